//! The part of YAML that calibration files use: names with numbers, nested by indentation or braces, and lists of numbers.

use super::problem::Problem;

/// A number or a list of them, with the names on the way to it and its line.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Entry {
    pub(super) path: Vec<String>,
    pub(super) values: Vec<f64>,
    pub(super) line: usize,
}

/// Nothing is read beyond this depth.
const DEEPEST: usize = 20;

/// All numbers of a file in order. Texts are passed over; a line that is none of this is an error.
pub(super) fn read(text: &str) -> Result<Vec<Entry>, Problem> {
    let mut entries = Vec::new();
    // Open names with their indentation.
    let mut open: Vec<(usize, String)> = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let number = i + 1;
        let line = line.split(" #").next().unwrap_or("");
        let body = line.trim();
        if body.is_empty()
            || body.starts_with('#')
            || body == "---"
            || body.starts_with('%')
            || body.starts_with('[') && body.ends_with(']')
        {
            continue;
        }
        if line[..line.len() - line.trim_start().len()].contains('\t') {
            return Err(Problem::at((number, 1), "a tab stands in the indentation, which YAML does not allow"));
        }
        let indent = line.len() - line.trim_start().len();
        // `name: value` of YAML, `name = value` of configuration files.
        let Some((name, value)) = body.split_once(':').or_else(|| body.split_once('=')) else {
            return Err(Problem::at((number, indent + 1), format!("`{body}` is no line `name: value`")));
        };
        open.retain(|(at, _)| *at < indent);
        if open.len() >= DEEPEST {
            return Err(Problem::at((number, indent + 1), "the file is nested too deeply"));
        }
        let name = name.trim().trim_matches(['"', '\'']).to_string();
        let path: Vec<String> = open.iter().map(|o| o.1.clone()).chain([name.clone()]).collect();
        let value = value.trim();
        if value.is_empty() {
            open.push((indent, name));
        } else {
            scalar(value, path, number, &mut entries)?;
        }
    }
    Ok(entries)
}

fn scalar(value: &str, path: Vec<String>, line: usize, entries: &mut Vec<Entry>) -> Result<(), Problem> {
    let problem = |text: &str| Problem::at((line, 1), format!("`{}`: `{text}` is no finite number", path.join(".")));
    if let Some(inner) = value.strip_prefix('{').and_then(|v| v.strip_suffix('}')) {
        for piece in inner.split(',').filter(|p| !p.trim().is_empty()) {
            let Some((name, value)) = piece.split_once(':') else { return Err(problem(piece)) };
            let path = path.iter().cloned().chain([name.trim().to_string()]).collect();
            scalar_plain(value.trim(), path, line, entries)?;
        }
        return Ok(());
    }
    if let Some(inner) = value.strip_prefix('[').and_then(|v| v.strip_suffix(']')) {
        let number =
            |word: &str| word.trim().parse::<f64>().ok().filter(|x| x.is_finite()).ok_or_else(|| problem(word));
        let values = inner.split(',').filter(|w| !w.trim().is_empty()).map(number).collect::<Result<Vec<f64>, _>>()?;
        entries.push(Entry { path, values, line });
        return Ok(());
    }
    scalar_plain(value, path, line, entries)
}

/// A number; texts are passed over.
fn scalar_plain(value: &str, path: Vec<String>, line: usize, entries: &mut Vec<Entry>) -> Result<(), Problem> {
    match value.parse::<f64>() {
        Ok(x) if x.is_finite() => entries.push(Entry { path, values: vec![x], line }),
        Ok(_) => return Err(Problem::at((line, 1), format!("`{}`: `{value}` is not finite", path.join(".")))),
        Err(_) if matches!(value, ".nan" | ".inf" | "-.inf" | ".NaN") => {
            return Err(Problem::at((line, 1), format!("`{}`: `{value}` is not finite", path.join("."))));
        }
        Err(_) => {}
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nested_numbers() {
        let text = "# made by a driver\nkinematics:\n  shoulder:\n    x: 0\n    yaw: -1.5e-05\n  wrist: {x: 1, y: -2}\n  hash: calib_12\nlist: [1, 2.5]\n";
        let entries = read(text).expect("entries");
        let shown: Vec<String> =
            entries.iter().map(|e| format!("{}={:?}@{}", e.path.join("."), e.values, e.line)).collect();
        assert_eq!(
            shown,
            [
                "kinematics.shoulder.x=[0.0]@4",
                "kinematics.shoulder.yaw=[-1.5e-5]@5",
                "kinematics.wrist.x=[1.0]@6",
                "kinematics.wrist.y=[-2.0]@6",
                "list=[1.0, 2.5]@8"
            ]
        );
        for bad in ["a: .nan", "a", "\ta: 1", "a: [1, b]", "a: {b}"] {
            assert!(read(bad).is_err(), "{bad}");
        }
    }
}
