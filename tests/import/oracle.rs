//! The pose of a chain of a URDF file, by a product of transforms that is written here anew.

use dh_symbolic::import::Imported;
use dh_tests::engine::spec;
use dh_tests::naive::{Arm, Matrix};
use roxmltree::{Document, Node};

/// A joint of the file, as plain numbers.
pub(super) struct Step {
    pub(super) origin: Matrix,
    pub(super) axis: [f64; 3],
    /// `None`: fixed; true: turns.
    pub(super) turns: Option<bool>,
    pub(super) name: String,
    /// The joint that this one follows, factor and offset.
    pub(super) follows: Option<(String, f64, f64)>,
}

pub(super) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// Roll, pitch, yaw written out.
pub(super) fn transform(xyz: [f64; 3], [r, p, y]: [f64; 3]) -> Matrix {
    let ((sr, cr), (sp, cp), (sy, cy)) = (r.sin_cos(), p.sin_cos(), y.sin_cos());
    [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr, xyz[0]],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr, xyz[1]],
        [-sp, cp * sr, cp * cr, xyz[2]],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

/// Turning about any direction (quaternion).
pub(super) fn turn(axis: [f64; 3], angle: f64) -> Matrix {
    let n = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (s, w) = (angle / 2.0).sin_cos();
    let [x, y, z] = axis.map(|c| c / n * s);
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w), 0.0],
        [2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w), 0.0],
        [2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y), 0.0],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

/// The joints from base to tip; angles nearer than `exact` to a multiple of 15 degrees are taken for it.
pub(super) fn steps(text: &str, base: &str, tip: &str, exact: f64) -> Vec<Step> {
    let document = Document::parse(text).expect("XML");
    let joints: Vec<Node<'_, '_>> =
        document.root_element().children().filter(|n| n.tag_name().name() == "joint").collect();
    let child = |n: &Node<'_, '_>, name: &str| n.children().find(|c| c.tag_name().name() == name).map(|c| c.id());
    let attribute = |n: &Node<'_, '_>, name: &str, key: &str| {
        let id = child(n, name)?;
        document.get_node(id)?.attribute(key).map(str::to_string)
    };
    let triple = |text: Option<String>, default: [f64; 3]| match text {
        Some(text) => {
            let list: Vec<f64> = text.split_whitespace().map(|w| w.parse().expect("a number")).collect();
            <[f64; 3]>::try_from(list).expect("three numbers")
        }
        None => default,
    };
    let step = std::f64::consts::PI / 12.0;
    let snapped = |x: f64| if (x - (x / step).round() * step).abs() <= exact { (x / step).round() * step } else { x };
    let mut list = Vec::new();
    let mut link = tip.to_string();
    while link != base {
        let joint = joints
            .iter()
            .find(|j| attribute(j, "child", "link").as_deref() == Some(&link))
            .unwrap_or_else(|| panic!("no way from {tip} to {base}"));
        let rpy = triple(attribute(joint, "origin", "rpy"), [0.0; 3]).map(snapped);
        let number = |name: &str, default: f64| {
            attribute(joint, "mimic", name).map_or(default, |x| x.parse().expect("a number"))
        };
        list.push(Step {
            origin: transform(triple(attribute(joint, "origin", "xyz"), [0.0; 3]), rpy),
            axis: triple(attribute(joint, "axis", "xyz"), [1.0, 0.0, 0.0]),
            turns: match joint.attribute("type") {
                Some("fixed") => None,
                Some("prismatic") => Some(false),
                _ => Some(true),
            },
            name: joint.attribute("name").expect("a name").to_string(),
            follows: attribute(joint, "mimic", "joint")
                .map(|name| (name, number("multiplier", 1.0), number("offset", 0.0))),
        });
        link = attribute(joint, "parent", "link").expect("a parent");
    }
    list.reverse();
    list
}

/// The pose of the tip.
pub(super) fn pose(steps: &[Step], q: &[f64]) -> Matrix {
    let moving: Vec<&Step> = steps.iter().filter(|s| s.turns.is_some()).collect();
    let value = |step: &Step| -> f64 {
        let (mut at, mut factor, mut sum) = (step, 1.0, 0.0);
        while let (Some((leader, k, offset)), true) = (&at.follows, follows_in(at, &moving)) {
            (sum, factor) = (sum + factor * offset, factor * k);
            at = moving.iter().find(|s| s.name == *leader).expect("the leader");
        }
        sum + factor * q[moving.iter().position(|s| s.name == at.name).expect("a motor")]
    };
    let mut m = transform([0.0; 3], [0.0; 3]);
    for step in steps {
        m = product(&m, &step.origin);
        match step.turns {
            Some(true) => m = product(&m, &turn(step.axis, value(step))),
            Some(false) => {
                let n = step.axis.iter().map(|x| x * x).sum::<f64>().sqrt();
                m = product(&m, &transform(step.axis.map(|x| x / n * value(step)), [0.0; 3]));
            }
            None => {}
        }
    }
    m
}

pub(super) fn follows_in(step: &Step, moving: &[&Step]) -> bool {
    step.follows.as_ref().is_some_and(|(leader, ..)| moving.iter().any(|s| s.name == *leader))
}

/// Base and tip by the first note.
pub(super) fn chain_of(made: &Imported) -> (String, String) {
    let words = made.notes[0].trim_start_matches("chain ").split(',').next().expect("a chain");
    let (base, tip) = words.split_once("..").expect("two links");
    (base.to_string(), tip.to_string())
}

/// The largest difference of an entry between table and file, positions over the reach.
pub(super) fn difference(text: &str, made: &Imported, exact: f64) -> f64 {
    let (base, tip) = chain_of(made);
    let steps = steps(text, &base, &tip, exact);
    let spec = spec(&made.table);
    let arm = Arm::new(&spec, &|_| panic!("no fields"));
    let moving: Vec<&Step> = steps.iter().filter(|s| s.turns.is_some()).collect();
    let follows: Vec<bool> = moving.iter().map(|s| follows_in(s, &moving)).collect();
    let motors = spec.rows.iter().flat_map(|r| &r.moves).flat_map(|m| &m.terms).map(|t| t.0 + 1).max().unwrap_or(0);
    let mut worst = 0.0f64;
    for sample in 0..20 {
        let q: Vec<f64> = (0..motors)
            .map(|i| if sample == 0 || follows[i] { 0.0 } else { ((i * 31 + sample * 17) as f64).sin() * 3.0 })
            .collect();
        let (have, want) = (arm.pose(&q), pose(&steps, &q));
        let reach = arm.reach(&q).max(1.0);
        for i in 0..3 {
            for j in 0..4 {
                worst = worst.max((have[i][j] - want[i][j]).abs() / if j == 3 { reach } else { 1.0 });
            }
        }
    }
    worst
}
