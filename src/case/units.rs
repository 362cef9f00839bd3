//! Units: the interface between the user and the engine.
//!
//! The engine works in nanometres, nanoseconds and attograms (1e-21 kg), hence in piconewtons, zeptojoules and megapascals.
//! Every unit accepted here is a power of ten times one of these, so a conversion only shifts the decimal point and nothing is rounded twice.

/// Exponents of kilogram, metre, second and kelvin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension(pub [i32; 4]);

impl Dimension {
    /// Power of ten of the coherent SI unit of this dimension, in engine units.
    pub const fn engine_power(self) -> i32 {
        let [kilogram, metre, second, _] = self.0;
        21 * kilogram + 9 * metre + 9 * second
    }
}

/// Boltzmann's constant, zJ/K.
pub const BOLTZMANN: f64 = 1.380649e-2;

/// Units that may carry a prefix: symbol, dimension, power of ten of the coherent SI unit.
const UNITS: [(&str, Dimension, i32); 9] = [
    ("m", Dimension([0, 1, 0, 0]), 0),
    ("Å", Dimension([0, 1, 0, 0]), -10),
    // The sign of the unit looks like the letter.
    ("\u{212b}", Dimension([0, 1, 0, 0]), -10),
    ("s", Dimension([0, 0, 1, 0]), 0),
    ("g", Dimension([1, 0, 0, 0]), -3),
    ("N", Dimension([1, 1, -2, 0]), 0),
    ("J", Dimension([1, 2, -2, 0]), 0),
    ("Pa", Dimension([1, -1, -2, 0]), 0),
    ("K", Dimension([0, 0, 0, 1]), 0),
];
const PREFIXES: [(&str, i32); 14] = [
    ("z", -21),
    ("a", -18),
    ("f", -15),
    ("p", -12),
    ("n", -9),
    ("u", -6),
    ("µ", -6),
    ("μ", -6),
    ("m", -3),
    ("c", -2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
];

/// One symbol such as `GPa`: its dimension and power of ten in engine units.
fn symbol(text: &str) -> Option<(Dimension, i32)> {
    let plain =
        |text: &str| UNITS.iter().find(|unit| unit.0 == text).map(|&(_, d, power)| (d, power + d.engine_power()));
    plain(text).or_else(|| {
        PREFIXES.iter().find_map(|&(prefix, power)| {
            let (dimension, unit) = plain(text.strip_prefix(prefix)?)?;
            Some((dimension, power + unit))
        })
    })
}

/// A time given in seconds, as a number of the unit in which people wait for it.
pub fn of_waiting(seconds: f64) -> (f64, &'static str) {
    let units = [(86_400.0, "days"), (3600.0, "h"), (60.0, "min"), (1.0, "s")];
    let (length, unit) = units.into_iter().find(|(length, _)| seconds >= 2.0 * length).unwrap_or((1.0, "s"));
    (seconds / length, unit)
}

/// The single symbols of a dimension, with every prefix.
pub fn simple_units(dimension: Dimension) -> Vec<String> {
    let of_dimension = UNITS.iter().filter(|unit| unit.1 == dimension);
    let with_prefixes = |&(symbol, ..): &(&'static str, Dimension, i32)| {
        let prefixed = PREFIXES.iter().map(move |(prefix, _)| format!("{prefix}{symbol}"));
        std::iter::once(symbol.to_string()).chain(prefixed)
    };
    of_dimension.flat_map(with_prefixes).collect()
}

/// The symbols that may carry a prefix, and the prefixes with their powers of ten.
pub fn symbols() -> (Vec<&'static str>, &'static [(&'static str, i32)]) {
    (UNITS.iter().map(|unit| unit.0).collect(), &PREFIXES)
}

/// A product of powers such as `kg m^2/s`; a slash divides by the one factor after it.
pub fn unit(text: &str) -> Option<(Dimension, i32)> {
    let spaced = text.replace('/', " / ").replace(['*', '·'], " ");
    let (mut total, mut power, mut sign, mut factors) = ([0; 4], 0, 1, 0);
    for word in spaced.split_whitespace() {
        if word == "/" {
            if sign < 0 {
                return None;
            }
            sign = -1;
            continue;
        }
        factors += 1;
        if word == "1" {
            sign = 1;
            continue;
        }
        let (base, exponent) = word.split_once('^').unwrap_or((word, "1"));
        let exponent = sign * exponent.parse::<i32>().ok().filter(|e| e.abs() <= 9)?;
        let (Dimension(of_base), power_of_base) = symbol(base)?;
        for (sum, one) in total.iter_mut().zip(of_base) {
            *sum += exponent * one;
        }
        power += exponent * power_of_base;
        sign = 1;
    }
    (factors > 0 && sign > 0).then_some((Dimension(total), power))
}

/// Splits `14 nm` into its number, as written, and the rest. The number may be out of the range of `f64`.
pub fn number_and_unit(text: &str) -> Option<(&str, &str)> {
    let text = text.trim();
    let after_sign = |at: usize| at + usize::from(text[at..].starts_with(['+', '-']));
    let after_digits = |at: usize| at + text[at..].bytes().take_while(u8::is_ascii_digit).count();
    let mut end = after_digits(after_sign(0));
    if text[end..].starts_with('.') {
        end = after_digits(end + 1);
    }
    text[..end].contains(|c: char| c.is_ascii_digit()).then_some(())?;
    if text[end..].starts_with(['e', 'E']) {
        let exponent = after_sign(end + 1);
        end = Some(after_digits(exponent)).filter(|&last| last > exponent).unwrap_or(end);
    }
    Some((&text[..end], text[end..].trim()))
}

/// A decimal number times a power of ten, rounded once; infinite beyond the range of `f64`.
pub fn shifted(decimal: &str, power: i32) -> f64 {
    let (mantissa, exponent) = decimal.split_once(['e', 'E']).unwrap_or((decimal, "0"));
    let beyond = if exponent.starts_with('-') { i32::MIN } else { i32::MAX };
    let exponent = exponent.parse().unwrap_or(beyond);
    format!("{mantissa}e{}", exponent.saturating_add(power)).parse().expect("the number has been parsed before")
}

/// A number for people: in decimal notation near one, otherwise with an exponent, always with enough digits to read it back exactly.
pub fn decimal(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-4..1e7).contains(&size) { format!("{value}") } else { format!("{value:e}") }
}

/// A number with six significant digits, for people.
pub fn rounded(value: f64) -> String {
    decimal(format!("{value:.5e}").parse().expect("a formatted number is a number"))
}

/// A number with this many significant digits, for people.
pub fn significant(value: f64, digits: usize) -> String {
    let scientific = format!("{value:.0$e}", digits - 1);
    let size = value.abs();
    if size == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    if !(1e-4..1e7).contains(&size) {
        return scientific;
    }
    let (_, exponent) = scientific.split_once('e').expect("scientific notation");
    let before: i32 = exponent.parse().expect("scientific notation");
    let decimals = (digits as i32 - 1 - before).max(0) as usize;
    format!("{:.decimals$}", scientific.parse::<f64>().expect("scientific notation"))
}

/// An engine value in a unit.
pub fn from_engine(value: f64, unit_text: &str) -> f64 {
    let power = if unit_text.is_empty() { 0 } else { unit(unit_text).expect("units named in the source exist").1 };
    if value.is_finite() { shifted(&format!("{value:e}"), -power) } else { value }
}

/// An engine value in `unit` with six significant digits, for people.
pub fn in_unit(value: f64, unit_text: &str) -> String {
    if !value.is_finite() {
        return format!("{value} {unit_text}");
    }
    format!("{} {unit_text}", rounded(from_engine(value, unit_text)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn engine_units_are_nanometre_nanosecond_attogram() {
        for engine in ["nm", "ns", "ag", "pN", "zJ", "MPa", "m/s", "mN/m", "ag/nm^3", "MPa nm", "1/ns"] {
            assert_eq!(unit(engine).map(|(_, power)| power), Some(0), "{engine}");
        }
    }

    #[test]
    fn conversion_rounds_once() {
        let convert = |number, text| shifted(number, unit(text).unwrap().1);
        assert_eq!(convert("73", "GPa"), 73e3);
        assert_eq!(convert("2200", "kg/m^3"), 2200e-6);
        assert_eq!(convert("0.1", "µm"), 100.0);
        assert_eq!(convert("27.3e0", "fs"), 27.3e-6);
        assert_eq!(convert("1.5", "J/m^2"), 1500.0);
        assert_eq!(convert("1", "kg m^2/s"), 1e30);
    }

    #[test]
    fn a_number_ends_where_its_last_digit_stands_however_large_it_is() {
        for (text, parts) in [
            ("14 nm", ("14", "nm")),
            ("1e400 nm", ("1e400", "nm")),
            ("-.5e-3e", ("-.5e-3", "e")),
            ("1energy", ("1", "energy")),
            ("3.", ("3.", "")),
        ] {
            assert_eq!(number_and_unit(text), Some(parts));
        }
        for text in ["", "nm", "e5", "+", "-inf nm", "inf", "nan"] {
            assert_eq!(number_and_unit(text), None, "{text}");
        }
        assert_eq!(shifted("1e400", 0), f64::INFINITY);
        assert_eq!(shifted("1", 400), f64::INFINITY);
    }

    #[test]
    fn exponents_beyond_every_number_leave_zero_or_infinity() {
        assert_eq!(shifted("1e-99999999999", 9), 0.0);
        assert_eq!(shifted("1e99999999999", -9), f64::INFINITY);
        assert_eq!(shifted("0e99999999999", 9), 0.0);
    }

    #[test]
    fn what_is_not_a_unit_is_refused() {
        for text in ["", "parsec", "kg//m", "m/", "m^x", "/", "m^-", "GGPa", "1.5"] {
            assert_eq!(unit(text), None, "{text}");
        }
    }

    #[test]
    fn a_decimal_is_read_back_exactly() {
        for value in [73e3, 0.1, 1.0 / 3.0, 2.2e-3, 1e-300, 6.02214076e23, -7e6, 1e7] {
            assert_eq!(decimal(value).parse(), Ok(value));
        }
    }

    #[test]
    fn people_see_six_digits_and_a_unit() {
        assert_eq!(in_unit(73e3, "GPa"), "73 GPa");
        assert_eq!(in_unit(2.0 / 3.0 * 1e-3, "fs"), "666.667 fs");
        assert_eq!(in_unit(1.0, "kg"), "1e-21 kg");
        assert_eq!(in_unit(f64::INFINITY, "fs"), "inf fs");
    }
}
