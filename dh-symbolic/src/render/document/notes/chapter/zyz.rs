//! The last three joints as Z-Y-Z Euler angles, with the two poses in which their axes 4 and 6 coincide.

use super::pieper::{rotation, undone};
use super::positioning::{Positioning, turn};
use super::{Math, NotesWriter, Sample, Sign, Text};
use crate::algebra::{Angle, LinearAngle, Poly, Rational, Transform};
use crate::chain::{Convention, Elementary};
use crate::kinematics::Kinematics;
use crate::render::document::notes::side_by_side;
use dh_kernels::pose::{self, Pose};

/// How the wrist is a sequence of turns about z, y, z.
struct Sequence {
    /// Constant turns before and behind.
    before: Vec<Elementary>,
    behind: Vec<Elementary>,
    /// Signs of the fifth and the sixth joint.
    signs: [bool; 2],
    m: Transform,
}

impl Sequence {
    /// `None` where the twists of the wrist are no right angles.
    fn of(p: &Positioning, convention: Convention, kinematics: &Kinematics) -> Option<Sequence> {
        let wrist = kinematics.transform(3, 6)?;
        let wrist = Transform { p: Default::default(), ..wrist };
        let turns = |list: &[Elementary]| -> Vec<Elementary> {
            list.iter().filter(|e| matches!(e, Elementary::Rotate(..))).cloned().collect()
        };
        let (before, after) = match convention {
            Convention::Modified => (turns(&p.between[2]), vec![]),
            Convention::Standard => (vec![], turns(&p.between[5])),
        };
        let half = Elementary::Rotate(0, LinearAngle::constant(Angle::half_turns(Rational::ONE)));
        let y = |negative: bool| {
            let (c, s) = Poly::cos_sin(p.angles[4]);
            Transform::rotation(1, (&c, &if negative { -&s } else { s }))
        };
        let z = |negative: bool| {
            let t = turn(p.angles[5]);
            if negative { t.inverse() } else { t }
        };
        for turned in [false, true] {
            let behind: Vec<Elementary> = if turned { vec![half.clone()] } else { vec![] };
            let m = rotation(&before).inverse().times(&wrist).times(&rotation(&after).inverse());
            let m = m.times(&rotation(&behind));
            for signs in [[false, false], [true, false], [false, true], [true, true]] {
                let all = turn(p.angles[3]).times(&y(signs[0])).times(&z(signs[1]));
                if all.r == m.r {
                    let mut list: Vec<Elementary> = undone(&after);
                    list.extend(behind);
                    return Some(Sequence { before, behind: list, signs, m });
                }
            }
        }
        None
    }
}

impl NotesWriter<'_> {
    pub(super) fn orientation(&mut self, p: &Positioning, sample: Option<&Sample>) {
        self.title(2, "The last three joints", "后三个关节");
        let kinematics = Kinematics::new(self.chain);
        self.tell_both(
            "With the first three joints known, what is left of the orientation is",
            "前三个关节已知后，剩下的姿态为",
            &[],
        );
        self.show_numbered("@R36 = @R03^{-1}\\thin @R06", &[]);
        let Some(s) = Sequence::of(p, self.chain.convention, &kinematics) else {
            self.tell_both(
                "The twists of this wrist are no right angles, so its turns are no Euler angles: the fifth joint follows from one element of this matrix, the fourth and the sixth from two more each.",
                "该手腕的扭转角不是直角，其转动不是欧拉角：由该矩阵的一个元素求第五个关节，再各由两个元素求第四、第六个关节。",
                &[],
            );
            return;
        };
        let angle = |w: &Self, k: usize, negative: bool| {
            let name = w.coordinate(k);
            if negative { Math::Row(vec![Math::Sign(Sign::Negative), name]) } else { name }
        };
        let list = [angle(self, 3, false), angle(self, 4, s.signs[0]), angle(self, 5, s.signs[1])];
        let mut product = self.motions_of(&undone(&s.before));
        product.push(self.formula("@R36", &[]));
        product.extend(self.motions_of(&s.behind));
        self.tell_both(
            "The wrist turns about three axes of which each is perpendicular to the next. But for constant turns these are Z-Y-Z Euler angles $\\alpha$, $\\beta$, $\\gamma$:",
            "手腕绕三根依次垂直的轴转动。除去固定的转动，它们就是 Z-Y-Z 欧拉角 $\\alpha$、$\\beta$、$\\gamma$：",
            &[],
        );
        let [a, b, c] = list.clone();
        let whole = side_by_side(product);
        self.show_numbered("M = #0 = R_z(#1)\\thin R_y(#2)\\thin R_z(#3)", &[whole, a.clone(), b.clone(), c.clone()]);
        self.tell_both(
            "so that $\\alpha = #0$, $\\beta = #1$, $\\gamma = #2$, and multiplied out",
            "即 $\\alpha = #0$，$\\beta = #1$，$\\gamma = #2$；展开得",
            &[a, b, c],
        );
        let entries: Vec<Vec<Math>> = (1..=3)
            .map(|i| (1..=3).map(|j| Math::Letter('m').below(Math::number(format!("{i}{j}")))).collect())
            .collect();
        self.show_numbered(
            "M = #0 = \\mat{c\\alpha c\\beta c\\gamma - s\\alpha s\\gamma & -c\\alpha c\\beta s\\gamma - s\\alpha c\\gamma & c\\alpha s\\beta; s\\alpha c\\beta c\\gamma + c\\alpha s\\gamma & -s\\alpha c\\beta s\\gamma + c\\alpha c\\gamma & s\\alpha s\\beta; -s\\beta c\\gamma & s\\beta s\\gamma & c\\beta}",
            &[Math::Matrix(entries)],
        );
        self.tell_both(
            "If $\\beta$ is neither $0\\deg$ nor $180\\deg$,",
            "若 $\\beta$ 不为 $0\\deg$ 或 $180\\deg$：",
            &[],
        );
        self.show(
            &[
                "\\beta = \\atan2(\\either\\sqrt{m_{31}^2 + m_{32}^2},m_{33})",
                "\\alpha = \\atan2(\\frac{m_{23}}{s\\beta},\\frac{m_{13}}{s\\beta})",
                "\\gamma = \\atan2(\\frac{m_{32}}{s\\beta},-\\frac{m_{31}}{s\\beta})",
            ],
            &[],
        );
        self.tell_both(
            "The lower sign flips the wrist: $(\\alpha,\\beta,\\gamma)$ becomes $(\\alpha + 180\\deg,-\\beta,\\gamma + 180\\deg)$, the same orientation.",
            "取负号时手腕翻转：$(\\alpha,\\beta,\\gamma)$ 变为 $(\\alpha + 180\\deg,-\\beta,\\gamma + 180\\deg)$，姿态不变。",
            &[],
        );
        self.points(
            &[
                (
                    "If $\\beta = 0\\deg$, the axes of joints 4 and 6 coincide and only $\\alpha + \\gamma$ is determined. One takes $0\\deg$ for $\\alpha$; then $\\gamma = \\atan2(-m_{12},m_{11})$.",
                    "若 $\\beta = 0\\deg$，关节 4、6 的轴线重合，只能确定 $\\alpha + \\gamma$。令 $\\alpha$ 为 $0\\deg$，则 $\\gamma = \\atan2(-m_{12},m_{11})$。",
                ),
                (
                    "If $\\beta = 180\\deg$, only $\\alpha - \\gamma$ is determined. One takes $0\\deg$ for $\\alpha$; then $\\gamma = \\atan2(m_{12},-m_{11})$.",
                    "若 $\\beta = 180\\deg$，只能确定 $\\alpha - \\gamma$。令 $\\alpha$ 为 $0\\deg$，则 $\\gamma = \\atan2(m_{12},-m_{11})$。",
                ),
            ],
            &[],
        );
        if let Some(sample) = sample {
            self.wrist_in_numbers(&s, sample);
        }
    }

    fn wrist_in_numbers(&mut self, s: &Sequence, sample: &Sample) {
        let Some(solution) = sample.found.get(sample.chosen) else { return };
        let x = sample.arm.coordinates(&solution.q);
        let kinematics = Kinematics::new(&sample.arm.chain);
        let Some(first) = kinematics.transform(0, 3) else { return };
        let first: Pose = sample.arm.numbers(&first, &x);
        let whole = sample.inner();
        let wrist = pose::compose(&pose::inverse(&first), &whole);
        let m: Pose = sample.arm.numbers(&s.m, &x);
        self.title(2, "The orientation in numbers", "姿态的数值");
        let r = [first, whole, wrist, m].map(|t| self.rotation(&t));
        self.tell_both("For the same solution", "对同一组解", &[]);
        self.show(&["@R03 = #0", "@R06 = #1", "@R36 = #2", "M = #3"], &r);
        let sine = m[2][0].hypot(m[2][1]);
        if sine < 1e-9 {
            self.tell_both(
                "Here $\\sin\\beta = 0$: the wrist is singular, and the joints 4 and 6 can be turned against each other.",
                "此处 $\\sin\\beta = 0$：手腕奇异，关节 4 与关节 6 可反向转动。",
                &[],
            );
            return;
        }
        self.tell_both("both signs of the root give", "根号取两种符号，得", &[]);
        let names = ["\\beta", "\\alpha", "\\gamma", "@q4", "@q5", "@q6"];
        let mut header: Vec<Text> = names.map(|t| Text::from(self.formula(t, &[]))).to_vec();
        header.push(self.both("solution", "解").into());
        let sign = |negative: bool| if negative { -1.0 } else { 1.0 };
        let rows = [1.0, -1.0].map(|root| {
            let beta = (root * sine).atan2(m[2][2]);
            let alpha = (root * m[1][2]).atan2(root * m[0][2]);
            let gamma = (root * m[2][1]).atan2(-root * m[2][0]);
            let last = [alpha, sign(s.signs[0]) * beta, sign(s.signs[1]) * gamma];
            let all: Vec<f64> = x.iter().take(3).copied().chain(last).collect();
            let angles = [beta, alpha, gamma].into_iter().chain(last);
            let mut row: Vec<Text> = angles.map(|x| Text::from(self.degrees(x))).collect();
            row.push(self.solutions_at(sample, &all));
            row
        });
        self.blocks.push(super::Block::Table(header, rows.to_vec()));
    }
}
