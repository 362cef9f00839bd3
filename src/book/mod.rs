//! The book: a page for each equation, in the order of the papers, and pages of what was found. Pages need no network and no server.

mod claims;
mod curve;
mod equation;
mod errata;
mod facts;
mod frame;
mod laws;
mod tables;
mod text;

use crate::equations::Registry;
use crate::error::{AtPath, Error};
use crate::golden::INDEX;
use crate::papers::Papers;
use crate::proofs::PAGE as PROOFS;
use crate::reproduce::{Row, claims_of, rows};
use crate::spec::document::Document;
use crate::spec::equation::Equation;
use facts::{Other, Statement, Table};
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
    /// What it is used for.
    role: String,
    /// The files in which it is used.
    users: Vec<String>,
    statements: Vec<Statement>,
    /// The bound of its rounding error, and whether it is proved.
    rounding: String,
}

/// A chapter: the equations of a paper, or those that papers share.
struct Chapter<'a> {
    name: &'a str,
    /// Authors and year; empty if it is no paper.
    reference: &'a str,
    entries: Vec<Entry<'a>>,
    /// The recorded rows of its claims.
    claims: Vec<Row>,
    /// What is to be said of its claims, as Markdown.
    discussion: String,
}

/// All that the pages show.
struct Book<'a> {
    chapters: Vec<Chapter<'a>>,
    others: Vec<Other>,
    /// The ids of the contact laws whose forces are drawn.
    laws: Vec<&'static str>,
    /// The pages of the repository that the book has as they are: file, title, Markdown.
    documents: Vec<(&'a str, &'a str, String)>,
}

/// Files that all pages share, by name.
const SHARED: [(&str, &str); 3] = [
    ("book.css", include_str!("book.css")),
    ("search.js", include_str!("search.js")),
    ("curve.js", include_str!("curve.js")),
];

/// The pages of the repository on claims, and on how laws were tested; the tests with values of others.
const FINDINGS: &str = "docs/findings.md";
const VERIFICATION: &str = "docs/verification.md";
const CLAIMS: &str = "docs/claims.md";
const OTHERS: &str = "tests/others";

/// The files of the book by name, from the repository at `root`.
///
/// # Errors
///
/// If the index, golden vectors, pages or cases of the repository cannot be read.
pub fn files(root: &Path, registry: &Registry, papers: Papers) -> Result<Vec<(String, String)>, Error> {
    let book = Book::of(root, registry, papers)?;
    let mut files: Vec<(String, String)> =
        SHARED.iter().map(|(name, content)| (name.to_string(), content.to_string())).collect();
    files.push(("index.html".into(), frame::contents(&book)));
    files.push(("errata.html".into(), errata::page(&book)));
    files.push(("laws.html".into(), laws::page(&book, papers)));
    let (tables, numbers) = tables::page(root, papers)?;
    files.push(("tables.html".into(), tables));
    files.push(("entries.js".into(), frame::entries(&book, numbers)));
    for chapter in book.papers() {
        files.push((chapter.claims_page(), claims::page(&book, chapter)));
    }
    for (file, title, markdown) in &book.documents {
        files.push((file.to_string(), frame::whole(title, text::markdown(markdown, &|link| book.page_of(link)))));
    }
    files.extend(equation::pages(&book));
    files.extend(equation::sources(&book));
    Ok(files)
}

impl<'a> Book<'a> {
    fn of(root: &Path, registry: &'a Registry, papers: Papers) -> Result<Self, Error> {
        let read = |name: &str| std::fs::read_to_string(root.join(name)).at(&root.join(name));
        let (index, proofs, findings) = (Table::of(&read(INDEX)?), read(PROOFS)?, read(FINDINGS)?);
        let about_proofs = proofs.split("\n| ").next().unwrap_or_default().to_string();
        let proofs = Table::of(&proofs);
        let mut chapters: Vec<Chapter> = vec![];
        for crate::equations::Entry { equation, document } in &registry.0 {
            let name = equation.id.split('-').next().unwrap_or_default();
            let (start, origin, independent) =
                facts::start(equation, document, &root.join("golden")).map_err(Error::Verification)?;
            let row = index.row(equation.id);
            let users = index.cell(row, "used in").split(", ").filter(|user| !user.is_empty());
            let entry = Entry {
                equation,
                document,
                start,
                origin,
                independent,
                role: index.cell(row, "role").into(),
                users: users.map(String::from).collect(),
                statements: facts::statements(equation, document, &proofs),
                rounding: facts::rounding(equation, &proofs),
            };
            match chapters.last_mut().filter(|chapter| chapter.name == name) {
                Some(chapter) => chapter.entries.push(entry),
                None => chapters.push(Chapter {
                    name,
                    reference: papers.find(name).map_or("", |paper| paper.reference()),
                    entries: vec![entry],
                    claims: rows(claims_of(&findings, name)),
                    discussion: claims::discussion(&findings, name),
                }),
            }
        }
        let others = facts::others(&root.join(OTHERS))?;
        for other in &others {
            let unknown = other.equations.iter().find(|id| registry.0.iter().all(|entry| entry.equation.id != **id));
            if other.equations.is_empty() || unknown.is_some() {
                let what = unknown.map_or("no equation".into(), |id| format!("`{id}`, which is no equation"));
                return Err(Error::Verification(format!(
                    "{OTHERS}: the documentation of `{}` names {what}",
                    other.test
                )));
            }
        }
        let documents = vec![
            ("claims.html", "All claims, with command and result", read(CLAIMS)?),
            ("verification.html", "Verification", read(VERIFICATION)?),
            ("proofs.html", "Proofs", about_proofs),
        ];
        let laws = papers.0.iter().flat_map(|paper| paper.shown_laws()).map(|law| law.id).collect();
        Ok(Self { chapters, others, laws, documents })
    }

    /// The chapters that are papers.
    fn papers(&self) -> impl Iterator<Item = &Chapter<'a>> {
        self.chapters.iter().filter(|chapter| !chapter.reference.is_empty())
    }

    /// All equations with their chapters, in order.
    fn entries(&self) -> impl Iterator<Item = (&Chapter<'a>, &Entry<'a>)> {
        self.chapters.iter().flat_map(|chapter| chapter.entries.iter().map(move |entry| (chapter, entry)))
    }

    /// The page that has what a page of the repository links to.
    fn page_of(&self, link: &str) -> Option<String> {
        let path = link.split('#').next().unwrap_or_default().trim_start_matches("../");
        let of_document =
            |name: &str| self.documents.iter().find(|(file, ..)| file.strip_suffix(".html") == Some(name));
        let of_source = |file: &str| self.entries().find(|(_, entry)| entry.equation.file == file);
        match path.strip_suffix(".md") {
            Some("spec/INDEX") => Some("index.html".into()),
            Some("findings") => Some("index.html#claims".into()),
            Some(name) => of_document(name).map(|(file, ..)| file.to_string()),
            None => of_source(path.strip_prefix("spec/")?).map(|(_, entry)| entry.source_page()),
        }
    }

    /// The page of the function that the documentation of a chapter links to.
    fn target(&self, chapter: &Chapter, path: &str) -> Option<String> {
        let mut words = path.rsplit("::");
        let (function, module) = (words.next()?, words.next().unwrap_or_default());
        let is_in = |entry: &Entry| entry.equation.file.ends_with(&format!("/{module}.rs"));
        let mut found: Vec<(&Chapter, &Entry)> =
            self.entries().filter(|(_, entry)| entry.equation.function == function).collect();
        if found.iter().any(|(_, entry)| is_in(entry)) {
            found.retain(|(_, entry)| is_in(entry));
        }
        if found.iter().any(|(of, _)| of.name == chapter.name) {
            found.retain(|(of, _)| of.name == chapter.name);
        }
        match found[..] {
            [(_, entry)] => Some(entry.page()),
            _ => None,
        }
    }
}

impl Chapter<'_> {
    fn title(&self) -> &str {
        if self.reference.is_empty() { "Mechanics that the papers share" } else { self.reference }
    }

    /// The name of the page of its claims.
    fn claims_page(&self) -> String {
        format!("claims-{}.html", self.name)
    }
}

impl Entry<'_> {
    /// The name of its page.
    fn page(&self) -> String {
        format!("{}.html", self.equation.id)
    }

    /// The name of the page with its source.
    fn source_page(&self) -> String {
        format!("{}.html", self.equation.file.replace('/', "."))
    }

    /// The numbers of the equation, as a paper prints them, or its name.
    fn label(&self) -> String {
        let id = self.equation.id;
        match self.equation.covers {
            [] => id.split_once('-').map_or(id, |(_, name)| name).replace('-', " "),
            numbers => format!("Eq. {}", numbers.iter().map(|number| printed(number)).collect::<Vec<_>>().join(", ")),
        }
    }

    /// Whether a text such as `Eqs. 8, 10 and 11, Table 4` names its number.
    fn is_named_in(&self, text: &str) -> bool {
        let words: Vec<&str> = text.split([' ', ',']).filter(|word| !word.is_empty() && *word != "and").collect();
        let is_kind = |word: &&&str| !word.contains(|c: char| c.is_ascii_digit());
        let of_equations = |k: usize| words[..k].iter().rev().find(is_kind).is_some_and(|kind| kind.starts_with("Eq"));
        let named = |number: &&str| {
            (1..words.len()).any(|k| words[k].trim_end_matches('.') == printed(number) && of_equations(k))
        };
        self.equation.covers.iter().any(named)
    }
}

/// A number as the paper prints it: `A17` is A.17.
fn printed(number: &str) -> String {
    number.replace('A', "A.")
}
