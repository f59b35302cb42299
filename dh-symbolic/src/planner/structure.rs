//! Geometric structure of an arm: parallel and intersecting axes, common points, and the table cells responsible.

use super::axes::{Axes, numeric};
use crate::algebra::Poly;
use crate::chain::{Chain, Convention};

/// The relation of two neighbouring axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NeighbourAxes {
    /// Parallel, or the same line.
    Parallel,
    /// They meet.
    Meeting,
    /// Neither.
    Skew,
}

/// Neighbouring joints (from 0) and the relation of their axes.
#[derive(Clone, Debug)]
pub struct Neighbours {
    /// The first joint; the second is the next one.
    pub first: usize,
    /// How.
    pub pair: NeighbourAxes,
    /// The cells of the table that cause it: `alpha2 = 0`.
    pub cells: Vec<String>,
}

/// The relations of an arm's axes.
#[derive(Clone, Debug)]
pub struct Structure {
    /// Neighbours in order.
    pub neighbours: Vec<Neighbours>,
    /// First joints of three neighbouring axes through one point.
    pub common_points: Vec<usize>,
}

impl Structure {
    /// Reads the relations off the exact transforms between the axes.
    pub fn new(chain: &Chain, axes: &Axes) -> Structure {
        let mut neighbours = Vec::new();
        // Where on the second axis the first one meets it, lengths over the length scale.
        let mut meeting: Vec<Option<(f64, f64)>> = Vec::new();
        for first in 0..axes.real.saturating_sub(1) {
            let Some((from, to)) = link_of(axes, first).zip(link_of(axes, first + 1)) else { continue };
            let mut t = crate::algebra::Transform::identity();
            for link in &axes.links[from + 1..=to] {
                t = t.times(&link.before);
            }
            let (d, p) = (t.column(2), &t.p);
            let moment = &(&p[0] * &d[1]) - &(&p[1] * &d[0]);
            let parallel = d[0].is_zero() && d[1].is_zero();
            let pair = if parallel {
                NeighbourAxes::Parallel
            } else if moment.is_zero() {
                NeighbourAxes::Meeting
            } else {
                NeighbourAxes::Skew
            };
            neighbours.push(Neighbours { first, pair, cells: cells(chain, first, pair) });
            meeting.push((pair == NeighbourAxes::Meeting).then(|| {
                // z_i s = p + d u: solve in the plane of both.
                let n = numeric(chain, &t, axes.length_scale);
                let k = if n[0][2].abs() > n[1][2].abs() { 0 } else { 1 };
                let u = -n[k][3] / n[k][2];
                (n[2][3] + n[2][2] * u, u)
            }));
        }
        let common_points = meeting
            .windows(2)
            .enumerate()
            .filter(|(_, w)| matches!((w[0], w[1]), (Some((_, u)), Some((s, _))) if (u - s).abs() < 1e-9))
            .map(|(i, _)| neighbours[i].first)
            .collect();
        Structure { neighbours, common_points }
    }
}

fn link_of(axes: &Axes, joint: usize) -> Option<usize> {
    axes.links.iter().position(|h| h.joint == Some(joint))
}

/// The cells between two joints that cause a relation.
fn cells(chain: &Chain, first: usize, pair: NeighbourAxes) -> Vec<String> {
    let (Some(a), Some(b)) = (chain.joints.get(first), chain.joints.get(first + 1)) else { return Vec::new() };
    let rows = match chain.convention {
        Convention::Modified => a.row + 1..b.row + 1,
        Convention::Standard => a.row..b.row,
    };
    let mut list = Vec::new();
    for row in rows {
        let link = &chain.links[row];
        let number = if chain.convention == Convention::Modified { row } else { row + 1 };
        let zero = |p: &Poly| p.is_zero();
        match pair {
            NeighbourAxes::Parallel => {
                let degrees = link.alpha.constant.to_degrees();
                list.push(format!("alpha{number} = {degrees}{}", if degrees.is_zero() { "" } else { " deg" }));
            }
            NeighbourAxes::Meeting if zero(&link.a) => list.push(format!("a{number} = 0")),
            NeighbourAxes::Meeting | NeighbourAxes::Skew => {}
        }
    }
    list
}
