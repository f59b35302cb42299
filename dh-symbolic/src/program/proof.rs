//! Proof by normal forms that a program computes the product of link transforms: its outputs are expanded back into the algebra.

use super::Program;
use super::fold::Arithmetic;
use crate::algebra::{LinearAngle, Poly, Symbol, Transform};
use crate::chain::Chain;
use crate::kinematics::{Kinematics, jacobian};
use std::fmt;

/// An output that differs from the exact formula.
#[derive(Clone, Debug)]
pub struct Disproof {
    /// Which output.
    pub output: String,
    /// The difference, program minus truth, where it was written out.
    pub difference: Option<Poly>,
}

impl fmt::Display for Disproof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the program's {} differs from the product of the link transforms", self.output)
    }
}

/// Polynomials.
struct Polynomials;

impl Arithmetic for Polynomials {
    type Number = Poly;

    fn zero(&mut self) -> Poly {
        Poly::zero()
    }

    fn constant(&mut self, p: &Poly) -> Poly {
        p.clone()
    }

    fn symbol(&mut self, s: Symbol) -> Poly {
        Poly::symbol(s)
    }

    fn harmonic(&mut self, _: usize, angle: &LinearAngle, sine: bool) -> Poly {
        angle.cos_sin().map(|(c, s)| if sine { s } else { c }).unwrap_or_default()
    }

    fn negative(&mut self, a: Poly) -> Poly {
        -&a
    }

    fn add(&mut self, a: Poly, b: Poly) -> Poly {
        &a + &b
    }

    fn multiply(&mut self, a: Poly, b: Poly) -> Poly {
        &a * &b
    }
}

impl Program {
    /// The outputs as polynomials.
    pub fn expand(&self) -> Vec<Poly> {
        self.graph.fold(&self.outputs, &mut Polynomials)
    }
}

/// An output, by its place.
fn place(k: usize, name: &str) -> String {
    format!("entry ({}, {}) of {name}", k % 3 + 1, k / 3 + 1)
}

fn compare(got: &Poly, want: &Poly, output: impl Fn() -> String) -> Result<(), Disproof> {
    if got == want { Ok(()) } else { Err(Disproof { output: output(), difference: Some(got - want) }) }
}

fn compare_pose(got: &[Poly], want: &Transform, name: &str) -> Result<(), Disproof> {
    for k in 0..12 {
        let got = got.get(k).cloned().unwrap_or_default();
        compare(&got, &want.entry(k % 3, k / 3), || place(k, name))?;
    }
    Ok(())
}

/// The 12 outputs are the pose, by normal forms.
///
/// # Errors
/// The first output that differs.
pub fn prove_pose(program: &Program, kinematics: &Kinematics) -> Result<(), Disproof> {
    compare_pose(&program.expand(), &kinematics.pose(), "the pose")
}

/// The outputs are all frames, by normal forms.
///
/// # Errors
/// The first output that differs.
pub fn prove_frames(program: &Program, kinematics: &Kinematics) -> Result<(), Disproof> {
    let got = program.expand();
    let mut t = kinematics.base().clone();
    for i in 0..kinematics.len() {
        if let Some(link) = kinematics.link(i + 1) {
            t = t.times(link);
        }
        compare_pose(got.get(12 * i..).unwrap_or(&[]), &t, &format!("frame {}", i + 1))?;
    }
    Ok(())
}

/// The outputs are pose and Jacobian, by normal forms.
///
/// # Errors
/// The first output that differs.
pub fn prove_jacobian(program: &Program, chain: &Chain, kinematics: &Kinematics) -> Result<(), Disproof> {
    let got = program.expand();
    compare_pose(&got, &kinematics.pose(), "the pose beside the Jacobian")?;
    let columns = jacobian(chain, kinematics);
    for actuator in 0..chain.dof() {
        for row in 0..6 {
            let entry = |joint: usize| if row < 3 { &columns[joint].0[row] } else { &columns[joint].1[row - 3] };
            let want = if chain.is_direct() {
                entry(actuator).clone()
            } else {
                (0..chain.dof()).map(|joint| entry(joint) * &chain.drive[joint][actuator]).sum()
            };
            let got = got.get(12 + 6 * actuator + row).cloned().unwrap_or_default();
            compare(&got, &want, || format!("Jacobian entry ({}, {})", row + 1, actuator + 1))?;
        }
    }
    Ok(())
}
