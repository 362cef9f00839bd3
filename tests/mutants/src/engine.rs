//! The mutated copy of the engine: the whole repository, of which only the files that compute and observe are changed.

use crate::copy::{messages, put};
use std::fs;
use std::path::Path;
use std::process::Command;

/// What is changed: pair loop, integrators, bodies, surfaces, ledger, builders and observers, those of the papers too.
const CHANGED: [&str; 13] = [
    "forces/",
    "geometry/",
    "initial/",
    "motion/",
    "observe/",
    "papers/soot/energy.rs",
    "papers/soot/watch",
    "papers/titania/film/watch",
    "papers/titania/watch",
    "papers/wear/fate",
    "papers/wear/watch",
    "simulation/",
    "system/",
];

/// Test programs that read sources, equations, documents, cases and folders of runs, which no mutant changes, or compare a run with itself.
const OTHERS: [&str; 21] = [
    "command_line",
    "equations",
    "exported",
    "findings",
    "fuzz",
    "golden",
    "house",
    "input",
    "interruption",
    "listings",
    "own_paper",
    "paths",
    "proofs",
    "readme",
    "reliability",
    "report",
    "restart",
    "run_folder",
    "same_bits",
    "traceability",
    "values",
];

/// Whether a file of the engine has mutants.
pub(crate) fn is_changed(file: &str) -> bool {
    CHANGED.iter().any(|begin| file.starts_with(begin)) && !file.ends_with("tests.rs")
}

/// The text with spaces in place of what makes the pair loop a macro, so that its functions can be read.
pub(crate) fn without_macros(source: &str) -> String {
    let blank = |text: String, part: &str| text.replace(part, &" ".repeat(part.len()));
    let Some((above, rest)) = source.split_once("macro_rules! pair_loop {") else { return source.into() };
    let (body, below) = rest.split_once("\n    };\n}\n").expect("an end");
    let (pattern, body) = body.split_once("=> {").expect("a pattern");
    let body = blank(body.replace("$name", "_name"), "$(#[target_feature(enable = $features)])?");
    let spaces = |count: usize| " ".repeat(count);
    let before = spaces("macro_rules! pair_loop {".len() + pattern.len() + "=> {".len());
    format!("{above}{before}{body}{}{below}", spaces("\n    };\n}\n".len()))
}

/// Writes all files of the repository but the sources of the engine.
pub(crate) fn write_others(root: &Path, home: &Path) {
    let listed = Command::new("git").args(["ls-files", "-z"]).current_dir(root).output().expect("git");
    let listed = String::from_utf8(listed.stdout).expect("names");
    let is_source = |file: &str| file.starts_with("src/") && file.ends_with(".rs");
    for file in listed.split('\0').filter(|file| !file.is_empty() && !is_source(file)) {
        let other = |folder: &str| file.starts_with(&format!("tests/{folder}"));
        if OTHERS.iter().any(|name| other(&format!("{name}.rs")) || other(&format!("{name}/"))) {
            continue;
        }
        match fs::read_to_string(root.join(file)) {
            Ok(text) if file == "Cargo.toml" => put(&home.join(file), &manifest(&text)),
            Ok(text) => put(&home.join(file), &text),
            Err(_) => drop(fs::copy(root.join(file), home.join(file))),
        }
    }
}

/// The manifest without other packages, checks and benchmarks.
fn manifest(text: &str) -> String {
    let parts = text.split("\n[").filter(|part| !part.starts_with("[bench]") && !part.starts_with("[test]"));
    let text = parts.collect::<Vec<_>>().join("\n[");
    let text = text.replace(r#""benches/peers", "tests/mutants""#, "").replace("[lints]\nworkspace = true\n", "");
    text.replace("debug = \"line-tables-only\"", "debug = false")
}

/// Compiles the tests; first without making programs, as long as there are errors.
pub(crate) fn compile(home: &Path) -> Vec<serde_json::Value> {
    let cargo = |arguments: &[&str]| messages(Command::new(env!("CARGO")).args(arguments).current_dir(home));
    let checked = cargo(&["check", "--lib"]);
    if checked.iter().any(|message| message["message"]["level"] == "error") {
        return checked;
    }
    cargo(&["test", "--package=veridem", "--no-run", "--lib", "--bins", "--tests"])
}
