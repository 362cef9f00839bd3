//! The curve of an equation, drawn by its exported kernel.

use super::Entry;
use super::text::escaped;
use crate::spec::document::{Domain, Quantity};
use crate::spec::languages::{Exported, Language, name};

/// Longest kernel that a page carries, in bytes.
const LONGEST: usize = 60_000;

/// The section with the curve, or nothing for an equation without a number to vary or with a very long kernel.
pub(super) fn section(entry: &Entry) -> String {
    let (equation, document) = (entry.equation, entry.document);
    let exported = Exported::equation(equation, document, "");
    if exported.refusal().is_some() || document.arguments.iter().all(|q| q.size > 1) {
        return String::new();
    }
    let module = Language::Javascript.module(&[exported]);
    if module.len() > LONGEST {
        return String::new();
    }
    let mut start = entry.start.iter().copied();
    let argument = |q: &Quantity| {
        let values: Vec<f64> = start.by_ref().take(q.size).collect();
        let [lo, hi] = bounds(q.domain, values[0]);
        serde_json::json!({ "name": q.name, "unit": q.unit, "meaning": q.meaning, "start": values, "lo": lo, "hi": hi })
    };
    let arguments: Vec<_> = document.arguments.iter().map(argument).collect();
    let result = |q: &Quantity| serde_json::json!({ "name": q.name, "unit": q.unit, "size": q.size });
    let results: Vec<_> = document.results.iter().map(result).collect();
    let data = serde_json::json!({ "arguments": arguments, "results": results }).to_string().replace('<', "\\u003c");
    format!(
        "<section id=\"curve\"><h2>Curve</h2>\n<p class=\"note\">Drawn by the <a href=\"#kernel\">exported kernel</a>. It begins at {}.</p>\n\
         <div class=\"curve\"><svg viewBox=\"0 0 640 360\" role=\"img\" aria-label=\"Curve of the equation\"></svg><form></form></div>\n\
         <details id=\"kernel\"><summary>The kernel</summary><pre><code>{}</code></pre></details>\n\
         <script type=\"module\">\n{module}\ndrawCurve({}, {data});\n</script></section>\n",
        escaped(&entry.origin),
        escaped(&module),
        name(equation),
    )
}

/// The ends of a slider: as far from a value as three times its size, within the domain.
fn bounds(domain: Domain, value: f64) -> [f64; 2] {
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
