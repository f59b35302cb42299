//! A serial chain of rigid transforms: the model of an arm that the numeric kernels use.

use super::elementary::{sin_cos, sqrt};
use super::polish::Kinematics;
use super::pose::{IDENTITY, Pose, compose, slide, turn};
use super::vector::cross;

/// A serial chain `J1(q1) C1 J2(q2) C2 ... JN(qN) CN` with `J = Rz` (or `Tz` where `prismatic`) and constant transforms `C`.
///
/// Every Denavit-Hartenberg table has this form: the constant in front of the first joint is taken over to the target's side.
#[derive(Clone, Copy, Debug)]
pub struct NumericChain<const N: usize> {
    /// The constant transform after each joint.
    pub links: [Pose; N],
    /// Which joints are prismatic.
    pub prismatic: [bool; N],
}

impl<const N: usize> NumericChain<N> {
    /// A length of the arm's size: the sum of its constant offsets; 1 where there are none.
    pub fn length_scale(&self) -> f64 {
        let mut sum = 0.0;
        for c in &self.links {
            sum += sqrt(c[0][3] * c[0][3] + c[1][3] * c[1][3] + c[2][3] * c[2][3]);
        }
        if sum > 0.0 { sum } else { 1.0 }
    }

    /// The transform of joint `i` and its link, applied to `before`.
    #[inline]
    fn step(&self, before: &Pose, i: usize, q: f64) -> Pose {
        let moved = if self.prismatic[i] {
            slide(before, q)
        } else {
            let (s, c) = sin_cos(q);
            turn(before, [c, s])
        };
        compose(&moved, &self.links[i])
    }
}

impl<const N: usize> Kinematics<N> for NumericChain<N> {
    fn forward(&self, q: &[f64; N]) -> Pose {
        let mut t = IDENTITY;
        for i in 0..N {
            t = self.step(&t, i, q[i]);
        }
        t
    }

    fn forward_and_jacobian(&self, q: &[f64; N]) -> (Pose, [[f64; N]; 6]) {
        let mut t = IDENTITY;
        let mut axes = [([0.0; 3], [0.0; 3]); N];
        for i in 0..N {
            axes[i] = ([t[0][2], t[1][2], t[2][2]], [t[0][3], t[1][3], t[2][3]]);
            t = self.step(&t, i, q[i]);
        }
        let mut j = [[0.0; N]; 6];
        for i in 0..N {
            let (z, p) = axes[i];
            let arm = [t[0][3] - p[0], t[1][3] - p[1], t[2][3] - p[2]];
            let (linear, angular) = if self.prismatic[i] { (z, [0.0; 3]) } else { (cross(z, arm), z) };
            for k in 0..3 {
                j[k][i] = linear[k];
                j[3 + k][i] = angular[k];
            }
        }
        (t, j)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::rotation_between;
    use crate::testing::{Rng, random_pose};

    #[test]
    fn jacobian_of_a_chain_is_its_derivative() {
        let mut rng = Rng::new(6);
        let links = [(); 5].map(|()| random_pose(&mut rng));
        let chain = NumericChain { links, prismatic: [false, true, false, false, true] };
        let q = [(); 5].map(|()| rng.angle());
        let (_, j) = chain.forward_and_jacobian(&q);
        for i in 0..5 {
            let h = 1e-6;
            let (mut plus, mut minus) = (q, q);
            plus[i] += h;
            minus[i] -= h;
            let (a, b) = (chain.forward(&minus), chain.forward(&plus));
            let turn = rotation_between(&a, &b);
            for k in 0..3 {
                assert!(((b[k][3] - a[k][3]) / (2.0 * h) - j[k][i]).abs() < 1e-8);
                assert!((turn[k] / (2.0 * h) - j[3 + k][i]).abs() < 1e-8);
            }
        }
    }
}
