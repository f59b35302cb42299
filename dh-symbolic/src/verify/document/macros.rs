//! `\newcommand`, `\def` and the like: a document's own commands are put in place before anything is read.

use std::collections::BTreeMap;

/// Characters with their lines.
type Text = Vec<(char, usize)>;

/// Deepest commands within commands.
const DEPTH: usize = 16;
/// Most characters that all commands together may add.
const GROWTH: usize = 200_000;

struct Macro {
    arguments: usize,
    body: Text,
}

/// The text without definitions and with commands put in place. A command whose definition is not understood is left as it is: it has no
/// meaning then.
pub(super) fn expand(text: Text) -> Text {
    let defining = ["newcommand", "renewcommand", "providecommand", "def", "DeclareMathOperator"];
    let flat: String = text.iter().map(|t| t.0).collect();
    if !defining.iter().any(|d| flat.contains(&format!("\\{d}"))) {
        return text;
    }
    let mut macros = BTreeMap::new();
    let mut rest = Text::new();
    let mut at = 0;
    while at < text.len() {
        match command(&text, at).filter(|(name, _)| defining.contains(&name.as_str())) {
            Some((kind, after)) => match definition(&text, after, &kind) {
                Some((name, m, end)) => {
                    macros.insert(name, m);
                    at = end;
                }
                None => at = after,
            },
            None => {
                rest.push(text[at]);
                at += 1;
            }
        }
    }
    let mut left = GROWTH;
    put(&rest, &macros, 0, &mut left)
}

/// The name of the command that begins here, and the place after it.
fn command(text: &[(char, usize)], at: usize) -> Option<(String, usize)> {
    if text.get(at)?.0 != '\\' {
        return None;
    }
    let name: String = text[at + 1..].iter().take(40).map(|t| t.0).take_while(char::is_ascii_alphabetic).collect();
    let after = at + 1 + name.len();
    (!name.is_empty()).then_some((name, after))
}

fn skip_room(text: &[(char, usize)], mut at: usize) -> usize {
    while text.get(at).is_some_and(|t| t.0.is_whitespace()) {
        at += 1;
    }
    at
}

/// What stands in braces from here, and the place after them.
fn braces(text: &[(char, usize)], at: usize) -> Option<(Text, usize)> {
    if text.get(at)?.0 != '{' {
        return None;
    }
    let mut depth = 0;
    for (k, t) in text.iter().enumerate().skip(at).take(20_000) {
        match t.0 {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some((text.get(at + 1..k)?.to_vec(), k + 1));
        }
    }
    None
}

fn definition(text: &[(char, usize)], after: usize, kind: &str) -> Option<(String, Macro, usize)> {
    let mut at = after + usize::from(text.get(after).is_some_and(|t| t.0 == '*'));
    at = skip_room(text, at);
    let (name, next) = match braces(text, at) {
        Some((inner, next)) => (command(&inner, 0)?.0, next),
        None => command(text, at)?,
    };
    at = next;
    let mut arguments = 0;
    if kind == "def" {
        while text.get(at).is_some_and(|t| t.0 != '{' && t.0 != '\n') {
            arguments += usize::from(text.get(at).is_some_and(|t| t.0 == '#'));
            at += 1;
        }
    } else if text.get(at).is_some_and(|t| t.0 == '[') {
        arguments = usize::try_from(text.get(at + 1)?.0.to_digit(10)?).ok()?;
        at += 3;
        if text.get(at).is_some_and(|t| t.0 == '[') {
            // a first argument that may be left out
            return None;
        }
    }
    let (body, end) = braces(text, skip_room(text, at))?;
    let body = if kind == "DeclareMathOperator" {
        let line = body.first().map_or(0, |t| t.1);
        let chars = |s: &str| s.chars().map(|c| (c, line)).collect::<Text>();
        [chars("\\operatorname{"), body, chars("}")].concat()
    } else {
        body
    };
    Some((name, Macro { arguments, body }, end))
}

fn put(text: &[(char, usize)], macros: &BTreeMap<String, Macro>, depth: usize, left: &mut usize) -> Text {
    let mut out = Text::new();
    let mut at = 0;
    while at < text.len() {
        let known = command(text, at).and_then(|(name, after)| Some((macros.get(&name)?, after)));
        let Some((m, mut after)) = known.filter(|_| depth < DEPTH && *left > 0) else {
            // `\\` is no beginning of a command
            let pair = text[at].0 == '\\' && command(text, at).is_none();
            out.extend(text.get(at..(at + 1 + usize::from(pair)).min(text.len())).unwrap_or_default());
            at += 1 + usize::from(pair);
            continue;
        };
        let line = text[at].1;
        let mut arguments: Vec<Text> = Vec::new();
        for _ in 0..m.arguments {
            after = skip_room(text, after);
            match braces(text, after) {
                Some((inner, next)) => {
                    arguments.push(inner);
                    after = next;
                }
                None => {
                    arguments.push(text.get(after..after + 1).unwrap_or_default().to_vec());
                    after += 1;
                }
            }
        }
        let mut body = Text::new();
        let mut k = 0;
        while let Some((c, _)) = m.body.get(k) {
            let number = m.body.get(k + 1).and_then(|t| t.0.to_digit(10));
            match (c, number) {
                ('#', Some(n)) => {
                    body.extend(arguments.get((n as usize).wrapping_sub(1)).into_iter().flatten());
                    k += 2;
                }
                _ => {
                    body.push((*c, line));
                    k += 1;
                }
            }
        }
        *left = left.saturating_sub(body.len().max(1));
        // a command ends where it ends: what follows is no part of its name
        let inner = put(&body, macros, depth + 1, left);
        let glued = inner.last().is_some_and(|t| t.0.is_ascii_alphabetic())
            && text.get(after).is_some_and(|t| t.0.is_ascii_alphabetic());
        out.extend(inner);
        if glued {
            out.push((' ', line));
        }
        at = after.min(text.len());
    }
    out
}
