//! Symbols and numbers in TeX.

use crate::document::{Document, Quantity};

/// The symbols of all numbers of some quantities, laid end to end.
pub(super) fn components(quantities: &[Quantity]) -> Vec<String> {
    let axes = ["x", "y", "z"];
    let of = |q: &Quantity| -> Vec<String> {
        match q.size {
            3 => axes.iter().map(|axis| component(&q.symbol, axis)).collect(),
            9 => (0..9).map(|k| component(&q.symbol, &format!("{}{}", axes[k / 3], axes[k % 3]))).collect(),
            _ => vec![q.symbol.clone()],
        }
    };
    quantities.iter().flat_map(of).collect()
}

/// The symbol of a component: an index after those that the vector has.
fn component(symbol: &str, index: &str) -> String {
    let plain = ["\\mathbf", "\\boldsymbol"].iter().fold(symbol.to_string(), |text, bold| text.replace(bold, ""));
    let plain = plain.trim();
    let Some((base, rest)) = plain.split_once('_') else { return format!("{plain}_{{{index}}}") };
    let (indices, after) = match rest.strip_prefix('{') {
        Some(inner) => {
            let mut depth = 1;
            let end = inner.find(|c: char| {
                depth += i32::from(c == '{') - i32::from(c == '}');
                depth == 0
            });
            inner.split_at(end.unwrap_or(inner.len()))
        }
        None => {
            let command =
                rest.strip_prefix('\\').map(|name| 1 + name.find(|c: char| !c.is_alphabetic()).unwrap_or(name.len()));
            rest.split_at(command.unwrap_or_else(|| rest.chars().next().map_or(0, char::len_utf8)))
        }
    };
    let after = if rest.starts_with('{') { after.strip_prefix('}').unwrap_or(after) } else { after };
    format!("{base}_{{{indices},{index}}}{after}")
}

/// A letter that no symbol of the table begins with.
pub(super) fn unused_letter(document: &Document) -> &'static str {
    let symbols = || document.arguments.iter().chain(&document.results).map(|q| q.symbol.as_str());
    let letters = ["q", "p", "u", "s", "z", "b", "g", "h"];
    let is_free = |letter: &&&str| !symbols().any(|symbol| symbol.contains(**letter) && !symbol.contains('\\'));
    letters.iter().find(is_free).unwrap_or(&"Q")
}

/// Largest denominator of a fraction that is told from its decimals.
const LARGEST_DENOMINATOR: u32 = 64;

/// A number, and whether it needs no parentheses beside other factors.
pub(super) fn number(value: f64) -> (String, bool) {
    let size = value.abs();
    let sign = if value.is_sign_negative() && value != 0.0 { "-" } else { "" };
    let short = format!("{size:?}");
    let text = if size.is_infinite() {
        "\\infty".into()
    } else if let Some(whole) = short.strip_suffix(".0") {
        whole.into()
    } else if let Some(fraction) = fraction(size).filter(|_| short.len() > 8) {
        fraction
    } else if let Some((mantissa, power)) = short.split_once('e') {
        if mantissa == "1" { format!("10^{{{power}}}") } else { format!("{mantissa} \\cdot 10^{{{power}}}") }
    } else {
        short
    };
    (format!("{sign}{text}"), sign.is_empty())
}

fn fraction(value: f64) -> Option<String> {
    (2..=LARGEST_DENOMINATOR).find_map(|denominator| {
        let numerator = (value * f64::from(denominator)).round();
        let is_it = numerator > 0.0 && numerator < 1000.0 && numerator / f64::from(denominator) == value;
        is_it.then(|| format!("\\frac{{{numerator}}}{{{denominator}}}"))
    })
}

#[cfg(test)]
mod tests {
    use super::{component, number};

    #[test]
    fn a_component_has_its_index_after_those_of_the_vector() {
        assert_eq!(component("\\mathbf{n}", "x"), "{n}_{x}");
        assert_eq!(component("\\mathbf{x}_i", "y"), "{x}_{i,y}");
        assert_eq!(component("\\boldsymbol{\\omega}_{ij}'", "z"), "{\\omega}_{ij,z}'");
        assert_eq!(component("F_\\parallel", "x"), "F_{\\parallel,x}");
    }

    #[test]
    fn numbers_are_written_as_in_a_paper() {
        let text = |value: f64| number(value).0;
        assert_eq!([text(2.0), text(-0.5), text(1.0 / 3.0)], ["2", "-0.5", "\\frac{1}{3}"]);
        assert_eq!([text(1e-9), text(1.38e-23)], ["10^{-9}", "1.38 \\cdot 10^{-23}"]);
    }
}
