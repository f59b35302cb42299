//! Tests of the parser: what is accepted, what is refused and where, and that nothing panics.

use super::{Derivation, Statement};
use crate::verify::Claims;

fn read(text: &str) -> Derivation {
    Claims::from_tokens(text.parse().unwrap()).derivation
}

/// Reads one line; an unreadable one gives its words and the reason.
fn trouble(text: &str) -> String {
    let d = read(text);
    match d.lines.iter().map(|l| &l.statement).find(|s| matches!(s, Statement::Unreadable(_))) {
        Some(Statement::Unreadable(n)) => format!("{}: {}", d.text(&n.place), n.why),
        _ => "fine".into(),
    }
}

#[test]
fn lines_are_written_down_as_they_were_read() {
    for line in [
        "T(0,6).px = c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1",
        "T(1,3) = [c23, -s23; 0, -a2*s2]",
        "a - -b != c^-1 + x^2",
        "at q1 = 21.8deg, q4 = -20deg within 0.5deg",
        "T(0,6).p ~ [381.3; 151.8; 19.5] within 0.05",
        "let f1 = a3*c(2-3)",
        "let phi: angle",
        "subst(e, q2 = 0, a1 = a2) <= -x = y >= z",
        "norm2(u)*dot(u, v)/sqrt(x) > 0",
        "alpha1: angle",
    ] {
        let d = read(&format!("{line};"));
        assert_eq!(d.lines.len(), 1);
        assert_eq!(trouble(line), "fine", "{line}");
        assert_eq!(d.text(&d.lines[0].place), line);
    }
}

#[test]
fn notes_belong_to_the_next_line() {
    let d = read("/// slide 12\n/// second\n x = y; a = b;");
    assert_eq!(d.lines[0].note, "slide 12 second");
    assert_eq!(d.lines[1].note, "");
}

#[test]
fn one_slip_is_one_message() {
    let d = read("a = b; c d = e; f = g;");
    assert_eq!(d.lines.iter().filter(|l| matches!(l.statement, Statement::Unreadable(_))).count(), 1);
    for (line, message) in [
        ("c4c5 s4 = 0;", "s4: `s4` stands alone: write `*` for a product"),
        ("a + = 0;", "=: expected a number, a name or a bracket, found `=`"),
        ("a*b;", ": a line says `left = right;` (or `~`, `!=`, `<`, `>`)"),
        ("[a, b; c] = 0;", "[a, b; c]: row 2 of the matrix has 1 entries, row 1 has 2"),
        ("[] = 0;", "[]: an empty matrix"),
        ("x^y = 1;", "y: an exponent is a whole number up to 16"),
        ("x^99 = 1;", "99: an exponent is a whole number up to 16"),
        ("let x;", ": expected `=` after the name, found the end of the line"),
        ("let x: mass;", "mass: expected `length` or `angle`, found `mass`"),
        ("a = {b};", "{: expected a number, a name or a bracket, found `{`"),
        ("a = \"b\";", "\"b\": expected a number, a name or a bracket, found `\"b\"`"),
        ("; a = b;", ": an empty line: a `;` too many?"),
    ] {
        assert_eq!(trouble(line), message, "{line}");
    }
}

#[test]
fn depth_is_limited() {
    let deep = |open: &str, close: &str| format!("{}x{} = 0;", open.repeat(400), close.repeat(400));
    for text in [deep("(", ")"), deep("-", ""), deep("[", "]"), deep("f(", ")"), format!("x{} = 0;", ".t".repeat(400))]
    {
        assert_ne!(trouble(&text), "fine");
    }
    assert_eq!(trouble(&format!("0{} = 0;", " + x*y".repeat(3000))), "fine");
}
