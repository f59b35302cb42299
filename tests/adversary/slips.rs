//! Slips of the pen: every line that differs from a line by one of them.

/// All lines with one slip: a sign, an index, sine for cosine, the order of arguments, a branch of a root, a lost factor or square, another
/// entry of a matrix. Indices go up to `most`.
pub(super) fn slips(line: &[String], most: usize) -> Vec<Vec<String>> {
    let mut out: Vec<Vec<String>> = Vec::new();
    let mut put = |range: std::ops::Range<usize>, new: &[&str]| {
        let mut copy = line.to_vec();
        copy.splice(range, new.iter().map(|w| w.to_string()));
        out.push(copy);
    };
    let is = |k: usize, w: &str| line.get(k).is_some_and(|x| x == w);
    let is_value = |w: &str| w.starts_with(|c: char| c.is_alphanumeric()) || matches!(w, ")" | "]");
    for (k, w) in line.iter().enumerate() {
        let field = k > 0 && is(k - 1, ".");
        let value_before = k > 0 && is_value(&line[k - 1]);
        // the arguments of T(0,6) are frames
        let frame = (k > 1 && is(k - 1, "(") && matches!(line[k - 2].as_str(), "T" | "A" | "J" | "c" | "s"))
            || (k > 3 && is(k - 1, ",") && matches!(line[k - 4].as_str(), "T" | "J"));
        let stem = w.trim_end_matches(|c: char| c.is_ascii_digit());
        let digits = &w[stem.len()..];
        match w.as_str() {
            "+" => put(k..k + 1, &["-"]),
            "-" if value_before => put(k..k + 1, &["+"]),
            "-" => put(k..k + 1, &[]),
            "^" => put(k..k + 2, &[]),
            "sqrt" => put(k..k, &["-"]),
            "cos" => put(k..k + 1, &["sin"]),
            "sin" => put(k..k + 1, &["cos"]),
            "atan2" => {
                if let Some((comma, close)) = arguments(line, k) {
                    let mut new: Vec<&str> = line[comma + 1..close].iter().map(String::as_str).collect();
                    new.push(",");
                    new.extend(line[k + 2..comma].iter().map(String::as_str));
                    put(k + 2..close, &new);
                }
            }
            _ if field => match (stem, digits.as_bytes()) {
                ("r", [i, j]) if i != j => {
                    put(k..k + 1, &[&format!("r{}{}", char::from(*j), char::from(*i))]);
                }
                ("px" | "py" | "pz" | "x" | "y" | "z", []) => {
                    for axis in ["x", "y", "z"] {
                        let new = format!("{}{axis}", &w[..w.len() - 1]);
                        if new != *w {
                            put(k..k + 1, &[&new]);
                        }
                    }
                }
                _ => {}
            },
            _ if frame && stem.is_empty() => {
                for other in [w.parse::<usize>().unwrap_or(0).wrapping_sub(1), w.parse::<usize>().unwrap_or(0) + 1] {
                    if other <= most {
                        put(k..k + 1, &[&other.to_string()]);
                    }
                }
            }
            // brackets, and names of functions
            _ if !is_value(w) || matches!(w.as_str(), ")" | "]") || is(k + 1, "(") => {}
            _ => {
                match stem {
                    "c" => put(k..k + 1, &[&format!("s{digits}")]),
                    "s" => put(k..k + 1, &[&format!("c{digits}")]),
                    _ => {}
                }
                if matches!(stem, "c" | "s") && digits.len() > 1 {
                    put(k..k + 1, &[&w[..w.len() - 1]]);
                }
                for other in 0..=most {
                    let new = format!("{stem}{other}");
                    let has_index = matches!(stem, "c" | "s" | "q" | "a" | "d" | "l" | "theta" | "alpha");
                    if digits.len() == 1 && new != *w && has_index {
                        put(k..k + 1, &[&new]);
                    }
                }
                // a factor is lost
                if is(k + 1, "*") && !is(k.wrapping_sub(1), "/") {
                    put(k..k + 2, &[]);
                }
                if k > 0 && is(k - 1, "*") && !is(k + 1, ".") {
                    put(k - 1..k + 1, &[]);
                }
            }
        }
    }
    out
}

/// Comma and closing bracket of a function with two arguments.
fn arguments(line: &[String], function: usize) -> Option<(usize, usize)> {
    let (mut depth, mut comma) = (0, None);
    for (j, x) in line.iter().enumerate().skip(function + 1) {
        match x.as_str() {
            "(" | "[" => depth += 1,
            ")" | "]" => depth -= 1,
            "," if depth == 1 => comma = Some(j),
            _ => {}
        }
        if depth == 0 {
            return Some((comma?, j));
        }
    }
    None
}
