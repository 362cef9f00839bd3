//! Does a film under a tip run, and do its forces agree with its energy balance?

#[path = "common/program.rs"]
mod program;

use std::path::Path;
use std::process::Command;
use veridem::output::{RunFolder, Series};
use veridem::papers::titania::Spectrum;

fn veridem(place: &Path, arguments: &[&str]) -> String {
    let output = program::veridem(place, arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

const RIGID: &str = "titania-film";
const NECKS: &str = "titania-film-necks";

fn case(name: &str) -> String {
    format!("{}/tests/cases/good/{name}.yaml", env!("CARGO_MANIFEST_DIR"))
}

fn finding(run: &Path, name: &str) -> f64 {
    let results: serde_yaml::Value =
        serde_yaml::from_str(&std::fs::read_to_string(run.join("results.yaml")).unwrap()).unwrap();
    results.get(name).unwrap_or_else(|| panic!("no {name}"))["value"].as_f64().unwrap()
}

/// Two columns of a stage.
fn columns(run: &Path, stage: &str, [x, y]: [&str; 2]) -> Vec<[f64; 2]> {
    let series = Series::read(&RunFolder::open(run).unwrap()).unwrap();
    let points = series.curve_of(stage, x, y);
    assert!(!points.is_empty(), "no {x} and {y} in {stage}");
    points.into_iter().map(|(x, y)| [x, y]).collect()
}

#[test]
fn the_tip_comes_down_to_its_setpoint_turns_and_pulls_and_the_events_are_those_that_are_counted() {
    let place = tempfile::tempdir().unwrap();
    veridem(place.path(), &["--quiet", "--threads", "1", "run", &case(RIGID), "--name", "film"]);
    let run = place.path().join("run/film");
    let curve = |stage: &str| columns(&run, stage, ["tip moved [nm]", "mean force on the tip [pN]"]);
    let (down, up) = (curve("approach"), curve("retraction"));
    let (lowest, setpoint) = (down[down.len() - 1][0], down[down.len() - 1][1]);
    assert!(setpoint >= 40.0 && down[..down.len() - 1].iter().all(|point| point[1] < 40.0));
    // Results have four digits, in nN.
    let rounded = |force: f64| format!("{:.3e}", 1e-3 * force).parse::<f64>().unwrap();
    assert_eq!(finding(&run, "force at the end of the approach"), rounded(setpoint));
    // Half of the turn is a way down by a quarter of speed times duration, 5 nm; then the tip is as fast as it was.
    let deepest = up.iter().map(|point| point[0]).fold(0.0, f64::min);
    assert!((deepest - (lowest - 5.0)).abs() < 0.1, "{deepest} {lowest}");
    let rise = up[up.len() - 1][0] - up[up.len() - 2][0];
    assert!((rise - 5.0 * 0.5).abs() < 1e-9, "{rise}");
    let largest = finding(&run, "largest pulling force on the tip");
    assert!(largest > 0.0 && up.iter().any(|point| rounded(-point[1]) == largest));
    let spectrum = Spectrum::read(&RunFolder::open(&run).unwrap()).unwrap();
    assert_eq!((spectrum.approach.len(), spectrum.retraction.len()), (down.len(), up.len()));
    assert_eq!(rounded(spectrum.largest), largest);
    assert!(spectrum.events.iter().all(|event| (deepest..=up[up.len() - 1][0]).contains(&event.0)));
    let detachments = spectrum.events.iter().filter(|event| event.1.starts_with("detachment of")).count();
    assert_eq!(detachments as f64, finding(&run, "retraction: detachments"));

    let events = std::fs::read_to_string(run.join("events.jsonl")).unwrap();
    for (what, name) in [("sliding of", "slidings"), ("rolling of", "rollings"), ("detachment of", "detachments")] {
        for stage in ["relaxation", "approach", "retraction"] {
            let lines =
                events.lines().filter(|line| line.contains(what) && line.contains(&format!("\"stage\":\"{stage}\"")));
            assert_eq!(lines.count() as f64, finding(&run, &format!("{stage}: {name}")), "{name} {stage}");
        }
    }
    for stage in ["relaxation", "approach", "retraction"] {
        for [discrete, kinetic] in columns(&run, stage, ["discrete residual [zJ]", "kinetic energy [zJ]"]) {
            assert!(discrete.abs() < 1e-6 * (1.0 + kinetic), "{stage}: {discrete}");
        }
        for [residual, _] in columns(&run, stage, ["relative residual", "step"]) {
            assert!(residual.abs() < 5e-3, "{stage}: {residual}");
        }
    }
}

#[test]
fn necks_break_under_the_tip_and_every_break_is_told_counted_and_booked() {
    let place = tempfile::tempdir().unwrap();
    veridem(place.path(), &["--quiet", "--threads", "1", "run", &case(NECKS), "--name", "film"]);
    let run = place.path().join("run/film");
    let events = std::fs::read_to_string(run.join("events.jsonl")).unwrap();
    let mut told = 0;
    for stage in ["relaxation", "approach", "retraction"] {
        let of_stage = events.lines().filter(|line| line.contains(&format!("\"stage\":\"{stage}\"")));
        let breaks = of_stage.filter(|line| line.contains("breaks")).count();
        assert_eq!(breaks as f64, finding(&run, &format!("{stage}: broken necks")), "{stage}");
        let change = |column| {
            let points = columns(&run, stage, ["step", column]);
            points[points.len() - 1][1] - points[0][1]
        };
        assert_eq!(change("necks"), -(breaks as f64));
        assert!((change("lost to breaking [zJ]") > 0.0) == (breaks > 0), "{stage}");
        told += breaks;
        for [residual, _] in columns(&run, stage, ["relative residual", "step"]) {
            assert!(residual.abs() < 5e-3, "{stage}: {residual}");
        }
    }
    assert!(told > 0);
}

#[test]
fn the_same_bits_for_any_number_of_threads_and_when_resumed() {
    for (name, stop) in [(RIGID, "9123"), (NECKS, "12345")] {
        let (place, case) = (tempfile::tempdir().unwrap(), case(name));
        veridem(place.path(), &["--quiet", "--threads", "1", "run", &case, "--name", "whole"]);
        let stopped = Command::new(env!("CARGO_BIN_EXE_veridem"))
            .current_dir(place.path())
            .args(["--quiet", "--threads", "2", "run", &case, "--name", "stopped", "--stop-after-steps", stop])
            .output()
            .unwrap();
        assert_eq!(stopped.status.code(), Some(75));
        veridem(place.path(), &["--quiet", "--threads", "2", "resume", "run/stopped"]);
        assert_eq!(veridem(place.path(), &["inspect", "--diff", "run/whole", "run/stopped"]), "identical\n");
    }
}
