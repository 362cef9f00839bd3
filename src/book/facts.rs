//! What the files of the repository know of an equation.

use crate::error::{AtPath, Error};
use crate::golden::{File, Vector, read};
use crate::spec::document::Document;
use crate::spec::equation::Equation;
use std::path::Path;

/// A table of a page of the repository.
pub(super) struct Table {
    names: Vec<String>,
    pub(super) rows: Vec<Vec<String>>,
}

impl Table {
    /// The first table in some Markdown.
    pub(super) fn of(text: &str) -> Self {
        let lines = text.lines().skip_while(|line| !line.starts_with('|')).take_while(|line| line.starts_with('|'));
        let cells = |line: &str| -> Vec<String> {
            let inner = line.trim_start_matches("| ").trim_end();
            inner.strip_suffix(" |").unwrap_or(inner).split(" | ").map(|cell| cell.trim().to_string()).collect()
        };
        let mut rows = lines.map(cells);
        let names = rows.next().unwrap_or_default();
        Self { names, rows: rows.skip(1).collect() }
    }

    /// The cell of a row in the column with a name.
    pub(super) fn cell<'a>(&self, row: &'a [String], name: &str) -> &'a str {
        let place = self.names.iter().position(|other| other == name);
        place.and_then(|place| row.get(place)).map_or("", String::as_str)
    }

    /// The row that begins with a name.
    pub(super) fn row(&self, name: &str) -> &[String] {
        self.rows.iter().find(|row| row[0] == name).map_or(&[], Vec::as_slice)
    }
}

/// A statement about an equation, and how far it is established.
pub(super) struct Statement {
    pub(super) text: String,
    pub(super) status: String,
}

/// The laws of an equation: those that its tests check, then what is proved or sampled over boxes of arguments, then what holds by construction.
pub(super) fn statements(equation: &Equation, document: &Document, proofs: &Table) -> Vec<Statement> {
    let law = |name: &String| Statement {
        text: super::text::sentence(name),
        status: status_of_law(equation.source, name).into(),
    };
    let mut all: Vec<Statement> = document.laws.iter().map(law).collect();
    let row = proofs.row(equation.id);
    for column in ["finite", "signs", "monotonicity"] {
        let cell = proofs.cell(row, column);
        let (one, si) = cell.split_once("; SI: ").unwrap_or((cell, cell));
        let status = |claim: &str| if claim.contains("sampled") { "sampled" } else { "proved" };
        for claim in one.split(", ").filter(|claim| !claim.is_empty()) {
            let text = if column == "finite" { "finite" } else { claim.trim_end_matches(" (sampled)") };
            let same = |other: &&str| column == "finite" || other.trim_end_matches(" (sampled)") == text;
            let in_si = si.split(", ").find(same).map_or("sampled", status);
            let status = match (status(claim), in_si) {
                (one, si) if one == si => one.to_string(),
                (one, si) => format!("{one}; in SI magnitudes {si}"),
            };
            all.push(Statement { text: text.into(), status });
        }
    }
    all
}

/// A test with arguments is sampled.
pub(super) fn status_of_law(source: &str, law: &str) -> &'static str {
    let arguments = source.split_once(&format!("fn {law}(")).map_or("", |(_, rest)| rest);
    if arguments.starts_with(')') { "checked at chosen values" } else { "sampled" }
}

/// The bound of the rounding error in words.
pub(super) fn rounding(equation: &Equation, proofs: &Table) -> String {
    let of_scale = |text: &str| {
        let parts: Vec<&str> = text.split(", ").collect();
        let first = parts[0].replacen(' ', " ULP: ", 1);
        let looser = parts.get(1).map(|more| format!("; {}", more.replacen(' ', " ULP are ", 1)));
        format!("at most {first}{}", looser.unwrap_or_default())
    };
    let cell = proofs.cell(proofs.row(equation.id), "rounding in ULP");
    let (one, si) = cell.split_once("; SI: ").unwrap_or((cell, ""));
    match (one, si) {
        ("", _) => "No bound is stated.".into(),
        (one, "") => format!("{}.", super::text::capitalised(&of_scale(one))),
        (one, si) => format!("{}. In SI magnitudes {}.", super::text::capitalised(&of_scale(one)), of_scale(si)),
    }
}

/// A value that another project publishes, and the test that compares it.
pub(super) struct Other {
    pub(super) test: String,
    pub(super) source: String,
    pub(super) equations: Vec<String>,
}

/// The tests of values of others in the files of a folder: each names its source, and in the paragraph `Equations:` what it compares.
///
/// # Errors
///
/// If a file cannot be read or is no Rust.
pub(super) fn others(folder: &Path) -> Result<Vec<Other>, Error> {
    let listed: Result<Vec<_>, _> = std::fs::read_dir(folder).at(folder)?.collect();
    let mut files: Vec<_> = listed.at(folder)?.iter().map(std::fs::DirEntry::path).collect();
    files.sort();
    let mut all = vec![];
    for file in files {
        let tests = others_in(&std::fs::read_to_string(&file).at(&file)?);
        all.extend(tests.map_err(|error| Error::Verification(format!("{}: {error}", file.display())))?);
    }
    Ok(all)
}

fn others_in(text: &str) -> Result<Vec<Other>, String> {
    let file = syn::parse_file(text).map_err(|error| error.to_string())?;
    let functions = file.items.into_iter().filter_map(|item| match item {
        syn::Item::Fn(function) if function.attrs.iter().any(|a| a.path().is_ident("test")) => Some(function),
        _ => None,
    });
    let other = |function: syn::ItemFn| {
        let lines = function.attrs.iter().filter_map(|attribute| match &attribute.meta {
            syn::Meta::NameValue(syn::MetaNameValue { value: syn::Expr::Lit(literal), .. }) => match &literal.lit {
                syn::Lit::Str(text) => Some(text.value().trim().to_string()),
                _ => None,
            },
            _ => None,
        });
        let text = lines.collect::<Vec<_>>().join(" ");
        let (source, equations) = text.split_once("Equations: ").unwrap_or((&text, ""));
        Other {
            test: function.sig.ident.to_string(),
            source: source.trim().into(),
            equations: equations.split('`').skip(1).step_by(2).map(String::from).collect(),
        }
    };
    Ok(functions.map(other).collect())
}

/// Arguments at which the curve of an equation begins, and where they come from: those of the independent vector with most values in SI, which is of the
/// paper or near it; and the number of independent vectors.
///
/// # Errors
///
/// If its golden vectors cannot be read.
pub(super) fn start(
    equation: &Equation,
    document: &Document,
    golden: &Path,
) -> Result<(Vec<f64>, String, usize), String> {
    let File { vectors, .. } = read(golden, equation)?;
    let is_independent = |vector: &&Vector| vector.source.is_some();
    let in_si = |vector: &&Vector| {
        let far = |x: &&f64| **x != 0.0 && !(1e-3..1e3).contains(&x.abs());
        vector.numbers(document).map_or(0, |numbers| numbers.iter().filter(far).count())
    };
    let begins = vectors.iter().filter(is_independent).max_by_key(in_si).or(vectors.first());
    let begins = begins.ok_or_else(|| format!("{} has no golden vectors", equation.id))?;
    let origin = begins.source.clone().unwrap_or_else(|| "a sampled vector".into());
    Ok((begins.numbers(document)?, origin, vectors.iter().filter(is_independent).count()))
}
