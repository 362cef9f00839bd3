//! Does every reader of files end soon and in order, whatever it is given?
//!
//! The readers are called with small files, with mutations of them, and with large files made to exhaust time or memory. `VERIDEM_SEED` seeds the
//! mutations, 1 unless given; `VERIDEM_TRIALS` multiplies their number. `fuzz/` calls the same functions under `cargo fuzz`.

mod checkpoints;
mod mutation;
mod targets;
#[path = "../common/trials.rs"]
mod trials;

use mutation::mutated;
use peak_alloc::PeakAlloc;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use targets::{TARGETS, call};
use trials::setting;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Longest time of a call, in a debug build on a busy machine. A reader whose time grows with the square of the length needs minutes.
const LONGEST: Duration = Duration::from_secs(20);

/// Most memory of the process, bytes: what a file announces is not allocated before it is read.
const MOST: usize = 1 << 30;

/// Calls a reader within the bounds on time and memory. The bytes are kept if it fails.
fn bounded(name: &str, bytes: &[u8]) -> Result<(), String> {
    let begun = Instant::now();
    let result = std::panic::catch_unwind(|| call(name, bytes));
    let (time, memory) = (begun.elapsed(), MEMORY.peak_usage());
    let what = match result {
        Err(panic) => panic.downcast_ref::<String>().cloned().unwrap_or_else(|| "a panic".into()),
        Ok(()) if time > LONGEST => format!("took {time:?}"),
        Ok(()) if memory > MOST => format!("{memory} bytes of memory were used"),
        Ok(()) => return Ok(()),
    };
    let kept = std::env::temp_dir().join(format!("veridem-fuzz-{name}-{:08x}", crc32fast::hash(bytes)));
    std::fs::write(&kept, bytes).expect("a file");
    Err(format!("{name}: {what}; its input is {}", kept.display()))
}

/// Most failures that are reported of a reader.
const REPORTED: usize = 10;

/// The small files of a reader, which are kept beside this one and in `tests/`.
fn seeds(name: &str) -> Vec<Vec<u8>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let others: &[&str] = match name {
        "case" => &["tests/cases/good", "tests/cases/bad"],
        "detected" | "flage" | "mstm" | "vtk" | "lammps" | "xyz" | "necks" => &["tests/data/aggregates"],
        "stl" => &["tests/data"],
        _ => &[],
    };
    let folders = others.iter().map(|folder| root.join(folder)).chain([root.join("tests/fuzz/seeds").join(name)]);
    let files =
        |folder: PathBuf| std::fs::read_dir(folder).into_iter().flatten().map(|entry| entry.expect("a file").path());
    let mut files: Vec<PathBuf> = folders.flat_map(files).filter(|path| path.is_file()).collect();
    files.sort();
    let mut seeds: Vec<Vec<u8>> = files.into_iter().map(|path| std::fs::read(path).expect("a file")).collect();
    if name == "checkpoint" {
        seeds.extend((0..checkpoints::number_of_runs()).map(|run| vec![run as u8]));
    }
    assert!(!seeds.is_empty(), "{name} has no small files");
    seeds
}

#[test]
fn small_files_and_their_mutations_are_read_or_refused() {
    let (seed, trials) = (setting("VERIDEM_SEED"), setting("VERIDEM_TRIALS"));
    println!("VERIDEM_SEED={seed} VERIDEM_TRIALS={trials}");
    let mut failures = Vec::new();
    for (name, _) in TARGETS {
        let seeds = seeds(name);
        let mut failed: Vec<String> = seeds.iter().filter_map(|bytes| bounded(name, bytes).err()).collect();
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        // A run is resumed for each checkpoint; the others take microseconds.
        let each = if name == "checkpoint" { 300 } else { 2000 };
        for _ in 0..each * trials {
            let first = &seeds[random.next_u64() as usize % seeds.len()];
            let second = &seeds[random.next_u64() as usize % seeds.len()];
            let bytes =
                if name == "checkpoint" { edits(first[0], &mut random) } else { mutated(first, second, &mut random) };
            failed.extend(bounded(name, &bytes).err());
            if failed.len() >= REPORTED {
                break;
            }
        }
        failures.extend(failed);
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// One to three edits of a run.
fn edits(run: u8, random: &mut ChaCha8Rng) -> Vec<u8> {
    let mut bytes = vec![0; 1 + 6 * (1 + random.next_u64() as usize % 3)];
    random.fill_bytes(&mut bytes);
    bytes[0] = run;
    bytes
}

#[test]
fn large_files_take_time_and_memory_in_proportion_to_their_length() {
    let mut failures = Vec::new();
    let mut try_it = |name: &str, bytes: &[u8]| failures.extend(bounded(name, bytes).err());
    let repeated = |text: &str, length: usize| text.repeat(length / text.len());
    let junction = include_str!("../cases/good/junction.yaml");
    let alias = |letter: u8| {
        let before = letter as char;
        let next = (letter + 1) as char;
        format!("  {next}: &{next} [{}]\n", vec![format!("*{before}"); 9].join(", "))
    };
    let bomb: String = (b'a'..b'k').map(alias).collect();
    for brackets in ["[", "{", "[{", "{a: ", "[a, ", "- ", "? ", "a: ", "- [", "&a ", "!a ", "*a ", "\"", "'", "#"] {
        for before in ["", "title: ", junction] {
            try_it("case", (before.to_string() + &repeated(brackets, 400_000)).as_bytes());
        }
        try_it("manifest", repeated(brackets, 400_000).as_bytes());
    }
    try_it("case", format!("title:\n  a: &a [x]\n{bomb}").as_bytes());
    try_it("case", format!("{junction}seed:\n  a: &a [x]\n{bomb}").as_bytes());
    try_it("case", junction.replace("73 GPa", &("1".repeat(400_000) + &"e".repeat(400_000))).as_bytes());
    let stage = "    - deposition: {duration: 0 ns}\n";
    let stages = "title: x\nmodel: {soot: {}}\nsample: {aggregate: {spheres: 6}}\nexperiment:\n  sequence:\n";
    try_it("case", (stages.to_string() + &repeated(stage, 400_000)).as_bytes());
    try_it("manifest", format!("{{\"status\": {}", repeated("{\"a\":", 400_000)).as_bytes());

    for number in ["99999999999", "18446744073709551615", "4294967295"] {
        try_it("xyz", format!("{number}\n\nC 0 0 0 1\n").as_bytes());
        try_it("xyz", format!("1\nProperties=species:S:{number}:pos:R:3\nC 0 0 0\n").as_bytes());
        try_it("vtk", format!("# vtk DataFile\n\nASCII\nPOINTS {number} float\n0 0 0\n").as_bytes());
        try_it("necks", format!("connections {number} {number} int\n1 3\n").as_bytes());
        try_it("lammps", format!("t\n\n{number} atoms\n\nAtoms # sphere\n\n1 1 2 1 0 0 0\n").as_bytes());
    }
    let binary = |count: u32, length: usize| [&[0; 80][..], &count.to_le_bytes(), &vec![0; length]].concat();
    try_it("stl", &binary(u32::MAX, 50));
    try_it("stl", &binary(8000, 400_000));
    for text in
        ["<a>", "<a b=\"", "&a;", "<particle>", "<!--", "<![CDATA[", "<particle><position>0 0 0</position></particle>"]
    {
        try_it("flage", repeated(text, 400_000).as_bytes());
        try_it("flage", ("<a>".to_string() + &repeated(text, 400_000)).as_bytes());
    }
    let entities: String =
        (0..20).map(|k| format!("<!ENTITY a{} \"{}\">", k + 1, format!("&a{k};").repeat(10))).collect();
    try_it("flage", format!("<!DOCTYPE a [<!ENTITY a0 \"x\">{entities}]><a>&a20;</a>").as_bytes());
    let column = |row: &dyn Fn(usize) -> String| (0..10_000).map(row).collect::<String>();
    for rows in [
        column(&|k| format!("1 {k} 0 0\n")),
        column(&|_| "1 0 0 0\n".into()),
        column(&|k| format!("1 {}e-9 0 0\n", k)),
        column(&|k| format!("1e{} {k} 0 0\n", k % 300)),
    ] {
        try_it("mstm", rows.as_bytes());
        try_it("detected", rows.as_bytes());
    }
    // Triangles around one edge, around one corner, and in one place.
    let facets = |corner: &dyn Fn(usize) -> String| {
        let facet = |k| format!("facet outer loop vertex 0 0 0 vertex {} endloop endfacet\n", corner(k));
        format!("solid\n{}endsolid\n", (0..5000).map(facet).collect::<String>())
    };
    try_it("stl", facets(&|k| format!("0 0 1 vertex 1 {k} 0")).as_bytes());
    try_it("stl", facets(&|k| format!("1 {k} 0 vertex 1 {k} 1")).as_bytes());
    try_it("stl", facets(&|_| "0 0 1 vertex 0 1 0".into()).as_bytes());
    try_it("stl", ("solid\n".to_string() + &repeated("facet outer loop vertex ", 400_000)).as_bytes());
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
