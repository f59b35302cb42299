//! Pieper's method for arms whose last three axes meet: the wrist centre through f, g and k, the equation for the third joint, then the
//! second and the first.

use super::positioning::Positioning;
use super::{Math, NotesWriter, Sign, Start};
use crate::algebra::{LinearAngle, Poly, Rational, Symbol, Transform, Vector};
use crate::chain::{Convention, Elementary};
use crate::render::document::frames::Frame;

/// Which of the equations for r and z has the third angle alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Case {
    /// Axes 1 and 2 meet: r.
    NoLength,
    /// They are parallel: z.
    NoTwist,
    /// Neither: the sum of two squares.
    General,
}

impl Case {
    pub(super) fn of(p: &Positioning) -> Case {
        if p.first.is_zero() {
            Case::NoLength
        } else if p.twist.1.is_zero() {
            Case::NoTwist
        } else {
            Case::General
        }
    }
}

impl NotesWriter<'_> {
    /// The part of the note; nothing where the method does not apply.
    pub(in super::super) fn pieper(&mut self, start: Option<&Start>) {
        self.with_table_angles(start, |w, sample| {
            let Some(p) = Positioning::of(w.chain) else { return };
            w.title(1, "Pieper's method", "Pieper 解法");
            w.tell_both(
                "The axes of joints 4, 5 and 6 meet in one point, the wrist centre. Where it is depends on the first three joints alone; the last three give the orientation. This splits the problem into two of three unknowns each (Pieper 1968).",
                "关节 4、5、6 的轴线交于一点，即腕心。腕心的位置只取决于前三个关节，姿态由后三个关节实现，于是问题分成各含三个未知量的两部分（Pieper，1968）。",
                &[],
            );
            w.table_angles();
            w.wrist_apart = !p.head.is_empty()
                || p.from_tip.iter().any(|x| !x.is_zero())
                || !w.chain.base.is_empty()
                || !w.chain.tool.is_empty();
            w.name_letters(&p);
            w.centre_of_wrist(&p);
            w.f_of_third(&p);
            w.g_of_second(&p);
            w.r_and_z(&p);
            w.cases(&p);
            w.back(&p);
            if let Some(sample) = sample {
                w.pieper_in_numbers(&p, sample);
            }
            w.orientation(&p, sample);
        });
    }

    fn name_letters(&mut self, p: &Positioning) {
        for (i, s) in p.letters.iter().enumerate() {
            self.notation.set_symbol(*s, Math::Letter('f').below(Math::number(i + 1)));
        }
    }

    pub(super) fn homogeneous(&self, v: &Vector) -> Math {
        let mut rows: Vec<Vec<Math>> = v.iter().map(|p| vec![self.notation.typeset(&self.group(p))]).collect();
        rows.push(vec![Math::number(1)]);
        Math::Matrix(rows)
    }

    pub(super) fn motions_of(&self, list: &[Elementary]) -> Vec<Math> {
        list.iter().map(|e| self.motion(&self.notation, e)).collect()
    }

    /// x, y, z: from the pose.
    fn centre_of_wrist(&mut self, p: &Positioning) {
        self.title(2, "The wrist centre", "腕心");
        let whole = self.notation.transform(Frame::Row(0), Frame::Row(6));
        let mut factors = self.motions_of(&undone(&p.head));
        factors.push(whole);
        factors.push(self.homogeneous(&p.from_tip));
        let product = super::super::side_by_side(factors);
        if p.head.is_empty() && p.from_tip.iter().all(Poly::is_zero) {
            self.tell_both(
                "It is the origin of the frames 4, 5 and 6, so the given pose holds it in its fourth column:",
                "腕心是坐标系 4、5、6 的公共原点，即已知位姿的第四列：",
                &[],
            );
        } else {
            self.tell_both(
                "The given pose tells where it is; constant motions before the first joint and behind the wrist are taken off:",
                "由已知位姿去掉第一关节之前和腕心之后的固定变换，得腕心：",
                &[],
            );
        }
        self.show_numbered("\\mat{@x;@y;@z;1} = #0", &[product]);
    }

    /// The wrist centre before the third turn.
    fn f_of_third(&mut self, p: &Positioning) {
        self.title(2, "f: a function of the third angle", "f：第三个角的函数");
        let modified = self.chain.convention == Convention::Modified;
        let product = if modified {
            let fourth = self.chain.links.get(3).map(|_| crate::kinematics::Kinematics::new(self.chain));
            let fourth = fourth.and_then(|k| k.link(4).map(|t| t.p.clone())).unwrap_or_default();
            super::super::side_by_side(vec![self.formula("@T23", &[]), self.homogeneous(&fourth)])
        } else {
            let n = p.between[1].iter().take_while(|e| matches!(e, Elementary::Translate(2, _))).count();
            let mut list = self.motions_of(&p.between[1][n..]);
            list.push(self.formula("R_z(@q3)", &[]));
            list.extend(self.motions_of(&p.between[2]));
            list.extend(self.motions_of(&p.between[3]).into_iter().take(1));
            list.push(self.homogeneous(&Vector::default()));
            super::super::side_by_side(list)
        };
        self.tell_both("Before the turns of joints 1 and 2 it is at", "在关节 1、2 转动之前，腕心位于", &[]);
        self.show_numbered("\\mat{f_1;f_2;f_3;1} = #0", &[product]);
        self.tell_both("Multiplied out, a function of $@q3$ alone:", "展开后只含 $@q3$：", &[]);
        self.components('f', &p.f);
    }

    fn components(&mut self, letter: char, v: &Vector) {
        let list = v.iter().enumerate().map(|(i, p)| {
            let left = Math::Letter(letter).below(Math::number(i + 1));
            self.equation(left, self.notation.typeset(&self.group(p)))
        });
        let list = list.collect();
        self.blocks.push(super::Block::Equations(list));
    }

    /// The same after the second turn.
    fn g_of_second(&mut self, p: &Positioning) {
        self.title(2, "g: the second angle comes in", "g：引入第二个角");
        let mut list = Vec::new();
        if self.chain.convention == Convention::Modified {
            list.push(self.formula("@T12", &[]));
        } else {
            list.extend(self.motions_of(&p.between[0]));
            list.push(self.formula("R_z(@q2)", &[]));
            let n = p.between[1].iter().take_while(|e| matches!(e, Elementary::Translate(2, _))).count();
            list.extend(self.motions_of(&p.between[1][..n]));
        }
        list.push(self.formula("\\mat{f_1;f_2;f_3;1}", &[]));
        self.tell_both("The second joint carries this point to", "第二个关节把该点带到", &[]);
        self.show_numbered("\\mat{g_1;g_2;g_3;1} = #0", &[super::super::side_by_side(list)]);
        self.components('g', &p.g);
        self.tell_both("and the first turns it about its axis:", "第一个关节再使其绕自身轴线转动：", &[]);
        self.show(&["@x = @c1 g_1 - @s1 g_2", "@y = @s1 g_1 + @c1 g_2", "@z = g_3"], &[]);
    }

    /// What the first turn does not change.
    fn r_and_z(&mut self, p: &Positioning) {
        self.title(2, "r and z: what the first joint does not change", "r 与 z：与第一个角无关的量");
        self.tell_both(
            "A turn about the first axis changes neither the distance from the origin nor the height, so that $r = @x^2 + @y^2 + @z^2 = g_1^2 + g_2^2 + g_3^2$ and $@z = g_3$ are free of $@q1$. With",
            "绕第一轴的转动既不改变到原点的距离，也不改变高度，因此 $r = @x^2 + @y^2 + @z^2 = g_1^2 + g_2^2 + g_3^2$ 与 $@z = g_3$ 不含 $@q1$。令",
            &[],
        );
        let f: [Poly; 3] = p.letters.map(Poly::symbol);
        let square = |p: &Poly| p.square();
        let mut k3: Poly = f.iter().map(square).sum();
        k3 = &(&k3 + &p.first.square()) + &p.offset.square();
        k3 = &k3 + &(&p.offset * &f[2]).scale(&Rational::int(2));
        let k4 = &p.twist.0 * &(&f[2] + &p.offset);
        let values = [f[0].clone(), -&f[1], k3, k4];
        let list = values.iter().enumerate().map(|(i, v)| {
            let left = Math::Letter('k').below(Math::number(i + 1));
            self.equation(left, self.notation.typeset(&self.group(v)))
        });
        let list = list.collect();
        self.blocks.push(super::Block::Equations(list));
        let mut ring = self.chain.ring.clone();
        let _ = ["wrist f1", "wrist f2", "wrist f3"].map(|n| ring.symbol(n));
        let k = ["wrist k1", "wrist k2", "wrist k3", "wrist k4"].map(|n| ring.symbol(n));
        for (i, s) in k.iter().enumerate() {
            self.notation.set_symbol(*s, Math::Letter('k').below(Math::number(i + 1)));
        }
        self.tell_both("they read", "它们写成", &[]);
        let [r, z] = self.right_sides(p, &k);
        self.show_numbered("r = #0", &[r]);
        self.show_numbered("@z = #0", &[z]);
    }

    /// (k1 c2 + k2 s2) 2 a1 + k3 and (k1 s2 - k2 c2) sin alpha1 + k4, with the numbers of the table.
    fn right_sides(&self, p: &Positioning, k: &[Symbol; 4]) -> [Math; 2] {
        let [k1, k2, ..] = k.map(Poly::symbol);
        let (c, s) = Poly::cos_sin(p.angles[1]);
        let along = &(&k1 * &c) + &(&k2 * &s);
        let across = &(&k1 * &s) - &(&k2 * &c);
        let bracket = |factor: &Poly, inner: &Poly, rest: &Symbol| {
            let rest = self.notation.symbol(*rest);
            if factor.is_zero() {
                return rest;
            }
            let inner = self.notation.typeset(&self.group(inner));
            let (sign, value) = signed(factor);
            let mut row = Vec::new();
            if sign {
                row.push(Math::Sign(Sign::Negative));
            }
            if !value.is_one() {
                row.push(self.notation.typeset(&self.group(&value)));
            }
            row.extend([inner.in_brackets(), Math::Sign(Sign::Plus), rest]);
            Math::Row(row)
        };
        [bracket(&p.first.scale(&Rational::int(2)), &along, &k[2]), bracket(&p.twist.1, &across, &k[3])]
    }

    /// Three cases; the equation of this arm.
    fn cases(&mut self, p: &Positioning) {
        self.title(2, "The third joint", "第三个关节");
        self.tell_both(
            "Both equations are linear in $@c2$ and $@s2$. There are three cases:",
            "两式对 $@c2$、$@s2$ 都是线性的。分三种情形：",
            &[],
        );
        let pieces = ["a_1", "\\alpha_1"].map(|t| self.formula(t, &[]));
        self.points(
            &[
                ("$#0 = 0$: of the first equation only $r$ and $k_3$ are left, without $@q2$.", "$#0 = 0$：第一式只剩 $r$ 与 $k_3$，不含 $@q2$。"),
                (
                    "$\\sin #1 = 0$: of the second equation only $@z$ and $k_4$ are left, without $@q2$.",
                    "$\\sin #1 = 0$：第二式只剩 $@z$ 与 $k_4$，不含 $@q2$。",
                ),
                (
                    "else: solved for the brackets, squared and added, they are free of $@q2$: $\\frac{(r - k_3)^2}{(2#0)^2} + \\frac{(@z - k_4)^2}{(\\sin #1)^2} = k_1^2 + k_2^2$.",
                    "其余情形：分别解出括号，平方后相加，即不含 $@q2$：$\\frac{(r - k_3)^2}{(2#0)^2} + \\frac{(@z - k_4)^2}{(\\sin #1)^2} = k_1^2 + k_2^2$。",
                ),
            ],
            &pieces,
        );
        let case = Case::of(p);
        match case {
            Case::NoLength => self.tell_both(
                "Here the axes of joints 1 and 2 meet, $#0 = 0$: the first case.",
                "这里关节 1、2 的轴线相交，$#0 = 0$：第一种情形。",
                &pieces,
            ),
            Case::NoTwist => self.tell_both(
                "Here the axes of joints 1 and 2 are parallel, $\\sin #1 = 0$: the second case.",
                "这里关节 1、2 的轴线平行，$\\sin #1 = 0$：第二种情形。",
                &pieces,
            ),
            Case::General => {
                self.tell_both("Here neither vanishes: the third case,", "这里两者均不为零，属第三种情形：", &[])
            }
        }
        match case {
            Case::NoLength => self.show_numbered("r = k_3", &[]),
            Case::NoTwist => self.show_numbered("@z = k_4", &[]),
            Case::General => {
                let square = |p: &Poly| self.notation.typeset(&self.group(&p.square()));
                let (length, twist) = (square(&p.first.scale(&Rational::int(2))), &p.twist.1.square());
                let second = match twist.is_one() {
                    true => self.formula("(@z - k_4)^2", &[]),
                    false => self.formula("\\frac{(@z - k_4)^2}{#0}", &[self.notation.typeset(&self.group(twist))]),
                };
                self.show_numbered("\\frac{(r - k_3)^2}{#0} + #1 = k_1^2 + k_2^2", &[length, second])
            }
        };
        self.tell_both("With the tangent of the half angle,", "以半角正切代换，", &[]);
        self.show(
            &["u = \\tan\\frac{@q3}{2}", "\\cos@q3 = \\frac{1 - u^2}{1 + u^2}", "\\sin@q3 = \\frac{2u}{1 + u^2}"],
            &[],
        );
        match case {
            Case::General => self.tell_both(
                "and multiplied by $(1 + u^2)^2$, it is an equation of degree four in $u$: up to four values of $@q3$.",
                "并乘以 $(1 + u^2)^2$，得到 $u$ 的四次方程：$@q3$ 最多有四个值。",
                &[],
            ),
            _ => self.tell_both(
                "and multiplied by $1 + u^2$, it is an equation of degree two in $u$: up to two values of $@q3$.",
                "并乘以 $1 + u^2$，得到 $u$ 的二次方程：$@q3$ 最多有两个值。",
                &[],
            ),
        }
    }

    /// The second and the first joint.
    fn back(&mut self, p: &Positioning) {
        self.title(2, "The second and the first joint", "第二个和第一个关节");
        let two = self.notation.typeset(&self.group(&p.first.scale(&Rational::int(2))));
        let sine = self.notation.typeset(&self.group(&p.twist.1));
        let along = |w: &Self| w.written("h_1 = \\frac{r - k_3}{#0}", std::slice::from_ref(&two));
        let across = |w: &Self| match signed(&p.twist.1) {
            (false, v) if v.is_one() => w.written("h_2 = @z - k_4", &[]),
            (true, v) if v.is_one() => w.written("h_2 = k_4 - @z", &[]),
            _ => w.written("h_2 = \\frac{@z - k_4}{#0}", std::slice::from_ref(&sine)),
        };
        match Case::of(p) {
            Case::General => {
                self.tell_both(
                    "With $@q3$ known, $k_1$ to $k_4$ are numbers, and both equations together give $@q2$ (Cramer's rule; the determinant is $k_1^2 + k_2^2$):",
                    "$@q3$ 已知后 $k_1$ 至 $k_4$ 均为数，两式联立求得 $@q2$（克拉默法则，行列式为 $k_1^2 + k_2^2$）：",
                    &[],
                );
                let list = vec![
                    along(self),
                    across(self),
                    self.written("@q2 = \\atan2(k_2 h_1 + k_1 h_2,k_1 h_1 - k_2 h_2)", &[]),
                ];
                self.blocks.push(super::Block::Equations(list));
            }
            Case::NoLength => {
                self.tell_both(
                    "With $@q3$ known, the second equation has $@q2$ alone, $k_1 @s2 - k_2 @c2 = h_2$: two values.",
                    "$@q3$ 已知后，第二式只含 $@q2$，即 $k_1 @s2 - k_2 @c2 = h_2$：两个值。",
                    &[],
                );
                let root = "@q2 = \\atan2(k_1,-k_2) \\pm \\atan2(\\sqrt{k_1^2 + k_2^2 - h_2^2},h_2)";
                let list = vec![across(self), self.written(root, &[])];
                self.blocks.push(super::Block::Equations(list));
            }
            Case::NoTwist => {
                self.tell_both(
                    "With $@q3$ known, the first equation has $@q2$ alone, $k_1 @c2 + k_2 @s2 = h_1$: two values.",
                    "$@q3$ 已知后，第一式只含 $@q2$，即 $k_1 @c2 + k_2 @s2 = h_1$：两个值。",
                    &[],
                );
                let root = "@q2 = \\atan2(k_2,k_1) \\pm \\atan2(\\sqrt{k_1^2 + k_2^2 - h_1^2},h_1)";
                let list = vec![along(self), self.written(root, &[])];
                self.blocks.push(super::Block::Equations(list));
            }
        }
        self.tell_both(
            "Now g is known, and $@x = @c1 g_1 - @s1 g_2$, $@y = @s1 g_1 + @c1 g_2$ give",
            "此时 g 已知，由 $@x = @c1 g_1 - @s1 g_2$ 与 $@y = @s1 g_1 + @c1 g_2$ 得",
            &[],
        );
        self.show(&["@q1 = \\atan2(@y,@x) - \\atan2(g_2,g_1)"], &[]);
        self.tell_both(
            "Together at most four positions of the first three joints. Where it lies on the first axis, $@q1$ is free.",
            "前三个关节最多有四组解。腕心位于第一轴上时 $@q1$ 可任取。",
            &[],
        );
    }
}

/// Sign and size of a factor that is one term.
fn signed(p: &Poly) -> (bool, Poly) {
    match p.terms() {
        [(_, x)] if x.is_negative() => (true, -p),
        _ => (false, p.clone()),
    }
}

/// The rotation of a product of motions.
pub(super) fn rotation(list: &[Elementary]) -> Transform {
    let t = list.iter().fold(Transform::identity(), |t, e| t.times(&e.transform()));
    Transform { p: Vector::default(), ..t }
}

/// The motions that undo these.
pub(super) fn undone(list: &[Elementary]) -> Vec<Elementary> {
    let one = |e: &Elementary| match e {
        Elementary::Rotate(axis, angle) => {
            let terms = angle.terms.iter().map(|(v, k)| (*v, -*k)).collect();
            let constant = angle.constant.times(&Rational::int(-1));
            Elementary::Rotate(*axis, LinearAngle { terms, constant })
        }
        Elementary::Translate(axis, length) => Elementary::Translate(*axis, -length),
    };
    list.iter().rev().map(one).collect()
}
