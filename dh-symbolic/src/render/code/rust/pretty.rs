//! Generated items as formatted text: for people, `dh expand` and the expanded examples.

use super::structure::{Items, lex};

/// The macro whose calls stand for comments while items are tokens, which hold none.
const COMMENT: &str = "comment_line";

/// Formats items. Doc comments come out line by line, and so do the comments of generated statements.
///
/// # Errors
/// If the tokens are not items.
pub fn pretty(items: Items) -> syn::Result<String> {
    let mut tokens = items.declaration;
    let (text, comments) = marked(&items.text);
    tokens.extend(lex(&text));
    let mut file: syn::File = syn::parse2(tokens)?;
    for item in &mut file.items {
        if let syn::Item::Struct(item) = item {
            item.attrs = std::mem::take(&mut item.attrs).into_iter().flat_map(by_line).collect();
        }
    }
    Ok(unmarked(&prettyplease::unparse(&file), &comments))
}

/// Comment lines as statements with their numbers, short enough that no line is broken; and the comments.
fn marked(text: &str) -> (String, Vec<&str>) {
    let (mut out, mut comments) = (String::new(), Vec::new());
    for line in text.lines() {
        match line.strip_prefix("// ") {
            Some(comment) => {
                out.push_str(&format!("{COMMENT}!({});\n", comments.len()));
                comments.push(comment);
            }
            None => out.extend([line, "\n"]),
        }
    }
    (out, comments)
}

/// These statements as comments again.
fn unmarked(text: &str, comments: &[&str]) -> String {
    let comment = |line: &str| -> Option<String> {
        let number = line.trim_start().strip_prefix(COMMENT)?.strip_prefix("!(")?.strip_suffix(");")?;
        let indent = " ".repeat(line.len() - line.trim_start().len());
        Some(format!("{indent}// {}\n", comments.get(number.parse::<usize>().ok()?)?))
    };
    text.lines().map(|line| comment(line).unwrap_or_else(|| format!("{line}\n"))).collect()
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
        let items = |text: &str| Items::of_tokens(text.parse().expect("lexes"));
        let text = pretty(items("#[doc = \" One.\\n\\ntwo\"] struct A;")).expect("items");
        assert_eq!(text, "/// One.\n///\n/// two\nstruct A;\n");
        assert!(pretty(items("1 + 1")).is_err());
    }

    #[test]
    fn comments_stay_where_they_are_and_cost_no_token() {
        let text = "fn f() {\n// q1 from \"a\" \\ b.\nlet x = 1;\n}\n".to_string();
        let items = Items { declaration: proc_macro2::TokenStream::new(), text };
        assert_eq!(items.clone().into_tokens().to_string(), "fn f () { let x = 1 ; }");
        assert_eq!(pretty(items).expect("items"), "fn f() {\n    // q1 from \"a\" \\ b.\n    let x = 1;\n}\n");
    }
}
