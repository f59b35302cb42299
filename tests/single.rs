//! Robots of another number type and another unit: the same arm in `f32` and millimetres.

use dh_robot::dh_robot;
use dh_tests::sample::Random;
use generated_examples::kuka_kr6_r700::KukaKr6R700;

dh_robot! {
    /// The KUKA KR 6 R700 in single precision and millimetres.
    struct Single;

    convention = standard;
    scalar = f32;
    unit = mm;

    | joint | theta      | d   | a     | alpha  |
    |-------|------------|-----|-------|--------|
    |   1   | q1         | 400 | 2.5cm | -90deg |
    |   2   | q2 - pi/2  | 0   | 315   |   0    |
    |   3   | q3         | 0   | 35    | -90deg |
    |   4   | q4         | 365 | 0     |  90deg |
    |   5   | q5         | 0   | 0     | -90deg |
    |   6   | q6         | 80  | 0     |   0    |
}

#[test]
fn single_precision_agrees_with_double() {
    let (single, double) = (Single, KukaKr6R700);
    let mut random = Random::new(3);
    for _ in 0..200 {
        let q: [f64; 6] = std::array::from_fn(|_| random.signed() * std::f64::consts::PI);
        let short = q.map(|x| x as f32);
        let (a, b) = (double.forward(&short.map(f64::from)), single.forward(&short));
        assert!((a.translation.vector * 1e3 - b.translation.vector.cast()).norm() < 1e-3, "{q:?}");
        assert!((a.rotation.matrix() - b.rotation.matrix().cast()).abs().max() < 1e-6, "{q:?}");
        let (a, b) = (double.jacobian(&short.map(f64::from)), single.jacobian(&short).cast::<f64>());
        assert!((a.fixed_rows::<3>(0) - b.fixed_rows::<3>(0) * 1e-3).abs().max() < 2e-6, "{q:?}");
        assert!((a.fixed_rows::<3>(3) - b.fixed_rows::<3>(3)).abs().max() < 1e-6, "{q:?}");
        let turned = |a: f32, b: f32| (f64::from(a - b) / std::f64::consts::TAU).fract().abs();
        let near = |a: &f32, b: &f32| turned(*a, *b).min(1.0 - turned(*a, *b)) < 1e-3;
        let found = single.inverse(&single.forward(&short));
        let there = found.iter().any(|s| s.q.iter().zip(&short).all(|(a, b)| near(a, b)));
        assert!(there, "{q:?}");
    }
}

dh_robot! {
    /// A UR5 in single precision: its elbow is stretched at zero.
    struct Stretched;

    convention = standard;
    scalar = f32;

    | theta | d        | a        | alpha  |
    |-------|----------|----------|--------|
    | q1    | 0.089159 | 0        |  90deg |
    | q2    | 0        | -0.425   |  0     |
    | q3    | 0        | -0.39225 |  0     |
    | q4    | 0.10915  | 0        |  90deg |
    | q5    | 0.09465  | 0        | -90deg |
    | q6    | 0.0823   | 0        |  0     |
}

#[test]
fn rounding_does_not_put_a_stretched_arm_out_of_reach() {
    let mut random = Random::new(4);
    for _ in 0..100 {
        let mut q: [f32; 6] = std::array::from_fn(|_| (random.signed() * std::f64::consts::PI) as f32);
        q[2] = 0.0;
        let found = Stretched.inverse(&Stretched.forward(&q));
        // A double root is good to the square root of rounding.
        let near = |a: &f32, b: &f32| (a - b).cos() > 1.0 - 5e-4;
        assert!(found.iter().any(|s| s.q.iter().zip(&q).all(|(a, b)| near(a, b))), "{q:?}: {found:?}");
    }
}

#[test]
fn a_straight_wrist_is_a_continuum_in_single_precision_too() {
    fn check(q: &[f32; 6], found: &[dh_robot::Solution<f32, 6>]) {
        let near = |k: usize, s: &dh_robot::Solution<f32, 6>| (s.q[k] - q[k]).cos() > 1.0 - 5e-4 || s.free.contains(k);
        let named = found.iter().any(|s| s.free.contains(5) && (0..6).all(|k| near(k, s)));
        assert!(named, "{q:?}: {found:?}");
    }
    let mut random = Random::new(5);
    for _ in 0..100 {
        let mut q: [f32; 6] = std::array::from_fn(|_| (random.signed() * std::f64::consts::PI) as f32);
        q[4] = 0.0;
        check(&q, &Single.inverse(&Single.forward(&q)));
        check(&q, &Stretched.inverse(&Stretched.forward(&q)));
    }
}
