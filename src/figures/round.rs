//! Round numbers: steps of ticks, lengths of bars, times in words.

/// The number of 1, 2 or 5 times a power of ten that is no smaller than `least`.
pub(super) fn round_step(least: f64) -> f64 {
    let power = libm::exp10(libm::floor(libm::log10(least)));
    let digit = [1.0, 2.0, 5.0].into_iter().find(|digit| digit * power >= least * (1.0 - 1e-9));
    digit.unwrap_or(10.0) * power
}

/// A time given in ns, in a unit that suits it.
pub(super) fn duration(ns: f64) -> String {
    in_thousands(ns, ["ps", "ns", "µs"])
}

/// A length given in nm, in a unit that suits it.
pub(super) fn distance(nm: f64) -> String {
    in_thousands(nm, ["pm", "nm", "µm"])
}

/// Four digits without needless zeros, in units a thousand times as large as those before.
fn in_thousands(value: f64, [below, unit, above]: [&str; 3]) -> String {
    let size = value.abs();
    let (value, unit) = match size {
        _ if size == 0.0 || (0.1..1000.0).contains(&size) => (value, unit),
        _ if size < 0.1 => (1e3 * value, below),
        _ => (1e-3 * value, above),
    };
    let rounded: f64 = format!("{value:.3e}").parse().expect("a number that was just written");
    format!("{rounded} {unit}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_and_lengths_have_units_that_suit_them() {
        assert_eq!(
            [0.0, 0.05, 0.123456, 12.0, 999.99, 1234.5].map(duration),
            ["0 ns", "50 ps", "0.1235 ns", "12 ns", "1000 ns", "1.234 µs"]
        );
        assert_eq!([0.02, 50.0, 2000.0].map(distance), ["20 pm", "50 nm", "2 µm"]);
    }

    #[test]
    fn a_step_is_round_and_no_smaller_than_asked_for() {
        assert_eq!([0.9, 1.0, 1.1, 2.1, 5.5, 1000.0].map(round_step), [1.0, 1.0, 2.0, 5.0, 10.0, 1000.0]);
    }
}
