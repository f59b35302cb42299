//! Generates a stub beside the errors of a wrong table: the same type with the same functions, so that one mistake is one error.

use super::structure::{Head, lex};
use proc_macro2::TokenStream;
use quote::quote;

/// The signatures of a robot with `n` joints; fields have names and types; bodies never return.
pub fn stub(
    head: &Head,
    n: usize,
    fields: &[(String, String)],
    scalar: &str,
    target: &str,
    redundant: usize,
) -> TokenStream {
    let (visibility, ident) = (&head.visibility, &head.ident);
    let mut list = TokenStream::new();
    for (name, kind) in fields {
        let (name, kind) = (lex(name), lex(kind));
        list.extend(quote! { pub #name: #kind, });
    }
    let body = if fields.is_empty() {
        quote! { ; }
    } else {
        quote! { { #list } }
    };
    let free = match redundant {
        0 => String::new(),
        1 => format!(", _free: {scalar}"),
        k => format!(", _free: [{scalar}; {k}]"),
    };
    let (each, frees) = (
        target.trim_start_matches('&'),
        match redundant {
            0 => String::new(),
            1 => format!(", _free: &[{scalar}]"),
            k => format!(", _free: &[[{scalar}; {k}]]"),
        },
    );
    let solution = format!("::core::result::Result<::dh_robot::Solution<{scalar}, {n}>, ::dh_robot::Why<{scalar}>>");
    let matrix = format!("::dh_robot::nalgebra::SMatrix<{scalar}, 6, {n}>");
    let iso = format!("::dh_robot::nalgebra::IsometryMatrix3<{scalar}>");
    let functions = lex(&format!(
        "impl {ident} {{\npub const DOF: usize = {n};\npub const MAX_SOLUTIONS: usize = 1;\n\
         pub fn forward(&self, _q: &[{scalar}; {n}]) -> {iso} {{ loop {{}} }}\n\
         pub fn frames(&self, _q: &[{scalar}; {n}]) -> [{iso}; {n}] {{ loop {{}} }}\n\
         pub fn jacobian(&self, _q: &[{scalar}; {n}]) -> {matrix} {{ loop {{}} }}\n\
         pub fn forward_batch(&self, _q: &[[{scalar}; {n}]], _poses: &mut [{iso}]) {{ loop {{}} }}\n\
         pub fn jacobian_batch(&self, _q: &[[{scalar}; {n}]], _jacobians: &mut [{matrix}]) {{ loop {{}} }}\n\
         pub fn jacobian_in_tool(&self, _q: &[{scalar}; {n}]) -> {matrix} {{ loop {{}} }}\n\
         pub fn jacobian_dot(&self, _q: &[{scalar}; {n}], _speeds: &[{scalar}; {n}]) -> {matrix} {{ loop {{}} }}\n\
         pub fn manipulability(&self, _q: &[{scalar}; {n}]) -> {scalar} {{ loop {{}} }}\n\
         pub fn smallest_singular_value(&self, _q: &[{scalar}; {n}]) -> {scalar} {{ loop {{}} }}\n\
         pub fn solve_velocity(&self, _q: &[{scalar}; {n}], _twist: &::dh_robot::nalgebra::Vector6<{scalar}>) -> ::dh_robot::velocity::JointSpeeds<{scalar}, {n}> {{ loop {{}} }}\n\
         pub fn inverse(&self, _target: {target}{free}) -> ::dh_robot::Solutions<{scalar}, {n}, 1> {{ loop {{}} }}\n\
         pub fn inverse_near(&self, _target: {target}{free}, _q: &[{scalar}; {n}]) -> {solution} {{ loop {{}} }}\n\
         pub fn inverse_batch(&self, _targets: &[{each}]{frees}, _solutions: &mut [::dh_robot::Solutions<{scalar}, {n}, 1>]) {{ loop {{}} }}\n\
         pub fn inverse_near_batch(&self, _targets: &[{each}]{frees}, _q: &[[{scalar}; {n}]], _solutions: &mut [{solution}]) {{ loop {{}} }}\n}}\n\
         impl ::core::default::Default for {ident} {{ fn default() -> Self {{ loop {{}} }} }}"
    ));
    quote! {
        #[allow(missing_docs, dead_code)]
        #[derive(Clone, Copy, Debug, PartialEq)]
        #visibility struct #ident #body
        #[allow(missing_docs, dead_code, clippy::all)]
        const _: () = { #functions };
    }
}
