//! Generates the robot's type with its fields, constants and default, and assembles all items.

use super::around::{self, implementing};
use super::forward;
use crate::chain::{Chain, Role};
use crate::program::{Forward, Inverse};
use crate::render::code::{bound, constant_pose, docs, literal, scalar_name};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// What the user wrote before the table: attributes (docs among them), visibility, name.
#[derive(Clone, Debug)]
pub struct Head {
    /// Attributes in front of the struct.
    pub attributes: TokenStream,
    /// Visibility.
    pub visibility: TokenStream,
    /// Name of the type.
    pub ident: Ident,
    /// Doc comments of the fields: name and lines.
    pub field_docs: Vec<(String, Vec<String>)>,
    /// The table as written: header and rows.
    pub table: Vec<Vec<String>>,
    /// `base` and `tool` as written.
    pub motions: Vec<(String, String)>,
    /// How batches of forward kinematics are computed.
    pub batches: Batches,
}

/// How batches of forward kinematics are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Batches {
    /// By single calls.
    OneByOne,
    /// In vector registers, by the formulas stated once more for packed numbers (feature `simd` of `dh-robot`).
    Packed,
}

/// Lexes generated text. Were it ever not to lex, a compile error says so.
pub(super) fn lex(text: &str) -> TokenStream {
    text.parse().unwrap_or_else(|e: proc_macro2::LexError| {
        let message = format!("dh_robot!: generated code does not lex: {e}");
        quote! { ::core::compile_error!(#message); }
    })
}

/// Generated items: the declaration with the user's own tokens, and the rest as text, in which lines that begin with `//` are comments.
#[derive(Clone, Debug)]
pub struct Items {
    /// The struct and its default.
    pub(super) declaration: TokenStream,
    /// Everything else.
    pub(super) text: String,
}

impl Items {
    /// Items that are tokens already.
    pub fn of_tokens(declaration: TokenStream) -> Items {
        Items { declaration, text: String::new() }
    }

    /// All tokens. Comments are dropped.
    pub fn into_tokens(self) -> TokenStream {
        let mut out = self.declaration;
        out.extend(lex(&self.text));
        out
    }
}

/// All items of a robot. `inverse` is the plan, and the text of further functions and traits that it makes.
pub fn robot(
    head: &Head,
    chain: &Chain,
    programs: &Forward,
    inverse: Option<(&Inverse, &str)>,
    extra_docs: &str,
) -> Items {
    let name = head.ident.to_string();
    let declaration = declaration(head, chain, &docs::table(chain, &head.table, &head.motions, extra_docs));
    let own = implementing(chain, &name);
    // What stands around an arm is put around one pose at a time.
    let batches = if chain.is_part() { Batches::OneByOne } else { head.batches };
    let (n, f) = (chain.dof(), scalar_name(chain.settings.scalar));
    let text = format!(
        "#[allow(unused, clippy::all, clippy::pedantic)]\nimpl {own} {{\n/// Number of joints.\npub const DOF: usize = {n};\n\
         /// Kind, range and name of every joint.\npub const JOINTS: [::dh_robot::Joint<{f}>; {n}] = [{}];\n{}}}\n{}{}",
        joints(chain),
        forward::functions(chain, programs, batches),
        forward::traits(chain, programs, &own, batches),
        inverse.map_or("", |i| i.1)
    );
    let text = if chain.is_part() { around::items(chain, &name, programs, &text, inverse.map(|i| i.0)) } else { text };
    Items { declaration, text }
}

/// The joints, separated by commas.
pub(super) fn joints(chain: &Chain) -> String {
    let joints: Vec<String> = chain.joints.iter().enumerate().map(|(i, j)| joint(chain, i, j)).collect();
    joints.join(", ")
}

/// The struct and its default.
pub(super) fn declaration(head: &Head, chain: &Chain, docs: &str) -> TokenStream {
    let (attributes, visibility, ident) = (&head.attributes, &head.visibility, &head.ident);
    let f = lex(scalar_name(chain.settings.scalar));
    let (mut fields, mut defaults) = (TokenStream::new(), Some(TokenStream::new()));
    let mut any = false;
    for p in &chain.parameters {
        let Role::Field(value) = &p.role else { continue };
        if p.of_point {
            continue;
        }
        any = true;
        let name = lex(&p.name);
        let doc = docs::field(chain, p);
        let written = head.field_docs.iter().filter(|d| d.0 == p.name).flat_map(|d| &d.1);
        fields.extend(quote! { #(#[doc = #written])* #[doc = #doc] pub #name: #f, });
        match (value, &mut defaults) {
            (Some(_), Some(list)) => {
                let value = lex(&literal(chain.nominal(p.handle), chain.settings.scalar));
                list.extend(quote! { #name: #value, });
            }
            _ => defaults = None,
        }
    }
    for pose in &chain.poses {
        any = true;
        let (name, doc) = (lex(&pose.name), docs::pose(chain, pose));
        let written = head.field_docs.iter().filter(|d| d.0 == pose.name).flat_map(|d| &d.1);
        fields.extend(
            quote! { #(#[doc = #written])* #[doc = #doc] pub #name: ::dh_robot::nalgebra::IsometryMatrix3<#f>, },
        );
        match (&pose.nominal, &mut defaults) {
            (Some(value), Some(list)) => {
                let value = lex(&constant_pose(chain, value));
                list.extend(quote! { #name: #value, });
            }
            _ => defaults = None,
        }
    }
    let body = if any {
        quote! { { #fields } }
    } else {
        quote! { ; }
    };
    let mut out = quote! {
        #attributes
        #[doc = #docs]
        #[derive(Clone, Copy, Debug, PartialEq)]
        #visibility struct #ident #body
    };
    if let Some(list) = defaults {
        let value = if any {
            quote! { #ident { #list } }
        } else {
            quote! { #ident }
        };
        out.extend(quote! {
            impl ::core::default::Default for #ident {
                fn default() -> Self { #value }
            }
        });
    }
    out
}

fn joint(chain: &Chain, actuator: usize, joint: &crate::chain::Joint) -> String {
    let kind = if chain.is_periodic(actuator) { "revolute" } else { "prismatic" };
    let range = joint.range.as_ref().map_or(String::new(), |(lo, hi)| {
        format!(
            ".with_range({}, {})",
            literal(bound(lo), chain.settings.scalar),
            literal(bound(hi), chain.settings.scalar)
        )
    });
    let label = joint.label.as_ref().map_or(String::new(), |text| format!(".with_label({text:?})"));
    format!("::dh_robot::Joint::{kind}(\"{}\"){range}{label}", joint.name)
}
