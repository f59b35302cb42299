//! Loops over branches as text: which names can be used where, and what has to be kept in arrays from one loop to the next.

use std::collections::{BTreeMap, BTreeSet};

/// The layout of an array `all_name`: the value of a branch is at `branch / before % roots * p + branch % p`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Layout {
    pub(super) before: usize,
    pub(super) roots: usize,
    pub(super) p: usize,
}

impl Layout {
    /// One value per branch, the same for branches that differ by `p`.
    pub(super) fn plain(p: usize) -> Self {
        Self { before: p, roots: 1, p }
    }

    pub(super) fn index(self) -> String {
        match self {
            Self { roots: 1, p, .. } => format!("branch % {p}"),
            Self { before, roots, p: 1 } => format!("branch / {before} % {roots}"),
            Self { before, roots, p } => format!("branch / {before} % {roots} * {p} + branch % {p}"),
        }
    }
}

/// What the confirmation is about.
pub(super) const KINDS: [&str; 3] = ["margin", "valid", "error"];

/// Several margins, validities or errors as one.
pub(super) fn joined(kind: usize, names: &[String]) -> String {
    match (kind, names) {
        (2, []) => "0.0".into(),
        (_, []) => "1.0".into(),
        (0, [first, rest @ ..]) => {
            rest.iter().fold(first.clone(), |t, m| format!("::dh_robot::runtime::batched::lesser({t}, {m})"))
        }
        (1, _) => names.join(" * "),
        _ => names.join(" + "),
    }
}

/// The loops of a function, one after the other; code for a single branch is outside of loops.
#[derive(Default)]
pub(super) struct Loops {
    /// Number and width of the loop that is being written, and whether it is the last one.
    pub(super) number: usize,
    pub(super) width: usize,
    pub(super) last: bool,
    /// Names that can be used as they are in this loop, and those that can be used anywhere.
    here: BTreeSet<String>,
    anywhere: BTreeSet<String>,
    pub(super) arrays: BTreeMap<String, Layout>,
    /// What the confirmation needs: margins, which branches are real, errors; of this loop, and as the end will find them.
    pending: [Vec<String>; 3],
    pub(super) judged: [Vec<String>; 3],
    /// The code before the loop, in it, and after it.
    pub(super) before: String,
    pub(super) inner: String,
    pub(super) after: String,
    /// What is finished.
    pub(super) out: String,
}

impl Loops {
    /// Goes on with a loop, or begins the next one.
    pub(super) fn enter(&mut self, number: usize, width: usize, last: bool) {
        if number != self.number {
            self.close();
        }
        (self.number, self.width, self.last) = (number, width, last);
    }

    /// Whether the name can be used as it is.
    pub(super) fn knows(&self, name: &str) -> bool {
        self.here.contains(name) || self.anywhere.contains(name)
    }

    /// Makes a name usable in the loop; false if it has to be written there first.
    pub(super) fn load(&mut self, name: &str) -> bool {
        if self.knows(name) {
            return true;
        }
        let Some(layout) = self.arrays.get(name).copied() else { return false };
        if layout.roots > 1 || layout.p < self.width {
            // Spread beforehand: the loop then reads whole vectors.
            let n = self.width;
            self.before.push_str(&format!(
                "let all_{name}: [f64; {n}] = ::core::array::from_fn(|branch| all_{name}[{}]);\n",
                layout.index()
            ));
            self.arrays.insert(name.to_string(), Layout::plain(n));
        }
        let at = if self.width == 1 { "0" } else { "branch" };
        self.inner.push_str(&format!("let {name} = all_{name}[{at}];\n"));
        self.here.insert(name.to_string());
        true
    }

    /// Keeps a value for later loops.
    pub(super) fn store(&mut self, name: &str, text: &str) {
        let n = self.width;
        self.before.push_str(&format!("let mut all_{name} = [0.0; {n}];\n"));
        self.inner.push_str(&format!("all_{name}[branch] = {text};\n"));
        self.arrays.insert(name.to_string(), Layout::plain(n));
        self.here.insert(name.to_string());
    }

    /// A name that has been written in this loop.
    pub(super) fn define(&mut self, name: &str) {
        let names = if self.width == 1 { &mut self.anywhere } else { &mut self.here };
        names.insert(name.to_string());
    }

    /// A value that the confirmation needs, of one of the three kinds.
    pub(super) fn judge(&mut self, kind: usize, name: String) {
        self.define(&name);
        self.pending[kind].push(name);
    }

    /// Puts together what this loop says to the confirmation.
    pub(super) fn flush(&mut self) {
        let pending = std::mem::take(&mut self.pending);
        for (kind, names) in pending.into_iter().enumerate().filter(|(_, names)| !names.is_empty()) {
            if self.width == 1 || self.last {
                self.judged[kind].extend(names);
                continue;
            }
            let name = format!("{}_{}", KINDS[kind], self.number);
            self.store(&name, &joined(kind, &names));
            self.judged[kind].push(name);
        }
    }

    /// Ends the loop.
    pub(super) fn close(&mut self) {
        self.flush();
        let (before, inner, after) =
            (std::mem::take(&mut self.before), std::mem::take(&mut self.inner), std::mem::take(&mut self.after));
        self.out.push_str(&before);
        if self.width == 1 {
            self.out.push_str(&inner);
        } else {
            self.out.push_str(&format!("for branch in 0..{} {{\n{inner}}}\n", self.width));
        }
        self.out.push_str(&after);
        self.here.clear();
    }
}
