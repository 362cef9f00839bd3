//! The tables of parameters of the papers, with the values of cases.

use crate::case::section::Key;
use crate::error::{AtPath, Error};
use crate::papers::{AnyPaper, Papers, shown};
use maud::{Markup, html};
use serde_json::json;
use serde_yaml::Value;
use std::path::Path;

/// The page, and its tables for the search.
///
/// # Errors
///
/// If a case cannot be read.
pub(super) fn page(root: &Path, papers: Papers) -> Result<(String, Vec<serde_json::Value>), Error> {
    let (mut parts, mut entries) = (vec![], vec![]);
    for paper in papers.0 {
        let mut of_paper = vec![];
        for (k, table) in paper.tables().iter().enumerate() {
            let id = format!("{}-{}", paper.name(), k + 1);
            entries.push(
                json!({ "page": format!("tables.html#{id}"), "id": "", "numbers": [table.number.rsplit(' ').next()],
                                 "label": table.number, "paper": paper.reference(), "title": table.title }),
            );
            of_paper.push(section(root, papers, *paper, table, &id)?);
        }
        parts.push(html! { h2 { (paper.reference()) } @for table in &of_paper { (table) } });
    }
    let body = html! {
        h1 { "Tables of parameters" }
        p { "The values are those of the cases named, in which an experiment of the paper is computed; defaults are the values of the paper or of its authors' program." }
        @for part in &parts { (part) }
    };
    Ok((super::frame::whole("Tables of parameters", body), entries))
}

fn section(root: &Path, papers: Papers, paper: &dyn AnyPaper, table: &shown::Table, id: &str) -> Result<Markup, Error> {
    let file = root.join(table.case);
    let job = papers.parse(&file, &std::fs::read_to_string(&file).at(&file)?)?;
    let case: Value = serde_yaml::from_str(&job.resolved).expect("a resolved case is YAML");
    let values = &case["model"][paper.name()];
    let [models, ..] = paper.sections();
    let keys = models.into_iter().find(|key| key.key == paper.name()).map(|key| key.keys).unwrap_or_default();
    let rows: Vec<Markup> = keys
        .iter()
        .filter(|key| table.keys.is_empty() || table.keys.contains(&key.key))
        .flat_map(|key| rows(key, "", &values[key.key]))
        .collect();
    Ok(html! {
        section id=(id) {
            h3 { (table.number) }
            p { (table.title) ". " span.note { code { (table.case) } } }
            div.wide { table {
                thead { tr { th { "key" } th { "value" } th { "meaning" } } }
                tbody { @for row in &rows { (row) } }
            } }
        }
    })
}

/// The row of a key that has a value, or those of the keys below it.
fn rows(key: &Key, above: &str, value: &Value) -> Vec<Markup> {
    let name = format!("{above}{}", key.key);
    match value {
        Value::Null => vec![],
        Value::Mapping(_) if !key.keys.is_empty() => {
            key.keys.iter().flat_map(|below| rows(below, &format!("{name}."), &value[below.key])).collect()
        }
        _ => {
            vec![html! { tr { td { code { (name) } } td { (text(value)) } td { (key.about.trim_end_matches('.')) } } }]
        }
    }
}

fn text(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Sequence(values) => values.iter().map(text).collect::<Vec<_>>().join(", "),
        other => serde_yaml::to_string(other).unwrap_or_default().trim().to_string(),
    }
}
