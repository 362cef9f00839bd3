//! The equations by name, evaluated with the user's arguments: names are matched leniently, values are parsed strictly.

use crate::case::units;
use crate::spec::document::{Document, Quantity};
use crate::spec::equation::Equation;
use crate::spec::unit::WHOLE;

/// An equation and its documentation.
pub struct Entry {
    /// The equation.
    pub equation: Equation,
    /// Its documentation.
    pub document: Document,
}

/// Every equation.
pub struct Registry(pub Vec<Entry>);

/// A result: the row of the table, and its numbers.
pub type Results<'a> = Vec<(&'a Quantity, Vec<f64>)>;

impl Registry {
    /// All equations with their documentation.
    #[expect(clippy::new_without_default, reason = "it reads the documentation of all equations")]
    pub fn new() -> Self {
        let document = |equation: Equation| {
            let document = Document::of(&equation).expect("every equation is documented");
            Entry { equation, document }
        };
        Self(crate::spec::equations().into_iter().map(document).collect())
    }

    /// The equation with an id; case, leading zeros and separators do not matter.
    ///
    /// # Errors
    ///
    /// If there is none, with the nearest id.
    pub fn find(&self, id: &str) -> Result<&Entry, String> {
        let exact = self.0.iter().find(|entry| entry.equation.id == id);
        // Programs ask thousands of times, and by the exact id.
        let alike = || {
            let asked = plain_id(id);
            self.0.iter().find(|entry| plain_id(entry.equation.id) == asked)
        };
        exact.or_else(alike).ok_or_else(|| {
            let ids = self.0.iter().map(|entry| entry.equation.id);
            format!("there is no equation `{id}`, {}", nearest(id, ids))
        })
    }

    /// Evaluates an equation with arguments such as `k_n=1 N/m`.
    ///
    /// # Errors
    ///
    /// If there is no such equation, or an argument is wrong.
    pub fn eval(&self, id: &str, arguments: &[String]) -> Result<Results<'_>, String> {
        let entry = self.find(id)?;
        let mut given = vec![];
        for argument in arguments {
            let (name, text) =
                argument.split_once('=').ok_or_else(|| format!("`{argument}`: expected name=\"value unit\""))?;
            let quantity = entry.argument(name.trim())?;
            given.push((name.trim().to_string(), with_unit(quantity, text)?));
        }
        entry.evaluate(given)
    }
}

impl Entry {
    /// The argument with a name: by its name in the table, or the only one with that name or symbol regardless of case and underscores.
    ///
    /// # Errors
    ///
    /// If there is none, with the nearest name.
    pub fn argument(&self, name: &str) -> Result<&Quantity, String> {
        let quantities = &self.document.arguments;
        let only = |alike: &dyn Fn(&Quantity) -> bool| {
            let mut all = quantities.iter().filter(|q| alike(q));
            all.next().filter(|_| all.next().is_none())
        };
        only(&|q| q.name == name)
            .or_else(|| only(&|q| plain(&q.name) == plain(name)))
            .or_else(|| only(&|q| plain_symbol(&q.symbol) == plain(name)))
            .ok_or_else(|| {
                let names = quantities.iter().map(|q| q.name.as_str());
                format!("{} has no argument `{name}`, {}", self.equation.id, nearest(name, names))
            })
    }

    /// Arguments given by name, in the order of the table.
    ///
    /// # Errors
    ///
    /// An unknown name, with the nearest one; an argument that is given twice or missing.
    pub fn in_order<T>(&self, given: impl IntoIterator<Item = (impl AsRef<str>, T)>) -> Result<Vec<T>, String> {
        let mut values: Vec<Option<T>> = self.document.arguments.iter().map(|_| None).collect();
        for (name, value) in given {
            let quantity = self.argument(name.as_ref())?;
            let place = self.document.arguments.iter().position(|q| q.name == quantity.name).expect("one of them");
            if values[place].replace(value).is_some() {
                return Err(format!("`{}` is given twice", quantity.name));
            }
        }
        let missing = |q: &Quantity| format!("`{}` is missing ({} in {})", q.name, q.meaning, q.unit);
        let all = self.document.arguments.iter().zip(values);
        all.map(|(quantity, value)| value.ok_or_else(|| missing(quantity))).collect()
    }

    /// Evaluates the equation with arguments in SI, in any order.
    ///
    /// # Errors
    ///
    /// As [`in_order`](Self::in_order), and for a value of another size or outside its domain, or if a result is not finite.
    pub fn evaluate(&self, given: Vec<(String, Vec<f64>)>) -> Result<Results<'_>, String> {
        let mut numbers = vec![];
        for (quantity, value) in self.document.arguments.iter().zip(self.in_order(given)?) {
            if value.len() != quantity.size {
                return Err(format!("`{}` is {} numbers, expected {}", quantity.name, value.len(), shape(quantity)));
            }
            if !quantity.domain.contains(&value) {
                return Err(outside(quantity, &quantity.name, &value));
            }
            numbers.extend(value);
        }
        let out = (self.equation.eval.f64)(&numbers);
        if out.iter().any(|y| !y.is_finite()) {
            return Err(self.not_finite("these arguments", &out));
        }
        let mut rest = out.as_slice();
        let mut take = |size| {
            let (parts, after) = rest.split_at(size);
            rest = after;
            parts.to_vec()
        };
        Ok(self.document.results.iter().map(|quantity| (quantity, take(quantity.size))).collect())
    }

    /// Says that the results for some arguments are not finite.
    pub fn not_finite(&self, arguments: &str, results: &[f64]) -> String {
        format!("{} has no finite value for {arguments}: {}", self.equation.id, plainly(results))
    }
}

/// Says that a value, which has this name, is outside the domain of a quantity.
pub fn outside(quantity: &Quantity, name: &str, value: &[f64]) -> String {
    format!("`{name}` = {} is outside its domain: {}", plainly(value), quantity.domain)
}

/// One number, or several as a list.
fn plainly(values: &[f64]) -> String {
    match values {
        [value] => units::decimal(*value),
        _ => format!("[{}]", values.iter().map(|value| units::decimal(*value)).collect::<Vec<_>>().join(", ")),
    }
}

fn shape(quantity: &Quantity) -> String {
    if quantity.size == 1 { "one number".into() } else { format!("{} numbers", quantity.size) }
}

/// Reads numbers and a unit of the right dimension; without a unit the numbers are in SI.
///
/// # Errors
///
/// What is wrong with the text.
pub fn with_unit(quantity: &Quantity, text: &str) -> Result<Vec<f64>, String> {
    let wrong = |what: &str| {
        format!("`{}` = `{text}`: {what}, expected {} in {}", quantity.name, shape(quantity), quantity.unit)
    };
    let cleared = text.replace(['[', ']', ','], " ");
    let (mut rest, mut decimals) = (cleared.trim(), vec![]);
    while decimals.len() < quantity.size {
        let word = rest.split_whitespace().next().unwrap_or_default();
        if word.parse::<f64>().is_ok_and(|number| !number.is_finite()) {
            return Err(wrong(&format!("`{word}` is not a finite number")));
        }
        let (decimal, after) = units::number_and_unit(rest).ok_or_else(|| wrong("too few numbers"))?;
        decimals.push(decimal.to_string());
        rest = after;
    }
    let unit = rest.replace("rad", "1");
    let [kg, m, s] = quantity.exponents.map(i32::from);
    let power = match units::unit(if unit.is_empty() { "1" } else { &unit }) {
        None => return Err(wrong(&format!("`{rest}` is not a unit"))),
        Some(_) if unit.is_empty() => 0,
        // No equation has a temperature as an argument.
        Some((dimension, _)) if dimension.0.map(|e| e * i32::from(WHOLE)) != [kg, m, s, 0] => {
            return Err(wrong(&format!("`{rest}` has the wrong dimension")));
        }
        Some((dimension, power)) => power - dimension.engine_power(),
    };
    let number = |decimal: &String| {
        let number = units::shifted(decimal, power);
        if number.is_finite() { Ok(number) } else { Err(wrong(&format!("`{decimal}` is beyond the largest number"))) }
    };
    decimals.iter().map(number).collect()
}

/// Letters and digits only, in lower case.
fn plain(name: &str) -> String {
    name.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

/// The letters of a symbol, without what only changes how it looks.
fn plain_symbol(symbol: &str) -> String {
    let looks = ["\\mathbf", "\\boldsymbol", "\\mathrm", "\\text", "\\hat"];
    plain(&looks.iter().fold(symbol.to_string(), |text, look| text.replace(look, "")))
}

/// Like [`plain`], without the leading zeros of its numbers.
fn plain_id(id: &str) -> String {
    let mut out = String::new();
    for c in plain(id).chars() {
        let digits = out.len() - out.trim_end_matches(|last: char| last.is_ascii_digit()).len();
        if c.is_ascii_digit() && digits == 1 && out.ends_with('0') {
            out.pop();
        }
        out.push(c);
    }
    out
}

fn nearest<'a>(wrong: &str, known: impl Iterator<Item = &'a str>) -> String {
    let alike = |name: &&str| (strsim::jaro_winkler(&plain(wrong), &plain(name)) * 1e9) as u64;
    known.max_by_key(alike).map_or("no name is similar".into(), |name| format!("the nearest is `{name}`"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn ids_are_unambiguous_and_names_in_a_table_mean_their_row() {
        let registry = Registry::new();
        let ids: BTreeSet<String> = registry.0.iter().map(|entry| plain_id(entry.equation.id)).collect();
        assert_eq!(ids.len(), registry.0.len());
        for entry in &registry.0 {
            for quantity in &entry.document.arguments {
                assert_eq!(entry.argument(&quantity.name).map(|q| &q.name), Ok(&quantity.name));
            }
        }
        // `xi` is the spring, `X_I` could be the position of i, too
        let contact = registry.find("wear-contact").unwrap();
        assert_eq!(contact.argument("xi").map(|q| q.meaning.as_str()), Ok("tangential spring before"));
        assert!(contact.argument("X_I").is_err());
    }

    #[test]
    fn ids_may_be_padded_and_in_any_case() {
        let registry = Registry::new();
        for id in ["wear-3", "wear-03", "WEAR-003", "wear 3"] {
            assert_eq!(registry.find(id).map(|entry| entry.equation.id), Ok("wear-3"), "{id}");
        }
        assert_eq!(plain_id("wear-A07"), plain_id("wear-a7"));
        assert_ne!(plain_id("wear-A10"), plain_id("wear-A1"));
        assert_eq!(plain_id("wear-100"), "wear100");
        let error = registry.find("wear-normal").map(|_| ()).unwrap_err();
        assert!(error.starts_with("there is no equation `wear-normal`, the nearest is `wear-"), "{error}");
    }

    fn eval(arguments: [&str; 4]) -> Result<f64, String> {
        let registry = Registry::new();
        registry.eval("wear-3", &arguments.map(String::from)).map(|results| results[0].1[0])
    }

    #[test]
    fn units_are_converted_and_checked() {
        let value = eval(["k_n=58.6 N/m", "delta_e=0.33 nm", "deltaF=375 pm", "delta_N=-0.1 nm"]);
        assert_eq!(value, Ok(58.6 * -0.1e-9));
        assert_eq!(eval(["k_N=2", "delta_e=1", "delta_f=2", "delta_n=0.5"]), Ok(1.0));
        let error = eval(["k_n=58.6 N", "delta_e=1", "delta_f=2", "delta_n=0"]).unwrap_err();
        assert_eq!(error, "`k_n` = `58.6 N`: `N` has the wrong dimension, expected one number in N/m");
        let error = eval(["k_n=1 N/m", "delta_e=1", "delta_f=2", "delta=0"]).unwrap_err();
        assert_eq!(error, "wear-3 has no argument `delta`, the nearest is `delta_n`");
    }

    #[test]
    fn what_lies_outside_the_domain_is_refused() {
        let error = eval(["k_n=-1", "delta_e=1", "delta_f=2", "delta_n=0"]).unwrap_err();
        assert_eq!(error, "`k_n` = -1 is outside its domain: > 0");
        let error = eval(["k_n=1", "delta_e=1", "delta_f=2", "delta_f=2"]).unwrap_err();
        assert_eq!(error, "`delta_f` is given twice");
    }
}
