//! Generates what verification of a solution needs: forward kinematics and Jacobian in `f64`.

use crate::chain::{Chain, Scalar};
use crate::program::Forward;
use crate::render::code::body::Body;
use crate::render::code::drive::drive;

/// What polishing needs: forward kinematics and Jacobian in `f64`.
///
/// Rank-deficient arms report distances in their unit of length.
pub(super) fn kinematics(chain: &Chain, name: &str, forward: &Forward, rank_deficient: bool) -> String {
    let n = chain.dof();
    let entry = |body: &Body<'_>, from: usize| {
        let row = |i: usize| {
            let o = |k: usize| body.output(from + 3 * k + i);
            format!("[{}, {}, {}, {}]", o(0), o(1), o(2), o(3))
        };
        format!("[{}, {}, {}]", row(0), row(1), row(2))
    };
    let pose = Body::new(chain, &forward.pose, Scalar::F64);
    let both = Body::new(chain, &forward.jacobian, Scalar::F64);
    let rows: Vec<String> = (0..6)
        .map(|r| {
            let row: Vec<String> = (0..n)
                .map(|j| if chain.settings.redundant.contains(&j) { "0.0".into() } else { both.output(12 + 6 * j + r) })
                .collect();
            format!("[{}]", row.join(", "))
        })
        .collect();
    let unit = if rank_deficient {
        format!("fn unit(&self) -> &'static str {{ \"{}\" }}\n", chain.settings.unit.name)
    } else {
        String::new()
    };
    format!(
        "#[allow(unused, clippy::all, clippy::pedantic)]\nimpl ::dh_robot::runtime::Kinematics<{n}> for {name} {{\n\
         #[inline]\nfn forward(&self, q: &[f64; {n}]) -> ::dh_robot::runtime::Pose {{\n{}\n{}\n}}\n\
         fn forward_and_jacobian(&self, q: &[f64; {n}]) -> (::dh_robot::runtime::Pose, [[f64; {n}]; 6]) {{\n{}\n({}, [{}])\n}}\n{unit}{}}}\n",
        pose.lines.join("\n"),
        entry(&pose, 0),
        both.lines.join("\n"),
        entry(&both, 0),
        rows.join(", "),
        drive(chain)
    )
}
