//! A plan for paper: the structure that was found, every step with its equation, its branches and where it degenerates; and the
//! same as a Mermaid graph.

use super::document::{Block, Document, Span, Text};
use crate::algebra::{Poly, Ring};
use crate::chain::{Chain, Coordinate};
use crate::planner::{Collected, Equation, Pair, Part, Plan, Refusal, Scalar, Step, StepKind, Structure};

fn plain(text: impl Into<String>) -> Text {
    Text(vec![Span::Plain(text.into())])
}

/// The plan of an arm, or why there is none.
pub fn plan(chain: &Chain, found: &Result<Plan, Refusal>) -> Document {
    let title = format!("Inverse kinematics of {}", chain.name);
    let mut out = Document { title, language: "en", blocks: Vec::new() };
    match found {
        Ok(plan) => {
            structure(chain, plan, &mut out);
            out.blocks.push(Block::Heading(2, plain("Steps")));
            out.blocks.push(Block::Paragraph(plain(
                "W is the target pose as the first and the last joint see it, with entries r11..r33, px, py, pz; pp = p.p and b = -R^T p. \
                 A prefix (a_, b_, ...) marks W brought back over joints that are known by then.",
            )));
            for (i, step) in plan.steps.iter().enumerate() {
                steps(plan, i, step, &mut out);
            }
            let product: Vec<String> = plan.steps.iter().map(|s| s.roots.to_string()).collect();
            out.blocks.push(Block::Paragraph(plain(format!(
                "At most {} solutions ({}).",
                plan.max_solutions,
                product.join(" x ")
            ))));
            out.blocks.push(Block::Code("mermaid", mermaid(plan)));
        }
        Err(refusal) => {
            let names: Vec<&str> =
                refusal.open.iter().filter_map(|k| chain.joints.get(*k)).map(|j| j.name.as_str()).collect();
            let solved = if refusal.solved.is_empty() { "nothing".to_string() } else { refusal.solved.join(", ") };
            out.blocks.push(Block::Paragraph(plain(format!(
                "No plan: {solved} can be found, {} stay open.",
                names.join(", ")
            ))));
        }
    }
    out
}

fn structure(chain: &Chain, plan: &Plan, out: &mut Document) {
    let found = Structure::new(chain, &plan.axes);
    out.blocks.push(Block::Heading(2, plain("Structure")));
    let mut lines = Vec::new();
    for n in &found.neighbours {
        let (a, b) = (n.first + 1, n.first + 2);
        let how = match n.pair {
            Pair::Parallel => "are parallel",
            Pair::Meeting => "meet",
            Pair::Skew => "are skew",
        };
        let cells = if n.cells.is_empty() { String::new() } else { format!(" ({})", n.cells.join(", ")) };
        lines.push(plain(format!("Axes {a} and {b} {how}{cells}.")));
    }
    for first in &found.common_points {
        lines.push(plain(format!("Axes {}, {} and {} pass through one point.", first + 1, first + 2, first + 3)));
    }
    if lines.is_empty() {
        lines.push(plain("One joint only."));
    }
    out.blocks.push(Block::List(lines));
}

fn unknowns(plan: &Plan, step: &Step) -> String {
    step.unknown.iter().map(|f| plan.knowledge.form_name(&plan.axes, f)).collect::<Vec<_>>().join(", ")
}

/// The textbook's name of a method, and when it degenerates.
fn method(kind: StepKind) -> (&'static str, &'static str) {
    match kind {
        StepKind::Linear => ("linear equation", "its coefficient vanishes: the slide is free"),
        StepKind::Quadratic => ("quadratic equation", "both roots coincide where the discriminant vanishes"),
        StepKind::HalfTurn => (
            "a cos u + b sin u = 0, u = atan2(-a, b) or half a turn further",
            "a = b = 0: the angle is free (a singular pose)",
        ),
        StepKind::SinCos => (
            "a cos u + b sin u = c, u = atan2(b, a) +- acos(c / sqrt(a^2 + b^2)); of squared distances, the law of cosines",
            "|c| = sqrt(a^2 + b^2): both roots coincide (stretched or folded); |c| larger: out of reach; a = b = c = 0: the angle is free",
        ),
        StepKind::AtanPair => (
            "two equations linear in sine and cosine, u = atan2(sin u, cos u)",
            "the equations become dependent: the angle is free",
        ),
        StepKind::SecondHarmonic => {
            ("trigonometric polynomial of second degree (tangent half-angle quartic)", "coinciding roots")
        }
        StepKind::Bilinear => (
            "two equations, each linear in both sines and cosines: one angle is eliminated, the other one solves a trigonometric \
             polynomial (Pieper's quartic where they are distances from the first axis)",
            "coinciding roots, or a common curve of solutions",
        ),
        StepKind::SlideAndTurn => {
            ("two equations in a length and an angle: the length is eliminated", "coinciding roots")
        }
        StepKind::General => (
            "elimination of the general six-axis arm (Raghavan and Roth): a trigonometric polynomial of degree 8 in one angle",
            "coinciding roots, or a continuum of solutions",
        ),
        StepKind::Choose => ("free at every pose of this arm: 0 is chosen", "always"),
    }
}

fn steps(plan: &Plan, i: usize, step: &Step, out: &mut Document) {
    let (how, degenerate) = method(step.kind);
    let roots = if step.roots == 1 { "one solution".to_string() } else { format!("up to {} solutions", step.roots) };
    out.blocks.push(Block::Heading(3, plain(format!("{}. {} ({roots})", i + 1, unknowns(plan, step)))));
    let mut text = String::new();
    for (e, c) in step.equations.iter().zip(&step.collected) {
        text.push_str(&format!("{}:\n", source(plan, e)));
        text.push_str(&format!("    {} = 0\n", equation(plan, step, c)));
    }
    if !text.is_empty() {
        out.blocks.push(Block::Code("text", text));
    }
    out.blocks.push(Block::List(vec![plain(format!("Method: {how}.")), plain(format!("Degenerates: {degenerate}."))]));
}

/// Where an equation comes from, in words.
fn source(plan: &Plan, e: &Equation) -> String {
    let name = |frame: usize| -> String {
        let joints: Vec<usize> = plan.axes.hops[..frame].iter().filter_map(|h| h.joint).collect();
        let after = joints.last().map_or("the base".to_string(), |j| format!("joint {}", j + 1));
        let shifted = frame > 0 && plan.axes.hops[frame - 1].joint.is_none();
        if shifted { format!("{after} (after its shift d)") } else { after }
    };
    let what = match e.scalar {
        Scalar::Rotation(i, j) => format!("direction cosine ({}, {})", i + 1, j + 1),
        Scalar::Position(i) => format!("{} of the position", ["x", "y", "z"][usize::from(i) % 3]),
        Scalar::Back(i) => format!("{} of the position seen from the far end", ["x", "y", "z"][usize::from(i) % 3]),
        Scalar::Distance => "squared distance".to_string(),
    };
    format!("{what} between {} and {}", name(e.a), name(e.b))
}

fn equation(plan: &Plan, step: &Step, c: &Collected) -> String {
    let ring: &Ring = &plan.knowledge.ring;
    let part = |p: Part, unknown: usize| -> Option<String> {
        let name = plan.knowledge.form_name(&plan.axes, &step.unknown[unknown]);
        let inner = |n: u8| if n == 1 { name.clone() } else { format!("{n}({name})") };
        match p {
            Part::One => None,
            Part::Cos(n) => Some(format!("cos({})", inner(n))),
            Part::Sin(n) => Some(format!("sin({})", inner(n))),
            Part::Power(1) => Some(name),
            Part::Power(n) => Some(format!("{name}^{n}")),
        }
    };
    let mut out = String::new();
    // Unknowns first, what is known last.
    for (key, p) in c.iter().rev() {
        let factors: Vec<String> = key.iter().enumerate().filter_map(|(i, x)| part(*x, i)).collect();
        let single = p.terms().len() == 1;
        let negative = single && p.terms()[0].1.is_negative();
        let magnitude: Poly = if negative { -p } else { p.clone() };
        let text = ring.text(&magnitude);
        let term = match (factors.is_empty(), magnitude.is_one(), single) {
            (true, _, _) => text,
            (false, true, _) => factors.join("*"),
            (false, false, true) => format!("{text}*{}", factors.join("*")),
            (false, false, false) => format!("({text})*{}", factors.join("*")),
        };
        let term = if factors.is_empty() && !single && !out.is_empty() { format!("({term})") } else { term };
        out.push_str(match (out.is_empty(), negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        });
        out.push_str(&term);
    }
    out
}

/// The plan as a Mermaid flow chart.
pub fn mermaid(plan: &Plan) -> String {
    let mut out = String::from("flowchart TD\n    W[target pose W]\n");
    for (i, step) in plan.steps.iter().enumerate() {
        let roots = if step.roots == 1 { String::new() } else { format!(" x{}", step.roots) };
        let before = if i == 0 { "W".to_string() } else { format!("S{i}") };
        out.push_str(&format!("    {before} --> S{}[\"{}{roots}\"]\n", i + 1, unknowns(plan, step)));
    }
    let joints: Vec<String> = plan
        .axes
        .coordinates
        .iter()
        .take(plan.axes.real)
        .map(|c| match c {
            Coordinate::Angle(v) => plan.knowledge.ring.angle_name(*v).to_string(),
            Coordinate::Length(s) => plan.knowledge.ring.symbol_name(*s).to_string(),
        })
        .collect();
    out.push_str(&format!("    S{} --> Q([\"{}\"])\n", plan.steps.len(), joints.join(", ")));
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planner::search;
    use crate::render::{Format, samples};

    #[test]
    fn plans_on_paper() {
        let text: Vec<String> = [samples::PUMA, samples::UR5, samples::SCARA, samples::STANFORD]
            .into_iter()
            .map(samples::chain)
            .map(|chain| plan(&chain, &search(&chain)).print(Format::Text))
            .collect();
        insta::assert_snapshot!(text.join("\n\n"));
    }
}
