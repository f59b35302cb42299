//! Tests of the document reader: spellings of formulas and what they are read as.

use super::DocumentClaims;
use crate::chain::samples::{PUMA, chain};
use crate::verify::language::{Statement, line_text};

/// Joints with an offset, a base and a tool.
const OFFSET: &str = "
pub struct Arm;
convention = standard;
let L_1: length; let l2: length;
base = tz(300mm); tool = tz(100mm);
| alpha  | a   | d | theta      |
|--------|-----|---|------------|
|  90deg | 0   | 0 | q1         |
|   0    | L_1 | 0 | q2 - 90deg |
|   0    | l2  | 0 | q3         |
";

/// The lines that a document is read as; what is not understood with its reason.
fn lines(table: &str, text: &str) -> Vec<String> {
    let paper = DocumentClaims::read(&chain(table), text);
    let d = &paper.derivation;
    d.lines
        .iter()
        .filter(|l| !matches!(l.statement, Statement::Remark(_)))
        .map(|l| match &l.statement {
            Statement::Unreadable(n) => format!("? {}: {}", d.text(&l.place), n.why),
            _ => line_text(&d.tokens[l.place.clone()]).0,
        })
        .collect()
}

#[test]
fn spellings() {
    let r11 = "T(0,6).r11 = c1*(c23*(c4*c5*c6 - s4*s6) - s23*s5*c6) + s1*(s4*c5*c6 + c4*s6)";
    for (text, line) in [
        (r"$$^0_6T r11 = c_1[c_{23}(c_4c_5c_6 - s_4s_6) - s_{23}s_5c_6] + s_1(s_4c_5c_6 + c_4s_6)$$", r11),
        (r"$$r_{11} = c_1\left[c_{23}(c_4c_5c_6 - s_4s_6) - s_{23}s_5c_6\right] + s_1(s_4c_5c_6 + c_4s_6)$$", r11),
        ("^0_6T r11 = c_1[c_{23}(c_4c_5c_6 - s_4s_6) - s_{23}s_5c_6] + s_1(s_4c_5c_6 + c_4s_6)", r11),
        ("r₁₁ = c₁[c₂₃(c₄c₅c₆ − s₄s₆) − s₂₃s₅c₆] + s₁(s₄c₅c₆ + c₄s₆)", r11),
        ("T(0,6).r11 = c1 [c23 (c4c5c6 - s4s6) - s23 s5 c6] + s1 (s4c5c6 + c4s6)", r11),
        (r"\[ {}^{1}p_x = a_2\cos\theta_2 \]", "T(1,6).px = a2*cos(q2)"),
        (r"\[ p_x = a_2\cos(\theta_2+\theta_3) - \sin\theta_5 \]", "T(0,6).px = a2*cos(q2 + q3) - sin(q5)"),
        (r"\[ p_x = \cos[t_2 + t_3] + \cos[t1] \]", "T(0,6).px = cos(q2 + q3) + cos(q1)"),
        (r"\( p_y = c\theta_1 s\alpha_2 \)", "T(0,6).py = cos(q1)*sin(alpha2)"),
        (r"$c_{2-3}^2 = \cos^2(\theta_2 - \theta_3)$", "cos(q2 - q3)^2 = cos(q2 - q3)^2"),
        ("cos(θ₂ + θ₃)² = c₂₃²", "cos(q2 + q3)^2 = c23^2"),
        (r"$T_6^0 = T_1^0 T_6^1$", "T(0,6) = T(0,1)*T(1,6)"),
        (r"$T_{06} = A_1 T_{1,6}$", "T(0,6) = T(0,1)*T(1,6)"),
        ("0T6 = 0T1 1T6", "T(0,6) = T(0,1)*T(1,6)"),
        ("⁰T₆ = ⁰T₁ ¹T₆", "T(0,6) = T(0,1)*T(1,6)"),
        ("¹T₆ = ⁰T₁⁻¹·⁰T₆", "T(1,6) = T(0,1)^-1*T(0,6)"),
        (r"${}^0_3R^T = {}^0_3R^{-1}$", "T(0,3).R.t = T(0,3).R^-1"),
        (r"${}^0P_{4\text{ ORG}} = {}^0P_6$", "T(0,4).p = T(0,6).p"),
        (r"$p^2 = p_x^2 + p_y^2 + p_z^2$", "norm2(T(0,6).p) = T(0,6).px^2 + T(0,6).py^2 + T(0,6).pz^2"),
        (r"$\frac{a_2}{2} = \dfrac{a_2 + a_2}{4}$", "(a2)/(2) = (a2 + a2)/(4)"),
        ("√(a₂² + (a₃ − d₃)²) = a₂/2", "sqrt(a2^2 + (a3 - d3)^2) = a2/2"),
        (r"$J_1 = J_{21} + J$", "J(1) = J(2,1) + J"),
        ("q1 = atan2(py, px) - atan2(d3, 1)", "q1 = atan2(T(0,6).py, T(0,6).px) - atan2(d3, 1)"),
        (r"$\theta_1 = \alpha_2 \pm \alpha_1$", "cos(q1 - (alpha2)) = cos(alpha1)"),
        (r"$\theta_1 = \operatorname{atan2}(\pm\sqrt{a_2}, a_3)$", "cos(q1) = cos(atan2(sqrt(a2), a3))"),
        ("[p_x; p_y] = [a2, a3]", "[T(0,6).px; T(0,6).py] = [a2, a3]"),
        (r"$\det\,\begin{bmatrix} a_2 & 0 \\ 0 & a_3 \end{bmatrix} = a_2a_3$", "det([a2, 0; 0, a3]) = a2*a3"),
        ("det [a2, 0; 0, a3] = a2 a3", "det([a2, 0; 0, a3]) = a2*a3"),
        (r"$|a_2 - a_3| = \left|a_2\right|$", "sqrt((a2 - a3)^2) = sqrt((a2)^2)"),
        ("p_x ≠ 0", "T(0,6).px != 0"),
    ] {
        assert_eq!(lines(PUMA, text), [line], "{text}");
    }
}

/// Spellings that are met in print and on the web.
#[test]
fn spellings_of_others() {
    let branch = "q1 = atan2(T(0,6).py, T(0,6).px) - atan2(d3, a2)";
    for (text, line) in [
        (r"$$\theta_1 = atan2(p_y, p_x) - Atan2(d_3, a_2)$$", branch),
        (r"$$\theta_1 = \text{Atan2}(p_y, p_x) - {\rm atan2}(d_3, a_2)$$", branch),
        (r"$$\theta_1 = \arctan2(p_y, p_x) - \operatorname{ATAN2}\left[d_3, a_2\right]$$", branch),
        (r"$$p_x = S_{23} + C_1$$", "T(0,6).px = s23 + c1"),
        (r"$$p_x = \sin\theta_{23} + cos(\theta_1)$$", "T(0,6).px = sin((q2 + q3)) + cos(q1)"),
        (r"$$\theta_1 = \tan^{-1}\frac{a_2}{a_3}$$", "q1 = atan((a2)/(a3))"),
        (r"$$\theta_1 = \arccos\frac{a_2}{a_3}$$", "q1 = acos((a2)/(a3))"),
        (r"$${}^0_1T(\theta_1) = {}^0_1T$$", "T(0,1) = T(0,1)"),
        (r"$$[{}^0_1T(\theta_1)]^{-1} = [{}^0_2T(\theta_1,\theta_2)]^{-1}$$", "(T(0,1))^-1 = (T(0,2))^-1"),
        (r"$$_{1}T^{2} = {}^1_2T$$", "T(1,2) = T(1,2)"),
        (r"$$_3\mathbf{R}^6 = {}^3_6R$$", "T(3,6).R = T(3,6).R"),
        (r"$${}^0_6T = {}^0_1T\,{}^1_2T\cdots{}^5_6T$$", "T(0,6) = T(0,1)*T(1,2)*T(2,5)*T(5,6)"),
        (r"$$\frac{\partial p_x}{\partial\theta_2} = a_2$$", "diff(T(0,6).px, q2) = a2"),
        (r"$$\theta_1 = \alpha_2 \pm \alpha_1 - \alpha_3$$", "cos(q1 - (alpha2 - alpha3)) = cos(alpha1)"),
        (r"$$a_2\sin\theta_1 = \pm\sqrt{a_2} \mp d_3$$", "a2*sin(q1) = ± sqrt(a2) ∓ d3"),
        (r"$$\left\{\begin{array}{l} p_x = a_2 \end{array}\right.$$", "T(0,6).px = a2"),
        ("```math\np_x = a_2\n```", "T(0,6).px = a2"),
        ("so $`p_x = a_2`$ holds", "T(0,6).px = a2"),
        (
            r"$$\theta_1 = \begin{cases} \alpha_1 & \theta_2 < 0 \\ \alpha_2 & \text{otherwise} \end{cases}$$",
            "q1 = alpha1 if q2 < 0 or q1 = alpha2",
        ),
        (r"\newcommand{\pos}[1]{p_{#1}} $$\pos{x} = a_2$$", "T(0,6).px = a2"),
        (r"\def\s{\sin\theta} $$p_x = \s_1$$", "T(0,6).px = sin(q1)"),
    ] {
        assert_eq!(lines(PUMA, text), [line], "{text}");
    }
}

/// Names of another arm, conventions of the last frame and values without a pose are no claims, and are listed.
#[test]
fn what_claims_nothing_is_listed() {
    for text in [r"$$a_n = 0$$", r"$$a_7 = 0.3$$", r"$${}^0_9T = {}^0_8T$$", r"$$p_x = 0.43$$", r"$$\theta_1 = 75.5$$"]
    {
        let paper = DocumentClaims::read(&chain(PUMA), text);
        let remarks = paper.derivation.lines.iter().filter(|l| matches!(l.statement, Statement::Remark(_))).count();
        assert_eq!((remarks, paper.derivation.lines.len()), (1, 1), "{text}");
    }
}

#[test]
fn offsets_bases_and_tools() {
    for (text, line) in [
        (r"$p_x = L_1 c_2$", "(base*T(0,3)*tool).px = L_1*c2"),
        (r"${}^b_eT = {}^b_0T\,{}^0_3T\,{}^3_eT$", "(base*T(0,3)*tool) = base*T(0,3)*tool"),
        ("p_x = L1 cos(θ2) + L2", "(base*T(0,3)*tool).px = L_1*cos(theta2) + l2"),
        (r"$c_i = \cos\theta_i$ $${}^0_2T_{} r_{11} = c_1 c_2$$", "T(0,2).r11 = c1*cos(theta2)"),
        (r"$c_i = \cos q_i$ $${}^0_2T r_{11} = c_1 c_2$$", "T(0,2).r11 = c1*c2"),
    ] {
        assert_eq!(lines(OFFSET, text), [line], "{text}");
    }
}

#[test]
fn names_values_and_order() {
    let text = r"
\begin{align}
  a_3c_3 - d_4s_3 &= K \\
  K &= \frac{p^2 - a_2^2}{2a_2} \\
    &\quad - a_3
\end{align}
With $U = {}^0_1T^{-1}\,{}^0_6T$ we have $u_x = u_{11}$, and $u$ is its position.
For $\theta_1 = 20^\circ$, $a_3 = 0.5$ it is $p_x = 0.25$.
$$ {}^1_6T = \begin{bmatrix} {}^1r_{11} & {}^1r_{12} & {}^1r_{13} & {}^1p_x \\ {}^1r_{21} & {}^1r_{22} & {}^1r_{23} & {}^1p_y \\
 {}^1r_{31} & {}^1r_{32} & {}^1r_{33} & {}^1p_z \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
$$ {}^1p_z = k $$";
    let expected = [
        "let K = (norm2(T(0,6).p) - a2^2)/(2*a2) - a3",
        "a3*c3 - d4*s3 = K",
        "let U = T(0,1)^-1*T(0,6)",
        "U.px = U.r11",
        "at q1 = 20deg",
        "at q1 = 20deg, a3 = 0.5",
        "T(0,6).px ~ 0.25",
        "let k = T(1,6).pz",
    ];
    assert_eq!(lines(PUMA, text), expected);
}

#[test]
fn prose_is_skipped_and_counted() {
    let text = "The arm = six links.\n\nWe set x = 3 here, and then p_x = a2 c2 follows.\nNothing else.\n\np_y = a2 s2\n   + d3 c1\n";
    let paper = DocumentClaims::read(&chain(PUMA), text);
    let d = &paper.derivation;
    let places: Vec<(usize, String)> = d.lines.iter().map(|l| (paper.line(&l.place), d.text(&l.place))).collect();
    assert_eq!(places, [(6, "T(0,6).py = a2*s2 + d3*c1".to_string())]);
    assert_eq!(paper.prose, 3);
    assert_eq!(DocumentClaims::read(&chain(PUMA), "").prose, 0);
}

/// Whatever stands in a document, reading it ends and does not panic.
#[test]
fn anything_can_be_read() {
    let pieces = [
        "$",
        "$$",
        "\\[",
        "{",
        "}",
        "^",
        "_",
        "\\begin{bmatrix}",
        "\\end{bmatrix}",
        "&",
        "\\\\",
        "\\frac",
        "=",
        "c_1",
        "⎡",
        "⎣",
        "⎤",
        "\n",
        "(",
        "]",
        ",",
        "±",
        "²",
        "√",
        "T",
        "r_{11}",
        "\\left",
        "%",
        "\\text{",
        "'",
        "0",
        ".",
        "θ",
        "°",
        "~",
        "|",
        "\\sqrt",
        "\\cos",
        "\\",
    ];
    let chain = chain(PUMA);
    let mut seed = 12345u64;
    for _ in 0..3000 {
        let mut text = String::new();
        for _ in 0..14 {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            text.push_str(pieces[(seed >> 33) as usize % pieces.len()]);
        }
        DocumentClaims::read(&chain, &text);
    }
    DocumentClaims::read(&chain, "- [ ] todo\n- [x] done\nx = [ ]");
    for deep in ["\\sqrt", "\\sqrt{", "(", "√(", "\\left\\{", "_{", "\\frac", "[", "x^"] {
        DocumentClaims::read(&chain, &format!("$$p_x = {}$$", deep.repeat(6_000)));
        DocumentClaims::read(&chain, &format!("p_x = {}", deep.repeat(6_000)));
    }
    DocumentClaims::read(&chain, &"{".repeat(100_000));
    DocumentClaims::read(&chain, &format!("$${}$$", "\\sqrt{".repeat(2000)));
    DocumentClaims::read(&chain, &format!("$$p_x = {}$$", "(".repeat(2000)));
}
