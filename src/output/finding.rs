//! Final quantities of a run: numbers with their significant digits, verdicts, and what was not reached.

use super::{Column, RunFolder, read};
use crate::case::units::{from_engine, significant};
use crate::error::Error;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

/// A final quantity of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// Its name, the same for every run of its kind.
    pub name: String,
    /// Its unit, the same for every run of its kind; empty for words or a pure number.
    pub unit: String,
    /// What was found.
    pub found: Found,
    /// The target value of the case's material, or the value stated by the paper, in its unit.
    pub target: Option<f64>,
}

/// What was found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Found {
    /// A number in the unit of the finding, and its standard error if known.
    Number(f64, Option<f64>),
    /// Numbers in the unit of the finding.
    Numbers(Vec<f64>),
    /// A count.
    Count(u64),
    /// A verdict.
    Words(String),
    /// The event that defines the quantity did not happen, for this reason.
    NotReached(String),
}

/// Significant digits of a number of unknown error.
const DIGITS: usize = 4;

impl Finding {
    fn new(result: Column, found: Found) -> Self {
        Self { name: result.name.into(), unit: result.unit.into(), found, target: None }
    }
    /// A number, given in engine units.
    pub fn number(result: Column, value: f64) -> Self {
        Self::new(result, Found::Number(from_engine(value, result.unit), None))
    }
    /// Numbers, given in engine units.
    pub fn numbers(result: Column, values: impl IntoIterator<Item = f64>) -> Self {
        Self::new(result, Found::Numbers(values.into_iter().map(|value| from_engine(value, result.unit)).collect()))
    }
    /// A count.
    pub fn count(result: Column, count: u64) -> Self {
        Self::new(result, Found::Count(count))
    }
    /// A verdict in words.
    pub fn words(result: Column, verdict: impl Into<String>) -> Self {
        Self::new(result, Found::Words(verdict.into()))
    }
    /// A number, given in engine units, that an event defines; `otherwise` says why there was none.
    pub fn reached(result: Column, value: Option<f64>, otherwise: impl Into<String>) -> Self {
        match value {
            Some(value) => Self::number(result, value),
            None => Self::new(result, Found::NotReached(otherwise.into())),
        }
    }
    /// The same at one of several moments.
    pub fn at(self, moment: &str) -> Self {
        Self { name: format!("{moment} {}", self.name), ..self }
    }
    /// The same, found in one of several stages that have such a result.
    pub fn during(self, stage: &str) -> Self {
        Self { name: format!("{stage}: {}", self.name), ..self }
    }
    /// The same with a target in engine units.
    pub fn target(self, target: f64) -> Self {
        Self { target: Some(from_engine(target, &self.unit)), ..self }
    }
    /// The same with a standard error in engine units.
    pub fn spread(self, spread: f64) -> Self {
        let spread = Some(from_engine(spread, &self.unit));
        let found = if let Found::Number(value, _) = self.found { Found::Number(value, spread) } else { self.found };
        Self { found, ..self }
    }

    /// The number, in its unit.
    pub fn value(&self) -> Option<f64> {
        match self.found {
            Found::Number(value, _) => Some(value),
            Found::Count(count) => Some(count as f64),
            Found::Numbers(_) | Found::Words(_) | Found::NotReached(_) => None,
        }
    }

    /// Its name with its unit, as the header of a column.
    pub fn header(&self) -> String {
        if self.unit.is_empty() { self.name.clone() } else { format!("{} [{}]", self.name, self.unit) }
    }

    /// Whether all its numbers are finite.
    pub fn is_finite(&self) -> bool {
        let spread = if let Found::Number(_, spread) = self.found { spread } else { None };
        let several = if let Found::Numbers(values) = &self.found { &values[..] } else { &[] };
        [self.value(), spread, self.target].iter().flatten().chain(several).all(|number| number.is_finite())
    }

    /// Number of significant digits: two of the error if it is known.
    fn digits(&self) -> usize {
        let place = |x: f64| x.abs().log10().floor() as i32;
        match self.found {
            Found::Number(value, Some(spread)) if value != 0.0 && spread > 0.0 => {
                (place(value) - place(spread) + 2).clamp(1, 15) as usize
            }
            Found::Count(count) => count.to_string().len(),
            _ => DIGITS,
        }
    }

    /// The number with its significant digits, the verdict, or why there is none; without the unit.
    pub fn text(&self) -> String {
        match &self.found {
            Found::Number(value, _) => significant(*value, self.digits()),
            Found::Numbers(values) if values.is_empty() => "none".into(),
            Found::Numbers(values) => {
                values.iter().map(|value| significant(*value, DIGITS)).collect::<Vec<_>>().join(", ")
            }
            Found::Count(count) => count.to_string(),
            Found::Words(words) | Found::NotReached(words) => words.clone(),
        }
    }

    /// The target with the digits of a number.
    pub fn target_text(&self) -> String {
        self.target.map_or(String::new(), |target| significant(target, DIGITS))
    }

    /// The number or verdict, with its error and unit.
    pub fn sentence(&self) -> String {
        let mut text = self.text();
        if let Found::Number(_, Some(spread)) = self.found {
            text.push_str(&format!(" ± {}", significant(spread, 2)));
        }
        let several = matches!(&self.found, Found::Numbers(values) if !values.is_empty());
        if (several || self.value().is_some()) && !self.unit.is_empty() {
            text.push_str(&format!(" {}", self.unit));
        }
        text
    }

    /// The results of a run, by name.
    pub fn results(findings: &[Self]) -> Value {
        Value::Object(findings.iter().map(|finding| (finding.name.clone(), finding.plain())).collect())
    }

    fn plain(&self) -> Value {
        let rounded = |text: String| text.parse::<f64>().expect("a formatted number is a number");
        let mut fields = Map::new();
        match &self.found {
            Found::Number(_, spread) => {
                fields.insert("value".into(), json!(rounded(self.text())));
                fields.insert("digits".into(), json!(self.digits()));
                spread.map(|spread| fields.insert("spread".into(), json!(rounded(significant(spread, 2)))));
            }
            Found::Numbers(values) => {
                let values: Vec<f64> = values.iter().map(|value| rounded(significant(*value, DIGITS))).collect();
                fields.insert("values".into(), json!(values));
                fields.insert("digits".into(), json!(DIGITS));
            }
            Found::Count(count) => {
                fields.insert("value".into(), json!(count));
            }
            Found::Words(verdict) => {
                fields.insert("verdict".into(), json!(verdict));
            }
            Found::NotReached(reason) => {
                fields.insert("value".into(), Value::Null);
                fields.insert("verdict".into(), json!(reason));
            }
        }
        if !self.unit.is_empty() {
            fields.insert("unit".into(), json!(self.unit));
        }
        self.target.map(|_| fields.insert("target".into(), json!(rounded(self.target_text()))));
        Value::Object(fields)
    }

    fn of(name: &str, fields: &Value) -> Option<Self> {
        let number = |key: &str| fields.get(key).and_then(Value::as_f64);
        let text = |key: &str| fields.get(key).and_then(Value::as_str).map(String::from);
        let found = match (fields.get("value"), text("verdict")) {
            (None, Some(verdict)) => Found::Words(verdict),
            (Some(Value::Null), Some(reason)) => Found::NotReached(reason),
            (Some(value), _) if fields.get("digits").is_none() => Found::Count(value.as_u64()?),
            (Some(value), _) => Found::Number(value.as_f64()?, number("spread")),
            (None, None) => {
                let values = fields.get("values").and_then(Value::as_array)?;
                Found::Numbers(values.iter().map(Value::as_f64).collect::<Option<_>>()?)
            }
        };
        Some(Self { name: name.into(), unit: text("unit").unwrap_or_default(), found, target: number("target") })
    }

    /// The findings of a run, with the digits that were written; none before it has finished.
    ///
    /// # Errors
    ///
    /// If the results cannot be read.
    pub fn of_run(folder: &RunFolder) -> Result<Vec<Self>, Error> {
        let path = folder.results();
        if !path.exists() {
            return Ok(Vec::new());
        }
        let results: Map<String, Value> =
            serde_yaml::from_slice(&read(&path)?).map_err(|error| Error::input(&path, error.to_string()))?;
        let one = |(name, fields): (&String, &Value)| {
            Self::of(name, fields).ok_or_else(|| Error::input(&path, format!("`{name}` is no result")))
        };
        results.iter().map(one).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FORCE: Column = Column { name: "force", unit: "nN", about: "A force." };
    const PURE: Column = Column { name: "ratio", unit: "", about: "A ratio." };

    #[test]
    fn a_number_has_the_digits_of_its_error_or_four() {
        assert_eq!(Finding::number(FORCE, 269_440.656).sentence(), "269.4 nN");
        assert_eq!(Finding::number(FORCE, 269_440.656).spread(1230.0).sentence(), "269.4 ± 1.2 nN");
        assert_eq!(Finding::number(FORCE, 4000.0).sentence(), "4.000 nN");
        assert_eq!(Finding::number(PURE, 0.0).sentence(), "0");
        assert_eq!(Finding::count(PURE, 123_456).sentence(), "123456");
        assert_eq!(Finding::numbers(FORCE, [4000.0, 250.0]).sentence(), "4.000, 0.2500 nN");
        assert_eq!(Finding::numbers(FORCE, []).sentence(), "none");
    }

    #[test]
    fn what_an_event_defines_has_no_value_without_it() {
        let time = Column { name: "time to settle", unit: "ns", about: "A time." };
        let settled = |value| Finding::reached(time, value, "not within 1 ns");
        assert_eq!((settled(None).sentence().as_str(), settled(None).value()), ("not within 1 ns", None));
        assert_eq!((settled(Some(0.5)).sentence().as_str(), settled(Some(0.5)).value()), ("0.5000 ns", Some(0.5)));
    }

    #[test]
    fn results_are_a_map_by_name_that_is_read_back() {
        let named = |name, unit| Column { name, unit, about: "" };
        let findings = [
            Finding::number(named("strength", "GPa"), 3980.0).target(4000.0).spread(20.0),
            Finding::count(named("necks", ""), 3).during("pulling"),
            Finding::words(named("fate", ""), "cut"),
            Finding::numbers(FORCE, [1000.0, 2000.0]),
            Finding::reached(named("rupture height", "nm"), None, "the tip is attached"),
        ];
        let results = Finding::results(&findings);
        assert_eq!(
            results["strength"],
            json!({"value": 3.98, "digits": 4, "spread": 0.02, "unit": "GPa", "target": 4.0})
        );
        assert_eq!(results["force"], json!({"values": [1.0, 2.0], "digits": 4, "unit": "nN"}));
        assert_eq!(results["rupture height"], json!({"value": null, "verdict": "the tip is attached", "unit": "nm"}));
        let again = results.as_object().unwrap().iter().map(|(name, fields)| Finding::of(name, fields).unwrap());
        assert_eq!(again.collect::<Vec<_>>(), findings);
    }
}
