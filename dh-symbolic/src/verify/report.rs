//! The wording of verdicts on hand derivations, for `dh check`, compile errors and the errata page.

use crate::algebra::Poly;
use crate::program::Indicator;
use crate::render::formula::expression::Expression;
use crate::render::formula::grouping::Order;
use crate::render::formula::plain;
use crate::verify::check::{Condition, Edit, Example, Fault, FaultKind, Pair, Ratio, Repair, Report, Verdict};
use crate::verify::language::{Derivation, Line, Place, Token, TokenKind, line_text};
use std::fmt::Write;

/// Longer formulas are cut.
const LONGEST: usize = 600;
/// A line that is named in a message about another is cut here.
const SHORT_LINE: usize = 40;

/// What is to be said about one line: a headline, and details one per line of text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Remark {
    /// One sentence.
    pub headline: String,
    /// What more there is to say.
    pub details: Vec<String>,
    /// How to repair it, where that is known.
    pub repair: Option<String>,
    /// The words that it is about.
    pub place: Place,
}

fn cut(text: String) -> String {
    if text.chars().count() <= LONGEST {
        return text;
    }
    let head: String = text.chars().take(LONGEST).collect();
    format!("{head}...")
}

fn formula(report: &Report, p: &Poly) -> String {
    let mut groups = report.groups.clone();
    groups.dedup();
    plain::formula(&report.ring, &Order::new(groups), p)
}

/// A quotient of formulas.
pub fn ratio_text(report: &Report, x: &Ratio) -> String {
    if x.den.is_one() {
        return cut(formula(report, &x.num));
    }
    if let Some(q) = x.num.quotient(&x.den) {
        return cut(formula(report, &q));
    }
    let (top, below) = (formula(report, &x.num), formula(report, &x.den));
    let top = if top.contains(' ') { format!("({top})") } else { top };
    let simple = below.chars().all(|c| c.is_ascii_alphanumeric());
    cut(if simple { format!("{top}/{below}") } else { format!("{top}/({below})") })
}

/// `d2 >= 0`
pub fn condition_text(report: &Report, c: &Condition) -> String {
    let order = Order::new(report.groups.clone());
    let (e, turned) = match order.group(&c.formula) {
        Expression::Sum(mut terms) if terms.len() == 1 => {
            let only = terms.remove(0);
            (only.value, only.negative)
        }
        e => (e, false),
    };
    let sign = match (turned, c.strict) {
        (false, false) => ">=",
        (false, true) => ">",
        (true, false) => "<=",
        (true, true) => "<",
    };
    format!("{} {sign} 0", plain::expression(&report.ring, &e))
}

/// "the shoulder is left and the elbow is up"
pub fn configuration_text(parts: &[(Indicator, bool)]) -> Option<String> {
    let one = |(part, first): &(Indicator, bool)| match (part, first) {
        (Indicator::Shoulder, true) => "the shoulder is left",
        (Indicator::Shoulder, false) => "the shoulder is right",
        (Indicator::Elbow, true) => "the elbow is up",
        (Indicator::Elbow, false) => "the elbow is down",
        (Indicator::Wrist, true) => "the wrist is not flipped",
        (Indicator::Wrist, false) => "the wrist is flipped",
    };
    let words: Vec<&str> = parts.iter().map(one).collect();
    (!words.is_empty()).then(|| words.join(" and "))
}

/// `q1 = 12.3deg, q2 = 0.4`
fn example_text(e: &Example) -> String {
    let one = |(name, x, angle): &(String, f64, bool)| match angle {
        true => format!("{name} = {:.1}deg", x.to_degrees()),
        false => format!("{name} = {x:.4}"),
    };
    e.joints.iter().map(one).collect::<Vec<_>>().join(", ")
}

fn number(x: f64) -> String {
    let text = format!("{x:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

fn tokens_text(tokens: &[Token]) -> String {
    line_text(tokens).0
}

/// Does what is inserted belong to the word before it?
fn is_suffix(e: &Edit) -> bool {
    e.tokens.first().is_some_and(|t| t.is("^") || t.is("."))
}

/// "`s6` should be `c6`".
pub fn edit_text(tokens: &[Token], e: &Edit) -> String {
    let old = tokens_text(tokens.get(e.place.clone()).unwrap_or_default());
    let new = tokens_text(&e.tokens);
    let word = |k: usize| tokens.get(k).map(|t| t.text.clone()).unwrap_or_default();
    match (old.is_empty(), new.is_empty()) {
        (true, _) if is_suffix(e) => {
            format!("`{new}` is missing after `{}`", word(e.place.start.saturating_sub(1)))
        }
        (true, _) => format!("`{new}` is missing before `{}`", word(e.place.start)),
        (_, true) => format!("`{old}` is too much"),
        _ => format!("`{old}` should be `{new}`"),
    }
}

/// "`s5` should be `s6` and `c5` should be `c6`".
pub fn repair_text(tokens: &[Token], m: &Repair) -> String {
    m.edits.iter().map(|e| edit_text(tokens, e)).collect::<Vec<_>>().join(" and ")
}

/// The beginning of a line of the derivation.
fn short_line(d: &Derivation, line: usize) -> String {
    let text = d.lines.get(line).map(|l| d.text(&l.place)).unwrap_or_default();
    if text.chars().count() <= SHORT_LINE {
        return text;
    }
    text.chars().take(SHORT_LINE).collect::<String>() + "..."
}

fn fault_remark(report: &Report, d: &Derivation, f: &Fault) -> Remark {
    let at = f.entry.map_or_else(String::new, |(i, j)| format!("entry ({i},{j}): "));
    let mut r = Remark { place: f.place.clone(), ..Remark::default() };
    match &f.kind {
        FaultKind::Formula { correct, difference, .. } => {
            r.headline = format!("{at}printed - correct = {}", ratio_text(report, difference));
            r.details.push(format!("correct: {}", ratio_text(report, correct)));
        }
        FaultKind::Angle(difference) => {
            r.headline = format!("{at}these angles are not the same: {} is not zero", ratio_text(report, difference));
        }
        FaultKind::Opposite => r.headline = format!("{at}these angles differ by half a turn"),
        FaultKind::Definition(line) => {
            r.headline = format!("with this definition `{}` does not hold", short_line(d, *line));
        }
        FaultKind::Follows(line) => {
            r.headline = format!("follows from `{}`, which is wrong", short_line(d, *line));
        }
        FaultKind::AngleAt(example, pair) => {
            r.headline = format!("{at}these angles are not the same");
            if let Pair::Angles(x, y) = pair {
                let degrees = |x: f64| format!("{:.4}", x.to_degrees());
                let numbers =
                    format!("at {}: printed {}deg, correct {}deg", example_text(example), degrees(*x), degrees(*y));
                r.details.push(numbers);
            }
        }
        FaultKind::Nowhere(example, pair) => {
            let at_pose =
                if example.joints.is_empty() { String::new() } else { format!("; at {}", example_text(example)) };
            let degrees = |x: f64| format!("{}deg", number(x.to_degrees()));
            r.headline = match pair {
                Pair::Numbers(x, y) => {
                    format!("{at}this holds nowhere{at_pose}: printed {}, correct {}", number(*x), number(*y))
                }
                Pair::Angles(x, y) => {
                    format!("{at}this holds nowhere{at_pose}: printed {}, correct {}", degrees(*x), degrees(*y))
                }
                Pair::Matrices => format!("{at}this holds nowhere{at_pose}"),
            };
        }
        FaultKind::None(example) => {
            r.headline = match example.joints.is_empty() {
                true => "none of the possibilities holds".into(),
                false => format!("none of the possibilities holds at {}", example_text(example)),
            };
        }
        FaultKind::Number { printed, correct, tolerance, angle } => {
            let show = |x: f64| if *angle { format!("{}deg", number(x.to_degrees())) } else { number(x) };
            r.headline = format!("{at}printed {}, correct {}", show(*printed), show(*correct));
            r.details.push(format!("rounding explains no more than {}", show(*tolerance)));
        }
        FaultKind::Same => r.headline = "both sides are the same formula".into(),
        FaultKind::Order { left, right } => {
            r.headline = format!("not so: left {}, right {}", number(*left), number(*right));
        }
        FaultKind::Kind(angle) => {
            r.headline = format!("this is {}", if *angle { "an angle" } else { "a length" });
        }
    }
    r.repair = f.repair.as_ref().map(|m| repair_text(&d.tokens, m));
    r
}

/// What is to be said about a line; nothing for one that is in order.
pub fn remarks(report: &Report, d: &Derivation, verdict: &Verdict) -> Vec<Remark> {
    match verdict {
        Verdict::Noted | Verdict::Proven(_) | Verdict::Agrees => vec![],
        Verdict::Wrong(faults) => {
            // where no entry is written out, the repair stands with the first fault
            faults.iter().map(|f| fault_remark(report, d, f)).collect()
        }
        Verdict::NotUnderstood(n, repair) => vec![Remark {
            headline: n.why.clone(),
            repair: repair.as_ref().map(|m| repair_text(&d.tokens, m)),
            place: n.place.clone(),
            ..Remark::default()
        }],
    }
}

/// A verdict as an error: where, what, and what to write instead. One for every place of the line that is wrong.
pub fn complaints(report: &Report, d: &Derivation, verdict: &Verdict) -> Vec<(Place, String, Option<String>)> {
    let mut out: Vec<(Place, String, Option<String>)> = Vec::new();
    let mut shown: Option<Place> = None;
    for (k, r) in remarks(report, d, verdict).into_iter().enumerate() {
        let text = if r.repair.is_some() { r.headline } else { [vec![r.headline], r.details].concat().join("\n") };
        match out.last_mut().filter(|_| shown.as_ref() == Some(&r.place)) {
            Some(last) => last.1 = format!("{}\n{text}", last.1),
            None => {
                let place =
                    marks(verdict, k, &Remark { place: r.place.clone(), ..Remark::default() }).into_iter().next();
                let word = if matches!(verdict, Verdict::Wrong(_)) { "this line is wrong: " } else { "" };
                out.push((place.unwrap_or(r.place.clone()), format!("{word}{text}"), r.repair));
            }
        }
        shown = Some(r.place);
    }
    out
}

/// One word for a verdict.
pub fn verdict_word(v: &Verdict) -> &'static str {
    match v {
        Verdict::Noted => "noted",
        Verdict::Proven(_) => "proven",
        Verdict::Agrees => "agrees",
        Verdict::Wrong(_) => "wrong",
        Verdict::NotUnderstood(..) => "unclear",
    }
}

/// The words that a remark points at: those of its repair, where there is one.
fn marks(v: &Verdict, k: usize, r: &Remark) -> Vec<Place> {
    let repair = match v {
        Verdict::Wrong(faults) => faults.get(k).and_then(|f| f.repair.as_ref()),
        Verdict::NotUnderstood(_, repair) => repair.as_ref(),
        _ => None,
    };
    // an insertion is shown at the word that it belongs to
    let shown = |e: &Edit| match (e.place.is_empty(), is_suffix(e)) {
        (false, _) => e.place.clone(),
        (true, true) => e.place.start.saturating_sub(1)..e.place.start,
        (true, false) => e.place.start..e.place.start + 1,
    };
    repair.map_or_else(|| vec![r.place.clone()], |m| m.edits.iter().map(shown).collect())
}

/// One line with its verdict, as plain text; what is wrong is underlined.
pub fn line_report(report: &Report, d: &Derivation, line: &Line, verdict: &Verdict) -> String {
    let (text, details) = line_details(report, d, line, verdict);
    let mut out = format!("{:<7} {text}\n", verdict_word(verdict));
    for detail in details {
        let _ = writeln!(out, "        {detail}");
    }
    out
}

/// The text of a line, and what is to be said about it, one line of text each; carets under what is wrong stand as if the text began in
/// their first column.
pub(super) fn line_details(report: &Report, d: &Derivation, line: &Line, verdict: &Verdict) -> (String, Vec<String>) {
    let tokens = d.tokens.get(line.place.clone()).unwrap_or_default();
    let (text, columns) = line_text(tokens);
    let mut out = Vec::new();
    if let Verdict::Proven(w) = verdict
        && !w.is_everywhere()
    {
        let all: Vec<String> = w.conditions.iter().map(|c| condition_text(report, c)).collect();
        let condition = all.join(" and ");
        out.push(match configuration_text(&w.configuration) {
            Some(words) => format!("where {words}: {condition}"),
            None => format!("where {condition}"),
        });
        if let Some(e) = w.example.as_ref().filter(|e| !e.joints.is_empty()) {
            out.push(format!("for example {}", example_text(e)));
        }
    }
    let mut shown: Option<Place> = None;
    for (k, r) in remarks(report, d, verdict).into_iter().enumerate() {
        // a line that could not be read is one word
        let whole = matches!(tokens, [only] if only.kind == TokenKind::Other);
        if shown.as_ref() != Some(&r.place) && !whole {
            out.push(carets(&marks(verdict, k, &r), line.place.start, tokens, &columns, text.chars().count()));
            shown = Some(r.place.clone());
        }
        out.push(r.headline);
        match r.repair {
            Some(repair) => out.push(repair),
            None => out.extend(r.details),
        }
    }
    (text, out)
}

/// `^^` under the words of some places.
fn carets(places: &[Place], from: usize, tokens: &[Token], columns: &[usize], width: usize) -> String {
    let mut carets = String::new();
    for place in places {
        let first = place.start.saturating_sub(from);
        let last = place.end.saturating_sub(from).max(first + 1) - 1;
        let start = columns.get(first).copied().unwrap_or(width);
        let end = match (columns.get(last), tokens.get(last)) {
            (Some(c), Some(t)) => c + t.text.chars().count(),
            _ => start + 1,
        };
        for k in carets.len()..end {
            carets.push(if k < start { ' ' } else { '^' });
        }
    }
    carets
}

/// All lines with their verdicts, as plain text.
pub fn derivation_report(report: &Report, d: &Derivation) -> String {
    let mut out = String::new();
    for (line, v) in d.lines.iter().zip(&report.verdicts) {
        if !line.note.is_empty() {
            let _ = writeln!(out, "// {}", line.note.split(" Correct: ").next().unwrap_or(""));
        }
        out.push_str(&line_report(report, d, line, v));
    }
    out
}
