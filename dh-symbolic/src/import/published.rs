//! Tables as people publish them, in CSV, TSV or Markdown: bare degrees or radians, Greek letters, variables of any number.

use super::arithmetic::value;
use super::problem::Problem;
use super::rounding::{Angle, Limits, number, shown};
use super::sheet::{Sheet, SheetRow, type_name};
use super::{Imported, Options, describe};
use crate::chain::Convention;
use crate::chain::table::{Column, heading};

/// A row in numbers: metres or the table's unit, and radians.
#[derive(Clone, Debug, Default)]
pub(super) struct Cells {
    pub(super) alpha: f64,
    pub(super) a: f64,
    pub(super) d: f64,
    pub(super) theta: f64,
    /// Added to the variable.
    pub(super) offset: f64,
    /// Turns, or slides; of no meaning for fixed rows.
    pub(super) turns: bool,
    pub(super) fixed: bool,
    pub(super) range: Option<(f64, f64)>,
    pub(super) label: String,
    /// Line of the file.
    pub(super) line: usize,
}

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Field {
    Dh(Column),
    Offset,
    Kind,
    Least,
    Greatest,
}

/// A column: what it holds, whether it shows i-1, its unit.
struct Heading {
    field: Field,
    previous: bool,
    unit: Option<String>,
    text: String,
}

/// A table in text.
///
/// # Errors
/// With the line of the cell.
pub(super) fn read(text: &str, options: &Options) -> Result<Imported, Problem> {
    let lines = lines(text);
    let Some(((number, header), rows)) = lines.split_first().map(|(h, r)| ((h.0, &h.1), r)) else {
        return Err(Problem::new("the file is empty"));
    };
    let at = |line: usize| (line, 1);
    let mut notes = Vec::new();
    let columns: Vec<Option<Heading>> = header.iter().map(|cell| read_heading(cell)).collect();
    let has = |column: Column| columns.iter().flatten().any(|h| h.field == Field::Dh(column));
    for column in [Column::Alpha, Column::A, Column::D, Column::Theta] {
        if !has(column) {
            let text = format!("column `{}` is missing in the header: {}", column.name(), header.join(", "));
            return Err(Problem::at(at(number), text));
        }
    }
    let out: Vec<&str> = header.iter().zip(&columns).filter(|(_, h)| h.is_none()).map(|(c, _)| c.as_str()).collect();
    if !out.is_empty() {
        notes.push(format!("columns that were left out: {}", out.join(", ")));
    }
    let shown_previous =
        columns.iter().flatten().find(|h| h.previous && matches!(h.field, Field::Dh(Column::Alpha | Column::A)));
    let convention = match (options.convention, shown_previous) {
        (Some(Convention::Standard), Some(h)) => {
            let text = format!("the header `{}` belongs to the modified convention", h.text);
            return Err(Problem::at(at(number), text).help("leave `--convention standard` out"));
        }
        (_, Some(h)) => {
            notes.push(format!("modified convention, since the header says `{}`", h.text));
            Convention::Modified
        }
        (Some(convention), None) => convention,
        (None, None) => {
            return Err(Problem::at(at(number), "the file does not say which convention its rows follow")
                .help("`--convention standard`, or `--convention modified` (Craig)"));
        }
    };
    let degrees = angles_in_degrees(&columns, rows, options, number)?;
    let length = length_unit(&columns, options)?;
    let mut all = Vec::new();
    let mut variables = Vec::new();
    for (line, cells) in rows {
        if cells.len() != header.len() {
            let text = format!("this row has {} cells, the header has {}", cells.len(), header.len());
            return Err(Problem::at(at(*line), text));
        }
        let mut row = Cells { line: *line, turns: true, fixed: true, ..Cells::default() };
        let (mut least, mut greatest) = (None, None);
        for (cell, column) in cells.iter().zip(&columns) {
            let Some(column) = column else { continue };
            let problem = |text: String| Problem::at(at(*line), text);
            let angle = |constant: f64, bare: bool| {
                let unit = column.unit.as_deref();
                let in_degrees = unit.map_or(degrees, |u| u != "rad");
                if bare && in_degrees { constant.to_radians() } else { constant }
            };
            match column.field {
                Field::Dh(Column::Joint) => row.label = label(cell),
                Field::Dh(Column::Range) => {
                    let clean = tidy(cell);
                    let bounds =
                        clean.split_once("..=").or_else(|| clean.split_once("..")).or_else(|| clean.split_once('~'));
                    if let Some((low, high)) = bounds {
                        let bound = |text: &str| constant(text).map(|(x, bare)| angle(x, bare));
                        row.range = bound(low).zip(bound(high));
                    }
                }
                Field::Least => least = constant(&tidy(cell)).map(|(x, bare)| angle(x, bare)),
                Field::Greatest => greatest = constant(&tidy(cell)).map(|(x, bare)| angle(x, bare)),
                Field::Kind => {
                    let word = cell.trim().to_lowercase();
                    row.turns = !(word.starts_with('p') || word == "1" || word.starts_with("slid"));
                    row.fixed = word.starts_with('f');
                }
                Field::Offset => {
                    let (x, bare) = constant(&tidy(cell)).ok_or_else(|| problem(no_constant(cell)))?;
                    row.offset = if row.turns { angle(x, bare) } else { x };
                }
                Field::Dh(dh) => {
                    let angular = matches!(dh, Column::Alpha | Column::Theta);
                    let clean = tidy(cell);
                    if clean.is_empty() {
                        return Err(problem(format!("an empty cell in column `{}`: write 0", column.text)));
                    }
                    let (variable, rest) = variable(&clean, dh);
                    if let Some(v) = variable {
                        if dh == Column::Alpha || dh == Column::A {
                            return Err(problem(format!("`{cell}` in column `{}` cannot move", column.text)));
                        }
                        (row.turns, row.fixed) = (angular, false);
                        variables.push(v);
                    }
                    let (x, bare) = if rest.is_empty() {
                        (0.0, true)
                    } else {
                        constant(&rest).ok_or_else(|| problem(no_constant(cell)))?
                    };
                    let x = if angular { angle(x, bare) } else { x };
                    *match dh {
                        Column::Alpha => &mut row.alpha,
                        Column::A => &mut row.a,
                        Column::D => &mut row.d,
                        _ => &mut row.theta,
                    } = x;
                }
            }
        }
        row.range = row.range.or(least.zip(greatest));
        all.push(row);
    }
    if all.iter().all(|r| r.fixed) {
        return Err(Problem::at(at(number), "no row has a joint variable: `q1`, `θ1`, `theta_1`"));
    }
    let in_order = variables.iter().enumerate().all(|(k, v)| *v == k + 1);
    if let (false, [first, .., last]) = (in_order, variables.as_slice()) {
        let mut sorted = variables.clone();
        sorted.sort_unstable();
        sorted.dedup();
        if sorted.len() != variables.len() {
            return Err(Problem::at(at(number), "one variable moves several rows: such a table is written by hand"));
        }
        notes
            .push(format!("variables {first} to {last} are q1 to q{} here, in the order of the rows", variables.len()));
    }
    finish(all, convention, length, options, notes, "made from a table in text")
}

fn no_constant(cell: &str) -> String {
    format!("`{}` is no constant: numbers, pi, and functions of them", cell.trim())
}

/// The lines with their cells, without rules and empty lines.
fn lines(text: &str) -> Vec<(usize, Vec<String>)> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let first = text.lines().find(|l| !l.trim().is_empty()).unwrap_or("");
    let count = |c: char| first.matches(c).count();
    let markdown = text.lines().any(|l| l.trim_start().starts_with('|')) || count('|') >= 3;
    let separator = if markdown {
        '|'
    } else if count('\t') >= 3 {
        '\t'
    } else if count(';') >= 3 {
        ';'
    } else {
        ','
    };
    let mut list = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let mut line = line.trim();
        if markdown {
            if !line.contains('|') {
                if list.is_empty() { continue } else { break }
            }
            line = line.strip_prefix('|').unwrap_or(line);
            line = line.strip_suffix('|').unwrap_or(line);
        }
        if line.is_empty() || line.starts_with('#') && !markdown {
            continue;
        }
        let cells = split(line, separator);
        if markdown && cells.iter().all(|c| !c.is_empty() && c.chars().all(|c| matches!(c, '-' | ':' | ' '))) {
            continue;
        }
        list.push((i + 1, cells));
    }
    list
}

/// Cells between separators; double quotes protect them.
fn split(line: &str, separator: char) -> Vec<String> {
    let (mut cells, mut cell, mut quoted, mut deep) = (Vec::new(), String::new(), false, 0i32);
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            c if c == separator && !quoted && deep <= 0 => cells.push(std::mem::take(&mut cell)),
            c => {
                deep += i32::from(c == '(') - i32::from(c == ')');
                cell.push(c);
            }
        }
    }
    cells.push(cell);
    cells.into_iter().map(|c| c.trim().to_string()).collect()
}

fn read_heading(text: &str) -> Option<Heading> {
    let make = |field, previous, unit| Some(Heading { field, previous, unit, text: text.trim().to_string() });
    if let Some((column, previous, unit)) = heading(text) {
        return make(Field::Dh(column), previous, unit);
    }
    let (name, unit) = match text.split_once(['(', '[']) {
        Some((name, unit)) => (name, Some(unit.trim_end_matches([')', ']']).trim().to_string())),
        None => (text, None),
    };
    let name = name.trim().to_lowercase();
    let field = match name.as_str() {
        "offset" => Field::Offset,
        "type" | "kind" | "sigma" => Field::Kind,
        "min" | "lower" | "qmin" | "q_min" | "least" => Field::Least,
        "max" | "upper" | "qmax" | "q_max" | "greatest" => Field::Greatest,
        _ => return None,
    };
    make(field, false, unit.filter(|u| !u.is_empty()))
}

/// Letters of typesetting as plain ones.
fn tidy(cell: &str) -> String {
    let mut text = String::new();
    for c in cell.trim().chars() {
        match c {
            '$' | '\\' | '{' | '}' | '_' => {}
            '−' | '–' => text.push('-'),
            '×' | '·' | '⋅' => text.push('*'),
            '°' | 'º' => text.push_str("*deg"),
            'θ' | 'ϑ' => text.push_str("theta"),
            'π' => text.push_str("pi"),
            '∘' | '^' => {}
            c if c.is_whitespace() => {}
            c => text.push(c),
        }
    }
    // `90deg`, `1.2rad`, `2pi`, `3theta`: a product without its sign; `^\circ` is a degree sign.
    let text = text.replace("circ", "*deg").replace("degrees", "deg");
    let mut out = String::new();
    let mut before = ' ';
    for (i, c) in text.char_indices() {
        let word = ["deg", "rad", "pi"].iter().any(|w| text[i..].starts_with(w));
        if before.is_ascii_digit() && word {
            out.push('*');
        }
        out.push(c);
        before = c;
    }
    out
}

/// The joint variable of a cell, and the cell without it.
fn variable(cell: &str, column: Column) -> (Option<usize>, String) {
    const NAMES: [&str; 6] = ["theta", "th", "q", "t", "d", "s"];
    let names = if column == Column::D { &["q", "d", "s"][..] } else { &NAMES[..4] };
    let letter = |c: char| c.is_alphabetic();
    let mut at = 0;
    while let Some(start) = cell[at..].find(letter).map(|i| at + i) {
        let end = cell[start..].find(|c: char| !letter(c)).map_or(cell.len(), |i| start + i);
        let digits = cell[end..].chars().take_while(char::is_ascii_digit).count();
        let word = cell[start..end].to_lowercase();
        if names.contains(&word.as_str()) && digits <= 4 && (digits > 0 || cell.len() == end) {
            let number = cell[end..end + digits].parse().unwrap_or(0);
            // A star marks the variable.
            let mut tail = end + digits;
            if cell[tail..].starts_with('*') && !cell[tail + 1..].starts_with(|c: char| c.is_alphanumeric() || c == '(')
            {
                tail += 1;
            }
            let (before, after) = (&cell[..start], &cell[tail..]);
            if before.ends_with(['*', '/', '-']) || after.starts_with(['*', '/']) {
                return (None, cell.to_string());
            }
            let rest = format!("{}{after}", before.trim_end_matches('+'));
            return (Some(number), rest.trim_start_matches('+').to_string());
        }
        at = end.max(start + 1) + digits;
    }
    (None, cell.to_string())
}

/// A constant, and whether it is a bare number (of the column's unit).
fn constant(text: &str) -> Option<(f64, bool)> {
    let x = value(text, &|name| match name {
        "rad" => Some(1.0),
        _ => None,
    })?;
    Some((x, !text.contains("pi") && !text.contains("deg") && !text.contains("rad") && !text.contains("tan")))
}

/// Are bare angles degrees? As the header or the caller says, else by the numbers.
fn angles_in_degrees(
    columns: &[Option<Heading>],
    rows: &[(usize, Vec<String>)],
    options: &Options,
    line: usize,
) -> Result<bool, Problem> {
    if let Some(degrees) = options.degrees {
        return Ok(degrees);
    }
    let mut bare = Vec::new();
    for (_, cells) in rows {
        for (cell, column) in cells.iter().zip(columns) {
            let Some(Heading { field: Field::Dh(dh @ (Column::Alpha | Column::Theta)), unit: None, .. }) = column
            else {
                continue;
            };
            let rest = variable(&tidy(cell), *dh).1;
            bare.extend(constant(&rest).filter(|c| c.1 && c.0 != 0.0).map(|c| c.0.abs()));
        }
    }
    let steps = std::f64::consts::PI / 12.0;
    let radians = bare.iter().filter(|x| (*x / steps - (*x / steps).round()).abs() < 0.02).count();
    if bare.iter().any(|x| *x > 7.0) || bare.is_empty() {
        return Ok(true);
    }
    if radians * 2 > bare.len() {
        return Ok(false);
    }
    Err(Problem::at((line, 1), "the file does not say whether its angles are degrees or radians")
        .help("`--angles deg` or `--angles rad`"))
}

/// The unit of lengths: of the header or the caller.
fn length_unit(columns: &[Option<Heading>], options: &Options) -> Result<Option<&'static str>, Problem> {
    const UNITS: [&str; 5] = ["m", "cm", "mm", "in", "ft"];
    let mut found = options.unit.clone();
    for h in columns.iter().flatten().filter(|h| matches!(h.field, Field::Dh(Column::A | Column::D))) {
        match (&h.unit, &found) {
            (Some(unit), Some(other)) if unit != other => {
                return Err(Problem::new(format!("the columns have different units: {unit} and {other}")));
            }
            (Some(unit), _) => found = Some(unit.clone()),
            (None, _) => {}
        }
    }
    match found {
        None => Ok(None),
        Some(unit) => match UNITS.iter().find(|u| **u == unit) {
            Some(unit) => Ok(Some(*unit)),
            None => Err(Problem::new(format!("no unit `{unit}`: one of {}", UNITS.join(", ")))),
        },
    }
}

/// A name of a row; its number is none.
fn label(cell: &str) -> String {
    let cell = cell.trim().trim_matches('$');
    if cell.chars().any(char::is_alphabetic) && !cell.starts_with('q') { cell.to_string() } else { String::new() }
}

/// Numbers to cells: exact angles are recovered, and what was rounded is told.
pub(super) fn finish(
    rows: Vec<Cells>,
    convention: Convention,
    unit: Option<&'static str>,
    options: &Options,
    mut notes: Vec<String>,
    origin: &str,
) -> Result<Imported, Problem> {
    let reach: f64 = rows.iter().map(|r| r.a.abs() + r.d.abs()).sum();
    let limits = Limits::new(options.rounding, reach.max(1e-3));
    let mut sheet = Sheet {
        docs: vec![format!("{}; {origin}.", options.name.as_deref().unwrap_or("An arm"))],
        name: options.name.clone().unwrap_or_else(|| type_name("arm")),
        convention,
        unit,
        base: String::new(),
        tool: String::new(),
        settings: Vec::new(),
        rows: Vec::new(),
    };
    let mut motor = 0;
    for row in &rows {
        let mut angle = |x: f64, what: &str| -> Angle {
            let exact = limits.angle(x).folded();
            let off = (limits.angle(x).radians() - x).abs();
            if off > 1e-11 {
                notes.push(format!("line {}: {what} {} -> {}, off by {off:.1e}", row.line, shown(x), exact.text()));
            }
            exact
        };
        let alpha = angle(row.alpha, "alpha").text();
        let theta = angle(row.theta + if row.turns { row.offset } else { 0.0 }, "theta");
        let d = row.d + if row.turns { 0.0 } else { row.offset };
        let mut cells = SheetRow {
            alpha,
            a: number(row.a),
            d: number(d),
            theta: theta.text(),
            range: "-".into(),
            label: row.label.clone(),
        };
        if !row.fixed {
            motor += 1;
            let cell = if row.turns { &mut cells.theta } else { &mut cells.d };
            *cell = match cell.as_str() {
                "0" => format!("q{motor}"),
                constant => match constant.strip_prefix('-') {
                    Some(rest) => format!("q{motor} - {rest}"),
                    None => format!("q{motor} + {constant}"),
                },
            };
            if let Some((low, high)) = row.range {
                let (low, high) = if low > high { (high, low) } else { (low, high) };
                cells.range = if row.turns {
                    let bound = |x: f64| {
                        let degrees = x.to_degrees();
                        let short = (degrees * 100.0).round() / 100.0;
                        if (short - degrees).abs() < 1e-6 {
                            format!("{}deg", number(short))
                        } else {
                            format!("{}rad", number(x))
                        }
                    };
                    format!("{}..={}", bound(low), bound(high))
                } else {
                    format!("{}..={}", number(low), number(high))
                };
            }
        }
        sheet.rows.push(cells);
    }
    describe::finish(sheet, notes)
}
