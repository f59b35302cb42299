//! Turns multiple angles back into powers where that is shorter: (1 + cos(2t))/2 becomes c^2.
//!
//! The normal form has cos(2t) and never c^2. For each cofactor the part in one angle is a trigonometric polynomial; it is
//! written as harmonics, in powers of c, in powers of s, or (second degree) in c^2, s c and s^2, whichever takes the fewest signs.

use super::{Along, Atom, Powers, Term};
use crate::algebra::{AngleVar, Rational};
use crate::render::formula::expression::Trig;

/// One way of writing: coefficients with atoms of the angle.
type Written = Vec<(Rational, Powers)>;

/// Rewrites multiple angles of single joints.
pub(super) fn lower_powers(mut terms: Vec<Term>) -> Vec<Term> {
    let mut angles: Vec<(AngleVar, Atom)> = Vec::new();
    for (atom, _) in terms.iter().flat_map(|t| &t.atoms) {
        if let Some((v, k, _)) = single(atom)
            && k > 1
            && !angles.iter().any(|(w, _)| *w == v)
        {
            angles.push((v, atom.clone()));
        }
    }
    for (v, example) in angles {
        terms = lower(terms, v, &example);
    }
    terms
}

fn along(atom: &Atom) -> Option<&Along> {
    match atom {
        Atom::Joint(w) | Atom::Constant(w) => Some(w),
        _ => None,
    }
}

/// Angle, multiple and kind of a sine or cosine of one angle.
fn single(atom: &Atom) -> Option<(AngleVar, usize, bool)> {
    match along(atom)?.trig.angles.as_slice() {
        [(v, k)] => Some((*v, usize::from(k.unsigned_abs()), along(atom)?.trig.sine)),
        _ => None,
    }
}

/// Terms with one cofactor of the angle's group, which is taken out.
type Family = (Powers, Vec<Term>);

fn lower(terms: Vec<Term>, v: AngleVar, example: &Atom) -> Vec<Term> {
    let in_group = |a: &Atom| along(a).is_some_and(|w| w.trig.angles.iter().any(|(x, _)| x.group() == v.group()));
    let mut families: Vec<Family> = Vec::new();
    for t in terms {
        let (own, rest): (Vec<_>, Vec<_>) = t.atoms.into_iter().partition(|(a, _)| in_group(a));
        let own = Term { coefficient: t.coefficient, atoms: own };
        match families.iter_mut().find(|(r, _)| *r == rest) {
            Some((_, list)) => list.push(own),
            None => families.push((rest, vec![own])),
        }
    }
    let mut out = Vec::new();
    for (rest, family) in families {
        let written = best(&family, v, example, !rest.is_empty())
            .unwrap_or_else(|| family.into_iter().map(|t| (t.coefficient, t.atoms)).collect());
        for (coefficient, own) in written {
            let mut atoms = rest.clone();
            atoms.extend(own);
            atoms.sort();
            out.push(Term { coefficient, atoms });
        }
    }
    out
}

/// The shortest way to write a trigonometric polynomial of the angle `v`; `None` where it is none, or has no multiple angle.
fn best(family: &[Term], v: AngleVar, example: &Atom, has_cofactor: bool) -> Option<Written> {
    let degree = family.iter().flat_map(|t| &t.atoms).filter_map(|(a, _)| single(a)).map(|(_, k, _)| k).max()?;
    if !(2..=8).contains(&degree) {
        return None;
    }
    let mut cosines = vec![Rational::ZERO; degree + 1];
    let mut sines = vec![Rational::ZERO; degree + 1];
    for t in family {
        let slot = match t.atoms.as_slice() {
            [] => cosines.first_mut()?,
            [(a, 1)] => {
                let (w, k, sine) = single(a)?;
                if w != v {
                    return None;
                }
                if sine { sines.get_mut(k)? } else { cosines.get_mut(k)? }
            }
            _ => return None,
        };
        *slot = &*slot + &t.coefficient;
    }
    let harmonics = family.iter().map(|t| (t.coefficient.clone(), t.atoms.clone())).collect();
    let grid = powers_of_cosine(&cosines, &sines);
    let mut ways: Vec<Written> =
        vec![harmonics, written(&grid, v, example), written(&powers_of_sine(&grid), v, example)];
    if degree == 2 && cosines[1].is_zero() && sines[1].is_zero() {
        let mut square = vec![vec![Rational::ZERO; 3]; 3];
        square[2][0] = &cosines[0] + &cosines[2];
        square[0][2] = &cosines[0] - &cosines[2];
        square[1][1] = &sines[2] + &sines[2];
        ways.push(written(&square, v, example));
    }
    ways.into_iter().min_by_key(|w| cost(w, has_cofactor))
}

/// Coefficients of c^i s^j.
type Grid = Vec<Vec<Rational>>;

fn add(grid: &mut Grid, i: usize, j: usize, x: &Rational) {
    while grid.len() <= i {
        grid.push(Vec::new());
    }
    let row = &mut grid[i];
    while row.len() <= j {
        row.push(Rational::ZERO);
    }
    row[j] = &row[j] + x;
}

/// cos(kt) = T_k(c), sin(kt) = s U_{k-1}(c); Chebyshev polynomials by their recurrence.
fn powers_of_cosine(cosines: &[Rational], sines: &[Rational]) -> Grid {
    let mut grid = Grid::new();
    let next = |a: &[i64], b: &[i64]| -> Vec<i64> {
        // 2 c a - b
        (0..=a.len()).map(|i| 2 * i.checked_sub(1).map_or(0, |j| a[j]) - b.get(i).copied().unwrap_or(0)).collect()
    };
    let (mut t, mut t_next) = (vec![1i64], vec![0, 1]);
    let (mut u_before, mut u) = (vec![0i64], vec![1]);
    for k in 0..cosines.len() {
        for (i, n) in t.iter().enumerate() {
            add(&mut grid, i, 0, &(&cosines[k] * &Rational::int(*n)));
        }
        (t, t_next) = (t_next.clone(), next(&t_next, &t));
        if k > 0 {
            for (i, n) in u.iter().enumerate() {
                add(&mut grid, i, 1, &(&sines[k] * &Rational::int(*n)));
            }
            (u_before, u) = (u.clone(), next(&u, &u_before));
        }
    }
    grid
}

/// c^2 = 1 - s^2 as often as possible.
fn powers_of_sine(grid: &Grid) -> Grid {
    let mut out = Grid::new();
    for (i, row) in grid.iter().enumerate() {
        for (j, x) in row.iter().enumerate() {
            // (1 - s^2)^n by binomials
            let n = i / 2;
            let mut binomial = 1i64;
            for m in 0..=n {
                let signed = if m % 2 == 1 { -binomial } else { binomial };
                add(&mut out, i % 2, j + 2 * m, &(x * &Rational::int(signed)));
                binomial = binomial * (n - m) as i64 / (m + 1) as i64;
            }
        }
    }
    out
}

fn written(grid: &Grid, v: AngleVar, example: &Atom) -> Written {
    let atom = |sine: bool| {
        let place = along(example).map_or(0, |w| w.place);
        let along = Along::new(place, Trig { angles: vec![(v, 1)], sine });
        if matches!(example, Atom::Joint(_)) { Atom::Joint(along) } else { Atom::Constant(along) }
    };
    let mut out = Written::new();
    for (i, row) in grid.iter().enumerate() {
        for (j, x) in row.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
            let mut atoms = Vec::new();
            for (n, sine) in [(i, false), (j, true)] {
                if n > 0 {
                    atoms.push((atom(sine), n as u32));
                }
            }
            out.push((x.clone(), atoms));
        }
    }
    out
}

/// Signs on paper, roughly; a bracket and the repeated attention that each further summand costs included.
fn cost(written: &Written, has_cofactor: bool) -> usize {
    let term = |(c, atoms): &(Rational, Powers)| {
        let number = if c.abs().is_one() && !atoms.is_empty() { 0 } else { c.abs().to_string().len() };
        let trigs: usize = atoms
            .iter()
            .map(|(a, n)| match single(a) {
                Some((_, k, _)) if k > 1 => 8,
                _ => 2 + usize::from(*n > 1),
            })
            .sum();
        number + trigs
    };
    let sum: usize = written.iter().map(term).sum();
    let more = written.len().saturating_sub(1);
    sum + 3 * more + if has_cofactor && more > 0 { 2 } else { 0 }
}
