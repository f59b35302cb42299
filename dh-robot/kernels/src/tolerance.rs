//! The tolerances that several kernels share, each with its reason.
//!
//! All of them are relative: to the size of the coefficients of an equation, or to the length scale of the arm. Absolute
//! sizes ("this coefficient counts as zero") are arguments of the kernels, because only the caller knows the scale.

/// Relative size below which a computed coefficient is taken for rounding noise, for callers that need an argument `tol`:
/// multiply it by the size of the terms that made the coefficient. About 4000 units in the last place: products of
/// six transforms lose ten or twenty, a badly scaled tool some hundred.
pub const ZERO: f64 = 1e-12;

/// How far (relative) a right-hand side may exceed the amplitude of `a cos t + b sin t` and still count as touching:
/// an arm stretched out to the boundary of its workspace, whose target was rounded. A false solution of this size misses
/// the pose by about this much times the length scale, and is then moved onto the target or rejected by forward kinematics.
pub const BOUNDARY: f64 = 1e-9;

/// Two solutions whose discriminant is below this (relative) are one: the square root of a rounding error. They
/// differ by 2e-7 rad at most.
pub const DOUBLE: f64 = 1e-14;

/// Two solutions whose discriminant is below this (relative) are nearly one: they differ by 2e-4 rad at most, and are good to 1e-12
/// only, which the next steps may see.
pub const GRAZING: f64 = 1e-8;

/// Relative size of an extremum of a trigonometric polynomial that counts as touching zero. Coefficients that come out of a few
/// multiplications are good to 1e-14; the rest is kept for the steps before. Touching where there is no root costs a rejected candidate.
pub const TOUCH: f64 = 1e-10;

/// Ratio of the singular values of a system below which its second equation counts as a copy of the first.
pub const RANK: f64 = 1e-9;

/// Residual (relative) at which overdetermined equations contradict each other beyond doubt: the branch that
/// led to them has no solution. Generous, because a wrong candidate costs one forward kinematics and a lost one is lost.
pub const CONTRADICTION: f64 = 1e-3;

/// Absolute size of the coefficients (rotation entries, lengths over the length scale) of an equation below which a contradiction says
/// nothing: a root of multiplicity four in a step before is good to the fourth root of rounding, and what vanishes there is as large
/// as this. The unknown counts as free then, and forward kinematics has the last word.
pub const BLUR: f64 = 1e-4;

/// Residual (relative to the largest coefficient) at which a polished solution of two equations counts as one. Generous,
/// for targets that lie on the boundary up to rounding; forward kinematics has the last word.
pub const ACCEPT: f64 = 1e-8;

/// Residual at which polishing stops early: position over the length scale, and radians.
pub const POLISHED: f64 = 1e-15;

/// Largest residual of a solution after polishing (position over the length scale, and radians): the noise of forward kinematics in
/// `f64` is a hundred times smaller, a false branch a million times larger.
pub const REACHED: f64 = 1e-10;

/// Residual (position over the length scale, and radians) that says nothing: rounding of forward kinematics. Half-way between two solutions near a
/// double root the target is missed by the square of their distance, more than this unless they are nearer than [`SAME`].
pub const BLURRED: f64 = 1e-14;

/// Joint vectors that differ by less than this in every joint (rad) are the same solution.
pub const SAME: f64 = 1e-6;

/// Joint vectors that differ by more than this (rad) are never the same solution, even if they end at the same root of high order.
pub const NEAR: f64 = 0.05;

/// Singular values of the slopes well below this belong to the direction in which a root of high order is flat: 1e-3 from a double root
/// they are as large. The others are a hundred times larger on arms that anybody builds.
pub const VALLEY: f64 = 3e-4;
