//! What the C interface of a robot consists of: names, types, and the functions with their parameters and the Rust that each runs.
//!
//! The same list is printed as Rust and as C, so that the two sides of the border cannot differ.

use super::functions::functions;
use super::names;
use crate::chain::{Chain, Handle, Joint, Role, Scalar, Task};
use crate::program::Inverse;
use crate::render::code::{bound, docs, scalar_name};

/// What was written around the table.
#[derive(Clone, Debug)]
pub struct Written<'a> {
    /// The doc comment of the struct, line by line.
    pub docs: &'a [String],
    /// The table: header and rows.
    pub table: &'a [Vec<String>],
    /// `base` and `tool`.
    pub motions: &'a [(String, String)],
    /// Doc comments of the fields: name and lines.
    pub fields: Vec<(String, Vec<String>)>,
}

/// The C interface of a robot.
#[derive(Debug)]
pub struct Interface<'a> {
    /// The robot.
    pub(super) chain: &'a Chain,
    /// What was written around its table.
    pub(super) written: Written<'a>,
    /// The library's name, which begins the names of all functions and types.
    pub(super) name: String,
    /// The same in capitals, for constants.
    pub(super) upper: String,
    /// The parameters of the table.
    pub(super) fields: Vec<Field>,
    /// The inverse, if there is one.
    pub(super) inverse: Option<Solved>,
    /// All functions that compute something.
    pub(super) functions: Vec<Function>,
}

/// A parameter of the table: a field of the struct.
#[derive(Debug)]
pub(super) struct Field {
    /// Its name in Rust.
    pub(super) name: String,
    /// Its name in C.
    pub(super) own: String,
    /// What it is, line by line.
    pub(super) docs: Vec<String>,
    /// Its nominal value.
    pub(super) nominal: Option<f64>,
}

/// What C has to know of an inverse.
#[derive(Debug)]
pub(super) struct Solved {
    /// The most solutions.
    pub(super) most: usize,
    /// What the steps of the solution are called in reasons, each name once.
    pub(super) steps: Vec<String>,
    /// The name of the target in functions.
    pub(super) target: &'static str,
    /// How many numbers it has.
    pub(super) length: usize,
    /// Whether Rust's functions take it by reference.
    by_reference: bool,
    /// What they are.
    pub(super) meaning: &'static str,
    /// The names of the joints that the caller chooses.
    pub(super) given: Vec<String>,
}

/// A function.
#[derive(Debug)]
pub(super) struct Function {
    /// Its name behind that of the library.
    pub(super) name: &'static str,
    /// What it does, line by line.
    pub(super) docs: Vec<String>,
    /// Its parameters but for the robot's.
    pub(super) parameters: Vec<Parameter>,
    /// Statements in Rust that see `robot` and the parameters, and end in the status.
    pub(super) body: String,
}

/// A parameter of a function.
#[derive(Debug)]
pub(super) struct Parameter {
    pub(super) name: String,
    pub(super) kind: Kind,
}

/// The types of parameters. Lengths stand in the declarations of C where they are known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Numbers that are read.
    Numbers(Option<usize>),
    /// Numbers that are written: so many rows of so many.
    Place(Option<[usize; 2]>),
    /// A number.
    Number,
    /// How many poses there are.
    Count,
    /// Solutions that are written.
    Solutions(Option<usize>),
    /// Numbers of solutions that are written.
    Counts,
    /// Reasons that are written, if the pointer is not null.
    Reasons,
}

impl<'a> Interface<'a> {
    /// The interface of a chain.
    pub fn new(chain: &'a Chain, inverse: Option<&Inverse>, written: Written<'a>, name: &str) -> Interface<'a> {
        let solved = inverse.map(|inverse| Solved::of(chain, inverse));
        let functions = functions(chain, solved.as_ref());
        let fields = fields(chain, &written);
        let (name, upper) = (name.to_string(), name.to_uppercase());
        Interface { chain, written, name, upper, fields, inverse: solved, functions }
    }

    /// Number of joints.
    pub(super) fn dof(&self) -> usize {
        self.chain.dof()
    }

    /// The number type of C.
    pub(super) fn number(&self) -> &'static str {
        match self.chain.settings.scalar {
            Scalar::F64 => "double",
            Scalar::F32 => "float",
        }
    }

    /// The number type of Rust.
    pub(super) fn scalar(&self) -> &'static str {
        scalar_name(self.chain.settings.scalar)
    }

    /// Whether every parameter has a nominal value (also where there is none): then there are functions of the nominal arm.
    pub(super) fn is_nominal(&self) -> bool {
        self.fields.iter().all(|field| field.nominal.is_some())
    }

    /// The forms that each function has: what is appended to its name, and whether it takes the robot's parameters first.
    pub(super) fn forms(&self) -> Vec<(&'static str, bool)> {
        let nominal = self.is_nominal().then_some(("", false));
        let with = (!self.fields.is_empty()).then_some(("_with", true));
        nominal.into_iter().chain(with).collect()
    }

    /// The joints: what `Joint` says of each in Rust.
    pub(super) fn joints(&self) -> impl Iterator<Item = (&Joint, bool, Option<[f64; 2]>)> {
        let one = |(i, joint): (usize, &'a Joint)| {
            let range = joint.range.as_ref().map(|(least, greatest)| [bound(least), bound(greatest)]);
            (joint, self.chain.is_periodic(i), range)
        };
        self.chain.joints.iter().enumerate().map(one)
    }
}

impl Solved {
    fn of(chain: &Chain, inverse: &Inverse) -> Solved {
        let mut steps: Vec<String> = Vec::new();
        for name in inverse.body.reports().iter().map(|report| report.name()) {
            if !steps.contains(&name) {
                steps.push(name);
            }
        }
        // What the reason names where the target is out of hand altogether.
        steps.push("the target".into());
        let (target, length, meaning) = match chain.settings.task {
            Task::Pose => ("pose", 16, "the pose of the last frame (or tool)"),
            Task::Position => ("point", 3, "x, y and z of the last frame (or tool)"),
            Task::Planar => ("target", 3, "x, y and the angle about z of the last frame (or tool)"),
            Task::Axis => {
                ("target", 6, "x, y and z of the last frame (or tool), and the direction of its z axis, a unit vector")
            }
        };
        let given = chain.settings.redundant.iter().filter_map(|k| chain.joints.get(*k)).map(|j| j.name.clone());
        let by_reference = matches!(chain.settings.task, Task::Pose | Task::Position);
        Solved {
            most: inverse.plan.max_solutions,
            steps,
            target,
            length,
            by_reference,
            meaning,
            given: given.collect(),
        }
    }

    /// The target as Rust's functions take it.
    pub(super) fn argument(&self) -> &'static str {
        if self.by_reference { "&target" } else { "target" }
    }

    /// The parameter that holds the joints which the caller chooses.
    pub(super) fn given(&self) -> Option<Parameter> {
        match self.given.as_slice() {
            [] => None,
            [joint] => Some(Parameter { name: joint.clone(), kind: Kind::Number }),
            several => Some(Parameter::new("given", Kind::Numbers(Some(several.len())))),
        }
    }
}

fn fields(chain: &Chain, written: &Written<'_>) -> Vec<Field> {
    let of_fields = |p: &&crate::chain::Parameter| matches!(p.role, Role::Field(_)) && !p.of_point;
    let all: Vec<_> = chain.parameters.iter().filter(of_fields).collect();
    let own = names::fields(&all.iter().map(|p| p.name.clone()).collect::<Vec<_>>());
    let one = |(p, own): (&crate::chain::Parameter, String)| {
        let docs = written.fields.iter().filter(|f| f.0 == p.name).flat_map(|f| f.1.clone());
        let nominal = match (&p.role, p.handle) {
            (Role::Field(Some(_)), Handle::Length(_) | Handle::Angle(_)) => Some(chain.nominal(p.handle)),
            _ => None,
        };
        Field { name: p.name.clone(), own, docs: docs.chain([docs::field(chain, p)]).collect(), nominal }
    };
    all.into_iter().zip(own).map(one).collect()
}

impl Parameter {
    pub(super) fn new(name: &str, kind: Kind) -> Parameter {
        Parameter { name: name.to_string(), kind }
    }
}
