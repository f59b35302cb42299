//! Calls of kernels as data: a name, arguments and the shape of what comes back, which every printer prints in one way and the
//! interpreter runs.

use dh_kernels::Outcome;

/// Cosine and sine of an angle; for a prismatic joint its length (over the length scale) twice.
pub type Unknown = [f64; 2];

/// What a kernel found: values of all unknowns per root, and why there are as many.
pub struct KernelRoots {
    /// One list per root, in the order of the unknowns.
    pub roots: Vec<Vec<Unknown>>,
    /// Why there are as many.
    pub outcome: Outcome,
}

impl KernelRoots {
    /// Nothing: the arguments are not those of the kernel.
    pub(super) fn none() -> KernelRoots {
        KernelRoots { roots: Vec::new(), outcome: Outcome::NoRealRoot }
    }

    pub(super) fn of<T: Copy + dh_kernels::Blank, const N: usize>(
        found: &dh_kernels::Roots<T, N>,
        unknowns: impl Fn(T) -> Vec<Unknown>,
    ) -> KernelRoots {
        KernelRoots { roots: found.iter().map(|r| unknowns(*r)).collect(), outcome: found.outcome }
    }
}

/// A coefficient of the step's equations, by place; signs are set where a kernel wants the other side of the equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coefficient {
    /// Equation and place in it.
    Plus(usize, usize),
    /// Its negative.
    Minus(usize, usize),
    /// Zero.
    Zero,
}

/// An argument of a kernel.
#[derive(Clone, Debug, PartialEq)]
pub enum Argument<N> {
    /// A number.
    Number(N),
    /// An array, passed by value.
    Array(Vec<Argument<N>>),
    /// An array, passed by reference.
    Reference(Vec<Argument<N>>),
    /// What the unknowns take where they are free: one value per unknown.
    Representatives,
    /// For the general elimination: which of its six joints are prismatic, and the best choices of where to cut the loop of joints.
    Elimination {
        /// Which joints are prismatic.
        prismatic: [bool; 6],
        /// Numbers of `general::Choice`.
        cuts: [u8; 3],
    },
}

impl<N> Argument<N> {
    /// The numbers in it, in order.
    pub fn numbers(&self) -> Vec<&N> {
        match self {
            Argument::Number(n) => vec![n],
            Argument::Array(list) | Argument::Reference(list) => list.iter().flat_map(Argument::numbers).collect(),
            Argument::Representatives | Argument::Elimination { .. } => Vec::new(),
        }
    }

    /// The same with other numbers.
    pub fn map<M>(&self, number: &impl Fn(&N) -> M) -> Argument<M> {
        let all = |list: &[Argument<N>]| list.iter().map(|a| a.map(number)).collect();
        match self {
            Argument::Number(n) => Argument::Number(number(n)),
            Argument::Array(list) => Argument::Array(all(list)),
            Argument::Reference(list) => Argument::Reference(all(list)),
            Argument::Representatives => Argument::Representatives,
            Argument::Elimination { prismatic, cuts } => Argument::Elimination { prismatic: *prismatic, cuts: *cuts },
        }
    }
}

/// Coefficients from `from` on in one equation.
pub(super) fn row(equation: usize, places: std::ops::Range<usize>) -> Vec<Argument<Coefficient>> {
    places.map(|i| plus(equation, i)).collect()
}

/// One coefficient.
pub(super) fn plus(equation: usize, place: usize) -> Argument<Coefficient> {
    Argument::Number(Coefficient::Plus(equation, place))
}

/// One coefficient on the other side of its equation.
pub(super) fn minus(equation: usize, place: usize) -> Argument<Coefficient> {
    Argument::Number(Coefficient::Minus(equation, place))
}

/// Zero.
pub(super) fn zero() -> Argument<Coefficient> {
    Argument::Number(Coefficient::Zero)
}

/// How a kernel treats an unknown that its equations leave free.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Representative {
    /// It says so, and the caller takes a value.
    Chosen,
    /// The same, and the caller takes zero for all of them.
    Zero,
    /// It takes the values that it is given ([`Argument::Representatives`]).
    Passed,
}

/// Runs a kernel: its numbers, its arguments as they stand in the call, what free unknowns take, and the size below which a coefficient
/// counts as zero.
type Run = fn(numbers: &[f64], arguments: &[Argument<f64>], free: &[Unknown], tolerance: f64) -> KernelRoots;

/// A function of `dh-kernels` that finds all roots of some equations.
#[derive(Debug)]
pub struct Kernel {
    /// Its name in Rust.
    pub rust: &'static str,
    /// Its name in the JavaScript runtime, if it has been ported.
    pub javascript: Option<&'static str>,
    /// Whether its last argument is the size below which a coefficient counts as zero.
    pub takes_tolerance: bool,
    /// What it does with unknowns that are free.
    pub free: Representative,
    /// Whether its arguments are a, b and c of a cos u + b sin u = c.
    pub is_sine_equation: bool,
    /// How many unknowns a root gives: 1, 2 or 6.
    pub unknowns: usize,
    /// Runs it on the numbers of its arguments, in order; `free` is what the unknowns take where they are free.
    pub run: Run,
}

/// A call of a kernel.
#[derive(Clone, Debug)]
pub struct Call<N> {
    /// The kernel.
    pub kernel: &'static Kernel,
    /// Its arguments, without the tolerance.
    pub arguments: Vec<Argument<N>>,
}

impl<N> Call<N> {
    /// The same with other numbers.
    pub fn map<M>(&self, number: &impl Fn(&N) -> M) -> Call<M> {
        Call { kernel: self.kernel, arguments: self.arguments.iter().map(|a| a.map(number)).collect() }
    }

    /// The numbers of all arguments, in order.
    pub fn numbers(&self) -> Vec<&N> {
        self.arguments.iter().flat_map(Argument::numbers).collect()
    }
}

impl Call<f64> {
    /// Runs the kernel; `free` is what the unknowns take where they are free.
    pub fn run(&self, free: &[Unknown], tolerance: f64) -> KernelRoots {
        let numbers: Vec<f64> = self.numbers().into_iter().copied().collect();
        self.run_with(&numbers, free, tolerance)
    }

    /// The same with other numbers in the place of its own.
    pub fn run_with(&self, numbers: &[f64], free: &[Unknown], tolerance: f64) -> KernelRoots {
        let mut found = (self.kernel.run)(numbers, &self.arguments, free, tolerance);
        if found.outcome == Outcome::Free && found.roots.is_empty() {
            match self.kernel.free {
                Representative::Chosen => found.roots.push(free.to_vec()),
                Representative::Zero => found.roots.push(vec![[1.0, 0.0]; self.kernel.unknowns]),
                Representative::Passed => {}
            }
        }
        found
    }
}

/// How many roots a batched kernel gives in every branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BatchedRoots {
    /// One.
    One,
    /// Two, half a turn apart: it gives the first.
    Opposite,
    /// Two, and which branches are real.
    Two,
}

/// A function that solves a kind of step without branching, so that loops over branches become vector instructions.
#[derive(Clone, Debug)]
pub struct BatchedKernel {
    /// Its name in Rust.
    pub name: &'static str,
    /// The same for targets in single precision, where that differs.
    pub single_precision: Option<&'static str>,
    /// Its arguments.
    pub arguments: Vec<Argument<Coefficient>>,
    /// What it gives.
    pub roots: BatchedRoots,
    /// Whether it reports how far its equations are from degenerating.
    pub has_margin: bool,
    /// The equations that fix the unknown at regular poses.
    pub equations: usize,
}
