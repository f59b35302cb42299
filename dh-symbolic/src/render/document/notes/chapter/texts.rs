//! What holds for every arm: direction cosines and homogeneous coordinates, accuracy and repeatability, and the methods by which equations
//! in sines and cosines are solved.

use super::{Block, NotesWriter, Sample, Start};
use crate::render::document::frames::Frame;

impl NotesWriter<'_> {
    /// Orientation by nine cosines, position and orientation in one matrix.
    pub(in super::super) fn directions(&mut self, start: Option<&Start>) {
        self.title(1, "Direction cosines and homogeneous coordinates", "方向余弦与齐次坐标");
        let end = if self.chain.tool.is_empty() { Frame::Row(self.chain.links.len()) } else { Frame::Tool };
        let from = if self.chain.base.is_empty() { Frame::Row(0) } else { Frame::Base };
        let pose = self.notation.transform(from, end);
        self.tell_both(
            "The orientation of a frame is given by the cosines of the nine angles between its axes and those of the base: column $j$ of the rotation matrix $R$ is the $j$-th unit vector of the frame, written in base axes.",
            "坐标系的姿态由其各轴与基座各轴之间九个夹角的余弦给出：旋转矩阵 $R$ 的第 $j$ 列是该坐标系第 $j$ 轴的单位矢量在基座坐标系中的分量。",
            &[],
        );
        self.show(&["R = \\mat{r_{11} & r_{12} & r_{13}; r_{21} & r_{22} & r_{23}; r_{31} & r_{32} & r_{33}}"], &[]);
        self.tell_both(
            "Nine numbers with six relations: the columns have length 1 and are perpendicular to each other, so that three are free. For the same reason the inverse of $R$ is its transpose, and the third column is the cross product of the first two.",
            "九个数满足六个关系：各列长度为 1 且两两垂直，故只有三个自由度。因此 $R$ 的逆等于其转置，第三列为前两列的叉积。",
            &[],
        );
        self.show(
            &[
                "r_{11}^2 + r_{21}^2 + r_{31}^2 = 1",
                "r_{11}r_{12} + r_{21}r_{22} + r_{31}r_{32} = 0",
                "r_{13} = r_{21}r_{32} - r_{31}r_{22}",
            ],
            &[],
        );
        self.tell_both(
            "A point with the coordinates $P$ in the frame has the coordinates $R P + p$ in the base, with the origin $p$ of the frame. With a fourth coordinate 1 this is one product, and motions after each other are products of matrices:",
            "坐标系中的点 $P$ 在基座中的坐标为 $R P + p$，其中 $p$ 为坐标系原点。加上第四个坐标 1，这成为一个乘积，相继的运动即矩阵之积：",
            &[],
        );
        self.show_numbered(
            "#0 = \\mat{r_{11} & r_{12} & r_{13} & p_x; r_{21} & r_{22} & r_{23} & p_y; r_{31} & r_{32} & r_{33} & p_z; 0 & 0 & 0 & 1}",
            &[pose],
        );
        self.tell_both(
            "The inverse needs no elimination: its rotation is the transpose, its position minus the transpose times $p$.",
            "求逆无需消元：其旋转部分为转置，其位置为负的转置乘以 $p$。",
            &[],
        );
        let solved = self.solved();
        if let (Some(start), Ok(inverse)) = (start, &*solved) {
            let sample = Sample::new(self.chain, inverse.clone(), start);
            self.angles_of_axes(&sample);
        }
    }

    /// The nine angles of the worked example.
    fn angles_of_axes(&mut self, sample: &Sample) {
        self.tell_both("In the worked example the matrix and its nine angles are", "算例中该矩阵及其九个夹角为", &[]);
        let r = self.rotation(&sample.goal);
        self.show(&["R = #0"], &[r]);
        let names = ["x", "y", "z"];
        let header = ["", "x", "y", "z"].map(|t| {
            if t.is_empty() {
                super::Text::default()
            } else {
                super::Text::from(format!("{} {t}", self.both("tool", "末端")))
            }
        });
        let rows = names.iter().enumerate().map(|(i, name)| {
            let mut row = vec![super::Text::from(format!("{} {name}", self.both("base", "基座")))];
            let angle = |x: f64| x.clamp(-1.0, 1.0).acos();
            row.extend(sample.goal[i].iter().take(3).map(|x| super::Text::from(self.degrees(angle(*x)))));
            row
        });
        let rows = rows.collect();
        self.blocks.push(Block::Table(header.to_vec(), rows));
    }

    /// Repeatability and accuracy.
    pub(in super::super) fn accuracy(&mut self) {
        self.title(1, "Repeatability and accuracy", "重复精度与精度");
        self.points(
            &[
                (
                    "A taught point is one to which the arm has been led: its joint values are stored, and to return they are set again. No inverse kinematics is needed. How closely the arm returns is its repeatability.",
                    "示教点：把机械臂引导到该点，存储其关节值；返回时重新取这些值，无需逆运动学。返回的一致程度称为重复精度。",
                ),
                (
                    "A computed point is given in Cartesian coordinates, perhaps by a camera, and the arm may never have been there: the inverse kinematics finds its joint values. How closely the arm gets there is its accuracy.",
                    "计算点：以笛卡尔坐标给出（例如由相机测得），机械臂可能从未到过，由逆运动学求关节值。到达的准确程度称为精度。",
                ),
                (
                    "Accuracy is no better than repeatability. It suffers besides from every error of the parameters of the table: the inverse solves the arm of the table, not the one that was built.",
                    "精度不会优于重复精度。表中参数的任何误差都会使其变差：逆运动学求解的是表中的臂，而不是实际的臂。",
                ),
                (
                    "Calibration finds the parameters of the arm that was built from measured poses. It improves the accuracy; the repeatability stays.",
                    "标定由测得的位姿求出实际的参数，可提高精度；重复精度不变。",
                ),
            ],
            &[],
        );
    }

    /// Each method once.
    pub(in super::super) fn methods(&mut self) {
        self.title(1, "Methods", "求解方法");
        self.title(2, "The angle from its cosine and sine", "由余弦和正弦求角");
        self.tell_both(
            "An angle needs both: $\\theta = \\atan2(s,c)$ with $c = \\cos\\theta$ and $s = \\sin\\theta$ is right in all four quadrants, and a common positive factor does not matter. From the cosine alone there are two angles, $\\theta = \\atan2(\\either\\sqrt{1 - c^2},c)$.",
            "求角需要两者：由 $c = \\cos\\theta$、$s = \\sin\\theta$ 得 $\\theta = \\atan2(s,c)$，在四个象限都正确，且与公共正因子无关。只知余弦时有两个角：$\\theta = \\atan2(\\either\\sqrt{1 - c^2},c)$。",
            &[],
        );
        self.title(2, "a cos + b sin = c", "a cos + b sin = c");
        self.tell_both(
            "With the polar form $a = \\rho\\cos\\eta$, $b = \\rho\\sin\\eta$, that is $\\rho = \\sqrt{a^2 + b^2}$ and $\\eta = \\atan2(b,a)$, the left side is $\\rho\\cos(\\theta - \\eta)$. So $\\cos(\\theta - \\eta) = \\frac{c}{\\rho}$, and",
            "令 $a = \\rho\\cos\\eta$，$b = \\rho\\sin\\eta$，即 $\\rho = \\sqrt{a^2 + b^2}$，$\\eta = \\atan2(b,a)$，则左边为 $\\rho\\cos(\\theta - \\eta)$，故 $\\cos(\\theta - \\eta) = \\frac{c}{\\rho}$，于是",
            &[],
        );
        self.show_numbered("\\theta = \\atan2(b,a) \\pm \\atan2(\\sqrt{a^2 + b^2 - c^2},c)", &[]);
        self.tell_both(
            "There is no solution where $a^2 + b^2$ is less than $c^2$, one where they are equal, and any angle is one where $a = b = c = 0$. For $c = 0$ the two are half a turn apart: $\\theta = \\atan2(-a,b)$ and $\\atan2(a,-b)$.",
            "$a^2 + b^2$ 小于 $c^2$ 时无解，相等时一个解；$a = b = c = 0$ 时角可任取。$c = 0$ 时两解相差半周：$\\theta = \\atan2(-a,b)$ 与 $\\atan2(a,-b)$。",
            &[],
        );
        self.title(2, "Two such equations: Cramer's rule", "两个这样的方程：克拉默法则");
        self.tell_both(
            "$a_1 c + b_1 s = h_1$ and $a_2 c + b_2 s = h_2$ are linear in $c = \\cos\\theta$ and $s = \\sin\\theta$. With the determinant $D = a_1 b_2 - a_2 b_1$,",
            "$a_1 c + b_1 s = h_1$ 与 $a_2 c + b_2 s = h_2$ 对 $c = \\cos\\theta$、$s = \\sin\\theta$ 是线性的。设行列式 $D = a_1 b_2 - a_2 b_1$，则",
            &[],
        );
        self.show(
            &["c = \\frac{h_1 b_2 - h_2 b_1}{D}", "s = \\frac{a_1 h_2 - a_2 h_1}{D}", "\\theta = \\atan2(s,c)"],
            &[],
        );
        self.tell_both(
            "One solution; where $D = 0$ the equations say the same or contradict each other.",
            "一个解；$D = 0$ 时两式相同或矛盾。",
            &[],
        );
        self.title(2, "The tangent of the half angle", "半角正切代换");
        self.tell_both(
            "With $u = \\tan\\frac{\\theta}{2}$ sine and cosine are fractions in $u$, and an equation in them is a polynomial. Its real roots give the angles, $\\theta = 2\\atan2(u,1)$; $\\theta = 180\\deg$ is lost ($u$ infinite) and shows as a leading coefficient that vanishes.",
            "令 $u = \\tan\\frac{\\theta}{2}$，正弦和余弦成为 $u$ 的分式，方程化为多项式。其实根给出角 $\\theta = 2\\atan2(u,1)$；$\\theta = 180\\deg$ 会丢失（$u$ 无穷大），表现为首项系数为零。",
            &[],
        );
        self.show(&["\\cos\\theta = \\frac{1 - u^2}{1 + u^2}", "\\sin\\theta = \\frac{2u}{1 + u^2}"], &[]);
        self.title(2, "Two unknowns: the resultant", "两个未知量：结式");
        self.tell_both(
            "Two equations $a_2 v^2 + a_1 v + a_0 = 0$ and $b_2 v^2 + b_1 v + b_0 = 0$, whose coefficients depend on a second unknown $u$, have a common root $v$ only where their resultant vanishes: a polynomial in $u$ alone.",
            "两个方程 $a_2 v^2 + a_1 v + a_0 = 0$ 与 $b_2 v^2 + b_1 v + b_0 = 0$ 的系数含第二个未知量 $u$。只有结式为零时才有公共根 $v$，而结式只含 $u$：",
            &[],
        );
        self.show_numbered("(a_2 b_0 - a_0 b_2)^2 = (a_2 b_1 - a_1 b_2)(a_1 b_0 - a_0 b_1)", &[]);
        self.tell_both(
            "Each root $u$ then has its $v = \\frac{a_0 b_2 - a_2 b_0}{a_2 b_1 - a_1 b_2}$. With both half-angle tangents of two joints this is how pairs of equations in two angles are solved.",
            "每个根 $u$ 对应 $v = \\frac{a_0 b_2 - a_2 b_0}{a_2 b_1 - a_1 b_2}$。取两个关节的半角正切，即可解含两个角的方程组。",
            &[],
        );
    }
}
