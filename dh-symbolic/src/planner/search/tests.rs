//! Plans of known arms, and what a search takes where equations vanish.

use super::super::step::StepKind;
use super::*;
use crate::chain::Convention;
use crate::chain::tests::revolute_chain;

fn outline(convention: Convention, rows: &[(i64, &str, &str, i64)]) -> String {
    let chain = revolute_chain(convention, rows);
    match search(&chain) {
        Ok(plan) => plan
            .steps
            .iter()
            .map(|s| {
                let names: Vec<String> = s.unknown.iter().map(|f| plan.knowledge.form_name(&plan.axes, f)).collect();
                format!("{:?} {} ({})", s.kind, names.join(", "), s.roots)
            })
            .collect::<Vec<_>>()
            .join("\n"),
        Err(r) => format!("stuck after {:?}, open {:?}", r.solved, r.open),
    }
}

#[test]
fn plans_of_known_arms() {
    let puma = [
        (0, "0", "0", 0),
        (-90, "0", "0", 0),
        (0, "0.4318", "0.15005", 0),
        (-90, "0.0203", "0.4318", 0),
        (90, "0", "0", 0),
        (-90, "0", "0", 0),
    ];
    let ur5 = [
        (90, "0", "0.089159", 0),
        (0, "-0.425", "0", 0),
        (0, "-0.39225", "0", 0),
        (90, "0", "0.10915", 0),
        (-90, "0", "0.09465", 0),
        (0, "0", "0.0823", 0),
    ];
    let kuka = [
        (-90, "0.025", "0.4", 0),
        (0, "0.315", "0", -90),
        (-90, "0.035", "0", 0),
        (90, "0", "0.365", 0),
        (-90, "0", "0", 0),
        (0, "0", "0.08", 0),
    ];
    let text = [
        outline(Convention::Modified, &puma),
        outline(Convention::Standard, &ur5),
        outline(Convention::Standard, &kuka),
    ]
    .join("\n\n");
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
