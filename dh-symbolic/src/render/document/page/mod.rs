//! The interactive page: one HTML file with sliders, the drawn arm, its pose, its formulas and all solutions; needs no network.
//!
//! The numbers come from the programs that the Rust backend prints, printed as [JavaScript](crate::render::code::javascript).

mod words;

use super::Block;
use super::html;
use super::notes::{Options, matrices};
use crate::chain::{Chain, Scalar, Settings};
use crate::program::{Disproof, Forward};
use crate::render::code::javascript::{RUNTIME, Solver, class};
use crate::render::{Language, refusal};
use words::{object, words};

/// The page of a robot.
///
/// # Errors
/// Where a program differs from the product of the link transforms: a defect of this crate, never of the table.
pub fn page(chain: &Chain, options: &Options) -> Result<String, Disproof> {
    let language = options.language;
    let numbers = chain.with(Settings { scalar: Scalar::F64, ..chain.settings.clone() });
    let solver = Solver::of(&numbers);
    let arm = class(&numbers, &Forward::derive(&numbers)?, &solver);
    let (how, wanted) = match &solver {
        Solver::Closed(_) => ("closed", true),
        Solver::Numeric => ("numeric", true),
        Solver::Refused(_) => ("unplanned", true),
        Solver::Unwanted => ("unwanted", false),
    };
    let reason = match &solver {
        Solver::Refused(refusal) => {
            let remarks = refusal::remarks(chain, refusal, language);
            let (space, stop) = if language == Language::Chinese { ("", "。") } else { (" ", ".") };
            remarks.iter().map(|r| format!("{space}{}{stop}", r.message.replace('`', ""))).collect()
        }
        _ => String::new(),
    };
    let script = format!(
        "\"use strict\";\n(() => {{\nconst WANTED = {wanted};\n{}{}\n{arm}\n{}\n{}}})();\n",
        object(language),
        RUNTIME.join("\n"),
        include_str!("scene.js"),
        include_str!("page.js"),
    );
    let w = |key: &str| words(key, language);
    let title = html::escape(&w("title").replace("{}", &chain.name));
    let formulas = formulas(chain, options);
    let given = chain
        .settings
        .redundant
        .iter()
        .filter_map(|k| chain.joints.get(*k))
        .map(|j| format!("<p class=\"note\">{}</p>", html::escape(&w("given").replace("{q}", &j.name))));
    let given: String = given.collect();
    let inverse = if wanted {
        format!(
            "<h3 class=\"note\">{}</h3><div id=\"target\"></div><p id=\"count\" aria-live=\"polite\"></p>\n\
             <div class=\"scroll\"><table id=\"solutions\" class=\"numbers\"></table></div><p class=\"note\" id=\"red\">{}</p>{given}",
            w("target"),
            w("red")
        )
    } else {
        String::new()
    };
    Ok(format!(
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
         <style>\n{}</style>\n</head>\n<body>\n<header><h1>{title}</h1><p>{}</p></header>\n<main>\n\
         <div class=\"stack\">\n<section>\n<h2>{}</h2>\n<div class=\"options\"><select id=\"unit\" aria-label=\"{} / {}\">\
         <option value=\"deg\">{}</option><option value=\"rad\">{}</option></select> <button id=\"reset\">{}</button></div>\n\
         <div id=\"joints\"></div>\n</section>\n<section id=\"fields\">\n<h2>{} ({})</h2>\n<div id=\"parameters\"></div>\n</section>\n</div>\n\
         <div class=\"stack\">\n<section>\n<h2>{}</h2>\n<div class=\"options\"><label><input type=\"checkbox\" id=\"frames\" checked> {}</label> \
         <label><input type=\"checkbox\" id=\"ghosts\"> {}</label></div>\n<svg id=\"drawing\" role=\"img\" aria-label=\"{}\"></svg>\n</section>\n\
         <section>\n<h2>{}</h2>\n<div class=\"scroll\"><table id=\"jacobian\" class=\"numbers matrix\"></table></div>\n<p id=\"determinant\" class=\"note\"></p>\n</section>\n</div>\n\
         <div class=\"stack\">\n<section>\n<h2>{}</h2>\n<div class=\"scroll\"><table id=\"pose\" class=\"numbers matrix\"></table></div>\n</section>\n\
         <section>\n<h2>{}</h2>\n<p class=\"note\">{}</p>\n{inverse}\n</section>\n</div>\n</main>\n\
         <section class=\"formulas\">\n<h2>{}</h2>\n{formulas}</section>\n<script>\n{script}</script>\n</body>\n</html>\n",
        language.tag(),
        include_str!("page.css"),
        w("hint"),
        w("joints"),
        w("degrees"),
        w("radians"),
        w("degrees"),
        w("radians"),
        w("reset"),
        w("parameters"),
        html::escape(chain.settings.unit.name),
        w("drawing"),
        w("frames"),
        w("ghosts"),
        w("drawing"),
        w("jacobian"),
        w("pose"),
        w("solutions"),
        w(how).to_string() + &html::escape(&reason),
        w("formulas"),
    ))
}

/// The formulas; of arms with very long ones, products stay products.
fn formulas(chain: &Chain, options: &Options) -> String {
    let mut text = String::new();
    for terms in TERMS {
        let options = Options { terms: terms.min(options.terms), ..options.clone() };
        text = matrices(chain, &options).iter().map(block).collect();
        if text.len() <= ROOM {
            break;
        }
    }
    text
}

/// Longest products written out: the first number that leaves the formulas short enough.
const TERMS: [usize; 4] = [1500, 400, 100, 30];
/// Bytes for formulas, so that a page stays below 300 kB.
const ROOM: usize = 180_000;

/// A block of the notes, one heading level deeper than there.
fn block(b: &Block) -> String {
    match b {
        Block::Heading(level, text) => html::block(&Block::Heading(level + 1, text.clone())),
        other => html::block(other),
    }
}
