//! The questions of the page and their answers.
//!
//! A question is an object with `ask` and `table`, and what else it needs (`language`, `format`, `text`). An answer is an object; where
//! the table has mistakes it is `{"mistakes": [...]}`, each with line, column, length, message and help.

use crate::sections::{formats, sections};
use dh_symbolic::{Checked, Document, Finding, Format, Language, NotesOptions, Part, Robot, TableError};
use serde_json::{Value, json};
use std::cell::RefCell;

/// Bytes of a table and of a document that are read: a worker is to answer within a moment.
const LONGEST_TABLE: usize = 200_000;
const LONGEST_DOCUMENT: usize = 2_000_000;

/// Bytes of formulas that a browser lays out in a moment, and the numbers of terms that are tried until they are no more.
const ROOM: usize = 700_000;
const TERMS: [usize; 4] = [1500, 400, 100, 30];

thread_local! {
    /// The last table and its robot: the page asks several things about one table.
    static LAST: RefCell<Option<(String, Robot)>> = const { RefCell::new(None) };
}

/// Answers a question.
#[must_use]
pub fn answer(question: &str) -> String {
    let answer = match serde_json::from_str::<Value>(question) {
        Ok(question) => Question { fields: &question }.answer(),
        Err(error) => Err(whole(&format!("the question is no JSON: {error}"))),
    };
    answer.unwrap_or_else(|mistakes| mistakes).to_string()
}

/// A mistake without a place.
fn whole(message: &str) -> Value {
    json!({ "mistakes": [{ "line": 0, "column": 0, "length": 0, "message": message, "help": null }] })
}

fn mistakes(error: &TableError) -> Value {
    let one = |m: &dh_symbolic::Mistake| json!({ "line": m.line, "column": m.column, "length": m.length, "message": m.message, "help": m.help });
    json!({ "mistakes": error.mistakes().iter().map(one).collect::<Vec<_>>() })
}

/// A question, its fields read as they are needed.
struct Question<'a> {
    fields: &'a Value,
}

impl Question<'_> {
    fn text(&self, name: &str) -> &str {
        self.fields.get(name).and_then(Value::as_str).unwrap_or_default()
    }

    fn language(&self) -> Language {
        if self.text("language") == "zh" { Language::Chinese } else { Language::English }
    }

    fn format(&self) -> Format {
        Format::ALL.iter().find(|f| f.0 == self.text("format")).map_or(Format::Html, |f| f.1)
    }

    fn options(&self) -> NotesOptions {
        NotesOptions { language: self.language(), ..NotesOptions::default() }
    }

    fn robot(&self) -> Result<Robot, Value> {
        let table = self.text("table");
        if table.len() > LONGEST_TABLE {
            return Err(whole(&format!(
                "a table of {} kB: more than {} kB are not read",
                table.len() / 1000,
                LONGEST_TABLE / 1000
            )));
        }
        if let Some(robot) = LAST.with_borrow(|last| last.as_ref().filter(|l| l.0 == table).map(|l| l.1.clone())) {
            return Ok(robot);
        }
        let robot = Robot::parse(table).map_err(|error| mistakes(&error))?;
        LAST.set(Some((table.to_string(), robot.clone())));
        Ok(robot)
    }

    fn answer(&self) -> Result<Value, Value> {
        let ask = self.text("ask");
        if ask == "version" {
            return Ok(json!({ "version": env!("CARGO_PKG_VERSION") }));
        }
        let robot = self.robot()?;
        match ask {
            "table" => Ok(json!({ "name": robot.name(), "joints": robot.dof(), "rows": robot.rows() })),
            "inverse" => robot.verify().map(|()| json!({})).map_err(|error| mistakes(&error)),
            "formulas" => Ok(self.formulas(&robot)),
            "notes" => {
                Ok(json!({ "title": self.notes(&robot).title, "html": self.notes(&robot).print_body(Format::Html) }))
            }
            "print" => Ok(json!({ "text": self.notes(&robot).print(self.format()) })),
            "plan" => {
                let plan = robot.plan().map_err(|error| mistakes(&error))?;
                let mut out = formats(&plan.document(self.language()));
                out["mermaid"] = plan.mermaid(self.language()).into();
                out["solutions"] = plan.max_solutions().into();
                Ok(out)
            }
            "page" => robot.page(&self.options()).map(|html| json!({ "html": html })).map_err(|error| mistakes(&error)),
            "code" => robot.expand().map(|text| json!({ "expansion": text })).map_err(|error| mistakes(&error)),
            "derivation" => self.derivation(&robot),
            _ => Err(whole(&format!("there is no question `{ask}`"))),
        }
    }

    fn notes(&self, robot: &Robot) -> Document {
        robot.notes(&self.options())
    }

    /// Link transforms, products, pose and Jacobian; of arms with very long formulas, products stay products.
    fn formulas(&self, robot: &Robot) -> Value {
        let parts = vec![Part::Links, Part::Forward, Part::Jacobian];
        let with = |terms| robot.notes(&NotesOptions { parts: parts.clone(), terms, ..self.options() });
        let mut found = Vec::new();
        for terms in TERMS {
            found = sections(&with(terms));
            let bytes: usize = found.iter().filter_map(|s| s["html"].as_str()).map(str::len).sum();
            if bytes <= ROOM {
                break;
            }
        }
        json!({ "sections": found })
    }

    /// The lines of a document, and those of the table's `prove` blocks, each with what was found.
    fn derivation(&self, robot: &Robot) -> Result<Value, Value> {
        let text = self.text("text");
        if text.len() > LONGEST_DOCUMENT {
            return Err(whole(&format!(
                "a document of {} kB: more than {} kB are not read",
                text.len() / 1000,
                LONGEST_DOCUMENT / 1000
            )));
        }
        let lines = |checked: &Checked| -> Vec<Value> {
            let one = |l: &dh_symbolic::CheckedLine| json!({ "line": l.line, "finding": finding(l.finding), "text": l.text, "details": l.details });
            checked.lines().iter().map(one).collect()
        };
        Ok(json!({
            "lines": lines(&robot.check_document(text)),
            "table": robot.check_proofs().map(|checked| lines(&checked)),
        }))
    }
}

/// What the page calls a finding.
fn finding(finding: Finding) -> &'static str {
    match finding {
        Finding::Definition => "definition",
        Finding::Proven => "proven",
        Finding::ProvenWhere => "where",
        Finding::Agrees => "agrees",
        Finding::Wrong => "wrong",
        Finding::Unclear => "unclear",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PUMA: &str = include_str!("../../../dh-symbolic/tests/puma560.dh");

    fn ask(question: Value) -> Value {
        serde_json::from_str(&answer(&question.to_string())).expect("JSON")
    }

    fn about(table: &str, ask_for: &str) -> Value {
        ask(json!({ "ask": ask_for, "table": table }))
    }

    #[test]
    fn every_question_about_a_puma() {
        assert_eq!(about(PUMA, "table")["joints"], 6);
        assert_eq!(about(PUMA, "inverse"), json!({}));
        let formulas = about(PUMA, "formulas");
        let list = formulas["sections"].as_array().expect("a list");
        assert!(list.len() >= 3);
        for (format, sign) in [("html", "<math"), ("latex", "\\begin{bmatrix}"), ("typst", "mat("), ("markdown", "$$")]
        {
            assert!(list[0][format].as_str().is_some_and(|text| text.contains(sign)), "{format}: {}", list[0][format]);
        }
        assert!(!list[0]["latex"].as_str().expect("text").contains("documentclass"));
        let plan = about(PUMA, "plan");
        assert_eq!(plan["solutions"], 8);
        assert!(!plan["html"].as_str().expect("text").contains("flowchart"));
        assert!(plan["mermaid"].as_str().is_some_and(|text| text.starts_with("flowchart")));
        for (question, field) in [("notes", "html"), ("print", "text"), ("page", "html"), ("code", "expansion")] {
            assert!(about(PUMA, question)[field].as_str().is_some_and(|text| text.len() > 2000), "{question}");
        }
        let chinese = ask(json!({ "ask": "notes", "table": PUMA, "language": "zh" }));
        assert!(chinese["title"].as_str().is_some_and(|title| title.contains("运动学")), "{}", chinese["title"]);
    }

    #[test]
    fn mistakes_have_places() {
        let found = about(
            "pub struct A;\nconvention = standard;\n| theta | d | a  | alpha |\n| q1    | 0 | l1 | 90    |",
            "table",
        );
        let list = found["mistakes"].as_array().expect("a list");
        let place = |m: &Value| ["line", "column", "length"].map(|k| m[k].as_u64().expect("a number"));
        assert_eq!(list.iter().map(place).collect::<Vec<_>>(), [[4, 15, 2], [4, 20, 2]]);
        assert!(list[1]["help"].as_str().is_some_and(|help| help.contains("90deg")), "{}", list[1]);
        // Of an arm that cannot be solved as asked, the inverse says so.
        let seven: String = (1..=7).map(|k| format!("| {}deg | 0.1 | 0.2 | q{k} |\n", 10 * k)).collect();
        let table = format!("pub struct A;\nconvention = standard;\n| alpha | a | d | theta |\n{seven}");
        assert_eq!(about(&table, "table")["joints"], 7);
        for question in ["inverse", "plan", "code"] {
            assert_eq!(place(&about(&table, question)["mistakes"][0])[0], 1, "{question}");
        }
    }

    #[test]
    fn lines_of_a_derivation() {
        let text = "The elbow is at\n$$ {}^1p_x = a_2 c_2 $$\nand not at\n$$ {}^1T_3 = T $$ $p_x = a_2 s_2$\n";
        let found = ask(json!({ "ask": "derivation", "table": PUMA, "text": text }));
        assert!(found["lines"].as_array().is_some_and(|l| !l.is_empty()), "{found}");
        let table = format!("{PUMA}\nprove {{ T(1,3).px = a2*c2; T(1,3).px = a2*s2; }}");
        let found = ask(json!({ "ask": "derivation", "table": table, "text": "" }));
        let list = found["table"].as_array().expect("a list");
        assert_eq!([&list[0]["finding"], &list[1]["finding"]], ["proven", "wrong"]);
        assert!(list[1]["details"].to_string().contains("`s2` should be `c2`"), "{}", list[1]);
    }

    #[test]
    fn whatever_is_asked_has_an_answer() {
        for text in ["", "{", "[]", "{\"ask\":3}", "{\"ask\":\"page\",\"table\":\"<script>\"}"] {
            assert!(answer(text).contains("mistakes"), "{text}");
        }
        assert!(
            about(&"| ".repeat(500_000), "table")["mistakes"][0]["message"].as_str().is_some_and(|m| m.contains("kB"))
        );
        assert!(about(&"(".repeat(199_000), "table")["mistakes"].is_array());
        assert!(about(&"| 0 ".repeat(40_000), "table")["mistakes"].is_array());
    }
}
