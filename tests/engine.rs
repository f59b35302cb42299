//! One look at a robot, whoever computes it: a type that the macro made, an expanded file, the interpreter, the plain product.

use dh_symbolic::chain::{Chain, ChainSpec, Coordinate, Handle, table};
use dh_symbolic::program::{Forward, Inputs, Program};

use crate::naive::{Arm, Column, Matrix};

/// A function of the joint variables.
pub type Of<T> = Box<dyn Fn(&[f64]) -> T>;

/// The forward functions of a robot.
pub struct Engine {
    /// Who computes.
    pub name: &'static str,
    /// Number of joint variables.
    pub dof: usize,
    /// `forward`.
    pub pose: Of<Matrix>,
    /// `frames`.
    pub frames: Of<Vec<Matrix>>,
    /// `jacobian`.
    pub jacobian: Of<Vec<Column>>,
    /// `forward_and_jacobian`.
    pub both: Of<(Matrix, Vec<Column>)>,
}

/// An engine of a type that the macro made, or of its expansion: a macro, since `forward_and_jacobian` is in no trait.
#[macro_export]
macro_rules! engine {
    ($name:expr, $robot:expr, $dof:literal) => {{
        use $crate::engine::{columns, matrix};
        let robot = $robot;
        let q = |q: &[f64]| -> [f64; $dof] { q.try_into().expect("as many values as joints") };
        $crate::engine::Engine {
            name: $name,
            dof: $dof,
            pose: Box::new(move |x| matrix(&robot.forward(&q(x)))),
            frames: Box::new(move |x| robot.frames(&q(x)).iter().map(matrix).collect()),
            jacobian: Box::new(move |x| columns(&robot.jacobian(&q(x)))),
            both: Box::new(move |x| {
                let (pose, jacobian) = robot.forward_and_jacobian(&q(x));
                (matrix(&pose), columns(&jacobian))
            }),
        }
    }};
}

/// A pose as a matrix by rows.
pub fn matrix(pose: &dh_robot::nalgebra::IsometryMatrix3<f64>) -> Matrix {
    let m = pose.to_homogeneous();
    std::array::from_fn(|i| std::array::from_fn(|j| m[(i, j)]))
}

/// A Jacobian as columns.
pub fn columns<const N: usize>(jacobian: &dh_robot::nalgebra::SMatrix<f64, 6, N>) -> Vec<Column> {
    jacobian.column_iter().map(|column| std::array::from_fn(|i| column[i])).collect()
}

/// Reads a table that must be in order.
///
/// # Panics
/// With all errors, if it is not.
#[must_use]
pub fn spec(table: &str) -> ChainSpec {
    let tokens = table.parse().unwrap_or_else(|e| panic!("{e}:\n{table}"));
    let parsed = table::parse(tokens);
    match parsed.spec {
        Some(spec) => spec,
        None => panic!("{:?}\n{table}", parsed.errors),
    }
}

/// The values of a robot's fields: the nominal ones, and for fields without one a value made of the name.
pub fn fields(chain: &Chain) -> impl Fn(&str) -> f64 + use<> {
    let values: Vec<(String, f64)> = chain
        .parameters
        .iter()
        .map(|p| {
            let given = !matches!(p.role, dh_symbolic::chain::Role::Field(None));
            (p.name.clone(), if given { chain.nominal(p.handle) } else { invented(&p.name) })
        })
        .collect();
    move |name| values.iter().find(|(n, _)| n == name).map_or(f64::NAN, |(_, x)| *x)
}

/// A value for a field that has no nominal one: the same for a name in every engine, and nothing special.
#[must_use]
pub fn invented(name: &str) -> f64 {
    let sum = name.bytes().fold(7_u32, |sum, byte| (sum * 31 + u32::from(byte)) % 1009);
    0.2 + f64::from(sum) / 1009.0
}

/// The compiler's programs, run without compiling them.
pub struct Interpreter {
    /// The robot.
    pub chain: Chain,
    /// Its proven programs.
    pub forward: Forward,
    /// The values of its fields.
    pub fields: Box<dyn Fn(&str) -> f64>,
}

impl Interpreter {
    /// Derives and proves the programs.
    ///
    /// # Panics
    /// Where a program is disproven.
    #[must_use]
    pub fn new(spec: &ChainSpec) -> Interpreter {
        let chain = Chain::new(spec.clone());
        let forward = Forward::derive(&chain).unwrap_or_else(|e| panic!("{e}: {e:?}"));
        let fields = Box::new(fields(&chain));
        Interpreter { chain, forward, fields }
    }

    /// Runs a program at some joint values.
    #[must_use]
    pub fn run(&self, program: &Program, q: &[f64]) -> Vec<f64> {
        let chain = &self.chain;
        let parameter = |handle: Handle| {
            let found = chain.parameters.iter().find(|p| p.handle == handle);
            found.map_or(f64::NAN, |p| (self.fields)(&p.name))
        };
        // The value of a coordinate of the formulas: what drives it, and the constant that is kept out of them.
        let coordinate = |i: usize| {
            let lengths = Inputs { symbol: &|s| parameter(Handle::Length(s)), angle: &|v| parameter(Handle::Angle(v)) };
            let driven: f64 = chain.drive[i].iter().zip(q).map(|(k, q)| k.evaluate(&lengths) * q).sum();
            let shift = &chain.joints[i].shift;
            let named = shift.symbols.iter().map(|(p, k)| f64::from(*k) * parameter(chain.parameters[*p].handle));
            driven + shift.radians() + named.sum::<f64>()
        };
        let joint = |c: Coordinate| chain.joints.iter().position(|j| j.coordinate == c);
        program.run(&Inputs {
            symbol: &|s| joint(Coordinate::Length(s)).map_or_else(|| parameter(Handle::Length(s)), coordinate),
            angle: &|v| joint(Coordinate::Angle(v)).map_or_else(|| parameter(Handle::Angle(v)), coordinate),
        })
    }

    /// As an engine.
    #[must_use]
    pub fn engine(self) -> Engine {
        let me = std::rc::Rc::new(self);
        let [a, b, c, d] = std::array::from_fn(|_| me.clone());
        let split = |x: &[f64]| (pose_of(x), x[12..].chunks(6).map(column_of).collect::<Vec<Column>>());
        Engine {
            name: "interpreter",
            dof: me.chain.dof(),
            pose: Box::new(move |q| pose_of(&a.run(&a.forward.pose, q))),
            frames: Box::new(move |q| {
                let all = b.run(&b.forward.frames, q);
                b.chain.joints.iter().map(|joint| pose_of(&all[12 * joint.row..])).collect()
            }),
            jacobian: Box::new(move |q| split(&c.run(&c.forward.jacobian, q)).1),
            both: Box::new(move |q| split(&d.run(&d.forward.jacobian, q))),
        }
    }
}

fn pose_of(columns: &[f64]) -> Matrix {
    let last = [0.0, 0.0, 0.0, 1.0];
    std::array::from_fn(|i| std::array::from_fn(|j| if i < 3 { columns[3 * j + i] } else { last[j] }))
}

fn column_of(x: &[f64]) -> Column {
    std::array::from_fn(|i| x[i])
}

/// The plain product as an engine.
#[must_use]
pub fn naive(arm: Arm) -> Engine {
    let [a, b, c, d] = std::array::from_fn(|_| arm.clone());
    Engine {
        name: "plain product",
        dof: arm.dof(),
        pose: Box::new(move |q| a.pose(q)),
        frames: Box::new(move |q| b.frames(q)),
        jacobian: Box::new(move |q| c.jacobian_from_axes(q)),
        both: Box::new(move |q| (d.pose(q), d.jacobian_from_slopes(q))),
    }
}
