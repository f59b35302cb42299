//! Actuators, joints and Cartesian space: who maps what to what, also for velocities.

use super::{Block, Equation, Math, NotesWriter, Sign};
use crate::algebra::Poly;

impl NotesWriter<'_> {
    /// The part of the note.
    pub(in super::super) fn spaces(&mut self) {
        let n = self.chain.dof();
        if n == 0 {
            return;
        }
        self.title(1, "Actuators, joints, Cartesian space", "驱动空间、关节空间与笛卡尔空间");
        self.points(
            &[
                (
                    "Actuator space: what the motors do, here $q_1$ to $q_#0$.",
                    "驱动空间：各电机的位置，这里为 $q_1$ 至 $q_#0$。",
                ),
                (
                    "Joint space: angles and lengths between neighbouring links, the variables of the table. Gears, belts, parallelograms and racks lead from the motors to the joints.",
                    "关节空间：相邻连杆之间的角度和长度，即表中的变量。齿轮、皮带、平行四边形机构和齿条把电机的运动传给关节。",
                ),
                (
                    "Cartesian space: position and orientation of the tool. Forward kinematics leads there from the joints, inverse kinematics back.",
                    "笛卡尔空间：末端的位置和姿态。由关节到此为正运动学，反之为逆运动学。",
                ),
            ],
            &[Math::number(n)],
        );
        if self.chain.is_direct() {
            self.tell_both(
                "On this arm every motor drives one joint alone: actuator and joint space are the same but for constant offsets, and the velocities are equal.",
                "这台臂的每个电机只驱动一个关节：除固定偏置外，驱动空间与关节空间相同，速度相等。",
                &[],
            );
            return;
        }
        self.tell_both("On this arm the motors share joints:", "这台臂的电机与关节相互耦合：", &[]);
        let relations = crate::render::formula::quantities::relations(self.chain, &self.notation, &self.order);
        let list = relations.into_iter().map(|(l, r)| self.equation(l, r)).collect();
        self.blocks.push(Block::Equations(list));
        self.rates();
    }

    /// The velocities of the joints from those of the motors.
    fn rates(&mut self) {
        let n = self.chain.dof();
        let motor = |k: usize| Math::Letter('q').below(Math::number(k + 1));
        let drive: Vec<Vec<Poly>> = self.chain.drive.clone();
        let cell = |w: &Self, p: &Poly| w.notation.typeset(&w.group(p));
        let matrix = Math::Matrix(drive.iter().map(|r| r.iter().map(|p| cell(self, p)).collect()).collect());
        let joints = Math::Matrix((0..n).map(|k| vec![self.coordinate(k).dotted()]).collect());
        let motors = Math::Matrix((0..n).map(|k| vec![motor(k).dotted()]).collect());
        self.tell_both(
            "Differentiated by the time, the velocities of joints and motors:",
            "对时间求导，得关节速度与电机速度的关系：",
            &[],
        );
        self.show_numbered("#0 = C\\thin #1", &[joints, motors]);
        self.show_numbered("C = #0", &[matrix]);
        let determinant = crate::algebra::determinant(&drive, 4000);
        if let Some(det) = determinant {
            let det = cell(self, &det);
            self.tell_both(
                "Its determinant is $\\det C = #0$: not zero, so that every motion of the joints has its motion of the motors, and torques are mapped by the transpose, the other way round.",
                "其行列式 $\\det C = #0$ 不为零，故每个关节运动都对应一个电机运动；力矩则由转置矩阵反向传递。",
                &[det],
            );
        }
        for (k, row) in drive.iter().enumerate() {
            let sum: Poly = row.iter().cloned().sum();
            let moving = row.iter().filter(|p| !p.is_zero()).count();
            if sum.is_zero() && moving > 1 {
                self.tell_both(
                    "$#0$ stands still where these motors run at one speed; their difference drives it.",
                    "这些电机同速运转时 $#0$ 不动，其差速驱动它。",
                    &[self.coordinate(k)],
                );
            }
        }
        self.in_space();
    }

    /// The velocity of the tool from those of the motors.
    fn in_space(&mut self) {
        let product =
            Math::Row(vec![Math::Letter('J').below(Math::Letter('x')), Math::Sign(Sign::Thin), Math::Letter('C')]);
        self.tell_both(
            "With the Jacobian $J_x$ of the joints, the velocity of the tool is $J_x C$ times that of the motors:",
            "设 $J_x$ 为对关节的雅可比矩阵，则末端速度等于 $J_x C$ 乘以电机速度：",
            &[],
        );
        let equation = Equation { left: Math::Letter('J'), right: vec![product], number: None };
        self.blocks.push(Block::Equations(vec![equation]));
    }
}
