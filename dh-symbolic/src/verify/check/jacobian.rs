//! The geometric Jacobian, and which of its rows a line means by J: those of the task, of the plane the arm moves in, all six.

use super::Evaluator;
use super::direct::{Direct, Spot};
use super::ratio::Ratio;
use super::refusal::{Understood, refuse};
use super::value::{Matrix, Value};
use crate::algebra::Poly;
use crate::chain::Task;
use crate::kinematics::jacobian;
use crate::verify::language::{Expr, ExprKind, Place, Relation};
use std::ops::RangeInclusive;

/// All rows: three linear, three angular.
pub(super) const ALL: [usize; 6] = [0, 1, 2, 3, 4, 5];

/// Poses at which a choice of rows is tried.
const POSES: usize = 3;

/// How a line fares with a choice of rows.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Fit {
    /// It has no meaning: shapes differ, a matrix that is not square has no determinant.
    None,
    /// It has a meaning.
    Shape,
    /// It holds.
    Holds,
}

impl Evaluator<'_> {
    /// The geometric Jacobian for the variables q: the rows that J stands for.
    pub(super) fn jacobian(&mut self) -> Matrix {
        self.rows_of_jacobian(&self.rows.clone())
    }

    /// Rows of the geometric Jacobian by their numbers from 0.
    pub(super) fn rows_of_jacobian(&mut self, rows: &[usize]) -> Matrix {
        let columns = jacobian(self.chain, &self.kinematics);
        let n = self.chain.dof();
        let mut entries = Vec::with_capacity(rows.len() * n);
        for row in rows {
            for actuator in 0..n {
                let terms = columns.iter().zip(&self.chain.drive).filter_map(|((linear, angular), line)| {
                    Some(linear.iter().chain(angular).nth(*row)? * line.get(actuator)?)
                });
                entries.push(Ratio::from(terms.sum::<Poly>()));
            }
        }
        Matrix { columns: n, entries }
    }

    /// Rows from 1 of column k from 1; a single one is a number.
    pub(super) fn part_of_jacobian(
        &self,
        j: &Matrix,
        rows: RangeInclusive<usize>,
        k: usize,
        place: &Place,
    ) -> Understood<Value> {
        let inside = *rows.start() >= 1 && *rows.end() <= j.rows() && k >= 1 && k <= j.columns;
        if !inside {
            return refuse(place, format!("the Jacobian is a {} matrix", j.shape()));
        }
        let entries: Vec<Ratio> = rows.map(|i| j.at(i - 1, k - 1)).collect();
        Ok(match <[Ratio; 1]>::try_from(entries) {
            Ok([only]) => Value::Scalar(only),
            Err(entries) => Value::Matrix(Matrix { columns: 1, entries }),
        })
    }

    /// Decides which rows J stands for in a line, by the shapes of its other parts: those of the line before as long as they fit,
    /// otherwise the first choice with which the line holds, otherwise the first with which it has a meaning.
    ///
    /// Only a matrix that is written out shows which rows are meant. An entry or a determinant that does not hold would find some rows with
    /// which it does: there the likeliest rows with a meaning stand for J, whatever the line says.
    pub(super) fn choose_rows(&mut self, first: &Expr, rest: &[(Relation, Expr)]) {
        if !mentions(first) && !rest.iter().any(|r| mentions(&r.1)) {
            return;
        }
        let used = self.rows.clone();
        // what a line without a matrix was read with is not what the next one means
        self.rows.clone_from(&self.shown_rows);
        self.choose_anew(first, rest);
        if self.rows != used {
            // poses remember J
            self.spots.clear();
        }
    }

    fn choose_anew(&mut self, first: &Expr, rest: &[(Relation, Expr)]) {
        let before = self.rows.clone();
        let default = before == ALL;
        let now = self.fit(first, rest);
        let shown = is_written(first) || rest.iter().any(|r| is_written(&r.1));
        if now == Fit::Holds || now == Fit::Shape && !(default && shown) {
            return;
        }
        let mut best = (now, before.clone());
        for rows in self.choices() {
            self.rows = rows;
            let fit = self.fit(first, rest);
            if fit > best.0 {
                best = (fit, self.rows.clone());
            }
            if fit == Fit::Holds || fit == Fit::Shape && !shown {
                break;
            }
        }
        self.rows = best.1;
        if shown {
            self.shown_rows.clone_from(&self.rows);
        }
    }

    fn fit(&self, first: &Expr, rest: &[(Relation, Expr)]) -> Fit {
        let mut fit = Fit::Holds;
        for k in 0..POSES {
            let mut spot = Spot::new(self.sample(k).0);
            let mut at_values = Spot::new(self.numbers(&self.given));
            let Some(mut left) = spot.evaluate(first, self) else { return Fit::None };
            let mut before = first;
            for (relation, right) in rest {
                let Some(x) = spot.evaluate(right, self) else { return Fit::None };
                if !have_one_shape(&left, &x) {
                    return Fit::None;
                }
                let holds = match relation {
                    Relation::Equal => left.is_near(&x, 1e-9),
                    Relation::Near => {
                        let sides = (at_values.evaluate(before, self), at_values.evaluate(right, self));
                        matches!(sides, (Some(a), Some(b)) if a.is_near(&b, 0.02))
                    }
                    _ => true,
                };
                if !holds {
                    fit = Fit::Shape;
                }
                left = x;
                before = right;
            }
        }
        fit
    }

    /// Sets of rows that people call the Jacobian, the likeliest first.
    fn choices(&self) -> Vec<Vec<usize>> {
        let mut spot = Spot::new(self.sample(0).0);
        let whole = spot.whole_jacobian(self.chain);
        let moves = |i: &usize| {
            whole.as_ref().is_some_and(|m| (0..m.columns).any(|j| m.get(*i, j).is_some_and(|x| x.abs() > 1e-12)))
        };
        let used: Vec<usize> = ALL.into_iter().filter(moves).collect();
        let linear: Vec<usize> = used.iter().copied().filter(|i| *i < 3).collect();
        let of_task: &[usize] = match self.chain.settings.task {
            Task::Pose => &ALL,
            Task::Position => &[0, 1, 2],
            Task::Planar => &[0, 1, 5],
            Task::Axis => &[0, 1, 2, 3, 4],
        };
        let common: [&[usize]; 9] =
            [of_task, &used, &linear, &[0, 1, 5], &[0, 1, 2], &[3, 4, 5], &[3, 4, 5, 0, 1, 2], &[0, 1], &[0, 2]];
        let rest = [1usize, 2].map(|i| vec![i, i + 1]).into_iter().chain(ALL.map(|i| vec![i]));
        let mut out: Vec<Vec<usize>> = Vec::new();
        for rows in common.iter().map(|r| r.to_vec()).chain(rest) {
            if !rows.is_empty() && !out.contains(&rows) {
                out.push(rows);
            }
        }
        out
    }
}

fn have_one_shape(a: &Direct, b: &Direct) -> bool {
    match (a, b) {
        (Direct::Matrix(m), Direct::Matrix(n)) => m.columns == n.columns && m.cells.len() == n.cells.len(),
        (Direct::Matrix(_), Direct::Scalar(x)) | (Direct::Scalar(x), Direct::Matrix(_)) => *x == 0.0,
        (Direct::Matrix(_), _) | (_, Direct::Matrix(_)) => false,
        _ => true,
    }
}

/// Is a matrix written out in a formula?
fn is_written(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => false,
        ExprKind::Call(_, arguments) => arguments.iter().any(|a| is_written(&a.1)),
        ExprKind::Sum(parts) | ExprKind::Product(parts) => parts.iter().any(|p| is_written(&p.1)),
        ExprKind::Negative(inner) | ExprKind::Power(inner, _) | ExprKind::Field(inner, _) => is_written(inner),
        ExprKind::Matrix(..) => true,
    }
}

/// Does a formula ask for J?
fn mentions(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Number(_) => false,
        ExprKind::Name(name) => name == "J",
        ExprKind::Call(name, arguments) => name == "J" || arguments.iter().any(|a| mentions(&a.1)),
        ExprKind::Sum(parts) | ExprKind::Product(parts) => parts.iter().any(|p| mentions(&p.1)),
        ExprKind::Negative(inner) | ExprKind::Power(inner, _) | ExprKind::Field(inner, _) => mentions(inner),
        ExprKind::Matrix(_, entries) => entries.iter().any(mentions),
    }
}
