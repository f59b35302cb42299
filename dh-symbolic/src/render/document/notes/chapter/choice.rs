//! How many solutions an arm has, how they belong together, and which one is taken.

use super::positioning::Positioning;
use super::{Block, Math, NotesWriter, Sample, Start, Text};
use crate::algebra::{Angle, LinearAngle, Poly, Rational, Transform};
use crate::chain::Chain;
use crate::kinematics::Kinematics;

/// Rows of the table of bounds: what vanishes, in formulas, and the bound.
const BOUNDS: [(&str, usize); 5] = [
    ("@any", 16),
    ("a_3", 16),
    ("a_3,\\thin a_5", 16),
    ("a_1,\\thin a_3,\\thin a_5", 16),
    ("a_4,\\thin a_5,\\thin d_5", 8),
];

/// Which rows of that table hold for an arm.
fn rows_of(chain: &Chain, w: &NotesWriter<'_>) -> [bool; 5] {
    let zero = |i: usize| w.crossing(i).is_some_and(|l| l.a.is_zero());
    let wrist = Positioning::of(chain).is_some();
    [true, zero(3), zero(3) && zero(5), zero(1) && zero(3) && zero(5), wrist]
}

/// Does a flip of the last three joints leave the last frame where it is?
fn flips(p: &Positioning, kinematics: &Kinematics) -> bool {
    let Some(wrist) = kinematics.transform(3, 6) else { return false };
    let half = || Angle::half_turns(Rational::ONE);
    let flipped = |v| {
        let [_, _, _, a, b, c] = p.angles;
        if v == a || v == c {
            Some(LinearAngle { terms: vec![(v, 1)], constant: half() })
        } else {
            (v == b).then(|| LinearAngle { terms: vec![(v, -1)], constant: Angle::ZERO })
        }
    };
    let image = |p: &Poly| p.substitute_angles(flipped);
    let entries = |t: &Transform| -> Vec<Poly> {
        (0..3).flat_map(|i| (0..4).map(move |j| (i, j))).map(|(i, j)| t.entry(i, j)).collect()
    };
    entries(&wrist).iter().all(|e| image(e).as_ref() == Some(e))
}

impl NotesWriter<'_> {
    /// The part of the note; nothing where the arm has no inverse.
    pub(in super::super) fn solutions_part(&mut self, start: Option<&Start>) {
        self.with_table_angles(start, |w, sample| {
            let solved = w.solved();
            let Ok(inverse) = &*solved else { return };
            w.title(1, "How many solutions, and which one", "解的个数与选择");
            w.tell_both(
                "The equations of the inverse are not linear: that there are as many of them as unknowns does not make the solution unique.",
                "逆运动学方程是非线性的：方程个数与未知量个数相同并不意味着解唯一。",
                &[],
            );
            let six = w.chain.dof() == 6
                && w.chain.joints.iter().all(|j| matches!(j.coordinate, crate::chain::Coordinate::Angle(_)));
            if six {
                w.bounds_of_six();
            }
            match inverse.plan.max_solutions {
                1 => w.tell_both("This arm has at most one solution.", "这台机械臂最多有一个解。", &[]),
                n => w.tell_both(
                    "The steps of the inverse give this arm at most $#0$ solutions.",
                    "按逆运动学各步，这台机械臂最多有 $#0$ 个解。",
                    &[Math::number(n)],
                ),
            }
            if let Some(p) = Positioning::of(w.chain) {
                w.flip(&p, sample);
            }
            if let Some(sample) = sample.filter(|s| s.found.len() > 1) {
                w.which_one(sample);
            }
        });
    }

    fn bounds_of_six(&mut self) {
        self.tell_both(
            "For six turning joints the number depends on which lengths vanish. As a table, the row of this arm marked (the last that fits):",
            "六个转动关节的臂，解数取决于哪些参数为零。列表如下，“本臂”标出适用的最后一行：",
            &[],
        );
        let fits = rows_of(self.chain, self);
        let last = fits.iter().rposition(|f| *f).unwrap_or(0);
        let header = [("lengths that vanish", "为零的参数"), ("at most", "最多"), ("this arm", "本臂")]
            .map(|(e, c)| self.both(e, c).into());
        let rows = BOUNDS.iter().enumerate().map(|(i, (what, n))| {
            let condition = match *what {
                "@any" => Text::from(self.both("none", "无")),
                what => Text::from(self.formula(what, &[])),
            };
            let mark = if i == last { self.both("this arm", "本臂") } else { "" };
            vec![condition, Math::number(n).into(), mark.into()]
        });
        let rows = rows.collect();
        self.blocks.push(Block::Table(header.to_vec(), rows));
        self.tell_both(
            "In the last row the axes of joints 4, 5 and 6 meet: four positions of the first three joints, two of the wrist. Older books and slides give 8 in the third row and 4 in the fourth. These are no bounds: the FANUC CRX-10iA belongs to the fourth row, and it has poses with 16 solutions.",
            "最后一行是关节 4、5、6 轴线交于一点的情形：前三个关节四组，手腕两组。一些教材和课件在第三行给出 8，第四行给出 4，这并不是上界：FANUC CRX-10iA 属于第四行，却有 16 个解的位姿。",
            &[],
        );
    }

    /// The second solution of a spherical wrist.
    fn flip(&mut self, p: &Positioning, sample: Option<&Sample>) {
        if !flips(p, &Kinematics::new(self.chain)) {
            return;
        }
        self.title(2, "The flip of the wrist", "手腕翻转");
        self.tell_both(
            "Each solution has a twin with the same arm and the wrist flipped over:",
            "每组解都有一组孪生解：前三个关节不变，手腕翻转：",
            &[],
        );
        self.show(&["@q4^' = @q4 + 180\\deg", "@q5^' = -@q5", "@q6^' = @q6 + 180\\deg"], &[]);
        self.tell_both(
            "With $@q5 = 0\\deg$ both are one, and $@q4$ and $@q6$ can be turned against each other.",
            "当 $@q5 = 0\\deg$ 时两组解重合，$@q4$ 与 $@q6$ 可反向转动。",
            &[],
        );
        let Some(sample) = sample else { return };
        let angles: Vec<Vec<f64>> = sample.found.iter().map(|f| sample.arm.coordinates(&f.q)).collect();
        let apart = |a: f64, b: f64| (a - b).sin().atan2((a - b).cos()).abs() > 1e-6;
        let twins = |a: &[f64], b: &[f64]| {
            let same = a.iter().zip(b).take(3).all(|(a, b)| !apart(*a, *b));
            same && a.len() == 6 && b.len() == 6 && !apart(a[4], -b[4]) && apart(a[3], b[3])
        };
        let mut pairs = Vec::new();
        for (i, a) in angles.iter().enumerate() {
            for (j, b) in angles.iter().enumerate().skip(i + 1) {
                if twins(a, b) {
                    pairs.push(format!("{} – {}", i + 1, j + 1));
                }
            }
        }
        if !pairs.is_empty() {
            let sentence = match self.options.language {
                crate::render::Language::English => {
                    format!("Twins among the solutions of the worked example: {}.", pairs.join(", "))
                }
                crate::render::Language::Chinese => format!("算例各解中的孪生解：{}。", pairs.join("，")),
            };
            self.blocks.push(Block::Paragraph(sentence.into()));
        }
    }

    /// What speaks for one of several solutions, in numbers.
    fn which_one(&mut self, sample: &Sample) {
        let arm = &sample.arm;
        self.title(2, "Which solution is taken", "解的选择");
        self.tell_both("A controller takes one of them:", "控制器从中选取一组：", &[]);
        self.points(
            &[
                (
                    "only those within the ranges of the joints and clear of obstacles count;",
                    "只考虑在关节范围内且不与障碍物相碰的解；",
                ),
                (
                    "the nearest one to where the arm is, in the sum of squares of the joint motions: a smooth motion that saves energy;",
                    "离当前位置最近者，即各关节运动量的平方和最小：运动平稳、省能；",
                ),
                (
                    "or the one whose largest joint motion is smallest: the fastest, if all joints are equally fast. A long link may count more than a short one: weights before the squares say so.",
                    "或最大关节运动量最小者：若各关节速度相同，则最快。可用加权使大关节少动、小关节多动。",
                ),
            ],
            &[],
        );
        let revolute = (0..arm.dof()).all(|k| arm.is_revolute(k));
        if !revolute {
            return;
        }
        let travel =
            |q: &[f64]| -> Vec<f64> { (0..arm.dof()).map(|k| arm.distance_of(k, q[k], sample.near[k])).collect() };
        let all: Vec<(f64, f64, bool)> = sample
            .found
            .iter()
            .map(|f| {
                let t = travel(&f.q);
                let largest = t.iter().fold(0.0f64, |m, x| m.max(x.abs()));
                (t.iter().map(|x| x * x).sum::<f64>().sqrt(), largest, f.in_range)
            })
            .collect();
        let list: Vec<Math> = (0..arm.dof()).map(|k| self.value_of(arm, k, sample.near[k], 0)).collect();
        let mut text = Text::from(self.both("In the worked example, with the arm at ", "算例中，设机械臂当前位于 "));
        text.0.extend(super::super::inverse::listed(&list));
        text.0.push(super::Span::Plain(self.both(":", "：").into()));
        self.blocks.push(Block::Paragraph(text));
        let header = [
            ("solution", "解"),
            ("root of the sum of squares", "平方和的平方根"),
            ("largest motion", "最大运动量"),
            ("in range", "范围内"),
        ]
        .map(|(e, c)| Text::from(self.both(e, c)));
        let rows = all.iter().enumerate().map(|(i, (sum, largest, fits))| {
            let fits = if *fits { self.both("yes", "是") } else { self.both("no", "否") };
            vec![(i + 1).to_string().into(), self.degrees(*sum).into(), self.degrees(*largest).into(), fits.into()]
        });
        let rows = rows.collect();
        self.blocks.push(Block::Table(header.to_vec(), rows));
        let best = |by: &dyn Fn(&(f64, f64, bool)) -> f64| {
            let fit = all.iter().enumerate().filter(|(_, a)| a.2);
            // equal ones but for rounding: the nearer
            let key = |a: &(f64, f64, bool)| (by(a) * 1e7).round();
            let order =
                |a: &(f64, f64, bool), b: &(f64, f64, bool)| key(a).total_cmp(&key(b)).then(a.0.total_cmp(&b.0));
            fit.min_by(|a, b| order(a.1, b.1)).map(|(i, _)| Math::number(i + 1))
        };
        match (best(&|a| a.0), best(&|a| a.1)) {
            (Some(near), Some(least)) if near == least => self.tell_both(
                "Of those in range, solution $#0$ is the nearest; its largest motion is the smallest, too.",
                "在范围内的解中，第 $#0$ 组最近，其最大运动量也最小。",
                &[near],
            ),
            (Some(near), Some(least)) => self.tell_both(
                "Of those in range, solution $#0$ is the nearest, and solution $#1$ has the smallest largest motion.",
                "在范围内的解中，第 $#0$ 组最近，第 $#1$ 组的最大运动量最小。",
                &[near, least],
            ),
            _ => self.tell_both("None is in range.", "没有一组在范围内。", &[]),
        }
    }
}
