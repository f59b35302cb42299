//! Singular configurations: the determinant of the Jacobian, factored along the structure of the arm.
//!
//! **In:** a [`Chain`]. **Out:** [`Determinant`]: the columns written where they have most zeros, the blocks that these leave, the
//! factors of the blocks' determinants and what each says about the arm.
//!
//! The determinant depends neither on the point whose velocity is meant nor on the axes in which linear and angular parts are
//! written (both change the matrix by a factor of determinant 1). At the wrist centre, in the axes of a middle frame, textbook arms fall
//! into blocks (Whitney 1972; Paul and Stevenson 1983). All choices of point and axes are tried at a point of a prime field; only the
//! best one is written out. The product of the factors is compared with the Jacobian's determinant there as well.

mod blocks;
mod meaning;
mod reference_frame;

pub use blocks::Block;
pub use meaning::{Degeneracy, Meaning, Region};
pub use reference_frame::ReferenceFrame;

use crate::algebra::{Element, FieldPoint, Poly, Rational, Vector, cross, determinant, dot, minus};
use crate::chain::{Chain, Coordinate, Task};
use crate::kinematics::{Kinematics, jacobian};
use blocks::{Pattern, SIDE};
pub(in crate::kinematics) use reference_frame::relative_transform;
use reference_frame::{NumericFrame, Triple, frames};

/// Products of terms that one block may take.
const BUDGET: usize = 60_000;
/// Choices of point and axes that are written out, to find the shortest.
const WRITTEN: usize = 12;
/// Terms of a determinant of columns with themselves that is still written out.
const SHORT: usize = 12;

/// A tool motion that the task leaves open; it is added as a further column, so that the matrix is square.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Open {
    /// A shift along axis 0, 1, 2 of the base.
    Translation(usize),
    /// A turn of the tool about axis 0, 1, 2 of the base.
    Rotation(usize),
    /// A turn about the tool's z axis.
    Roll,
}

/// The determinant of a square Jacobian.
#[derive(Clone, Debug)]
pub struct Determinant {
    /// Joints of the first columns.
    pub joints: Vec<usize>,
    /// Motions of the other columns.
    pub open: Vec<Open>,
    /// The point whose velocity the linear rows hold: the origin of this frame.
    pub point: ReferenceFrame,
    /// Axes of the linear rows.
    pub linear: ReferenceFrame,
    /// Axes of the angular rows.
    pub angular: ReferenceFrame,
    /// The columns, linear rows first.
    pub columns: Vec<[Poly; SIDE]>,
    /// Blocks on the diagonal, whose determinants multiply up to that of the whole (up to sign).
    pub blocks: Vec<Block>,
    /// The number in front.
    pub number: Rational,
    /// Factors with their powers.
    pub factors: Vec<DeterminantFactor>,
}

/// A factor of the determinant.
#[derive(Clone, Debug)]
pub struct DeterminantFactor {
    /// The formula.
    pub value: Poly,
    /// Its power.
    pub power: u32,
    /// Whether it depends on the joints.
    pub moves: bool,
    /// What it means that it vanishes.
    pub meaning: Option<Meaning>,
}

/// What can be said about the determinant.
#[derive(Clone, Debug)]
pub enum Singular {
    /// The Jacobian is square, and this is its determinant.
    Determinant(Box<Determinant>),
    /// It vanishes everywhere: the joints of this arm never do all that is asked.
    Everywhere,
    /// Blocks were found, but one of this size is too long to write out.
    TooLong(usize),
    /// There are fewer joints than motions: the determinant of the Jacobian's transpose times itself, which vanishes where columns
    /// depend on each other; its value, and whether it is plainly positive.
    Gram(Poly, bool),
    /// There are more or fewer joints than motions, and no short formula says where columns depend on each other.
    NotSquare,
}

/// Derives the determinant for the joint coordinates (not the actuators).
pub fn singular(chain: &Chain, k: &Kinematics) -> Singular {
    let points = [FieldPoint::new(7), FieldPoint::new(8)];
    let views: Vec<View<'_>> = points.iter().map(|at| View { chain, frames: frames(k, at) }).collect();
    let chosen: Vec<usize> = chain.chosen().into_iter().map(|(k, _)| k).collect();
    let joints: Vec<usize> = (0..chain.dof()).filter(|j| !chosen.contains(j)).collect();
    let mut some = false;
    for open in choices(chain, &joints, &views) {
        some = true;
        let places = places(&views, &joints, &open, k.len());
        if places.is_empty() {
            continue;
        }
        let value = |at: &FieldPoint, view: &View<'_>| truth(chain, k, at, view, &joints, &open);
        let truths: Vec<Element> = points.iter().zip(&views).map(|(at, v)| value(at, v)).collect();
        if truths.iter().all(|x| *x == Element::ZERO) {
            continue;
        }
        return match derive(chain, k, &joints, open, places) {
            Ok(mut d) => match d.agree(&points, &truths) {
                true => {
                    if is_odd(&d.open) {
                        d.number = -&d.number;
                    }
                    meaning::explain(chain, k, &mut d);
                    Singular::Determinant(Box::new(d))
                }
                false => Singular::TooLong(SIDE),
            },
            Err(size) => Singular::TooLong(size),
        };
    }
    if some && chain.settings.task != Task::Pose {
        return Singular::Everywhere;
    }
    gram(chain, k).unwrap_or(Singular::NotSquare)
}

/// The determinant of J^T J, where it is short.
fn gram(chain: &Chain, k: &Kinematics) -> Option<Singular> {
    if chain.dof() > 3 {
        return None;
    }
    let columns = jacobian(chain, k);
    let product = |a: &(Vector, Vector), b: &(Vector, Vector)| &dot(&a.0, &b.0) + &dot(&a.1, &b.1);
    let m: Vec<Vec<Poly>> = columns.iter().map(|a| columns.iter().map(|b| product(a, b)).collect()).collect();
    let value = determinant(&m, BUDGET)?;
    let positive = value.is_sum_of_squares() && value.terms().iter().any(|(m, _)| m.is_one());
    (value.terms().len() <= SHORT).then_some(Singular::Gram(value, positive))
}

/// The columns of open motions stand behind those of the joints: is the determinant of all six rows the negative of that of the rows that
/// are left?
fn is_odd(open: &[Open]) -> bool {
    let row = |o: &Open| match o {
        Open::Translation(k) => Some(*k),
        Open::Rotation(k) => Some(3 + k),
        Open::Roll => None,
    };
    let Some(last) = open.iter().map(row).collect::<Option<Vec<usize>>>() else { return false };
    let order: Vec<usize> = (0..SIDE).filter(|r| !last.contains(r)).chain(last.iter().copied()).collect();
    let inversions = (0..order.len()).flat_map(|i| (i + 1..order.len()).map(move |j| (i, j)));
    inversions.filter(|(i, j)| order.get(*i) > order.get(*j)).count() % 2 == 1
}

/// Determinant of the coupling: the factor between the actuators' and the joints' Jacobian.
pub fn coupling(chain: &Chain) -> Option<Poly> {
    let whole = chain.dof() <= SIDE && chain.settings.redundant.is_empty() && !chain.is_direct();
    whole.then(|| determinant(&chain.drive, BUDGET)).flatten()
}

/// Which motions may be left out of account so that six columns remain; in order of preference.
fn choices(chain: &Chain, joints: &[usize], views: &[View<'_>]) -> Vec<Vec<Open>> {
    let n = joints.len();
    let last = |v: &View<'_>| v.frames.len() - 1;
    let zero = |r: usize| {
        views.iter().all(|v| joints.iter().all(|j| v.joint(*j, 0, 0, last(v)).get(r) == Some(&Element::ZERO)))
    };
    let still: Vec<usize> = (0..SIDE).filter(|r| zero(*r)).collect();
    let motion = |r: &usize| if *r < 3 { Open::Translation(*r) } else { Open::Rotation(*r - 3) };
    let (translations, rotations): (Vec<usize>, Vec<usize>) = still.iter().partition(|r| **r < 3);
    let position = || translations.iter().chain(&[3, 4, 5]).map(motion).collect::<Vec<Open>>();
    let orientation = || [0, 1, 2].iter().chain(&rotations).map(motion).collect::<Vec<Open>>();
    let natural = || still.iter().map(motion).collect::<Vec<Open>>();
    let all = match chain.settings.task {
        Task::Pose => vec![natural(), position(), orientation()],
        Task::Position => vec![position()],
        Task::Planar => vec![vec![Open::Translation(2), Open::Rotation(0), Open::Rotation(1)]],
        Task::Axis => vec![vec![Open::Roll]],
    };
    all.into_iter().filter(|o| o.len() + n == SIDE).collect()
}

/// The arm at a point of the field.
struct View<'a> {
    chain: &'a Chain,
    /// In the order of [`ReferenceFrame::all`].
    frames: Vec<NumericFrame>,
}

fn place(s: ReferenceFrame, n: usize) -> usize {
    match s {
        ReferenceFrame::Base => 0,
        ReferenceFrame::Link(i) => i + 1,
        ReferenceFrame::Tool => n + 2,
    }
}

impl View<'_> {
    /// Column of a joint: linear part in the axes of frame `a`, angular part in those of `b`, at the origin of `p`.
    fn joint(&self, joint: usize, a: usize, b: usize, p: usize) -> [Element; SIDE] {
        let Some(f) = self.frames.get(place(ReferenceFrame::of_joint(self.chain, joint), 0)) else {
            return [Element::ZERO; SIDE];
        };
        let prismatic = self.chain.joints.get(joint).is_some_and(|j| matches!(j.coordinate, Coordinate::Length(_)));
        self.written(prismatic, &f.axes[2], &f.origin, [a, b, p])
    }

    fn open(&self, open: Open, a: usize, b: usize, p: usize) -> [Element; SIDE] {
        let (Some(base), Some(tool)) = (self.frames.first(), self.frames.last()) else { return [Element::ZERO; SIDE] };
        match open {
            Open::Translation(k) => self.written(true, &base.axes[k], &tool.origin, [a, b, p]),
            Open::Rotation(k) => self.written(false, &base.axes[k], &tool.origin, [a, b, p]),
            Open::Roll => self.written(false, &tool.axes[2], &tool.origin, [a, b, p]),
        }
    }

    fn written(&self, prismatic: bool, z: &Triple, o: &Triple, [a, b, p]: [usize; 3]) -> [Element; SIDE] {
        let (a, b, p) = (&self.frames[a], &self.frames[b], &self.frames[p]);
        let (linear, angular) = if prismatic {
            (a.components(z), [Element::ZERO; 3])
        } else {
            (a.components(&cross(z, &minus(&p.origin, o))), b.components(z))
        };
        std::array::from_fn(|r| if r < 3 { linear[r] } else { angular[r - 3] })
    }

    fn columns(&self, joints: &[usize], open: &[Open], at: [usize; 3]) -> Vec<[Element; SIDE]> {
        let [a, b, p] = at;
        joints.iter().map(|j| self.joint(*j, a, b, p)).chain(open.iter().map(|o| self.open(*o, a, b, p))).collect()
    }
}

/// Sizes of the blocks, the greatest first; entries in them; way from the joints.
type Score = (Vec<usize>, usize, usize);
/// Axes of the linear rows, of the angular rows, the point, and the blocks.
type Written = ([ReferenceFrame; 3], Vec<Block>);

/// Points and axes with the smallest blocks; those with the fewest entries, then with the shortest way from the joints, come first.
fn places(views: &[View<'_>], joints: &[usize], open: &[Open], n: usize) -> Vec<Written> {
    let stands = ReferenceFrame::all(n);
    let Some(first) = views.first() else { return Vec::new() };
    let of_joint: Vec<usize> = joints.iter().map(|j| place(ReferenceFrame::of_joint(first.chain, *j), n)).collect();
    // Zeros of linear rows by axes and point, of angular rows by axes.
    let halves = |a: usize, p: usize| -> Pattern {
        let mut pattern: Pattern = [0; SIDE];
        for v in views {
            for (c, column) in v.columns(joints, open, [a, a, p]).iter().enumerate() {
                for (row, x) in pattern.iter_mut().zip(column) {
                    *row |= u8::from(*x != Element::ZERO) << c;
                }
            }
        }
        pattern
    };
    let mut found: Vec<(Score, Written)> = Vec::new();
    // Where every turn is left out, no other point than the tool's has its velocity.
    let fixed = (0..3).all(|k| open.contains(&Open::Rotation(k)));
    for p in if fixed { stands.len() - 1 } else { 0 }..stands.len() {
        let of_axes: Vec<Pattern> = (0..stands.len()).map(|a| halves(a, p)).collect();
        for (a, b) in (0..stands.len()).flat_map(|a| (0..stands.len()).map(move |b| (a, b))) {
            let pattern: Pattern = std::array::from_fn(|r| if r < 3 { of_axes[a][r] } else { of_axes[b][r] });
            let Some(list) = blocks::blocks(&pattern) else { continue };
            let mut sizes: Vec<usize> = list.iter().map(|b| b.rows.len()).collect();
            sizes.sort_unstable_by(|x, y| y.cmp(x));
            let inside = |b: &Block| {
                let mask: u8 = b.columns.iter().map(|c| 1u8 << c).sum();
                b.rows.iter().map(|r| (pattern[*r] & mask).count_ones() as usize).sum::<usize>()
            };
            let inside: usize = list.iter().map(inside).sum();
            let mut way = 0;
            for (r, row) in pattern.iter().enumerate() {
                for (_, joint) in of_joint.iter().enumerate().filter(|(c, _)| row >> c & 1 == 1) {
                    way += if r < 3 { a.abs_diff(*joint) + p.abs_diff(*joint) } else { b.abs_diff(*joint) };
                }
            }
            let Some(place) = stands.get(a).zip(stands.get(b)).zip(stands.get(p)) else { continue };
            let ((a, b), p) = place;
            found.push(((sizes, inside, way), ([*a, *b, *p], list)));
        }
    }
    found.sort_by(|x, y| x.0.cmp(&y.0));
    let best = found.first().map(|f| f.0.0.clone());
    found.into_iter().filter(|f| Some(&f.0.0) == best.as_ref()).map(|f| f.1).take(WRITTEN).collect()
}

/// The determinant of the Jacobian itself with the open motions: base axes, at the tool.
fn truth(chain: &Chain, k: &Kinematics, at: &FieldPoint, view: &View<'_>, joints: &[usize], open: &[Open]) -> Element {
    let all = jacobian(chain, k);
    let last = view.frames.len() - 1;
    let mut columns: Vec<[Element; SIDE]> = joints
        .iter()
        .filter_map(|j| all.get(*j))
        .map(|(v, w)| std::array::from_fn(|r| at.value(if r < 3 { &v[r] } else { &w[r - 3] })))
        .collect();
    columns.extend(open.iter().map(|o| view.open(*o, 0, 0, last)));
    eliminate(columns)
}

/// A determinant in the field.
fn eliminate(mut m: Vec<[Element; SIDE]>) -> Element {
    let mut product = Element::ONE;
    for i in 0..SIDE {
        let Some(pivot) = (i..m.len()).find(|c| m[*c][i] != Element::ZERO) else { return Element::ZERO };
        if pivot != i {
            m.swap(pivot, i);
            product = product.negative();
        }
        product = product.times(m[i][i]);
        let scale = m[i][i].inverse().negative();
        let head = m[i];
        for column in m.iter_mut().skip(i + 1) {
            let factor = column[i].times(scale);
            for (x, h) in column.iter_mut().zip(head) {
                *x = x.plus(h.times(factor));
            }
        }
    }
    product
}

/// The columns, exact.
fn columns(
    chain: &Chain,
    k: &Kinematics,
    joints: &[usize],
    open: &[Open],
    at: [ReferenceFrame; 3],
) -> Vec<[Poly; SIDE]> {
    let [linear, angular, point] = at;
    let (tool, tip) = (relative_transform(k, linear, ReferenceFrame::Tool).p, relative_transform(k, linear, point).p);
    let column = |prismatic: bool, z: [Vector; 2], o: &Vector| -> [Poly; SIDE] {
        let arm: Vector = std::array::from_fn(|i| &tip[i] - &o[i]);
        let v = if prismatic { z[0].clone() } else { cross(&z[0], &arm) };
        std::array::from_fn(|r| match r {
            0..3 => v[r].clone(),
            _ if prismatic => Poly::zero(),
            _ => z[1][r - 3].clone(),
        })
    };
    let of_joint = |j: &usize| {
        let s = ReferenceFrame::of_joint(chain, *j);
        let prismatic = chain.joints.get(*j).is_some_and(|j| matches!(j.coordinate, Coordinate::Length(_)));
        let t = relative_transform(k, linear, s);
        column(prismatic, [t.column(2), relative_transform(k, angular, s).column(2)], &t.p)
    };
    let of_open = |o: &Open| {
        let (s, axis) = match o {
            Open::Translation(axis) | Open::Rotation(axis) => (ReferenceFrame::Base, *axis),
            Open::Roll => (ReferenceFrame::Tool, 2),
        };
        let z = [relative_transform(k, linear, s).column(axis), relative_transform(k, angular, s).column(axis)];
        column(matches!(o, Open::Translation(_)), z, &tool)
    };
    joints.iter().map(of_joint).chain(open.iter().map(of_open)).collect()
}

/// Columns and factors, exact; the size of a block that is too long.
fn derive(
    chain: &Chain,
    k: &Kinematics,
    joints: &[usize],
    open: Vec<Open>,
    places: Vec<Written>,
) -> Result<Determinant, usize> {
    let entry = |columns: &[[Poly; SIDE]], r: usize, c: usize| columns.get(c).map_or_else(Poly::zero, |x| x[r].clone());
    let terms = |columns: &[[Poly; SIDE]], b: &Block| -> usize {
        let of_row = |r: &usize| b.columns.iter().map(|c| entry(columns, *r, *c).terms().len()).sum::<usize>();
        b.rows.iter().map(of_row).sum()
    };
    let written = places.into_iter().map(|(at, blocks)| {
        let columns = columns(chain, k, joints, &open, at);
        let length: usize = blocks.iter().map(|b| terms(&columns, b)).sum();
        (length, at, blocks, columns)
    });
    let Some((_, [linear, angular, point], blocks, columns)) = written.min_by_key(|w| w.0) else { return Err(SIDE) };
    let mut number = Rational::ONE;
    let mut factors: Vec<DeterminantFactor> = Vec::new();
    for b in &blocks {
        let row = |r: &usize| b.columns.iter().map(|c| entry(&columns, *r, *c)).collect();
        let m: Vec<Vec<Poly>> = b.rows.iter().map(row).collect();
        let value = determinant(&m, BUDGET).ok_or(m.len())?;
        let (x, list) = value.factors();
        number = &number * &x;
        for (p, n) in list {
            match factors.iter_mut().find(|f| f.value == p) {
                Some(f) => f.power += n,
                None => {
                    let moves = chain.joints.iter().any(|j| match j.coordinate {
                        Coordinate::Angle(v) => p.has_angle(v),
                        Coordinate::Length(s) => p.has_symbol(s),
                    });
                    factors.push(DeterminantFactor { value: p, power: n, moves, meaning: None });
                }
            }
        }
    }
    // Lengths first, then what moves.
    factors.sort_by_key(|f| f.moves);
    Ok(Determinant { joints: joints.to_vec(), open, point, linear, angular, columns, blocks, number, factors })
}

/// The determinant of one block; 0 where it is too long.
pub fn minor(d: &Determinant, b: &Block) -> Poly {
    let entry = |r: &usize, c: &usize| d.columns.get(*c).map_or_else(Poly::zero, |x| x[*r].clone());
    let m: Vec<Vec<Poly>> = b.rows.iter().map(|r| b.columns.iter().map(|c| entry(r, c)).collect()).collect();
    determinant(&m, BUDGET).unwrap_or_default()
}

impl Determinant {
    /// Gives the number in front the Jacobian's sign; false where the values differ by more than that.
    fn agree(&mut self, points: &[FieldPoint], truths: &[Element]) -> bool {
        let value = |at: &FieldPoint| {
            let number = at.value(&Poly::constant(self.number.clone()));
            self.factors.iter().fold(number, |x, f| x.times(at.value(&f.value).power(u64::from(f.power))))
        };
        let values: Vec<Element> = points.iter().map(value).collect();
        if values == truths {
            return true;
        }
        self.number = -&self.number;
        values.iter().zip(truths).all(|(x, y)| x.negative() == *y)
    }
}

#[cfg(test)]
mod tests;
