//! The `dh_robot!` macro: a thin shell around [`dh_symbolic::expand`].

use proc_macro::TokenStream;

/// Turns a Denavit-Hartenberg table into a robot type; see the crate `dh-robot` for the manual of the table.
#[proc_macro]
pub fn dh_robot(input: TokenStream) -> TokenStream {
    dh_symbolic::expand(input.into()).into()
}
