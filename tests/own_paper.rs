//! Does a fourth paper, built with the public library alone, work with every command? The tests start this program again, as the program of the example.

#[path = "../examples/own_paper/main.rs"]
mod own_paper;

use std::fs::read_to_string;
use std::path::Path;
use std::process::{Command, ExitCode, Output};

const AS_PROGRAM: &str = "OWN_PAPER";
const CASE: &str = include_str!("../examples/own_paper/case.yaml");

/// A test in a temporary folder that holds the case.
type Test = fn(&Path);

const TESTS: [(&str, Test); 8] = [
    ("check_prints_defaults_and_derived_values", check_prints_defaults_and_derived_values),
    ("a_wrong_key_is_named_with_its_line_and_the_nearest_one", a_wrong_key_is_named_with_its_line_and_the_nearest_one),
    ("a_value_that_makes_no_sense_is_refused", a_value_that_makes_no_sense_is_refused),
    ("the_schema_lists_its_sections_and_no_other_paper", the_schema_lists_its_sections_and_no_other_paper),
    ("a_run_leaves_columns_events_findings_and_figures", a_run_leaves_columns_events_findings_and_figures),
    ("a_resumed_run_has_the_same_bits", a_resumed_run_has_the_same_bits),
    ("a_sweep_varies_its_keys", a_sweep_varies_its_keys),
    ("its_claim_holds", its_claim_holds),
];

fn main() -> ExitCode {
    if std::env::var_os(AS_PROGRAM).is_some() {
        return own_paper::main();
    }
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let asked = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(word.as_str()));
    for (name, test) in TESTS.into_iter().filter(|(name, _)| asked(name)) {
        let place = tempfile::tempdir().expect("a folder");
        std::fs::write(place.path().join("case.yaml"), CASE).expect("a case");
        test(place.path());
        println!("test {name} ... ok");
    }
    ExitCode::SUCCESS
}

fn program(place: &Path, arguments: &[&str]) -> Output {
    let itself = std::env::current_exe().expect("a program");
    Command::new(itself)
        .current_dir(place)
        .env(AS_PROGRAM, "")
        .arg("--quiet")
        .args(arguments)
        .output()
        .expect("it starts")
}

/// The standard output of a command that must succeed.
fn printed(place: &Path, arguments: &[&str]) -> String {
    let output = program(place, arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("a text")
}

/// The exit status and the messages of `check` for a case in which a text is replaced.
fn refused(place: &Path, written: &str, wrong: &str) -> (Option<i32>, String) {
    std::fs::write(place.join("case.yaml"), CASE.replace(written, wrong)).expect("a case");
    let output = program(place, &["check", "case.yaml"]);
    (output.status.code(), String::from_utf8(output.stderr).expect("a text"))
}

fn check_prints_defaults_and_derived_values(place: &Path) {
    let resolved = printed(place, &["check", "case.yaml"]);
    for line in ["most: 100000 steps", "derived:", "mass: 9.21534 ag", "dt: 1.08824 ps", "restitution: '0.526621'"] {
        assert!(resolved.contains(line), "{line} in\n{resolved}");
    }
}

fn a_wrong_key_is_named_with_its_line_and_the_nearest_one(place: &Path) {
    let told = refused(place, "damping_ratio", "damping_ration");
    assert_eq!(told.0, Some(65));
    assert!(told.1.starts_with("case.yaml:3:"), "{}", told.1);
    assert!(told.1.contains("unknown key `damping_ration`, did you mean `damping_ratio`?"), "{}", told.1);
}

fn a_value_that_makes_no_sense_is_refused(place: &Path) {
    let told = refused(place, "damping_ratio: 0.2", "damping_ratio: 1");
    let expected = "case.yaml:3: model.linear.damping_ratio: found `1`, expected 0 or more, below 1\n";
    assert_eq!(told, (Some(65), expected.into()));
    let told = refused(place, "10 nm", "10 ns");
    assert_eq!(told.0, Some(65));
    assert!(told.1.contains("found `10 ns`, which has the wrong dimension, expected a length"), "{}", told.1);
}

fn the_schema_lists_its_sections_and_no_other_paper(place: &Path) {
    let schema = printed(place, &["schema"]);
    let spring = "# Stiffness of the spring. Expects a stiffness such as `1e6 N/m`. Required.\n    stiffness: ...\n";
    for text in [spring, "dt: 0.01 t_c", "\n  pair:", "\n  collision:"] {
        assert!(schema.contains(text), "{text} in\n{schema}");
    }
    assert!(!schema.contains("wear:"), "the program has one paper");
}

fn a_run_leaves_columns_events_findings_and_figures(place: &Path) {
    let findings = printed(place, &["run", "case.yaml"]);
    assert!(findings.starts_with("restitution ") && findings.contains("largest overlap "), "{findings}");
    let series = read_to_string(place.join("run/case/series.csv")).expect("a series");
    let columns: Vec<&str> = series.lines().next().expect("a header").split(',').collect();
    for column in ["spring energy [zJ]", "lost to dashpots [zJ]", "gap [nm]"] {
        assert!(columns.contains(&column), "{column} in {columns:?}");
    }
    let stages: Vec<&str> = series.lines().skip(1).filter_map(|row| row.split(',').next()).collect();
    assert_eq!((stages.first(), stages.last()), (Some(&"approach"), Some(&"rebound")));
    let events = read_to_string(place.join("run/case/events.jsonl")).expect("events");
    assert_eq!(events.matches("the overlap is deepest").count(), 1, "{events}");
    for file in ["figures/gap.svg", "report.html", "results.yaml", "case.resolved.yaml"] {
        assert!(place.join("run/case").join(file).exists(), "{file}");
    }
}

fn a_resumed_run_has_the_same_bits(place: &Path) {
    let whole = printed(place, &["run", "case.yaml", "--name", "whole"]);
    // In the first stage, and in the second one.
    for stop in ["130", "330"] {
        let arguments = ["run", "case.yaml", "--name", "parts", "--force", "--stop-after-steps", stop];
        assert_eq!(program(place, &arguments).status.code(), Some(75), "stopped after {stop} steps");
        assert_eq!(printed(place, &["resume", "run/parts"]), whole);
        for file in ["series.csv", "events.jsonl", "results.yaml"] {
            let [parts, whole] = ["parts", "whole"].map(|run| std::fs::read(place.join("run").join(run).join(file)));
            assert!(parts.expect("a file") == whole.expect("a file"), "{file} differs: stopped after {stop} steps");
        }
    }
}

fn a_sweep_varies_its_keys(place: &Path) {
    let table = printed(place, &["sweep", "case.yaml", "model.linear.damping_ratio=0.1,0.3"]);
    let rows: Vec<Vec<&str>> = table.lines().map(|row| row.split(',').collect()).collect();
    assert_eq!(rows[0][..3], ["model.linear.damping_ratio", "status", "restitution"]);
    assert_eq!(rows[1..].iter().map(|row| row[1]).collect::<Vec<_>>(), ["finished"; 2]);
}

fn its_claim_holds(place: &Path) {
    let claims = printed(place, &["reproduce", "linear"]);
    assert_eq!(claims.matches("| holds |").count(), 3, "{claims}");
    for file in ["claims.json", "claims.md", "report.html", "figures/restitution.svg"] {
        assert!(place.join("run/reproduce-linear").join(file).exists(), "{file}");
    }
}
