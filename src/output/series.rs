//! Rows of the time series.

use crate::case::units::decimal;

/// A cell of the time series.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A measured number, written with enough digits to be read back exactly.
    Number(f64),
    /// A count.
    Count(u64),
    /// A name.
    Name(String),
    /// Not measured in this stage.
    Nothing,
}

/// One line of a table; no cell of ours holds a comma or a quote.
pub fn row(cells: &[Cell]) -> String {
    let text = |cell: &Cell| match cell {
        Cell::Number(x) => decimal(*x),
        Cell::Count(n) => n.to_string(),
        Cell::Name(name) => name.clone(),
        Cell::Nothing => String::new(),
    };
    cells.iter().map(text).collect::<Vec<_>>().join(",")
}
