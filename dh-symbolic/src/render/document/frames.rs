//! Frames, the transforms between them, and decimals, in the notation's style.

use crate::render::formula::math::{Math, Script, Sign};
use crate::render::formula::name::Name;
use crate::render::formula::notation::Notation;
use crate::render::formula::style::Transforms;

/// A frame that a transform leads to or from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::render) enum Frame {
    /// The base, where it is not frame 0.
    Base,
    /// A frame of the table.
    Row(usize),
    /// A frame that a constant motion joins to this one: number of primes.
    Primed(usize, u8),
    /// The tool, where it is not the last frame.
    Tool,
    /// A frame that a constant motion joins to the base.
    PrimedBase(u8),
    /// A frame that a constant motion, or what the task leaves open, joins to the tool.
    PrimedTool(u8),
    /// i - 1.
    Before,
    /// i.
    General,
}

impl Frame {
    /// Another frame beside this one, with so many primes.
    pub(super) fn primed(self, primes: u8) -> Frame {
        match self {
            Frame::Row(n) | Frame::Primed(n, _) => Frame::Primed(n, primes),
            Frame::Base | Frame::PrimedBase(_) => Frame::PrimedBase(primes),
            Frame::Tool | Frame::PrimedTool(_) => Frame::PrimedTool(primes),
            Frame::Before | Frame::General => self,
        }
    }
}

impl Notation {
    /// The name of a frame.
    pub(in crate::render) fn frame(&self, frame: Frame) -> Math {
        let own = |key: &str| {
            let found = self.style.frames.iter().find(|(k, _)| k == key);
            found.map(|(_, name)| Name::of(name).math())
        };
        let row = |n: usize| own(&n.to_string()).unwrap_or_else(|| Math::number(n));
        let primed = |m: Math, primes: u8| {
            let prime = Math::Sign(Sign::Prime);
            m.above(if primes == 1 { prime } else { Math::Row(vec![prime; usize::from(primes)]) })
        };
        match frame {
            Frame::Base => own("b").unwrap_or(Math::Letter('b')),
            Frame::Tool => own("e").unwrap_or(Math::Letter('e')),
            Frame::Row(n) => row(n),
            Frame::Primed(n, primes) => primed(row(n), primes),
            Frame::PrimedBase(primes) => primed(self.frame(Frame::Base), primes),
            Frame::PrimedTool(primes) => primed(self.frame(Frame::Tool), primes),
            Frame::Before => Math::Row(vec![Math::Letter('i'), Math::Sign(Sign::Minus), Math::number(1)]),
            Frame::General => Math::Letter('i'),
        }
    }

    /// The transform between two frames.
    pub(in crate::render) fn transform(&self, from: Frame, to: Frame) -> Math {
        let script = |letter: char, sub: Option<Math>, sup: Option<Math>, before_sub: Option<Math>, before_sup| {
            Math::Script(Box::new(Script { base: Math::Letter(letter), sub, sup, before_sub, before_sup }))
        };
        let (a, b) = (self.frame(from), self.frame(to));
        match self.style.transforms {
            Transforms::Leading => script('T', None, None, Some(b), Some(a)),
            Transforms::Trailing => script('T', Some(b), Some(a), None, None),
            Transforms::Products => match (from, to) {
                (Frame::Before, Frame::General) => script('A', Some(b), None, None, None),
                (Frame::Row(i), Frame::Row(j)) if i + 1 == j => script('A', Some(Math::number(j)), None, None, None),
                (Frame::Row(0), _) => script('T', Some(b), None, None, None),
                _ => script('T', Some(b), None, None, Some(a)),
            },
        }
    }

    /// An angle in radians as a decimal, in the unit of the notation; `places` are those of degrees.
    pub(in crate::render) fn decimal_angle(&self, radians: f64, places: usize) -> Math {
        if self.style.radians {
            return decimal(radians, places + 2);
        }
        Math::Row(vec![decimal(radians.to_degrees(), places), Math::Sign(Sign::Degree)])
    }
}

/// A number with some places, no minus before zero.
pub(in crate::render) fn decimal(x: f64, places: usize) -> Math {
    let text = format!("{x:.places$}");
    let zero = text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
    match text.strip_prefix('-') {
        Some(rest) if zero => Math::number(rest),
        Some(rest) => Math::Row(vec![Math::Sign(Sign::Negative), Math::number(rest)]),
        None => Math::Number(text),
    }
}
