//! Suggestions for misspelt words.

/// The candidate that the text was probably meant to be: at most two slips (a letter left out, put in, changed, or two
/// neighbours swapped), and fewer slips than half its length.
pub(super) fn suggestion<'a>(text: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let most = (text.chars().count() / 2).min(2);
    candidates
        .into_iter()
        .map(|c| (distance(&text.to_lowercase(), c), c))
        .filter(|(d, _)| *d <= most)
        .min_by_key(|(d, _)| *d)
        .map(|(_, c)| c)
}

/// A word for a message: control characters escaped, no longer than 40 letters.
pub(super) fn shown(word: &str) -> String {
    let end = if word.chars().count() > 40 { "..." } else { "" };
    let start: String = word.chars().take(40).collect();
    format!("{}{end}", start.escape_debug())
}

/// Number of slips between two words (optimal string alignment); words longer than 40 letters are far from all others.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().take(41).collect(), b.chars().take(41).collect());
    if a.len() > 40 || b.len() > 40 {
        return usize::MAX;
    }
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let change = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = change.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            row.push(best);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_counted() {
        let pairs = [("tehta", "theta", 1), ("theta", "theta", 0), ("alfa", "alpha", 2), ("", "ab", 2)];
        for (a, b, d) in pairs {
            assert_eq!(distance(a, b), d, "{a} {b}");
        }
        let columns = ["joint", "alpha", "a", "d", "theta", "range"];
        assert_eq!(suggestion("tehta", columns), Some("theta"));
        assert_eq!(suggestion("Alpha", columns), Some("alpha"));
        assert_eq!(suggestion("b", columns), None, "one letter is not enough to guess from");
    }
}
