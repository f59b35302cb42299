//! Tables whose notes are followed by hand: arms from public reports that once were printed wrongly, and random ones.

pub(crate) const OWN: [(&str, &str); 8] = [
    (
        "offset of joint 3",
        "pub struct Offset; convention = modified;
        | alpha | a | d | theta |
        | 0 | 0 | 0 | q1 |
        | -90deg | 0 | 0 | q2 |
        | 0 | 0.4 | 0 | q3 + 90deg |
        | 90deg | 0 | 0.4 | q4 |
        | -90deg | 0 | 0 | q5 |
        | 90deg | 0.1 | 0 | q6 |",
    ),
    (
        "MH12",
        "pub struct Mh; convention = standard; tool = tz(0.1) * ry(30deg);
        | theta | d | a | alpha |
        | q1 | 0.45 | 0.155 | -90deg |
        | q2 - 90deg | 0 | 0.614 | 180deg |
        | q3 | 0 | 0.2 | -90deg |
        | q4 | -0.64 | 0 | 90deg |
        | q5 | 0 | 0 | -90deg |
        | q6 + 180deg | -0.1 | 0 | 180deg |",
    ),
    (
        "point in space",
        "pub struct Ppp; convention = modified; task = position; base = tz(1);
        | alpha | a | d | theta |
        | 30deg | 0.2 | q1 | 0 |
        | -90deg | 0 | q2 + 0.3 | 90deg |
        | -90deg | 0 | q3 | 0 |",
    ),
    (
        "point on a turned arm",
        "pub struct Point; convention = modified; task = position; tool = tx(0.3); base = rx(40deg);
        | alpha | a | d | theta |
        | 25deg | 0.1 | 0.2 | q1 - 90deg |
        | 90deg | 0 | 0 | q2 |
        | 0 | 0.5 | 0 | q3 + 180deg |",
    ),
    (
        "five axes",
        "pub struct Axis; convention = modified; task = axis; let l_1: length = 0.3; let l_2: length = 0.4; let l_3: length = 0.2;
        | alpha | a | d | theta |
        | 90deg | 0 | l_1 | q1 |
        | 0 | l_2 | 0 | -(q2 + 90deg) |
        | 0 | l_3 | 0 | q3 + 90deg |
        | -90deg | 0.1 | 0 | q4 |
        | 0 | 0 | 0.3 | q5 |",
    ),
    (
        "letters of the table",
        "pub struct Letters; convention = standard; let k: length = 0.3; let L: length = 0.4; let u: length = 0.2;
        | theta | d | a | alpha |
        | q1 | k | 0 | 90deg |
        | q2 | 0 | L | 0 |
        | q3 | 0 | u | 0 |
        | q4 | 0.1 | 0 | 90deg |
        | q5 | -0.09 | 0 | -90deg |
        | q6 | 0.08 | 0 | 0 |",
    ),
    (
        "parallelogram",
        "pub struct Drive; convention = standard;
        | theta | d | a | alpha |
        | q1 | 0.4 | 0.1 | -90deg |
        | q2 - 90deg | 0 | 0.5 | 0 |
        | q3 - q2 + 90deg | 0 | -0.1 | -90deg |
        | q4 | 0.6 | 0 | 90deg |
        | q5 | 0 | 0 | -90deg |
        | q6 | 0.1 | 0 | 0 |",
    ),
    (
        "plane",
        "pub struct Plane; convention = modified; task = planar; tool = tx(0.2);
        | alpha | a | d | theta |
        | 0 | 0 | 0.3 | q1 |
        | 0 | 0.4 | 0 | q2 + 30deg |
        | 0 | 0.3 | 0.1 | q3 |",
    ),
];

/// Number of random tables.
pub(crate) const RANDOM: u64 = 24;

struct Random(u64);

impl Random {
    /// A number below `n`.
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % n
    }

    fn pick<'a>(&mut self, list: &[&'a str]) -> &'a str {
        list[self.below(list.len())]
    }

    /// A length in millimetres, negative ones among them.
    fn length(&mut self) -> String {
        let size = 50 + 10 * self.below(40);
        format!("{}{size}", if self.below(3) == 0 { "-" } else { "" })
    }

    fn perhaps(&mut self, n: usize) -> String {
        if self.below(n) == 0 { self.length() } else { "0".into() }
    }
}

/// An arm with a spherical wrist or three parallel axes, offsets, a base, a tool, coupled joints, in either convention.
pub(crate) fn random(seed: u64) -> String {
    let mut r = Random(seed * 7919 + 17);
    for _ in 0..5 {
        r.below(2);
    }
    let modified = r.below(2) == 0;
    let parallel = r.below(3) == 0;
    let coupled = r.below(4) == 0;
    let quarter = ["", " + 90deg", " - 90deg", " + 180deg", "", " + 30deg"];
    let (p, m) = (["90deg", "-90deg"], ["-90deg", "90deg"]);
    let turn = r.below(2);
    // Twists between neighbouring axes.
    let twists = match parallel {
        true => [p[turn], "0", "0", p[1 - turn], m[1 - turn]],
        false => [p[turn], if r.below(4) == 0 { "180deg" } else { "0" }, p[1 - turn], m[turn], p[turn]],
    };
    let (mut a, mut d): (Vec<String>, Vec<String>) = (vec!["0".into(); 7], vec!["0".into(); 6]);
    a[1] = r.perhaps(2);
    a[2] = r.length();
    a[3] = if parallel { r.length() } else { r.perhaps(2) };
    d[0] = r.perhaps(2);
    d[1] = r.perhaps(4);
    d[3] = r.length();
    d[4] = if parallel { r.length() } else { "0".into() };
    d[5] = r.perhaps(2);
    let mut out =
        format!("pub struct Random; convention = {}; unit = mm;\n", if modified { "modified" } else { "standard" });
    if r.below(3) == 0 {
        out += &format!("base = tz({}) * rx({});\n", r.length(), r.pick(&["90deg", "30deg", "180deg"]));
    }
    if r.below(3) == 0 {
        out += &format!("tool = tz({}) * ry({});\n", r.length(), r.pick(&["90deg", "-30deg"]));
    }
    out += "| alpha | a | d | theta |\n";
    for i in 0..6 {
        let variable = if coupled && i == 2 { "q3 - q2".to_string() } else { format!("q{}", i + 1) };
        let theta = format!("{variable}{}", r.pick(&quarter));
        let (alpha, length) = match modified {
            true => (if i == 0 { "0" } else { twists[i - 1] }, if i == 0 { "0" } else { &a[i] }),
            false => (if i == 5 { "0" } else { twists[i] }, if i == 5 { "0" } else { &a[i + 1] }),
        };
        out += &format!("| {alpha} | {length} | {} | {theta} |\n", d[i]);
    }
    out
}
