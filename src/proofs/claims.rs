//! What is claimed of an equation, and how a claim is checked over a box.

use super::bisection::{Proof, Ranges, divide, prove};
use super::boxes::{Scale, whole};
use crate::golden::samples;
use veridem_spec::Real;
use veridem_spec::document::{Document, Quantity};
use veridem_spec::equation::Equation;
use veridem_spec::numbers::{Dual, Interval, Rounded, Slope, Trouble};

/// A claim about an equation.
#[derive(Clone, Debug, PartialEq)]
pub enum Claim {
    /// Every result is finite: no denominator vanishes, no root or logarithm is without a value, nothing overflows.
    Finite,
    /// A number that comes out has this sign.
    Sign(usize, Sign),
    /// A number that comes out does not fall as an argument grows, or does not rise.
    Monotonic {
        /// The number that comes out.
        result: usize,
        /// The number that goes in.
        argument: usize,
        /// Whether it rises.
        rises: bool,
    },
    /// The rounding error is within a bound, in units of the last place.
    Rounding(f64),
}

/// The sign of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Above zero.
    Positive,
    /// Not below zero.
    NotNegative,
    /// Below zero.
    Negative,
    /// Not above zero.
    NotPositive,
}

impl Sign {
    /// As a comparison with zero.
    pub fn text(self) -> &'static str {
        match self {
            Self::Positive => "> 0",
            Self::NotNegative => ">= 0",
            Self::Negative => "< 0",
            Self::NotPositive => "<= 0",
        }
    }
    /// With zero.
    pub(super) fn weak(self) -> Self {
        match self {
            Self::Positive | Self::NotNegative => Self::NotNegative,
            Self::Negative | Self::NotPositive => Self::NotPositive,
        }
    }
    fn of(values: impl Iterator<Item = f64> + Clone) -> Option<Self> {
        let all = |holds: fn(f64) -> bool| values.clone().all(holds);
        [
            (Self::Positive, all(|x| x > 0.0)),
            (Self::Negative, all(|x| x < 0.0)),
            (Self::NotNegative, all(|x| x >= 0.0)),
            (Self::NotPositive, all(|x| x <= 0.0)),
        ]
        .into_iter()
        .find_map(|(sign, holds)| holds.then_some(sign))
    }
    fn holds(self, x: Interval) -> bool {
        match self {
            Self::Positive => x.lo > 0.0,
            Self::NotNegative => x.lo >= 0.0,
            Self::Negative => x.hi < 0.0,
            Self::NotPositive => x.hi <= 0.0,
        }
    }
}

/// Random inputs from which signs and monotonicity are conjectured.
const SAMPLES: usize = 300;

/// The claims about an equation: finite, its stated rounding, and the signs and monotonicity of scalar results that no sample contradicts.
pub fn claims(equation: &Equation, document: &Document) -> Vec<Claim> {
    let mut claims = vec![Claim::Finite];
    let inputs: Vec<Vec<f64>> = samples(equation, document, SAMPLES).into_iter().map(|sample| sample.numbers).collect();
    let outputs: Vec<Vec<f64>> = inputs.iter().map(|numbers| (equation.eval.f64)(numbers)).collect();
    let scalars = |quantities: &[Quantity]| {
        let mut at = 0;
        let places = quantities.iter().map(|q| {
            at += q.size;
            (q.size == 1).then_some(at - 1)
        });
        places.flatten().collect::<Vec<usize>>()
    };
    let (arguments, results) = (scalars(&document.arguments), scalars(&document.results));
    for &result in &results {
        if outputs.iter().any(|out| out[result] != 0.0) {
            claims.extend(Sign::of(outputs.iter().map(|out| out[result])).map(|sign| Claim::Sign(result, sign)));
        }
    }
    for &argument in &arguments {
        let slopes: Vec<Vec<f64>> = inputs
            .iter()
            .map(|numbers| {
                let mut duals: Vec<Dual> = numbers.iter().map(|x| Dual::constant(*x)).collect();
                duals[argument] = Dual::variable(numbers[argument]);
                (equation.eval.dual)(&duals).into_iter().map(|y| y.slope).collect()
            })
            .collect();
        for &result in &results {
            let of_result = || slopes.iter().map(|slopes| slopes[result]);
            let rises = of_result().all(|slope| slope >= 0.0);
            if (rises || of_result().all(|slope| slope <= 0.0)) && of_result().any(|slope| slope != 0.0) {
                claims.push(Claim::Monotonic { result, argument, rises });
            }
        }
    }
    claims.extend(document.rounding.map(Claim::Rounding));
    claims
}

/// Tries to prove a claim with at most `budget` checks.
pub fn attempt(equation: &Equation, document: &Document, claim: &Claim, scale: Scale, budget: usize) -> Proof {
    let euler = conditioning(document);
    let check = |part: &[Interval]| match *claim {
        Claim::Finite => finite(equation, part).map(|_| ()),
        Claim::Sign(result, sign) => {
            let number = finite(equation, part)?[result];
            let (exact, computed) = (number.exact(), number.computed());
            if sign.holds(exact) && sign.holds(computed) {
                Ok(())
            } else {
                Err(format!("it may be anything from {:e} to {:e}", exact.lo, exact.hi))
            }
        }
        Claim::Monotonic { result, argument, rises } => {
            let slope = slopes(equation, part, argument)[result].slope;
            let holds = if rises { slope.lo >= 0.0 } else { slope.hi <= 0.0 };
            if holds { Ok(()) } else { Err(format!("its slope may be anything from {:e} to {:e}", slope.lo, slope.hi)) }
        }
        Claim::Rounding(ulps) => rounding(equation, part, ulps, &euler),
    };
    prove(whole(document, scale), budget, check)
}

/// Parts into which a box is divided for an enclosure of results.
const PARTS: usize = 1024;

/// Intervals that contain the exact results and those of `f64` for all arguments in a box.
///
/// # Errors
///
/// If a result may not be finite there.
pub fn enclosure(equation: &Equation, ranges: Ranges) -> Result<Vec<Interval>, String> {
    let parts = divide(ranges, PARTS);
    let mut all: Option<Vec<Interval>> = None;
    for part in &parts {
        let results = finite(equation, part)?.into_iter().map(|y| y.exact().hull(y.computed()));
        all = Some(match all {
            Some(all) => all.into_iter().zip(results).map(|(a, b)| a.hull(b)).collect(),
            None => results.collect(),
        });
    }
    Ok(all.unwrap_or_default())
}

fn rounded(equation: &Equation, part: &[Interval]) -> Vec<Rounded> {
    let inputs: Vec<Rounded> = part.iter().enumerate().map(|(k, x)| Rounded::input(k, *x)).collect();
    (equation.eval.rounded)(&inputs)
}

fn slopes(equation: &Equation, part: &[Interval], argument: usize) -> Vec<Slope> {
    let mut inputs: Vec<Slope> = part.iter().map(|x| Slope::constant(*x)).collect();
    inputs[argument] = Slope::variable(part[argument]);
    (equation.eval.slope)(&inputs)
}

fn finite(equation: &Equation, part: &[Interval]) -> Result<Vec<Rounded>, String> {
    let results = rounded(equation, part);
    match results.iter().find_map(|y| y.trouble()) {
        Some(Trouble::Denominator) => Err("a denominator may be zero".into()),
        Some(Trouble::Domain) => Err("a root, a logarithm or an inverse cosine may have no value".into()),
        Some(Trouble::Overflow) => Err("a number may be too large".into()),
        None => Ok(results),
    }
}

/// What is left of an error beside roundings counts as nothing below this part of a rounding of the largest result in a box,
const NOTHING: f64 = 1e-6;
/// or below this number, where results underflow.
const TINY: f64 = 1e-300;

/// Whether every number that comes out has an error of at most `stated` units of the last place.
fn rounding(equation: &Equation, part: &[Interval], stated: f64, euler: &[f64]) -> Result<(), String> {
    let results = finite(equation, part)?;
    let size = |x: Interval| x.lo.abs().max(x.hi.abs());
    let open: Vec<usize> = (0..results.len())
        .filter(|k| {
            let ulps = results[*k].ulps(euler[*k]);
            let rest = ulps.rest <= TINY.max(NOTHING * f64::EPSILON * size(results[*k].exact()));
            !(rest && ulps.first_order <= stated)
        })
        .collect();
    if open.is_empty() {
        return Ok(());
    }
    // what the inputs, each rounded once, do to it at the least
    let mut inputs = vec![0.0; results.len()];
    for (argument, x) in part.iter().enumerate() {
        let smallest = Real::abs(*x).lo;
        if smallest > 0.0 {
            for (sum, y) in inputs.iter_mut().zip(slopes(equation, part, argument)) {
                *sum += smallest * Real::abs(y.slope).lo * (1.0 - f64::EPSILON);
            }
        }
    }
    for k in open {
        let exact = results[k].exact();
        let conditioned = (inputs[k] / size(exact) * (1.0 - 1e-14)).max(euler[k]);
        let ulps = results[k].ulps(if conditioned.is_finite() { conditioned } else { euler[k] });
        let at_least = (Real::abs(exact).lo + inputs[k]) * (1.0 - 1e-13);
        let by_shares = ulps.first_order + ulps.rest / (f64::EPSILON * at_least);
        let by_size = results[k].error() / (f64::EPSILON * at_least) * (1.0 + 1e-14);
        let found = by_shares.min(by_size);
        if found.is_nan() || found > stated {
            return Err(format!("the error may be {:.3} ULP", found));
        }
    }
    Ok(())
}

/// Lower bounds of `sum_k |x_k df/dx_k|` over `|f|` from the units alone: Euler's theorem, as every equation is homogeneous in
/// the units of mass, length and time.
fn conditioning(document: &Document) -> Vec<f64> {
    let powers = |direction: [f64; 3], q: &Quantity| -> f64 {
        direction.iter().zip(q.exponents).map(|(along, quarters)| along * f64::from(quarters)).sum()
    };
    const STEPS: [f64; 5] = [-2.0, -1.0, 0.0, 1.0, 2.0];
    let pairs = STEPS.iter().flat_map(|a| STEPS.map(|b| [*a, b]));
    let directions: Vec<[f64; 3]> = pairs.flat_map(|[a, b]| STEPS.map(|c| [a, b, c])).collect();
    let bound = |result: &Quantity| {
        let ratio = |direction: &[f64; 3]| {
            let most = document.arguments.iter().map(|q| powers(*direction, q).abs()).fold(0.0, f64::max);
            if most > 0.0 { powers(*direction, result).abs() / most } else { 0.0 }
        };
        directions.iter().map(ratio).fold(0.0, f64::max) * (1.0 - 1e-15)
    };
    document.results.iter().flat_map(|result| std::iter::repeat_n(bound(result), result.size)).collect()
}

/// The parts of a box, by the names of the arguments.
pub fn described(document: &Document, part: &Ranges) -> String {
    let mut rest = part.as_slice();
    let mut text = vec![];
    for quantity in &document.arguments {
        let (numbers, after) = rest.split_at(quantity.size);
        rest = after;
        let ranges: Vec<String> = numbers.iter().map(|x| range_text(*x)).collect();
        text.push(format!("{} = {}", quantity.name, ranges.join(", ")));
    }
    text.join("; ")
}

fn range_text(x: Interval) -> String {
    if x.lo == x.hi { format!("{}", x.lo) } else { format!("{:.6e} .. {:.6e}", x.lo, x.hi) }
}
