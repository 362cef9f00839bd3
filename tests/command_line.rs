//! Do the commands around a run work as documented?

#[path = "common/program.rs"]
mod program;

use program::veridem as telling;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

fn case(name: &str) -> String {
    format!("{}/tests/cases/good/{name}.yaml", env!("CARGO_MANIFEST_DIR"))
}

/// Without its messages on standard error.
fn veridem(place: &Path, arguments: &[&str]) -> Output {
    telling(place, &[&["--quiet"], arguments].concat())
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
    assert_eq!(rows[0][..4], ["sample.hcp.diameter", "model.wear.poisson_ratio", "status", "Young's modulus [GPa]"]);
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
    let modulus = &json[0]["results"]["Young's modulus"];
    assert_eq!((rows[1][3].parse().ok(), modulus["unit"].as_str()), (modulus["value"].as_f64(), Some("GPa")));
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
    assert_eq!(sweep.status.code(), Some(2), "the exit status of the run that failed");
    let (told, table) = (text(&sweep.stderr), text(&sweep.stdout));
    let refused = "seed=3: swept/seed=3: is not a resumable run; remove this folder to start again\n";
    assert!(told.contains(refused), "{told}");
    let cells = |row: &str| {
        let cells: Vec<String> = row.split(',').map(str::to_string).collect();
        [cells[1].clone(), cells[cells.len() - 2].clone(), cells[cells.len() - 1].clone()]
    };
    let rows: Vec<[String; 3]> = table.lines().skip(1).map(cells).collect();
    let reason = "swept/seed=3: is not a resumable run; remove this folder to start again";
    assert_eq!(rows, [["finished", "", "seed=1"], ["finished", "", "seed=2"], ["not run", reason, "seed=3"]]);
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
        refused("seed=1..2.5"),
        (Some(2), "`seed=1..2.5`: a range without `:COUNT` must have whole numbers as limits\n".into())
    );
    assert_eq!(refused("title.x=1"), (Some(2), "`title.x=1`: `title` is not a section\n".into()));
    assert_eq!(refused("seed.=1"), (Some(2), "`seed.=1`: expected a key such as `sample.hcp.size[1]`\n".into()));
    let (code, message) = refused("sample.hcp.siz[0]=9 d_0");
    assert_eq!(code, Some(65));
    assert!(message.ends_with("sample.hcp: unknown key `siz`, did you mean `size`?\n"), "{message}");
}

#[test]
fn a_sweep_varies_lists_their_items_and_keys_that_have_defaults() {
    let place = tempfile::tempdir().unwrap();
    let whole = std::fs::read_to_string(case("patch-hcp")).unwrap();
    let bare = whole.replace("    size: [6 d_0, 8 d_0, 3 d_0]\n", "");
    std::fs::write(place.path().join("patch.yaml"), bare).unwrap();
    let sweep = |keys: &[&str]| {
        let all = [&["sweep", "patch.yaml", "--out", "swept", "--stop-after-steps", "2"], keys].concat();
        let output = veridem(place.path(), &all);
        assert_eq!(output.status.code(), Some(75), "{}", text(&output.stderr));
        text(&output.stdout)
    };
    let lists = ["sample.hcp.size=[6 d_0, 8 d_0, 3 d_0],[8 d_0, 6 d_0, 3 d_0]", "title='one, two'"];
    assert_eq!(sweep(&lists).lines().count(), 3);
    let items = ["sample.hcp.size[0]=6 d_0", "sample.hcp.size[1]=6 d_0", "limits.overlap=0.7..0.9:3"];
    let table = sweep(&items);
    assert_eq!(table.lines().count(), 6, "{table}");
    let head = "sample.hcp.size,title,sample.hcp.size[0],sample.hcp.size[1],limits.overlap,status,reason,run\n";
    assert!(table.starts_with(head), "{table}");
    assert!(table.contains("\n\"[8 d_0, 6 d_0, 3 d_0]\",\"'one, two'\",,,,stopped,"), "{table}");
    assert!(table.contains("\n,,6 d_0,6 d_0,0.8,stopped,"), "{table}");
    for entry in std::fs::read_dir(place.path().join("swept")).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        assert!(name.len() < 200 && name.chars().all(|c| c.is_ascii_alphanumeric() || "._=,-".contains(c)), "{name}");
        if entry.path().is_dir() {
            let case = std::fs::read_to_string(entry.path().join("case.yaml")).unwrap();
            assert!(case.contains("- 3 d_0\n") || case.contains("- 3.0 d_0\n"), "the default is kept: {case}");
        }
    }
}

#[test]
fn the_summary_of_a_sweep_keeps_earlier_rows_and_is_never_made_of_another_file() {
    let place = tempfile::tempdir().unwrap();
    let sweep = |key: &str| veridem(place.path(), &["--json", "sweep", &case("patch-hcp"), key, "--out", "swept"]);
    assert!(sweep("seed=1").status.success());
    let halted = sweep("limits.overlap=0.001,0.8");
    assert_eq!(halted.status.code(), Some(5));
    let json: serde_json::Value = serde_json::from_slice(&halted.stdout).expect("one document");
    assert_eq!((&json[0]["status"], &json[0]["error"]["exit"]), (&"halted".into(), &5.into()));
    assert!(json[0]["reason"].as_str().unwrap().starts_with("halted at step "), "{json}");
    assert_eq!((&json[1]["status"], &json[1]["error"]), (&"finished".into(), &serde_json::Value::Null));
    let file = place.path().join("swept/summary.csv");
    let summary = std::fs::read_to_string(&file).unwrap();
    let first = |row: &str| row.split(',').take(3).map(str::to_string).collect::<Vec<_>>();
    let rows: Vec<Vec<String>> = summary.lines().map(first).collect();
    let expected =
        [["seed", "limits.overlap", "status"], ["1", "", "finished"], ["", "0.001", "halted"], ["", "0.8", "finished"]];
    assert_eq!(rows, expected);
    std::fs::write(&file, "date,notes\n1,mine\n").unwrap();
    let refused = sweep("seed=7");
    assert_eq!(refused.status.code(), Some(65));
    assert!(!place.path().join("swept/seed=7").exists());
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "date,notes\n1,mine\n");
}

#[test]
fn a_sweep_begins_with_its_longest_runs() {
    let place = tempfile::tempdir().unwrap();
    let key = "experiment.patch.compression.duration=300 steps,100 steps,900 steps,600 steps";
    let sweep = ["--threads", "1", "sweep", &case("patch-hcp"), key, "--out", "swept"];
    let sweep = telling(place.path(), &sweep);
    assert!(sweep.status.success(), "{}", text(&sweep.stderr));
    let told = text(&sweep.stderr);
    let ended: Vec<&str> = told.lines().filter_map(|line| line.strip_suffix("steps: finished")).collect();
    assert_eq!(ended, ["900", "600", "300", "100"].map(|steps| format!("duration={steps}")));
}

#[test]
fn forced_a_sweep_begins_every_run_anew() {
    let place = tempfile::tempdir().unwrap();
    let sweep = |force: &[&str]| {
        let output =
            telling(place.path(), &[&["sweep", &case("patch-hcp"), "seed=1,2", "--out", "swept"], force].concat());
        assert!(output.status.success(), "{}", text(&output.stderr));
        let written =
            |seed| place.path().join(format!("swept/seed={seed}/series.csv")).metadata().unwrap().modified().unwrap();
        [written(1), written(2)]
    };
    let first = sweep(&[]);
    assert_eq!(sweep(&[]), first);
    let anew = sweep(&["--force"]);
    assert!(anew[0] > first[0] && anew[1] > first[1]);
}

#[test]
fn with_json_every_command_writes_one_document_and_every_error_is_an_object() {
    let place = tempfile::tempdir().unwrap();
    let json = |arguments: &[&str]| -> serde_json::Value {
        let output = veridem(place.path(), &[&["--json"], arguments].concat());
        let parsed = serde_json::from_slice(&output.stdout);
        let json: serde_json::Value =
            parsed.unwrap_or_else(|error| panic!("{arguments:?}: {error}: {}", text(&output.stdout)));
        if let Some(error) = json.get("error") {
            assert_eq!(error["exit"], output.status.code().unwrap(), "{arguments:?}");
            assert!(!error["what"].as_str().unwrap().is_empty());
        } else {
            assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
        }
        json
    };
    let patch = case("patch-hcp");
    for arguments in
        [&["run", &patch][..], &["check", &patch], &["inspect", "run/patch-hcp"], &["schema"], &["eq", "list"]]
    {
        assert!(json(arguments).get("error").is_none(), "{arguments:?}");
    }
    let diff = json(&["inspect", "--diff", "run/patch-hcp", "run/patch-hcp"]);
    assert_eq!(diff["identical"], true);
    assert_eq!(json(&["eq", "show", "wear-3"])["id"], "wear-3");
    assert_eq!(json(&["completions", "bash"])["shell"], "bash");
    for (arguments, exit) in [
        (&["run", &patch][..], 2),
        (&["run", "nowhere.yaml"], 66),
        (&["resume", "nowhere"], 66),
        (&["inspect", "nowhere"], 66),
        (&["check"], 2),
        (&["eq", "show", "wear-nothing"], 2),
        (&["import", "nowhere"], 66),
        (&["frobnicate"], 2),
    ] {
        assert_eq!(json(arguments)["error"]["exit"], exit, "{arguments:?}");
    }
    std::fs::write(place.path().join("wrong.yaml"), "title: x\nsead: 3\n").unwrap();
    let error = &json(&["check", "wrong.yaml"])["error"];
    assert_eq!((&error["file"], &error["line"]), (&"wrong.yaml".into(), &2.into()));
    assert_eq!(error["problems"][0]["what"], "unknown key `sead`, did you mean `seed`?");
}

#[test]
fn a_batch_with_a_wrong_line_answers_all_and_exits_65() {
    use std::io::Write;
    let mut batch = Command::new(env!("CARGO_BIN_EXE_veridem"))
        .args(["eq", "eval", "--batch"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let good = r#"{"id": "mechanics-sphere-volume", "in": {"r": 1}}"#;
    batch.stdin.take().unwrap().write_all(format!("{good}\n\n{good}").as_bytes()).unwrap();
    let output = batch.wait_with_output().unwrap();
    assert_eq!((output.status.code(), text(&output.stdout).lines().count()), (Some(65), 3));
    assert_eq!(text(&output.stderr), "standard input: 1 of 3 lines were answered with an error\n");
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
    let changed = std::fs::read_to_string(&series).unwrap().replacen(",24,24,18\n", ",24,24,18.5\n", 1);
    std::fs::write(&series, changed).unwrap();
    let differ = veridem(place.path(), &["inspect", "--diff", "run/one", "run/two"]);
    assert_eq!(differ.status.code(), Some(4));
    assert_eq!(text(&differ.stdout), "series.csv: row 1, side z [nm]: 18 and 18.5\n");
    assert_eq!(text(&differ.stderr), "run/one and run/two differ\n");

    std::fs::write(&series, std::fs::read(place.path().join("run/one/series.csv")).unwrap()).unwrap();
    let frame = place.path().join("run/two/frames/cohesion.000001.xyz");
    let changed = std::fs::read_to_string(&frame).unwrap().replacen("\n", "0\n", 1);
    std::fs::write(&frame, changed).unwrap();
    std::fs::remove_file(place.path().join("run/two/frames/cohesion.000000.xyz")).unwrap();
    let differ = veridem(place.path(), &["inspect", "--diff", "run/one", "run/two"]);
    let told = text(&differ.stdout);
    assert!(
        told.starts_with("frames/cohesion.000000.xyz: present and missing\nframes/cohesion.000001.xyz: line 1: `"),
        "{told}"
    );
    std::fs::remove_file(&series).unwrap();
    let missing = veridem(place.path(), &["inspect", "run/two"]);
    assert_eq!(missing.status.code(), Some(66));
    assert!(text(&missing.stderr).starts_with("run/two/series.csv: cannot be read: "), "{}", text(&missing.stderr));

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
    assert_eq!(json["results"]["Young's modulus"]["unit"], "GPa");
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
    assert!(told.contains("\nnecks            1 across gaps and overlaps below 0.01 nm, `neck_distance`\n"), "{told}");
    assert!(told.contains("at the start of a run with the defaults of `soot`, which keep 0 necks\n"), "{told}");
    assert!(told.contains("\ncoordination number     1.333\n"), "{told}");
}
