//! The choice of which joint plays which role in the elimination.

use super::super::Blank;

/// How the loop of six joints is cut. There are [`Choice::COUNT`]; structured arms make many of them useless.
///
/// Going round the loop in one direction or the other, from one of the joints on: the first two joints are eliminated linearly, of the
/// next three one is hidden (the determinant is a polynomial in it), one doubles the equations and one is single; the last one
/// doesn't occur.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Choice(u8);

impl Choice {
    /// The number of choices.
    pub const COUNT: u8 = 84;

    /// How many of them eliminate with the dialytic matrix; the others need two parallel neighbours and two neighbours that meet.
    pub(super) const GENERAL: u8 = 72;

    /// The choice with this number, counted modulo [`Choice::COUNT`]. Numbers are stable: generated code holds them.
    pub const fn new(number: u8) -> Self {
        Self(number % Self::COUNT)
    }

    /// Whether it needs the structure of `pairs.rs`.
    pub(super) const fn is_pairs(self) -> bool {
        self.0 >= Self::GENERAL
    }

    /// Its number.
    pub const fn number(self) -> u8 {
        self.0
    }

    /// Whether the loop runs against the order of the joints.
    pub(super) const fn reversed(self) -> bool {
        self.0 % Self::GENERAL >= if self.is_pairs() { 6 } else { 36 }
    }

    /// The joints (counted from 0) in the order of their parts: two linear ones, three others, and the one that drops out.
    pub const fn joints(self) -> [usize; 6] {
        let first = (if self.is_pairs() { self.0 % 6 } else { self.0 % 36 / 6 }) as usize;
        let mut joints = [0; 6];
        let mut i = 0;
        while i < 6 {
            joints[i] = if self.reversed() { (first + 6 - i) % 6 } else { (first + i) % 6 };
            i += 1;
        }
        joints
    }

    /// Of the three middle joints (0, 1, 2): the hidden one, the one that doubles, the single one.
    pub(super) const fn middle(self) -> [usize; 3] {
        match self.0 % 6 {
            0 => [0, 1, 2],
            1 => [0, 2, 1],
            2 => [1, 0, 2],
            3 => [1, 2, 0],
            4 => [2, 0, 1],
            _ => [2, 1, 0],
        }
    }

    /// Whether the determinant has degree 8 for every arm (otherwise it may have degree 12, with roots that belong to no solution).
    ///
    /// The extraneous factor of Raghavan and Roth's determinant is known only for the angle next to the linear ones.
    pub(super) const fn has_least_degree(self) -> bool {
        self.middle()[0] == 0
    }

    /// Whether the choice is possible if these joints are prismatic: the hidden one, the one that doubles and the one that drops out must be revolute.
    pub(super) fn allows(self, prismatic: &[bool; 6]) -> bool {
        let (joints, [hidden, double, _]) = (self.joints(), self.middle());
        ![joints[2 + hidden], joints[2 + double], joints[5]].iter().any(|j| prismatic[*j])
    }

    /// The joint (counted from 0) whose angle is found first.
    pub const fn hidden_joint(self) -> usize {
        self.joints()[if self.is_pairs() { 5 } else { 2 + self.middle()[0] }]
    }
}

impl Blank for Choice {
    const BLANK: Self = Self(0);
}
