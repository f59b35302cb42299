//! In which order the link transforms are multiplied on the blackboard.

use crate::chain::{Chain, Convention};

/// T(from, to) is the product of what lies between these frames: mostly T(from, middle) T(middle, to).
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Step {
    pub(super) from: usize,
    pub(super) middle: Vec<usize>,
    pub(super) to: usize,
}

/// From the tip to the base; links with parallel axes are multiplied among themselves before they join the rest, so that
/// c2 c3 - s2 s3 = c23 happens in a small matrix. For a PUMA: 4T6, 3T6, 1T3, 1T6, 0T6.
pub(super) fn steps(chain: &Chain) -> Vec<Step> {
    let n = chain.links.len();
    // Frames where one run of parallel axes ends and the next begins.
    let mut cuts = vec![0];
    cuts.extend((1..n).filter(|i| !parallel(chain, *i)));
    cuts.push(n);
    let mut steps = Vec::new();
    let mut tail: Option<usize> = None;
    for run in cuts.windows(2).rev() {
        let &[a, b] = run else { continue };
        steps.extend((a + 2..=b).map(|to| Step { from: a, middle: vec![to - 1], to }));
        if tail.is_some() {
            steps.push(Step { from: a, middle: vec![b], to: n });
        }
        tail = Some(a);
    }
    steps
}

/// Numbers of the equations of the pose and of the Jacobian in a note with all its parts.
pub(in crate::render) fn equation_numbers(chain: &Chain) -> (usize, usize) {
    let (base, tool) = (!chain.base.is_empty(), !chain.tool.is_empty());
    // One row in general, all rows, the products; base, tool and the product with them.
    let constants = usize::from(base) + usize::from(tool) + usize::from(base || tool);
    let pose = 1 + chain.links.len() + steps(chain).len() + constants;
    (pose, pose + 1)
}

/// The products that were asked for, in that order; each is made of the fewest factors among rows and products formed before it.
pub(super) fn asked(n: usize, products: &[(usize, usize)]) -> Vec<Step> {
    let mut known: Vec<(usize, usize)> = (0..n).map(|i| (i, i + 1)).collect();
    let mut steps = Vec::new();
    for (from, to) in products.iter().copied().filter(|(i, j)| i < j && *j <= n) {
        // Fewest factors from `from` to every frame, and the frame before it.
        let mut best: Vec<Option<(usize, usize)>> = vec![None; n + 1];
        if let Some(place) = best.get_mut(from) {
            *place = Some((0, from));
        }
        for j in from + 1..=to {
            let ways = known.iter().filter(|(i, k)| *k == j && *i >= from && (*i, *k) != (from, to));
            let way = ways.filter_map(|(i, _)| Some((best.get(*i)?.as_ref()?.0 + 1, *i))).min();
            if let (Some(way), Some(place)) = (way, best.get_mut(j)) {
                *place = Some(way);
            }
        }
        let mut middle = Vec::new();
        let mut at = to;
        while let Some(Some((_, before))) = best.get(at).filter(|_| at > from) {
            at = *before;
            if at > from {
                middle.push(at);
            }
        }
        middle.reverse();
        known.push((from, to));
        steps.push(Step { from, middle, to });
    }
    steps
}

/// Is the axis of row `i` (from 1) parallel to that of row i + 1?
fn parallel(chain: &Chain, i: usize) -> bool {
    let row = match chain.convention {
        Convention::Modified => i,
        Convention::Standard => i - 1,
    };
    chain.links.get(row).is_some_and(|l| {
        l.alpha.terms.is_empty() && l.alpha.constant.steps_of_15_degrees().is_some_and(|n| n % 12 == 0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_use_those_before_them() {
        let steps = asked(6, &[(4, 6), (3, 6), (1, 3), (0, 6), (0, 2)]);
        let middle: Vec<&[usize]> = steps.iter().map(|s| &s.middle[..]).collect();
        assert_eq!(middle, [&[5][..], &[4], &[2], &[1, 3], &[1]]);
        assert_eq!(asked(3, &[(0, 3)])[0].middle, [1, 2]);
        assert!(asked(3, &[(0, 4), (2, 2)]).is_empty());
    }
}
