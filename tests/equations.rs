//! Every equation, over every kind of number: what its documentation claims is executed.

#[path = "../benches/peers/crystal.rs"]
#[expect(dead_code, reason = "its law is needed, not its spheres")]
mod crystal;

use rayon::prelude::*;
use std::collections::HashMap;
use std::sync::LazyLock;
use veridem::golden::{Sample, documented, error, measure, samples};
use veridem_spec::columns::{CoefficientsKernel, PairKernel, Results, StoredKernel, in_rows, one_by_one};
use veridem_spec::document::{Document, Quantity};
use veridem_spec::equation::Equation;
use veridem_spec::numbers::{Dimension, Instructions, Interval, Lanes, Reference};
use veridem_spec::titania::{Tabulated, Titania};
use veridem_spec::{Contact, Flat, Outcome, PairModel, Vec3};

/// Random inputs per equation.
const COUNT: usize = 200;

/// Runs a check on every equation and reports all failures together.
fn every_equation(check: impl Fn(&Equation, &Document) -> Result<(), String> + Sync) {
    let equations = documented().expect("every equation is documented");
    let failures: Vec<String> = equations
        .par_iter()
        .with_max_len(1)
        .filter_map(|(e, d)| check(e, d).err().map(|what| format!("{}: {what}", e.id)))
        .collect();
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

/// The samples of every equation by its identifier, drawn once for all tests: their results with many digits take most of the time.
static SAMPLES: LazyLock<HashMap<&str, Vec<Sample>>> = LazyLock::new(|| {
    let equations = documented().expect("every equation is documented");
    let of = |(equation, document): &(Equation, Document)| (equation.id, samples(equation, document, COUNT));
    equations.par_iter().with_max_len(1).map(of).collect()
});

/// The samples of an equation, which must not be scarce: a table whose domains are wrong leaves few inputs with a value.
fn samples_of(equation: &Equation) -> Result<&'static [Sample], String> {
    let samples = &SAMPLES[equation.id];
    for (flag, count) in [("sampled", COUNT), ("small", COUNT / 2), ("near", COUNT / 2)] {
        let found = samples.iter().filter(|sample| sample.flag == flag).count();
        if found < count {
            return Err(format!("only {found} {flag} inputs have a value"));
        }
    }
    Ok(samples)
}

/// Their inputs.
fn inputs(equation: &Equation) -> Result<Vec<&'static [f64]>, String> {
    Ok(samples_of(equation)?.iter().map(|sample| &*sample.numbers).collect())
}

fn references(numbers: &[f64]) -> Vec<Reference> {
    numbers.iter().map(|x| Reference::exact(*x)).collect()
}

#[test]
fn units_of_the_results_follow_from_those_of_the_arguments() {
    every_equation(|equation, document| {
        let dimension = |q: &Quantity| std::iter::repeat_n(Dimension::Of(q.exponents), q.size);
        let arguments: Vec<Dimension> = document.arguments.iter().flat_map(dimension).collect();
        let stated: Vec<Dimension> = document.results.iter().flat_map(dimension).collect();
        let executed = (equation.eval.dimension)(&arguments);
        for (k, (stated, executed)) in stated.iter().zip(&executed).enumerate() {
            // a component that is always zero has any dimension
            if stated != executed && *executed != Dimension::Any {
                return Err(format!("output {k} is said to be {stated}, it is {executed}"));
            }
        }
        if executed.iter().all(|d| *d == Dimension::Any) { Err("is always zero".into()) } else { Ok(()) }
    });
}

#[test]
fn eight_lanes_have_the_bits_of_eight_doubles() {
    every_equation(|equation, _| {
        for eight in inputs(equation)?.chunks_exact(8) {
            let lanes: Vec<Lanes<8>> =
                (0..eight[0].len()).map(|k| Lanes(std::array::from_fn(|lane| eight[lane][k]))).collect();
            let out = (equation.eval.lanes)(&lanes);
            for (lane, numbers) in eight.iter().enumerate() {
                let single = (equation.eval.f64)(numbers);
                if single.iter().zip(&out).any(|(y, lanes)| y.to_bits() != lanes.0[lane].to_bits()) {
                    return Err(format!("{numbers:?} gives {single:?} alone and {out:?} in lane {lane}"));
                }
            }
        }
        Ok(())
    });
}

#[test]
fn columns_have_the_bits_of_single_numbers_with_every_instruction_set() {
    every_equation(|equation, _| {
        let inputs = inputs(equation)?;
        let singles: Vec<Vec<f64>> = inputs.iter().map(|numbers| (equation.eval.f64)(numbers)).collect();
        // with and without a rest that does not fill a row
        for count in [1, 8, inputs.len() - 3] {
            let arguments: Vec<Vec<f64>> =
                (0..inputs[0].len()).map(|k| inputs[..count].iter().map(|numbers| numbers[k]).collect()).collect();
            let arguments: Vec<&[f64]> = arguments.iter().map(Vec::as_slice).collect();
            let mut room = vec![vec![f64::NAN; count]; singles[0].len()];
            let mut check = |way: &str, evaluate: &dyn Fn(&[&[f64]], Results)| {
                evaluate(&arguments, &mut room.iter_mut().map(Vec::as_mut_slice).collect::<Vec<_>>());
                for (place, single) in singles[..count].iter().enumerate() {
                    if single.iter().zip(&mut room).any(|(y, column)| y.to_bits() != column[place].to_bits()) {
                        return Err(format!("{way} differs from {single:?} at {:?}", inputs[place]));
                    }
                }
                room.iter_mut().for_each(|column| column.fill(f64::NAN));
                Ok(())
            };
            check("f64", &equation.many.f64)?;
            for set in Instructions::available() {
                check(set.name(), &|arguments, results| (equation.many.rows)(set, arguments, results))?;
            }
        }
        Ok(())
    });
}

/// Evaluates pairs of spheres of this radius and mass, about this distance apart, one by one by the law itself and over columns.
fn compare_pairs<M: PairModel>(name: &str, model: &M, [r, m, distance, dt]: [f64; 4]) {
    let constants = model.coefficients(r, r, m, m);
    let mut noise = crystal::noise();
    let (mut rows, mut expected, mut stored) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..37 {
        let mut vector = |size: f64| Vec3([noise(), noise(), noise()]) * size;
        let x = Vec3([distance, 0.0, 0.0]) + vector(0.05 * distance);
        let [v, omega_i, omega_j] = [vector(1.0), vector(0.3), vector(0.3)];
        let springs: M::Memory<f64> = Flat::from_fn(|_| vector(0.01 * distance).0[0]);
        let contact = Contact::new(x, v, omega_i, omega_j, r, r);
        let Outcome { wrench, memory, losses } = model.pair(&contact, &constants, springs, dt);
        let arguments = [x, v, omega_i, omega_j].into_iter().flat_map(|u| u.0).chain([r, r]);
        let arguments = arguments.chain((0..M::Coefficients::<f64>::LEN).map(|k| *constants.at(k)));
        rows.push(arguments.chain((0..M::Memory::<f64>::LEN).map(|k| *springs.at(k))).collect::<Vec<_>>());
        let results = [wrench.force, wrench.torque_i, wrench.torque_j].into_iter().flat_map(|u| u.0);
        let results = results.chain((0..M::Memory::<f64>::LEN).map(|k| *memory.at(k)));
        expected.push(results.chain((0..M::Losses::<f64>::LEN).map(|k| *losses.at(k))).collect::<Vec<_>>());
        let held = model.stored(&contact, &constants, &springs);
        stored.push((0..M::Stored::<f64>::LEN).map(|k| *held.at(k)).collect::<Vec<_>>());
    }
    let columns: Vec<Vec<f64>> = (0..rows[0].len()).map(|k| rows.iter().map(|row| row[k]).collect()).collect();
    let arguments: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
    let check = |way: &str, expected: &[Vec<f64>], evaluate: &dyn Fn(Results)| {
        let mut room = vec![vec![f64::NAN; rows.len()]; expected[0].len()];
        evaluate(&mut room.iter_mut().map(Vec::as_mut_slice).collect::<Vec<_>>());
        for (place, single) in expected.iter().enumerate() {
            let same = single.iter().zip(&room).all(|(y, column)| y.to_bits() == column[place].to_bits());
            assert!(same, "{name}, {way}: {single:?} at {:?}", rows[place]);
        }
    };
    for set in Instructions::available() {
        check(set.name(), &expected, &|results| in_rows(PairKernel { model, dt }, set, &arguments, results));
        check(set.name(), &stored, &|results| in_rows(StoredKernel { model }, set, &arguments, results));
    }
    let sizes = [r, r, m, m].map(|size| vec![size; rows.len()]);
    let constants = vec![(0..M::Coefficients::<f64>::LEN).map(|k| *constants.at(k)).collect(); rows.len()];
    check("constants", &constants, &|results| {
        let kernel = CoefficientsKernel { model, joined: false };
        one_by_one(kernel, &sizes.each_ref().map(Vec::as_slice), results);
    });
}

#[test]
fn contact_laws_over_columns_have_the_bits_of_single_pairs() {
    compare_pairs("wear", &crystal::silica(), [3.0, 0.25, 5.94, 1e-4]);
    let law = Titania::paper(1.0, 1e3, 1.0);
    let r = law.contact_radius(8.0);
    compare_pairs("titania", &Tabulated::new(law, &[r], 0.1), [r, 1.3, law.equilibrium(r, r), 5e-4]);
}

#[test]
fn intervals_contain_the_double_and_the_exact_value() {
    every_equation(|equation, _| {
        for Sample { numbers, exact, .. } in samples_of(equation)? {
            let points: Vec<Interval> = numbers.iter().map(|x| Interval::point(*x)).collect();
            let bounds = (equation.eval.interval)(&points);
            let out = (equation.eval.f64)(numbers);
            for ((bounds, y), exact) in bounds.iter().zip(out).zip(exact) {
                if !bounds.contains(y) || !bounds.contains(exact.to_f64()) {
                    return Err(format!("{numbers:?}: {y} or {} is not in {bounds:?}", exact.to_f64()));
                }
            }
        }
        Ok(())
    });
}

#[test]
fn rounding_errors_are_within_their_bounds_and_the_bounds_are_tight() {
    every_equation(|equation, document| {
        let measured = measure(equation, samples_of(equation)?);
        let stated = document.rounding.ok_or(format!("no `Rounding:` line; measured {:.3}", measured.ulps))?;
        if measured.ulps > stated {
            return Err(format!("{} ULP at {:?}, stated are {stated}", measured.ulps, measured.at));
        }
        // one rounding of the result is the least that an inexact function can promise
        if stated > (4.0 * measured.ulps).max(1.0) || (measured.ulps == 0.0) != (stated == 0.0) {
            return Err(format!("the bound {stated} is too loose for the {} ULP measured", measured.ulps));
        }
        Ok(())
    });
}

#[test]
fn single_precision_loses_digits_no_faster_than_double() {
    every_equation(|equation, document| {
        // literals such as pi are rounded, too, and differently in each precision
        let stated = document.rounding.unwrap_or(0.0) + 0.5;
        // numbers of the magnitudes in SI units leave the range of single precision
        let of_order_one = |sample: &&Sample| !["small", "near"].contains(&sample.flag);
        let samples = &SAMPLES[equation.id];
        for Sample { numbers, .. } in samples.iter().filter(of_order_one) {
            let single: Vec<f32> = numbers.iter().map(|x| *x as f32).collect();
            let rounded: Vec<f64> = single.iter().map(|x| f64::from(*x)).collect();
            let out: Vec<f64> = (equation.eval.f32)(&single).into_iter().map(f64::from).collect();
            let exact = (equation.eval.reference)(&references(&rounded));
            if exact.iter().any(|y| !y.to_f64().is_finite()) {
                continue; // rounding left the domain
            }
            let eps = f64::from(f32::EPSILON);
            let errors = error(equation, &rounded, &out, &exact, eps);
            if let Some(ulps) = errors.iter().find(|ulps| **ulps > stated) {
                return Err(format!("{ulps} ULP of single precision at {rounded:?}, stated are {stated}"));
            }
        }
        Ok(())
    });
}
