//! The forces of the contact laws, drawn by their exported kernels.

use super::curve::{bounds, drawing, kernel, literal, script};
use super::{Book, Entry};
use crate::papers::Papers;
use crate::papers::shown::Law;
use crate::spec::document::Domain;
use crate::spec::languages::{Exported, Language, Row};
use maud::{Markup, html};
use serde_json::{Value, json};

/// The page.
pub(super) fn page(book: &Book, papers: Papers) -> String {
    let mut exported: Vec<Exported> = papers.0.iter().flat_map(|paper| paper.exported_laws()).collect();
    let body = html! {
        h1 { "Forces of the contact laws" }
        p { "Each law is computed in this page by its exported kernel, the code that the program runs. The first curve pulls two spheres apart at rest; a positive force repels. \
             The second shears them to and fro at a fixed distance: the path that is left is the loop of the friction. All quantities are in SI." }
        @for paper in papers.0 {
            h2 { (paper.reference()) }
            @for law in paper.shown_laws() { (section(book, &law, exported.extract_if(.., |other| other.id == law.id).collect())) }
        }
    };
    super::frame::whole("Forces of the contact laws", body)
}

/// A law as an equation, or as `procedures`: its constants, and its forces.
fn section(book: &Book, law: &Law, mut procedures: Vec<Exported>) -> Markup {
    let entry = book.entries().map(|(_, entry)| entry).find(|entry| entry.equation.id == law.id);
    if let Some(Entry { equation, document, .. }) = entry {
        procedures.push(Exported::equation(equation, document, ""));
    }
    let module = Language::Javascript.module(&procedures);
    let (constants, [.., forces]) = (procedures.len() > 1, &procedures[..]) else {
        panic!("`{}` is no equation and no exported law", law.id);
    };
    let arguments: Vec<&Row> = match constants {
        true => procedures[0].arguments.iter().chain(&forces.arguments).collect(),
        false => forces.arguments.iter().collect(),
    };
    let parameter = |(name, value): &(&str, f64)| -> Option<Value> {
        let row = arguments.iter().find(|row| row.name == *name)?;
        let domain = Domain::parse(&row.domain).unwrap_or(Domain::ANY);
        let [lo, hi] = bounds(domain, *value);
        Some(json!({ "name": name, "unit": row.unit, "meaning": row.meaning, "start": value, "lo": lo, "hi": hi }))
    };
    let parameters: Vec<Value> = law.values.iter().filter_map(parameter).collect();
    let sizes = |rows: &[Row]| rows.iter().map(|row| json!({ "name": row.name, "size": row.size })).collect::<Vec<_>>();
    let data = json!({
        "id": law.id, "gaps": law.gaps, "gap": law.gap, "path": law.path, "parameters": parameters,
        "arguments": sizes(&forces.arguments), "results": sizes(&forces.results),
    });
    let of_pair = if constants { procedures[0].name.as_str() } else { "null" };
    html! {
        section.law id=(law.id) {
            h3 { @match entry { Some(entry) => a href=(entry.page()) { (law.title) }, None => (law.title) } }
            figure { figcaption { "Normal force against the gap of the surfaces" } (drawing("Normal force")) }
            figure { figcaption { "Tangential force against the displacement" } (drawing("Tangential force")) }
            (kernel(&module, &format!("{}-kernel", law.id)))
            (script(&format!("{module}\ndrawLaw({}, {of_pair}, {});", forces.name, literal(&data))))
        }
    }
}
