//! All integration tests in one binary, so that there is one link.

mod agreement;
mod claims;
mod fixtures;
mod random;
mod robots;
mod soup;
mod ui;
