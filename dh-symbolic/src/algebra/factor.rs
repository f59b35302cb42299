//! Factoring formulas: common factors, factors in a single angle or group of parallel angles, and exact division.
//!
//! The normal form decides equality; factors serve where a sign or a common divisor is asked for. Formulas are taken as polynomials
//! in symbols, roots, sines and cosines, with powers instead of multiple angles. Not every factorisation is found.

use super::{AngleVar, Factor, Poly, Rational, Symbol};
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// What cannot be taken apart.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Atom {
    /// The square root of 2 or 3.
    Root(u8),
    /// A symbol.
    Symbol(Symbol),
    /// Cosine of a combination of angles of one group.
    Cos(Vec<(AngleVar, i8)>),
    /// Sine of one.
    Sin(Vec<(AngleVar, i8)>),
}

impl Ord for Atom {
    /// Roots, symbols, then angles by their groups; c4 before s4 before c45.
    fn cmp(&self, other: &Atom) -> Ordering {
        let harmonic = |a: &Atom| match a {
            Atom::Cos(t) => (t.clone(), false),
            Atom::Sin(t) => (t.clone(), true),
            _ => (vec![], false),
        };
        slot(self).cmp(&slot(other)).then_with(|| harmonic(self).cmp(&harmonic(other)))
    }
}

impl PartialOrd for Atom {
    fn partial_cmp(&self, other: &Atom) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Powers of atoms, in order.
type Powers = Vec<(Atom, u32)>;
/// A polynomial in atoms.
type Sum = BTreeMap<Powers, Rational>;

/// What an atom varies with: a root, a symbol, a group of angles.
fn slot(a: &Atom) -> (u8, u16) {
    match a {
        Atom::Root(n) => (0, u16::from(*n)),
        Atom::Symbol(s) => (1, s.0),
        Atom::Cos(t) | Atom::Sin(t) => (2, t.first().map_or(0, |x| x.0.group)),
    }
}

fn atom_poly(a: &Atom) -> Poly {
    match a {
        Atom::Root(2) => Poly::sqrt2(),
        Atom::Root(_) => Poly::sqrt3(),
        Atom::Symbol(s) => Poly::symbol(*s),
        Atom::Cos(t) => Poly::harmonic(t, false),
        Atom::Sin(t) => Poly::harmonic(t, true),
    }
}

fn to_poly(s: &Sum) -> Poly {
    let term =
        |(p, c): (&Powers, &Rational)| p.iter().fold(Poly::constant(c.clone()), |x, (a, n)| &x * &atom_poly(a).pow(*n));
    s.iter().map(term).sum()
}

fn times(a: &Powers, b: &Powers) -> Powers {
    let mut out = a.clone();
    for (x, n) in b {
        match out.binary_search_by(|y| y.0.cmp(x)) {
            Ok(i) => out[i].1 += n,
            Err(i) => out.insert(i, (x.clone(), *n)),
        }
    }
    out
}

fn add(sum: &mut Sum, p: Powers, c: &Rational) {
    let entry = sum.entry(p).or_insert(Rational::ZERO);
    *entry = &*entry + c;
}

fn binomial(n: u32, k: u32) -> i64 {
    (0..k).fold(1, |x, i| x * i64::from(n - i) / i64::from(i + 1))
}

/// cos(k v) or sin(k v) times (c^2 + s^2)^extra in powers of c = cos v and s = sin v: (power of c, power of s, coefficient).
fn multiple_angle(k: u32, sine: bool, extra: u32) -> Vec<(u32, u32, Rational)> {
    let mut out = Vec::new();
    for j in (u32::from(sine)..=k).step_by(2) {
        let sign = if (j / 2) % 2 == 0 { 1 } else { -1 };
        for m in 0..=extra {
            let c = Rational::int(sign * binomial(k, j) * binomial(extra, m));
            out.push((k - j + 2 * (extra - m), j + 2 * m, c));
        }
    }
    out
}

/// Writes the harmonics of one angle `v` as powers, with as few terms as possible.
fn unfold(harmonic: &[(u32, bool, Rational)], v: AngleVar) -> Sum {
    let power = |i: u32, j: u32| {
        let mut p = Powers::new();
        if i > 0 {
            p.push((Atom::Cos(vec![(v, 1)]), i));
        }
        if j > 0 {
            p.push((Atom::Sin(vec![(v, 1)]), j));
        }
        p
    };
    let build = |homogeneous: bool| {
        let mut sum = Sum::new();
        for (k, sine, c) in harmonic {
            let top = harmonic.iter().map(|w| w.0).filter(|n| n % 2 == k % 2).max().unwrap_or(*k);
            let extra = if homogeneous { (top - k) / 2 } else { 0 };
            for (i, j, x) in multiple_angle(*k, *sine, extra) {
                add(&mut sum, power(i, j), &(&x * c));
            }
        }
        sum.retain(|_, c| !c.is_zero());
        sum
    };
    let (plain, homogeneous) = (build(false), build(true));
    if homogeneous.len() < plain.len() { homogeneous } else { plain }
}

/// Formulas with more terms are written as they come.
const MOST_TERMS: usize = 400;
/// The highest multiple of an angle that is unfolded into powers.
const UNFOLD: u32 = 6;

fn to_sum(p: &Poly) -> Sum {
    // angles that occur alone in their group's harmonics, with a multiple somewhere
    let mut alone: Vec<(AngleVar, bool)> = Vec::new();
    let mut company: Vec<u16> = Vec::new();
    for (m, _) in p.terms() {
        for f in m.factors() {
            if let Factor::Cos(t) | Factor::Sin(t) = f {
                match t.as_slice() {
                    [(v, k)] => {
                        let high = k.unsigned_abs() > 1;
                        match alone.iter_mut().find(|a| a.0 == *v) {
                            Some(a) => a.1 |= high,
                            None => alone.push((*v, high)),
                        }
                        if u32::from(k.unsigned_abs()) > UNFOLD {
                            company.push(v.group);
                        }
                    }
                    _ => company.extend(t.first().map(|x| x.0.group)),
                }
            }
        }
    }
    let groups: Vec<u16> = alone.iter().map(|a| a.0.group).collect();
    let lonely = |v: AngleVar| !company.contains(&v.group) && groups.iter().filter(|g| **g == v.group).count() == 1;
    let unfolded: Vec<AngleVar> = alone.iter().filter(|a| a.1 && lonely(a.0)).map(|a| a.0).collect();
    let mut sum = Sum::new();
    for (m, c) in p.terms() {
        let powers = m
            .factors()
            .map(|f| match f {
                Factor::Root(n) => (Atom::Root(n), 1),
                Factor::Power(s, n) => (Atom::Symbol(s), n),
                Factor::Cos(t) => (Atom::Cos(t), 1),
                Factor::Sin(t) => (Atom::Sin(t), 1),
            })
            .collect::<Powers>();
        let mut powers = powers;
        powers.sort();
        add(&mut sum, powers, c);
    }
    for v in unfolded {
        sum = unfold_one(&sum, v);
    }
    sum
}

fn unfold_one(sum: &Sum, v: AngleVar) -> Sum {
    let mut classes: BTreeMap<Powers, Vec<(u32, bool, Rational)>> = BTreeMap::new();
    for (p, c) in sum {
        let mut rest = Powers::new();
        let mut harmonic = (0, false);
        for (a, n) in p {
            match a {
                Atom::Cos(t) | Atom::Sin(t) if t.first().is_some_and(|x| x.0 == v) => {
                    harmonic = (t.first().map_or(0, |x| u32::from(x.1.unsigned_abs())), matches!(a, Atom::Sin(_)));
                }
                _ => rest.push((a.clone(), *n)),
            }
        }
        classes.entry(rest).or_default().push((harmonic.0, harmonic.1, c.clone()));
    }
    let mut out = Sum::new();
    for (rest, harmonic) in &classes {
        for (p, c) in unfold(harmonic, v) {
            add(&mut out, times(rest, &p), &c);
        }
    }
    out.retain(|_, c| !c.is_zero());
    out
}

/// A number times powers of sums, none of which has a common factor any more.
struct Split {
    number: Rational,
    /// Common powers.
    common: Powers,
    /// Sums of two terms or more.
    sums: Vec<Sum>,
}

fn split(mut sum: Sum) -> Split {
    let Some((first, c)) = sum.iter().next() else {
        return Split { number: Rational::ZERO, common: vec![], sums: vec![] };
    };
    let mut common = first.clone();
    let mut number = c.clone();
    for (p, c) in &sum {
        for (a, n) in &mut common {
            *n = (*n).min(p.iter().find(|x| x.0 == *a).map_or(0, |x| x.1));
        }
        number = common_number(&number, c);
    }
    common.retain(|x| x.1 > 0);
    if let (Some(x), true) = (number.recip(), !number.is_one() || !common.is_empty()) {
        sum = sum
            .into_iter()
            .map(|(p, c)| {
                let less = |(a, n): (Atom, u32)| {
                    let n = n - common.iter().find(|x| x.0 == a).map_or(0, |x| x.1);
                    (n > 0).then_some((a, n))
                };
                (p.into_iter().filter_map(less).collect(), &c * &x)
            })
            .collect();
    }
    let mut sums = Vec::new();
    if sum.len() > 1 {
        separate(sum, &mut sums);
    }
    Split { number, common, sums }
}

/// The greatest number that divides both, with the sign of the first.
fn common_number(a: &Rational, b: &Rational) -> Rational {
    let (Some((n, d)), Some((m, e))) = (a.to_small(), b.to_small()) else { return Rational::ONE };
    let gcd = |mut x: u64, mut y: u64| {
        while y != 0 {
            (x, y) = (y, x % y);
        }
        x
    };
    let top = gcd(n.unsigned_abs(), m.unsigned_abs());
    let below = gcd(d.unsigned_abs(), e.unsigned_abs());
    let lcm = (d.unsigned_abs() / below.max(1)).checked_mul(e.unsigned_abs());
    match (i64::try_from(top), lcm.and_then(|l| i64::try_from(l).ok())) {
        (Ok(t), Some(l)) => Rational::new(if n < 0 { -t } else { t }, l).unwrap_or(Rational::ONE),
        _ => Rational::ONE,
    }
}

/// Splits off factors that depend on one slot alone.
fn separate(sum: Sum, out: &mut Vec<Sum>) {
    for s in slots(&sum) {
        let parts = collect(&sum, s);
        let Some((_, first)) = parts.iter().next() else { continue };
        if parts.len() < 2 || first.len() < 2 {
            continue;
        }
        let factor: Option<Sum> = parts.iter().map(|(p, c)| Some((p.clone(), proportion(c, first)?))).collect();
        if let Some(factor) = factor {
            let first = first.clone();
            out.push(factor);
            separate(first, out);
            return;
        }
    }
    out.push(sum);
}

fn proportion(a: &Sum, b: &Sum) -> Option<Rational> {
    let x = a.values().next()? * &b.values().next()?.recip()?;
    let same = a.len() == b.len() && a.iter().zip(b).all(|((p, c), (q, d))| p == q && *c == &x * d);
    same.then_some(x)
}

/// Slots of a sum: angle groups first, in order, then symbols and roots.
fn slots(sum: &Sum) -> Vec<(u8, u16)> {
    let mut found: Vec<(u8, u16)> = sum.keys().flatten().map(|(a, _)| slot(a)).collect();
    found.sort_by_key(|s| (u8::MAX - s.0, s.1));
    found.dedup();
    found
}

/// Coefficients of the powers of one slot.
fn collect(sum: &Sum, s: (u8, u16)) -> BTreeMap<Powers, Sum> {
    let mut parts: BTreeMap<Powers, Sum> = BTreeMap::new();
    for (p, c) in sum {
        let (own, rest): (Powers, Powers) = p.iter().cloned().partition(|(a, _)| slot(a) == s);
        parts.entry(own).or_default().insert(rest, c.clone());
    }
    parts
}

/// The quotient of two sums, where it is one: division from the greatest powers down.
fn divided(mut a: Sum, b: &Sum) -> Option<Sum> {
    let top = |s: &Sum| s.iter().max_by(|x, y| by_powers(x.0, y.0)).map(|(p, c)| (p.clone(), c.clone()));
    let (lead, number) = top(b)?;
    let one_over = number.recip()?;
    let mut quotient = Sum::new();
    while let Some((p, c)) = top(&a) {
        let left = |(x, n): &(Atom, u32)| {
            let own = p.iter().find(|y| y.0 == *x).map_or(0, |y| y.1);
            own.checked_sub(*n)
        };
        lead.iter().try_for_each(|x| left(x).map(|_| ()))?;
        let less = |(x, n): &(Atom, u32)| {
            let n = n - lead.iter().find(|y| y.0 == *x).map_or(0, |y| y.1);
            (n > 0).then(|| (x.clone(), n))
        };
        let term: Powers = p.iter().filter_map(less).collect();
        let factor = &c * &one_over;
        for (q, d) in b {
            add(&mut a, times(&term, q), &-&(&factor * d));
        }
        a.retain(|_, c| !c.is_zero());
        quotient.insert(term, factor);
    }
    Some(quotient)
}

/// An order of powers that products respect: by the exponent of the first atom in which they differ.
fn by_powers(a: &Powers, b: &Powers) -> Ordering {
    for (x, y) in a.iter().zip(b) {
        match x.0.cmp(&y.0) {
            Ordering::Less => return Ordering::Greater,
            Ordering::Greater => return Ordering::Less,
            Ordering::Equal if x.1 != y.1 => return x.1.cmp(&y.1),
            Ordering::Equal => {}
        }
    }
    a.len().cmp(&b.len())
}

impl Poly {
    /// self / other, where the quotient is a formula again and division from the greatest powers down finds it.
    pub fn quotient(&self, other: &Poly) -> Option<Poly> {
        if self.terms().len() > MOST_TERMS || other.terms().len() > MOST_TERMS {
            return None;
        }
        divided(to_sum(self), &to_sum(other)).map(|q| to_poly(&q))
    }

    /// Is this, as it stands, a sum of squares with positive factors?
    pub fn is_sum_of_squares(&self) -> bool {
        let square = |(a, n): &(Atom, u32)| n % 2 == 0 || matches!(a, Atom::Root(_));
        to_sum(self).iter().all(|(p, c)| !c.is_negative() && p.iter().all(square))
    }

    /// A number and factors with their multiplicity, whose product is this formula: common factors, and factors that
    /// depend on one angle group alone. Not every factorisation is found.
    pub fn factors(&self) -> (Rational, Vec<(Poly, u32)>) {
        let s = split(to_sum(self));
        let mut out: Vec<(Poly, u32)> = s.common.iter().map(|(a, n)| (atom_poly(a), *n)).collect();
        for f in &s.sums {
            let p = to_poly(f);
            match out.iter_mut().find(|x| x.0 == p) {
                Some(x) => x.1 += 1,
                None => out.push((p, 1)),
            }
        }
        (s.number, out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Arm {
        length: Vec<Poly>,
        c: Vec<Poly>,
        s: Vec<Poly>,
    }

    /// Lengths a, b; angles q1 (alone), q2 and q3 (parallel), q4 (alone); c and s of q1, q2, q23, q4.
    fn arm() -> Arm {
        let mut ring = super::super::Ring::new();
        let length = ["a", "b"].map(|n| Poly::symbol(ring.symbol(n))).to_vec();
        let q1 = ring.angle("q1");
        let q2 = ring.angle("q2");
        let q3 = ring.angle_parallel_to(q2, "q3");
        let q4 = ring.angle("q4");
        let harmonics = [vec![(q1, 1)], vec![(q2, 1)], vec![(q2, 1), (q3, 1)], vec![(q4, 1)]];
        let c = harmonics.iter().map(|w| Poly::harmonic(w, false)).collect();
        let s = harmonics.iter().map(|w| Poly::harmonic(w, true)).collect();
        Arm { length, c, s }
    }

    #[test]
    fn factors_multiply_to_the_formula() {
        let Arm { length, c, s } = arm();
        let atoms: Vec<&Poly> = length.iter().chain(&c).chain(&s).collect();
        // all products of two sums of two atoms
        for i in 0..atoms.len() {
            for j in 0..atoms.len() {
                for k in [0, 3, 7] {
                    let left = atoms[i] - &atoms[j].scale(&Rational::int(3));
                    let p = &(&left * &(atoms[j] + atoms[k])) * &atoms[i].pow(2);
                    let (number, factors) = p.factors();
                    let product = factors.iter().fold(Poly::constant(number), |x, (f, n)| &x * &f.pow(*n));
                    assert_eq!(product, p);
                }
            }
        }
    }

    #[test]
    fn exact_quotients_are_found() {
        let Arm { length, c, s } = arm();
        let (a, b) = (&length[0], &length[1]);
        let d = &(a * a) + &(b * b);
        let q = &(a * &c[0]) - &(b * &s[2]);
        assert_eq!((&q * &d).quotient(&d), Some(q.clone()));
        assert_eq!((&(&q * &d) + a).quotient(&d), None);
        assert_eq!(q.quotient(&Poly::zero()), None);
    }
}
