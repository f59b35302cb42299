//! Generates the functions derived from the Jacobian: other axes, its derivative, singular values, joint speeds.

use crate::chain::Chain;
use crate::planner::Axes;
use crate::render::code::drive::matrices;
use crate::render::code::{literal, scalar_name};

/// The inherent functions.
pub(super) fn functions(chain: &Chain) -> String {
    let (n, f) = (chain.dof(), scalar_name(chain.settings.scalar));
    let q = format!("q: &[{f}; {n}]");
    let matrix = format!("::dh_robot::nalgebra::SMatrix<{f}, 6, {n}>");
    let derivative = match matrices(chain) {
        None => "::dh_robot::velocity::jacobian_dot(&self.jacobian(q), speeds)".into(),
        Some(m) => format!(
            "let det = {};\n::dh_robot::velocity::jacobian_dot_coupled(&self.jacobian(q), speeds, &{}, &{})",
            m.det, m.rows, m.actuators
        ),
    };
    let size = literal(Axes::new(chain).length_scale, chain.settings.scalar);
    format!(
        "/// [`jacobian`](Self::jacobian) in the axes of the last frame (or tool) instead of the base; the point is the same.\n\
         #[inline]\n#[must_use]\npub fn jacobian_in_tool(&self, {q}) -> {matrix} {{\n\
         let (pose, jacobian) = self.forward_and_jacobian(q);\n::dh_robot::velocity::in_axes_of(&pose, &jacobian)\n}}\n\
         /// The time derivative of [`jacobian`](Self::jacobian) (base axes) while the joints move with `speeds`, exact.\n\
         #[inline]\n#[must_use]\npub fn jacobian_dot(&self, {q}, speeds: &[{f}; {n}]) -> {matrix} {{\n{derivative}\n}}\n\
         /// Product of the Jacobian's singular values (Yoshikawa 1985), in its units; zero at singular poses.\n\
         #[inline]\n#[must_use]\npub fn manipulability(&self, {q}) -> {f} {{\n\
         ::dh_robot::velocity::manipulability(&self.jacobian(q))\n}}\n\
         /// The smallest singular value of the Jacobian, in its units; zero at singular poses.\n\
         #[inline]\n#[must_use]\npub fn smallest_singular_value(&self, {q}) -> {f} {{\n\
         ::dh_robot::velocity::smallest_singular_value(&self.jacobian(q))\n}}\n\
         /// Joint speeds for a velocity of the last frame (or tool): linear, then angular, in base axes. Damped near singular poses, and\n\
         /// the result says so; see [`solve_velocity`](::dh_robot::velocity::solve_velocity).\n\
         #[inline]\n#[must_use]\npub fn solve_velocity(&self, {q}, twist: &::dh_robot::nalgebra::Vector6<{f}>) -> \
         ::dh_robot::velocity::JointSpeeds<{f}, {n}> {{\n\
         ::dh_robot::velocity::solve_velocity(&self.jacobian(q), twist, {size})\n}}\n"
    )
}
