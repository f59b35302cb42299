//! mdBook: every fenced `dh` block of a book becomes the notes of its table.
//!
//! A preprocessor as mdBook runs it: `[context, book]` comes in as JSON, the book goes out. The info string of a block holds the
//! options of `dh notes` without their dashes, and `source` where the table is to be shown as well:
//!
//! ````markdown
//! ```dh parts=links,forward sines=long lang=zh source
//! pub struct Arm; ...
//! ```
//! ````
//!
//! Formulas are MathML and figures SVG, so that the book needs no script; headings stay Markdown, so that they get their links.

use super::Block;
use super::html;
use super::notes::{Options, notes};
use crate::chain::Chain;
use crate::chain::table::parse;
use crate::diagnostic::lex;
use serde_json::Value;

/// Renderers that understand what the notes are turned into.
pub const RENDERERS: [&str; 1] = ["html"];

/// The book with its notes.
///
/// # Errors
/// Everything that is wrong with the input or with a table, drawn, in the order of the chapters.
pub fn preprocess(input: &str) -> Result<String, String> {
    let parsed: Value =
        serde_json::from_str(input).map_err(|e| format!("error: standard input is not from mdBook: {e}\n"))?;
    let Some([context, book]) = parsed.as_array().map(Vec::as_slice) else {
        return Err("error: standard input is not from mdBook: expected [context, book]\n".into());
    };
    let language = context.pointer("/config/book/language").and_then(Value::as_str).unwrap_or("en");
    let language = if language.starts_with("zh") { "zh" } else { "en" };
    let mut book = book.clone();
    let mut errors = String::new();
    chapters(&mut book, &mut |path, text| match chapter(path, text, language) {
        Ok(new) => Some(new),
        Err(e) => {
            errors.push_str(&e);
            None
        }
    });
    if errors.is_empty() { Ok(format!("{book}\n")) } else { Err(errors) }
}

/// Calls `change` with the path and the text of every chapter, whatever the lists that hold them are called.
fn chapters(value: &mut Value, change: &mut impl FnMut(&str, &str) -> Option<String>) {
    match value {
        Value::Array(list) => list.iter_mut().for_each(|v| chapters(v, change)),
        Value::Object(map) => {
            for (key, inner) in map.iter_mut() {
                if key == "Chapter" {
                    let text = |name: &str| inner.get(name).and_then(Value::as_str).map(str::to_string);
                    let path = text("source_path").or(text("path")).or(text("name")).unwrap_or_default();
                    if let Some(new) = text("content").and_then(|c| change(&path, &c)) {
                        inner["content"] = Value::String(new);
                    }
                }
                chapters(inner, change);
            }
        }
        _ => {}
    }
}

/// A chapter with its `dh` blocks turned into notes.
fn chapter(path: &str, text: &str, language: &str) -> Result<String, String> {
    let mut out = String::new();
    let mut errors = String::new();
    let mut open: Option<Fence> = None;
    for (number, line) in text.split_inclusive('\n').enumerate() {
        match &mut open {
            Some(fence) if fence.closes(line) => match open.take().and_then(|f| f.info.is_some().then_some(f)) {
                Some(fence) => match fence.notes(path, language) {
                    Ok(notes) => out.push_str(&notes),
                    Err(e) => errors.push_str(&e),
                },
                None => out.push_str(line),
            },
            Some(fence) => match &fence.info {
                Some(_) => fence.body.push_str(line),
                None => out.push_str(line),
            },
            None => {
                open = Fence::opens(line, number);
                if open.as_ref().is_none_or(|f| f.info.is_none()) {
                    out.push_str(line);
                }
            }
        }
    }
    if let Some(fence) = open.filter(|f| f.info.is_some()) {
        errors.push_str(&format!("error: the `dh` block is never closed\n --> {path}:{}\n", fence.line + 1));
    }
    if errors.is_empty() { Ok(out) } else { Err(errors) }
}

/// A fenced block of code.
struct Fence {
    mark: char,
    length: usize,
    /// The options of a `dh` block; `None` for a block in another language.
    info: Option<String>,
    body: String,
    /// Line of the opening fence, from 0.
    line: usize,
}

impl Fence {
    fn opens(line: &str, number: usize) -> Option<Fence> {
        let trimmed = line.trim_start_matches(' ');
        let mark = trimmed.chars().next().filter(|c| matches!(c, '`' | '~'))?;
        let length = trimmed.chars().take_while(|c| *c == mark).count();
        if line.len() - trimmed.len() > 3 || length < 3 {
            return None;
        }
        let info = trimmed.get(length..)?.trim();
        let name = info.split([' ', ',']).next()?;
        let info = (name == "dh")
            .then(|| info.get(name.len()..).unwrap_or_default().trim_start_matches(',').trim().to_string());
        Some(Fence { mark, length, info, body: String::new(), line: number })
    }

    fn closes(&self, line: &str) -> bool {
        let trimmed = line.trim();
        trimmed.chars().count() >= self.length && trimmed.chars().all(|c| c == self.mark)
    }

    /// The notes; errors are drawn at their lines of the chapter.
    fn notes(&self, path: &str, language: &str) -> Result<String, String> {
        let at = |message: String| format!("error: {message}\n --> {path}:{}\n", self.line + 1);
        let mut options = Options::default();
        options.set("--lang", language).map_err(at)?;
        let mut source = false;
        for word in self.info.as_deref().unwrap_or_default().split_whitespace() {
            match word.split_once('=') {
                Some((name, value)) => {
                    let known = options.set(&format!("--{name}"), value).map_err(at)?;
                    if !known {
                        return Err(at(format!("no option `{name}` of a `dh` block")));
                    }
                }
                None if word == "source" => source = true,
                None => return Err(at(format!("no option `{word}` of a `dh` block: `name=value`, or `source`"))),
            }
        }
        // as many lines before the table as in the chapter
        let text = format!("{}{}", "\n".repeat(self.line + 1), self.body);
        let mut parsed = parse(lex(&text).map_err(|e| e.draw(&text, path))?);
        let Some(spec) = parsed.spec.take().filter(|_| parsed.errors.is_empty()) else {
            return Err(parsed.errors.draw(&text, path));
        };
        let chain = Chain::new(spec);
        options.check(&chain).map_err(at)?;
        let mut out = String::new();
        if source {
            out.push_str(&format!("```text\n{}\n```\n\n", self.body.trim_end()));
        }
        for block in &notes(&chain, &options).blocks {
            out.push_str(&match block {
                Block::Heading(level, t) => format!("{} {}\n\n", "#".repeat(usize::from(*level) + 1), html::text(t)),
                // an empty line would end the HTML
                other => html::block(other).replace("\n\n", "\n") + "\n",
            });
        }
        Ok(out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ARM: &str = "pub struct Arm;\nconvention = modified;\nlet l1: length = 0.4;\n| alpha | a | d | theta |\n|---|---|---|---|\n| 0 | 0 | 0 | q1 |\n| 0 | l1 | 0 | q2 |\n";

    fn book(content: &str, language: &str) -> String {
        let chapter = serde_json::json!({ "Chapter": { "name": "One", "content": content, "path": "one.md", "sub_items": [
            { "Chapter": { "name": "Two", "content": "plain", "path": "two.md", "sub_items": [] } }] } });
        serde_json::json!([{ "root": ".", "config": { "book": { "language": language } }, "renderer": "html" },
            { "sections": [chapter, "Separator"], "__non_exhaustive": null }])
        .to_string()
    }

    fn content(out: &str) -> String {
        let book: Value = serde_json::from_str(out).expect("JSON");
        book["sections"][0]["Chapter"]["content"].as_str().expect("text").to_string()
    }

    #[test]
    fn blocks_become_notes() {
        let text = format!("# Arms\n\n```rust\nlet dh = 1;\n```\n\n```dh parts=links,forward\n{ARM}```\n\nEnd.\n");
        let out = content(&preprocess(&book(&text, "en")).expect("a book"));
        assert!(out.starts_with("# Arms\n\n```rust\nlet dh = 1;\n```\n\n## Link transforms\n\n<p>"), "{out}");
        assert!(out.contains("<math") && out.contains("## Forward kinematics") && out.ends_with("\n\nEnd.\n"), "{out}");
        assert!(!out.contains("Jacobian") && !out.contains("```dh"), "{out}");
        let zh = content(&preprocess(&book(&text, "zh-CN")).expect("a book"));
        assert!(zh.contains("正运动学"), "{zh}");
        let both = content(&preprocess(&book(&format!("~~~dh,source lang=en\n{ARM}~~~"), "zh")).expect("a book"));
        assert!(both.starts_with("```text\npub struct Arm;") && both.contains("## Forward kinematics"), "{both}");
        let plain = book("nothing here", "en");
        let same: Value = serde_json::from_str(&preprocess(&plain).expect("a book")).expect("JSON");
        assert_eq!(same, serde_json::from_str::<Value>(&plain).expect("JSON")[1]);
    }

    #[test]
    fn errors_are_drawn_at_their_lines() {
        let wrong = format!("Text\n\n```dh\n{}```\n", ARM.replace("| l1 |", "| l7 |"));
        let error = preprocess(&book(&wrong, "en")).expect_err("a wrong cell");
        assert!(error.contains("one.md:10:7") && error.contains("^^"), "{error}");
        for (text, part) in [
            (format!("```dh parts=tables\n{ARM}```\n"), "one of table"),
            (format!("```dh colour=red\n{ARM}```\n"), "no option `colour`"),
            (format!("```dh loud\n{ARM}```\n"), "no option `loud`"),
            (format!("```dh\n{ARM}"), "never closed"),
        ] {
            let error = preprocess(&book(&text, "en")).expect_err("a wrong block");
            assert!(error.contains(part) && error.contains("one.md:1"), "{error}");
        }
        for input in ["", "{}", "[1]", "[1, 2, 3]"] {
            assert!(preprocess(input).expect_err("no book").contains("not from mdBook"));
        }
    }
}
