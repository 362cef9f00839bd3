//! The curve of an equation, drawn by its exported kernel.

use super::Entry;
use crate::spec::document::{Domain, Quantity};
use crate::spec::languages::{Exported, Language, name};
use maud::{Markup, PreEscaped, html};
use serde_json::Value;

/// Longest kernel that a page carries, in bytes.
const LONGEST: usize = 60_000;

/// The section with the curve, or nothing for an equation without a number to vary or with a very long kernel.
pub(super) fn section(entry: &Entry) -> Markup {
    let (equation, document) = (entry.equation, entry.document);
    let exported = Exported::equation(equation, document, "");
    if exported.refusal().is_some() || document.arguments.iter().all(|q| q.size > 1) {
        return html! {};
    }
    let module = Language::Javascript.module(&[exported]);
    if module.len() > LONGEST {
        return html! {};
    }
    let data = serde_json::json!({ "arguments": arguments(&document.arguments, &entry.start), "results": results(&document.results) });
    html! {
        section #curve {
            h2 { "Curve" }
            p.note { "Drawn by the " a href="#kernel" { "exported kernel" } ". It begins at " (entry.origin) "." }
            (drawing("Curve of the equation"))
            (kernel(&module, "kernel"))
            (script(&format!("{module}\ndrawCurve({}, {});", name(equation), literal(&data))))
        }
    }
}

/// Where a curve is drawn.
pub(super) fn drawing(what: &str) -> Markup {
    html! { div.curve { svg viewBox="0 0 640 360" role="img" aria-label=(what) {} form {} } }
}

/// A kernel to read.
pub(super) fn kernel(module: &str, id: &str) -> Markup {
    html! { details id=(id) { summary { "The kernel" } pre { code { (module) } } } }
}

/// A module of the page.
pub(super) fn script(text: &str) -> Markup {
    html! { script type="module" { (PreEscaped(format!("\n{text}\n"))) } }
}

/// Data in a form that cannot end the script element that holds it.
pub(super) fn literal(data: &Value) -> String {
    data.to_string().replace('<', "\\u003c")
}

/// Arguments with the values at which they begin, laid end to end in `start`, and the ends of their sliders.
pub(super) fn arguments(quantities: &[Quantity], start: &[f64]) -> Vec<Value> {
    let mut start = start.iter().copied();
    let argument = |q: &Quantity| {
        let values: Vec<f64> = start.by_ref().take(q.size).collect();
        let [lo, hi] = bounds(q.domain, values[0]);
        serde_json::json!({ "name": q.name, "unit": q.unit, "meaning": q.meaning, "start": values, "lo": lo, "hi": hi })
    };
    quantities.iter().map(argument).collect()
}

/// Results with their sizes.
pub(super) fn results(quantities: &[Quantity]) -> Vec<Value> {
    quantities.iter().map(|q| serde_json::json!({ "name": q.name, "unit": q.unit, "size": q.size })).collect()
}

/// The ends of a slider: as far from a value as three times its size, within the domain.
pub(super) fn bounds(domain: Domain, value: f64) -> [f64; 2] {
    let reach = if value == 0.0 { 1.0 } else { 2.0 * value.abs() };
    let [least, largest] = [value - reach, value + reach];
    match domain {
        Domain::Unit => [-1.0, 1.0],
        Domain::Between { lo, hi, with_lo, with_hi } => {
            // An end that is excluded is a small part of the way off.
            let off = 1e-3 * reach;
            let lo = if with_lo { lo } else { lo + off };
            let hi = if with_hi { hi } else { hi - off };
            [least.max(lo), largest.min(hi)]
        }
    }
}
