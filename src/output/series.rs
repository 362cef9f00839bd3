//! Rows of the time series, and final quantities.

use super::{RunFolder, read};
use crate::case::units::decimal;
use crate::error::Error;
use serde::{Deserialize, Serialize};

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

/// A final quantity of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// Its name.
    pub name: String,
    /// Its value.
    pub value: String,
    /// Its unit; empty for words or a pure number.
    pub unit: String,
    /// The target value of the case's material, or the value stated by the paper; empty if there is none.
    pub target: String,
}

impl Finding {
    /// A number.
    pub fn number(name: &str, value: f64, unit: &str, target: Option<f64>) -> Self {
        let target = target.map(decimal).unwrap_or_default();
        Self { name: name.into(), value: decimal(value), unit: unit.into(), target }
    }
    /// A verdict in words.
    pub fn words(name: &str, value: impl Into<String>) -> Self {
        Self { name: name.into(), value: value.into(), unit: String::new(), target: String::new() }
    }

    /// The findings of a run; none before it has finished.
    ///
    /// # Errors
    ///
    /// If the results cannot be read.
    pub fn of_run(folder: &RunFolder) -> Result<Vec<Self>, Error> {
        let path = folder.results();
        if !path.exists() {
            return Ok(Vec::new());
        }
        serde_yaml::from_slice(&read(&path)?).map_err(|error| Error::input(&path, error.to_string()))
    }
}
