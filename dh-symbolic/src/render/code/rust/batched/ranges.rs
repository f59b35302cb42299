//! Generates the expressions that bring angles into the ranges of their joints.

use crate::chain::{Chain, Scalar};
use crate::render::code::{bound, literal};

/// The angle brought into the joint's range by a turn, where one can: what can be decided now is.
pub(super) fn into_range(chain: &Chain, k: usize, angle: String) -> String {
    use core::f64::consts::PI;
    let Some((least, greatest)) = &chain.joints[k].range else { return angle };
    let (least, greatest) = (bound(least), bound(greatest));
    if (least <= -PI && greatest >= PI) || (least > -PI + 1e-3 && greatest < PI - 1e-3) {
        // Every angle is in range, or no turn brings one in.
        angle
    } else if least <= PI && greatest >= -PI {
        let (least, greatest) = (literal(least, Scalar::F64), literal(greatest, Scalar::F64));
        format!("::dh_robot::runtime::batched::into_range({angle}, {least}, {greatest})")
    } else {
        let (least, greatest) = (literal(least, Scalar::F64), literal(greatest, Scalar::F64));
        format!("::dh_robot::Joint::revolute(\"\").with_range({least}, {greatest}).normalize({angle})")
    }
}
