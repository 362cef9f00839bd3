//! What all pages have, the contents, and the list for the search.

use super::text::plain;
use super::{Book, Chapter, Entry};
use maud::{DOCTYPE, Markup, html};
use serde_json::{Value, json};

/// A page.
pub(super) fn whole(title: &str, body: Markup) -> String {
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                link rel="icon" href="data:,";
                link rel="stylesheet" href="book.css";
                script src="entries.js" {}
                script src="search.js" {}
                script src="curve.js" {}
            }
            body {
                header {
                    a href="index.html" { "veridem" }
                    div.search { input type="search" placeholder="Number or word" aria-label="Search"; ul {} }
                    nav {
                        a href="errata.html" { "errata" }
                        a href="index.html#claims" { "claims" }
                        a href="laws.html" { "forces" }
                        a href="tables.html" { "tables" }
                    }
                }
                main { (body) }
            }
        }
    }
    .into_string()
}

/// The table of contents.
pub(super) fn contents(book: &Book) -> String {
    let row = |entry: &Entry| {
        html! { tr { td { a href=(entry.page()) { (entry.label()) } } td { (plain(&entry.document.title)) } } }
    };
    let chapter = |chapter: &Chapter| {
        html! { h2 id=(chapter.name) { (chapter.title()) } table { @for entry in &chapter.entries { (row(entry)) } } }
    };
    let body = html! {
        h1 { "The equations of three contact models" }
        p { "Each equation has a page: how it is printed, how it is computed, how it was read, which laws it obeys, and who else computed the same." }
        ul {
            @for chapter in &book.chapters { li { a href=(format!("#{}", chapter.name)) { (chapter.title()) } } }
            li { a href="errata.html" { "What we found in the papers" } }
            li { a href="laws.html" { "Forces of the contact laws" } }
            li { a href="tables.html" { "Tables of parameters" } }
            @for (file, title, _) in &book.documents { li { a href=(file) { (title) } } }
        }
        h2 id="claims" { "Claims with what was measured" }
        ul { @for chapter in book.papers() { li { a href=(chapter.claims_page()) { (chapter.title()) } } } }
        @for one in &book.chapters { (chapter(one)) }
    };
    whole("veridem: the equations", body)
}

/// What the search looks through: the equations and `others`.
pub(super) fn entries(book: &Book, others: Vec<Value>) -> String {
    let entry = |(chapter, entry): (&Chapter, &Entry)| {
        json!({ "page": entry.page(), "id": entry.equation.id, "numbers": entry.equation.covers, "label": entry.label(),
                "paper": chapter.title(), "title": plain(&entry.document.title) })
    };
    let all: Vec<Value> = book.entries().map(entry).chain(others).collect();
    format!("const ENTRIES = {};\n", Value::from(all))
}
