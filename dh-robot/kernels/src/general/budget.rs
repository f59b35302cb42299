//! How much the elimination may compute for one target: bounded by constants, or as much as it takes.

/// The bounds of one call.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// Eliminations.
    pub(super) eliminations: u32,
    /// Newton steps that bring what they find onto the target.
    pub(super) steps: u32,
    /// Whether neighbours of degenerate roots are tried, and poses in many directions from a singular one.
    pub(super) thorough: bool,
}

impl Budget {
    /// What a controller can wait for. At a singular pose the target's two neighbours are asked.
    pub const BOUNDED: Self = Self { eliminations: 5, steps: 300, thorough: false };
    /// A search without a bound on its time.
    pub const THOROUGH: Self = Self { eliminations: u32::MAX, steps: u32::MAX, thorough: true };

    /// Takes one elimination, if one is left.
    pub(super) fn eliminate(&mut self) -> bool {
        let left = self.eliminations > 0;
        self.eliminations = self.eliminations.saturating_sub(1);
        left
    }
}
