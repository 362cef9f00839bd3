//! Every equation of every paper, one by one and eight at a time, in the middle of its domain.
//!
//! The time includes laying out the arguments and results, which the engine does not do: compare equations, and `f64`
//! (one result) with `lanes` (eight).

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use std::time::Duration;
use veridem::spec::document::{Document, Domain, Quantity};
use veridem::spec::equations;
use veridem::spec::numbers::Lanes;

/// A value that the quantity may have, far from the ends of its domain.
fn typical(quantity: &Quantity) -> Vec<f64> {
    match quantity.domain {
        Domain::Unit => vec![2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0],
        Domain::Between { lo, hi, .. } => {
            let middle = match (lo.is_finite(), hi.is_finite()) {
                (true, true) => 0.5 * (lo + hi),
                (true, false) => lo + 1.5,
                (false, true) => hi - 1.5,
                (false, false) => 0.25,
            };
            vec![middle; quantity.size]
        }
    }
}

fn kernels(criterion: &mut Criterion) {
    for equation in equations() {
        let document = Document::of(&equation).expect("every equation is documented");
        let arguments: Vec<f64> = document.arguments.iter().flat_map(typical).collect();
        let lanes: Vec<Lanes<8>> = arguments.iter().map(|&x| Lanes([x; 8])).collect();
        let mut group = criterion.benchmark_group(equation.id);
        group.throughput(Throughput::Elements(1));
        group.bench_function("f64", |b| b.iter(|| (equation.eval.f64)(black_box(&arguments))));
        group.throughput(Throughput::Elements(8));
        group.bench_function("lanes", |b| b.iter(|| (equation.eval.lanes)(black_box(&lanes))));
        group.finish();
    }
}

criterion_group! {
    name = all;
    config = Criterion::default().warm_up_time(Duration::from_millis(100)).measurement_time(Duration::from_millis(400));
    targets = kernels
}
criterion_main!(all);
