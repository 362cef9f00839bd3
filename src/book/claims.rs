//! The claims of the papers with what was measured, from the page of findings.

use super::facts::Table;
use super::text::{inline, markdown};
use super::{Book, Chapter, Entry};
use maud::{Markup, html};

/// What stands below a heading, up to the next of its level or above.
pub(super) fn part<'a>(text: &'a str, heading: &str) -> &'a str {
    let rest = text.split_once(heading).map_or("", |(_, rest)| rest);
    let ends = ["\n# ", "\n## "].map(|end| rest.find(end).unwrap_or(rest.len()));
    let end = if heading.starts_with("\n# ") { ends[0] } else { ends[0].min(ends[1]) };
    &rest[..end]
}

/// What the page of findings says of a paper beside its table.
pub(super) fn discussion(findings: &str, paper: &str) -> String {
    let beside = part(findings, &format!("\n## Claims of the {paper} paper\n"));
    let beside: String = beside.split_inclusive('\n').filter(|line| !line.starts_with('|')).collect();
    format!("{}\n{}", beside.trim(), part(findings, &format!("\n# The {paper} paper\n")))
}

/// The rows of claims about an equation.
pub(super) fn rows_on<'a>(chapter: &'a Chapter, entry: &Entry) -> Vec<&'a Vec<String>> {
    let table: &Table = &chapter.claims;
    table.rows.iter().filter(|row| entry.is_named_in(table.cell(row, "where"))).collect()
}

/// The page of a paper.
pub(super) fn page(book: &Book, chapter: &Chapter) -> String {
    let rows: Vec<_> = chapter.claims.rows.iter().collect();
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
pub(super) fn table(book: &Book, chapter: &Chapter, rows: &[&Vec<String>]) -> Markup {
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
                tr { @for name in names {
                    @let cell = chapter.claims.cell(row, name);
                    @match name {
                        "where" => td { (linked(cell)) },
                        "verdict" => td.differs[cell != "holds"] { (cell.to_lowercase()) },
                        _ => td { (inline(cell, &target)) },
                    }
                } }
            } }
        } }
    }
}
