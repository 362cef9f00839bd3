//! Every mutant, activated one at a time.

use crate::copy::Copy;
use crate::kept::{Notice, Outcomes, explained};
use crate::rewrite::Mutant;
use crate::run::{FEW, Laws, MANY, in_parallel, patience};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

/// Laws that are run at a time: the first that notices ends the search only after the others of its group.
const GROUP: usize = 4;
/// Laws that take longer are run by themselves, after the others.
const QUICK: Duration = Duration::from_secs(5);
/// Laws that take longer still are left out.
const LONGEST: Duration = Duration::from_secs(30);
/// How long tests of the engine may take together, without a mutant.
const ENOUGH: Duration = Duration::from_secs(90);
/// How much longer laws may take with many samples than with few.
const MORE: u32 = 8;

/// Activates every mutant of the files whose name contains `name`; whether one survives that is not on the list of those that may.
pub(crate) fn all(copy: &Copy, root: &Path, name: &str) -> bool {
    let mut laws = Laws::of(copy);
    laws.record(copy);
    let known = Outcomes::of(copy);
    let mut mutants: Vec<&Mutant> =
        copy.mutants.iter().filter(|m| m.file.contains(name) && known.get(m).is_none()).collect();
    eprintln!("{} mutants, {} of them to be tried", copy.mutants.len(), mutants.len());
    mutants.sort_by_key(|mutant| (!known.survived(mutant), shuffled(mutant.id)));
    let done = AtomicUsize::new(0);
    in_parallel(&mutants, |_, mutant| {
        let notice = if mutant.part == "src" { notice_in_engine } else { notice };
        known.add(mutant, notice(&laws, mutant));
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        if done.is_multiple_of(100) {
            eprintln!("{done} of {}", mutants.len());
        }
    });
    report(copy, root, name) > 0
}

/// Who notices a mutant: quick laws with few samples, then slow ones. If none does, quick laws with many samples, those of its file also if
/// few samples did not reach it.
fn notice(laws: &Laws, mutant: &Mutant) -> Notice {
    let [own, others] = laws.reaching(mutant.id, &mutant.file);
    let whole = laws.of_file(&mutant.file);
    let steps = [
        (Notice::Own, &own, false, FEW),
        (Notice::Other, &others, false, FEW),
        (Notice::Own, &own, true, FEW),
        (Notice::Other, &others, true, FEW),
        (Notice::Own, &whole, false, MANY),
        (Notice::Other, &others, false, MANY),
    ];
    for (notice, names, slow, samples) in steps {
        let times = if slow { QUICK..LONGEST } else { Duration::ZERO..QUICK };
        let names: Vec<&str> = names.iter().copied().filter(|name| times.contains(&laws.time(&[*name]))).collect();
        let longer = if samples == MANY { MORE } else { 1 };
        let fails =
            |names: &[&str]| !laws.hold(names, Some(mutant.id), None, longer * patience(laws.time(names)), samples);
        if names.chunks(if slow { 1 } else { GROUP }).any(fails) {
            return notice;
        }
    }
    Notice::Nobody
}

/// Who notices a mutant of the engine: as many tests that reach it as take a minute and a half together, the cheapest for what they notice first.
fn notice_in_engine(laws: &Laws, mutant: &Mutant) -> Notice {
    let [own, others] = laws.reaching(mutant.id, &mutant.file);
    let own = own.into_iter().map(|name| (Notice::Own, name));
    let mut left = ENOUGH;
    for (notice, name) in own.chain(others.into_iter().map(|name| (Notice::Other, name))) {
        let time = laws.time(&[name]);
        if time <= left {
            left -= time;
            if !laws.hold(&[name], Some(mutant.id), None, patience(time), FEW) {
                return notice;
            }
        }
    }
    Notice::Nobody
}

/// A number without order, the same for the same mutant.
fn shuffled(id: u32) -> u32 {
    let mixed = (id ^ id >> 16).wrapping_mul(0x045d_9f3b);
    (mixed ^ mixed >> 16).wrapping_mul(0x045d_9f3b)
}

/// Prints the survivors and a table of the files; how many survivors are not explained.
fn report(copy: &Copy, root: &Path, name: &str) -> usize {
    let (outcomes, expected) = (Outcomes::of(copy), explained(root));
    let mut files: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
    let (mut survivors, mut unexpected) = (0, 0);
    for mutant in copy.mutants.iter().filter(|mutant| mutant.file.contains(name)) {
        let Some(notice) = outcomes.get(mutant) else { continue };
        let counts = files.entry(&mutant.file).or_default();
        counts[0] += 1;
        counts[1] += usize::from(notice == Notice::Own);
        counts[2] += usize::from(notice != Notice::Nobody);
        if notice == Notice::Nobody {
            let line = mutant.sentence();
            let known = expected.contains(&line);
            survivors += 1;
            unexpected += usize::from(!known);
            println!("{}{line} (line {})", if known { "known: " } else { "" }, mutant.line);
        }
    }
    println!("\n| file | mutants | by its own laws | by any law |\n|---|---|---|---|");
    for (file, [count, own, any]) in &files {
        println!("| {file} | {count} | {own} | {any} |");
    }
    let [count, own, any] = [0, 1, 2].map(|k| files.values().map(|counts| counts[k]).sum::<usize>());
    println!("| all | {count} | {own} | {any} |\n\n{survivors} survive, {unexpected} of them unexpectedly");
    unexpected
}
