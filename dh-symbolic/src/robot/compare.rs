//! Compares two tables: whether they describe one arm, and which constant transforms relate their frames.
//!
//! A standard and a modified table of one arm put their frames at different places of the same links. With D such a constant
//! transform, T_A(i) = T_B(j) * D: these are carried from joint to joint, D' = L_B^-1 * D * L_A, so nothing long is ever formed.

use super::Robot;
use crate::algebra::{Angle, AngleVar, LinearAngle, Poly, Rational, Ring, Symbol, Transform};
use crate::chain::{AngleCell, Chain, Coordinate, Handle, Nominal, Parameter, Role};
use crate::kinematics::Kinematics;
use crate::render::formula::grouping::Order;
use crate::render::formula::plain;
use std::fmt::{self, Write};

/// What two tables have in common: `Display` prints the transforms that join their frames.
///
/// Joint variables are the same where their names are; lengths and angles that both tables declare as fields are the same where their
/// names are, all others count with their values.
///
/// ```
/// # fn main() -> Result<(), dh_symbolic::TableError> {
/// use dh_symbolic::{Comparison, Robot};
/// let table = |convention, rows| format!("struct A; convention = {convention}; let l: length;\n| theta | d | a | alpha |\n{rows}");
/// let craig = Robot::parse(&table("modified", "| q1 | 0 | 0 | 0 |\n| q2 | 0.1 | l | 90deg |"))?;
/// let paul = Robot::parse(&table("standard", "| q1 | 0 | l | 90deg |\n| q2 | 0.1 | 0 | 0 |"))?;
/// let comparison = Comparison::new(&paul, &craig);
/// assert!(comparison.same());
/// assert!(comparison.to_string().contains("frame 1: D = tx(l) * rx(90deg)"), "{comparison}");
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Comparison {
    text: String,
    same: bool,
}

impl Comparison {
    /// Compares two robots.
    pub fn new(a: &Robot, b: &Robot) -> Comparison {
        let (a_chain, b_chain) = (&a.arm.chain, &b.arm.chain);
        let fields = shared_fields(a_chain, b_chain);
        let mut common = Common::default();
        let first = Side::new(a_chain, &a.kinematics, &fields, a_chain, &mut common);
        let second = Side::new(b_chain, &b.kinematics, &fields, a_chain, &mut common);
        let mut comparison = Comparison { text: String::new(), same: false };
        comparison.walk(&first, &second, &common);
        let names = format!("A = {} ({}), B = {} ({})", a.name(), a.source.name, b.name(), b.source.name);
        let verdict = match comparison.same {
            true => "one arm: T_A = T_B * D with constant transforms D",
            false => "the arms differ",
        };
        comparison.text = format!("{names}\n{verdict}\n{}", comparison.text);
        comparison
    }

    /// Is every link of one arm joined to a link of the other by a constant transform?
    pub fn same(&self) -> bool {
        self.same
    }

    fn walk(&mut self, a: &Side<'_>, b: &Side<'_>, common: &Common) {
        let (Some(base_a), Some(base_b)) = (a.step(a.kinematics.base()), b.step(b.kinematics.base())) else {
            self.text.push_str("angles without exact sines are not compared\n");
            return;
        };
        let mut d = base_b.inverse().times(&base_a);
        self.line("frame 0", &d, common);
        if a.chain.dof() != b.chain.dof() {
            let _ = writeln!(self.text, "A has {} joints, B has {}", a.chain.dof(), b.chain.dof());
            return;
        }
        let (mut from_a, mut from_b) = (0, 0);
        for (k, (i, j)) in a.chain.joints.iter().zip(&b.chain.joints).enumerate() {
            let (to_a, to_b) = (i.row + 1, j.row + 1);
            let Some(next) = joined(&d, a.link(from_a, to_a), b.link(from_b, to_b)) else { return };
            (d, from_a, from_b) = (next, to_a, to_b);
            if !common.is_constant(&d) {
                let text =
                    format!("joint {}: no constant transform joins frame {to_a} of A and frame {to_b} of B", k + 1);
                self.text.push_str(&format!("{text}\n"));
                return;
            }
            let name = if to_a == to_b { format!("frame {to_a}") } else { format!("frame {to_a} of A, {to_b} of B") };
            self.line(&name, &d, common);
        }
        let (last_a, last_b) = (a.chain.links.len(), b.chain.links.len());
        let end = |side: &Side<'_>, from: usize, to: usize| {
            Some(side.link(from, to)?.times(&side.step(side.kinematics.tool())?))
        };
        if let Some(d) = joined(&d, end(a, from_a, last_a), end(b, from_b, last_b)) {
            self.line("pose of the tool", &d, common);
            self.same = true;
        }
    }

    fn line(&mut self, name: &str, d: &Transform, common: &Common) {
        let _ = writeln!(self.text, "{name}: {}", common.text(d));
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// L_B^-1 * D * L_A.
fn joined(d: &Transform, a: Option<Transform>, b: Option<Transform>) -> Option<Transform> {
    Some(b?.inverse().times(&d.times(&a?)))
}

/// Names that both tables declare as fields of one kind.
fn shared_fields(a: &Chain, b: &Chain) -> Vec<String> {
    let is_field = |p: &&Parameter| matches!(p.role, Role::Field(_));
    let angle = |p: &Parameter| matches!(p.handle, Handle::Angle(_));
    let other = |p: &&Parameter| b.parameters.iter().any(|q| is_field(&q) && q.name == p.name && angle(q) == angle(p));
    a.parameters.iter().filter(is_field).filter(other).map(|p| p.name.clone()).collect()
}

/// The names that both arms share, in one ring.
#[derive(Default)]
struct Common {
    ring: Ring,
    /// Constant angles without exact sines, by their size.
    sizes: Vec<(AngleCell, AngleVar)>,
    /// What moves: whether it turns, the combination of the joint variables, and its name in the ring.
    coordinates: Vec<(bool, Vec<Poly>, Coordinate)>,
}

impl Common {
    /// A constant angle: exact, or under the name of its size.
    fn angle(&mut self, cell: &AngleCell) -> LinearAngle {
        let exact = cell.exact();
        if cell.approx.is_none() && exact.steps_of_15_degrees().is_some() {
            return LinearAngle::constant(exact);
        }
        let minus = |x: &Option<Rational>| x.as_ref().map(|x| x * &Rational::int(-1));
        let negative = cell.approx.as_ref().or(cell.half_turns.as_ref()).is_some_and(Rational::is_negative);
        let size = match negative {
            true => AngleCell { half_turns: minus(&cell.half_turns), approx: minus(&cell.approx), symbols: vec![] },
            false => AngleCell { symbols: vec![], ..cell.clone() },
        };
        let known = self.sizes.iter().find(|s| s.0 == size).map(|s| s.1);
        let v = known.unwrap_or_else(|| {
            let v = self.ring.angle(&format!("angle{}", self.sizes.len() + 1));
            self.sizes.push((size, v));
            v
        });
        LinearAngle { terms: vec![(v, if negative { -1 } else { 1 })], constant: Angle::ZERO }
    }

    /// A declared angle.
    fn named_angle(&mut self, name: &str) -> LinearAngle {
        LinearAngle::var(self.ring.find_angle(name).unwrap_or_else(|| self.ring.angle(name)))
    }

    /// The name of a coordinate that is this combination of joint variables; a new one is parallel to `neighbour`.
    fn coordinate(&mut self, revolute: bool, row: Vec<Poly>, neighbour: Option<AngleVar>) -> Coordinate {
        if let Some((_, _, known)) = self.coordinates.iter().find(|c| c.0 == revolute && c.1 == row) {
            return *known;
        }
        let name = format!("coordinate{}", self.coordinates.len() + 1);
        let new = match (revolute, neighbour) {
            (true, Some(v)) => Coordinate::Angle(self.ring.angle_parallel_to(v, &name)),
            (true, None) => Coordinate::Angle(self.ring.angle(&name)),
            (false, _) => Coordinate::Length(self.ring.symbol(&name)),
        };
        self.coordinates.push((revolute, row, new));
        new
    }

    fn is_constant(&self, t: &Transform) -> bool {
        t.r.iter().flatten().chain(&t.p).all(|p| {
            self.coordinates.iter().all(|c| match c.2 {
                Coordinate::Angle(v) => !p.has_angle(v),
                Coordinate::Length(s) => !p.has_symbol(s),
            })
        })
    }

    /// `D = tx(a2) * rx(90deg)` where the rotation is about one axis, else the matrix.
    fn text(&self, t: &Transform) -> String {
        let formula = |p: &Poly| plain::formula(&self.ring, &Order::default(), p);
        let shift = |p: &[Poly; 3]| -> Vec<String> {
            let factors = ["tx", "ty", "tz"].iter().zip(p).filter(|(_, p)| !p.is_zero());
            factors.map(|(name, p)| format!("{name}({})", formula(p))).collect()
        };
        let mut factors = shift(&t.p);
        let turn = (0..3).flat_map(|axis| (0..24).map(move |n| (axis, n))).find(|(axis, n)| {
            let angle = Angle::degrees(&Rational::int(15 * n));
            angle.cos_sin().is_some_and(|(c, s)| Transform::rotation(*axis, (&c, &s)).r == t.r)
        });
        match turn {
            Some((_, 0)) => {}
            Some((axis, n)) => {
                factors.push(format!("r{}({}deg)", ["x", "y", "z"][axis], if n > 12 { 15 * n - 360 } else { 15 * n }));
            }
            None => {
                let row = |i: usize| t.r[i].iter().chain([&t.p[i]]).map(formula).collect::<Vec<_>>().join(", ");
                return format!(
                    "D = [{}]",
                    (0..3).map(row).chain(["0, 0, 0, 1".into()]).collect::<Vec<_>>().join("; ")
                );
            }
        }
        if factors.is_empty() { "equal".into() } else { format!("D = {}", factors.join(" * ")) }
    }
}

/// One table in the names of both, lengths in the unit of the first.
struct Side<'a> {
    chain: &'a Chain,
    kinematics: &'a Kinematics,
    /// Unit of this table over that of the first.
    scale: Rational,
    symbols: Vec<(Symbol, Poly)>,
    angles: Vec<(AngleVar, LinearAngle)>,
}

impl<'a> Side<'a> {
    fn new(
        chain: &'a Chain,
        kinematics: &'a Kinematics,
        fields: &[String],
        unit_of: &Chain,
        common: &mut Common,
    ) -> Side<'a> {
        let ratio = |x: &Rational, y: &Rational| x.recip().map_or(Rational::ONE, |r| &r * y);
        let scale = ratio(&unit_of.settings.unit.metres, &chain.settings.unit.metres);
        let back = ratio(&scale, &Rational::ONE);
        let (mut symbols, mut angles) = (Vec::new(), Vec::new());
        for p in &chain.parameters {
            let value = match &p.role {
                _ if fields.contains(&p.name) => None,
                Role::Constant(value) | Role::Field(Some(value)) => Some(value),
                Role::Field(None) => None,
            };
            match (p.handle, value) {
                (Handle::Length(s), Some(Nominal::Length(x))) => symbols.push((s, Poly::constant(x.clone()))),
                (Handle::Length(s), _) => symbols.push((s, Poly::symbol(common.ring.symbol(&p.name)).scale(&back))),
                (Handle::Angle(v), Some(Nominal::Angle(cell))) => angles.push((v, common.angle(cell))),
                (Handle::Angle(v), _) => angles.push((v, common.named_angle(&p.name))),
            }
        }
        let mut side = Side { chain, kinematics, scale, symbols, angles };
        let mut turning: Vec<(AngleVar, AngleVar)> = Vec::new();
        for (joint, row) in chain.joints.iter().zip(&chain.drive) {
            let row: Vec<Poly> = row.iter().map(|p| side.lengths(p)).collect();
            match joint.coordinate {
                Coordinate::Length(s) => {
                    if let Coordinate::Length(x) = common.coordinate(false, row, None) {
                        side.symbols.push((s, Poly::symbol(x).scale(&back)));
                    }
                }
                Coordinate::Angle(v) => {
                    let neighbour = turning.iter().rev().find(|t| t.0.group() == v.group()).map(|t| t.1);
                    if let Coordinate::Angle(x) = common.coordinate(true, row, neighbour) {
                        turning.push((v, x));
                        let angle = side.shifted(x, &joint.shift, common);
                        side.angles.push((v, angle));
                    }
                }
            }
        }
        side
    }

    /// A joint's angle: the combination of joint variables and the constant part that the table adds.
    fn shifted(&self, x: AngleVar, shift: &AngleCell, common: &mut Common) -> LinearAngle {
        let mut angle = common.angle(&AngleCell { symbols: vec![], ..shift.clone() });
        for (parameter, times) in &shift.symbols {
            let Some(Handle::Angle(v)) = self.chain.parameters.get(*parameter).map(|p| p.handle) else { continue };
            let Some((_, named)) = self.angles.iter().find(|a| a.0 == v) else { continue };
            angle.constant = angle.constant.plus(&named.constant.times(&i64::from(*times).into()));
            angle.terms.extend(named.terms.iter().map(|(w, k)| (*w, k.saturating_mul(*times))));
        }
        angle.terms.push((x, 1));
        angle
    }

    fn lengths(&self, p: &Poly) -> Poly {
        p.substitute_symbols(|s| self.symbols.iter().find(|x| x.0 == s).map(|x| x.1.clone()))
    }

    fn poly(&self, p: &Poly) -> Option<Poly> {
        self.lengths(p).substitute_angles(|v| self.angles.iter().find(|x| x.0 == v).map(|x| x.1.clone()))
    }

    /// A transform in the common names.
    fn step(&self, t: &Transform) -> Option<Transform> {
        let mut out = Transform::identity();
        for i in 0..3 {
            for j in 0..3 {
                out.r[i][j] = self.poly(&t.r[i][j])?;
            }
            out.p[i] = self.poly(&t.p[i])?.scale(&self.scale);
        }
        Some(out)
    }

    /// The product of some rows.
    fn link(&self, from: usize, to: usize) -> Option<Transform> {
        self.step(&self.kinematics.transform(from, to)?)
    }
}
