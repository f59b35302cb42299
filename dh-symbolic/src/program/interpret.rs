//! Interprets a program in `f64`: an independent check in tests, and the numbers of worked examples.

use super::Program;
use super::fold::Arithmetic;
use crate::algebra::{LinearAngle, Point, Poly, Symbol};

/// Values of the inputs.
pub type Inputs<'a> = Point<'a>;

impl Program {
    /// The outputs at a point.
    pub fn run(&self, at: &Inputs<'_>) -> Vec<f64> {
        self.graph.fold(&self.outputs, &mut Floats(at))
    }
}

/// `f64`, at a point.
pub(super) struct Floats<'a, 'b>(pub(super) &'a Point<'b>);

impl Arithmetic for Floats<'_, '_> {
    type Number = f64;

    fn zero(&mut self) -> f64 {
        0.0
    }

    fn constant(&mut self, p: &Poly) -> f64 {
        p.evaluate(self.0)
    }

    fn symbol(&mut self, s: Symbol) -> f64 {
        (self.0.symbol)(s)
    }

    fn harmonic(&mut self, _: usize, angle: &LinearAngle, sine: bool) -> f64 {
        let terms = angle.terms.iter().map(|(v, k)| f64::from(*k) * (self.0.angle)(*v)).sum::<f64>();
        let x = terms + angle.constant.radians();
        if sine { x.sin() } else { x.cos() }
    }

    fn negative(&mut self, a: f64) -> f64 {
        -a
    }

    fn add(&mut self, a: f64, b: f64) -> f64 {
        a + b
    }

    fn multiply(&mut self, a: f64, b: f64) -> f64 {
        a * b
    }
}
