//! Do the rooms of the house obey its rules? Each rule is checked on the source text without test modules: a test inside a room
//! may take a paper's law as its example.

mod source;

use source::{Source, sources};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

const PAPERS: [&str; 3] = ["wear", "soot", "titania"];

/// The rooms of `src/`, the uppermost first: each uses only rooms below it, so that no circle can be.
const ROOMS: [&str; 24] = [
    "main",
    "cli",
    "book",
    "papers",
    "proofs",
    "golden",
    "reproduce",
    "run",
    "figures",
    "output",
    "observe",
    "simulation",
    "motion",
    "forces",
    "initial",
    "geometry",
    "system",
    "equations",
    "case",
    "interrupt",
    "random",
    "error",
    "allocator",
    "lib",
];

/// Rooms that may call single equations of a paper, never its law, its case or its stages.
const CALL_EQUATIONS: [&str; 2] = ["initial", "observe"];

/// Names of papers that mean something else, by room: the program soot-dem, whose files are read.
const OTHER_MEANINGS: [(&str, &str); 2] = [("initial", "soot-dem"), ("cli", "soot-dem")];

/// What `system` may take from the specification: types of numbers, no formula.
const TYPES: [&str; 2] = ["Vec3", "Tensor"];

/// Functions of numbers that `system` must not call, but for these files: contacts with a surface are told apart by where they are.
const FUNCTIONS: [&str; 14] =
    ["sqrt", "norm", "dot", "cross", "exp", "ln", "sin", "cos", "acos", "tanh", "squared", "powi", "powf", "recip"];
const COMPARES_PLACES: [(&str, &str); 1] = [("src/system/surface.rs", "norm")];

/// The modules that are public, room by room; all others are reached through what their room exports.
const PUBLIC: [(&str, &[&str]); 23] = [
    (
        "",
        &[
            "allocator",
            "book",
            "case",
            "cli",
            "equations",
            "error",
            "figures",
            "forces",
            "geometry",
            "golden",
            "initial",
            "interrupt",
            "motion",
            "observe",
            "output",
            "papers",
            "proofs",
            "random",
            "reproduce",
            "run",
            "simulation",
            "system",
        ],
    ),
    ("allocator", &[]),
    ("book", &[]),
    ("case", &["check", "json_schema", "quantity", "section", "springs", "units"]),
    ("cli", &[]),
    ("equations", &[]),
    ("error", &[]),
    ("figures", &[]),
    ("forces", &[]),
    ("geometry", &["capacity", "clusters", "directions", "hull", "jacobi", "principal", "shadow", "triangles"]),
    ("golden", &[]),
    ("initial", &["aggregate", "film", "lattice", "packing", "stl"]),
    ("interrupt", &[]),
    ("motion", &["verlet"]),
    (
        "observe",
        &[
            "aggregate",
            "film",
            "force_curve",
            "fractal",
            "morphology",
            "packing",
            "patch",
            "rotation",
            "shear_layer",
            "statistics",
            "strain",
            "stress",
            "third_body",
        ],
    ),
    ("output", &["aggregate", "columns", "frames"]),
    ("papers", &["shown", "soot", "titania", "wear"]),
    ("proofs", &[]),
    ("random", &[]),
    ("reproduce", &[]),
    ("run", &["sweep"]),
    ("simulation", &[]),
    ("system", &[]),
];

/// The modules with `unsafe`: the allocator, and those that call functions compiled for vector instructions, which `tests/vector_instructions.rs` checks.
const UNSAFE: [&str; 5] = [
    "src/allocator.rs",
    "src/forces/kernel.rs",
    "src/forces/prefetch.rs",
    "src/forces/transpose.rs",
    "spec/numbers/instructions.rs",
];

/// The words of a text that are names of papers, with the lines they stand in.
fn names(text: &str) -> Vec<(usize, &'static str)> {
    let words = |line: &str| -> BTreeSet<&'static str> {
        let line = line.to_lowercase();
        let letters = line.split(|c: char| !c.is_alphabetic());
        letters.filter_map(|word| PAPERS.into_iter().find(|paper| *paper == word)).collect()
    };
    text.lines().enumerate().flat_map(|(at, line)| words(line).into_iter().map(move |name| (at + 1, name))).collect()
}

/// A text with blank lines for the examples of its documentation, which are tests.
fn without_examples(text: &str) -> String {
    let mut inside = false;
    let kept = text.lines().map(|line| {
        let fence = line.trim_start().trim_start_matches(['/', '!']).trim_start().starts_with("```");
        inside ^= fence;
        if inside || fence { "" } else { line }
    });
    kept.collect::<Vec<_>>().join("\n")
}

#[test]
fn a_paper_is_named_in_its_own_rooms_alone() {
    let mut found = Vec::new();
    for source in sources("src").into_iter().filter(|source| source.room() != "papers") {
        let room = source.room();
        let mut text = without_examples(&source.text);
        for (_, words) in OTHER_MEANINGS.iter().filter(|other| other.0 == room) {
            text = text.replace(words, "");
        }
        if CALL_EQUATIONS.contains(&room) {
            for paper in PAPERS {
                for kind in ["eq", "def"] {
                    text = text.replace(&format!("spec::{paper}::{kind}"), "");
                }
            }
        }
        found.extend(names(&text).into_iter().map(|(line, name)| format!("{}:{line}: {name}", source.path)));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn two_lists_name_each_paper_once() {
    for (file, line) in [("src/papers/mod.rs", "pub mod"), ("spec/lib.rs", "pub mod")] {
        let source = sources(file.split_once('/').expect("a folder").0).into_iter().find(|source| source.path == file);
        let code = source.expect("the file of a list").code;
        for paper in PAPERS {
            assert!(code.contains(&format!("{line} {paper};")), "{file} lists {paper}");
        }
    }
}

#[test]
fn rooms_use_only_rooms_below_them() {
    let place = |room: &str| ROOMS.iter().position(|other| *other == room);
    let mut found = Vec::new();
    for source in sources("src").into_iter().filter(|source| source.room() != "lib") {
        let from =
            place(source.room()).unwrap_or_else(|| panic!("{}: the room has no place in the order", source.path));
        for path in source.paths() {
            if let Some(to) = path.first().and_then(|room| place(room))
                && to < from
            {
                found.push(format!("{} uses {}", source.path, path.join("::")));
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn papers_do_not_use_each_other() {
    let mut found = Vec::new();
    for source in sources("src").into_iter().filter(|source| source.path.starts_with("src/papers/")) {
        for path in source.paths() {
            let own = source.module.get(1).map(String::as_str);
            let of = match path.first().map(String::as_str) {
                Some("papers" | "spec") => path.get(1).map(String::as_str),
                _ => None,
            };
            if of.is_some_and(|of| PAPERS.contains(&of) && Some(of) != own) {
                found.push(format!("{} uses {}", source.path, path.join("::")));
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn papers_of_the_specification_use_mechanics_and_mechanics_no_paper() {
    let mut found = Vec::new();
    for source in sources("spec").into_iter().filter(|source| source.path != "spec/lib.rs") {
        for path in source.paths() {
            if path.first().is_some_and(|of| PAPERS.contains(&of.as_str()) && of != source.room()) {
                found.push(format!("{} uses {}", source.path, path.join("::")));
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn files_use_each_other_in_no_circle() {
    // What two modules of the same parent use of each other.
    let mut uses: BTreeMap<Vec<String>, BTreeMap<String, BTreeSet<String>>> = BTreeMap::new();
    let all = sources("src");
    let modules: BTreeSet<Vec<String>> =
        all.iter().flat_map(|s| (1..=s.module.len()).map(|n| s.module[..n].to_vec())).collect();
    for source in &all {
        for path in source.paths() {
            let shared = source.module.iter().zip(&path).take_while(|(a, b)| a == b).count();
            if let (Some(from), Some(to)) = (source.module.get(shared), path.get(shared))
                && modules.contains(&path[..=shared])
            {
                let at = uses.entry(path[..shared].to_vec()).or_default();
                at.entry(from.clone()).or_default().insert(to.clone());
            }
        }
    }
    let mut found = Vec::new();
    for (parent, uses) in &uses {
        let mut reached = uses.clone();
        loop {
            let before = reached.clone();
            for of in reached.values_mut() {
                let farther: Vec<String> = of.iter().filter_map(|to| before.get(to)).flatten().cloned().collect();
                of.extend(farther);
            }
            if reached == before {
                break;
            }
        }
        let circle: Vec<&String> =
            reached.iter().filter(|(from, to)| to.contains(*from)).map(|(from, _)| from).collect();
        if !circle.is_empty() {
            found.push(format!("{}: {circle:?}", parent.join("::")));
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn system_computes_nothing() {
    let mut found = Vec::new();
    for source in sources("src").into_iter().filter(|source| source.room() == "system") {
        for path in source.paths().into_iter().filter(|path| path[0] == "spec") {
            if path.len() != 2 || !TYPES.contains(&path[1].as_str()) {
                found.push(format!("{} uses {}", source.path, path.join("::")));
            }
        }
        for function in FUNCTIONS {
            let called = [".", "::"].iter().any(|before| source.code.contains(&format!("{before}{function}(")));
            if called && !COMPARES_PLACES.contains(&(&source.path, function)) {
                found.push(format!("{} calls {function}", source.path));
            }
        }
        for (at, line) in source.code.lines().enumerate() {
            // A product or a quotient with a number that has a fraction is a formula; one of counts is a place in a list.
            let near = |operator: &str| line.split(operator).any(has_fraction);
            if [" * ", " / "].iter().any(|operator| line.contains(operator) && near(operator)) {
                found.push(format!("{}:{}: {}", source.path, at + 1, line.trim()));
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// Whether a number such as 2.0 stands in some code.
fn has_fraction(code: &str) -> bool {
    code.split('.').collect::<Vec<_>>().windows(2).any(|sides| {
        sides[0].ends_with(|c: char| c.is_ascii_digit()) && sides[1].starts_with(|c: char| c.is_ascii_digit())
    })
}

#[test]
fn what_is_public_is_a_list() {
    let known: BTreeMap<&str, BTreeSet<&str>> =
        PUBLIC.iter().map(|(room, of)| (*room, of.iter().copied().collect())).collect();
    for source in sources("src") {
        let room = match source.module.as_slice() {
            [] if source.path == "src/lib.rs" => "",
            [room] if source.path != "src/main.rs" => room,
            _ => continue,
        };
        let public = source.code.lines().filter_map(|line| line.trim().strip_prefix("pub mod ")?.strip_suffix(';'));
        let public: BTreeSet<&str> = public.collect();
        assert_eq!(known.get(room), Some(&public), "the public modules of {}", source.path);
    }
}

#[test]
fn one_driver_takes_every_step() {
    let mut found = Vec::new();
    for source in sources("src") {
        let own = source.path == "src/run/driver.rs" || source.room() == "simulation";
        if !own && [".step()", "Simulation::step"].iter().any(|call| source.code.contains(call)) {
            found.push(format!("{} takes steps", source.path));
        }
    }
    // A test of the engine steps a law of its own by hand; one that runs a paper's stages goes the way of a run.
    for source in sources("tests") {
        if source.code.contains("veridem::papers") && source.code.contains(".step()") {
            found.push(format!("{} takes steps of a paper's stages", source.path));
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn unsafe_code_is_in_a_list_of_modules() {
    let all = ["src", "spec", "tests", "benches", "examples"].into_iter().flat_map(sources);
    // Test modules count, too.
    let has = |source: &Source| {
        let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(&source.path)).expect("a source");
        let mut code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
        code.any(|code| code.split(|c: char| !c.is_alphanumeric()).any(|word| word == "unsafe"))
    };
    let found: Vec<String> =
        all.filter(has).map(|source| source.path).filter(|path| path != "tests/house.rs").collect();
    assert_eq!(found, UNSAFE);
}

#[test]
fn the_reader_sees_code_and_no_tests() {
    let text = "//! A soot.\nuse crate::{a::{b as c, self}, d::*};\n#[cfg(test)]\nmod tests {\n    use crate::x;\n}\nfn f() { super::g::h::<u8>(\"crate::no\", '{') }\n";
    let source = Source::new("src/room/file.rs", text);
    assert_eq!((source.room(), source.module.join("::")), ("room", "room::file".into()));
    let paths: Vec<String> = source.paths().iter().map(|path| path.join("::")).collect();
    assert_eq!(paths, ["a::b", "a", "d", "room::g::h"]);
    assert_eq!(names(&source.text), [(1, "soot")]);
}
