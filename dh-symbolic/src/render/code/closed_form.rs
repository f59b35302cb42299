//! The closed form of the pose as text, for the documentation of generated code.

use crate::algebra::{Poly, Transform};
use crate::chain::Chain;
use crate::kinematics::Kinematics;
use crate::render::formula::expression::Expression;
use crate::render::formula::grouping::Order;
use crate::render::formula::math::{Math, Sign};
use crate::render::formula::notation::Notation;
use crate::render::formula::quantities::{constants, named_offsets, relations};
use crate::render::formula::text;

/// A pose with more terms than this is not written out: nobody would read it, and a macro has better things to do.
const MOST_TERMS: usize = 500;
/// Glyphs on a line.
const WIDTH: usize = 84;

/// The pose in closed form.
pub(in crate::render) struct ClosedForm {
    /// What the formulas are, or why there are none.
    pub(in crate::render) heading: String,
    /// The formulas in lines, with what their abbreviations mean; empty where nobody would read them.
    pub(in crate::render) formulas: String,
}

/// Markdown for the documentation of the generated type.
pub fn rustdoc(chain: &Chain, kinematics: &Kinematics) -> String {
    let ClosedForm { heading, formulas } = closed_form(chain, kinematics);
    if formulas.is_empty() { format!("\n{heading}\n") } else { format!("\n{heading}\n\n```text\n{formulas}```\n") }
}

/// The pose of the tool in the base. Names are those of the code: q1, q2, and the fields.
pub(in crate::render) fn closed_form(chain: &Chain, kinematics: &Kinematics) -> ClosedForm {
    let named = named_offsets(chain);
    let own;
    let kinematics = if named.is_some() {
        own = Kinematics::new(named.as_ref().unwrap_or(chain));
        &own
    } else {
        kinematics
    };
    let chain = named.as_ref().unwrap_or(chain);
    let pose = kinematics.pose();
    let count: usize = entries(&pose).map(|(_, _, p)| p.terms().len()).sum();
    if count > MOST_TERMS {
        let heading = format!("The pose in closed form has {count} terms; `dh notes` derives it step by step.");
        return ClosedForm { heading, formulas: String::new() };
    }
    let (order, notation) = (Order::of(chain), Notation::of_code(chain));
    let list: Vec<(usize, usize, Expression)> = entries(&pose).map(|(i, j, p)| (i, j, order.group(p))).collect();
    let end = if chain.tool.is_empty() { "last frame" } else { "tool" };
    let heading = format!("Pose of the {end} in the base, rotation and translation:");
    let mut out = String::new();
    let cells: Vec<Vec<Math>> =
        (0..3).map(|i| list.iter().filter(|e| e.0 == i).map(|e| notation.typeset(&e.2)).collect()).collect();
    let wide: usize =
        (0..4).map(|j| 2 + cells.iter().filter_map(|r| r.get(j)).map(Math::glyphs).max().unwrap_or(0)).sum();
    if wide <= WIDTH {
        out.push_str(&text::display(&Math::Matrix(cells)));
    } else {
        let mut columns: Vec<&(usize, usize, Expression)> = list.iter().collect();
        columns.sort_by_key(|e| (e.1, e.0));
        for (i, j, e) in columns {
            let left = match j {
                3 => format!("p{} ", ["x", "y", "z"].get(*i).unwrap_or(&"")),
                _ => text::math(&Math::Letter('r').below(Math::number(format!("{}{}", i + 1, j + 1)))),
            };
            for (k, line) in notation.typeset(e).lines(WIDTH).iter().enumerate() {
                out.push_str(&if k == 0 { format!("{left} = ") } else { " ".repeat(6) });
                out.push_str(&text::math(line));
                out.push('\n');
            }
        }
    }
    let expressions = list.iter().map(|e| &e.2);
    let mut meanings: Vec<Math> = notation.legend(expressions);
    meanings.extend(relations(chain, &notation, &order).into_iter().map(|(left, right)| Math::equation(left, right)));
    meanings.extend(constants(chain, &notation, &pose));
    paragraph(&meanings, &mut out);
    ClosedForm { heading, formulas: out }
}

fn entries(t: &Transform) -> impl Iterator<Item = (usize, usize, &Poly)> {
    let rotation = |i: usize| t.r.get(i).into_iter().flatten().enumerate().map(move |(j, p)| (i, j, p));
    (0..3).flat_map(move |i| rotation(i).chain(t.p.get(i).map(|p| (i, 3, p))))
}

/// `where ...`, several meanings on a line.
fn paragraph(meanings: &[Math], out: &mut String) {
    let mut line = String::from("\nwhere");
    let mut between = " ";
    for m in meanings {
        let text = text::math(m);
        line.push_str(between.trim_end());
        if line.chars().count() + text.chars().count() > WIDTH + 8 {
            out.push_str(&line);
            line = String::from("\n     ");
        }
        line.push(' ');
        line.push_str(&text);
        let commas = m.clone().flatten().iter().any(|x| matches!(x, Math::Sign(Sign::Comma | Sign::Dots)));
        between = if commas { "; " } else { ", " };
    }
    if !meanings.is_empty() {
        out.push_str(&line);
        out.push('\n');
    }
}
