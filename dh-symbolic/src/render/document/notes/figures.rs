//! Figures of a note: the arm with its frames, the postures of one pose, the workspace.

use super::arm::{generic_degrees, slide};
use super::example::Start;
use super::{Block, Math, NotesWriter, Phrase, Span, Text, given};
use crate::chain::{Chain, Coordinate};
use crate::kinematics::Kinematics;
use crate::planner::Axes;
use crate::render::document::Figure;
use crate::render::document::figure::{self, Drawing, Posture};

/// Most postures that stand side by side.
const POSTURES: usize = 16;

impl NotesWriter<'_> {
    /// The arm at the joint values of the example.
    pub(super) fn figure(&mut self, kinematics: &Kinematics, start: Option<&Start>) {
        if self.chain.dof() == 0 {
            return;
        }
        let x = coordinates(self.chain, start);
        let posture = Posture::at(self.chain, kinematics, &x);
        let drawing = figure::arm(self.chain, &self.notation, &posture);
        let values: Vec<Math> = x.iter().enumerate().map(|(k, x)| self.at(k, *x)).collect();
        let mut text = Text::default();
        let mut halves = self.words(Phrase::FigureArm).splitn(2, "{}");
        text.0.push(Span::Plain(halves.next().unwrap_or_default().into()));
        text.0.extend(super::inverse::listed(&values));
        text.0.push(Span::Plain(halves.next().unwrap_or_default().into()));
        self.draw(drawing, text);
    }

    /// `theta1 = 20 degrees`.
    fn at(&self, k: usize, x: f64) -> Math {
        let revolute = self.chain.joints.get(k).is_some_and(|j| matches!(j.coordinate, Coordinate::Angle(_)));
        let value = if revolute {
            self.notation.decimal_angle(x, if (x.to_degrees() - x.to_degrees().round()).abs() < 1e-9 { 0 } else { 2 })
        } else {
            let text = format!("{x:.4}");
            Math::number(text.trim_end_matches('0').trim_end_matches('.'))
        };
        Math::equation(self.coordinate(k), value)
    }

    /// All solutions of the example, as joint coordinates.
    pub(super) fn postures(&mut self, kinematics: &Kinematics, list: &[Vec<f64>]) {
        if !(2..=POSTURES).contains(&list.len()) {
            return;
        }
        let postures: Vec<Posture> = list.iter().map(|x| Posture::at(self.chain, kinematics, x)).collect();
        let text = self.words(Phrase::FigurePostures).into();
        self.draw(figure::postures(&postures), text);
    }

    /// The rings of a planar arm.
    pub(super) fn workspace_figure(&mut self, kinematics: &Kinematics, start: Option<&Start>) {
        let posture = Posture::at(self.chain, kinematics, &coordinates(self.chain, start));
        let Some(drawing) = figure::workspace(self.chain, kinematics, &posture) else { return };
        let dexterous = figure::rings(self.chain, kinematics).is_some_and(|r| r.dexterous.is_some());
        let phrase = match self.chain.dof() {
            2 => Phrase::FigureRings,
            _ if dexterous => Phrase::FigureDexterous,
            _ => Phrase::FigureReach,
        };
        let text = self.words(phrase).replace("{}", self.chain.settings.unit.name);
        self.draw(drawing, text.into());
    }

    fn draw(&mut self, drawing: Drawing, caption: Text) {
        if !drawing.shapes.is_empty() {
            let word = self.words(Phrase::Figure);
            self.blocks.push(Block::Figure(Figure { drawing, caption, word }));
        }
    }
}

/// Joint coordinates of the example's variables.
fn coordinates(chain: &Chain, start: Option<&Start>) -> Vec<f64> {
    let length_scale = Axes::new(chain).length_scale;
    let revolute = |k: usize| chain.joints.get(k).is_some_and(|j| matches!(j.coordinate, Coordinate::Angle(_)));
    let q: Vec<f64> = (0..chain.dof())
        .map(|k| {
            let x = if revolute(k) { generic_degrees(k).to_radians() } else { slide(length_scale) };
            let range = chain.joints.get(k).and_then(|j| j.range.as_ref());
            let inside = range.map(|(a, b)| (given::bound(a), given::bound(b))).filter(|(a, b)| x < *a || x > *b);
            let usual = inside.map_or(x, |(a, b)| a + 0.4 * (b - a));
            start.and_then(|s| s.value(k)).unwrap_or(usual)
        })
        .collect();
    let number = |p: &crate::algebra::Poly| crate::render::code::scaled_constant(chain, p, 1.0);
    let rows = chain.joints.iter().zip(&chain.drive);
    rows.map(|(j, row)| given::shift(chain, &j.shift) + row.iter().zip(&q).map(|(k, q)| number(k) * q).sum::<f64>())
        .collect()
}
