//! Substitution of formulas for symbols and angles.

use super::{AngleVar, Factor, LinearAngle, Poly, Symbol};

impl Poly {
    /// Replaces symbols by formulas; those for which `value` gives `None` stay.
    #[must_use]
    pub fn substitute_symbols(&self, value: impl Fn(Symbol) -> Option<Poly>) -> Poly {
        self.terms()
            .iter()
            .map(|(m, c)| {
                let hit = |f: &Factor| matches!(f, Factor::Power(s, _) if value(*s).is_some());
                let mut p = Poly::term(m.filter(|f| !hit(f)), c.clone());
                for f in m.factors() {
                    if let Factor::Power(s, n) = f
                        && let Some(v) = value(s)
                    {
                        p = &p * &v.pow(n);
                    }
                }
                p
            })
            .sum()
    }

    /// Replaces angles by other angles (`None`: stays). `None` where a constant without exact sine would arise.
    pub fn substitute_angles(&self, value: impl Fn(AngleVar) -> Option<LinearAngle>) -> Option<Poly> {
        let mut parts = Vec::new();
        for (m, c) in self.terms() {
            let hit = |f: &Factor| match f {
                Factor::Cos(t) | Factor::Sin(t) => t.iter().any(|(v, _)| value(*v).is_some()),
                _ => false,
            };
            let mut p = Poly::term(m.filter(|f| !hit(f)), c.clone());
            for f in m.factors().filter(hit) {
                let (Factor::Cos(t) | Factor::Sin(t)) = &f else { continue };
                let mut sum = LinearAngle::constant(super::Angle::ZERO);
                for (v, k) in t {
                    let part = value(*v).unwrap_or_else(|| LinearAngle::var(*v));
                    sum.constant = sum.constant.plus(&part.constant.times(&i64::from(*k).into()));
                    for (w, n) in part.terms {
                        sum.terms.push((w, n.saturating_mul(*k)));
                    }
                }
                let (cosine, sine) = sum.cos_sin()?;
                p = &p * if matches!(f, Factor::Cos(_)) { &cosine } else { &sine };
            }
            parts.push(p);
        }
        Some(parts.into_iter().sum())
    }
}
