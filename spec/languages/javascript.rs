//! JavaScript: a module without dependencies.

use super::Syntax;
use super::comment::wrapped;
use super::procedure::{Procedure, Statement, Value};

pub(super) struct Javascript;

const HELPERS: &str = r#"
const _view = new DataView(new ArrayBuffer(8));
// The power of two of a normal number.
function _exponent(x) {
  _view.setFloat64(0, x);
  return ((_view.getUint32(0) >>> 20) & 2047) - 1023;
}
// Two to the power of a whole number, to which 3/2 2^52 has been added.
function _power_of_two(shifted) {
  _view.setUint32(0, (shifted - 6755399441055744 + 1023) * 1048576);
  _view.setUint32(4, 0);
  return _view.getFloat64(0);
}
const _sqrt = Math.sqrt;
const _floor = Math.floor;
const _abs = (x) => (x < 0 ? -x : x);
const _min = (a, b) => (a < b ? a : b);
const _max = (a, b) => (b < a ? a : b);
"#;

impl Syntax for Javascript {
    fn reserved(&self) -> &'static [&'static str] {
        &[
            "await",
            "break",
            "case",
            "catch",
            "class",
            "const",
            "continue",
            "debugger",
            "default",
            "delete",
            "do",
            "else",
            "enum",
            "export",
            "extends",
            "false",
            "finally",
            "for",
            "function",
            "if",
            "implements",
            "import",
            "in",
            "instanceof",
            "interface",
            "let",
            "new",
            "null",
            "package",
            "private",
            "protected",
            "public",
            "return",
            "static",
            "super",
            "switch",
            "this",
            "throw",
            "true",
            "try",
            "typeof",
            "var",
            "void",
            "while",
            "with",
            "yield",
            "arguments",
            "eval",
            "infinity",
            "nan",
        ]
    }
    fn literal(&self, value: f64) -> String {
        match value {
            f64::INFINITY => "Infinity".into(),
            f64::NEG_INFINITY => "-Infinity".into(),
            _ if value.is_nan() => "NaN".into(),
            _ => format!("{value:?}"),
        }
    }
    fn function(&self, name: &'static str) -> String {
        format!("_{name}")
    }
    fn procedure(&self, procedure: &Procedure, comment: &str) -> String {
        let names: Vec<&str> = procedure.arguments.iter().map(|value| value.name.as_str()).collect();
        let statement = |s: &Statement| format!("  const {} = {};\n", s.name, s.expression);
        let body: String = procedure.statements.iter().map(statement).collect();
        let mut outputs = procedure.outputs.iter();
        let mut result = |value: &Value| {
            let numbers: Vec<&str> = outputs.by_ref().take(value.size).map(String::as_str).collect();
            let numbers = if value.size == 1 { numbers[0].to_string() } else { format!("[{}]", numbers.join(", ")) };
            if procedure.results.len() == 1 { numbers } else { format!("{}: {numbers}", value.name) }
        };
        let results: Vec<String> = procedure.results.iter().map(&mut result).collect();
        let results = if results.len() == 1 { results[0].clone() } else { format!("{{ {} }}", results.join(", ")) };
        let export = if procedure.private { "" } else { "export " };
        let comment = wrapped(comment, self.comment());
        format!(
            "{comment}{export}function {}({}) {{\n{body}  return {results};\n}}\n",
            procedure.name,
            names.join(", ")
        )
    }
    fn module(&self, head: &str, functions: &[String], _: &[Procedure], texts: &[String]) -> String {
        let shapes = wrapped(
            "Vectors are arrays of three numbers, tensors of nine, rows first; several results come as an object with their names.",
            self.comment(),
        );
        format!("{head}{shapes}{HELPERS}\n{}\n{}", functions.join("\n"), texts.join("\n"))
    }
}
