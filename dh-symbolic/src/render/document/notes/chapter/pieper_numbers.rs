//! Pieper's method in numbers: the polynomial in u of the worked example, its roots, and the joint angles that belong to each.

use super::pieper::Case;
use super::positioning::Positioning;
use super::{Block, Math, NotesWriter, Sample, Sign, Text};
use crate::algebra::Poly;
use dh_kernels::pose::{self, Pose};
use dh_kernels::{solve_second_harmonic, solve_sincos};
use std::f64::consts::PI;

/// Angles that differ by less are one.
const SAME: f64 = 1e-6;

/// constant + cosine cos t + sine sin t.
type Harmonic = [f64; 3];

/// The wrist centre and what does not depend on the joint angles.
struct Wrist<'a> {
    p: &'a Positioning,
    sample: &'a Sample,
    /// The wrist centre seen from before the first turn.
    centre: [f64; 3],
    r: f64,
    first: f64,
    twist: [f64; 2],
    offset: f64,
}

/// The first three joint angles with all that leads there.
struct Row {
    angles: [f64; 3],
    f: [f64; 3],
    k: [f64; 4],
    h: [f64; 2],
    g: [f64; 3],
}

fn wrapped(x: f64) -> f64 {
    x.sin().atan2(x.cos())
}

impl Wrist<'_> {
    fn evaluate(&self, p: &Poly, angles: [f64; 3]) -> f64 {
        let mut x = self.sample.arm.coordinates(&self.sample.q);
        x.iter_mut().zip(angles).for_each(|(x, a)| *x = a);
        self.sample.arm.evaluate(p, &x)
    }

    fn f(&self, third: f64) -> [f64; 3] {
        std::array::from_fn(|i| self.evaluate(&self.p.f[i], [0.0, 0.0, third]))
    }

    fn k(&self, f: [f64; 3]) -> [f64; 4] {
        let square: f64 = f.iter().map(|x| x * x).sum();
        let k3 = square + self.first * self.first + self.offset * self.offset + 2.0 * self.offset * f[2];
        [f[0], -f[1], k3, self.twist[0] * (f[2] + self.offset)]
    }

    /// r - k3 over 2 a1 and z - k4 over sin alpha1; not finite where that is not used.
    fn h(&self, k: [f64; 4]) -> [f64; 2] {
        [(self.r - k[2]) / (2.0 * self.first), (self.centre[2] - k[3]) / self.twist[1]]
    }

    /// k as functions of the third angle.
    fn harmonics(&self) -> [Harmonic; 4] {
        let [a, b, c] = [0.0, PI / 2.0, PI].map(|t| self.k(self.f(t)));
        std::array::from_fn(|i| {
            let constant = (a[i] + c[i]) / 2.0;
            [constant, (a[i] - c[i]) / 2.0, b[i] - constant]
        })
    }

    /// The equation for the third angle: squares of harmonics with their factors, or one harmonic.
    fn equation(&self, case: Case) -> (Vec<(f64, Harmonic)>, bool) {
        let [k1, k2, k3, k4] = self.harmonics();
        let from = |x: f64, k: Harmonic| [x - k[0], -k[1], -k[2]];
        let (r, z) = (from(self.r, k3), from(self.centre[2], k4));
        match case {
            Case::NoLength => (vec![(1.0, r)], false),
            Case::NoTwist => (vec![(1.0, z)], false),
            Case::General => {
                let (a, s) = (2.0 * self.first, self.twist[1]);
                (vec![(1.0 / (a * a), r), (1.0 / (s * s), z), (-1.0, k1), (-1.0, k2)], true)
            }
        }
    }

    fn rows(&self, case: Case) -> Vec<Row> {
        let (list, squares) = self.equation(case);
        let mut thirds: Vec<f64> = if squares {
            let (mut constant, mut cos, mut sin) = (0.0, [0.0; 2], [0.0; 2]);
            for (w, [p, c, s]) in &list {
                constant += w * (p * p + (c * c + s * s) / 2.0);
                cos = [cos[0] + w * 2.0 * p * c, cos[1] + w * (c * c - s * s) / 2.0];
                sin = [sin[0] + w * 2.0 * p * s, sin[1] + w * c * s];
            }
            solve_second_harmonic(constant, cos, sin, 0.0).roots.iter().map(|[c, s]| s.atan2(*c)).collect()
        } else {
            let [p, c, s] = list.first().map_or([0.0; 3], |l| l.1);
            solve_sincos(c, s, -p, 0.0).roots.iter().map(|[c, s]| s.atan2(*c)).collect()
        };
        thirds.sort_by(f64::total_cmp);
        thirds.into_iter().flat_map(|third| self.behind(case, third)).collect()
    }

    /// The second and the first angle for a third one.
    fn behind(&self, case: Case, third: f64) -> Vec<Row> {
        let f = self.f(third);
        let k = self.k(f);
        let h = self.h(k);
        let seconds: Vec<f64> = match case {
            Case::General => vec![(k[1] * h[0] + k[0] * h[1]).atan2(k[0] * h[0] - k[1] * h[1])],
            Case::NoLength => solve_sincos(-k[1], k[0], h[1], 0.0).roots.iter().map(|[c, s]| s.atan2(*c)).collect(),
            Case::NoTwist => solve_sincos(k[0], k[1], h[0], 0.0).roots.iter().map(|[c, s]| s.atan2(*c)).collect(),
        };
        let row = |second: f64| {
            let letter = |s| self.p.letters.iter().position(|l| *l == s).map(|i| f[i]);
            let mut x = self.sample.arm.coordinates(&self.sample.q);
            x.iter_mut().skip(1).zip([second, third]).for_each(|(x, a)| *x = a);
            let g = std::array::from_fn(|i| self.sample.arm.evaluate_with(&self.p.g[i], &x, &letter));
            let g: [f64; 3] = g;
            let [x, y, _] = self.centre;
            let first = wrapped(y.atan2(x) - g[1].atan2(g[0]));
            Row { angles: [first, second, third], f, k, h, g }
        };
        seconds.into_iter().map(row).collect()
    }
}

/// Coefficients of a polynomial in u, constant first: a harmonic times 1 + u^2.
fn in_half_tangent([p, c, s]: Harmonic) -> [f64; 3] {
    [p + c, 2.0 * s, p - c]
}

impl NotesWriter<'_> {
    pub(super) fn pieper_in_numbers(&mut self, p: &Positioning, sample: &Sample) {
        let arm = &sample.arm;
        let number = |p: &Poly| arm.evaluate(p, &arm.coordinates(&sample.q));
        let head = p.head.iter().fold(pose::IDENTITY, |t, e| pose::compose(&t, &arm.motion(e, &[])));
        let mut tip: Pose = pose::IDENTITY;
        tip.iter_mut().zip(&p.from_tip).for_each(|(row, x)| row[3] = number(x));
        let wrist = pose::compose(&pose::inverse(&head), &pose::compose(&sample.inner(), &tip));
        let centre = [wrist[0][3], wrist[1][3], wrist[2][3]];
        let wrist = Wrist {
            p,
            sample,
            centre,
            r: centre.iter().map(|x| x * x).sum(),
            first: number(&p.first),
            twist: [number(&p.twist.0), number(&p.twist.1)],
            offset: number(&p.offset),
        };
        let case = Case::of(p);
        let rows = wrist.rows(case);
        self.title(2, "The wrist centre in numbers", "腕心的数值");
        self.at_solution(sample);
        let [x, y, z] = centre.map(|x| self.real(x));
        self.tell_both(
            "the wrist centre is at $@x = #0$, $@y = #1$, $@z = #2$, $r = #3$, and the equation for $u$ is",
            "腕心为 $@x = #0$，$@y = #1$，$@z = #2$，$r = #3$，$u$ 的方程为",
            &[x, y, z, self.real(wrist.r)],
        );
        let (list, squares) = wrist.equation(case);
        let (polynomial, full) = self.polynomial(&list, squares);
        self.show_numbered("#0 = 0", &[polynomial]);
        if !full {
            self.tell_both(
                "The highest power drops out: $@q3 = 180\\deg$ is a root, with $u$ infinite.",
                "最高次项为零：$@q3 = 180\\deg$ 是一个根（此时 $u$ 为无穷）。",
                &[],
            );
        }
        if rows.is_empty() {
            self.tell_both("It has no real root: the wrist centre is out of reach.", "方程无实根：腕心不可达。", &[]);
            return;
        }
        self.tell_both("Its real roots, and the angles that follow from each:", "其实根及由各根求得的角：", &[]);
        let mut header: Vec<Text> = ["u", "@q3", "@q2", "@q1"].map(|t| Text::from(self.formula(t, &[]))).to_vec();
        header.push(self.both("solutions", "解").into());
        let cells = rows.iter().map(|row| {
            let [a, b, c] = row.angles;
            let u = (c / 2.0).tan();
            let u = if u.abs() > 1e9 { Math::Letter('∞') } else { self.real(u) };
            let mut line = [u, self.degrees(c), self.degrees(b), self.degrees(a)].map(Text::from).to_vec();
            line.push(self.solutions_at(sample, &row.angles));
            line
        });
        let cells = cells.collect();
        self.blocks.push(Block::Table(header, cells));
        self.way_to(&wrist, &rows, case);
    }

    /// Numbers of the solutions of the worked example whose first joints stand at these angles; what is no number is not compared.
    pub(super) fn solutions_at(&self, sample: &Sample, angles: &[f64]) -> Text {
        let fits = |q: &[f64]| {
            sample.arm.coordinates(q).iter().zip(angles).all(|(x, a)| a.is_nan() || wrapped(x - a).abs() < SAME)
        };
        let found = sample.found.iter().enumerate().filter(|(_, f)| fits(&f.q));
        let numbers: Vec<String> = found.map(|(i, _)| (i + 1).to_string()).collect();
        if numbers.is_empty() { "–".into() } else { numbers.join(", ").into() }
    }

    /// The polynomial in u, its largest coefficient made 1; whether its highest power is there.
    fn polynomial(&self, list: &[(f64, Harmonic)], squares: bool) -> (Math, bool) {
        let mut sum = [0.0; 5];
        for (w, harmonic) in list {
            let a = in_half_tangent(*harmonic);
            if squares {
                for (i, x) in a.iter().enumerate() {
                    a.iter().enumerate().for_each(|(j, y)| sum[i + j] += w * x * y);
                }
            } else {
                sum.iter_mut().zip(a).for_each(|(s, x)| *s += w * x);
            }
        }
        let degree = if squares { 4 } else { 2 };
        let largest = sum.iter().fold(0.0f64, |m, x| m.max(x.abs())).max(f64::MIN_POSITIVE);
        let mut row: Vec<Math> = Vec::new();
        for (n, x) in sum.iter().enumerate().take(degree + 1).rev() {
            let x = x / largest;
            if x.abs() < 1e-12 {
                continue;
            }
            row.push(match (row.is_empty(), x < 0.0) {
                (true, true) => Math::Sign(Sign::Negative),
                (true, false) => Math::Row(vec![]),
                (false, true) => Math::Sign(Sign::Minus),
                (false, false) => Math::Sign(Sign::Plus),
            });
            if n == 0 || (x.abs() - 1.0).abs() > 1e-12 {
                row.push(self.real(x.abs()));
            }
            let u = Math::Letter('u');
            row.extend(match n {
                0 => None,
                1 => Some(u),
                n => Some(u.above(Math::number(n))),
            });
        }
        (Math::Row(row), (sum[degree] / largest).abs() > 1e-12)
    }

    /// Everything on the way to the solution that the worked example follows.
    fn way_to(&mut self, wrist: &Wrist<'_>, rows: &[Row], case: Case) {
        let sample = wrist.sample;
        let Some(solution) = sample.found.get(sample.chosen) else { return };
        let x = sample.arm.coordinates(&solution.q);
        let fits = |r: &&Row| r.angles.iter().zip(&x).all(|(a, b)| wrapped(a - b).abs() < SAME);
        let Some(row) = rows.iter().find(fits) else { return };
        self.tell_both(
            "On the way to solution $#0$ of the worked example:",
            "求算例第 $#0$ 组解的过程：",
            &[Math::number(sample.chosen + 1)],
        );
        let indexed = |letter: char, list: &[f64], skip: &[usize]| -> Vec<Math> {
            let one = |(i, x): (usize, &f64)| {
                let name = Math::Letter(letter).below(Math::number(i + 1));
                (!skip.contains(&i)).then(|| Math::equation(name, self.real(*x)))
            };
            list.iter().enumerate().filter_map(one).collect()
        };
        let unused: &[usize] = match case {
            Case::General => &[],
            Case::NoLength => &[0],
            Case::NoTwist => &[1],
        };
        let [first, second, third] = row.angles.map(|a| self.degrees(a));
        let at = |name: &str, value: Math| Math::equation(self.formula(name, &[]), value);
        let mut lines = vec![
            [vec![Math::equation(Math::Letter('u'), self.real((row.angles[2] / 2.0).tan())), at("@q3", third)]]
                .concat(),
            indexed('f', &row.f, &[]),
            indexed('k', &row.k, &[]),
            indexed('h', &row.h, unused),
            indexed('g', &row.g, &[]),
        ];
        lines[3].push(at("@q2", second));
        lines[4].push(at("@q1", first));
        let between = self.both(", ", "，");
        let items = lines.into_iter().map(|l| Text::join(l.into_iter().map(Text::from), between)).collect();
        self.blocks.push(Block::List(items));
    }
}
