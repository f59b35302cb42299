//! A sheet of equations and numbers: what a reader of a chapter writes down, and whether it fits together.

use super::matrix::{Matrix, elementary, inverse, times};
use crate::handwork::formula::{Formula, read};
use std::collections::BTreeMap;

#[derive(Clone, Debug)]
enum Value {
    Scalar(f64),
    Matrix(Matrix),
}

/// Names and numbers that hold together.
type Numbers = BTreeMap<String, f64>;

/// What was read.
#[derive(Default)]
pub(crate) struct Sheet {
    /// Matrices as printed, by the number of their placeholder.
    cells: Vec<Vec<Vec<Formula>>>,
    /// Displayed equations, side by side.
    equations: Vec<(String, Vec<Formula>)>,
    /// Numbers in running text.
    given: Numbers,
    /// Numbers of the solution that is followed.
    followed: Numbers,
    /// Rows of tables and lists that are alternatives.
    alternatives: Vec<Numbers>,
    /// What the note abbreviates: c_2 and the angle, or c_i and the angle with i.
    legend: BTreeMap<String, String>,
}

/// One consistent set of values.
struct World<'a> {
    sheet: &'a Sheet,
    numbers: Numbers,
    matrices: BTreeMap<String, Matrix>,
}

const ANGLES: [&str; 8] = ["theta", "q", "beta", "alpha", "gamma", "psi", "varphi", "phi"];

fn name_of(f: &Formula) -> Option<&str> {
    match f {
        Formula::Name(n) => Some(n),
        Formula::Sum(list) => match list.as_slice() {
            [('+', only)] => name_of(only),
            _ => None,
        },
        Formula::Product(list) => match list.as_slice() {
            [only] => name_of(only),
            _ => None,
        },
        _ => None,
    }
}

fn is_angle(f: &Formula) -> bool {
    name_of(f).is_some_and(|n| ANGLES.iter().any(|a| n == *a || n.starts_with(&format!("{a}_"))))
}

/// Cut at `=` outside of braces.
fn sides(text: &str) -> Vec<String> {
    let (mut depth, mut out) = (0, vec![String::new()]);
    for c in text.chars() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        match c {
            '=' if depth == 0 => out.push(String::new()),
            c => out.last_mut().unwrap().push(c),
        }
    }
    out.iter().map(|s| s.trim().to_string()).collect()
}

impl Sheet {
    /// Reads a note.
    pub(crate) fn read(&mut self, text: &str) {
        let mut block: Option<String> = None;
        let mut list: Vec<Numbers> = Vec::new();
        let mut header: Option<Vec<String>> = None;
        let mut solution: Vec<(String, Numbers)> = Vec::new();
        // Of the worked example: its solutions, and the values that are assumed.
        let mut example = false;
        for line in text.lines() {
            if line.trim() == "$$" {
                match block.take() {
                    Some(b) => self.display(&b),
                    None => block = Some(String::new()),
                }
                continue;
            }
            if let Some(b) = &mut block {
                b.push_str(line);
                b.push('\n');
                continue;
            }
            if line.starts_with("## ") {
                example = line == "## Worked example";
            }
            let inline: Vec<&str> = line.split('$').skip(1).step_by(2).collect();
            let words: String = line.split('$').step_by(2).collect();
            if line.starts_with('|') {
                let cells: Vec<String> =
                    line.trim_matches('|').split(" | ").map(|c| c.trim().trim_matches('$').to_string()).collect();
                if line.starts_with("|--") {
                    continue;
                }
                match &header {
                    None => header = Some(cells),
                    Some(names) => {
                        let values = names.iter().zip(&cells).filter_map(|(n, c)| {
                            let name = name_of(&read(n)?)?.to_string();
                            Some((name, self.constant(c)?))
                        });
                        let row: Numbers = values.collect();
                        if names.first().is_some_and(String::is_empty) {
                            solution.push((cells[0].clone(), row));
                        } else if !example && !names.iter().any(|n| n.contains("i - 1") || n.contains("theta_i")) {
                            self.alternatives.push(row);
                        }
                    }
                }
                continue;
            }
            if !line.is_empty() {
                header = None;
            }
            let numbers: Numbers = inline.iter().filter_map(|t| self.named(t)).collect();
            for text in inline.iter().filter(|t| t.starts_with("c_")) {
                let [left, right] = &sides(text)[..] else { continue };
                let angle = right.strip_prefix("\\cos").and_then(read);
                if let (Some(left), Some(angle)) = (read(left), angle)
                    && let (Some(c), Some(angle)) = (name_of(&left), name_of(&angle))
                {
                    self.legend.entry(c.to_string()).or_insert(angle.to_string());
                }
            }
            if example && !line.starts_with("Parameters without") {
                continue;
            }
            let plain = words.trim_start_matches("- ").chars().all(|c| ", ".contains(c));
            if line.starts_with("so that") {
                for text in inline.iter().filter(|t| t.contains('=')) {
                    let formulas = sides(text).iter().map(|s| read(s)).collect::<Option<Vec<_>>>();
                    self.equations.push((text.to_string(), formulas.unwrap_or_else(|| panic!("cannot read {text}"))));
                }
            }
            if line.starts_with("- ") && plain {
                list.push(numbers);
            } else if line.starts_with("On the way to solution") {
                let number = inline.first().copied().unwrap_or_default();
                let row = solution.iter().find(|s| s.0 == number).map(|s| s.1.clone());
                self.followed.extend(row.unwrap_or_default());
            } else if line.starts_with("With") && line.contains("of the worked example") {
                self.followed.extend(numbers);
            } else if !line.starts_with("- ") && !line.contains("is a root") && !line.contains("with the arm at") {
                self.given.extend(numbers);
            }
            if !line.starts_with("- ") && !line.is_empty() {
                self.lists(&mut list);
            }
        }
        self.lists(&mut list);
        // Where no solution is named, the one of the example's joint values.
        if self.followed.is_empty() {
            let near = |row: &Numbers| row.iter().all(|(n, x)| self.given.get(n).is_none_or(|y| (x - y).abs() < 1e-6));
            let first = solution.iter().find(|s| near(&s.1)).or(solution.first()).map(|s| s.1.clone());
            self.followed.extend(first.unwrap_or_default());
        }
    }

    /// A list of numbers: alternatives where items have names in common.
    fn lists(&mut self, list: &mut Vec<Numbers>) {
        let twice = |a: &Numbers| list.iter().filter(|b| b.keys().any(|k| a.contains_key(k))).count() > 1;
        if list.iter().any(twice) {
            self.alternatives.append(list);
        } else {
            self.followed.extend(list.drain(..).flatten());
        }
    }

    fn constant(&self, text: &str) -> Option<f64> {
        let world = World { sheet: self, numbers: Numbers::new(), matrices: BTreeMap::new() };
        world.scalar(&read(text)?, 1.0)
    }

    /// Is a side a matrix of numbers?
    fn is_numeric(&self, equation: &(String, Vec<Formula>)) -> bool {
        let world = World { sheet: self, numbers: Numbers::new(), matrices: BTreeMap::new() };
        equation.1.iter().any(|side| matches!(world.value(side, 1.0), Some(Value::Matrix(_))))
    }

    /// `x = 1.5`.
    fn named(&self, text: &str) -> Option<(String, f64)> {
        let [left, right] = &sides(text)[..] else { return None };
        Some((name_of(&read(left)?)?.to_string(), self.constant(right)?))
    }

    /// A displayed block: rows of aligned equations, matrices replaced by placeholders.
    fn display(&mut self, block: &str) {
        let block = block.split("\\tag").next().unwrap_or(block).trim().to_string();
        let mut text = String::new();
        let mut rest = block.as_str();
        while let Some(start) = rest.find("\\begin{bmatrix}") {
            let end = rest.find("\\end{bmatrix}").expect("the end of a matrix");
            let inner = &rest[start + "\\begin{bmatrix}".len()..end];
            let rows = inner.split("\\\\").map(|r| r.split('&').map(read).collect::<Option<Vec<_>>>());
            let rows: Option<Vec<Vec<Formula>>> = rows.collect();
            self.cells.push(rows.unwrap_or_else(|| panic!("cannot read {inner}")));
            text.push_str(&format!("{}\\Mat_{{{}}}", &rest[..start], self.cells.len() - 1));
            rest = &rest[end + "\\end{bmatrix}".len()..];
        }
        text.push_str(rest);
        for letter in ["c", "s"] {
            for i in 1..6 {
                text = text.replace(&format!("{letter}^2\\alpha_{i}"), &format!("({letter}\\alpha_{i})^2"));
            }
        }
        let inner = text.trim().strip_prefix("\\begin{aligned}").and_then(|t| t.strip_suffix("\\end{aligned}"));
        let mut rows: Vec<String> = Vec::new();
        for row in inner.unwrap_or(text.trim()).split("\\\\") {
            match rows.last_mut().filter(|_| !row.contains('=')) {
                Some(last) => last.push_str(row),
                None => rows.push(row.to_string()),
            }
        }
        for row in rows {
            let row = row.replace('&', "");
            let formulas = sides(&row).iter().map(|s| read(s)).collect::<Option<Vec<_>>>();
            let formulas = formulas.unwrap_or_else(|| panic!("cannot read {row}"));
            // the general row of a table
            if !row.contains("{i - 1}") {
                self.equations.push((row.trim().to_string(), formulas));
            }
        }
    }

    /// How many equations hold with the numbers of the solution that is followed, and in all alternatives.
    ///
    /// # Errors
    /// The first that does not, or has no value.
    pub(crate) fn judge(&self) -> Result<usize, String> {
        // an arm without a worked example has no numbers
        if self.equations.is_empty() || self.followed.is_empty() {
            return Ok(0);
        }
        let mut numbers = self.given.clone();
        numbers.extend(self.followed.clone());
        let mut world = World { sheet: self, numbers, matrices: BTreeMap::new() };
        let first = self.alternatives.iter().find(|a| {
            let fits = |(n, x): (&String, &f64)| world.numbers.get(n).is_none_or(|y| (x - y).sin().abs() < 1e-6);
            a.iter().all(fits)
        });
        if let Some(row) = first {
            let more: Vec<(String, f64)> = row.iter().map(|(n, x)| (n.clone(), *x)).collect();
            for (n, x) in more {
                world.numbers.entry(n).or_insert(x);
            }
        }
        let mut held = world.check(true)?;
        for row in &self.alternatives {
            let mut numbers = self.given.clone();
            numbers.remove("u");
            numbers.extend(row.clone());
            // other roots have other matrices than the solution that is followed
            let other = Sheet {
                cells: self.cells.clone(),
                equations: self
                    .equations
                    .iter()
                    .filter(|e| !row.contains_key("u") || !self.is_numeric(e))
                    .cloned()
                    .collect(),
                legend: self.legend.clone(),
                ..Sheet::default()
            };
            let mut world = World { sheet: &other, numbers, matrices: BTreeMap::new() };
            held += world.check(false)?;
        }
        Ok(held)
    }
}

impl World<'_> {
    /// Defines what can be defined, then compares all sides.
    fn check(&mut self, complete: bool) -> Result<usize, String> {
        let sheet = self.sheet;
        for _ in 0..6 {
            for (text, sides) in &sheet.equations {
                if text.contains("\\pm") {
                    continue;
                }
                // the flipped wrist is another solution
                if text.contains("prime") {
                    continue;
                }
                let Some(value) = sides.iter().rev().find_map(|s| self.value(s, 1.0)) else { continue };
                sides.iter().for_each(|s| self.define(s, &value));
            }
        }
        let mut held = 0;
        for (text, sides) in &sheet.equations {
            let values = |sign: f64| -> Vec<Option<Value>> { sides.iter().map(|s| self.value(s, sign)).collect() };
            let (plus, minus) = (values(1.0), values(-1.0));
            if complete && plus.iter().any(Option::is_none) && !text.contains("prime") {
                return Err(format!("{text}: a side has no value"));
            }
            let fits = |list: &[Option<Value>]| {
                let known: Vec<&Value> = list.iter().flatten().collect();
                known.windows(2).all(|w| same(w[0], w[1], is_angle(&sides[0])))
            };
            if plus.iter().flatten().count() < 2 {
                continue;
            }
            if !fits(&plus) && !fits(&minus) {
                return Err(format!("{text}: {plus:?} or {minus:?}; with {:?}", self.numbers));
            }
            held += 1;
        }
        Ok(held)
    }

    fn define(&mut self, left: &Formula, value: &Value) {
        match (name_of(left), value) {
            (Some(name), Value::Matrix(m)) if name.starts_with("Mat_") => {
                let Some(cells) = name[4..].parse::<usize>().ok().and_then(|i| self.sheet.cells.get(i)) else { return };
                for (row, numbers) in cells.iter().zip(m) {
                    for (cell, x) in row.iter().zip(numbers) {
                        if let Some(n) = name_of(cell) {
                            self.numbers.entry(n.to_string()).or_insert(*x);
                        }
                    }
                }
            }
            (Some(name), Value::Matrix(m)) => {
                self.matrices.entry(name.to_string()).or_insert(m.clone());
            }
            (Some(name), Value::Scalar(x)) if !name.starts_with("c_") && !name.starts_with("s_") => {
                self.numbers.entry(name.to_string()).or_insert(*x);
            }
            // the cosine of an angle between 0 and 180 degrees
            (None, Value::Scalar(x)) => {
                let Formula::Sum(list) = left else { return };
                let [('+', Formula::Product(list))] = list.as_slice() else { return };
                let [Formula::Call(name, inner)] = list.as_slice() else { return };
                if let (true, Some(n)) = (name == "cos", inner.first().and_then(name_of))
                    && n == "psi"
                {
                    self.numbers.entry(n.to_string()).or_insert(x.clamp(-1.0, 1.0).acos());
                }
            }
            _ => {}
        }
    }

    fn scalar(&self, f: &Formula, sign: f64) -> Option<f64> {
        match self.value(f, sign)? {
            Value::Scalar(x) => Some(x),
            Value::Matrix(_) => None,
        }
    }

    fn value(&self, f: &Formula, sign: f64) -> Option<Value> {
        let scalar = |f: &Formula| self.scalar(f, sign);
        Some(match f {
            Formula::Number(x) => Value::Scalar(*x),
            Formula::Name(name) => return self.name(name, sign),
            Formula::Sum(list) => {
                if let [('+', only)] = list.as_slice() {
                    return self.value(only, sign);
                }
                let mut sum = 0.0;
                for (s, f) in list {
                    let x = scalar(f)?;
                    sum += match s {
                        '-' => -x,
                        '±' => sign * x,
                        _ => x,
                    };
                }
                Value::Scalar(sum)
            }
            Formula::Product(list) => {
                let (mut factor, mut product): (f64, Option<Matrix>) = (1.0, None);
                for f in list {
                    match self.value(f, sign)? {
                        Value::Scalar(x) => factor *= x,
                        Value::Matrix(m) => product = Some(product.map_or(m.clone(), |p| times(&p, &m))),
                    }
                }
                product.map_or(Value::Scalar(factor), Value::Matrix)
            }
            Formula::Quotient(a, b) => Value::Scalar(scalar(a)? / scalar(b)?),
            Formula::Root(a) => Value::Scalar(scalar(a)?.max(0.0).sqrt()),
            Formula::Power(a, n) => match self.value(a, sign)? {
                Value::Scalar(x) => Value::Scalar(x.powi(*n)),
                Value::Matrix(m) if *n == -1 => Value::Matrix(inverse(&m)),
                Value::Matrix(_) => return None,
            },
            Formula::Call(name, list) => {
                let x: Vec<f64> = list.iter().map(scalar).collect::<Option<_>>()?;
                match (name.as_str(), x.as_slice()) {
                    ("atan2", [y, x]) => Value::Scalar(y.atan2(*x)),
                    ("cos", [x]) => Value::Scalar(x.cos()),
                    ("sin", [x]) => Value::Scalar(x.sin()),
                    ("tan", [x]) => Value::Scalar(x.tan()),
                    (motion, [x]) if motion.len() == 3 => Value::Matrix(elementary(motion, *x)?),
                    _ => return None,
                }
            }
            Formula::Matrix(_) => return None,
        })
    }

    fn name(&self, name: &str, sign: f64) -> Option<Value> {
        if let Some(i) = name.strip_prefix("Mat_") {
            let rows = self.sheet.cells.get(i.parse::<usize>().ok()?)?;
            let row = |r: &Vec<Formula>| r.iter().map(|f| self.scalar(f, sign)).collect::<Option<Vec<f64>>>();
            return Some(Value::Matrix(rows.iter().map(row).collect::<Option<_>>()?));
        }
        if let Some(x) = self.numbers.get(name) {
            return Some(Value::Scalar(*x));
        }
        if let Some((letter, index)) = name.split_once('_').filter(|(l, _)| matches!(*l, "c" | "s")) {
            let angle = |i: char| {
                let legend = &self.sheet.legend;
                let own = legend.get(&format!("c_{i}")).or(legend.get("c_i"));
                self.numbers.get(&own.map_or(format!("theta_{i}"), |n| n.replace("_i", &format!("_{i}"))))
            };
            let sum: Option<f64> = index.chars().map(angle).try_fold(0.0, |sum, x| Some(sum + x?));
            return sum.map(|x| Value::Scalar(if letter == "c" { x.cos() } else { x.sin() }));
        }
        if let Some((i, j)) = name.strip_prefix("t_").or(name.strip_prefix("r_")).and_then(|t| t.split_at_checked(1)) {
            // elements of the given pose
            let (i, j): (usize, usize) = (i.parse().ok()?, j.parse().ok()?);
            return Some(Value::Scalar(*self.matrices.get("G")?.get(i - 1)?.get(j - 1)?));
        }
        let axis = name.strip_prefix("p_").and_then(|a| "xyz".find(a));
        if let Some(i) = axis.filter(|_| !self.numbers.contains_key(name)) {
            return Some(Value::Scalar(*self.matrices.get("G")?.get(i)?.get(3)?));
        }
        let rigid = name.starts_with("T[") || name.starts_with("R[");
        if rigid && let Some(m) = self.way(name) {
            return Some(Value::Matrix(m));
        }
        // the index of a link transform, or whole words of names
        self.matrices.get(name).cloned().map(Value::Matrix)
    }

    /// T[i,j] from the transforms of single rows, R[i,j] from those.
    fn way(&self, name: &str) -> Option<Matrix> {
        let (from, to) = name[2..].strip_suffix(']')?.split_once(',')?;
        let ends: Vec<usize> = [from, to].iter().filter_map(|t| t.parse().ok()).collect();
        let [from, to] = ends[..] else { return None };
        if from + 1 == to && name.starts_with("T[") {
            return None;
        }
        let mut t: Option<Matrix> = None;
        for i in from..to {
            let m = self.matrices.get(&format!("T[{i},{}]", i + 1))?;
            t = Some(t.map_or(m.clone(), |t| times(&t, m)));
        }
        let t = t?;
        Some(if name.starts_with("R[") { t.iter().take(3).map(|r| r[..3].to_vec()).collect() } else { t })
    }
}

fn same(a: &Value, b: &Value, angle: bool) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-6 * (1.0 + a.abs() + b.abs());
    match (a, b) {
        (Value::Scalar(a), Value::Scalar(b)) => near(*a, *b) || angle && ((a - b) / 2.0).sin().abs() < 1e-6,
        (Value::Matrix(a), Value::Matrix(b)) => {
            let n = a.len().min(b.len());
            let square = |m: &Matrix| m.len() > 1 && m[0].len() == m.len();
            let columns = if square(a) && square(b) { n } else { a[0].len().min(b[0].len()) };
            (0..n).all(|i| (0..columns).all(|j| near(a[i][j], b[i][j])))
        }
        _ => false,
    }
}
