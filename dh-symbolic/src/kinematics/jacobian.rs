//! The geometric Jacobian in the joint coordinates: the reference for generated code.

use super::Kinematics;
use crate::algebra::{Poly, Transform, Vector};
use crate::chain::{Chain, Coordinate};

/// Columns (linear, angular) per joint coordinate x_i, base axes, at the origin of the last frame (or tool).
///
/// Linear part: dp/dx_i. Angular part: the axis of a turning joint in the base, zero for a sliding one (Siciliano et al. 2009,
/// section 3.1; that it equals the rotation's derivative is one of the tests).
pub fn jacobian(chain: &Chain, kinematics: &Kinematics) -> Vec<(Vector, Vector)> {
    let p = kinematics.pose().p;
    let axes = axes(chain, kinematics);
    chain
        .joints
        .iter()
        .zip(axes)
        .map(|(joint, axis)| match joint.coordinate {
            Coordinate::Length(s) => {
                (p.each_ref().map(|p| p.derivative_by_symbol(s)), std::array::from_fn(|_| Poly::zero()))
            }
            Coordinate::Angle(v) => (p.each_ref().map(|p| p.derivative_by_angle(v)), axis),
        })
        .collect()
}

/// The axis of every joint in the base.
fn axes(chain: &Chain, kinematics: &Kinematics) -> Vec<Vector> {
    let mut axes = Vec::new();
    let mut before = kinematics.base().clone();
    for (row, link) in chain.links.iter().enumerate() {
        if link.joint.is_some() {
            // Modified: the axis is z of the frame itself. Standard: z of the frame before.
            let mut axis = before.clone();
            for e in chain.link_factors(row) {
                if matches!(e, crate::chain::Elementary::Rotate(2, _) | crate::chain::Elementary::Translate(2, _)) {
                    break;
                }
                axis = axis.times(&e.transform());
            }
            axes.push(axis.column(2));
        }
        before = before.times(kinematics.link(row + 1).unwrap_or(&Transform::identity()));
    }
    axes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::cross;
    use crate::chain::Convention;
    use crate::chain::tests::revolute_chain;

    /// dR/dx R^T = [w]x, that is w = 1/2 sum_k r_k x dr_k/dx over the columns r_k.
    #[test]
    fn angular_columns_are_the_derivative_of_the_rotation() {
        for convention in [Convention::Standard, Convention::Modified] {
            let rows = [(-90, "0.1", "0.2", 0), (60, "0.3", "0", 30), (90, "0", "0.1", -90), (180, "0.2", "0", 0)];
            let chain = revolute_chain(convention, &rows);
            let kinematics = Kinematics::new(&chain);
            let pose = kinematics.pose();
            for (joint, (_, angular)) in chain.joints.iter().zip(jacobian(&chain, &kinematics)) {
                let Coordinate::Angle(v) = joint.coordinate else { continue };
                let crosses: Vec<Vector> = (0..3)
                    .map(|k| cross(&pose.column(k), &pose.column(k).each_ref().map(|p| p.derivative_by_angle(v))))
                    .collect();
                let half: Vector = std::array::from_fn(|i| crosses.iter().map(|c| c[i].clone()).sum::<Poly>().half());
                assert_eq!(half, angular);
            }
        }
    }
}
