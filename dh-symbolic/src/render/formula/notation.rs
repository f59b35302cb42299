//! The printed names of quantities: c1 and s23 with their meaning, theta2, L1, alpha3.

use super::expression::{Expression, Trig};
use super::math::{Math, Sign};
pub use super::name::Name;
use super::style::Style;
use crate::algebra::{AngleVar, Ring, Symbol};
use crate::chain::{Chain, Coordinate};

/// Names for everything in a ring.
#[derive(Clone, Debug, Default)]
pub struct Notation {
    symbols: Vec<(Symbol, Math)>,
    angles: Vec<(AngleVar, Name)>,
    pub(in crate::render) style: Style,
}

impl Notation {
    /// The names as they stand in the ring: `q2` is called q2.
    pub fn of_ring(ring: &Ring) -> Notation {
        Notation {
            symbols: ring.symbols().map(|s| (s, Name::of(ring.symbol_name(s)).math())).collect(),
            angles: ring.angles().map(|v| (v, Name::of(ring.angle_name(v)))).collect(),
            style: Style::default(),
        }
    }

    /// The names that generated code uses: q1, q2, and theta for a joint angle that is not its variable.
    pub fn of_code(chain: &Chain) -> Notation {
        let mut notation = Notation::of_ring(&chain.ring);
        for joint in &chain.joints {
            if let Coordinate::Angle(v) = joint.coordinate
                && !joint.shift.is_zero()
            {
                notation.rename_angle(v, Name::with_index("theta", (joint.row + 1).to_string()));
            }
        }
        notation
    }

    /// The names of textbooks: theta_i for turning joints and d_i for sliding ones, where the joint variable is just
    /// that (no offset, no coupling, every row a joint) and no parameter has the name; else as in code.
    pub fn textbook(chain: &Chain) -> Notation {
        Notation::styled(chain, &Style::default())
    }

    /// The same with choices of notation.
    pub fn styled(chain: &Chain, style: &Style) -> Notation {
        let mut notation = Notation::of_code(chain);
        notation.style = style.clone();
        let stem = style.joints.as_deref().unwrap_or("theta");
        if !is_plain(chain) {
            return notation;
        }
        for joint in &chain.joints {
            let number = (joint.row + 1).to_string();
            match joint.coordinate {
                Coordinate::Angle(v) => notation.rename_angle(v, Name::with_index(stem, number)),
                Coordinate::Length(s) => notation.rename_symbol(s, Name::with_index("d", number)),
            }
        }
        notation
    }

    /// Calls an angle by another name.
    pub fn rename_angle(&mut self, v: AngleVar, name: Name) {
        if let Some(entry) = self.angles.iter_mut().find(|(w, _)| *w == v) {
            entry.1 = name;
        }
    }

    /// Calls a length by another name.
    pub fn rename_symbol(&mut self, s: Symbol, name: Name) {
        self.set_symbol(s, name.math());
    }

    /// Writes a length in another way.
    pub fn set_symbol(&mut self, s: Symbol, math: Math) {
        match self.symbols.iter_mut().find(|(t, _)| *t == s) {
            Some(entry) => entry.1 = math,
            None => self.symbols.push((s, math)),
        }
    }

    /// Adds the names that the other has and this one has not.
    pub fn extend(&mut self, other: &Notation) {
        for (s, math) in &other.symbols {
            if !self.symbols.iter().any(|(t, _)| t == s) {
                self.symbols.push((*s, math.clone()));
            }
        }
        for (v, name) in &other.angles {
            if !self.angles.iter().any(|(w, _)| w == v) {
                self.angles.push((*v, name.clone()));
            }
        }
    }

    /// Is this what joint angles are called?
    fn is_joint(&self, stem: &str) -> bool {
        matches!(stem, "q" | "theta") || self.style.joints.as_deref() == Some(stem)
    }

    fn angle_name(&self, v: AngleVar) -> Name {
        self.angles.iter().find(|(w, _)| *w == v).map_or_else(|| Name::of("angle"), |(_, n)| n.clone())
    }

    /// A length as typeset.
    pub fn symbol(&self, s: Symbol) -> Math {
        self.symbols.iter().find(|(t, _)| *t == s).map_or_else(|| Math::word("length"), |(_, m)| m.clone())
    }

    /// An angle as typeset.
    pub fn angle(&self, v: AngleVar) -> Math {
        self.angle_name(v).math()
    }

    /// A sine or cosine as typeset: c1, s23, c2-3 for joint angles with numbers; c alpha2 for other angles; else written out.
    pub fn trig(&self, w: &Trig) -> Math {
        if self.style.long_sines {
            return self.written_out(w);
        }
        let letter = Math::Letter(if w.sine { 's' } else { 'c' });
        let names: Vec<(Name, i8)> = w.angles.iter().map(|(v, k)| (self.angle_name(*v), *k)).collect();
        let numbered = names.iter().all(|(n, k)| {
            self.is_joint(&n.stem)
                && k.unsigned_abs() == 1
                && !n.index.is_empty()
                && n.index.bytes().all(|b| b.is_ascii_digit())
        });
        if numbered {
            let wide = names.iter().any(|(n, _)| n.index.len() > 1);
            let mut row = Vec::new();
            for (i, (n, k)) in names.iter().enumerate() {
                if *k < 0 {
                    row.push(Math::Sign(if i == 0 { Sign::Negative } else { Sign::Minus }));
                } else if i > 0 && wide {
                    row.push(Math::Sign(Sign::Comma));
                }
                row.push(Math::number(&n.index));
            }
            let plain = row.iter().all(|m| matches!(m, Math::Number(_)));
            let index = if plain {
                Math::Number(names.iter().map(|(n, _)| n.index.as_str()).collect())
            } else {
                Math::Row(row)
            };
            return letter.below(index);
        }
        match names.as_slice() {
            [(n, 1)] if matches!(base_of(&n.math()), Math::Letter(_)) => Math::Row(vec![letter, n.math()]),
            _ => self.written_out(w),
        }
    }

    /// A sine or cosine written out: cos(theta2 + theta3).
    pub fn written_out(&self, w: &Trig) -> Math {
        let name = if w.sine { "sin" } else { "cos" };
        match w.angles.as_slice() {
            [(v, 1)] => Math::Row(vec![Math::word(name), Math::Sign(Sign::Apply), self.angle(*v)]),
            _ => Math::call(name, vec![self.combination(&w.angles)]),
        }
    }

    /// theta2 + theta3, 2 theta1 - theta4.
    pub fn combination(&self, angles: &[(AngleVar, i8)]) -> Math {
        let mut row = Vec::new();
        for (v, k) in angles {
            match (row.is_empty(), *k < 0) {
                (true, true) => row.push(Math::Sign(Sign::Negative)),
                (true, false) => {}
                (false, true) => row.push(Math::Sign(Sign::Minus)),
                (false, false) => row.push(Math::Sign(Sign::Plus)),
            }
            if k.unsigned_abs() != 1 {
                row.push(Math::number(k.unsigned_abs()));
            }
            row.push(self.angle(*v));
        }
        Math::Row(row)
    }

    /// What the abbreviations in these formulas mean, each as an equation; sines and cosines written out anyway are left
    /// away. Three or more single angles are told together: c_i = cos theta_i, s_i = sin theta_i, i = 1, 4, 5.
    pub fn legend<'a>(&self, expressions: impl IntoIterator<Item = &'a Expression>) -> Vec<Math> {
        self.legend_of(&trigs(expressions))
    }

    /// The same for a sorted list of sines and cosines.
    pub fn legend_of(&self, trigs: &[Trig]) -> Vec<Math> {
        if self.style.long_sines {
            return Vec::new();
        }
        let numbers: Vec<&str> = self.family(trigs);
        let together = numbers.len() > 2;
        let mut out = Vec::new();
        if together {
            let i = || Math::Letter('i');
            let stem = trigs.iter().find_map(|w| self.number(w)).map_or("theta", |(stem, _)| stem);
            let angle = Name::with_index(stem, "i".into()).math();
            for (letter, word) in [('c', "cos"), ('s', "sin")] {
                let long = Math::Row(vec![Math::word(word), Math::Sign(Sign::Apply), angle.clone()]);
                out.push(Math::equation(Math::Letter(letter).below(i()), long));
            }
            let consecutive = numbers.windows(2).all(|w| {
                let value = |t: &str| t.parse::<u32>().unwrap_or(0);
                matches!(w, [a, b] if value(a) + 1 == value(b))
            });
            let mut row = vec![i(), Math::Sign(Sign::Equals)];
            match (numbers.first(), numbers.last()) {
                (Some(first), Some(last)) if consecutive && numbers.len() > 3 => {
                    row.extend([Math::number(first), Math::Sign(Sign::Dots), Math::number(last)]);
                }
                _ => {
                    for (k, n) in numbers.iter().enumerate() {
                        if k > 0 {
                            row.push(Math::Sign(Sign::Comma));
                        }
                        row.push(Math::number(n));
                    }
                }
            }
            out.push(Math::Row(row));
        }
        for w in trigs {
            if together && self.number(w).is_some() {
                continue;
            }
            let (short, long) = (self.trig(w), self.written_out(w));
            if short != long {
                out.push(Math::equation(short, long));
            }
        }
        out
    }

    /// Stem and number of the sine or cosine of one numbered joint angle.
    fn number<'a>(&'a self, w: &Trig) -> Option<(&'a str, &'a str)> {
        let [(v, 1)] = w.angles.as_slice() else { return None };
        let (_, name) = self.angles.iter().find(|(x, _)| x == v)?;
        let fine =
            self.is_joint(&name.stem) && !name.index.is_empty() && name.index.bytes().all(|b| b.is_ascii_digit());
        fine.then_some((name.stem.as_str(), name.index.as_str()))
    }

    /// The numbers of the single joint angles, if all have one stem.
    fn family(&self, trigs: &[Trig]) -> Vec<&str> {
        let list: Vec<(&str, &str)> = trigs.iter().filter_map(|w| self.number(w)).collect();
        let mut numbers: Vec<&str> = list.iter().map(|(_, n)| *n).collect();
        numbers.sort_by_key(|n| n.parse::<u32>().unwrap_or(0));
        numbers.dedup();
        let one_stem = list.windows(2).all(|w| matches!(w, [a, b] if a.0 == b.0));
        if one_stem { numbers } else { Vec::new() }
    }
}

/// The sines and cosines in these formulas, sorted: single angles first.
pub fn trigs<'a>(expressions: impl IntoIterator<Item = &'a Expression>) -> Vec<Trig> {
    let mut trigs: Vec<Trig> = Vec::new();
    for e in expressions {
        e.leaves(&mut |leaf| {
            if let Expression::Trig(w) = leaf {
                trigs.push(w.clone());
            }
        });
    }
    trigs.sort_by(|a, b| (a.angles.len(), a).cmp(&(b.angles.len(), b)));
    trigs.dedup();
    trigs
}

fn base_of(m: &Math) -> &Math {
    match m {
        Math::Script(s) => &s.base,
        other => other,
    }
}

/// Does every row move, each by its own variable and nothing else?
fn is_plain(chain: &Chain) -> bool {
    let taken = |name: String| chain.parameters.iter().any(|p| p.name == name);
    chain.is_direct()
        && chain.joints.iter().enumerate().all(|(i, joint)| {
            let Some(link) = chain.links.get(joint.row) else { return false };
            let number = joint.row + 1;
            let free = match joint.coordinate {
                Coordinate::Angle(_) => link.theta.constant.is_zero() && !taken(format!("theta{number}")),
                Coordinate::Length(s) => link.d == crate::algebra::Poly::symbol(s) && !taken(format!("d{number}")),
            };
            joint.row == i && joint.shift.is_zero() && free
        })
}
