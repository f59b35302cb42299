//! The PUMA 560 at work: pose, Jacobian and all solutions of its inverse in numbers, and its pose as formulas.
//!
//! `cargo run -p generated-examples --example puma560`

#![allow(clippy::print_stdout)] // an example shows its results

use dh_robot::nalgebra::IsometryMatrix3;
use dh_symbolic::chain::{Chain, table};
use dh_symbolic::kinematics::Kinematics;
use dh_symbolic::render::rustdoc;
use generated_examples::puma560::Puma560;
use generated_examples::source;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let robot = Puma560::default();
    let q = [20.0, -40.0, 30.0, 15.0, 60.0, -75.0_f64].map(f64::to_radians);
    println!("q = (20, -40, 30, 15, 60, -75) degrees");
    println!("pose of the last frame:{:.6}", robot.forward(&q).to_homogeneous());
    println!("Jacobian:{:.4}", robot.jacobian(&q));
    println!("all joint vectors (radians) that reach this pose:\n{}\n", robot.inverse(&robot.forward(&q)));
    let far = robot.inverse(&IsometryMatrix3::translation(1.2, 0.3, 0.2));
    println!("1.2 m away: {} solutions, since {}\n", far.len(), far.why());

    let table = source::all()?.into_iter().find(|source| source.module == "puma560").ok_or("no PUMA 560")?;
    let spec = table::parse(table.body.parse()?).spec.ok_or("the table is not in order")?;
    let chain = Chain::new(spec);
    println!("{}", rustdoc(&chain, &Kinematics::new(&chain)).replace("```text\n", "").replace("```\n", ""));
    Ok(())
}
