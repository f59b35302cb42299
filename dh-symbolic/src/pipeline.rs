//! The whole way, from tokens to output, in one screen.

use crate::chain::table::{Claims, Parsed, Sketch, parse};
use crate::chain::{Chain, Scalar, Task};
use crate::diagnostic::{Error, Errors, Place};
use crate::kinematics::{Kinematics, claims};
use crate::planner;
use crate::program::{Forward, Inverse};
use crate::render::rust::{self, Head};
use crate::render::rustdoc;
use crate::render::verdict::complaints;
use proc_macro2::{Ident, Span, TokenStream};

/// Expands the body of `dh_robot!`: items, or errors beside a stub of the type.
pub fn expand(input: TokenStream) -> TokenStream {
    let (items, errors) = compile(input);
    let mut out = errors.to_compile_errors();
    out.extend(items);
    out
}

/// The items of a table, and what is wrong with it: then the items are a stub of the type.
pub fn compile(input: TokenStream) -> (TokenStream, Errors) {
    let mut parsed = parse(input);
    let head = head(&parsed);
    let items =
        parsed.spec.take().filter(|_| parsed.errors.is_empty()).map(|spec| items(&head, Chain::new(spec), &mut parsed));
    let items = match items {
        Some(items) if parsed.errors.is_empty() => items,
        _ => stub(&head, &parsed.sketch),
    };
    (items, parsed.errors)
}

/// The items of a robot whose table is in order.
fn items(head: &Head, chain: Chain, parsed: &mut Parsed) -> TokenStream {
    check_derivation(&chain, parsed);
    match Forward::derive(&chain) {
        Ok(forward) => {
            let inverse = if chain.ik { inverse(head, &chain, &forward, parsed) } else { String::new() };
            rust::robot(head, &chain, &forward, &inverse, &rustdoc(&chain, &Kinematics::new(&chain)))
        }
        Err(difference) => {
            let text = format!("{difference}; this is a defect of dh-symbolic");
            parsed.errors.push(Error::new(Place::at(head.ident.span()), text));
            TokenStream::new()
        }
    }
}

/// Checks the lines of `prove` blocks: a wrong one is an error where it is wrong.
fn check_derivation(chain: &Chain, parsed: &mut Parsed) {
    if parsed.claims.is_empty() {
        return;
    }
    let claims = Claims::read(&parsed.claims);
    let report = claims::check(chain, &claims.derivation);
    for verdict in &report.verdicts {
        for (place, message, help) in complaints(&report, &claims.derivation, verdict) {
            let mut error = Error::new(claims.place(&place).unwrap_or_else(Place::call_site), message);
            error.help = help;
            parsed.errors.push(error);
        }
    }
}

/// The text of everything inverse; errors at the cells where the planner got stuck.
fn inverse(head: &Head, chain: &Chain, forward: &Forward, parsed: &mut Parsed) -> String {
    // Never more than six joints at once: a plan that leaves one to chance would be found, and fail.
    let free = chain.dof() - usize::from(chain.redundant.is_some());
    if free > 6 {
        let text = format!(
            "{free} joints leave the inverse open: say which one the caller chooses, `redundant = q3;`, or `ik = none;`"
        );
        parsed.errors.push(Error::new(parsed.origins.name, text));
        return String::new();
    }
    let tilting = if chain.task == Task::Planar { planner::tilting_joints(chain) } else { Vec::new() };
    if !tilting.is_empty() {
        for joint in tilting {
            let name = chain.joints.get(joint).map_or("", |j| j.name.as_str());
            let text = format!("`{name}` tilts the tool, and `task = planar` asks for x, y and the angle about z only");
            let help = "turning axes must be parallel to z of the base (`base = rx(90deg);` and the like turn the arm), or take another task";
            parsed.errors.push(Error::new(parsed.origins.joint(joint), text).help(help));
        }
        return String::new();
    }
    if chain.task == Task::Planar && planner::is_upright(chain) {
        let text = "`task = planar` asks for the angle of the tool's x axis about z, and this axis points along z";
        let help = "turn the tool, `tool = ry(90deg);` for example, so that its x axis lies in the plane; or take another task";
        parsed.errors.push(Error::new(parsed.origins.setting("task"), text).help(help));
        return String::new();
    }
    let plan = match planner::search(chain) {
        Ok(plan) => plan,
        Err(refusal) => {
            refuse(chain, &refusal, parsed);
            return String::new();
        }
    };
    let inverse = Inverse::derive(chain, plan);
    if let Err((missed, of)) = inverse.check(chain, SAMPLES) {
        let text = format!(
            "the plan for the inverse missed {missed} of {of} sample poses, so it is not emitted; `ik = none;` asks for no inverse"
        );
        parsed.errors.push(Error::new(Place::at(head.ident.span()), text));
    }
    rust::inverse(chain, &head.ident.to_string(), forward, &inverse)
}

/// Sample poses that every plan must solve before it is emitted.
const SAMPLES: usize = 6;

fn refuse(chain: &Chain, refusal: &planner::Refusal, parsed: &mut Parsed) {
    let solved = if refusal.solved.is_empty() { "nothing".into() } else { refusal.solved.join(", ") };
    for joint in &refusal.open {
        let name = chain.joints.get(*joint).map_or("", |j| j.name.as_str());
        let text = format!("no closed form was found for `{name}` (found: {solved}); `ik = none;` asks for no inverse");
        parsed.errors.push(Error::new(parsed.origins.joint(*joint), text));
    }
}

fn head(parsed: &Parsed) -> Head {
    Head {
        attributes: parsed.head.attributes.clone(),
        visibility: parsed.head.visibility.clone(),
        ident: parsed.head.name.clone().unwrap_or_else(|| Ident::new("Robot", Span::call_site())),
        table: parsed.sketch.table.clone(),
        motions: parsed.sketch.motions.clone(),
        field_docs: parsed.sketch.fields.iter().map(|f| (f.name.to_string(), f.docs.clone())).collect(),
    }
}

fn stub(head: &Head, sketch: &Sketch) -> TokenStream {
    let scalar = match sketch.scalar {
        Scalar::F64 => "f64",
        Scalar::F32 => "f32",
    };
    let target = match sketch.task {
        Task::Pose => format!("&::dh_robot::nalgebra::IsometryMatrix3<{scalar}>"),
        Task::Position => format!("&::dh_robot::nalgebra::Point3<{scalar}>"),
        Task::Planar => format!("({scalar}, {scalar}, {scalar})"),
        Task::Axis => {
            format!("(&::dh_robot::nalgebra::Point3<{scalar}>, &::dh_robot::nalgebra::UnitVector3<{scalar}>)")
        }
    };
    let fields: Vec<String> = sketch.fields.iter().map(|f| f.name.to_string()).collect();
    rust::stub(head, sketch.joints, &fields, scalar, &target, sketch.redundant.is_some())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refusal_stands_at_the_cells_of_the_open_joints() {
        let table = "struct A; convention = standard; | alpha | a | d | theta | | 0 | 1 | 0 | q1 | | 0 | 1 | q2 | 0 |";
        let mut parsed = parse(table.parse().unwrap());
        let chain = Chain::new(parsed.spec.take().unwrap());
        refuse(&chain, &planner::Refusal { solved: vec!["q1".into()], open: vec![1] }, &mut parsed);
        let drawn = parsed.errors.draw(table, "a.dh");
        let message = "error: no closed form was found for `q2` (found: q1); `ik = none;` asks for no inverse";
        assert!(drawn.starts_with(message), "{drawn}");
        let carets = drawn.lines().find(|l| l.contains("^^")).unwrap();
        let line = drawn.lines().find(|l| l.contains("struct A")).unwrap();
        assert_eq!((carets.find("^^"), carets.matches('^').count()), (line.rfind("q2"), 2), "{drawn}");
    }
}
