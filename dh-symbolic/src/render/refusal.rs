//! The wording of the reasons why an arm has no inverse: for compile errors, plans, notes and pages.

use super::Language;
use crate::chain::Chain;
use crate::planner::{MOST_OPEN_JOINTS, Refusal};

/// What a remark is about, so that it can be shown there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The robot as a whole.
    Robot,
    /// A joint (from 0).
    Joint(usize),
    /// The setting `task`.
    Task,
    /// The setting `redundant`.
    Redundant,
}

/// One reason, with what can be done about it. Names of the table stand between backticks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// What it is about.
    pub subject: Subject,
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub help: String,
}

impl Remark {
    /// Message and help as one text.
    pub fn sentences(&self) -> String {
        format!("{} ({})", self.message, self.help)
    }
}

/// The reasons of a refusal, one for each place of the table that it concerns.
pub fn remarks(chain: &Chain, refusal: &Refusal, language: Language) -> Vec<Remark> {
    let words = |english: &str, chinese: &str| match language {
        Language::English => english.to_string(),
        Language::Chinese => chinese.to_string(),
    };
    let name = |joint: usize| chain.joints.get(joint).map_or("", |j| j.name.as_str());
    let no_inverse = || words("`ik = none;` asks for no inverse", "`ik = none;` 表示不求逆解");
    match refusal {
        Refusal::TooManyJoints { open, given } => {
            let message = words(
                "{open} joints leave the inverse open: at most {most} can be solved for",
                "逆解有 {open} 个关节待求：最多只能求 {most} 个",
            );
            let message = message.replace("{open}", &open.to_string()).replace("{most}", &MOST_OPEN_JOINTS.to_string());
            let help = match open + given - MOST_OPEN_JOINTS {
                1 => words(
                    "say which one the caller chooses, `redundant = q3;`, or `ik = none;`",
                    "用 `redundant = q3;` 指定由调用者给定的关节，或写 `ik = none;`",
                ),
                _ => words(
                    "say which {n} joints the caller chooses, `redundant = q1, q8;`, or `ik = none;`",
                    "用 `redundant = q1, q8;` 指定由调用者给定的 {n} 个关节，或写 `ik = none;`",
                ),
            };
            let help = help.replace("{n}", &(open + given - MOST_OPEN_JOINTS).to_string());
            vec![Remark { subject: Subject::Robot, message, help }]
        }
        Refusal::NotSpare { given, spare: 0 } => vec![Remark {
            subject: Subject::Redundant,
            message: words(
                "no joint is redundant: the arm needs all of them for its task, and {given} would be given",
                "没有冗余关节：任务需要全部关节，而指定了 {given} 个",
            )
            .replace("{given}", &given.to_string()),
            help: words("leave `redundant` out", "去掉 `redundant`"),
        }],
        Refusal::NotSpare { given, spare } => vec![Remark {
            subject: Subject::Redundant,
            message: words(
                "{given} joints would be given, and the arm can spare {spare} for its task",
                "指定了 {given} 个关节，而该任务只有 {spare} 个冗余",
            )
            .replace("{given}", &given.to_string())
            .replace("{spare}", &spare.to_string()),
            help: words("name fewer joints", "请少指定几个关节"),
        }],
        Refusal::Tilting(joints) => joints
            .iter()
            .map(|joint| Remark {
                subject: Subject::Joint(*joint),
                message: words(
                    "`{}` tilts the tool, and `task = planar` asks for x, y and the angle about z only",
                    "`{}` 使工具倾斜，而 `task = planar` 只涉及 x、y 和绕 z 轴的转角",
                )
                .replace("{}", name(*joint)),
                help: words(
                    "turning axes must be parallel to z of the base (`base = rx(90deg);` and the like turn the arm), or take another task",
                    "转动轴须平行于基座的 z 轴（可用 `base = rx(90deg);` 等转动整个机械臂），或改用其他任务",
                ),
            })
            .collect(),
        Refusal::Upright => vec![Remark {
            subject: Subject::Task,
            message: words(
                "`task = planar` asks for the angle of the tool's x axis about z, and this axis points along z",
                "`task = planar` 需要工具 x 轴绕 z 轴的转角，而该轴沿 z 方向",
            ),
            help: words(
                "turn the tool, `tool = ry(90deg);` for example, so that its x axis lies in the plane; or take another task",
                "转动工具，例如 `tool = ry(90deg);`，使其 x 轴位于平面内；或改用其他任务",
            ),
        }],
        Refusal::Stuck { solved, open } => {
            let found = match solved.as_slice() {
                [] => words("nothing", "无"),
                list => list.join(", "),
            };
            let message = words("no closed form was found for `{}` (found: {found})", "没有找到 `{}` 的封闭解（已求得：{found}）")
                .replace("{found}", &found);
            let one = |joint: &usize| Remark {
                subject: Subject::Joint(*joint),
                message: message.replace("{}", name(*joint)),
                help: no_inverse(),
            };
            open.iter().map(one).collect()
        }
        Refusal::Unconfirmed { missed, of } => vec![Remark {
            subject: Subject::Robot,
            message: words(
                "the plan for the inverse missed {missed} of {of} sample poses, so it is not used",
                "逆解方案在 {of} 个抽样位姿中有 {missed} 个未能求出，因此不予采用",
            )
            .replace("{missed}", &missed.to_string())
            .replace("{of}", &of.to_string()),
            help: no_inverse(),
        }],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::samples::{PLANAR, chain};

    #[test]
    fn reasons_stand_at_their_joints() {
        let planar = chain(PLANAR);
        let stuck = Refusal::Stuck { solved: vec!["q1".into()], open: vec![1, 2] };
        let list = remarks(&planar, &stuck, Language::English);
        assert_eq!(list.iter().map(|r| r.subject).collect::<Vec<_>>(), [Subject::Joint(1), Subject::Joint(2)]);
        assert_eq!(list[1].message, "no closed form was found for `q3` (found: q1)");
        let many = |open, given| remarks(&planar, &Refusal::TooManyJoints { open, given }, Language::English).remove(0);
        assert!(many(7, 0).help.contains("say which one"));
        // Two too many: no advice that leads to the next error.
        assert!(many(8, 0).help.contains("which 2 joints") && many(7, 1).help.contains("which 2 joints"));
    }
}
