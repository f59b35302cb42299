//! Texts that a notebook shows as what they are: notes, plans, the interactive page.

use dh_symbolic::{Format, InversePlan, Language};
use pyo3::prelude::*;

/// A lecture note as text. `str(notes)` is the text; a notebook shows notes in Markdown and in HTML as such.
#[pyclass(frozen, str, module = "dhkin")]
pub(crate) struct Notes {
    pub(crate) text: String,
    pub(crate) format: Format,
}

impl std::fmt::Display for Notes {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.text)
    }
}

#[pymethods]
impl Notes {
    /// The text.
    #[getter]
    fn text(&self) -> &str {
        &self.text
    }

    /// Writes the text to a file.
    fn save(&self, path: std::path::PathBuf) -> PyResult<()> {
        Ok(std::fs::write(path, &self.text)?)
    }

    fn _repr_markdown_(&self) -> Option<&str> {
        (self.format == Format::Markdown).then_some(&self.text)
    }

    fn _repr_html_(&self) -> Option<String> {
        (self.format == Format::Html).then(|| frame(&self.text, 600))
    }

    fn __len__(&self) -> usize {
        self.text.chars().count()
    }

    fn __contains__(&self, part: &str) -> bool {
        self.text.contains(part)
    }

    fn __repr__(&self) -> String {
        format!("Notes({} characters of {:?})", self.__len__(), self.format)
    }
}

/// An interactive page of an arm: one HTML file that needs no network. A notebook shows it in place.
#[pyclass(frozen, str, module = "dhkin")]
pub(crate) struct Page {
    pub(crate) html: String,
    pub(crate) height: u32,
}

impl std::fmt::Display for Page {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.html)
    }
}

#[pymethods]
impl Page {
    /// The file's text.
    #[getter]
    fn html(&self) -> &str {
        &self.html
    }

    /// Writes the file.
    fn save(&self, path: std::path::PathBuf) -> PyResult<()> {
        Ok(std::fs::write(path, &self.html)?)
    }

    fn _repr_html_(&self) -> String {
        frame(&self.html, self.height)
    }

    fn __repr__(&self) -> String {
        format!("Page({} characters)", self.html.len())
    }
}

/// A page in a frame of its own, so that its styles and scripts are its own.
fn frame(html: &str, height: u32) -> String {
    let text = html.replace('&', "&amp;").replace('"', "&quot;");
    format!("<iframe srcdoc=\"{text}\" style=\"width: 100%; height: {height}px; border: 0\"></iframe>")
}

/// How an arm is inverted, step by step.
#[pyclass(frozen, str, module = "dhkin")]
pub(crate) struct Plan {
    pub(crate) plan: InversePlan,
}

impl std::fmt::Display for Plan {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.plan.fmt(f)
    }
}

#[pymethods]
impl Plan {
    /// The most solutions that a target can have.
    #[getter]
    fn max_solutions(&self) -> usize {
        self.plan.max_solutions()
    }

    /// The plan as a graph in the language of mermaid.
    #[getter]
    fn mermaid(&self) -> String {
        self.plan.mermaid(Language::English)
    }

    fn _repr_markdown_(&self) -> String {
        self.plan.document(Language::English).print(Format::Markdown)
    }

    fn __len__(&self) -> usize {
        self.plan.steps().len()
    }

    fn __repr__(&self) -> String {
        self.plan.to_string()
    }
}
