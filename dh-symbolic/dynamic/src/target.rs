//! What an inverse is asked for: a pose, or the part of it that the arm's task looks at.

use dh_kernels::{Pose, TaskTarget};
use dh_robot::Why;
use dh_robot::nalgebra::IsometryMatrix3;
use dh_robot::runtime::{direction, frame_of, frame_of_axis, frame_of_plane, in_units};

/// What an inverse is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// `task = pose`: the pose of the last frame, or of the tool.
    Pose(IsometryMatrix3<f64>),
    /// `task = position`: its position.
    Position([f64; 3]),
    /// `task = planar`: x, y and the angle about z.
    Planar(f64, f64, f64),
    /// `task = axis`: the position, and the direction of the z axis as a unit vector.
    Axis([f64; 3], [f64; 3]),
}

impl Target {
    /// The target as a frame with lengths over the length scale, and what of it counts.
    pub(crate) fn frame(
        &self,
        length_scale: f64,
        plane: impl Fn() -> [[f64; 3]; 3],
    ) -> Result<(Pose, TaskTarget), Why> {
        let finite = |list: &[f64]| if list.iter().all(|x| x.is_finite()) { Ok(()) } else { Err(Why::NotFinite) };
        match self {
            Target::Pose(pose) => {
                let frame = frame_of(pose, length_scale)?;
                Ok((frame, TaskTarget::Pose(in_units(&frame, length_scale))))
            }
            Target::Position(p) => {
                finite(p)?;
                Ok((frame_of_axis(p.map(|x| x / length_scale), [0.0, 0.0, 1.0]), TaskTarget::Position(*p)))
            }
            Target::Planar(x, y, phi) => {
                finite(&[*x, *y, *phi])?;
                let frame = frame_of_plane([x / length_scale, y / length_scale], *phi, plane());
                Ok((frame, TaskTarget::Planar(*x, *y, *phi)))
            }
            Target::Axis(p, z) => {
                finite(p)?;
                let z = direction(*z)?;
                Ok((frame_of_axis(p.map(|x| x / length_scale), z), TaskTarget::Axis(*p, z)))
            }
        }
    }
}
