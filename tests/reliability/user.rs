//! A person who runs a small case, meets a fault, and goes on as the program says.

use crate::setting::setting;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;
use tempfile::TempDir;

/// Two stages with a tip; several checkpoints, frames and rows in each.
const CASE: &str = "\
title: A small case in which everything is written
model: {soot: {necks: S}}
sample: {aggregate: {spheres: 4, neck_fraction: 1}}
experiment:
  sequence:
    - deposition: {velocity: 2 m/s, duration: 120 steps}
    - indentation: {gap: 7 nm, cantilever: 70e-3 1/ns, duration: 90 steps}
output: {series: 20 steps, frames: 60 steps, checkpoints: 40 steps}
";

/// The name of the case's file, and of its run.
pub(crate) const FILE: &str = "small.yaml";
pub(crate) const RUN: &str = "run/small";

/// Number of trials: as many as a test asks for, times `VERIDEM_TRIALS`.
pub(crate) fn trials(few: u64) -> u64 {
    few * setting("VERIDEM_TRIALS")
}

/// An empty folder, in memory where the system has one there: a disk would take most of the time for syncs that no trial needs.
pub(crate) fn folder() -> TempDir {
    tempfile::tempdir_in("/dev/shm").or_else(|_| tempfile::tempdir()).unwrap()
}

/// A folder with the case and nothing else.
pub(crate) fn desk() -> TempDir {
    let place = folder();
    std::fs::write(place.path().join(FILE), CASE).unwrap();
    place
}

/// The same, where the case imports its aggregate, of which the run keeps a copy.
pub(crate) fn desk_with_input() -> TempDir {
    let place = folder();
    let import = "import: {file: row.xyz, unit: 1 nm}";
    std::fs::write(place.path().join(FILE), CASE.replace("spheres: 4", import)).unwrap();
    let row = "4\n\nC 0 0 0 14\nC 28 0 0 14\nC 56 0 0 14\nC 56 28 0 14\n";
    std::fs::write(place.path().join("row.xyz"), row).unwrap();
    place
}

/// The program, in a folder.
pub(crate) fn veridem(place: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_veridem"));
    command.current_dir(place).args(["--quiet", "--threads", "1"]).args(arguments).stdin(Stdio::null());
    command
}

/// The run that nothing disturbs: every file that it leaves.
pub(crate) fn undisturbed() -> &'static BTreeMap<PathBuf, Vec<u8>> {
    static FILES: OnceLock<BTreeMap<PathBuf, Vec<u8>>> = OnceLock::new();
    FILES.get_or_init(|| {
        let place = desk();
        let done = veridem(place.path(), &["run", FILE]).output().unwrap();
        assert!(done.status.success(), "{}", told(&done));
        outcome(place.path())
    })
}

/// Every file of the run but the manifest and the report, which tell the run's history, and the lock; of checkpoints the names alone, because one
/// that was damaged and never read stays as it is.
pub(crate) fn outcome(place: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let root = place.join(RUN);
    let (mut found, mut folders) = (BTreeMap::new(), vec![root.clone()]);
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if !["manifest.json", "report.html", "lock"].contains(&path.file_name().unwrap().to_str().unwrap()) {
                let name = path.strip_prefix(&root).unwrap().to_path_buf();
                let content = if name.starts_with("checkpoints") { vec![] } else { std::fs::read(&path).unwrap() };
                found.insert(name, content);
            }
        }
    }
    found
}

/// The first file in which a run differs from the one that nothing disturbed.
pub(crate) fn difference(place: &Path) -> Option<String> {
    difference_from(place, undisturbed())
}

fn difference_from(place: &Path, expected: &BTreeMap<PathBuf, Vec<u8>>) -> Option<String> {
    let found = outcome(place);
    let names = found.keys().chain(expected.keys());
    names.filter(|name| found.get(*name) != expected.get(*name)).map(|name| name.display().to_string()).next()
}

/// The status and the messages of a process.
pub(crate) fn told(output: &Output) -> String {
    format!("{}: {}", output.status, String::from_utf8_lossy(&output.stderr))
}

/// Resumes a run, or begins it anew if there is nothing to resume, and compares; returns why it was not resumed.
pub(crate) fn go_on(place: &Path) -> Result<Option<String>, String> {
    go_on_to(place, undisturbed())
}

/// The same, where these are the files of the run that nothing disturbed.
pub(crate) fn go_on_to(place: &Path, expected: &BTreeMap<PathBuf, Vec<u8>>) -> Result<Option<String>, String> {
    let resumed = veridem(place, &["resume", RUN]).output().unwrap();
    let again = match resumed.status.code() {
        Some(0) => None,
        // It had finished.
        Some(2) => None,
        Some(65 | 66) => Some(veridem(place, &["run", FILE, "--force"]).output().unwrap()),
        _ => return Err(told(&resumed)),
    };
    if let Some(again) = again.as_ref().filter(|again| !again.status.success()) {
        return Err(format!("{}; begun anew: {}", told(&resumed), told(again)));
    }
    match difference_from(place, expected) {
        None => Ok(again.map(|_| told(&resumed))),
        Some(file) => Err(format!("{file} differs; {}", told(&resumed))),
    }
}
