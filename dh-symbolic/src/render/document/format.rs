//! The formats that notes can be printed in.

use super::Document;

/// A format that notes can be printed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Plain text with Unicode indices.
    Text,
    /// A LaTeX document.
    Latex,
    /// Markdown with LaTeX formulas between dollar signs.
    Markdown,
    /// A Typst document.
    Typst,
    /// An HTML page with MathML.
    Html,
}

impl Format {
    /// All formats with their names on the command line.
    pub const ALL: [(&'static str, Format); 5] = [
        ("text", Format::Text),
        ("latex", Format::Latex),
        ("markdown", Format::Markdown),
        ("typst", Format::Typst),
        ("html", Format::Html),
    ];
}

impl Document {
    /// The note in a format.
    pub fn print(&self, format: Format) -> String {
        match format {
            Format::Text => super::text::document(self),
            Format::Latex => super::latex::document(self),
            Format::Markdown => super::markdown::document(self),
            Format::Typst => super::typst::document(self),
            Format::Html => super::html::document(self),
        }
    }

    /// Its blocks in a format, to be put into a document of one's own: without title, without what a document begins and ends with.
    pub fn print_body(&self, format: Format) -> String {
        match format {
            Format::Text => super::text::body(self),
            Format::Latex => super::latex::body(self),
            Format::Markdown => super::markdown::body(self),
            Format::Typst => super::typst::body(self),
            Format::Html => super::html::body(self),
        }
    }

    /// The note as Markdown with its figures in files of their own, `stem-1.svg` and so on: the text, and names and texts of these
    /// files. (Markdown from [`print`](Self::print) carries them inside, where not every reader shows them.)
    pub fn linked_markdown(&self, stem: &str) -> (String, Vec<(String, String)>) {
        super::markdown::linked(self, stem)
    }
}
