//! The Rust backend: from a chain and its programs to the items that `dh_robot!` leaves behind.
//!
//! Items are written as text and lexed once: the text is what a reader of `cargo expand` sees, and the compiler's own lexer is
//! much faster than building tokens one by one in an unoptimised macro. The user's own tokens (attributes, visibility, name) keep
//! their spans.

mod around;
mod batch;
mod batched;
mod candidates;
mod forward;
mod inverse;
#[cfg(feature = "cli")]
mod pretty;
mod structure;
mod stub;
mod target;
mod velocity;
mod verify;

pub use around::implementing;
pub use inverse::inverse;
#[cfg(feature = "cli")]
pub use pretty::pretty;
pub use structure::{Batches, Head, Items, robot};
pub use stub::stub;
