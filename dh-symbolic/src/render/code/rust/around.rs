//! Prints robots with poses that the program sets: the arm of the formulas becomes a private type, and the robot's functions put at run
//! time what stands around it (`dh_robot::runtime::Around`).

use super::structure::{Batches, joints};
use super::target::Target;
use crate::algebra::{AngleVar, Symbol};
use crate::chain::{Chain, Elementary, Factor, Handle, Role, Scalar, Task};
use crate::program::{Forward, Inverse};
use crate::render::code::body::field_polynomial;
use crate::render::code::{constant_pose, literal, scalar_name};

/// The type that implements the formulas: the robot itself, or the private type of the arm inside it.
pub fn implementing(chain: &Chain, name: &str) -> String {
    if chain.is_part() { format!("{name}Inside") } else { name.to_string() }
}

/// The items of such a robot: `arm` are those of the arm inside it.
pub(super) fn items(chain: &Chain, name: &str, forward: &Forward, arm: &str, inverse: Option<&Inverse>) -> String {
    let inside = implementing(chain, name);
    let (n, f) = (chain.dof(), scalar_name(chain.settings.scalar));
    let printer = Printer { chain, inside: &inside };
    let inverse_text = inverse.map_or_else(String::new, |inverse| printer.inverse(inverse));
    let traits = inverse.map_or_else(String::new, |inverse| {
        super::inverse::as_trait(chain, name, inverse.plan.max_solutions, &Target::of(chain, &|_| String::new()).kind)
    });
    format!(
        "#[allow(non_local_definitions)]\nconst _: () = {{\n{}{arm}\
         #[allow(unused, clippy::all, clippy::pedantic)]\nimpl {name} {{\n\
         /// Number of joints.\npub const DOF: usize = {n};\n\
         /// Kind, range and name of every joint.\npub const JOINTS: [::dh_robot::Joint<{f}>; {n}] = [{}];\n{}{inverse_text}}}\n{}{traits}}};\n",
        printer.declaration(),
        joints(chain),
        printer.forward(),
        super::forward::traits(chain, forward, name, Batches::OneByOne),
    )
}

struct Printer<'a> {
    chain: &'a Chain,
    inside: &'a str,
}

impl Printer<'_> {
    fn f(&self) -> &'static str {
        scalar_name(self.chain.settings.scalar)
    }

    /// The fields of the arm inside: its parameters.
    fn declaration(&self) -> String {
        let fields = self.chain.parameters.iter().filter(|p| matches!(p.role, Role::Field(_)));
        let list: Vec<String> = fields.map(|p| format!("{}: {}", p.name, self.f())).collect();
        format!(
            "/// The arm that the formulas are about: what stands between the poses that the program sets.\n\
             #[derive(Clone, Copy)]\n#[allow(dead_code)]\nstruct {} {{ {} }}\n",
            self.inside,
            list.join(", ")
        )
    }

    fn is_field(&self, handle: Handle) -> bool {
        self.chain.parameters.iter().any(|p| p.handle == handle && matches!(p.role, Role::Field(_)))
    }

    /// Whether the value of a motion changes with a field.
    fn has_fields(&self, motion: &Elementary) -> bool {
        match motion {
            Elementary::Translate(_, p) => p.symbols().iter().any(|s: &Symbol| self.is_field(Handle::Length(*s))),
            Elementary::Rotate(_, a) => a.terms.iter().any(|(v, _): &(AngleVar, _)| self.is_field(Handle::Angle(*v))),
        }
    }

    /// A motion whose value changes with a field.
    fn motion(&self, motion: &Elementary) -> String {
        let f = self.f();
        match motion {
            Elementary::Translate(axis, p) => {
                format!("::dh_robot::runtime::translation::<{f}>({axis}, {})", field_polynomial(self.chain, p))
            }
            Elementary::Rotate(axis, angle) => {
                let term = |(v, k): &(AngleVar, i8)| {
                    let handle = Handle::Angle(*v);
                    let name = self.chain.parameters.iter().find(|p| p.handle == handle).map(|p| p.name.as_str());
                    match name.filter(|_| self.is_field(handle)) {
                        Some(name) => format!("{k}.0 * f64::from(self.{name})"),
                        None => literal(f64::from(*k) * self.chain.nominal(handle), Scalar::F64),
                    }
                };
                let constant = literal(angle.constant.radians(), Scalar::F64);
                let sum: Vec<String> = angle.terms.iter().map(term).chain([constant]).collect();
                format!("::dh_robot::runtime::rotation::<{f}>({axis}, {})", sum.join(" + "))
            }
        }
    }

    /// A product; constant motions beside each other are one literal.
    fn product(&self, factors: &[Factor]) -> String {
        if factors.is_empty() {
            return "::core::option::Option::None".into();
        }
        let (mut parts, mut run): (Vec<String>, Vec<Elementary>) = (Vec::new(), Vec::new());
        let flush = |run: &mut Vec<Elementary>, parts: &mut Vec<String>| {
            if !run.is_empty() {
                parts.push(constant_pose(self.chain, run));
                run.clear();
            }
        };
        for factor in factors {
            match factor {
                Factor::Motion(m) if !self.has_fields(m) => run.push(m.clone()),
                Factor::Motion(m) => {
                    flush(&mut run, &mut parts);
                    parts.push(self.motion(m));
                }
                Factor::Pose(i) => {
                    flush(&mut run, &mut parts);
                    parts.push(format!("pose_{i}"));
                }
            }
        }
        flush(&mut run, &mut parts);
        format!("::core::option::Option::Some({})", parts.join(" * "))
    }

    /// The expression of what stands around the arm, from `pose_0`, `pose_1`, ...
    fn around(&self) -> String {
        format!(
            "::dh_robot::runtime::Around {{ before: {}, after: {} }}",
            self.product(&self.chain.before),
            self.product(&self.chain.after)
        )
    }

    fn forward(&self) -> String {
        let (n, f, inside) = (self.chain.dof(), self.f(), self.inside);
        let iso = format!("::dh_robot::nalgebra::IsometryMatrix3<{f}>");
        let matrix = format!("::dh_robot::nalgebra::SMatrix<{f}, 6, {n}>");
        let unit = self.chain.settings.unit.name;
        let raw = |(i, p): (usize, &crate::chain::PoseField)| format!("let pose_{i} = self.{};\n", p.name);
        let rigid = |(i, p): (usize, &crate::chain::PoseField)| {
            format!("let pose_{i} = ::dh_robot::runtime::rigid(&self.{0}, \"{0}\")?;\n", p.name)
        };
        let raw: String = self.chain.poses.iter().enumerate().map(raw).collect();
        let rigid: String = self.chain.poses.iter().enumerate().map(rigid).collect();
        let around = self.around();
        let point = self.chain.point();
        let value = |p: &crate::chain::Parameter| match point.as_ref().and_then(|o| o.iter().position(|x| *x == p.name))
        {
            Some(axis) => format!("{}: around.point()[{axis}]", p.name),
            None => format!("{0}: self.{0}", p.name),
        };
        let fields = self.chain.parameters.iter().filter(|p| matches!(p.role, Role::Field(_))).map(value);
        let fields = fields.collect::<Vec<_>>().join(", ");
        let outer = if point.is_some() { "around.at_point()" } else { "around" };
        let mut out = format!(
            "/// What stands around the arm of the formulas.\n#[inline]\nfn around(&self) -> ::dh_robot::runtime::Around<{f}> {{\n{raw}{around}\n}}\n\
             /// The same with poses that are exact rigid motions; or the reason why there are none.\n\
             fn rigid_around(&self) -> ::core::result::Result<::dh_robot::runtime::Around<{f}>, ::dh_robot::Why<{f}>> {{\n{rigid}\
             ::core::result::Result::Ok({around})\n}}\n\
             /// The arm of the formulas.\n#[inline]\nfn inside(&self, around: &::dh_robot::runtime::Around<{f}>) -> {inside} {{\n{inside} {{ {fields} }}\n}}\n"
        );
        out.push_str(&format!(
            "/// Pose of the tool in the base, with the poses that are fields as they are; angles in radians, lengths in {unit}.\n#[inline]\n#[must_use]\n\
             pub fn forward(&self, q: &[{f}; {n}]) -> {iso} {{\nlet around = self.around();\n{outer}.forward(&self.inside(&around).forward(q))\n}}\n\
             /// Pose of every moving link's frame in the base, without the tool.\n#[must_use]\n\
             pub fn frames(&self, q: &[{f}; {n}]) -> [{iso}; {n}] {{\nlet around = self.around();\n\
             self.inside(&around).frames(q).map(|frame| around.frame(&frame))\n}}\n\
             /// Geometric Jacobian: rows 0..3 linear ({unit} per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the\n\
             /// origin of the tool.\n#[inline]\n#[must_use]\npub fn jacobian(&self, q: &[{f}; {n}]) -> {matrix} {{\n\
             self.forward_and_jacobian(q).1\n}}\n\
             /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.\n#[inline]\n#[must_use]\n\
             pub fn forward_and_jacobian(&self, q: &[{f}; {n}]) -> ({iso}, {matrix}) {{\nlet around = self.around();\n\
             {outer}.velocity(self.inside(&around).forward_and_jacobian(q))\n}}\n"
        ));
        out.push_str(&super::batch::forward(self.chain, Batches::OneByOne));
        out.push_str(&super::velocity::functions(self.chain));
        out
    }

    fn inverse(&self, inverse: &Inverse) -> String {
        let (n, f, m, inside) = (self.chain.dof(), self.f(), inverse.plan.max_solutions, self.inside);
        let Target { parameter, kind, .. } = Target::of(self.chain, &|_| String::new());
        let (given, pass) = match self.chain.settings.redundant.len() {
            0 => (String::new(), ""),
            1 => (format!(", given: {f}"), ", given"),
            k => (format!(", given: [{f}; {k}]"), ", given"),
        };
        let (convert, by) = match self.chain.settings.task {
            Task::Pose => ("around.pose(target)".to_string(), "&"),
            Task::Position => ("around.position(target)".to_string(), "&"),
            Task::Axis => ("around.axis(target)".to_string(), ""),
            Task::Planar => (format!("around.planar(target, &inside.forward(&[0.0; {n}]))"), ""),
        };
        let list = format!("::dh_robot::Solutions<{f}, {n}, {m}>");
        let call = |function: &str, more: &str, refuse: &str| {
            format!(
                "match self.target_of_arm(target) {{\n\
                 ::core::result::Result::Ok((inside, target)) => inside.{function}({by}target{pass}{more}),\n\
                 ::core::result::Result::Err(why) => {refuse},\n}}"
            )
        };
        let none = "::dh_robot::Solutions::none(&Self::JOINTS, why)";
        let mut out = format!(
            "/// Greatest number of solutions of [`inverse`](Self::inverse).\npub const MAX_SOLUTIONS: usize = {m};\n\
             /// What one call of [`inverse`](Self::inverse) or [`inverse_near`](Self::inverse_near) computes at most, at any pose.\n\
             pub const MAX_WORK: ::dh_robot::Work = {inside}::MAX_WORK;\n\
             /// The arm of the formulas, and what a target is to it.\n#[inline]\n\
             fn target_of_arm(&self, {parameter}) -> ::core::result::Result<({inside}, {kind}), ::dh_robot::Why<{f}>> {{\n\
             let around = self.rigid_around()?;\nlet inside = self.inside(&around);\nlet target = {convert}?;\n\
             ::core::result::Result::Ok((inside, target))\n}}\n"
        );
        out.push_str(&format!(
            "{}#[must_use]\npub fn inverse(&self, {parameter}{given}) -> {list} {{\n{}\n}}\n\n",
            super::inverse::docs(self.chain, inverse),
            call("inverse", "", none)
        ));
        out.push_str(&format!(
            "{}pub fn inverse_near(&self, {parameter}{given}, q: &[{f}; {n}]) -> \
             ::core::result::Result<::dh_robot::Solution<{f}, {n}>, ::dh_robot::Why<{f}>> {{\n{}\n}}\n\n",
            super::inverse::NEAR_DOCS,
            call("inverse_near", ", q", "::core::result::Result::Err(why)")
        ));
        out.push_str(&format!(
            "{}#[must_use]\npub fn inverse_exhaustive(&self, {parameter}{given}) -> {list} {{\n{}\n}}\n\n",
            super::inverse::EXHAUSTIVE_DOCS,
            call("inverse_exhaustive", "", none)
        ));
        out.push_str(&format!(
            "/// [`inverse`](Self::inverse) without its fast path, and how much was computed.\n#[must_use]\n\
             pub fn inverse_with_work(&self, {parameter}{given}) -> ({list}, ::dh_robot::Work) {{\n{}\n}}\n\n",
            call("inverse_with_work", "", &format!("({none}, ::dh_robot::Work::NONE)"))
        ));
        out.push_str(&super::batch::inverse(self.chain, m));
        out.push_str(&format!(
            "{}#[must_use]\n\
             pub fn self_motion(&self, solution: &::dh_robot::Solution<{f}, {n}>) -> ::core::option::Option<[{f}; {n}]> {{\n\
             self.inside(&self.around()).self_motion(solution)\n}}\n",
            super::inverse::SELF_MOTION_DOCS
        ));
        out
    }
}
