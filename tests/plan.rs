//! Does a run do as its check says, and is nothing excessive begun by mistake?

#[path = "common/program.rs"]
mod program;

use serde_json::Value;
use std::path::Path;
use std::process::Output;

/// Exit status, result and messages of a command in a folder.
fn veridem(place: &Path, arguments: &[&str]) -> (i32, String, String) {
    let Output { status, stdout, stderr } = program::veridem(place, arguments);
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).to_string();
    (status.code().expect("no signal"), text(&stdout), text(&stderr))
}

fn case(name: &str) -> String {
    format!("{}/tests/cases/good/{name}.yaml", env!("CARGO_MANIFEST_DIR"))
}

fn checked(place: &Path, case: &str) -> Value {
    let (status, result, told) = veridem(place, &["check", case, "--json"]);
    assert_eq!(status, 0, "{told}");
    serde_json::from_str(&result).unwrap()
}

const CHAIN: &str = "title: a chain
model: {soot: {}}
sample: {aggregate: {spheres: 8}}
experiment: {restructuring: {duration: 1234 steps}}
output: {series: 100 steps, frames: 500 steps}
";

#[test]
fn a_run_writes_the_rows_and_frames_of_its_plan() {
    let place = tempfile::tempdir().unwrap();
    let place = place.path();
    std::fs::write(place.join("chain.yaml"), CHAIN).unwrap();
    for case in ["chain.yaml", &case("soot-short")] {
        let plan = &checked(place, case)["plan"];
        let (status, _, told) = veridem(place, &["run", case, "--name", "x", "--force"]);
        assert_eq!(status, 0, "{told}");
        let total = |key: &str| -> u64 {
            plan["stages"].as_object().unwrap().values().map(|stage| stage[key].as_u64().unwrap()).sum()
        };
        let series = std::fs::read_to_string(place.join("run/x/series.csv")).unwrap();
        assert_eq!(series.lines().count() as u64, 1 + total("rows of series.csv"), "{case}");
        let endings = std::fs::read_dir(place.join("run/x/frames")).unwrap().map(|entry| entry.unwrap().path());
        let frames = endings.filter(|path| path.extension().unwrap() == "xyz").count();
        assert_eq!(frames as u64, total("frames"), "{case}");
        let first = plan["stages"].as_object().unwrap().keys().next().unwrap();
        let frame = std::fs::read_to_string(place.join(format!("run/x/frames/{first}.000000.xyz"))).unwrap();
        assert_eq!(frame.lines().next().unwrap(), plan["spheres"].to_string(), "{case}");
    }
}

#[test]
fn intervals_that_are_no_whole_steps_are_told() {
    let place = tempfile::tempdir().unwrap();
    let place = place.path();
    std::fs::write(place.join("chain.yaml"), CHAIN.replace("series: 100 steps", "series: 0.010104 ns")).unwrap();
    let plan = &checked(place, "chain.yaml")["plan"];
    let stage = &plan["stages"]["restructuring"];
    let told = stage["interval of series"].as_str().unwrap();
    assert!(told.contains("steps, rounded from 0.010104 ns"), "{told}");
    assert!(stage.get("interval of frames").is_none());
}

#[test]
fn the_excessive_is_begun_on_request_alone() {
    let place = tempfile::tempdir().unwrap();
    let place = place.path();
    for (name, from, to, what) in [
        ("steps", "1234 steps", "1e19 steps", "steps, more than"),
        ("rows", "duration: 1234 steps", "duration: 1e11 steps", "rows of series.csv, more than"),
        (
            "frames",
            "1234 steps}}\noutput: {series: 100 steps, frames: 500",
            "1e9 steps}}\noutput: {series: 1e9 steps, frames: 100",
            "frames, more than",
        ),
    ] {
        let file = format!("{name}.yaml");
        std::fs::write(place.join(&file), CHAIN.replace(from, to)).unwrap();
        for command in ["check", "run"] {
            let (status, _, told) = veridem(place, &[command, &file]);
            assert_eq!((status, told.contains(what), told.contains("--yes")), (65, true, true), "{told}");
        }
        assert!(!place.join("run").exists());
        let (status, _, told) = veridem(place, &["check", &file, "--yes"]);
        assert_eq!(status, 0, "{told}");
    }
    let (status, _, told) = veridem(place, &["schema", "--threads", "20000"]);
    assert_eq!((status, told.contains("found 20000, expected at most 1024")), (2, true), "{told}");
    let wide = std::fs::read_to_string(case("patch-hcp"))
        .unwrap()
        .replace("size: [6 d_0, 8 d_0, 3 d_0]", "size: [3000 d_0, 3000 d_0, 300 d_0]");
    std::fs::write(place.join("wide.yaml"), wide).unwrap();
    let (status, _, told) = veridem(place, &["check", "wide.yaml"]);
    assert_eq!((status, told.contains("spheres, which need")), (65, true), "{told}");
}

#[test]
fn a_halt_names_the_sphere_for_which_the_step_is_too_long() {
    // Below the limit of two spheres, above that of a sphere with several necks.
    let place = tempfile::tempdir().unwrap();
    let place = place.path();
    let stiff = CHAIN.replace("spheres: 8", "spheres: 40, fractal_dimension: 2.5, growth: spheres");
    std::fs::write(
        place.join("stiff.yaml"),
        stiff.replace("duration: 1234 steps", "duration: 20000 steps, dt: 15.5 fs"),
    )
    .unwrap();
    for command in ["check", "run"] {
        let (status, _, told) = veridem(place, &[command, "stiff.yaml"]);
        assert_eq!(status, 5, "{told}");
        assert!(told.contains("the time step 15.5 fs may be too long") && told.contains("necks is stable"), "{told}");
    }
}
