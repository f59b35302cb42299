//! The target of `inverse`: its type, and the statements that make a frame and a task of it.

use crate::algebra::{AngleVar, Poly};
use crate::chain::{Chain, Coordinate, Handle, Role, Scalar, Task};
use crate::render::code::steps::LENGTH_SCALE;
use crate::render::code::{literal, scalar_name};

/// The argument of `inverse`, and the statements that convert it.
pub(super) struct Target {
    /// The parameter, with its type.
    pub(super) parameter: String,
    /// The statements that make `frame`, or return with the reason why there is none.
    pub(super) frame: String,
    /// Expression of the task that solutions are measured by.
    pub(super) task: String,
    /// The target's type in the trait.
    pub(super) kind: String,
}

impl Target {
    /// The target of a chain's task; `refuse` is the statement that gives back a reason.
    pub(super) fn of(chain: &Chain, refuse: &dyn Fn(&str) -> String) -> Target {
        let f = scalar_name(chain.settings.scalar);
        let (length_scale, not_finite, refuse) = (LENGTH_SCALE, refuse("::dh_robot::Why::NotFinite"), refuse("why"));
        let finite = |list: &str| format!("if !{list}.iter().all(|x: &f64| x.is_finite()) {{ {not_finite}; }}");
        match chain.settings.task {
            Task::Pose => Target {
                parameter: format!("target: &::dh_robot::nalgebra::IsometryMatrix3<{f}>"),
                frame: format!(
                    "let frame = match ::dh_robot::runtime::frame_of(target, {length_scale}) {{ ::core::result::Result::Ok(frame) => frame, ::core::result::Result::Err(why) => {refuse} }};"
                ),
                task: format!(
                    "::dh_robot::runtime::TaskTarget::Pose(::dh_robot::runtime::in_units(&frame, {length_scale}))"
                ),
                kind: format!("::dh_robot::nalgebra::IsometryMatrix3<{f}>"),
            },
            Task::Position => Target {
                parameter: format!("target: &::dh_robot::nalgebra::Point3<{f}>"),
                frame: format!(
                    "let p: [f64; 3] = [target.x.into(), target.y.into(), target.z.into()];\n{}\n\
                     let frame = ::dh_robot::runtime::frame_of_axis(p.map(|x| x / {length_scale}), [0.0, 0.0, 1.0]);",
                    finite("p")
                ),
                task: "::dh_robot::runtime::TaskTarget::Position(p)".into(),
                kind: format!("::dh_robot::nalgebra::Point3<{f}>"),
            },
            Task::Planar => Target {
                parameter: format!("target: ({f}, {f}, {f})"),
                frame: format!(
                    "let (x, y, phi): (f64, f64, f64) = (target.0.into(), target.1.into(), target.2.into());\n{}\n\
                     let frame = ::dh_robot::runtime::frame_of_plane([x / {length_scale}, y / {length_scale}], phi, {});",
                    finite("[x, y, phi]"),
                    plane(chain)
                ),
                task: "::dh_robot::runtime::TaskTarget::Planar(x, y, phi)".into(),
                kind: format!("({f}, {f}, {f})"),
            },
            Task::Axis => Target {
                parameter: format!(
                    "target: (::dh_robot::nalgebra::Point3<{f}>, ::dh_robot::nalgebra::UnitVector3<{f}>)"
                ),
                frame: format!(
                    "let p: [f64; 3] = [target.0.x.into(), target.0.y.into(), target.0.z.into()];\n\
                     {}\n\
                     let z = match ::dh_robot::runtime::direction([target.1.x.into(), target.1.y.into(), target.1.z.into()]) {{ ::core::result::Result::Ok(z) => z, ::core::result::Result::Err(why) => {refuse} }};\n\
                     let frame = ::dh_robot::runtime::frame_of_axis(p.map(|x| x / {length_scale}), z);",
                    finite("p")
                ),
                task: "::dh_robot::runtime::TaskTarget::Axis(p, z)".into(),
                kind: format!("(::dh_robot::nalgebra::Point3<{f}>, ::dh_robot::nalgebra::UnitVector3<{f}>)"),
            },
        }
    }
}

/// Pose of the tool of a planar arm with all joints at zero: its rotation and height are the same at every configuration up to a
/// turn about z (and slides along it).
fn plane(chain: &Chain) -> String {
    let pose = crate::kinematics::Kinematics::new(chain).pose();
    let is_field = |v: &AngleVar| {
        chain.parameters.iter().any(|p| p.handle == Handle::Angle(*v) && matches!(p.role, Role::Field(_)))
    };
    if pose.r.iter().flatten().any(|entry| entry.angles().iter().any(is_field)) {
        let zeros = format!("&[0.0; {}]", chain.dof());
        return format!("::dh_robot::runtime::Kinematics::forward(self, {zeros}).map(|[x, y, z, _]| [x, y, z])");
    }
    let at_zero = |p: &Poly| {
        let value = p.evaluate(&crate::algebra::Point {
            symbol: &|s| {
                if chain.joints.iter().any(|j| j.coordinate == Coordinate::Length(s)) {
                    0.0
                } else {
                    chain.nominal(crate::chain::Handle::Length(s))
                }
            },
            angle: &|v| {
                if chain.joints.iter().any(|j| j.coordinate == Coordinate::Angle(v)) {
                    0.0
                } else {
                    chain.nominal(crate::chain::Handle::Angle(v))
                }
            },
        });
        literal(value, Scalar::F64)
    };
    let rows: Vec<String> = (0..3)
        .map(|i| format!("[{}]", (0..3).map(|j| at_zero(&pose.r[i][j])).collect::<Vec<_>>().join(", ")))
        .collect();
    format!("[{}]", rows.join(", "))
}
