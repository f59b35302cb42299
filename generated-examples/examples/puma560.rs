//! The PUMA 560 at work: the pose and the Jacobian at some joint angles, and its pose as formulas.
//!
//! `cargo run -p generated-examples --example puma560`

#![allow(clippy::print_stdout)] // an example shows its results

use dh_symbolic::chain::{Chain, table};
use dh_symbolic::kinematics::Kinematics;
use generated_examples::puma560::Puma560;
use generated_examples::source;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let robot = Puma560::default();
    let q = [20.0, -40.0, 30.0, 15.0, 60.0, -75.0_f64].map(f64::to_radians);
    println!("q = (20, -40, 30, 15, 60, -75) degrees");
    println!("pose of the last frame:{:.6}", robot.forward(&q).to_homogeneous());
    println!("Jacobian:{:.4}", robot.jacobian(&q));

    let table = source::all()?.into_iter().find(|source| source.module == "puma560").ok_or("no PUMA 560")?;
    let spec = table::parse(table.body.parse()?).spec.ok_or("the table is not in order")?;
    let chain = Chain::new(spec);
    let pose = Kinematics::new(&chain).pose();
    for (k, name) in
        ["r11", "r21", "r31", "r12", "r22", "r32", "r13", "r23", "r33", "px", "py", "pz"].iter().enumerate()
    {
        println!("{name} = {}", chain.ring.text(&pose.entry(k % 3, k / 3)));
    }
    Ok(())
}
