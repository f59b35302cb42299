//! Compiler from Denavit-Hartenberg tables to closed-form kinematics.

pub mod algebra;
pub mod chain;
pub mod diagnostic;
pub mod kinematics;
pub mod planner;
pub mod program;
pub mod render;

/// Expands the body of `dh_robot!`.
pub fn expand(input: proc_macro2::TokenStream) -> proc_macro2::TokenStream {
    chain::table::parse(input).errors.to_compile_errors()
}

#[cfg(test)]
pub(crate) use planner::kernels as ik;
