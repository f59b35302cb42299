//! Doc comments of generated types: fields, the table as it was written.

use crate::chain::{Chain, Convention, Handle, Nominal, Parameter, Role};

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
