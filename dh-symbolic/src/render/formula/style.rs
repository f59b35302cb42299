//! Choices of notation: sines short or written out, transforms with indices before or behind, degrees or radians, names.

/// How formulas are written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Style {
    /// cos(theta2 + theta3) instead of c23?
    pub long_sines: bool,
    /// Names of transforms.
    pub transforms: Transforms,
    /// Exact angles as multiples of pi, decimal ones in radians, instead of degrees?
    pub radians: bool,
    /// What turning joints are called: `q` makes q1, q2, ...; `None`: theta.
    pub joints: Option<String>,
    /// Names of frames: the number of a row, `b` for the base or `e` for the tool, and what to call it.
    pub frames: Vec<(String, String)>,
    /// Letters that mean something else in the same note.
    pub taken: Vec<char>,
}

/// How the transform from frame i to frame j is called.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Transforms {
    /// T with i above and j below on its left (Craig).
    #[default]
    Leading,
    /// T with j below and i above on its right.
    Trailing,
    /// Products of A's: A_j for a row, T_j for the product from the base, i above on the left elsewhere (Paul).
    Products,
}
