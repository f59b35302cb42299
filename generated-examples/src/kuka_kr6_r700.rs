//! The KUKA KR 6 R700: a spherical wrist behind an offset shoulder.
//!
//! Source: lengths of the data sheet as in `opw_parameters_examples.h` of the opw_kinematics project, written as a table.

use dh_robot::dh_robot;

dh_robot! {
    /// KUKA KR 6 R700 sixx.
    pub struct KukaKr6R700;

    convention = standard;

    | joint | theta      | d     | a     | alpha  | range            |
    |-------|------------|-------|-------|--------|------------------|
    |   1   | q1         | 400mm | 25mm  | -90deg | -170deg..=170deg |
    |   2   | q2 - 90deg | 0     | 315mm |   0    | -190deg..= 45deg |
    |   3   | q3         | 0     | 35mm  | -90deg | -120deg..=156deg |
    |   4   | q4         | 365mm | 0     |  90deg | -185deg..=185deg |
    |   5   | q5         | 0     | 0     | -90deg | -120deg..=120deg |
    |   6   | q6         | 80mm  | 0     |   0    | -350deg..=350deg |
}
