//! How the frames of a table are found on the arm, how a link transform is made of four elementary ones, and the same arm in the other
//! convention.

use super::{Block, Equation, Math, NotesWriter, Sign, Text};
use crate::algebra::{LinearAngle, Poly};
use crate::chain::{Convention, Elementary, Link};

/// How two neighbouring axes lie.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Lie {
    Same,
    Parallel,
    Meeting,
    Skew,
}

fn lie(link: &Link) -> Lie {
    let parallel = link.alpha.cos_sin().is_some_and(|(_, s)| s.is_zero());
    match (parallel, link.a.is_zero()) {
        (true, true) => Lie::Same,
        (true, false) => Lie::Parallel,
        (false, true) => Lie::Meeting,
        (false, false) => Lie::Skew,
    }
}

impl NotesWriter<'_> {
    /// From the axes to the frames.
    pub(in super::super) fn construction(&mut self) {
        let n = self.chain.links.len();
        if n == 0 {
            return;
        }
        let modified = self.chain.convention == Convention::Modified;
        self.title(1, "How the frames are found", "坐标系的建立");
        self.tell_both(
            "Link 0 is the ground; joint $i$ moves link $i$ against link $i - 1$. The frames are found in this order:",
            "连杆 0 为地杆；关节 $i$ 使连杆 $i$ 相对连杆 $i - 1$ 运动。按以下顺序建立坐标系：",
            &[],
        );
        let list: &[(&str, &str)] = if modified {
            &[
                ("Draw the joint axes $1$ to $#0$.", "画出关节轴 $1$ 至 $#0$。"),
                (
                    "Draw the common normal of each axis and the next one. Where they meet, mark the point; where they are parallel, choose one of the normals.",
                    "作相邻两轴的公垂线；两轴相交时标出交点，平行时任选一条公垂线。",
                ),
                ("$Z_i$ along axis $i$.", "$Z_i$ 沿第 $i$ 轴。"),
                (
                    "$X_i$ along the normal from axis $i$ to axis $i + 1$; where the axes meet, perpendicular to both. The origin is where this normal leaves axis $i$.",
                    "$X_i$ 沿由第 $i$ 轴指向第 $i + 1$ 轴的公垂线；两轴相交时与两轴都垂直。原点为公垂线在第 $i$ 轴上的垂足。",
                ),
                ("$Y_i$ completes a right-handed frame.", "$Y_i$ 按右手定则确定。"),
                (
                    "Frame $0$ coincides with frame $1$ when the first variable is zero; $X_#0$ is chosen along $X_#1$ when the last one is zero, so that as many entries of the table as possible vanish.",
                    "第一个关节变量为零时，坐标系 $0$ 与坐标系 $1$ 重合；最后一个变量为零时，$X_#0$ 取与 $X_#1$ 同向，使表中尽可能多的参数为零。",
                ),
            ]
        } else {
            &[
                ("Draw the joint axes $1$ to $#0$.", "画出关节轴 $1$ 至 $#0$。"),
                (
                    "Draw the common normal of each axis and the next one. Where they meet, mark the point; where they are parallel, choose one of the normals.",
                    "作相邻两轴的公垂线；两轴相交时标出交点，平行时任选一条公垂线。",
                ),
                ("$Z_i$ along axis $i + 1$; $Z_#0$ is free.", "$Z_i$ 沿第 $i + 1$ 轴；$Z_#0$ 可任选。"),
                (
                    "$X_i$ along the normal from axis $i$ to axis $i + 1$; where the axes meet, perpendicular to both. The origin is where this normal arrives at axis $i + 1$.",
                    "$X_i$ 沿由第 $i$ 轴指向第 $i + 1$ 轴的公垂线；两轴相交时与两轴都垂直。原点为公垂线在第 $i + 1$ 轴上的垂足。",
                ),
                ("$Y_i$ completes a right-handed frame.", "$Y_i$ 按右手定则确定。"),
                (
                    "Frame $0$ has its $Z_0$ along axis $1$, its origin and $X_0$ are free; frame $#0$ sits at the tip.",
                    "坐标系 $0$ 的 $Z_0$ 沿第 $1$ 轴，原点和 $X_0$ 可任选；坐标系 $#0$ 位于末端。",
                ),
            ]
        };
        let pieces = [Math::number(n), Math::number(n - 1)];
        self.points(list, &pieces);
        self.tell_both(
            "The table then says how far it is from one to the next:",
            "表中参数即相邻坐标系之间的量：",
            &[],
        );
        let measures: &[(&str, &str)] = if modified {
            &[
                (
                    "$\\alpha_{i - 1}$: angle from $Z_{i - 1}$ to $Z_i$, about $X_{i - 1}$;",
                    "$\\alpha_{i - 1}$：绕 $X_{i - 1}$ 由 $Z_{i - 1}$ 转到 $Z_i$ 的角；",
                ),
                (
                    "$a_{i - 1}$: distance from $Z_{i - 1}$ to $Z_i$, along $X_{i - 1}$;",
                    "$a_{i - 1}$：沿 $X_{i - 1}$ 由 $Z_{i - 1}$ 到 $Z_i$ 的距离；",
                ),
                (
                    "$d_i$: distance from $X_{i - 1}$ to $X_i$, along $Z_i$;",
                    "$d_i$：沿 $Z_i$ 由 $X_{i - 1}$ 到 $X_i$ 的距离；",
                ),
                (
                    "$\\theta_i$: angle from $X_{i - 1}$ to $X_i$, about $Z_i$.",
                    "$\\theta_i$：绕 $Z_i$ 由 $X_{i - 1}$ 转到 $X_i$ 的角。",
                ),
            ]
        } else {
            &[
                (
                    "$\\theta_i$: angle from $X_{i - 1}$ to $X_i$, about $Z_{i - 1}$;",
                    "$\\theta_i$：绕 $Z_{i - 1}$ 由 $X_{i - 1}$ 转到 $X_i$ 的角；",
                ),
                (
                    "$d_i$: distance from $X_{i - 1}$ to $X_i$, along $Z_{i - 1}$;",
                    "$d_i$：沿 $Z_{i - 1}$ 由 $X_{i - 1}$ 到 $X_i$ 的距离；",
                ),
                (
                    "$a_i$: distance from $Z_{i - 1}$ to $Z_i$, along $X_i$;",
                    "$a_i$：沿 $X_i$ 由 $Z_{i - 1}$ 到 $Z_i$ 的距离；",
                ),
                (
                    "$\\alpha_i$: angle from $Z_{i - 1}$ to $Z_i$, about $X_i$.",
                    "$\\alpha_i$：绕 $X_i$ 由 $Z_{i - 1}$ 转到 $Z_i$ 的角。",
                ),
            ]
        };
        self.points(measures, &[]);
        self.axes_of_this_arm();
        self.title(2, "Choices", "选择");
        let choices: &[(&str, &str)] = if modified {
            &[
                (
                    "$Z_i$ may point either way: reversed, $\\theta_i$ and $d_i$ change their signs, $\\alpha_{i - 1}$ and $\\alpha_i$ change by $180\\deg$.",
                    "$Z_i$ 有两个方向可选：反向时 $\\theta_i$、$d_i$ 变号，$\\alpha_{i - 1}$、$\\alpha_i$ 改变 $180\\deg$。",
                ),
                (
                    "Where the axes meet, $X_i$ may point either way: reversed, $\\alpha_i$ (and $a_i$) change their signs, $\\theta_i$ and $\\theta_{i + 1}$ change by $180\\deg$.",
                    "两轴相交时 $X_i$ 有两个方向可选：反向时 $\\alpha_i$（及 $a_i$）变号，$\\theta_i$、$\\theta_{i + 1}$ 改变 $180\\deg$。",
                ),
            ]
        } else {
            &[
                (
                    "$Z_i$ may point either way: reversed, $\\theta_{i + 1}$ and $d_{i + 1}$ change their signs, $\\alpha_i$ and $\\alpha_{i + 1}$ change by $180\\deg$.",
                    "$Z_i$ 有两个方向可选：反向时 $\\theta_{i + 1}$、$d_{i + 1}$ 变号，$\\alpha_i$、$\\alpha_{i + 1}$ 改变 $180\\deg$。",
                ),
                (
                    "Where the axes meet, $X_i$ may point either way: reversed, $\\alpha_i$ (and $a_i$) change their signs, $\\theta_i$ and $\\theta_{i + 1}$ change by $180\\deg$.",
                    "两轴相交时 $X_i$ 有两个方向可选：反向时 $\\alpha_i$（及 $a_i$）变号，$\\theta_i$、$\\theta_{i + 1}$ 改变 $180\\deg$。",
                ),
            ]
        };
        self.points(choices, &[]);
    }

    /// How the axes of this arm lie.
    fn axes_of_this_arm(&mut self) {
        let n = self.chain.links.len();
        if n < 2 {
            return;
        }
        self.title(2, "On this arm", "本臂的坐标系");
        let header = [("axes", "轴"), ("how they lie", "相对位置"), ("angle", "夹角"), ("distance", "距离")]
            .map(|(e, c)| Text::from(self.both(e, c)));
        let rows = (1..n).filter_map(|i| {
            let link = self.crossing(i)?;
            let lie = match lie(link) {
                Lie::Same => self.both("one line", "重合"),
                Lie::Parallel => self.both("parallel", "平行"),
                Lie::Meeting => self.both("they meet", "相交"),
                Lie::Skew => self.both("skew", "异面"),
            };
            let axes = Text::from(format!("{i}, {}", i + 1));
            let distance = self.notation.typeset(&self.group(&link.a));
            Some(vec![axes, lie.into(), self.angle(&link.alpha).into(), distance.into()])
        });
        let rows = rows.collect();
        self.blocks.push(Block::Table(header.to_vec(), rows));
    }

    /// The four motions one by one.
    pub(in super::super) fn elementary(&mut self) {
        if self.chain.links.is_empty() {
            return;
        }
        self.title(1, "A link transform from four motions", "由四个基本变换得到连杆变换");
        let modified = self.chain.convention == Convention::Modified;
        let index = if modified { "i - 1" } else { "i" };
        let names = [format!("\\alpha_{{{index}}}"), format!("a_{{{index}}}"), "\\theta_i".into(), "d_i".into()];
        let pieces: Vec<Math> = names.iter().map(|n| self.formula(n, &[])).collect();
        if modified {
            self.tell_both(
                "From frame $i - 1$ to frame $i$ there are four motions, each in the frame that the one before has made: a rotation about $X_{i - 1}$, a translation along it, a rotation about $Z_i$, a translation along it.",
                "由坐标系 $i - 1$ 到坐标系 $i$ 经过四个运动，每个都在前一个得到的坐标系中进行：绕 $X_{i - 1}$ 转动，沿其移动，绕 $Z_i$ 转动，沿其移动。",
                &[],
            );
        } else {
            self.tell_both(
                "From frame $i - 1$ to frame $i$ there are four motions, each in the frame that the one before has made: a rotation about $Z_{i - 1}$, a translation along it, a translation along $X_i$, a rotation about it.",
                "由坐标系 $i - 1$ 到坐标系 $i$ 经过四个运动，每个都在前一个得到的坐标系中进行：绕 $Z_{i - 1}$ 转动，沿其移动，沿 $X_i$ 移动，绕其转动。",
                &[],
            );
        }
        let turn_x = "R_x(#0) = \\mat{1 & 0 & 0 & 0; 0 & c#0 & -s#0 & 0; 0 & s#0 & c#0 & 0; 0 & 0 & 0 & 1}";
        let way_x = "D_x(#1) = \\mat{1 & 0 & 0 & #1; 0 & 1 & 0 & 0; 0 & 0 & 1 & 0; 0 & 0 & 0 & 1}";
        let turn_z = "R_z(#2) = \\mat{c#2 & -s#2 & 0 & 0; s#2 & c#2 & 0 & 0; 0 & 0 & 1 & 0; 0 & 0 & 0 & 1}";
        let way_z = "D_z(#3) = \\mat{1 & 0 & 0 & 0; 0 & 1 & 0 & 0; 0 & 0 & 1 & #3; 0 & 0 & 0 & 1}";
        let both_x =
            "R_x(#0)\\thin D_x(#1) = \\mat{1 & 0 & 0 & #1; 0 & c#0 & -s#0 & 0; 0 & s#0 & c#0 & 0; 0 & 0 & 0 & 1}";
        let both_z =
            "R_z(#2)\\thin D_z(#3) = \\mat{c#2 & -s#2 & 0 & 0; s#2 & c#2 & 0 & 0; 0 & 0 & 1 & #3; 0 & 0 & 0 & 1}";
        let (first, second) = ([turn_x, way_x], [turn_z, way_z]);
        let order = if modified { [first, second] } else { [second, first] };
        for [first, second] in order {
            let Equation { left, mut right, .. } = self.written(first, &pieces);
            let second = self.formula(second, &pieces);
            let first = right.pop().unwrap_or(Math::number(0));
            let row = Math::Row(vec![first, Math::Sign(Sign::Comma), Math::Sign(Sign::Wide), second]);
            self.blocks.push(Block::Equations(vec![Equation { left, right: vec![row], number: None }]));
        }
        self.tell_both(
            "A rotation about an axis and a translation along it may change places. The pairs are",
            "绕某轴的转动与沿该轴的移动可以交换次序。两两相乘得",
            &[],
        );
        if modified {
            self.show(&[both_x, both_z], &pieces)
        } else {
            self.show(&[both_z, both_x], &pieces)
        }
        self.general();
        self.tell_both(
            "Products of these lead from any frame to any other: in $#0$ the inner indices cancel.",
            "这些变换的乘积可联系任意两个坐标系：在 $#0$ 中，中间的上下标相消。",
            &[self.chained()],
        );
    }

    fn chained(&self) -> Math {
        let n = self.chain.links.len();
        let product = super::super::side_by_side((1..=n).map(|i| self.link_name(i - 1, i)).collect());
        Math::equation(self.link_name(0, n), product)
    }

    /// The same arm in the other convention, and what joins the frames of both.
    pub(in super::super) fn conventions(&mut self) {
        let n = self.chain.links.len();
        if n == 0 {
            return;
        }
        let modified = self.chain.convention == Convention::Modified;
        self.title(1, "Standard and modified parameters", "标准型与改进型参数");
        self.tell_both(
            "Both conventions describe the same motions, rotation about a joint axis, translation along it, translation along the common normal, twist, and cut them at different places. Standard: frame $i$ sits behind the twist, on axis $i + 1$. Modified (Craig): frame $i$ sits before the translation along the normal, on axis $i$.",
            "两种约定描述同一串运动：绕关节轴转动、沿关节轴移动、沿公垂线移动、扭转，只是切分位置不同。标准型：坐标系 $i$ 在扭转之后，位于第 $i + 1$ 轴上；改进型（Craig）：坐标系 $i$ 在沿公垂线移动之前，位于第 $i$ 轴上。",
            &[],
        );
        self.show(
            &[
                "S_i = R_z(\\theta_i)\\thin D_z(d_i)\\thin D_x(a_i)\\thin R_x(\\alpha_i)",
                "Q_i = R_x(\\alpha_{i - 1})\\thin D_x(a_{i - 1})\\thin R_z(\\theta_i)\\thin D_z(d_i)",
            ],
            &[],
        );
        self.tell_both(
            "With $N_i = R_x(\\alpha_i)\\thin D_x(a_i)$, standard frame $i$ is modified frame $i$ moved by $N_i$, a constant; and",
            "记 $N_i = R_x(\\alpha_i)\\thin D_x(a_i)$（常量），标准型坐标系 $i$ 由改进型坐标系 $i$ 经 $N_i$ 得到，且",
            &[],
        );
        let factor = |letter: char, i: usize| Math::Letter(letter).below(Math::number(i));
        let row = |letter: char| (1..=n).map(move |i| factor(letter, i));
        let left = std::iter::once(factor('N', 0)).chain(row('S')).collect();
        let right = row('Q').chain([factor('N', n)]).collect();
        let sides = [left, right].map(super::super::side_by_side);
        self.show_numbered("#0 = #1", &sides);
        if modified {
            let list = match self.tool_link() {
                Some(_) => (
                    "The same arm with standard parameters (row $i$ lists $a$ and $\\alpha$ of link $i$):",
                    "同一台臂的标准型参数（第 $i$ 行给出连杆 $i$ 的 $a$ 与 $\\alpha$）：",
                ),
                None => (
                    "The same arm with standard parameters (row $i$ lists $a$ and $\\alpha$ of link $i$; nothing follows the last joint):",
                    "同一台臂的标准型参数（第 $i$ 行给出连杆 $i$ 的 $a$ 与 $\\alpha$；最后一个关节之后为零）：",
                ),
            };
            self.tell_both(list.0, list.1, &[]);
        } else {
            self.tell_both(
                "The same arm with modified parameters (row $i$ lists $\\alpha$ and $a$ of link $i - 1$; nothing precedes the first joint):",
                "同一台臂的改进型参数（第 $i$ 行给出连杆 $i - 1$ 的 $\\alpha$ 与 $a$；第一个关节之前为零）：",
                &[],
            );
        }
        self.other_table(modified);
        self.joined(modified);
    }

    fn other_table(&mut self, modified: bool) {
        let zero = || (LinearAngle::constant(crate::algebra::Angle::ZERO), Poly::zero());
        let n = self.chain.links.len();
        let cells = |i: usize| self.crossing(i).map_or_else(zero, |l| (l.alpha.clone(), l.a.clone()));
        let header: Vec<Text> = if modified {
            ["i", "\\theta_i", "d_i", "a_i", "\\alpha_i"].map(|t| Text::from(self.formula(t, &[]))).to_vec()
        } else {
            ["i", "\\alpha_{i - 1}", "a_{i - 1}", "d_i", "\\theta_i"].map(|t| Text::from(self.formula(t, &[]))).to_vec()
        };
        let length = |p: &Poly| self.notation.typeset(&self.group(p));
        let rows = (1..=n).filter_map(|i| {
            let link = self.chain.links.get(i - 1)?;
            let (alpha, a) = match (modified, i) {
                (true, i) if i == n => self.tool_link().map_or_else(zero, |l| (l.alpha, l.a)),
                (true, i) => cells(i),
                (false, 1) => zero(),
                (false, i) => cells(i - 1),
            };
            let [alpha, a] = [self.angle(&alpha), length(&a)];
            let [d, theta] = [length(&link.d), self.angle(&link.theta)];
            let row = if modified { [theta, d, a, alpha] } else { [alpha, a, d, theta] };
            Some(std::iter::once(Math::number(i)).chain(row).map(Text::from).collect())
        });
        let rows = rows.collect();
        self.blocks.push(Block::Table(header, rows));
    }

    /// Where the tool is a way along the last x axis and a turn about it: the last row of the standard table.
    fn tool_link(&self) -> Option<Link> {
        let mut link = Link {
            alpha: LinearAngle::constant(crate::algebra::Angle::ZERO),
            a: Poly::zero(),
            d: Poly::zero(),
            theta: LinearAngle::constant(crate::algebra::Angle::ZERO),
            joint: None,
        };
        match self.chain.tool.as_slice() {
            [Elementary::Translate(0, a)] => link.a = a.clone(),
            [Elementary::Rotate(0, alpha)] => link.alpha = alpha.clone(),
            [Elementary::Translate(0, a), Elementary::Rotate(0, alpha)]
            | [Elementary::Rotate(0, alpha), Elementary::Translate(0, a)] => {
                (link.a, link.alpha) = (a.clone(), alpha.clone());
            }
            _ => return None,
        }
        Some(link)
    }

    /// The constant transforms at both ends.
    fn joined(&mut self, modified: bool) {
        let n = self.chain.links.len();
        let motions = |link: Option<&Link>| -> Vec<Elementary> {
            let Some(link) = link else { return Vec::new() };
            let list = [Elementary::Rotate(0, link.alpha.clone()), Elementary::Translate(0, link.a.clone())];
            list.into_iter().filter(|e| !e.is_identity()).collect()
        };
        let tool = self.tool_link().filter(|_| modified);
        if tool.is_some() {
            let right = super::super::side_by_side(self.motions_of(&motions(tool.as_ref())));
            self.tell_both(
                "The tool is such a constant: the standard table takes it into its last row,",
                "工具变换正是这样的常量，标准型把它归入最后一行：",
                &[],
            );
            let left = Math::Letter('N').below(Math::number(n));
            self.blocks.push(Block::Equations(vec![Equation { left, right: vec![right], number: None }]));
        }
        let constant = if modified { motions(self.crossing(0)) } else { motions(self.crossing(n)) };
        let name = Math::Letter('N').below(Math::number(if modified { 0 } else { n }));
        if constant.is_empty() {
            if tool.is_some() {
                self.tell_both("and $N_0 = I$.", "且 $N_0 = I$。", &[]);
            } else if modified {
                self.tell_both(
                    "Here $N_0 = I$ and, with nothing behind the last joint, $N_#0 = I$: both products are the same.",
                    "这里 $N_0 = I$，最后一个关节之后无固定变换，$N_#0 = I$：两个乘积相同。",
                    &[Math::number(n)],
                );
            } else {
                self.tell_both(
                    "Here $N_#0 = I$ and, with nothing before the first joint, $N_0 = I$: both products are the same.",
                    "这里 $N_#0 = I$，第一个关节之前无固定变换，$N_0 = I$：两个乘积相同。",
                    &[Math::number(n)],
                );
            }
        } else {
            let right = super::super::side_by_side(self.motions_of(&constant));
            let equation = Equation { left: name, right: vec![right], number: None };
            if modified {
                self.tell_both(
                    "What stands before the first joint becomes a base transform:",
                    "第一个关节之前的固定变换归入基座变换：",
                    &[],
                );
            } else {
                self.tell_both(
                    "What stands behind the last joint becomes a tool transform:",
                    "最后一个关节之后的固定变换归入工具变换：",
                    &[],
                );
            }
            self.blocks.push(Block::Equations(vec![equation]));
        }
        self.tell_both("The frames between differ by these constants:", "中间各坐标系相差以下常量：", &[]);
        let list = (1..n).map(|i| {
            let factors = self.motions_of(&motions(self.crossing(i)));
            let right = if factors.is_empty() { Math::Letter('I') } else { super::super::side_by_side(factors) };
            Equation { left: Math::Letter('N').below(Math::number(i)), right: vec![right], number: None }
        });
        let list: Vec<Equation> = list.collect();
        if !list.is_empty() {
            self.blocks.push(Block::Equations(list));
        }
    }
}
