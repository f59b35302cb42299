//! Lengths that look like millimetres although the table does not say its unit.

use super::statements::Let;
use crate::diagnostic::{Error, Errors, Place};
use proc_macro2::TokenTree;

/// Where the longest bare length is at least this and the shortest at least `SHORTEST`, nobody meant metres.
const LONGEST: f64 = 100.0;
const SHORTEST: f64 = 1.0;

/// A cell that is one number without a unit, and where it stands.
pub(super) fn bare(tokens: &[TokenTree], place: Place) -> Option<(f64, Place)> {
    let number = match tokens {
        [TokenTree::Literal(number)] => number,
        [TokenTree::Punct(sign), TokenTree::Literal(number)] if sign.as_char() == '-' => number,
        _ => return None,
    };
    let size = number.to_string().replace('_', "").parse::<f64>().ok()?.abs();
    (size > 0.0).then_some((size, place))
}

/// Asks for the unit of a table that has none, where its lengths would be those of a bridge.
pub(super) fn check(cells: &[(f64, Place)], lets: &[Let], errors: &mut Errors) {
    let values = lets.iter().filter_map(|line| {
        let lengthy = line.kind.as_ref().is_some_and(|kind| kind.text == "length");
        bare(line.value.as_deref().filter(|_| lengthy)?, line.place)
    });
    let all: Vec<(f64, Place)> = cells.iter().copied().chain(values).collect();
    let shortest = all.iter().map(|x| x.0).fold(f64::INFINITY, f64::min);
    let Some((size, place)) = all.into_iter().max_by(|x, y| x.0.total_cmp(&y.0)) else { return };
    if size >= LONGEST && shortest >= SHORTEST {
        let error = Error::new(place, format!("is this a length of {size} metres? The table does not say its unit"));
        errors.push(error.help("write `unit = mm;`, or `unit = m;` if it is"));
    }
}
