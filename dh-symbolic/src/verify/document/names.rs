//! Resolves letters with indices: names of the table, abbreviations, matrix entries, names defined by the document.

use super::layout::Item;
use super::letter::{Letter, field, general};
use super::tables::function;
use crate::algebra::{Poly, Rational};
use crate::chain::{Chain, Convention, Coordinate, Handle, Nominal, Parameter, Role};
use crate::render::formula::greek;
use std::collections::BTreeSet;

/// A name without a meaning, or why it has none.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Unknown {
    pub(super) why: String,
    /// The name, where a definition would give it a meaning.
    pub(super) name: Option<String>,
}

/// Everything that names depend on.
pub(super) struct DocumentNames<'a> {
    pub(super) chain: &'a Chain,
    /// Entries that a matrix of names has named: the letter, what it is.
    bound: Vec<(Letter, String)>,
    /// Names that the document gives: the letter, the name, whether it is a 4x4 matrix.
    given: Vec<(Letter, String, bool)>,
    /// Joints whose c1 and s1 are those of the table's angle and not of the variable.
    of_table: Vec<usize>,
    /// The transform whose entries r_{11} and p_x are, where the document says so.
    given_pose: Option<String>,
    /// Frames that the document defines: the label, how the frame is seen from frame 0.
    frames: Vec<(String, String)>,
    /// Values given so far: settings of an `at` line.
    pub(super) values: Vec<(String, String)>,
    /// The last side of the statement before.
    pub(super) last_side: Vec<Item>,
    /// The same, also of statements about any row.
    pub(super) last_general: Vec<Item>,
    /// Does theta_i mean the variable of joint i, also where the table's angle has an offset?
    pub(super) theta_is_variable: bool,
    /// Is the document about other arms too?
    pub(super) has_others: bool,
    /// Letters that stand alone on one side of an equation somewhere.
    pub(super) definable: BTreeSet<String>,
    /// Letters that belong to another arm.
    pub(super) aliens: BTreeSet<String>,
    /// Letters without a meaning in the statements so far.
    pub(super) seen: BTreeSet<String>,
    /// Quantities that the document leaves free.
    pub(super) free: BTreeSet<String>,
    /// Letters of laws that hold for any quantities.
    pub(super) generic: BTreeSet<String>,
    /// Letters that are equal to something of the arm, somewhere in the document.
    pub(super) concrete: BTreeSet<String>,
    /// What was learnt when the document was read before.
    pub(super) learnt: super::Learnt,
    /// Values under which the statements of a line are said: the line, the variable, its value.
    pub(super) conditions: Vec<(usize, String, String)>,
    /// Lines that begin with a condition which this arm does not meet.
    pub(super) elsewhere: BTreeSet<usize>,
    /// Was theta_i read where the two differ?
    pub(super) theta_differs: std::cell::Cell<bool>,
}

impl<'a> DocumentNames<'a> {
    pub(super) fn new(chain: &'a Chain) -> DocumentNames<'a> {
        DocumentNames {
            chain,
            bound: Vec::new(),
            given: Vec::new(),
            of_table: Vec::new(),
            given_pose: None,
            frames: Vec::new(),
            values: Vec::new(),
            last_side: Vec::new(),
            last_general: Vec::new(),
            theta_is_variable: false,
            has_others: false,
            definable: BTreeSet::new(),
            aliens: BTreeSet::new(),
            seen: BTreeSet::new(),
            free: BTreeSet::new(),
            generic: BTreeSet::new(),
            concrete: BTreeSet::new(),
            learnt: super::Learnt::default(),
            conditions: Vec::new(),
            elsewhere: BTreeSet::new(),
            theta_differs: std::cell::Cell::new(false),
        }
    }

    fn declared(&self) -> impl Iterator<Item = &'a Parameter> {
        self.chain.parameters.iter().filter(|p| p.declared)
    }

    /// May these letters of plain text stand in a formula?
    pub(super) fn is_word(&self, run: &str) -> bool {
        run.len() == 1
            || function(run).is_some()
            || greek::letter(run).is_some()
            || matches!(run, "pi" | "deg" | "mm" | "cm")
            || run.len() == 2 && run.ends_with(['x', 'y', 'z'])
            || self.declared().any(|p| p.name.split(|c: char| !c.is_ascii_alphabetic()).any(|part| part == run))
            || run.chars().all(|c| "cs".contains(c))
    }

    /// Length of the longest known word that plain text begins with.
    pub(super) fn longest(&self, rest: &str) -> Option<usize> {
        let fixed = ["pi"].into_iter();
        let functions = [
            "cos", "sin", "tan", "atan2", "arctan2", "atan", "arctan", "acos", "arccos", "asin", "arcsin", "sqrt",
            "Rot", "Trans", "inv",
        ];
        let greek = greek::GREEK.iter().map(|g| g.0);
        let own = self.declared().map(|p| p.name.as_str());
        let fits = |word: &&str| {
            let last = word.chars().last().unwrap_or(' ');
            rest.strip_prefix(*word).is_some_and(|tail| {
                let next = tail.chars().next().unwrap_or(' ');
                if last.is_ascii_digit() { !next.is_ascii_digit() } else { !next.is_ascii_alphabetic() }
            })
        };
        fixed.chain(functions).chain(greek).chain(own).filter(fits).map(str::len).max()
    }

    /// The row of a turning joint whose angle has this number, and its variable.
    fn turning(&self, number: usize) -> Option<(usize, usize)> {
        let k = self.chain.joints.iter().position(|j| j.row + 1 == number)?;
        matches!(self.chain.joints.get(k)?.coordinate, Coordinate::Angle(_)).then_some((number, k + 1))
    }

    /// Is the table's angle of this row the variable itself?
    fn is_variable(&self, row: usize) -> bool {
        let Some(joint) = self.chain.joints.iter().find(|j| j.row + 1 == row) else { return false };
        let plain = self.chain.links.get(joint.row).is_some_and(|l| l.theta.constant.is_zero());
        if self.chain.is_direct() && joint.shift.is_zero() && plain {
            return true;
        }
        self.theta_differs.set(true);
        self.theta_is_variable && self.chain.is_direct()
    }

    /// The angle whose cosine is c_n.
    fn numbered_angle(&self, n: usize) -> String {
        if self.of_table.contains(&n) && !self.is_variable(n) { format!("theta{n}") } else { format!("q{n}") }
    }

    /// `c_i = cos theta_i` (or q_i): for one joint, or for all.
    pub(super) fn say_angle(&mut self, index: &str, table: bool) {
        let list: Vec<usize> = match index.parse() {
            Ok(n) => vec![n],
            Err(_) => (1..=self.chain.links.len()).collect(),
        };
        self.of_table.retain(|n| !list.contains(n));
        if table {
            self.of_table.extend(list);
        }
    }

    /// The joints of `23`, `2-3`, `1,10`: subtracted?, number.
    fn joints(index: &str) -> Option<Vec<(bool, usize)>> {
        let wide = index.contains(',');
        let mut out = Vec::new();
        let (mut minus, mut digits) = (false, String::new());
        for c in index.chars().chain([',']) {
            if c.is_ascii_digit() {
                digits.push(c);
                if wide {
                    continue;
                }
            }
            if !digits.is_empty() {
                out.push((minus, std::mem::take(&mut digits).parse().ok()?));
                minus = false;
            }
            match c {
                '-' => minus = true,
                c if c.is_ascii_digit() || matches!(c, ',' | '+') => {}
                _ => return None,
            }
        }
        (!out.is_empty()).then_some(out)
    }

    /// c_{23}, s_1, c_{2-3}; `None` where the index is no list of joints.
    fn abbreviation(&self, stem: &str, index: &str) -> Option<String> {
        let joints = DocumentNames::joints(index)?;
        let angles: Vec<(bool, String)> = joints.iter().map(|(m, n)| (*m, self.numbered_angle(*n))).collect();
        let short = angles.iter().all(|(minus, a)| !minus && a.starts_with('q') && a.len() == 2);
        if short {
            let digits: String = joints.iter().map(|j| j.1.to_string()).collect();
            return Some(format!("{stem}{digits}"));
        }
        let function = if stem == "c" { "cos" } else { "sin" };
        let mut sum = String::new();
        for (minus, a) in angles {
            let sign = match (sum.is_empty(), minus) {
                (true, false) => "",
                (_, true) => "- ",
                (false, false) => "+ ",
            };
            sum.push_str(&format!("{sign}{a} "));
        }
        Some(format!("{function} ( {sum})"))
    }

    /// Is it a name that the document gives?
    pub(super) fn is_given(&self, letter: &Letter) -> bool {
        self.given.iter().any(|g| g.0 == *letter)
    }

    /// Gives a name to an entry of a matrix.
    pub(super) fn bind(&mut self, letter: Letter, meaning: String) {
        self.bound.retain(|b| b.0 != letter);
        self.bound.push((letter, meaning));
    }

    /// Takes a name of the document; gives the name for claims.
    pub(super) fn give(&mut self, letter: &Letter, matrix: bool) -> String {
        let before = self.given.iter().filter(|g| g.0 == *letter).count();
        let name = if before == 0 { letter.own() } else { format!("{}_{}", letter.own(), "x".repeat(before)) };
        self.given.push((letter.clone(), name.clone(), matrix));
        self.aliens.remove(&letter.own());
        name
    }

    /// What a letter with indices stands for, as words of a claim with room between them.
    pub(super) fn meaning(&self, letter: &Letter) -> Result<String, Unknown> {
        if let Some((_, meaning)) = self.bound.iter().find(|b| b.0 == *letter) {
            return Ok(meaning.clone());
        }
        if let Some((_, name, _)) = self.given.iter().rev().find(|g| g.0 == *letter) {
            return Ok(name.clone());
        }
        if letter.primes == 0
            && let Some(known) = self.table_name(letter).or_else(|| self.entry(letter))
        {
            return Ok(known);
        }
        let shown = format!("{}{}{}", letter.stem, if letter.index.is_empty() { "" } else { "_" }, letter.index);
        Err(Unknown { why: format!("`{shown}` has no meaning here"), name: Some(letter.own()) })
    }

    fn table_name(&self, letter: &Letter) -> Option<String> {
        if !letter.frame.is_empty() {
            return None;
        }
        let (stem, index) = (letter.stem.as_str(), letter.index.as_str());
        if letter.is_general() {
            return matches!(stem, "alpha" | "theta" | "a" | "d").then(|| general(stem, index));
        }
        let joined = format!("{stem}{index}");
        let under = format!("{stem}_{index}");
        let same = |p: &&Parameter| p.name == joined || p.name == under;
        let alike = |p: &&Parameter| p.name.eq_ignore_ascii_case(&joined) || p.name.eq_ignore_ascii_case(&under);
        if let Some(p) = self.declared().find(same).or_else(|| self.declared().find(alike)) {
            return Some(p.name.clone());
        }
        if matches!(joined.as_str(), "pi" | "I3" | "I4") {
            return Some(joined);
        }
        let number: Option<usize> = index.parse().ok().filter(|n| *n < 1000);
        match (stem, number) {
            ("c" | "s", Some(_)) => self.abbreviation(stem, index),
            ("C" | "S", Some(_)) => self.abbreviation(&stem.to_ascii_lowercase(), index),
            ("phi", None) if index.is_empty() && self.is_planar() => {
                let pose = self.pose();
                Some(format!("atan2 ( {pose} . r21 , {pose} . r11 )"))
            }
            ("c" | "s", None) if !index.is_empty() => self.abbreviation(stem, index).or_else(|| {
                let angle = self.meaning(&Letter { stem: index.into(), ..Letter::default() }).ok()?;
                Some(format!("{} ( {angle} )", if stem == "c" { "cos" } else { "sin" }))
            }),
            // theta_{23}: the sum of the angles
            ("theta" | "t", Some(n)) if n == 0 || n > self.chain.links.len() => self.sum_of_angles(index),
            ("q", Some(n)) if n == 0 || n > self.chain.dof() => None,
            ("theta" | "t", Some(n)) => Some(if self.is_variable(n) && self.turning(n).is_some() {
                format!("q{}", self.turning(n)?.1)
            } else {
                format!("theta{n}")
            }),
            ("q" | "a" | "d" | "alpha", Some(n)) => Some(format!("{stem}{n}")),
            // lengths of the base and the tool
            _ => self
                .chain
                .parameters
                .iter()
                .find(|p| !p.declared && (p.name == joined || p.name == under))
                .map(|p| p.name.clone()),
        }
    }

    /// theta_{23} of an arm with fewer rows than 23.
    fn sum_of_angles(&self, index: &str) -> Option<String> {
        let joints = DocumentNames::joints(index).filter(|j| j.len() > 1)?;
        let angles: Option<Vec<String>> = joints
            .iter()
            .map(|(_, n)| self.table_name(&Letter { stem: "theta".into(), index: n.to_string(), ..Letter::default() }))
            .collect();
        Some(format!("( {} )", angles?.join(" + ")))
    }

    /// Do all axes point along z, so that the angle of the tool is a sum?
    fn is_planar(&self) -> bool {
        let flat = |l: &crate::chain::Link| l.alpha.terms.is_empty() && l.alpha.constant.is_zero();
        self.chain.base.is_empty() && self.chain.links.iter().all(flat)
    }

    /// The velocity of a formula: that of a joint is a quantity of its own, others follow.
    pub(super) fn velocity(&self, meaning: &str) -> String {
        let joints: Vec<&str> = self.chain.joints.iter().map(|j| j.name.as_str()).collect();
        if joints.contains(&meaning) {
            return format!("{meaning}_dot");
        }
        let parts: Vec<String> = joints.iter().map(|q| format!("diff ( {meaning} , {q} ) * {q}_dot")).collect();
        format!("( {} )", parts.join(" + "))
    }

    /// The velocities of all joints as a column.
    pub(super) fn velocities(&self) -> String {
        let all: Vec<String> = self.chain.joints.iter().map(|j| format!("{}_dot", j.name)).collect();
        format!("[ {} ]", all.join(" ; "))
    }

    /// The pose of the whole arm.
    pub(super) fn pose(&self) -> String {
        let n = self.chain.links.len();
        let base = if self.chain.base.is_empty() { "" } else { "base * " };
        let tool = if self.chain.tool.is_empty() { "" } else { " * tool" };
        if base.is_empty() && tool.is_empty() {
            format!("T ( 0 , {n} )")
        } else {
            format!("( {base}T ( 0 , {n} ){tool} )")
        }
    }

    /// r_{11}, p_x, J_2, u_{11}.
    fn entry(&self, letter: &Letter) -> Option<String> {
        let n = self.chain.links.len();
        let (stem, index) = (letter.stem.as_str(), letter.index.as_str());
        let field = field(stem, index);
        if stem == "T" && index.is_empty() && letter.frame.is_empty() {
            return Some(self.pose());
        }
        if stem == "J" && letter.frame.is_empty() {
            return match index.split_once(',') {
                None if index.is_empty() => Some("J".into()),
                None if matches!(index, "v" | "L" | "P") => Some("Jv".into()),
                None if matches!(index, "w" | "omega" | "O") => Some("Jw".into()),
                None if index.len() == 2 && index.bytes().all(|b| b.is_ascii_digit()) => {
                    Some(format!("J ( {} , {} )", &index[..1], &index[1..]))
                }
                None if index.bytes().all(|b| b.is_ascii_digit()) => Some(format!("J ( {index} )")),
                Some((r, k)) => Some(format!("J ( {r} , {k} )")),
                None => None,
            };
        }
        if matches!(stem, "r" | "p" | "px" | "py" | "pz") {
            let field = field?;
            return match letter.frame.as_str() {
                "" => Some(format!("{} . {field}", self.given_pose.clone().unwrap_or_else(|| self.pose()))),
                k if k.bytes().all(|b| b.is_ascii_digit()) => Some(format!("T ( {k} , {n} ) . {field}")),
                _ => None,
            };
        }
        // the place of the tip, as figures call it
        if matches!(stem, "x" | "y") && index.is_empty() && letter.frame.is_empty() {
            return Some(format!("{} . p{stem}", self.pose()));
        }
        // u_{11} of a matrix U
        let capital = stem.to_uppercase();
        let matrix =
            self.given.iter().rev().find(|g| g.2 && g.0.stem == capital && capital != stem && g.0.index.is_empty());
        // v_x, omega_z: the velocity of the tool
        if let ("v" | "omega", "x" | "y" | "z", None) = (stem, index, matrix) {
            let part = if stem == "v" { "Jv" } else { "Jw" };
            return Some(format!("( {part} * {} ) . {index}", self.velocities()));
        }
        let matrix = matrix?;
        let field = match index {
            "" => "p".to_string(),
            "x" | "y" | "z" => format!("p{index}"),
            _ => self::field("r", index)?,
        };
        Some(format!("{} . {field}", matrix.1))
    }

    /// A number of the table that stands there with a minus sign, and that this document calls by its size: `a_1 = 30` for -30.
    pub(super) fn say_size(&mut self, letter: &Letter, value: &str) -> bool {
        let name = format!("{}{}", letter.stem, letter.index);
        let Some(p) = self.chain.parameters.iter().find(|p| p.name == name && !p.declared) else { return false };
        let (Handle::Length(s), Role::Constant(Nominal::Length(x))) = (p.handle, &p.role) else { return false };
        let ahead = usize::from(self.chain.convention == Convention::Modified);
        let number: usize = letter.index.parse().unwrap_or(usize::MAX);
        let cell = match letter.stem.as_str() {
            "a" => number
                .checked_add(ahead)
                .and_then(|n| n.checked_sub(1))
                .and_then(|k| self.chain.links.get(k))
                .map(|l| &l.a),
            "d" => number.checked_sub(1).and_then(|k| self.chain.links.get(k)).map(|l| &l.d),
            _ => None,
        };
        let turned = cell == Some(&-&Poly::symbol(s));
        let same = Rational::from_decimal(value).as_ref() == Some(x);
        if turned && same {
            self.bind(letter.clone(), format!("( - {name} )"));
        }
        turned && same
    }

    /// From here on r_{11} and p_x are entries of this transform, where they have no other name.
    pub(super) fn say_pose(&mut self, transform: String) {
        self.bound.retain(|b| !(matches!(b.0.stem.as_str(), "r" | "p") && b.0.frame.is_empty()));
        self.given_pose = Some(transform);
    }

    /// A frame that the document defines, as seen from frame 0.
    pub(super) fn frame(&self, label: &str) -> Option<&str> {
        self.frames.iter().find(|f| f.0 == label).map(|f| f.1.as_str())
    }

    /// Takes a frame that the document defines.
    pub(super) fn say_frame(&mut self, label: String, seen: String) {
        self.frames.push((label, seen));
    }

    /// Is this the name of an angle?
    pub(super) fn is_angle(&self, letter: &Letter) -> bool {
        let own = |p: &Parameter| matches!(p.handle, Handle::Angle(_));
        let named = self.declared().find(|p| p.name == format!("{}{}", letter.stem, letter.index));
        match named {
            Some(p) => own(p),
            None => {
                let greek = greek::letter(&letter.stem).is_some() && letter.stem != "pi";
                greek || matches!(letter.stem.as_str(), "q" | "t") && !letter.index.is_empty()
            }
        }
    }

    /// The variable of a joint, if this is what the letter stands for, and whether it turns.
    pub(super) fn variable(&self, meaning: &str) -> Option<bool> {
        let sliding =
            |k: &usize| self.chain.joints.get(*k).is_some_and(|j| matches!(j.coordinate, Coordinate::Length(_)));
        if let Some(k) = meaning.strip_prefix('q').and_then(|n| n.parse::<usize>().ok()?.checked_sub(1)) {
            return self.chain.joints.get(k).map(|_| !sliding(&k));
        }
        if let Some(row) = meaning.strip_prefix('d').and_then(|n| n.parse::<usize>().ok()) {
            let joint = self.chain.joints.iter().find(|j| j.row + 1 == row)?;
            let Coordinate::Length(s) = joint.coordinate else { return None };
            return (self.chain.links.get(joint.row)?.d == Poly::symbol(s)).then_some(false);
        }
        if let Some(row) = meaning.strip_prefix("theta").and_then(|n| n.parse::<usize>().ok()) {
            return self.turning(row).map(|_| true);
        }
        None
    }
}
