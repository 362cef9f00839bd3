//! Python 3: a module without dependencies.

use super::Syntax;
use super::comment::wrapped;
use super::procedure::{Procedure, Statement, Value};

pub(super) struct Python;

const HELPERS: &str = r#"
import math


def _over(a, b):
    """The quotient as IEEE 754 defines it, of zeros, too."""
    if b != 0.0:
        return a / b
    return math.nan if a == 0.0 or a != a else math.copysign(math.inf, a) * math.copysign(1.0, b)


def _sqrt(x):
    return math.sqrt(x) if x >= 0.0 else math.nan


def _floor(x):
    return math.copysign(float(math.floor(x)), x) if abs(x) < 4503599627370496.0 else x


def _exponent(x):
    """The power of two of a normal number."""
    return float(math.frexp(x)[1] - 1)


def _power_of_two(shifted):
    """Two to the power of a whole number, to which 3/2 2^52 has been added."""
    whole = shifted - 6755399441055744.0
    return math.ldexp(1.0, int(whole)) if -1023.0 < whole < 1024.0 else math.nan


def _abs(x):
    return -x if x < 0.0 else x


def _min(a, b):
    return a if a < b else b


def _max(a, b):
    return a if b < a else b
"#;

impl Syntax for Python {
    fn reserved(&self) -> &'static [&'static str] {
        &[
            "and", "as", "assert", "async", "await", "break", "class", "continue", "def", "del", "elif", "else",
            "except", "finally", "for", "from", "global", "if", "import", "in", "is", "lambda", "nonlocal", "not",
            "or", "pass", "raise", "return", "try", "while", "with", "yield", "none", "true", "false", "math", "abs",
            "float", "int",
        ]
    }
    fn literal(&self, value: f64) -> String {
        match value {
            f64::INFINITY => "math.inf".into(),
            f64::NEG_INFINITY => "-math.inf".into(),
            _ if value.is_nan() => "math.nan".into(),
            _ => format!("{value:?}"),
        }
    }
    fn logic(&self) -> [&'static str; 3] {
        ["and", "or", "not "]
    }
    fn select(&self, condition: &str, yes: &str, no: &str) -> String {
        format!("{yes} if {condition} else {no}")
    }
    fn function(&self, name: &'static str) -> String {
        format!("_{name}")
    }
    /// Python raises an exception for a quotient by zero, also where it is not chosen in the end.
    fn quotient(&self, dividend: &str, divisor: &str) -> Option<String> {
        let is_literal = divisor.parse::<f64>().is_ok_and(|x| x != 0.0);
        (!is_literal).then(|| format!("_over({dividend}, {divisor})"))
    }
    fn comment(&self) -> &'static str {
        "#"
    }
    fn procedure(&self, procedure: &Procedure, comment: &str) -> String {
        let names: Vec<&str> = procedure.arguments.iter().map(|value| value.name.as_str()).collect();
        let statement = |s: &Statement| format!("    {} = {}\n", s.name, s.expression);
        let body: String = procedure.statements.iter().map(statement).collect();
        let mut outputs = procedure.outputs.iter();
        let mut result = |value: &Value| {
            let numbers: Vec<&str> = outputs.by_ref().take(value.size).map(String::as_str).collect();
            if value.size == 1 { numbers[0].to_string() } else { format!("({})", numbers.join(", ")) }
        };
        let results: Vec<String> = procedure.results.iter().map(&mut result).collect();
        let comment: String = wrapped(comment, "")
            .lines()
            .map(|line| format!("    {}\n", line.strip_prefix(' ').unwrap_or(line)).replace("    \n", "\n"))
            .collect();
        let (name, list) = (&procedure.name, names.join(", "));
        format!("def {name}({list}):\n    r\"\"\"{}\"\"\"\n{body}    return {}\n", comment.trim(), results.join(", "))
    }
    fn module(&self, head: &str, functions: &[String], _: &[Procedure], texts: &[String]) -> String {
        let shapes = wrapped(
            "Vectors are sequences of three numbers, tensors of nine, rows first; several results come as a tuple.",
            self.comment(),
        );
        let all: Vec<&str> = functions.iter().chain(texts).map(String::as_str).collect();
        format!("{head}{shapes}{HELPERS}\n\n{}", all.join("\n\n"))
    }
}
