//! The book: a page for each equation, in the order of the papers. Pages need no network and no server.

mod curve;
mod page;
mod start;
mod text;

use crate::equations;
use crate::error::{AtPath, Error};
use crate::golden::INDEX;
use crate::spec::document::Document;
use crate::spec::equation::Equation;
use std::path::Path;

/// An equation and what is known of it.
struct Entry<'a> {
    equation: &'a Equation,
    document: &'a Document,
    /// Arguments at which its curve begins, laid end to end.
    start: Vec<f64>,
    /// Where these arguments come from.
    origin: String,
    /// The number of independently computed vectors.
    independent: usize,
    /// The files in which it is used.
    users: Vec<String>,
}

/// A chapter: the equations of a paper, or those that papers share.
struct Chapter<'a> {
    name: &'a str,
    /// Authors and year; empty if it is no paper.
    reference: &'a str,
    entries: Vec<Entry<'a>>,
}

/// Files that all pages share, by name.
const SHARED: [(&str, &str); 2] = [("book.css", include_str!("book.css")), ("book.js", include_str!("book.js"))];

/// The files of the book by name, from the repository at `root`; `reference` gives authors and year of a paper by its name.
///
/// # Errors
///
/// If the index or golden vectors cannot be read.
pub fn files(
    root: &Path,
    registry: &equations::Registry,
    reference: impl Fn(&str) -> &'static str,
) -> Result<Vec<(String, String)>, Error> {
    let users = start::users(root).at(&root.join(INDEX))?;
    let mut chapters: Vec<Chapter> = vec![];
    for equations::Entry { equation, document } in &registry.0 {
        let name = equation.id.split('-').next().unwrap_or_default();
        let used = users.get(equation.id).cloned().unwrap_or_default();
        let entry = start::entry(equation, document, &root.join("golden"), used).map_err(Error::Verification)?;
        match chapters.last_mut().filter(|chapter| chapter.name == name) {
            Some(chapter) => chapter.entries.push(entry),
            None => chapters.push(Chapter { name, reference: reference(name), entries: vec![entry] }),
        }
    }
    let mut files: Vec<(String, String)> =
        SHARED.iter().map(|(name, content)| (name.to_string(), content.to_string())).collect();
    files.push(("entries.js".into(), page::entries(&chapters)));
    files.push(("index.html".into(), page::contents(&chapters)));
    let all: Vec<(&Chapter, &Entry)> =
        chapters.iter().flat_map(|chapter| chapter.entries.iter().map(move |entry| (chapter, entry))).collect();
    for (k, (chapter, entry)) in all.iter().enumerate() {
        let neighbour = |place: Option<usize>| place.and_then(|place| all.get(place)).map(|(_, entry)| *entry);
        let neighbours = [neighbour(k.checked_sub(1)), neighbour(Some(k + 1))];
        files.push((page::file(entry.equation.id), page::equation(chapter, entry, neighbours)));
    }
    Ok(files)
}
