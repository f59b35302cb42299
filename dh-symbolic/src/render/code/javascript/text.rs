//! JavaScript text: string literals that are safe inside a page, indented lines.

/// A string literal; safe between `<script>` tags too.
pub(in crate::render) fn string(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => {
                out.push('\\');
                out.push(c);
            }
            '<' | '>' | '&' | '\u{2028}' | '\u{2029}' => out.push_str(&format!("\\u{:04x}", c as u32)),
            c if c.is_control() => out.push_str(&format!("\\u{:04x}", c as u32)),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// Indents lines by the brackets that are open.
pub(super) fn indented(text: &str) -> String {
    let mut out = String::new();
    let mut depth = 0usize;
    for line in text.lines() {
        let open = line.matches(['{', '[', '(']).count();
        let close = line.matches(['}', ']', ')']).count();
        let leading = line.chars().take_while(|c| matches!(c, '}' | ']' | ')')).count();
        let own = depth.saturating_sub(leading.min(1));
        out.push_str(&"  ".repeat(own));
        out.push_str(line);
        out.push('\n');
        depth = (depth + usize::from(open > close)).saturating_sub(usize::from(close > open));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_end_where_they_should() {
        assert_eq!(string("a\"b\\</script>\n"), "\"a\\\"b\\\\\\u003c/script\\u003e\\u000a\"");
    }

    #[test]
    fn blocks_are_indented() {
        assert_eq!(
            indented("f() {\nif (x) {\ny([1]);\n}\nreturn [\n1,\n];\n}"),
            "f() {\n  if (x) {\n    y([1]);\n  }\n  return [\n    1,\n  ];\n}\n"
        );
    }
}
