//! Reads and evaluates the words of a formula in one go.

use super::value::Value::{Angle, Matrix, Number};
use super::value::{Value, determinant_and_inverse, entry, identity, product, rows};
use super::{Pose, evaluate};

/// `None` of its functions: something that this little program does not know.
pub(super) struct Reader<'a> {
    pub(super) words: &'a [String],
    pub(super) at: usize,
    pub(super) pose: &'a Pose,
    /// Are the lower signs of ± read?
    pub(super) below: bool,
}

/// Translation along or rotation about a coordinate axis.
fn elementary(turns: bool, axis: usize, x: f64) -> Vec<Vec<f64>> {
    let mut m = identity(4);
    if turns {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        (m[j][j], m[j][k], m[k][j], m[k][k]) = (x.cos(), -x.sin(), x.sin(), x.cos());
    } else {
        m[axis][3] = x;
    }
    m
}

fn scaled(v: Value, k: f64) -> Value {
    match v {
        Number(x) => Number(k * x),
        Angle(x) => Angle(k * x),
        Matrix(m) => Matrix(m.into_iter().map(|r| r.into_iter().map(|x| k * x).collect()).collect()),
    }
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

    /// A sign here, as a factor.
    fn sign(&self) -> Option<f64> {
        let minus = match self.peek() {
            "+" => false,
            "-" => true,
            "±" => self.below,
            "∓" => !self.below,
            _ => return None,
        };
        Some(if minus { -1.0 } else { 1.0 })
    }

    pub(super) fn sum(&mut self) -> Option<Value> {
        let mut sum = self.product()?;
        while let Some(sign) = self.sign() {
            self.at += 1;
            sum = match (sum, self.product()?) {
                (Number(x), Number(y)) => Number(x + sign * y),
                (Angle(x), Angle(y)) => Angle(x + sign * y),
                (Angle(x), Number(0.0)) => Angle(x),
                (Number(0.0), Angle(y)) => Angle(sign * y),
                (Matrix(x), Matrix(y)) if x.len() == y.len() && x[0].len() == y[0].len() => Matrix(
                    x.iter().zip(&y).map(|(r, s)| r.iter().zip(s).map(|(a, b)| a + sign * b).collect()).collect(),
                ),
                _ => return None,
            };
        }
        Some(sum)
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
                (v, Number(k)) => scaled(v, if over { 1.0 / k } else { k }),
                (Number(k), v) if !over => scaled(v, k),
                (Matrix(a), Matrix(b)) if !over && a[0].len() == b.len() => Matrix(product(&a, &b)),
                (Matrix(a), Matrix(mut b)) if !over && a[0].len() == 4 && b.len() == 3 && b[0].len() == 1 => {
                    b.push(vec![1.0]);
                    Matrix(product(&a, &b))
                }
                _ => return None,
            };
        }
    }

    fn signed(&mut self) -> Option<Value> {
        if let Some(sign) = self.sign() {
            self.at += 1;
            return Some(scaled(self.signed()?, sign));
        }
        let v = self.primary()?;
        let mut v = self.fields(v)?;
        if self.take("^") {
            let minus = self.take("-");
            let n: i32 = self.peek().parse().ok()?;
            self.at += 1;
            v = match v {
                Number(x) => Number(x.powi(if minus { -n } else { n })),
                Matrix(m) if minus && n == 1 => Matrix(determinant_and_inverse(&m)?.1),
                _ => return None,
            };
        }
        self.fields(v)
    }

    fn fields(&mut self, mut v: Value) -> Option<Value> {
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

    fn matrix(&mut self) -> Option<Value> {
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

    fn primary(&mut self) -> Option<Value> {
        let word = self.peek().to_string();
        self.at += 1;
        if word == "(" {
            let v = self.sum()?;
            return self.take(")").then_some(v);
        }
        if word == "[" {
            return self.matrix();
        }
        if word.starts_with(|c: char| c.is_ascii_digit()) {
            return match word.strip_suffix("deg") {
                Some(x) => Some(Angle(x.parse::<f64>().ok()?.to_radians())),
                None => Some(Number(word.parse().ok()?)),
            };
        }
        if self.peek() == "(" {
            self.at += 1;
            if matches!(word.as_str(), "c" | "s") {
                return self.of_joints(word == "s");
            }
            let v = self.arguments()?;
            return self.call(&word, &v);
        }
        self.name(&word)
    }

    /// `c(2-3)`.
    fn of_joints(&mut self, sine: bool) -> Option<Value> {
        let (mut sum, mut sign) = (0.0, 1.0);
        loop {
            if let Some(s) = self.sign() {
                self.at += 1;
                sign = s;
            }
            let n: usize = self.peek().parse().ok()?;
            self.at += 1;
            sum += sign * self.angle(n)?;
            if self.take(")") {
                return Some(Number(if sine { sum.sin() } else { sum.cos() }));
            }
        }
    }

    fn angle(&self, n: usize) -> Option<f64> {
        let k = n.checked_sub(1)?;
        (*self.pose.turns.get(k)? == Some(true)).then(|| self.pose.q[k])
    }

    fn frame(&self, i: f64, j: f64) -> Option<Value> {
        let (i, j) = (self.pose.frames.get(i as usize)?, self.pose.frames.get(j as usize)?);
        Some(Matrix(product(&determinant_and_inverse(i)?.1, j)))
    }

    fn jacobian(&self) -> Vec<Vec<f64>> {
        let columns = self.pose.arm.jacobian_from_slopes(&self.pose.q);
        (0..6).map(|i| columns.iter().map(|c| c[i]).collect()).collect()
    }

    fn call(&self, name: &str, v: &[Value]) -> Option<Value> {
        let axis = |name: &str| ["x", "y", "z"].iter().position(|a| name[1..] == **a);
        Some(match (name, v) {
            ("T", [Number(i), Number(j)]) => self.frame(*i, *j)?,
            ("A", [Number(i)]) => self.frame(*i - 1.0, *i)?,
            ("J", [Number(k)]) => {
                let k = (*k as usize).checked_sub(1)?;
                Matrix(self.jacobian().iter().map(|r| r.get(k).map(|x| vec![*x])).collect::<Option<_>>()?)
            }
            ("J", [Number(i), Number(k)]) => {
                let (i, k) = ((*i as usize).checked_sub(1)?, (*k as usize).checked_sub(1)?);
                Number(*self.jacobian().get(i)?.get(k)?)
            }
            ("cos", [Angle(x)]) => Number(x.cos()),
            ("sin", [Angle(x)]) => Number(x.sin()),
            ("tan", [Angle(x)]) => Number(x.tan()),
            ("cos" | "tan" | "sin", [Number(0.0)]) => Number(if name == "cos" { 1.0 } else { 0.0 }),
            ("atan2", [Number(y), Number(x)]) => Angle(y.atan2(*x)),
            ("atan", [Number(x)]) => Angle(x.atan()),
            ("acos", [Number(x)]) => Angle(x.acos()),
            ("asin", [Number(x)]) => Angle(x.asin()),
            ("sqrt", [Number(x)]) => Number(x.sqrt()),
            ("det", [Matrix(m)]) => Number(determinant_and_inverse(m)?.0),
            ("inv", [Matrix(m)]) => Matrix(determinant_and_inverse(m)?.1),
            ("norm2", [Matrix(m)]) => Number(m.iter().flatten().map(|x| x * x).sum()),
            ("dot", [Matrix(a), Matrix(b)]) if a.len() == b.len() && a[0].len() == 1 && b[0].len() == 1 => {
                Number(a.iter().zip(b).map(|(x, y)| x[0] * y[0]).sum())
            }
            ("Rx" | "Ry" | "Rz", [Angle(x)]) => Matrix(elementary(true, axis(name)?, *x)),
            ("Tx" | "Ty" | "Tz", [Number(x)]) => Matrix(elementary(false, axis(name)?, *x)),
            _ => return None,
        })
    }

    fn name(&self, word: &str) -> Option<Value> {
        if let Some(v) = self.pose.names.get(word) {
            return Some(v.clone());
        }
        match word {
            "pi" => return Some(Angle(std::f64::consts::PI)),
            "J" => return Some(Matrix(self.jacobian())),
            "base" | "tool" => return Some(Matrix(rows(&self.pose.arm.ends()[usize::from(word == "tool")]))),
            "I3" | "I4" => return Some(Matrix(identity(if word == "I3" { 3 } else { 4 }))),
            _ => {}
        }
        let (stem, digits) = word.split_at(word.find(|c: char| c.is_ascii_digit())?);
        if matches!(stem, "c" | "s") {
            let one = |c: char| self.angle(c.to_digit(10)? as usize);
            let x: f64 = digits.chars().map(one).collect::<Option<Vec<f64>>>()?.iter().sum();
            return Some(Number(if stem == "c" { x.cos() } else { x.sin() }));
        }
        let n: usize = digits.parse().ok()?;
        let moving = |k: usize, turns: bool| {
            let row = self.pose.arm.rows.get(k)?;
            let drive = row.moves.as_ref().filter(|m| m.0 == turns);
            let moved: f64 = drive.map_or(0.0, |m| m.1.iter().map(|(j, k)| k * self.pose.q[*j]).sum());
            Some(moved + if turns { row.theta } else { row.d })
        };
        let of_link = (n + usize::from(self.pose.modified)).checked_sub(1);
        match stem {
            "q" => match self.pose.turns.get(n.checked_sub(1)?)? {
                Some(true) => Some(Angle(self.pose.q[n - 1])),
                Some(false) => Some(Number(self.pose.q[n - 1])),
                None => None,
            },
            "theta" => Some(Angle(moving(n.checked_sub(1)?, true)?)),
            "d" => Some(Number(moving(n.checked_sub(1)?, false)?)),
            "a" => Some(Number(self.pose.arm.rows.get(of_link?)?.a)),
            "alpha" => Some(Angle(self.pose.arm.rows.get(of_link?)?.alpha)),
            // ca2: of a twist
            "ca" | "sa" => match evaluate(&[format!("alpha{n}")], self.pose, self.below)? {
                Angle(x) => Some(Number(if stem == "ca" { x.cos() } else { x.sin() })),
                _ => None,
            },
            _ => None,
        }
    }
}
