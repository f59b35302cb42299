//! In which order the link transforms are multiplied on the blackboard.

use crate::chain::{Chain, Convention};

/// T(from, to) = T(from, middle) T(middle, to).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Step {
    pub(super) from: usize,
    pub(super) middle: usize,
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
        steps.extend((a + 2..=b).map(|to| Step { from: a, middle: to - 1, to }));
        if tail.is_some() {
            steps.push(Step { from: a, middle: b, to: n });
        }
        tail = Some(a);
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
