//! Collects terms: common factors first, then by the outermost angle of the chain, then by the next.

use super::part::Part;
use super::{Along, Atom, Powers, Term};
use crate::algebra::Rational;
use std::cmp::Reverse;

/// The summands of a sum of terms. In brackets the order does not depend on signs, so that a sum and its negative read alike.
pub(super) fn parts(terms: Vec<Term>, top: bool) -> Vec<Part> {
    if terms.len() < 2 {
        return terms.into_iter().map(Part::of_term).collect();
    }
    let (number, atoms) = common(&terms);
    if number.is_one() && atoms.is_empty() {
        return collect(terms, top);
    }
    let inverse = number.recip().unwrap_or(Rational::ONE);
    let rest = terms
        .into_iter()
        .map(|t| Term { coefficient: &t.coefficient * &inverse, atoms: divide(t.atoms, &atoms) })
        .collect();
    vec![wrap(number, atoms, collect(rest, false))]
}

/// Number and atoms that all terms share.
fn common(terms: &[Term]) -> (Rational, Powers) {
    let Some((first, rest)) = terms.split_first() else { return (Rational::ONE, Vec::new()) };
    let mut shared = first.atoms.clone();
    for t in rest {
        for (atom, n) in &mut shared {
            *n = (*n).min(t.atoms.iter().find(|(a, _)| a == atom).map_or(0, |(_, m)| *m));
        }
        shared.retain(|(_, n)| *n > 0);
    }
    (content(terms), shared)
}

/// The greatest number that divides all coefficients; 1 where they are no machine numbers.
fn content(terms: &[Term]) -> Rational {
    let (mut numerator, mut denominator) = (0i64, 1i64);
    for t in terms {
        let Some((n, d)) = t.coefficient.to_small() else { return Rational::ONE };
        numerator = gcd(numerator, n);
        let Some(multiple) = (denominator / gcd(denominator, d).max(1)).checked_mul(d) else { return Rational::ONE };
        denominator = multiple;
    }
    Rational::new(numerator, denominator).filter(|x| !x.is_zero()).unwrap_or(Rational::ONE)
}

fn gcd(a: i64, b: i64) -> i64 {
    let (mut a, mut b) = (a.saturating_abs(), b.saturating_abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

fn divide(atoms: Powers, by: &[(Atom, u32)]) -> Powers {
    atoms
        .into_iter()
        .map(|(a, n)| {
            let less = by.iter().find(|(b, _)| *b == a).map_or(0, |(_, m)| *m);
            (a, n.saturating_sub(less))
        })
        .filter(|(_, n)| *n > 0)
        .collect()
}

/// `number * atoms * (inner)`, the first summand in the bracket positive.
fn wrap(number: Rational, atoms: Powers, mut inner: Vec<Part>) -> Part {
    if inner.len() == 1 {
        let mut part = inner.remove(0);
        part.number = &part.number * &number;
        for (a, n) in atoms {
            match part.atoms.iter_mut().find(|(b, _)| *b == a) {
                Some((_, m)) => *m += n,
                None => part.atoms.push((a, n)),
            }
        }
        part.atoms.sort();
        return part;
    }
    let negative = inner.first().is_some_and(|p| p.negative);
    if negative {
        inner.iter_mut().for_each(|p| p.negative = !p.negative);
    }
    Part { negative, number, atoms, brackets: vec![inner] }
}

/// The place of the outermost angle, joints before constants.
fn outermost(terms: &[Term]) -> Option<(bool, usize)> {
    terms
        .iter()
        .flat_map(|t| &t.atoms)
        .filter_map(|(a, _)| match a {
            Atom::Joint(w) => Some((false, w.place)),
            Atom::Constant(w) => Some((true, constant_place(w))),
            _ => None,
        })
        .min()
}

fn constant_place(w: &Along) -> usize {
    w.trig.angles.first().map_or(0, |(v, _)| usize::from(v.group()))
}

/// Collects by the outermost angle. The terms have no common factor.
fn collect(terms: Vec<Term>, top: bool) -> Vec<Part> {
    let Some(outer) = outermost(&terms) else {
        let mut list: Vec<Part> = terms.into_iter().map(Part::of_term).collect();
        list.sort_by_cached_key(|p| (p.negative, p.symbols(), p.atoms.clone()));
        return list;
    };
    let belongs = |a: &Atom| match a {
        Atom::Joint(w) => outer == (false, w.place),
        Atom::Constant(w) => outer == (true, constant_place(w)),
        _ => false,
    };
    let mut without: Vec<Term> = Vec::new();
    let mut keyed: Vec<Keyed> = Vec::new();
    for t in terms {
        let (key, rest): (Vec<_>, Vec<_>) = t.atoms.into_iter().partition(|(a, _)| belongs(a));
        let rest = Term { coefficient: t.coefficient, atoms: rest };
        if key.is_empty() {
            without.push(rest);
        } else {
            match keyed.iter_mut().find(|(k, _)| *k == key) {
                Some((_, list)) => list.push(rest),
                None => keyed.push((key, vec![rest])),
            }
        }
    }
    let mut list: Vec<(Powers, Part)> = join(keyed)
        .into_iter()
        .map(|(keys, rest)| {
            let inner = parts(rest, false);
            let mut keys = keys.into_iter();
            let first = keys.next().map_or_else(Vec::new, |k| k.1);
            let others: Vec<(bool, Powers)> = keys.collect();
            if others.is_empty() {
                return (first.clone(), wrap(Rational::ONE, first, inner));
            }
            let factor = |negative, atoms| Part { negative, number: Rational::ONE, atoms, brackets: Vec::new() };
            let mut sum = vec![factor(false, first.clone())];
            sum.extend(others.into_iter().map(|(negative, atoms)| factor(negative, atoms)));
            let mut part = wrap(Rational::ONE, Vec::new(), inner);
            part.brackets.insert(0, sum);
            (first, part)
        })
        .collect();
    // Along the chain; then brackets before plain products, the one that reaches further first; lengths in their order;
    // cosines before sines.
    let trigs = |key: &[(Atom, u32)]| -> Vec<_> {
        key.iter()
            .filter_map(|(a, _)| match a {
                Atom::Joint(w) | Atom::Constant(w) => Some((w.last, w.trig.angles.clone())),
                _ => None,
            })
            .collect()
    };
    list.sort_by_cached_key(|(key, p)| {
        let (bracketed, span) = (!p.brackets.is_empty(), p.span());
        let first = if bracketed { Reverse(span) } else { Reverse(0) };
        (trigs(key), !bracketed, first, p.symbols(), Reverse(span), key.clone())
    });
    // Outside brackets no minus in front, where a term of the same angle can go first.
    if top
        && without.is_empty()
        && let Some((key, _)) = list.first().filter(|(_, p)| p.negative && p.brackets.is_empty())
    {
        let same = trigs(key);
        let better = list.iter().position(|(k, p)| !p.negative && p.brackets.is_empty() && trigs(k) == same);
        if let Some(i) = better {
            let part = list.remove(i);
            list.insert(0, part);
        }
    }
    let mut list: Vec<Part> = list.into_iter().map(|(_, p)| p).collect();
    let rest = parts(without, top);
    if rest.iter().any(Part::has_angles) {
        list.extend(rest);
    } else {
        list.splice(0..0, rest);
    }
    list
}

/// Signed keys that have one common cofactor, and that cofactor.
type Joined = (Vec<(bool, Powers)>, Vec<Term>);
/// Terms with one product of the outermost angle, which is taken out.
type Keyed = (Powers, Vec<Term>);

/// Joins keys whose cofactors are the same sum up to sign: c1(..) - s1(..) becomes (c1 - s1)(..).
fn join(keyed: Vec<Keyed>) -> Vec<Joined> {
    let mut out: Vec<Joined> = Vec::new();
    let mut keyed = keyed;
    keyed.sort_by(|a, b| a.0.cmp(&b.0));
    for (key, mut rest) in keyed {
        rest.sort_by(|a, b| a.atoms.cmp(&b.atoms));
        let negated: Vec<Term> =
            rest.iter().map(|t| Term { coefficient: -&t.coefficient, atoms: t.atoms.clone() }).collect();
        let known = out.iter_mut().filter(|_| rest.len() > 1).find_map(|(keys, other)| {
            if *other == rest {
                Some((keys, false))
            } else if *other == negated {
                Some((keys, true))
            } else {
                None
            }
        });
        match known {
            Some((keys, negative)) => keys.push((negative, key)),
            None => out.push((vec![(false, key)], rest)),
        }
    }
    out
}
