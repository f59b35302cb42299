//! The geometric Jacobian.

use super::{Block, Math, NotesWriter, Phrase, Sign, row_width};
use crate::algebra::Poly;
use crate::kinematics::{Kinematics, jacobian};

impl NotesWriter<'_> {
    pub(super) fn jacobian(&mut self, kinematics: &Kinematics) {
        let n = self.chain.dof();
        if n == 0 || super::forward::terms(&kinematics.pose()) > self.options.terms {
            return;
        }
        self.heading(1, Phrase::Jacobian);
        let i = || Math::Letter('i');
        let phrase = match (self.chain.is_direct(), self.chain.tool.is_empty()) {
            (true, true) => Phrase::JacobianIs,
            (true, false) => Phrase::JacobianOfTool,
            (false, _) => Phrase::JacobianOfMotors,
        };
        self.say(phrase, vec![i(), i()]);
        let columns = self.motor_columns(kinematics);
        let typeset: Vec<Vec<Math>> = columns.iter().map(|c| c.iter().map(|p| self.entry(p)).collect()).collect();
        let rows: Vec<Vec<Math>> = (0..6).map(|r| typeset.iter().filter_map(|c| c.get(r).cloned()).collect()).collect();
        let j = Math::Letter('J');
        if row_width(&rows) <= self.options.width {
            self.display(j, Math::Matrix(rows));
        } else {
            let names = (1..=n).map(|k| j.clone().below(Math::number(k))).collect();
            self.display(j.clone(), Math::Matrix(vec![names]));
            for (k, column) in typeset.into_iter().enumerate() {
                self.column(j.clone().below(Math::number(k + 1)), k, column);
            }
        }
        let all: Vec<_> = columns.iter().flatten().map(|p| self.group(p)).collect();
        self.tell_new(Phrase::With, &all);
    }

    /// An entry: the name of an entry of the pose, where it is one or its negative.
    fn entry(&self, p: &Poly) -> Math {
        let long = |q: &Poly| q.terms().len() > 1;
        if let Some((_, name)) = self.named.iter().find(|(q, _)| long(q) && q == p) {
            return name.clone();
        }
        let negative = -p;
        if let Some((_, name)) = self.named.iter().find(|(q, _)| long(q) && *q == negative) {
            return Math::Row(vec![Math::Sign(Sign::Negative), name.clone()]);
        }
        self.notation.typeset(&self.group(p))
    }

    /// One column as a vector, or entry by entry where it is too wide.
    fn column(&mut self, left: Math, k: usize, column: Vec<Math>) {
        if column.iter().all(|m| m.glyphs() <= self.options.width) {
            self.display(left, Math::Matrix(column.into_iter().map(|m| vec![m]).collect()));
        } else {
            let names = (1..=6)
                .map(|r| {
                    let index = if k < 9 { format!("{r}{}", k + 1) } else { format!("{r},{}", k + 1) };
                    Math::Letter('J').below(Math::number(index))
                })
                .collect::<Vec<_>>();
            self.display(left, Math::Matrix(names.iter().map(|m| vec![m.clone()]).collect()));
            let list = names.into_iter().zip(column).map(|(name, m)| self.equation(name, m)).collect();
            self.blocks.push(Block::Equations(list));
        }
    }

    /// Columns for the actuators: those for the joint coordinates times the coupling.
    fn motor_columns(&self, kinematics: &Kinematics) -> Vec<Vec<Poly>> {
        let columns: Vec<Vec<Poly>> = jacobian(self.chain, kinematics)
            .into_iter()
            .map(|(linear, angular)| linear.into_iter().chain(angular).collect())
            .collect();
        if self.chain.is_direct() {
            return columns;
        }
        (0..self.chain.dof())
            .map(|actuator| {
                (0..6)
                    .map(|r| {
                        columns
                            .iter()
                            .zip(&self.chain.drive)
                            .filter_map(|(c, line)| Some(c.get(r)? * line.get(actuator)?))
                            .sum()
                    })
                    .collect()
            })
            .collect()
    }
}
