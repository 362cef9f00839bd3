//! Do spheres that overlap, or whose places are rounded, stay at rest with necks as given, and is the energy accounted for when such necks break?

#[path = "common/program.rs"]
mod program;

use program::veridem;
use std::path::Path;
use veridem::interrupt::Interrupt;
use veridem::papers::parse;
use veridem::papers::soot::{self, Plan};
use veridem::run::{Study, advance};
use veridem::simulation::{Settings, Simulation};
use veridem::spec::Vec3;
use veridem::spec::soot::{Along, Soot};
use veridem::system::System;

const DT: f64 = 50e-6;

fn plan(file: &str, keys: &str) -> Plan<Along> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/aggregates").join(file);
    let import = format!("import: {{file: {}, unit: 1 nm}}", path.display());
    let text = format!(
        "title: sintered\nmodel: {{soot: {{hamaker_constant: 0 J}}}}\nsample: {{aggregate: {{{import}, {keys}}}}}\nexperiment: {{deposition: {{}}}}\n"
    );
    Plan::of(&parse::<soot::Soot>(Path::new("sintered.yaml"), &text).expect("a case"), Along)
}

fn begun(plan: &Plan<Along>) -> Simulation<Soot> {
    let system: System = plan.initial(&Interrupt::default()).expect("an aggregate at rest");
    Simulation::new(plan.model(0, &system), system, Settings::new(DT).skin(1.4)).expect("a stable step")
}

fn stored(simulation: &Simulation<Soot>) -> f64 {
    simulation.ledger().stored.iter().sum()
}

/// Largest way of a sphere in some steps, nm.
fn way(simulation: &mut Simulation<Soot>, steps: u64) -> f64 {
    let places = |simulation: &Simulation<Soot>| {
        let particles = &simulation.system().particles;
        let mut places: Vec<(u32, Vec3<f64>)> = particles.id.iter().copied().zip(particles.x.iter().copied()).collect();
        places.sort_by_key(|(id, _)| *id);
        places
    };
    let before = places(simulation);
    advance(simulation, steps).expect("a stable step");
    before.iter().zip(places(simulation)).map(|(a, b)| (a.1 - b.1).norm()).fold(0.0, f64::max)
}

#[test]
fn spheres_as_given_stay_where_they_are_with_necks_or_without() {
    for (file, necks) in [("sintered.xyz", 3), ("one_decimal.dat", 29), ("pyfracval_overlapping.dat", 19)] {
        for fraction in [1.0, 0.5, 0.0] {
            let keys = format!("neck_length: as-given, neck_distance: 0.1 nm, neck_fraction: {fraction}");
            let mut simulation = begun(&plan(file, &keys));
            assert_eq!(simulation.system().necks.len(), (f64::from(necks) * fraction) as usize, "{file}");
            assert!(stored(&simulation) < 1e-15, "{file}: {}", stored(&simulation));
            let way = way(&mut simulation, 2000);
            assert!(way < 1e-10, "{file}: {way}");
        }
    }
}

#[test]
fn rings_of_overlaps_have_necks_if_they_are_asked_for() {
    let all = plan("sintered.xyz", "neck_length: as-given, neck_fraction: 1, neck_cycles: true");
    assert_eq!(begun(&all).system().necks, [(0, 1), (0, 2), (1, 2), (1, 4)]);
    let tree = plan("sintered.xyz", "neck_length: as-given, neck_fraction: 1");
    // The overlaps with the third sphere are 0.44 nm, that of the first two is 2 nm.
    assert_eq!(begun(&tree).system().necks, [(0, 1), (0, 2), (1, 4)]);
}

#[test]
fn an_overlap_whose_neck_breaks_keeps_its_place_and_no_energy_appears() {
    let plan = plan("sintered.xyz", "neck_length: as-given, neck_fraction: 1");
    let mut simulation = begun(&plan);
    assert_eq!(simulation.break_necks(|_, _, _, _| true).expect("a list of neighbours").len(), 3);
    assert_eq!(stored(&simulation), 0.0);
    assert!(way(&mut simulation, 2000) < 1e-10);
    // Pushed together they rebound: with the gap at rest until they have parted, as whole spheres thereafter. What springs of whole spheres held in these overlaps would be millions of zJ.
    let mut system = simulation.into_system_with_springs();
    for p in 0..system.particles.len() {
        let sign = if system.particles.id[p] == 4 { 1.0 } else { -0.25 };
        system.particles.v[p] = Vec3::new(-20.0 * sign, 0.0, 0.0);
    }
    let residual = |dt: f64| {
        let settings = Settings::new(dt).skin(1.4);
        let mut simulation = Simulation::new(plan.model(0, &system), system.clone(), settings).expect("a stable step");
        let kinetic = simulation.ledger().kinetic;
        advance(&mut simulation, (2.0 / dt) as u64).expect("a stable step");
        simulation.ledger().physical_residual().abs() / kinetic
    };
    let (coarse, fine) = (residual(DT), residual(DT / 4.0));
    assert!(coarse < 0.01 && fine < 0.4 * coarse, "{coarse} {fine}");
}

#[test]
fn a_neck_as_given_goes_on_from_a_snapshot_with_the_same_bits() {
    let plan = plan("sintered.xyz", "neck_length: as-given, neck_fraction: 0.7");
    let pushed = || {
        let mut system = plan.initial(&Interrupt::default()).expect("an aggregate at rest");
        system.particles.v[4] = Vec3::new(-15.0, 3.0, 0.0);
        Simulation::new(plan.model(0, &system), system, Settings::new(DT).skin(1.4)).expect("a stable step")
    };
    let (mut whole, mut half) = (pushed(), pushed());
    advance(&mut whole, 1000).expect("a stable step");
    advance(&mut half, 400).expect("a stable step");
    let settings = Settings::new(DT).skin(1.4);
    let mut resumed =
        Simulation::resume(plan.model(0, half.system()), settings, half.snapshot()).expect("a valid snapshot");
    advance(&mut resumed, 600).expect("a stable step");
    assert_eq!(whole.snapshot(), resumed.snapshot());
}

#[test]
fn import_check_and_run_agree_on_necks_and_energy() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/aggregates");
    let place = tempfile::tempdir().expect("a folder");
    for name in ["sintered.xyz", "one_decimal.dat"] {
        std::fs::copy(data.join(name), place.path().join(name)).expect("a copy");
        for (keys, options, accepted) in [
            ("neck_distance: 0.1 nm", &["--neck-distance", "0.1 nm"][..], false),
            (
                "neck_distance: 0.1 nm, neck_length: as-given",
                &["--neck-distance", "0.1 nm", "--neck-length", "as-given"],
                true,
            ),
        ] {
            let imported = veridem(place.path(), &[&["import", name, "--unit", "1 nm", "--json"], options].concat());
            let told: serde_json::Value = serde_json::from_slice(&imported.stdout).expect("JSON");
            let start = &told["at_start"][0];
            assert_eq!(start["refusal"].is_null(), accepted, "{told}");
            assert_eq!(start["springs"].as_f64().is_some_and(|energy| energy < 1e-15), accepted, "{told}");
            let case = format!(
                "title: {name}\nmodel: {{soot: {{}}}}\nsample: {{aggregate: {{import: {{file: {name}, unit: 1 nm}}, {keys}}}}}\nexperiment: {{deposition: {{duration: 2 steps}}}}\n"
            );
            std::fs::write(place.path().join("case.yaml"), case).expect("a case");
            for command in [&["check", "case.yaml"][..], &["run", "case.yaml", "--force"]] {
                let done = veridem(place.path(), command);
                let text = String::from_utf8_lossy(&done.stderr);
                assert_eq!(done.status.code(), Some(if accepted { 0 } else { 65 }), "{text}");
                // All three say the same.
                let refusal = start["refusal"].as_str().unwrap_or_default();
                assert!(text.contains(refusal.trim_start_matches("sample.aggregate: ")), "{refusal}\n{text}");
                assert!(accepted || text.contains("`neck_length: as-given`"), "{text}");
            }
        }
    }
}
