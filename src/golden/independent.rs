//! How many vectors of every equation were computed independently: the list that keeps them from being lost.

use super::read;
use std::collections::BTreeMap;
use std::path::Path;
use veridem_spec::document::Document;
use veridem_spec::equation::Equation;

/// The list in the folder `golden`, written by the script that computes the vectors.
const COUNTS: &str = "independent.json";

/// Compares the number of independent vectors of every equation, at least one, with the list: generating a missing file anew brings back all vectors but
/// these.
pub fn check_independent(golden: &Path, equations: &[(Equation, Document)]) -> Vec<String> {
    let path = golden.join(COUNTS);
    let listed = std::fs::read_to_string(&path).map_err(|error| error.to_string());
    let listed = listed.and_then(|text| serde_json::from_str(&text).map_err(|error| error.to_string()));
    let mut listed: BTreeMap<String, usize> = match listed {
        Ok(listed) => listed,
        Err(error) => return vec![format!("{}: {error}", path.display())],
    };
    let mut wrong = vec![];
    for (equation, _) in equations {
        let vectors = read(golden, equation).map(|file| file.vectors).unwrap_or_default();
        let found = vectors.iter().filter(|vector| vector.source.is_some()).count();
        let expected = listed.remove(equation.id).unwrap_or_default();
        let id = equation.id;
        if found != expected {
            wrong.push(format!(
                "{id}: found {found} independent vectors, expected {expected}: restore the file or run `python3 golden/oracle {id}`"
            ));
        } else if found == 0 {
            wrong.push(format!("{id}: no independent vector: write a function for it in golden/oracle"));
        }
    }
    wrong.extend(listed.keys().map(|id| format!("{}: there is no equation `{id}`", path.display())));
    wrong
}
