//! Closed-form kinematics of serial robots, generated from a Denavit-Hartenberg table and proven while the program is
//! compiled.
//!
//! Write the table of an arm as it stands in the book or the data sheet; get a type with forward kinematics, all link
//! frames, the geometric Jacobian and *all* solutions of the inverse kinematics. No iteration from a guess, no heap, no
//! `unsafe`, no standard library if you have none.
//!
//! ```
//! use dh_robot::dh_robot;
//!
//! dh_robot! {
//!     /// Unimation PUMA 560, frames after Craig.
//!     pub struct Puma560;
//!
//!     convention = modified;
//!     let a2: length = 431.8mm;
//!     let a3: length = 20.3mm;
//!     let d3: length = 150.05mm;
//!     let d4: length = 431.8mm;
//!
//!     | joint | alpha  | a  | d  | theta | range            |
//!     |-------|--------|----|----|-------|------------------|
//!     |   1   |   0    | 0  | 0  | q1    | -160deg..=160deg |
//!     |   2   | -90deg | 0  | 0  | q2    | -225deg..= 45deg |
//!     |   3   |   0    | a2 | d3 | q3    |  -45deg..=225deg |
//!     |   4   | -90deg | a3 | d4 | q4    | -110deg..=170deg |
//!     |   5   |  90deg | 0  | 0  | q5    | -100deg..=100deg |
//!     |   6   | -90deg | 0  | 0  | q6    | -266deg..=266deg |
//! }
//!
//! let robot = Puma560::default();
//! let here = [0.1, -0.8, 0.6, 0.0, 0.9, -0.3];
//! let target = robot.forward(&here);
//! for solution in &robot.inverse(&target).within_range() {
//!     println!("{solution}"); // [0.1000, -0.8000, ...] (shoulder right, elbow up, wrist no flip)
//! }
//! ```
//!
//! # Contents
//!
//! - [The table](#the-table): [columns](#columns), [lengths](#lengths), [angles](#angles),
//!   [names](#names-let), [joint variables](#joint-variables), [coupled drives](#coupled-drives)
//! - [The settings](#the-settings): `convention`, `unit`, `base` and `tool`, `task`, `redundant`, `ik`, `scalar`
//! - [Checking a derivation](#checking-a-derivation): `prove`
//! - [What you get](#what-you-get): the generated type, solutions, [targets that lost digits](#targets-that-lost-digits), empty answers,
//!   [batches](#batches), [velocities](#velocities)
//! - [Programs that are generic over robots](#programs-that-are-generic-over-robots)
//! - [C and C++](#c-and-c)
//! - [Without the standard library](#without-the-standard-library)
//!
//! # The table
//!
//! The body of the macro is: attributes and `pub struct Name;`, settings and names in any order, the table, and perhaps a
//! `prove` block. The table is a Markdown table, so that it can be pasted from a README and is drawn again in the
//! documentation of the type. The rule line `|---|` may be left out. Every cell says something: an empty cell is an error,
//! zero is written `0`.
//!
//! A mistake in the table is a compile error at its cell, and all mistakes are reported at once.
//!
//! ## Columns
//!
//! `alpha` (link twist), `a` (link length), `d` (link offset) and `theta` (joint angle), in any order, named by the
//! header; `joint` (the row's number, or a name such as `shoulder`, kept as [`Joint::label`]) and `range` may be left out.
//! Which row a link's twist and length stand in is what the two conventions differ in, and the classic source of wrong robots;
//! so there is no default:
//!
//! Headers and cells may be pasted as people publish them: units in the header (`a [mm]`, `alpha (deg)`), `alpha(i-1)` for the modified convention (an error where
//! `convention` says otherwise), `θ1` and `π/2` as Greek letters, `sqrt`, `sin`, `atan2` and the like of constants.
//!
//! | setting | link transform | row i holds |
//! |---------|----------------|-------------|
//! | `convention = standard;` | `Rz(theta) Tz(d) Tx(a) Rx(alpha)` | theta(i), d(i), a(i), alpha(i) |
//! | `convention = modified;` | `Rx(alpha) Tx(a) Rz(theta) Tz(d)` | alpha(i-1), a(i-1), d(i), theta(i), as in Craig's book |
//!
//! `range` holds `least..=greatest` in the unit of the joint, `-160deg..=160deg`, `0mm..=300mm`, or `-` where it is not known.
//! A row that does not move may say `fixed`. A table has at most 16 rows, 12 of them moving, and 64 names.
//!
//! ## Lengths
//!
//! `0`, `0.4318m`, `431.8mm`, `43.18cm`, `17in`, `1.5ft`, with signs, and sums of them. A bare number is in the table's unit, which is
//! also the unit of every length in the program: metres, unless `unit = mm;` (or `cm`, `in`) says otherwise. A table
//! without `unit` whose bare lengths reach a hundred metres, none below one, is asked for its unit. Numbers are read digit by digit, as
//! exact fractions.
//!
//! ## Angles
//!
//! `0`, `90deg`, `pi/2`, `-3*pi/4`, `0.25turn`: exact, all of them, so that the cosine of a right angle *is* zero and not
//! 6e-17. A number of radians cannot be exact and has to say so: `approx 1.2rad`. If it is suspiciously near a multiple of
//! 15 degrees, that is an error which names the exact spelling: `approx 1.5708rad` is refused, since it is pi/2 rounded to its
//! four places; `approx 1.5703rad` is another angle (of a calibrated arm, say) and stays what it is.
//!
//! In the program angles are radians.
//!
//! ## Names: `let`
//!
//! | line | meaning |
//! |------|---------|
//! | `let a2: length = 431.8mm;` | a symbol with a nominal value: a public field of the struct, so that a calibrated arm can differ |
//! | `let a2: length;`, `let tilt: angle;` | a symbol without one: the struct has no `Default` then |
//! | `let k: number;`, `let k: number = 2;` | a symbol without a unit: a ratio, a gear |
//! | `let a2 = 431.8mm;`, `let w = pi/2;` | a constant, folded into the code; it may use the constants above it |
//!
//! A doc comment before a `let` becomes the field's. Cells are sums and products of numbers and names, with parentheses and
//! division by numbers: `-d4`, `a2 + 10mm`, `2*(l1 + l2)`, `l1/2`. A declared angle takes whole factors only: `2*tilt`. Symbols stay symbols in the formulas: the
//! solution is found, and proven, for every value they may have.
//!
//! ## Poses that change: `let gripper: pose`
//!
//! `let gripper: pose;` is a public field of type `IsometryMatrix3`, `let gripper: pose = tz(120mm) * ry(90deg);` one with a nominal value. It is a
//! factor of `base` and `tool`, nothing else:
//!
//! ```text
//! let rail: pose;
//! let gripper: pose = tz(120mm);
//! base = rail * tz(0.3);
//! tool = tz(50mm) * gripper;
//! ```
//!
//! Poses, Jacobian and velocities are those at the gripper, the inverse takes its pose; it costs a product in each. Link frames have `base` in
//! them, not `tool`. Formulas, claims (`T(0,6)`, the plain `px` of a `prove` block) and plans are those of the arm between the nearest such poses.
//! With `task = position` the tool's point becomes three parameters of the plan. With `task = planar` a pose in `base` must keep the plane,
//! with `task = axis` a pose in `tool` must keep the last z axis. One that does not, or a value that is no rigid motion, is an answer:
//! [`Why::UnfitPose`]. Exported C takes the nominal values.
//!
//! ## Joint variables
//!
//! `q1`, `q2`, ... stand where the joint moves: in `theta` the joint turns, in `d` it slides. An offset is written where the
//! book writes it: `q2 - 90deg`, `q3 + 0.05`. A row without a variable is a fixed link.
//! Fixed rows do not count: the k-th row that moves has the variable `qk`. A joint that turns and slides is written as two rows.
//!
//! ```text
//! | joint | theta      | d        | a     | alpha  | range            |
//! |-------|------------|----------|-------|--------|------------------|
//! |   1   | q1         | 387mm    | 325mm |   0    | -130deg..=130deg |
//! |   2   | q2 - 90deg | 0        | 225mm | 180deg | -145deg..=145deg |
//! |   3   | 0          | q3       | 0     |   0    |    0mm..=200mm   |
//! |   4   | q4         | 0        | 0     |   0    | -360deg..=360deg |
//! ```
//!
//! ## Coupled drives
//!
//! A cell may hold any linear combination of joint variables: `q3 - q2` where a parallelogram keeps the forearm's
//! direction, `p*(q2 - q1)` in `d` where two motors share a slide. There are as many variables as moving rows, and it must be
//! possible to solve for them. Then `q` is what the *motors* do, everywhere: forward, Jacobian, inverse and ranges. A factor or a
//! minus (`-q2`, `q1/50`) counts as coupling too; in a table without any, a variable in another row than its own is an error.
//!
//! # The settings
//!
//! | setting | meaning |
//! |---------|---------|
//! | `convention = standard;` or `modified` | see [columns](#columns); must be given |
//! | `unit = m;` (default), `mm`, `cm`, `in`, `ft` | the unit of bare numbers, and of every length in the program |
//! | `base = tz(373mm);` | a constant transform before the chain: a product of `tx ty tz rx ry rz`, and of [poses](#poses-that-change-let-gripper-pose) |
//! | `tool = tz(206mm) * ry(90deg);` | the same after the chain |
//! | `task = pose;` (default) | what the inverse is given; see below |
//! | `redundant = q3;` | the joint whose value the caller chooses, on arms with one joint too many; `redundant = q1, q8;` several |
//! | `ik = none;` | no inverse is wanted, or none can be had |
//! | `urdf = "arm.urdf"; chain = base_link..tool0;` | instead of a table: the chain between two links of a URDF file, its path relative to the crate; with the feature `urdf` |
//! | `scalar = f32;` | the type of every number in the program, instead of `f64` |
//!
//! | task | the target is | for |
//! |------|---------------|-----|
//! | `pose` | `&IsometryMatrix3<f64>` | position and orientation, six coordinates |
//! | `position` | `&Point3<f64>` | position alone |
//! | `planar` | `(x, y, phi)` | position in the plane and angle about z |
//! | `axis` | `(Point3<f64>, UnitVector3<f64>)` | position and direction of the last z axis, for arms of five joints |
//!
//! With `redundant = q3` the call is `inverse(&target, q3)`, with several it is `inverse(&target, [q1, q8])`, in the order of the setting.
//! More joints than the arm can spare for its task cannot be given. An arm of fewer than six joints may keep `task = pose`: it
//! answers when the pose is one that it can take, and says what is wrong when not.
//!
//! Where no closed form exists the macro says so, at the cells that break the structure; forward kinematics and Jacobian
//! are there all the same. It never generates an inverse that it could not verify.
//!
//! # Checking a derivation
//!
//! The lines of a derivation by hand, from a lecture or a paper, can stand in the program. They are checked exactly, as
//! identities, while it is compiled; a wrong line is an error at that line which shows the difference.
//!
//! ```text
//! prove {
//!     T(1,3) = [c23, -s23, 0, a2*c2; 0, 0, 1, d3; -s23, -c23, 0, -a2*s2; 0, 0, 0, 1];
//!     T(0,6).px = c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1;
//! }
//! ```
//!
//! `T(i,j)` is frame j in frame i, `.px`, `.py`, `.pz` its position, `.r11` ... `.r33` the entries of its rotation; `c1` is
//! the cosine of the first joint angle, `s23` the sine of the sum of the second and third.
//!
//! # What you get
//!
//! ```ignore
//! impl Puma560 {
//!     pub const DOF: usize = 6;
//!     pub const MAX_SOLUTIONS: usize = 8;
//!     pub const JOINTS: [Joint; 6];
//!     pub fn forward(&self, q: &[f64; 6]) -> IsometryMatrix3<f64>;
//!     pub fn frames(&self, q: &[f64; 6]) -> [IsometryMatrix3<f64>; 6];
//!     pub fn jacobian(&self, q: &[f64; 6]) -> SMatrix<f64, 6, 6>;
//!     pub fn forward_and_jacobian(&self, q: &[f64; 6]) -> (IsometryMatrix3<f64>, SMatrix<f64, 6, 6>);
//!     pub fn inverse(&self, target: &IsometryMatrix3<f64>) -> Solutions<f64, 6, 8>;
//!     // and batches and velocities, see below
//! }
//! ```
//!
//! - `forward` is the pose of the last frame, or of the tool, in the base; `frames` that of every link frame.
//! - `jacobian` is the geometric one: rows 0..3 are linear, 3..6 angular velocity per joint speed, in base axes, at the
//!   origin of the last frame (or tool). `forward_and_jacobian` computes both for little more than one of them: a loop that follows a path
//!   calls it.
//! - `inverse` returns every real solution, each once, and none that misses the target: a list on the stack, [`Solutions`].
//!   Angles are in `(-pi, pi]`, or a few whole turns away where only that is in the joint's range. Where motors are geared, so that a whole
//!   turn of a row is no whole turn of its motors, this holds for what the rows turn by.
//!
//! A [`Solution`] knows which alternatives it took ([`Branch`]: shoulder, elbow, wrist), so that a program can stay on its
//! branch, and which joints are free ([`FreeJoints`]): at a singular pose, a wrist stretched out for example, there are
//! infinitely many solutions, of which one is returned (within the ranges, if one joint can be turned against others until all are there). Of the list one asks the nearest
//! ([`closest_to`](Solutions::closest_to)), where to move ([`toward`](Solutions::toward)), what the joints can do
//! ([`within_range`](Solutions::within_range)), a branch ([`with_branch`](Solutions::with_branch)).
//!
//! ## Along a path
//!
//! A control loop asks for one solution, the one that continues from where the arm stands:
//!
//! - `inverse_near(&target, &q)` (with `redundant`: `inverse_near(&target, given, &q)`) is that solution: the one of least travel, whole turns within the
//!   ranges, and at a singular pose the point of the self-motion nearest to `q`, so that a path through a straight wrist does not jump. What continues from
//!   `q` within 0.2 rad is preferred even out of range, and a residual of 1e-9 is let pass where a smaller one would need a jump.
//! - [`follow`] does so along an iterator of targets, and says where and why the arm cannot go on ([`Stop`]).
//! - `self_motion(&solution)` is the direction in joint space in which the arm moves while its tool stands still.
//!
//! The work of `inverse` and `inverse_near` is bounded at every pose: `MAX_WORK` says by how many runs of the plan and Newton steps. (Of an arm that needs an
//! elimination a run is one elimination with what it does near its double roots: milliseconds at special poses.) `inverse_exhaustive` is a
//! thorough search without a bound on its time, to compare with.
//!
//! ## Targets that lost digits
//!
//! - A rotation with six decimals, or a long product of rotations, is accepted up to [`Real::ROTATION_TOLERANCE`] and the nearest exact one
//!   taken: on an arm with six joints all solutions are those of that rotation, and miss the matrix as given by its rounding, no more. Farther
//!   off, [`Why::NotARotation`] says by how much; [`pose::orthonormalized`] repairs what is meant nevertheless. The direction of `task = axis`
//!   is treated alike.
//! - An arm with fewer joints than its target has coordinates reaches few targets exactly. One that is off what the arm can do by more than
//!   1e-9 (radians, or lengths over the sum of the link lengths; 2e-6 with `scalar = f32`) is refused, and [`Why::NotOnTask`] says whether its
//!   position or its orientation is off, and by how much: a pose with six decimals, say, by some 1e-7. So ask such an arm for what it can
//!   choose: `task = position`, `planar` or `axis`; or compute the coordinates that it cannot choose from those that it can (a SCARA's tool
//!   points straight down, the plane of a five-axis arm holds its first axis) instead of reading them.
//! - With `scalar = f32` everything is computed in `f64` and rounded at the end: solutions reach their target to some 1e-6.
//!
//! No input panics. An empty list says [`why`](Solutions::why): out of reach at which step and by how much, a number that is
//! not finite, a matrix that is no rotation. [`pose`] holds the check itself, and a repair for matrices that lost digits.
//!
//! ## Batches
//!
//! `forward_batch(&q, &mut poses)`, `jacobian_batch(&q, &mut jacobians)`, `inverse_batch(&targets, &mut solutions)` and
//! `inverse_near_batch(&targets, &q, &mut solutions)` take slices: of poses, or of what else the task's target is. With `redundant = q3` the
//! values of that joint come as a slice behind the targets. As many are computed as the shortest slice holds, what lies beyond
//! stays as it is, and each result is that of the single call to the last bit: a joint vector or target that is not finite spoils
//! its own result only. Nothing is allocated.
//!
//! With the feature `simd` (`dh-robot = { version = "0.1", features = ["simd"] }`) forward kinematics and Jacobians of `f64` robots are computed
//! several poses at a time, in the widest vector registers that the processor has when the program runs (AVX-512, AVX2 with FMA, NEON; without
//! these one by one). Results then differ from those of single calls by rounding only: where the processor multiplies and adds in one instruction,
//! sines and cosines use it.
//!
//! ## Velocities
//!
//! | function | what it gives |
//! |----------|---------------|
//! | `jacobian_in_tool(&q)` | the Jacobian in the axes of the last frame (or tool) |
//! | `jacobian_dot(&q, &speeds)` | its time derivative (base axes) while the joints move, exact: for accelerations |
//! | `manipulability(&q)`, `smallest_singular_value(&q)` | how far the arm is from a singular pose; both 0 there |
//! | `solve_velocity(&q, &twist)` | joint speeds for a velocity of the tool, damped near singular poses; [`velocity::JointSpeeds`] says how much, and what is missed |
//!
//! Coupled drives are part of all of these: speeds are those of the motors. [`velocity`] says how they are computed, and offers the
//! same for any Jacobian.
//!
//! nalgebra's types are the language of the program; the crate that they come from is re-exported as [`nalgebra`].
//!
//! # Programs that are generic over robots
//!
//! The functions above need no trait in scope. For programs that serve several arms the type implements
//! [`ForwardKinematics`], [`Jacobian`] and [`InverseKinematics`] as well, with the number of joints as a parameter. Arms of different kinds
//! stand in one list as `dyn` [`Arm`], whose joint values are slices:
//!
//! ```
//! use dh_robot::ForwardKinematics;
//! use dh_robot::nalgebra::Point3;
//!
//! /// How far the tool is from a point.
//! fn gap<const N: usize>(robot: &dyn ForwardKinematics<N>, q: &[f64; N], point: &Point3<f64>) -> f64 {
//!     (robot.forward(q).translation.vector - point.coords).norm()
//! }
//! ```
//!
//! # C and C++
//!
//! `dh export arm.dh --to c --out DIR` (the command of the crate `dh-symbolic`; the file holds what stands between the braces of the macro)
//! writes a folder that stands alone: a small crate with the table, `NAME.h` (C99), `NAME.hpp` (C++17), `CMakeLists.txt` that builds a static
//! and a shared library and installs a CMake package, example programs, and a README with the commands. `--dh-robot PATH` builds with a
//! clone in place of the registry's crate.
//!
//! ```c
//! double pose[16];                                          /* a homogeneous matrix, row after row */
//! puma560_solution solutions[PUMA560_MAX_SOLUTIONS];
//! puma560_why why;
//! puma560_forward(q, pose);
//! int count = puma560_inverse(pose, solutions, &why);       /* or why not: puma560_why_text */
//! ```
//!
//! The functions are those of this page (`forward`, `frames`, `jacobian`, `inverse`, `inverse_near` and batches, for every task), give the
//! same bits, allocate nothing, and answer a null pointer with an error code. Those with the ending `_with` take the `let` parameters of the
//! table as a struct first; those without are the nominal arm's. The header holds the table, the formulas and what each function promises.
//! `src/c.rs` is the border between the languages, and the only file with `unsafe`: a crate that calls the macro already may take it over.
//!
//! # Without the standard library
//!
//! ```toml
//! dh-robot = { version = "0.1", default-features = false, features = ["libm"] }
//! ```
//!
//! Then square roots and the like come from the crate libm. Sines, cosines and arc tangents of generated code are the
//! crate's own in either case ([`sincos`], [`atan2`]). `tests/no_std` in the repository is such a program.
//!
//! # Speed
//!
//! The kernels are written for the vector units that every processor of the last twenty years has; nothing has to be
//! switched on. `-C target-cpu=native` (or a target with AVX2 and FMA) doubles their speed:
//!
//! | relative to as many calls of the standard library | x86-64 | with AVX2, FMA |
//! |---------------------------------------------------|-------:|---------------:|
//! | sines and cosines of six angles | 0.22 | 0.13 |
//! | sines and cosines of seven angles | 0.26 | 0.12 |
//! | arc tangents of eight vectors | 0.27 | 0.08 |
//!
//! Medians over 41 repetitions of `cargo bench -p dh-robot` on one core of a server processor, random angles.
#![cfg_attr(not(any(test, feature = "std")), no_std)]

// Without one of the features `std` and `libm` the crate dh-kernels refuses to compile, with a message that says so.
mod arm;
pub mod atan2;
mod branch;
mod elementary;
mod follow;
mod free;
mod inverse;
mod joint;
pub mod math;
#[cfg(feature = "rayon")]
mod parallel;
pub mod pose;
mod real;
mod robot;
#[doc(hidden)]
pub mod runtime;
pub mod sincos;
mod solution;
mod solutions;
pub mod velocity;
mod why;

pub use dh_macro::dh_robot;
pub use nalgebra;

pub use arm::{Arm, SolutionView, WrongLength};
pub use atan2::atan2_batch;
pub use branch::{Branch, Elbow, Shoulder, Wrist};
pub use follow::{Follow, Stop, follow};
pub use free::{FreeJoints, FreeJointsIter};
pub use inverse::Work;
pub use joint::{Joint, JointKind};
#[cfg(feature = "rayon")]
pub use parallel::ParallelInverse;
pub use real::Real;
pub use robot::{ForwardKinematics, InverseKinematics, Jacobian, Robot, SolutionList};
pub use sincos::sincos_batch;
pub use solution::Solution;
pub use solutions::Solutions;
pub use why::Why;

/// The programs in the README are compiled and run with the tests of the documentation.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
