//! Formulas as plain text: indices as Unicode subscripts, matrices with drawn brackets and aligned columns.

mod inline;
pub(in crate::render) mod picture;

use super::math::Math;
pub use inline::math;
use picture::picture;

/// A formula with its matrices drawn, on several lines.
pub fn display(m: &Math) -> String {
    picture(m).lines.iter().map(|l| format!("{}\n", l.trim_end())).collect()
}

/// Columns that a line takes; Chinese and other full-width letters take two.
pub(in crate::render) fn width(line: &str) -> usize {
    line.chars().map(columns).sum()
}

pub(in crate::render) fn columns(c: char) -> usize {
    match u32::from(c) {
        0x1100..=0x115f | 0x2e80..=0xa4cf | 0xac00..=0xd7a3 | 0xf900..=0xfaff | 0xfe30..=0xfe4f | 0xff00..=0xff60 => 2,
        _ => 1,
    }
}
