//! Builds a chain from typed rows: every quantity gets a name, and joints with parallel axes share a group of angles.

use super::*;
use crate::algebra::{Angle, Rational, Transform};

pub(super) fn build(spec: ChainSpec) -> Chain {
    let mut b = Builder { ring: Ring::new(), parameters: Vec::new() };
    for p in &spec.parameters {
        let handle = match p.quantity {
            Quantity::Length => Handle::Length(b.ring.symbol(&p.name)),
            Quantity::Angle => Handle::Angle(b.ring.angle(&p.name)),
        };
        b.parameters.push(Parameter {
            name: p.name.clone(),
            handle,
            role: p.role.clone(),
            declared: true,
            of_point: false,
        });
    }
    let modified = spec.convention == Convention::Modified;
    let (mut links, mut joints, mut drives) = (Vec::new(), Vec::<Joint>::new(), Vec::new());
    let count = spec.rows.iter().filter(|r| r.moves.is_some()).count();
    // Rotation since the axis of the last turning joint; parallel axes share a group.
    let mut since = Transform::identity();
    let mut last_angle: Option<AngleVar> = None;
    for (i, row) in spec.rows.iter().enumerate() {
        let before = if modified { i } else { i + 1 };
        let alpha = b.constant_angle(&row.alpha, &format!("alpha{before}"));
        let a = b.length(&row.a, &format!("a{before}"));
        let alpha_turn = Elementary::Rotate(0, alpha.clone()).transform();
        if modified {
            since = since.times(&alpha_turn);
        }
        let mut link = Link { alpha, a, d: Poly::zero(), theta: LinearAngle::constant(Angle::ZERO), joint: None };
        let mut turns = None;
        let number = joints.len();
        if let Some(drive) = &row.moves {
            let direct =
                matches!(drive.terms.as_slice(), [(v, k)] if *v == number && *k == LengthCell::number(Rational::ONE));
            let name = format!("q{}", number + 1);
            let mut shift = AngleCell::default();
            let coordinate = if drive.revolute {
                let label = if direct { name.clone() } else { b.free_name(&format!("theta{}", i + 1)) };
                let parallel = since.r[0][2].is_zero() && since.r[1][2].is_zero();
                let v = match last_angle {
                    Some(last) if parallel => b.ring.angle_parallel_to(last, &label),
                    _ => b.ring.angle(&label),
                };
                turns = Some(v);
                Coordinate::Angle(v)
            } else {
                let label = if direct { name.clone() } else { b.free_name(&format!("x{}", i + 1)) };
                Coordinate::Length(b.ring.symbol(&label))
            };
            match coordinate {
                Coordinate::Angle(v) => {
                    let exact = row.theta.exact();
                    let whole = row.theta.approx.is_none() && row.theta.symbols.is_empty();
                    let constant = if whole && exact.steps_of_15_degrees().is_some() {
                        exact
                    } else {
                        shift = row.theta.clone();
                        Angle::ZERO
                    };
                    link.theta = LinearAngle { terms: vec![(v, 1)], constant };
                    link.d = b.length(&row.d, &format!("d{}", i + 1));
                }
                Coordinate::Length(s) => {
                    link.theta = b.constant_angle(&row.theta, &format!("theta{}", i + 1));
                    // d is the whole cell; what is added to the variable has another name.
                    link.d = &Poly::symbol(s) + &b.length(&row.d, &format!("b{}", i + 1));
                }
            }
            link.joint = Some(number);
            drives.push(drive.terms.clone());
            joints.push(Joint { name, row: i, coordinate, shift, range: row.range.clone(), label: row.label.clone() });
        } else {
            link.theta = b.constant_angle(&row.theta, &format!("theta{}", i + 1));
            link.d = b.length(&row.d, &format!("d{}", i + 1));
        }
        match turns {
            Some(v) => {
                last_angle = Some(v);
                since = Transform::identity();
            }
            None => since = since.times(&Elementary::Rotate(2, link.theta.clone()).transform()),
        }
        if !modified {
            since = since.times(&alpha_turn);
        }
        links.push(link);
    }
    let drive = drives
        .iter()
        .map(|terms| {
            let mut line = vec![Poly::zero(); count];
            for (v, k) in terms {
                if let Some(cell) = line.get_mut(*v) {
                    *cell = &*cell + &b.polynomial(k);
                }
            }
            line
        })
        .collect();
    let (before, base) = around::split_base(&spec.base);
    let (tool, after) = around::split_tool(&spec.tool);
    let (base, mut tool) = (b.motions(base, "b"), b.motions(tool, "t"));
    if spec.settings.task == Task::Position && !after.is_empty() {
        for (axis, name) in around::POINT.into_iter().enumerate() {
            let name = b.free_name(name);
            let s = b.ring.symbol(&name);
            let (handle, role) = (Handle::Length(s), Role::Field(None));
            b.parameters.push(Parameter { name, handle, role, declared: false, of_point: true });
            tool.push(Elementary::Translate(axis, Poly::symbol(s)));
        }
    }
    let (before, after) = (b.factors(before, "b"), b.factors(after, "t"));
    let of_pose = |b: &mut Builder, p: &PoseSpec| PoseField {
        name: p.name.clone(),
        nominal: p.nominal.as_ref().map(|list| b.motions(list, &format!("{}_", p.name))),
    };
    let poses = spec.poses.iter().map(|p| of_pose(&mut b, p)).collect();
    Chain {
        name: spec.name,
        convention: spec.convention,
        settings: spec.settings,
        ring: b.ring,
        parameters: b.parameters,
        links,
        joints,
        drive,
        base,
        tool,
        poses,
        before,
        after,
    }
}

struct Builder {
    ring: Ring,
    parameters: Vec<Parameter>,
}

impl Builder {
    /// A polynomial in the declared lengths, numbers as they are.
    fn polynomial(&self, cell: &LengthCell) -> Poly {
        cell.terms
            .iter()
            .map(|(c, factors)| {
                factors.iter().fold(Poly::constant(c.clone()), |p, i| match self.parameters.get(*i).map(|x| x.handle) {
                    Some(Handle::Length(s)) => &p * &Poly::symbol(s),
                    _ => p,
                })
            })
            .sum()
    }

    /// A cell with a length. Bare numbers in it become named constants, one name for one magnitude, so that every formula stays
    /// homogeneous in lengths.
    fn length(&mut self, cell: &LengthCell, name: &str) -> Poly {
        let mut sum = Vec::new();
        for (x, factors) in &cell.terms {
            sum.push(if factors.is_empty() {
                let s = self.number(&x.abs(), name);
                if x.is_negative() { -&Poly::symbol(s) } else { Poly::symbol(s) }
            } else {
                self.polynomial(&LengthCell { terms: vec![(x.clone(), factors.clone())] })
            });
        }
        sum.into_iter().sum()
    }

    /// The named constant of a magnitude.
    fn number(&mut self, x: &Rational, name: &str) -> Symbol {
        let role = Role::Constant(Nominal::Length(x.clone()));
        // A length and an offset of the same size keep names of their own: a2 and d4 of the PUMA are different things.
        let same_letter = |p: &Parameter| p.name.chars().next() == name.chars().next();
        let known = self.parameters.iter().find(|p| !p.declared && p.role == role && same_letter(p)).map(|p| p.handle);
        if let Some(Handle::Length(s)) = known {
            return s;
        }
        let name = self.free_name(name);
        let s = self.ring.symbol(&name);
        self.parameters.push(Parameter { name, handle: Handle::Length(s), role, declared: false, of_point: false });
        s
    }

    /// A constant angle. What has no exact sine becomes a named constant angle.
    fn constant_angle(&mut self, cell: &AngleCell, name: &str) -> LinearAngle {
        let mut angle = LinearAngle::constant(Angle::ZERO);
        for (i, k) in &cell.symbols {
            if let Some(Handle::Angle(v)) = self.parameters.get(*i).map(|p| p.handle) {
                angle.terms.push((v, *k));
            }
        }
        let exact = cell.exact();
        if cell.approx.is_none() && exact.steps_of_15_degrees().is_some() {
            angle.constant = exact;
            return angle;
        }
        let number = AngleCell { symbols: Vec::new(), ..cell.clone() };
        let negative = number.approx.as_ref().or(number.half_turns.as_ref()).is_some_and(Rational::is_negative);
        let minus_one = Rational::int(-1);
        let flip = |x: &Option<Rational>| x.as_ref().map(|x| if negative { x * &minus_one } else { x.clone() });
        let magnitude =
            AngleCell { half_turns: flip(&number.half_turns), approx: flip(&number.approx), symbols: Vec::new() };
        let role = Role::Constant(Nominal::Angle(magnitude));
        let known = self.parameters.iter().find(|p| !p.declared && p.role == role).map(|p| p.handle);
        let v = match known {
            Some(Handle::Angle(v)) => v,
            _ => {
                let name = self.free_name(name);
                let v = self.ring.angle(&name);
                self.parameters.push(Parameter {
                    name,
                    handle: Handle::Angle(v),
                    role,
                    declared: false,
                    of_point: false,
                });
                v
            }
        };
        angle.terms.push((v, if negative { -1 } else { 1 }));
        angle
    }

    fn motions(&mut self, list: &[MotionSpec], prefix: &str) -> Vec<Elementary> {
        let constant = |f: Factor| match f {
            Factor::Motion(m) => Some(m),
            Factor::Pose(_) => None,
        };
        self.factors(list, prefix).into_iter().filter_map(constant).collect()
    }

    fn factors(&mut self, list: &[MotionSpec], prefix: &str) -> Vec<Factor> {
        let axis_name = ["x", "y", "z"];
        list.iter()
            .map(|m| match m {
                MotionSpec::Translate(axis, cell) => {
                    let length = self.length(cell, &format!("{prefix}{}", axis_name[*axis % 3]));
                    Factor::Motion(Elementary::Translate(*axis, length))
                }
                MotionSpec::Rotate(axis, cell) => {
                    let angle = self.constant_angle(cell, &format!("{prefix}r{}", axis_name[*axis % 3]));
                    Factor::Motion(Elementary::Rotate(*axis, angle))
                }
                MotionSpec::Pose(i) => Factor::Pose(*i),
            })
            .collect()
    }

    /// `name`, or `name_2`, `name_3`, ... where it is taken.
    fn free_name(&self, name: &str) -> String {
        let taken = |n: &str| self.parameters.iter().any(|p| p.name == n);
        if !taken(name) {
            return name.to_string();
        }
        (2..).map(|i| format!("{name}_{i}")).find(|n| !taken(n)).unwrap_or_else(|| name.to_string())
    }
}
