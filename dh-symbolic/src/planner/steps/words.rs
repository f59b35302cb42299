//! The names of the kinds of steps, in every language of the notes.

/// The same words in each language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wording {
    /// English.
    pub english: &'static str,
    /// Chinese, simplified.
    pub chinese: &'static str,
}

/// A formula that a sentence mentions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slot {
    /// The (first) unknown.
    First,
    /// The second unknown.
    Second,
    /// The tangent of half the first unknown.
    HalfTangent,
    /// t = the tangent of half the first unknown.
    NamedHalfTangent,
    /// The greatest number of roots.
    Roots,
}

/// What people call a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words {
    /// The textbook's name, as it follows "from".
    pub name: Wording,
    /// The equation and the number of its solutions, for doc comments; English.
    pub equation: &'static str,
    /// How it is solved, where that is no formula; `{}` takes the slots in turn.
    pub sentence: Option<(Wording, &'static [Slot])>,
    /// Why the formulas follow from the equations, for readers who ask.
    pub why: Option<Wording>,
}

impl Words {
    /// A step that formulas solve.
    pub(super) const fn new(english: &'static str, chinese: &'static str, equation: &'static str) -> Words {
        Words { name: Wording { english, chinese }, equation, sentence: None, why: None }
    }

    /// The same with a reason.
    pub(super) const fn because(self, english: &'static str, chinese: &'static str) -> Words {
        Words { why: Some(Wording { english, chinese }), ..self }
    }

    /// The same with a sentence in the place of formulas.
    pub(super) const fn solved_by(self, english: &'static str, chinese: &'static str, slots: &'static [Slot]) -> Words {
        Words { sentence: Some((Wording { english, chinese }, slots)), ..self }
    }
}
