//! Does every invalid input give a helpful error, and every valid one pass?

#[path = "common/program.rs"]
mod program;

use program::veridem as veridem_in;
use std::path::{Path, PathBuf};
use std::process::Command;

fn cases(kind: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases").join(kind);
    let mut found: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    found.sort();
    assert!(!found.is_empty());
    found
}

/// What stands at the end of a bad case, after `# expected:`.
fn expected(text: &str) -> String {
    let (_, lines) = text.split_once("# expected:\n").expect("a bad case ends with its error");
    lines.lines().map(|line| format!("{}\n", line.strip_prefix("# ").unwrap())).collect()
}

#[test]
fn every_bad_case_gets_the_error_written_in_it() {
    for case in cases("bad") {
        let folder = case.parent().unwrap();
        let name = case.file_name().unwrap().to_str().unwrap();
        for command in ["check", "run"] {
            let output = veridem_in(folder, &[command, name]);
            assert_eq!(
                String::from_utf8_lossy(&output.stderr),
                expected(&std::fs::read_to_string(&case).unwrap()),
                "{name}"
            );
            assert_eq!(output.status.code(), Some(65), "{name}");
            assert!(output.stdout.is_empty(), "{name}");
        }
        assert!(!folder.join("run").exists(), "{name}: nothing is written for a bad case");
    }
}

#[test]
fn every_good_case_passes_and_is_resolved_with_its_time_step() {
    for case in cases("good") {
        let output = veridem_in(case.parent().unwrap(), &["check", case.to_str().unwrap()]);
        assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{}", case.display());
        let resolved: serde_yaml::Value = serde_yaml::from_slice(&output.stdout).unwrap();
        let limit = resolved["derived"]["largest stable time step"].as_str().unwrap();
        assert!(limit.ends_with(" fs"), "{limit}");
    }
}

#[test]
fn what_cannot_be_read_is_named() {
    let place = tempfile::tempdir().unwrap();
    let check = |name: &str| veridem_in(place.path(), &["check", name]);
    let missing = check("missing.yaml");
    assert_eq!(missing.status.code(), Some(66));
    let text = String::from_utf8_lossy(&missing.stderr).to_string();
    assert_eq!(text, "missing.yaml: cannot be read: No such file or directory (os error 2)\n");

    std::fs::write(place.path().join("latin.yaml"), b"title: \xe4\n").unwrap();
    let unreadable = check("latin.yaml");
    assert_eq!(unreadable.status.code(), Some(65));
    let text = String::from_utf8_lossy(&unreadable.stderr).to_string();
    assert_eq!(text, "latin.yaml: is not a text in UTF-8\n");

    let folder = check(".");
    assert_eq!(folder.status.code(), Some(66));
    assert_eq!(String::from_utf8_lossy(&folder.stderr), ".: cannot be read: Is a directory (os error 21)\n");
}

#[test]
fn a_byte_order_mark_is_no_part_of_the_case() {
    let place = tempfile::tempdir().unwrap();
    let good =
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/good/patch-hcp.yaml")).unwrap();
    let check = |text: &str| {
        std::fs::write(place.path().join("marked.yaml"), format!("\u{feff}{text}")).unwrap();
        String::from_utf8(veridem_in(place.path(), &["check", "marked.yaml"]).stderr).unwrap()
    };
    assert_eq!(check(&good), "");
    let wrong = check(&good.replace("restitution: 0.95", "restitution: 2"));
    assert_eq!(wrong, "marked.yaml:10: model.wear.restitution: found `2`, expected 0 to 1\n");
}

#[test]
fn a_wrong_command_line_ends_with_two() {
    let here = Path::new(".");
    for arguments in [&["walk"][..], &["run"], &["run", "a.yaml", "--threads", "0"], &["inspect"], &["sweep", "a.yaml"]]
    {
        assert_eq!(veridem_in(here, arguments).status.code(), Some(2), "{arguments:?}");
    }
}

#[test]
fn a_saved_sample_is_used_only_for_the_case_it_was_made_for() {
    let place = tempfile::tempdir().unwrap();
    let good =
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/good/junction.yaml")).unwrap();
    let write = |name: &str, text: String| std::fs::write(place.path().join(name), text).unwrap();
    let with = |line: &str| good.replace("    largest:", &format!("    {line}\n    largest:"));
    write("make.yaml", with("save: silica.sample"));
    write("use.yaml", with("load: silica.sample"));
    write("other.yaml", with("load: silica.sample").replace("largest: 4.5 nm", "largest: 4.6 nm"));
    let run = |name: &str| veridem_in(place.path(), &["--quiet", "run", name]);

    let early = run("use.yaml");
    assert_eq!(early.status.code(), Some(66));
    let text = String::from_utf8_lossy(&early.stderr).to_string();
    let folder = place.path().canonicalize().unwrap();
    let from = format!("`silica.sample` goes from {}, the folder of the case", folder.display());
    assert_eq!(text, format!("silica.sample: cannot be read: No such file or directory (os error 2); {from}\n"));
    assert!(run("make.yaml").status.success());
    assert!(run("use.yaml").status.success());
    let results =
        |name: &str| std::fs::read_to_string(place.path().join("run").join(name).join("results.yaml")).unwrap();
    let fate = |name: &str| results(name).split_once("fate").unwrap().1.to_string();
    assert_eq!(fate("make"), fate("use"));
    let other = run("other.yaml");
    assert_eq!(other.status.code(), Some(65));
    let text = String::from_utf8_lossy(&other.stderr).to_string();
    assert_eq!(text, "silica.sample: was made with another model, sample or seed\n");
}

#[test]
fn a_sample_is_not_computed_for_a_folder_that_does_not_exist() {
    let place = tempfile::tempdir().unwrap();
    let good = |name: &str| {
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/good").join(name)).unwrap()
    };
    for (name, at, save, line, key) in [
        ("junction.yaml", "    largest:", "    save: no/s\n    largest:", 15, "sample.amorphous.save"),
        ("soot-sequence.yaml", "100 ns}", "100 ns, save: no/s}", 6, "experiment.sequence[0].deposition.save"),
        ("titania-film.yaml", "  film:\n", "  film:\n    save: no/s\n", 8, "sample.film.save"),
    ] {
        std::fs::write(place.path().join(name), good(name).replace(at, save)).unwrap();
        for command in ["check", "run"] {
            let output = veridem_in(place.path(), &["--quiet", command, name]);
            let expected = format!("{name}:{line}: {key}: found `no/s`, expected a file in a folder that exists\n");
            assert_eq!((output.status.code(), String::from_utf8(output.stderr).unwrap()), (Some(65), expected));
        }
    }
    assert!(!place.path().join("run").exists());
}

/// A limit on the size of files stands for a full disk: writing fails in the same way, at a place that can be chosen.
#[test]
fn a_full_disk_is_named_and_leaves_the_last_checkpoint_valid() {
    let place = tempfile::tempdir().unwrap();
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/good/junction.yaml");
    let run = |arguments: &[&str]| {
        veridem_in(place.path(), &[&["--quiet", "run", case.to_str().unwrap()], arguments].concat())
    };
    assert_eq!(run(&["--name", "probe", "--stop-after-steps", "170"]).status.code(), Some(75));
    let folders = ["checkpoints", "frames"].map(|name| place.path().join("run/probe").join(name));
    let files = folders.iter().flat_map(|folder| std::fs::read_dir(folder).unwrap());
    let largest = files.map(|file| file.unwrap().metadata().unwrap().len()).max().unwrap();
    // In units of 1024 bytes: all files up to the first checkpoint fit; larger ones follow.
    let blocks = largest / 1024 + 1;
    let veridem = env!("CARGO_BIN_EXE_veridem");
    let script = format!("trap '' XFSZ; ulimit -f {blocks}; exec {veridem} --quiet run {}", case.display());
    let full = Command::new("bash").current_dir(place.path()).args(["-c", &script]).output().unwrap();
    let text = String::from_utf8_lossy(&full.stderr).to_string();
    let named = text.strip_suffix(": File too large (os error 27)\n").map(|name| place.path().join(name));
    let folder = named.as_ref().and_then(|name| name.parent()).unwrap_or_else(|| panic!("{text}"));
    assert!(folder.is_dir() && !named.as_ref().is_some_and(|name| name.exists()), "{text}");
    assert_eq!(full.status.code(), Some(74));

    let resumed = veridem_in(place.path(), &["--quiet", "resume", "run/junction"]);
    assert!(resumed.status.success(), "{}", String::from_utf8_lossy(&resumed.stderr));
    assert!(run(&["--name", "whole"]).status.success());
    let same = veridem_in(place.path(), &["inspect", "--diff", "run/junction", "run/whole"]);
    assert_eq!(String::from_utf8_lossy(&same.stdout), "identical\n");
}
