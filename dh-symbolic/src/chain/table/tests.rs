//! Tests of whole tables: what they mean, and the errors of wrong ones with their places.

use super::*;
use crate::algebra::Rational;
use crate::chain::*;
use crate::diagnostic::lex;

/// The PUMA's table with everything that may stand around it.
fn puma() -> String {
    let claims = "
        T(1,3) = [c23, -s23, 0, a2*c2; 0, 0, 1, d3; -s23, -c23, 0, -a2*s2; 0, 0, 0, 1];
        T(0,6).px = c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1;
    ";
    format!("/// Unimation PUMA 560, frames after Craig.\n{}\nprove {{{claims}}}\n", crate::chain::samples::PUMA)
}

fn read(source: &str) -> Parsed {
    parse(lex(source).unwrap_or_else(|e| panic!("{}", e.draw(source, "-"))))
}

/// Lines before a table with the columns alpha, a, d, theta, range, and its rows.
fn table(lines: &str, rows: &str) -> String {
    format!("struct R;\nconvention = standard;\n{lines}\n| alpha | a | d | theta | range |\n{rows}")
}

fn spec(lines: &str, rows: &str) -> ChainSpec {
    let source = table(lines, rows);
    let parsed = read(&source);
    parsed.spec.unwrap_or_else(|| panic!("{}", parsed.errors.draw(&source, "-")))
}

/// "underlined text: message (second place) [help]" for each error, in order.
fn errors(source: &str) -> Vec<String> {
    let parsed = read(source);
    assert_eq!(parsed.errors.is_empty(), parsed.spec.is_some(), "either a robot or errors");
    let offset = |(line, column): (usize, usize)| {
        source.split_inclusive('\n').take(line.saturating_sub(1)).map(|l| l.chars().count()).sum::<usize>() + column
    };
    let list = parsed.errors.in_order().into_iter().map(|e| {
        let (start, end) = (offset(e.place.start()), offset(e.place.end()));
        let text = source.chars().skip(start).take(end - start).collect::<String>();
        let help = e.help.as_ref().map_or(String::new(), |h| format!(" [{h}]"));
        let related = e.related.as_ref().map_or(String::new(), |(p, what)| format!(" ({what}, line {})", p.line()));
        format!("{text}: {}{related}{help}", e.message)
    });
    list.collect()
}

#[track_caller]
fn wrong(lines: &str, rows: &str, want: &[&str]) {
    assert_eq!(errors(&table(lines, rows)), want);
}

fn half_turns(n: i64, d: i64) -> AngleCell {
    AngleCell { half_turns: Rational::new(n, d).filter(|x| !x.is_zero()), ..AngleCell::default() }
}

fn ratio(n: i64, d: i64) -> Rational {
    Rational::new(n, d).expect("a denominator")
}

fn number(n: i64, d: i64) -> LengthCell {
    LengthCell::number(ratio(n, d))
}

#[test]
fn the_puma_of_the_contract() {
    let text = puma();
    let parsed = read(&text);
    let spec = parsed.spec.unwrap_or_else(|| panic!("{}", parsed.errors.draw(&text, "-")));
    assert_eq!((spec.name.as_str(), spec.rows.len(), parsed.claims.len()), ("Puma560", 6, 2));
    assert_eq!(parsed.head.docs, [" Unimation PUMA 560, frames after Craig."]);
    assert_eq!(spec.rows[1].alpha, half_turns(-1, 2));
    assert_eq!(spec.rows[3].a.terms, [(Rational::ONE, vec![1])]);
    assert_eq!(spec.rows[0].range, Some((Bound::HalfTurns(ratio(-8, 9)), Bound::HalfTurns(ratio(8, 9)))));
    assert_eq!(spec.parameters[0].role, Role::Field(Some(Nominal::Length(ratio(2159, 5000)))));
    assert_eq!(parsed.sketch.table[2], ["2", "-90deg", "0", "0", "q2", "-225deg..=45deg"]);
    assert_eq!((parsed.origins.cell(3, Column::A).start(), parsed.origins.joint(5).start()), ((14, 19), (16, 29)));
}

#[test]
fn line_breaks_and_order_mean_nothing() {
    let text = puma();
    let one_line = text.replace("/// Unimation PUMA 560, frames after Craig.", "").replace('\n', " ");
    let moved = "prove { } tool = tz(1); | theta | d | a | alpha | | q1 | 1mm | 2 | 30deg | let x: length; \
                 struct_is_first = 1;";
    let (a, b) = (read(&text).spec.expect("fine"), read(&one_line).spec.expect("fine too"));
    assert_eq!(format!("{a:?}"), format!("{b:?}"));
    assert_eq!(errors(&format!("struct R; convention = standard; {moved}")).len(), 1);
    let spec = spec("", "| 30deg | 2 | 1mm | q1 | - |");
    let row = read("struct R; convention = standard; | theta | d | a | alpha | | q1 | 1mm | 2 | 30deg |");
    assert_eq!(format!("{:?}", spec.rows), format!("{:?}", row.spec.expect("fine").rows));
}

#[test]
fn angles_are_exact() {
    let list = [
        ("0", 0, 1),
        ("90deg", 1, 2),
        ("pi/2", 1, 2),
        ("-3*pi/4", -3, 4),
        ("0.25turn", 1, 2),
        ("-pi", -1, 1),
        ("2pi/3", 2, 3),
        ("101.25deg", 9, 16),
        ("-79.34995deg", -1_586_999, 3_600_000),
        ("-(90deg - 30deg)", -1, 3),
        ("90deg - pi/2", 0, 1),
        ("--w/2", 1, 8),
        ("0rad", 0, 1),
        ("90deg*(2/3)", 1, 3),
        ("k*90deg", 3, 2),
    ];
    for (text, n, d) in list {
        let spec = spec("let w = 45deg; let k = 3;", &format!("| {text} | 0 | 0 | q1 + {text} | - |"));
        assert_eq!((&spec.rows[0].alpha, &spec.rows[0].theta), (&half_turns(n, d), &half_turns(n, d)), "{text}");
    }
    let spec =
        spec("let beta: angle; let gamma: angle = 30deg;", "| beta - 2*gamma + approx -1.2rad | 0 | 0 | q1 | - |");
    let alpha = &spec.rows[0].alpha;
    assert_eq!((alpha.approx.clone(), alpha.symbols.clone()), (Some(ratio(-6, 5)), vec![(0, 1), (1, -2)]));
    assert_eq!(spec.parameters[1].role, Role::Field(Some(Nominal::Angle(half_turns(1, 6)))));
}

#[test]
fn lengths_are_exact_in_the_unit_of_the_table() {
    let list = [
        ("0", "m", 0, 1),
        ("0.4318m", "m", 2159, 5000),
        ("431.8mm", "m", 2159, 5000),
        ("-30.0", "mm", -30, 1),
        ("1in", "mm", 127, 5),
        ("1ft", "in", 12, 1),
        ("1m", "ft", 1250, 381),
        ("2*(3cm - 10mm)/4", "cm", 1, 1),
        ("50mm - 5cm", "m", 0, 1),
        ("1e-05", "m", 1, 100_000),
        ("z", "m", 0, 1),
        ("l1 - l2", "mm", 0, 1),
    ];
    for (text, unit, n, d) in list {
        let lines = format!("unit = {unit}; let z = 0; let l1 = 20mm; let l2 = 2cm;");
        let spec = spec(&lines, &format!("| 0 | {text} | {text} | q1 | - |"));
        assert_eq!((&spec.rows[0].a, &spec.rows[0].d), (&number(n, d), &number(n, d)), "{text} in {unit}");
    }
    let spec = spec("let a2: length; let k: number; let z = 0;", "| 0 | -a2/2 + 10mm + 3*k*a2 + z | k*5 | q1 | - |");
    assert_eq!(spec.rows[0].a.terms, [(ratio(-1, 2), vec![0]), (ratio(1, 100), vec![]), (ratio(3, 1), vec![0, 1])]);
    assert_eq!(spec.rows[0].d.terms, [(ratio(5, 1), vec![1])]);
}

#[test]
fn names_and_their_roles() {
    let lines =
        "let a2: length; let b: angle = pi/3; let k: number = 2; let l = 3cm; let m2 = 2*l; let w = -90deg; let n = 7;";
    let spec = spec(lines, "| w | m2 | 0 | q1 | - |");
    let roles: Vec<_> = spec.parameters.into_iter().map(|p| (p.name, p.quantity, p.role)).collect();
    let (length, angle) = (Quantity::Length, Quantity::Angle);
    let want = [
        ("a2", length, Role::Field(None)),
        ("b", angle, Role::Field(Some(Nominal::Angle(half_turns(1, 3))))),
        ("k", length, Role::Field(Some(Nominal::Length(ratio(2, 1))))),
        ("l", length, Role::Constant(Nominal::Length(ratio(3, 100)))),
        ("m2", length, Role::Constant(Nominal::Length(ratio(3, 50)))),
        ("w", angle, Role::Constant(Nominal::Angle(half_turns(-1, 2)))),
        ("n", length, Role::Constant(Nominal::Length(ratio(7, 1)))),
    ];
    assert_eq!(roles, want.map(|(n, q, r)| (n.to_string(), q, r)));
    assert_eq!(
        (spec.rows[0].alpha.clone(), spec.rows[0].a.terms.clone()),
        (half_turns(-1, 2), vec![(Rational::ONE, vec![4])])
    );
}

#[test]
fn joints_slide_turn_and_stand() {
    let rows = "| 0 | 0 | 0 | -90deg + q1 | - | | 0 | 0 | 1 | 0 | - | | 0 | 0 | q2 + 0.05 | 30deg | 0.1..=20cm |";
    let spec = spec("", rows);
    let drive = |i: usize| spec.rows[i].moves.as_ref().map(|d| (d.revolute, d.terms.clone()));
    let one = number(1, 1);
    assert_eq!(drive(0), Some((true, vec![(0, one.clone())])));
    assert_eq!(drive(1).is_none(), spec.rows[1].range.is_none());
    assert_eq!(drive(2), Some((false, vec![(1, one)])));
    assert_eq!((&spec.rows[2].d, &spec.rows[2].theta), (&number(1, 20), &half_turns(1, 6)));
    assert_eq!(spec.rows[2].range, Some((Bound::Length(ratio(1, 10)), Bound::Length(ratio(1, 5)))));
}

#[test]
fn coupled_drives() {
    let drives = |lines: &str, rows: &str| -> Vec<Vec<(usize, LengthCell)>> {
        spec(lines, rows).rows.into_iter().filter_map(|r| r.moves).map(|d| d.terms).collect()
    };
    let (one, minus) = (number(1, 1), number(-1, 1));
    // The parallelogram arm and the leg-wheel robot.
    let parallel = drives("", "| 0 | 0 | 0 | q1 | - | | 0 | 1 | 0 | q2 | - | | 0 | 1 | 0 | q3 - q2 | -90deg..=90deg |");
    assert_eq!(parallel[2], [(1, minus), (2, one.clone())]);
    let leg = drives("let p: length;", "| 0 | 0 | 0 | q1 | - | | 90deg | 0 | p*(q2 - q1) | 0 | 0..=360deg |");
    let p = |sign: i64| LengthCell { terms: vec![(Rational::int(sign), vec![0])] };
    assert_eq!(leg, [vec![(0, one.clone())], vec![(0, p(-1)), (1, p(1))]]);
    // Scaled and reversed drives; constants are put in place.
    let gear =
        drives("let g = 1/50; let one = 1;", "| 0 | 0 | 0 | -q2 | - | | 0 | 1 | 0 | g*q1 + one*q2 - 15deg | - |");
    assert_eq!(gear, [vec![(1, number(-1, 1))], vec![(0, number(1, 50)), (1, one)]]);
    assert_eq!(drives("", "| 0 | 0 | (q1 + 3*q1)/4 | 0 | - |"), [vec![(0, number(1, 1))]]);
}

#[test]
fn settings_and_motions() {
    let lines = "unit = mm; scalar = f32; task = position; redundant = q2; ik = none;\n\
                 let l: length; base = tz(373); tool = tx(-l) * rz(pi/2 - 30deg);";
    let rows = "| 0 | 1 | 0 | q1 | - |".repeat(4).replacen("q1", "q2", 2).replacen("q2", "q1", 1);
    let rows = rows.replacen(
        "- || 0 | 1 | 0 | q1 | - || 0 | 1 | 0 | q1 | - |",
        "- || 0 | 1 | 0 | q3 | - || 0 | 1 | 0 | q4 | - |",
        1,
    );
    let spec = spec(lines, &rows);
    assert_eq!(
        (
            spec.settings.unit.name,
            spec.settings.scalar,
            spec.settings.task,
            spec.settings.redundant.clone(),
            spec.settings.ik
        ),
        ("mm", Scalar::F32, Task::Position, vec![1], false)
    );
    assert!(matches!(spec.base.as_slice(), [MotionSpec::Translate(2, x)] if *x == number(373, 1)));
    assert!(
        matches!(spec.tool.as_slice(), [MotionSpec::Translate(0, _), MotionSpec::Rotate(2, x)] if *x == half_turns(1, 3))
    );
}

#[test]
fn wrong_cells() {
    wrong(
        "",
        "| 90 | 431.8deg | 0.4f32 | q1 | - |\n| 0 | .5m | 1 m | q2 - 90degrees | - |\n| 1mm | 1.m | 2 3 | q3 + sin(1) | - |",
        &[
            "90: column `alpha` holds an angle (`90deg`, `pi/2`), but `90` has no unit [write `90deg`]",
            "431.8deg: column `a` holds a length, but `431.8deg` is an angle [write a length: `0.4318m`, `431.8mm`]",
            "0.4f32: unknown unit `f32`; lengths: m, cm, mm, in, ft; angles: deg, rad, turn \
             [`f32` is a type of Rust; numbers here are exact]",
            ".5m: a number starts with a digit [write `0.5m`]",
            "1 m: no space stands between a number and its unit [write `1m`]",
            "90degrees: unknown unit `degrees`; lengths: m, cm, mm, in, ft; angles: deg, rad, turn [did you mean `90deg`?]",
            "1mm: column `alpha` holds an angle, but `1mm` is a length [write an angle: `90deg`, `pi/2`]",
            "1.m: a number does not end with its point [write `1m` or `1.0m`]",
            "3: an operator is missing before this [a product is written with `*`]",
            "sin(1): `sin` takes an angle: `30deg`, `pi/6`",
        ],
    );
    wrong(
        "let l: length; let b: angle;",
        "| b/2 | l*l | 1/l | q1 | - |\n| b*l | 1/0 | 1mm*2mm | q2*q2 | - |\n| pi*pi | 2^3 | l + | q3*pi | - |",
        &[
            "b: a declared angle takes whole factors from -4 to 4 [declare the part that you need as an angle of its own, besides `b`]",
            "l: a product of two lengths is no length [a coefficient is declared as `let k: number;`]",
            "l: only plain numbers divide [write a factor instead: `0.5*a2`]",
            "b: an angle takes plain numbers as factors, no fields and no lengths",
            "0: division by zero",
            "1mm: a product of two lengths is no length [a coefficient is declared as `let k: number;`]",
            "q2*q2: a product of joint variables: a motor drives its joints linearly",
            "pi*pi: the product of two angles is no angle",
            "^: there are no powers here [write a product]",
            "l +: a number or a name is missing here",
            "q3: the coefficient of a joint variable is a number, no angle",
        ],
    );
}

#[test]
fn more_wrong_cells() {
    wrong(
        "let b: angle;",
        "| 5*b | 0 | 0 | q1 | - |\n| tilt | len | 0 | 2mm*q2 | - |\n| 2b | 0x1F | 0 | q3 | - |",
        &[
            "b: a declared angle takes whole factors from -4 to 4 \
             [declare the part that you need as an angle of its own, besides `b`]",
            "tilt: unknown name `tilt` [declare it: `let tilt: angle;`]",
            "len: unknown name `len` [declare it: `let len: length;`]",
            "q2: the coefficient of a turning joint is a number, no length",
            "2b: unknown unit `b`; lengths: m, cm, mm, in, ft; angles: deg, rad, turn [a product is written with `*`: `2*b`]",
            "0x1F: numbers are decimal here",
        ],
    );
    let tool = format!("tool = {};", vec!["tx(1)"; 17].join("*"));
    assert!(errors(&table(&tool, "| 0 | 0 | 0 | q1 | - |"))[0].contains("a product of more than 16 motions"));
}

#[test]
fn radians_say_that_they_are_approximate() {
    let message = |cell: &str| errors(&table("", &format!("| {cell} | 0 | 0 | q1 | - |"))).pop().unwrap_or_default();
    assert_eq!(message("1.5708rad"), "1.5708rad: radians are never exact [write `90deg` or `pi/2`]");
    assert_eq!(message("-2.36rad"), "2.36rad: radians are never exact [write `135deg` or `3*pi/4`]");
    assert_eq!(
        message("1.2rad"),
        "1.2rad: radians are never exact: say `approx 1.2rad` [or write the angle in degrees]"
    );
    assert_eq!(
        message("approx -1.5707963267948966rad"),
        "approx -1.5707963267948966rad: this looks like an exact angle, written as a rounded number \
         [write `-90deg` or `-pi/2`, or give more digits if it is another angle]"
    );
    for fine in ["approx 1.2rad", "approx -1.3849179rad", "approx 1.570320019rad", "approx 0.001rad", "-approx 1.3rad"]
    {
        assert_eq!(message(fine), "", "{fine}");
    }
    assert_eq!(
        message("approx 90deg"),
        "90deg: `approx` is for radians; all other numbers are exact [leave `approx` out]"
    );
    assert!(
        message("approx 0.524rad").contains("`30deg` or `pi/6`") && message("approx 1e-15rad").contains("write `0`")
    );
}

#[test]
fn wrong_rows() {
    let columns = "alpha, a, d, theta, range";
    wrong(
        "",
        "| 0 | 0 | 0 | q1 |\n",
        &[&format!("| 0 | 0 | 0 | q1 |: this row has 4 cells, the header has 5: {columns}")],
    );
    wrong(
        "",
        "| 0 | 0 | 0 | q1 | - | 7 |\n| 0 | 0 | 0 | q2 | - |\n",
        &[&format!("| 0 | 0 | 0 | q1 | - | 7 |: this row has 6 cells, the header has 5: {columns}")],
    );
    wrong(
        "",
        "| 0 |  | 0 | q1 | - |\n| 0 | 0 | 0 | q2 | |\n| | 0 | 0 | q3 | - |\n| 0 | 0 | 0 | q4 | - | |",
        &[
            "|  |: an empty cell [write `0`, or `-` where a range is not known]",
            "| |: an empty cell [write `0`, or `-` where a range is not known]",
            "| |: an empty cell [write `0`, or `-` where a range is not known]",
            "| |: an empty cell too many at the end of this row",
        ],
    );
    wrong(
        "",
        "| 0 | 0 | 0 | q1 | -\n| 0 | 0 | 0 | q2 | -\n",
        &["-: the closing bar `|` of this row is missing", "-: the closing bar `|` is missing after this"],
    );
    wrong(
        "",
        "| 0 | 0 | 0 | q1 | - | |\n| 0 | 0 | 0 | q2 | - |\n|\n| 0 | 0 | 0 | q3\n| 0 | 0 | 0 | q4 | - |",
        &[
            "| |: an empty cell too many at the end of this row",
            "|\n|: a row without cells",
            &format!(
                "| 0 | 0 | 0 | q3\n| 0 | 0 | 0 | q4 | - |: this row has 9 cells, the header has 5: {columns} \
                 (is the closing bar missing after this cell?, line 8)"
            ),
        ],
    );
    wrong("", "", &["| alpha | a | d | theta | range |: the table has no rows"]);
    wrong("", "|---|---|\n| 0 | 0 | 0 | q1 | - |", &["|---|---|: this rule line has 2 cells, the header has 5"]);
    assert_eq!(errors(&table("", &"| 0 | 1 | 0 | 0 | - |\n".repeat(17))).len(), 2, "too many rows, and nothing moves");
    let many: String = (1..=13).map(|i| format!("| 0 | 1 | 0 | q{i} | - |\n")).collect();
    wrong("", &many, &["q13: a robot has at most 12 joints"]);
}

#[test]
fn wrong_headers() {
    let header = |text: &str| errors(&format!("struct R; convention = standard;\n{text}\n| 0 | 0 | 0 | q1 |"));
    assert_eq!(header("| alpha | a | d | tehta |"), ["tehta: unknown column `tehta` [did you mean `theta`?]"]);
    assert!(header("| α | A | D | θ |").is_empty());
    assert_eq!(
        header("| alpha(i-1) | a(i-1) | d | theta |"),
        ["alpha(i-1): a header with the index i-1 belongs to the modified convention, and the table says `standard` \
          [write `convention = modified;`, or the column without index]"]
    );
    assert_eq!(
        header("| alpha | a [deg] | d | theta |"),
        ["a [deg]: unknown column `a[deg]` [columns: joint, alpha, a, d, theta, range]"]
    );
    assert_eq!(header("| alpha | d | d | theta |"), ["d: column `d` appears twice (first here, line 2)"]);
    assert_eq!(header("| joint | a | d | theta |"), ["| joint | a | d | theta |: column `alpha` is missing"]);
    assert_eq!(
        header("| alpha | a | d | theta\n|-|-|-|-|"),
        ["| alpha | a | d | theta\n|: the closing bar `|` of the header is missing"]
    );
    assert_eq!(header("| alpha |  | d | theta |")[0], "|  |: this column has no name");
    let none = "the header is missing: the first row names the columns [`| joint | alpha | a | d | theta | range |`, in any order]";
    assert_eq!(header(""), [format!("| 0 | 0 | 0 | q1 |: {none}")]);
}

#[test]
fn tables_as_people_publish_them() {
    let source = r"struct R; convention = modified; unit = mm;
        | Link | $\alpha_{i-1}$ (deg) | a_{i-1} [m] | $\theta_i$ | d_i |
        | 1 | 0 | 0 | q1 | 243.3 |
        | 2 | 90 | 0.28 | π/2 + θ2 | 30 |
        | 3 | -90° | 0 | θ_3 − 90° | 20 |";
    let parsed = read(source);
    let spec = parsed.spec.unwrap_or_else(|| panic!("{}", parsed.errors.draw(source, "-")));
    assert_eq!((spec.rows[1].alpha.clone(), spec.rows[2].alpha.clone()), (half_turns(1, 2), half_turns(-1, 2)));
    assert_eq!((spec.rows[1].a.clone(), spec.rows[1].d.clone()), (number(280, 1), number(30, 1)));
    assert_eq!((spec.rows[1].theta.clone(), spec.rows[2].theta.clone()), (half_turns(1, 2), half_turns(-1, 2)));
    assert!(spec.rows.iter().all(|r| r.moves.as_ref().is_some_and(|m| m.revolute)));
}

#[test]
fn functions_of_constants() {
    let spec = spec(
        "let w = 3; let h = 4mm;",
        "| atan2(3, 3) | sqrt(w*w + 16) | sqrt(9mm*h/4) | q1 + atan(49.75/250) | - |
         | acos(1/2) | 2*cos(60deg) | 0.3*sin(pi/3) | q2 | -2.41rad..=3.141593rad |
         | atan2(h, 3mm) | tan(45deg) | 0 | q3 | - |",
    );
    let rows = &spec.rows;
    assert_eq!((rows[0].alpha.clone(), rows[1].alpha.clone()), (half_turns(1, 4), half_turns(1, 3)));
    assert_eq!((rows[0].a.clone(), rows[0].d.clone()), (number(5, 1), number(3, 1000)));
    assert_eq!((rows[1].a.clone(), rows[2].a.clone()), (number(1, 1), number(1, 1)));
    assert!((rows[0].theta.radians() - (49.75f64 / 250.0).atan()).abs() < 1e-15);
    assert!((rows[2].alpha.radians() - 4f64.atan2(3.0)).abs() < 1e-15);
    let d: f64 = rows[1].d.terms[0].0.to_f64();
    assert!((d - 0.3 * 0.75f64.sqrt()).abs() < 1e-15);
    assert_eq!(rows[1].range, Some((Bound::Radians(ratio(-241, 100)), Bound::Radians(ratio(3_141_593, 1_000_000)))));
    let wrong = |lines: &str, cell: &str| errors(&table(lines, &format!("| 0 | {cell} | 0 | q1 | - |"))).join("\n");
    assert!(wrong("", "sqrt(-2)").contains("takes a number that is not negative"));
    assert!(wrong("", "sin(0.5)").contains("takes an angle"));
    assert!(wrong("let a2: length;", "sqrt(a2*a2)").contains("a function takes constants only"));
    assert!(wrong("", "sqrt(1, 2)").contains("`sqrt` takes"));
    assert!(wrong("", "log(2)").contains("of functions there are sqrt"));
    assert!(wrong("", "sqrt()").contains("a number or a name is missing here"));
}

#[test]
fn help_names_the_right_unit() {
    let help = |cell: &str| errors(&table("", &format!("| {cell} | 0 | 0 | q1 | - |"))).join("\n");
    assert!(help("1.5708").contains("[in radians this is `90deg` or `pi/2`]"), "{}", help("1.5708"));
    assert!(help("-0.785").contains("`45deg` or `pi/4`"));
    assert!(help("90").contains("[write `90deg`]"));
    assert!(help("1.2").contains("[write `approx 1.2rad` if these are radians, `1.2deg` if these are degrees]"));
    let row = |cell: &str| errors(&table("", &format!("| 0 | 0 | 0 | {cell} | - |"))).join("\n");
    assert!(row("th1").contains("the variable of a joint is called `q1`"), "{}", row("th1"));
    assert!(row("q1 + 1.5708").contains("`pi/2`"));
    let range = errors(&table("", "| 0 | 0 | 0 | q1 | 10deg..=-10deg |")).join("\n");
    assert!(range.contains("write `-10deg..=10deg`"), "{range}");
}

#[test]
fn attributes_and_visibility_are_checked() {
    let rest = "struct R; convention = standard; | alpha | a | d | theta | | 0 | 1 | 0 | q1 |";
    assert_eq!(errors(&format!("pub(cratemodified) {rest}")).len(), 1);
    assert_eq!(errors(&format!("#[(Debug)] {rest}")).len(), 1);
    assert!(errors(&format!("#[allow(dead_code)] pub(crate) {rest}")).is_empty());
}

#[test]
fn wrong_variables() {
    wrong(
        "",
        "| 0 | q1 | 0 | q1 | - |\n| 0 | 0 | q2 | q2 | - |\n| 0 | 0 | 0 | q2 | - |\n| 0 | 0 | 0 | q0 | - |\n| q1 | 0 | 0 | 0 | - |",
        &[
            "q1: column `a` cannot move: a joint variable stands in column `theta` or `d`",
            "q2: row 2 moves in `theta` and in `d`: one joint per row (it moves here already, line 6) [write a cylindrical joint as two rows]",
            "q2: the variable of row 3 is `q3`, not `q2` [variables are numbered in the order of the rows]",
            "q0: joint variables are numbered from 1: `q1` is the first",
            "q1: column `alpha` cannot move: a joint variable stands in column `theta` or `d`",
        ],
    );
    wrong(
        "",
        "| 0 | 1 | 0 | q1 | - |\n| 0 | 1 | 0 | 0 | - |\n| 0 | 1 | 0 | q3 | - |",
        &[
            "q3: the variable of row 3 is `q2`, not `q3` [row 3 is moving row number 2: rows without a variable are fixed and do not count]",
        ],
    );
    let singular = "this coupling is singular: some motion of the motors moves no joint, so it cannot be inverted";
    wrong(
        "let p: length;",
        "| 0 | 1 | 0 | p*(q1 - q2) | - |\n| 0 | 1 | 0 | q2 - q1 | - |",
        &[&format!("p*(q1 - q2) | - |\n| 0 | 1 | 0 | q2 - q1: {singular}")],
    );
    wrong(
        "let p: length = 1;",
        "| 0 | 1 | 0 | p*q1 + q2 | - |\n| 0 | 1 | 0 | q1 + q2 | - |",
        &["p*q1 + q2 | - |\n| 0 | 1 | 0 | q1 + q2: this coupling is singular at the nominal values of its fields"],
    );
    wrong(
        "",
        "| 0 | 1 | 0 | q1 - q2 | - |\n| 0 | 1 | 0 | q3 | - |",
        &["q3: there is no variable `q3`: 2 rows move, so there are `q1` to `q2`"],
    );
    wrong(
        "",
        "| 0 | 1 | 0 | 2*q1 | - |\n| 0 | 1 | 0 | q1 | - |",
        &[
            "q1: `q2` drives nothing: 2 rows move, so there are `q1` to `q2` [a row that a linkage moves without a motor of its own adds \
           one that stays at 0: `q2 - q2 - q3`, for example, with the range `0deg..=0deg`]",
        ],
    );
    wrong(
        "",
        "| 0 | 1 | 0 | q1 - q1 | - |",
        &["q1 - q1: the joint variables cancel out here, so the row does not move"],
    );
    assert!(errors(&table("", "| 0 | 1 | 0 | 0 | - |"))[0].contains("nothing moves"));
}

#[test]
fn wrong_ranges() {
    wrong(
        "let l: length;",
        "| 0 | 0 | 0 | q1 | 160deg..=-160deg |\n| 0 | 0 | 0 | q2 | 0m..=1m |\n| 0 | 0 | q3 | 0 | 0..1 |\n\
         | 0 | 0 | 0 | 0 | 0..=1 |\n| 0 | 0 | q4 | 0 | 0..=l |\n| 0 | 0 | q5 | 0 | fixed |\n| 0 | 0 | 0 | q6 | 90 |\n| 0 | 0 | q7 | 0 | ..=1 |",
        &[
            "160deg..=-160deg: this range is empty: its lower bound is above its upper bound [if the bounds came reversed, write `-160deg..=160deg`]",
            "0m: joint 2 turns: its range is in angles",
            "0..1: the bounds belong to the range [write `..=`]",
            "0..=1: this row has no joint variable, so there is no range [write `-`]",
            "l: `l` is a field: a range needs numbers or constants",
            "fixed: the row says `fixed`, but joint 5 moves",
            "90: this is no range [a range is written `-160deg..=160deg`; `-` where it is not known]",
            "..=1: both bounds of a range must be given [a range is written `-160deg..=160deg`; `-` where it is not known]",
        ],
    );
}

#[test]
fn wrong_lines() {
    wrong(
        "let a2;\nlet fn: length;\nlet b: lenght;\nlet c = 3mm;\nlet c: angle;\nlet q1: length;\nlet e: angle = 3mm;\nlet k: length;\nlet n = 2*k;let o = 3*n;let p = 1/e;",
        "| e + p | b + a3 | n + o | q1 | - |",
        &[
            "a2: `let a2` has neither a kind nor a value [write `let a2: length;` or `let a2 = 431.8mm;`]",
            "fn: `fn` is a keyword of Rust, and a symbol becomes a field",
            "lenght: a name is a `length`, an `angle`, a `number` or a `pose` [did you mean `length`?]",
            "c: `c` is declared twice (first declared here, line 6)",
            "q1: `q1` is the name of a joint variable",
            "3mm: `e` holds an angle, but `3mm` is a length [write an angle: `90deg`, `pi/2`]",
            "k: `k` is a field: its value may change while the program runs \
             [write the expression in the cells, or make both constants: `let NAME = VALUE;`]",
            "a3: unknown name `a3` [declare it: `let a3: length;`]",
        ],
    );
    wrong(
        "conventoin = modified; unit = miles; scalar = f64; scalar = f32; task = poses; redundant = q2; ik = yes; base = tz(3) rx(1); tool = ;",
        "| 0 | 0 | 0 | q1 | - |",
        &[
            "conventoin: unknown setting `conventoin` [did you mean `convention`?]",
            "miles: unknown unit `miles`; the table's unit is one of m, cm, mm, in, ft",
            "scalar: `scalar` is set twice (first set here, line 3)",
            "poses: `task` is one of `pose`, `position`, `planar`, `axis` [did you mean `pose`?]",
            "q2: `redundant` names joint variables of the table [of `q1` to `q1`]",
            "yes: `ik` can only be set to `none`",
            "rx: motions are joined by `*`",
            "tool: `tool` has no value",
        ],
    );
    let three = "| 0 | 1 | 0 | q1 | - | | 0 | 1 | 0 | q2 | - | | 0 | 1 | 0 | q3 | - |";
    let names = "`redundant` names joint variables of the table [of `q1` to `q3`]";
    wrong(
        "redundant = q2, q4, q1, q2, , x;",
        three,
        &[
            &format!("q2, q4, q1, q2, , x: {names}"),
            &format!("q4: {names}"),
            "q2: `q2` is named twice",
            &format!("x: {names}"),
        ],
    );
    wrong(
        "task = planar; redundant = q2;",
        "| 0 | 0 | 0 | q1 | - | | 0 | 1 | 0 | q2 + q1 | - | | 0 | 1 | 0 | q3 - q2 | - | | 0 | 1 | 0 | q4 | - |",
        &[
            "q2: no row is moved by `q2` alone, so choosing it fixes no joint [choose a variable that stands alone in a cell]",
        ],
    );
    wrong(
        "let c1: length; prove { a = b; }",
        "| 0 | c1 | 0 | q1 | - |",
        &["c1: `c1` is a cosine or sine in the `prove` block: choose another name"],
    );
    wrong(
        "convention = craig;",
        "| 0 | 0 | 0 | q1 | - |",
        &["convention: `convention` is set twice (first set here, line 2)"],
    );
}

#[test]
fn wrong_outlines() {
    let row = "| alpha | a | d | theta |\n| 0 | 0 | 0 | q1 |";
    let starts = |source: String| -> Vec<String> {
        errors(&source).iter().map(|e| e.split(" [").next().unwrap_or("").into()).collect()
    };
    assert_eq!(starts(format!("struct R;\n{row}")), ["R: the convention is missing; there is no default"]);
    assert_eq!(starts("struct R; convention = modified;".into()), ["R: the table is missing"]);
    assert_eq!(
        starts(format!("struct R {{ a: f64 }} convention = modified;\n{row}")),
        ["{ a: f64 }: the struct has no body here: its fields are the `let` lines"]
    );
    assert_eq!(starts(format!("robot R; convention = modified;\n{row}")), ["robot: `struct` is missing"]);
    assert_eq!(starts(format!("struct f64; convention = modified;\n{row}")), ["f64: a robot cannot be called `f64`"]);
    assert_eq!(
        starts(format!("struct R; convention = modified let a: length let b = 1mm\n{row}")),
        ["modified: `;` is missing after this", "length: `;` is missing after this", "1mm: `;` is missing after this"]
    );
    assert_eq!(
        starts(format!("struct R; convention = modified;\n{row}\n+ 1;")),
        ["+ 1: this belongs to no line of the table"]
    );
    let second = format!("struct R; convention = modified;\n{row}\nik = none;\n{row}\nstruct S;");
    let want = [
        "| alpha | a | d | theta |\n| 0 | 0 | 0 | q1 |: a second table: there is one robot in each call (the first table is here, line 2)",
        "struct: a second struct: there is one robot in each call",
    ];
    assert_eq!(starts(second), want);
    assert_eq!(starts(String::new()), [": there is no robot here"]);
}

#[test]
fn hostile_input_is_refused_quickly() {
    let one = |cell: &str| errors(&table("let l: number; let k: number;", &format!("| 0 | {cell} | 0 | q1 | - |")));
    let deep = format!("{}1{}", "(".repeat(200), ")".repeat(200));
    let cells = [
        deep,
        format!("1{}", "0".repeat(500)),
        "1e401".into(),
        "1e300*1e300".into(),
        vec!["1"; 500].join("+"),
        vec!["(l+k)"; 40].join("*"),
        vec!["1e399"; 90].join("*"),
        "-".repeat(500),
    ];
    for cell in cells {
        assert_eq!(one(&cell).len(), 1, "{cell}");
    }
    let many: String = (0..70).map(|i| format!("let a{i}: length;")).collect();
    assert_eq!(errors(&table(&many, "| 0 | 0 | 0 | q1 | - |")).len(), 6);
    let angles = "| 4*b | 0 | 0 | q1 | - |".repeat(7);
    assert!(errors(&table("let b: angle;", &angles)).iter().any(|e| e.contains("occurs more than")));
}

#[test]
fn invisible_groups_are_seen_through() {
    use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
    fn wrap(tokens: TokenStream) -> TokenStream {
        let wrapped = tokens.into_iter().map(|t| match t {
            TokenTree::Literal(_) => TokenTree::Group(Group::new(Delimiter::None, t.into())),
            t => t,
        });
        wrapped.collect()
    }
    let source = table("let l = 3mm;", "| -90deg | 2*l | 0 | q1 | -10deg..=20deg |");
    let plain = read(&source).spec.map(|s| format!("{s:?}"));
    let wrapped = parse(wrap(lex(&source).expect("tokens"))).spec.map(|s| format!("{s:?}"));
    assert_eq!((plain.is_some(), plain), (true, wrapped));
}

/// Bare numbers of a hundred and more, in a table that does not say its unit.
#[test]
fn millimetres_without_a_unit_are_asked_about() {
    let rows = "| 0 | 431.8 | 0 | q1 | - | | 0 | -20.3 | 150 | q2 | - |";
    let text = "431.8: is this a length of 431.8 metres? The table does not say its unit [write `unit = mm;`, or `unit = m;` if it is]";
    wrong("", rows, &[text]);
    wrong("let l: length = 500;", "| 0 | l | 0 | q1 | - |", &[&text.replace("431.8", "500")]);
    for (lines, rows) in [
        ("unit = m;", rows),
        ("unit = mm;", rows),
        ("", "| 0 | 431.8m | 0 | q1 | - |"),
        ("", "| 0 | 574 | 0.089 | q1 | - |"),
        ("", "| 0 | 10 | 20 | q1 | - |"),
    ] {
        assert_eq!(errors(&table(lines, rows)), [""; 0], "{lines} {rows}");
    }
}

#[test]
fn labels_of_rows() {
    let source = "struct R; convention = standard; | joint | alpha | a | d | theta |
        | waist | 0 | 0 | 0 | q1 | | 2 | 0 | 1 | 0 | q2 | | \"left elbow\" | 0 | 1 | 0 | q3 | | J4 | 0 | 1 | 0 | 0 | | - | 0 | 1 | 0 | q4 |";
    let labels: Vec<Option<String>> = read(source).spec.expect("a robot").rows.into_iter().map(|r| r.label).collect();
    let want = [Some("waist"), None, Some("left elbow"), Some("J4"), None];
    assert_eq!(labels, want.map(|l| l.map(str::to_string)));
}
