//! Necks of different strengths: do the weakest break first, is a strength kept, and does a single neck break where its law says?

#[path = "common/program.rs"]
mod program;

use program::veridem;
use serde_json::Value;
use std::path::Path;

/// The pairs whose necks have broken, in this order, and the strengths that are told.
fn broken(run: &Path) -> (Vec<usize>, Vec<f64>) {
    let text = std::fs::read_to_string(run.join("events.jsonl")).expect("events");
    let event = |line: &str| serde_json::from_str::<Value>(line).expect("an event")["event"].as_str().map(String::from);
    let breaks = |event: String| {
        let (ids, strength) = event.strip_prefix("the neck of ")?.split_once(" breaks")?;
        let (first, second) = ids.split_once(" and ")?;
        let strength =
            strength.strip_prefix(": its strength is ").map(|number| number.parse::<f64>().expect("a number"));
        let [first, second] = [first, second].map(|id| id.parse::<usize>().expect("an id"));
        assert_eq!((first % 2, second), (0, first + 1));
        Some((first / 2, strength))
    };
    let (pairs, strengths): (_, Vec<_>) = text.lines().filter_map(|line| event(line).and_then(breaks)).unzip();
    (pairs, strengths.into_iter().flatten().collect())
}

/// Number of pairs.
const PAIRS: usize = 14;

/// Runs pairs that fly apart, all in the same way, with necks of these strengths.
fn parting(place: &Path, name: &str, seed: u64, strengths: &str) -> Result<(Vec<usize>, Vec<f64>), String> {
    let rows = (0..2 * PAIRS).map(|k| {
        let side = if k % 2 == 0 { -1.0 } else { 1.0 };
        format!("{},{},0,14,{},0,0\n", 14.0 * side, 100 * (k / 2), 12.0 * side)
    });
    std::fs::write(place.join("pairs.csv"), format!("x,y,z,r,vx,vy,vz\n{}", rows.collect::<String>())).expect("a file");
    let case = format!(
        "title: Pairs that part\nseed: {seed}\nmodel:\n  soot:\n    necks: S\n    hamaker_constant: 0 J\n    capillary_force: 0 nN\n    \
         break_stress: {{tension: 1.27 GPa, shear: 9 GPa, neck_radius: 5 nm}}\n    neck_strengths: {strengths}\n\
         sample: {{aggregate: {{neck_fraction: 1, import: {{file: pairs.csv, unit: 1 nm, disconnected: true}}}}}}\n\
         experiment: {{restructuring: {{dt: 0.25 fs, duration: 0.2 ps}}}}\n"
    );
    std::fs::write(place.join(format!("{name}.yaml")), case).expect("a file");
    let output = veridem(place, &["--quiet", "run", &format!("{name}.yaml")]);
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    Ok(broken(&place.join("run").join(name)))
}

#[test]
fn necks_break_in_the_order_of_their_strengths_and_the_strongest_hold() {
    let place = tempfile::tempdir().unwrap();
    // From 0.2 to 0.92, in a disorder; every fourth holds.
    let strength = |pair: usize| if pair % 4 == 3 { 4.0 } else { f64::from(200 + 45 * ((5 * pair as u32) % 17)) / 1e3 };
    let rows: String = (0..PAIRS).map(|pair| format!("{},{},{}\n", 2 * pair, 2 * pair + 1, strength(pair))).collect();
    std::fs::write(place.path().join("strengths.csv"), format!("i,j,strength\n{rows}")).unwrap();
    let mut expected: Vec<usize> = (0..PAIRS).filter(|&pair| strength(pair) < 1.0).collect();
    expected.sort_by(|&a, &b| strength(a).total_cmp(&strength(b)));
    let told: Vec<f64> = expected.iter().map(|&pair| strength(pair)).collect();
    assert_eq!(parting(place.path(), "read", 1, "{file: strengths.csv}").unwrap(), (expected, told.clone()));

    // Frames have the strengths of the necks that hold.
    for (frame, necks) in [("000000", PAIRS), ("000001", PAIRS - told.len())] {
        let text = std::fs::read_to_string(place.path().join(format!("run/read/frames/restructuring.{frame}.bonds")));
        let text = text.expect("a frame");
        let mut lines = text.lines().skip_while(|line| !line.starts_with("ITEM: ENTRIES"));
        let header: Vec<&str> = lines.next().expect("a header").split(' ').skip(2).collect();
        let place = |name: &str| header.iter().position(|column| *column == name).expect("a column");
        let rows = lines.map(|line| {
            let words: Vec<&str> = line.split(' ').collect();
            ["batom1", "btype", "strength"].map(|name| words[place(name)].parse::<f64>().expect("a number"))
        });
        let found: Vec<(usize, f64)> =
            rows.filter(|row| row[1] == 2.0).map(|[id, _, strength]| (id as usize / 2, strength)).collect();
        assert_eq!(found.len(), necks, "{frame}");
        assert!(found.iter().all(|&(pair, found)| (found / strength(pair) - 1.0).abs() < 1e-6), "{found:?}");
    }
}

#[test]
fn strengths_of_a_file_are_in_the_checkpoint() {
    let place = tempfile::tempdir().unwrap();
    let rows: String = (0..PAIRS).map(|pair| format!("{},{},0.{}\n", 2 * pair + 1, 2 * pair, 99 - 5 * pair)).collect();
    std::fs::write(place.path().join("strengths.csv"), rows).unwrap();
    let whole = parting(place.path(), "whole", 1, "{file: strengths.csv}").unwrap();
    let run = ["--quiet", "run", "whole.yaml", "--name", "parts", "--stop-after-steps", "120"];
    assert_eq!(veridem(place.path(), &run).status.code(), Some(75));
    let parts = place.path().join("run/parts");
    assert!((1..PAIRS).contains(&broken(&parts).0.len()), "{:?}", broken(&parts));
    for file in ["strengths.csv", "run/parts/inputs/strengths.csv"] {
        std::fs::remove_file(place.path().join(file)).unwrap();
    }
    assert!(veridem(place.path(), &["--quiet", "resume", "run/parts"]).status.success());
    assert_eq!(broken(&parts), whole);
}

#[test]
fn a_file_that_lacks_a_neck_is_refused() {
    let place = tempfile::tempdir().unwrap();
    std::fs::write(place.path().join("strengths.csv"), "0,1,1\n2,3,1\n").unwrap();
    let refused = parting(place.path(), "lacks", 1, "{file: strengths.csv}").unwrap_err();
    assert_eq!(refused, "strengths.csv: has no strength of the neck of 4 and 5\n");
    std::fs::write(place.path().join("strengths.csv"), "0,1,1\n2,3,0\n").unwrap();
    let refused = parting(place.path(), "zero", 1, "{file: strengths.csv}").unwrap_err();
    assert_eq!(refused, "strengths.csv:2: found the strength `0`, expected more than zero\n");
}

#[test]
fn drawn_strengths_are_those_of_the_seed() {
    let place = tempfile::tempdir().unwrap();
    let drawn = |name, seed| parting(place.path(), name, seed, "{weibull: {scale: 0.8, shape: 2}}").unwrap();
    let (first, again, other) = (drawn("first", 1), drawn("again", 1), drawn("other", 2));
    assert!(first.0.len() > PAIRS / 2, "{first:?}");
    assert_eq!(first, again);
    assert_ne!(first, other);
}

#[test]
fn a_pulled_neck_breaks_where_its_spring_pulls_with_its_strength() {
    let place = tempfile::tempdir().unwrap();
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/soot/neck-pull.yaml");
    let output = veridem(place.path(), &["--quiet", "run", case.to_str().unwrap()]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let run = place.path().join("run/neck-pull");
    assert_eq!(broken(&run), (vec![0], vec![]));

    // Units of nm, ns and ag: springs P, 5 GPa over a radius of 5 nm, 1 m/s, five steps of 0.1 fs between two examinations.
    let (k_n, eta_n, strength, examined) = (1e9, 1.25e6, 5e3 * std::f64::consts::PI * 25.0, 5e-7);
    let results: Value =
        serde_yaml::from_str(&std::fs::read_to_string(run.join("results.yaml")).unwrap()).expect("results");
    let found = |name: &str| results[format!("leg: {name} at which the neck breaks")]["value"].as_f64().unwrap();
    // Results have four digits.
    let within = |found: f64, least: f64, most: f64| ((1.0 - 1e-3) * least..(1.0 + 1e-3) * most).contains(&found);
    let elongation = strength / k_n;
    assert!(within(found("elongation"), elongation, elongation + examined), "{}", found("elongation"));
    assert!(within(found("strain"), elongation / 28.0, (elongation + examined) / 28.0), "{}", found("strain"));
    let force = 1e-3 * (strength + eta_n);
    assert!(within(found("force"), force, force + 1e-3 * k_n * examined), "{}", found("force"));

    // The curve up to there: the spring by the elongation, and the dashpot by the velocity.
    let mut reader = csv::Reader::from_path(run.join("series.csv")).unwrap();
    let mut place = |name: &str| reader.headers().unwrap().iter().position(|header| header == name).unwrap();
    let (force, stretched) = (place("force x on the second [pN]"), place("elongation [nm]"));
    let rows: Vec<[f64; 2]> =
        reader.records().map(|row| [force, stretched].map(|k| row.as_ref().unwrap()[k].parse().unwrap())).collect();
    let (held, parted): (Vec<&[f64; 2]>, Vec<&[f64; 2]>) =
        rows[1..].iter().partition(|[_, stretched]| *stretched < elongation);
    assert!(held.len() > 300 && parted.len() > 50, "{} {}", held.len(), parted.len());
    for [force, stretched] in held {
        assert!((force - eta_n - k_n * stretched).abs() < 1e-3 * eta_n, "{force} at {stretched}");
    }
    assert!(parted[1..].iter().all(|[force, _]| *force == 0.0));
}
