//! Equations evaluated over ranges of their arguments.

use crate::equations::{Entry, outside, with_unit};
use crate::proofs::enclosure;
use crate::spec::document::{Domain, Quantity};
use crate::spec::numbers::Interval;
use serde_json::{Map, Value, json};

/// Evaluates an equation with arguments such as `r=1 nm .. 10 nm` or `m=2 kg`: intervals that contain all results.
pub(super) fn eval(entry: &Entry, arguments: &[String]) -> Result<Vec<Interval>, String> {
    let mut given = vec![];
    for argument in arguments {
        let (name, text) =
            argument.split_once('=').ok_or_else(|| format!("`{argument}`: expected name=\"value .. value unit\""))?;
        given.push((name.trim(), range(entry.argument(name.trim())?, text)?));
    }
    enclosure(&entry.equation, entry.in_order(given)?.concat())
}

/// Reads `1 nm .. 10 nm`, `1 .. 10 nm`, or one value.
fn range(quantity: &Quantity, text: &str) -> Result<Vec<Interval>, String> {
    let (low, high) = text.split_once("..").unwrap_or((text, text));
    let has_unit = |text: &str| text.contains(|c: char| c.is_alphabetic() && c != 'e' && c != 'E');
    let unit = high.find(|c: char| c.is_alphabetic() && c != 'e' && c != 'E').map(|at| &high[at..]);
    let low = match unit {
        Some(unit) if !has_unit(low) => format!("{} {unit}", low.trim()),
        _ => low.trim().into(),
    };
    let (low, high) = (with_unit(quantity, &low)?, with_unit(quantity, high.trim())?);
    let inside = |value: &[f64]| match quantity.domain {
        Domain::Unit => value.iter().all(|x| x.abs() <= 1.0),
        domain => domain.contains(value),
    };
    if let Some(value) = [&low, &high].into_iter().find(|value| !inside(value)) {
        return Err(outside(quantity, &quantity.name, value));
    }
    let ordered = |(lo, hi): (&f64, &f64)| {
        let backwards = || format!("`{}` = `{text}`: a range goes from the smaller to the larger value", quantity.name);
        if lo <= hi { Ok(Interval::new(*lo, *hi)) } else { Err(backwards()) }
    };
    low.iter().zip(&high).map(ordered).collect()
}

/// One result per line, in SI.
pub(super) fn text(entry: &Entry, results: &[Interval]) -> String {
    let line = |(quantity, numbers): (&Quantity, &[Interval])| {
        let ranges: Vec<String> = numbers.iter().map(|x| format!("{:.16e} .. {:.16e}", x.lo, x.hi)).collect();
        format!("{} = {} {}\n", quantity.name, ranges.join(", "), quantity.unit)
    };
    by_result(entry, results).map(line).collect()
}

/// By name, each number as its bounds.
pub(super) fn json(entry: &Entry, results: &[Interval]) -> String {
    let named = |(quantity, numbers): (&Quantity, &[Interval])| {
        let bounds: Vec<Value> = numbers.iter().map(|x| json!([x.lo, x.hi])).collect();
        (quantity.name.clone(), if quantity.size == 1 { bounds[0].clone() } else { bounds.into() })
    };
    format!("{}\n", Value::from(by_result(entry, results).map(named).collect::<Map<_, _>>()))
}

fn by_result<'a>(entry: &'a Entry, mut rest: &'a [Interval]) -> impl Iterator<Item = (&'a Quantity, &'a [Interval])> {
    entry.document.results.iter().map(move |quantity| {
        let (numbers, after) = rest.split_at(quantity.size);
        rest = after;
        (quantity, numbers)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equations::Registry;

    fn force(arguments: [&str; 4]) -> Result<Interval, String> {
        let registry = Registry::new();
        eval(registry.find("wear-3")?, &arguments.map(String::from)).map(|results| results[0])
    }

    #[test]
    fn a_range_gives_an_interval_that_is_hardly_wider_than_the_results() {
        let force = |k_n, delta_n| force([k_n, "delta_e=0.3 nm", "delta_f=0.5 nm", delta_n]).unwrap();
        // the elastic branch is a product
        let bounds = force("k_n=1 .. 2 N/m", "delta_n=-0.2 nm .. -0.1 nm");
        assert!(bounds.contains(-0.4e-9) && bounds.contains(-0.1e-9), "{bounds:?}");
        assert!(bounds.lo >= -0.4000001e-9 && bounds.hi <= -0.0999999e-9, "{bounds:?}");
        // across the peak, where the cases meet
        let bounds = force("k_n=1 N/m", "delta_n=0.2 nm .. 0.4 nm");
        assert!(bounds.contains(0.3e-9) && bounds.contains(0.15e-9) && bounds.hi < 0.31e-9, "{bounds:?}");
    }

    #[test]
    fn a_range_that_is_none_is_refused() {
        let error = |k_n| force([k_n, "delta_e=0.3 nm", "delta_f=0.5 nm", "delta_n=0"]).unwrap_err();
        assert_eq!(error("k_n=2 .. 1 N/m"), "`k_n` = `2 .. 1 N/m`: a range goes from the smaller to the larger value");
        assert_eq!(error("k_n=-1 .. 1 N/m"), "`k_n` = -1 is outside its domain: > 0");
        assert!(error("k_n=1 .. 2 N").contains("wrong dimension"));
    }
}
