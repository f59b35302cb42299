//! The plain-text form: what snapshots and error messages show, and what `prove` reads.

use super::{AngleVar, Factor, Monomial, Poly, Ring};

impl Ring {
    /// `c23`, `s(2-3)`, `cos(2*q2 + q3)`: a harmonic, as `prove` reads it. Angles named `q` or `theta` with a number get the short form.
    pub fn harmonic_text(&self, terms: &[(AngleVar, i8)], sine: bool) -> String {
        let digits = |v: AngleVar| {
            let name = self.angle_name(v);
            let tail = name.strip_prefix("theta").or_else(|| name.strip_prefix('q'))?;
            (!tail.is_empty() && tail.bytes().all(|b| b.is_ascii_digit())).then(|| tail.to_string())
        };
        let short: Option<Vec<(String, i8)>> =
            terms.iter().map(|(v, k)| digits(*v).filter(|_| k.abs() == 1).map(|d| (d, *k))).collect();
        match short {
            Some(parts) => {
                let letter = if sine { "s" } else { "c" };
                if parts.iter().any(|(_, k)| *k < 0) {
                    let inner: Vec<String> = parts
                        .iter()
                        .enumerate()
                        .map(|(i, (d, k))| {
                            format!(
                                "{}{d}",
                                if *k < 0 {
                                    "-"
                                } else if i > 0 {
                                    "+"
                                } else {
                                    ""
                                }
                            )
                        })
                        .collect();
                    return format!("{letter}({})", inner.concat());
                }
                let wide = parts.iter().any(|(d, _)| d.len() > 1);
                let names: Vec<&str> = parts.iter().map(|(d, _)| d.as_str()).collect();
                let text = format!("{letter}{}", names.join(if wide { "_" } else { "" }));
                text
            }
            None => {
                let mut inner = String::new();
                for (v, k) in terms {
                    let sign = if *k < 0 {
                        " - "
                    } else if inner.is_empty() {
                        ""
                    } else {
                        " + "
                    };
                    inner.push_str(if inner.is_empty() { sign.trim() } else { sign });
                    if k.unsigned_abs() != 1 {
                        inner.push_str(&format!("{}*", k.unsigned_abs()));
                    }
                    inner.push_str(self.angle_name(*v));
                }
                format!("{}({inner})", if sine { "sin" } else { "cos" })
            }
        }
    }

    fn monomial_text(&self, m: &Monomial) -> Vec<String> {
        m.factors()
            .map(|f| match f {
                Factor::Root(n) => format!("sqrt({n})"),
                Factor::Power(s, 1) => self.symbol_name(s).to_string(),
                Factor::Power(s, n) => format!("{}^{n}", self.symbol_name(s)),
                Factor::Cos(t) => self.harmonic_text(&t, false),
                Factor::Sin(t) => self.harmonic_text(&t, true),
            })
            .collect()
    }

    /// The expanded formula in plain text: `a2*c2 - d4*s23`.
    pub fn text(&self, p: &Poly) -> String {
        if p.is_zero() {
            return "0".into();
        }
        let mut out = String::new();
        for (m, c) in p.terms() {
            let sign = match (out.is_empty(), c.is_negative()) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            out.push_str(sign);
            let mut factors = self.monomial_text(m);
            if !c.abs().is_one() || factors.is_empty() {
                factors.insert(0, c.abs().to_string());
            }
            out.push_str(&factors.join("*"));
        }
        out
    }
}
