//! From an arm with frames to the cells of a table, and what was rounded as lines for people.

use super::Options;
use super::axes::{Axis, PlacedAxes};
use super::frames::{Link, Motion, Rows};
use super::rounding::{Angle, number, shown};
use super::route::Route;
use super::sheet::{Sheet, SheetRow, type_name};
use super::space::{Vector, cross, dot, minus, norm};
use super::urdf::Model;
use crate::chain::Convention;

/// The table.
pub(super) fn sheet(model: &Model, route: &Route, arm: &PlacedAxes, rows: &Rows, options: &Options) -> Sheet {
    let convention = options.convention.unwrap_or(Convention::Modified);
    let robot = if model.name.is_empty() { "A robot" } else { &model.name };
    let (base, tip) = (&model.links[route.base], &model.links[route.tip]);
    Sheet {
        docs: vec![format!("{robot}, from {base} to {tip}; made from its URDF file.")],
        name: options.name.clone().unwrap_or_else(|| type_name(&model.name)),
        convention,
        unit: None,
        base: motions(&rows.base),
        tool: motions(&rows.tool),
        settings: Vec::new(),
        rows: self::rows(arm, rows, convention),
    }
}

/// The rows of a table.
pub(super) fn rows(arm: &PlacedAxes, rows: &Rows, convention: Convention) -> Vec<SheetRow> {
    let first = Link::default();
    let before = std::iter::once(&first).chain(&rows.links);
    // A row of a modified table holds the normal before its joint.
    let normal = |(link, before)| row(arm, link, if convention == Convention::Modified { before } else { link });
    rows.links.iter().zip(before).map(normal).collect()
}

fn row(arm: &PlacedAxes, link: &Link, normal: &Link) -> SheetRow {
    let mut row = SheetRow {
        alpha: normal.alpha.text(),
        a: number(normal.a),
        d: number(link.d),
        theta: link.theta.text(),
        range: "-".into(),
        label: String::new(),
    };
    let Some(axis) = link.axis.and_then(|i| arm.axes.get(i)) else { return row };
    row.label.clone_from(&axis.name);
    if axis.turns {
        let theta = if axis.at_zero == 0.0 {
            link.theta
        } else {
            arm.limits.angle(link.theta.radians() + axis.at_zero).folded()
        };
        row.theta = moving(axis, &theta.text(), theta.is_zero());
    } else {
        let d = arm.limits.length(link.d + axis.at_zero);
        row.d = moving(axis, &number(d), d == 0.0);
    }
    if let Some((low, high)) = &axis.limits {
        row.range = range(axis, low, high);
    }
    row
}

/// `q3 - 90deg`.
fn moving(axis: &Axis, constant: &str, zero: bool) -> String {
    let mut text = String::new();
    for (motor, factor) in &axis.motors {
        let name = format!("q{}", motor + 1);
        let sign = match (text.is_empty(), *factor < 0.0) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        let size = factor.abs();
        text += &if size == 1.0 { format!("{sign}{name}") } else { format!("{sign}{}*{name}", number(size)) };
    }
    match (text.is_empty(), zero) {
        (true, _) => constant.to_string(),
        (_, true) => text,
        _ => match constant.strip_prefix('-') {
            Some(rest) => format!("{text} - {rest}"),
            None => format!("{text} + {constant}"),
        },
    }
}

/// Limits as written, angles in degrees where they were meant so.
fn range(axis: &Axis, low: &str, high: &str) -> String {
    let value = |text: &str| text.parse::<f64>().unwrap_or(0.0);
    let (low, high) = if value(low) > value(high) { (high, low) } else { (low, high) };
    let bound = |text: &str| {
        let x = value(text);
        if !axis.turns {
            return number(x);
        }
        // Whole degrees, rounded to the digits that are written.
        let digits = text.split(['e', 'E']).next().and_then(|t| t.split_once('.')).map_or(0, |(_, f)| f.len());
        // Of few digits only the usual angles: 2.6 is near 149 degrees by chance.
        let step = if digits < 4 { 15.0 } else { 0.5 };
        let degrees = (x.to_degrees() / step).round() * step;
        let last_digit = 0.1f64.powi(i32::try_from(digits.clamp(3, 9)).unwrap_or(9));
        if (degrees.to_radians() - x).abs() <= last_digit {
            return format!("{}deg", number(degrees));
        }
        let hundredths = (x.to_degrees() * 100.0).round() / 100.0;
        if (hundredths.to_radians() - x).abs() <= 1e-9 {
            return format!("{}deg", number(hundredths));
        }
        format!("{}rad", number(x))
    };
    format!("{}..={}", bound(low), bound(high))
}

/// `tz(0.1) * rx(90deg)`.
pub(super) fn motions(list: &[Motion]) -> String {
    let names = ["x", "y", "z"];
    let one = |m: &Motion| match m {
        Motion::Shift(k, x) => format!("t{}({})", names[*k], number(*x)),
        Motion::Turn(k, a) => format!("r{}({})", names[*k], a.text()),
    };
    list.iter().map(one).collect::<Vec<_>>().join(" * ")
}

/// Differences below this are noise of floating-point numbers.
const NOISE: f64 = 1e-11;
/// Differences below this are told together.
const SMALL: f64 = 1e-7;

/// What was rounded, line by line, and what it does to the tip.
pub(super) fn rounded(arm: &PlacedAxes, rows: &Rows) -> Vec<String> {
    let mut notes = Vec::new();
    let mut small = (0, 0.0f64);
    let mut told: Vec<(&str, f64)> = Vec::new();
    for (i, pair) in arm.written_directions().windows(2).enumerate() {
        let [z, next] = [pair[0], pair[1]];
        let twist = twist(rows, i);
        let Some(exact) = twist else { continue };
        let written = norm(cross(z, next)).atan2(dot(z, next)) * if exact.radians() < 0.0 { -1.0 } else { 1.0 };
        let off = (written - exact.radians()).abs();
        let name = arm.axes[i + 1].name.as_str();
        if off > SMALL {
            notes.push(line(name, "twist", written, &exact.text(), off));
            told.push((name, off));
        } else if off > NOISE {
            small = (small.0 + 1, small.1.max(off));
        }
    }
    for r in &arm.rounded {
        // A twist that was told already.
        if told.iter().any(|(name, off)| *name == r.joint && (off - r.off).abs() < 0.01 * off) {
            continue;
        }
        if r.off > SMALL {
            notes.push(line(&r.joint, r.what, r.written, &r.taken, r.off));
        }
    }
    for (link, name) in rows.links.iter().filter_map(|l| Some((l, &arm.axes.get(l.axis?)?.name))) {
        for (what, lost) in [("length a behind it", link.lost.0), ("offset d", link.lost.1)] {
            if lost > SMALL * arm.limits.reach {
                notes.push(format!("{name} {what} {} -> 0", shown(lost)));
            }
        }
    }
    if small.0 > 0 {
        notes.push(format!("rounded without a line of their own: {} twists, off by at most {:.1e}", small.0, small.1));
    }
    let (far, turned) = difference(arm, rows);
    if far > 1e-12 * arm.limits.reach.max(1.0) || turned > 1e-12 {
        notes.push(format!(
            "the tip of the table is off that of the file by at most {far:.1e} m and {turned:.1e} rad (at sample poses); `--as-written` keeps every digit"
        ));
    }
    notes.extend(questions(arm, rows));
    for axis in &arm.axes {
        if let Some((low, high)) = &axis.limits
            && low.parse::<f64>().unwrap_or(0.0) > high.parse::<f64>().unwrap_or(0.0)
        {
            notes.push(format!("{}: its limits came reversed, {low} to {high}", axis.name));
        }
    }
    notes
}

fn line(joint: &str, what: &str, written: f64, taken: &str, off: f64) -> String {
    format!("{joint} {what} {} -> {taken}, off by {off:.1e}", shown(written))
}

/// The exact twist between axes i and i + 1; `None` where it is no exact angle.
fn twist(rows: &Rows, i: usize) -> Option<Angle> {
    let at = rows.links.iter().position(|l| l.axis == Some(i))?;
    let tilted = rows.links.get(at + 1).is_some_and(|l| l.axis.is_none());
    let alpha = rows.links[at].alpha;
    (alpha.is_exact() && !tilted).then_some(alpha)
}

/// The largest differences of position and direction between the table and the file, at sample poses.
fn difference(arm: &PlacedAxes, rows: &Rows) -> (f64, f64) {
    let motors = arm.motors();
    let mut worst = (0.0f64, 0.0f64);
    for sample in 0..8usize {
        let q: Vec<f64> = (0..motors)
            .map(|i| if sample == 0 { 0.0 } else { ((i * 7 + sample * 13) as f64 * 0.73).sin() * 2.5 })
            .collect();
        let (have, want) = (rows.pose(arm, &q), arm.written_pose(&q));
        let far: Vector = minus(have.p, want.p);
        worst = (worst.0.max(norm(far)), worst.1.max(have.r.back().times(&want.r).angle()));
    }
    worst
}

/// What is nearly exact, but too far off to be rounded without asking.
fn questions(arm: &PlacedAxes, rows: &Rows) -> Vec<String> {
    let mut list = Vec::new();
    for link in &rows.links {
        let Some(axis) = link.axis.and_then(|i| arm.axes.get(i + 1)) else { continue };
        let off = link.alpha.rest.abs();
        if off > 0.0 && link.alpha.steps % 6 == 0 && off <= 10.0 * arm.limits.angle && arm.limits.angle >= 1e-3 {
            let exact = Angle { rest: 0.0, ..link.alpha }.text();
            list.push(format!("{} twist is off {exact} by {off:.1e}: `--round` takes the exact one", axis.name));
        }
        if link.a > 0.0 && link.a <= 10.0 * arm.limits.length && arm.limits.angle >= 1e-3 {
            list.push(format!(
                "{} misses the axis before it by {} m only: `--round` takes 0",
                axis.name,
                number(link.a)
            ));
        }
    }
    list
}
