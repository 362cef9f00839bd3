//! Inputs of an equation, chosen inside the domains of its table: the same on every machine.

use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use sha2::{Digest, Sha256};
use veridem_spec::Real;
use veridem_spec::document::{Document, Domain, Quantity};
use veridem_spec::equation::Equation;
use veridem_spec::numbers::Reference;

/// Inputs of an equation and why they were chosen.
pub struct Sample {
    /// `sampled`, `equal`, `edge` or `zero`.
    pub flag: &'static str,
    /// The arguments, laid end to end.
    pub numbers: Vec<f64>,
}

/// Inputs of an equation: `count` drawn at random, then some where arguments are equal, at the edge of their domain, or zero.
/// All numbers are of the order of one, so that every comparison in an equation goes both ways.
pub fn samples(equation: &Equation, document: &Document, count: usize) -> Vec<Sample> {
    let mut random = ChaCha12Rng::from_seed(Sha256::digest(equation.id).into());
    let mut draw = || -> Vec<Vec<f64>> { document.arguments.iter().map(|q| quantity(q, &mut random)).collect() };
    let mut out = Vec::new();
    let mut keep = |flag, arguments: &[Vec<f64>]| {
        let inside = document.arguments.iter().zip(arguments).all(|(q, values)| q.domain.contains(values));
        let numbers = arguments.concat();
        if inside && has_value(equation, &numbers) {
            out.push(Sample { flag, numbers });
            true
        } else {
            false
        }
    };
    // where a table cannot say all of the domain, such as `a < b`, some draws have no value
    let mut missing = count;
    for _ in 0..20 * count {
        if missing > 0 && keep("sampled", &draw()) {
            missing -= 1;
        }
    }
    for k in 0..document.arguments.len() {
        let mut same = draw();
        if k > 0 {
            let like = |a: &Quantity, b: &Quantity| a.exponents == b.exponents && a.size == b.size;
            if let Some(other) = (0..k).rev().find(|j| like(&document.arguments[*j], &document.arguments[k])) {
                same[k] = same[other].clone();
                keep("equal", &same);
            }
        }
        for edge in edges(&document.arguments[k].domain) {
            let mut at_edge = draw();
            at_edge[k].fill(edge);
            keep(if edge == 0.0 { "zero" } else { "edge" }, &at_edge);
        }
    }
    out
}

/// Whether the equation has a value there: not every domain can be written in a table. Whether it is found in `f64` does not matter.
fn has_value(equation: &Equation, numbers: &[f64]) -> bool {
    let exact: Vec<Reference> = numbers.iter().map(|x| Reference::exact(*x)).collect();
    (equation.eval.reference)(&exact).iter().all(|y| y.to_f64().is_finite())
}

fn quantity(quantity: &Quantity, random: &mut ChaCha12Rng) -> Vec<f64> {
    let mut one = || number(&quantity.domain, random);
    let values: Vec<f64> = (0..quantity.size).map(|_| one()).collect();
    match quantity.domain {
        Domain::Unit => {
            let length = Real::sqrt(values.iter().map(|x| x * x).sum::<f64>());
            values.iter().map(|x| x / length).collect()
        }
        _ => values,
    }
}

/// Widest interval that is filled evenly; a wider one is treated as if it had no upper bound.
const WIDE: f64 = 100.0;

fn number(domain: &Domain, random: &mut ChaCha12Rng) -> f64 {
    let mut uniform = || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
    // 1/8 to 8, as many below one as above
    let size = (1.0 + uniform()) * [0.125, 0.25, 0.5, 1.0, 2.0, 4.0][(6.0 * uniform()) as usize];
    match *domain {
        Domain::Between { lo, hi, .. } if lo.is_finite() && hi - lo <= WIDE => lo + uniform() * (hi - lo),
        Domain::Between { lo, .. } if lo.is_finite() => lo + size,
        Domain::Between { hi, .. } if hi.is_finite() => hi - size,
        _ => {
            if uniform() < 0.5 {
                -size
            } else {
                size
            }
        }
    }
}

/// The bounds that belong to a domain, and zero.
fn edges(domain: &Domain) -> Vec<f64> {
    match *domain {
        Domain::Unit => vec![],
        Domain::Between { lo, hi, .. } => {
            let mut edges = vec![lo, hi, 0.0];
            edges.retain(|edge| edge.abs() <= WIDE && domain.contains(&[*edge]));
            edges.dedup();
            edges
        }
    }
}
