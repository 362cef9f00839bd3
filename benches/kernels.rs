//! Every equation and every contact law over columns of numbers: one number after the other, and in rows with each instruction
//! set. Beside them stands the time of a copy of the same columns, which is what the memory asks for.

#[path = "peers/crystal.rs"]
#[expect(dead_code, reason = "its spheres are for the engine, its law is for all")]
mod crystal;

use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main, measurement::WallTime};
use std::path::Path;
use std::time::{Duration, Instant};
use veridem::forces::Instructions;
use veridem::golden::{documented, samples};
use veridem::interrupt::Interrupt;
use veridem::papers::parse;
use veridem::papers::soot::{self, Plan};
use veridem::run::Study;
use veridem::spec::columns::{PairKernel, in_rows, one_by_one};
use veridem::spec::equation::Kernel;
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::spec::soot::Along;
use veridem::spec::titania::{Tabulated, Titania};
use veridem::spec::{Flat, PairModel};

/// Numbers in a column: ten columns fit into the second cache of any processor.
const LENGTH: usize = 1024;

/// Measures what a kernel does with columns, in every way, and prints the times beside that of a copy.
fn compare(
    criterion: &mut Criterion,
    name: &str,
    arguments: &[Vec<f64>],
    results: usize,
    scalar: impl Fn(&[&[f64]], &mut [&mut [f64]]),
    rows: impl Fn(Instructions, &[&[f64]], &mut [&mut [f64]]),
) {
    let arguments: Vec<&[f64]> = arguments.iter().map(Vec::as_slice).collect();
    let mut room = vec![vec![0.0; LENGTH]; results];
    let mut results: Vec<&mut [f64]> = room.iter_mut().map(Vec::as_mut_slice).collect();
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(LENGTH as u64));
    let mut times = vec![("f64", time(&mut group, "f64", || scalar(&arguments, &mut results)))];
    for set in Instructions::available() {
        times.push((set.name(), time(&mut group, set.name(), || rows(set, &arguments, &mut results))));
    }
    let columns = vec![vec![1.0; LENGTH]; arguments.len() + results.len()];
    let mut copies = columns.clone();
    let copy = time(&mut group, "copy", || {
        copies.iter_mut().zip(&columns).for_each(|(copy, column)| copy.copy_from_slice(std::hint::black_box(column)));
    });
    group.finish();
    let shown: Vec<String> = times
        .into_iter()
        .filter_map(|(name, time)| Some((name, time?)))
        .map(|(name, time)| match copy {
            Some(copy) => format!("{name} {time:.3} ns = {:.2} copies", time / copy),
            None => format!("{name} {time:.3} ns"),
        })
        .collect();
    if !shown.is_empty() {
        println!("{name}, per element: {}", shown.join(", "));
    }
}

/// The shortest time per element, ns; none if it is not asked for.
fn time(group: &mut BenchmarkGroup<WallTime>, name: &str, mut work: impl FnMut()) -> Option<f64> {
    let mut shortest = None;
    group.bench_function(name, |b| {
        b.iter_custom(|times| {
            let begin = Instant::now();
            (0..times).for_each(|_| work());
            let taken = begin.elapsed();
            let each = taken.as_secs_f64() * 1e9 / (times * LENGTH as u64) as f64;
            shortest = Some(shortest.map_or(each, |shortest: f64| shortest.min(each)));
            taken
        });
    });
    shortest
}

/// The inputs of the golden vectors, again and again.
fn equations(criterion: &mut Criterion) {
    for (equation, document) in documented().expect("every equation is documented") {
        let inputs = samples(&equation, &document, 64);
        let size: usize = document.arguments.iter().map(|quantity| quantity.size).sum();
        let column = |k: usize| inputs.iter().map(|input| input.numbers[k]).cycle().take(LENGTH).collect();
        let arguments: Vec<Vec<f64>> = (0..size).map(column).collect();
        let results = document.results.iter().map(|quantity| quantity.size).sum();
        compare(criterion, equation.id, &arguments, results, equation.many.f64, equation.many.rows);
    }
}

/// Pairs of equal spheres about as far apart as is stated, in all directions, moving and turning a little.
fn pairs<M: PairModel>(criterion: &mut Criterion, name: &str, model: &M, [r, m, distance, dt]: [f64; 4]) {
    let mut noise = crystal::noise();
    let constants: M::Coefficients<f64> = model.coefficients(r, r, m, m);
    let rows: Vec<Vec<f64>> = (0..LENGTH)
        .map(|_| {
            let toward = [noise(), noise(), noise()];
            let far = distance * (1.0 + 0.01 * noise()) / toward.iter().map(|x| x * x).sum::<f64>().sqrt();
            let place = toward.map(|x| far * x);
            let moving: Vec<f64> = (0..9).map(|_| 1e-3 * noise()).collect();
            let constants = (0..M::Coefficients::<f64>::LEN).map(|k| *constants.at(k));
            let springs = (0..M::Memory::<f64>::LEN).map(|_| 1e-3 * noise());
            place.into_iter().chain(moving).chain([r, r]).chain(constants).chain(springs).collect()
        })
        .collect();
    let arguments: Vec<Vec<f64>> = (0..rows[0].len()).map(|k| rows.iter().map(|row| row[k]).collect()).collect();
    let kernel = || PairKernel { model, dt };
    let results = Kernel::<f64, ()>::shape(&kernel()).results.iter().sum();
    compare(
        criterion,
        name,
        &arguments,
        results,
        |arguments, results| one_by_one(kernel(), arguments, results),
        |set, arguments, results| in_rows(kernel(), set, arguments, results),
    );
}

fn laws(criterion: &mut Criterion) {
    let mass = sphere_mass(2.2e-3, 3.0);
    pairs(criterion, "wear, pairs", &crystal::silica(), [3.0, mass, 5.94, 1e-4]);

    let text = "title: t\nmodel: {soot: {}}\nsample: {aggregate: {spheres: 30}}\nexperiment: {restructuring: {}}\n";
    let plan = Plan::of(&parse::<soot::Soot>(Path::new("defaults"), text).expect("a case of defaults"), Along);
    let system = plan.initial(&Interrupt::default()).expect("an aggregate");
    let (r, m) = (system.particles.radius[0], system.particles.mass[0]);
    pairs(criterion, "soot, pairs", &plan.model(0, &system), [r, m, 2.0 * r, 5e-5]);

    let law = Titania::paper(1.0, 1e3, 1.0);
    let r = law.contact_radius(8.0);
    let tables = Tabulated::new(law, &[r], 0.1);
    pairs(criterion, "titania, pairs", &tables, [r, sphere_mass(4.23e-3, r), law.equilibrium(r, r), 5e-4]);
}

criterion_group! {
    name = all;
    config = Criterion::default().sample_size(10).warm_up_time(Duration::from_millis(50)).measurement_time(Duration::from_millis(100));
    targets = equations, laws
}
criterion_main!(all);
