//! `inverse` and its traits: the target made a frame, then the fast path where the plan allows it, and the fallback.

use super::batched::{FastPath, passed};
use super::candidates::candidates;
use super::target::Target;
use super::verify::kinematics;
use crate::chain::{Chain, Task};
use crate::planner::Step;
use crate::program::{Forward, Inverse};
use crate::render::code::drive::coordinates;
use crate::render::code::scalar_name;
use crate::render::code::steps::{LENGTH_SCALE, combination, length_scale};

pub(super) const NEAR_DOCS: &str = "\
    /// The solution that continues from the joint values `q`: the one of least travel, and on a self-motion (at a singular pose) the\n\
    /// point of it nearest to `q`. Angles are shifted by whole turns towards `q`, within the ranges where that is possible; a solution out\n\
    /// of range is given only if none is in range, or if it continues from `q` within 0.2 rad.\n///\n\
    /// # Errors\n/// The reason why no joint values reach the target.\n";
pub(super) const EXHAUSTIVE_DOCS: &str = "\
    /// The same as [`inverse`](Self::inverse) by a thorough search, at special poses without a bound on its time: from many starts, at\n\
    /// neighbouring poses and along self-motions. To compare with.\n";
pub(super) const SELF_MOTION_DOCS: &str = "\
    /// The direction in which the arm can move at a solution with free joints while its target stays reached: joint speeds, the largest of\n\
    /// them 1 (or the arm's size, for a length). `None` at an isolated solution.\n";

/// All functions and traits of the inverse.
pub fn inverse(chain: &Chain, name: &str, forward: &Forward, inverse: &Inverse) -> String {
    let (n, f) = (chain.dof(), scalar_name(chain.settings.scalar));
    let m = inverse.plan.max_solutions;
    let Target { parameter: target, task, kind, .. } = Target::of(chain, &refuse_list);
    let frame = frame(chain, &refuse_list);
    let (given, pass) = match chain.settings.redundant.len() {
        0 => (String::new(), ""),
        1 => (format!(", given: {f}"), ", given.into()"),
        k => (format!(", given: [{f}; {k}]"), ", given.map(|x| x.into())"),
    };
    let fast = FastPath::of(chain, inverse);
    let fixed = fixed(chain);
    let rank_deficient = inverse.plan.rank_deficient;
    let prepared = |frame: &str| {
        format!(
            "{frame}\nlet setting = ::dh_robot::runtime::Setting {{ joints: &Self::JOINTS, length_scale: {LENGTH_SCALE}, rank_deficient: {rank_deficient}, given: {fixed} }};\n\
             let task = {task};\n"
        )
    };
    let prepare = prepared(&frame);
    let frame_one = self::frame(chain, &refuse_one);
    let run = format!("|frame, sample, found| self.candidates(frame{pass}, sample, found)");
    let solve = format!("::dh_robot::runtime::solve_bounded(self, setting, &task, &frame, Self::MAX_WORK, {run})\n");
    let same = if !chain.settings.redundant.is_empty() { ", given" } else { "" };
    let fallback = format!("self.inverse_with_work(target{same}).0\n");
    let rest = fast.as_ref().map_or(fallback, |fast| format!("{frame}\n{}", fast.call(chain, inverse)));
    let work = match inverse.plan.steps.iter().any(Step::is_elimination) {
        true => "ELIMINATION",
        false if inverse.plan.has_crossings => "CROSSING_SHEETS",
        false => "CLOSED_FORM",
    };
    let mut out = format!(
        "#[allow(unused, clippy::all, clippy::pedantic)]\nimpl {name} {{\n\
         /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.\n\
         pub const MAX_SOLUTIONS: usize = {m};\n\
         /// What one call of [`inverse`](Self::inverse) or [`inverse_near`](Self::inverse_near) computes at most, at any pose.\n\
         pub const MAX_WORK: ::dh_robot::Work = ::dh_robot::Work::{work};\n\
         {}{}\n\
         #[must_use]\npub fn inverse(&self, {target}{given}) -> ::dh_robot::Solutions<{f}, {n}, {m}> {{\n\
         {rest}}}\n\n",
        length_scale(chain, inverse),
        docs(chain, inverse),
    );
    out.push_str(&format!(
        "{NEAR_DOCS}\
         pub fn inverse_near(&self, {target}{given}, q: &[{f}; {n}]) -> ::core::result::Result<::dh_robot::Solution<{f}, {n}>, ::dh_robot::Why<{f}>> {{\n\
         {}}}\n\n\
         {EXHAUSTIVE_DOCS}\
         #[must_use]\npub fn inverse_exhaustive(&self, {target}{given}) -> ::dh_robot::Solutions<{f}, {n}, {m}> {{\n\
         {prepare}::dh_robot::runtime::solve(self, setting, &task, &frame, {run})\n}}\n\n",
        near(chain, inverse, fast.as_ref(), &prepared(&frame_one), &run),
    ));
    out.push_str(&super::batch::inverse(chain, m));
    if chain.settings.task == Task::Pose {
        out.push_str(&format!(
            "/// [`inverse`](Self::inverse) of the nearest pose whose matrix is a rotation, and by how much the target's was off (the largest entry\n\
             /// of `R^T R - 1`): for targets whose entries are off by up to 1e-3, such as those with three to five decimals.\n#[must_use]\n\
             pub fn inverse_nearest_rotation(&self, {target}{given}) -> (::dh_robot::Solutions<{f}, {n}, {m}>, {f}) {{\n\
             match ::dh_robot::pose::nearest_rotation(target) {{\n\
             ::core::result::Result::Ok((target, deviation)) => (self.inverse(&target{same}), deviation),\n\
             ::core::result::Result::Err(why) => (::dh_robot::Solutions::none(&Self::JOINTS, why), ::dh_robot::pose::rotation_deviation(target.rotation.matrix())),\n\
             }}\n}}\n"
        ));
    }
    out.push_str(&tangent(chain, rank_deficient));
    out.push_str(&unknowns(chain, inverse));
    out.push_str(&candidates(chain, inverse));
    out.push_str(&format!(
        "/// [`inverse`](Self::inverse) without its fast path: the plan root by root, with everything that special poses need; and how much was\n\
         /// computed, which is never more than [`MAX_WORK`](Self::MAX_WORK).\n#[cold]\n#[inline(never)]\n#[must_use]\n\
         pub fn inverse_with_work(&self, {target}{given}) -> (::dh_robot::Solutions<{f}, {n}, {m}>, ::dh_robot::Work) {{\n{}{solve}}}\n",
        prepared(&self::frame(chain, &refuse_counted))
    ));
    if let Some(fast) = fast {
        out.push_str(&fast.items(chain, inverse));
    }
    out.push_str("}\n");
    out.push_str(&kinematics(chain, name, forward, rank_deficient));
    out.push_str(&as_trait(chain, name, m, &kind));
    out
}

/// The statements that make `frame`, or give back a reason; a joint value that is not finite is one.
fn frame(chain: &Chain, refuse: &dyn Fn(&str) -> String) -> String {
    let frame = Target::of(chain, refuse).frame;
    let finite = match chain.settings.redundant.len() {
        0 => return frame,
        1 => "given.is_finite()",
        _ => "given.iter().all(|x| x.is_finite())",
    };
    format!("if !{finite} {{ {}; }}\n{frame}", refuse("::dh_robot::Why::NotFinite"))
}

/// How a function that gives back a list refuses its target.
fn refuse_list(why: &str) -> String {
    format!("return ::dh_robot::Solutions::none(&Self::JOINTS, {why})")
}

/// How one that gives back a list and its work does.
fn refuse_counted(why: &str) -> String {
    format!("return (::dh_robot::Solutions::none(&Self::JOINTS, {why}), ::dh_robot::Work::NONE)")
}

/// How one that gives back a single solution does.
fn refuse_one(why: &str) -> String {
    format!("return ::core::result::Result::Err({why})")
}

/// The body of `inverse_near`: the nearest of the fast path's list, or the search that goes on from the joint values.
fn near(chain: &Chain, inverse: &Inverse, fast: Option<&FastPath>, prepare: &str, run: &str) -> String {
    let (n, m) = (chain.dof(), inverse.plan.max_solutions);
    let mut out = prepare.to_string();
    if let Some(fast) = fast.filter(|f| !f.is_free()) {
        let total = fast.branches();
        let number = passed(chain);
        out.push_str(&format!(
            "let mut found = [[0.0; {total}]; {n}];\nlet mut valid = [0.0; {total}];\n\
             if self.all_branches(&frame{number}, &mut found, &mut valid) {{\n\
             let list: ::dh_robot::Solutions<_, {n}, {m}> = ::dh_robot::runtime::batched::collect(&Self::JOINTS, &valid, &found, &Self::BRANCHES);\n\
             return ::dh_robot::runtime::nearest(&list, q, {LENGTH_SCALE});\n}}\n"
        ));
    }
    out.push_str(&format!(
        "let unknowns = self.unknowns(&q.map(f64::from));\n\
         ::dh_robot::runtime::solve_near::<_, {n}, {m}>(self, setting, &task, &frame, Self::MAX_WORK, q, unknowns, {run})\n"
    ));
    out
}

/// The function that gives the direction of a solution's self-motion.
fn tangent(chain: &Chain, rank_deficient: bool) -> String {
    let (n, f) = (chain.dof(), scalar_name(chain.settings.scalar));
    let one = |k: usize| match chain.settings.redundant.contains(&k) {
        false => "::core::option::Option::None".to_string(),
        true => format!("::core::option::Option::Some(solution.q[{k}].into())"),
    };
    let fixed = format!("[{}]", (0..n).map(one).collect::<Vec<_>>().join(", "));
    let position = "[t[0][3], t[1][3], t[2][3]]";
    let task = match chain.settings.task {
        Task::Pose => "Pose(*t)".to_string(),
        Task::Position => format!("Position({position})"),
        Task::Axis => format!("Axis({position}, [t[0][2], t[1][2], t[2][2]])"),
        Task::Planar => "Planar(t[0][3], t[1][3], ::dh_robot::runtime::atan2(t[1][0], t[0][0]))".into(),
    };
    format!(
        "{SELF_MOTION_DOCS}#[must_use]\n\
         pub fn self_motion(&self, solution: &::dh_robot::Solution<{f}, {n}>) -> ::core::option::Option<[{f}; {n}]> {{\n\
         let setting = ::dh_robot::runtime::Setting {{ joints: &Self::JOINTS, length_scale: {LENGTH_SCALE}, rank_deficient: {rank_deficient}, given: {fixed} }};\n\
         ::dh_robot::runtime::self_motion(self, setting, |t| ::dh_robot::runtime::TaskTarget::{task}, solution)\n}}\n\n"
    )
}

/// The function that gives the values of the plan's unknowns (radians, lengths over the length scale) at joint values.
fn unknowns(chain: &Chain, inverse: &Inverse) -> String {
    let plan = &inverse.plan;
    let x: Vec<String> = coordinates(chain);
    let value = |step: &Step| {
        let Some(form) = step.unknown.first() else { return "0.0".into() };
        if form.iter().skip(plan.axes.real).any(|k| *k != 0) {
            return "0.0".into();
        }
        let sum = combination(form, &x);
        let prismatic = form.iter().position(|k| *k != 0).is_some_and(|k| !plan.axes.is_revolute(k));
        if prismatic { format!("({sum}) / {LENGTH_SCALE}") } else { sum }
    };
    let mut values: Vec<String> = plan.steps.iter().map(value).collect();
    values.resize(8, "0.0".into());
    format!(
        "/// The plan's unknowns at joint values.\nfn unknowns(&self, q: &[f64; {}]) -> [f64; 8] {{\n[{}]\n}}\n",
        chain.dof(),
        values.join(", ")
    )
}

/// The value that the caller gives to each joint, if any.
fn fixed(chain: &Chain) -> String {
    if chain.settings.redundant.is_empty() {
        return format!("[::core::option::Option::None; {}]", chain.dof());
    }
    let one = |k: usize| match (chain.settings.redundant.iter().position(|r| *r == k), chain.settings.redundant.len()) {
        (None, _) => "::core::option::Option::None".to_string(),
        (Some(_), 1) => "::core::option::Option::Some(given.into())".to_string(),
        (Some(i), _) => format!("::core::option::Option::Some(given[{i}].into())"),
    };
    format!("[{}]", (0..chain.dof()).map(one).collect::<Vec<_>>().join(", "))
}

/// The trait: with redundant joints its target is a pair, of the target and the values of these joints.
pub(super) fn as_trait(chain: &Chain, name: &str, m: usize, kind: &str) -> String {
    let (n, f) = (chain.dof(), scalar_name(chain.settings.scalar));
    let (kind, target, given) = match chain.settings.redundant.len() {
        0 => (kind.to_string(), "target", ""),
        1 => (format!("({kind}, {f})"), "target.0", ", target.1"),
        k => (format!("({kind}, [{f}; {k}])"), "target.0", ", target.1"),
    };
    let target = match (chain.settings.task, chain.settings.redundant.is_empty()) {
        (Task::Pose | Task::Position, true) | (Task::Planar | Task::Axis, false) => target.to_string(),
        (Task::Pose | Task::Position, false) => format!("&{target}"),
        (Task::Planar | Task::Axis, true) => format!("*{target}"),
    };
    format!(
        "impl ::dh_robot::InverseKinematics<{n}, {f}> for {name} {{\ntype Target = {kind};\n\
         type Solutions = ::dh_robot::Solutions<{f}, {n}, {m}>;\n\
         fn inverse(&self, target: &Self::Target) -> Self::Solutions {{ {name}::inverse(self, {target}{given}) }}\n\
         fn inverse_near(&self, target: &Self::Target, q: &[{f}; {n}]) -> ::core::result::Result<::dh_robot::Solution<{f}, {n}>, ::dh_robot::Why<{f}>> {{ {name}::inverse_near(self, {target}{given}, q) }}\n}}\n\
         impl ::dh_robot::runtime::HasJoints<{f}> for {name} {{\ntype Joints = ::dh_robot::runtime::Joints<{n}>;\n}}\n"
    )
}

/// The plan in the doc comment.
pub(super) fn docs(chain: &Chain, inverse: &Inverse) -> String {
    let mut out = String::from(
        "/// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.\n///\n",
    );
    if chain.settings.task == Task::Pose {
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
