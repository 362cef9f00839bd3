//! Does the page of findings agree with the program?

#[path = "common/program.rs"]
mod program;

use program::veridem as run;
use veridem::papers::PAPERS;

const FINDINGS: &str = include_str!("../docs/findings.md");

/// The table of a paper.
fn table(paper: &str) -> &'static str {
    let heading = format!("Claims of the {paper} paper\n");
    let rest = FINDINGS.split("\n## ").find(|part| part.starts_with(&heading)).expect("a table for every paper");
    rest.split("\n# ").next().unwrap_or_default()
}

#[test]
fn the_claims_that_follow_from_the_equations_stand_in_the_tables_as_they_are_computed() {
    let place = tempfile::tempdir().unwrap();
    for paper in PAPERS.0 {
        let found = run(place.path(), &["--quiet", "reproduce", paper.name(), "--only", "exact"]);
        assert!(found.status.success(), "{}", String::from_utf8_lossy(&found.stderr));
        let computed = String::from_utf8(found.stdout).unwrap();
        let rows: Vec<String> = computed.lines().skip(2).map(|row| format!("\n{row} `exact` |\n")).collect();
        assert!(!rows.is_empty());
        for row in rows {
            assert!(table(paper.name()).contains(&row), "the table of {} lacks{row}", paper.name());
        }
    }
}

#[test]
fn every_chapter_has_rows_in_the_table_of_its_paper() {
    for paper in PAPERS.0 {
        for chapter in paper.chapters() {
            let mark = format!(" `{}` |\n", chapter.name);
            assert!(table(paper.name()).contains(&mark), "{}: {}", paper.name(), chapter.name);
        }
    }
}
