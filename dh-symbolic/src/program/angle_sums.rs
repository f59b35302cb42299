//! Angle-sum sharing: computes sines and cosines of angle sums from those that are computed anyway.
//!
//! Where u and v are needed, the sine and cosine of u + v cost four multiplications and two additions instead of a call; v may
//! be a constant, as between a frame and one that is fixed to it at 30 degrees.

use super::fold::Arithmetic;
use super::graph::{Graph, Node, Value, ZERO};
use super::{Cost, Program};
use crate::algebra::{Angle, LinearAngle, Poly, Rational, Symbol};

/// How the sine and cosine of a angle_sum are put together.
#[derive(Clone, Debug)]
enum Recipe {
    /// A angle_sum plus a constant with exact sine.
    Shifted(usize, LinearAngle),
    /// A angle_sum plus (or minus) another.
    Sum(usize, usize, bool),
}

impl Program {
    /// The same program with the sines of sums shared, where that is cheaper.
    pub(super) fn share_angle_sums(self) -> Program {
        let recipes = recipes(&self.graph, &self.graph.live(&self.outputs));
        if recipes.iter().all(Option::is_none) {
            return self;
        }
        let (graph, moved) = rewritten(&self.graph, &self.outputs, &recipes);
        let outputs = self.outputs.iter().map(|v| signed(moved[v.node as usize], v.negative)).collect();
        let shared = Program { graph, outputs };
        let weight = |p: &Program| Cost::of(&p.graph, &p.outputs).weight();
        if weight(&shared) < weight(&self) { shared } else { self }
    }
}

/// A recipe for every angle_sum that is the sum of two others, or another one and a constant. No ingredient has a recipe itself.
fn recipes(graph: &Graph, live: &[bool]) -> Vec<Option<Recipe>> {
    let angle_sums = graph.angle_sums();
    let mut needed = vec![false; angle_sums.len()];
    for (node, _) in graph.nodes().iter().zip(live).filter(|(_, live)| **live) {
        if let Node::Cos(w) | Node::Sin(w) = node {
            needed[*w as usize] = true;
        }
    }
    let mut recipes: Vec<Option<Recipe>> = vec![None; angle_sums.len()];
    let mut ingredient = vec![false; angle_sums.len()];
    // Long sums first, since they are made of short ones.
    let mut order: Vec<usize> = (0..angle_sums.len()).filter(|w| needed[*w]).collect();
    order.sort_by_key(|w| std::cmp::Reverse((angle_sums[*w].terms.len(), !angle_sums[*w].constant.is_zero(), *w)));
    for &w in order.iter().filter(|w| !angle_sums[**w].terms.is_empty()) {
        if ingredient[w] {
            continue;
        }
        let usable = |u: &&usize| **u != w && recipes[**u].is_none();
        let found = order.iter().filter(usable).find_map(|&u| {
            let rest = sum(&angle_sums[w], &angle_sums[u], -1);
            if rest.terms.is_empty() {
                return rest.constant.steps_of_15_degrees().is_some().then_some(Recipe::Shifted(u, rest));
            }
            let opposite = sum(&LinearAngle::constant(Angle::ZERO), &rest, -1);
            order.iter().filter(usable).filter(|v| **v != u).find_map(|&v| {
                (angle_sums[v] == rest || angle_sums[v] == opposite).then_some(Recipe::Sum(
                    u,
                    v,
                    angle_sums[v] == opposite,
                ))
            })
        });
        match found {
            Some(Recipe::Shifted(u, _)) => ingredient[u] = true,
            Some(Recipe::Sum(u, v, _)) => (ingredient[u], ingredient[v]) = (true, true),
            None => {}
        }
        recipes[w] = found;
    }
    recipes
}

/// a + k b, its terms in order.
fn sum(a: &LinearAngle, b: &LinearAngle, k: i8) -> LinearAngle {
    let mut terms = a.terms.clone();
    for (v, n) in &b.terms {
        match terms.iter_mut().find(|t| t.0 == *v) {
            Some(t) => t.1 = t.1.saturating_add(n.saturating_mul(k)),
            None => terms.push((*v, n.saturating_mul(k))),
        }
    }
    terms.retain(|t| t.1 != 0);
    terms.sort_unstable();
    LinearAngle { terms, constant: a.constant.plus(&b.constant.times(&Rational::int(i64::from(k)))) }
}

fn signed(v: Value, negative: bool) -> Value {
    if negative { -v } else { v }
}

/// The same instructions in a new graph, angle sums by their recipes; and where each old node went.
fn rewritten(old: &Graph, outputs: &[Value], recipes: &[Option<Recipe>]) -> (Graph, Vec<Value>) {
    let mut rewriting = Rewriting { g: old.emptied(), old, recipes };
    let moved = old.fold_nodes(outputs, &mut rewriting);
    (rewriting.g, moved)
}

/// Values of a new graph.
struct Rewriting<'a> {
    g: Graph,
    old: &'a Graph,
    recipes: &'a [Option<Recipe>],
}

impl Arithmetic for Rewriting<'_> {
    type Number = Value;

    fn zero(&mut self) -> Value {
        ZERO
    }

    fn constant(&mut self, p: &Poly) -> Value {
        self.g.constant(p.clone())
    }

    fn symbol(&mut self, s: Symbol) -> Value {
        self.g.push(Node::Symbol(s))
    }

    fn harmonic(&mut self, index: usize, _: &LinearAngle, sine: bool) -> Value {
        let (c, s) = pair(&mut self.g, self.old, self.recipes, index as u32);
        if sine { s } else { c }
    }

    fn negative(&mut self, a: Value) -> Value {
        -a
    }

    fn add(&mut self, a: Value, b: Value) -> Value {
        self.g.add(a, b)
    }

    fn multiply(&mut self, a: Value, b: Value) -> Value {
        self.g.mul(a, b)
    }
}

/// (cosine, sine) of a angle_sum.
fn pair(g: &mut Graph, old: &Graph, recipes: &[Option<Recipe>], w: u32) -> (Value, Value) {
    let (u, (cv, sv)) = match &recipes[w as usize] {
        None => return g.cos_sin(&old.angle_sums()[w as usize]),
        Some(Recipe::Shifted(u, constant)) => (*u, g.cos_sin(constant)),
        Some(Recipe::Sum(u, v, minus)) => {
            let (c, s) = g.cos_sin(&old.angle_sums()[*v]);
            (*u, (c, signed(s, *minus)))
        }
    };
    let (cu, su) = g.cos_sin(&old.angle_sums()[u]);
    let (cc, ss) = (g.mul(cu, cv), g.mul(su, sv));
    let (sc, cs) = (g.mul(su, cv), g.mul(cu, sv));
    (g.sub(cc, ss), g.add(sc, cs))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{AngleVar, Ring};
    use crate::chain::Convention;
    use crate::chain::tests::revolute_chain;

    fn angle(terms: &[(AngleVar, i8)], degrees: i64) -> LinearAngle {
        LinearAngle { terms: terms.to_vec(), constant: Angle::degrees(&Rational::int(degrees)) }
    }

    /// A program whose outputs are the cosines and sines of some angles.
    fn program(angles: &[LinearAngle]) -> Program {
        let mut graph = Graph::new(&revolute_chain(Convention::Standard, &[]));
        let outputs = angles.iter().flat_map(|a| <[Value; 2]>::from(graph.cos_sin(a))).collect();
        Program { graph, outputs }
    }

    fn names() -> (AngleVar, AngleVar) {
        let mut ring = Ring::new();
        let a = ring.angle("a");
        (a, ring.angle_parallel_to(a, "b"))
    }

    #[test]
    fn sums_are_shared_and_mean_the_same() {
        let (a, b) = names();
        for (angles, calls) in [
            (vec![angle(&[(a, 1)], 0), angle(&[(b, 1)], 0), angle(&[(a, 1), (b, 1)], 0)], 2),
            (vec![angle(&[(a, 1)], 0), angle(&[(b, 1)], 0), angle(&[(a, 1), (b, -1)], 0)], 2),
            (vec![angle(&[(b, 1)], 0), angle(&[(a, 1), (b, -1)], 0), angle(&[(a, 1)], 0)], 2),
            (vec![angle(&[(a, 1)], 0), angle(&[(a, 1)], 30), angle(&[(a, 1)], -45)], 1),
            (vec![angle(&[(a, 1)], 30), angle(&[(b, 1)], 0), angle(&[(a, 1), (b, 1)], 30)], 2),
        ] {
            let shared = program(&angles).share_angle_sums();
            assert_eq!(Cost::of(&shared.graph, &shared.outputs).sincos, calls, "{angles:?}");
            assert_eq!(shared.expand(), program(&angles).expand(), "{angles:?}");
        }
    }

    #[test]
    fn what_is_not_there_is_not_used() {
        let (a, b) = names();
        let angles = [angle(&[(a, 1)], 0), angle(&[(a, 1), (b, 1)], 0)];
        assert_eq!(program(&angles).share_angle_sums().outputs, program(&angles).outputs);
    }
}
