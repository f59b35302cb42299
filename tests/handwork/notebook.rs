//! What a reader with a pocket calculator knows, and what a formula comes out as then.

use super::formula::Formula;
use std::collections::BTreeMap;

pub(crate) type Matrix = [[f64; 4]; 4];

/// What a formula comes out as.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    Scalar(f64),
    Matrix(Matrix),
}

/// What is known so far.
#[derive(Clone, Debug, Default)]
pub(crate) struct Notebook {
    pub(crate) scalars: BTreeMap<String, f64>,
    pub(crate) matrices: BTreeMap<String, Matrix>,
    /// Formulas that the note gives for names.
    pub(crate) formulas: BTreeMap<String, Formula>,
    /// What joint angles are called: `theta` or `q`.
    pub(crate) stems: Vec<String>,
}

pub(crate) const IDENTITY: Matrix = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];

pub(crate) fn times(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

pub(crate) fn inverse(a: &Matrix) -> Matrix {
    let mut t = IDENTITY;
    for i in 0..3 {
        for j in 0..3 {
            t[i][j] = a[j][i];
        }
        t[i][3] = -(0..3).map(|k| a[k][i] * a[k][3]).sum::<f64>();
    }
    t
}

impl Notebook {
    /// The value of a formula, where all of it is known; `sign` is taken for ±.
    pub(crate) fn value(&self, f: &Formula, sign: f64) -> Option<Value> {
        self.within(f, sign, 0)
    }

    pub(crate) fn scalar(&self, f: &Formula, sign: f64) -> Option<f64> {
        match self.value(f, sign)? {
            Value::Scalar(x) => Some(x),
            Value::Matrix(_) => None,
        }
    }

    pub(crate) fn matrix(&self, f: &Formula) -> Option<Matrix> {
        match self.value(f, 1.0)? {
            Value::Matrix(m) => Some(m),
            Value::Scalar(_) => None,
        }
    }

    fn within(&self, f: &Formula, sign: f64, depth: usize) -> Option<Value> {
        if depth > 40 {
            return None;
        }
        let scalar = |f: &Formula| match self.within(f, sign, depth + 1)? {
            Value::Scalar(x) => Some(x),
            Value::Matrix(_) => None,
        };
        Some(match f {
            Formula::Number(x) => Value::Scalar(*x),
            Formula::Name(name) => return self.name(name, depth + 1),
            Formula::Sum(list) => {
                if let [('+', only)] = list.as_slice() {
                    return self.within(only, sign, depth + 1);
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
                let values: Vec<Value> = list.iter().map(|f| self.within(f, sign, depth + 1)).collect::<Option<_>>()?;
                let (mut factor, mut product) = (1.0, None);
                for v in values {
                    match v {
                        Value::Scalar(x) => factor *= x,
                        Value::Matrix(m) => product = Some(product.map_or(m, |p| times(&p, &m))),
                    }
                }
                product.map_or(Value::Scalar(factor), Value::Matrix)
            }
            Formula::Quotient(a, b) => Value::Scalar(scalar(a)? / scalar(b)?),
            Formula::Root(a) => Value::Scalar(scalar(a)?.max(0.0).sqrt()),
            Formula::Power(a, n) => match self.within(a, sign, depth + 1)? {
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
            Formula::Matrix(rows) => {
                let mut m = IDENTITY;
                for (i, row) in rows.iter().enumerate().take(4) {
                    for (j, f) in row.iter().enumerate().take(4) {
                        m[i][j] = scalar(f)?;
                    }
                }
                Value::Matrix(m)
            }
        })
    }

    fn name(&self, name: &str, depth: usize) -> Option<Value> {
        if let Some(x) = self.scalars.get(name) {
            return Some(Value::Scalar(*x));
        }
        if let Some(m) = self.matrices.get(name) {
            return Some(Value::Matrix(*m));
        }
        if name.starts_with("c_") || name.starts_with("s_") {
            let own = self.formulas.get(name).and_then(|f| self.within(f, 1.0, depth));
            if own.is_some() {
                return own;
            }
        }
        if let Some((letter, index)) = name.split_once('_').filter(|(l, _)| matches!(*l, "c" | "s")) {
            let sums = ["theta", "q"].map(String::from);
            let stems = if index.len() > 1 { &sums[..] } else { &self.stems };
            let known = stems.iter().find_map(|stem| self.scalars.get(&format!("{stem}_{index}")));
            if let Some(x) = known {
                return Some(Value::Scalar(if letter == "c" { x.cos() } else { x.sin() }));
            }
        }
        if let Some(f) = self.formulas.get(name) {
            return self.within(f, 1.0, depth);
        }
        let ends = name.strip_prefix("T[")?.strip_suffix(']')?;
        let (from, to) = ends.split_once(',')?;
        self.way(from, to, depth).map(Value::Matrix)
    }

    /// The transform between two frames as a product of known ones.
    fn way(&self, from: &str, to: &str, depth: usize) -> Option<Matrix> {
        let names = self.matrices.keys().chain(self.formulas.keys()).filter(|n| n.starts_with("T["));
        let mut edges: Vec<(String, String, Matrix)> = Vec::new();
        for name in names {
            let (a, b) = name[2..name.len() - 1].split_once(',')?;
            let m = match self.matrices.get(name) {
                Some(m) => *m,
                None => match self.within(&self.formulas[name], 1.0, depth) {
                    Some(Value::Matrix(m)) => m,
                    _ => continue,
                },
            };
            edges.push((a.into(), b.into(), m));
            edges.push((b.into(), a.into(), inverse(&m)));
        }
        let mut reached: Vec<(String, Matrix)> = vec![(from.to_string(), IDENTITY)];
        let mut next = 0;
        while let Some((frame, m)) = reached.get(next).cloned() {
            if frame == to {
                return Some(m);
            }
            for (a, b, t) in &edges {
                if *a == frame && reached.iter().all(|r| r.0 != *b) {
                    reached.push((b.clone(), times(&m, t)));
                }
            }
            next += 1;
        }
        None
    }
}

fn elementary(motion: &str, x: f64) -> Option<Matrix> {
    let axis = "xyz".find(motion.chars().last()?)?;
    let mut t = IDENTITY;
    if motion.starts_with('D') {
        t[axis][3] = x;
    } else {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        (t[j][j], t[k][k], t[j][k], t[k][j]) = (x.cos(), x.cos(), -x.sin(), x.sin());
    }
    Some(t)
}
