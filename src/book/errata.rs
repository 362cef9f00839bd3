//! What was found in the papers: errata with their effects and proofs, ambiguities, and forms that cancel.

use super::facts::status_of_law;
use super::text::{after_colon, markdown, math, sentence};
use super::{Book, Chapter, Entry};
use crate::spec::finding::{Finding, Kind};
use maud::{Markup, html};

/// The page.
pub(super) fn page(book: &Book) -> String {
    let part = |kind: Kind, title: &str, about: &str| {
        let found = findings(book, kind);
        html! {
            h2 { (title) " (" (found.len()) ")" }
            p { (about) }
            @for (chapter, entry, finding) in &found { (card(book, chapter, entry, finding)) }
        }
    };
    let body = html! {
        h1 { "What we found in the papers" }
        p { "The papers are followed to the letter unless they contradict themselves or mechanics. This page is made of the readings of the equations." }
        (part(Kind::Erratum, "Errata", "What is printed, what is right, what the printed form would do, and the law that fails for it. Each law is a test of this project."))
        (part(Kind::Ambiguous, "Ambiguities", "Where the text allows several readings, and which one is taken."))
        (part(Kind::Cancellation, "Forms that lose digits", "The printed terms are right, but cancel in floating-point numbers; another form of the same value is evaluated."))
    };
    super::frame::whole("What we found in the papers", body)
}

fn findings<'a>(book: &'a Book, kind: Kind) -> Vec<(&'a Chapter<'a>, &'a Entry<'a>, Finding<'a>)> {
    let found = book.entries().filter_map(|(chapter, entry)| Some((chapter, entry, Finding::of(entry.document)?)));
    found.filter(|(.., finding)| finding.kind == kind).collect()
}

fn card(book: &Book, chapter: &Chapter, entry: &Entry, finding: &Finding) -> Markup {
    let target = |path: &str| book.target(chapter, path);
    let row = |name: &str, content: Markup| html! { tr { th { (name) } td { (content) } } };
    html! {
        section.finding id=(entry.equation.id) {
            h3 { a href=(entry.page()) { (entry.label()) } " " span.note { (chapter.title()) } }
            div.wide { table {
                (row("printed", html! { div.formula { (math(&entry.document.formula, true)) } }))
                (row("right", after_colon(&finding.text, &target)))
                @if !finding.effect.is_empty() { (row("effect", after_colon(finding.effect, &target))) }
                @if !finding.proof.is_empty() { (row("proof", proof(entry, finding))) }
            } }
        }
    }
}

fn proof(entry: &Entry, finding: &Finding) -> Markup {
    let status = |law| status_of_law(entry.equation.source, law);
    html! { @for law in &finding.proof { p { (sentence(law)) " " span.note { (status(law)) } } } }
}

/// The reading of an equation, with its finding by parts.
pub(super) fn reading(book: &Book, chapter: &Chapter, entry: &Entry) -> Markup {
    let target = |path: &str| book.target(chapter, path);
    let Some(finding) = Finding::of(entry.document) else { return markdown(&entry.document.reading, &target) };
    html! {
        p { a href=(format!("errata.html#{}", entry.equation.id)) { (finding.kind.label()) } }
        (after_colon(&finding.text, &target))
        @if !finding.effect.is_empty() { h3 { "Effect" } (after_colon(finding.effect, &target)) }
        @if !finding.proof.is_empty() { h3 { "Proof" } (proof(entry, &finding)) }
    }
}
