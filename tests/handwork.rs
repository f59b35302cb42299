//! The printed inverse, followed with a pocket calculator: every formula of every step, from the numbers that are printed.
//!
//! A note is read as Markdown by a small reader and evaluator of its own (`handwork/`). From the printed pose it goes through the
//! steps in order: known poses are products of the printed matrices, letters and roots come from the printed formulas. What comes out
//! must be what the note prints, each equation must hold, and the joint values must give the pose through the printed link transforms.

pub(crate) mod formula;
mod notebook;
pub(crate) mod tables;

use dh_symbolic::chain::Chain;
use dh_symbolic::chain::table::parse;
use dh_symbolic::render::document::notes::Part;
use dh_symbolic::render::{Format, Options, notes};
use formula::{Formula, read};
use generated_examples::source;
use notebook::{IDENTITY, Matrix, Notebook, Value, times};

/// How far two numbers may differ, over their size; the notes of this test print twelve digits.
const CLOSE: f64 = 2e-7;

fn close(a: f64, b: f64, size: f64) -> bool {
    (a - b).abs() <= CLOSE * (size + a.abs() + b.abs())
}

/// Angles may differ by whole turns.
fn same_angle(a: f64, b: f64) -> bool {
    let d = a - b;
    d.sin().atan2(d.cos()).abs() < 1e-6
}

/// What was followed in one note.
#[derive(Default)]
struct Followed {
    equations: usize,
    formulas: usize,
    numbers: usize,
}

struct Note<'a> {
    name: &'a str,
    text: String,
    book: Notebook,
    followed: Followed,
}

/// An equation: its sides as they are printed.
type Sides = Vec<String>;

/// The formulas between `$` of a line.
fn inline(line: &str) -> Vec<String> {
    line.split('$').skip(1).step_by(2).map(str::to_string).collect()
}

/// Cut at `=` outside of braces.
fn sides(text: &str) -> Sides {
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

/// The equations of a displayed block.
fn displayed(block: &str) -> Vec<Sides> {
    let block = block.split("\\tag").next().unwrap_or(block).trim();
    let Some(inner) = block.strip_prefix("\\begin{aligned}").and_then(|b| b.strip_suffix("\\end{aligned}")) else {
        return vec![sides(block)];
    };
    let mut rows: Vec<String> = Vec::new();
    for row in inner.split("\\\\") {
        match rows.last_mut().filter(|_| !row.contains("&=")) {
            Some(last) => last.push_str(row),
            None => rows.push(row.to_string()),
        }
    }
    rows.iter().map(|r| sides(&r.replace('&', ""))).collect()
}

/// What the note says of a step beside its equations.
struct Step<'a> {
    /// What it finds.
    unknown: &'a [String],
    /// Names and values.
    printed: &'a [(String, f64)],
    /// The root that is not taken.
    other: Option<f64>,
}

/// A piece of a section, in order.
enum Piece {
    Display(Vec<Sides>),
    Line(String),
}

fn pieces(text: &str) -> Vec<Piece> {
    let mut out = Vec::new();
    let mut block: Option<String> = None;
    for line in text.lines() {
        match (line.trim() == "$$", block.take()) {
            (true, None) => block = Some(String::new()),
            (true, Some(b)) => out.push(Piece::Display(displayed(&b))),
            (false, Some(b)) => block = Some(b + line + "\n"),
            (false, None) => out.push(Piece::Line(line.to_string())),
        }
    }
    out
}

/// The name that a formula is.
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

/// The name whose square a formula is.
fn squared(f: &Formula) -> Option<&str> {
    match f {
        Formula::Power(n, 2) => name_of(n),
        Formula::Sum(list) => match list.as_slice() {
            [('+', only)] => squared(only),
            _ => None,
        },
        Formula::Product(list) => match list.as_slice() {
            [only] => squared(only),
            _ => None,
        },
        _ => None,
    }
}

impl Note<'_> {
    fn section(&self, heading: &str) -> &str {
        let start = self.text.find(heading).map_or(self.text.len(), |i| i + heading.len());
        let rest = &self.text[start..];
        rest.find("\n## ").map_or(rest, |end| &rest[..end])
    }

    /// Values of the table, link transforms, products, abbreviations.
    fn learn(&mut self) {
        let before = self.text.find("## Inverse kinematics").unwrap_or(self.text.len());
        let first = self.text[..before].to_string();
        for piece in pieces(&first) {
            match piece {
                Piece::Line(line) => inline(&line).iter().for_each(|f| self.legend(f)),
                Piece::Display(list) => list.iter().for_each(|s| self.transform(s)),
            }
        }
        let inverse = self.text[before..].to_string();
        for line in inverse.lines().filter(|l| !l.starts_with("- Step")) {
            inline(line).iter().for_each(|f| self.abbreviation(f));
            if line.starts_with("Parameters without a value") {
                inline(line).iter().for_each(|f| self.legend(f));
            }
        }
    }

    /// `a_2 = 0.5`, `c_{23} = cos(theta_2 + theta_3)`.
    fn legend(&mut self, text: &str) {
        self.abbreviation(text);
        let [left, right] = &sides(text)[..] else { return };
        let (Some(left), Some(right)) = (read(left), read(right)) else { return };
        let (Some(name), Some(value)) = (name_of(&left), self.book.scalar(&right, 1.0)) else { return };
        self.book.scalars.insert(name.to_string(), value);
    }

    fn abbreviation(&mut self, text: &str) {
        let [left, right] = &sides(text)[..] else { return };
        let (Some(left), Some(right)) = (read(left), read(right)) else { return };
        let Some(name) = name_of(&left).filter(|n| n.starts_with("c_") || n.starts_with("s_")) else { return };
        if name.ends_with("_i") {
            let text = format!("{right:?}");
            let stem = if text.contains("\"theta_i\"") { "theta" } else { "q" };
            if !self.book.stems.iter().any(|s| s == stem) {
                self.book.stems.push(stem.to_string());
            }
        } else {
            self.book.formulas.insert(name.to_string(), right);
        }
    }

    /// `{}^0_1T = ... = matrix`, and names of entries.
    fn transform(&mut self, sides: &Sides) {
        let (Some(left), Some(right)) = (sides.first().and_then(|s| read(s)), sides.last().and_then(|s| read(s)))
        else {
            return;
        };
        if let Some(name) = name_of(&left).filter(|n| !n.contains('i') && sides.len() > 1) {
            self.book.formulas.insert(name.to_string(), right);
        }
    }

    fn fail(&self, what: &str) -> ! {
        panic!("{}: {what}\n{}", self.name, self.section("## Inverse kinematics"))
    }

    /// The given pose.
    fn given(&mut self) {
        let example = self.section("## Worked example").to_string();
        let wanted = self.section("## Inverse kinematics").to_string();
        let of = inline(wanted.lines().find(|l| l.contains("wanted are")).unwrap_or_default());
        let of = sides(of.first().map_or("", |s| s))[0].clone();
        for piece in pieces(&example) {
            let Piece::Display(list) = piece else { continue };
            for s in list {
                if s.first().is_some_and(|l| l == "G") {
                    let Some(m) = s.last().and_then(|t| read(t)).and_then(|f| self.book.matrix(&f)) else { continue };
                    self.entries("r", "p", &m);
                    self.book.matrices.insert("G".into(), m);
                    if let Some(name) = read(&of).as_ref().and_then(name_of) {
                        self.book.matrices.insert(name.to_string(), m);
                    }
                }
            }
        }
        let chosen: Vec<String> = wanted.lines().filter(|l| l.ends_with("is prescribed.")).flat_map(inline).collect();
        let names: Vec<String> = chosen.iter().filter_map(|c| Some(name_of(&read(c)?)?.to_string())).collect();
        let values = example.lines().filter(|l| l.contains("forward kinematics gives the pose")).flat_map(inline);
        for text in values {
            let [left, right] = &sides(&text)[..] else { continue };
            let (Some(left), Some(right)) = (read(left), read(right)) else { continue };
            if let Some(name) = name_of(&left).filter(|n| names.iter().any(|m| m == n)) {
                let value = self.book.scalar(&right, 1.0).unwrap_or(f64::NAN);
                self.book.scalars.insert(name.to_string(), value);
            }
        }
    }

    fn entries(&mut self, r: &str, p: &str, m: &Matrix) {
        for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
            for j in 0..3 {
                self.book.scalars.insert(format!("{r}_{}{}", i + 1, j + 1), m[i][j]);
            }
            self.book.scalars.insert(format!("{p}_{axis}"), m[i][3]);
        }
    }

    /// The numbers that the note prints for a step: names and values, and the other root.
    fn printed(&self, step: usize) -> (Vec<(String, f64)>, Option<f64>) {
        let head = format!("- Step {step}: ");
        let example = self.section("## Worked example");
        let Some(line) = example.lines().find(|l| l.starts_with(&head)) else {
            self.fail(&format!("no numbers of step {step}"))
        };
        let number = |text: &str| read(text).and_then(|f| self.book.scalar(&f, 1.0));
        let mut list = Vec::new();
        let mut other = None;
        for text in inline(line) {
            match &sides(&text)[..] {
                [left, right] => {
                    let left = read(left).unwrap_or_else(|| self.fail(&text));
                    let name = name_of(&left).map(str::to_string).or(squared(&left).map(|n| format!("{n}^2")));
                    list.push((
                        name.unwrap_or_else(|| self.fail(&text)),
                        number(right).unwrap_or_else(|| self.fail(&text)),
                    ));
                }
                [only] => other = number(only),
                _ => self.fail(&text),
            }
        }
        (list, other)
    }

    /// All steps in order.
    fn follow(&mut self) {
        let inverse = self.section("## Inverse kinematics").to_string();
        let mut parts = inverse.split("\n### Step ");
        let preface = parts.next().unwrap_or_default().to_string();
        for piece in pieces(&preface) {
            let Piece::Display(list) = piece else { continue };
            list.iter().for_each(|s| self.transform(s));
        }
        let mut sums: Vec<Sides> = Vec::new();
        for (i, part) in parts.enumerate() {
            let (title, rest) = part.split_once('\n').unwrap_or((part, ""));
            let unknown: Vec<String> =
                inline(title).iter().filter_map(|t| Some(name_of(&read(t)?)?.to_string())).collect();
            let (printed, other) = self.printed(i + 1);
            let value = |name: &str| printed.iter().find(|p| p.0 == name).map(|p| p.1);
            let mut waiting: Vec<Sides> = Vec::new();
            let step = Step { unknown: &unknown, printed: &printed, other };
            let (body, last) = rest.split_once("The remaining joints are differences:").unwrap_or((rest, ""));
            for piece in pieces(body) {
                match piece {
                    Piece::Line(line) => {
                        for text in inline(&line) {
                            let s = sides(&text);
                            if s.len() == 2 && read(&s[0]).as_ref().and_then(squared).is_some()
                                || s[0].contains("prime") && s.len() == 2
                            {
                                self.equation(&s, &step, false, &mut waiting);
                            } else if s.len() == 2
                                && unknown.iter().any(|u| read(&s[0]).as_ref().and_then(name_of) == Some(u))
                            {
                                sums.push(s);
                            }
                        }
                    }
                    Piece::Display(list) => {
                        for s in list {
                            self.equation(&s, &step, false, &mut waiting);
                        }
                    }
                }
            }
            let is_root = |s: &Sides| {
                let left = read(&s[0]);
                left.as_ref().and_then(name_of).is_some_and(|n| unknown.iter().any(|u| u == n))
            };
            let (roots, waiting): (Vec<Sides>, Vec<Sides>) = waiting.into_iter().partition(is_root);
            for s in roots {
                self.equation(&s, &step, true, &mut Vec::new());
            }
            for name in &unknown {
                if let Some(x) = value(name) {
                    self.book.scalars.insert(name.clone(), x);
                }
            }
            for s in waiting {
                self.holds(&s);
            }
            self.numbers(i + 1, &printed);
            for piece in pieces(last) {
                let Piece::Display(list) = piece else { continue };
                for s in list {
                    self.equation(&s, &Step { unknown: &[], printed: &[], other: None }, false, &mut Vec::new());
                }
            }
        }
        for s in sums {
            let both: Vec<Option<f64>> = s.iter().map(|t| self.book.scalar(&read(t)?, 1.0)).collect();
            let [Some(a), Some(b)] = both[..] else { self.fail(&format!("{s:?}: {both:?}")) };
            if !same_angle(a, b) {
                self.fail(&format!("{s:?}: {a} and {b}"));
            }
        }
    }

    /// A definition, a root, or an equation that has to wait for the unknown.
    fn equation(&mut self, s: &Sides, step: &Step<'_>, last: bool, waiting: &mut Vec<Sides>) {
        let Step { unknown, printed, other } = *step;
        let [left_text, right_text] = &s[..] else { return };
        let Some(left) = read(left_text) else { self.fail(left_text) };
        let name = name_of(&left).map(str::to_string);
        if let Some(name) = name.clone().filter(|n| unknown.contains(n)) {
            // what it is made of may be told after it
            if !last {
                waiting.push(s.clone());
                return;
            }
            let mut roots = Vec::new();
            for part in right_text.split("\\qquad") {
                let part = part.trim().trim_end_matches(',');
                let Some(f) = read(part) else { self.fail(part) };
                for sign in [1.0, -1.0] {
                    let Some(x) = self.book.scalar(&f, sign) else { self.fail(&format!("{part} is not known")) };
                    roots.push(x);
                }
            }
            let turns = !name.starts_with('d') || name == "q";
            let same = |a: f64, b: f64| close(a, b, 1.0) || turns && same_angle(a, b);
            for wanted in printed.iter().find(|p| p.0 == name).map(|p| p.1).into_iter().chain(other) {
                if !roots.iter().any(|x| same(*x, wanted)) {
                    self.fail(&format!("{name}: {right_text} gives {roots:?}, printed is {wanted}"));
                }
            }
            self.followed.formulas += 1;
            return;
        }
        let right = read(right_text);
        let value = right.as_ref().and_then(|f| self.book.value(f, 1.0));
        match (name, value) {
            (Some(name), Some(Value::Matrix(m))) if name.len() == 1 => {
                let small = name.to_lowercase();
                self.entries(&small, &small, &m);
                self.book.matrices.insert(name, m);
            }
            (Some(name), Some(Value::Scalar(x)))
                if !self.book.scalars.contains_key(&name) && !name.starts_with("c_") && !name.starts_with("s_") =>
            {
                self.book.scalars.insert(name, x);
            }
            // a letter that is made of what comes later
            (Some(name), None) if name.starts_with(char::is_uppercase) && right.is_some() => {
                self.book.formulas.extend(right.map(|f| (name, f)));
            }
            (None, Some(Value::Scalar(x))) if squared(&left).is_some() => {
                let name = squared(&left).unwrap_or_default().to_string();
                self.book.scalars.insert(name, x.max(0.0).sqrt());
            }
            _ => waiting.push(s.clone()),
        }
    }

    fn holds(&mut self, s: &Sides) {
        let both: Vec<Option<f64>> = s.iter().map(|t| self.book.scalar(&read(t)?, 1.0)).collect();
        let [Some(a), Some(b)] = both[..] else { self.fail(&format!("{s:?}: {both:?}")) };
        if !close(a, b, 1.0) {
            self.fail(&format!("{} = {a}, {} = {b}", s[0], s[1]));
        }
        self.followed.equations += 1;
    }

    /// What is printed for letters and entries.
    fn numbers(&mut self, step: usize, printed: &[(String, f64)]) {
        for (name, x) in printed {
            let own = match name.strip_suffix("^2") {
                Some(root) => self.book.scalars.get(root).map(|v| v * v),
                None => self.book.scalar(&Formula::Name(name.clone()), 1.0),
            };
            let Some(own) = own else { self.fail(&format!("step {step}: {name} is printed and not known")) };
            if !close(own, *x, 1e-3) && !same_angle(own, *x) {
                self.fail(&format!("step {step}: {name} = {own}, printed is {x}"));
            }
            self.followed.numbers += 1;
        }
    }

    /// The joint values give the pose through the printed link transforms.
    fn arrives(&self, chain: &Chain) {
        let mut free = self.book.clone();
        let given = std::mem::take(&mut free.matrices);
        let n = chain.links.len();
        let mut t = IDENTITY;
        for i in 0..n {
            let Some(Value::Matrix(m)) = free.value(&Formula::Name(format!("T[{i},{}]", i + 1)), 1.0) else {
                self.fail(&format!("row {}", i + 1))
            };
            t = times(&t, &m);
        }
        let constant = |name: &str| free.matrix(&Formula::Name(name.into()));
        if !chain.base.is_empty() {
            t = times(&constant("T[b,0]").unwrap_or_else(|| self.fail("base")), &t);
        }
        if !chain.tool.is_empty() {
            t = times(&t, &constant(&format!("T[{n},e]")).unwrap_or_else(|| self.fail("tool")));
        }
        let Some(goal) = given.get("G") else { self.fail("no pose") };
        use dh_symbolic::chain::Task;
        for i in 0..3 {
            for j in 0..4 {
                let counts = match chain.settings.task {
                    Task::Pose => true,
                    Task::Position => j == 3,
                    Task::Axis => j >= 2,
                    Task::Planar => i < 2 && (j == 0 || j == 3),
                };
                if counts && !close(t[i][j], goal[i][j], 1.0) {
                    self.fail(&format!("entry {i} {j}: {} instead of {}", t[i][j], goal[i][j]));
                }
            }
        }
    }
}

/// Follows the note of a table; `None` where it has no example.
fn follow(name: &str, table: &str) -> Option<Followed> {
    let parsed = parse(table.parse().expect("words"));
    let chain = Chain::new(parsed.spec.unwrap_or_else(|| panic!("{name}: no table\n{table}")));
    let parts = vec![Part::Table, Part::Links, Part::Forward, Part::Inverse, Part::Example];
    let options = Options { parts, width: 4000, digits: 12, ..Options::default() };
    let text = notes(&chain, &options).print(Format::Markdown);
    if !text.contains("\n- Step ") {
        return None;
    }
    let mut note = Note { name, text, book: Notebook::default(), followed: Followed::default() };
    note.learn();
    note.given();
    note.follow();
    note.arrives(&chain);
    Some(note.followed)
}

#[test]
fn printed_steps_of_the_examples() {
    let (mut equations, mut formulas, mut numbers) = (0, 0, 0);
    let all = source::all().unwrap();
    let own = tables::OWN.iter().map(|(n, t)| (n.to_string(), t.to_string()));
    for (name, table) in all.into_iter().map(|s| (s.module, s.body)).chain(own) {
        let Some(f) = follow(&name, &table) else { continue };
        (equations, formulas, numbers) = (equations + f.equations, formulas + f.formulas, numbers + f.numbers);
    }
    assert!(equations > 150 && formulas > 100 && numbers > 400, "{equations} {formulas} {numbers}");
}

#[test]
fn printed_steps_of_random_tables() {
    let mut formulas = 0;
    for seed in 0..tables::RANDOM {
        let table = tables::random(seed);
        formulas += follow(&format!("random {seed}"), &table).map_or(0, |f| f.formulas);
    }
    assert!(formulas > 80, "{formulas}");
}
