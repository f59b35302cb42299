//! IK-Geo in Rust as a peer: product of exponentials, made from the generated Jacobian at zero.

use std::hint::black_box;
use std::panic::{AssertUnwindSafe, catch_unwind};

use ::ik_geo::inverse_kinematics::auxiliary::Kinematics;
use ::ik_geo::nalgebra::{Matrix3, Vector3, Vector6};
use cpu_time::ProcessTime;
use dh_robot::nalgebra::{Matrix3 as Ours3, Vector3 as OurVector};
use dh_robot::{ForwardKinematics, Jacobian};

use crate::Pose;
use crate::peer::{Answer, Peer};

type Solver = fn(&Matrix3<f64>, &Vector3<f64>, &Kinematics<6, 7>) -> (Vec<Vector6<f64>>, Vec<bool>);

/// One arm with the solver of its class.
pub struct IkGeo {
    class: &'static str,
    solver: Solver,
    arm: Kinematics<6, 7>,
    /// Rotation of the last frame with all joints at zero: theirs is the identity there.
    zero: Ours3<f64>,
}

impl IkGeo {
    /// The axes from joint `meet` on (counted from 0) have a point in common, on which the solver relies.
    pub fn new(
        robot: &(impl ForwardKinematics<6> + Jacobian<6>),
        class: &'static str,
        solver: Solver,
        meet: usize,
    ) -> Self {
        let (pose, jacobian) = (robot.forward(&[0.0; 6]), robot.jacobian(&[0.0; 6]));
        let end = pose.translation.vector;
        // Direction and a point of each axis: the linear velocity is direction x (end - point).
        let h: [OurVector<f64>; 6] = std::array::from_fn(|i| jacobian.fixed_view::<3, 1>(3, i).into_owned());
        let mut at: [OurVector<f64>; 6] =
            std::array::from_fn(|i| end + h[i].cross(&jacobian.fixed_view::<3, 1>(0, i).into_owned()));
        if meet < 5 {
            // The point of axis 5 (index 4) nearest to axis 6: the common one.
            let (u, v, w) = (h[meet], h[meet + 1], at[meet + 1] - at[meet]);
            let n = u.cross(&v);
            let point = at[meet] + u * (w.cross(&v).dot(&n) / n.norm_squared());
            at[meet..].fill(point);
        }
        let mut arm: Kinematics<6, 7> = Kinematics::new();
        let mut last = OurVector::zeros();
        for i in 0..6 {
            arm.h.set_column(i, &Vector3::new(h[i].x, h[i].y, h[i].z));
            let step = at[i] - last;
            arm.p.set_column(i, &Vector3::new(step.x, step.y, step.z));
            last = at[i];
        }
        let step = end - last;
        arm.p.set_column(6, &Vector3::new(step.x, step.y, step.z));
        Self { class, solver, arm, zero: *pose.rotation.matrix() }
    }

    /// Calls the solver. Its searches panic at some poses: such a pose then has no answer.
    fn solve(&self, r: &Matrix3<f64>, p: &Vector3<f64>) -> (Vec<Vector6<f64>>, Vec<bool>) {
        catch_unwind(AssertUnwindSafe(|| (self.solver)(r, p, &self.arm))).unwrap_or_default()
    }

    fn target(&self, target: &Pose) -> (Matrix3<f64>, Vector3<f64>) {
        let r = target.rotation.matrix() * self.zero.transpose();
        let p = target.translation.vector;
        (Matrix3::from_column_slice(r.as_slice()), Vector3::new(p.x, p.y, p.z))
    }
}

impl Peer<6> for IkGeo {
    fn name(&self) -> String {
        format!("ik-geo 0.1.2 {}", self.class)
    }

    fn pass(&self, targets: &[Pose]) -> f64 {
        let targets: Vec<_> = targets.iter().map(|target| self.target(target)).collect();
        let start = ProcessTime::now();
        for target in &targets {
            let (r, p) = black_box(target);
            black_box(&self.solve(r, p));
        }
        start.elapsed().as_secs_f64()
    }

    fn answers(&self, target: &Pose) -> Vec<Answer<6>> {
        let (r, p) = self.target(target);
        let (q, nearest) = self.solve(&r, &p);
        q.into_iter().zip(nearest).map(|(q, nearest)| Answer { q: q.into(), claimed: !nearest }).collect()
    }
}
