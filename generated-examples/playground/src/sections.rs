//! A document cut at its headings, each piece in every format: what the page shows with buttons to copy it.

use dh_symbolic::render::document::Block;
use dh_symbolic::{Document, Format};
use serde_json::{Value, json};

/// A document in every format that the page offers; flow charts, which a browser does not draw, are left out of the HTML.
pub(crate) fn formats(document: &Document) -> Value {
    let chart = |b: &&Block| !matches!(b, Block::Code("mermaid", _));
    let shown = Document { blocks: document.blocks.iter().filter(chart).cloned().collect(), ..document.clone() };
    json!({
        "html": shown.print_body(Format::Html),
        "latex": document.print_body(Format::Latex),
        "typst": document.print_body(Format::Typst),
        "markdown": document.print_body(Format::Markdown),
    })
}

/// The pieces between headings, each with the heading that it stands under.
pub(crate) fn sections(document: &Document) -> Vec<Value> {
    let mut pieces: Vec<Vec<Block>> = Vec::new();
    for block in &document.blocks {
        match pieces.last_mut() {
            Some(piece) if !matches!(block, Block::Heading(..)) => piece.push(block.clone()),
            _ => pieces.push(vec![block.clone()]),
        }
    }
    let only = |blocks: Vec<Block>| formats(&Document { blocks, ..document.clone() });
    pieces.into_iter().map(only).collect()
}
