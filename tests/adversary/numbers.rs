//! Plain numbers for the lines of a derivation: a reader of formulas, a table and products of matrices that share nothing with the checker.

use std::collections::BTreeMap;

/// The PUMA of the examples, by Craig: alpha, a, d of each row; theta is q.
const PUMA: [(f64, f64, f64); 6] = [
    (0.0, 0.0, 0.0),
    (-90.0, 0.0, 0.0),
    (0.0, 0.4318, 0.15005),
    (-90.0, 0.0203, 0.4318),
    (90.0, 0.0, 0.0),
    (-90.0, 0.0, 0.0),
];

/// A value at a pose.
#[derive(Clone, Debug)]
enum Value {
    Number(f64),
    Angle(f64),
    Matrix(Vec<Vec<f64>>),
}

use Value::{Angle, Matrix, Number};

fn product(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
    a.iter().map(|row| (0..b[0].len()).map(|j| row.iter().zip(b).map(|(x, r)| x * r[j]).sum()).collect()).collect()
}

fn link(i: usize, q: f64) -> Vec<Vec<f64>> {
    let (alpha, a, d) = PUMA[i];
    let (ca, sa) = (alpha.to_radians().cos(), alpha.to_radians().sin());
    let (c, s) = (q.cos(), q.sin());
    vec![
        vec![c, -s, 0.0, a],
        vec![s * ca, c * ca, -sa, -sa * d],
        vec![s * sa, c * sa, ca, ca * d],
        vec![0.0, 0.0, 0.0, 1.0],
    ]
}

fn frame(i: usize, j: usize, q: &[f64]) -> Vec<Vec<f64>> {
    if i > j {
        return rigid_inverse(&frame(j, i, q));
    }
    let one = (0..4).map(|i| (0..4).map(|j| f64::from(u8::from(i == j))).collect()).collect::<Vec<Vec<f64>>>();
    (i..j).fold(one, |t, k| product(&t, &link(k, q[k])))
}

fn rigid_inverse(t: &[Vec<f64>]) -> Vec<Vec<f64>> {
    (0..4)
        .map(|i| {
            (0..4)
                .map(|j| match (i, j) {
                    (3, _) => f64::from(u8::from(j == 3)),
                    (_, 3) => -(0..3).map(|k| t[k][i] * t[k][3]).sum::<f64>(),
                    _ => t[j][i],
                })
                .collect()
        })
        .collect()
}

/// Reads and evaluates words in one go. `None`: something that this little program does not know.
struct Reader<'a> {
    words: &'a [String],
    at: usize,
    q: &'a [f64],
    names: &'a BTreeMap<String, Value>,
}

impl Reader<'_> {
    fn peek(&self) -> &str {
        self.words.get(self.at).map_or("", String::as_str)
    }

    fn take(&mut self, word: &str) -> bool {
        let hit = self.peek() == word;
        self.at += usize::from(hit);
        hit
    }

    fn sum(&mut self) -> Option<Value> {
        let mut sum = self.product()?;
        loop {
            let sign = match self.peek() {
                "+" => 1.0,
                "-" => -1.0,
                _ => return Some(sum),
            };
            self.at += 1;
            sum = match (sum, self.product()?) {
                (Number(x), Number(y)) => Number(x + sign * y),
                (Angle(x), Angle(y)) => Angle(x + sign * y),
                (Matrix(x), Matrix(y)) if x.len() == y.len() && x[0].len() == y[0].len() => Matrix(
                    x.iter().zip(&y).map(|(r, s)| r.iter().zip(s).map(|(a, b)| a + sign * b).collect()).collect(),
                ),
                _ => return None,
            };
        }
    }

    fn product(&mut self) -> Option<Value> {
        let mut all = self.signed()?;
        loop {
            let over = match self.peek() {
                "*" => false,
                "/" => true,
                _ => return Some(all),
            };
            self.at += 1;
            all = match (all, self.signed()?) {
                (Number(x), Number(y)) => Number(if over { x / y } else { x * y }),
                (Number(k), Matrix(m)) | (Matrix(m), Number(k)) if !over => {
                    Matrix(m.into_iter().map(|r| r.into_iter().map(|x| k * x).collect()).collect())
                }
                (Matrix(a), Matrix(b)) if !over && a[0].len() == b.len() => Matrix(product(&a, &b)),
                _ => return None,
            };
        }
    }

    fn signed(&mut self) -> Option<Value> {
        if self.take("-") {
            return Some(match self.signed()? {
                Number(x) => Number(-x),
                Angle(x) => Angle(-x),
                Matrix(m) => Matrix(m.into_iter().map(|r| r.into_iter().map(|x| -x).collect()).collect()),
            });
        }
        let mut v = self.primary()?;
        while self.take(".") {
            let field = self.peek().to_string();
            self.at += 1;
            v = entry(v, &field)?;
        }
        if self.take("^") {
            let minus = self.take("-");
            let n: i32 = self.peek().parse().ok()?;
            self.at += 1;
            v = match v {
                Number(x) => Number(x.powi(if minus { -n } else { n })),
                Matrix(m) if minus && n == 1 && m.len() == 4 => Matrix(rigid_inverse(&m)),
                Matrix(m) if minus && n == 1 && m.len() == 3 => {
                    Matrix((0..3).map(|i| (0..3).map(|j| m[j][i]).collect()).collect())
                }
                _ => return None,
            };
        }
        while self.take(".") {
            let field = self.peek().to_string();
            self.at += 1;
            v = entry(v, &field)?;
        }
        Some(v)
    }

    fn arguments(&mut self) -> Option<Vec<Value>> {
        let mut out = vec![self.sum()?];
        while self.take(",") {
            out.push(self.sum()?);
        }
        self.take(")").then_some(out)
    }

    fn primary(&mut self) -> Option<Value> {
        let word = self.peek().to_string();
        self.at += 1;
        let called = self.peek() == "(";
        if word == "(" {
            let v = self.sum()?;
            return self.take(")").then_some(v);
        }
        if word == "[" {
            let mut rows = vec![vec![]];
            loop {
                let Number(x) = self.sum()? else { return None };
                rows.last_mut()?.push(x);
                if self.take(";") {
                    rows.push(vec![]);
                } else if self.take("]") {
                    return rows.iter().all(|r| r.len() == rows[0].len()).then_some(Matrix(rows));
                } else if !self.take(",") {
                    return None;
                }
            }
        }
        if word.starts_with(|c: char| c.is_ascii_digit()) {
            return match word.strip_suffix("deg") {
                Some(x) => Some(Angle(x.parse::<f64>().ok()?.to_radians())),
                None => Some(Number(word.parse().ok()?)),
            };
        }
        if called {
            self.at += 1;
            let v = self.arguments()?;
            return Some(match (word.as_str(), v.as_slice()) {
                ("T", [Number(i), Number(j)]) => {
                    let (i, j) = (*i as usize, *j as usize);
                    if i > 6 || j > 6 {
                        return None;
                    }
                    Matrix(frame(i, j, self.q))
                }
                ("cos", [Angle(x)]) => Number(x.cos()),
                ("sin", [Angle(x)]) => Number(x.sin()),
                ("atan2", [Number(y), Number(x)]) => Angle(y.atan2(*x)),
                ("acos", [Number(x)]) => Angle(x.acos()),
                ("sqrt", [Number(x)]) => Number(x.sqrt()),
                ("norm2", [Matrix(m)]) => Number(m.iter().flatten().map(|x| x * x).sum()),
                ("inv", [Matrix(m)]) if m.len() == 4 => Matrix(rigid_inverse(m)),
                _ => return None,
            });
        }
        if let Some(v) = self.names.get(&word) {
            return Some(v.clone());
        }
        let (stem, digits) = word.split_at(word.find(|c: char| c.is_ascii_digit())?);
        let joint = |c: char| self.q.get((c.to_digit(10)? as usize).checked_sub(1)?).copied();
        let n: usize = digits.parse().ok()?;
        match stem {
            "q" => Some(Angle(*self.q.get(n.checked_sub(1)?)?)),
            "c" | "s" => {
                let x: f64 = digits.chars().map(joint).collect::<Option<Vec<f64>>>()?.iter().sum();
                Some(Number(if stem == "c" { x.cos() } else { x.sin() }))
            }
            "a" => Some(Number(PUMA.get(n)?.1)),
            "d" => Some(Number(PUMA.get(n.checked_sub(1)?)?.2)),
            _ => None,
        }
    }
}

fn entry(v: Value, field: &str) -> Option<Value> {
    let Matrix(m) = v else { return None };
    let axis = |c: &str| ["x", "y", "z"].iter().position(|a| *a == c);
    let column = |j: usize| Matrix((0..3).map(|i| vec![m[i][j]]).collect());
    if let (Some(i), 4) = (field.strip_prefix('p').and_then(axis), m.len()) {
        return Some(Number(m[i][3]));
    }
    match (field, m.len(), m[0].len()) {
        ("t", ..) => Some(Matrix((0..m[0].len()).map(|j| m.iter().map(|r| r[j]).collect()).collect())),
        ("p", 4, 4) => Some(column(3)),
        ("R", 3 | 4, 3 | 4) => Some(Matrix((0..3).map(|i| m[i][..3].to_vec()).collect())),
        ("x" | "y" | "z", 3 | 4, 3 | 4) => Some(column(axis(field)?)),
        ("x" | "y" | "z", 3, 1) => Some(Number(m[axis(field)?][0])),
        (r, 3 | 4, 3 | 4) => {
            let digits: Vec<usize> =
                r.strip_prefix('r')?.chars().map(|c| c.to_digit(10).map(|d| d as usize)).collect::<Option<_>>()?;
            let [i @ 1..=3, j @ 1..=3] = digits.as_slice() else { return None };
            Some(Number(m[i - 1][j - 1]))
        }
        _ => None,
    }
}

fn evaluate(words: &[String], q: &[f64], names: &BTreeMap<String, Value>) -> Option<Value> {
    let mut r = Reader { words, at: 0, q, names };
    let v = r.sum()?;
    (r.at == words.len()).then_some(v)
}

/// Same, different, or too near to tell; `None` where one has no value.
fn compare(a: &Value, b: &Value) -> Option<bool> {
    let numbers = |x: f64, y: f64| {
        let apart = (x - y).abs() / x.abs().max(y.abs()).max(1.0);
        if !apart.is_finite() || (1e-9..1e-5).contains(&apart) { None } else { Some(apart < 1e-9) }
    };
    match (a, b) {
        (Number(x), Number(y)) => numbers(*x, *y),
        (Angle(x), Angle(y)) => {
            let apart = (x - y).rem_euclid(std::f64::consts::TAU);
            numbers(apart.min(std::f64::consts::TAU - apart), 0.0)
        }
        (Matrix(m), Matrix(n)) if m.len() == n.len() && m[0].len() == n[0].len() => {
            let all: Vec<Option<bool>> =
                m.iter().flatten().zip(n.iter().flatten()).map(|(x, y)| numbers(*x, *y)).collect();
            if all.contains(&Some(false)) { Some(false) } else { all.iter().all(Option::is_some).then_some(true) }
        }
        _ => None,
    }
}

/// At how many poses a line holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Truth {
    Always,
    Sometimes,
    Never,
}

pub(super) fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 33) as f64 / (1u64 << 31) as f64
}

/// What plain numbers say of `left = right = ...` after definitions. `None`: nothing.
pub(super) fn truth(lets: &[(String, Vec<String>)], line: &[String]) -> Option<Truth> {
    let sides: Vec<&[String]> = line.split(|w| w == "=").collect();
    let (mut yes, mut no) = (0, 0);
    let mut state = 4711;
    for _ in 0..160 {
        let q: Vec<f64> = (0..6).map(|_| (2.0 * random(&mut state) - 1.0) * std::f64::consts::PI).collect();
        let mut names = BTreeMap::new();
        for (name, words) in lets {
            let v = evaluate(words, &q, &names)?;
            names.insert(name.clone(), v);
        }
        let values: Vec<Value> = sides.iter().map(|s| evaluate(s, &q, &names)).collect::<Option<_>>()?;
        let same: Option<Vec<bool>> = values.windows(2).map(|w| compare(&w[0], &w[1])).collect();
        match same {
            Some(same) if same.iter().all(|s| *s) => yes += 1,
            Some(_) => no += 1,
            None => {}
        }
        // one hit by chance is none
        if yes > 1 && no > 1 {
            return Some(Truth::Sometimes);
        }
    }
    match (yes, no) {
        (20.., 0) => Some(Truth::Always),
        (0, 20..) => Some(Truth::Never),
        _ => None,
    }
}
