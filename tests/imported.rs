//! Do samples from files do what the same samples do that are generated, and do bodies and velocities in them obey mechanics?

use std::fmt::Write;
use std::ops::ControlFlow;
use std::path::Path;
use std::process::Command;
use veridem::geometry::Sphere;
use veridem::initial::aggregate::necks::{NeckLength, necks};
use veridem::interrupt::Interrupt;
use veridem::papers::parse;
use veridem::papers::titania::case::{Case, Sample};
use veridem::papers::titania::chain::{Recipe, agglomerate};
use veridem::papers::titania::{Plan, Titania};
use veridem::run::{Driver, Each, RunningStage, Step};
use veridem::spec::Vec3;
use veridem::spec::mechanics::body::spin;
use veridem::spec::mechanics::drive::ramped_time;
use veridem::spec::mechanics::rotation::to_space;
use veridem::spec::titania::Tabulated;
use veridem::system::System;

fn run(place: &Path, text: &str, name: &str, more: &[&str]) -> (Option<i32>, String) {
    std::fs::write(place.join(format!("{name}.yaml")), text).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_veridem"))
        .current_dir(place)
        .args(["--quiet", "--threads", "1", "run", &format!("{name}.yaml")])
        .args(more)
        .output()
        .unwrap();
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

/// A file of a run.
fn file(place: &Path, name: &str, file: &str) -> Vec<u8> {
    std::fs::read(place.join("run").join(name).join(file)).unwrap_or_else(|error| panic!("{name}/{file}: {error}"))
}

const CHAIN: &str = "title: a chain\nseed: 3\nmodel: {titania: {}}\nsample: {agglomerate: SAMPLE}\nexperiment:\n  stretching: {relaxation: 0.02 ns, distance: 0.5 nm, dt: 0.5 ps}\noutput: {series: 5 ps, frames: 50 ps}\n";

#[test]
fn a_chain_from_a_file_does_what_the_generated_one_does() {
    let place = tempfile::tempdir().unwrap();
    let recipe = Recipe { particles: 14, smallest: 8.0, largest: 20.0, length: 100.0 };
    let chain = agglomerate(&recipe, 3, &Interrupt::default()).unwrap().unwrap();
    let mut rows = String::from("x,y,z,d\n");
    for (Vec3([x, y, z]), d) in &chain {
        writeln!(rows, "{x},{y},{z},{d}").unwrap();
    }
    std::fs::write(place.path().join("chain.csv"), rows).unwrap();
    assert!(chain.iter().any(|particle| particle.1 > 19.0), "the margin of the box is that of the largest");
    assert_eq!(run(place.path(), &CHAIN.replace("SAMPLE", "{}"), "grown", &[]), (Some(0), String::new()));
    let import = "{import: {file: chain.csv, unit: 1 nm}}";
    assert_eq!(run(place.path(), &CHAIN.replace("SAMPLE", import), "read", &[]), (Some(0), String::new()));
    for name in ["series.csv", "series.pulling.csv", "windows.csv", "events.jsonl", "results.yaml"] {
        assert_eq!(file(place.path(), "read", name), file(place.path(), "grown", name), "{name}");
    }
}

#[test]
fn a_film_from_a_file_does_what_the_generated_one_does() {
    let place = tempfile::tempdir().unwrap();
    let good = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/good/titania-film.yaml");
    let text = std::fs::read_to_string(&good).unwrap().replace("relaxation: 2 ns", "relaxation: 0.5 ns");
    let case: Case = parse::<Titania>(&good, &text).unwrap();
    let Sample::Film(film) = &case.sample else { panic!("a film") };
    let film = film.plan().build(case.seed, &Interrupt::default()).unwrap();
    let mut rows = String::from("x,y,z,d,body\n");
    for sphere in &film.spheres {
        let Vec3([x, y, z]) = sphere.centre;
        writeln!(rows, "{x},{y},{z},{},{}", sphere.diameter, sphere.aggregate + 1).unwrap();
    }
    std::fs::write(place.path().join("film.csv"), rows).unwrap();
    let grown = "particles: 260\n    sides: [140 nm, 140 nm]\n    aggregates:\n      median: 12\n      largest: 24\n";
    assert!(text.contains(grown));
    let import = text.replace(grown, "sides: [140 nm, 140 nm]\n    import: {file: film.csv, unit: 1 nm}\n");
    let stop = ["--stop-after-steps", "3000"];
    assert_eq!(run(place.path(), &text, "grown", &stop).0, Some(75));
    assert_eq!(run(place.path(), &import, "read", &stop).0, Some(75));
    let series = file(place.path(), "read", "series.csv");
    assert!(series.iter().filter(|byte| **byte == b'\n').count() > 3);
    assert_eq!(series, file(place.path(), "grown", "series.csv"));
    assert_eq!(file(place.path(), "read", "events.jsonl"), file(place.path(), "grown", "events.jsonl"));
}

#[test]
fn a_film_of_one_layer_has_no_bulk() {
    let place = tempfile::tempdir().unwrap();
    std::fs::write(place.path().join("film.csv"), "x,y,z,d\n20,20,4,8\n40,40,4,8\n20,40,4,8\n40,20,4,8\n").unwrap();
    let text = "title: a layer\nmodel: {titania: {}}\nsample: {film: {sides: [60 nm, 60 nm], import: {file: film.csv, unit: 1 nm}}}\nexperiment: {spectroscopy: {relaxation: 0.05 ns, speed: 5 m/s, average: 0.1 ns, reversal: 1 ns, depth: 3 nm, retraction: 4 nm, tip: {radius: 5 nm, side: 30 nm}}}\n";
    let (status, message) = run(place.path(), text, "layer", &["--stop-after-steps", "150"]);
    assert_eq!(status, Some(75), "{message}");
}

/// The states of a case of an agglomerate after each step, as `see` is shown them, and the last one.
fn follow(text: &str, rows: &str, mut see: impl FnMut(usize, &System)) -> System {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("a.csv");
    std::fs::write(&file, rows).unwrap();
    let text = text.replace("a.csv", file.to_str().unwrap());
    let case = parse::<Titania>(Path::new("case.yaml"), &text).unwrap();
    let plan = Plan::<Tabulated>::of(&case);
    let mut each = Each(|stage: &mut RunningStage<'_, Plan<Tabulated>>, _: &Step| {
        see(stage.number, stage.simulation.system());
        ControlFlow::Continue(())
    });
    Driver::new(&plan, &Interrupt::default()).run(&mut each).unwrap().system
}

/// Momentum, angular momentum about the origin, and kinetic energy of bodies and spheres by themselves.
fn momenta(system: &System) -> (Vec3<f64>, Vec3<f64>, f64) {
    let (p, mut sums) = (&system.particles, (Vec3::zero(), Vec3::zero(), 0.0));
    let mut add = |x: Vec3<f64>, v: Vec3<f64>, m: f64, own: Vec3<f64>, turning: f64| {
        sums = (sums.0 + v * m, sums.1 + x.cross(v) * m + own, sums.2 + 0.5 * m * v.dot(v) + turning);
    };
    for k in (0..p.len()).filter(|&k| p.body[k] == 0) {
        let inertia = 0.4 * p.mass[k] * p.radius[k] * p.radius[k];
        add(p.x[k], p.v[k], p.mass[k], p.w[k] * inertia, 0.5 * inertia * p.w[k].dot(p.w[k]));
    }
    for body in &system.bodies {
        let turning = spin(body.pose.q_0, body.pose.q, body.l, body.moments).1;
        add(body.pose.x, body.v, body.mass, to_space(body.pose.q_0, body.pose.q, body.l), turning);
    }
    sums
}

const RELEASE: &str = "title: a collision\nmodel: {titania: {}}\nsample: {agglomerate: {import: {file: a.csv, unit: 1 nm, disconnected: true}}}\nexperiment: {release: {duration: 0.3 ns, dt: 0.5 ps}}\n";

#[test]
fn two_rigid_bodies_that_collide_keep_momentum_and_angular_momentum() {
    let rows = "x,y,z,d,body,vx,vy,vz,wx,wy,wz\n\
        0,0,0,8,1,20,0,0,0,0,0.2\n8,0,0,8,1,20,1.6,0,0,0,0.2\n4,6.9282,0,8,1,18.6,0.8,0,0,0,0.2\n\
        20,5,1,10,2,-20,0,0,0,0,0\n30,5,1,10,2,-20,0,0,0,0,0\n40,-2,0,9,0,-5,3,0,0,0,0\n";
    let mut first = None;
    let last = follow(RELEASE, rows, |_, system| {
        first.get_or_insert_with(|| momenta(system));
    });
    let ((p, l, energy), (p_end, l_end, energy_end)) = (first.unwrap(), momenta(&last));
    assert_eq!(last.bodies.len(), 2);
    // What the file says: masses times velocities.
    let mass = |d: f64| {
        last.particles.mass[(0..6).find(|&k| (last.particles.radius[k] - 0.5 * d - 0.075).abs() < 1e-9).unwrap()]
    };
    let given = Vec3([58.6 * mass(8.0) - 40.0 * mass(10.0) - 5.0 * mass(9.0), 2.4 * mass(8.0) + 3.0 * mass(9.0), 0.0]);
    assert!((p - given).norm() < 1e-2 * given.norm(), "{p:?} {given:?}");
    assert!((p_end - p).norm() < 1e-11 * p.norm().max(1.0), "{p:?} {p_end:?}");
    assert!((l_end - l).norm() < 1e-9 * l.norm(), "{l:?} {l_end:?}");
    assert!(energy_end < 0.9 * energy, "they have not met: {energy} {energy_end}");
}

const ROW: &str = "x,y,z,d\n0,0,0,8\n8,0,0,8\n16,0.2,0,8\n24,0,0.3,8\n";

fn stretched(keys: &str) -> String {
    format!(
        "title: a row\nmodel: {{titania: {{}}}}\nsample: {{agglomerate: {{import: {{file: a.csv, unit: 1 nm}}}}}}\nexperiment: {{stretching: {{relaxation: 0.01 ns, distance: 0.5 nm, dt: 0.5 ps, {keys}}}}}\n"
    )
}

#[test]
fn an_end_that_is_frozen_rests_and_a_spring_along_x_leaves_the_other_directions_alone() {
    let (mut start, mut aside) = (None, 0.0f64);
    let last = follow(&stretched("drawn: 1, hold: frozen, spring_along: x"), ROW, |stage, system| {
        if stage == 1 {
            start.get_or_insert(system.particles.x[system.place(0)]);
            aside = system.steerings[0].force.0[1..].iter().fold(aside, |most, f| most.max(f.abs()));
            assert_eq!((system.walls.len(), system.steerings.len()), (1, 1));
        }
    });
    assert_eq!((last.particles.x[last.place(0)], aside), (start.unwrap(), 0.0));
    assert!(last.particles.x[last.place(3)].0[0] > start.unwrap().0[0] + 24.2);
}

#[test]
fn the_far_end_of_the_spring_follows_the_ramp() {
    let (mut pulled, dt) = (Vec::new(), 0.5e-3);
    let last = follow(&stretched("drawn: 1, ramp: 0.04 ns, velocity: 5 m/s"), ROW, |stage, system| {
        if stage == 1 {
            pulled.push(system.steerings[1].drawn().0[0]);
        }
    });
    for (step, drawn) in (1..).zip(&pulled) {
        assert!((drawn - 5.0 * ramped_time(f64::from(step) * dt, 0.04)).abs() < 1e-12);
    }
    assert!((pulled[pulled.len() - 1] - 0.5).abs() < 5.0 * dt, "the distance is that of the case");
    assert_eq!(last.steerings[0].drawn(), Vec3::zero());
}

#[test]
fn a_spring_pulls_a_rigid_body_whole() {
    // One body in vacuum: springs along x alone, whose sum moves the centre of mass.
    let rows = "x,y,z,d,body\n0,0,0,8,1\n8,0,0,8,1\n60,0,0,8,2\n68,0,0,8,2\n";
    let text = stretched("hold: frozen, spring_along: x").replace("unit: 1 nm", "unit: 1 nm, disconnected: true");
    let mut moved = 0.0;
    let last = follow(&text, rows, |stage, system| {
        if stage == 1 {
            moved = system.steerings[0].travel.0[0];
        }
    });
    let body = last.bodies.iter().find(|body| body.wall == 0).unwrap();
    // The tension of the far end of 0.5 nm, 160 N/m: the body follows within the swing.
    assert!(
        moved > 0.2 && body.v.0[0] > 0.0 && (body.pose.x.0[0] - 64.0 - 12.0 - moved).abs() < 0.1,
        "{moved} {body:?}"
    );
    let apart = (last.particles.x[last.place(2)] - last.particles.x[last.place(3)]).norm();
    assert!((apart - 8.0).abs() < 1e-12);
}

#[test]
fn wrong_files_are_named_with_what_was_expected() {
    let place = tempfile::tempdir().unwrap();
    let write = |rows: &str| std::fs::write(place.path().join("a.csv"), rows).unwrap();
    let trouble = |text: &str| {
        let (code, trouble) = run(place.path(), text, "case", &[]);
        assert_eq!(code, Some(65), "{trouble}");
        trouble
    };
    write("x,y,z,d,body\n0,0,0,8,1\n8,0,0,8,1\n16,0,0,8,1\n");
    assert!(trouble(&stretched("drawn: 1")).contains("a.csv: one rigid body is at both ends"));
    assert!(trouble(&stretched("drawn: 2")).contains("a.csv: found 3 particles, expected at least 4"));
    let coarse = stretched("dt: 7 ps, drawn: 1, stiffness: 160 N/m").replace("dt: 0.5 ps, ", "");
    assert!(trouble(&coarse).contains("case.yaml:4: experiment.stretching.stiffness: found `160 N/m`"));
    let coarse = coarse.replace("160 N/m", "1 N/m");
    assert!(trouble(&coarse).contains("case.yaml:4: experiment.stretching.dt: found `7 ps`, expected more than zero"));
    write("x,y,z,d\n0,0,0,0.5\n0.5,0,0,0.5\n");
    let thin = trouble(RELEASE);
    assert!(
        thin.contains("model.titania.core_gap: found `0.57 nm`, expected less than the smallest diameter, 0.5 nm"),
        "{thin}"
    );
    let film = "title: a film\nmodel: {titania: {}}\nsample: {film: {sides: [60 nm, 60 nm], import: {file: a.csv, unit: 1 nm}}}\nexperiment: {spectroscopy: {depth: 30 nm, tip: {radius: 5 nm, side: 30 nm}}}\n";
    write("x,y,z,d\n0,0,6,8\n8,0,6,8\n");
    assert!(
        trouble(film).contains("a.csv: the lowest sphere ends at z = 2 nm, expected one that touches the floor, z = 0")
    );
    let narrow = film.replace("60 nm, 60 nm", "60 nm, 9 nm").replace("5 nm, side: 30 nm", "2 nm, side: 5 nm");
    assert!(trouble(&narrow).contains("case.yaml:3: sample.film.sides[1]: found `9 nm`"), "{}", trouble(&narrow));
}

/// The coordinates in the first frame of a stage, by id.
fn places(place: &Path, name: &str, stage: &str) -> Vec<[f64; 3]> {
    let frame = String::from_utf8(file(place, name, &format!("frames/{stage}.000000.xyz"))).unwrap();
    assert!(frame.contains("Properties=species:S:1:id:I:1:body:I:1:wall:I:1:radius:R:1:mass:R:1:pos:R:3"));
    let numbers = |line: &str| line.split(' ').skip(6).take(3).map(|word| word.parse().unwrap()).collect::<Vec<f64>>();
    frame.lines().skip(2).map(|line| numbers(line).try_into().unwrap()).collect()
}

/// The shift that a run states.
fn shift(place: &Path, name: &str) -> [f64; 3] {
    let resolved = String::from_utf8(file(place, name, "case.resolved.yaml")).unwrap();
    let stated = resolved.split_once("shift of the imported spheres into the box: ").expect(&resolved).1;
    let numbers: Vec<f64> = stated
        .lines()
        .next()
        .unwrap()
        .split(", ")
        .map(|part| part.strip_suffix(" nm").unwrap().parse().unwrap())
        .collect();
    numbers.try_into().unwrap()
}

#[test]
fn the_shift_leads_back_to_the_coordinates_of_the_file_and_own_frames_are_read_without_a_remark() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let chain = [[-31.5, 7.25, 1.0], [-23.5, 7.25, 1.0], [-15.5, 7.25, 1.5], [-8.0, 10.0, 2.0]];
    let write = |name: &str, rows: &[[f64; 3]]| {
        let rows: String = rows.iter().map(|[x, y, z]| format!("{x},{y},{z},4\n")).collect();
        std::fs::write(place.join(name), format!("x,y,z,r\n{rows}")).unwrap();
    };
    write("chain.csv", &chain);
    write("film.csv", &[[62.0, 70.0, 4.0], [70.0, 70.0, 4.0], [78.0, 70.0, 4.0]]);
    let import = "import: {file: chain.csv, unit: 1 nm, disconnected: true}";
    let digits = "output: {digits: all}\n";
    let soot = |more: &str| {
        format!(
            "title: a\nmodel: {{soot: {{necks: S}}}}\nsample: {{aggregate: {{{import}{more}}}}}\nexperiment: {{restructuring: {{dt: 1 fs, duration: 1 ps}}}}\n{digits}"
        )
    };
    let release = format!(
        "title: a\nmodel: {{titania: {{}}}}\nsample: {{agglomerate: {{{import}}}}}\nexperiment: {{release: {{duration: 1 ps, dt: 0.5 ps}}}}\n{digits}"
    );
    let film = "title: a\nmodel: {titania: {}}\nsample: {film: {sides: [140 nm, 140 nm], import: {file: film.csv, unit: 1 nm}}}\nexperiment: {spectroscopy: {relaxation: 10 ps, average: 0.1 ns, depth: 1 nm, tip: {radius: 5 nm, side: 30 nm}}}\n".to_string() + digits;
    for (name, text, stage, given) in [
        ("centred", soot(""), "restructuring", &chain[..]),
        ("released", release, "release", &chain),
        ("film", film, "relaxation", &[[62.0, 70.0, 4.0], [70.0, 70.0, 4.0], [78.0, 70.0, 4.0]]),
    ] {
        let (code, trouble) = run(place, &text, name, &["--stop-after-steps", "3"]);
        assert!(matches!(code, Some(0 | 75)), "{name}: {trouble}");
        let shift = shift(place, name);
        for (found, given) in places(place, name, stage).iter().zip(given) {
            for axis in 0..3 {
                assert!(
                    (found[axis] - shift[axis] - given[axis]).abs() < 1e-12,
                    "{name}: {found:?} {given:?} {shift:?}"
                );
            }
        }
        let frame = place.join("run").join(name).join(format!("frames/{stage}.000000.xyz"));
        let inspected = Command::new(env!("CARGO_BIN_EXE_veridem")).arg("inspect").arg(frame).output().unwrap();
        assert_eq!((inspected.status.code(), String::from_utf8(inspected.stderr).unwrap()), (Some(0), String::new()));
    }
    assert_ne!(shift(place, "centred"), [0.0; 3]);
    assert_eq!(shift(place, "film"), [0.0; 3]);
}

#[test]
fn a_film_with_necks_from_files_does_what_the_generated_one_does() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let good = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/good/titania-film-necks.yaml");
    let text = std::fs::read_to_string(&good).unwrap().replace("relaxation: 1 ns", "relaxation: 0.25 ns");
    let case: Case = parse::<Titania>(&good, &text).unwrap();
    let Sample::Film(film) = &case.sample else { panic!("a film") };
    let film = film.plan().build(case.seed, &Interrupt::default()).unwrap();
    let (mut rows, mut joined) = (String::from("x,y,z,d\n"), String::new());
    for sphere in &film.spheres {
        let Vec3([x, y, z]) = sphere.centre;
        writeln!(rows, "{x},{y},{z},{}", sphere.diameter).unwrap();
    }
    let spheres: Vec<Sphere> =
        film.spheres.iter().map(|s| Sphere { centre: s.centre, radius: 0.5 * s.diameter }).collect();
    let mut first = 0;
    for aggregate in film.spheres.chunk_by(|a, b| a.aggregate == b.aggregate) {
        let these = &spheres[first..first + aggregate.len()];
        for (i, j) in necks(these, 0.01, NeckLength::Touching, true, &Interrupt::default()).unwrap() {
            writeln!(joined, "{},{}", first + i, first + j).unwrap();
        }
        first += aggregate.len();
    }
    std::fs::write(place.join("film.csv"), rows).unwrap();
    std::fs::write(place.join("necks.csv"), &joined).unwrap();
    let grown = "particles: 160\n    sides: [140 nm, 140 nm]\n    aggregates:\n      median: 12\n      largest: 24\n";
    assert!(text.contains(grown));
    let import = "sides: [140 nm, 140 nm]\n    import: {file: film.csv, unit: 1 nm, necks: necks.csv}\n";
    let import = text.replace(grown, import);
    let stop = ["--stop-after-steps", "3000"];
    assert_eq!(run(place, &text, "grown", &stop).0, Some(75));
    assert_eq!(run(place, &import, "read", &stop).0, Some(75));
    for name in ["series.csv", "events.jsonl", "frames/relaxation.000000.xyz", "frames/relaxation.000000.bonds"] {
        assert_eq!(file(place, "read", name), file(place, "grown", name), "{name}");
    }
    let kinds = String::from_utf8(file(place, "read", "frames/relaxation.000000.bonds")).unwrap();
    let bonds = kinds.lines().skip(9).filter(|line| line.split(' ').nth(2) == Some("2")).count();
    assert!(bonds > 100 && bonds <= joined.lines().count(), "{bonds} necks, those of the floor are rigid");

    // A neck that joins distant spheres is refused by its line.
    std::fs::write(place.join("necks.csv"), format!("{joined}0,{}\n", film.spheres.len() - 1)).unwrap();
    let (code, trouble) = run(place, &import, "wrong", &[]);
    assert_eq!(code, Some(65));
    assert!(trouble.contains(&format!("necks.csv:{}", joined.lines().count() + 1)), "{trouble}");
}
