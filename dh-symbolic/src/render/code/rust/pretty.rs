//! Generated items as formatted text: for people, `dh expand` and the expanded examples.

use proc_macro2::TokenStream;

/// Formats items. Doc comments come out line by line.
///
/// # Errors
/// Where the tokens are no items.
pub fn pretty(items: TokenStream) -> syn::Result<String> {
    let mut file: syn::File = syn::parse2(items)?;
    for item in &mut file.items {
        if let syn::Item::Struct(item) = item {
            item.attrs = std::mem::take(&mut item.attrs).into_iter().flat_map(by_line).collect();
        }
    }
    Ok(prettyplease::unparse(&file))
}

/// A doc attribute of several lines becomes one per line: `///` instead of `/** */`.
fn by_line(attribute: syn::Attribute) -> Vec<syn::Attribute> {
    let text = match &attribute.meta {
        syn::Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => text.value(),
            _ => return vec![attribute],
        },
        _ => return vec![attribute],
    };
    let line = |line: &str| {
        let line = if line.is_empty() || line.starts_with(' ') { line.to_string() } else { format!(" {line}") };
        syn::parse_quote!(#[doc = #line])
    };
    text.lines().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn documentation_comes_line_by_line() {
        let items = "#[doc = \" One.\\n\\ntwo\"] struct A;".parse().expect("lexes");
        assert_eq!(pretty(items).expect("items"), "/// One.\n///\n/// two\nstruct A;\n");
        assert!(pretty("1 + 1".parse().expect("lexes")).is_err());
    }
}
