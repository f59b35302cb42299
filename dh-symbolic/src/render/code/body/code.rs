//! Expressions of generated code with their precedence and sign.

/// How tightly an expression binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Binding {
    /// A name, a literal, a call, something in parentheses.
    Atom,
    /// A product.
    Product,
    /// A sum.
    Sum,
}

/// An expression.
#[derive(Clone, Debug)]
pub(in crate::render) struct Code {
    /// Whether it begins with a minus sign.
    negative: bool,
    /// What follows the sign.
    unsigned: String,
    binding: Binding,
    /// Whether it is the name of a sine or cosine, or of a product of some.
    is_trigonometric: bool,
}

impl Code {
    /// A name, a call or the like.
    pub(in crate::render) fn atom(text: impl Into<String>) -> Code {
        Code { negative: false, unsigned: text.into(), binding: Binding::Atom, is_trigonometric: false }
    }

    /// The name of a sine or cosine, or of a product of some.
    pub(in crate::render) fn trigonometric(text: impl Into<String>) -> Code {
        Code { is_trigonometric: true, ..Code::atom(text) }
    }

    /// A number; `text` is the literal of its absolute value.
    pub(in crate::render) fn number(negative: bool, text: impl Into<String>) -> Code {
        Code { negative, ..Code::atom(text) }
    }

    /// The whole text.
    pub(in crate::render) fn text(&self) -> String {
        if self.negative { format!("-{}", self.unsigned) } else { self.unsigned.clone() }
    }

    /// Its length.
    pub(super) fn len(&self) -> usize {
        self.unsigned.len() + usize::from(self.negative)
    }

    /// Whether it is a single name, literal or call, perhaps with a sign.
    pub(super) fn is_atom(&self) -> bool {
        self.binding == Binding::Atom
    }

    /// The name, if it is that of a sine or cosine, or of a product of some.
    pub(super) fn trigonometric_name(&self) -> Option<&str> {
        (self.is_trigonometric && !self.negative).then_some(self.unsigned.as_str())
    }

    /// The negative.
    pub(in crate::render) fn negated(&self) -> Code {
        match self.binding {
            Binding::Sum => Code::number(true, format!("({})", self.text())),
            _ => Code { negative: !self.negative, is_trigonometric: false, ..self.clone() },
        }
    }

    /// In parentheses, unless it is a single thing.
    fn single(&self) -> String {
        if self.is_atom() { self.text() } else { format!("({})", self.text()) }
    }

    /// As a factor: sums get parentheses.
    fn factor(&self) -> Code {
        if self.binding == Binding::Sum { Code::atom(format!("({})", self.text())) } else { self.clone() }
    }

    /// self * other, from left to right.
    pub(in crate::render) fn times(&self, other: &Code) -> Code {
        let (a, b) = (self.factor(), other.factor());
        Code {
            negative: a.negative,
            unsigned: format!("{} * {}", a.unsigned, b.text()),
            binding: Binding::Product,
            is_trigonometric: false,
        }
    }

    /// self * (other): the other one is computed first.
    pub(in crate::render) fn times_whole(&self, other: &Code) -> Code {
        self.times(&Code::atom(other.single()))
    }

    /// (self) * other.
    pub(in crate::render) fn whole_times(&self, other: &Code) -> Code {
        if self.is_atom() { self.times(other) } else { Code::atom(self.single()).times(other) }
    }

    /// a + b - c, from left to right, with signs pulled into the operators; empty for no parts.
    pub(in crate::render) fn sum(parts: &[Code]) -> Code {
        let Some((first, rest)) = parts.split_first() else { return Code::atom("") };
        if rest.is_empty() {
            return first.clone();
        }
        let mut out = first.unsigned.clone();
        for part in rest {
            out.push_str(if part.negative { " - " } else { " + " });
            out.push_str(&part.unsigned);
        }
        Code { negative: first.negative, unsigned: out, binding: Binding::Sum, is_trigonometric: false }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_and_parentheses_keep_the_meaning() {
        let [a, b, c] = ["a", "b", "c"].map(Code::atom);
        let difference = Code::sum(&[a.clone(), b.negated()]);
        assert_eq!(difference.text(), "a - b");
        assert_eq!(difference.negated().text(), "-(a - b)");
        assert_eq!(Code::sum(&[c.clone(), difference.negated()]).text(), "c - (a - b)");
        assert_eq!(c.times(&difference).text(), "c * (a - b)");
        assert_eq!(c.negated().negated().text(), "c");
        assert_eq!(Code::number(true, "2.0").times_whole(&a.times(&b)).text(), "-2.0 * (a * b)");
        assert_eq!(Code::sum(&[Code::sum(&[a.negated(), b]), c.negated()]).text(), "-a + b - c");
    }
}
