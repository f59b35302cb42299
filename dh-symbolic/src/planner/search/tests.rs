//! Tests of the search: plans of known arms, and arms whose usual equations vanish.

use super::*;
use crate::chain::Convention;
use crate::chain::samples::{KUKA, PUMA, UR5, chain};
use crate::chain::tests::revolute_chain;

fn outline(chain: &Chain) -> String {
    match search(chain) {
        Ok(plan) => plan
            .steps
            .iter()
            .map(|s| {
                let names: Vec<String> = s.unknown.iter().map(|f| plan.knowledge.form_name(&plan.axes, f)).collect();
                format!("{:?} {} ({})", s.kind, names.join(", "), s.roots)
            })
            .collect::<Vec<_>>()
            .join("\n"),
        Err(refusal) => format!("{refusal:?}"),
    }
}

#[test]
fn plans_of_known_arms() {
    let text = [PUMA, UR5, KUKA].map(|table| outline(&chain(table))).join("\n\n");
    insta::assert_snapshot!(text);
}

#[test]
fn a_second_ratio_stands_by_where_the_first_one_vanishes() {
    // A tool that points straight down: its direction does not say how the first joint stands, its position does.
    let five_axes = [
        (-90, "0.016", "0.349", 0),
        (0, "0.221", "0", 0),
        (0, "0.221", "0", 0),
        (90, "0", "0", 90),
        (0, "0", "0.145", 0),
    ];
    let plan = search(&revolute_chain(Convention::Standard, &five_axes)).unwrap();
    assert_eq!((plan.steps[0].kind, plan.steps[0].equations.len()), (StepKind::HalfTurn, 2));
}
