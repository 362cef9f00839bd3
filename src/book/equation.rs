//! The page of an equation.

use super::facts::Statement;
use super::text::{inline, markdown, math, sentence};
use super::{Book, Chapter, Entry, claims, curve, errata};
use crate::spec::document::{Document, Quantity};
use crate::spec::languages::graph;
use crate::spec::languages::mathematics::{Computed, computed};
use maud::{Markup, html};
use std::collections::BTreeMap;

/// The pages of all equations, by name.
pub(super) fn pages(book: &Book) -> Vec<(String, String)> {
    let all: Vec<(&Chapter, &Entry)> = book.entries().collect();
    let neighbour = |place: Option<usize>| place.and_then(|place| all.get(place)).map(|(_, entry)| *entry);
    let page = |(k, (chapter, entry)): (usize, &(&Chapter, &Entry))| {
        (entry.page(), page(book, chapter, entry, [neighbour(k.checked_sub(1)), neighbour(Some(k + 1))]))
    };
    all.iter().enumerate().map(page).collect()
}

/// The pages with the sources of the equations, by name.
pub(super) fn sources(book: &Book) -> BTreeMap<String, String> {
    let page = |entry: &Entry| {
        let title = format!("spec/{}", entry.equation.file);
        let body = html! { h1 { (title) } pre.source { code { (entry.equation.source) } } };
        (entry.source_page(), super::frame::whole(&title, body))
    };
    book.entries().map(|(_, entry)| page(entry)).collect()
}

fn page(book: &Book, chapter: &Chapter, entry: &Entry, [before, after]: [Option<&Entry>; 2]) -> String {
    let (equation, document) = (entry.equation, entry.document);
    let target = |path: &str| book.target(chapter, path);
    let others: Vec<_> =
        book.others.iter().filter(|other| other.equations.iter().any(|id| id == equation.id)).collect();
    let body = html! {
        h1 { (entry.label()) }
        p.note { (chapter.title()) " · " (equation.id) }
        (markdown(&document.title, &target))
        (section("As printed", html! { div.formula { (math(&document.formula, true)) } }))
        (section("As computed", as_computed(entry)))
        @if !document.reading.is_empty() { (section("Reading", errata::reading(book, chapter, entry))) }
        (section("Arguments", table(&document.arguments)))
        (section("Results", table(&document.results)))
        (curve::section(entry))
        @if book.laws.contains(&equation.id) {
            p { "This law is also drawn as " a href=(format!("laws.html#{}", equation.id)) { "forces of two spheres" } "." }
        }
        (section("Laws", laws(entry)))
        (section("Rounding", html! { p { (entry.rounding) } }))
        (section("Values of others", html! {
            p { (counted(entry.independent, "vector")) " in " code { "golden/" } " computed independently of this code." }
            @if !others.is_empty() {
                ul { @for other in others { li { (sentence(&other.test)) " " span.note { (inline(&other.source, &target)) } } } }
            }
        }))
        @let rows = claims::rows_on(chapter, entry);
        @if !rows.is_empty() { (section("Claims", claims::table(book, chapter, &rows))) }
        (section("Used by", used(entry)))
        (section("Source", html! {
            p { code { (equation.function) } " in " a href=(entry.source_page()) { code { "spec/" (equation.file) } } }
        }))
        nav.turning {
            span { @if let Some(entry) = before { a rel="prev" href=(entry.page()) { (entry.label()) } } }
            span { @if let Some(entry) = after { a rel="next" href=(entry.page()) { (entry.label()) } } }
        }
    };
    super::frame::whole(&format!("{}, {}", entry.label(), chapter.title()), body)
}

pub(super) fn section(title: &str, body: Markup) -> Markup {
    html! { section { h2 { (title) } (body) } }
}

fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// Most lines of a computed form on a page.
const MOST_LINES: usize = 40;

fn as_computed(entry: &Entry) -> Markup {
    let graph = graph(entry.equation);
    let Computed { parts, results } = computed(&graph, entry.document);
    if parts.len() + results.len() > MOST_LINES {
        let (id, steps) = (entry.equation.id, graph.nodes.len());
        return html! { p { "In " (steps) " steps, which " code { "veridem eq export --language c " (id) } " writes." } };
    }
    let lines = parts.iter().chain(&results);
    html! { @for line in lines { div.formula { (math(&format!("{} = {}", line.symbol, line.formula), true)) } } }
}

fn table(quantities: &[Quantity]) -> Markup {
    let unit = |q: &Quantity| if q.size == 1 { q.unit.clone() } else { format!("{} ({})", q.unit, q.size) };
    html! {
        div.wide { table {
            thead { tr { th { "symbol" } th { "name" } th { "unit" } th { "domain" } th { "meaning" } } }
            tbody { @for q in quantities {
                tr {
                    td { (math(&q.symbol, false)) }
                    td { code { (q.name) } }
                    td { (unit(q)) }
                    td { (q.domain.to_string()) }
                    td { (inline(&q.meaning, &|_| None)) }
                }
            } }
        } }
    }
}

/// The statements, and what holds for every equation by construction.
fn laws(entry: &Entry) -> Markup {
    html! {
        table.laws { tbody {
            @for statement in &entry.statements {
                tr { td { (claim(statement, entry.document)) } td.status { (statement.status) } }
            }
            tr { td { "Units balance, and no digit depends on the units." } td.status { "by construction" } }
        } }
        p.note { "What these words mean, and over which arguments laws are proved: " a href="proofs.html" { "proofs" } ", " a href="verification.html" { "verification" } "." }
    }
}

/// A statement with the symbols of the quantities that it names, such as `f_n rises with k_n`.
fn claim(Statement { text, .. }: &Statement, document: &Document) -> Markup {
    if text.ends_with('.') {
        return html! { (text) };
    }
    if text == "finite" {
        return html! { "Every result is finite, and no denominator is zero." };
    }
    let quantities: Vec<&Quantity> = document.arguments.iter().chain(&document.results).collect();
    let word = |word: &str| match word {
        ">=" => html! { "≥ " },
        "<=" => html! { "≤ " },
        _ => match quantities.iter().find(|q| q.name == word && !q.symbol.is_empty()) {
            Some(q) => html! { (math(&q.symbol, false)) " " },
            None => html! { (word) " " },
        },
    };
    html! { @for part in text.split(' ') { (word(part)) } }
}

fn used(entry: &Entry) -> Markup {
    let who = match entry.role.as_str() {
        "engine" => "The engine and its contact laws.",
        "equation" => "Other equations only.",
        "claim" => "The claims only: the program compares it with what the paper says.",
        _ => "Nothing but its laws.",
    };
    html! {
        p { (who) }
        @if !entry.users.is_empty() { ul { @for user in &entry.users { li { code { (user) } } } } }
    }
}
