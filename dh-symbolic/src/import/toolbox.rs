//! Scripts of the robotics toolboxes: `Revolute('d', 0.4, 'a', 0, 'alpha', pi/2)` (MATLAB), `RevoluteMDH(d=0.4, alpha=-pi/2)` (Python),
//! `Link([0 0.4 0 pi/2])`. The links in the order of the file become the rows.

use super::arithmetic::value;
use super::problem::Problem;
use super::published::{Cells, finish};
use super::{Imported, Options};
use crate::chain::Convention;

/// A call's name, and what it says: turns (`None`: as the arguments say), modified (`None`: as the arguments say).
type LinkCall = (&'static str, Option<bool>, Option<bool>);

/// All calls.
const CALLS: [LinkCall; 9] = [
    ("RevoluteMDH", Some(true), Some(true)),
    ("PrismaticMDH", Some(false), Some(true)),
    ("RevoluteDH", Some(true), Some(false)),
    ("PrismaticDH", Some(false), Some(false)),
    ("Revolute", Some(true), None),
    ("Prismatic", Some(false), None),
    ("DHLink", None, None),
    ("Link", None, None),
    ("MDHLink", None, Some(true)),
];

/// A script as a table.
///
/// # Errors
/// With the line, where a link cannot be read.
pub(super) fn read(text: &str, options: &Options) -> Result<Imported, Problem> {
    let clean = without_comments(text);
    let names = assignments(&clean);
    let lookup = |name: &str| names.iter().rev().find(|(n, _)| n == name).map(|(_, x)| *x);
    let mut rows = Vec::new();
    let mut conventions = Vec::new();
    let mut at = 0;
    while let Some((start, call)) = next_call(&clean, at) {
        let line = clean[..start].matches('\n').count() + 1;
        let column = start - clean[..start].rfind('\n').map_or(0, |i| i + 1) + 1;
        let problem = |message: String| Problem::at((line, column), message);
        let open = start + call.0.len();
        let Some(arguments) = inside(&clean[open..]) else {
            return Err(problem(format!("the bracket behind `{}` is never closed", call.0)));
        };
        at = open + 1;
        let pieces = split(arguments);
        // A constructor without arguments, or another function of this name.
        if pieces.is_empty() {
            continue;
        }
        let (cells, modified) = link(&pieces, call, line, &lookup).map_err(problem)?;
        rows.push(cells);
        conventions.push(modified);
        at = open + arguments.len() + 2;
    }
    if rows.is_empty() {
        return Err(Problem::new(
            "there is no link in this script: `Revolute(...)`, `RevoluteMDH(...)`, `Link([...])`",
        ));
    }
    let modified = conventions.iter().any(|m| *m);
    if modified && conventions.iter().any(|m| !*m) {
        return Err(Problem::new(
            "some links of this script are of the standard convention and some of the modified one",
        ));
    }
    let convention = if modified { Convention::Modified } else { Convention::Standard };
    if options.convention.is_some_and(|c| c != convention) {
        let name = if modified { "modified" } else { "standard" };
        return Err(Problem::new(format!("the links of this script are of the {name} convention"))
            .help("leave `--convention` out"));
    }
    finish(rows, convention, None, options, Vec::new(), "made from a toolbox script")
}

/// The next call of a link, with its place.
fn next_call(text: &str, from: usize) -> Option<(usize, LinkCall)> {
    let word = |c: char| c.is_alphanumeric() || c == '_';
    let found = CALLS.iter().filter_map(|call| {
        let mut at = from;
        loop {
            let start = at + text.get(at..)?.find(call.0)?;
            let before = text[..start].chars().next_back();
            let after = text[start + call.0.len()..].chars().next();
            if !before.is_some_and(word) && after == Some('(') {
                return Some((start, *call));
            }
            at = start + call.0.len();
        }
    });
    found.min_by_key(|(start, call)| (*start, usize::MAX - call.0.len()))
}

/// What stands in the bracket at the start of the text.
fn inside(text: &str) -> Option<&str> {
    let (mut depth, mut quoted) = (0usize, None);
    for (i, c) in text.char_indices() {
        match (quoted, c) {
            (Some(q), c) if c == q => quoted = None,
            (Some(_), _) => {}
            (None, '\'' | '"') => quoted = Some(c),
            (None, '(' | '[' | '{') => depth += 1,
            (None, ')' | ']' | '}') => {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    return text.get(1..i);
                }
            }
            _ => {}
        }
    }
    None
}

/// Arguments, split at the commas of this level.
fn split(text: &str) -> Vec<&str> {
    let (mut list, mut depth, mut quoted, mut start) = (Vec::new(), 0i32, None, 0);
    for (i, c) in text.char_indices() {
        match (quoted, c) {
            (Some(q), c) if c == q => quoted = None,
            (Some(_), _) => {}
            (None, '\'' | '"') => quoted = Some(c),
            (None, '(' | '[' | '{') => depth += 1,
            (None, ')' | ']' | '}') => depth -= 1,
            (None, ',') if depth == 0 => {
                list.push(text[start..i].trim());
                start = i + 1;
            }
            _ => {}
        }
    }
    list.push(text[start..].trim());
    list.retain(|piece| !piece.is_empty());
    list
}

/// The numbers of `[0 0.4 0 pi/2]` or `[0, 0.4]`.
fn vector(text: &str) -> Option<Vec<&str>> {
    let inner = text.trim().strip_prefix(['[', '('])?.strip_suffix([']', ')'])?;
    Some(if inner.contains(',') {
        inner.split(',').map(str::trim).filter(|w| !w.is_empty()).collect()
    } else {
        inner.split_whitespace().collect()
    })
}

/// One link.
fn link(
    pieces: &[&str],
    (call, mut turns, mut modified): (&'static str, Option<bool>, Option<bool>),
    line: usize,
    names: &dyn Fn(&str) -> Option<f64>,
) -> Result<(Cells, bool), String> {
    let mut cells = Cells { line, ..Cells::default() };
    let number = |text: &str| value(text, names).ok_or_else(|| format!("`{text}` is no constant that is known here"));
    let mut i = 0;
    while let Some(piece) = pieces.get(i) {
        i += 1;
        if let Some(list) = vector(piece) {
            // theta d a alpha sigma offset
            let numbers = list.iter().map(|w| number(w)).collect::<Result<Vec<f64>, _>>()?;
            let [theta, d, a, alpha, more @ ..] = numbers.as_slice() else {
                return Err(format!("`{piece}` is no row theta, d, a, alpha"));
            };
            (cells.theta, cells.d, cells.a, cells.alpha) = (*theta, *d, *a, *alpha);
            turns = Some(more.first().is_none_or(|sigma| *sigma == 0.0)).filter(|_| turns.is_none()).or(turns);
            cells.offset = more.get(1).copied().unwrap_or(0.0);
            continue;
        }
        let quoted = |text: &str| {
            let inner = text.strip_prefix(['\'', '"'])?.strip_suffix(['\'', '"'])?;
            Some(inner.to_string())
        };
        // A name and its value: `'d', 0.4` or `d=0.4`.
        let (name, text) = match (quoted(piece), piece.split_once('=')) {
            (Some(name), _) => match name.as_str() {
                "modified" | "mod" => {
                    modified = Some(true);
                    continue;
                }
                "standard" | "std" | "revolute" | "prismatic" | "r" | "p" => {
                    match name.as_str() {
                        "revolute" | "r" => turns = Some(true),
                        "prismatic" | "p" => turns = Some(false),
                        _ => modified = modified.or(Some(false)),
                    }
                    continue;
                }
                _ => {
                    let Some(text) = pieces.get(i) else { return Err(format!("`'{name}'` has no value")) };
                    i += 1;
                    (name, (*text).to_string())
                }
            },
            (None, Some((name, text))) => (name.trim().to_string(), text.trim().to_string()),
            (None, None) => {
                return Err(format!("`{piece}` of `{call}` has no name: 'd', 'a', 'alpha', 'offset', 'qlim'"));
            }
        };
        match name.as_str() {
            "theta" => cells.theta = number(&text)?,
            "d" => cells.d = number(&text)?,
            "a" => cells.a = number(&text)?,
            "alpha" => cells.alpha = number(&text)?,
            "offset" => cells.offset = number(&text)?,
            "sigma" => turns = Some(number(&text)? == 0.0),
            "mdh" => modified = Some(matches!(text.as_str(), "1" | "true" | "True")),
            "qlim" => {
                if let Some([low, high]) = vector(&text).as_deref() {
                    cells.range = Some((number(low)?, number(high)?));
                }
            }
            "name" | "label" => cells.label = quoted(&text).unwrap_or_default(),
            // Masses, inertia, motors, gears: not for a table.
            _ => {}
        }
    }
    cells.turns = turns.unwrap_or(true);
    Ok((cells, modified.unwrap_or(false)))
}

/// `name = value` lines that are constants.
fn assignments(text: &str) -> Vec<(String, f64)> {
    let mut known: Vec<(String, f64)> = Vec::new();
    for line in text.split(['\n', ';']).take(5000) {
        let Some((name, expression)) = line.split_once('=') else { continue };
        let name = name.trim();
        if name.is_empty() || !name.chars().all(|c| c.is_alphanumeric() || c == '_') {
            continue;
        }
        let x = value(expression, &|n| known.iter().rev().find(|(k, _)| k == n).map(|(_, x)| *x));
        if let Some(x) = x {
            known.push((name.to_string(), x));
        }
    }
    known
}

/// The script without `%` and `#` comments; lines and columns stay.
fn without_comments(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let mut quoted = None;
        let mut end = line.len();
        for (i, c) in line.char_indices() {
            match (quoted, c) {
                (Some(q), c) if c == q => quoted = None,
                (Some(_), _) => {}
                (None, '"') => quoted = Some(c),
                // A quote behind a letter is MATLAB's transposition.
                (None, '\'') if !line[..i].ends_with(|c: char| c.is_alphanumeric() || matches!(c, ')' | ']')) => {
                    quoted = Some(c)
                }
                (None, '%' | '#') => {
                    end = i;
                    break;
                }
                _ => {}
            }
        }
        out.push_str(&line[..end]);
        if end < line.len() && line.ends_with('\n') {
            out.push('\n');
        }
    }
    // MATLAB's continued lines.
    out.replace("...", "   ")
}
