//! Drawings as TikZ pictures, for LaTeX: its own fonts stand in the labels.

use super::formula::math as formula;
use crate::render::document::figure::{Color, Drawing, Pen, Shape, tenths};

/// Width of the text on a page, in points.
const WIDEST: f64 = 440.0;

/// The drawing as a `tikzpicture`; a unit is a point.
pub fn picture(d: &Drawing) -> String {
    // Letters keep their size where a wide drawing is made smaller.
    let scale = (WIDEST / d.size[0].max(1.0)).min(1.0);
    let mut out = format!("\\begin{{tikzpicture}}[x={scale:.3}bp,y=-{scale:.3}bp,line cap=round,line join=round]\n");
    for shape in d.shapes.iter().filter(|s| !s.is_blank()) {
        out.push_str(&line(shape));
    }
    out.push_str("\\end{tikzpicture}\n");
    out
}

fn line(shape: &Shape) -> String {
    match shape {
        Shape::Line(points, pen) => format!("\\draw[{}] {};\n", edge(pen), list(points)),
        Shape::Area(points, fill, pen) => match pen {
            Some(pen) => format!("\\filldraw[fill={},{}] {} -- cycle;\n", color(*fill), edge(pen), list(points)),
            None => format!("\\fill[fill={}] {} -- cycle;\n", color(*fill), list(points)),
        },
        Shape::Circle(at, r, fill, pen) => {
            let mut options: Vec<String> = Vec::new();
            options.extend(fill.map(|f| format!("fill={}", color(f))));
            options.extend(pen.as_ref().map(edge));
            format!("\\path[{}] {} circle ({}bp);\n", options.join(","), point(*at), tenths(*r))
        }
        Shape::Label(at, math, fill) => format!(
            "\\node[text={},font=\\footnotesize,fill=white,fill opacity=0.7,text opacity=1,inner sep=0.6pt] at {} {{${}$}};\n",
            color(*fill),
            point(*at),
            formula(math)
        ),
    }
}

fn list(points: &[[f64; 2]]) -> String {
    points.iter().map(|p| point(*p)).collect::<Vec<_>>().join(" -- ")
}

fn point(p: [f64; 2]) -> String {
    format!("({},{})", tenths(p[0]), tenths(p[1]))
}

fn edge(pen: &Pen) -> String {
    let dashes = if pen.dashed { ",dash pattern=on 3bp off 3bp" } else { "" };
    format!("draw={},line width={}bp{dashes}", color(pen.color), tenths(pen.width))
}

fn color(Color(r, g, b): Color) -> String {
    format!("{{rgb,255:red,{r};green,{g};blue,{b}}}")
}
