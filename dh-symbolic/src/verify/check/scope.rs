//! What a name means in a derivation: local names, declared names, cells of the table, joint variables, c23 and sa2.

use super::Evaluator;
use super::ratio::{Ratio, Worked};
use super::value::{Turn, Value};
use crate::algebra::{Angle, AngleVar, Poly, Rational, adjugate};
use crate::chain::{AngleCell, Chain, Convention, Coordinate, Handle, Nominal, Parameter, Role};

/// `prefix` and a number from 0: `a2` is ("a", 2).
pub(super) fn numbered(name: &str) -> Option<(&str, usize)> {
    let at = name.find(|c: char| c.is_ascii_digit())?;
    let (prefix, digits) = name.split_at(at);
    let fine =
        digits.len() <= 3 && digits.bytes().all(|b| b.is_ascii_digit()) && (digits == "0" || !digits.starts_with('0'));
    if fine { Some((prefix, digits.parse().ok()?)) } else { None }
}

/// Is it a number of the table that has this name, and no cell has?
pub(super) fn is_number_without_cell(p: &Parameter, name: &str) -> bool {
    let cell = numbered(name).is_some_and(|s| matches!(s.0, "q" | "theta" | "d" | "a" | "alpha"));
    !p.declared && p.name == name && !cell
}

impl Evaluator<'_> {
    /// The value of a name; otherwise the reason why it has none.
    pub(super) fn name(&mut self, name: &str) -> Result<Value, String> {
        if let Some((_, v)) = self.locals.iter().rev().find(|(n, _)| n == name) {
            return Ok(v.clone());
        }
        if let Some(v) = self.known(name) {
            return Ok(v);
        }
        match name.split_at_checked(1) {
            Some(("c", rest)) if !rest.is_empty() => self.abbreviation(rest, false, name),
            Some(("s", rest)) if !rest.is_empty() => self.abbreviation(rest, true, name),
            _ => Err(self.unknown(name)),
        }
    }

    fn unknown(&self, name: &str) -> String {
        match numbered(name) {
            Some(("a" | "d" | "alpha" | "theta", _)) => {
                let n = self.chain.links.len();
                let (first, last) = match self.chain.convention {
                    Convention::Modified => (0, n.saturating_sub(1)),
                    Convention::Standard => (1, n),
                };
                format!(
                    "the table has no `{name}`: it has alpha{first}, a{first} to alpha{last}, a{last} and d1, theta1 to d{n}, theta{n}"
                )
            }
            Some(("q", _)) => format!("there is no `{name}`: the arm has {} joints", self.chain.joints.len()),
            _ => format!("unknown name `{name}`"),
        }
    }

    /// Is the name taken by something that a local name must not hide?
    pub(super) fn is_taken(&mut self, name: &str) -> bool {
        !matches!(name, "J" | "Jv" | "Jw") && self.name(name).is_ok()
    }

    /// Names that mean something without any `let` in the derivation, except c23 and the like.
    fn known(&mut self, name: &str) -> Option<Value> {
        if let Some(v) = self.quantity(name) {
            return Some(v);
        }
        Some(match name {
            "base" => self.fixed(self.kinematics.base()),
            "tool" => self.fixed(self.kinematics.tool()),
            "J" => Value::Matrix(self.jacobian()),
            "Jv" => Value::Matrix(self.rows_of_jacobian(&[0, 1, 2])),
            "Jw" => Value::Matrix(self.rows_of_jacobian(&[3, 4, 5])),
            "I3" => Value::Matrix(super::value::Matrix::identity(3)),
            "I4" => Value::Matrix(super::value::Matrix::identity(4)),
            _ => return None,
        })
    }

    /// Lengths and angles of the table: declared ones, cells, joint variables.
    pub(super) fn quantity(&self, name: &str) -> Option<Value> {
        let handle = |h: Handle| match h {
            Handle::Length(s) => Value::Scalar(Poly::symbol(s).into()),
            Handle::Angle(v) => Value::Angle(Turn::var(v)),
        };
        let parameters = &self.chain.parameters;
        if let Some(p) = parameters.iter().find(|p| p.declared && p.name == name) {
            return Some(handle(p.handle));
        }
        if name == "pi" {
            return Some(Value::Angle(Turn::constant(Angle::half_turns(Rational::ONE))));
        }
        if let Some(p) = parameters.iter().find(|p| is_number_without_cell(p, name)) {
            return Some(handle(p.handle));
        }
        let (prefix, number) = numbered(name)?;
        // rows count theta_i and d_i from 1; the modified convention keeps alpha and a of the link before
        let ahead = usize::from(self.chain.convention == Convention::Modified);
        let own = number.checked_sub(1);
        match prefix {
            "q" => self.joints.get(own?).cloned(),
            "theta" => {
                let link = self.chain.links.get(own?)?;
                Some(Value::Angle(Turn::linear(&link.theta)))
            }
            "d" => Some(Value::Scalar(self.chain.links.get(own?)?.d.clone().into())),
            "a" => Some(Value::Scalar(self.chain.links.get((number + ahead).checked_sub(1)?)?.a.clone().into())),
            "alpha" => Some(Value::Angle(Turn::linear(&self.chain.links.get((number + ahead).checked_sub(1)?)?.alpha))),
            _ => None,
        }
    }

    /// c23, sa2, cphi: `rest` is what follows the first letter.
    fn abbreviation(&mut self, rest: &str, sine: bool, name: &str) -> Result<Value, String> {
        let turn = if rest.bytes().all(|b| b.is_ascii_digit() || b == b'_') {
            let numbers: Vec<&str> = if rest.contains('_') {
                rest.split('_').collect()
            } else {
                rest.split("").filter(|d| !d.is_empty()).collect()
            };
            let mut sum = Turn::constant(Angle::ZERO);
            for n in numbers {
                sum = sum.plus(&self.joint_angle(n.parse().ok().ok_or_unknown(name)?)?);
            }
            sum
        } else {
            let long = match rest.strip_prefix('a') {
                Some(digits) if !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()) => {
                    format!("alpha{digits}")
                }
                _ => rest.to_string(),
            };
            let local = self.locals.iter().rev().find(|(n, _)| *n == long).map(|(_, v)| v.clone());
            match local.or_else(|| self.known(&long)) {
                Some(Value::Angle(t)) => t,
                _ => return Err(self.unknown(name)),
            }
        };
        let (c, s) =
            self.cos_sin(&turn).map_err(|t| t.why().to_string())?.ok_or("this angle has no sine in the normal form")?;
        Ok(Value::Scalar(if sine { s } else { c }))
    }

    /// The variable of turning joint `n` (from 1).
    pub(super) fn joint_angle(&self, n: usize) -> Result<Turn, String> {
        match n.checked_sub(1).and_then(|i| self.joints.get(i)) {
            Some(Value::Angle(t)) => Ok(t.clone()),
            Some(_) => Err(format!("joint {n} slides: q{n} has no cosine")),
            None => Err(format!("there is no joint {n}: the arm has {}", self.joints.len())),
        }
    }

    fn fixed(&self, t: &crate::algebra::Transform) -> Value {
        Value::Matrix(super::value::Matrix::from_transform(t))
    }
}

trait OrUnknown<T> {
    fn ok_or_unknown(self, name: &str) -> Result<T, String>;
}

impl<T> OrUnknown<T> for Option<T> {
    fn ok_or_unknown(self, name: &str) -> Result<T, String> {
        self.ok_or_else(|| format!("unknown name `{name}`"))
    }
}

/// The constant part that a joint angle keeps out of the formulas.
fn shift(chain: &Chain, cell: &AngleCell) -> Turn {
    let mut turn = Turn::constant(cell.exact());
    if let Some(x) = &cell.approx {
        turn = turn.plus(&Turn::constant(radians(x.to_f64())));
    }
    for (i, k) in &cell.symbols {
        if let Some(Handle::Angle(v)) = chain.parameters.get(*i).map(|p| p.handle) {
            let one = Turn::var(v);
            turn = turn.plus(&one.times(&Rational::int(i64::from(*k))).unwrap_or(one));
        }
    }
    turn
}

/// The constant angles of the table that have no exact sine, with their sizes: `20deg` in a cell and in a line are one.
pub(super) fn constant_angles(chain: &Chain) -> Vec<(AngleVar, Angle)> {
    let constant = |p: &Parameter| match (&p.role, p.handle) {
        (Role::Constant(Nominal::Angle(a)), Handle::Angle(v)) => {
            let approx = a.approx.as_ref().map_or(Angle::ZERO, |x| radians(x.to_f64()));
            Some((v, a.exact().plus(&approx)))
        }
        _ => None,
    };
    chain.parameters.iter().filter_map(constant).filter(|c| !c.1.factor().is_negative()).collect()
}

/// Radians as a multiple of pi, to the digits that a double has.
pub(super) fn radians(x: f64) -> Angle {
    let half_turns = x / std::f64::consts::PI;
    let digits = Rational::from_decimal(&format!("{:e}", half_turns.abs())).unwrap_or(Rational::ZERO);
    Angle::half_turns(if half_turns < 0.0 { -&digits } else { digits })
}

/// The joint variables q_k in the coordinates of the formulas: the drive turned around.
pub(super) fn joint_variables(chain: &Chain, scalar: impl Fn(&Turn) -> Ratio) -> Worked<Vec<Value>> {
    let coordinates: Vec<Value> = chain
        .joints
        .iter()
        .map(|j| match j.coordinate {
            Coordinate::Angle(v) => Value::Angle(Turn::var(v).plus(&shift(chain, &j.shift).negated())),
            Coordinate::Length(s) => Value::Scalar(Poly::symbol(s).into()),
        })
        .collect();
    if chain.is_direct() {
        return Ok(coordinates);
    }
    let mut work = super::ratio::Work::new();
    let (adjugate, determinant) = adjugate(&chain.drive);
    let determinant = Ratio::from(determinant);
    let mut out = Vec::new();
    for row in &adjugate {
        let row: Vec<Ratio> =
            row.iter().map(|k| Ratio::from(k.clone()).over(&determinant, &mut work)).collect::<Worked<_>>()?;
        let used: Vec<(&Ratio, &Value)> = row.iter().zip(&coordinates).filter(|(k, _)| !k.is_zero()).collect();
        let turns: Option<Vec<Turn>> = used
            .iter()
            .map(|(k, v)| match v {
                Value::Angle(t) => t.times(&k.as_rational()?),
                _ => None,
            })
            .collect();
        out.push(match turns {
            Some(turns) => Value::Angle(turns.iter().fold(Turn::constant(Angle::ZERO), |sum, t| sum.plus(t))),
            None => {
                let mut sum = Ratio::zero();
                for (k, v) in used {
                    let x = match v {
                        Value::Angle(t) => scalar(t),
                        Value::Scalar(x) => x.clone(),
                        Value::Matrix(_) => Ratio::zero(),
                    };
                    sum = sum.plus(&k.times(&x, &mut work)?, &mut work)?;
                }
                Value::Scalar(sum)
            }
        });
    }
    Ok(out)
}
