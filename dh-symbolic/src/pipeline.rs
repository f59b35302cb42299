//! The whole way, from tokens to output, in one screen.

use crate::chain::table::{Field, Parsed, Sketch, parse};
use crate::chain::{Chain, Scalar, Task};
use crate::diagnostic::{Error, Errors, Place};
#[cfg(feature = "import")]
use crate::import::in_macro;
use crate::kinematics::Kinematics;
use crate::planner::Refusal;
use crate::program::{Disproof, Forward, Inverse};
use crate::render::Language;
use crate::render::code::rust::{self, Batches, Head, Items};
use crate::render::refusal::{Subject, remarks};
use crate::render::rustdoc;
use crate::verify::report::complaints;
use crate::verify::{Claims, check};
use proc_macro2::{Ident, Span, TokenStream};

/// Expands the body of `dh_robot!`: items, or errors beside a stub of the type.
pub fn expand(input: TokenStream) -> TokenStream {
    let (input, watch, mut errors) = with_file(input);
    let batches = if cfg!(feature = "simd") { Batches::Packed } else { Batches::OneByOne };
    let (items, more) = compile_table(&parse(input), batches);
    // Without its file a robot has no table, which is no second error.
    if errors.is_empty() {
        errors.extend(more);
    }
    let mut out = errors.to_compile_errors();
    out.extend(items.into_tokens());
    out.extend(watch);
    out
}

/// `urdf = "arm.urdf";`: the file's table in place of its name, and an item by which the build notices changes of the file.
#[cfg(feature = "import")]
fn with_file(input: TokenStream) -> (TokenStream, TokenStream, Errors) {
    let folder = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default();
    match in_macro::splice(&input, folder.as_ref()) {
        Ok(Some(spliced)) => (spliced.table, spliced.watch, Errors::new()),
        Ok(None) => (input, TokenStream::new(), Errors::new()),
        Err(errors) => (input, TokenStream::new(), errors),
    }
}

#[cfg(not(feature = "import"))]
fn with_file(input: TokenStream) -> (TokenStream, TokenStream, Errors) {
    (input, TokenStream::new(), Errors::new())
}

/// The items of a table, and what is wrong with it: then the items are a stub of the type.
pub fn compile(input: TokenStream) -> (Items, Errors) {
    compile_table(&parse(input), Batches::OneByOne)
}

/// The same for a table that has been read.
pub fn compile_table(parsed: &Parsed, batches: Batches) -> (Items, Errors) {
    let head = head(parsed, batches);
    match derive(parsed) {
        Ok((chain, programs)) => (items(&head, &chain, &programs), Errors::new()),
        Err(errors) => (Items::of_tokens(stub(&head, &parsed.sketch)), errors),
    }
}

/// What is printed: programs that are proven, and an inverse that was tried.
#[derive(Debug)]
pub struct Programs {
    /// Pose, frames, Jacobian.
    pub forward: Forward,
    /// `None` where the table asks for none.
    pub inverse: Option<Inverse>,
}

/// The programs of a table that has been read.
///
/// # Errors
/// All that is wrong: with the table, with the claims of its `prove` blocks, with the task it sets.
pub fn derive(parsed: &Parsed) -> Result<(Chain, Programs), Errors> {
    let Some(spec) = parsed.spec.as_ref().filter(|_| parsed.errors.is_empty()) else {
        return Err(parsed.errors.clone());
    };
    let chain = Chain::new(spec.clone());
    let mut errors = wrong_claims(&chain, &Claims::read(&parsed.claims));
    match programs(&chain, parsed) {
        Ok(programs) if errors.is_empty() => return Ok((chain, programs)),
        Ok(_) => {}
        Err(more) => errors.extend(more),
    }
    Err(errors)
}

/// The programs of a chain whose table is in order, whatever its `prove` blocks say.
///
/// # Errors
/// Why there is no inverse, at the places of the table.
pub fn programs(chain: &Chain, parsed: &Parsed) -> Result<Programs, Errors> {
    let forward = Forward::derive(chain).map_err(|difference| Errors::from(defect(parsed, &difference)));
    let inverse = chain.settings.ik.then(|| Inverse::of(chain)).transpose();
    let inverse = inverse.map_err(|refusal| refused(chain, &refusal, parsed));
    Ok(Programs { forward: forward?, inverse: inverse? })
}

/// The lines of `prove` blocks that are wrong or not understood.
pub fn wrong_claims(chain: &Chain, claims: &Claims) -> Errors {
    let mut errors = Errors::new();
    if claims.derivation.lines.is_empty() {
        return errors;
    }
    let report = check::check(chain, &claims.derivation);
    for verdict in &report.verdicts {
        for (place, message, help) in complaints(&report, &claims.derivation, verdict) {
            let mut error = Error::new(claims.place(&place).unwrap_or_else(Place::call_site), message);
            error.help = help;
            errors.push(error);
        }
    }
    errors
}

/// A program that differs from what it was made of.
fn defect(parsed: &Parsed, difference: &Disproof) -> Error {
    Error::new(parsed.origins.name, format!("{difference}; this is a defect of dh-symbolic"))
}

/// The reasons why there is no inverse, each at the place of the table that it concerns.
pub fn refused(chain: &Chain, refusal: &Refusal, parsed: &Parsed) -> Errors {
    let mut errors = Errors::new();
    for remark in remarks(chain, refusal, Language::English) {
        let place = match remark.subject {
            Subject::Robot => parsed.origins.name,
            Subject::Joint(joint) => parsed.origins.joint(joint),
            Subject::Task => parsed.origins.setting("task"),
            Subject::Redundant => parsed.origins.setting("redundant"),
        };
        errors.push(Error::new(place, remark.message).help(remark.help));
    }
    errors
}

/// The code of a robot.
fn items(head: &Head, chain: &Chain, programs: &Programs) -> Items {
    let forward = &programs.forward;
    let inverse = programs.inverse.as_ref();
    let own = rust::implementing(chain, &head.ident.to_string());
    let text = inverse.map(|i| rust::inverse(chain, &own, forward, i));
    let inverse = inverse.zip(text.as_deref());
    rust::robot(head, chain, forward, inverse, &rustdoc(chain, &Kinematics::new(chain)))
}

fn head(parsed: &Parsed, batches: Batches) -> Head {
    Head {
        attributes: parsed.head.attributes.clone(),
        visibility: parsed.head.visibility.clone(),
        ident: parsed.head.name.clone().unwrap_or_else(|| Ident::new("Robot", Span::call_site())),
        table: parsed.sketch.table.clone(),
        motions: parsed.sketch.motions.clone(),
        batches,
        field_docs: parsed.sketch.fields.iter().map(|f| (f.name.to_string(), f.docs.clone())).collect(),
    }
}

fn stub(head: &Head, sketch: &Sketch) -> TokenStream {
    let scalar = match sketch.settings.scalar {
        Scalar::F64 => "f64",
        Scalar::F32 => "f32",
    };
    let target = match sketch.settings.task {
        Task::Pose => format!("&::dh_robot::nalgebra::IsometryMatrix3<{scalar}>"),
        Task::Position => format!("&::dh_robot::nalgebra::Point3<{scalar}>"),
        Task::Planar => format!("({scalar}, {scalar}, {scalar})"),
        Task::Axis => {
            format!("(::dh_robot::nalgebra::Point3<{scalar}>, ::dh_robot::nalgebra::UnitVector3<{scalar}>)")
        }
    };
    let pose = format!("::dh_robot::nalgebra::IsometryMatrix3<{scalar}>");
    let kind = |f: &Field| if f.quantity.is_some() { scalar.to_string() } else { pose.clone() };
    let fields: Vec<(String, String)> = sketch.fields.iter().map(|f| (f.name.to_string(), kind(f))).collect();
    rust::stub(head, sketch.joints, &fields, scalar, &target, sketch.settings.redundant.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refusal_stands_at_the_cells_of_the_open_joints() {
        let table = "struct A; convention = standard; | alpha | a | d | theta | | 0 | 1 | 0 | q1 | | 0 | 1 | q2 | 0 |";
        let mut parsed = parse(table.parse().unwrap());
        let chain = Chain::new(parsed.spec.take().unwrap());
        let stuck = Refusal::Stuck { solved: vec!["q1".into()], open: vec![1] };
        let drawn = refused(&chain, &stuck, &parsed).draw(table, "a.dh");
        let message = "error: no closed form was found for `q2` (found: q1)";
        assert!(drawn.starts_with(message), "{drawn}");
        let carets = drawn.lines().find(|l| l.contains("^^")).unwrap();
        let line = drawn.lines().find(|l| l.contains("struct A")).unwrap();
        assert_eq!((carets.find("^^"), carets.matches('^').count()), (line.rfind("q2"), 2), "{drawn}");
    }
}
