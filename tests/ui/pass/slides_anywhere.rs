//! Slides that are no neighbours, between axes in general position: the inverse of generated code leads back.
use dh_robot::dh_robot;

dh_robot! {
    pub struct TwoSlides;

    convention = modified;

    | alpha | a | d | theta |
    |-------|---|---|-------|
    | 20deg  | 0.1  | 0.2  | q1 |
    | 40deg  | 0.3  | q2   | 10deg |
    | -50deg | 0.2  | 0.15 | q3 |
    | 70deg  | 0.12 | 0.22 | q4 |
    | 35deg  | 0.17 | q5   | 25deg |
    | 65deg  | 0.07 | 0.3  | q6 |
}

dh_robot! {
    pub struct ThreeSlides;

    convention = standard;

    | alpha | a | d | theta |
    |-------|---|---|-------|
    | -90deg  | -0.31 | q1    | 0          |
    | 30deg   | 0     | -0.25 | q2         |
    | 55.3deg | 0.3   | q3    | 0          |
    | 12.5deg | 0     | 0.568 | q4         |
    | -20deg  | 0.3   | q5    | 40deg      |
    | 90deg   | 0.1   | 0.2   | q6 + 90deg |
}

dh_robot! {
    pub struct FiveAxes;

    convention = standard;
    task = axis;

    | alpha | a | d | theta |
    |-------|---|---|-------|
    | 90deg  | 0     | q1 + 0.53 | -90deg     |
    | -90deg | 0.142 | 0         | q2 + 30deg |
    | 45deg  | 0     | 0.3       | q3 - 90deg |
    | -45deg | -0.25 | 0         | q4         |
    | -90deg | 0     | q5        | 90deg      |
}

fn assert_found<const N: usize>(q: [f64; N], found: &[[f64; N]]) {
    let near = |s: &&[f64; N]| s.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-9);
    assert_eq!(found.iter().filter(near).count(), 1, "{found:?}");
}

fn main() {
    let q = [0.3, -0.2, 1.1, -0.7, 0.4, 2.0];
    let solutions = TwoSlides.inverse(&TwoSlides.forward(&q));
    assert_found(q, &solutions.iter().map(|s| s.q).collect::<Vec<_>>());
    assert_eq!(TwoSlides::MAX_SOLUTIONS, 8);

    let solutions = ThreeSlides.inverse(&ThreeSlides.forward(&q));
    assert_found(q, &solutions.iter().map(|s| s.q).collect::<Vec<_>>());
    assert_eq!((ThreeSlides::MAX_SOLUTIONS, solutions.len()), (2, 2));

    let q = [0.3, -0.2, 1.1, -0.7, 0.4];
    let pose = FiveAxes.forward(&q);
    let point = dh_robot::nalgebra::Point3::from(pose.translation.vector);
    let axis = pose.rotation * dh_robot::nalgebra::Vector3::z_axis();
    let solutions = FiveAxes.inverse((point, axis));
    assert_found(q, &solutions.iter().map(|s| s.q).collect::<Vec<_>>());
}
