//! Readable variable names for generated code: s1, c23, c4s5, field names.

use crate::algebra::{LinearAngle, Ring};

/// The subscript of an angle sum: `1`, `23`, `2m3`, `2_beta`.
pub(super) fn subscript(ring: &Ring, angle_sum: &LinearAngle) -> String {
    let mut out = String::new();
    for (v, k) in &angle_sum.terms {
        let name = ring.angle_name(*v);
        let tail = name.strip_prefix("theta").or_else(|| name.strip_prefix('q')).unwrap_or(name);
        let number = tail.bytes().all(|b| b.is_ascii_digit());
        if *k < 0 {
            out.push('m');
        }
        if !number || tail.len() > 1 {
            out.push('_');
        }
        if k.unsigned_abs() > 1 {
            out.push_str(&format!("{}x", k.unsigned_abs()));
        }
        out.push_str(tail);
    }
    if !angle_sum.constant.is_zero() {
        let degrees = angle_sum.constant.to_degrees().to_string().replace('-', "m").replace('/', "over");
        out.push_str(&format!("_{degrees}"));
    }
    out
}

/// Hands out each name once.
#[derive(Default)]
pub(super) struct CodeNames {
    taken: Vec<String>,
}

impl CodeNames {
    pub(super) fn new(reserved: &[&str]) -> CodeNames {
        CodeNames { taken: reserved.iter().map(|s| (*s).to_string()).collect() }
    }

    /// Keeps a name for somebody else.
    pub(super) fn reserve(&mut self, name: &str) {
        if !self.taken.iter().any(|n| n == name) {
            self.taken.push(name.to_string());
        }
    }

    pub(super) fn take(&mut self, wish: &str) -> String {
        let mut name = wish.to_string();
        let mut n = 1;
        while self.taken.contains(&name) {
            n += 1;
            name = format!("{wish}_{n}");
        }
        self.taken.push(name.clone());
        name
    }
}
