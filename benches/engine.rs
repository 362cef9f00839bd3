//! A whole step of the engine, per instruction set and number of threads, and building its neighbour list.

#[path = "peers/crystal.rs"]
mod crystal;

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use std::path::Path;
use std::time::Duration;
use veridem::forces::Instructions;
use veridem::initial::aggregate::{self, Method, Radii, Recipe};
use veridem::interrupt::Interrupt;
use veridem::papers::parse;
use veridem::papers::soot::{self, Plan};
use veridem::run::{Study, advance};
use veridem::simulation::Simulation;
use veridem::spec::soot::Along;

const CRYSTALS: [[usize; 3]; 2] = [[18, 12, 7], [29, 17, 26]];

fn step(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("step");
    for cells in CRYSTALS {
        let particles = 4 * cells.iter().product::<usize>();
        group.throughput(Throughput::Elements(particles as u64));
        for threads in [1, 2] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a thread pool");
            for instructions in Instructions::available() {
                let mut simulation =
                    pool.install(|| crystal::simulation(cells, instructions)).expect("a stable crystal");
                let name = format!("{particles} spheres, {threads} threads, {instructions:?}");
                group.bench_function(name, |b| {
                    pool.install(|| b.iter(|| advance(&mut simulation, 1).expect("a stable crystal")))
                });
            }
        }
    }
    group.finish();
}

/// The initial state of the published soot simulation, on one core.
fn restructuring(criterion: &mut Criterion) {
    let file = Path::new("cases/soot/restructuring.yaml");
    let text = std::fs::read_to_string(file).expect("a case of the repository");
    let case = parse::<soot::Soot>(file, &text).expect("a case of the repository");
    let plan = Plan::of(&case, Along);
    let system = plan.initial(&Interrupt::default()).expect("an aggregate");
    let settings = plan.settings(0, &system);
    let particles = system.particles.len() as u64;
    let mut simulation = Simulation::new(plan.model(0), system, settings).expect("an aggregate at rest");
    let mut group = criterion.benchmark_group("step of a soot aggregate");
    group.throughput(Throughput::Elements(particles));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    group.bench_function(format!("{particles} spheres"), |b| {
        pool.install(|| b.iter(|| advance(&mut simulation, 1).expect("a stable aggregate")));
    });
    group.finish();
}

/// Growing an aggregate of 150 spheres, another one each time.
fn growth(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("grow an aggregate of 150 spheres");
    for (name, method, d_f) in [("clusters", Method::Clusters, 1.8), ("spheres", Method::Spheres, 2.2)] {
        let recipe = Recipe { number: 150, d_f, k_f: 1.4, radii: Radii::Equal(14.0), method };
        let mut seed = 0;
        group.bench_function(name, |b| {
            b.iter(|| {
                seed += 1;
                aggregate::aggregate(&recipe, seed, &Interrupt::default()).expect("an aggregate that obeys the law")
            });
        });
    }
    group.finish();
}

fn list(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("build the crystal and its neighbour list");
    for cells in CRYSTALS {
        let particles = 4 * cells.iter().product::<usize>();
        group.throughput(Throughput::Elements(particles as u64));
        let build = || crystal::simulation(cells, Instructions::best()).expect("a stable crystal");
        group.bench_function(format!("{particles} spheres"), |b| {
            b.iter_batched(|| (), |()| build(), BatchSize::PerIteration)
        });
    }
    group.finish();
}

criterion_group! {
    name = all;
    config = Criterion::default().sample_size(20).warm_up_time(Duration::from_secs(1)).measurement_time(Duration::from_secs(3));
    targets = step, restructuring, growth, list
}
criterion_main!(all);
