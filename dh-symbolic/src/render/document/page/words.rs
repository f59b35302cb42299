//! What the interactive page says, in every language.

use crate::render::Language;

/// Key in the script (or in the page's template), English, Chinese.
const WORDS: &[(&str, &str, &str)] = &[
    ("title", "Kinematics of {}", "{} 的运动学"),
    (
        "hint",
        "Move the joints, turn the drawing with the mouse, click a solution.",
        "移动关节滑块，用鼠标旋转图形，点击一个解。",
    ),
    ("joints", "Joints", "关节变量"),
    ("degrees", "degrees", "度"),
    ("radians", "radians", "弧度"),
    ("reset", "reset", "复位"),
    ("parameters", "Parameters", "参数"),
    ("drawing", "The arm", "机械臂"),
    ("frames", "frames", "坐标系"),
    ("ghosts", "all solutions", "所有解"),
    ("pose", "Pose of the tip", "末端位姿"),
    ("jacobian", "Jacobian", "雅可比矩阵"),
    ("solutions", "Inverse kinematics", "逆运动学"),
    ("target", "Target", "目标"),
    ("roll", "roll", "横滚"),
    ("pitch", "pitch", "俯仰"),
    ("yaw", "yaw", "偏航"),
    ("phi", "angle", "角度"),
    ("found", "Solutions: {n}; within the joints' ranges: {m}.", "共 {n} 个解，其中 {m} 个在关节范围内。"),
    ("free", "{q} free", "{q} 任取"),
    ("red", "Red values are out of a joint's range.", "红色数值超出关节范围。"),
    ("shoulder", "shoulder", "肩"),
    ("elbow", "elbow", "肘"),
    ("wrist", "wrist", "腕"),
    ("left", "left", "左"),
    ("right", "right", "右"),
    ("up", "up", "上"),
    ("down", "down", "下"),
    ("no flip", "no flip", "不翻"),
    ("flip", "flip", "翻"),
    ("why none", "No solution was found.", "没有找到解。"),
    ("why finite", "A number of the target is missing.", "目标中缺少数值。"),
    ("why rotation", "The target is not a rotation.", "目标不是旋转矩阵。"),
    ("why root", "{step}: the equation has no real root.", "{step}：方程没有实根。"),
    ("why task", "The arm cannot take this pose: it misses by {by}.", "机械臂无法达到该位姿：误差 {by}。"),
    ("why verified", "The best candidate misses the target by {by}.", "最好的候选解与目标相差 {by}。"),
    (
        "why far",
        "{step}: {needs} {unit} is more than {has} {unit}, the most that the arm can do.",
        "{step}：{needs} {unit} 超过最大值 {has} {unit}。",
    ),
    (
        "why near",
        "{step}: {needs} {unit} is less than {has} {unit}, the least that the arm can do.",
        "{step}：{needs} {unit} 小于最小值 {has} {unit}。",
    ),
    (
        "closed",
        "All solutions in closed form, each verified by the forward kinematics.",
        "封闭形式的所有解，每个解都用正运动学验证。",
    ),
    (
        "numeric",
        "This arm needs the elimination of the general six-axis arm, which this page does not contain. The solutions are found by Newton's method from many starts: some may be missing.",
        "该机械臂需要一般六轴消元法，本页不包含。解由多个初值的牛顿法求得，可能不全。",
    ),
    (
        "unplanned",
        "No closed form was found for this arm. The solutions are found by Newton's method from many starts: some may be missing.",
        "没有找到该机械臂的封闭解。解由多个初值的牛顿法求得，可能不全。",
    ),
    ("given", "{q} keeps the value of its slider.", "{q} 取滑块的值。"),
    ("unwanted", "The table asks for no inverse (ik = none).", "该表不要求逆解（ik = none）。"),
    ("formulas", "Formulas", "公式"),
];

/// The words for a key; nothing for a key that does not exist.
pub(super) fn words(key: &str, language: Language) -> &'static str {
    let found = WORDS.iter().find(|w| w.0 == key);
    found.map_or("", |w| if language == Language::Chinese { w.2 } else { w.1 })
}

/// All words as an object of the script.
pub(super) fn object(language: Language) -> String {
    use crate::render::code::javascript::string;
    let entries: Vec<String> =
        WORDS.iter().map(|w| format!("{}: {}", string(w.0), string(words(w.0, language)))).collect();
    format!("const WORDS = {{ {} }};\n", entries.join(", "))
}
