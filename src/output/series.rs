//! The tables of a run: their files, columns and rows.

use super::columns::{STAGE, STEP, TIME};
use crate::case::units::decimal;

/// A cell of a table.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A measured number, written with enough digits to be read back exactly.
    Number(f64),
    /// A count.
    Count(u64),
    /// A name.
    Name(String),
}

/// One line of a table; no cell of ours holds a comma or a quote.
pub fn row<'a>(cells: impl IntoIterator<Item = &'a Cell>) -> String {
    let text = |cell: &Cell| match cell {
        Cell::Number(x) => decimal(*x),
        Cell::Count(n) => n.to_string(),
        Cell::Name(name) => name.clone(),
    };
    cells.into_iter().map(text).collect::<Vec<_>>().join(",")
}

/// The table of all stages: the columns that every stage has.
pub(super) const SERIES: &str = "series.csv";
/// The table of windows.
pub(super) const WINDOWS: &str = "windows.csv";
/// The table of profiles.
pub(super) const PROFILES: &str = "profiles.csv";

/// The name of a stage in the name of a file.
pub(super) fn slug(stage: &str) -> String {
    stage.replace(' ', "-")
}

/// The file of the columns that only some stages have.
pub(super) fn stage_file(stage: &str) -> String {
    format!("series.{}.csv", slug(stage))
}

/// Whether a table of a run has this name.
pub(super) fn is_table(name: &str) -> bool {
    let of_stage = name.strip_prefix("series.").and_then(|rest| rest.strip_suffix(".csv"));
    [SERIES, WINDOWS, PROFILES].contains(&name)
        || of_stage.is_some_and(|stage| !stage.is_empty() && !stage.contains('.'))
}

/// A table.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Its file.
    pub file: String,
    /// Its columns.
    pub columns: Vec<String>,
}

/// The tables of a run, each without empty cells: the columns that all stages have; for each stage that has more of them, those, behind step and time; the windows; and the profiles.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// The tables, that of all stages first; those of windows and of profiles last, if there are any.
    pub tables: Vec<Table>,
    /// For every stage its table, if it has one, and where each of its cells goes: whether into that of all stages.
    stages: Vec<(Option<usize>, Vec<bool>)>,
    windows: Option<usize>,
    profiles: Option<usize>,
}

impl Layout {
    /// The tables of stages with these columns, of windows with these and of profiles with these.
    pub fn new(names: &[String], stages: Vec<Vec<String>>, windows: Vec<String>, profiles: Vec<String>) -> Self {
        let first = stages.first().cloned().unwrap_or_default();
        let common: Vec<String> =
            first.into_iter().filter(|column| stages.iter().all(|columns| columns.contains(column))).collect();
        let mut layout = Self {
            tables: vec![Table { file: SERIES.into(), columns: common.clone() }],
            stages: Vec::new(),
            windows: None,
            profiles: None,
        };
        for (name, columns) in names.iter().zip(stages) {
            // A row of any stage fills the columns of all in their order.
            assert!(columns.iter().filter(|column| common.contains(column)).eq(&common), "stages order columns alike");
            let shared: Vec<bool> = columns.iter().map(|column| common.contains(column)).collect();
            let own: Vec<String> =
                columns.into_iter().zip(&shared).filter(|(_, shared)| !**shared).map(|(column, _)| column).collect();
            let table = (!own.is_empty()).then_some(layout.tables.len());
            if !own.is_empty() {
                let columns = [STEP, TIME].iter().map(|column| column.to_string()).chain(own).collect();
                layout.tables.push(Table { file: stage_file(name), columns });
            }
            layout.stages.push((table, shared));
        }
        layout.windows = layout.add(WINDOWS, windows);
        layout.profiles = layout.add(PROFILES, profiles);
        layout
    }

    /// Adds a table of all stages with these columns, if there are any; returns its number.
    fn add(&mut self, file: &str, own: Vec<String>) -> Option<usize> {
        if own.is_empty() {
            return None;
        }
        let columns = [STAGE, STEP, TIME].iter().map(|column| column.to_string()).chain(own).collect();
        self.tables.push(Table { file: file.into(), columns });
        Some(self.tables.len() - 1)
    }

    /// The lines of a row of a stage, whose first cells are its name, the step and the time, and the numbers of their tables.
    pub fn lines(&self, stage: usize, cells: &[Cell]) -> Vec<(usize, String)> {
        let (table, shared) = &self.stages[stage];
        let those =
            |common: bool| cells.iter().zip(shared).filter(move |(_, shared)| **shared == common).map(|(cell, _)| cell);
        let own = table.map(|table| (table, row(cells[1..3].iter().chain(those(false)))));
        [(0, row(those(true)))].into_iter().chain(own).collect()
    }

    /// The number of the table of windows.
    pub fn windows(&self) -> Option<usize> {
        self.windows
    }

    /// The number of the table of profiles.
    pub fn profiles(&self) -> Option<usize> {
        self.profiles
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_is_rectangular_and_holds_a_number_once() {
        let text = |columns: &[&str]| columns.iter().map(|column| column.to_string()).collect::<Vec<_>>();
        let first = text(&["stage", "step", "time [ns]", "strain", "energy"]);
        let second = text(&["stage", "step", "time [ns]", "energy"]);
        let names = text(&["a", "b c"]);
        let layout = Layout::new(&names, vec![first, second.clone()], text(&["size"]), text(&["height"]));
        assert_eq!(
            layout.tables.iter().map(|table| &*table.file).collect::<Vec<_>>(),
            [SERIES, "series.a.csv", WINDOWS, PROFILES]
        );
        assert_eq!(layout.tables[0].columns, second);
        assert_eq!(layout.tables[1].columns, ["step", "time [ns]", "strain"]);
        assert_eq!((layout.windows(), layout.profiles()), (Some(2), Some(3)));
        assert_eq!(layout.tables[3].columns, ["stage", "step", "time [ns]", "height"]);
        let cells = [Cell::Name("a".into()), Cell::Count(3), Cell::Number(0.5), Cell::Number(0.25), Cell::Number(7.0)];
        assert_eq!(layout.lines(0, &cells), [(0, "a,3,0.5,7".into()), (1, "3,0.5,0.25".into())]);
        assert!(["series.csv", "series.b-c.csv", "windows.csv", "profiles.csv"].iter().all(|name| is_table(name)));
        assert!(!["series..csv", "series.a.b.csv", "mine.csv"].iter().any(|name| is_table(name)));
    }
}
