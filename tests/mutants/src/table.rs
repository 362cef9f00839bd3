//! The table of `docs/verification.md`: what stands behind each equation.

use crate::copy::Copy;
use crate::kept::{Notice, Outcomes, explained};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The page, and the line from which on it is generated.
const PAGE: &str = "docs/verification.md";
const BELOW: &str = "<!-- below: cargo run -p veridem-mutants -- table -->\n";

/// Mutants: noticed, and all that can be.
#[derive(Clone, Copy, Default)]
struct Count {
    noticed: usize,
    all: usize,
}

impl Count {
    fn cell(self) -> String {
        if self.all == 0 { String::new() } else { format!("{}/{}", self.noticed, self.all) }
    }
}

/// Writes the tables of equations and files; whether something is missing.
pub(crate) fn write(copy: &Copy, root: &Path) -> bool {
    let (outcomes, explained) = (Outcomes::of(copy), explained(root));
    let (mut functions, mut files) = (BTreeMap::<_, Count>::new(), BTreeMap::<_, Count>::new());
    let (mut all, mut equivalent, mut unknown) = (Count::default(), 0, 0);
    for mutant in &copy.mutants {
        let Some(notice) = outcomes.get(mutant) else {
            unknown += 1;
            continue;
        };
        if notice == Notice::Nobody && explained.contains(&mutant.sentence()) {
            equivalent += 1;
            continue;
        }
        let function = functions.entry((mutant.file.as_str(), mutant.function.as_str())).or_default();
        for count in [function, files.entry(mutant.file.as_str()).or_default(), &mut all] {
            count.all += 1;
            count.noticed += usize::from(notice != Notice::Nobody);
        }
    }
    let independent: BTreeMap<String, usize> =
        serde_json::from_str(&read(root, "golden/independent.json")).expect("counts");
    let proofs = read(root, "docs/proofs.md");
    let rows = proofs.lines().filter_map(|line| line.strip_prefix("| ")?.split_once(" | "));
    let rows = rows.filter(|(id, _)| independent.contains_key(*id)).map(|(id, cells)| {
        let entry = copy.entries.iter().find(|entry| entry[1] == id).expect("an equation of the list");
        let mutants = functions.get(&(entry[0].as_str(), entry[2].as_str())).copied().unwrap_or_default();
        format!("| {id} | {} | {} | {} |\n", independent[id], proved(cells), mutants.cell())
    });
    let equations = format!(
        "| equation | independent vectors | claims proved | mutants noticed |\n|---|---|---|---|\n{}",
        rows.collect::<String>()
    );
    let rows = files.iter().map(|(file, count)| format!("| [{file}](../spec/{file}) | {} |\n", count.cell()));
    let files = format!("| file | mutants noticed |\n|---|---|\n{}", rows.collect::<String>());
    let totals = format!(
        "**Mutants**: {} of {} are noticed, {:.1} %; besides, {equivalent} that change nothing that can be noticed.{}",
        all.noticed,
        all.all,
        100.0 * all.noticed as f64 / all.all as f64,
        if unknown > 0 { format!(" Not tried: {unknown}.") } else { String::new() }
    );
    let page = read(root, PAGE);
    let (above, _) = page.split_once(BELOW).expect("a page with the line from which on it is generated");
    fs::write(root.join(PAGE), format!("{above}{BELOW}\n{totals}\n\n{equations}\n{files}")).expect("a page");
    println!("{totals}");
    unknown > 0
}

fn read(root: &Path, path: &str) -> String {
    fs::read_to_string(root.join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// How many of the claims of a row of `docs/proofs.md` are proved over the box of order one: finite, signs, monotonicity, the stated rounding.
fn proved(cells: &str) -> String {
    let cells = cells.trim_end_matches(" |").split(" | ");
    let of_order_one = cells.map(|cell| cell.split("; SI: ").next().unwrap_or_default().trim());
    let claims: Vec<bool> = of_order_one
        .enumerate()
        .flat_map(|(k, cell)| match k {
            0 => vec![cell == "proved"],
            3 => vec![!cell.contains("measured")],
            _ => cell.split(", ").filter(|claim| !claim.is_empty()).map(|claim| !claim.contains("(sampled)")).collect(),
        })
        .collect();
    format!("{} of {}", claims.iter().filter(|proved| **proved).count(), claims.len())
}
