//! The order in which the notes multiply the link transforms, and the numbers of the equations this gives.

use crate::chain::{Chain, Convention};

/// T(from, to) is the product of what lies between these frames: mostly T(from, middle) T(middle, to).
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::render) struct Splitting {
    pub(in crate::render) from: usize,
    pub(in crate::render) middle: Vec<usize>,
    pub(in crate::render) to: usize,
}

/// From the tip to the base; links with parallel axes are multiplied among themselves before they join the rest, so that
/// c2 c3 - s2 s3 = c23 happens in a small matrix. For a PUMA: 4T6, 3T6, 1T3, 1T6, 0T6.
pub(in crate::render) fn steps(chain: &Chain) -> Vec<Splitting> {
    let n = chain.links.len();
    // Frames where one run of parallel axes ends and the next begins.
    let mut cuts = vec![0];
    cuts.extend((1..n).filter(|i| !parallel(chain, *i)));
    cuts.push(n);
    let mut steps = Vec::new();
    let mut tail: Option<usize> = None;
    for run in cuts.windows(2).rev() {
        let &[a, b] = run else { continue };
        steps.extend((a + 2..=b).map(|to| Splitting { from: a, middle: vec![to - 1], to }));
        if tail.is_some() {
            steps.push(Splitting { from: a, middle: vec![b], to: n });
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
