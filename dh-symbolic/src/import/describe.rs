//! What kind of arm a new table is: it is read, inverted, and described.

use super::Imported;
use super::problem::Problem;
use super::sheet::Sheet;
use crate::chain::table::parse;
use crate::chain::{Chain, ChainSpec, Settings};
use crate::diagnostic::lex;
use crate::planner::{self, Axes, NeighbourAxes, Plan, StepKind, Structure};

/// Reads the table that was made, chooses the joint to spare of an arm of seven, and says what is known of the arm.
pub(super) fn finish(mut sheet: Sheet, mut notes: Vec<String>) -> Result<Imported, Problem> {
    let spec = read(&sheet)?;
    let mut chain = Chain::new(spec.clone());
    notes.extend(structure(&chain));
    let mut plan = None;
    if chain.dof() == 7 {
        let best = (0..7).filter_map(|k| with_given(&spec, k)).min_by_key(effort);
        if let Some((k, found)) = best {
            sheet.settings.push(format!("redundant = q{}", k + 1));
            notes.push(format!("seven joints: the caller gives q{} (`redundant = q{};`)", k + 1, k + 1));
            chain = found.0;
            plan = Some(found.1);
        }
    } else if chain.dof() < 7 {
        plan = planner::search(&chain).ok();
    }
    match &plan {
        Some(plan) => notes.push(class(&chain, plan)),
        None => {
            sheet.settings.push("ik = none".into());
            notes.push(format!("{} joints: no inverse was found (`ik = none;`)", chain.dof()));
        }
    }
    Ok(Imported { table: sheet.text(), notes })
}

/// The table as the compiler reads it. What was written here must be in order; where the arm cannot be a table (too many rows),
/// the reason is the table's own.
fn read(sheet: &Sheet) -> Result<ChainSpec, Problem> {
    let text = sheet.text();
    let refused = |errors: crate::diagnostic::Errors| {
        let messages: Vec<String> = errors.in_order().iter().map(|e| e.message.clone()).collect();
        Problem::new(format!("the arm does not fit into a table: {}", messages.join("; ")))
            .help(format!("the table:\n{text}"))
    };
    let parsed = parse(lex(&text).map_err(refused)?);
    parsed.spec.ok_or_else(|| refused(parsed.errors))
}

/// The arm with one joint given, and its plan.
fn with_given(spec: &ChainSpec, joint: usize) -> Option<(usize, (Chain, Plan))> {
    let settings = Settings { redundant: vec![joint], ..spec.settings.clone() };
    let chain = Chain::new(ChainSpec { settings, ..spec.clone() });
    let plan = planner::search(&chain).ok()?;
    Some((joint, (chain, plan)))
}

/// How much work a plan is: closed forms before polynomials, polynomials before the general elimination. Equal ones: the joint that
/// is usually given (the elbow's or the last one).
fn effort((joint, (_, plan)): &(usize, (Chain, Plan))) -> (usize, usize, usize) {
    const USUAL: [usize; 7] = [2, 6, 0, 4, 3, 1, 5];
    let work = plan.steps.iter().map(|s| match s.kind {
        StepKind::General => 1000,
        StepKind::Bilinear | StepKind::LengthAndAngle => 50,
        StepKind::SecondHarmonic => 10,
        _ => 1,
    });
    (work.sum(), plan.max_solutions, USUAL.iter().position(|k| k == joint).unwrap_or(7))
}

/// Which axes are parallel, and which meet.
fn structure(chain: &Chain) -> Vec<String> {
    let found = Structure::new(chain, &Axes::new(chain));
    let mut notes = Vec::new();
    // Neighbours that are parallel make one group.
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for n in found.neighbours.iter().filter(|n| n.pair == NeighbourAxes::Parallel) {
        match groups.last_mut() {
            Some(group) if group.last() == Some(&n.first) => group.push(n.first + 1),
            _ => groups.push(vec![n.first, n.first + 1]),
        }
    }
    let listed = |group: &[usize]| {
        let names: Vec<String> = group.iter().map(|k| (k + 1).to_string()).collect();
        match names.split_last() {
            Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
            _ => names.concat(),
        }
    };
    notes.extend(groups.iter().map(|g| format!("axes {} are parallel", listed(g))));
    notes.extend(found.common_points.iter().map(|&k| format!("axes {} meet in one point", listed(&[k, k + 1, k + 2]))));
    let within = |n: usize| found.common_points.iter().any(|k| n == *k || n == k + 1);
    let meeting: Vec<String> = found
        .neighbours
        .iter()
        .filter(|n| n.pair == NeighbourAxes::Meeting && !within(n.first))
        .map(|n| listed(&[n.first, n.first + 1]))
        .collect();
    if !meeting.is_empty() {
        notes.push(format!("axes {} meet", meeting.join("; ")));
    }
    notes
}

/// The class of the arm in a line.
fn class(chain: &Chain, plan: &Plan) -> String {
    let has = |kind: StepKind| plan.steps.iter().any(|s| s.kind == kind);
    let way = if has(StepKind::General) {
        "the elimination of the general arm"
    } else if has(StepKind::Bilinear) || has(StepKind::LengthAndAngle) || has(StepKind::SecondHarmonic) {
        "closed form but for a polynomial in one unknown"
    } else {
        "closed form"
    };
    format!("{} joints; inverse by {way}, at most {} solutions", chain.dof(), plan.max_solutions)
}
