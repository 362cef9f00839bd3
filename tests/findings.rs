//! Does the page of findings agree with the program?

#[path = "common/program.rs"]
mod program;

use program::veridem as run;
use veridem::papers::PAPERS;
use veridem::reproduce::{Row, claims_of, recorded};

const FINDINGS: &str = include_str!("../docs/findings.md");

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
            assert!(claims_of(FINDINGS, paper.name()).contains(&row), "the table of {} lacks{row}", paper.name());
        }
    }
}

#[test]
fn every_chapter_has_rows_in_the_table_of_its_paper_or_is_said_to_have_none() {
    for paper in PAPERS.0 {
        for chapter in paper.chapters() {
            let (row, none) =
                (format!(" `{}` |\n", chapter.name), format!("`{}` has no recorded result", chapter.name));
            let table = claims_of(FINDINGS, paper.name());
            assert!(table.contains(&row) != table.contains(&none), "{}: {}", paper.name(), chapter.name);
        }
    }
}

#[test]
fn every_row_belongs_to_a_listed_claim_and_every_claim_has_a_row_or_a_reason() {
    for paper in PAPERS.0 {
        let (record, listed) = (recorded(paper.name()), paper.listed());
        for row in &record {
            assert!(listed.iter().any(|claim| claim.is_measured_by(row)), "no claim is listed for {row:?}");
        }
        for claim in listed {
            let recorded = |(chapter, phrase): &(&str, &str)| {
                let has = |row: &Row| format!("{}: {}", row.place, row.claim).contains(phrase);
                record.iter().any(|row| row.chapter == *chapter && has(row))
            };
            let whole = !claim.rows.is_empty() && claim.rows.iter().all(recorded);
            assert!(whole || !claim.open.is_empty(), "{}: a row has no recorded result, and no reason", claim.id);
            let chapters: Vec<&str> = paper.chapters().iter().map(|chapter| chapter.name).collect();
            assert!(
                claim.rows.iter().all(|(chapter, _)| chapters.contains(chapter)),
                "{}: an unknown chapter",
                claim.id
            );
        }
    }
}

#[test]
fn the_page_of_claims_is_what_the_program_lists() {
    let place = tempfile::tempdir().unwrap();
    let found = run(place.path(), &["reproduce", "--list"]);
    assert!(found.status.success(), "{}", String::from_utf8_lossy(&found.stderr));
    let page = include_str!("../docs/claims.md");
    let listed = page.split_once("\n# ").expect("a heading of a paper").1;
    assert_eq!(format!("# {listed}"), String::from_utf8(found.stdout).unwrap());
}
