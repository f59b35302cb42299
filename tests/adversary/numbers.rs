//! Plain numbers for the lines of a derivation: a reader of formulas and products of matrices that share nothing with the checker but the
//! table as it is read.

mod reader;
mod value;

use std::collections::BTreeMap;

use dh_symbolic::chain::{ChainSpec, Convention, Nominal, Quantity, Role};
use dh_tests::naive::Arm;
use reader::Reader;
use value::{Value, compare};

/// Poses at which a line is tried.
const POSES: usize = 160;

/// At how many poses a line holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Truth {
    Always,
    Sometimes,
    Never,
}

pub(super) fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 33) as f64 / (1u64 << 31) as f64
}

/// What a definition gives a name.
#[derive(Clone, Debug)]
pub(super) enum Given {
    /// A formula.
    Formula(Vec<String>),
    /// Any value: is it an angle?
    Free(bool),
}

/// An arm at a pose.
struct Pose {
    modified: bool,
    arm: Arm,
    q: Vec<f64>,
    /// Frames of the rows, the first one the identity.
    frames: Vec<Vec<Vec<f64>>>,
    names: BTreeMap<String, Value>,
    /// Does the joint variable turn? Nothing where it does both.
    turns: Vec<Option<bool>>,
}

/// An arm that is drawn at random poses; its fields without a value are drawn too.
pub(super) struct Calculator<'a> {
    spec: &'a ChainSpec,
}

impl<'a> Calculator<'a> {
    pub(super) fn new(spec: &'a ChainSpec) -> Calculator<'a> {
        Calculator { spec }
    }

    pub(super) fn dof(&self) -> usize {
        self.spec.rows.iter().filter(|r| r.moves.is_some()).count()
    }

    fn pose(&self, state: &mut u64) -> Pose {
        let mut values = BTreeMap::new();
        let mut names = BTreeMap::new();
        let scale = self.scale();
        for p in &self.spec.parameters {
            let angle = matches!(p.quantity, Quantity::Angle);
            let value = match &p.role {
                Role::Field(Some(v)) | Role::Constant(v) => match v {
                    Nominal::Length(x) => x.to_f64(),
                    Nominal::Angle(cell) => cell.radians(),
                },
                Role::Field(None) if angle => std::f64::consts::PI * (2.0 * random(state) - 1.0),
                // mostly positive, as lengths are
                Role::Field(None) => scale * (0.4 + random(state)) * if random(state) < 0.2 { -1.0 } else { 1.0 },
            };
            values.insert(p.name.clone(), value);
            names.insert(p.name.clone(), if angle { Value::Angle(value) } else { Value::Number(value) });
        }
        let arm = Arm::new(self.spec, &|n| values.get(n).copied().unwrap_or(f64::NAN));
        let mut turns: Vec<Option<bool>> = vec![None; arm.dof()];
        let mut seen = vec![false; arm.dof()];
        for (revolute, terms) in arm.rows.iter().filter_map(|r| r.moves.as_ref()) {
            for (j, _) in terms {
                turns[*j] = (!seen[*j] || turns[*j] == Some(*revolute)).then_some(*revolute);
                seen[*j] = true;
            }
        }
        let draw = |t: &Option<bool>| match t {
            Some(false) => scale * (3.0 * random(state) - 1.5),
            _ => std::f64::consts::PI * (2.0 * random(state) - 1.0),
        };
        let q: Vec<f64> = turns.iter().map(draw).collect();
        let frames = arm.chain_frames(&q).iter().map(value::rows).collect();
        Pose { modified: self.spec.convention == Convention::Modified, arm, q, frames, names, turns }
    }

    /// The size of lengths.
    fn scale(&self) -> f64 {
        let given = |p: &dh_symbolic::chain::ParameterSpec| match &p.role {
            Role::Field(Some(Nominal::Length(x))) | Role::Constant(Nominal::Length(x)) => x.to_f64().abs(),
            _ => 0.0,
        };
        let largest = self.spec.parameters.iter().map(given).fold(0.0, f64::max);
        if largest > 0.0 { largest } else { 1.0 }
    }

    /// What plain numbers say of a line after definitions. `None`: nothing.
    pub(super) fn truth(&self, lets: &[(String, Given)], line: &[String]) -> Option<Truth> {
        let (mut yes, mut no) = (0, 0);
        let mut state = 4711;
        for _ in 0..POSES {
            let mut pose = self.pose(&mut state);
            for (name, given) in lets {
                let v = match given {
                    Given::Formula(words) => evaluate(words, &pose, false)?,
                    Given::Free(true) => Value::Angle(6.0 * random(&mut state) - 3.0),
                    Given::Free(false) => Value::Number(0.4 + random(&mut state)),
                };
                pose.names.insert(name.clone(), v);
            }
            match holds(line, &pose)? {
                Some(true) => yes += 1,
                Some(false) => no += 1,
                None => {}
            }
            // one hit by chance is none
            if yes > 1 && no > 1 {
                return Some(Truth::Sometimes);
            }
        }
        match (yes, no) {
            (20.., 0) => Some(Truth::Always),
            (0, 20..) => Some(Truth::Never),
            _ => None,
        }
    }
}

/// `A = B = C`, also with both signs, also with `or`: does it hold at a pose? Nothing inside where it is too near to tell, nothing at all
/// where it is not understood.
fn holds(line: &[String], pose: &Pose) -> Option<Option<bool>> {
    let signed = line.iter().any(|w| w == "±" || w == "∓");
    let mut any = Some(false);
    for part in line.split(|w| w == "or") {
        for below in if signed { &[false, true][..] } else { &[false][..] } {
            match equal(part, pose, *below)? {
                Some(true) => any = Some(true),
                None if any != Some(true) => any = None,
                _ => {}
            }
        }
    }
    Some(any)
}

fn equal(line: &[String], pose: &Pose, below: bool) -> Option<Option<bool>> {
    let sides: Vec<&[String]> = line.split(|w| w == "=").collect();
    if sides.len() < 2 {
        return None;
    }
    let values: Vec<Value> = sides.iter().map(|s| evaluate(s, pose, below)).collect::<Option<_>>()?;
    let mut all = Some(true);
    for w in values.windows(2) {
        match compare(&w[0], &w[1]) {
            Some(false) => all = Some(false),
            None if all != Some(false) => all = None,
            _ => {}
        }
    }
    Some(all)
}

fn evaluate(words: &[String], pose: &Pose, below: bool) -> Option<Value> {
    let mut r = Reader { words, at: 0, pose, below };
    let v = r.sum()?;
    (r.at == words.len()).then_some(v)
}
