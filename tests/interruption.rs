//! Do commands that read large files stop soon after a signal, whatever they are at?
#![cfg(unix)]

use std::fmt::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Spheres along the sides of a simple cubic lattice: two hundred thousand that touch.
const SIDES: [usize; 3] = [60, 60, 56];

/// The lattice, and the case of an aggregate that is imported from it.
fn desk() -> tempfile::TempDir {
    let place = tempfile::tempdir().unwrap();
    let [a, b, c] = SIDES;
    let mut text = format!("{}\nProperties=species:S:1:pos:R:3:radius:R:1\n", a * b * c);
    for k in 0..a * b * c {
        let [x, y, z] = [k % a, k / a % b, k / a / b].map(|n| 28 * n);
        writeln!(text, "C {x} {y} {z} 14").unwrap();
    }
    std::fs::write(place.path().join("lattice.xyz"), text).unwrap();
    let case = "title: A lattice\nmodel: {soot: {}}\n\
                sample: {aggregate: {import: {file: lattice.xyz, unit: 1 nm}}}\nexperiment: {restructuring: {}}\n";
    std::fs::write(place.path().join("lattice.yaml"), case).unwrap();
    place
}

/// Interrupts a command after a time: its status, its last words, and how long it went on.
fn interrupted(place: &Path, arguments: &[&str], after: Duration) -> (Option<i32>, String, Duration) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_veridem"));
    command.current_dir(place).args(arguments).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
    let process = command.spawn().unwrap();
    std::thread::sleep(after);
    let sent = Instant::now();
    Command::new("kill").args(["-INT", &process.id().to_string()]).status().unwrap();
    let ended = process.wait_with_output().unwrap();
    (ended.status.code(), String::from_utf8_lossy(&ended.stderr).into(), sent.elapsed())
}

#[test]
fn reading_a_large_file_is_interrupted_soon() {
    let place = desk();
    let commands =
        [&["import", "lattice.xyz", "--unit", "1 nm"][..], &["check", "lattice.yaml"], &["run", "lattice.yaml"]];
    for arguments in commands {
        let (status, said, late) = interrupted(place.path(), arguments, Duration::from_millis(500));
        // A run may have begun to place its spheres by then.
        let resumable = arguments[0] == "run" && status == Some(75) && said.contains("resume with");
        let nothing = status == Some(74) && said.contains("nothing was kept, and there is nothing to resume");
        assert!(resumable || nothing, "{arguments:?}: {status:?} {said}");
        assert!(late < Duration::from_millis(1500), "{arguments:?}: {late:?}");
    }
}
