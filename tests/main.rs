//! All integration tests in one binary, so that there is one link.

mod agreement;
mod arms;
mod browser;
mod choice;
mod claims;
mod closure;
mod corners;
mod coupled;
mod determinism;
mod digits;
mod fixtures;
mod fresh;
mod javascript;
mod lanes;
mod library;
mod mixed;
mod oracle;
mod papers;
mod random;
mod robots;
mod single;
mod soup;
mod spare;
mod special;
mod tidy;
mod ui;
