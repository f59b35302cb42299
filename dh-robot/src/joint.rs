//! Joints: revolute or prismatic, their range, and the normalisation of their angles.

use crate::Real;
use crate::math::{ceil, round, wrap_angle};

/// How a joint moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JointKind {
    /// The joint turns; its variable is an angle in radians, and a whole turn changes nothing.
    Revolute,
    /// The joint slides; its variable is a length in the unit of the table. So counts also the variable of a coupled drive of
    /// which a whole turn is not a whole turn of every row it moves: taking turns off would move the arm. Inverses count
    /// motor values that differ by whole turns of rows as one solution, and give those within the ranges.
    Prismatic,
}

/// One joint variable of a robot: its name in the table, its kind and its range.
///
/// ```
/// use dh_robot::{Joint, JointKind};
///
/// const ELBOW: Joint = Joint::revolute("q3").with_range(-0.8, 3.9);
/// assert_eq!(ELBOW.kind, JointKind::Revolute);
/// assert!(ELBOW.contains(3.5) && !ELBOW.contains(-1.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint<T = f64> {
    /// The variable's name, as in the table: `q3`.
    pub name: &'static str,
    /// What column `joint` of the table calls the row: `shoulder`; empty where it holds a number or nothing.
    pub label: &'static str,
    /// Whether it turns or slides.
    pub kind: JointKind,
    /// Smallest and largest value, in radians or in the table's unit of length; `None` where the table gives none.
    pub range: Option<(T, T)>,
}

impl<T> Joint<T> {
    /// A turning joint without limits.
    pub const fn revolute(name: &'static str) -> Self {
        Self { name, label: "", kind: JointKind::Revolute, range: None }
    }

    /// A sliding joint without limits.
    pub const fn prismatic(name: &'static str) -> Self {
        Self { name, label: "", kind: JointKind::Prismatic, range: None }
    }
}

impl<T: Copy> Joint<T> {
    /// The same joint with a range, both ends included.
    pub const fn with_range(self, least: T, greatest: T) -> Self {
        Self { name: self.name, label: self.label, kind: self.kind, range: Some((least, greatest)) }
    }

    /// The same joint with another label.
    pub const fn with_label(self, label: &'static str) -> Self {
        Self { name: self.name, label, kind: self.kind, range: self.range }
    }
}

impl<T: Real> Joint<T> {
    /// Whether the joint turns.
    #[inline]
    pub fn is_revolute(&self) -> bool {
        self.kind == JointKind::Revolute
    }

    /// Whether `value` is in the range, as it stands: whole turns are not taken off. Without a range every number is.
    ///
    /// A value beyond a limit by no more than [`Real::RANGE_TOLERANCE`] counts as inside: see [`Joint::clamp`].
    #[inline]
    pub fn contains(&self, value: T) -> bool {
        match self.range {
            Some((least, greatest)) => value >= least - T::RANGE_TOLERANCE && value <= greatest + T::RANGE_TOLERANCE,
            None => value.is_finite(),
        }
    }

    /// Puts a value that is beyond a limit on that limit.
    #[inline]
    pub fn clamp(&self, value: T) -> T {
        match self.range {
            Some((least, _)) if value < least => least,
            Some((_, greatest)) if value > greatest => greatest,
            _ => value,
        }
    }

    /// The value of a joint as solutions give it: an angle in `(-pi, pi]`, or, where that is out of range and a whole
    /// number of turns brings it in, the nearest such angle. A length is returned as it is.
    ///
    /// ```
    /// use dh_robot::Joint;
    /// use core::f64::consts::PI;
    ///
    /// let third = Joint::revolute("q3").with_range(-0.25 * PI, 1.25 * PI);
    /// assert_eq!(third.normalize(-0.875 * PI), 1.125 * PI); // a turn more is in range
    /// assert_eq!(third.normalize(-0.5 * PI), -0.5 * PI); // nothing fits: it stays, out of range
    /// assert_eq!(third.normalize(2.5 * PI), 0.5 * PI);
    /// ```
    #[inline]
    pub fn normalize(&self, value: T) -> T {
        if !self.is_revolute() {
            return value;
        }
        let angle = wrap_angle(value);
        match self.range {
            Some((least, greatest)) => shift_into(angle, least, greatest).unwrap_or(angle),
            None => angle,
        }
    }

    /// The angle that differs from `value` by whole turns, is in range and comes nearest to `reference`; `value` itself
    /// where no such angle is in range, and for a sliding joint.
    #[inline]
    pub fn nearest_to(&self, reference: T, value: T) -> T {
        if !self.is_revolute() {
            return value;
        }
        let near = value + T::TAU * round((reference - value) / T::TAU);
        match self.range {
            Some((least, greatest)) => shift_into(near, least, greatest).unwrap_or(value),
            None => near,
        }
    }

    /// How far the joint has to move from `a` to `b`: a turning joint takes the shorter way round, at most pi.
    #[inline]
    pub fn difference(&self, a: T, b: T) -> T {
        if self.is_revolute() { wrap_angle(b - a).abs() } else { (b - a).abs() }
    }
}

/// `angle` plus the fewest whole turns that bring it between the limits; `None` where none does.
#[inline]
fn shift_into<T: Real>(angle: T, least: T, greatest: T) -> Option<T> {
    let (least, greatest) = (least - T::RANGE_TOLERANCE, greatest + T::RANGE_TOLERANCE);
    let shifted = if angle < least {
        angle + T::TAU * ceil((least - angle) / T::TAU)
    } else if angle > greatest {
        angle - T::TAU * ceil((angle - greatest) / T::TAU)
    } else {
        return Some(angle);
    };
    (shifted >= least && shifted <= greatest).then_some(shifted)
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI, TAU};

    use super::*;

    const FREE: Joint = Joint::revolute("q1");
    const SHIFTED: Joint = Joint::revolute("q2").with_range(100.0 * PI / 180.0, 400.0 * PI / 180.0);
    const JOINTS: [Joint; 2] = [FREE, SHIFTED];
    const SINGLE: Joint<f32> = Joint::prismatic("q1").with_range(0.0, 0.2);

    fn degrees(angle: f64) -> f64 {
        angle * 180.0 / PI
    }

    #[test]
    fn joints_are_constants() {
        assert_eq!(JOINTS[1].name, "q2");
        assert_eq!(SINGLE.range, Some((0.0, 0.2)));
    }

    #[test]
    fn whole_turns_go_into_the_range() {
        for (given, expected) in
            [(100.0, 100.0), (180.0, 180.0), (-179.0, 181.0), (0.0, 360.0), (40.0, 400.0), (41.0, 41.0), (99.0, 99.0)]
        {
            let got = degrees(SHIFTED.normalize(given * PI / 180.0));
            assert!((got - expected).abs() < 1e-9, "{given}: {got} instead of {expected}");
        }
    }

    #[test]
    fn a_range_below_the_principal_angles_is_reached_downwards() {
        let joint = Joint::revolute("q").with_range(-5.0 * PI, -4.0 * PI);
        assert!((joint.normalize(-FRAC_PI_2) - (-4.5 * PI)).abs() < 1e-12);
        assert_eq!(joint.normalize(FRAC_PI_2), FRAC_PI_2);
    }

    #[test]
    fn a_range_of_more_than_a_turn_keeps_the_principal_angle() {
        let joint = Joint::revolute("q6").with_range(-400.0 * PI / 180.0, 400.0 * PI / 180.0);
        assert_eq!(joint.normalize(3.0), 3.0);
        assert!((joint.normalize(3.5) - (3.5 - TAU)).abs() < 1e-15);
    }

    #[test]
    fn half_a_turn_is_positive_unless_the_range_forbids_it() {
        assert_eq!(FREE.normalize(-PI), PI);
        let left = Joint::revolute("q").with_range(-PI, 0.0);
        assert_eq!(left.normalize(PI), -PI);
    }

    #[test]
    fn round_off_at_a_limit_is_inside_and_clamped() {
        let joint = Joint::revolute("q").with_range(-1.0, 1.0);
        let beyond = 1.0 + 1e-12;
        assert!(joint.contains(beyond) && joint.clamp(beyond) == 1.0);
        assert!(!joint.contains(1.0 + 1e-6));
        assert!(!joint.contains(f64::NAN) && !FREE.contains(f64::NAN));
    }

    #[test]
    fn nearest_respects_the_range() {
        let joint = Joint::revolute("q6").with_range(-266.0 * PI / 180.0, 266.0 * PI / 180.0);
        // From 200 degrees to 190: not to -170, although both are in range.
        let got = joint.nearest_to(200.0 * PI / 180.0, -170.0 * PI / 180.0);
        assert!((degrees(got) - 190.0).abs() < 1e-9, "{}", degrees(got));
        // From 260 degrees to 270: out of range, so a turn less.
        let got = joint.nearest_to(260.0 * PI / 180.0, -90.0 * PI / 180.0);
        assert!((degrees(got) + 90.0).abs() < 1e-9, "{}", degrees(got));
        assert_eq!(SINGLE.nearest_to(0.1, 0.15), 0.15);
    }

    #[test]
    fn difference_takes_the_shorter_way_round() {
        assert!((FREE.difference(3.0, -3.0) - (TAU - 6.0)).abs() < 1e-15);
        assert_eq!(Joint::prismatic("q").difference(3.0, -3.0), 6.0);
    }

    #[test]
    fn backwards_or_undefined_ranges_do_no_harm() {
        let backwards: Joint = Joint::revolute("q").with_range(1.0, -1.0);
        assert!(!backwards.contains(0.0));
        assert!(backwards.normalize(0.0).is_finite());
        let undefined: Joint = Joint::revolute("q").with_range(f64::NAN, f64::NAN);
        assert_eq!(undefined.normalize(0.5), 0.5);
    }
}
