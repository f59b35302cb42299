//! Doc comments of generated types: fields, the table as it was written.

use crate::chain::{Chain, Convention, Factor, Handle, Nominal, Parameter, PoseField, Role};

/// Docs of a field.
pub(super) fn field(chain: &Chain, p: &Parameter) -> String {
    let unit = match p.handle {
        Handle::Length(_) => chain.settings.unit.name,
        Handle::Angle(_) => "radians",
    };
    let nominal = match &p.role {
        Role::Field(Some(Nominal::Length(_) | Nominal::Angle(_))) => format!(", nominally {}", chain.nominal(p.handle)),
        _ => String::new(),
    };
    format!(" `{}` in {unit}{nominal}.", p.name)
}

/// Docs of a field with a pose.
pub(super) fn pose(chain: &Chain, pose: &PoseField) -> String {
    let stands = |list: &[Factor]| {
        let is_it =
            |f: &Factor| matches!(f, Factor::Pose(i) if chain.poses.get(*i).is_some_and(|p| p.name == pose.name));
        list.iter().any(is_it)
    };
    let of = match (stands(&chain.before), stands(&chain.after)) {
        (true, true) => ", a factor of `base` and `tool`",
        (true, false) => ", a factor of `base`",
        (false, true) => ", a factor of `tool`",
        (false, false) => "",
    };
    format!(" `{}`{of}: a rigid motion, lengths in {}.", pose.name, chain.settings.unit.name)
}

/// What the table below is.
pub(super) fn heading(chain: &Chain) -> String {
    let convention = match chain.convention {
        Convention::Standard => "standard convention (theta, d, a and alpha of one link)",
        Convention::Modified => "modified convention (Craig: alpha and a of the link before)",
    };
    format!("Denavit-Hartenberg table, {convention}; bare lengths in {}:", chain.settings.unit.name)
}

/// The Denavit-Hartenberg table in Markdown, cell by cell as it was written, with `base` and `tool`, followed by further text.
pub(super) fn table(chain: &Chain, table: &[Vec<String>], motions: &[(String, String)], extra: &str) -> String {
    let mut out = format!("\n{}\n\n", heading(chain));
    for (i, row) in table.iter().enumerate() {
        let cells: Vec<String> = row.iter().map(|c| escape(c)).collect();
        out.push_str(&format!("| {} |\n", cells.join(" | ")));
        if i == 0 {
            out.push_str(&format!("|{}\n", "---|".repeat(row.len())));
        }
    }
    for (name, value) in motions {
        out.push_str(&format!("\n`{name} = {value};`\n"));
    }
    let poses = chain.left_out();
    if !poses.is_empty() {
        let names: Vec<String> = poses.iter().map(|p| format!("`{p}`")).collect();
        out.push_str(&format!(
            "\nThe formulas end where {} begins; what lies beyond is multiplied at run time.\n",
            names.join(" or ")
        ));
    }
    out.push_str(extra);
    out
}

/// Cells are code to Markdown only where they could mean something else to it.
fn escape(cell: &str) -> String {
    let mut out = String::new();
    for c in cell.chars() {
        if matches!(c, '*' | '_' | '[' | ']' | '<' | '`') {
            out.push('\\');
        }
        out.push(c);
    }
    out
}
