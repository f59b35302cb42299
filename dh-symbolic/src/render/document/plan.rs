//! The plan of the inverse kinematics at a glance: a table of steps, and the flow from the pose to the joints.

use super::explanation::{Explanation, StepExplanation};
use super::notes::words::Phrase;
use super::{Block, Document, Format, Span, Text};
use crate::chain::Chain;
use crate::planner::{Axes, NeighbourAxes, Plan, Refusal, Structure};
use crate::program::Inverse;
use crate::render::Language;
use crate::render::formula::math::Math;
use crate::render::formula::notation::Notation;
use crate::render::formula::quantities::named_offsets;
use crate::render::formula::text;
use std::fmt::{self, Write};

/// How an arm is inverted: steps as data, as a document, as a flow chart. `Display` prints the document as text.
#[derive(Clone, Debug)]
pub struct InversePlan {
    chain: Chain,
    plan: Plan,
}

/// One step of a plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanStep {
    /// What it finds: joint angles, lengths of slides, sums of them.
    pub finds: Vec<String>,
    /// How, by the textbook's name: `the law of cosines`.
    pub method: &'static str,
    /// The steps before (from 0) whose results it uses.
    pub needs: Vec<usize>,
    /// Most solutions that it has.
    pub solutions: usize,
}

impl InversePlan {
    /// Plans an arm and tries the plan on sample poses.
    ///
    /// # Errors
    /// Why the arm has no inverse.
    #[doc(hidden)]
    pub fn new(chain: &Chain) -> Result<InversePlan, Refusal> {
        let chain = named_offsets(chain).unwrap_or_else(|| chain.clone());
        let plan = Inverse::of(&chain)?.plan;
        Ok(InversePlan { chain, plan })
    }

    fn explanation(&self) -> Explanation<'_> {
        Explanation::new(&self.chain, &self.plan, &Notation::textbook(&self.chain))
    }

    /// The steps in order.
    pub fn steps(&self) -> Vec<PlanStep> {
        let step = |s: &StepExplanation| PlanStep {
            finds: s.unknown.iter().map(text::math).collect(),
            method: Language::English.of(s.words.name),
            needs: s.needs.clone(),
            solutions: s.roots,
        };
        self.explanation().steps.iter().map(step).collect()
    }

    /// Most solutions that a target has.
    pub fn max_solutions(&self) -> usize {
        self.plan.max_solutions
    }

    /// What the axes have in common, the steps (what each finds, how, from which earlier steps, how many solutions, where it fails),
    /// their equations, the flow chart.
    pub fn document(&self, language: Language) -> Document {
        let title = Phrase::PlanTitle.in_language(language).replace("{}", &self.chain.name);
        let explanation = self.explanation();
        let mut blocks = structure(&self.chain, language);
        let poses = self.chain.left_out();
        if !poses.is_empty() {
            let names = Text::join(poses.iter().map(|p| Text(vec![Span::Code((*p).to_string())])), ", ");
            let mut text = Text::default();
            for (i, part) in Phrase::LeftOutOfPlan.in_language(language).split("{}").enumerate() {
                if i > 0 {
                    text.0.extend(names.0.clone());
                }
                text.0.push(Span::Plain(part.to_string()));
            }
            blocks.push(Block::Paragraph(text));
        }
        blocks.extend(steps(&explanation, language));
        blocks.push(Block::Code("mermaid", chart(&explanation, language)));
        Document { title, subtitle: None, fragment: false, language: language.tag(), blocks }
    }

    /// The flow chart alone, as Mermaid reads it.
    pub fn mermaid(&self, language: Language) -> String {
        chart(&self.explanation(), language)
    }
}

impl fmt::Display for InversePlan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.document(Language::English).print(Format::Text))
    }
}

/// Which neighbouring axes are parallel or meet, by which cells of the table.
fn structure(chain: &Chain, language: Language) -> Vec<Block> {
    let found = Structure::new(chain, &Axes::new(chain));
    let number = |n: usize| Span::Plain(n.to_string());
    let mut lines = Vec::new();
    for n in &found.neighbours {
        let phrase = match n.pair {
            NeighbourAxes::Parallel => Phrase::AxesParallel,
            NeighbourAxes::Meeting => Phrase::AxesMeet,
            NeighbourAxes::Skew => Phrase::AxesSkew,
        };
        let pieces = vec![number(n.first + 1), number(n.first + 2)];
        let mut line = Text::fill(phrase.in_language(language), pieces);
        if !n.cells.is_empty() {
            line.0.push(Span::Plain(": ".into()));
            line.0.push(Span::Code(n.cells.join(", ")));
        }
        lines.push(line);
    }
    for first in &found.common_points {
        let pieces = (1..=3).map(|k| number(first + k)).collect();
        lines.push(Text::fill(Phrase::AxesPoint.in_language(language), pieces));
    }
    if lines.is_empty() { Vec::new() } else { vec![Block::List(lines)] }
}

fn steps(explanation: &Explanation<'_>, language: Language) -> Vec<Block> {
    let words = |p: Phrase| p.in_language(language);
    let header = [
        Phrase::PlanStep,
        Phrase::PlanFinds,
        Phrase::PlanFrom,
        Phrase::PlanNeeds,
        Phrase::PlanMost,
        Phrase::PlanNone,
        Phrase::PlanFree,
    ]
    .map(|p| Text::from(words(p)));
    let list = |items: &[Math]| Text::join(items.iter().cloned().map(Text::from), ", ");
    let rows = explanation
        .steps
        .iter()
        .enumerate()
        .map(|(i, s)| {
            let needs: Vec<String> = s.needs.iter().map(|k| (k + 1).to_string()).collect();
            vec![
                (i + 1).to_string().into(),
                list(&s.unknown),
                language.of(s.words.name).into(),
                needs.join(", ").into(),
                s.roots.to_string().into(),
                s.solution.radicand.as_ref().map_or(Text::default(), |m| {
                    let mut t = Text::from(m.clone());
                    t.0.push(Span::Plain(" < 0".into()));
                    t
                }),
                list(&s.solution.degenerate),
            ]
        })
        .collect();
    let mut blocks = vec![Block::Table(header.to_vec(), rows)];
    let equations = explanation.steps.iter().flat_map(|s| &s.equations);
    let list: Vec<_> = equations
        .map(|(left, right)| super::Equation { left: left.clone(), right: vec![right.clone()], number: None })
        .collect();
    if !list.is_empty() {
        blocks.push(Block::Paragraph(words(Phrase::PlanEquations).into()));
        blocks.push(Block::Equations(list));
    }
    let poses = explanation.poses.iter().filter_map(|p| Some((p.matrix.clone(), p.product.clone()?)));
    let poses: Vec<_> = poses.map(|(left, right)| super::Equation { left, right: vec![right], number: None }).collect();
    if !poses.is_empty() {
        blocks.push(Block::Paragraph(words(Phrase::PlanPoses).into()));
        blocks.push(Block::Equations(poses));
    }
    let differences = explanation.differences();
    if !differences.is_empty() {
        let list = differences
            .into_iter()
            .map(|(left, right)| super::Equation { left, right: vec![right], number: None })
            .collect();
        blocks.push(Block::Paragraph(words(Phrase::Differences).into()));
        blocks.push(Block::Equations(list));
    }
    let product: Vec<String> = explanation.steps.iter().map(|s| s.roots.to_string()).collect();
    let pieces = vec![Span::Plain(explanation.plan.max_solutions.to_string()), Span::Plain(product.join(" × "))];
    blocks.push(Block::Paragraph(Text::fill(words(Phrase::PlanTotal), pieces)));
    blocks
}

fn chart(explanation: &Explanation<'_>, language: Language) -> String {
    let mut out = format!("flowchart TD\n  pose([\"{}\"])\n", Phrase::PlanPose.in_language(language));
    for (i, s) in explanation.steps.iter().enumerate() {
        let _ = writeln!(out, "  s{}[\"{}\"]", i + 1, label(s, language));
    }
    for (i, s) in explanation.steps.iter().enumerate() {
        if s.needs.is_empty() {
            let _ = writeln!(out, "  pose --> s{}", i + 1);
        }
        for k in direct(explanation, i) {
            let _ = writeln!(out, "  s{} --> s{}", k + 1, i + 1);
        }
    }
    out
}

fn label(s: &StepExplanation, language: Language) -> String {
    let unknown: Vec<String> = s.unknown.iter().map(text::math).collect();
    let count = if s.roots > 1 { format!(" (×{})", s.roots) } else { String::new() };
    format!("{}: {}{count}", unknown.join(", "), language.of(s.words.name))
}

/// Steps that step `i` needs, without those that another needed step needs already.
fn direct(explanation: &Explanation<'_>, i: usize) -> Vec<usize> {
    let needs = |k: usize| explanation.steps.get(k).map_or(&[][..], |s| &s.needs);
    needs(i).iter().copied().filter(|k| !needs(i).iter().any(|other| needs(*other).contains(k))).collect()
}
