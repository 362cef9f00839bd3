//! Inputs of an equation, chosen inside the domains of its table: the same on every machine.

use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use sha2::{Digest, Sha256};
use veridem_spec::Real;
use veridem_spec::document::{Document, Domain, Quantity};
use veridem_spec::equation::Equation;
use veridem_spec::numbers::Reference;
use veridem_spec::unit::WHOLE;

/// Inputs of an equation and why they were chosen.
pub struct Sample {
    /// `sampled`, `equal`, `edge`, `zero`, `small` or `near`.
    pub flag: &'static str,
    /// The arguments, laid end to end.
    pub numbers: Vec<f64>,
    /// The results, with many digits.
    pub exact: Vec<Reference>,
}

/// Inputs of an equation: `count` drawn at random, then some where arguments are equal, at the edge of their domain, or zero. All these numbers are of
/// the order of one, so that every comparison in an equation goes both ways. Then half as many of the magnitudes of the papers in SI units, and as many with arguments
/// near the ends of their domains.
pub fn samples(equation: &Equation, document: &Document, count: usize) -> Vec<Sample> {
    let mut random = ChaCha12Rng::from_seed(Sha256::digest(equation.id).into());
    let mut draw =
        |manner| -> Vec<Vec<f64>> { document.arguments.iter().map(|q| quantity(q, manner, &mut random)).collect() };
    let mut out = Vec::new();
    let mut keep = |flag, arguments: &[Vec<f64>]| {
        let inside = document.arguments.iter().zip(arguments).all(|(q, values)| q.domain.contains(values));
        let numbers = arguments.concat();
        let exact = if inside { value(equation, &numbers) } else { None };
        let found = exact.map(|exact| out.push(Sample { flag, numbers, exact }));
        found.is_some()
    };
    // where a table cannot say all of the domain, such as `a < b`, some draws have no value
    let mut missing = count;
    for _ in 0..20 * count {
        if missing > 0 && keep("sampled", &draw(Manner::One)) {
            missing -= 1;
        }
    }
    for k in 0..document.arguments.len() {
        let mut same = draw(Manner::One);
        if k > 0 {
            let like = |a: &Quantity, b: &Quantity| a.exponents == b.exponents && a.size == b.size;
            if let Some(other) = (0..k).rev().find(|j| like(&document.arguments[*j], &document.arguments[k])) {
                same[k] = same[other].clone();
                keep("equal", &same);
            }
        }
        for edge in edges(&document.arguments[k].domain) {
            let mut at_edge = draw(Manner::One);
            at_edge[k].fill(edge);
            keep(if edge == 0.0 { "zero" } else { "edge" }, &at_edge);
        }
    }
    for (flag, manner) in [("small", Manner::Small), ("near", Manner::Near)] {
        let mut missing = count / 2;
        for _ in 0..20 * count {
            if missing > 0 && keep(flag, &draw(manner)) {
                missing -= 1;
            }
        }
    }
    out
}

/// The results of an equation, with many digits.
pub(super) fn exact(equation: &Equation, numbers: &[f64]) -> Vec<Reference> {
    (equation.eval.reference)(&numbers.iter().map(|x| Reference::exact(*x)).collect::<Vec<_>>())
}

/// The value of the equation, if it has one there: not every domain can be written in a table. Whether it is found in `f64` does not matter.
fn value(equation: &Equation, numbers: &[f64]) -> Option<Vec<Reference>> {
    let exact = exact(equation, numbers);
    exact.iter().all(|y| y.to_f64().is_finite()).then_some(exact)
}

/// How numbers are drawn.
#[derive(Clone, Copy, PartialEq)]
enum Manner {
    /// Of the order of one.
    One,
    /// Of the order of the papers' quantities in SI units.
    Small,
    /// Of the order of one, but every second one near a bound of its domain.
    Near,
}

/// Powers of two for kilogram, metre and second: 5e-20 kg, 4 nm and 0.2 ns, hence 4 nN, 0.3 GPa and 1e-17 J.
const SMALL: [i32; 3] = [-64, -28, -32];

fn quantity(quantity: &Quantity, manner: Manner, random: &mut ChaCha12Rng) -> Vec<f64> {
    let unit: i32 =
        quantity.exponents.iter().zip(SMALL).map(|(power, two)| i32::from(*power) * two / i32::from(WHOLE)).sum();
    // as many above as below, by a factor of sixteen at the most
    let two = if manner == Manner::Small && unit != 0 { unit - 4 + below(9, random) } else { 0 };
    let mut one = || match manner {
        Manner::One | Manner::Small => number(&quantity.domain, two, random),
        Manner::Near => near(&quantity.domain, random),
    };
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

fn uniform(random: &mut ChaCha12Rng) -> f64 {
    (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}

/// A whole number from 0 to `count - 1`.
fn below(count: i32, random: &mut ChaCha12Rng) -> i32 {
    (f64::from(count) * uniform(random)) as i32
}

/// A number of a domain; where it is not bounded on both sides, of the order of two to the power `two`, counted from the bound.
fn number(domain: &Domain, two: i32, random: &mut ChaCha12Rng) -> f64 {
    // 1/8 to 8, as many below one as above
    let size = (1.0 + uniform(random)) * [0.125, 0.25, 0.5, 1.0, 2.0, 4.0][below(6, random) as usize];
    let size = libm::ldexp(size, two);
    match *domain {
        Domain::Between { lo, hi, .. } if lo.is_finite() && hi - lo <= WIDE => lo + uniform(random) * (hi - lo),
        Domain::Between { lo, .. } if lo.is_finite() => lo + size,
        Domain::Between { hi, .. } if hi.is_finite() => hi - size,
        _ => {
            if uniform(random) < 0.5 {
                -size
            } else {
                size
            }
        }
    }
}

/// Powers of two between a number near an end of its domain and that end: 1e-3 to 1e-12.
const NEAR: [i32; 2] = [10, 40];

/// A number of a domain, every second time near a bound if there is one.
fn near(domain: &Domain, random: &mut ChaCha12Rng) -> f64 {
    let two = NEAR[0] + below(NEAR[1] - NEAR[0], random);
    match (below(4, random), *domain) {
        (0, Domain::Between { lo, hi, .. }) if lo.abs() <= WIDE => lo + libm::ldexp((hi - lo).min(1.0), -two),
        (1, Domain::Between { lo, hi, .. }) if hi.abs() <= WIDE => hi - libm::ldexp((hi - lo).min(1.0), -two),
        _ => number(domain, 0, random),
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
