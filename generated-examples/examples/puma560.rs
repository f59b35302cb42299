//! The PUMA 560 from its table: pose, Jacobian and all solutions of its inverse in numbers, its pose as formulas, and the inverse as lecture notes.
//!
//! `cargo run -p generated-examples --example puma560`

#![allow(clippy::print_stdout)] // an example shows its results

use dh_robot::nalgebra::IsometryMatrix3;
use dh_symbolic::{NotesOptions, Robot};
use generated_examples::puma560::Puma560;
use generated_examples::source;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // What the macro left behind, in numbers.
    let robot = Puma560::default();
    let q = [20.0, -40.0, 30.0, 15.0, 60.0, -75.0_f64].map(f64::to_radians);
    println!("q = (20, -40, 30, 15, 60, -75) degrees");
    println!("pose of the last frame:{:.6}", robot.forward(&q).to_homogeneous());
    println!("Jacobian:{:.4}", robot.jacobian(&q));
    println!("all joint vectors (radians) that reach this pose:\n{}\n", robot.inverse(&robot.forward(&q)));
    let far = robot.inverse(&IsometryMatrix3::translation(1.2, 0.3, 0.2));
    println!("1.2 m away: {} solutions, since {}\n", far.len(), far.why());

    // The same table on paper.
    let source = source::all()?.into_iter().find(|source| source.module == "puma560").ok_or("no PUMA 560")?;
    let puma = Robot::parse(&source.body)?;
    println!("{}\n", puma.transform(0, 6));
    let mut options = NotesOptions::default();
    options.set("--parts", "inverse")?;
    println!("{}", puma.notes(&options));
    Ok(())
}
