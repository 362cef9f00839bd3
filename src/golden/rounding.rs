//! The rounding error of an equation in `f64`, measured against 256-bit numbers.

use super::Sample;
use veridem_spec::Real;
use veridem_spec::equation::Equation;
use veridem_spec::numbers::{Dual, Reference};

/// The largest error of an equation over some inputs.
pub struct Rounding {
    /// In units of the last place, as [`error`] defines them.
    pub ulps: f64,
    /// Where it was found: the arguments, laid end to end.
    pub at: Vec<f64>,
}

/// The error of each number that comes out, divided by `eps (|f| + sum_k |x_k df/dx_k|)`: as if the result and each
/// input had been rounded that number of times. Conditioning, which no implementation can help, is thereby divided out, but an
/// infinite derivative excuses nothing, nor does one that is not a number. The error is never NaN: it is infinite where the exact or the
/// rounded result is not finite.
pub fn error(equation: &Equation, numbers: &[f64], out: &[f64], exact: &[Reference], eps: f64) -> Vec<f64> {
    let mut sizes: Vec<f64> = exact.iter().map(|y| y.to_f64().abs()).collect();
    for (k, x) in numbers.iter().enumerate().filter(|(_, x)| **x != 0.0) {
        let mut duals: Vec<Dual> = numbers.iter().map(|x| Dual::constant(*x)).collect();
        duals[k] = Dual::variable(*x);
        for (size, y) in sizes.iter_mut().zip((equation.eval.dual)(&duals)) {
            let change = (x * y.slope).abs();
            *size += if change.is_finite() { change } else { 0.0 };
        }
    }
    let ulps = |((y, exact), size): ((&f64, &Reference), f64)| {
        if !y.is_finite() || !exact.to_f64().is_finite() {
            return f64::INFINITY;
        }
        let error = (Reference::exact(*y) - *exact).abs().to_f64();
        // where numbers are so small that they lose digits, half of the smallest is an error of one half
        if error == 0.0 { 0.0 } else { error / (eps * size).max(f64::from_bits(1)) }
    };
    out.iter().zip(exact).zip(sizes).map(ulps).collect()
}

/// The largest error of an equation in `f64` over the given samples.
pub fn measure(equation: &Equation, samples: &[Sample]) -> Rounding {
    let mut worst = Rounding { ulps: 0.0, at: vec![] };
    for Sample { numbers, exact, .. } in samples {
        let out = (equation.eval.f64)(numbers);
        let ulps = error(equation, numbers, &out, exact, f64::EPSILON).into_iter().fold(0.0, f64::max);
        if ulps > worst.ulps {
            worst = Rounding { ulps, at: numbers.clone() };
        }
    }
    worst
}
