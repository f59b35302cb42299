//! The chapter as it is taught: textbook methods for the arms that they fit, selectable as parts of a note.
//!
//! The steps of the inverse in the other parts follow the plan of the generated code. These parts follow the lecture: general formulas,
//! then those of the arm, then numbers of the worked example. Their words stand beside their formulas, in both languages.

mod calibration;
mod choice;
mod frames;
mod identifiable;
mod pieper;
mod pieper_numbers;
mod planar;
mod positioning;
mod spaces;
mod texts;
mod written;
mod zyz;

use super::arm::Arm;
use super::example::{Sample, Start};
use super::numbers::significant;
use super::{Block, Equation, Math, NotesWriter, Sign, Span, Text};
use crate::chain::{Convention, Coordinate};
use crate::render::Language;
use crate::render::document::frames::Frame;
use crate::render::formula::expression::Trig;
use crate::render::formula::quantities::{named_table_angles, relations};

impl NotesWriter<'_> {
    /// Writes a part in which every angle is that of the table: offsets have been taken into the joint angles, which then have names
    /// of their own, and sines are written out, since elsewhere in the note c2 is the cosine of the variable.
    fn with_table_angles(&mut self, start: Option<&Start>, part: impl FnOnce(&mut NotesWriter<'_>, Option<&Sample>)) {
        let solved = self.solved();
        let renamed = named_table_angles(self.chain);
        let chain = renamed.as_ref().unwrap_or(self.chain);
        let mut options = self.options.clone();
        options.style.long_sines |= renamed.is_some();
        let mut inner = NotesWriter::new(chain, options);
        inner.number = self.number;
        inner.introduced.clone_from(&self.introduced);
        inner.solved = Some(solved.clone());
        let sample = match (start, &*solved) {
            (Some(start), Ok(inverse)) => {
                // solved along the plan of the chain as it is; then seen in the angles of the table
                let own = Sample::new(self.chain, inverse.clone(), start);
                Some(own.seen_as(Arm::new(chain, inverse.clone())))
            }
            _ => None,
        };
        part(&mut inner, sample.as_ref());
        self.number = inner.number;
        self.blocks.append(&mut inner.blocks);
    }

    /// Which angles of the table are not the joints' variables.
    fn table_angles(&mut self) {
        let list: Vec<Equation> =
            relations(self.chain, &self.notation, &self.order).into_iter().map(|(l, r)| self.equation(l, r)).collect();
        if !list.is_empty() {
            self.tell_both(
                "The angles of this section are those of the table, offsets included:",
                "本节的角均为表中的角（含偏置）：",
                &[],
            );
            self.blocks.push(Block::Equations(list));
        }
    }

    fn both(&self, english: &'static str, chinese: &'static str) -> &'static str {
        match self.options.language {
            Language::English => english,
            Language::Chinese => chinese,
        }
    }

    fn title(&mut self, level: u8, english: &'static str, chinese: &'static str) {
        let text = self.text(self.both(english, chinese), &[]);
        self.blocks.push(Block::Heading(level, text));
    }

    /// A paragraph; formulas stand between dollar signs.
    fn tell_both(&mut self, english: &'static str, chinese: &'static str, pieces: &[Math]) {
        let text = self.text(self.both(english, chinese), pieces);
        self.blocks.push(Block::Paragraph(text));
    }

    fn points(&mut self, list: &[(&'static str, &'static str)], pieces: &[Math]) {
        let items = list.iter().map(|(e, c)| self.text(self.both(e, c), pieces)).collect();
        self.blocks.push(Block::List(items));
    }

    fn text(&self, sentence: &str, pieces: &[Math]) -> Text {
        let spans = sentence.split('$').enumerate().filter(|(_, t)| !t.is_empty()).map(|(i, t)| match i % 2 {
            0 => Span::Plain(t.to_string()),
            _ => Span::Math(self.formula(t, pieces)),
        });
        Text(spans.collect())
    }

    fn formula(&self, text: &str, pieces: &[Math]) -> Math {
        written::formula(text, &|word| self.name_of(word), pieces)
    }

    /// One equation, as typed.
    fn written(&self, text: &str, pieces: &[Math]) -> Equation {
        let mut depth = 0;
        let cut = text.char_indices().find(|(_, c)| {
            depth += i32::from(*c == '{') - i32::from(*c == '}');
            *c == '=' && depth == 0
        });
        let (left, right) = cut.map_or((text, ""), |(i, _)| (&text[..i], &text[i + 1..]));
        self.equation(self.formula(left, pieces), self.formula(right, pieces))
    }

    /// Equations in a row, aligned, without numbers.
    fn show(&mut self, list: &[&str], pieces: &[Math]) {
        let list = list.iter().map(|t| self.written(t, pieces)).collect();
        self.blocks.push(Block::Equations(list));
    }

    /// An equation with a number; gives the number.
    fn show_numbered(&mut self, text: &str, pieces: &[Math]) -> Math {
        self.number += 1;
        let equation = Equation { number: Some(self.number), ..self.written(text, pieces) };
        self.blocks.push(Block::Equations(vec![equation]));
        Math::number(self.number).in_brackets()
    }

    /// The joint values of the solution that the numbers which follow belong to.
    fn at_solution(&mut self, sample: &Sample) {
        let Some(solution) = sample.found.get(sample.chosen) else { return };
        let arm = &sample.arm;
        let list: Vec<Math> = solution.q.iter().enumerate().map(|(k, x)| self.value_of(arm, k, *x, 0)).collect();
        let mut text = Text::from(self.both("With ", "取 "));
        text.0.extend(super::inverse::listed(&list));
        let number = sample.chosen + 1;
        text.0.push(Span::Plain(match self.options.language {
            Language::English => format!(", solution {number} of the worked example:"),
            Language::Chinese => format!("，即算例第 {number} 组解："),
        }));
        self.blocks.push(Block::Paragraph(text));
    }

    fn real(&self, x: f64) -> Math {
        significant(x, self.options.digits + 1)
    }

    fn degrees(&self, x: f64) -> Math {
        self.notation.decimal_angle(x, self.options.digits.saturating_sub(2))
    }

    /// A 3x3 matrix of numbers.
    fn rotation(&self, t: &[[f64; 4]; 3]) -> Math {
        let places = self.options.digits;
        let row = |r: &[f64; 4]| r[..3].iter().map(|x| crate::render::document::frames::decimal(*x, places)).collect();
        Math::Matrix(t.iter().map(row).collect())
    }

    /// `c2`, `s2`: cosine and sine of a joint angle; `q2`: that angle or length; `a1`, `A1`, `d1`: length, twist and offset of the table;
    /// `T03`, `R03`: a transform of the table and its rotation; `x`, `y`: `z`: the wrist.
    fn name_of(&self, word: &str) -> Option<Math> {
        let (kind, index) = (word.get(..1)?, word.get(1..)?);
        let digits: Vec<usize> = index.chars().filter_map(|c| Some(c.to_digit(10)? as usize)).collect();
        let cell = |p: &crate::algebra::Poly| self.notation.typeset(&self.group(p));
        match (kind, digits.as_slice()) {
            ("c" | "s", [i]) => {
                let joint = self.chain.joints.get(i.checked_sub(1)?)?;
                let Coordinate::Angle(v) = joint.coordinate else { return None };
                Some(self.notation.trig(&Trig { angles: vec![(v, 1)], sine: kind == "s" }))
            }
            ("q", [i]) => Some(self.coordinate(i.checked_sub(1)?)),
            ("a", [i]) => Some(cell(&self.crossing(*i)?.a)),
            ("A", [i]) => Some(self.angle(&self.crossing(*i)?.alpha)),
            ("d", [i]) => Some(cell(&self.chain.links.get(i.checked_sub(1)?)?.d)),
            ("T", [i, j]) => Some(self.notation.transform(Frame::Row(*i), Frame::Row(*j))),
            ("R", [i, j]) => match self.notation.transform(Frame::Row(*i), Frame::Row(*j)) {
                Math::Script(mut s) => {
                    s.base = Math::Letter('R');
                    Some(Math::Script(s))
                }
                other => Some(other),
            },
            ("x" | "y" | "z", []) => {
                let letter = Math::Letter(kind.chars().next()?);
                Some(if self.wrist_apart { letter.below(Math::Letter('w')) } else { letter })
            }
            _ => None,
        }
    }

    /// The row that holds the length and twist between the axes of joints i and i + 1.
    fn crossing(&self, i: usize) -> Option<&crate::chain::Link> {
        self.chain.links.get(match self.chain.convention {
            Convention::Modified => i,
            Convention::Standard => i.checked_sub(1)?,
        })
    }
}
