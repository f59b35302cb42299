//! Drawings as SVG: one element, without style sheet, as browsers and Typst read it.

use super::mathml::escape;
use crate::render::document::figure::{Color, Drawing, LETTER, Pen, Shape, tenths};
use crate::render::formula::math::{Math, Sign};

/// The drawing as an `svg` element; its size is in points.
pub fn element(d: &Drawing, title: &str) -> String {
    let [w, h] = d.size;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}pt\" height=\"{1}pt\" viewBox=\"0 0 {0} {1}\" role=\"img\" \
         stroke-linecap=\"round\" stroke-linejoin=\"round\" font-family=\"Latin Modern Math, STIX Two Text, New Computer Modern, Times New Roman, serif\" font-size=\"{LETTER}\">\n",
        tenths(w),
        tenths(h)
    );
    if !title.is_empty() {
        out.push_str(&format!("<title>{}</title>\n", escape(title)));
    }
    for shape in &d.shapes {
        out.push_str(&line(shape));
    }
    out.push_str("</svg>\n");
    out
}

fn line(shape: &Shape) -> String {
    match shape {
        Shape::Line(points, pen) => {
            format!("<polyline points=\"{}\" fill=\"none\"{}/>\n", list(points), edge(Some(*pen)))
        }
        Shape::Area(points, fill, pen) => {
            format!("<polygon points=\"{}\" fill=\"{}\"{}/>\n", list(points), color(*fill), edge(*pen))
        }
        Shape::Circle(..) if shape.is_blank() => String::new(),
        Shape::Circle(at, r, fill, pen) => {
            let fill = fill.map_or("none".to_string(), color);
            let (x, y, r) = (tenths(at[0]), tenths(at[1]), tenths(*r));
            format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" fill=\"{fill}\"{}/>\n", edge(*pen))
        }
        Shape::Label(at, math, fill) => {
            let mut runs = Vec::new();
            flatten(math, false, &mut runs);
            let mut text = String::new();
            let mut low = false;
            for run in runs {
                let dy = match (low, run.low) {
                    (false, true) => " dy=\"2.6\"",
                    (true, false) => " dy=\"-2.6\"",
                    _ => "",
                };
                let size = if run.low { format!(" font-size=\"{}\"", tenths(0.72 * LETTER)) } else { String::new() };
                let style = if run.italic { " font-style=\"italic\"" } else { "" };
                text.push_str(&format!("<tspan{dy}{size}{style}>{}</tspan>", escape(&run.text)));
                low = run.low;
            }
            format!(
                "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"2\" paint-order=\"stroke\">{text}</text>\n",
                tenths(at[0]),
                tenths(at[1] + 0.33 * LETTER),
                color(*fill)
            )
        }
    }
}

fn list(points: &[[f64; 2]]) -> String {
    points.iter().map(|p| format!("{},{}", tenths(p[0]), tenths(p[1]))).collect::<Vec<_>>().join(" ")
}

fn edge(pen: Option<Pen>) -> String {
    let Some(pen) = pen else { return String::new() };
    let dashes = if pen.dashed { " stroke-dasharray=\"3 3\"" } else { "" };
    format!(" stroke=\"{}\" stroke-width=\"{}\"{dashes}", color(pen.color), tenths(pen.width))
}

fn color(Color(r, g, b): Color) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Letters of one kind.
struct Run {
    text: String,
    low: bool,
    italic: bool,
}

/// A formula of a label as runs of letters: names, sums and products with indices. (Labels hold nothing else.)
fn flatten(m: &Math, low: bool, out: &mut Vec<Run>) {
    let mut push = |text: String, italic: bool| match out.last_mut() {
        Some(last) if last.low == low && last.italic == italic => last.text.push_str(&text),
        _ => out.push(Run { text, low, italic }),
    };
    match m {
        Math::Row(list) => list.iter().for_each(|m| flatten(m, low, out)),
        Math::Letter(c) => push(c.to_string(), true),
        Math::Word(w) | Math::Number(w) => push(w.clone(), false),
        Math::Open(c) | Math::Close(c) => push(c.to_string(), false),
        Math::Sign(s) => {
            let text = match s {
                Sign::Plus => " + ",
                Sign::Minus => " − ",
                Sign::Negative => "−",
                Sign::Equals => " = ",
                Sign::Comma => ",",
                Sign::Degree => "°",
                Sign::Prime => "′",
                Sign::PlusMinus | Sign::Either => "±",
                _ => "\u{2009}",
            };
            push(text.to_string(), false);
        }
        Math::Script(s) => {
            flatten(&s.base, low, out);
            for index in [&s.sub, &s.sup].into_iter().flatten() {
                flatten(index, true, out);
            }
        }
        Math::Fraction(a, b) => {
            flatten(a, low, out);
            out.push(Run { text: "/".into(), low, italic: false });
            flatten(b, low, out);
        }
        Math::Root(x) => {
            out.push(Run { text: "√".into(), low, italic: false });
            flatten(x, low, out);
        }
        Math::Dot(x) => {
            flatten(x, low, out);
            out.push(Run { text: "\u{307}".into(), low, italic: false });
        }
        Math::Matrix(_) => {}
    }
}
