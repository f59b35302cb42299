//! Writing it down: code and notes.
//!
//! **In:** chains, plans, programs, documents. **Out:** text and tokens.
//!
//! **Never here:** decisions about kinematics.

pub mod errata;
pub mod rust;
pub mod verdict;
