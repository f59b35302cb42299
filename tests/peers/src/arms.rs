//! The arms of the tables, and what each peer needs to know of them.

use std::f64::consts::FRAC_PI_2;

use dh_robot::dh_robot;
use generated_examples::cobra600::Cobra600;
use generated_examples::kuka_kr6_r700::KukaKr6R700;
use generated_examples::panda::Panda;
use generated_examples::puma560::Puma560;
use generated_examples::stanford::Stanford;
use generated_examples::ur5::Ur5;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;

use crate::Visit;
use crate::locked::Locked;
use crate::peer::{Opw, Peer};

/// Joint (counted from 0) and value where the wrist is singular, and where the elbow is stretched, for arms with such sets.
pub type Singular = [Option<(usize, f64)>; 2];

dh_robot! {
    /// FANUC CRX-10iA: axes 2 and 3 are parallel, the wrist has no common point; up to 16 solutions.
    pub struct Crx10ia;

    convention = modified;

    | joint | alpha  | a     | d      | theta      |
    |-------|--------|-------|--------|------------|
    |   1   |   0    | 0     | 0      | q1         |
    |   2   | -90deg | 0     | 0      | q2 - 90deg |
    |   3   |   0    | 540mm | 0      | q3         |
    |   4   | -90deg | 0     | 540mm  | q4         |
    |   5   |  90deg | 0     | -150mm | q5         |
    |   6   | -90deg | 0     | 160mm  | q6         |
}

dh_robot! {
    /// Six turning joints without any special geometry.
    pub struct General6r;

    convention = standard;

    | joint | theta | d     | a    | alpha  |
    |-------|-------|-------|------|--------|
    |   1   | q1    | 0.37  | 0.21 |  73deg |
    |   2   | q2    | 0.11  | 0.43 | -52deg |
    |   3   | q3    | -0.17 | 0.31 |  67deg |
    |   4   | q4    | 0.29  | 0.13 | -81deg |
    |   5   | q5    | 0.19  | 0.09 |  58deg |
    |   6   | q6    | 0.11  | 0.07 |  39deg |
}

dh_robot! {
    /// KUKA LBR iiwa 7 R800: spherical shoulder and wrist; the third joint is the caller's.
    pub struct Iiwa7;

    convention = standard;
    redundant = q3;

    | joint | theta | d     | a | alpha  |
    |-------|-------|-------|---|--------|
    |   1   | q1    | 0.34  | 0 | -90deg |
    |   2   | q2    | 0     | 0 |  90deg |
    |   3   | q3    | 0.4   | 0 |  90deg |
    |   4   | q4    | 0     | 0 | -90deg |
    |   5   | q5    | 0.4   | 0 | -90deg |
    |   6   | q6    | 0     | 0 |  90deg |
    |   7   | q7    | 0.126 | 0 |   0    |
}

/// Parameters of the Puma in the frames of rs-opw-kinematics.
fn puma() -> Parameters {
    Parameters {
        a1: 0.0,
        a2: -0.0203,
        b: 0.15005,
        c1: 0.0,
        c2: 0.4318,
        c3: 0.4318,
        c4: 0.0,
        offsets: [0.0, -FRAC_PI_2, -FRAC_PI_2, 0.0, 0.0, 0.0],
        sign_corrections: [1; 6],
        dof: 6,
    }
}

/// Parameters of the KR 6 R700 in the frames of rs-opw-kinematics.
fn kuka() -> Parameters {
    Parameters {
        a1: 0.025,
        a2: -0.035,
        b: 0.0,
        c1: 0.4,
        c2: 0.315,
        c3: 0.365,
        c4: 0.08,
        offsets: [0.0, 0.0, -FRAC_PI_2, 0.0, 0.0, 0.0],
        sign_corrections: [1; 6],
        dof: 6,
    }
}

/// Adds IK-Geo where it is built in.
macro_rules! peers {
    ($robot:expr, [$($peer:expr),*], $class:ident, $meet:literal) => {{
        #[allow(unused_mut)]
        let mut peers: Vec<Box<dyn Peer<6>>> = vec![$(Box::new($peer)),*];
        #[cfg(feature = "ik-geo")]
        peers.push(Box::new(crate::ik_geo::IkGeo::new(
            $robot, stringify!($class), ::ik_geo::inverse_kinematics::$class, $meet,
        )));
        peers
    }};
}

/// Shows every arm to `visit`.
pub fn every(visit: &mut impl Visit) {
    let robot = Puma560::default();
    let peers = peers!(&robot, [Opw::new(&robot, puma())], spherical_two_parallel, 3);
    visit.arm("PUMA 560", &robot, &peers, [Some((4, 0.0)), Some((2, (0.0203_f64 / 0.4318).atan() - FRAC_PI_2))]);

    let robot = KukaKr6R700::default();
    let peers = peers!(&robot, [Opw::new(&robot, kuka())], spherical_two_parallel, 3);
    visit.arm("KUKA KR 6 R700", &robot, &peers, [Some((4, 0.0)), Some((2, (0.035_f64 / 0.365).atan() - FRAC_PI_2))]);

    let robot = Ur5::default();
    let peers = peers!(&robot, [], three_parallel_two_intersecting, 4);
    visit.arm("UR5", &robot, &peers, [Some((4, 0.0)), Some((2, 0.0))]);

    let robot = Crx10ia::default();
    visit.arm("FANUC CRX-10iA", &robot, &[], [Some((4, 0.0)), Some((2, -FRAC_PI_2))]);

    let robot = General6r::default();
    visit.arm("general 6R", &robot, &[], [None, None]);

    visit.arm("iiwa 7, joint 3 given", &Locked::new(Iiwa7::default(), 2, 0.7), &[], [Some((5, 0.0)), Some((3, 0.0))]);
    visit.arm("Panda, joint 7 given", &Locked::new(Panda::default(), 6, 0.7), &[], [None, None]);

    visit.arm("Stanford arm", &Stanford::default(), &[], [Some((4, 0.0)), None]);
    visit.arm("SCARA (Cobra 600)", &Cobra600::default(), &[], [None, None]);
}
