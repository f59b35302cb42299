//! Products of symbol powers, square roots and one harmonic per group of angles; the term order.

use super::symbol::GROUP_SIZE;
use super::{AngleVar, Rational, Symbol};

/// One factor, packed so that comparing numbers compares factors: slot (16 bits), kind (8 bits), payload (96 bits).
/// Kinds: 0 square root of 2 or 3, 1 power of a symbol, 2 cosine, 3 sine.
type Code = u128;

const ROOT: u128 = 0;
const POWER: u128 = 1;
const COS: u128 = 2;
const SIN: u128 = 3;
/// Slots: 0 and 1 are the square roots, then symbols, then groups of angles.
const SYMBOL_BASE: u128 = 16;
const GROUP_BASE: u128 = 1 << 15;

/// A product of factors, at most one per slot, in order of slots. The empty product is 1.
#[derive(Clone, PartialEq, Eq, Hash, Default)]
pub struct Monomial(Vec<Code>);

impl Ord for Monomial {
    /// The order of lists. (Sorting terms is most of what formulas cost, and macros run unoptimised: a loop is faster than the library's.)
    fn cmp(&self, other: &Monomial) -> std::cmp::Ordering {
        let (a, b) = (self.0.as_slice(), other.0.as_slice());
        let mut i = 0;
        while i < a.len() && i < b.len() {
            if a[i] != b[i] {
                return if a[i] < b[i] { std::cmp::Ordering::Less } else { std::cmp::Ordering::Greater };
            }
            i += 1;
        }
        a.len().cmp(&b.len())
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Monomial) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

/// A factor of a monomial, for those who look inside.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Factor {
    /// The square root of 2 or of 3.
    Root(u8),
    /// A symbol to a positive power.
    Power(Symbol, u32),
    /// The cosine of an integer combination of angles of one group.
    Cos(Vec<(AngleVar, i8)>),
    /// The sine of one.
    Sin(Vec<(AngleVar, i8)>),
}

fn slot(code: Code) -> u128 {
    code >> 112
}

fn kind(code: Code) -> u128 {
    (code >> 104) & 0xff
}

fn pack(slot: u128, kind: u128, payload: u128) -> Code {
    (slot << 112) | (kind << 104) | payload
}

fn payload(code: Code) -> u128 {
    code & ((1 << 96) - 1)
}

/// Integer factors of the angles of a group.
type Multiples = [i8; GROUP_SIZE];

fn multiples_of(code: Code) -> Multiples {
    let mut k = [0i8; GROUP_SIZE];
    for (i, x) in k.iter_mut().enumerate() {
        *x = (((code >> (8 * (GROUP_SIZE - 1 - i))) & 0xff) as u8 ^ 0x80) as i8;
    }
    k
}

fn packed(k: Multiples) -> u128 {
    k.into_iter().fold(0, |payload, x| (payload << 8) | u128::from((x as u8) ^ 0x80))
}

/// The packed form of nothing but zeros: 0x80 in each byte, which is added to every factor.
const ZEROS: u128 = (u128::MAX / 0xff * 0x80) >> (128 - 8 * GROUP_SIZE);

/// Are all factors of packed multiples between -64 and 63? Then two of them add up, and change sign, as one number without a carry.
fn is_small(multiples: u128) -> bool {
    (multiples + ZEROS / 2) & ZEROS == ZEROS
}

/// Sum and difference of two packed multiples.
fn sum_and_difference(x: u128, y: u128) -> [u128; 2] {
    if is_small(x) && is_small(y) {
        return [x + y - ZEROS, x + ZEROS - y];
    }
    let (x, y) = (multiples_of(x), multiples_of(y));
    let of = |f: fn(i8, i8) -> i8| packed(std::array::from_fn(|i| f(x[i], y[i])));
    [of(i8::saturating_add), of(i8::saturating_sub)]
}

/// The code of cos or sin of packed multiples; gives the sign that normalising took. `None`: the harmonic is the constant 1 (cos) or 0 (sin).
fn harmonic_code(group: u16, sine: bool, mut multiples: u128) -> Option<(Code, bool)> {
    let bits = multiples ^ ZEROS;
    if bits == 0 {
        return None;
    }
    // The first factor that isn't zero is negative where its byte's first bit differs.
    let flip = bits.leading_zeros().is_multiple_of(8);
    if flip {
        multiples = if is_small(multiples) {
            2 * ZEROS - multiples
        } else {
            packed(multiples_of(multiples).map(i8::saturating_neg))
        };
    }
    let code = pack(GROUP_BASE + u128::from(group), if sine { SIN } else { COS }, multiples);
    Some((code, flip && sine))
}

impl Monomial {
    /// The empty product.
    pub fn one() -> Monomial {
        Monomial(Vec::new())
    }

    /// Is this the empty product?
    pub fn is_one(&self) -> bool {
        self.0.is_empty()
    }

    /// The square root of 2 (`which` = 2) or 3.
    pub(super) fn root(which: u8) -> Monomial {
        Monomial(vec![pack(u128::from(which == 3), ROOT, 0)])
    }

    /// A symbol to a power.
    pub(super) fn power(s: Symbol, exponent: u32) -> Monomial {
        if exponent == 0 {
            Monomial::one()
        } else {
            Monomial(vec![pack(SYMBOL_BASE + u128::from(s.0), POWER, u128::from(exponent))])
        }
    }

    /// cos or sin of a combination of angles of one group, with its sign; `None` where it is constant.
    pub(super) fn harmonic(terms: &[(AngleVar, i8)], sine: bool) -> Option<(Monomial, bool)> {
        let group = terms.first()?.0.group;
        let mut k = [0i8; GROUP_SIZE];
        for (v, n) in terms {
            k[usize::from(v.index)] = k[usize::from(v.index)].saturating_add(*n);
        }
        harmonic_code(group, sine, packed(k)).map(|(code, flip)| (Monomial(vec![code]), flip))
    }

    /// The factors in order: roots, symbols, harmonics.
    pub fn factors(&self) -> impl Iterator<Item = Factor> + '_ {
        self.0.iter().map(|&code| match kind(code) {
            ROOT => Factor::Root(if slot(code) == 0 { 2 } else { 3 }),
            POWER => Factor::Power(Symbol((slot(code) - SYMBOL_BASE) as u16), (code & 0xffff_ffff) as u32),
            which => {
                let group = (slot(code) - GROUP_BASE) as u16;
                let terms = multiples_of(code)
                    .iter()
                    .enumerate()
                    .filter(|(_, k)| **k != 0)
                    .map(|(i, k)| (AngleVar { group, index: i as u8 }, *k))
                    .collect();
                if which == COS { Factor::Cos(terms) } else { Factor::Sin(terms) }
            }
        })
    }

    /// The monomial of these factors of this one that `keep` accepts.
    pub fn filter(&self, mut keep: impl FnMut(&Factor) -> bool) -> Monomial {
        Monomial(self.0.iter().copied().zip(self.factors()).filter(|(_, f)| keep(f)).map(|(c, _)| c).collect())
    }

    /// Greatest factor of an angle in a sine or cosine: 2 in cos(2*q1 - q2). Products add them up; beyond 127 they would no
    /// longer be exact, so whoever multiplies formulas of unknown size asks first.
    pub fn order(&self) -> u8 {
        let multiples = self.0.iter().filter(|c| kind(**c) >= COS).map(|c| multiples_of(*c));
        multiples.flat_map(|k| k.map(i8::unsigned_abs)).max().unwrap_or(0)
    }

    /// Does the angle occur?
    pub fn has_angle(&self, v: AngleVar) -> bool {
        self.0.iter().any(|&c| {
            kind(c) >= COS
                && slot(c) == GROUP_BASE + u128::from(v.group)
                && (c >> (8 * (GROUP_SIZE - 1 - usize::from(v.index)))) & 0xff != 0x80
        })
    }

    /// Exponent of a symbol.
    pub fn exponent(&self, s: Symbol) -> u32 {
        let want = SYMBOL_BASE + u128::from(s.0);
        self.0.iter().find(|&&c| slot(c) == want).map_or(0, |c| (c & 0xffff_ffff) as u32)
    }

    /// Appends `coefficient * self * other` to `out`: one term, or several where harmonics of one group meet.
    pub(super) fn multiply_into(&self, other: &Monomial, coefficient: Rational, out: &mut Vec<(Monomial, Rational)>) {
        let (a, b) = (&self.0, &other.0);
        let mut product = Vec::with_capacity(a.len() + b.len());
        let mut coefficient = coefficient;
        // Pairs of harmonics of one group: each doubles the number of terms.
        let mut meetings: Vec<(Code, Code)> = Vec::new();
        let (mut i, mut j) = (0, 0);
        while i < a.len() && j < b.len() {
            let (x, y) = (a[i], b[j]);
            let (sx, sy) = (slot(x), slot(y));
            if sx < sy {
                product.push(x);
                i += 1;
            } else if sy < sx {
                product.push(y);
                j += 1;
            } else {
                match kind(x) {
                    ROOT => coefficient = &coefficient * &Rational::int(if sx == 0 { 2 } else { 3 }),
                    POWER => product.push(x + (y & 0xffff_ffff)),
                    _ => meetings.push((x, y)),
                }
                i += 1;
                j += 1;
            }
        }
        product.extend_from_slice(&a[i..]);
        product.extend_from_slice(&b[j..]);
        if meetings.is_empty() {
            out.push((Monomial(product), coefficient));
            return;
        }
        let mut terms = vec![(product, coefficient)];
        for (x, y) in meetings {
            let group = (slot(x) - GROUP_BASE) as u16;
            let [sum, difference] = sum_and_difference(payload(x), payload(y));
            // cos cos, sin sin -> cosines; mixed -> sines. Signs of (difference, sum) terms.
            let (sine, sign_difference, sign_sum) = match (kind(x), kind(y)) {
                (COS, COS) => (false, 1, 1),
                (SIN, SIN) => (false, 1, -1),
                (SIN, _) => (true, 1, 1),
                (_, _) => (true, -1, 1),
            };
            let mut next = Vec::with_capacity(terms.len() * 2);
            for (codes, c) in terms {
                let half = &c * &Rational::HALF;
                for (multiples, sign) in [(difference, sign_difference), (sum, sign_sum)] {
                    let signed = if sign < 0 { -&half } else { half.clone() };
                    match harmonic_code(group, sine, multiples) {
                        Some((code, flip)) => {
                            let mut longer = codes.clone();
                            let at = longer.partition_point(|&c| slot(c) < slot(code));
                            longer.insert(at, code);
                            next.push((longer, if flip { -&signed } else { signed }));
                        }
                        None if sine => {}
                        None => next.push((codes.clone(), signed)),
                    }
                }
            }
            terms = next;
        }
        out.extend(terms.into_iter().map(|(codes, c)| (Monomial(codes), c)));
    }
}

impl std::fmt::Debug for Monomial {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.factors()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packed_multiples_add_up_and_change_sign_like_lists() {
        let mut x = 1u64;
        for round in 0..3000 {
            let mut multiples = |most: i8| -> Multiples {
                std::array::from_fn(|_| {
                    x = x.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                    // Many zeros.
                    if x >> 63 == 0 { 0 } else { ((x >> 33) as i8).clamp(-most, most) }
                })
            };
            // Small ones; some just too large; anything.
            let most = [3, 63, 66, 127][round % 4];
            let (a, b) = (multiples(most), multiples(most));
            let [sum, difference] = sum_and_difference(packed(a), packed(b));
            assert_eq!(multiples_of(sum), std::array::from_fn(|i| a[i].saturating_add(b[i])));
            assert_eq!(multiples_of(difference), std::array::from_fn(|i| a[i].saturating_sub(b[i])));
            let first = a.iter().copied().find(|k| *k != 0);
            let code = harmonic_code(5, true, packed(a));
            assert_eq!(code.map(|c| c.1), first.map(|k| k < 0), "{a:?}");
            if let (Some((code, flip)), Some(_)) = (code, first) {
                assert_eq!(multiples_of(code), if flip { a.map(i8::saturating_neg) } else { a });
            }
        }
    }
}
