//! Generates `forward`, `frames` and `jacobian`.

use super::structure::Batches;
use crate::chain::Chain;
use crate::program::{Cost, Forward, Program};
use crate::render::code::body::Body;
use crate::render::code::scalar_name;

fn pose(body: &Body<'_>, from: usize) -> String {
    let o = |k: usize| body.output(from + k);
    format!(
        "::dh_robot::pose::from_entries([[{}, {}, {}], [{}, {}, {}], [{}, {}, {}]], [{}, {}, {}])",
        o(0),
        o(3),
        o(6),
        o(1),
        o(4),
        o(7),
        o(2),
        o(5),
        o(8),
        o(9),
        o(10),
        o(11)
    )
}

/// The Jacobian without the pose.
pub(super) fn jacobian(forward: &Forward) -> Program {
    Program { graph: forward.jacobian.graph.clone(), outputs: forward.jacobian.outputs[12..].to_vec() }
}

/// The columns of a Jacobian whose entries start at this output.
pub(super) fn columns(body: &Body<'_>, from: usize, n: usize) -> String {
    let entry = |j: usize, r: usize| body.output(from + 6 * j + r);
    let column = |j: usize| format!("[{}]", (0..6).map(|r| entry(j, r)).collect::<Vec<_>>().join(", "));
    (0..n).map(column).collect::<Vec<_>>().join(",\n")
}

fn cost(p: &Program) -> Cost {
    Cost::of(&p.graph, &p.outputs)
}

/// The inherent functions.
pub(super) fn functions(chain: &Chain, forward: &Forward, batches: Batches) -> String {
    let (n, f) = (chain.dof(), scalar_name(chain.settings.scalar));
    let unit = chain.settings.unit.name;
    let mut out = String::new();
    let (number, next) = crate::render::formula::products::equation_numbers(chain);
    let body = Body::new(chain, &forward.pose, chain.settings.scalar);
    out.push_str(&format!(
        "/// Pose of the last frame (with the tool) in the base; angles in radians, lengths in {unit}.\n///\n/// \
         Cost: {}. Proven equal to the product of the link transforms; equation ({number}) of the robot's notes.\n#[inline]\n#[must_use]\n\
         pub fn forward(&self, q: &[{f}; {n}]) -> ::dh_robot::nalgebra::IsometryMatrix3<{f}> {{\n{}\n{}\n}}\n",
        cost(&forward.pose),
        body.lines.join("\n"),
        pose(&body, 0)
    ));
    let rows: Vec<usize> = chain.joints.iter().map(|j| j.row).collect();
    let outputs = rows.iter().flat_map(|r| forward.frames.outputs.iter().skip(12 * r).take(12).copied()).collect();
    let frames = Program { graph: forward.frames.graph.clone(), outputs };
    let body = Body::new(chain, &frames, chain.settings.scalar);
    let poses: Vec<String> = (0..n).map(|i| pose(&body, 12 * i)).collect();
    out.push_str(&format!(
        "/// Pose of every moving link's frame in the base, without the tool.\n///\n/// Cost: {}.\n#[must_use]\n\
         pub fn frames(&self, q: &[{f}; {n}]) -> [::dh_robot::nalgebra::IsometryMatrix3<{f}>; {n}] {{\n{}\n[{}]\n}}\n",
        cost(&frames),
        body.lines.join("\n"),
        poses.join(",\n")
    ));
    let jacobian = jacobian(forward);
    let body = Body::new(chain, &jacobian, chain.settings.scalar);
    out.push_str(&format!(
        "/// Geometric Jacobian: rows 0..3 linear ({unit} per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the\n\
         /// origin of the last frame (or tool); equation ({next}) of the robot's notes.\n///\n/// Cost: {}.\n#[inline]\n#[must_use]\n\
         pub fn jacobian(&self, q: &[{f}; {n}]) -> ::dh_robot::nalgebra::SMatrix<{f}, 6, {n}> {{\n{}\n\
         ::dh_robot::nalgebra::SMatrix::from_data(::dh_robot::nalgebra::ArrayStorage([{}]))\n}}\n",
        cost(&jacobian),
        body.lines.join("\n"),
        columns(&body, 0, n)
    ));
    let body = Body::new(chain, &forward.jacobian, chain.settings.scalar);
    out.push_str(&format!(
        "/// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.\n///\n/// Cost: {}.\n\
         #[inline]\n#[must_use]\npub fn forward_and_jacobian(&self, q: &[{f}; {n}]) -> \
         (::dh_robot::nalgebra::IsometryMatrix3<{f}>, ::dh_robot::nalgebra::SMatrix<{f}, 6, {n}>) {{\n{}\n\
         ({}, ::dh_robot::nalgebra::SMatrix::from_data(::dh_robot::nalgebra::ArrayStorage([{}])))\n}}\n",
        cost(&forward.jacobian),
        body.lines.join("\n"),
        pose(&body, 0),
        columns(&body, 12, n)
    ));
    out.push_str(&super::batch::forward(chain, batches));
    out.push_str(&super::velocity::functions(chain));
    out
}

/// The trait implementations that go with them.
pub(super) fn traits(chain: &Chain, forward: &Forward, name: &str, batches: Batches) -> String {
    let (n, f) = (chain.dof(), scalar_name(chain.settings.scalar));
    let iso = format!("::dh_robot::nalgebra::IsometryMatrix3<{f}>");
    format!(
        "impl ::dh_robot::Robot<{n}, {f}> for {name} {{\n\
         fn joints(&self) -> &'static [::dh_robot::Joint<{f}>; {n}] {{ &Self::JOINTS }}\n}}\n\
         impl ::dh_robot::ForwardKinematics<{n}, {f}> for {name} {{\n\
         #[inline]\nfn forward(&self, q: &[{f}; {n}]) -> {iso} {{ {name}::forward(self, q) }}\n\
         #[inline]\nfn frames(&self, q: &[{f}; {n}]) -> [{iso}; {n}] {{ {name}::frames(self, q) }}\n}}\n\
         impl ::dh_robot::Jacobian<{n}, {f}> for {name} {{\n\
         #[inline]\nfn jacobian(&self, q: &[{f}; {n}]) -> ::dh_robot::nalgebra::SMatrix<{f}, 6, {n}> {{ {name}::jacobian(self, q) }}\n\
         #[inline]\nfn forward_and_jacobian(&self, q: &[{f}; {n}]) -> ({iso}, ::dh_robot::nalgebra::SMatrix<{f}, 6, {n}>) \
         {{ {name}::forward_and_jacobian(self, q) }}\n}}\n{}",
        super::batch::packed(chain, name, forward, batches)
    )
}
