//! The interactive page in a real browser: a slider is moved, every solution clicked, and the numbers on the screen compared with Rust's.
//!
//! Needs Chromium (`chromium`, or what `CHROMIUM` names); where there is none the test says so and passes, unless `CHROMIUM` is set.

use std::path::Path;
use std::process::Command;

use dh_symbolic::render::{Options, page};
use dh_tests::engine::{Interpreter, spec};
use serde_json::Value;

/// How far the numbers on the screen may be from Rust's.
const AGREE: f64 = 1e-12;

/// The document that a browser makes of a page; `None` where there is no browser.
fn browse(page: &Path, profile: &Path) -> Option<String> {
    let asked = std::env::var_os("CHROMIUM");
    let program = asked.clone().unwrap_or_else(|| "chromium".into());
    let done = Command::new(program)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"])
        .args(["--disable-background-networking", "--disable-component-update", "--disable-sync"])
        .args(["--window-size=1500,1000", "--virtual-time-budget=5000", "--dump-dom"])
        .arg(format!("--user-data-dir={}", profile.display()))
        .arg(format!("file://{}", page.display()))
        .output();
    match done {
        Ok(done) => Some(String::from_utf8_lossy(&done.stdout).into_owned()),
        Err(error) => {
            assert!(asked.is_none(), "the browser that CHROMIUM names does not start: {error}");
            eprintln!("skipped: there is no chromium to look at the page ({error})");
            None
        }
    }
}

/// What the reader in `browser.js` saw.
fn report(name: &str, html: &str) -> Option<Value> {
    let folder = std::env::temp_dir().join(format!("dh-browser-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let page = folder.join("page.html");
    let reader = format!("<script>{}</script>\n</body>", include_str!("browser.js"));
    std::fs::write(&page, html.replace("</body>", &reader)).expect("a file");
    let seen = browse(&page, &folder.join("profile"));
    std::fs::remove_dir_all(&folder).ok();
    let seen = seen?;
    let report = seen.split_once("<pre id=\"report\">").and_then(|(_, rest)| rest.split_once("</pre>"));
    let (json, _) = report.unwrap_or_else(|| panic!("{name}: the script did not run:\n{seen}"));
    let json = json.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
    Some(serde_json::from_str(&json).expect("JSON"))
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|x| x.as_f64().unwrap_or(f64::NAN)).collect()
}

#[test]
fn the_page_shows_what_rust_computes() {
    let sources = generated_examples::source::all().expect("the examples can be read");
    for (module, solutions) in [("puma560", 8), ("stanford", 8), ("scara_rrrp", 2), ("planar_3r", 2), ("planar_2r", 2)]
    {
        let source = sources.iter().find(|s| s.module == module).expect("an example");
        let interpreter = Interpreter::new(&spec(&source.body));
        let html = page(&interpreter.chain, &Options::default()).expect("a page");
        assert!(html.len() < 300_000, "{module}: {} bytes", html.len());
        assert!(!html.contains("http://") || html.matches("http://").count() == 1, "{module}: only SVG has an address");
        let Some(report) = report(module, &html) else { return };
        assert!(report.get("error").is_none(), "{module}: {}", report["error"]);
        let engine = interpreter.engine();
        let check = |what: &str, seen: &Value, q: &[f64]| {
            let pose = (engine.pose)(q).concat();
            for (a, b) in pose.iter().zip(numbers(&seen["pose"])) {
                assert!((a - b).abs() <= AGREE, "{module}, {what}: {a} in Rust, {b} on the page");
            }
            let columns = (engine.jacobian)(q);
            let rows = (0..6).flat_map(|r| columns.iter().map(move |c| c[r]));
            for (a, b) in rows.zip(numbers(&seen["jacobian"])) {
                assert!((a - b).abs() <= AGREE, "{module}, {what}: {a} in Rust, {b} on the page");
            }
        };
        let moved = &report["slider"];
        let q = numbers(&moved["q"]);
        assert!((q[0] - 0.75).abs() < 1e-15, "{module}: {q:?}");
        check("slider moved", moved, &q);
        let list: Vec<Vec<f64>> = moved["solutions"].as_array().expect("a list").iter().map(numbers).collect();
        assert_eq!(list.len(), solutions, "{module}: {list:?}");
        let here = moved["chosen"].as_u64().expect("the posture is one of the solutions") as usize;
        assert!(list[here].iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-9), "{module}: {list:?} {q:?}");
        for (i, seen) in report["clicks"].as_array().expect("a list").iter().enumerate() {
            assert_eq!(seen["chosen"], i, "{module}");
            check("solution clicked", seen, &list[i]);
            assert_eq!(seen["solutions"], moved["solutions"], "{module}: clicking changes no solution");
        }
        assert!(report["ghosts"]["drawn"].as_u64() > moved["drawn"].as_u64(), "{module}: shadows of the others");
        // (A slide goes as far as it is asked to.)
        let reached = if module == "stanford" { solutions } else { 0 };
        assert_eq!(report["far"]["solutions"].as_array().map(Vec::len), Some(reached), "{module}");
        assert!(report["far"]["text"].as_str().is_some_and(|t| t.len() > 15), "{module}: {}", report["far"]["text"]);
        assert!(report["formulas"].as_u64() > Some(5) && report["laidOut"] == true, "{module}: MathML");
        assert_eq!(report["inside"], true, "{module}: the arm leaves the drawing");
        assert_eq!(report["requests"], 0, "{module}: the page asks the network");
    }
}
