//! Link transforms and their products.

use crate::algebra::Transform;
use crate::chain::{Chain, Elementary};

/// The link transforms of a chain in the algebra.
#[derive(Clone, Debug)]
pub struct Kinematics {
    links: Vec<Transform>,
    base: Transform,
    tool: Transform,
}

fn product(factors: &[Elementary]) -> Transform {
    factors.iter().filter(|f| !f.is_identity()).fold(Transform::identity(), |t, f| t.times(&f.transform()))
}

impl Kinematics {
    /// Expands the link transforms.
    pub fn new(chain: &Chain) -> Kinematics {
        Kinematics {
            links: (0..chain.links.len()).map(|i| product(&chain.link_factors(i))).collect(),
            base: product(&chain.base),
            tool: product(&chain.tool),
        }
    }

    /// The transform of link `i`, counted from 1: T(i-1, i).
    pub fn link(&self, i: usize) -> Option<&Transform> {
        self.links.get(i.checked_sub(1)?)
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.links.len()
    }

    /// Whether the table is empty.
    pub fn is_empty(&self) -> bool {
        self.links.is_empty()
    }

    /// T(i, j): frame j seen from frame i, without base and tool. For i > j the inverse. `None` where a frame does not exist.
    ///
    /// The product is formed from the tip towards the base, so that short vectors are multiplied first.
    pub fn transform(&self, i: usize, j: usize) -> Option<Transform> {
        if i > j {
            return Some(self.transform(j, i)?.inverse());
        }
        let links = self.links.get(i..j)?;
        Some(links.iter().rev().fold(Transform::identity(), |t, link| {
            if t == Transform::identity() { link.clone() } else { link.times(&t) }
        }))
    }

    /// The constant transform before the first row.
    pub fn base(&self) -> &Transform {
        &self.base
    }

    /// The constant transform after the last row.
    pub fn tool(&self) -> &Transform {
        &self.tool
    }

    /// Pose of frame `j` in the base: base * T(0, j); the last one with the tool.
    pub fn frame(&self, j: usize) -> Option<Transform> {
        Some(self.base.times(&self.transform(0, j)?))
    }

    /// Pose of the tool in the base: what `forward` computes.
    pub fn pose(&self) -> Transform {
        let mut t = self.tool.clone();
        for link in self.links.iter().rev() {
            t = link.times(&t);
        }
        self.base.times(&t)
    }
}
