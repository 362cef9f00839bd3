//! One function for each reader of files: whatever the bytes are, it ends soon, without a panic, and an error of the input names the file.
//!
//! `cargo test --test fuzz` calls them with seeds and mutations of seeds, `cargo fuzz` with whatever reaches new code.

use crate::checkpoints;
use std::path::Path;
use veridem::error::{Error, silence};
use veridem::geometry::Sphere;
use veridem::initial::aggregate::import::{Format, Options, parse, parse_necks};
use veridem::initial::stl::parse_stl;
use veridem::interrupt::Interrupt;
use veridem::output::Manifest;
use veridem::papers::PAPERS;
use veridem::spec::Vec3;

/// A reader: its name, and how it is called.
type Target = (&'static str, fn(&[u8]));

/// Every reader.
pub(crate) const TARGETS: [Target; 11] = [
    ("case", case),
    ("detected", |bytes| aggregate(None, bytes)),
    ("flage", |bytes| aggregate(Some(Format::Flage), bytes)),
    ("mstm", |bytes| aggregate(Some(Format::Mstm), bytes)),
    ("vtk", |bytes| aggregate(Some(Format::Vtk), bytes)),
    ("lammps", |bytes| aggregate(Some(Format::Lammps), bytes)),
    ("xyz", |bytes| aggregate(Some(Format::Xyz), bytes)),
    ("necks", necks),
    ("stl", stl),
    ("manifest", manifest),
    ("checkpoint", checkpoints::resumed),
];

/// Calls a reader by its name.
pub(crate) fn call(name: &str, bytes: &[u8]) {
    silence();
    let target =
        TARGETS.iter().find(|target| target.0 == name).unwrap_or_else(|| panic!("there is no reader `{name}`"));
    target.1(bytes);
}

/// An error names the file and, if it knows one, a line of it.
fn judge<T>(file: &str, bytes: &[u8], result: Result<T, Error>) {
    let problems = match result {
        Ok(_) => return,
        Err(Error::Input(problems)) => problems,
        Err(other) => panic!("{other}: expected an error of the input"),
    };
    assert!(!problems.is_empty());
    // Line breaks of YAML, some of which are no bytes of their own.
    let lines = 2 + bytes.iter().filter(|byte| matches!(byte, b'\n' | b'\r' | 0x85 | 0xa8 | 0xa9)).count();
    for problem in problems {
        assert_eq!(problem.file, Path::new(file), "{problem}");
        assert!(problem.line.is_none_or(|line| (1..=lines).contains(&line)), "{problem}: there are {lines} lines");
        assert!(!problem.what.is_empty());
    }
}

fn case(bytes: &[u8]) {
    if let Ok(text) = std::str::from_utf8(bytes) {
        judge("a.yaml", bytes, PAPERS.parse(Path::new("a.yaml"), text));
    }
}

fn aggregate(format: Option<Format>, bytes: &[u8]) {
    // The spheres of some formats have no radius, others no unit of length.
    let options = [(Some(1.0), None), (None, Some(14.0)), (Some(1.0), Some(14.0))];
    for (unit, radius) in options {
        let options = Options { format, unit, radius, disconnected: true };
        judge("a.xyz", bytes, parse(Path::new("a.xyz"), bytes, &options, &Interrupt::default()));
    }
}

fn necks(bytes: &[u8]) {
    let spheres = [-28.0, 0.0, 28.0].map(|x| Sphere { centre: Vec3([x, 0.0, 0.0]), radius: 14.0 });
    judge("necks.vtk", bytes, parse_necks(Path::new("necks.vtk"), bytes, &spheres, &Interrupt::default()));
}

fn stl(bytes: &[u8]) {
    judge("tip.stl", bytes, parse_stl(Path::new("tip.stl"), bytes, 1.0));
}

fn manifest(bytes: &[u8]) {
    judge("manifest.json", bytes, Manifest::parse(Path::new("manifest.json"), bytes));
}
