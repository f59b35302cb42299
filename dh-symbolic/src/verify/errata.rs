//! Writes an errata page for a set of hand derivations: wrong lines with their corrections, and lines that need a condition.

use super::report::{condition_text, line_report, ratio_text, remarks, verdict_word};
use crate::verify::check::{FaultKind, Report, Verdict};
use crate::verify::language::{Derivation, Line};
use std::fmt::Write;

/// One file of claims, checked.
#[derive(Clone, Copy, Debug)]
pub struct Page<'a> {
    /// Name of the file, without folder.
    pub file: &'a str,
    /// The lines.
    pub derivation: &'a Derivation,
    /// The verdicts.
    pub report: &'a Report,
}

/// A line that was printed: its note is `[id] document, where`, perhaps followed by `Correct: ...` in words.
struct Printed<'a> {
    page: &'a Page<'a>,
    line: &'a Line,
    verdict: &'a Verdict,
    id: &'a str,
    document: &'a str,
    place: &'a str,
    /// What the note adds in words.
    words: Option<&'a str>,
}

fn printed<'a>(page: &'a Page<'a>) -> impl Iterator<Item = Printed<'a>> {
    page.derivation.lines.iter().zip(&page.report.verdicts).filter_map(move |(line, verdict)| {
        let (id, rest) = line.note.strip_prefix('[')?.split_once("] ")?;
        let (rest, words) = rest.split_once(" Correct: ").map_or((rest, None), |(r, w)| (r, Some(w)));
        let (document, place) = rest.split_once(", ").unwrap_or(("", rest));
        Some(Printed { page, line, verdict, id, document, place, words })
    })
}

/// The errata page as Markdown. Lines are ordered by document, then by file and line. `reviewed` is appended: Markdown with the
/// lines that only a reader can judge.
pub fn errata(pages: &[Page<'_>], reviewed: &str) -> String {
    let mut lines: Vec<Printed<'_>> = pages.iter().flat_map(printed).collect();
    lines.sort_by_key(|p| p.document);
    let count = |word: &str| lines.iter().filter(|p| verdict_word(p.verdict) == word).count();
    let mut out = String::from("# Errata\n\n");
    let _ = writeln!(
        out,
        "Every line below was printed in a lecture document, written down as a claim about a robot's table, and checked in exact \
         algebra: {} claims, of which {} are proven for all values of their variables, {} agree to the printed digits, {} are wrong \
         and {} mean nothing as they stand.\n",
        lines.len(),
        count("proven"),
        count("agrees"),
        count("wrong"),
        count("unclear"),
    );
    out.push_str("## Wrong lines\n\n");
    for p in lines.iter().filter(|p| matches!(p.verdict, Verdict::Wrong(_) | Verdict::NotUnderstood(..))) {
        wrong(&mut out, p);
    }
    out.push_str(
        "## Lines that need a condition\n\nTrue, but only where the condition holds: the page should say so.\n\n",
    );
    for p in &lines {
        if let Verdict::Proven(w) = p.verdict
            && !w.is_everywhere()
        {
            let all: Vec<String> =
                w.conditions.iter().map(|c| format!("`{}`", condition_text(p.page.report, c))).collect();
            let _ = writeln!(
                out,
                "- **{}**, {} (`{}`): `{}` holds where {}.",
                p.document,
                p.place,
                p.id,
                p.page.derivation.text(&p.line.place),
                all.join(" and ")
            );
        }
    }
    let reviewed = reviewed.trim().replace("\n## ", "\n### ");
    if !reviewed.is_empty() {
        let _ = write!(out, "\n{}\n", reviewed.replacen("# ", "## ", 1));
    }
    out
}

/// One wrong line: where, as printed, corrected, the difference.
fn wrong(out: &mut String, p: &Printed<'_>) {
    let (d, report) = (p.page.derivation, p.page.report);
    let _ = writeln!(out, "### {}: {}\n", p.document, p.place);
    let _ = writeln!(out, "`{}` in `{}`\n", p.id, p.page.file);
    let block = line_report(report, d, p.line, p.verdict);
    let _ = writeln!(out, "```text\n{}```\n", block);
    if let Some(words) = p.words {
        let _ = writeln!(out, "Correct: {words}\n");
    } else if let Some(text) = corrected(p) {
        let _ = writeln!(out, "Correct: `{text}`\n");
    }
}

/// The corrected line: with its repairs, or with the correct formula where the whole right side is a formula.
fn corrected(p: &Printed<'_>) -> Option<String> {
    let (d, report) = (p.page.derivation, p.page.report);
    let mut repair = crate::verify::check::Repair { edits: vec![] };
    match p.verdict {
        Verdict::Wrong(faults) => {
            if let [fault] = faults.as_slice()
                && fault.repair.is_none()
                && let FaultKind::Formula { correct, .. } = &fault.kind
            {
                return Some(ratio_text(report, correct));
            }
            for m in faults.iter().filter_map(|f| f.repair.as_ref()) {
                repair.edits.extend(m.edits.iter().filter(|e| !repair.edits.contains(e)).cloned().collect::<Vec<_>>());
            }
        }
        Verdict::NotUnderstood(_, Some(m)) => repair = m.clone(),
        _ => {}
    }
    let open = remarks(report, d, p.verdict).iter().any(|r| r.repair.is_none());
    if repair.edits.is_empty()
        || (open && matches!(p.verdict, Verdict::Wrong(f) if f.len() > 1 && f.iter().any(|x| x.entry.is_none())))
    {
        return None;
    }
    repair.edits.sort_by_key(|e| e.place.start);
    Some(crate::verify::language::line_text(&repair.apply(&d.tokens, &p.line.place)).0)
}
