//! The documentation of an equation, read from its source: the only place of names, units and domains.

use crate::equation::Equation;
use crate::unit::{Exponents, exponents};

/// The documentation of an equation.
#[derive(Debug)]
pub struct Document {
    /// The first paragraph: number, section, what it is.
    pub title: String,
    /// The formula as printed, in TeX.
    pub formula: String,
    /// Errata, ambiguities, signs, and the choice made, as Markdown.
    pub reading: String,
    /// Inputs, in the order of the function's arguments.
    pub arguments: Vec<Quantity>,
    /// Results.
    pub results: Vec<Quantity>,
    /// Names of the tests that prove the equation.
    pub laws: Vec<String>,
    /// Largest rounding error in `f64`, in units of the last place as [`Document::of`] defines them.
    pub rounding: Option<f64>,
}

/// One row of the table.
#[derive(Debug)]
pub struct Quantity {
    /// Name of the function's argument, or of the result.
    pub name: String,
    /// Symbol in the paper, in TeX.
    pub symbol: String,
    /// Unit as written.
    pub unit: String,
    /// Dimension of the unit.
    pub exponents: Exponents,
    /// 1 for a scalar, 3 for a vector, 9 for a tensor.
    pub size: usize,
    /// Allowed values.
    pub domain: Domain,
    /// Meaning, in words.
    pub meaning: String,
}

/// The values that a quantity may have; always finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Domain {
    /// Vectors of length one.
    Unit,
    /// Numbers between two bounds; vectors and tensors by component.
    Between {
        /// Lower bound.
        lo: f64,
        /// Upper bound.
        hi: f64,
        /// Whether the lower bound is allowed.
        with_lo: bool,
        /// Whether the upper bound is allowed.
        with_hi: bool,
    },
}

impl std::fmt::Display for Domain {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match *self {
            Self::Unit => write!(f, "a unit vector"),
            Self::Between { lo, hi, .. } if lo.is_infinite() && hi.is_infinite() => write!(f, "any"),
            Self::Between { lo, hi, with_lo, .. } if hi.is_infinite() => {
                write!(f, "{} {lo}", if with_lo { ">=" } else { ">" })
            }
            Self::Between { lo, hi, with_hi, .. } if lo.is_infinite() => {
                write!(f, "{} {hi}", if with_hi { "<=" } else { "<" })
            }
            Self::Between { lo, hi, with_lo, with_hi } => {
                write!(f, "{}{lo}, {hi}{}", if with_lo { '[' } else { '(' }, if with_hi { ']' } else { ')' })
            }
        }
    }
}

/// How far from one the length of a unit vector may be: normals come with about seven digits at the least.
const UNIT_TOLERANCE: f64 = 1e-6;

impl Domain {
    /// Every finite number.
    pub const ANY: Self = Self::Between { lo: f64::NEG_INFINITY, hi: f64::INFINITY, with_lo: false, with_hi: false };

    /// Reads `any`, `unit`, `> a`, `>= a`, `< a`, `<= a`, or an interval such as `(a, b]`.
    ///
    /// # Errors
    ///
    /// If the text is none of these.
    pub fn parse(text: &str) -> Result<Self, String> {
        let number = |text: &str| parse_number(text.trim()).ok_or_else(|| format!("domain `{text}`: not a number"));
        let between = |lo, with_lo, hi, with_hi| Self::Between { lo, hi, with_lo, with_hi };
        let (least, largest) = (f64::NEG_INFINITY, f64::INFINITY);
        Ok(match text {
            "any" => Self::ANY,
            "unit" => Self::Unit,
            _ => {
                if let Some(rest) = text.strip_prefix(">=") {
                    between(number(rest)?, true, largest, false)
                } else if let Some(rest) = text.strip_prefix("<=") {
                    between(least, false, number(rest)?, true)
                } else if let Some(rest) = text.strip_prefix('>') {
                    between(number(rest)?, false, largest, false)
                } else if let Some(rest) = text.strip_prefix('<') {
                    between(least, false, number(rest)?, false)
                } else {
                    let inner = text.get(1..text.len().max(1) - 1).and_then(|inner| inner.split_once(','));
                    match (inner, text.starts_with(['[', '(']), text.ends_with([']', ')'])) {
                        (Some((lo, hi)), true, true) => {
                            between(number(lo)?, text.starts_with('['), number(hi)?, text.ends_with(']'))
                        }
                        _ => return Err(format!("domain `{text}` is not understood")),
                    }
                }
            }
        })
    }

    /// Whether a scalar, vector or tensor with these components may occur. A NaN never may.
    pub fn contains(&self, components: &[f64]) -> bool {
        match *self {
            Self::Unit => (components.iter().map(|x| x * x).sum::<f64>().sqrt() - 1.0).abs() <= UNIT_TOLERANCE,
            // Without a way out of the loop several components are looked at together.
            Self::Between { lo, hi, with_lo, with_hi } => components.iter().fold(true, |within, x| {
                let at_bound = (*x == lo) & !with_lo | (*x == hi) & !with_hi;
                within & x.is_finite() & (*x >= lo) & (*x <= hi) & !at_bound
            }),
        }
    }
}

/// A number, a fraction, or a multiple of `pi` written as a fraction: `0.5`, `1/4`, `-pi/2`.
fn parse_number(text: &str) -> Option<f64> {
    let part = |text: &str| match text.trim_start_matches('-') {
        "pi" => Some(if text.starts_with('-') { -std::f64::consts::PI } else { std::f64::consts::PI }),
        _ => text.parse::<f64>().ok().filter(|x| x.is_finite()),
    };
    match text.split_once('/') {
        Some((numerator, denominator)) => Some(part(numerator)? / part(denominator)?),
        None => part(text),
    }
}

const HEADER: &str = "| name | symbol | unit | domain | meaning |";
const RULE: &str = "|---|---|---|---|---|";
/// Mark of the rows of the table that come out.
const RESULT: &str = "→ ";

impl Document {
    /// Reads the documentation of an equation. The line `Rounding: at most K ULP.` bounds, for every number that comes
    /// out, the error divided by `eps (|f| + sum_k |x_k df/dx_k|)`: K roundings of the result or of any of the inputs.
    ///
    /// # Errors
    ///
    /// If a part of the documentation is missing or cannot be read.
    pub fn of(equation: &Equation) -> Result<Self, String> {
        let text = doc_comment(equation.source, equation.function)
            .ok_or_else(|| format!("no documented `pub fn {}` in spec/{}", equation.function, equation.file))?;
        Self::parse(&text).map_err(|what| format!("spec/{}, `{}`: {what}", equation.file, equation.function))
    }

    fn parse(text: &str) -> Result<Self, String> {
        let mut document = Self {
            title: String::new(),
            formula: String::new(),
            reading: String::new(),
            arguments: vec![],
            results: vec![],
            laws: vec![],
            rounding: None,
        };
        let (mut section, mut fenced, mut titled) = ("", false, false);
        let mut rows = vec![];
        for line in text.lines() {
            if line.starts_with("```") {
                fenced = line == "```math";
                if section == "Reading" {
                    push_line(&mut document.reading, "$$");
                }
            } else if fenced && section.is_empty() {
                push_line(&mut document.formula, line);
            } else if let Some(heading) = line.strip_prefix("# ") {
                section = heading;
            } else if let Some(bound) = line.strip_prefix("Rounding: at most ") {
                let bound = bound.strip_suffix(" ULP.").and_then(|k| k.parse().ok());
                document.rounding = Some(bound.ok_or("`Rounding: at most K ULP.` is not understood")?);
            } else if line.starts_with('|') {
                rows.push(line);
            } else if section == "Laws" {
                document.laws.extend(line.strip_prefix("* `").and_then(|law| law.strip_suffix('`')).map(String::from));
            } else if section == "Reading" {
                push_line(&mut document.reading, line);
            } else if section.is_empty() && !titled {
                titled = line.is_empty();
                push_line(&mut document.title, line);
            }
        }
        if rows.first() != Some(&HEADER) || rows.get(1) != Some(&RULE) {
            return Err(format!("the table begins with `{HEADER}`"));
        }
        for row in &rows[2..] {
            let (quantity, is_result) = Quantity::parse(row).map_err(|what| format!("row `{row}`: {what}"))?;
            match (is_result, document.results.is_empty()) {
                (true, _) => document.results.push(quantity),
                (false, true) => document.arguments.push(quantity),
                (false, false) => return Err("results stand below all arguments".into()),
            }
        }
        for part in [&mut document.title, &mut document.formula, &mut document.reading] {
            *part = part.trim().into();
        }
        Ok(document)
    }
}

impl Quantity {
    fn parse(row: &str) -> Result<(Self, bool), String> {
        let cells: Vec<&str> = row.trim_matches('|').split(" |").map(str::trim).collect();
        let [name, symbol, unit, domain, meaning] = cells[..] else {
            return Err(format!("five cells, not {}", cells.len()));
        };
        let is_result = name.starts_with(RESULT);
        let name = name.strip_prefix(RESULT).unwrap_or(name);
        let name =
            name.strip_prefix('`').and_then(|name| name.strip_suffix('`')).ok_or("the name stands in backticks")?;
        let (unit, size) = match unit.split_once(" (") {
            Some((unit, "3)")) => (unit, 3),
            Some((unit, "9)")) => (unit, 9),
            Some(_) => return Err("a vector is marked `(3)`, a tensor `(9)`".into()),
            None => (unit, 1),
        };
        let quantity = Self {
            name: name.into(),
            symbol: symbol.trim_matches('$').into(),
            unit: unit.into(),
            exponents: exponents(unit)?,
            size,
            domain: if is_result && domain.is_empty() { Domain::ANY } else { Domain::parse(domain)? },
            meaning: meaning.into(),
        };
        Ok((quantity, is_result))
    }
}

fn push_line(text: &mut String, line: &str) {
    text.push_str(line);
    text.push('\n');
}

/// The text of the documentation comment directly above a public function.
fn doc_comment(source: &str, function: &str) -> Option<String> {
    let lines: Vec<&str> = source.lines().collect();
    let is_function = |line: &&str| {
        let rest = line.strip_prefix("pub fn ").and_then(|rest| rest.strip_prefix(function));
        rest.is_some_and(|rest| rest.starts_with(['<', '(']))
    };
    let end = lines.iter().position(is_function)?;
    let above = lines[..end].iter().rev().take_while(|line| line.starts_with("///") || line.starts_with("#["));
    let mut text: Vec<&str> = above.filter_map(|line| line.strip_prefix("///")).collect();
    text.reverse();
    let text: String = text.iter().flat_map(|line| [line.strip_prefix(' ').unwrap_or(line), "\n"]).collect();
    (!text.trim().is_empty()).then_some(text)
}

#[cfg(test)]
mod laws {
    use super::*;

    fn domain(text: &str) -> Domain {
        Domain::parse(text).unwrap()
    }

    #[test]
    fn domains_are_read_as_written() {
        assert!(domain("any").contains(&[-1e300, 0.0]) && !domain("any").contains(&[f64::NAN]));
        assert!(domain("> 0").contains(&[5e-324]) && !domain("> 0").contains(&[0.0]));
        assert!(domain(">= 0").contains(&[0.0, 1.0]) && !domain(">= 0").contains(&[1.0, -1e-300]));
        assert!(domain("(-1, 1/4]").contains(&[0.25]) && !domain("(-1, 1/4]").contains(&[-1.0]));
        assert!(domain("[-pi/2, pi/2)").contains(&[-std::f64::consts::FRAC_PI_2]));
        assert!(domain("< 1").contains(&[-3.0]) && !domain("<= 1").contains(&[1.0f64.next_up()]));
        assert!(domain("unit").contains(&[0.6, 0.0, -0.8]) && !domain("unit").contains(&[0.6, 0.0, 0.9]));
        assert!(!domain(">= 0").contains(&[f64::INFINITY]));
        for text in ["any", "> 0", ">= -2", "< 1.5", "<= 1", "[0, 1)", "(-1, 0.25]"] {
            assert_eq!(domain(text).to_string(), text);
        }
    }

    #[test]
    fn other_words_are_no_domain() {
        for text in ["", "positive", "> x", "[0, 1", "0, 1", "[0]", "(", "> inf"] {
            assert!(Domain::parse(text).is_err(), "`{text}` was read");
        }
    }

    #[test]
    fn a_row_with_a_wrong_cell_is_refused() {
        for row in [
            "| `m` | $m$ | kg | > 0 |",
            "| m | $m$ | kg | > 0 | mass |",
            "| `m` | $m$ | kilogram | > 0 | mass |",
            "| `m` | $m$ | kg (2) | > 0 | mass |",
            "| `m` | $m$ | kg | | mass |",
        ] {
            assert!(Quantity::parse(row).is_err(), "{row}");
        }
        let (force, is_result) = Quantity::parse("| → `f_n` | $F_N$ | N (3) | | force |").unwrap();
        assert!(is_result && force.size == 3 && force.domain == Domain::ANY);
    }
}
