//! Forward programs (pose, frames, Jacobian) run on joint values, for one pose or for several side by side.

use dh_robot::sincos::{LIMIT, sincos_batch};
use dh_symbolic::algebra::LinearAngle;
use dh_symbolic::chain::{Chain, Coordinate};
use dh_symbolic::program::{Node, Program};

use crate::tape::{Instruction, Operand, Registers, Signed, run};
use crate::values::{Values, is_constant_angle};

/// Sines and cosines that are computed at once for a single pose.
const TOGETHER: usize = 8;

/// A straight-line program of the joint values.
pub(crate) struct Straight {
    registers: Registers,
    /// Angle sums of joints, with the registers of cosine and sine where they are needed.
    angles: Vec<(LinearAngle, [Option<Operand>; 2])>,
    /// Coordinates of sliding joints, with their registers.
    lengths: Vec<(usize, Operand)>,
    instructions: Vec<Instruction>,
    outputs: Vec<Signed>,
}

/// An angle sum in numbers.
struct Sum {
    /// Coordinates with their factors.
    terms: Vec<(usize, f64)>,
    constant: f64,
}

/// The numbers that a program needs of the arm's parameters.
pub(crate) struct StraightNumbers {
    prefix: Vec<f64>,
    sums: Vec<Sum>,
}

/// How joint coordinates of the formulas follow from joint values.
pub(crate) struct Coordinates {
    rows: Vec<Sum>,
}

impl Coordinates {
    /// The drive in numbers.
    pub(crate) fn new(values: &Values<'_>) -> Coordinates {
        let row = |(i, row): (usize, &Vec<_>)| {
            let factors = row.iter().map(|p| values.formula(p)).enumerate();
            Sum { terms: factors.filter(|(_, k)| *k != 0.0).collect(), constant: values.shift(i) }
        };
        Coordinates { rows: values.chain.drive.iter().enumerate().map(row).collect() }
    }

    /// The coordinates at joint values.
    pub(crate) fn at<const L: usize>(&self, q: &[[f64; L]]) -> Vec<[f64; L]> {
        self.rows.iter().map(|row| row.at(q)).collect()
    }
}

impl Sum {
    #[inline]
    fn at<const L: usize>(&self, x: &[[f64; L]]) -> [f64; L] {
        let mut sum: Option<[f64; L]> = None;
        for (i, k) in &self.terms {
            let term = x[*i].map(|x| k * x);
            sum = Some(match sum {
                None => term,
                Some(before) => std::array::from_fn(|l| before[l] + term[l]),
            });
        }
        let sum = sum.unwrap_or([0.0; L]);
        if self.constant == 0.0 { sum } else { sum.map(|x| x + self.constant) }
    }
}

/// Sines and cosines of several angles. One that takes the slow way (beyond the limit, or not finite) does not change the others.
fn sines<const L: usize>(angles: &[f64; L]) -> ([f64; L], [f64; L]) {
    let is_beyond = |x: f64| x.is_nan() || x.abs() > LIMIT;
    let (mut s, mut c) = sincos_batch(&angles.map(|x| if is_beyond(x) { 0.0 } else { x }));
    for (lane, x) in angles.iter().enumerate().filter(|(_, x)| is_beyond(**x)) {
        ([s[lane]], [c[lane]]) = sincos_batch(&[*x]);
    }
    (s, c)
}

impl Straight {
    /// The flat form of a proven program.
    pub(crate) fn new(chain: &Chain, program: &Program) -> Straight {
        let graph = &program.graph;
        let mut registers = Registers::new(chain, graph, &program.outputs);
        let mut angles: Vec<(LinearAngle, [Option<Operand>; 2])> = Vec::new();
        let mut lengths = Vec::new();
        let nodes: Vec<(usize, Node)> = graph.nodes().iter().copied().enumerate().collect();
        for (node, kind) in nodes {
            match kind {
                _ if !registers.live[node] => {}
                Node::Cos(i) | Node::Sin(i) => {
                    let sum = &graph.angle_sums()[i as usize];
                    if is_constant_angle(chain, sum) {
                        continue;
                    }
                    let place = registers.place(node, 1);
                    let known = match angles.iter().position(|(known, _)| known == sum) {
                        Some(known) => known,
                        None => {
                            angles.push((sum.clone(), [None; 2]));
                            angles.len() - 1
                        }
                    };
                    angles[known].1[usize::from(matches!(kind, Node::Sin(_)))] = Some(place);
                }
                Node::Symbol(s) => {
                    if let Some(joint) = chain.joints.iter().position(|j| j.coordinate == Coordinate::Length(s)) {
                        lengths.push((joint, registers.place(node, 1)));
                    }
                }
                _ => {}
            }
        }
        let computed: Vec<usize> = registers.computed().map(|(node, _)| node).collect();
        let instructions = computed.into_iter().filter_map(|node| registers.instruction(node, 1)).collect();
        let outputs = program.outputs.iter().map(|v| registers.value(*v)).collect();
        Straight { registers, angles, lengths, instructions, outputs }
    }

    /// What it needs of the parameters.
    pub(crate) fn numbers(&self, values: &Values<'_>) -> StraightNumbers {
        let sum = |angle: &LinearAngle| {
            let (mut terms, mut constant) = (Vec::new(), angle.constant.radians());
            for (v, k) in &angle.terms {
                match values.chain.joints.iter().position(|j| j.coordinate == Coordinate::Angle(*v)) {
                    Some(joint) => terms.push((joint, f64::from(*k))),
                    None => constant += f64::from(*k) * values.angle(*v),
                }
            }
            Sum { terms, constant }
        };
        StraightNumbers {
            prefix: self.registers.prefix(values),
            sums: self.angles.iter().map(|(angle, _)| sum(angle)).collect(),
        }
    }

    /// Registers to run it in, with what the parameters fill.
    pub(crate) fn space<const L: usize>(&self, numbers: &StraightNumbers) -> Vec<[f64; L]> {
        let mut x = vec![[0.0; L]; self.registers.count as usize];
        for (to, from) in x.iter_mut().zip(&numbers.prefix) {
            *to = [*from; L];
        }
        x
    }

    /// Runs it at joint coordinates.
    pub(crate) fn run<const L: usize>(&self, numbers: &StraightNumbers, coordinates: &[[f64; L]], x: &mut [[f64; L]]) {
        let mut set = |place: &[Option<Operand>; 2], c: [f64; L], s: [f64; L]| {
            for (place, lanes) in place.iter().zip([c, s]) {
                if let Some(place) = place {
                    x[place.at as usize] = lanes;
                }
            }
        };
        if L == 1 {
            for (sums, places) in numbers.sums.chunks(TOGETHER).zip(self.angles.chunks(TOGETHER)) {
                let mut angles = [0.0; TOGETHER];
                for (to, sum) in angles.iter_mut().zip(sums) {
                    *to = sum.at(coordinates)[0];
                }
                let (sines, cosines) = sines(&angles);
                for (k, (_, place)) in places.iter().enumerate() {
                    set(place, [cosines[k]; L], [sines[k]; L]);
                }
            }
        } else {
            for (sum, (_, place)) in numbers.sums.iter().zip(&self.angles) {
                let (s, c) = sines(&sum.at(coordinates));
                set(place, c, s);
            }
        }
        for (joint, place) in &self.lengths {
            x[place.at as usize] = coordinates[*joint];
        }
        run(&self.instructions, x);
    }

    /// Output number `i` of a run.
    #[inline]
    pub(crate) fn output<const L: usize>(&self, i: usize, x: &[[f64; L]]) -> [f64; L] {
        self.outputs[i].lanes(x)
    }
}
