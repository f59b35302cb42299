//! The parts of a document that hold formulas.

use super::ascii_matrices;
use super::names::DocumentNames;
use super::tables::{DISPLAYS, relation};

/// Longest stretch of formulas, in characters.
pub(super) const LONGEST: usize = 100_000;
/// Characters that are looked at in search of the ends of formulas.
const SEARCHED: usize = 40_000_000;

/// A stretch of formulas.
#[derive(Debug)]
pub(super) struct Region {
    /// The characters with their lines, from 1.
    pub(super) text: Vec<(char, usize)>,
    /// Plain text: letters in a row are words.
    pub(super) plain: bool,
    /// Found between sentences: what cannot be read is a sentence.
    pub(super) loose: bool,
}

/// All regions, in order.
pub(super) fn split(text: &str, names: &DocumentNames<'_>) -> Vec<Region> {
    let marked =
        text.contains('$') || text.contains("```math") || ["\\[", "\\(", "\\begin{"].iter().any(|m| text.contains(m));
    if marked { Marked::new(text).regions(names) } else { plain(&numbered(ascii_matrices::flatten(text)), names) }
}

fn numbered(lines: Vec<String>) -> Vec<(usize, String)> {
    lines.into_iter().enumerate().map(|(k, l)| (k + 1, l)).collect()
}

/// A document with marked formulas.
struct Marked {
    text: Vec<(char, usize)>,
    at: usize,
    out: Vec<Region>,
    /// Lines outside of formulas.
    outside: Vec<(usize, String)>,
    /// Lines that hold a mark.
    touched: Vec<usize>,
    /// Characters looked at so far in search of ends.
    searched: usize,
}

impl Marked {
    fn new(text: &str) -> Marked {
        let latex = text.contains("\\documentclass") || text.contains("\\begin{document}");
        let start = text.find("\\begin{document}").map_or(0, |i| text[..i].lines().count().saturating_sub(1));
        let mut chars = Vec::new();
        let mut fenced = false;
        let mut formulas = false;
        for (k, line) in text.lines().enumerate() {
            let fence = line.trim_start().starts_with("```")
                || line.contains("\\begin{verbatim}")
                || line.contains("\\end{verbatim}");
            // ```math is a display
            if fence && !fenced && (formulas || line.trim() == "```math") {
                formulas = !formulas;
                chars.extend([('$', k + 1), ('$', k + 1), ('\n', k + 1)]);
                continue;
            }
            fenced ^= fence;
            if k >= start && !fence && !fenced {
                let line = if latex { without_comment(line) } else { line };
                chars.extend(line.chars().map(|c| (c, k + 1)));
            }
            chars.push(('\n', k + 1));
        }
        let chars = super::macros::expand(chars);
        Marked { text: chars, at: 0, out: Vec::new(), outside: Vec::new(), touched: Vec::new(), searched: 0 }
    }

    fn rest_is(&self, at: usize, mark: &str) -> bool {
        mark.chars().enumerate().all(|(k, c)| self.text.get(at + k).is_some_and(|t| t.0 == c))
    }

    fn find(&mut self, from: usize, mark: &str, within_paragraph: bool) -> Option<usize> {
        let mut k = from;
        while k < self.text.len().min(from + 2 * LONGEST) && self.searched < SEARCHED {
            self.searched += 1;
            if within_paragraph && self.rest_is(k, "\n\n") {
                return None;
            }
            if self.rest_is(k, mark) && !(mark.starts_with('$') && k > 0 && self.text[k - 1].0 == '\\') {
                return Some(k);
            }
            k += 1;
        }
        None
    }

    /// The closing mark of what opens here, the length of the opening mark, and whether it is a display.
    fn opening(&self) -> Option<(String, usize, bool)> {
        for (open, close, display) in
            [("$$", "$$", true), ("$`", "`$", false), ("$", "$", false), ("\\[", "\\]", true), ("\\(", "\\)", false)]
        {
            if self.rest_is(self.at, open) {
                return Some((close.into(), open.len(), display));
            }
        }
        for name in DISPLAYS {
            for star in ["", "*"] {
                let open = format!("\\begin{{{name}{star}}}");
                if self.rest_is(self.at, &open) {
                    return Some((format!("\\end{{{name}{star}}}"), open.len(), true));
                }
            }
        }
        None
    }

    fn regions(mut self, names: &DocumentNames<'_>) -> Vec<Region> {
        let mut line = String::new();
        while let Some(&(c, number)) = self.text.get(self.at) {
            let opening = if c == '$' || c == '\\' { self.opening() } else { None };
            let found = opening.and_then(|(close, length, display)| {
                let from = self.at + length;
                Some((from, self.find(from, &close, !display)?, close.len(), display))
            });
            if let Some((from, to, length, display)) = found {
                let text: Vec<(char, usize)> = self.text.get(from..to).unwrap_or_default().to_vec();
                let last = self.text.get(to).map_or(number, |t| t.1);
                self.touched.extend(number..=last);
                self.out.push(Region { text, plain: false, loose: !display });
                self.at = to + length;
                continue;
            }
            if c == '\n' {
                self.outside.push((number, std::mem::take(&mut line)));
            } else {
                line.push(c);
            }
            // `\$` is a sign of the text
            self.at += if c == '\\' { 2 } else { 1 };
        }
        self.touched.sort_unstable();
        self.outside.retain(|(n, _)| self.touched.binary_search(n).is_err());
        let mut loose = plain(&self.outside, names);
        loose.iter_mut().for_each(|r| r.loose = true);
        self.out.extend(loose);
        self.out.sort_by_key(|r| r.text.first().map_or(0, |t| t.1));
        self.out
    }
}

fn without_comment(line: &str) -> &str {
    let bytes = line.as_bytes();
    let comment = |i: &usize| bytes[*i] == b'%' && (*i == 0 || bytes[i - 1] != b'\\');
    (0..bytes.len()).find(comment).map_or(line, |i| &line[..i])
}

/// Lines of plain text that hold formulas; lines without a gap between them belong together.
fn plain(lines: &[(usize, String)], names: &DocumentNames<'_>) -> Vec<Region> {
    let mut out: Vec<Region> = Vec::new();
    let mut open = false;
    // indentation of the sentence before, where there is no gap
    let mut sentence: Option<usize> = None;
    // indentation of the item of a list that is open
    let mut item: Option<usize> = None;
    for (number, line) in lines {
        let trimmed = without_number(line.trim());
        let indent = line.chars().take_while(|c| c.is_whitespace()).count();
        let chars = |text: &str| text.chars().map(|c| (c, *number)).collect::<Vec<_>>();
        if item.is_some_and(|i| indent > i) && !trimmed.is_empty() {
            // a sentence that goes on
            (open, sentence) = (false, Some(indent));
            continue;
        }
        item = line.trim_start().starts_with('•').then_some(indent);
        let signed = trimmed.starts_with(['+', '-', '−', '=', '≈', '·', '*', '±']);
        let continues =
            open && out.last().is_some_and(|r| !r.loose && r.text.len() < LONGEST && (signed || unbalanced(r)));
        let found = formula(trimmed, names).map(|(text, after_words)| {
            // a list that was broken into lines
            let wrapped = sentence.is_some_and(|s| indent <= s) && before_relation(text).contains([',', '，']);
            (text, after_words || wrapped)
        });
        let fresh = found.filter(|(text, _)| continues || !before_relation(text).is_empty());
        match (out.last_mut().filter(|_| open), fresh) {
            (Some(last), None) if continues => {
                last.text.push((' ', *number));
                last.text.extend(chars(trimmed));
                continue;
            }
            (Some(last), Some((text, false))) if !last.loose => {
                last.text.push((if continues { ' ' } else { '\n' }, *number));
                last.text.extend(chars(text));
                continue;
            }
            (_, Some((text, loose))) => {
                out.push(Region { text: chars(text), plain: true, loose });
                open = true;
                sentence = loose.then_some(indent);
            }
            _ => {
                open = false;
                sentence = (!trimmed.is_empty()).then_some(indent);
            }
        }
    }
    out
}

fn before_relation(text: &str) -> &str {
    let relations = |c: char| relation(c.encode_utf8(&mut [0; 4])).is_some();
    text.find(relations).and_then(|k| text.get(..k)).unwrap_or(text)
}

fn unbalanced(r: &Region) -> bool {
    let line = r.text.iter().rev().take_while(|t| t.0 != '\n');
    let count = |marks: &str| line.clone().filter(|t| marks.contains(t.0)).count();
    count("([{") > count(")]}")
}

/// Without the number of the equation at the end: `   (12)`.
fn without_number(line: &str) -> &str {
    let digits = |t: &str| !t.is_empty() && t.chars().all(|c| c.is_ascii_digit() || c == '.');
    match line.rsplit_once("  (") {
        Some((head, tail)) if tail.strip_suffix(')').is_some_and(digits) => head.trim_end(),
        _ => line,
    }
}

/// The part of a line that may be a formula, and whether words stand before it.
fn formula<'a>(line: &'a str, names: &DocumentNames<'_>) -> Option<(&'a str, bool)> {
    let relations = |c: char| relation(c.encode_utf8(&mut [0; 4])).is_some();
    let first = line.find(relations)?;
    let mut start = 0;
    let mut word = 0;
    let left = &line[..first];
    for (i, c) in left.char_indices().chain([(left.len(), ' ')]) {
        let wide = !c.is_ascii()
            && c.is_alphabetic()
            && crate::render::formula::greek::name(c).is_none()
            && super::tables::script(c).is_none();
        if c.is_ascii_alphabetic() {
            continue;
        }
        if word < i && !names.is_word(&left[word..i]) {
            start = i;
        }
        if wide || matches!(c, ':' | '：' | '•') {
            start = i + c.len_utf8();
        }
        word = i + c.len_utf8();
    }
    let formula = line.get(start..)?.trim_start_matches([',', ' ', '.', ':', ';']);
    let loose = start > 0;
    let formula = if loose { until_words(formula, names) } else { formula };
    (!formula.is_empty()).then_some((formula, loose))
}

/// The beginning up to the next word that is no formula.
fn until_words<'a>(text: &'a str, names: &DocumentNames<'_>) -> &'a str {
    let mut word = 0;
    for (i, c) in text.char_indices().chain([(text.len(), ' ')]) {
        if c.is_ascii_alphabetic() {
            continue;
        }
        let run = text.get(word..i).unwrap_or_default();
        if !run.is_empty() && !names.is_word(run) {
            return text.get(..word).unwrap_or_default().trim_end_matches([' ', ',', '.', ';']);
        }
        word = i + c.len_utf8();
    }
    text
}
