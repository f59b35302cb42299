//! The arm of the cup-grasp task: a base, a tool and millimetres.
//!
//! Source: slides on inverse kinematics, the task worked through with numbers. The tool frame is the cup's, held by the gripper;
//! the notes work out where the table and the cup on it stand.
//!
//! Notes: --frames b=W,e=C
//! Notes: --pose tx(830) * ty(20) * tz(330) * tx(-280) * ty(250) * tz(62.5) * rz(35deg)

use dh_robot::dh_robot;

dh_robot! {
    /// The arm that grasps a cup, in millimetres, on its stand and with its gripper.
    pub struct CupArm;

    convention = modified;
    unit = mm;
    base = tz(373mm);
    tool = tz(206mm) * ry(90deg) * rz(180deg);

    | joint | alpha  | a   | d   | theta |
    |-------|--------|-----|-----|-------|
    |   1   |   0    | 0   | 0   | q1    |
    |   2   | -90deg | -30 | 0   | q2    |
    |   3   |   0    | 340 | 0   | q3    |
    |   4   | -90deg | -40 | 338 | q4    |
    |   5   |  90deg | 0   | 0   | q5    |
    |   6   | -90deg | 0   | 0   | q6    |
}
