//! The mutated copy: written, compiled, and rid of the mutants that do not compile.

use crate::engine;
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
    /// The programs that run its tests, with the name before the names of theirs: none for those of the changed sources themselves.
    pub tests: Vec<(String, PathBuf)>,
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

/// Writes and compiles a copy of the repository at `root`, or of its specification.
pub(crate) fn build(root: &Path, kind: Kind) -> Copy {
    let home = root.join("target/mutants").join(match kind {
        Kind::Scaled => "sweep",
        Kind::Changed => "all",
        Kind::Engine => "engine",
    });
    let kept = home.join("dropped.txt");
    let sources = read(&root.join(kind.part()));
    // Mutants that did not compile the last time.
    let mut dropped: BTreeSet<String> =
        fs::read_to_string(&kept).unwrap_or_default().lines().map(String::from).collect();
    loop {
        let (mutants, listed, entries) = write(root, &home, kind, &sources, &dropped);
        let messages = if kind == Kind::Engine { engine::compile(&home) } else { compile(root, &home) };
        let found = errors(&messages, &home.join(if kind == Kind::Engine { "" } else { "spec" }));
        if found.is_empty() {
            fs::write(&kept, dropped.iter().map(|key| format!("{key}\n")).collect::<String>()).expect("a file");
            let tests = messages.iter().filter_map(program).collect();
            let mut texts: Vec<&str> = sources.iter().map(|(_, source)| source.as_str()).collect();
            let programs = if kind == Kind::Engine { read(&root.join("tests")) } else { vec![] };
            texts.extend(
                programs.iter().filter(|(file, _)| !file.starts_with("mutants/")).map(|(_, text)| text.as_str()),
            );
            let laws = digest(texts.into_iter());
            return Copy { home, tests, mutants, listed, entries, laws };
        }
        eprintln!("{} mutants do not compile", found.len());
        dropped.extend(mutants.into_iter().filter(|mutant| found.contains(&mutant.id)).map(|mutant| mutant.key));
    }
}

/// A program that runs tests, from a message of the compiler.
fn program(message: &serde_json::Value) -> Option<(String, PathBuf)> {
    let target = &message["target"];
    let is_test = target["kind"][0] == "test";
    let has_tests = message["profile"]["test"] == true && (is_test || target["kind"][0] == "lib");
    let name = if is_test { format!("{}: ", target["name"].as_str()?) } else { String::new() };
    has_tests.then_some((name, message["executable"].as_str()?.into()))
}

/// The sources in a folder, in order: paths relative to it, and texts.
fn read(part: &Path) -> Vec<(String, String)> {
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
    collect(part, &mut paths);
    paths.sort();
    let name = |path: &PathBuf| path.strip_prefix(part).expect("below").display().to_string();
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
        let is_changed = match kind {
            Kind::Engine => engine::is_changed(file),
            _ => !LEFT.iter().any(|left| file.starts_with(left)) && !file.contains("/laws"),
        };
        if is_changed {
            let code = source.split("#[cfg(test)]").next().unwrap_or(source);
            let digest = digest([file.as_str(), code].into_iter());
            let parsed = if kind == Kind::Engine { &engine::without_macros(source) } else { source };
            let rewritten = rewrite(kind, file, source, parsed, &digest, next, dropped, &entries);
            text = rewritten.text;
            mutants.extend(rewritten.mutants);
            listed.extend(rewritten.listed);
            next = (next + 1).max(rewritten.next);
        }
        if file == "lib.rs" {
            text = text.replacen("\n\n", "\n\n#![allow(warnings, clippy::all)]\n", 1) + "\npub(crate) mod mutants;\n";
        }
        if kind == Kind::Engine {
            put(&home.join("src").join(file), &text);
            continue;
        }
        if file == "equation.rs" {
            // the laws do not look functions up, and every function with every kind of number takes long to compile
            text = text.replace(": flat,", ": |_| vec![],");
        }
        // inlined everywhere, the choices take long to compile
        put(&home.join("spec").join(file), &text.replace("#[inline(always)]", ""));
    }
    if kind == Kind::Engine {
        put(&home.join("src/mutants.rs"), include_str!("switch.rs"));
        engine::write_others(root, home);
        return (mutants, listed, entries);
    }
    put(&home.join("spec/mutants.rs"), concat!(include_str!("switch.rs"), include_str!("scaled.rs")));
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
pub(crate) fn put(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
    if !fs::read_to_string(path).is_ok_and(|kept| kept == text) {
        fs::write(path, text).expect("a file");
    }
}

/// Compiles the tests of the copy of the specification, with the compiled dependencies of the repository.
fn compile(root: &Path, home: &Path) -> Vec<serde_json::Value> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["test", "--lib", "--features=verify", "--no-run", "--manifest-path"]);
    cargo.arg(home.join("spec/Cargo.toml")).arg("--target-dir").arg(root.join("target"));
    messages(&mut cargo)
}

/// What the compiler says.
pub(crate) fn messages(cargo: &mut Command) -> Vec<serde_json::Value> {
    let output = cargo.arg("--message-format=json").stderr(Stdio::inherit()).output().expect("cargo");
    String::from_utf8_lossy(&output.stdout).lines().filter_map(|line| serde_json::from_str(line).ok()).collect()
}

/// The mutants in the lines of a folder that the compiler complains of, or nearest to them.
fn errors(messages: &[serde_json::Value], folder: &Path) -> BTreeSet<u32> {
    let (mut found, mut others) = (BTreeSet::new(), String::new());
    for message in messages.iter().filter(|message| message["message"]["level"] == "error") {
        let spans = message["message"]["spans"].as_array().map_or(&[][..], |spans| spans);
        let of = |is_primary| {
            let lines = spans.iter().filter(move |span| span["is_primary"] == is_primary);
            lines.flat_map(|span| marked(span, folder)).collect::<Vec<_>>()
        };
        let primary = of(true);
        found.extend(if primary.is_empty() { of(false) } else { primary });
        others += message["message"]["rendered"].as_str().unwrap_or_default();
    }
    assert!(!found.is_empty() || others.is_empty(), "{others}");
    found
}

/// The mutants in a line, or those within three lines.
fn marked(span: &serde_json::Value, folder: &Path) -> Vec<u32> {
    let Ok(text) = fs::read_to_string(folder.join(span["file_name"].as_str().unwrap_or_default())) else {
        return vec![];
    };
    let lines: Vec<&str> = text.lines().collect();
    let line = span["line_start"].as_u64().unwrap_or(1) as usize - 1;
    let marked = |k: usize| lines.get(k)?.split_once("/*M")?.1.split('*').next()?.parse().ok();
    marked(line).map_or_else(|| (line.saturating_sub(3)..line + 4).filter_map(marked).collect(), |id| vec![id])
}
