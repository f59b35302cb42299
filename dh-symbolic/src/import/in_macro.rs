//! `urdf = "arm.urdf"; chain = base_link..tool0;` in the macro: the rows, base and tool come from the file.

use super::{Options, from_urdf};
use crate::chain::Convention;
use crate::diagnostic::{Error, Errors, Place, lex};
use proc_macro2::{Group, Ident, Literal, Span, TokenStream, TokenTree};
use std::path::Path;

/// The body of the macro with a table in place of the file's name.
#[derive(Debug)]
pub(crate) struct Spliced {
    /// What the compiler reads.
    pub(crate) table: TokenStream,
    /// An item by which the build notices changes of the file.
    pub(crate) watch: TokenStream,
}

/// A line `NAME = VALUE;` outside of all groups.
struct Line {
    name: String,
    /// Positions of the name and of the token behind the `;`.
    range: (usize, usize),
    value: Vec<TokenTree>,
}

/// Puts the table of a URDF file in place of `urdf` and `chain`; `None` where the input has no `urdf`. `folder`: what the path is relative to.
///
/// # Errors
/// At the tokens, with the line of the file where the file is to blame.
pub(crate) fn splice(input: &TokenStream, folder: &Path) -> Result<Option<Spliced>, Errors> {
    let tokens: Vec<TokenTree> = input.clone().into_iter().collect();
    let lines = lines(&tokens);
    let find = |name: &str| lines.iter().find(|l| l.name == name);
    let Some(urdf) = find("urdf") else { return Ok(None) };
    let fail = |error: Error| {
        let mut errors = Errors::new();
        errors.push(error);
        errors
    };
    let place = Place::of_all(&urdf.value).unwrap_or_else(Place::call_site);
    let file = match urdf.value.as_slice() {
        [TokenTree::Literal(text)] => string(text),
        _ => None,
    };
    let Some(file) = file else {
        return Err(fail(Error::new(place, "`urdf` takes the name of a file: `urdf = \"arm.urdf\";`")));
    };
    let path = folder.join(&file);
    let text = std::fs::read_to_string(&path).map_err(|e| {
        fail(Error::new(place, format!("{file}: {e}")).help("the path is relative to the folder of Cargo.toml"))
    })?;
    if let Some(unit) = find("unit").filter(|l| !matches!(l.value.as_slice(), [TokenTree::Ident(w)] if w == "m")) {
        let place = Place::of_all(&unit.value).unwrap_or(place);
        return Err(fail(Error::new(place, "the lengths of a URDF file are metres").help("leave `unit` out")));
    }
    let mut options = Options { name: Some("Arm".into()), ..Options::default() };
    if find("convention").is_some_and(|l| matches!(l.value.as_slice(), [TokenTree::Ident(w)] if w == "standard")) {
        options.convention = Some(Convention::Standard);
    }
    if let Some(chain) = find("chain") {
        (options.base, options.tip) = ends(&chain.value).ok_or_else(|| {
            fail(Error::new(Place::of_all(&chain.value).unwrap_or(place), "a chain is written `base_link..tool0`"))
        })?;
    }
    let made = from_urdf(&text, &options).map_err(|problem| {
        let mut error = Error::new(place, format!("{}: {}", problem.place(&file), problem.message));
        error.help = problem.help;
        fail(error)
    })?;
    let span = urdf.value.first().map_or_else(Span::call_site, TokenTree::span);
    let made: Vec<TokenTree> = respanned(lex(&made.table)?, span).into_iter().collect();
    Ok(Some(Spliced { table: merged(&tokens, &lines, &made), watch: watch(&file) }))
}

/// The user's tokens without `urdf` and `chain`, then those of the file: what both set is the user's, but motions are multiplied.
fn merged(tokens: &[TokenTree], users: &[Line], made: &[TokenTree]) -> TokenStream {
    let dropped = |l: &&Line| matches!(l.name.as_str(), "urdf" | "chain" | "base" | "tool");
    let mut out: Vec<TokenTree> = Vec::new();
    let mut at = 0;
    for line in users.iter().filter(dropped) {
        out.extend_from_slice(&tokens[at..line.range.0]);
        at = line.range.1;
    }
    out.extend_from_slice(&tokens[at..]);
    let files = lines(made);
    let value = |list: &[Line], name: &str| list.iter().find(|l| l.name == name).map(|l| l.value.clone());
    let punct = |c: char| TokenTree::Punct(proc_macro2::Punct::new(c, proc_macro2::Spacing::Alone));
    let mut set = |name: &str, value: Vec<TokenTree>| {
        out.extend([TokenTree::Ident(Ident::new(name, Span::call_site())), punct('=')]);
        out.extend(value);
        out.push(punct(';'));
    };
    for name in ["base", "tool"] {
        // What the user adds stands outside of the file's chain.
        let (first, second) = (value(users, name), value(&files, name));
        let (first, second) = if name == "base" { (first, second) } else { (second, first) };
        match (first, second) {
            (Some(first), Some(second)) => set(name, [first, vec![punct('*')], second].concat()),
            (Some(only), None) | (None, Some(only)) => set(name, only),
            (None, None) => {}
        }
    }
    let spare = users.iter().any(|l| matches!(l.name.as_str(), "redundant" | "ik" | "task"));
    for line in files.iter().filter(|l| !matches!(l.name.as_str(), "base" | "tool")) {
        let chosen = spare && matches!(line.name.as_str(), "redundant" | "ik");
        if !chosen && !users.iter().any(|l| l.name == line.name) {
            set(&line.name, line.value.clone());
        }
    }
    let rows = made.iter().position(|t| matches!(t, TokenTree::Punct(p) if p.as_char() == '|')).unwrap_or(made.len());
    out.extend_from_slice(&made[rows..]);
    out.into_iter().collect()
}

/// The settings among the tokens.
fn lines(tokens: &[TokenTree]) -> Vec<Line> {
    let is = |i: usize, c: char| matches!(tokens.get(i), Some(TokenTree::Punct(p)) if p.as_char() == c);
    let mut list = Vec::new();
    let mut start = true;
    let mut i = 0;
    while let Some(token) = tokens.get(i) {
        if let (TokenTree::Ident(name), true, true) = (token, start, is(i + 1, '=')) {
            let end = (i + 2..tokens.len()).find(|&k| is(k, ';')).unwrap_or(tokens.len());
            let value = tokens.get(i + 2..end).unwrap_or(&[]).to_vec();
            list.push(Line { name: name.to_string(), range: (i, (end + 1).min(tokens.len())), value });
            i = end + 1;
            continue;
        }
        start = is(i, ';') || is(i, '|') || matches!(token, TokenTree::Group(_));
        i += 1;
    }
    list
}

fn string(text: &Literal) -> Option<String> {
    match syn::Lit::new(text.clone()) {
        syn::Lit::Str(text) => Some(text.value()),
        _ => None,
    }
}

/// Names of base and tip, one of which may be left out.
fn ends(value: &[TokenTree]) -> Option<(Option<String>, Option<String>)> {
    let dot = |t: &TokenTree| matches!(t, TokenTree::Punct(p) if p.as_char() == '.');
    let at = value.windows(2).position(|pair| pair.iter().all(dot))?;
    let name = |tokens: &[TokenTree]| match tokens {
        [] => Some(None),
        [TokenTree::Ident(word)] => Some(Some(word.to_string())),
        [TokenTree::Literal(text)] => string(text).map(Some),
        _ => None,
    };
    let (base, tip) = (name(&value[..at])?, name(&value[at + 2..])?);
    (base.is_some() || tip.is_some()).then_some((base, tip))
}

/// All tokens at one place.
fn respanned(tokens: TokenStream, span: Span) -> TokenStream {
    let one = |token: TokenTree| match token {
        TokenTree::Group(g) => {
            let mut group = Group::new(g.delimiter(), respanned(g.stream(), span));
            group.set_span(span);
            TokenTree::Group(group)
        }
        mut other => {
            other.set_span(span);
            other
        }
    };
    tokens.into_iter().map(one).collect()
}

/// `include_bytes!` of the file.
fn watch(file: &str) -> TokenStream {
    let text = if Path::new(file).is_absolute() {
        format!("const _: &[u8] = ::core::include_bytes!({file:?});")
    } else {
        let path = format!("/{file}");
        format!(
            "const _: &[u8] = ::core::include_bytes!(::core::concat!(::core::env!(\"CARGO_MANIFEST_DIR\"), {path:?}));"
        )
    };
    text.parse().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    const URDF: &str = r#"<robot name="two"><link name="base"/><link name="upper arm"/><link name="hand"/>
        <joint name="a" type="revolute"><origin xyz="0 0 0.1"/><parent link="base"/><child link="upper arm"/><axis xyz="0 0 1"/></joint>
        <joint name="b" type="revolute"><origin xyz="0.3 0 0"/><parent link="upper arm"/><child link="hand"/><axis xyz="0 0 1"/></joint>
        </robot>"#;

    fn spliced(body: &str) -> Result<String, String> {
        let folder = std::env::temp_dir().join(format!("dh-splice-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        std::fs::write(folder.join("two.urdf"), URDF).expect("a file");
        std::fs::write(folder.join("bad.urdf"), URDF.replace("0.3 0 0", "0.3 0 nan")).expect("a file");
        match splice(&body.parse().expect("tokens"), &folder) {
            Ok(Some(s)) => Ok(s.table.to_string()),
            Ok(None) => Err("nothing to do".into()),
            Err(errors) => Err(errors.draw(body, "-")),
        }
    }

    #[test]
    fn a_file_becomes_rows() {
        let table = spliced(
            "pub struct Two; convention = standard; urdf = \"two.urdf\"; chain = base..\"hand\"; tool = tx(0.2);",
        );
        let parsed = crate::chain::table::parse(table.expect("a table").parse().expect("tokens"));
        let spec = parsed.spec.expect("a robot");
        assert_eq!((spec.name.as_str(), spec.rows.len(), spec.tool.len()), ("Two", 2, 1));
        assert_eq!(spec.convention, Convention::Standard);
        assert_eq!(
            spec.rows[0].a,
            crate::chain::LengthCell::number(crate::algebra::Rational::new(3, 10).expect("0.3"))
        );
    }

    #[test]
    fn mistakes_stand_at_the_tokens() {
        let error = |body: &str| spliced(body).expect_err("wrong");
        assert_eq!(error("pub struct Two; convention = standard;"), "nothing to do");
        let drawn = error("struct Two; urdf = \"bad.urdf\";");
        assert!(drawn.contains("bad.urdf:3:") && drawn.contains("`nan` is not finite"), "{drawn}");
        assert!(drawn.contains("^^^^^^^^^^"), "{drawn}");
        assert!(error("struct Two; urdf = \"lost.urdf\";").contains("relative to the folder of Cargo.toml"));
        assert!(error("struct Two; urdf = arm;").contains("takes the name of a file"));
        assert!(error("struct Two; urdf = \"two.urdf\"; chain = base;").contains("base_link..tool0"));
        assert!(error("struct Two; urdf = \"two.urdf\"; chain = base..elbow;").contains("there is no link `elbow`"));
    }
}
