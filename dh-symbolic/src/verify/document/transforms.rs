//! `{}^0_6T`, `T_6^0`, `A_1`, `{}^0_3R`, `{}^0P_4`: transforms between frames in their many spellings.

use super::layout::{Item, ItemKind};
use super::letter::{general, index_text};
use super::names::{DocumentNames, Unknown};
use crate::chain::Convention;

/// A frame by its label.
#[derive(Clone, Debug, PartialEq)]
enum FrameLabel {
    /// A frame of the table.
    Number(usize),
    /// A frame that the document defines, as seen from frame 0.
    Defined(String),
    /// Before the constant transform at the base.
    Base,
    /// After the one at the tip.
    Tool,
    /// Any frame: `i`, `i-1`.
    Any(String),
}

/// What a letter for a transform stands for, and what is left of its raised index.
#[derive(Debug)]
pub(super) struct Found {
    pub(super) meaning: String,
    pub(super) power: Option<Vec<Item>>,
}

fn unknown(why: String) -> Unknown {
    Unknown { why, name: None }
}

/// Reads a letter T, A, R or P with its frames; `None` where it is not such a letter.
pub(super) fn read(item: &Item, names: &DocumentNames<'_>) -> Option<Result<Found, Unknown>> {
    let letter = item.name()?;
    if !matches!(letter, "T" | "A" | "R" | "P") {
        return None;
    }
    let text = |part: &Option<Vec<Item>>| part.as_ref().and_then(|p| index_text(p)).filter(|t| !t.is_empty());
    let (before_sup, before_sub) = (text(&item.before_sup), text(&item.before_sub));
    let (sup, sub) = (text(&item.sup), text(&item.sub));
    let is_power = |t: &String| t == "-1" || t == "T" || t == "t";
    let rest = item.sup.clone().filter(|_| sup.as_ref().is_some_and(is_power));
    let raised = sup.filter(|t| !is_power(t));
    let (from, to, power) = match (before_sup, before_sub, raised, sub) {
        (Some(i), Some(j), None, None) | (Some(i), None, None, Some(j)) | (None, None, Some(i), Some(j)) => {
            (i, j, rest)
        }
        (Some(i), None, Some(j), None) => (i, j, None),
        // _1T^2, as some write it
        (None, Some(i), Some(j), None) => (i, j, None),
        (None, None, None, Some(j)) => match two(&j) {
            Some((i, j)) => (i, j, rest),
            None if letter == "A" => {
                let n: Option<usize> = j.parse().ok();
                let before = n.and_then(|n| n.checked_sub(1)).map_or_else(|| format!("{j}-1"), |n| n.to_string());
                (before, j, rest)
            }
            None => ("0".to_string(), j, rest),
        },
        (Some(i), None, None, None) if letter == "P" => {
            return Some(Err(unknown(format!("a point in frame {i} without a name"))));
        }
        _ => return None,
    };
    // of a point, the number of the frame whose origin it is
    let to = if letter == "P" { to.chars().take_while(char::is_ascii_digit).collect() } else { to };
    let part = match letter {
        "R" => " . R",
        "P" => " . p",
        _ => "",
    };
    Some(between(&from, &to, names).map(|meaning| Found { meaning: format!("{meaning}{part}"), power }))
}

/// Is it a transform or rotation between frames of which one is neither the table's nor defined by the document?
pub(super) fn has_unknown_frame(item: &Item, names: &DocumentNames<'_>) -> bool {
    if !matches!(item.name(), Some("T" | "R")) || motion(item).is_some() {
        return false;
    }
    let label = |part: &Option<Vec<Item>>| part.as_ref().and_then(|p| index_text(p));
    let unknown = |l: &String| {
        let letter = l.chars().all(|c| c.is_ascii_alphabetic()) && !l.is_empty();
        letter && !matches!(l.as_str(), "T" | "t" | "i" | "j" | "k") && frame(l, names).is_none()
    };
    [&item.before_sup, &item.before_sub, &item.sup, &item.sub].into_iter().filter_map(label).any(|l| unknown(&l))
}

/// The two frames of a transform T, as written.
pub(super) fn ends(item: &Item) -> Option<(String, String)> {
    let text = |part: &Option<Vec<Item>>| part.as_ref().and_then(|p| index_text(p));
    let ends = match (text(&item.before_sup), text(&item.before_sub), text(&item.sup), text(&item.sub)) {
        (Some(i), Some(j), None, None) | (Some(i), None, None, Some(j)) | (None, None, Some(i), Some(j)) => (i, j),
        _ => return None,
    };
    (item.name() == Some("T")).then_some(ends)
}

/// The frame that `{}^{4'}_4T = ...` defines: one with a prime that has no meaning yet; and how it is seen from frame 0.
pub(super) fn defined(item: &Item, right: &str, names: &DocumentNames<'_>) -> Option<(String, String)> {
    let (from, to) = ends(item)?;
    let free = |label: &str| label.ends_with('\'') && frame(label, names).is_none();
    let known = |label: &str| frame(label, names).and_then(|f| seen(&f, names));
    match (free(&from), free(&to)) {
        (true, false) => Some((from, format!("( {} * inv ( {right} ) )", known(&to)?))),
        (false, true) => Some((to, format!("( {} * {right} )", known(&from)?))),
        _ => None,
    }
}

/// `06`, `0,6`.
fn two(index: &str) -> Option<(String, String)> {
    if let Some((i, j)) = index.split_once(',') {
        return Some((i.into(), j.into()));
    }
    match index.as_bytes() {
        [i, j] if i.is_ascii_digit() && j.is_ascii_digit() => {
            Some((char::from(*i).to_string(), char::from(*j).to_string()))
        }
        _ => None,
    }
}

fn frame(label: &str, names: &DocumentNames<'_>) -> Option<FrameLabel> {
    let n = names.chain.links.len();
    if let Some(words) = names.frame(label) {
        return Some(FrameLabel::Defined(words.into()));
    }
    let number = match label.strip_prefix("n-").and_then(|k| k.parse::<usize>().ok()) {
        Some(k) => n.checked_sub(k),
        None => label.parse::<usize>().ok(),
    };
    if let Some(k) = number {
        return Some(FrameLabel::Number(k));
    }
    match label {
        "b" | "B" | "W" | "w" if names.chain.base.is_empty() => Some(FrameLabel::Number(0)),
        "b" | "B" | "W" | "w" => Some(FrameLabel::Base),
        "e" | "E" | "H" | "h" | "tool" | "n" if names.chain.tool.is_empty() => Some(FrameLabel::Number(n)),
        "n" => Some(FrameLabel::Number(n)),
        "e" | "E" | "H" | "h" | "tool" => Some(FrameLabel::Tool),
        "i" | "i-1" | "i+1" | "j" | "j-1" => Some(FrameLabel::Any(label.into())),
        _ => None,
    }
}

/// A frame as seen from frame 0.
fn seen(frame: &FrameLabel, names: &DocumentNames<'_>) -> Option<String> {
    let n = names.chain.links.len();
    Some(match frame {
        FrameLabel::Number(k) => format!("T ( 0 , {k} )"),
        FrameLabel::Defined(words) => words.clone(),
        FrameLabel::Base => "inv ( base )".into(),
        FrameLabel::Tool => format!("( T ( 0 , {n} ) * tool )"),
        FrameLabel::Any(_) => return None,
    })
}

/// The transform from one frame to another, as words of a claim.
pub(super) fn between(from: &str, to: &str, names: &DocumentNames<'_>) -> Result<String, Unknown> {
    let read = |label: &str| frame(label, names).ok_or_else(|| unknown(format!("there is no frame `{label}`")));
    let (i, j) = (read(from)?, read(to)?);
    let n = names.chain.links.len();
    let text = match (&i, &j) {
        (FrameLabel::Any(i), FrameLabel::Any(j)) if (i == "i-1" && j == "i") || (i == "j-1" && j == "j") => {
            any_link(names, j)
        }
        (FrameLabel::Any(_), _) | (_, FrameLabel::Any(_)) => {
            return Err(unknown(format!("T from frame {from} to {to} is general")));
        }
        (FrameLabel::Number(0), FrameLabel::Defined(words)) => words.clone(),
        (FrameLabel::Defined(words), FrameLabel::Number(0)) => format!("inv ( {words} )"),
        (FrameLabel::Defined(_), other) | (other, FrameLabel::Defined(_)) => {
            let none = || unknown(format!("there is no frame `{from}` or `{to}`"));
            let (a, b) = (seen(&i, names).ok_or_else(none)?, seen(&j, names).ok_or_else(none)?);
            if i == j && i == *other { "I4".into() } else { format!("( inv ( {a} ) * {b} )") }
        }
        (FrameLabel::Base, FrameLabel::Number(0)) => "base".into(),
        (FrameLabel::Number(k), FrameLabel::Tool) if *k == n => "tool".into(),
        (FrameLabel::Base, FrameLabel::Tool) => names.pose(),
        (FrameLabel::Base, FrameLabel::Number(..)) => format!("( base * {} )", between("0", to, names)?),
        (FrameLabel::Number(..), FrameLabel::Tool) => format!("( {} * tool )", between(from, &n.to_string(), names)?),
        (FrameLabel::Base, FrameLabel::Base) | (FrameLabel::Tool, FrameLabel::Tool) => "I4".into(),
        (FrameLabel::Tool, _) | (_, FrameLabel::Base) => format!("inv ( {} )", between(to, from, names)?),
        (FrameLabel::Number(i), FrameLabel::Number(j)) => format!("T ( {i} , {j} )"),
    };
    Ok(text)
}

/// The transform of any row, from the convention.
fn any_link(names: &DocumentNames<'_>, j: &str) -> String {
    let q = |stem: &str, index: &str| general(stem, index);
    match names.chain.convention {
        Convention::Modified => {
            let before = format!("{j}-1");
            let (alpha, a) = (q("alpha", &before), q("a", &before));
            format!("( Rx ( {alpha} ) * Tx ( {a} ) * Rz ( {} ) * Tz ( {} ) )", q("theta", j), q("d", j))
        }
        Convention::Standard => {
            let (alpha, a) = (q("alpha", j), q("a", j));
            format!("( Rz ( {} ) * Tz ( {} ) * Tx ( {a} ) * Rx ( {alpha} ) )", q("theta", j), q("d", j))
        }
    }
}

/// `R_x(..)`, `D_z(..)`, `T_{\hat{x}}(..)`, `Rot_x`: the axis, and what kind of motion it is, where the letter says so.
pub(super) fn motion(item: &Item) -> Option<(char, Option<bool>)> {
    let letter = item.name()?;
    if item.before_sup.is_some() || item.before_sub.is_some() {
        return None;
    }
    let rotation = match letter {
        "R" | "Rot" => Some(true),
        "D" | "Trans" => Some(false),
        "T" => None,
        _ => return None,
    };
    let first = item.sub.as_deref()?.first()?;
    let axis = match &first.kind {
        ItemKind::Name(n) | ItemKind::Text(n) => n.chars().next()?.to_ascii_lowercase(),
        _ => return None,
    };
    matches!(axis, 'x' | 'y' | 'z').then_some((axis, rotation))
}
