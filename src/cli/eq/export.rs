//! Equations in other programming languages.

use crate::equations::{Entry, Registry};
use crate::papers::Papers;
use crate::spec::languages::{Exported, Language};

/// The name of a language.
#[derive(Clone, Copy, clap::ValueEnum)]
pub(super) enum Name {
    C,
    Python,
    Javascript,
    Fortran,
}

/// A header or module with the equations of these ids, with all of them if there are none.
///
/// # Errors
///
/// An id that does not exist, or an equation that was asked for and cannot be exported, with the reason.
pub(super) fn module(registry: &Registry, papers: Papers, name: Name, ids: &[String]) -> Result<String, String> {
    let language = match name {
        Name::C => Language::C,
        Name::Python => Language::Python,
        Name::Javascript => Language::Javascript,
        Name::Fortran => Language::Fortran,
    };
    let equation = |entry: &Entry| {
        let paper = entry.equation.id.split('-').next().and_then(|name| papers.find(name));
        Exported::equation(&entry.equation, &entry.document, paper.map_or("", |paper| paper.reference()))
    };
    let mut laws: Vec<Exported> = papers.0.iter().flat_map(|paper| paper.exported_laws()).collect();
    if ids.is_empty() {
        let equations = registry.0.iter().map(equation);
        return Ok(language.module(&equations.chain(laws).collect::<Vec<_>>()));
    }
    let mut chosen: Vec<Exported> = vec![];
    for id in ids {
        // An id that is given twice is exported once.
        if chosen.iter().any(|other| other.id == *id) {
            continue;
        }
        if laws.iter().any(|law| law.id == *id) {
            chosen.extend(laws.extract_if(.., |law| law.id == *id));
            continue;
        }
        let found = equation(registry.find(id)?);
        if let Some(reason) = found.refusal() {
            return Err(format!("{id} cannot be exported: {reason}"));
        }
        if chosen.iter().all(|other| other.id != found.id) {
            chosen.push(found);
        }
    }
    Ok(language.module(&chosen))
}
