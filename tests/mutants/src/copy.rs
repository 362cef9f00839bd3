//! The mutated copy of the specification: written, compiled, and rid of the mutants that do not compile.

use crate::rewrite::{Entry, Kind, Listed, Mutant, entries, rewrite};
use std::collections::BTreeSet;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The copy with all its mutants, compiled.
pub(crate) struct Copy {
    /// The folder it is in.
    pub home: PathBuf,
    /// The program that runs its tests.
    pub tests: PathBuf,
    pub mutants: Vec<Mutant>,
    pub listed: Vec<Listed>,
    pub entries: Vec<Entry>,
    /// A digest of code and laws.
    pub laws: String,
}

/// The files that are not mutated, and folders: numbers, lists and languages that other tests check, and what is for tests only.
const LEFT: [&str; 11] = [
    "columns.rs",
    "document.rs",
    "equation.rs",
    "unit.rs",
    "languages/",
    "mechanics/samples.rs",
    "mechanics/amplification.rs",
    "numbers/rounded/",
    "numbers/slope.rs",
    "numbers/source",
    "numbers/written",
];

/// Writes and compiles a copy of the specification of the repository at `root`.
pub(crate) fn build(root: &Path, kind: Kind) -> Copy {
    let home = root.join("target/mutants").join(if kind == Kind::Scaled { "sweep" } else { "all" });
    let kept = home.join("dropped.txt");
    let sources = sources(&root.join("spec"));
    // Mutants that did not compile the last time.
    let mut dropped: BTreeSet<String> =
        fs::read_to_string(&kept).unwrap_or_default().lines().map(String::from).collect();
    loop {
        let (mutants, listed, entries) = write(root, &home, kind, &sources, &dropped);
        let messages = compile(root, &home);
        let found = errors(&messages, &home);
        if found.is_empty() {
            fs::write(&kept, dropped.iter().map(|key| format!("{key}\n")).collect::<String>()).expect("a file");
            let tests = messages.iter().filter(|message| message["profile"]["test"] == true);
            let tests = tests.filter_map(|message| message["executable"].as_str()).next_back().expect("a program");
            let laws = digest(sources.iter().map(|(_, source)| source.as_str()));
            return Copy { home, tests: tests.into(), mutants, listed, entries, laws };
        }
        eprintln!("{} mutants do not compile", found.len());
        dropped.extend(mutants.into_iter().filter(|mutant| found.contains(&mutant.id)).map(|mutant| mutant.key));
    }
}

/// The sources of the specification, in order: paths relative to it, and texts.
fn sources(spec: &Path) -> Vec<(String, String)> {
    fn collect(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                collect(&path, found);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }
    let mut paths = vec![];
    collect(spec, &mut paths);
    paths.sort();
    let name = |path: &PathBuf| path.strip_prefix(spec).expect("below").display().to_string();
    paths.iter().map(|path| (name(path), fs::read_to_string(path).expect("a text"))).collect()
}

/// A digest of sources without comments, and of how they are rewritten.
fn digest<'a>(sources: impl Iterator<Item = &'a str>) -> String {
    let mut hasher = DefaultHasher::new();
    (LEFT, include_str!("rewrite.rs")).hash(&mut hasher);
    let lines = sources.flat_map(str::lines).filter(|line| !line.trim_start().starts_with("//"));
    lines.for_each(|line| line.hash(&mut hasher));
    format!("{:016x}", hasher.finish())
}

fn write(
    root: &Path,
    home: &Path,
    kind: Kind,
    sources: &[(String, String)],
    dropped: &BTreeSet<String>,
) -> (Vec<Mutant>, Vec<Listed>, Vec<Entry>) {
    let entries: Vec<Entry> =
        sources.iter().filter(|(file, _)| file != "equation.rs").flat_map(|(_, source)| entries(source)).collect();
    let (mut mutants, mut listed, mut next) = (vec![], vec![], 0);
    for (file, source) in sources {
        let mut text = source.clone();
        if !LEFT.iter().any(|left| file.starts_with(left)) && !file.contains("/laws") {
            let formulas = source.split("#[cfg(test)]").next().unwrap_or(source);
            let rewritten =
                rewrite(kind, file, source, &digest([file.as_str(), formulas].into_iter()), next, dropped, &entries);
            text = rewritten.text;
            mutants.extend(rewritten.mutants);
            listed.extend(rewritten.listed);
            next = (next + 1).max(rewritten.next);
        }
        if file == "lib.rs" {
            text = text.replacen("\n#[cfg(test)]", "\n#![allow(warnings, clippy::all)]\n#[cfg(test)]", 1)
                + "\npub(crate) mod mutants;\n";
        }
        if file == "equation.rs" {
            // the laws do not look functions up, and every function with every kind of number takes long to compile
            text = text.replace(": flat,", ": |_| vec![],");
        }
        // inlined everywhere, the choices take long to compile
        put(&home.join("spec").join(file), &text.replace("#[inline(always)]", ""));
    }
    put(&home.join("spec/mutants.rs"), include_str!("switch.rs"));
    let manifest = fs::read_to_string(root.join("spec/Cargo.toml")).expect("a manifest");
    let manifest = manifest.replace("[lints]\nworkspace = true\n", "");
    let own: String = manifest
        .lines()
        .filter(|line| !line.contains(".workspace = true") && !line.starts_with("veridem-spec"))
        .map(|line| format!("{line}\n"))
        .collect();
    let own = own.replacen("[package]\n", "[package]\nversion = \"0.0.0\"\nedition = \"2024\"\n", 1);
    let workspace = fs::read_to_string(root.join("Cargo.toml")).expect("a manifest");
    // the profiles for dependencies, so that they need not be compiled again
    let profile: String = workspace
        .split("\n[")
        .filter(|part| part.starts_with("profile.dev"))
        .map(|part| format!("\n[{part}"))
        .collect();
    // mutants are compiled once and run thousands of times
    let profile = format!("\n[workspace]{profile}\n[profile.dev.package.veridem-spec]\nopt-level = 1\ndebug = false\n");
    put(&home.join("spec/Cargo.toml"), &(own + &profile));
    if !home.join("spec/Cargo.lock").exists() {
        fs::copy(root.join("Cargo.lock"), home.join("spec/Cargo.lock")).expect("a copy");
    }
    (mutants, listed, entries)
}

/// Writes a file unless it has this text already.
fn put(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
    if !fs::read_to_string(path).is_ok_and(|kept| kept == text) {
        fs::write(path, text).expect("a file");
    }
}

/// Compiles the tests of the copy, with the compiled dependencies of the repository.
fn compile(root: &Path, home: &Path) -> Vec<serde_json::Value> {
    let output = Command::new(env!("CARGO"))
        .args(["test", "--lib", "--features=verify", "--no-run", "--message-format=json", "--manifest-path"])
        .arg(home.join("spec/Cargo.toml"))
        .arg("--target-dir")
        .arg(root.join("target"))
        .stderr(Stdio::inherit())
        .output()
        .expect("cargo");
    String::from_utf8_lossy(&output.stdout).lines().filter_map(|line| serde_json::from_str(line).ok()).collect()
}

/// The mutants in the lines that the compiler complains of, or nearest to them.
fn errors(messages: &[serde_json::Value], home: &Path) -> BTreeSet<u32> {
    let (mut found, mut others) = (BTreeSet::new(), String::new());
    for message in messages.iter().filter(|message| message["message"]["level"] == "error") {
        for span in
            message["message"]["spans"].as_array().into_iter().flatten().filter(|span| span["is_primary"] == true)
        {
            let file = span["file_name"].as_str().unwrap_or_default();
            let path = if Path::new(file).is_absolute() { file.into() } else { home.join("spec").join(file) };
            let text = fs::read_to_string(&path).expect("a source");
            let lines: Vec<&str> = text.lines().collect();
            let line = span["line_start"].as_u64().unwrap_or(1) as usize - 1;
            let marked = |k: usize| {
                lines.get(k).and_then(|line| line.split_once("/*M")?.1.split('*').next()?.parse::<u32>().ok())
            };
            match marked(line) {
                Some(id) => drop(found.insert(id)),
                None => found.extend((line.saturating_sub(3)..line + 4).filter_map(marked)),
            }
        }
        others += message["message"]["rendered"].as_str().unwrap_or_default();
    }
    assert!(!found.is_empty() || others.is_empty(), "{others}");
    found
}
