//! The geometric Jacobian in the joint coordinates, by differentiating the pose: the reference for generated code.

use super::Kinematics;
use crate::algebra::{Poly, Vector, cross};
use crate::chain::{Chain, Coordinate};

/// Columns (linear, angular) per joint coordinate x_i, base axes, at the origin of the last frame (or tool).
///
/// Linear part: dp/dx_i. Angular part: from dR/dx_i R^T = [w]x, that is w = 1/2 sum_k r_k x dr_k/dx_i over the columns r_k.
/// (Siciliano et al. 2009, section 3.1.)
pub fn jacobian(chain: &Chain, kinematics: &Kinematics) -> Vec<(Vector, Vector)> {
    let pose = kinematics.pose();
    chain
        .joints
        .iter()
        .map(|joint| match joint.coordinate {
            Coordinate::Length(s) => {
                (pose.p.each_ref().map(|p| p.derivative_by_symbol(s)), std::array::from_fn(|_| Poly::zero()))
            }
            Coordinate::Angle(v) => {
                let linear = pose.p.each_ref().map(|p| p.derivative_by_angle(v));
                let columns: [Vector; 3] = std::array::from_fn(|k| pose.column(k));
                let turned: [Vector; 3] =
                    std::array::from_fn(|k| columns[k].each_ref().map(|p| p.derivative_by_angle(v)));
                let crosses: [Vector; 3] = std::array::from_fn(|k| cross(&columns[k], &turned[k]));
                let angular = std::array::from_fn(|i| crosses.iter().map(|c| c[i].clone()).sum::<Poly>().half());
                (linear, angular)
            }
        })
        .collect()
}
