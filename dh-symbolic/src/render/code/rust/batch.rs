//! Generates batch functions: many poses in one call, slices in and out.

use super::structure::Batches;
use super::target::Target;
use crate::chain::{Chain, Scalar};
use crate::program::Forward;
use crate::render::code::body::Body;
use crate::render::code::scalar_name;

/// What every batch does with its slices.
const SLICES: &str = "as many as the shorter slice holds; what lies beyond stays as it is. Each stands for itself: one that is not finite \
                      spoils its own\n/// result only.";

/// Whether the formulas are stated for packed numbers as well: in double precision only.
fn is_packed(chain: &Chain, batches: Batches) -> bool {
    batches == Batches::Packed && chain.settings.scalar == Scalar::F64 && chain.dof() > 0
}

/// Forward kinematics and Jacobians of many joint vectors.
pub(super) fn forward(chain: &Chain, batches: Batches) -> String {
    let (n, f) = (chain.dof(), scalar_name(chain.settings.scalar));
    let one = |name: &str, single: &str, to: &str, kind: &str| {
        let body = if is_packed(chain, batches) {
            format!("::dh_robot::runtime::packed::{name}(self, q, {to});")
        } else {
            format!("for (q, to) in q.iter().zip({to}) {{ *to = self.{single}(q); }}")
        };
        format!(
            "/// [`{single}`](Self::{single}) of every joint vector: {SLICES}\n#[inline]\n\
             pub fn {name}(&self, q: &[[{f}; {n}]], {to}: &mut [{kind}]) {{\n{body}\n}}\n"
        )
    };
    let pose = format!("::dh_robot::nalgebra::IsometryMatrix3<{f}>");
    let matrix = format!("::dh_robot::nalgebra::SMatrix<{f}, 6, {n}>");
    one("forward_batch", "forward", "poses", &pose) + &one("jacobian_batch", "jacobian", "jacobians", &matrix)
}

/// The formulas once more, for the packed numbers of several poses.
pub(super) fn packed(chain: &Chain, name: &str, forward: &Forward, batches: Batches) -> String {
    if !is_packed(chain, batches) {
        return String::new();
    }
    let n = chain.dof();
    let body = Body::packed(chain, &forward.pose);
    let entries: Vec<String> = [0, 3, 6, 1, 4, 7, 2, 5, 8, 9, 10, 11].iter().map(|k| body.output(*k)).collect();
    let (pose, entries) = (body.lines.join("\n"), entries.join(", "));
    let jacobian = super::forward::jacobian(forward);
    let body = Body::packed(chain, &jacobian);
    let (lines, columns) = (body.lines.join("\n"), super::forward::columns(&body, 0, n));
    let function = |name: &str, to: &str, body: &str| {
        format!(
            "#[inline(always)]\nfn {name}<R: ::dh_robot::runtime::packed::Register>(&self, q: &[::dh_robot::runtime::packed::Packed<R>; {n}], \
             sines: &mut ::dh_robot::runtime::packed::Sines<R>) -> {to} {{\n{body}\n}}\n"
        )
    };
    let pose = function("pose", "[::dh_robot::runtime::packed::Packed<R>; 12]", &format!("{pose}\n[{entries}]"));
    let to = format!("[[::dh_robot::runtime::packed::Packed<R>; 6]; {n}]");
    let columns = function("columns", &to, &format!("{lines}\n[{columns}]"));
    format!(
        "#[allow(unused, clippy::all, clippy::pedantic)]\nimpl ::dh_robot::runtime::packed::PackedKinematics<{n}> for {name} {{\n{pose}{columns}}}\n"
    )
}

/// Solutions of many targets, at most `m` each.
pub(super) fn inverse(chain: &Chain, m: usize) -> String {
    let (n, f) = (chain.dof(), scalar_name(chain.settings.scalar));
    let Target { parameter, kind, .. } = Target::of(chain, &|_| String::new());
    let target = if parameter.starts_with("target: &") { "target" } else { "*target" };
    let (given, chosen, pass, pair) = match chain.settings.redundant.len() {
        0 => (String::new(), "", "", "target"),
        1 => (format!(", given: &[{f}]"), ".zip(given)", ", *given", "(target, given)"),
        k => (format!(", given: &[[{f}; {k}]]"), ".zip(given)", ", *given", "(target, given)"),
    };
    let also = if chain.settings.redundant.is_empty() {
        ""
    } else {
        " The values of the joints that you choose come with each target."
    };
    format!(
        "/// [`inverse`](Self::inverse) of every target: {SLICES}{also}\n#[inline]\n\
         pub fn inverse_batch(&self, targets: &[{kind}]{given}, solutions: &mut [::dh_robot::Solutions<{f}, {n}, {m}>]) {{\n\
         for ({pair}, to) in targets.iter(){chosen}.zip(solutions) {{ *to = self.inverse({target}{pass}); }}\n}}\n\n\
         /// [`inverse_near`](Self::inverse_near) of every target, from the joint values `q` of the same place: {SLICES}{also}\n#[inline]\n\
         pub fn inverse_near_batch(&self, targets: &[{kind}]{given}, q: &[[{f}; {n}]], \
         solutions: &mut [::core::result::Result<::dh_robot::Solution<{f}, {n}>, ::dh_robot::Why<{f}>>]) {{\n\
         for (({pair}, q), to) in targets.iter(){chosen}.zip(q).zip(solutions) {{ *to = self.inverse_near({target}{pass}, q); }}\n}}\n\n"
    )
}
