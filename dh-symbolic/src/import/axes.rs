//! The axes of an arm in space, at zero, in the base's frame.

use super::Rounding;
use super::problem::Problem;
use super::rounding::{Limits, shown};
use super::route::Route;
use super::space::{Pose, Rotation, Vector, dot, norm, scale, unit};
use super::urdf::{Joint, Kind, Model};

/// An arm as lines in space.
#[derive(Clone, Debug)]
pub(super) struct PlacedAxes {
    /// The moving joints in order.
    pub(super) axes: Vec<Axis>,
    /// The tip at zero.
    pub(super) end: Pose,
    /// With every digit of the file: for each axis the pose of its frame in the one before, at zero, and its direction there.
    pub(super) written: Vec<(Pose, Vector)>,
    /// The tip in the frame of the last axis, with every digit.
    pub(super) written_end: Pose,
    /// The limits of rounding.
    pub(super) limits: Limits,
    /// What was rounded: joint, quantity, as written, as taken, difference in radians.
    pub(super) rounded: Vec<Rounded>,
    /// What was decided.
    pub(super) notes: Vec<String>,
}

/// The axis of a moving joint.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    /// Name of the joint.
    pub(super) name: String,
    /// Turns, or slides.
    pub(super) turns: bool,
    /// A point on it. Of a sliding joint any point does.
    pub(super) p: Vector,
    /// Its direction.
    pub(super) z: Vector,
    /// Bounds as written.
    pub(super) limits: Option<(String, String)>,
    /// Which motors (from 0) move it, and by what factor.
    pub(super) motors: Vec<(usize, f64)>,
    /// Its value where all motors are at zero.
    pub(super) at_zero: f64,
}

/// An angle of the file that was rounded.
#[derive(Clone, Debug)]
pub(super) struct Rounded {
    pub(super) joint: String,
    pub(super) what: &'static str,
    pub(super) written: f64,
    pub(super) taken: String,
    pub(super) off: f64,
}

/// Most moving joints that a table has.
const MOST_JOINTS: usize = 12;

/// Places the axes.
pub(super) fn place(model: &Model, route: &Route, rounding: Rounding) -> Result<PlacedAxes, Problem> {
    let joints: Vec<&Joint> = route.joints.iter().map(|&j| &model.joints[j]).collect();
    let reach: f64 = joints.iter().map(|j| norm(j.xyz)).sum();
    let limits = Limits::new(rounding, reach.max(1e-3));
    let (mut here, mut written) = (Pose::IDENTITY, Pose::IDENTITY);
    let mut arm = PlacedAxes {
        axes: Vec::new(),
        end: Pose::IDENTITY,
        written: Vec::new(),
        written_end: Pose::IDENTITY,
        limits,
        rounded: Vec::new(),
        notes: Vec::new(),
    };
    for joint in &joints {
        let mut rpy = joint.rpy;
        for (x, what) in rpy.iter_mut().zip(["roll", "pitch", "yaw"]) {
            let taken = limits.angle(*x);
            let off = (taken.radians() - *x).abs();
            if taken.is_exact() {
                if off > 1e-12 {
                    let (joint, taken) = (joint.name.clone(), taken.text());
                    arm.rounded.push(Rounded { joint, what, written: *x, taken, off });
                }
                *x = taken.radians();
            }
        }
        here = here.times(&Pose { r: Rotation::rpy(rpy), p: joint.xyz });
        written = written.times(&Pose { r: plain_rpy(joint.rpy), p: joint.xyz });
        if joint.kind == Kind::Fixed {
            continue;
        }
        if arm.axes.len() == MOST_JOINTS {
            return Err(Problem::at(joint.at, format!("a table has at most {MOST_JOINTS} moving joints")));
        }
        let direction = unit(joint.axis);
        let exact = coordinate_axis(direction, limits.angle);
        arm.written.push((written, direction));
        written = Pose::IDENTITY;
        let turns = joint.kind != Kind::Prismatic;
        let bounds = if joint.kind == Kind::Continuous { None } else { joint.limits.clone() };
        arm.axes.push(Axis {
            name: joint.name.clone(),
            turns,
            p: here.p,
            z: here.r.apply(exact),
            limits: bounds,
            motors: Vec::new(),
            at_zero: 0.0,
        });
    }
    (arm.end, arm.written_end) = (here, written);
    motors(&joints, &mut arm)?;
    Ok(arm)
}

impl PlacedAxes {
    /// The tip's pose with every digit of the file, for values of the motors.
    pub(super) fn written_pose(&self, q: &[f64]) -> Pose {
        let mut pose = Pose::IDENTITY;
        for (axis, (before, direction)) in self.axes.iter().zip(&self.written) {
            let x = axis.value(q);
            let motion = if axis.turns {
                Pose { r: Rotation::about_vector(*direction, x), p: [0.0; 3] }
            } else {
                Pose { r: Rotation::IDENTITY, p: scale(*direction, x) }
            };
            pose = pose.times(before).times(&motion);
        }
        pose.times(&self.written_end)
    }

    /// Directions of all axes at zero, with every digit of the file.
    pub(super) fn written_directions(&self) -> Vec<Vector> {
        let mut r = Rotation::IDENTITY;
        let step = |(before, direction): &(Pose, Vector)| {
            r = r.times(&before.r);
            r.apply(*direction)
        };
        self.written.iter().map(step).collect()
    }

    /// Number of motors.
    pub(super) fn motors(&self) -> usize {
        self.axes.iter().flat_map(|a| &a.motors).map(|m| m.0 + 1).max().unwrap_or(0)
    }
}

impl Axis {
    /// What the joint turns or slides by.
    pub(super) fn value(&self, q: &[f64]) -> f64 {
        self.motors.iter().fold(self.at_zero, |x, (m, k)| x + k * q.get(*m).copied().unwrap_or(0.0))
    }
}

/// Roll, pitch, yaw with every digit.
fn plain_rpy(rpy: [f64; 3]) -> Rotation {
    let turn = |axis: usize, angle: f64| {
        let (s, c) = angle.sin_cos();
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut r = Rotation::IDENTITY;
        (r.0[j][j], r.0[j][k], r.0[k][k], r.0[k][j]) = (c, s, c, -s);
        r
    };
    turn(2, rpy[2]).times(&turn(1, rpy[1])).times(&turn(0, rpy[0]))
}

/// The coordinate axis that a direction is near.
fn coordinate_axis(v: Vector, angle: f64) -> Vector {
    let largest = (0..3).max_by(|&i, &j| v[i].abs().total_cmp(&v[j].abs())).unwrap_or(2);
    let mut axis = [0.0; 3];
    axis[largest] = v[largest].signum();
    let rest = norm(super::space::minus(v, scale(axis, dot(v, axis))));
    if rest <= angle { axis } else { v }
}

/// Who drives whom: each joint has its own motor, but those that follow another joint of the chain.
fn motors(joints: &[&Joint], arm: &mut PlacedAxes) -> Result<(), Problem> {
    let moving: Vec<&&Joint> = joints.iter().filter(|j| j.kind != Kind::Fixed).collect();
    let position = |name: &str| moving.iter().position(|j| j.name == name);
    // The joint that moves another in the end, the factor and the value at zero.
    let mut leaders: Vec<(usize, f64, f64)> = Vec::new();
    for (i, joint) in moving.iter().enumerate() {
        let (mut at, mut factor, mut zero) = (i, 1.0, 0.0);
        let mut steps = 0;
        while let Some(mimic) = &moving[at].mimic {
            let Some(next) = position(&mimic.joint) else {
                arm.notes.push(format!(
                    "{} follows {}, which is not on the chain: it is taken as a joint of its own",
                    moving[at].name, mimic.joint
                ));
                break;
            };
            zero += factor * mimic.offset;
            factor *= mimic.multiplier;
            at = next;
            steps += 1;
            if steps > moving.len() {
                return Err(Problem::at(mimic.at, format!("joint `{}` follows itself", joint.name)));
            }
        }
        leaders.push((at, factor, zero));
    }
    for (i, (axis, (leader, factor, zero))) in arm.axes.iter_mut().zip(&leaders).enumerate() {
        // A table has a variable for every moving row: that of a follower stays at 0.
        axis.motors = vec![(i, 1.0)];
        if *leader != i {
            if *factor != 0.0 {
                axis.motors.insert(0, (*leader, *factor));
            }
            axis.limits = Some(("0".into(), "0".into()));
        }
        axis.at_zero = *zero;
    }
    for (i, joint) in moving.iter().enumerate().filter(|(i, _)| leaders[*i].0 != *i) {
        let (leader, factor, zero) = leaders[i];
        let mut text =
            format!("{} follows {}: {} * {}", joint.name, moving[leader].name, shown(factor), moving[leader].name);
        if zero != 0.0 {
            text += &format!(" + {}", shown(zero));
        }
        text += &format!("; its own variable q{} stays at 0", i + 1);
        arm.notes.push(text);
    }
    Ok(())
}
