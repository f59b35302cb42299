//! The ring of a robot: the names of its symbols, which occur in powers, and of its angles, which occur in sines and cosines.

use super::{Angle, Poly, Rational};

/// Most angles that one group of parallel axes may hold.
pub(super) const GROUP_SIZE: usize = 12;

/// A quantity that enters polynomially: a length, a prismatic variable, an entry of the target pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol(pub(super) u16);

/// An angle that enters through sines and cosines: member `index` of the group `group`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AngleVar {
    pub(super) group: u16,
    pub(super) index: u8,
}

impl AngleVar {
    /// The group of angles with parallel axes that this angle belongs to.
    pub fn group(self) -> u16 {
        self.group
    }
}

/// An integer combination of angles plus an exact constant: the argument of a sine or cosine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinearAngle {
    /// Angles with their integer factors.
    pub terms: Vec<(AngleVar, i8)>,
    /// The constant part.
    pub constant: Angle,
}

impl LinearAngle {
    /// The angle of one variable.
    pub fn var(v: AngleVar) -> LinearAngle {
        LinearAngle { terms: vec![(v, 1)], constant: Angle::ZERO }
    }

    /// A constant angle.
    pub fn constant(angle: Angle) -> LinearAngle {
        LinearAngle { terms: Vec::new(), constant: angle }
    }

    /// (cosine, sine) as polynomials; `None` where the constant part has no exact sine (not a multiple of 15 degrees).
    pub fn cos_sin(&self) -> Option<(Poly, Poly)> {
        let (mut c, mut s) = self.constant.cos_sin()?;
        let mut groups: Vec<u16> = self.terms.iter().map(|(v, _)| v.group).collect();
        groups.sort_unstable();
        groups.dedup();
        for g in groups {
            let part: Vec<(AngleVar, i8)> = self.terms.iter().copied().filter(|(v, _)| v.group == g).collect();
            let (cg, sg) = (Poly::harmonic(&part, false), Poly::harmonic(&part, true));
            let (cn, sn) = (&(&c * &cg) - &(&s * &sg), &(&s * &cg) + &(&c * &sg));
            (c, s) = (cn, sn);
        }
        Some((c, s))
    }
}

/// The registry of names. Arithmetic never needs it; reading and printing do.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Ring {
    symbols: Vec<String>,
    /// Per group, the names of its angles.
    groups: Vec<Vec<String>>,
}

impl Ring {
    /// An empty registry.
    pub fn new() -> Ring {
        Ring::default()
    }

    /// A new symbol, or the one that has this name.
    pub fn symbol(&mut self, name: &str) -> Symbol {
        match self.find_symbol(name) {
            Some(s) => s,
            None => {
                self.symbols.push(name.to_string());
                Symbol(u16::try_from(self.symbols.len() - 1).unwrap_or(u16::MAX))
            }
        }
    }

    /// A new angle in a group of its own.
    pub fn angle(&mut self, name: &str) -> AngleVar {
        self.groups.push(vec![name.to_string()]);
        AngleVar { group: u16::try_from(self.groups.len() - 1).unwrap_or(u16::MAX), index: 0 }
    }

    /// A new angle in the group of `neighbour`; a group of its own where that group is full (12 angles).
    pub fn angle_parallel_to(&mut self, neighbour: AngleVar, name: &str) -> AngleVar {
        match self.groups.get_mut(usize::from(neighbour.group)) {
            Some(names) if names.len() < GROUP_SIZE => {
                names.push(name.to_string());
                AngleVar { group: neighbour.group, index: (names.len() - 1) as u8 }
            }
            _ => self.angle(name),
        }
    }

    /// The symbol of this name.
    pub fn find_symbol(&self, name: &str) -> Option<Symbol> {
        self.symbols.iter().position(|s| s == name).and_then(|i| u16::try_from(i).ok()).map(Symbol)
    }

    /// The angle of this name.
    pub fn find_angle(&self, name: &str) -> Option<AngleVar> {
        self.angles().find(|v| self.angle_name(*v) == name)
    }

    /// The name of a symbol (empty for one of another ring).
    pub fn symbol_name(&self, s: Symbol) -> &str {
        self.symbols.get(usize::from(s.0)).map_or("", String::as_str)
    }

    /// The name of an angle (empty for one of another ring).
    pub fn angle_name(&self, v: AngleVar) -> &str {
        self.groups.get(usize::from(v.group)).and_then(|g| g.get(usize::from(v.index))).map_or("", String::as_str)
    }

    /// All symbols in order of declaration.
    pub fn symbols(&self) -> impl Iterator<Item = Symbol> + use<> {
        (0..self.symbols.len() as u16).map(Symbol)
    }

    /// All angles, group by group.
    pub fn angles(&self) -> impl Iterator<Item = AngleVar> + '_ {
        self.groups
            .iter()
            .enumerate()
            .flat_map(|(g, names)| (0..names.len()).map(move |i| AngleVar { group: g as u16, index: i as u8 }))
    }
}

impl Poly {
    /// A symbol.
    pub fn symbol(s: Symbol) -> Poly {
        Poly::power(s, 1)
    }

    /// (cosine, sine) of one angle.
    pub fn cos_sin(v: AngleVar) -> (Poly, Poly) {
        (Poly::harmonic(&[(v, 1)], false), Poly::harmonic(&[(v, 1)], true))
    }

    /// An integer.
    pub fn int(n: i64) -> Poly {
        Poly::constant(Rational::int(n))
    }
}
