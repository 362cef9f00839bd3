//! Do paths in a case go from its folder, and does a run keep what it has read?

#[path = "common/program.rs"]
mod program;

use program::veridem;
use std::path::Path;

fn succeeds(folder: &Path, arguments: &[&str]) -> String {
    let done = veridem(folder, arguments);
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).expect("text")
}

fn fails(folder: &Path, arguments: &[&str], status: i32) -> String {
    let done = veridem(folder, arguments);
    let text = String::from_utf8_lossy(&done.stderr).to_string();
    assert_eq!(done.status.code(), Some(status), "{arguments:?}: {text}");
    text
}

const STL: &str = "solid s\nfacet normal 0 0 1\nouter loop\nvertex -100 -100 0\nvertex 100 -100 0\nvertex 0 100 0\nendloop\nendfacet\nendsolid s\n";

/// A project: a case that reads an aggregate beside it and a substrate above it, and saves below it.
fn project(place: &Path) {
    std::fs::create_dir_all(place.join("project/cases/data")).expect("folders");
    let write = |name: &str, text: &str| std::fs::write(place.join("project").join(name), text).expect("a file");
    write("cases/data/row.xyz", "3\n\nC 0 0 0 14\nC 28 0 0 14\nC 56 0 0 14\n");
    write("floor.stl", STL);
    write(
        "cases/case.yaml",
        "title: t\nmodel: {soot: {}}\nsample: {aggregate: {import: {file: data/row.xyz, unit: 1 nm}}}\nexperiment:\n  \
         deposition: {velocity: 2 m/s, duration: 4000 steps, substrate: {stl: ../floor.stl, unit: 1 nm}, save: data/row.sample}\n",
    );
}

#[test]
fn relative_paths_go_from_the_folder_of_the_case() {
    let place = tempfile::tempdir().expect("a folder");
    let here = place.path();
    project(here);
    succeeds(here, &["check", "project/cases/case.yaml"]);
    succeeds(here, &["--quiet", "run", "project/cases/case.yaml", "--out", "elsewhere/run"]);
    assert!(here.join("project/cases/data/row.sample").exists());
    let run = here.join("elsewhere/run/case");
    assert_eq!(std::fs::read_to_string(run.join("inputs/floor.stl")).expect("a copy"), STL);
    assert!(run.join("inputs/row.xyz").exists());
    // The case is what its author has written.
    let resolved = std::fs::read_to_string(run.join("case.resolved.yaml")).expect("a case");
    assert!(resolved.contains("stl: ../floor.stl\n"), "{resolved}");

    std::fs::remove_file(here.join("project/floor.stl")).expect("a file");
    let text = fails(here, &["check", "project/cases/case.yaml"], 66);
    let folder = here.canonicalize().expect("a folder").join("project/cases");
    let expected = format!("`../floor.stl` goes from {}, the folder of the case", folder.display());
    assert!(text.starts_with("project/cases/../floor.stl: cannot be read") && text.contains(&expected), "{text}");
}

#[test]
fn a_run_is_resumed_from_its_copies_wherever_it_and_the_originals_are() {
    let place = tempfile::tempdir().expect("a folder");
    let here = place.path();
    project(here);
    let whole = ["--quiet", "run", "project/cases/case.yaml", "--name", "whole"];
    succeeds(here, &whole);
    std::fs::remove_file(here.join("project/cases/data/row.sample")).expect("a file");
    let half = [&["--quiet", "run", "project/cases/case.yaml", "--name", "half"][..], &["--stop-after-steps", "1500"]];
    fails(here, &half.concat(), 75);
    std::fs::remove_file(here.join("project/floor.stl")).expect("a file");
    std::fs::remove_file(here.join("project/cases/data/row.xyz")).expect("a file");
    std::fs::create_dir(here.join("archive")).expect("a folder");
    std::fs::rename(here.join("run/half"), here.join("archive/half")).expect("a folder that moves");
    succeeds(&here.join("archive"), &["--quiet", "resume", "half"]);
    assert_eq!(succeeds(here, &["inspect", "--diff", "run/whole", "archive/half"]), "identical\n");
    assert!(here.join("project/cases/data/row.sample").exists(), "it is saved where the case says");
    // What has been run can be run again.
    std::fs::remove_file(here.join("project/cases/data/row.sample")).expect("a file");
    succeeds(here, &["--quiet", "run", "archive/half/case.yaml", "--name", "again"]);
    assert_eq!(succeeds(here, &["inspect", "--diff", "run/whole", "run/again"]), "identical\n");
}

#[test]
fn copies_that_have_changed_are_refused() {
    let place = tempfile::tempdir().expect("a folder");
    let here = place.path();
    project(here);
    // Before the first step, so that everything is read again.
    fails(here, &["--quiet", "run", "project/cases/case.yaml", "--max-time", "0"], 75);
    std::fs::write(here.join("run/case/inputs/row.xyz"), "1\n\nC 0 0 0 14\n").expect("a file");
    let text = fails(here, &["--quiet", "resume", "run/case"], 65);
    assert_eq!(text, "run/case/inputs/row.xyz: has changed since the run was started\n");
}

#[test]
fn a_forced_run_removes_the_copies_of_the_earlier_one_and_nothing_else() {
    let place = tempfile::tempdir().expect("a folder");
    let here = place.path();
    project(here);
    succeeds(here, &["--quiet", "run", "project/cases/case.yaml"]);
    std::fs::write(here.join("run/case/inputs/mine.txt"), "mine").expect("a file");
    let plain = "title: t\nmodel: {soot: {}}\nsample: {aggregate: {spheres: 3}}\nexperiment: {deposition: {duration: 2 steps}}\n";
    std::fs::write(here.join("project/cases/case.yaml"), plain).expect("a case");
    succeeds(here, &["--quiet", "run", "project/cases/case.yaml", "--force"]);
    let left: Vec<_> = std::fs::read_dir(here.join("run/case/inputs")).expect("a folder").collect();
    assert_eq!(left.len(), 1);
    std::fs::remove_file(here.join("run/case/inputs/mine.txt")).expect("a file of one's own");
    succeeds(here, &["--quiet", "run", "project/cases/case.yaml", "--force"]);
    assert!(!here.join("run/case/inputs").exists());
}

#[test]
fn files_with_one_name_and_large_files_are_told_apart() {
    let place = tempfile::tempdir().expect("a folder");
    let here = place.path();
    project(here);
    // Two surfaces of one name; the aggregate is large, by its comment.
    let wide = STL.replace("100", "200");
    std::fs::write(here.join("project/cases/floor.stl"), &wide).expect("a file");
    let comment = "a long comment ".repeat(100_000);
    std::fs::write(here.join("project/cases/data/row.xyz"), format!("1\n{comment}\nC 0 0 0 14\n")).expect("a file");
    let case = "title: t\nmodel: {soot: {}}\nsample: {aggregate: {import: {file: data/row.xyz, unit: 1 nm}}}\nexperiment:\n  sequence:\n";
    let stage = |stl: &str| format!("    - deposition: {{duration: 2 steps, substrate: {{stl: {stl}, unit: 1 nm}}}}\n");
    let case = [case, &stage("../floor.stl"), &stage("floor.stl"), &stage("../cases/floor.stl")].concat();
    std::fs::write(here.join("project/cases/case.yaml"), case).expect("a case");
    succeeds(here, &["--quiet", "run", "project/cases/case.yaml"]);
    let copy = |name: &str| std::fs::read_to_string(here.join("run/case/inputs").join(name)).expect("a copy");
    assert_eq!((copy("floor.stl"), copy("2 floor.stl")), (STL.to_string(), wide));
    assert_eq!(std::fs::read_dir(here.join("run/case/inputs")).expect("a folder").count(), 2);
    let manifest = std::fs::read(here.join("run/case/manifest.json")).expect("a manifest");
    let manifest: serde_json::Value = serde_json::from_slice(&manifest).expect("JSON");
    let large = here.canonicalize().expect("a folder").join("project/cases/data/row.xyz").display().to_string();
    assert_eq!(manifest["files"]["data/row.xyz"], large.as_str());
    assert!(manifest["inputs"][large].is_string());
}

#[test]
fn a_sweep_resumes_its_members_from_their_copies() {
    let place = tempfile::tempdir().expect("a folder");
    let here = place.path();
    project(here);
    let case = here.join("project/cases/case.yaml");
    let text = std::fs::read_to_string(&case).expect("a case").replace(", save: data/row.sample", "");
    std::fs::write(&case, text.replace("4000", "400000")).expect("a case");
    let sweep = ["--quiet", "sweep", "project/cases/case.yaml", "seed=1,2"];
    fails(here, &[&sweep[..], &["--stop-after-steps", "20000"]].concat(), 75);
    std::fs::remove_file(here.join("project/floor.stl")).expect("a file");
    let text = fails(here, &[&sweep[..], &["--stop-after-steps", "20"]].concat(), 75);
    assert!(!text.contains("cannot be read"), "{text}");
}
