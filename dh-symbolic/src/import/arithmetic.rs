//! Arithmetic of constants as scripts and data sheets write it: `-pi/2`, `160*deg`, `a2 + 0.1`, `deg2rad(90)`.

use std::f64::consts::PI;

/// The value of an expression, with the values of names; `None` where it is none.
pub(super) fn value(text: &str, names: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
    let mut reader = Reader { rest: text.trim(), names, depth: 0 };
    let x = reader.sum()?;
    (reader.rest.is_empty() && x.is_finite()).then_some(x)
}

struct Reader<'a> {
    rest: &'a str,
    names: &'a dyn Fn(&str) -> Option<f64>,
    depth: usize,
}

impl Reader<'_> {
    fn eat(&mut self, c: char) -> bool {
        match self.rest.strip_prefix(c) {
            Some(rest) => {
                self.rest = rest.trim_start();
                true
            }
            None => false,
        }
    }

    fn sum(&mut self) -> Option<f64> {
        let mut x = self.product()?;
        loop {
            if self.eat('+') {
                x += self.product()?;
            } else if self.eat('-') {
                x -= self.product()?;
            } else {
                return Some(x);
            }
        }
    }

    fn product(&mut self) -> Option<f64> {
        let mut x = self.signed()?;
        loop {
            if self.eat('*') {
                x *= self.signed()?;
            } else if self.eat('/') {
                x /= self.signed()?;
            } else {
                return Some(x);
            }
        }
    }

    fn signed(&mut self) -> Option<f64> {
        let mut sign = 1.0;
        loop {
            if self.eat('-') {
                sign = -sign;
            } else if !self.eat('+') {
                return Some(sign * self.atom()?);
            }
        }
    }

    fn atom(&mut self) -> Option<f64> {
        if self.depth > 60 {
            return None;
        }
        if self.eat('(') {
            self.depth += 1;
            let x = self.sum()?;
            self.depth -= 1;
            return self.eat(')').then_some(x);
        }
        let digit = |c: char| c.is_ascii_digit() || c == '.';
        if self.rest.starts_with(digit) {
            let mut end = self.rest.find(|c| !digit(c)).unwrap_or(self.rest.len());
            if let Some(tail) = self.rest.get(end..).filter(|t| t.starts_with(['e', 'E'])) {
                let sign = usize::from(tail[1..].starts_with(['+', '-']));
                let digits = tail[1 + sign..].chars().take_while(char::is_ascii_digit).count();
                if digits > 0 {
                    end += 1 + sign + digits;
                }
            }
            let (number, rest) = self.rest.split_at(end);
            self.rest = rest.trim_start();
            return number.parse().ok();
        }
        let end = self.rest.find(|c: char| !(c.is_alphanumeric() || matches!(c, '_' | '.'))).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        if word.is_empty() {
            return None;
        }
        self.rest = rest.trim_start();
        // `np.pi`, `math.sqrt`
        let word = word.rsplit('.').next().unwrap_or(word);
        if self.eat('(') {
            self.depth += 1;
            let x = self.sum()?;
            let second = if self.eat(',') { Some(self.sum()?) } else { None };
            self.depth -= 1;
            if !self.eat(')') {
                return None;
            }
            return Some(match (word, second) {
                ("deg2rad" | "radians" | "rad", None) => x.to_radians(),
                ("sqrt", None) => x.sqrt(),
                ("sin", None) => x.sin(),
                ("cos", None) => x.cos(),
                ("tan", None) => x.tan(),
                ("atan" | "arctan", None) => x.atan(),
                ("atan2" | "arctan2", Some(y)) => x.atan2(y),
                _ => return None,
            });
        }
        match word {
            "pi" | "π" | "PI" => Some(PI),
            "deg" => (self.names)(word).or(Some(PI / 180.0)),
            _ => (self.names)(word),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn expressions() {
        let names = |n: &str| (n == "a2").then_some(0.4318);
        for (text, x) in [
            ("-pi/2", -PI / 2.0),
            ("160*deg", 160.0 * PI / 180.0),
            ("a2 + 1e-1", 0.5318),
            ("np.pi*(1 - 0.5)", PI / 2.0),
            ("deg2rad(90)", PI / 2.0),
            ("-.5", -0.5),
        ] {
            assert!((value(text, &names).expect(text) - x).abs() < 1e-15, "{text}");
        }
        for text in ["", "a3", "1 +", "(1", "1 2", "1/0", "f(2)"] {
            assert_eq!(value(text, &names), None, "{text}");
        }
    }
}
