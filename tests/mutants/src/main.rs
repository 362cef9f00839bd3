//! Changes the specification and the engine in small ways and looks whether their tests notice.
//!
//!     cargo run -p veridem-mutants -- sweep [NAME]
//!     cargo run -p veridem-mutants -- all [NAME]
//!     cargo run -p veridem-mutants -- engine [NAME]
//!     cargo run -p veridem-mutants -- table
//!
//! `sweep` multiplies the result of each equation of the list by 1.01, 0 and -1: the laws that its documentation lists must notice. `all`
//! changes operators, comparisons, constants, selected branches and functions of the specification one at a time: any of its laws may notice.
//! `engine` does the same with the engine, where it also leaves out conditions, assignments and calls: any test of it may notice. With a
//! name, only equations or files whose name contains it are changed. One copy is compiled with all mutants, of which an
//! environment variable activates one. The process fails if a mutant of the sweep survives, or if others than `tests/mutants/survivors.txt` lists do.
//!
//! `all` and `engine` write down what becomes of each mutant as they go, in an order without order: interrupted, they have tried a sample, and the same command
//! continues. `table` writes what is known of the specification into `docs/verification.md`.

mod all;
mod copy;
mod engine;
mod kept;
mod rewrite;
mod run;
mod table;

use copy::Copy;
use rewrite::{Entry, Kind};
use run::{ENDLESS, Laws, NONE, SWEEP, in_parallel, patience};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let (command, name) = match &words[..] {
        [command] => (command.as_str(), ""),
        [command, name] => (command.as_str(), name.as_str()),
        _ => ("", ""),
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("the repository");
    let survive = match command {
        "sweep" => sweep(&copy::build(&root, Kind::Scaled), name),
        "all" => all::all(&copy::build(&root, Kind::Changed), &root, name),
        "engine" => all::all(&copy::build(&root, Kind::Engine), &root, name),
        "table" => table::write(&copy::build(&root, Kind::Changed), &root),
        _ => {
            eprintln!("sweep [NAME], all [NAME], engine [NAME] or table");
            return ExitCode::from(64);
        }
    };
    if survive { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

/// Scales the result of each equation; whether its own laws miss one of its mutants.
fn sweep(copy: &Copy, name: &str) -> bool {
    let laws = Laws::of(copy);
    let listed: Vec<_> = copy.listed.iter().filter(|equation| equation.id.contains(name)).collect();
    let missed = in_parallel(&listed, |_, equation| {
        let own: Vec<&str> = equation.laws.iter().filter_map(|law| laws.named(&equation.file, law)).collect();
        let begin = Instant::now();
        if own.is_empty() || own.len() < equation.laws.len() || !laws.hold(&own, Some(NONE), None, ENDLESS, SWEEP) {
            return vec!["laws that hold and are found"];
        }
        let patience = patience(begin.elapsed());
        let factors = ["1.01", "0", "-1"].into_iter().zip(equation.first..);
        factors
            .filter(|(_, mutant)| laws.hold(&own, Some(*mutant), None, patience, SWEEP))
            .map(|(factor, _)| factor)
            .collect()
    });
    for (equation, factors) in listed.iter().zip(&missed).filter(|(_, factors)| !factors.is_empty()) {
        println!(
            "{} ({}, spec/{}): not noticed: {}",
            equation.id,
            equation.function,
            equation.file,
            factors.join(", ")
        );
    }
    let count = missed.iter().map(Vec::len).sum::<usize>();
    println!("{} functions, {} mutants, {count} not noticed", listed.len(), 3 * listed.len());
    // Several equations may be one function.
    let is_changed = |[file, _, function]: &&Entry| {
        copy.listed.iter().any(|equation| equation.file == *file && equation.function == *function)
    };
    let left: Vec<&str> =
        copy.entries.iter().filter(|entry| !is_changed(entry)).map(|entry| entry[1].as_str()).collect();
    println!("{} equations, {} not changed: {}", copy.entries.len(), left.len(), left.join(", "));
    count > 0 || !left.is_empty()
}
