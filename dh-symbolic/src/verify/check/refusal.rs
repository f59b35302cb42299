//! Refusals: why a line has no meaning, and at which token.

use super::ratio::Worked;
use crate::verify::language::{NotUnderstood, Place};

/// A result, or the place and the reason for which there is none.
pub(super) type Understood<T> = Result<T, NotUnderstood>;

/// There is no result here, and why.
pub(super) fn refuse<T>(place: &Place, why: impl Into<String>) -> Understood<T> {
    Err(NotUnderstood { place: place.clone(), why: why.into() })
}

/// Puts a place to a trouble of arithmetic.
pub(super) trait At<T> {
    fn at(self, place: &Place) -> Understood<T>;
}

impl<T> At<T> for Worked<T> {
    fn at(self, place: &Place) -> Understood<T> {
        self.or_else(|t| refuse(place, t.why()))
    }
}
