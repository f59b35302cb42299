//! Link transforms, their products, the pose.

use super::steps::steps;
use super::{Block, Math, Phrase, Sign, Text, Writer, frame_transform, link_name, side_by_side};
use crate::algebra::{LinearAngle, Poly, Ring, Transform};
use crate::chain::{Convention, Elementary, Link};
use crate::kinematics::Kinematics;
use crate::render::expression::Expression;
use crate::render::grouping::Order;
use crate::render::notation::{Name, Notation};

impl Writer<'_> {
    pub(super) fn links(&mut self, kinematics: &Kinematics) {
        self.heading(1, Phrase::Links);
        self.general();
        let mut all = Vec::new();
        let mut blocks = Vec::new();
        for i in 1..=kinematics.len() {
            let Some(t) = kinematics.link(i) else { continue };
            let before = self.blocks.len();
            all.extend(self.transform(link_name(i - 1, i), None, t, Some(i - 1)));
            blocks.extend(self.blocks.drain(before..));
        }
        self.tell_new(Phrase::Short, &all);
        self.blocks.extend(blocks);
    }

    /// The transform of any row, from the convention itself.
    fn general(&mut self) {
        let mut ring = Ring::new();
        let (alpha, theta) = (ring.angle("alpha"), ring.angle("theta"));
        let (a, d) = (ring.symbol("a"), ring.symbol("d"));
        let link = Link {
            alpha: LinearAngle::var(alpha),
            a: Poly::symbol(a),
            d: Poly::symbol(d),
            theta: LinearAngle::var(theta),
            joint: None,
        };
        let factors = self.chain.convention.factors(&link);
        let t = factors.iter().fold(Transform::identity(), |t, f| t.times(&f.transform()));
        let before = match self.chain.convention {
            Convention::Modified => "i−1",
            Convention::Standard => "i",
        };
        let mut notation = Notation::of_ring(&ring);
        let named = |stem: &str, index: &str| Name { stem: stem.into(), index: index.into() };
        notation.rename_angle(alpha, named("alpha", before));
        notation.rename_angle(theta, named("theta", "i"));
        notation.rename_symbol(a, named("a", before));
        notation.rename_symbol(d, named("d", "i"));
        let order = Order::new(vec![theta.group()]);
        let mut cells: Vec<Vec<Math>> =
            (0..3).map(|i| (0..4).map(|j| notation.typeset(&order.group(&t.entry(i, j)))).collect()).collect();
        cells.push(["0", "0", "0", "1"].map(Math::number).to_vec());
        let product = factors
            .iter()
            .map(|f| {
                let (letter, axis, argument) = match f {
                    Elementary::Rotate(axis, angle) => ('R', axis, notation.combination(&angle.terms)),
                    Elementary::Translate(axis, length) => ('D', axis, notation.typeset(&order.group(length))),
                };
                let axis = Math::Letter(['x', 'y', 'z'][axis % 3]);
                Math::Row(vec![Math::Letter(letter).below(axis), argument.in_brackets()])
            })
            .collect();
        self.say(Phrase::General, vec![]);
        let i = Math::Letter('i');
        let i_before = Math::Row(vec![i.clone(), Math::Sign(Sign::Minus), Math::number(1)]);
        let right = Math::equation(side_by_side(product), Math::Matrix(cells));
        self.display(frame_transform(i_before, i), right);
    }

    pub(super) fn forward(&mut self, kinematics: &Kinematics) {
        let n = kinematics.len();
        self.heading(1, Phrase::Forward);
        let list = steps(self.chain);
        if list.len() > 1 {
            self.say(Phrase::FromTheTip, vec![]);
        }
        let mut last = Vec::new();
        for s in list {
            let Some(t) = kinematics.transform(s.from, s.to) else { continue };
            let product = side_by_side(vec![link_name(s.from, s.middle), link_name(s.middle, s.to)]);
            let prefix = (s.from > 0).then_some(s.from);
            last = self.product(link_name(s.from, s.to), product, &t, prefix);
        }
        let (base, tool) = (!self.chain.base.is_empty(), !self.chain.tool.is_empty());
        if base || tool {
            self.say(Phrase::BaseAndTool, vec![]);
            let mut product = Vec::new();
            let (first, end) = (Math::Letter('b'), Math::Letter('e'));
            if base {
                let left = frame_transform(first.clone(), Math::number(0));
                self.transform(left.clone(), None, kinematics.base(), None);
                product.push(left);
            }
            if n > 0 {
                product.push(link_name(0, n));
            }
            if tool {
                let left = frame_transform(Math::number(n), end.clone());
                self.transform(left.clone(), None, kinematics.tool(), None);
                product.push(left);
            }
            let (from, to) = (if base { first } else { Math::number(0) }, if tool { end } else { Math::number(n) });
            last = self.product(frame_transform(from, to), side_by_side(product), &kinematics.pose(), None);
        }
        let legend = self.notation.legend(&last);
        self.tell(Phrase::Legend, legend);
    }

    /// A product of transforms, written out if it is not too long.
    fn product(&mut self, left: Math, product: Math, t: &Transform, prefix: Option<usize>) -> Vec<Expression> {
        let terms = terms(t);
        if terms > self.options.terms {
            self.named.clear();
            self.display(left, product);
            let text = self.words(Phrase::TooLong).replace("{}", &terms.to_string());
            self.blocks.push(Block::Paragraph(Text::from(text)));
            return Vec::new();
        }
        let entries = self.transform(left, Some(product), t, prefix);
        self.tell_new(Phrase::With, &entries);
        entries
    }
}

/// Number of terms of all entries.
pub(super) fn terms(t: &Transform) -> usize {
    (0..3).flat_map(|i| (0..4).map(move |j| (i, j))).map(|(i, j)| t.entry(i, j).terms().len()).sum()
}
