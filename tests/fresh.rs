//! The committed expansions are what the macro makes today. (`cargo regen --check` looks at the notes as well.)

use dh_symbolic::pipeline::compile;
use dh_symbolic::render::code::rust::pretty;
use generated_examples::source;

#[test]
fn expanded_files_are_up_to_date() {
    for source in source::all().expect("the examples can be read") {
        let (items, _) = compile(source.body.parse().expect("it lexes"));
        let text = pretty(items).expect("items");
        let path = source::folder().join(format!("expanded/{}.rs", source.module));
        let committed = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(committed.ends_with(&text), "{} is stale: run `cargo regen`", path.display());
    }
}
