//! Is a value that makes no sense refused by key and line, wherever it stands?

#[path = "common/trials.rs"]
mod trials;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rayon::prelude::*;
use serde_yaml::Value;
use std::panic::catch_unwind;
use std::path::{Path, PathBuf};
use std::time::Instant;
use trials::setting;
use veridem::error::Error;
use veridem::interrupt::Interrupt;
use veridem::papers::PAPERS;

const VALUES: [&str; 14] = [
    ".nan",
    ".inf",
    "-.inf",
    "0",
    "-1",
    "1e300",
    "1e-300",
    "12 parsec",
    "~",
    "[1, 2]",
    "1e300 nm",
    "0 steps",
    "1 ag",
    "1e30 d_0",
];

fn files(folder: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() { folders.push(path) } else { found.push(path) }
        }
    }
    found.sort();
    found
}

/// The places of all values in a case.
fn places(value: &Value, place: &[String], found: &mut Vec<Vec<String>>) {
    let below = |part: String| [place, &[part]].concat();
    match value {
        Value::Mapping(section) => {
            section.iter().for_each(|(key, value)| places(value, &below(key.as_str().unwrap().into()), found));
        }
        Value::Sequence(list) => {
            list.iter().enumerate().for_each(|(at, value)| places(value, &below(at.to_string()), found));
        }
        _ => found.push(place.to_vec()),
    }
}

fn with(case: &Value, place: &[String], value: Value) -> String {
    let mut changed = case.clone();
    let target = place.iter().fold(&mut changed, |at, part| match at {
        Value::Sequence(list) => &mut list[part.parse::<usize>().unwrap()],
        section => section.get_mut(part.as_str()).unwrap(),
    });
    *target = value;
    serde_yaml::to_string(&changed).unwrap()
}

/// Tries every value in the place of every number of a case; returns their number, and the cases that are accepted.
fn each(file: &Path) -> (usize, Vec<(String, String)>) {
    let text = std::fs::read_to_string(file).unwrap();
    let mut case: Value = serde_yaml::from_str(&PAPERS.parse(file, &text).unwrap().resolved).unwrap();
    case.as_mapping_mut().unwrap().remove("derived");
    let (mut all, mut accepted) = (Vec::new(), Vec::new());
    places(&case, &[], &mut all);
    let number = all.len();
    for place in all {
        for value in VALUES {
            let (text, what) = (with(&case, &place, serde_yaml::from_str(value).unwrap()), place.join("."));
            let what = format!("{}: {what}: {value}", file.file_name().unwrap().display());
            match catch_unwind(|| PAPERS.parse(file, &text).map(drop)).unwrap_or_else(|_| panic!("{what} panics")) {
                Ok(()) => accepted.push((what, text)),
                Err(Error::Input(problems)) => {
                    for problem in problems {
                        assert!(problem.line.is_some() && !problem.key.is_empty(), "{what}: {problem}");
                    }
                }
                Err(error) => panic!("{what}: {error}"),
            }
        }
    }
    (VALUES.len() * number, accepted)
}

/// Places the spheres of an accepted case and takes its first steps, during which every number stays finite, or it is refused by a name.
fn try_out(what: &str, text: &str) {
    let begun = Instant::now();
    let plan = || PAPERS.parse(Path::new("case.yaml"), text).and_then(|job| job.plan(&Interrupt::default()));
    match catch_unwind(plan).unwrap_or_else(|_| panic!("{what} panics")) {
        Ok(_) | Err(Error::Halted(..) | Error::NoInput(..)) => {}
        Err(Error::Input(problems)) => assert!(!problems.is_empty(), "{what}"),
        Err(error) => panic!("{what}: {error}"),
    }
    assert!(begun.elapsed().as_secs() < 120, "{what} takes {:?}", begun.elapsed());
}

/// Of the accepted cases this many are tried out for each unit of `VERIDEM_TRIALS`.
const TRIED: usize = 25;

#[test]
fn a_value_that_makes_no_sense_is_refused_by_key_and_line_and_the_others_can_be_run() {
    let (numbers, accepted): (Vec<_>, Vec<_>) = files("cases").par_iter().map(|file| each(file)).unzip();
    let (tried, mut accepted) = (numbers.iter().sum::<usize>(), accepted.concat());
    // Placing the spheres of the full sizes takes a minute.
    accepted.retain(|(what, _)| !what.contains("-full.yaml"));
    let trials = setting("VERIDEM_TRIALS") as usize;
    println!("{tried} values tried, {} accepted, {} of these run", accepted.len(), TRIED * trials);
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut drawn = || &accepted[(rng.next_u64() % accepted.len() as u64) as usize];
    let drawn: Vec<_> = (0..TRIED * trials).map(|_| drawn()).collect();
    drawn.par_iter().with_max_len(1).for_each(|(what, text)| try_out(what, text));
}
