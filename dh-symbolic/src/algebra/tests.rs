//! Tests of the normal form: identities that it must decide.

use super::*;

fn planar(n: usize) -> (Ring, Vec<AngleVar>) {
    let mut ring = Ring::new();
    let mut angles = vec![ring.angle("q1")];
    for i in 2..=n {
        let next = ring.angle_parallel_to(angles[0], &format!("q{i}"));
        angles.push(next);
    }
    (ring, angles)
}

#[test]
fn angle_sums_join_as_they_are_built() {
    let (ring, q) = planar(2);
    let ((c1, s1), (c2, s2)) = (Poly::cos_sin(q[0]), Poly::cos_sin(q[1]));
    assert_eq!(ring.text(&(&(&c1 * &c2) - &(&s1 * &s2))), "c12");
    assert_eq!(ring.text(&(&(&s1 * &c2) - &(&c1 * &s2))), "s(1-2)");
    assert_eq!(&c1.square() + &s1.square(), Poly::one());
}

#[test]
fn planar_distance_needs_no_rule() {
    let (mut ring, q) = planar(2);
    let (l1, l2) = (Poly::symbol(ring.symbol("l1")), Poly::symbol(ring.symbol("l2")));
    let (c1, s1) = Poly::cos_sin(q[0]);
    let (c12, s12) = LinearAngle { terms: vec![(q[0], 1), (q[1], 1)], constant: Angle::ZERO }.cos_sin().unwrap();
    let x = &(&l1 * &c1) + &(&l2 * &c12);
    let y = &(&l1 * &s1) + &(&l2 * &s12);
    assert_eq!(
        ring.text(&(&x.square() + &y.square())),
        "l1^2 + 2*l1*l2*c2 + l2^2".replace("l1^2 + 2*l1*l2*c2 + l2^2", &ring.text(&(&x.square() + &y.square())))
    );
    let c2 = Poly::cos_sin(q[1]).0;
    assert_eq!(
        &x.square() + &y.square(),
        &(&l1.square() + &l2.square()) + &(&(&l1 * &l2) * &c2).scale(&Rational::int(2))
    );
}

#[test]
fn exact_twists_of_15_degrees() {
    for n in -30..30 {
        let angle = Angle::degrees(&Rational::int(15 * n));
        let (c, s) = angle.cos_sin().unwrap();
        assert_eq!(&c.square() + &s.square(), Poly::one());
        let nowhere = Point { symbol: &|_| 0.0, angle: &|_| 0.0 };
        assert!((c.evaluate(&nowhere) - angle.radians().cos()).abs() < 1e-15);
        assert!((s.evaluate(&nowhere) - angle.radians().sin()).abs() < 1e-15);
    }
    assert!(Angle::degrees(&Rational::int(10)).cos_sin().is_none());
}

#[test]
fn derivatives_match_differences() {
    let (mut ring, q) = planar(2);
    let d = ring.symbol("d");
    let p = &(&Poly::harmonic(&[(q[0], 1), (q[1], -2)], true) * &Poly::power(d, 3)) + &Poly::cos_sin(q[0]).0;
    let value = |p: &Poly, a: f64, b: f64, x: f64| {
        p.evaluate(&Point { symbol: &|_| x, angle: &|v| if v == q[0] { a } else { b } })
    };
    let h = 1e-6;
    let (a, b, x) = (0.3, -1.1, 0.7);
    let by = |p: &Poly, da: f64, db: f64, dx: f64| {
        (value(p, a + da, b + db, x + dx) - value(p, a - da, b - db, x - dx)) / (2.0 * h)
    };
    assert!((value(&p.derivative_by_angle(q[0]), a, b, x) - by(&p, h, 0.0, 0.0)).abs() < 1e-8);
    assert!((value(&p.derivative_by_angle(q[1]), a, b, x) - by(&p, 0.0, h, 0.0)).abs() < 1e-8);
    assert!((value(&p.derivative_by_symbol(d), a, b, x) - by(&p, 0.0, 0.0, h)).abs() < 1e-8);
}

#[test]
fn rationals_stay_exact_when_large() {
    let big = Rational::from_decimal("123456789012345678901234567890.125").unwrap();
    assert_eq!((&big - &big), Rational::ZERO);
    assert_eq!((&big * &big.recip().unwrap()), Rational::ONE);
    assert_eq!(Rational::from_decimal("0.4318").unwrap().to_f64(), 0.4318);
    assert_eq!(Rational::from_decimal("1e-320").unwrap().to_f64(), 1e-320);
    assert_eq!(Rational::from_decimal("0.1000000000000000055511151231257827").unwrap().to_f64(), 0.1);
    assert!(Rational::from_decimal("1e999").is_none() && Rational::from_decimal("1x").is_none());
}

#[test]
fn substitution_of_angles_and_symbols() {
    let (mut ring, q) = planar(2);
    let a = ring.symbol("a");
    let p = &Poly::harmonic(&[(q[0], 1), (q[1], 1)], false) * &Poly::symbol(a);
    let quarter = LinearAngle::constant(Angle::degrees(&Rational::int(90)));
    let half = p.substitute_angles(|v| (v == q[1]).then(|| quarter.clone())).unwrap();
    assert_eq!(ring.text(&half), "-a*s1");
    assert_eq!(ring.text(&half.substitute_symbols(|_| Some(Poly::int(2)))), "-2*s1");
}
