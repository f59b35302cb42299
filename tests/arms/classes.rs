//! Random tables of a class: what is parallel, what meets and what slides belongs to the class, the rest is random.

/// The classes, with the number of joints that a class name starts with.
pub(super) const CLASSES: &[&str] = &[
    "6 wrist at the end, 2 and 3 parallel",
    "6 wrist at the end, neighbours that meet",
    "6 wrist at the end, any other axes",
    "6 wrist at the base",
    "6 wrist in the middle",
    "6 parallel from 1",
    "6 parallel from 2",
    "6 parallel from 3",
    "6 parallel from 4",
    "6 gantry with wrist",
    "6 cylinder with wrist",
    "6 two slides and wrist",
    "6 three slides anywhere",
    "6 two slides, any axes",
    "6 three slides, any axes",
    "6 track",
    "7 shoulder and wrist",
    "5 axes 2 to 4 parallel",
    "5 axes 2 to 4 parallel, task axis",
    "5 turning",
    "5 mixed",
    "5 two slides, any axes, task axis",
    "5 three slides, any axes, task axis",
    "4 scara",
    "4 turning",
    "4 mixed",
    "3 turning",
    "3 turning, task position",
    "3 planar",
    "2 mixed",
];

/// Links in Craig's order: twist and length before the joint, offset along it; does it turn?
type Link = (f64, f64, f64, bool);

/// Takes decisions from numbers in [-1, 1).
struct Maker<'a>(&'a mut dyn FnMut() -> f64);

impl Maker<'_> {
    fn chance(&mut self, p: f64) -> bool {
        0.5 * ((self.0)() + 1.0) < p
    }

    fn pick(&mut self, list: &[f64]) -> f64 {
        let at = 0.5 * ((self.0)() + 1.0) * list.len() as f64;
        list[(at as usize).min(list.len() - 1)]
    }

    fn right(&mut self) -> f64 {
        self.pick(&[90.0, -90.0])
    }

    fn parallel(&mut self) -> f64 {
        self.pick(&[0.0, 0.0, 0.0, 180.0])
    }

    /// Any twist but a parallel one; mostly a right angle.
    fn cross(&mut self) -> f64 {
        self.pick(&[90.0, -90.0, 90.0, -90.0, 90.0, -90.0, 30.0, -45.0, 60.0, 55.3, -20.0, 100.0])
    }

    fn twist(&mut self) -> f64 {
        if self.chance(0.1) { self.parallel() } else { self.cross() }
    }

    fn some(&mut self) -> f64 {
        let size = 0.05 + 0.55 * 0.5 * ((self.0)() + 1.0);
        let size = if self.chance(0.3) { 0.3 } else { (size * 1000.0).round() / 1000.0 };
        if self.chance(0.5) { size } else { -size }
    }

    fn maybe(&mut self, p: f64) -> f64 {
        if self.chance(p) { self.some() } else { 0.0 }
    }

    fn free(&mut self, turns: bool) -> Link {
        let twist = self.twist();
        let flat = twist == 0.0 || twist == 180.0;
        (twist, if flat { self.some() } else { self.maybe(0.5) }, self.maybe(0.5), turns)
    }

    fn wrist(&mut self, links: &mut Vec<Link>, twist: f64, a: f64, d: f64) {
        links.push((twist, a, d, true));
        links.push((self.cross(), 0.0, 0.0, true));
        links.push((self.cross(), 0.0, self.maybe(0.5), true));
    }

    fn links(&mut self, class: &str) -> Vec<Link> {
        let first = (0.0, 0.0, self.maybe(0.5), true);
        let mut l: Vec<Link> = Vec::new();
        let wrist_at_end = |m: &mut Self, l: &mut Vec<Link>| {
            let (t, a, d) = (m.cross(), m.maybe(0.6), m.some());
            m.wrist(l, t, a, d);
        };
        match class {
            "6 wrist at the end, 2 and 3 parallel" => {
                l.extend([first, (self.cross(), self.maybe(0.5), self.maybe(0.3), true)]);
                l.push((self.parallel(), self.some(), self.maybe(0.3), true));
                wrist_at_end(self, &mut l);
            }
            "6 wrist at the end, neighbours that meet" => {
                l.extend([first, (self.cross(), 0.0, self.maybe(0.5), true)]);
                l.push((self.cross(), self.some(), self.maybe(0.5), true));
                wrist_at_end(self, &mut l);
            }
            "6 wrist at the end, any other axes" => {
                l.push(first);
                for _ in 0..2 {
                    l.push((self.twist(), self.some(), self.some(), true));
                }
                wrist_at_end(self, &mut l);
            }
            "6 wrist at the base" => {
                self.wrist(&mut l, 0.0, 0.0, 0.3);
                l[2].2 = self.some();
                l.push((self.cross(), self.maybe(0.5), self.maybe(0.3), true));
                l.push((self.parallel(), self.some(), self.maybe(0.4), true));
                l.push((self.cross(), self.maybe(0.6), self.maybe(0.7), true));
            }
            "6 wrist in the middle" => {
                l.extend([first, (self.cross(), self.some(), self.maybe(0.5), true)]);
                l.extend([(self.cross(), 0.0, 0.0, true), (self.cross(), 0.0, self.maybe(0.7), true)]);
                l.extend([(self.cross(), self.some(), self.maybe(0.7), true)]);
                l.push((self.cross(), self.maybe(0.7), self.maybe(0.7), true));
            }
            "6 parallel from 1" | "6 parallel from 2" | "6 parallel from 3" | "6 parallel from 4" => {
                let at = usize::from(class.as_bytes()[class.len() - 1] - b'1');
                l.push(first);
                for i in 1..6 {
                    let inside = i == at + 1 || i == at + 2;
                    l.push(if inside {
                        (self.parallel(), self.some(), self.maybe(0.4), true)
                    } else {
                        (self.right(), self.maybe(0.3), self.maybe(0.6), true)
                    });
                }
            }
            "6 gantry with wrist" => {
                l.push((0.0, 0.0, 0.0, false));
                l.extend([(90.0, 0.0, 0.0, false), (self.right(), self.maybe(0.3), self.maybe(0.3), false)]);
                wrist_at_end(self, &mut l);
            }
            "6 cylinder with wrist" => {
                l.extend([first, (self.parallel(), self.maybe(0.5), 0.0, false)]);
                l.push((self.right(), self.maybe(0.5), self.maybe(0.3), false));
                wrist_at_end(self, &mut l);
            }
            "6 two slides and wrist" => {
                l.extend([first, (self.right(), self.maybe(0.5), self.maybe(0.3), false)]);
                l.push((self.right(), self.maybe(0.5), self.maybe(0.3), false));
                wrist_at_end(self, &mut l);
            }
            "6 three slides anywhere" => {
                let slides = [[0, 1, 2], [0, 2, 3], [1, 2, 4], [0, 3, 4]];
                let slides = slides[self.pick(&[0.0, 1.0, 2.0, 3.0]) as usize];
                for i in 0..6 {
                    let twist = if i == 0 { 0.0 } else { self.right() };
                    l.push((twist, self.maybe(0.6), self.maybe(0.6), !slides.contains(&i)));
                }
            }
            _ if class.contains("any axes,") || class.ends_with("slides, any axes") => {
                let joints = usize::from(class.as_bytes()[0] - b'0');
                let mut turning: Vec<usize> = (0..joints).collect();
                for _ in 0..if class.contains("two") { 2 } else { 3 } {
                    let at = 0.5 * ((self.0)() + 1.0) * turning.len() as f64;
                    turning.remove((at as usize).min(turning.len() - 1));
                }
                for i in 0..joints {
                    let twist = if i == 0 { 0.0 } else { self.cross() };
                    l.push((twist, self.maybe(0.8), self.maybe(0.8), turning.contains(&i)));
                }
            }
            "6 track" => {
                l.push((0.0, 0.0, 0.0, false));
                l.push((self.right(), self.maybe(0.3), self.maybe(0.3), true));
                l.push((self.right(), self.maybe(0.5), self.maybe(0.2), true));
                l.push((self.parallel(), self.some(), self.maybe(0.2), true));
                l.push((self.parallel(), self.some(), self.maybe(0.5), true));
                l.push((self.right(), 0.0, self.maybe(0.5), true));
            }
            "7 shoulder and wrist" => {
                l.push(first);
                l.extend([(self.right(), 0.0, 0.0, true), (self.right(), 0.0, self.some(), true)]);
                l.extend([
                    (self.right(), self.maybe(0.5), 0.0, true),
                    (self.right(), self.maybe(0.5), self.some(), true),
                ]);
                l.extend([(self.right(), 0.0, 0.0, true), (self.right(), 0.0, self.maybe(0.5), true)]);
            }
            "5 axes 2 to 4 parallel" | "5 axes 2 to 4 parallel, task axis" => {
                l.extend([first, (self.cross(), self.maybe(0.5), self.maybe(0.3), true)]);
                l.extend([(self.parallel(), self.some(), 0.0, true), (self.parallel(), self.some(), 0.0, true)]);
                l.push((self.cross(), self.maybe(0.3), self.maybe(0.7), true));
            }
            "4 scara" => {
                let slide = self.pick(&[0.0, 1.0, 2.0, 3.0]) as usize;
                for i in 0..4 {
                    l.push((
                        if i == 0 { 0.0 } else { self.parallel() },
                        if i == 0 { 0.0 } else { self.some() },
                        0.0,
                        i != slide,
                    ));
                }
            }
            "3 planar" => {
                l.push((0.0, 0.0, 0.0, true));
                l.extend([(0.0, self.some(), 0.0, true), (0.0, self.some(), 0.0, true)]);
            }
            _ => {
                let joints = usize::from(class.as_bytes()[0] - b'0');
                l.push(first);
                for _ in 1..joints {
                    let turns = class.contains("turning") || self.chance(0.6);
                    l.push(self.free(turns));
                }
            }
        }
        l
    }

    fn motions(&mut self, what: &str) -> String {
        if self.chance(0.6) {
            return String::new();
        }
        let turn = ["rx", "ry", "rz"][self.pick(&[0.0, 1.0, 2.0]) as usize];
        let shift = ["tx", "ty", "tz"][self.pick(&[0.0, 1.0, 2.0]) as usize];
        format!("{what} = {shift}({}) * {turn}({}deg);\n", self.some(), self.cross())
    }
}

/// The text of a table of a class, made of numbers in [-1, 1).
pub(super) fn table(class: &str, draw: &mut dyn FnMut() -> f64) -> String {
    let mut m = Maker(draw);
    let links = m.links(class);
    let n = links.len();
    let planar = class.ends_with("planar");
    let modified = planar || m.chance(0.5);
    let mut text = format!("pub struct Arm;\nconvention = {};\n", if modified { "modified" } else { "standard" });
    if let Some((_, task)) = class.split_once("task ") {
        text += &format!("task = {task};\n");
    } else if planar {
        text += "task = planar;\ntool = tx(0.2);\n";
    } else {
        text += &m.motions("base");
        text += &m.motions("tool");
    }
    if n == 7 {
        text += &format!("redundant = q{};\n", m.pick(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]));
    }
    text += "| alpha | a | d | theta |\n";
    for i in 0..n {
        let (d, turns) = (links[i].2, links[i].3);
        let last = (if m.chance(0.7) { 0.0 } else { m.cross() }, m.maybe(0.2), 0.0, true);
        let (alpha, a) =
            if modified { (links[i].0, links[i].1) } else { links.get(i + 1).map_or((last.0, last.1), |l| (l.0, l.1)) };
        let offset = if planar { 0.0 } else { m.pick(&[0.0, 0.0, 0.0, 0.0, 90.0, -90.0, 180.0, 30.0, 17.3]) };
        let q = i + 1;
        text += &if turns {
            format!("| {alpha}deg | {a} | {d} | q{q} + {offset}deg |\n")
        } else {
            format!("| {alpha}deg | {a} | q{q} + {d} | {offset}deg |\n")
        };
    }
    text
}
