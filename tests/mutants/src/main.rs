//! Changes the specification in small ways and looks whether its laws notice.
//!
//!     cargo run -p veridem-mutants -- sweep [NAME]
//!     cargo run -p veridem-mutants -- all [NAME]
//!
//! `sweep` multiplies the result of each equation of the list by 1.01, 0 and -1: the laws that its documentation lists must notice. `all`
//! changes operators, comparisons, constants, selected branches and functions one at a time: any law of the specification may notice. With a
//! name, only equations or files whose name contains it are changed. One copy of the specification is compiled with all mutants, of which an
//! environment variable activates one. The process fails if a mutant of the sweep survives, or if others than `tests/mutants/survivors.txt` lists do.

mod copy;
mod rewrite;
mod run;

use copy::Copy;
use rewrite::{Kind, Mutant};
use run::{ENDLESS, Laws, NONE, in_parallel, patience};
use std::collections::BTreeMap;
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
        "all" => all(&copy::build(&root, Kind::Changed), &root, name),
        _ => {
            eprintln!("sweep [NAME] or all [NAME]");
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
        if own.is_empty() || own.len() < equation.laws.len() || !laws.hold(&own, Some(NONE), None, ENDLESS) {
            return vec!["laws that hold and are found"];
        }
        let patience = patience(begin.elapsed());
        let factors = ["1.01", "0", "-1"].into_iter().zip(equation.first..);
        factors.filter(|(_, mutant)| laws.hold(&own, Some(*mutant), None, patience)).map(|(factor, _)| factor).collect()
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
    println!("{} equations, {} mutants, {count} not noticed", listed.len(), 3 * listed.len());
    count > 0
}

/// Activates every mutant; whether one survives that is not on the list of those that may.
fn all(copy: &Copy, root: &Path, name: &str) -> bool {
    let mut laws = Laws::of(copy);
    laws.record(&root.join("target/mutants"));
    let mutants: Vec<&Mutant> = copy.mutants.iter().filter(|mutant| mutant.file.contains(name)).collect();
    let noticed = in_parallel(&mutants, |_, mutant| {
        let [own, others] = laws.reaching(mutant.id, &mutant.file);
        let notice =
            |names: &[&str]| !names.is_empty() && !laws.hold(names, Some(mutant.id), None, patience(laws.time(names)));
        if notice(&own) { (true, true) } else { (false, others.chunks(8).any(notice)) }
    });
    let mut files: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
    for (mutant, (own, any)) in mutants.iter().zip(&noticed) {
        let counts = files.entry(&mutant.file).or_default();
        counts[0] += 1;
        counts[1] += usize::from(*own);
        counts[2] += usize::from(*own || *any);
    }
    let expected = std::fs::read_to_string(root.join("tests/mutants/survivors.txt")).unwrap_or_default();
    let (mut survivors, mut unexpected) = (0, 0);
    for (mutant, _) in mutants.iter().zip(&noticed).filter(|(_, (own, any))| !own && !any) {
        let line = format!("spec/{}, {}, {}", mutant.file, mutant.function, mutant.change);
        let known = expected.lines().any(|known| known.trim() == line);
        survivors += 1;
        unexpected += usize::from(!known);
        println!("{}{line} (line {})", if known { "known: " } else { "" }, mutant.line);
    }
    println!("\n| file | mutants | by its own laws | by any law |\n|---|---|---|---|");
    for (file, [count, own, any]) in &files {
        println!("| {file} | {count} | {own} | {any} |");
    }
    let sum = |k: usize| files.values().map(|counts| counts[k]).sum::<usize>();
    println!(
        "| all | {} | {} | {} |\n\n{survivors} survive, {unexpected} of them unexpectedly",
        sum(0),
        sum(1),
        sum(2)
    );
    unexpected > 0
}
