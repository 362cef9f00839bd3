//! The claims of the papers with what was measured, from the page of findings.

use super::text::{inline, markdown};
use super::{Book, Chapter, Entry};
use crate::reproduce::{Row, claims_of};
use maud::{Markup, html};

/// What the page of findings says of a paper beside its table.
pub(super) fn discussion(findings: &str, paper: &str) -> String {
    let beside = claims_of(findings, paper).split_inclusive('\n').filter(|line| !line.starts_with('|'));
    let reasons = findings.split_once(&format!("\n# The {paper} paper\n")).map_or("", |(_, rest)| rest);
    format!("{}\n{}", beside.collect::<String>().trim(), reasons.split("\n# ").next().unwrap_or_default())
}

/// The rows of claims about an equation.
pub(super) fn rows_on<'a>(chapter: &'a Chapter, entry: &Entry) -> Vec<&'a Row> {
    chapter.claims.iter().filter(|row| entry.is_named_in(&row.place)).collect()
}

/// The page of a paper.
pub(super) fn page(book: &Book, chapter: &Chapter) -> String {
    let rows: Vec<_> = chapter.claims.iter().collect();
    let body = html! {
        h1 { "What the paper claims, and what was measured" }
        p.note { (chapter.title()) }
        p { "The chapter of a claim computes it again: " code { "veridem reproduce " (chapter.name) " --only CHAPTER" } "." }
        (table(book, chapter, &rows))
        (markdown(&chapter.discussion, &|_| None))
    };
    super::frame::whole(&format!("Claims of {}", chapter.title()), body)
}

/// Rows of claims as a table, with links to the equations that they name.
pub(super) fn table(book: &Book, chapter: &Chapter, rows: &[&Row]) -> Markup {
    let names = ["where", "claim", "paper", "measured", "verdict", "chapter"];
    let linked = |place: &str| {
        let mut entries = chapter.entries.iter().filter(|entry| entry.is_named_in(place));
        html! { @match entries.next() { Some(entry) => a href=(entry.page()) { (place) }, None => (place) } }
    };
    let target = |path: &str| book.target(chapter, path);
    html! {
        div.wide { table.claims {
            thead { tr { @for name in names { th { (name) } } } }
            tbody { @for row in rows {
                tr {
                    td { (linked(&row.place)) }
                    @for cell in [&row.claim, &row.paper, &row.measured] { td { (inline(cell, &target)) } }
                    td.differs[row.verdict != "holds"] { (row.verdict.to_lowercase()) }
                    td { code { (row.chapter) } }
                }
            } }
        } }
    }
}
