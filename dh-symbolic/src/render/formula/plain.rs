//! Formulas on one line of ASCII, as `prove` reads them: `c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1`.

use super::expression::{Expression, Summand, Trig};
use super::grouping::Order;
use crate::algebra::{Poly, Rational, Ring};

/// Formulas with more terms are written as they come: nobody will read them.
const MOST_TERMS: usize = 400;

/// A formula in the textbook's shape.
pub fn formula(ring: &Ring, order: &Order, p: &Poly) -> String {
    if p.terms().len() > MOST_TERMS { ring.text(p) } else { expression(ring, &without_sign(order.group(p))) }
}

/// `c1*(s6 - s5)` for `-c1*(s5 - s6)`.
fn without_sign(e: Expression) -> Expression {
    match &e {
        Expression::Sum(terms) => match terms.as_slice() {
            [only] if only.negative => turned(&only.value).unwrap_or(e),
            _ => e,
        },
        _ => e,
    }
}

/// The negative of a formula, where it needs no sign in front.
fn turned(e: &Expression) -> Option<Expression> {
    match e {
        Expression::Product(factors) => {
            let (i, f) = factors.iter().enumerate().find_map(|(i, f)| Some((i, turned(f)?)))?;
            let mut factors = factors.clone();
            *factors.get_mut(i)? = f;
            Some(Expression::Product(factors))
        }
        Expression::Sum(terms) => {
            let turn = |t: &Summand| match turned(&t.value) {
                Some(value) if !t.negative => Summand { negative: false, value },
                _ => Summand { negative: !t.negative, value: t.value.clone() },
            };
            let mut terms: Vec<Summand> = terms.iter().map(turn).collect();
            let first = terms.iter().position(|t| !t.negative)?;
            terms.get_mut(..=first)?.rotate_right(1);
            Some(Expression::Sum(terms))
        }
        _ => None,
    }
}

/// A formula in the shape that it has.
pub fn expression(ring: &Ring, e: &Expression) -> String {
    match e {
        Expression::Number(x) => number(x),
        Expression::Root(n) => format!("sqrt({n})"),
        Expression::Symbol(s) => ring.symbol_name(*s).to_string(),
        Expression::Trig(Trig { angles, sine }) => ring.harmonic_text(angles, *sine),
        Expression::Power(base, n) => format!("{}^{n}", bracketed(ring, base, false)),
        Expression::Product(factors) => factors.iter().map(|f| bracketed(ring, f, true)).collect::<Vec<_>>().join("*"),
        Expression::Sum(terms) if terms.is_empty() => "0".into(),
        Expression::Sum(terms) => {
            let mut out = String::new();
            for t in terms {
                out.push_str(match (out.is_empty(), t.negative) {
                    (true, false) => "",
                    (true, true) => "-",
                    (false, false) => " + ",
                    (false, true) => " - ",
                });
                out.push_str(&bracketed(ring, &t.value, true));
            }
            out
        }
    }
}

/// In brackets where a sum (and for a base: a number or a product) must not stand bare.
fn bracketed(ring: &Ring, e: &Expression, product_is_fine: bool) -> String {
    let text = expression(ring, e);
    let bare = match e {
        Expression::Trig(_) | Expression::Symbol(_) | Expression::Root(_) => true,
        Expression::Number(_) | Expression::Power(..) | Expression::Product(_) => product_is_fine,
        Expression::Sum(terms) => terms.is_empty(),
    };
    if bare { text } else { format!("({text})") }
}

/// A decimal where it is finite and short, otherwise a fraction.
pub fn number(x: &Rational) -> String {
    if let Some((n, mut d)) = x.to_small() {
        let mut places = 0u32;
        let mut scaled = n;
        while d > 1 && places < 12 {
            let step = if d % 10 == 0 {
                (1, 10)
            } else if d % 2 == 0 {
                (5, 2)
            } else if d % 5 == 0 {
                (2, 5)
            } else {
                break;
            };
            let Some(next) = scaled.checked_mul(step.0) else { break };
            scaled = next;
            d /= step.1;
            places += 1;
        }
        if d == 1 && places > 0 {
            let digits = format!("{:0width$}", scaled.unsigned_abs(), width = places as usize + 1);
            let (whole, fraction) = digits.split_at(digits.len() - places as usize);
            return format!("{}{whole}.{fraction}", if scaled < 0 { "-" } else { "" });
        }
    }
    x.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_read_back() {
        let mut ring = Ring::new();
        let [a, b] = ["a", "b"].map(|n| Poly::symbol(ring.symbol(n)));
        let q1 = ring.angle("q1");
        let q2 = ring.angle_parallel_to(q1, "q2");
        let (c1, _) = Poly::cos_sin(q1);
        let difference = Poly::harmonic(&[(q1, 1), (q2, -1)], true);
        let rational = |n, d| Poly::constant(Rational::new(n, d).unwrap());
        let order = Order::new(vec![q1.group()]);
        for (p, text) in [
            (&(&a * &c1) - &(&b * &difference), "a*c1 - b*s(1-2)"),
            (&(&a + &b).pow(2) * &c1, "c1*(a^2 + 2*a*b + b^2)"),
            (&(&a - &b) * &-&c1, "c1*(b - a)"),
            (rational(-381, 10), "-38.1"),
            (rational(1, 3), "1/3"),
            (&rational(1, 2) * &a, "0.5*a"),
            (&Poly::sqrt2() * &a, "sqrt(2)*a"),
            (Poly::zero(), "0"),
        ] {
            assert_eq!(formula(&ring, &order, &p), text);
        }
    }
}
