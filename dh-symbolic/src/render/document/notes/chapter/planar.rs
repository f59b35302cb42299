//! The planar arm of two links and a hand, as every lecture begins: by the triangle, by algebra, and by the tangent of the half angle.

use super::{Block, Equation, Math, NotesWriter, Sample, Sign, Start, Text};
use crate::algebra::{AngleVar, Factor, Poly, Rational};
use crate::chain::{Chain, Convention, Coordinate};
use crate::kinematics::Kinematics;
use crate::render::document::frames::Frame;

/// Two links that turn about parallel axes, and perhaps a hand that turns about a third one.
struct TwoLinks {
    /// Numbers of the turning joints.
    joints: Vec<usize>,
    /// The lengths of both links.
    links: [Poly; 2],
    /// The wrist (the tip, where there is no hand) seen from the frame that is given, in its plane.
    back: [Poly; 2],
    /// Whether the tool belongs to the second link.
    tool: bool,
}

impl TwoLinks {
    fn of(chain: &Chain, k: &Kinematics) -> Option<TwoLinks> {
        let turning = |j: &usize| matches!(chain.joints.get(*j).map(|j| j.coordinate), Some(Coordinate::Angle(_)));
        let joints: Vec<usize> = (0..chain.dof()).filter(turning).collect();
        if !(2..=3).contains(&joints.len()) {
            return None;
        }
        let var = |j: usize| match chain.joints.get(*joints.get(j)?)?.coordinate {
            Coordinate::Angle(v) => Some(v),
            Coordinate::Length(_) => None,
        };
        let (first, second) = (var(0)?, var(1)?);
        let n = chain.links.len();
        let tool = joints.len() == 2;
        let whole = match tool {
            true => k.transform(0, n)?.times(k.tool()),
            false => k.transform(0, n)?,
        };
        let wrist = match joints.get(2) {
            Some(j) => {
                let row = chain.joints.get(*j)?.row;
                k.transform(0, if chain.convention == Convention::Modified { row + 1 } else { row })?.p
            }
            None => whole.p.clone(),
        };
        // The wrist seen from the last frame must stand still in its plane.
        let back = match joints.get(2) {
            Some(j) => {
                let row = chain.joints.get(*j)?.row;
                let frame = if chain.convention == Convention::Modified { row + 1 } else { row };
                let [x, y, _] = k.transform(frame, n)?.inverse().p;
                [x, y]
            }
            None => [Poly::zero(), Poly::zero()],
        };
        let moves = |p: &Poly| {
            chain.joints.iter().any(|j| match j.coordinate {
                Coordinate::Angle(v) => p.has_angle(v),
                Coordinate::Length(s) => p.has_symbol(s),
            })
        };
        // x = l1 c1 + l2 c12 and y alike, exactly
        let factor = |harmonic: &[(AngleVar, i8)]| before_cosine(&wrist[0], harmonic);
        let links = [factor(&[(first, 1)])?, factor(&[(first, 1), (second, 1)])?];
        let sum = |sine: bool| {
            let one = &links[0] * &Poly::harmonic(&[(first, 1)], sine);
            &one + &(&links[1] * &Poly::harmonic(&[(first, 1), (second, 1)], sine))
        };
        let upright = whole.r[2][0].is_zero() && whole.r[2][1].is_zero() && whole.r[2][2].is_one();
        let all: Option<Vec<(AngleVar, i8)>> = (0..joints.len()).map(|j| Some((var(j)?, 1))).collect();
        let fits = wrist[0] == sum(false)
            && wrist[1] == sum(true)
            && upright
            && whole.r[0][0] == Poly::harmonic(&all?, false)
            && !back.iter().any(moves)
            && !links.iter().any(|l| l.is_zero() || moves(l));
        fits.then_some(TwoLinks { joints, links, back, tool })
    }
}

/// What stands before the cosine of this sum of angles.
fn before_cosine(p: &Poly, harmonic: &[(AngleVar, i8)]) -> Option<Poly> {
    let wanted = Poly::harmonic(harmonic, false);
    let group = harmonic.first()?.0.group();
    let parts = p.collect(|f| match f {
        Factor::Cos(t) | Factor::Sin(t) => t.iter().any(|(v, _)| v.group() == group),
        Factor::Power(..) | Factor::Root(_) => false,
    });
    let found = parts.into_iter().find(|(m, _)| Poly::term(m.clone(), Rational::ONE) == wanted);
    found.map(|(_, p)| p)
}

/// The joint angles of the triangle, in radians.
struct Numbers {
    x: f64,
    y: f64,
    phi: f64,
    links: [f64; 2],
    cosine: f64,
}

impl Numbers {
    /// The angles of joints 1, 2 and 3 for a sign of the elbow's sine.
    fn angles(&self, sign: f64) -> [f64; 3] {
        let second = (sign * (1.0 - self.cosine * self.cosine).max(0.0).sqrt()).atan2(self.cosine);
        let (k1, k2) = (self.links[0] + self.links[1] * second.cos(), self.links[1] * second.sin());
        let wrapped = |x: f64| x.sin().atan2(x.cos());
        let first = wrapped(self.y.atan2(self.x) - k2.atan2(k1));
        [first, second, wrapped(self.phi - first - second)]
    }
}

impl NotesWriter<'_> {
    /// The part of the note; nothing where the arm is no such arm.
    pub(in super::super) fn planar_arm(&mut self, start: Option<&Start>) {
        self.with_table_angles(start, |w, sample| {
            let kinematics = Kinematics::new(w.chain);
            let Some(arm) = TwoLinks::of(w.chain, &kinematics) else { return };
            let index = |i: usize| arm.joints.get(i).map_or(0, |j| j + 1);
            let joint = |w: &NotesWriter<'_>, i: usize| w.coordinate(index(i).saturating_sub(1));
            let sum = {
                let vars = arm.joints.iter().take(2).filter_map(|j| match w.chain.joints.get(*j)?.coordinate {
                    Coordinate::Angle(v) => Some((v, 1)),
                    Coordinate::Length(_) => None,
                });
                let vars: Vec<(AngleVar, i8)> = vars.collect();
                [false, true].map(|sine| {
                    w.notation.trig(&crate::render::formula::expression::Trig { angles: vars.clone(), sine })
                })
            };
            let lengths = [&arm.links[0], &arm.links[1]].map(|l| w.notation.typeset(&w.group(l)));
            let squares = [&arm.links[0], &arm.links[1]].map(|l| w.notation.typeset(&w.group(&l.square())));
            let (c1, s1) = (format!("@c{}", index(0)), format!("@s{}", index(0)));
            let trig = [c1, s1, format!("@c{}", index(1)), format!("@s{}", index(1))].map(|t| w.formula(&t, &[]));
            let [l1, l2] = lengths;
            let [l1s, l2s] = squares;
            let [c1, s1, c2, s2] = trig;
            let [c12, s12] = sum;
            let third = if arm.joints.len() > 2 { joint(w, 2) } else { Math::number(0) };
            // 0 l1, 1 l2, 2 l1^2, 3 l2^2, 4 c1, 5 s1, 6 c2, 7 s2, 8 c12, 9 s12, 10 theta1, 11 theta2, 12 theta3
            let pieces = [l1, l2, l1s, l2s, c1, s1, c2, s2, c12, s12, joint(w, 0), joint(w, 1), third];
            w.wrist_apart = arm.back.iter().any(|p| !p.is_zero()) || !w.chain.tool.is_empty() && !arm.tool;
            w.title(1, "The planar arm", "平面机械臂");
            w.tell_both(
                "Seen along its turning axes the arm has two links, $#0$ and $#1$.",
                "沿转动轴方向看，机械臂有两根连杆，长度为 $#0$ 和 $#1$。",
                &pieces,
            );
            w.table_angles();
            let numbers = sample.map(|s| w.planar_goal(&arm, s));
            w.wanted_in_plane(&arm, numbers.as_ref(), sample);
            w.by_triangle(&arm, &pieces, numbers.as_ref());
            w.by_algebra(&arm, &pieces);
            let second = sample.and_then(|s| {
                let x = s.arm.coordinates(&s.found.get(s.chosen)?.q);
                x.get(*arm.joints.get(1)?).copied()
            });
            w.by_half_angle(&pieces, numbers.as_ref(), second.map_or(1.0, |x| x.sin().signum()));
            if let (Some(n), Some(sample)) = (&numbers, sample) {
                w.both_elbows(&arm, n, sample, &pieces);
            }
        });
    }

    fn planar_goal(&self, arm: &TwoLinks, sample: &Sample) -> Numbers {
        let inner = sample.inner();
        let value = |p: &Poly| sample.arm.evaluate(p, &[]);
        let pose = match arm.tool {
            true => {
                let tool = Kinematics::new(&sample.arm.chain);
                dh_kernels::pose::compose(&inner, &sample.arm.numbers(tool.tool(), &[]))
            }
            false => inner,
        };
        let back = [value(&arm.back[0]), value(&arm.back[1])];
        let place = |i: usize| pose[i][3] + pose[i][0] * back[0] + pose[i][1] * back[1];
        let links = [value(&arm.links[0]), value(&arm.links[1])];
        let (x, y) = (place(0), place(1));
        let cosine = (x * x + y * y - links[0] * links[0] - links[1] * links[1]) / (2.0 * links[0] * links[1]);
        Numbers { x, y, phi: pose[1][0].atan2(pose[0][0]), links, cosine }
    }

    /// x, y, phi from the given pose.
    fn wanted_in_plane(&mut self, arm: &TwoLinks, numbers: Option<&Numbers>, sample: Option<&Sample>) {
        let n = Frame::Row(self.chain.links.len());
        let end = if arm.tool && !self.chain.tool.is_empty() { Frame::Tool } else { n };
        let pose = self.notation.transform(Frame::Row(0), end);
        let hand = arm.joints.len() > 2;
        // r and p are those of the given pose
        let own = self.chain.base.is_empty() && (end == Frame::Tool || self.chain.tool.is_empty());
        let letters: [Math; 2] = if own { ["r_{ij}", "p"] } else { ["t_{ij}", "t_{i4}"] }.map(|t| self.formula(t, &[]));
        let [letter, _] = &letters;
        if hand {
            self.tell_both(
                "The third joint turns the hand. Given are the wrist $(@x,@y)$ and the direction $\\phi$ of the hand, from the elements $#1$ of $#0$:",
                "第三个关节转动手部。已知腕点 $(@x,@y)$ 和手部方向 $\\phi$，由 $#0$ 的元素 $#1$ 得：",
                &[pose, letter.clone()],
            );
        } else {
            self.tell_both(
                "Given is the tip $(@x,@y)$, from the fourth column $#1$ of $#0$:",
                "已知末端 $(@x,@y)$，由 $#0$ 的第四列 $#1$ 得：",
                &[pose, letters[1].clone()],
            );
        }
        let entry = |i: usize, j: usize| match (own, j) {
            (true, 4) => Math::Letter('p').below(Math::Letter(if i == 1 { 'x' } else { 'y' })),
            (true, _) => Math::Letter('r').below(Math::number(format!("{i}{j}"))),
            (false, _) => Math::Letter('t').below(Math::number(format!("{i}{j}"))),
        };
        let place = |w: &Self, i: usize| {
            let mut row = vec![entry(i, 4)];
            for (j, p) in arm.back.iter().enumerate().filter(|(_, p)| !p.is_zero()) {
                let negative = p.terms().first().is_some_and(|t| t.1.is_negative());
                let size = if negative { -p } else { p.clone() };
                row.push(Math::Sign(if negative { Sign::Minus } else { Sign::Plus }));
                let size = w.notation.typeset(&w.group(&size));
                row.push(size);
                row.push(entry(i, j + 1));
            }
            Math::Row(row)
        };
        let mut list = vec![
            Equation { left: self.formula("@x", &[]), right: vec![place(self, 1)], number: None },
            Equation { left: self.formula("@y", &[]), right: vec![place(self, 2)], number: None },
        ];
        if hand {
            list.push(self.written("\\phi = \\atan2(#0,#1)", &[entry(2, 1), entry(1, 1)]));
        }
        self.blocks.push(Block::Equations(list));
        if let (Some(n), Some(sample)) = (numbers, sample) {
            self.at_solution(sample);
            let values = [self.real(n.x), self.real(n.y), self.degrees(n.phi)];
            if hand {
                self.tell_both("$@x = #0$, $@y = #1$, $\\phi = #2$.", "$@x = #0$，$@y = #1$，$\\phi = #2$。", &values);
            } else {
                self.tell_both("$@x = #0$, $@y = #1$.", "$@x = #0$，$@y = #1$。", &values);
            }
        }
    }

    fn by_triangle(&mut self, arm: &TwoLinks, pieces: &[Math], numbers: Option<&Numbers>) {
        self.title(2, "By geometry: the triangle", "几何法：三角形");
        self.tell_both(
            "Shoulder, elbow and wrist are the corners of a triangle with the sides $#0$, $#1$ and $\\sqrt{@x^2 + @y^2}$. Its angle at the elbow is $180\\deg - #11$ (up to sign), so by the law of cosines",
            "肩、肘、腕构成三角形，三边为 $#0$、$#1$ 和 $\\sqrt{@x^2 + @y^2}$。肘处内角为 $180\\deg - #11$（不计符号），由余弦定理",
            pieces,
        );
        self.show_numbered("@x^2 + @y^2 = #2 + #3 - 2#0#1\\cos(180\\deg - #11)", pieces);
        self.show(&["#6 = \\frac{@x^2 + @y^2 - #2 - #3}{2#0#1}"], pieces);
        self.tell_both(
            "There is a triangle only if this is between $-1$ and $1$. Then $#11$ has two values, one for each sign: the elbow on either side of the line from shoulder to wrist. That line has the direction $\\beta$, and the triangle has the angle $\\psi$ at the shoulder, $0\\deg \\le \\psi \\le 180\\deg$:",
            "仅当此值在 $-1$ 与 $1$ 之间时三角形存在。此时 $#11$ 有正负两个值，即肘在肩腕连线的两侧。连线的方向角为 $\\beta$，三角形在肩处的内角为 $\\psi$（$0\\deg \\le \\psi \\le 180\\deg$）：",
            pieces,
        );
        self.show(
            &["\\beta = \\atan2(@y,@x)", "\\cos\\psi = \\frac{@x^2 + @y^2 + #2 - #3}{2#0\\sqrt{@x^2 + @y^2}}"],
            pieces,
        );
        self.points(
            &[
                ("$#11$ negative: $#10 = \\beta + \\psi$.", "$#11$ 为负：$#10 = \\beta + \\psi$。"),
                ("$#11$ positive: $#10 = \\beta - \\psi$.", "$#11$ 为正：$#10 = \\beta - \\psi$。"),
            ],
            pieces,
        );
        if arm.joints.len() > 2 {
            self.tell_both("What is left of $\\phi$ is the hand's:", "余下的角由手部实现：", &[]);
            self.show(&["#12 = \\phi - #10 - #11"], pieces);
        }
        let Some(n) = numbers else { return };
        let distance = n.x.hypot(n.y);
        let [a, b] = n.links;
        let cosine = (n.x * n.x + n.y * n.y + a * a - b * b) / (2.0 * a * distance);
        let beta = self.degrees(n.y.atan2(n.x));
        let mut all = pieces.to_vec();
        all.extend([self.real(n.cosine), beta, self.real(cosine), self.degrees(cosine.clamp(-1.0, 1.0).acos())]);
        self.tell_both(
            "In numbers $#6 = #13$, $\\beta = #14$, $\\cos\\psi = #15$, $\\psi = #16$.",
            "数值：$#6 = #13$，$\\beta = #14$，$\\cos\\psi = #15$，$\\psi = #16$。",
            &all,
        );
    }

    fn by_algebra(&mut self, arm: &TwoLinks, pieces: &[Math]) {
        self.title(2, "By algebra", "代数法");
        self.tell_both("The forward kinematics says", "由正运动学", &[]);
        self.show_numbered("@x = #0#4 + #1#8", pieces);
        self.show_numbered("@y = #0#5 + #1#9", pieces);
        self.tell_both("Both squared and added, $#10$ drops out:", "两式平方相加，消去 $#10$：", pieces);
        self.show(
            &["@x^2 + @y^2 = #2 + #3 + 2#0#1#6", "#7 = \\either\\sqrt{1 - #6^2}", "#11 = \\atan2(#7,#6)"],
            pieces,
        );
        self.tell_both("With $#11$ known, $k_1$ and $k_2$ are numbers,", "$#11$ 已知后，$k_1$、$k_2$ 均为数，", pieces);
        self.show(&["k_1 = #0 + #1#6", "k_2 = #1#7", "@x = k_1#4 - k_2#5", "@y = k_1#5 + k_2#4"], pieces);
        self.tell_both(
            "and in polar form, $k_1 = r\\cos\\gamma$ and $k_2 = r\\sin\\gamma$, these are sums of angles:",
            "写成极坐标形式 $k_1 = r\\cos\\gamma$，$k_2 = r\\sin\\gamma$，即为角的和：",
            &[],
        );
        self.show(
            &[
                "r = \\sqrt{k_1^2 + k_2^2}",
                "\\gamma = \\atan2(k_2,k_1)",
                "\\frac{@x}{r} = \\cos(\\gamma + #10)",
                "\\frac{@y}{r} = \\sin(\\gamma + #10)",
                "#10 = \\atan2(@y,@x) - \\atan2(k_2,k_1)",
            ],
            pieces,
        );
        if arm.joints.len() > 2 {
            self.show(&["#12 = \\phi - #10 - #11"], pieces);
        }
        self.tell_both(
            "So $\\gamma$ is the angle $\\psi$ of the triangle with the sign of $#11$: another elbow, another $k_2$, another $#10$.",
            "可见 $\\gamma$ 就是三角形的角 $\\psi$，符号与 $#11$ 相同：肘换到另一侧，$k_2$ 变号，$#10$ 随之改变。",
            pieces,
        );
    }

    fn by_half_angle(&mut self, pieces: &[Math], numbers: Option<&Numbers>, elbow: f64) {
        self.title(2, "By the tangent of the half angle", "半角正切代换");
        self.tell_both(
            "An equation in the sine and the cosine of one angle becomes a polynomial with the tangent of half the angle. In $k_1#4 - k_2#5 = @x$",
            "含一个角的正弦和余弦的方程，用半角的正切代换即成为多项式。对 $k_1#4 - k_2#5 = @x$，令",
            pieces,
        );
        self.show(&["u = \\tan\\frac{#10}{2}", "#4 = \\frac{1 - u^2}{1 + u^2}", "#5 = \\frac{2u}{1 + u^2}"], pieces);
        self.tell_both("is put in and multiplied by $1 + u^2$:", "代入并乘以 $1 + u^2$，得", &[]);
        self.show_numbered("(k_1 + @x)u^2 + 2k_2u + (@x - k_1) = 0", &[]);
        self.tell_both("so that", "于是", &[]);
        self.show(&["u = \\frac{-k_2 \\pm \\sqrt{k_1^2 + k_2^2 - @x^2}}{k_1 + @x}", "#10 = 2\\atan2(u,1)"], pieces);
        self.tell_both(
            "Of both roots the equation for $@y$ leaves one. If $k_1 + @x = 0$ the equation is linear, and the other root is $#10 = 180\\deg$.",
            "两个根中只有一个满足 $@y$ 的方程。若 $k_1 + @x = 0$，方程为一次，另一根为 $#10 = 180\\deg$。",
            pieces,
        );
        let Some(n) = numbers else { return };
        let [first, second, _] = n.angles(elbow);
        let (k1, k2) = (n.links[0] + n.links[1] * second.cos(), n.links[1] * second.sin());
        let root = (k1 * k1 + k2 * k2 - n.x * n.x).max(0.0).sqrt();
        if (k1 + n.x).abs() < 1e-9 * (1.0 + k1.abs()) {
            return;
        }
        let values = [root, -root].map(|r| (-k2 + r) / (k1 + n.x));
        let good = |u: f64| (2.0 * u.atan() - first).sin().abs() < 1e-9;
        let (own, other) = if good(values[0]) { (values[0], values[1]) } else { (values[1], values[0]) };
        let mut all = pieces.to_vec();
        all.extend([self.degrees(second), self.real(own), self.degrees(first), self.real(other)]);
        all.push(self.degrees(2.0 * other.atan()));
        self.tell_both(
            "For $#11 = #13$: $u = #14$, $#10 = #15$; the root $#16$ ($#17$) does not give this $@y$.",
            "取 $#11 = #13$：$u = #14$，$#10 = #15$；根 $#16$（$#17$）不满足 $@y$ 的方程。",
            &all,
        );
    }

    /// Both solutions, with their numbers in the worked example.
    fn both_elbows(&mut self, arm: &TwoLinks, n: &Numbers, sample: &Sample, pieces: &[Math]) {
        if n.cosine.abs() > 1.0 {
            self.tell_both("This place is out of reach.", "该位置不可达。", &[]);
            return;
        }
        let letters = ["#7", "k_1", "k_2", "r", "\\gamma"].map(|t| Text::from(self.formula(t, pieces)));
        let mut header: Vec<Text> = letters.to_vec();
        header.extend(arm.joints.iter().map(|j| Text::from(self.coordinate(*j))));
        header.push(self.both("solution", "解").into());
        let rows = [1.0, -1.0].map(|sign| {
            let angles = n.angles(sign);
            let mut all = vec![f64::NAN; self.chain.dof()];
            arm.joints.iter().zip(angles).for_each(|(j, a)| all[*j] = a);
            let second = angles[1];
            let (k1, k2) = (n.links[0] + n.links[1] * second.cos(), n.links[1] * second.sin());
            let mut row: Vec<Text> = [second.sin(), k1, k2, k1.hypot(k2)].map(|x| Text::from(self.real(x))).to_vec();
            row.push(self.degrees(k2.atan2(k1)).into());
            row.extend(arm.joints.iter().zip(angles).map(|(_, a)| Text::from(self.degrees(a))));
            row.push(self.solutions_at(sample, &all));
            row
        });
        self.tell_both("Both solutions, with their numbers in the worked example:", "两组解及其在算例中的编号：", &[]);
        self.blocks.push(Block::Table(header, rows.to_vec()));
    }
}
