//! Splits a chain into blocks of consecutive joints with parallel axes.
//!
//! Inside a block turns add up (the textbook's theta2 + theta3), shifts are plain vectors turned by partial sums, and sliding
//! joints along the common direction change nothing. Between blocks stands a constant turn. Cutting here is what makes
//! c23 appear without any rule, and what low operation counts rest on.

use crate::algebra::{Angle, LinearAngle, Poly, Rational};
use crate::chain::{Chain, Coordinate, Elementary};

/// A stretch of the chain with one axis direction: z of the block's frame.
#[derive(Clone, Debug, Default)]
pub struct Segment {
    /// Shifts, in order from base to tip.
    pub pieces: Vec<Piece>,
    /// Joints of the block, in order.
    pub joints: Vec<BlockJoint>,
    /// Link frames that end inside the block.
    pub frames: Vec<FrameMark>,
    /// Sum of all turns of the block.
    pub turn: AngleSum,
    /// Constant turns after the block, into the next block's frame (or the tool's).
    pub exit: Vec<Elementary>,
}

/// An angle sum with a `Default` of zero and like terms collected.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AngleSum(pub LinearAngle);

impl Default for AngleSum {
    fn default() -> AngleSum {
        AngleSum(LinearAngle::constant(Angle::ZERO))
    }
}

impl AngleSum {
    /// Adds `sign` times an angle.
    fn add(&mut self, angle: &LinearAngle, sign: i8) {
        for (v, k) in &angle.terms {
            match self.0.terms.iter_mut().find(|t| t.0 == *v) {
                Some(t) => t.1 += k * sign,
                None => self.0.terms.push((*v, k * sign)),
            }
        }
        self.0.terms.retain(|t| t.1 != 0);
        self.0.constant = self.0.constant.plus(&angle.constant.times(&Rational::int(i64::from(sign))));
    }
}

/// A shift inside a block: the vector `v`, turned by `turn` about the block's z.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Turn about z before the shift.
    pub turn: AngleSum,
    /// The shift.
    pub v: [Poly; 3],
}

/// A joint of a block.
#[derive(Clone, Debug)]
pub struct BlockJoint {
    /// Index of the joint.
    pub joint: usize,
    /// Whether it is revolute (or prismatic).
    pub revolute: bool,
    /// Whether its axis is opposite to the block's z (after an odd number of half turns about x).
    pub opposite: bool,
    /// Number of pieces before it.
    pub pieces: usize,
}

/// A link frame inside a block.
#[derive(Clone, Debug)]
pub struct FrameMark {
    /// Row, counted from 0.
    pub row: usize,
    /// Number of pieces before it.
    pub pieces: usize,
    /// Turn about the block's z so far.
    pub turn: AngleSum,
    /// Constant turns after that.
    pub exit: Vec<Elementary>,
}

/// Cuts a chain, base and tool included, into blocks.
pub fn blocks(chain: &Chain) -> Vec<Segment> {
    let mut cutter = Cutter { done: Vec::new(), now: Segment::default(), half_turn: false };
    for e in &chain.base {
        cutter.step(e, None);
    }
    for (row, link) in chain.links.iter().enumerate() {
        for e in chain.link_factors(row) {
            let moving = link.joint.filter(|j| {
                matches!(
                    (&e, chain.joints[*j].coordinate),
                    (Elementary::Rotate(2, _), Coordinate::Angle(_))
                        | (Elementary::Translate(2, _), Coordinate::Length(_))
                )
            });
            cutter.step(&e, moving);
        }
        cutter.mark(row);
    }
    for e in &chain.tool {
        cutter.step(e, None);
    }
    if cutter.half_turn {
        cutter.now.exit.insert(0, half_turn());
    }
    cutter.done.push(cutter.now);
    cutter.done
}

struct Cutter {
    done: Vec<Segment>,
    now: Segment,
    /// An odd number of half turns about x is pending.
    half_turn: bool,
}

fn half_turn() -> Elementary {
    Elementary::Rotate(0, LinearAngle::constant(Angle::half_turns(Rational::ONE)))
}

impl Cutter {
    fn step(&mut self, e: &Elementary, joint: Option<usize>) {
        if e.is_identity() && joint.is_none() {
            return;
        }
        // A turn about z, or any shift, after a constant turn begins a new block.
        let merges = match (e, self.now.exit.last()) {
            (Elementary::Rotate(axis, _), Some(Elementary::Rotate(last, _))) => axis == last,
            _ => false,
        };
        let constant_turn = matches!(e, Elementary::Rotate(axis, _) if *axis != 2);
        let continues = constant_turn && merges;
        if !self.now.exit.is_empty() && !continues {
            let mut finished = std::mem::take(&mut self.now);
            if self.half_turn {
                finished.exit.insert(0, half_turn());
                self.half_turn = false;
                Self::join(&mut finished.exit);
            }
            finished.exit.retain(|x| !x.is_identity());
            if finished.exit.is_empty() {
                self.now = finished;
            } else if finished.exit.len() == 1 && finished.exit[0] == half_turn() {
                finished.exit.clear();
                self.half_turn = true;
                self.now = finished;
            } else {
                self.done.push(finished);
            }
        }
        let sign: i8 = if self.half_turn { -1 } else { 1 };
        let signed = |p: &Poly| if sign < 0 { -p } else { p.clone() };
        match e {
            Elementary::Rotate(2, angle) => {
                if let Some(joint) = joint {
                    self.joint(joint, true);
                }
                self.now.turn.add(angle, sign);
            }
            Elementary::Rotate(axis, angle) => match self.now.exit.last_mut() {
                Some(Elementary::Rotate(_, sum)) if merges => {
                    let mut w = AngleSum(sum.clone());
                    w.add(angle, 1);
                    *sum = reduce(w.0);
                }
                _ => {
                    let exit = Elementary::Rotate(*axis, reduce(angle.clone()));
                    if exit == half_turn() {
                        self.half_turn = !self.half_turn;
                    } else if !exit.is_identity() {
                        self.now.exit.push(exit);
                    }
                }
            },
            Elementary::Translate(axis, length) => {
                if let Some(joint) = joint {
                    self.joint(joint, false);
                }
                let mut v = [Poly::zero(), Poly::zero(), Poly::zero()];
                v[*axis] = if *axis == 0 { length.clone() } else { signed(length) };
                self.now.pieces.push(Piece { turn: self.now.turn.clone(), v });
            }
        }
    }

    fn join(exit: &mut Vec<Elementary>) {
        if let [Elementary::Rotate(0, a), Elementary::Rotate(0, b), ..] = exit.as_slice() {
            let mut w = AngleSum(a.clone());
            w.add(b, 1);
            exit[1] = Elementary::Rotate(0, reduce(w.0));
            exit.remove(0);
        }
    }

    fn joint(&mut self, joint: usize, revolute: bool) {
        self.now.joints.push(BlockJoint { joint, revolute, opposite: self.half_turn, pieces: self.now.pieces.len() });
    }

    fn mark(&mut self, row: usize) {
        let mut exit = self.now.exit.clone();
        if self.half_turn {
            exit.insert(0, half_turn());
        }
        self.now.frames.push(FrameMark { row, pieces: self.now.pieces.len(), turn: self.now.turn.clone(), exit });
    }
}

/// A constant turn without whole turns.
fn reduce(mut angle: LinearAngle) -> LinearAngle {
    if angle.terms.is_empty() {
        let turns = angle.constant.times(&Rational::HALF);
        angle.constant = angle.constant.plus(&Angle::half_turns(&turns.factor().floor() * &Rational::int(-2)));
    }
    angle
}
