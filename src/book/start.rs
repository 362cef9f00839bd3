//! What the files of the repository know of an equation.

use super::Entry;
use crate::golden::{File, INDEX, Vector, read};
use crate::spec::document::Document;
use crate::spec::equation::Equation;
use std::collections::BTreeMap;
use std::path::Path;

/// The files in which each equation is used, by its id, from the index of the specification.
pub(super) fn users(root: &Path) -> std::io::Result<BTreeMap<String, Vec<String>>> {
    let text = std::fs::read_to_string(root.join(INDEX))?;
    let cells =
        |line: &str| -> Vec<String> { line.trim_matches('|').split('|').map(|cell| cell.trim().to_string()).collect() };
    let mut rows = text.lines().filter(|line| line.starts_with('|')).map(cells);
    let place = rows.next().and_then(|names| names.iter().position(|name| name == "used in"));
    let files = |cells: Vec<String>| -> Option<(String, Vec<String>)> {
        let users = cells.get(place?)?;
        Some((cells[0].clone(), users.split(", ").filter(|user| !user.is_empty()).map(String::from).collect()))
    };
    Ok(rows.filter_map(files).collect())
}

/// An equation with the arguments at which its curve begins: those of the independent vector with most values in SI, which is of the paper or near it.
///
/// # Errors
///
/// If its golden vectors cannot be read.
pub(super) fn entry<'a>(
    equation: &'a Equation,
    document: &'a Document,
    golden: &Path,
    users: Vec<String>,
) -> Result<Entry<'a>, String> {
    let File { vectors, .. } = read(golden, equation)?;
    let is_independent = |vector: &&Vector| vector.source.is_some();
    let in_si = |vector: &&Vector| {
        let far = |x: &&f64| **x != 0.0 && !(1e-3..1e3).contains(&x.abs());
        vector.numbers(document).map_or(0, |numbers| numbers.iter().filter(far).count())
    };
    let begins = vectors.iter().filter(is_independent).max_by_key(in_si).or(vectors.first());
    let begins = begins.ok_or_else(|| format!("{} has no golden vectors", equation.id))?;
    Ok(Entry {
        equation,
        document,
        start: begins.numbers(document)?,
        origin: begins.source.clone().unwrap_or_else(|| "a sampled vector".into()),
        independent: vectors.iter().filter(is_independent).count(),
        users,
    })
}
