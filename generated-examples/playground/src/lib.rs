//! What the playground's page asks the compiler: a question about a table comes in as JSON, the answer goes out as JSON.
//!
//! All of it is `dh_symbolic::Robot`; the page shows what it answers. Plain functions of text, so that they are tested like any others;
//! `exports` hands them to WebAssembly.
//!
//! **Never here:** formulas, plans, code of its own.

mod answers;
mod exports;
mod sections;

pub use answers::answer;
