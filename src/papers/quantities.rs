//! The list of every quantity that a run writes.

use super::Papers;
use crate::output::Column;
use crate::output::aggregate::SHAPE;
use crate::output::columns::{EVERY, OF_SURFACES};
use crate::output::frames::{FRAME_COLUMNS, PAIR_COLUMNS};
use std::fmt::Write;

impl Papers {
    /// The page of all columns and results, as Markdown.
    pub fn quantities(&self) -> String {
        let mut page = String::from(
            "# Columns and results\n\n\
             Every quantity that a run writes: its name, its unit and its definition. `veridem schema --results` prints this page.\n\n\
             `series.csv` has the columns that all stages of a run have, `series.<stage>.csv` those that only one stage has, `windows.csv` the quantities that are measured over \
             windows, and `profiles.csv` those by height, a row for every layer; every cell of every table holds a value. `results.yaml` has the results by name: value, unit, significant digits, spread (the standard error unless the definition says \
             otherwise), target, or the reason why one was not reached. In a sequence of stages the name of the stage stands before the name of a result, as in `indentation: necks`.\n",
        );
        section(&mut page, "Columns of every run", EVERY);
        page.push_str(
            "\nBeside these, `<cause> energy [zJ]` is the energy that the pairs store and `lost to <cause> [zJ]` the energy that they have dissipated, for every cause of the contact model.\n",
        );
        section(&mut page, "Columns of runs with surfaces", OF_SURFACES);
        section(&mut page, "Shape of an aggregate", SHAPE);
        page.push_str("\n`veridem import`, and `veridem inspect` of a frame, measure the same.\n");
        section(&mut page, "Columns of spheres in frames", FRAME_COLUMNS);
        section(&mut page, "Columns of pairs in frames", PAIR_COLUMNS);
        for paper in self.0 {
            let _ = write!(page, "\n## {} ({})\n", paper.name(), paper.reference());
            for (heading, columns) in paper.quantities() {
                let _ = write!(page, "\n### {heading}\n");
                table(&mut page, columns);
            }
        }
        page
    }
}

fn section(page: &mut String, heading: &str, columns: &[Column]) {
    let _ = write!(page, "\n## {heading}\n");
    table(page, columns);
}

fn table(page: &mut String, columns: &[Column]) {
    page.push_str("\n| name | unit | definition |\n|---|---|---|\n");
    for Column { name, unit, about } in columns {
        let unit = if unit.is_empty() { "-" } else { unit };
        let _ = writeln!(page, "| {name} | {unit} | {} |", about.trim());
    }
}
