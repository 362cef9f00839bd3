//! Does an aggregate between a substrate and a moving tip obey the conservation laws, with the same bits on any machine?

mod common;

use common::instruction_sets;
use common::soot::{DT, SPHERES, between, dry, momentum, plane, settings};
use std::process::{Command, Output};
use veridem::forces::Instructions;
use veridem::output::{RunFolder, Series};
use veridem::run::{advance, advance_until};
use veridem::simulation::{Settings, Simulation};
use veridem::spec::Vec3;
use veridem::spec::soot::Soot;
use veridem::system::Mesh;
use veridem::system::{PrescribedMotion, Shape, Surface, System};

/// A square far larger than the aggregate, whose diagonal passes below it.
fn sheet() -> Shape {
    let [a, b, c, d] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| Vec3([x, y, 0.0]) * 2e3);
    Shape::Mesh(Mesh::new(&[[a, b, c], [a, c, d]]).expect("a sheet"))
}

fn run(system: System, settings: Settings, steps: usize) -> Simulation<Soot> {
    common::soot::run(dry(), system, settings, steps)
}

#[test]
fn the_energy_is_accounted_for_to_rounding_and_to_first_order() {
    let account = |dt: f64| {
        let after = run(between(plane()), settings(dt), (0.3 / dt) as usize);
        let ledger = after.ledger();
        assert!(ledger.discrete_residual().abs() < 1e-11 * ledger.turnover(), "{ledger:?}");
        assert!(ledger.surfaces.work > 100.0 && ledger.surfaces.lost.iter().sum::<f64>() > 10.0, "{ledger:?}");
        ledger.physical_residual().abs() / ledger.turnover()
    };
    let (coarse, fine) = (account(DT / 4.0), account(DT / 16.0));
    assert!(coarse < 1e-2, "{coarse}");
    assert!((3.0..5.0).contains(&(coarse / fine)), "{coarse} and {fine}");
}

#[test]
fn a_surface_turns_back_when_it_is_as_old_as_its_motion_says() {
    let (dt, steps) = (1e-5, 1000);
    let turn = dt * f64::from(steps);
    let motion = PrescribedMotion::Reversal { velocity: 100.0, rate: 300.0, turn };
    let mut surface = Surface::new("tip", 0, plane(), motion);
    let mut way = Vec::new();
    for step in 1..=2 * steps {
        surface.advance(dt);
        way.push(surface.way.0[2]);
        assert!((surface.age - dt * f64::from(step)).abs() < 1e-12);
    }
    let farthest = way.iter().enumerate().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).expect("steps").0;
    assert_eq!(farthest + 1, steps as usize);
    // It goes back the way that it came.
    for k in 1..steps as usize {
        assert!((way[farthest - k] - way[farthest + k]).abs() < 1e-9 * way[farthest].abs());
    }
    assert!(way[farthest].abs() > 0.5 * 100.0 * turn && way[2 * steps as usize - 1].abs() < 1e-9);
}

#[test]
fn surfaces_give_the_spheres_all_the_momentum_that_they_gain() {
    let mut simulation = run(between(plane()), settings(DT), 0);
    let (mut given, before) = (Vec3::zero(), momentum(&simulation.system().particles));
    let mut causes = [0.0f64; 3];
    for _ in 0..10_000 {
        advance(&mut simulation, 1).expect("a stable step");
        for surface in &simulation.system().surfaces {
            given = given - surface.force.total() * DT;
            let force = surface.force;
            for (largest, cause) in causes.iter_mut().zip([force.contact, force.friction, force.van_der_waals]) {
                *largest = largest.max(cause.norm());
            }
        }
    }
    let gained = momentum(&simulation.system().particles) - before;
    assert!(gained.norm() > 100.0, "it was pushed");
    assert!((gained - given).norm() < 1e-10 * gained.norm(), "{gained:?} {given:?}");
    assert!(causes.iter().all(|largest| *largest > 100.0), "{causes:?}");
}

#[test]
fn a_square_of_two_triangles_is_as_good_as_a_plane() {
    let end = |substrate| run(between(substrate), settings(DT), 5_000).system().particles.clone();
    let (plane, sheet) = (end(plane()), end(sheet()));
    for (a, b) in plane.x.iter().zip(&sheet.x) {
        assert!((*a - *b).norm() < 1e-9, "{a:?} {b:?}");
    }
}

#[test]
fn neither_threads_nor_instructions_nor_a_pause_change_a_bit() {
    let with = |threads: usize, instructions| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let settings = Settings { instructions, ..settings(DT) };
        pool.install(|| run(between(sheet()), settings, 6000).snapshot())
    };
    let plain = with(1, Instructions::BASELINE);
    for instructions in instruction_sets() {
        assert!(with(2, instructions) == plain, "{instructions:?}");
    }

    // The pause is made while a sphere lies on the substrate.
    let mut first = run(between(sheet()), settings(DT), 0);
    advance_until(&mut first, |now| !now.system().surfaces[0].contacts.places.is_empty()).expect("a stable step");
    let taken = first.system().step as usize;
    let mut resumed = Simulation::resume(dry(), settings(DT), first.snapshot()).expect("a valid snapshot");
    advance(&mut resumed, 6000 - taken as u64).expect("a stable step");
    assert!(resumed.snapshot() == plain);
}

#[test]
fn springs_of_all_contacts_go_on_from_stage_to_stage() {
    let whole = run(between(plane()), settings(DT), 6000);
    let first = run(between(plane()), settings(DT), 3000).into_system_with_springs();
    let second = run(first, settings(DT), 3000);
    let (a, b) = (&whole.system().particles, &second.system().particles);
    for id in 0..SPHERES as u32 {
        let (p, q) = (whole.system().place(id), second.system().place(id));
        assert!((a.x[p] - b.x[q]).norm() < 1e-9 && (a.v[p] - b.v[q]).norm() < 1e-6, "{:?} {:?}", a.x[p], b.x[q]);
    }
}

#[test]
fn a_sphere_that_sinks_into_a_surface_is_reported() {
    let mut deep = between(plane());
    deep.particles.x.iter_mut().for_each(|x| x.0[2] -= 5.0);
    let mut simulation = Simulation::new(dry(), deep, settings(DT)).expect("a stable step");
    let halt = advance(&mut simulation, 1).expect_err("too deep").to_string();
    assert!(halt.contains("overlaps a surface by 0.343 of its radius (limit 0.1)"), "{halt}");
}

#[test]
fn an_aggregate_from_a_file_is_indented_with_the_bits_of_a_sequence() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let run = |name: &str, sample: &str, stages: &str| -> Output {
        let text = format!(
            "title: t\nmodel: {{soot: {{necks: S}}}}\nsample: {{aggregate: {{spheres: 6, neck_fraction: 1{sample}}}}}\n\
             experiment:\n  sequence:\n{stages}output: {{series: 500 steps}}\n"
        );
        std::fs::write(place.path().join(name).with_extension("yaml"), text).expect("a writable folder");
        let mut command = Command::new(env!("CARGO_BIN_EXE_veridem"));
        command.current_dir(place.path()).args(["--quiet", "run", &format!("{name}.yaml")]).output().expect("it starts")
    };
    let deposition = |save: &str| format!("    - deposition: {{velocity: 5 m/s, duration: 4000 steps{save}}}\n");
    let indentation =
        "    - indentation: {gap: 0.01 r, keep_necks: 0.5, duration: 6000 steps, integrator: velocity-verlet}\n";
    let series = |name: &str| {
        let folder = RunFolder::open(&place.path().join("run").join(name)).expect("a run");
        Series::read(&folder).expect("a series")
    };
    // A run of one stage has all of its columns in one table.
    let rows = |name: &str| {
        let (alone, series) = (series("second"), series(name));
        let columns = alone.tables[0].columns.iter().filter(|column| *column != "stage");
        columns.map(|column| (column.clone(), series.curve_of("indentation", "step", column))).collect::<Vec<_>>()
    };
    assert!(run("whole", "", &(deposition("") + indentation)).status.success());
    assert!(run("first", "", &deposition(", save: one.sample")).status.success());
    assert!(run("second", ", deposited: one.sample", indentation).status.success());
    assert!(rows("whole").iter().all(|(_, points)| points.len() == 13));
    assert_eq!(rows("whole"), rows("second"));
    assert!(place.path().join("run/whole/frames/deposition.000001.obj").exists());

    let veridem = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_veridem"));
        command.current_dir(place.path()).arg("--quiet").args(arguments).output().expect("it starts")
    };
    let paused = veridem(&["run", "whole.yaml", "--name", "paused", "--stop-after-steps", "7001"]);
    assert_eq!(paused.status.code(), Some(75));
    assert!(veridem(&["resume", "run/paused"]).status.success());
    let same = veridem(&["inspect", "--diff", "run/paused", "run/whole"]);
    assert_eq!(String::from_utf8_lossy(&same.stdout), "identical\n");

    let other = run("other", ", deposited: one.sample, radius: 15 nm", indentation);
    let text = String::from_utf8_lossy(&other.stderr).to_string();
    assert_eq!(text, "one.sample: was made with another model or aggregate\n");
    assert_eq!(other.status.code(), Some(65));
    let early = run("early", ", deposited: none.sample", indentation);
    assert_eq!(early.status.code(), Some(66), "{early:?}");
}
