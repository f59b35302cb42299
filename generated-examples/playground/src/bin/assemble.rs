//! Makes the playground's page: module, scripts, styles and examples in one HTML file.
//!
//! `assemble MODULE.wasm PAGE.html`. The content policy names the scripts by their hashes, so that nothing else runs.

use flate2::{Compression, write::GzEncoder};
use serde_json::json;
use sha2::{Digest, Sha256};
use std::error::Error;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The scripts of the page, in the order in which they stand in it.
const SCRIPTS: [&str; 7] = ["words", "markup", "editor", "share", "compiler", "tabs", "main"];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [module, page] = arguments.as_slice() else {
        return Err("usage: assemble MODULE.wasm PAGE.html".into());
    };
    let module = fs::read(module)?;
    let mut packer = GzEncoder::new(Vec::new(), Compression::best());
    packer.write_all(&module)?;
    let packed = packer.finish()?;
    let html = html(&base64(&packed), &serde_json::to_string(&examples()?)?)?;
    fs::write(page, &html)?;
    eprintln!(
        "{page}: {} kB (module {} kB, {} kB compressed)",
        html.len() / 1000,
        module.len() / 1000,
        packed.len() / 1000
    );
    Ok(())
}

/// The page from its parts.
fn html(module: &str, examples: &str) -> Result<String, Box<dyn Error>> {
    let part = |name: &str| fs::read_to_string(folder().join("page").join(name));
    let mut script = "\"use strict\";\n(() => {\n".to_string();
    for name in SCRIPTS {
        script.push_str(&part(&format!("{name}.js"))?);
    }
    script.push_str("})();\n");
    let boot = part("boot.js")?;
    let policy = format!(
        "default-src 'none'; script-src {} {} 'wasm-unsafe-eval' blob:; style-src 'unsafe-inline'; img-src data:; \
         worker-src blob:; base-uri 'none'; form-action 'none'",
        hash(&script),
        hash(&boot)
    );
    // Inside a script element only these two end it; in JSON and in our scripts `<` may be written otherwise.
    let examples = examples.replace('<', "\\u003c");
    let mut out = part("page.html")?;
    for (name, text) in [
        ("policy", policy.as_str()),
        ("style", &part("style.css")?),
        ("worker", &part("worker.js")?),
        ("boot", &boot),
        ("script", &script),
        ("examples", &examples),
        ("module", module),
    ] {
        if name != "module" && (text.contains("</script") || text.contains("<!--")) {
            return Err(format!("`{name}` would end its element").into());
        }
        out = out.replacen(&format!("{{{{{name}}}}}"), text, 1);
    }
    Ok(out)
}

fn folder() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The tables of the example robots, in the order of their list, then those of lectures with their derivations.
fn examples() -> Result<Vec<serde_json::Value>, Box<dyn Error>> {
    let robots = folder().join("../src");
    let list = fs::read_to_string(robots.join("lib.rs"))?;
    let mut found: Vec<(usize, String, String)> = Vec::new();
    for path in files(&robots, "rs")? {
        let text = fs::read_to_string(&path)?;
        let inside = text.split_once("\ndh_robot! {\n").and_then(|(_, call)| call.strip_suffix("\n}\n"));
        let name = stem(&path);
        if let (Some(inside), Some(at)) = (inside, list.find(&format!("    {name} "))) {
            let table = inside.lines().map(|l| format!("{}\n", l.strip_prefix("    ").unwrap_or(l))).collect();
            found.push((at, name, table));
        }
    }
    found.sort();
    let mut out: Vec<serde_json::Value> =
        found.into_iter().map(|(_, id, table)| example("robots", &id, &table)).collect();
    for path in files(&folder().join("../../tests/corpus"), "dh")? {
        out.push(example("lectures", &format!("lecture-{}", stem(&path)), &fs::read_to_string(&path)?));
    }
    if out.len() < 20 {
        return Err("the examples are not where they were".into());
    }
    Ok(out)
}

/// An example by the first sentence of its documentation, or by its name.
fn example(kind: &str, id: &str, table: &str) -> serde_json::Value {
    let first = table.lines().find_map(|line| line.trim().strip_prefix("/// "));
    let name = || table.split_once("struct ").and_then(|(_, rest)| rest.split([';', ' ']).next());
    let title = first.map(|line| line.trim_end_matches(['.', ':'])).or_else(name).unwrap_or(id);
    json!({ "kind": kind, "id": id, "title": title, "table": table })
}

fn files(folder: &Path, extension: &str) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).map_err(|e| format!("{}: {e}", folder.display()))? {
        let path = entry?.path();
        if path.extension().is_some_and(|e| e == extension) {
            all.push(path);
        }
    }
    all.sort();
    Ok(all)
}

fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(String::new, |s| s.to_string_lossy().into_owned())
}

/// How a content policy names a script.
fn hash(script: &str) -> String {
    format!("'sha256-{}'", base64(&Sha256::digest(script.as_bytes())))
}

fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let group = three.iter().fold(0_u32, |g, b| g << 8 | u32::from(*b)) << (8 * (3 - three.len()));
        for k in 0..4 {
            out.push(if k <= three.len() { char::from(LETTERS[(group >> (18 - 6 * k)) as usize & 63]) } else { '=' });
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_of_bytes() {
        for (bytes, letters) in [("", ""), ("M", "TQ=="), ("Ma", "TWE="), ("Man", "TWFu"), ("light w", "bGlnaHQgdw==")]
        {
            assert_eq!(base64(bytes.as_bytes()), letters);
        }
        assert_eq!(hash(""), "'sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU='");
    }

    #[test]
    fn a_page_of_all_parts() {
        let examples = examples().expect("the examples");
        assert!(examples.iter().any(|e| e["id"] == "puma560") && examples.iter().any(|e| e["kind"] == "lectures"));
        let page = html("TQ==", "[\"</script>\"]").expect("a page");
        assert!(!page.contains("{{"), "a part is missing");
        assert!(page.contains("[\"\\u003c/script>\"]"));
    }
}
