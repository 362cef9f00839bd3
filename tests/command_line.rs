//! Do the commands around a run work as documented?

use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

fn case(name: &str) -> String {
    format!("{}/tests/cases/good/{name}.yaml", env!("CARGO_MANIFEST_DIR"))
}

fn veridem(place: &Path, arguments: &[&str]) -> Output {
    telling(place, &[&["--quiet"], arguments].concat())
}

/// With its messages on standard error.
fn telling(place: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_veridem")).current_dir(place).args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).to_string()
}

#[test]
fn the_schema_lists_every_key_with_its_meaning_and_default() {
    let place = tempfile::tempdir().unwrap();
    let listed = text(&veridem(place.path(), &["schema"]).stdout);
    let keys = |text: &str| text.lines().filter(|line| !line.trim_start().starts_with('#')).count();
    let json: serde_json::Value = serde_json::from_slice(&veridem(place.path(), &["schema", "--json"]).stdout).unwrap();
    fn count(keys: &serde_json::Value) -> usize {
        keys.as_array().map_or(0, |keys| keys.iter().map(|key| 1 + count(&key["keys"])).sum())
    }
    assert_eq!(keys(&listed), count(&json));
    assert!(
        listed
            .contains("# Young's modulus E. Expects a pressure such as `73 GPa`. Required.\n    young_modulus: ...\n")
    );
    assert!(listed.contains("# Seed of all random streams. Expects a whole number.\nseed: 1\n"));
}

#[test]
fn a_sweep_runs_every_combination_once_and_sums_up() {
    let place = tempfile::tempdir().unwrap();
    let keys = ["sample.hcp.diameter=0.6 d_c,1.2 d_c", "model.wear.poisson_ratio=0..0.25:2"];
    let sweep = || telling(place.path(), &["sweep", &case("patch-hcp"), keys[0], keys[1], "--out", "swept"]);
    let first = sweep();
    assert!(first.status.success(), "{}", text(&first.stderr));
    assert!(text(&first.stderr).starts_with("4 runs, 4 of them new: about "), "{}", text(&first.stderr));
    let rows: Vec<Vec<String>> =
        text(&first.stdout).lines().map(|l| l.split(',').map(str::to_string).collect()).collect();
    assert_eq!(rows[0][..4], ["sample.hcp.diameter", "model.wear.poisson_ratio", "status", "Young's modulus [MPa]"]);
    assert!(!text(&first.stderr).contains("before"), "nothing was there: {}", text(&first.stderr));
    let points: Vec<&[String]> = rows[1..].iter().map(|row| &row[..3]).collect();
    let point = |d, nu| [d, nu, "finished"];
    assert_eq!(
        points,
        [point("0.6 d_c", "0"), point("0.6 d_c", "0.25"), point("1.2 d_c", "0"), point("1.2 d_c", "0.25")]
    );
    assert_eq!(std::fs::read_to_string(place.path().join("swept/summary.csv")).unwrap(), text(&first.stdout));

    let series = place.path().join("swept/diameter=0.6d_c,poisson_ratio=0/series.csv");
    let made = series.metadata().unwrap().modified().unwrap();
    let again = sweep();
    assert!(text(&again.stderr).starts_with("4 runs, all started before\n"), "{}", text(&again.stderr));
    assert_eq!(text(&again.stdout), text(&first.stdout));
    assert_eq!(series.metadata().unwrap().modified().unwrap(), made, "a finished run is not made again");

    let json = veridem(place.path(), &["--json", "sweep", &case("patch-hcp"), keys[0], keys[1], "--out", "swept"]);
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json.as_array().unwrap().len(), 4);
    assert_eq!(json[0]["run"], "swept/diameter=0.6d_c,poisson_ratio=0");
    assert_eq!((&json[0]["keys"]["sample.hcp.diameter"], &json[0]["status"]), (&"0.6 d_c".into(), &"finished".into()));
    assert_eq!(
        (&*rows[1][3], &json[0]["results"][0]["name"]),
        (json[0]["results"][0]["value"].as_str().unwrap(), &"Young's modulus".into())
    );
}

#[test]
fn a_sweep_begins_in_a_folder_that_holds_no_run_yet_and_leaves_others_alone() {
    let place = tempfile::tempdir().unwrap();
    let swept = place.path().join("swept");
    std::fs::create_dir_all(swept.join("seed=1")).unwrap();
    std::fs::create_dir_all(swept.join("seed=2/frames")).unwrap();
    std::fs::write(swept.join("seed=2/case.yaml.part"), "ti").unwrap();
    std::fs::create_dir_all(swept.join("seed=3")).unwrap();
    std::fs::write(swept.join("seed=3/notes.txt"), "mine").unwrap();
    let sweep = telling(place.path(), &["sweep", &case("patch-hcp"), "seed=1..3", "--out", "swept"]);
    assert_eq!(sweep.status.code(), Some(4));
    let (told, table) = (text(&sweep.stderr), text(&sweep.stdout));
    let refused = "seed=3: swept/seed=3: is not a resumable run; remove this folder to start again\n";
    assert!(told.contains(refused), "{told}");
    let status: Vec<&str> = table.lines().skip(1).map(|row| row.split(',').nth(1).unwrap()).collect();
    assert_eq!(status, ["finished", "finished", "not run"]);
    assert!(swept.join("seed=3/notes.txt").exists());
}

#[test]
fn a_sweep_is_refused_that_has_no_runs_or_the_same_twice() {
    let place = tempfile::tempdir().unwrap();
    for (keys, expected) in [
        (&["seed=1,2", "seed=3,4"][..], "`seed=3,4`: the key `seed` is given twice\n"),
        (&["seed=5,6,6"], "`6` and `6` are the same case\n"),
        (&["seed=1,2", "sample.hcp.diameter=0.6 d_c,0.60 d_c"], "`1, 0.6 d_c` and `1, 0.60 d_c` are the same case\n"),
        (&["model.wear.young_modulus=1 GPa,1GPa"], "`1 GPa` and `1GPa` have the same run folder\n"),
        (&["seed=3..1"], "`seed=3..1`: expected an increasing range\n"),
    ] {
        let output = veridem(place.path(), &[&["sweep", &case("patch-hcp")], keys].concat());
        assert_eq!((output.status.code(), &*text(&output.stderr)), (Some(2), expected));
    }
    assert!(!place.path().join("run").exists());
}

#[test]
fn a_sweep_over_a_wrong_key_or_value_is_refused_before_anything_runs() {
    let place = tempfile::tempdir().unwrap();
    let refused = |key: &str| {
        let output = veridem(place.path(), &["sweep", &case("patch-hcp"), key]);
        assert!(!place.path().join("run").exists());
        (output.status.code(), text(&output.stderr))
    };
    let (code, message) = refused("model.wear.poisson=0.1,0.2");
    assert_eq!(code, Some(65));
    let unknown = "model.wear: unknown key `poisson`, expected one of `young_modulus`, `poisson_ratio`";
    let (place, what) = message.split_once(": ").unwrap();
    assert_eq!(
        place,
        format!("{} with model.wear.poisson=0.1", case("patch-hcp")),
        "no line: it is not that of the file"
    );
    assert!(what.starts_with(unknown), "{message}");
    let (code, message) = refused("model.wear.poisson_ratio=0.2,0.3");
    assert_eq!(code, Some(65));
    assert!(
        message.contains("model.wear.poisson_ratio: found `0.3`, expected more than -1 and at most 1/4"),
        "{message}"
    );
    assert_eq!(
        refused("seed=1..x"),
        (Some(2), "`seed=1..x`: a range without `:COUNT` must have whole numbers as limits\n".into())
    );
    assert_eq!(refused("title.x=1"), (Some(2), "`title.x`: there is no such key\n".into()));
}

#[test]
fn inspect_finds_what_differs_between_two_runs() {
    let place = tempfile::tempdir().unwrap();
    for (name, threads) in [("one", "1"), ("two", "2")] {
        let run = veridem(place.path(), &["run", &case("junction"), "--name", name, "--threads", threads]);
        assert!(run.status.success(), "{}", text(&run.stderr));
    }
    let same = veridem(place.path(), &["inspect", "--diff", "run/one", "run/two"]);
    assert_eq!((same.status.code(), &*text(&same.stdout)), (Some(0), "identical\n"));

    let series = place.path().join("run/two/series.csv");
    let changed = std::fs::read_to_string(&series).unwrap().replacen(",24,24,18,", ",24,24,18.5,", 1);
    std::fs::write(&series, changed).unwrap();
    let differ = veridem(place.path(), &["inspect", "--diff", "run/one", "run/two"]);
    assert_eq!(differ.status.code(), Some(4));
    assert_eq!(text(&differ.stdout), "side z [nm]: differs from row 1 on, by up to 5e-1 of 1.85e1\n");
    assert_eq!(text(&differ.stderr), "run/one and run/two differ\n");

    let summary = text(&veridem(place.path(), &["inspect", "run/one"]).stdout);
    assert!(summary.starts_with("A small junction, coarse and short\nFinished, "), "{summary}");
    assert!(summary.contains("\nfate of the junction"), "{summary}");
}

#[test]
fn json_goes_to_standard_output_and_messages_to_standard_error() {
    let place = tempfile::tempdir().unwrap();
    let run = Command::new(env!("CARGO_BIN_EXE_veridem"))
        .current_dir(place.path())
        .args(["run", "--json", &case("patch-hcp")])
        .output()
        .unwrap();
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(json["results"][0]["name"], "Young's modulus");
    assert!(text(&run.stderr).ends_with("finished: run/patch-hcp/report.html\n"));
    let manifest: serde_json::Value =
        serde_json::from_slice(&std::fs::read(place.path().join("run/patch-hcp/manifest.json")).unwrap()).unwrap();
    assert_eq!(manifest["status"], "finished");
    assert_eq!(manifest["inputs"].as_object().unwrap().len(), 1);
    assert!(manifest["outputs"].as_object().unwrap().contains_key("series.csv"));
}

#[test]
fn a_simulation_that_leaves_its_domain_says_where_and_keeps_the_state() {
    let place = tempfile::tempdir().unwrap();
    let strict = std::fs::read_to_string(case("junction")).unwrap() + "limits:\n  overlap: 0.01\n";
    std::fs::write(place.path().join("strict.yaml"), strict).unwrap();
    let halted = veridem(place.path(), &["run", "strict.yaml"]);
    assert_eq!(halted.status.code(), Some(5));
    let message = text(&halted.stderr);
    assert!(message.starts_with("halted at step 0 (t = 0.01"), "{message}");
    assert!(
        message.ends_with("of the sum of their radii (limit 0.01); the state is in run/strict/halted.xyz\n"),
        "{message}"
    );
    let folder = place.path().join("run/strict");
    assert!(std::fs::read_to_string(folder.join("halted.xyz")).unwrap().contains("stage=cohesion"));
    assert!(std::fs::read_to_string(folder.join("events.jsonl")).unwrap().ends_with("(limit 0.01)\"}\n"));
    assert!(std::fs::read_to_string(folder.join("manifest.json")).unwrap().contains("\"status\": \"halted\""));
    assert_eq!(veridem(place.path(), &["resume", "run/strict"]).status.code(), Some(5), "the last checkpoint is valid");
}

#[test]
fn a_signal_stops_a_run_at_a_checkpoint() {
    let place = tempfile::tempdir().unwrap();
    let long = std::fs::read_to_string(case("junction")).unwrap().replace("duration: 600 steps", "duration: 1 ns");
    std::fs::write(place.path().join("long.yaml"), long).unwrap();
    let mut run = Command::new(env!("CARGO_BIN_EXE_veridem"))
        .current_dir(place.path())
        .args(["--quiet", "run", "long.yaml"])
        .stderr(Stdio::piped())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let series = place.path().join("run/long/series.csv");
    let begun = Instant::now();
    while !series.exists() && begun.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(Command::new("kill").args(["-TERM", &run.id().to_string()]).status().unwrap().success());
    assert_eq!(run.wait().unwrap().code(), Some(75));
    let manifest = std::fs::read_to_string(place.path().join("run/long/manifest.json")).unwrap();
    assert!(manifest.contains("\"status\": \"stopped\""));
    let resumed = veridem(place.path(), &["resume", "run/long", "--stop-after-steps", "10"]);
    assert_eq!(text(&resumed.stderr), "stopped; resume with `veridem resume run/long`\n");
}

#[test]
fn completions_know_the_subcommands() {
    let script = text(&veridem(Path::new("."), &["completions", "bash"]).stdout);
    for command in ["run", "resume", "check", "sweep", "inspect", "schema", "completions"] {
        assert!(script.contains(&format!("veridem__subcmd__{command}")), "{command}");
    }
}

#[test]
fn an_import_tells_how_many_necks_the_spheres_would_have() {
    let place = tempfile::tempdir().unwrap();
    std::fs::write(place.path().join("row.xyz"), "3\n\nC 0 0 0\nC 28 0 0\nC 56.1 0 0\n").unwrap();
    let told = veridem(place.path(), &["import", "row.xyz", "--unit", "1 nm", "--radius", "14 nm"]);
    let told = text(&told.stdout);
    assert!(told.ends_with("\nnecks            1 across gaps below 0.01 nm, `neck_distance`\n"), "{told}");
}
