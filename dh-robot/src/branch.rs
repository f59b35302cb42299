//! The branch of a solution: its configuration (shoulder, elbow, wrist), as robot controllers call it.

use core::fmt;

/// On which side of the arm's way forward the shoulder is (the indicators of Lee and Ziegler, 1984).
///
/// The macro finds out which root is which on sample poses; on arms where they do not tell (the first two axes parallel, say) the names are
/// those of the first root and the second. On an arm of seven axes several roots together may decide the side: then it has no names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Shoulder {
    /// Lefty: facing its wrist, the arm hangs on the left of the waist. "Front" on arms without a shoulder offset: the wrist is ahead of
    /// the waist, where the shoulder is (or the first frame's x axis points).
    Left,
    /// Righty; "back" on arms without a shoulder offset, where the arm reaches over its own shoulder.
    Right,
}

/// On which side of the line from shoulder to wrist the elbow is, on arms whose second and third axes are parallel; above is where z of the
/// table's frame 0 points, wherever `base` puts it. Else first root and second.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Elbow {
    /// The elbow is above the line.
    Up,
    /// The elbow is below the line.
    Down,
}

/// Which of the two ways round the wrist takes: the middle wrist joint bends one way or the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Wrist {
    /// The sine of the middle wrist joint's angle (as the table has it, with its offset) is positive.
    NoFlip,
    /// It is negative.
    Flip,
}

/// Which alternative every step of the solution took: a value to keep, compare and ask for again.
///
/// A branch has up to three names that robot controllers use (shoulder, elbow, wrist; only where the arm has such a
/// thing), and for each of the first eight steps of the solution the number of the alternative taken.
///
/// ```
/// use dh_robot::{Branch, Elbow, Shoulder, Wrist};
///
/// let branch = Branch::ANY.with_shoulder(Shoulder::Right).with_elbow(Elbow::Up).with_wrist(Wrist::Flip);
/// assert_eq!(branch.to_string(), "shoulder right, elbow up, wrist flip");
/// assert!(branch.agrees_with(Branch::ANY.with_elbow(Elbow::Up)));
/// assert!(!branch.agrees_with(Branch::ANY.with_elbow(Elbow::Down)));
/// ```
// Eight fields of five bits (0: not said, k + 1: alternative k), then three fields of two bits (0: not said, 1, 2).
#[repr(transparent)]
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Branch(u64);

const STEP_BITS: u32 = 5;
const STEP_MASK: u64 = 0b11111;
const NAME_MASK: u64 = 0b11;
const SHOULDER_AT: u32 = 40;
const ELBOW_AT: u32 = 42;
const WRIST_AT: u32 = 44;

impl Branch {
    /// Says nothing: every branch agrees with it.
    pub const ANY: Self = Self(0);
    /// How many steps a branch remembers.
    pub const STEPS: usize = 8;
    /// How many alternatives of one step it can tell apart.
    pub const ALTERNATIVES: usize = 31;

    /// The branch with the alternative that a step took, both counted from 0; a step or an alternative that is beyond
    /// [`Branch::STEPS`] or [`Branch::ALTERNATIVES`] is not kept.
    #[inline]
    pub const fn with_step(self, step: usize, alternative: usize) -> Self {
        if step >= Self::STEPS || alternative >= Self::ALTERNATIVES {
            return self;
        }
        let at = STEP_BITS * step as u32;
        Self(self.0 & !(STEP_MASK << at) | (alternative as u64 + 1) << at)
    }

    /// The branch with this shoulder.
    #[inline]
    pub const fn with_shoulder(self, shoulder: Shoulder) -> Self {
        self.with_name(SHOULDER_AT, shoulder as u64)
    }

    /// The branch with this elbow.
    #[inline]
    pub const fn with_elbow(self, elbow: Elbow) -> Self {
        self.with_name(ELBOW_AT, elbow as u64)
    }

    /// The branch with this wrist.
    #[inline]
    pub const fn with_wrist(self, wrist: Wrist) -> Self {
        self.with_name(WRIST_AT, wrist as u64)
    }

    /// The alternative that a step took, from 0; `None` where the step left no choice or is not remembered.
    #[inline]
    pub const fn step(self, step: usize) -> Option<usize> {
        if step >= Self::STEPS {
            return None;
        }
        match self.0 >> (STEP_BITS * step as u32) & STEP_MASK {
            0 => None,
            field => Some(field as usize - 1),
        }
    }

    /// The shoulder, on arms that have this choice.
    #[inline]
    pub const fn shoulder(self) -> Option<Shoulder> {
        match self.name(SHOULDER_AT) {
            1 => Some(Shoulder::Left),
            2 => Some(Shoulder::Right),
            _ => None,
        }
    }

    /// The elbow, on arms that have this choice.
    #[inline]
    pub const fn elbow(self) -> Option<Elbow> {
        match self.name(ELBOW_AT) {
            1 => Some(Elbow::Up),
            2 => Some(Elbow::Down),
            _ => None,
        }
    }

    /// The wrist, on arms that have this choice.
    #[inline]
    pub const fn wrist(self) -> Option<Wrist> {
        match self.name(WRIST_AT) {
            1 => Some(Wrist::NoFlip),
            2 => Some(Wrist::Flip),
            _ => None,
        }
    }

    /// The branch as a number: to be stored, or passed to programs in other languages. 0 is [`Branch::ANY`].
    #[inline]
    pub const fn to_bits(self) -> u64 {
        self.0
    }

    /// The branch of such a number; any other number is some branch too.
    #[inline]
    pub const fn from_bits(bits: u64) -> Self {
        Self(bits)
    }

    /// Whether this branch is as `wanted` says, in everything that `wanted` does say.
    #[inline]
    pub const fn agrees_with(self, wanted: Self) -> bool {
        let mut said = 0;
        let mut step = 0;
        while step < Self::STEPS {
            said |= mask_if_said(wanted.0, STEP_BITS * step as u32, STEP_MASK);
            step += 1;
        }
        said |= mask_if_said(wanted.0, SHOULDER_AT, NAME_MASK);
        said |= mask_if_said(wanted.0, ELBOW_AT, NAME_MASK);
        said |= mask_if_said(wanted.0, WRIST_AT, NAME_MASK);
        self.0 & said == wanted.0
    }

    const fn with_name(self, at: u32, name: u64) -> Self {
        Self(self.0 & !(NAME_MASK << at) | (name + 1) << at)
    }

    const fn name(self, at: u32) -> u64 {
        self.0 >> at & NAME_MASK
    }
}

/// The field's mask where the field says something, else zero.
const fn mask_if_said(fields: u64, at: u32, mask: u64) -> u64 {
    if fields >> at & mask == 0 { 0 } else { mask << at }
}

impl fmt::Display for Shoulder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Left => "shoulder left",
            Self::Right => "shoulder right",
        })
    }
}

impl fmt::Display for Elbow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Up => "elbow up",
            Self::Down => "elbow down",
        })
    }
}

impl fmt::Display for Wrist {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NoFlip => "wrist no flip",
            Self::Flip => "wrist flip",
        })
    }
}

impl fmt::Display for Branch {
    /// The names where there are any (`shoulder right, elbow up, wrist flip`); the alternatives step by step where these are more
    /// (`alternatives 0, 2, 1`, behind a semicolon if there are names); or else `any`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut separator = "";
        let mut names = 0;
        if let Some(shoulder) = self.shoulder() {
            write!(f, "{shoulder}")?;
            (separator, names) = (", ", names + 1);
        }
        if let Some(elbow) = self.elbow() {
            write!(f, "{separator}{elbow}")?;
            (separator, names) = (", ", names + 1);
        }
        if let Some(wrist) = self.wrist() {
            write!(f, "{separator}{wrist}")?;
            names += 1;
        }
        if self.0 == 0 {
            return f.write_str("any");
        }
        if (0..Self::STEPS).filter_map(|step| self.step(step)).count() > names {
            f.write_str(if names > 0 { "; alternatives " } else { "alternatives " })?;
            separator = "";
            for alternative in (0..Self::STEPS).filter_map(|step| self.step(step)) {
                write!(f, "{separator}{alternative}")?;
                separator = ", ";
            }
        }
        Ok(())
    }
}

impl fmt::Debug for Branch {
    /// Names and alternatives: `Branch(elbow up; 0:1 2:0)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Branch({self};")?;
        for step in 0..Self::STEPS {
            if let Some(alternative) = self.step(step) {
                write!(f, " {step}:{alternative}")?;
            }
        }
        f.write_str(")")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_do_not_disturb_each_other() {
        let mut branch = Branch::ANY.with_shoulder(Shoulder::Left).with_elbow(Elbow::Down).with_wrist(Wrist::NoFlip);
        for step in 0..Branch::STEPS {
            branch = branch.with_step(step, (7 * step) % Branch::ALTERNATIVES);
        }
        for step in 0..Branch::STEPS {
            assert_eq!(branch.step(step), Some((7 * step) % Branch::ALTERNATIVES));
        }
        assert_eq!(branch.shoulder(), Some(Shoulder::Left));
        assert_eq!(branch.elbow(), Some(Elbow::Down));
        assert_eq!(branch.wrist(), Some(Wrist::NoFlip));
        assert_eq!(
            branch.to_string(),
            "shoulder left, elbow down, wrist no flip; alternatives 0, 7, 14, 21, 28, 4, 11, 18"
        );
        assert_eq!(branch.with_elbow(Elbow::Up).with_elbow(Elbow::Down), branch);
        assert_eq!(branch.with_step(3, 0).with_step(3, 21), branch);
        assert_eq!(Branch::from_bits(branch.to_bits()), branch);
    }

    #[test]
    fn sixteen_roots_of_one_step_are_told_apart() {
        for root in 0..16 {
            assert_eq!(Branch::ANY.with_step(0, root).step(0), Some(root));
        }
    }

    #[test]
    fn what_does_not_fit_is_not_kept() {
        assert_eq!(Branch::ANY.with_step(8, 0), Branch::ANY);
        assert_eq!(Branch::ANY.with_step(0, 31), Branch::ANY);
        assert_eq!(Branch::ANY.step(8), None);
    }

    #[test]
    fn agreement_looks_only_at_what_is_said() {
        let branch = Branch::ANY.with_elbow(Elbow::Up).with_step(0, 1).with_step(1, 0);
        assert!(branch.agrees_with(Branch::ANY));
        assert!(branch.agrees_with(branch));
        assert!(branch.agrees_with(Branch::ANY.with_step(1, 0)));
        assert!(!branch.agrees_with(Branch::ANY.with_step(1, 1)));
        assert!(!branch.agrees_with(Branch::ANY.with_wrist(Wrist::Flip)));
        assert!(!Branch::ANY.agrees_with(branch));
    }

    #[test]
    fn branches_print_what_they_know() {
        assert_eq!(Branch::ANY.to_string(), "any");
        assert_eq!(Branch::ANY.with_step(0, 0).with_step(3, 12).to_string(), "alternatives 0, 12");
        assert_eq!(Branch::ANY.with_elbow(Elbow::Up).with_step(1, 1).to_string(), "elbow up");
        let more = Branch::ANY.with_elbow(Elbow::Up).with_step(0, 3).with_step(1, 1);
        assert_eq!(more.to_string(), "elbow up; alternatives 3, 1");
        assert_eq!(format!("{:?}", Branch::ANY.with_elbow(Elbow::Up).with_step(1, 1)), "Branch(elbow up; 1:1)");
    }
}
