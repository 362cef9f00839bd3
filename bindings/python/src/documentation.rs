//! The documentation of an equation as Python shows it.

use veridem::equations::Entry;
use veridem_spec::document::{Document, Quantity};

/// Words that no argument may have as its name in Python.
const RESERVED: [&str; 1] = ["lambda"];

/// The name of an argument in Python.
fn argument(name: &str) -> String {
    if RESERVED.contains(&name) { format!("{name}_") } else { name.into() }
}

/// The names of the arguments of a call.
pub(crate) fn parameters(entry: &Entry) -> Vec<String> {
    entry.document.arguments.iter().map(|quantity| argument(&quantity.name)).collect()
}

/// Text without the marks of emphasis, in one line.
pub(crate) fn plain(markdown: &str) -> String {
    markdown.replace("**", "").replace('\n', " ")
}

/// The documentation: title, table, formula as printed, reading, laws.
pub(crate) fn of(entry: &Entry) -> String {
    let Document { title, formula, reading, arguments, results, laws, rounding } = &entry.document;
    let titled = |title: &str, text: String| format!("{title}\n{}\n{text}", "-".repeat(title.len()));
    let mut parts = vec![plain(title)];
    parts.push(titled("Parameters", arguments.iter().map(|q| row(&argument(&q.name), q)).collect::<String>() + CHECK));
    parts.push(titled("Returns", results.iter().map(|q| row(&q.name, q)).collect()));
    parts.push(titled("Formula as printed", indented(formula)));
    if !reading.is_empty() {
        parts.push(titled("Reading", reading.clone()));
    }
    if !laws.is_empty() {
        parts.push(titled("Laws", laws.iter().map(|law| format!("* {}\n", law.replace('_', " "))).collect()));
    }
    let rounding = rounding.map_or(String::new(), |bound| format!(", rounding error at most {bound} ULP"));
    parts.push(format!("{}, spec/{}{rounding}", entry.equation.id, entry.equation.file));
    parts.iter().map(|part| part.trim_end()).collect::<Vec<_>>().join("\n\n") + "\n"
}

const CHECK: &str = "check : bool\n    refuse values outside their domain, and results that are not finite\n";

fn row(name: &str, Quantity { symbol, unit, size, domain, meaning, .. }: &Quantity) -> String {
    let kind = match size {
        1 => "float or array",
        9 => "array (..., 3, 3)",
        _ => "array (..., 3)",
    };
    let unit = if unit == "1" { String::new() } else { format!(" [{unit}]") };
    let domain = domain.to_string();
    let domain = if domain == "any" { String::new() } else { format!(", {domain}") };
    format!("{name} : {kind}{unit}{domain}\n    ${symbol}$: {meaning}\n")
}

fn indented(text: &str) -> String {
    text.lines().map(|line| format!("    {line}\n")).collect()
}
