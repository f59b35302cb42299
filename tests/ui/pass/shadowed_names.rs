//! Names of the user's that generated code must not trip over: variants `Ok` and `None` in scope, fields called like its variables.
#![deny(missing_docs, unsafe_code, warnings)]

/// A user's own states.
#[derive(Clone, Copy, Debug)]
pub enum State {
    /// Fine.
    Ok,
    /// Broken.
    Err,
    /// Unknown.
    None,
    /// Known.
    Some,
}

use State::*;

/// A user's own list.
#[derive(Clone, Copy, Debug)]
pub struct Vec;
/// A user's own choice.
#[derive(Clone, Copy, Debug)]
pub struct Option;

dh_robot::dh_robot! {
    /// A wrist behind gears.
    pub struct Geared;

    convention = standard;
    /// Coefficient.
    let target: length = 0.5;
    /// Length.
    let t: length = 0.4;
    /// Angle.
    let c23: angle = 10deg;

    | theta      | d   | a | alpha | range            |
    | q1 + c23   | 0.3 | t | 90deg | -100deg..=300deg |
    | target*q2  | 0   | t | 0     | -                |
    | q3 + 2*q2  | 0   | t | 0     | -                |
}

dh_robot::dh_robot! {
    /// Beside it.
    pub struct Wrist;

    convention = standard;
    /// Length.
    let found: length = 0.4;
    /// Length.
    let self_: length = 0.3;
    /// Length.
    let r0: length = 0.1;

    | theta | d     | a      | alpha  |
    | q1    | self_ | r0 | -90deg |
    | q2    | 0     | found  | 0      |
    | q3    | 0     | 0      | -90deg |
    | q4    | found | 0      | 90deg  |
    | q5    | 0     | 0      | -90deg |
    | q6    | 0     | 0      | 0      |
}

fn main() {
    let _ = ([Ok, Err, None, Some], Vec, Option);
    let arm = Wrist::default();
    assert!(!arm.inverse(&arm.forward(&[0.3; 6])).is_empty());
    let arm = Geared { target: 0.7, ..Geared::default() };
    assert!(!arm.inverse(&arm.forward(&[0.3; 3])).is_empty());

    // In a function body, too.
    dh_robot::dh_robot! {
        struct Local;

        convention = modified;

        | alpha | a   | d | theta |
        | 0     | 0   | 0 | q1    |
        | 0     | 0.4 | 0 | q2    |
    }
    assert!(!Local.inverse(&Local.forward(&[0.3; 2])).is_empty());
}
