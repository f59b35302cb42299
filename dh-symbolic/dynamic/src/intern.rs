//! Names and joints that live as long as the program: each different one is kept once, since solutions refer to them.

use std::sync::{Mutex, PoisonError};

use dh_robot::Joint;

static NAMES: Mutex<Vec<&'static str>> = Mutex::new(Vec::new());
static JOINTS: Mutex<Vec<&'static [Joint]>> = Mutex::new(Vec::new());

/// The name, for good.
pub(crate) fn name(text: &str) -> &'static str {
    let mut names = NAMES.lock().unwrap_or_else(PoisonError::into_inner);
    match names.iter().find(|known| **known == text) {
        Some(known) => known,
        None => {
            let new: &'static str = Box::leak(text.to_string().into_boxed_str());
            names.push(new);
            new
        }
    }
}

/// The joints, for good.
pub(crate) fn joints(list: &[Joint]) -> &'static [Joint] {
    let mut all = JOINTS.lock().unwrap_or_else(PoisonError::into_inner);
    match all.iter().find(|known| **known == list) {
        Some(known) => known,
        None => {
            let new: &'static [Joint] = Box::leak(list.to_vec().into_boxed_slice());
            all.push(new);
            new
        }
    }
}
