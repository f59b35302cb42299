//! Doc comments of generated types: the table as rustdoc draws it, and the closed form.

use super::{bound, literal};
use crate::chain::{Chain, Convention, Coordinate, Elementary, Handle, Parameter, Scalar};

/// Docs of a field.
pub(super) fn field(chain: &Chain, p: &Parameter) -> String {
    let unit = match p.handle {
        Handle::Length(_) => chain.unit.name,
        Handle::Angle(_) => "radians",
    };
    format!(" `{}` in {unit}.", p.name)
}

/// The Denavit-Hartenberg table in Markdown, followed by further text.
pub(super) fn table(chain: &Chain, extra: &str) -> String {
    let (convention, head) = match chain.convention {
        Convention::Standard => {
            ("standard (theta, d, a, alpha of one link)", "| joint | theta | d | a | alpha | range |")
        }
        Convention::Modified => {
            ("modified, after Craig (alpha and a of the link before)", "| joint | alpha | a | d | theta | range |")
        }
    };
    let mut out = format!(
        "\nDenavit-Hartenberg parameters, {convention}; lengths in {}:\n\n{head}\n|---|---|---|---|---|---|\n",
        chain.unit.name
    );
    for (i, link) in chain.links.iter().enumerate() {
        let mut cells: Vec<String> = chain.link_factors(i).iter().map(|e| cell(chain, e)).collect();
        if chain.convention == Convention::Modified {
            cells.swap(2, 3);
        }
        let joint = link.joint.and_then(|j| chain.joints.get(j));
        let range = match joint {
            None => "fixed".to_string(),
            Some(j) => match &j.range {
                None => "any".to_string(),
                Some((lo, hi)) => {
                    let (scale, unit) = match j.coordinate {
                        Coordinate::Angle(_) => (180.0 / std::f64::consts::PI, " deg"),
                        Coordinate::Length(_) => (1.0, ""),
                    };
                    let show = |b| literal((bound(b) * scale * 1e6).round() / 1e6, Scalar::F64);
                    format!("{} to {}{unit}", show(lo), show(hi))
                }
            },
        };
        let label = joint.map_or("-".to_string(), |j| j.name.clone());
        out.push_str(&format!("| {label} | {} | {range} |\n", cells.join(" | ")));
    }
    out.push_str(extra);
    out
}

fn cell(chain: &Chain, e: &Elementary) -> String {
    match e {
        Elementary::Translate(_, p) => chain.ring.text(p),
        Elementary::Rotate(_, angle) => {
            let mut parts: Vec<String> = angle
                .terms
                .iter()
                .map(|(v, k)| match k {
                    1 => chain.ring.angle_name(*v).to_string(),
                    -1 => format!("-{}", chain.ring.angle_name(*v)),
                    _ => format!("{k}*{}", chain.ring.angle_name(*v)),
                })
                .collect();
            if !angle.constant.is_zero() {
                parts.push(format!("{} deg", angle.constant.to_degrees()));
            }
            if parts.is_empty() { "0".into() } else { parts.join(" + ").replace("+ -", "- ") }
        }
    }
}
