//! Equations on a terminal.

use crate::equations::{Entry, Registry, Results};
use serde_json::{Value, json};
use veridem_spec::document::Quantity;
use veridem_spec::languages::graph;
use veridem_spec::languages::mathematics::{Computed, Formula, computed};

/// One line per equation.
pub(super) fn list(registry: &Registry) -> String {
    let width = registry.0.iter().map(|entry| entry.equation.id.len()).max().unwrap_or(0);
    let line = |entry: &Entry| format!("{:width$}  {}\n", entry.equation.id, plain_text(&entry.document.title));
    registry.0.iter().map(line).collect()
}

/// The complete documentation of an equation, as JSON.
pub(super) fn as_json(Entry { equation, document }: &Entry) -> Value {
    let quantities = |quantities: &[Quantity]| -> Vec<Value> {
        let row = |q: &Quantity| {
            json!({ "name": q.name, "symbol": q.symbol, "unit": q.unit, "size": q.size,
                    "domain": q.domain.to_string(), "meaning": q.meaning })
        };
        quantities.iter().map(row).collect()
    };
    json!({
        "id": equation.id,
        "numbers": equation.covers,
        "function": equation.function,
        "file": format!("spec/{}", equation.file),
        "title": plain_text(&document.title),
        "formula": document.formula,
        "arguments": quantities(&document.arguments),
        "results": quantities(&document.results),
        "laws": document.laws,
        "rounding": document.rounding,
    })
}

/// The complete documentation of an equation and its computed form, as JSON.
pub(super) fn entry_as_json(entry: &Entry) -> Value {
    let Computed { parts, results } = computed(&graph(&entry.equation), &entry.document);
    let formula = |Formula { symbol, formula }: &Formula| json!({ "symbol": symbol, "formula": formula });
    let mut value = as_json(entry);
    value["computed"] = parts.iter().chain(&results).map(formula).collect();
    value
}

/// Most lines of a computed form that are shown.
const MOST_LINES: usize = 40;

/// The formula as it is computed, a line for each part that occurs more than once and for each result.
fn as_computed(Entry { equation, document }: &Entry) -> String {
    let graph = graph(equation);
    let Computed { parts, results } = computed(&graph, document);
    let line = |Formula { symbol, formula }: &Formula| format!("{symbol} = {formula}");
    let lines: Vec<String> = parts.iter().chain(&results).map(line).collect();
    if lines.len() <= MOST_LINES {
        return lines.join("\n");
    }
    format!("In {} steps, which `veridem eq export --language c {}` writes", graph.nodes.len(), equation.id)
}

/// The documentation of an equation.
pub(super) fn entry(shown: &Entry) -> String {
    let Entry { equation, document } = shown;
    let laws: Vec<String> = document.laws.iter().map(|law| law.replace('_', " ")).collect();
    let bound = document.rounding.map_or("not stated".into(), |bound| format!("at most {bound} ULP"));
    [
        format!("{}: {}", equation.id, plain_text(&document.title)),
        indented(&document.formula),
        format!("Computed\n{}", indented(&as_computed(shown))),
        format!("Reading\n{}", indented(&document.reading)),
        format!("Arguments\n{}", indented(&table(&document.arguments))),
        format!("Results\n{}", indented(&table(&document.results))),
        format!("Laws\n{}", indented(&laws.join("\n"))),
        format!("Rounding\n{}", indented(&bound)),
        format!("Source\n    spec/{}, `{}`\n", equation.file, equation.function),
    ]
    .join("\n\n")
}

fn table(quantities: &[Quantity]) -> String {
    let row = |q: &Quantity| {
        let unit = if q.size == 1 { q.unit.clone() } else { format!("{} ({})", q.unit, q.size) };
        [q.name.clone(), q.symbol.clone(), unit, q.domain.to_string()]
    };
    let rows: Vec<[String; 4]> = quantities.iter().map(row).collect();
    let widths: [usize; 4] = std::array::from_fn(|k| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0));
    let line = |(row, quantity): (&[String; 4], &Quantity)| {
        let cells: Vec<String> = row.iter().zip(widths).map(|(cell, width)| format!("{cell:width$}")).collect();
        format!("{}  {}\n", cells.join("  "), quantity.meaning)
    };
    rows.iter().zip(quantities).map(line).collect()
}

/// The results, one per line, in SI.
pub(super) fn results(results: &Results) -> String {
    let line = |(quantity, values): &(&Quantity, Vec<f64>)| {
        let digits: Vec<String> = values.iter().map(|x| format!("{x:.16e}")).collect();
        format!("{} = {} {}\n", quantity.name, digits.join(" "), quantity.unit)
    };
    results.iter().map(line).collect()
}

fn indented(text: &str) -> String {
    text.lines().map(|line| format!("    {line}").trim_end().to_string()).collect::<Vec<_>>().join("\n")
}

fn plain_text(markdown: &str) -> String {
    markdown.replace("**", "").replace('\n', " ")
}
