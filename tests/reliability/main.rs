//! Is anything lost when the power is cut, the process is killed, a file call fails, or a byte is damaged?
//!
//! Every test tries a small case and compares all files of the run with those of a run that nothing disturbed. The number of
//! trials is small here; `VERIDEM_TRIALS=20 cargo test --release --test reliability` tries twenty times as many.

#![cfg(target_os = "linux")]

mod disk;
mod layer;
#[path = "../common/trials.rs"]
mod setting;
mod user;

use disk::{Disk, Unsynced};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rayon::prelude::*;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::Stdio;
use std::time::Instant;
use user::{
    FILE, RUN, desk, desk_with_input, difference, folder, go_on, go_on_to, outcome, told, trials, undisturbed, veridem,
};

/// Says how often something was tried, and fails with all that failed.
fn conclude(tried: usize, of: &str, failures: Vec<String>) {
    println!("{tried} {of}, {} failed", failures.len());
    assert!(failures.is_empty(), "{} trials failed:\n{}", failures.len(), failures.join("\n"));
}

/// The first call after which a checkpoint is safe.
fn first_safe_checkpoint(journal: &[String]) -> usize {
    let renamed = journal.iter().position(|line| line.starts_with("rename") && line.ends_with(".checkpoint"));
    let renamed = renamed.expect("the run has checkpoints");
    let folder = format!("{RUN}/checkpoints");
    let mut handles = Vec::new();
    for (k, line) in journal.iter().enumerate() {
        let words: Vec<&str> = line.split('\t').collect();
        match words[..] {
            ["open", handle, path, ..] if path == folder => handles.push(handle),
            ["sync", handle] if k > renamed && handles.contains(&handle) => return k + 1,
            _ => {}
        }
    }
    panic!("the folder of the checkpoints is never synced");
}

#[test]
fn a_power_cut_at_any_call_loses_nothing_that_was_checkpointed() {
    let place = desk();
    let before = Disk::of(place.path());
    let (journal, output) = layer::journal(place.path(), &["run", FILE]);
    assert!(output.status.success(), "{}", told(&output));
    assert_eq!(difference(place.path()), None, "the layer changes nothing");
    let safe = first_safe_checkpoint(&journal);
    let cut = |calls: usize, unsynced: Unsynced| {
        let mut disk = before.clone();
        journal[..calls].iter().for_each(|line| disk.apply(line));
        let left = folder();
        disk.after_power_cut(unsynced, left.path());
        let failed = |what: String| Some(format!("after {calls} of {} calls, {unsynced:?}: {what}", journal.len()));
        match go_on(left.path()) {
            Ok(Some(refusal)) if calls >= safe => failed(format!("the checkpoint was not used: {refusal}")),
            Ok(_) => None,
            Err(what) => failed(what),
        }
    };
    let mut cuts: Vec<(usize, Unsynced)> = (0..=journal.len()).map(|calls| (calls, Unsynced::Lost)).collect();
    let mut chance = ChaCha8Rng::seed_from_u64(1);
    cuts.extend(
        (0..trials(50))
            .map(|_| (chance.next_u64() as usize % (journal.len() + 1), Unsynced::Either(chance.next_u64()))),
    );
    let tried = cuts.len();
    conclude(tried, "power cuts", cuts.into_par_iter().filter_map(|(calls, unsynced)| cut(calls, unsynced)).collect());
}

#[test]
fn a_power_cut_while_a_run_is_resumed_loses_nothing() {
    let tried = trials(20);
    let failures = (0..tried).into_par_iter().filter_map(|trial| {
        let mut chance = ChaCha8Rng::seed_from_u64(trial);
        let (place, mut arguments) = (desk(), vec!["run", FILE]);
        // Every process is interrupted at one of its calls, until one comes to its end.
        for cuts in 0..4 {
            let mut disk = Disk::of(place.path());
            let (journal, _) = layer::journal(place.path(), &arguments);
            let calls = chance.next_u64() as usize % (journal.len() + 1);
            journal[..calls].iter().for_each(|line| disk.apply(line));
            for entry in std::fs::read_dir(place.path()).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() { std::fs::remove_dir_all(path).unwrap() } else { std::fs::remove_file(path).unwrap() }
            }
            disk.after_power_cut(Unsynced::Either(chance.next_u64()), place.path());
            let run_is_there = place.path().join(RUN).join("manifest.json").exists();
            arguments = if run_is_there { vec!["resume", RUN] } else { vec!["run", FILE, "--force"] };
            if cuts == 3 || calls == journal.len() {
                return go_on(place.path()).err().map(|what| format!("trial {trial}: {what}"));
            }
        }
        None
    });
    conclude(tried as usize, "series of power cuts in resumed runs", failures.collect());
}

#[test]
fn a_kill_before_any_call_loses_nothing_that_was_checkpointed() {
    let calls = calls();
    let every = (calls / trials(60)).max(1);
    let chosen: Vec<u64> = (1..=calls).filter(|call| call % every == 0).collect();
    let failures = chosen.par_iter().filter_map(|&call| {
        let place = desk();
        let killed = layer::above(place.path(), &["run", FILE], &[("LAYER_KILL", call.to_string())]);
        if killed.status.signal() != Some(9) {
            return Some(format!("call {call}: {}", told(&killed)));
        }
        go_on(place.path()).err().map(|what| format!("killed before call {call} of {calls}: {what}"))
    });
    conclude(chosen.len(), "kills before file calls", failures.collect());
}

#[test]
fn a_kill_at_any_moment_loses_nothing_that_was_checkpointed() {
    let place = desk();
    let begun = Instant::now();
    assert!(veridem(place.path(), &["run", FILE]).output().unwrap().status.success());
    let whole = begun.elapsed();
    let tried = trials(25);
    let failures = (0..tried).map(|trial| {
        let mut chance = ChaCha8Rng::seed_from_u64(trial);
        let place = desk();
        let mut process =
            veridem(place.path(), &["run", FILE]).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        std::thread::sleep(whole.mul_f64(f64::from(chance.next_u32()) / f64::from(u32::MAX)));
        process.kill().unwrap();
        process.wait().unwrap();
        go_on(place.path()).err().map(|what| format!("trial {trial}: {what}"))
    });
    conclude(tried as usize, "kills at random moments", failures.flatten().collect());
}

#[test]
fn a_kill_of_a_run_that_keeps_a_copy_of_its_input_loses_nothing() {
    let place = desk_with_input();
    let (journal, output) = layer::journal(place.path(), &["run", FILE]);
    assert!(output.status.success(), "{}", told(&output));
    let whole = outcome(place.path());
    assert!(whole.contains_key(Path::new("inputs/row.xyz")), "{:?}", whole.keys());
    let (calls, tried) = (journal.len() as u64 - 1, trials(6));
    let failures = (0..tried).into_par_iter().filter_map(|trial| {
        let call = 1 + ChaCha8Rng::seed_from_u64(trial).next_u64() % calls;
        let place = desk_with_input();
        let killed = layer::above(place.path(), &["run", FILE], &[("LAYER_KILL", call.to_string())]);
        if killed.status.signal() != Some(9) {
            return Some(format!("call {call}: {}", told(&killed)));
        }
        // Once there is a checkpoint, the copy alone will do.
        let saved = |entry: std::io::Result<std::fs::DirEntry>| {
            entry.unwrap().path().extension() == Some("checkpoint".as_ref())
        };
        if std::fs::read_dir(place.path().join(RUN).join("checkpoints")).is_ok_and(|mut files| files.any(saved)) {
            std::fs::remove_file(place.path().join("row.xyz")).unwrap();
        }
        go_on_to(place.path(), &whole).err().map(|what| format!("killed before call {call} of {calls}: {what}"))
    });
    conclude(tried as usize, "kills of a run with a copy of its input", failures.collect());
}

/// Number of file calls of the small run.
fn calls() -> u64 {
    let place = desk();
    let (journal, output) = layer::journal(place.path(), &["run", FILE]);
    assert!(output.status.success(), "{}", told(&output));
    let last = journal.last().and_then(|line| line.strip_prefix("calls\t")).expect("the number of calls comes last");
    last.parse().unwrap()
}

/// Whether a message begins with the path of a file or folder that could be there.
fn names_a_path(place: &Path, message: &str) -> bool {
    let (path, _) = message.split_once(": ").unwrap_or_default();
    !path.is_empty() && place.join(path).parent().is_some_and(Path::exists)
}

#[test]
fn a_file_call_that_fails_is_reported_and_the_run_goes_on_later() {
    const ENOSPC: i32 = 28;
    const EIO: i32 = 5;
    let calls = calls();
    let every = (calls / trials(60)).max(1);
    let kinds = [(EIO, false), (ENOSPC, true)];
    let all = (1..=calls).filter(|call| call % every == 0).flat_map(|call| kinds.map(|kind| (call, kind)));
    let all: Vec<_> = all.collect();
    let failures = all.par_iter().filter_map(|&(call, (error, forever))| {
        let place = desk();
        let mut settings = vec![("LAYER_FAIL", call.to_string()), ("LAYER_ERROR", error.to_string())];
        settings.extend(forever.then(|| ("LAYER_FOREVER", "1".to_string())));
        let failed = layer::above(place.path(), &["run", FILE], &settings);
        let message = String::from_utf8_lossy(&failed.stderr);
        let complaint = match failed.status.code() {
            // Not every call matters: a temporary file may be left behind.
            Some(0) => difference(place.path()).map(|file| format!("status 0, but {file} differs")),
            Some(74) if names_a_path(place.path(), &message) => None,
            _ => Some(told(&failed)),
        };
        let complaint = complaint.or_else(|| go_on(place.path()).err());
        complaint.map(|what| format!("call {call} of {calls}, error {error}: {what}"))
    });
    conclude(all.len(), "file calls made to fail", failures.collect());
}

/// Damages a file of a run that was stopped in its second stage. The damage must be noticed or be without effect.
fn damaged(file: &str, damage: impl Fn(&mut Vec<u8>) + Sync) -> Option<String> {
    let place = desk();
    let stopped = veridem(place.path(), &["run", FILE, "--stop-after-steps", "170"]).output().unwrap();
    assert_eq!(stopped.status.code(), Some(75), "{}", told(&stopped));
    let path = place.path().join(RUN).join(file);
    let whole = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut bytes = whole.clone();
    damage(&mut bytes);
    if bytes == whole {
        return None;
    }
    std::fs::write(&path, bytes).unwrap();
    let resumed = veridem(place.path(), &["resume", RUN]).output().unwrap();
    let message = String::from_utf8_lossy(&resumed.stderr);
    let name = Path::new(file).file_name().unwrap().to_str().unwrap();
    // A manifest that knows another case cannot be told from a case that has changed.
    let named = message.contains(name) || name == "manifest.json" && message.contains("case.yaml: has changed");
    match resumed.status.code() {
        Some(0) => difference(place.path()).map(|file| format!("status 0, but {file} differs; {message}")),
        Some(65) if named => None,
        _ => Some(told(&resumed)),
    }
}

/// The files of a run that was stopped which `resume` reads.
const READ: [&str; 6] = [
    "checkpoints/stopped.checkpoint",
    "checkpoints/000000000160.checkpoint",
    "case.yaml",
    "manifest.json",
    "series.csv",
    "events.jsonl",
];

/// Damages each of these files this many times, every time with other random numbers.
fn damage_all(few: u64, of: &str, damage: impl Fn(u64, &mut ChaCha8Rng, &mut Vec<u8>) + Sync) {
    let all = READ.into_iter().flat_map(|file| (0..trials(few)).map(move |trial| (file, trial)));
    let all: Vec<_> = all.collect();
    let failures = all.par_iter().filter_map(|&(file, trial)| {
        let once = |bytes: &mut Vec<u8>| damage(trial, &mut ChaCha8Rng::seed_from_u64(trial), bytes);
        damaged(file, once).map(|what| format!("{file}, trial {trial}: {what}"))
    });
    conclude(all.len(), of, failures.collect());
}

#[test]
fn a_flipped_bit_is_noticed_or_has_no_effect() {
    damage_all(12, "flipped bits", |_, chance, bytes| {
        let (place, bit) = (chance.next_u64() as usize % bytes.len(), chance.next_u32() % 8);
        bytes[place] ^= 1 << bit;
    });
}

#[test]
fn a_file_cut_short_or_lengthened_is_noticed_or_has_no_effect() {
    damage_all(6, "files of another length", |trial, chance, bytes| {
        let length = chance.next_u64() as usize;
        match trial % 3 {
            0 => bytes.truncate(length % bytes.len()),
            1 => bytes.extend(b"\0".repeat(1 + length % 99)),
            _ => bytes.clear(),
        }
    });
}

#[test]
fn a_finished_run_with_any_file_missing_says_so_or_is_whole() {
    for file in undisturbed().keys() {
        let place = desk();
        assert!(veridem(place.path(), &["run", FILE]).output().unwrap().status.success());
        std::fs::remove_file(place.path().join(RUN).join(file)).unwrap();
        let inspected = veridem(place.path(), &["inspect", RUN]).output().unwrap();
        assert!(matches!(inspected.status.code(), Some(0 | 66)), "{}: {}", file.display(), told(&inspected));
        assert!(outcome(place.path()).len() < undisturbed().len());
    }
}
