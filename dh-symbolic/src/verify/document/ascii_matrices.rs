//! Rewrites matrices that are drawn over several lines of plain text as one line.

/// Replaces every drawn matrix by `[a, b; c, d]` on its middle line; the other lines of the drawing become empty.
pub(super) fn flatten(text: &str) -> Vec<String> {
    let mut lines: Vec<Vec<char>> = text.lines().map(|l| l.chars().collect()).collect();
    let mut top = 0;
    while top < lines.len() {
        // from the right, so that what is replaced does not move what is still to be replaced
        let opens: Vec<usize> = (0..lines[top].len()).rev().filter(|k| lines[top][*k] == '⎡').collect();
        for open in &opens {
            flatten_one(&mut lines, top, *open);
        }
        if !opens.is_empty() {
            let below = lines.iter().skip(top).take_while(|l| l.contains(&'⎣') || l.contains(&'⎢')).count();
            let mut rest: Vec<usize> = (top..top + below).collect();
            rest.insert(0, top);
            for k in rest {
                if lines[k].iter().any(|c| "⎡⎢⎣".contains(*c)) {
                    lines[k].clear();
                }
            }
        }
        top += 1;
    }
    lines.into_iter().map(|l| single_rows(&l.into_iter().collect::<String>())).collect()
}

fn flatten_one(lines: &mut [Vec<char>], top: usize, open: usize) {
    let Some(width) = lines[top].iter().skip(open).position(|c| *c == '⎤') else { return };
    let close = open + width;
    let mut rows = Vec::new();
    for line in lines.iter().skip(top) {
        let corner = line.get(open).copied().unwrap_or(' ');
        if !matches!(corner, '⎡' | '⎢' | '⎣') || close >= line.len() {
            return;
        }
        rows.push(cells(&line[open + 1..close].iter().collect::<String>()));
        if corner == '⎣' {
            break;
        }
    }
    let text = format!("[{}]", rows.iter().map(|r| r.join(", ")).collect::<Vec<_>>().join("; "));
    let middle = (rows.len() - 1) / 2;
    for k in 0..rows.len() {
        let line = &mut lines[top + k];
        let new: Vec<char> = if k == middle { text.chars().collect() } else { Vec::new() };
        line.splice(open..=close, new);
    }
}

/// Cells stand at least two spaces apart.
fn cells(row: &str) -> Vec<String> {
    row.split("  ").map(str::trim).filter(|c| !c.is_empty()).map(String::from).collect()
}

/// `[ a  b ]`, a matrix of one row.
fn single_rows(line: &str) -> String {
    let mut out = String::new();
    let mut rest = line;
    while let Some(open) = rest.find("[ ") {
        let Some(close) = rest[open..].find(" ]") else { break };
        // `[ ]` of a list of tasks is no matrix
        let Some(inner) = rest.get(open + 2..open + close) else {
            let (head, tail) = rest.split_at(open + 1);
            out.push_str(head);
            rest = tail;
            continue;
        };
        out.push_str(&rest[..open]);
        out.push_str(&format!("[{}]", cells(inner).join(", ")));
        rest = &rest[open + close + 2..];
    }
    out + rest
}
