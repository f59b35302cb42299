//! Link transforms, their products, the pose.

use super::products::asked;
use super::{Block, Math, NotesWriter, Phrase, Prefix, Text, side_by_side};
use crate::algebra::{LinearAngle, Poly, Ring, Transform};
use crate::chain::{Convention, Elementary, Factor, Handle, Link, Parameter};
use crate::kinematics::Kinematics;
use crate::render::document::frames::Frame;
use crate::render::formula::expression::Expression;
use crate::render::formula::grouping::Order;
use crate::render::formula::math::Sign;
use crate::render::formula::notation::{Name, Notation};
use crate::render::formula::products::steps;
use crate::render::formula::style::Transforms;

impl NotesWriter<'_> {
    pub(super) fn links(&mut self, kinematics: &Kinematics) {
        self.heading(1, Phrase::Links);
        if self.number_of_equation(&self.notation.transform(Frame::Before, Frame::General)).is_none() {
            self.general();
        }
        let mut all = Vec::new();
        let mut blocks = Vec::new();
        for i in 1..=kinematics.len() {
            let Some(t) = kinematics.link(i) else { continue };
            let before = self.blocks.len();
            all.extend(self.transform(self.link_name(i - 1, i), None, t, Some((i - 1, Some(i)))));
            blocks.extend(self.blocks.drain(before..));
        }
        self.tell_new(Phrase::Short, &all);
        self.blocks.extend(blocks);
    }

    /// The transform of any row, from the convention itself.
    pub(super) fn general(&mut self) {
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
        notation.style = self.notation.style.clone();
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
                motion(letter, *axis, argument)
            })
            .collect();
        self.say(Phrase::General, vec![]);
        let left = self.notation.transform(Frame::Before, Frame::General);
        self.display_product(left, Some(side_by_side(product)), Math::Matrix(cells));
    }

    pub(super) fn forward(&mut self, kinematics: &Kinematics) {
        let n = kinematics.len();
        let (base, tool) = (!self.chain.base.is_empty(), !self.chain.tool.is_empty());
        self.heading(1, Phrase::Forward);
        self.left_out();
        let list = if self.options.products.is_empty() { steps(self.chain) } else { asked(n, &self.options.products) };
        if list.len() > 1 && self.options.products.is_empty() {
            self.say(Phrase::FromTheTip, vec![]);
        }
        if self.notation.style.transforms == Transforms::Products && n > 1 {
            let a = Math::Letter('A').below(Math::Letter('i'));
            let product = side_by_side((1..=n).map(|i| self.link_name(i - 1, i)).collect());
            let whole = Math::equation(self.link_name(0, n), product);
            self.say(Phrase::Paul, vec![a, Math::Letter('i'), whole]);
        }
        let mut last = Vec::new();
        for s in list {
            let Some(t) = kinematics.transform(s.from, s.to) else { continue };
            let ends: Vec<usize> = std::iter::once(s.from).chain(s.middle).chain([s.to]).collect();
            let product = ends.windows(2).map(|w| self.link_name(w[0], w[1])).collect();
            // r and p without indices are those of the pose that the task is about.
            let inner = base || tool;
            let prefix = (s.from > 0 || s.to < n || inner).then_some((s.from, (s.to < n).then_some(s.to)));
            last = self.product(self.link_name(s.from, s.to), side_by_side(product), &t, prefix);
        }
        if base || tool {
            self.say(Phrase::BaseAndTool, vec![]);
            let mut product = Vec::new();
            if base {
                let left = self.notation.transform(Frame::Base, Frame::Row(0));
                self.transform(left.clone(), None, kinematics.base(), None);
                product.push(left);
            }
            if n > 0 {
                product.push(self.link_name(0, n));
            }
            if tool {
                let left = self.notation.transform(Frame::Row(n), Frame::Tool);
                self.transform(left.clone(), None, kinematics.tool(), None);
                product.push(left);
            }
            let from = if base { Frame::Base } else { Frame::Row(0) };
            let to = if tool { Frame::Tool } else { Frame::Row(n) };
            let left = self.notation.transform(from, to);
            last = self.product(left, side_by_side(product), &kinematics.pose(), None);
        }
        let legend = self.notation.legend(&last);
        self.tell(Phrase::Legend, legend);
    }

    /// The poses that formulas leave out, if any, and the product that has them.
    fn left_out(&mut self) {
        let names: Vec<Math> = self.chain.left_out().into_iter().map(pose_name).collect();
        if names.is_empty() {
            return;
        }
        let factor = |f: &Factor| match f {
            Factor::Pose(i) => self.chain.poses.get(*i).map_or(Math::Letter('T'), |p| pose_name(&p.name)),
            Factor::Motion(Elementary::Translate(axis, length)) => {
                motion('D', *axis, self.notation.typeset(&self.group(length)))
            }
            Factor::Motion(Elementary::Rotate(axis, angle)) if angle.terms.is_empty() => {
                let (negative, value) = self.notation.exact_angle(angle.constant.factor());
                motion('R', *axis, if negative { Math::Row(vec![Math::Sign(Sign::Negative), value]) } else { value })
            }
            Factor::Motion(Elementary::Rotate(axis, angle)) => {
                motion('R', *axis, self.notation.combination(&angle.terms))
            }
        };
        let before: Vec<Math> = self.chain.before.iter().map(factor).collect();
        let after: Vec<Math> = self.chain.after.iter().map(factor).collect();
        let product = before.into_iter().chain([Math::Letter('T')]).chain(after).collect();
        self.say(Phrase::LeftOut, vec![Math::list(&names), side_by_side(product)]);
        if let Some(point) = self.chain.point() {
            let handles = self.chain.parameters.iter().filter(|p| point.contains(&p.name));
            let symbol = |p: &Parameter| match p.handle {
                Handle::Length(s) => Some(self.notation.symbol(s)),
                Handle::Angle(_) => None,
            };
            let list: Vec<Math> = handles.filter_map(symbol).collect();
            self.say(Phrase::ToolPoint, vec![Math::list(&list)]);
        }
    }

    /// A product of transforms, written out if it is not too long.
    fn product(&mut self, left: Math, product: Math, t: &Transform, prefix: Prefix) -> Vec<Expression> {
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

/// The name of a pose that the program sets: T with its name as index.
fn pose_name(name: &str) -> Math {
    Math::Letter('T').below(Math::word(name))
}

/// A motion along or about an axis.
fn motion(letter: char, axis: usize, value: Math) -> Math {
    let axis = Math::Letter(['x', 'y', 'z'][axis % 3]);
    Math::Row(vec![Math::Letter(letter).below(axis), value.in_brackets()])
}

/// Number of terms of all entries.
pub(super) fn terms(t: &Transform) -> usize {
    (0..3).flat_map(|i| (0..4).map(move |j| (i, j))).map(|(i, j)| t.entry(i, j).terms().len()).sum()
}
