//! Units as pages show them.

/// A text whose units have raised exponents: `nm²` for `nm^2`.
pub(super) fn raised(text: &str) -> String {
    let mut parts = text.split('^');
    let first = parts.next().unwrap_or_default();
    parts.fold(first.into(), |before, part| {
        let end = part.find(|c: char| !c.is_ascii_digit() && c != '-').unwrap_or(part.len());
        let (exponent, rest) = part.split_at(end);
        match exponent.parse::<i32>() {
            Ok(_) => before + &exponent.chars().map(superscript).collect::<String>() + rest,
            Err(_) => format!("{before}^{part}"),
        }
    })
}

/// A digit or minus sign as an exponent.
fn superscript(sign: char) -> char {
    match sign.to_digit(10) {
        Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
        None => '⁻',
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_of_units_are_raised_and_nothing_else_is() {
        let texts = ["projected area [nm^2]", "12 m^3", "s^-1", "ag/nm^3 of x^10", "2^n", "a ^", "x^1-2", "plain"];
        let expected = ["projected area [nm²]", "12 m³", "s⁻¹", "ag/nm³ of x¹⁰", "2^n", "a ^", "x^1-2", "plain"];
        assert_eq!(texts.map(raised), expected);
    }
}
