//! Arms of every kind that takes the fast path, with lengths that were thrown once.

use dh_robot::Solutions;
use dh_robot::nalgebra::IsometryMatrix3;

use super::check;

/// A robot in a module of its own, and a test of it.
macro_rules! arm {
    ($(#[$doc:meta])* $name:ident given $joint:literal: $($table:tt)*) => {
        arm!(@ $(#[$doc])* $name, |arm, target, q| [arm.inverse(target, q[$joint]), arm.inverse_with_work(target, q[$joint]).0], $($table)*);
    };
    ($(#[$doc:meta])* $name:ident $($table:tt)*) => {
        arm!(@ $(#[$doc])* $name, |arm, target, _q| [arm.inverse(target), arm.inverse_with_work(target).0], $($table)*);
    };
    (@ $(#[$doc:meta])* $name:ident, |$arm:ident, $target:ident, $q:ident| $both:expr, $($table:tt)*) => {
        mod $name {
            dh_robot::dh_robot! {
                $(#[$doc])*
                pub(super) struct Arm;
                $($table)*
            }

            type Found = super::Solutions<f64, { Arm::DOF }, { Arm::MAX_SOLUTIONS }>;

            /// What the fast path finds, and what the fallback path does, which is private to this module.
            pub(super) fn both($arm: &Arm, $target: &super::IsometryMatrix3<f64>, $q: &[f64; Arm::DOF]) -> [Found; 2] {
                $both
            }
        }

        #[test]
        fn $name() {
            let arm = $name::Arm::default();
            check(stringify!($name), &arm, |target, q| $name::both(&arm, target, q));
        }
    };
}

arm! {
    /// Axes 2 and 3 parallel, spherical wrist; shoulder offset, no lengths before it.
    wrist_craig
    convention = modified;
    | alpha  | a     | d     | theta |
    | 0      | 0     | 0     | q1    |
    | -90deg | 0     | 0     | q2    |
    | 0      | 0.548 | 0.16  | q3    |
    | -90deg | 0.041 | 0.548 | q4    |
    | 90deg  | 0     | 0     | q5    |
    | -90deg | 0     | 0     | q6    |
}

arm! {
    /// The same kind after the standard convention, with offsets of the joints and a flange.
    wrist_book
    convention = standard;
    | theta       | d      | a      | alpha  |
    | q1          | -0.365 | 0.053  | -90deg |
    | q2 - pi/2   | 0      | -0.107 | 0      |
    | q3          | 0      | 0.096  | -90deg |
    | q4          | -0.165 | 0      | 90deg  |
    | q5          | 0      | 0      | -90deg |
    | q6 + 180deg | -0.095 | 0      | 0      |
}

arm! {
    /// All twists the other way round, axes 2 and 3 against each other, lengths of both signs.
    wrist_other_signs
    convention = standard;
    | theta      | d      | a      | alpha  |
    | q1         | 0.285  | 0.084  | 90deg  |
    | q2         | 0.027  | -0.069 | 180deg |
    | q3 + 90deg | 0      | 0.035  | 90deg  |
    | q4         | 0.206  | 0      | -90deg |
    | q5         | 0      | 0      | 90deg  |
    | q6         | -0.058 | 0      | 180deg |
}

arm! {
    /// Base and tool turned, ranges that one turn leads into.
    wrist_tool
    convention = modified;
    base = tz(0.3) * rx(20deg);
    tool = tx(0.05) * rz(30deg) * ry(90deg) * tz(0.12);
    | alpha  | a      | d      | theta | range            |
    | 0      | 0      | 0.063  | q1    | -170deg..=170deg |
    | 90deg  | -0.089 | 0      | q2    | -225deg..=45deg  |
    | 0      | -0.181 | 0      | q3    | -45deg..=225deg  |
    | 90deg  | 0      | -0.405 | q4    | -350deg..=10deg  |
    | -90deg | 0      | 0      | q5    | -100deg..=100deg |
    | 90deg  | 0      | 0.057  | q6    | 90deg..=450deg   |
}

arm! {
    /// No offset at all: the shoulder axis goes through the wrist in a whole family of poses.
    wrist_plain
    convention = standard;
    | theta | d     | a     | alpha  |
    | q1    | 0.38  | 0     | 90deg  |
    | q2    | 0     | 0.296 | 0      |
    | q3    | 0     | 0     | 90deg  |
    | q4    | 0.134 | 0     | -90deg |
    | q5    | 0     | 0     | 90deg  |
    | q6    | 0     | 0     | 0      |
}

arm! {
    /// A wrist whose twists are not right angles.
    wrist_skew
    convention = standard;
    | theta | d     | a      | alpha  |
    | q1    | 0     | 0.071  | -90deg |
    | q2    | 0     | -0.288 | 0      |
    | q3    | 0     | 0      | -90deg |
    | q4    | 0.561 | 0      | 60deg  |
    | q5    | 0     | 0      | -75deg |
    | q6    | 0.084 | 0      | 0      |
}

arm! {
    /// Axes 1 and 2 parallel, then the wrist.
    wrist_upright
    convention = standard;
    | theta | d      | a     | alpha  |
    | q1    | -0.369 | 0.114 | 0      |
    | q2    | 0      | 0.336 | 90deg  |
    | q3    | 0.199  | 0     | -90deg |
    | q4    | 0.113  | 0     | 90deg  |
    | q5    | 0      | 0     | -90deg |
    | q6    | 0.05   | 0     | 0      |
}

arm! {
    /// Lengths as fields.
    wrist_fields
    convention = modified;
    let a1: length = 0.045;
    let a2: length = 0.574;
    let a3: length = -0.081;
    let d1: length = -0.417;
    let d3: length = -0.056;
    let d4: length = 0.09;
    let d6: length = -0.055;
    | alpha  | a  | d  | theta |
    | 0      | 0  | d1 | q1    |
    | -90deg | a1 | 0  | q2    |
    | 0      | a2 | d3 | q3    |
    | -90deg | a3 | d4 | q4    |
    | 90deg  | 0  | 0  | q5    |
    | -90deg | 0  | d6 | q6    |
}

arm! {
    /// The spherical joint at the base.
    shoulder
    convention = standard;
    | theta | d     | a      | alpha  |
    | q1    | 0     | 0      | 90deg  |
    | q2    | 0     | 0      | -90deg |
    | q3    | 0.097 | -0.044 | 90deg  |
    | q4    | 0     | -0.065 | 0      |
    | q5    | 0     | -0.061 | 90deg  |
    | q6    | 0.051 | 0      | 0      |
}

arm! {
    /// Axes 2, 3 and 4 parallel.
    cobot
    convention = standard;
    | theta | d      | a      | alpha  |
    | q1    | -0.34  | 0      | 90deg  |
    | q2    | 0      | -0.222 | 0      |
    | q3    | 0      | -0.201 | 0      |
    | q4    | -0.083 | 0      | 90deg  |
    | q5    | -0.084 | 0      | -90deg |
    | q6    | 0.133  | 0      | 0      |
}

arm! {
    /// The same kind after Craig, with lengths along the parallel axes.
    cobot_craig
    convention = modified;
    | alpha  | a      | d      | theta      |
    | 0      | 0      | 0.406  | q1         |
    | -90deg | 0      | -0.05  | q2 - 90deg |
    | 0      | 0.399  | 0.088  | q3         |
    | 0      | -0.213 | 0.095  | q4 + 90deg |
    | -90deg | 0      | -0.065 | q5         |
    | 90deg  | 0      | -0.182 | q6         |
}

arm! {
    /// The same with ranges, base and tool.
    cobot_tool
    convention = standard;
    base = ty(0.2) * rz(45deg);
    tool = tz(0.1) * rx(90deg);
    | theta | d      | a     | alpha  | range            |
    | q1    | -0.583 | 0     | -90deg | -180deg..=180deg |
    | q2    | 0.176  | 0.105 | 0      | -350deg..=0deg   |
    | q3    | 0.037  | 0.435 | 0      | -150deg..=150deg |
    | q4    | 0      | 0     | -90deg | -10deg..=350deg  |
    | q5    | 0.188  | 0     | 90deg  | -180deg..=180deg |
    | q6    | 0.195  | 0     | 0      | -360deg..=360deg |
}

arm! {
    /// Two joints that turn, one that slides, a wrist.
    stanford
    convention = standard;
    | theta | d      | a | alpha  |
    | q1    | -0.148 | 0 | -90deg |
    | q2    | -0.177 | 0 | 90deg  |
    | 0     | q3     | 0 | 0      |
    | q4    | 0      | 0 | -90deg |
    | q5    | 0      | 0 | 90deg  |
    | q6    | -0.197 | 0 | 0      |
}

arm! {
    /// Turn, slide, slide, wrist.
    cylinder
    convention = standard;
    | theta | d     | a | alpha  |
    | q1    | 0.462 | 0 | 0      |
    | 0     | q2    | 0 | -90deg |
    | 0     | q3    | 0 | 0      |
    | q4    | 0     | 0 | -90deg |
    | q5    | 0     | 0 | 90deg  |
    | q6    | 0.111 | 0 | 0      |
}

arm! {
    /// Three slides and a wrist.
    gantry
    convention = standard;
    | theta | d        | a | alpha  |
    | 90deg | q1       | 0 | 90deg  |
    | 90deg | q2       | 0 | 90deg  |
    | 0     | q3 + 0.2 | 0 | 0      |
    | q4    | 0        | 0 | -90deg |
    | q5    | 0        | 0 | 90deg  |
    | q6    | -0.137   | 0 | 0      |
}

arm! {
    /// SCARA, the slide last.
    scara_rrrp
    convention = standard;
    | theta | d      | a     | alpha  |
    | q1    | -0.206 | 0.41  | 0      |
    | q2    | 0      | 0.257 | 180deg |
    | q3    | 0      | 0     | 0      |
    | 0     | q4     | 0     | 0      |
}

arm! {
    /// SCARA, the slide third.
    scara_rrpr
    convention = standard;
    | theta | d      | a    | alpha  |
    | q1    | -0.269 | 0.49 | 0      |
    | q2    | 0      | 0.1  | 180deg |
    | 0     | q3     | 0    | 0      |
    | q4    | 0.098  | 0    | 0      |
}

arm! {
    /// SCARA, the slide first.
    scara_prrr
    convention = modified;
    | alpha | a      | d      | theta |
    | 0     | 0      | q1     | 0     |
    | 0     | 0.211  | 0      | q2    |
    | 0     | -0.235 | -0.079 | q3    |
    | 0     | 0.1    | 0      | q4    |
}

arm! {
    /// Turn, slide, turn in a plane.
    planar_rpr
    convention = standard;
    | theta | d  | a      | alpha  |
    | q1    | 0  | 0      | 90deg  |
    | 0     | q2 | 0      | -90deg |
    | q3    | 0  | -0.061 | 0      |
}

arm! {
    /// Turn and slide.
    planar_rp
    convention = standard;
    | theta | d      | a | alpha |
    | q1    | -0.182 | 0 | 90deg |
    | 0     | q2     | 0 | 0     |
}

arm! {
    /// Shoulder, elbow and wrist: the third joint, an offset on it, is the caller's.
    seven_spherical given 2:
    convention = standard;
    redundant = q3;
    | theta      | d     | a | alpha  | range            |
    | q1         | 0.34  | 0 | -90deg | -                |
    | q2         | 0     | 0 | 90deg  | -120deg..=120deg |
    | q3 + 30deg | 0.41  | 0 | 90deg  | -                |
    | q4         | 0     | 0 | -90deg | -                |
    | q5         | 0.38  | 0 | -90deg | -                |
    | q6         | 0     | 0 | 90deg  | -                |
    | q7         | 0.126 | 0 | 0      | -175deg..=175deg |
}

arm! {
    /// Offsets at elbow and wrist, the last joint is the caller's.
    seven_offsets given 6:
    convention = modified;
    redundant = q7;
    | alpha  | a       | d     | theta |
    | 0      | 0       | 0.333 | q1    |
    | -90deg | 0       | 0     | q2    |
    | 90deg  | 0       | 0.316 | q3    |
    | 90deg  | 0.0825  | 0     | q4    |
    | -90deg | -0.0825 | 0.384 | q5    |
    | 90deg  | 0       | 0     | q6    |
    | 90deg  | 0.088   | 0.1   | q7    |
}

arm! {
    /// A six-axis arm on a track whose place the caller chooses.
    on_a_track given 0:
    convention = standard;
    redundant = q1;
    | theta | d     | a     | alpha  |
    | 90deg | q1    | 0     | 90deg  |
    | q2    | 0.4   | 0.025 | -90deg |
    | q3    | 0     | 0.315 | 0      |
    | q4    | 0     | 0.035 | -90deg |
    | q5    | 0.365 | 0     | 90deg  |
    | q6    | 0     | 0     | -90deg |
    | q7    | 0.08  | 0     | 0      |
}

arm! {
    /// A wrist behind a parallelogram: the third motor turns the forearm against the base, the last two are coupled.
    parallelogram
    convention = standard;
    | theta      | d    | a    | alpha  | range            |
    | q1         | 0.4  | 0.1  | -90deg | -                |
    | q2         | 0    | 0.5  |   0    | -100deg..=260deg |
    | q3 - q2    | 0    | 0.05 | -90deg | -80deg..=280deg  |
    | q4 + 50deg | 0.45 | 0    |  90deg | -                |
    | q5         | 0    | 0    | -90deg | -                |
    | q6 + 2*q5  | 0.1  | 0    |   0    | -                |
}

arm! {
    /// Three parallel axes, each measured against the base.
    three_parallel_from_the_base
    convention = standard;
    | theta              | d     | a      | alpha  |
    | q1                 | 0.089 | 0      | 90deg  |
    | q2 - 100deg        | 0     | -0.425 | 0      |
    | q3 - q2 + 20deg    | 0     | -0.392 | 0      |
    | q4 - q3 + 0.3*1turn| 0.109 | 0      | 90deg  |
    | q5                 | 0.095 | 0      | -90deg |
    | q6                 | 0.082 | 0      | 0      |
}
