//! Proofs over boxes: the numbers that carry them are sound, and the page says what they show.

use std::path::Path;
use veridem::equations::Registry;
use veridem::golden::{documented, samples};
use veridem::proofs::{PAGE, row};
use veridem_spec::Real;
use veridem_spec::document::Document;
use veridem_spec::equation::Equation;
use veridem_spec::numbers::{Dual, Interval, Reference, Rounded};

/// Random inputs per equation, and points in the box around each.
const COUNT: usize = 10;
const POINTS: usize = 4;

/// One equation in this number is proved again.
const EVERY: usize = 12;

/// A sequence of numbers between zero and one.
fn noise() -> impl FnMut() -> f64 {
    let mut state = 88_172_645_463_325_252u64;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// `|f| + sum_k |x_k df/dx_k|` of every number that comes out.
fn sizes(equation: &Equation, point: &[f64], exact: &[Reference]) -> Vec<f64> {
    let mut sizes: Vec<f64> = exact.iter().map(|y| y.to_f64().abs()).collect();
    for (k, x) in point.iter().enumerate() {
        let mut duals: Vec<Dual> = point.iter().map(|x| Dual::constant(*x)).collect();
        duals[k] = Dual::variable(*x);
        for (size, y) in sizes.iter_mut().zip((equation.eval.dual)(&duals)) {
            let change = (x * y.slope).abs();
            // zero times an infinite slope
            *size += if change.is_nan() { 0.0 } else { change };
        }
    }
    sizes
}

/// Compares exact value, double and error at points of a box with what is claimed of the box; counts the numbers that were bounded.
fn check_box(equation: &Equation, ranges: &[Interval], random: &mut impl FnMut() -> f64) -> Result<[usize; 2], String> {
    let inputs: Vec<Rounded> = ranges.iter().enumerate().map(|(k, x)| Rounded::input(k, *x)).collect();
    let claimed = (equation.eval.rounded)(&inputs);
    let mut counts = [0, 0];
    for _ in 0..POINTS {
        let point: Vec<f64> = ranges.iter().map(|x| (x.lo + random() * (x.hi - x.lo)).clamp(x.lo, x.hi)).collect();
        let exact = (equation.eval.reference)(&point.iter().map(|x| Reference::exact(*x)).collect::<Vec<_>>());
        let double = (equation.eval.f64)(&point);
        let sizes = sizes(equation, &point, &exact);
        for (k, claimed) in claimed.iter().enumerate() {
            counts[1] += 1;
            if claimed.trouble().is_some() {
                continue;
            }
            counts[0] += 1;
            let bounds = claimed.exact();
            let inside = exact[k].ge(Reference::exact(bounds.lo)) && exact[k].le(Reference::exact(bounds.hi));
            let error = (Reference::exact(double[k]) - exact[k]).abs().to_f64();
            let ulps = claimed.ulps(0.0);
            // the size itself is computed in `f64`
            let in_ulps = ulps.first_order * f64::EPSILON * sizes[k] * (1.0 + 1e-9) + ulps.rest;
            let within = error <= claimed.error() && error <= in_ulps;
            if !inside || !claimed.computed().contains(double[k]) || !within {
                return Err(format!(
                    "{point:?}: number {k} is {} with an error of {error:e}, claimed are {claimed:?}",
                    double[k]
                ));
            }
        }
    }
    Ok(counts)
}

#[test]
fn errors_at_random_points_are_within_the_bounds_of_their_boxes() {
    let mut random = noise();
    let (mut bounded, mut all) = (0, 0);
    for (equation, document) in documented().unwrap() {
        for (at, sample) in samples(&equation, &document, COUNT).into_iter().enumerate() {
            let width = [0.0, 1e-9, 1e-3, 0.1, 0.5][at % 5];
            let range = |x: &f64| {
                // around zero, too
                let wide = width * if at % 2 == 0 { x.abs() } else { x.abs().max(1e-3) };
                Interval::new(x - wide, x + wide)
            };
            let ranges: Vec<Interval> = sample.numbers.iter().map(range).collect();
            let counts = check_box(&equation, &ranges, &mut random);
            let [here, of] = counts.unwrap_or_else(|what| panic!("{}: {what}", equation.id));
            // boxes around numbers near the end of a domain reach beyond it
            if !["small", "near"].contains(&sample.flag) {
                (bounded, all) = (bounded + here, all + of);
            }
        }
    }
    // a bound that is never given would pass
    assert!(bounded > 9 * all / 10, "{bounded} of {all} numbers are bounded");
}

/// Kilogram, metre and second become larger by these powers of two; a fourth root of a unit, by a fourth of the power, is not rounded.
const UNITS: [[i32; 3]; 4] = [[4, 0, 0], [0, -4, 0], [0, 0, 4], [-4, 8, 4]];

#[test]
fn a_change_of_units_by_powers_of_sixteen_changes_no_digit() {
    let scaled = |document: &Document, of_results: bool, powers: [i32; 3], numbers: &[f64]| -> Vec<f64> {
        let quantities = if of_results { &document.results } else { &document.arguments };
        let power = |exponents: [i16; 3]| exponents.iter().zip(powers).map(|(e, p)| i32::from(*e) * p / 4).sum::<i32>();
        let factors = quantities.iter().flat_map(|q| std::iter::repeat_n(2f64.powi(power(q.exponents)), q.size));
        numbers.iter().zip(factors).map(|(x, factor)| x * factor).collect()
    };
    for (equation, document) in documented().unwrap() {
        for sample in samples(&equation, &document, COUNT) {
            for powers in UNITS {
                let in_these = (equation.eval.f64)(&scaled(&document, false, powers, &sample.numbers));
                let expected = scaled(&document, true, powers, &(equation.eval.f64)(&sample.numbers));
                for (one, other) in in_these.into_iter().zip(expected) {
                    // the least numbers have fewer digits
                    let same = one == other || one.is_subnormal() || other.is_subnormal();
                    assert!(same, "{} at {:?} in units {powers:?}: {one} {other}", equation.id, sample.numbers);
                }
            }
        }
    }
}

#[test]
fn the_page_says_what_is_proved() {
    let page = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(PAGE)).unwrap();
    let registry = Registry::new();
    let rows: Vec<&str> = page.lines().filter(|line| line.starts_with("| ")).skip(1).collect();
    let ids: Vec<&str> = rows.iter().map(|row| row[2..].split(" |").next().unwrap_or_default()).collect();
    let expected: Vec<&str> = registry.0.iter().map(|entry| entry.equation.id).collect();
    assert_eq!(ids, expected, "run `veridem eq prove --all > {PAGE}`");
    for (entry, kept) in registry.0.iter().zip(&rows) {
        let stated = format!("| {} ", entry.document.rounding.unwrap_or_default());
        assert!(
            kept.contains(&stated),
            "{}: another bound is stated now, run `veridem eq prove --all > {PAGE}`",
            entry.equation.id
        );
    }
    for (entry, kept) in registry.0.iter().zip(rows).step_by(EVERY) {
        assert_eq!(row(entry).trim_end(), kept, "run `veridem eq prove --all > {PAGE}`");
    }
}
