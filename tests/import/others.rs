//! Tables from CSV, Markdown, toolbox scripts and calibration files: poses as their authors have them.

use dh_symbolic::chain::Convention;
use dh_symbolic::import::{Imported, Options, Problem, from_calibration, from_table, from_toolbox, from_urdf};
use dh_tests::engine::spec;
use dh_tests::naive::{Arm, Matrix};

fn arm(made: &Imported) -> Arm {
    Arm::new(&spec(&made.table), &|name| panic!("{name}"))
}

/// Joint values of 10, 20, 30 degrees and so on.
fn tens(n: u32) -> Vec<f64> {
    (1..=n).map(|i| f64::from(10 * i).to_radians()).collect()
}

/// The pose of the reports on this arm.
fn asked() -> Vec<f64> {
    [20.0, -30.0, 40.0, 50.0, -60.0, 70.0].map(f64::to_radians).to_vec()
}

fn close(have: &Matrix, want: &Matrix, tolerance: f64) {
    for i in 0..3 {
        for j in 0..4 {
            assert!((have[i][j] - want[i][j]).abs() < tolerance, "{have:?}\n{want:?}");
        }
    }
}

fn made(result: Result<Imported, Problem>) -> Imported {
    result.unwrap_or_else(|e| panic!("{e:?}"))
}

/// Case B45 of the public reports: a README's table with TeX in its header, bare degrees, `90 + \\theta_2`.
#[test]
fn a_table_of_a_readme() {
    let text = r"
Some words.

| Links | $\alpha_{i-1}$ | $a_{i-1}$ | $\theta_i$ | $d_i$ |
| -- | -- | -- | -- | -- |
|1| 0      | 0   | $\theta_1$          | 243.3 |
|2| 90  | 0   | 90 + $\theta_2$  | 30 |
|3| 180 | 280 | 90 + \theta_3  | 20 |
|4| 90  | 0   | 90 + \theta_4  | 245 |
|5| 90  | 0   | 180 + \theta_5 | 57 |
|6| 90  | 0   | 90 + \theta_6  | 235 |

More words.
";
    let made = made(from_table(text, &Options { unit: Some("mm".into()), ..Options::default() }));
    assert!(made.notes.iter().any(|n| n.starts_with("modified convention")), "{:#?}", made.notes);
    let want = [
        [0.008032956591, -0.72435519636, 0.689380171686, 147.313154150226],
        [0.760780951207, -0.442981302158, -0.474320472063, -87.005921812757],
        [0.648959024815, 0.528277498521, 0.547517185728, 868.776105325252],
        [0.0, 0.0, 0.0, 1.0],
    ];
    close(&arm(&made).pose(&tens(6)), &want, 1e-9);
    let other = Options { convention: Some(Convention::Standard), ..Options::default() };
    let problem = from_table(text, &other).expect_err("the header says modified");
    assert_eq!(problem.at, Some((4, 1)));
}

/// Case B44: CSV with Greek letters, capitals, bare degrees, and variables of any number.
#[test]
fn csv_with_its_own_numbers() {
    let options = Options { convention: Some(Convention::Standard), unit: Some("mm".into()), ..Options::default() };
    let arms = "Link,θ,D,A,α\n1,q15,0,0,90\n2,-90+q16,0,0,90\n3,-90+q17,329.01,0,90\n4,q18,0,0,-90\n5,q19,202,0,90\n6,90+q20,0,187.496,0\n";
    let table = made(from_table(arms, &options));
    assert!(
        table.notes.contains(&"variables 15 to 20 are q1 to q6 here, in the order of the rows".to_string()),
        "{:#?}",
        table.notes
    );
    let want = [
        [0.3181118114, 0.2126651904, 0.9238930632, -226.4928140385],
        [-0.9006756081, 0.3720062552, 0.2244878507, -399.1646096222],
        [-0.2959532472, -0.9035401833, 0.3098819334, 260.0762202723],
        [0.0, 0.0, 0.0, 1.0],
    ];
    close(&arm(&table).pose(&asked()), &want, 1e-8);
    let leg = "Link\tθ\tD\tA\tα\n1\tq6\t0\t0\t90°\n2\t90+q5\t0\t0\t90°\n3\tq4\t0\t-330\t0\n4\tq3\t17.5\t-300\t0\n5\tq2\t0\t0\t-90\n6\tq1\t0\t-123.005\t0\n";
    let table = made(from_table(leg, &options));
    let want = [
        [0.1181577625, -0.9897220176, 0.0805547705, -213.7175518945],
        [-0.2330222515, -0.1064940099, -0.9666228097, 108.1887636974],
        [0.965266478, 0.0954429344, -0.2432103468, -670.8961639956],
        [0.0, 0.0, 0.0, 1.0],
    ];
    close(&arm(&table).pose(&[10.0, -20.0, 30.0, -40.0, 25.0, 15.0].map(f64::to_radians)), &want, 1e-8);
}

/// Case B24: radians without a unit are right angles, and never degrees.
#[test]
fn radians_are_told_from_degrees() {
    let text = "joint;theta;d;a;alpha;min;max\n1;q1;0;0.2951;-1.5708;-3.1416;3.1416\n2;q2;0.9954;0.4270;1.5708;-1;1\n3;0;q3;0;0;0;0.3\n";
    let options = Options { convention: Some(Convention::Standard), ..Options::default() };
    let table = made(from_table(text, &options));
    assert!(table.table.contains("| -90deg |") && table.table.contains("0..=0.3"), "{}", table.table);
    assert!(table.notes.iter().any(|n| n == "line 2: alpha -1.5708 -> -90deg, off by 3.7e-6"), "{:#?}", table.notes);
    let unclear = "joint,theta,d,a,alpha\n1,q1,0,0.3,1.2\n2,q2,0,0.4,2.1\n";
    let problem = from_table(unclear, &options).expect_err("degrees or radians");
    assert_eq!(problem.help.as_deref(), Some("`--angles deg` or `--angles rad`"));
    assert!(from_table(unclear, &Options { degrees: Some(false), ..options.clone() }).is_ok());
    for (text, message) in [
        ("", "the file is empty"),
        ("theta,d,a\nq1,0,0\n", "column `alpha` is missing in the header: theta, d, a"),
        ("theta,d,a,alpha\nq1,0,0\n", "this row has 3 cells, the header has 4"),
        ("theta,d,a,alpha\nq1,0,0,\n", "an empty cell in column `alpha`: write 0"),
        ("theta,d,a,alpha\nq1,0,0,foo\n", "`foo` is no constant: numbers, pi, and functions of them"),
        ("theta,d,a,alpha\n0,0,1,0\n", "no row has a joint variable: `q1`, `θ1`, `theta_1`"),
        ("theta,d,a,alpha\nq1,0,1,0\nq1,0,1,0\n", "one variable moves several rows: such a table is written by hand"),
    ] {
        assert_eq!(from_table(text, &options).expect_err(message).message, message);
    }
    let unknown = from_table("theta,d,a,alpha\nq1,0,1,0\n", &Options::default()).expect_err("no convention");
    assert!(unknown.message.contains("which convention"));
}

#[test]
fn scripts_of_toolboxes() {
    let matlab = "
% a PUMA 560, MATLAB
deg = pi/180;
L(1) = Revolute('d', 0, 'a', 0, 'alpha', pi/2, 'I', [0, 0.35, 0, 0, 0, 0], 'qlim', [-160 160]*deg);
L(2) = Revolute('d', 0, ...  % upper arm
    'a', 0.4318, 'alpha', 0);
L(3) = Revolute('d', 0.15005, 'a', 0.0203, 'alpha', -1.5708);
L(4) = Link([0 0.4318 0 pi/2]);
L(5) = Revolute('alpha', -pi/2, 'offset', pi/2);
L(6) = Prismatic('theta', 0, 'qlim', [0 0.2]);
";
    let table = made(from_toolbox(matlab, &Options { name: Some("Puma".into()), ..Options::default() }));
    assert!(
        table.table.contains("convention = standard;") && table.table.contains("pub struct Puma;"),
        "{}",
        table.table
    );
    let rows = arm(&table).rows;
    assert_eq!((rows.len(), rows[1].a, rows[2].d, rows[3].d), (6, 0.4318, 0.15005, 0.4318));
    assert!(table.table.contains("q5 + 90deg") && table.table.contains("0..=0.2"), "{}", table.table);
    assert!((rows[2].alpha + std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    let python = "
import roboticstoolbox as rtb
a2 = 0.4318
robot = rtb.DHRobot([
    RevoluteMDH(d=0.3, alpha=0),   # waist
    RevoluteMDH(alpha=-np.pi/2, qlim=[-pi, pi/2], offset=-pi/2),
    rtb.RevoluteMDH(a=a2 + 0.1, d=-0.02),
])
";
    let table = made(from_toolbox(python, &Options::default()));
    assert!(
        table.table.contains("convention = modified;") && table.table.contains("-180deg..=90deg"),
        "{}",
        table.table
    );
    let rows = arm(&table).rows;
    assert!((rows[2].a - 0.5318).abs() < 1e-15 && rows[2].d == -0.02 && rows[1].theta < -1.5);
    for (text, line, message) in [
        ("x = 1", None, "there is no link in this script"),
        ("\nL = Revolute('d', b)", Some(2), "`b` is no constant that is known here"),
        ("L = Revolute('d', 1", Some(1), "the bracket behind `Revolute` is never closed"),
        ("L = Link([1 2])", Some(1), "`[1 2]` is no row theta, d, a, alpha"),
        ("[RevoluteDH(d=1), RevoluteMDH(d=1)]", None, "some links of this script"),
    ] {
        let problem = from_toolbox(text, &Options::default()).expect_err(message);
        assert!(problem.message.starts_with(message), "{problem:?}");
        assert_eq!(problem.at.map(|a| a.0), line, "{problem:?}");
    }
}

const NOMINAL: &str = "pub struct Ur5e; convention = standard;
| joint | theta | d | a | alpha | range |
| pan   | q1 | 0.1625 | 0       |  90deg | -360deg..=360deg |
| lift  | q2 | 0      | -0.425  |  0     | -360deg..=360deg |
| elbow | q3 | 0      | -0.3922 |  0     | -180deg..=180deg |
| w1    | q4 | 0.1333 | 0       |  90deg | -360deg..=360deg |
| w2    | q5 | 0.0997 | 0       | -90deg | -360deg..=360deg |
| w3    | q6 | 0.0996 | 0       |  0     | -360deg..=360deg |
";

/// Link poses as the driver writes them.
const CALIBRATION: &str = "kinematics:
  shoulder:
    x: 0
    y: 0
    z: 0.16254
    roll: 0
    pitch: 0
    yaw: 1.3e-05
  upper_arm:
    x: -0.00012
    y: 0
    z: 0
    roll: 1.5703
    pitch: 0
    yaw: -2.1e-05
  forearm:
    x: -0.42503
    y: 0
    z: 0
    roll: 0.00042
    pitch: 0.00031
    yaw: 1.1e-05
  wrist_1:
    x: -0.39215
    y: -0.00007
    z: 0.13332
    roll: 0.00054
    pitch: -0.00022
    yaw: -3.0e-06
  wrist_2:
    x: 4.0e-05
    y: -0.09971
    z: 0.00002
    roll: 1.5711
    pitch: 0
    yaw: 1.0e-06
  wrist_3:
    x: 0.00001
    y: 0.09962
    z: -0.00003
    roll: 1.5705
    pitch: 3.14159
    yaw: 3.14159
  hash: calib_0123
";

#[test]
fn the_arm_of_one_serial_number() {
    let table = made(from_calibration(CALIBRATION, NOMINAL, &Options::default()));
    let calibrated = arm(&table);
    // Nearly parallel axes: all lengths are those of the arm.
    assert!(calibrated.rows.iter().all(|r| r.d.abs() < 0.5 && r.a.abs() < 0.5), "{}", table.table);
    assert!(table.table.contains("pub struct Ur5eCalibrated;") && table.table.contains("| elbow"), "{}", table.table);
    // The same poses as those of a URDF with these numbers.
    let link = |name: &str, keys: [&str; 3]| {
        let at = CALIBRATION.find(name).expect("a link");
        let value = |key: &str| {
            let tail =
                &CALIBRATION[at + CALIBRATION[at..].find(&format!(" {key}: ")).expect("a key") + key.len() + 3..];
            tail.lines().next().expect("a value").to_string()
        };
        keys.map(value).join(" ")
    };
    let mut joints: Vec<[String; 5]> = Vec::new();
    for name in ["shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3"] {
        let (xyz, rpy) = (link(name, ["x", "y", "z"]), link(name, ["roll", "pitch", "yaw"]));
        joints.push(["revolute".into(), xyz, rpy, "0 0 1".into(), String::new()]);
    }
    let list: Vec<[&str; 5]> = joints.iter().map(|j| std::array::from_fn(|i| j[i].as_str())).collect();
    let urdf = super::serial(&list);
    let options = Options { rounding: dh_symbolic::import::Rounding::AsWritten, ..Options::default() };
    let same = arm(&made(from_urdf(&urdf, &options)));
    for sample in 0..5 {
        let q: Vec<f64> = (0..6).map(|i| f64::from(i * 3 + sample).sin() * 3.0).collect();
        close(&calibrated.pose(&q), &same.pose(&q), 1e-12);
        close(&calibrated.pose(&q), &Arm::new(&spec(NOMINAL), &|_| 0.0).pose(&q), 5e-3);
    }
}

#[test]
fn deviations_of_the_columns() {
    // As the controller stores them: second and third row far away along nearly parallel axes.
    let text = "[mounting]\ndelta_theta = [1e-5, 0.2, -0.2, 0, 0, 0]\ndelta_a = [0, 1e-4, 0, 0, 0, 0]\ndelta_d = [0, 40.0, -40.0, 0, 0, 0]\ndelta_alpha = [0, 5e-4, -5e-4, 1e-4, 0, 0]\n";
    let nominal = Arm::new(&spec(NOMINAL), &|_| 0.0);
    let mut want = nominal.clone();
    for (row, (theta, a, d, alpha)) in want.rows.iter_mut().zip([
        (1e-5, 0.0, 0.0, 0.0),
        (0.2, 1e-4, 40.0, 5e-4),
        (-0.2, 0.0, -40.0, -5e-4),
        (0.0, 0.0, 0.0, 1e-4),
    ]) {
        row.theta += theta;
        row.a += a;
        row.d += d;
        row.alpha += alpha;
    }
    let table = made(from_calibration(text, NOMINAL, &Options::default()));
    let have = arm(&table);
    assert!(have.rows.iter().all(|r| r.d.abs() < 1.0), "{}", table.table);
    for sample in 0..5 {
        let q: Vec<f64> = (0..6).map(|i| f64::from(i * 3 + sample).sin() * 3.0).collect();
        close(&have.pose(&q), &want.pose(&q), 1e-12);
    }
}

#[test]
fn calibrations_that_do_not_fit() {
    let message = |text: &str| {
        let problem = from_calibration(text, NOMINAL, &Options::default()).expect_err("wrong");
        (problem.at.map(|a| a.0), problem.message)
    };
    assert!(message(&CALIBRATION.replace("z: 0.16254", "z: 0.5")).1.contains("is off the nominal one"));
    assert_eq!(message(&CALIBRATION.replace("z: 0.16254", "z: .nan")).0, Some(5));
    assert!(message(&CALIBRATION.replace("    yaw: 1.3e-05\n", "")).1.contains("has no `yaw`"));
    assert!(message("delta_a: [0, 1]").1.contains("`delta_a` has 2 values, the table 6 rows"));
    assert!(message("a: 1").1.contains("this is no calibration"));
    let three = "pub struct A; convention = standard; | theta | d | a | alpha | | q1 | 0 | 1 | 0 |";
    assert!(
        from_calibration(CALIBRATION, three, &Options::default()).expect_err("1 joint").message.contains("6 links")
    );
}
