//! The `dh` command.
fn main() {}
