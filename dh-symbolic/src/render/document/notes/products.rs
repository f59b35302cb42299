//! Products of transforms that the reader asks for by name (`--products`), each from the fewest known factors.

use crate::render::formula::products::Splitting;

/// The products that were asked for, in that order; each is made of the fewest factors among rows and products formed before it.
pub(in crate::render) fn asked(n: usize, products: &[(usize, usize)]) -> Vec<Splitting> {
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
        steps.push(Splitting { from, middle, to });
    }
    steps
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
