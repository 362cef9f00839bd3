//! Does the README agree with the files that it quotes and shows?

use std::fs;
use std::path::Path;

const README: &str = include_str!("../README.md");

fn file(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path))
        .unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Fences announced by `<!-- excerpt: path -->`, with that path.
fn excerpts() -> Vec<(&'static str, &'static str)> {
    let announced = README.split("<!-- excerpt: ").skip(1);
    announced
        .map(|rest| {
            let (path, rest) = rest.split_once(" -->").expect("a path");
            let (_, fence) = rest.split_once("```").expect("a fence");
            let (_, body) = fence.split_once('\n').expect("a line after the fence's language");
            (path, body.split("```").next().unwrap_or_default())
        })
        .collect()
}

#[test]
fn every_excerpt_is_verbatim() {
    let excerpts = excerpts();
    assert!(!excerpts.is_empty());
    for (path, excerpt) in excerpts {
        assert!(file(path).contains(excerpt), "{path} no longer contains\n{excerpt}");
    }
}

#[test]
fn every_link_and_picture_exists() {
    let targets: Vec<&str> = README.split("](").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    assert!(!targets.is_empty());
    for target in targets.into_iter().filter(|target| !target.contains("://") && !target.starts_with('#')) {
        assert!(Path::new(env!("CARGO_MANIFEST_DIR")).join(target).exists(), "{target} does not exist");
    }
}

#[test]
fn every_case_that_it_runs_exists() {
    let cases: Vec<&str> =
        README.split_whitespace().filter(|word| word.starts_with("cases/") && word.ends_with(".yaml")).collect();
    assert!(!cases.is_empty());
    for case in cases {
        file(case);
    }
}

#[test]
fn the_cases_at_the_top_are_those_of_their_paper() {
    for name in ["agglomerate.yaml", "film.yaml"] {
        assert_eq!(file(&format!("cases/{name}")), file(&format!("cases/titania/{name}")));
    }
}
