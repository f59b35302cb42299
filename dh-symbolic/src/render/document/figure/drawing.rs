//! A drawing in the plane: what every figure is before it is printed. Points are `[x, y]`, y downwards, in points of 1/72 inch.

use crate::render::formula::math::Math;

/// A drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Width and height.
    pub size: [f64; 2],
    /// What is drawn, the farthest first.
    pub shapes: Vec<Shape>,
}

/// Equal if they look equal: coordinates are finite.
impl Eq for Drawing {}

/// A piece of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A line through points.
    Line(Vec<[f64; 2]>, Pen),
    /// A filled polygon, with or without an edge.
    Area(Vec<[f64; 2]>, Color, Option<Pen>),
    /// A circle: centre, radius, filling, edge.
    Circle([f64; 2], f64, Option<Color>, Option<Pen>),
    /// A formula with its centre at a point.
    Label([f64; 2], Math, Color),
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// Its colour.
    pub color: Color,
    /// Its width.
    pub width: f64,
    /// In dashes?
    pub dashed: bool,
}

impl Pen {
    /// A line without gaps.
    pub fn new(color: Color, width: f64) -> Pen {
        Pen { color, width, dashed: false }
    }
}

/// Red, green, blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color(pub u8, pub u8, pub u8);

/// Height of a label's letters.
pub(in crate::render) const LETTER: f64 = 10.0;

impl Shape {
    /// A circle that only takes room?
    pub(in crate::render) fn is_blank(&self) -> bool {
        matches!(self, Shape::Circle(_, _, None, None))
    }

    /// The smallest box: least and greatest x and y.
    fn bounds(&self) -> [[f64; 2]; 2] {
        let around = |points: &[[f64; 2]], by: f64| {
            let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
            for p in points {
                for i in 0..2 {
                    low[i] = low[i].min(p[i] - by);
                    high[i] = high[i].max(p[i] + by);
                }
            }
            [low, high]
        };
        match self {
            Shape::Line(points, pen) => around(points, 0.5 * pen.width),
            Shape::Area(points, _, pen) => around(points, pen.map_or(0.0, |p| 0.5 * p.width)),
            Shape::Circle(at, r, _, pen) => around(&[*at], r + pen.map_or(0.0, |p| 0.5 * p.width)),
            Shape::Label(at, math, _) => {
                let [w, h] = label_size(math);
                [[at[0] - 0.5 * w, at[1] - 0.5 * h], [at[0] + 0.5 * w, at[1] + 0.5 * h]]
            }
        }
    }

    fn moved(&mut self, by: [f64; 2]) {
        let shift = |p: &mut [f64; 2]| *p = [p[0] + by[0], p[1] + by[1]];
        match self {
            Shape::Line(points, _) | Shape::Area(points, ..) => points.iter_mut().for_each(shift),
            Shape::Circle(at, ..) | Shape::Label(at, ..) => shift(at),
        }
    }
}

/// A length with one decimal: a tenth of a point.
pub(in crate::render) fn tenths(x: f64) -> String {
    let text = format!("{x:.1}");
    match text.strip_suffix(".0") {
        Some("-0") => "0".into(),
        Some(whole) => whole.into(),
        None => text,
    }
}

/// Width and height that a label takes, about.
pub(super) fn label_size(math: &Math) -> [f64; 2] {
    [4.0 + 0.55 * LETTER * math.glyphs() as f64, 1.5 * LETTER]
}

impl Drawing {
    /// Shapes with the smallest frame around them.
    pub fn around(mut shapes: Vec<Shape>, margin: f64) -> Drawing {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for [a, b] in shapes.iter().map(Shape::bounds) {
            for i in 0..2 {
                low[i] = low[i].min(a[i]);
                high[i] = high[i].max(b[i]);
            }
        }
        if !(low[0] <= high[0] && low[1] <= high[1]) {
            return Drawing::default();
        }
        let shift = [margin - low[0], margin - low[1]];
        shapes.iter_mut().for_each(|s| s.moved(shift));
        Drawing { size: [high[0] - low[0] + 2.0 * margin, high[1] - low[1] + 2.0 * margin], shapes }
    }

    /// Drawings of one size in rows, `columns` in each.
    pub fn in_rows(list: Vec<Drawing>, columns: usize) -> Drawing {
        let columns = columns.clamp(1, list.len().max(1));
        let cell: [f64; 2] = std::array::from_fn(|i| list.iter().map(|d| d.size[i]).fold(0.0, f64::max));
        let rows = list.len().div_ceil(columns);
        let mut shapes = Vec::new();
        for (k, drawing) in list.into_iter().enumerate() {
            let (row, column) = (k / columns, k % columns);
            let corner = [column as f64 * cell[0], row as f64 * cell[1]];
            let free: [f64; 2] = std::array::from_fn(|i| corner[i] + 0.5 * (cell[i] - drawing.size[i]));
            shapes.extend(drawing.shapes.into_iter().map(|mut s| {
                s.moved(free);
                s
            }));
        }
        Drawing { size: [columns as f64 * cell[0], rows as f64 * cell[1]], shapes }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(size: f64) -> Drawing {
        let pen = Pen::new(Color(0, 0, 0), 2.0);
        Drawing::around(vec![Shape::Line(vec![[-5.0, 7.0], [size - 5.0, size + 7.0]], pen)], 3.0)
    }

    #[test]
    fn the_frame_is_around_everything() {
        let d = square(10.0);
        assert_eq!(d.size, [18.0, 18.0]);
        assert_eq!(d.shapes, [Shape::Line(vec![[4.0, 4.0], [14.0, 14.0]], Pen::new(Color(0, 0, 0), 2.0))]);
        assert_eq!(Drawing::around(Vec::new(), 3.0), Drawing::default());
    }

    #[test]
    fn rows_have_cells_of_one_size() {
        let d = Drawing::in_rows(vec![square(10.0), square(20.0), square(10.0)], 2);
        assert_eq!((d.size, d.shapes.len()), ([56.0, 56.0], 3));
    }
}
