//! What the worker of the page calls: it writes a question into the module's memory, asks, and reads the answer there.
//!
//! No binding generator: three functions of numbers are all that passes the border, and the build needs no tool beyond the compiler.
//! The attribute `no_mangle` counts as unsafe because it claims a name of the whole program; nothing else here is.
#![allow(unsafe_code)]

use std::cell::RefCell;

thread_local! {
    /// Question and answer, where the page finds them until the next call.
    static QUESTION: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Room for a question of so many bytes: its address in memory.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn dh_question(length: usize) -> *mut u8 {
    QUESTION.with_borrow_mut(|question| {
        question.clear();
        question.resize(length, 0);
        question.as_mut_ptr()
    })
}

/// Answers the question that was written there: the address of the answer.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn dh_answer() -> *const u8 {
    let question = QUESTION.take();
    ANSWER.with_borrow_mut(|answer| {
        *answer = crate::answer(&String::from_utf8_lossy(&question));
        answer.as_ptr()
    })
}

/// Bytes of the last answer.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn dh_answer_length() -> usize {
    ANSWER.with_borrow(String::len)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_question_passes_through_memory() {
        let question = br#"{"ask":"version"}"#;
        let room = dh_question(question.len());
        // SAFETY: the room is as long as was asked for, and nobody else writes there.
        unsafe { std::ptr::copy_nonoverlapping(question.as_ptr(), room, question.len()) };
        let at = dh_answer();
        // SAFETY: the answer stays where it is until the next question.
        let bytes = unsafe { std::slice::from_raw_parts(at, dh_answer_length()) };
        assert!(std::str::from_utf8(bytes).expect("UTF-8").contains(env!("CARGO_PKG_VERSION")));
    }
}
