//! Shared helpers of the integration tests.

pub mod compare;
pub mod engine;
pub mod naive;
pub mod sample;
