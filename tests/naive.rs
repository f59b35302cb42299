//! The plain product of 4x4 matrices and the Jacobian in two ways: the second opinion, written without a look at the compiler.
//!
//! It takes a robot as written ([`ChainSpec`]) and shares nothing with what the compiler does after that.

use std::ops::{Add, Mul, Neg, Sub};

use dh_symbolic::chain::{AngleCell, ChainSpec, Convention, LengthCell, MotionSpec};

/// What matrices are made of: `f64`, or [`Dual`] to differentiate.
pub trait Number: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> {
    /// A constant.
    fn of(x: f64) -> Self;
    /// Sine and cosine of radians.
    fn sin_cos(self) -> (Self, Self);
}

impl Number for f64 {
    fn of(x: f64) -> f64 {
        x
    }
    fn sin_cos(self) -> (f64, f64) {
        f64::sin_cos(self)
    }
}

/// A value and its derivative.
#[derive(Clone, Copy, Debug)]
pub struct Dual {
    /// The value.
    pub value: f64,
    /// Its derivative.
    pub slope: f64,
}

impl Add for Dual {
    type Output = Dual;
    fn add(self, other: Dual) -> Dual {
        Dual { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl Neg for Dual {
    type Output = Dual;
    fn neg(self) -> Dual {
        Dual { value: -self.value, slope: -self.slope }
    }
}

impl Sub for Dual {
    type Output = Dual;
    fn sub(self, other: Dual) -> Dual {
        self + -other
    }
}

impl Mul for Dual {
    type Output = Dual;
    fn mul(self, other: Dual) -> Dual {
        Dual { value: self.value * other.value, slope: self.slope * other.value + self.value * other.slope }
    }
}

impl Number for Dual {
    fn of(x: f64) -> Dual {
        Dual { value: x, slope: 0.0 }
    }
    fn sin_cos(self) -> (Dual, Dual) {
        let (s, c) = self.value.sin_cos();
        (Dual { value: s, slope: c * self.slope }, Dual { value: c, slope: -s * self.slope })
    }
}

/// A homogeneous matrix by rows.
pub type Matrix<T = f64> = [[T; 4]; 4];
/// Six rows, linear before angular, per joint variable.
pub type Column = [f64; 6];

fn identity<T: Number>() -> Matrix<T> {
    std::array::from_fn(|i| std::array::from_fn(|j| T::of(if i == j { 1.0 } else { 0.0 })))
}

fn product<T: Number>(a: &Matrix<T>, b: &Matrix<T>) -> Matrix<T> {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).fold(T::of(0.0), |sum, k| sum + a[i][k] * b[k][j])))
}

fn shift<T: Number>(axis: usize, length: T) -> Matrix<T> {
    let mut m = identity();
    m[axis][3] = length;
    m
}

fn turn<T: Number>(axis: usize, angle: T) -> Matrix<T> {
    let (s, c) = angle.sin_cos();
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut m = identity();
    (m[j][j], m[j][k], m[k][j], m[k][k]) = (c, -s, s, c);
    m
}

/// A row of numbers, in radians and table units.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// Link twist.
    pub alpha: f64,
    /// Link length.
    pub a: f64,
    /// Link offset, without the variable part.
    pub d: f64,
    /// Joint angle, without the variable part.
    pub theta: f64,
    /// What moves: (`theta`, else `d`; combination of joint variables).
    pub moves: Option<(bool, Vec<(usize, f64)>)>,
}

/// A constant motion.
#[derive(Clone, Copy, Debug)]
pub enum Motion {
    /// Along an axis.
    Shift(usize, f64),
    /// About an axis.
    Turn(usize, f64),
}

/// An arm in numbers.
#[derive(Clone, Debug, Default)]
pub struct Arm {
    /// Craig's convention, else the standard one.
    pub modified: bool,
    /// Before the first row.
    pub base: Vec<Motion>,
    /// The rows.
    pub rows: Vec<Row>,
    /// After the last row.
    pub tool: Vec<Motion>,
}

/// Frames on the way from the base to the tool.
struct Walk<T> {
    /// Every row's frame.
    frames: Vec<Matrix<T>>,
    /// A frame whose z axis is the axis of the row's joint.
    axes: Vec<Matrix<T>>,
    /// The tool.
    tip: Matrix<T>,
}

impl Arm {
    /// The arm of a table, with the values of its fields.
    pub fn new(spec: &ChainSpec, field: &dyn Fn(&str) -> f64) -> Arm {
        let parameter = |i: usize| {
            let p = &spec.parameters[i];
            use dh_symbolic::chain::{Nominal, Role};
            match &p.role {
                Role::Field(_) => field(&p.name),
                Role::Constant(Nominal::Length(x)) => x.to_f64(),
                Role::Constant(Nominal::Angle(cell)) => cell.radians(),
            }
        };
        let length = |cell: &LengthCell| -> f64 {
            let term = |(k, factors): &(_, Vec<usize>)| {
                let k: &dh_symbolic::algebra::Rational = k;
                factors.iter().fold(k.to_f64(), |x, i| x * parameter(*i))
            };
            cell.terms.iter().map(term).sum()
        };
        let angle = |cell: &AngleCell| -> f64 {
            cell.radians() + cell.symbols.iter().map(|(i, k)| f64::from(*k) * parameter(*i)).sum::<f64>()
        };
        let motions = |list: &[MotionSpec]| -> Vec<Motion> {
            let one = |m: &MotionSpec| match m {
                MotionSpec::Translate(axis, cell) => Motion::Shift(*axis, length(cell)),
                MotionSpec::Rotate(axis, cell) => Motion::Turn(*axis, angle(cell)),
                MotionSpec::Pose(_) => Motion::Turn(2, 0.0),
            };
            list.iter().map(one).collect()
        };
        let rows = spec.rows.iter().map(|row| Row {
            alpha: angle(&row.alpha),
            a: length(&row.a),
            d: length(&row.d),
            theta: angle(&row.theta),
            moves: row.moves.as_ref().map(|m| (m.revolute, m.terms.iter().map(|(j, k)| (*j, length(k))).collect())),
        });
        Arm {
            modified: spec.convention == Convention::Modified,
            base: motions(&spec.base),
            rows: rows.collect(),
            tool: motions(&spec.tool),
        }
    }

    /// Number of joint variables.
    #[must_use]
    pub fn dof(&self) -> usize {
        self.rows.iter().filter(|row| row.moves.is_some()).count()
    }

    /// Sum of all lengths at these joint values: what errors of position are measured by. At least 1e-3.
    #[must_use]
    pub fn reach(&self, q: &[f64]) -> f64 {
        let rows: f64 = self.rows.iter().map(|row| row.a.abs() + self.coordinates::<f64>(row, q).1.abs()).sum();
        let motion = |m: &Motion| if let Motion::Shift(_, x) = m { x.abs() } else { 0.0 };
        let ends: f64 = self.base.iter().chain(&self.tool).map(motion).sum();
        (rows + ends).max(1e-3)
    }

    /// theta and d of a row.
    fn coordinates<T: Number>(&self, row: &Row, q: &[T]) -> (T, T) {
        let mut both = (T::of(row.theta), T::of(row.d));
        if let Some((turns, terms)) = &row.moves {
            let x = terms.iter().fold(T::of(0.0), |x, (j, k)| x + T::of(*k) * q[*j]);
            let moving = if *turns { &mut both.0 } else { &mut both.1 };
            *moving = *moving + x;
        }
        both
    }

    fn walk<T: Number>(&self, q: &[T]) -> Walk<T> {
        let apply = |m: Matrix<T>, motion: &Motion| match motion {
            Motion::Shift(axis, x) => product(&m, &shift(*axis, T::of(*x))),
            Motion::Turn(axis, x) => product(&m, &turn(*axis, T::of(*x))),
        };
        let mut now = self.base.iter().fold(identity(), apply);
        let (mut frames, mut axes) = (Vec::new(), Vec::new());
        for row in &self.rows {
            let (theta, d) = self.coordinates(row, q);
            let across = product(&turn(0, T::of(row.alpha)), &shift(0, T::of(row.a)));
            let along = product(&turn(2, theta), &shift(2, d));
            let before = now;
            now = if self.modified {
                product(&product(&now, &across), &along)
            } else {
                product(&product(&now, &along), &across)
            };
            axes.push(if self.modified { now } else { before });
            frames.push(now);
        }
        Walk { tip: self.tool.iter().fold(now, apply), frames, axes }
    }

    /// The pose of the tool in the base.
    #[must_use]
    pub fn pose(&self, q: &[f64]) -> Matrix {
        self.walk(q).tip
    }

    /// The frame of every moving row in the base.
    #[must_use]
    pub fn frames(&self, q: &[f64]) -> Vec<Matrix> {
        let frames = self.walk(q).frames;
        frames.into_iter().zip(&self.rows).filter(|(_, row)| row.moves.is_some()).map(|(frame, _)| frame).collect()
    }

    /// The frame of every row in the frame before the first row: without `base` and `tool`; the first one is the identity.
    #[must_use]
    pub fn chain_frames(&self, q: &[f64]) -> Vec<Matrix> {
        let rows = Arm { base: vec![], tool: vec![], ..self.clone() }.walk(q).frames;
        std::iter::once(identity()).chain(rows).collect()
    }

    /// The constant transforms before and after the rows.
    #[must_use]
    pub fn ends(&self) -> [Matrix; 2] {
        let still = |motions: &[Motion]| Arm { base: motions.to_vec(), ..Arm::default() }.walk::<f64>(&[]).tip;
        [still(&self.base), still(&self.tool)]
    }

    /// The geometric Jacobian from the joint axes: z x (tip - origin) and z for a joint that turns, z and 0 for one that slides.
    #[must_use]
    pub fn jacobian_from_axes(&self, q: &[f64]) -> Vec<Column> {
        let walk = self.walk(q);
        let mut columns = vec![[0.0; 6]; self.dof()];
        for (row, axis) in self.rows.iter().zip(&walk.axes) {
            let Some((turns, terms)) = &row.moves else { continue };
            let z = [axis[0][2], axis[1][2], axis[2][2]];
            let r: [f64; 3] = std::array::from_fn(|i| walk.tip[i][3] - axis[i][3]);
            let across: [f64; 3] =
                std::array::from_fn(|i| z[(i + 1) % 3] * r[(i + 2) % 3] - z[(i + 2) % 3] * r[(i + 1) % 3]);
            for (j, k) in terms {
                for i in 0..3 {
                    columns[*j][i] += k * if *turns { across[i] } else { z[i] };
                    columns[*j][i + 3] += k * if *turns { z[i] } else { 0.0 };
                }
            }
        }
        columns
    }

    /// The same from the derivative of the pose: dp/dq, and the vector of the skew matrix dR/dq R^T.
    #[must_use]
    pub fn jacobian_from_slopes(&self, q: &[f64]) -> Vec<Column> {
        let column = |j: usize| {
            let dual = |(i, x): (usize, &f64)| Dual { value: *x, slope: if i == j { 1.0 } else { 0.0 } };
            let tip = self.walk(&q.iter().enumerate().map(dual).collect::<Vec<_>>()).tip;
            let skew = |i: usize, k: usize| (0..3).map(|m| tip[i][m].slope * tip[k][m].value).sum::<f64>();
            [tip[0][3].slope, tip[1][3].slope, tip[2][3].slope, skew(2, 1), skew(0, 2), skew(1, 0)]
        };
        (0..q.len()).map(column).collect()
    }
}
