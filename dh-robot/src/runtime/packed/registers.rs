//! The vector registers of the processor that the program runs on, through the crate `pulp`, and the loops over groups of poses.

use nalgebra::{IsometryMatrix3, SMatrix};
use pulp::{Arch, Simd, WithSimd, bytemuck};

use super::{Packed, PackedKinematics, Register, Sines};
use crate::pose::from_entries;

impl<S: Simd> Register for S {
    type Numbers = S::f64s;
    type Mask = S::m64s;

    #[inline(always)]
    fn splat(self, x: f64) -> S::f64s {
        self.splat_f64s(x)
    }
    #[inline(always)]
    fn add(self, a: S::f64s, b: S::f64s) -> S::f64s {
        self.add_f64s(a, b)
    }
    #[inline(always)]
    fn sub(self, a: S::f64s, b: S::f64s) -> S::f64s {
        self.sub_f64s(a, b)
    }
    #[inline(always)]
    fn mul(self, a: S::f64s, b: S::f64s) -> S::f64s {
        self.mul_f64s(a, b)
    }
    #[inline(always)]
    fn neg(self, a: S::f64s) -> S::f64s {
        self.neg_f64s(a)
    }
    #[inline(always)]
    fn mul_add(self, a: S::f64s, b: S::f64s, c: S::f64s) -> S::f64s {
        self.mul_add_e_f64s(a, b, c)
    }
    #[inline(always)]
    fn turn(self, rounded: S::f64s, sine: S::f64s, cosine: S::f64s) -> (S::f64s, S::f64s) {
        let quadrant = self.transmute_u64s_f64s(rounded);
        let (zero, one, two) = (self.splat_u64s(0), self.splat_u64s(1), self.splat_u64s(2));
        let has = |bits, bit| self.greater_than_u64s(self.and_u64s(bits, bit), zero);
        let odd = has(quadrant, one);
        let (s, c) = (self.select_f64s(odd, cosine, sine), self.select_f64s(odd, sine, cosine));
        let signed = |x, negative| {
            let sign = self.select_u64s(negative, self.splat_u64s(1 << 63), zero);
            self.transmute_f64s_u64s(self.xor_u64s(self.transmute_u64s_f64s(x), sign))
        };
        (signed(s, has(quadrant, two)), signed(c, has(self.add_u64s(quadrant, one), two)))
    }
    #[inline(always)]
    fn nowhere(self) -> S::m64s {
        self.less_than_f64s(self.splat_f64s(1.0), self.splat_f64s(0.0))
    }
    #[inline(always)]
    fn or_beyond(self, mask: S::m64s, x: S::f64s, limit: f64) -> S::m64s {
        let within = self.less_than_or_equal_f64s(self.abs_f64s(x), self.splat_f64s(limit));
        self.or_m64s(mask, self.not_m64s(within))
    }
    #[inline(always)]
    fn is_anywhere(self, mask: S::m64s) -> bool {
        self.first_true_m64s(mask) < S::F64_LANES
    }
}

/// The most lanes of any register.
const WIDEST: usize = 8;

/// Joint values of as many poses as a register has lanes.
#[inline(always)]
fn packed<S: Simd, const N: usize>(register: S, q: &[[f64; N]]) -> [Packed<S>; N] {
    core::array::from_fn(|j| {
        let mut numbers = [register.splat_f64s(0.0)];
        let lanes: &mut [f64] = bytemuck::cast_slice_mut(&mut numbers);
        for (lane, q) in lanes.iter_mut().zip(q) {
            *lane = q[j];
        }
        Packed { register, numbers: numbers[0] }
    })
}

/// The numbers of each lane.
#[inline(always)]
fn unpacked<S: Simd, const K: usize>(entries: &[Packed<S>; K]) -> [[f64; WIDEST]; K] {
    entries.map(|entry| {
        let mut out = [0.0; WIDEST];
        let numbers = [entry.numbers];
        let lanes: &[f64] = bytemuck::cast_slice(&numbers);
        for (to, from) in out.iter_mut().zip(lanes) {
            *to = *from;
        }
        out
    })
}

struct Poses<'a, A, const N: usize> {
    arm: &'a A,
    q: &'a [[f64; N]],
    to: &'a mut [IsometryMatrix3<f64>],
}

impl<A: PackedKinematics<N>, const N: usize> WithSimd for Poses<'_, A, N> {
    type Output = usize;

    #[inline(always)]
    fn with_simd<S: Simd>(self, register: S) -> usize {
        let (arm, lanes) = (self.arm, S::F64_LANES);
        let mut done = 0;
        for (q, to) in self.q.chunks_exact(lanes).zip(self.to.chunks_exact_mut(lanes)) {
            let mut sines = Sines::new(register);
            let entries = arm.pose(&packed(register, q), &mut sines);
            if sines.beyond() {
                q.iter().zip(to).for_each(|(q, to)| *to = arm.forward(q));
            } else {
                let [xx, yx, zx, xy, yy, zy, xz, yz, zz, x, y, z] = unpacked(&entries);
                for (i, to) in to.iter_mut().enumerate() {
                    let rows = [[xx[i], yx[i], zx[i]], [xy[i], yy[i], zy[i]], [xz[i], yz[i], zz[i]]];
                    *to = from_entries(rows, [x[i], y[i], z[i]]);
                }
            }
            done += lanes;
        }
        done
    }
}

/// The poses of whole groups; how many.
pub(super) fn forward<A: PackedKinematics<N>, const N: usize>(
    arm: &A,
    q: &[[f64; N]],
    to: &mut [IsometryMatrix3<f64>],
) -> usize {
    Arch::new().dispatch(Poses { arm, q, to })
}

struct Jacobians<'a, A, const N: usize> {
    arm: &'a A,
    q: &'a [[f64; N]],
    to: &'a mut [SMatrix<f64, 6, N>],
}

impl<A: PackedKinematics<N>, const N: usize> WithSimd for Jacobians<'_, A, N> {
    type Output = usize;

    #[inline(always)]
    fn with_simd<S: Simd>(self, register: S) -> usize {
        let (arm, lanes) = (self.arm, S::F64_LANES);
        let mut done = 0;
        for (q, to) in self.q.chunks_exact(lanes).zip(self.to.chunks_exact_mut(lanes)) {
            let mut sines = Sines::new(register);
            let columns = arm.columns(&packed(register, q), &mut sines);
            if sines.beyond() {
                q.iter().zip(to).for_each(|(q, to)| *to = arm.jacobian(q));
            } else {
                for (j, column) in columns.iter().enumerate() {
                    let rows = unpacked(column);
                    for (i, to) in to.iter_mut().enumerate() {
                        for (r, row) in rows.iter().enumerate() {
                            to[(r, j)] = row[i];
                        }
                    }
                }
            }
            done += lanes;
        }
        done
    }
}

/// The Jacobians of whole groups; how many.
pub(super) fn jacobians<A: PackedKinematics<N>, const N: usize>(
    arm: &A,
    q: &[[f64; N]],
    to: &mut [SMatrix<f64, 6, N>],
) -> usize {
    Arch::new().dispatch(Jacobians { arm, q, to })
}
