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
use veridem::spec::Vec3;
use veridem::spec::soot::Along;
use veridem::system::{Mesh, Shape};

#[global_allocator]
static ALLOCATOR: veridem::allocator::LargePages = veridem::allocator::LargePages;

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
    let mut simulation = Simulation::new(plan.model(0, &system), system, settings).expect("an aggregate at rest");
    let mut group = criterion.benchmark_group("step of a soot aggregate");
    group.throughput(Throughput::Elements(particles));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    group.bench_function(format!("{particles} spheres"), |b| {
        pool.install(|| b.iter(|| advance(&mut simulation, 1).expect("a stable aggregate")));
    });
    group.finish();
}

/// An aggregate above a square of two and of 3,200 triangles, on one core.
fn surface(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("step of a soot aggregate above a square");
    let file = Path::new("deposition");
    let text = "title: t\nmodel: {soot: {}}\nsample: {aggregate: {spheres: 30}}\nexperiment: {deposition: {}}\n";
    let plan = Plan::of(&parse::<soot::Soot>(file, text).expect("a case of defaults"), Along);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    for n in [1, 40] {
        let initial = plan.initial(&Interrupt::default()).expect("an aggregate");
        let mut system = plan.set_up(0, initial).expect("an aggregate above a substrate");
        let corner =
            |i: usize, j: usize| Vec3([600.0 * i as f64 / n as f64 - 200.0, 600.0 * j as f64 / n as f64 - 200.0, 0.0]);
        let squares = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        let triangles = squares.flat_map(|(i, j)| {
            let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            [[a, b, c], [a, c, d]]
        });
        let triangles: Vec<_> = triangles.collect();
        let lowest = system.particles.x.iter().map(|x| x.0[2]).fold(f64::INFINITY, f64::min);
        let down = Vec3([0.0, 0.0, 15.0 - lowest]);
        system.particles.x.iter_mut().for_each(|x| *x = *x + down);
        system.particles.v.fill(Vec3([0.0; 3]));
        system.surfaces[0].shape = Shape::Mesh(Mesh::new(&triangles).expect("a square"));
        let settings = plan.settings(0, &system);
        let mut simulation = Simulation::new(plan.model(0, &system), system, settings).expect("a stable step");
        group.bench_function(format!("{} triangles", triangles.len()), |b| {
            pool.install(|| b.iter(|| advance(&mut simulation, 1).expect("a stable aggregate")));
        });
    }
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
    targets = step, restructuring, surface, growth, list
}
criterion_main!(all);
