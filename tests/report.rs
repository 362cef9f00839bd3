//! What a run shows its user: its report, again from the folder alone, its film, and the report of a sweep.

use std::path::Path;
use std::process::{Command, Output};

fn case(name: &str) -> String {
    format!("{}/tests/cases/good/{name}.yaml", env!("CARGO_MANIFEST_DIR"))
}

/// Exit status, data and messages of a command in a folder.
fn veridem(place: &Path, arguments: &[&str]) -> (i32, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_veridem")).current_dir(place).args(arguments).output();
    let Output { status, stdout, stderr } = output.expect("a program");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).to_string();
    (status.code().expect("no signal"), text(&stdout), text(&stderr))
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn a_report_is_written_again_and_a_film_is_drawn_from_the_folder_alone() {
    let place = tempfile::tempdir().expect("a folder");
    let place = place.path();
    assert_eq!(veridem(place, &["--quiet", "run", &case("patch-hcp"), "--name", "a"]).0, 0);
    let page = place.join("run/a/report.html");
    let first = read(&page);
    for what in [
        "<h2>Results</h2>",
        "<h2>Spheres</h2>",
        "<h2>Curves</h2>",
        "<h2>Pictures</h2>",
        "<h2>Case</h2>",
        "href=\"results.yaml\"",
        "Finished after",
    ] {
        assert!(first.contains(what), "{what}");
    }
    // The only address is the name of the language of pictures, which nothing fetches.
    let fetched = first.replace("http://www.w3.org/2000/svg", "");
    assert!(
        first.len() < 10_000_000 && !fetched.contains("http://") && !fetched.contains("https://"),
        "self-contained"
    );
    std::fs::remove_file(&page).expect("a page");
    std::fs::remove_file(place.join("run/a/figures/ledger.svg")).expect("a figure");
    let (status, told, _) = veridem(place, &["report", "run/a"]);
    assert_eq!((status, told.trim()), (0, "run/a/report.html"));
    assert!(read(&page) == first && place.join("run/a/figures/ledger.svg").exists());

    for (arguments, file) in
        [(&["movie", "run/a"][..], "run/a/movie.gif"), (&["movie", "run/a", "--out", "b.gif"], "b.gif")]
    {
        let (status, told, problems) = veridem(place, arguments);
        assert_eq!((status, told.trim()), (0, file), "{problems}");
        assert!(std::fs::read(place.join(file)).expect("a film").starts_with(b"GIF89a"), "{file}");
    }
    // A film is a run's own: a new run replaces it without a word.
    let (status, _, told) = veridem(place, &["run", &case("patch-hcp"), "--name", "a", "--force"]);
    assert!(status == 0 && !told.contains("warning") && !place.join("run/a/movie.gif").exists(), "{told}");
}

#[test]
fn a_stopped_run_has_a_report_that_says_so_and_shows_no_results() {
    let place = tempfile::tempdir().expect("a folder");
    let place = place.path();
    let stop = ["--quiet", "run", &case("patch-hcp"), "--name", "a", "--stop-after-steps", "30"];
    assert_eq!(veridem(place, &stop).0, 75);
    assert_eq!(veridem(place, &["report", "run/a"]).0, 0);
    let page = read(&place.join("run/a/report.html"));
    assert!(
        page.contains("<p class=\"verdict\">Stopped after") && !page.contains("<h2>Results</h2>"),
        "{}",
        &page[..400]
    );
    // A frame that cannot be read is left out, and the page says so.
    let frames = std::fs::read_dir(place.join("run/a/frames")).expect("frames");
    let last = frames
        .map(|entry| entry.expect("a frame").path())
        .filter(|path| path.extension().is_some_and(|e| e == "xyz"))
        .max();
    let last = last.expect("a frame");
    std::fs::copy(&last, last.with_file_name("shear.999999.xyz")).expect("a copy");
    std::fs::write(&last, "2\nno frame\n").expect("a broken frame");
    assert_eq!(veridem(place, &["report", "run/a"]).0, 0);
    assert!(read(&place.join("run/a/report.html")).contains("1 that cannot be read or are empty are left out"));
    let (status, _, told) = veridem(place, &["movie", "run/a"]);
    assert_eq!((status, told.contains("is no frame in the extended XYZ format")), (65, true), "{told}");
}

#[test]
fn a_sweep_has_a_report_with_its_results_against_the_key() {
    let place = tempfile::tempdir().expect("a folder");
    let place = place.path();
    let sweep = ["--quiet", "sweep", &case("patch-hcp"), "model.wear.restitution=0.9,0.95", "--out", "out"];
    let (status, _, told) = veridem(place, &sweep);
    assert_eq!(status, 0, "{told}");
    let page = read(&place.join("out/report.html"));
    for what in [
        "2 of 2 runs have finished",
        "against model.wear.restitution",
        "href=\"summary.csv\"",
        "/report.html\">finished</a>",
    ] {
        assert!(page.contains(what), "{what}");
    }
}
