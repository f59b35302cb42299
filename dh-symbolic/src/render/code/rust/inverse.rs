//! `inverse` and its traits: the target made a frame, then the fast way where the plan allows it, and the robust one.

use super::candidates::candidates;
use super::lanes;
use super::target::Target;
use super::verify::kinematics;
use crate::chain::{Chain, Scalar, Task};
use crate::program::{Forward, Inverse};
use crate::render::code::{literal, scalar_name};

/// All functions and traits of the inverse.
pub fn inverse(chain: &Chain, name: &str, forward: &Forward, inverse: &Inverse) -> String {
    let (n, f) = (chain.dof(), scalar_name(chain.scalar));
    let m = inverse.plan.max_solutions;
    let reach = literal(inverse.plan.axes.reach, Scalar::F64);
    let Target { parameter: target, frame, task, kind } = Target::of(chain, &reach);
    let given = if chain.redundant.is_some() { format!(", given: {f}") } else { String::new() };
    let pass = if chain.redundant.is_some() { ", given.into()" } else { "" };
    let fits = lanes::fits(chain, inverse);
    let fixed = chain.redundant.map_or("::core::option::Option::None".into(), |k| {
        format!("::core::option::Option::Some(({k}, given.into()))")
    });
    let few = inverse.plan.few;
    let robust = format!(
        "{frame}\nlet setting = ::dh_robot::runtime::Setting {{ joints: &Self::JOINTS, reach: {reach}, few: {few}, given: {fixed} }};\n\
         let task = {task};\n\
         ::dh_robot::runtime::solve(self, setting, &task, &frame, |frame, pick, found| self.candidates(frame{pass}, pick, found))\n"
    );
    let rest = if fits { format!("{frame}\n{}", lanes::call(chain, inverse)) } else { robust.clone() };
    let mut out = format!(
        "#[allow(unused, clippy::all, clippy::pedantic)]\nimpl {name} {{\n\
         /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.\n\
         pub const MAX_SOLUTIONS: usize = {m};\n\
         {}\n\
         #[must_use]\npub fn inverse(&self, {target}{given}) -> ::dh_robot::Solutions<{f}, {n}, {m}> {{\n\
         {rest}}}\n\n",
        docs(chain, inverse),
    );
    out.push_str(&candidates(chain, inverse));
    if fits {
        out.push_str(&format!(
            "/// The plan root by root, with everything that special poses need.\n#[cold]\n#[inline(never)]\n\
             fn robust(&self, {target}{given}) -> ::dh_robot::Solutions<{f}, {n}, {m}> {{\n{robust}}}\n"
        ));
        out.push_str(&lanes::lanes(chain, inverse));
    }
    out.push_str("}\n");
    out.push_str(&kinematics(chain, name, forward, few));
    out.push_str(&as_trait(chain, name, m, &kind));
    out
}

/// The trait: with a redundant joint its target is a pair, of the target and that joint's value.
fn as_trait(chain: &Chain, name: &str, m: usize, kind: &str) -> String {
    let (n, f) = (chain.dof(), scalar_name(chain.scalar));
    let (kind, target, given) = match chain.redundant {
        None => (kind.to_string(), "target", ""),
        Some(_) => (format!("({kind}, {f})"), "target.0", ", target.1"),
    };
    let target = match (chain.task, chain.redundant) {
        (Task::Pose | Task::Position, None) | (Task::Planar, Some(_)) => target.to_string(),
        (Task::Pose | Task::Position, Some(_)) => format!("&{target}"),
        (Task::Planar, None) => format!("*{target}"),
        (Task::Axis, _) => format!("(&{target}.0, &{target}.1)"),
    };
    format!(
        "impl ::dh_robot::InverseKinematics<{n}, {m}, {f}> for {name} {{\ntype Target = {kind};\n\
         fn inverse(&self, target: &Self::Target) -> ::dh_robot::Solutions<{f}, {n}, {m}> {{ {name}::inverse(self, {target}{given}) }}\n}}\n"
    )
}

/// The plan in the doc comment.
fn docs(chain: &Chain, inverse: &Inverse) -> String {
    let mut out = String::from(
        "/// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.\n///\n",
    );
    if chain.task == Task::Pose {
        out.push_str(
            "/// A rotation that lost digits (in a file with six decimals, say) is accepted up to\n\
             /// [`Real::ROTATION_TOLERANCE`](::dh_robot::Real::ROTATION_TOLERANCE) and the nearest exact one taken.\n///\n",
        );
    }
    out.push_str("/// Plan:\n");
    for (i, s) in inverse.plan.steps.iter().enumerate() {
        let names: Vec<String> =
            s.unknown.iter().map(|f| inverse.plan.knowledge.form_name(&inverse.plan.axes, f)).collect();
        let words = s.words();
        out.push_str(&format!(
            "/// {}. `{}`: {} ({}).\n",
            i + 1,
            names.join("`, `"),
            words.name.english,
            words.equation
        ));
    }
    out
}
