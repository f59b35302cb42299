//! `{}^0_6T`, `T_6^0`, `A_1`, `{}^0_3R`, `{}^0P_4`: transforms between frames in their many spellings.

use super::layout::{Item, ItemKind};
use super::letter::{general, index_text};
use super::names::{Names, Unknown};
use crate::chain::{Convention, Coordinate};

/// A frame by its label.
#[derive(Clone, Debug, PartialEq)]
enum Frame {
    /// A frame of the table; `true`: primed.
    Number(usize, bool),
    /// Before the constant transform at the base.
    Base,
    /// On the axis of joint 1, where the document says by which B it is moved there.
    Start,
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
pub(super) fn read(item: &Item, names: &Names<'_>) -> Option<Result<Found, Unknown>> {
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

/// The number of the frame at the tip, where the document gives its pose.
pub(super) const TIP: usize = usize::MAX;

/// The numbers of primed frames begin here, where the document gives their pose.
const PRIMED: usize = 1000;

/// The last frame of a transform from frame 0, as written, and whether that is 0'.
pub(super) fn last_frame(item: &Item) -> Option<(usize, bool)> {
    let text = |part: &Option<Vec<Item>>| part.as_ref().and_then(|p| index_text(p));
    let (from, to) = match (text(&item.before_sup), text(&item.before_sub), text(&item.sup), text(&item.sub)) {
        (Some(i), Some(j), None, None) | (Some(i), None, None, Some(j)) | (None, None, Some(i), Some(j)) => (i, j),
        _ => return None,
    };
    if item.name() != Some("T") || !matches!(from.as_str(), "0" | "0'") {
        return None;
    }
    let frame = match (to.as_str(), to.strip_suffix('\'')) {
        ("e" | "E" | "H" | "h" | "tool", _) => TIP,
        (_, Some(number)) => number.parse::<usize>().ok()?.checked_add(PRIMED)?,
        (_, None) => to.parse().ok()?,
    };
    Some((frame, from != "0"))
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

fn frame(label: &str, names: &Names<'_>) -> Option<Frame> {
    let n = names.chain.links.len();
    let (digits, primed) = match label.strip_suffix('\'') {
        Some(head) => (head, true),
        None => (label, false),
    };
    let digits = match digits.strip_prefix("n-").and_then(|k| k.parse::<usize>().ok()) {
        Some(k) => &n.checked_sub(k)?.to_string(),
        None => digits,
    };
    if let Ok(k) = digits.parse::<usize>() {
        if primed && k == 0 && names.start().is_some() {
            return Some(Frame::Start);
        }
        if primed && names.given_pose(k.saturating_add(PRIMED)).is_some() {
            return Some(Frame::Number(k + PRIMED, false));
        }
        return Some(Frame::Number(k, primed));
    }
    match label {
        "b" | "B" | "W" | "w" if names.chain.base.is_empty() => Some(Frame::Number(0, false)),
        "b" | "B" | "W" | "w" => Some(Frame::Base),
        "e" | "E" | "H" | "h" | "tool" if names.given_pose(TIP).is_some() => Some(Frame::Number(TIP, false)),
        "e" | "E" | "H" | "h" | "tool" | "n" if names.chain.tool.is_empty() => Some(Frame::Number(n, false)),
        "n" => Some(Frame::Number(n, false)),
        "e" | "E" | "H" | "h" | "tool" => Some(Frame::Tool),
        "i" | "i-1" | "i+1" | "j" | "j-1" => Some(Frame::Any(label.into())),
        _ => None,
    }
}

/// The transform from one frame to another, as words of a claim.
pub(super) fn between(from: &str, to: &str, names: &Names<'_>) -> Result<String, Unknown> {
    let read = |label: &str| frame(label, names).ok_or_else(|| unknown(format!("there is no frame `{label}`")));
    let (i, j) = (read(from)?, read(to)?);
    let n = names.chain.links.len();
    // frames of the inverse are seen from 0'; what is seen from 0 are those of the table
    if let (true, Frame::Number(0, false), Frame::Number(k @ 1.., false)) = (names.from_start, &i, &j)
        && *k <= n
    {
        return Ok(format!("T ( 0 , {k} )"));
    }
    if names.on_axes
        && let (Frame::Number(i, p), Frame::Number(j, q)) = (&i, &j)
    {
        return Ok(between_axes((*i, *p), (*j, *q), names));
    }
    let text = match (&i, &j) {
        (Frame::Start, Frame::Start) => "I4".into(),
        (Frame::Start, Frame::Number(k, false)) if names.given_pose(*k).is_some() => {
            names.given_pose(*k).unwrap_or_default().to_string()
        }
        (Frame::Start, Frame::Number(k, p)) if names.on_axes => {
            let to = between_axes((0, false), (*k, *p), names);
            format!("( inv ( {} ) * {to} )", names.start().unwrap_or_default())
        }
        (Frame::Start, _) => {
            format!("( inv ( {} ) * {} )", names.start().unwrap_or_default(), between("0", to, names)?)
        }
        (_, Frame::Start) => format!("inv ( {} )", between(to, from, names)?),
        (Frame::Any(i), Frame::Any(j)) if (i == "i-1" && j == "i") || (i == "j-1" && j == "j") => any_link(names, j),
        (Frame::Any(_), _) | (_, Frame::Any(_)) => {
            return Err(unknown(format!("T from frame {from} to {to} is general")));
        }
        (Frame::Base, Frame::Number(0, false)) => "base".into(),
        (Frame::Number(k, false), Frame::Tool) if *k == n => "tool".into(),
        (Frame::Base, Frame::Tool) => names.pose(),
        (Frame::Base, Frame::Number(..)) => format!("( base * {} )", between("0", to, names)?),
        (Frame::Number(..), Frame::Tool) => format!("( {} * tool )", between(from, &n.to_string(), names)?),
        (Frame::Base, Frame::Base) | (Frame::Tool, Frame::Tool) => "I4".into(),
        (Frame::Tool, _) | (_, Frame::Base) => format!("inv ( {} )", between(to, from, names)?),
        (Frame::Number(i, false), Frame::Number(j, false)) if names.given_pose(*j).is_some() && i != j => {
            let pose = names.placed_pose(*j).unwrap_or_default();
            if *i == 0 { pose } else { format!("( T ( {i} , 0 ) * {pose} )") }
        }
        (Frame::Number(i, true), Frame::Number(j, false)) if names.given_pose(*j).is_some() => {
            let pose = names.placed_pose(*j).unwrap_or_default();
            format!("( {} * T ( {i} , 0 ) * {pose} )", shift(names, *i, false))
        }
        (Frame::Number(i, false), Frame::Number(..)) if names.given_pose(*i).is_some() => {
            format!("inv ( {} )", between(to, from, names)?)
        }
        (Frame::Number(i, false), Frame::Number(j, false)) => format!("T ( {i} , {j} )"),
        (Frame::Number(i, p), Frame::Number(j, q)) => {
            let mut factors = vec![format!("T ( {i} , {j} )")];
            if *p {
                factors.insert(0, shift(names, *i, false));
            }
            if *q {
                factors.push(shift(names, *j, true));
            }
            format!("( {} )", factors.join(" * "))
        }
    };
    Ok(text)
}

/// The same between frames on the joint axes: frame i is frame i-1 of the table after the motion of joint i; the primed one after
/// the shift along the axis as well.
fn between_axes(from: (usize, bool), to: (usize, bool), names: &Names<'_>) -> String {
    let place = |(k, primed): (usize, bool)| {
        if let Some(pose) = names.placed_pose(k) {
            return Some(pose);
        }
        let joint = names.chain.joints.get(k.checked_sub(1)?)?;
        let (row, number) = (joint.row, joint.row + 1);
        let both = primed || matches!(joint.coordinate, Coordinate::Length(_));
        let shift = if both { format!(" * Tz ( d{number} )") } else { String::new() };
        Some(format!("( T ( 0 , {row} ) * Rz ( theta{number} ){shift} )"))
    };
    match (place(from), place(to)) {
        (None, None) => "I4".into(),
        (None, Some(to)) => to,
        (Some(from), None) => format!("inv ( {from} )"),
        (Some(from), Some(to)) => format!("( inv ( {from} ) * {to} )"),
    }
}

/// From the primed frame to its frame; `back`: the other way round. The primed frame is the frame of the table before its shift along
/// the axis (modified convention), or after the shift of the next row (standard).
fn shift(names: &Names<'_>, k: usize, back: bool) -> String {
    match (names.chain.convention == Convention::Modified, back) {
        (true, false) => format!("Tz ( d{k} )"),
        (true, true) => format!("Tz ( - d{k} )"),
        (false, false) => format!("Tz ( - d{} )", k + 1),
        (false, true) => format!("Tz ( d{} )", k + 1),
    }
}

/// The transform of any row, from the convention.
fn any_link(names: &Names<'_>, j: &str) -> String {
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
