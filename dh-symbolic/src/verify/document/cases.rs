//! Statements that are said of a case: `If $a_1 = 0$`, values of letters that the document has defined, letters that change their meaning.

use super::Word;
use super::letter::Letter;
use super::meaning::formula;
use super::names::DocumentNames;
use super::others::{number, table_number};
use super::pieces::Statement;
use super::values::{is_number, text};
use std::collections::BTreeSet;

impl Statement {
    /// `\alpha = 0` for a letter that the document has defined: a case that is looked at, or a number of an example.
    pub(super) fn is_case(&self, names: &DocumentNames<'_>) -> bool {
        let [left, right] = self.sides.as_slice() else { return false };
        let [only] = left.as_slice() else { return false };
        let given = Letter::of(only).is_some_and(|l| names.is_given(&l) && l.index.is_empty());
        let exact = |w: &[Word]| is_number(w) && !w.iter().any(|w| w.token.text.contains('.'));
        given && only.sup.is_none() && self.relations == ["="] && formula(right, names).is_ok_and(|w| exact(&w))
    }

    /// `If $a_1 = 0$`: what follows in this line of the document is said for this value. `s\alpha_1 = 0` has two.
    pub(super) fn take_condition(&self, names: &mut DocumentNames<'_>) {
        let Ok(sides) = self.words(names) else { return };
        let [left, right] = sides.as_slice() else { return };
        if self.relations != ["="] || !is_number(right) {
            return;
        }
        let words: Vec<&str> = left.iter().map(|w| w.token.text.as_str()).collect();
        let values = match words.as_slice() {
            [name] => vec![(*name, text(right))],
            ["sin", "(", name, ")"] if text(right) == "0" => vec![(*name, "0".into()), (*name, "180deg".into())],
            _ => return,
        };
        let variable = |name: &str| {
            let parameter = names.chain.parameters.iter().any(|p| p.name == name);
            parameter || names.variable(name).is_some()
        };
        // of a number of the table it is true, and says nothing, or it is not: then nothing after it is said of this arm
        let known = |(name, value): &(&str, String)| {
            Some((table_number(names.chain, name)? - number(&[Word::new(value, 0)])?).abs() < 1e-9)
        };
        let facts: Vec<bool> = values.iter().filter_map(known).collect();
        if !facts.is_empty() {
            if !facts.contains(&true) {
                names.elsewhere.insert(self.line);
            }
            return;
        }
        // a letter of the document: what follows is said of this case of its law
        if let Some([only]) = self.sides.first().map(Vec::as_slice)
            && Letter::of(only).is_some_and(|l| l.index.is_empty() && names.is_given(&l))
        {
            names.elsewhere.insert(self.line);
            return;
        }
        let own: Vec<_> = values.into_iter().filter(|v| variable(v.0)).collect();
        names.conditions.retain(|c| c.0 == self.line && own.iter().all(|o| *o.0 != c.1));
        names.conditions.extend(own.iter().map(|(n, v)| (self.line, n.to_string(), v.clone())));
    }

    /// A claim at the values that are said before it in the same line of the document, one line for each value.
    pub(super) fn under_conditions(&self, sides: &[Vec<Word>], names: &DocumentNames<'_>) -> Option<Vec<Vec<Word>>> {
        let here: Vec<_> = names.conditions.iter().filter(|c| c.0 == self.line).collect();
        if here.is_empty() || self.relations.iter().any(|r| *r != "=") {
            return None;
        }
        // every choice of a value for each variable
        let mut choices: Vec<Vec<(&str, &str)>> = vec![Vec::new()];
        for name in here.iter().map(|c| &c.1).collect::<BTreeSet<_>>() {
            let values = || here.iter().filter(|c| c.1 == *name).map(|c| (name.as_str(), c.2.as_str()));
            choices = choices.iter().flat_map(|c| values().map(|v| [c.clone(), vec![v]].concat())).take(4).collect();
        }
        let word = |t: &str| Word::new(t, self.line);
        let at = |side: &Vec<Word>, choice: &[(&str, &str)]| {
            let head = [word("subst"), word("(")].into_iter().chain(side.iter().cloned());
            let one = |(name, value): &(&str, &str)| {
                [",", name, "="].into_iter().chain(value.split(' ')).map(word).collect::<Vec<_>>()
            };
            head.chain(choice.iter().flat_map(one)).chain([word(")")]).collect::<Vec<_>>()
        };
        let line = |choice: &Vec<(&str, &str)>| {
            let all: Vec<Vec<Word>> = sides.iter().map(|s| at(s, choice)).collect();
            all.join(&word("="))
        };
        Some(choices.iter().map(line).collect())
    }

    /// A letter that means something else from here on: read once more, this line was found to define it anew.
    pub(super) fn renewed(&self, names: &DocumentNames<'_>) -> Option<Letter> {
        let [only] = self.sides.first()?.as_slice() else { return None };
        let letter = Letter::of(only).filter(|l| only.sup.is_none() && names.is_given(l))?;
        names.learnt.renewed.contains(&(self.line, letter.own())).then_some(letter)
    }
}
