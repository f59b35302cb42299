//! How long the macro takes for each example robot, in the build that macros run in: `cargo run -p generated-examples --example
//! expansion_time` (without `--release`: compilers build macros unoptimised).

#![allow(clippy::print_stdout)] // an example shows its results

use std::hint::black_box;
use std::time::Instant;

use dh_symbolic::chain::{Chain, table};
use dh_symbolic::program::Forward;
use generated_examples::source;
use proc_macro2::TokenStream;

const REPETITIONS: usize = 5;

/// Median of some runs, in milliseconds.
fn milliseconds(mut run: impl FnMut()) -> f64 {
    let mut times: Vec<f64> = (0..REPETITIONS)
        .map(|_| {
            let start = Instant::now();
            run();
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[REPETITIONS / 2]
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    if !cfg!(debug_assertions) {
        println!("note: this build is optimised; macros are not");
    }
    println!("{:18} {:>20} {:>12}", "", "FK, J and proof", "all");
    for source in source::all()? {
        let tokens: TokenStream = source.body.parse()?;
        let spec = table::parse(tokens.clone()).spec.ok_or("a table is not in order")?;
        let chain = Chain::new(spec);
        let forward = milliseconds(|| drop(black_box(Forward::derive(&chain))));
        let all = milliseconds(|| drop(black_box(dh_symbolic::expand(tokens.clone()))));
        println!("{:18} {forward:17.1} ms {all:9.1} ms", source.module);
    }
    Ok(())
}
