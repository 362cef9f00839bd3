//! The ticks of an axis: round numbers, written the same way along the axis.

use super::round::round_step;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use std::ops::Range;

/// A range with its ticks.
#[derive(Clone)]
pub(super) struct Ticked {
    range: Range<f64>,
    ticks: Vec<(f64, String)>,
}

impl Ticked {
    /// A range, which is of logarithms for a logarithmic axis.
    pub(super) fn new(range: Range<f64>, log: bool) -> Self {
        Self { ticks: ticks((range.start, range.end), log), range }
    }

    /// The texts of its ticks.
    pub(super) fn texts(&self) -> impl Iterator<Item = &str> {
        self.ticks.iter().map(|(_, text)| &**text)
    }
}

impl Ranged for Ticked {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        let part = (value - self.range.start) / (self.range.end - self.range.start);
        from + (part * f64::from(to - from)).round() as i32
    }
    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.iter().map(|tick| tick.0).collect()
    }
    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for Ticked {
    fn format(place: &f64) -> String {
        place.to_string()
    }
    fn format_ext(&self, place: &f64) -> String {
        self.ticks.iter().find(|tick| tick.0 == *place).map_or(String::new(), |tick| tick.1.clone())
    }
}

/// Most ticks of an axis; seldom fewer than half as many.
const MOST: f64 = 7.0;

/// Round numbers within a range, which is of logarithms for a logarithmic axis, with their texts.
fn ticks((low, high): (f64, f64), log: bool) -> Vec<(f64, String)> {
    if log && high - low > 0.7 {
        return decades(low, high).into_iter().map(|place| (place, power(libm::exp10(place)))).collect();
    }
    if !log {
        return linear(low, high);
    }
    // Within less than a decade the ticks of a linear axis are the clearer ones.
    linear(libm::exp10(low), libm::exp10(high)).into_iter().map(|(value, text)| (libm::log10(value), text)).collect()
}

fn linear(low: f64, high: f64) -> Vec<(f64, String)> {
    let step = round_step((high - low) / MOST);
    // A tick at an end of the range is not lost to rounding.
    let (first, last) = ((low / step - 1e-9).ceil() as i64, (high / step + 1e-9).floor() as i64);
    let largest = low.abs().max(high.abs());
    // Of numbers that are all large, or all small, the power of ten is written.
    let scientific = !(1e-3..1e5).contains(&largest);
    let exponent = libm::floor(libm::log10(step)) as i32;
    let text = |k: i64| {
        let value = k as f64 * step;
        if k == 0 {
            return "0".into();
        }
        let decimals = |of: i32| (of - exponent).max(0) as usize;
        if !scientific {
            return trimmed(&format!("{value:.0$}", decimals(0)));
        }
        let size = libm::floor(libm::log10(value.abs()) + 1e-9) as i32;
        trimmed(&format!("{value:.0$e}", decimals(size)))
    };
    (first..=last).map(|k| (k as f64 * step, text(k))).collect()
}

/// The logarithms of powers of ten, or of 1, 2 and 5 times these where there are few.
fn decades(low: f64, high: f64) -> Vec<f64> {
    let every = ((high - low) / MOST).ceil().max(1.0) as i64;
    let digits: &[f64] = if high - low > 2.0 { &[1.0] } else { &[1.0, 2.0, 5.0] };
    let powers = (low.floor() as i64..=high.ceil() as i64).filter(|power| power % every == 0);
    let places = powers.flat_map(|power| digits.iter().map(move |digit| power as f64 + libm::log10(*digit)));
    places.filter(|place| (low..=high).contains(place)).collect()
}

/// A tick of a logarithmic axis.
fn power(value: f64) -> String {
    if (1e-3..1e5).contains(&(value * (1.0 + 1e-9))) {
        let decimals = (-libm::floor(libm::log10(value) + 1e-9)).max(0.0) as usize;
        return trimmed(&format!("{value:.decimals$}"));
    }
    trimmed(&format!("{value:.0e}"))
}

/// A number without needless zeros, before its power of ten if it has one.
fn trimmed(text: &str) -> String {
    let (digits, power) = text.find('e').map_or((text, ""), |at| text.split_at(at));
    let short = if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits };
    format!("{short}{power}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(low: f64, high: f64, log: bool) -> Vec<String> {
        ticks((low, high), log).into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn small_and_large_ticks_have_powers_of_ten() {
        assert_eq!(texts(-2.1e-6, 2.1e-6, false), ["-2e-6", "-1e-6", "0", "1e-6", "2e-6"]);
        assert_eq!(texts(0.0, 1.5e-4, false), ["0", "5e-5", "1e-4", "1.5e-4"]);
        assert_eq!(texts(0.0, 3e5, false), ["0", "5e4", "1e5", "1.5e5", "2e5", "2.5e5", "3e5"]);
    }

    #[test]
    fn ticks_are_told_apart_without_needless_digits() {
        assert_eq!(texts(0.0, 2500.0, false), ["0", "500", "1000", "1500", "2000", "2500"]);
        assert_eq!(texts(2.0, 2.00001, false), ["2", "2.000002", "2.000004", "2.000006", "2.000008", "2.00001"]);
        assert_eq!(texts(-0.3, 0.3, false), ["-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"]);
    }

    #[test]
    fn a_logarithmic_axis_has_powers_of_ten() {
        assert_eq!(texts(-4.2, 0.1, true), ["1e-4", "0.001", "0.01", "0.1", "1"]);
        assert_eq!(texts(1.9, 3.1, true), ["100", "200", "500", "1000"]);
        assert_eq!(texts(-14.0, 2.0, true), ["1e-12", "1e-9", "1e-6", "0.001", "1"]);
        assert_eq!(texts(0.0, 0.31, true), ["1", "1.2", "1.4", "1.6", "1.8", "2"]);
    }

    #[test]
    fn no_range_has_more_ticks_than_fit() {
        for k in 0..400 {
            let width = libm::exp10(f64::from(k) * 0.05 - 10.0);
            for low in [-3.0 * width, 0.0, 0.7 * width, 40.0 * width] {
                let found = ticks((low, low + width), false);
                assert!((2..=8).contains(&found.len()), "{low} {width}: {found:?}");
                let mut texts: Vec<&String> = found.iter().map(|tick| &tick.1).collect();
                texts.dedup();
                assert_eq!(texts.len(), found.len(), "{low} {width}: {found:?}");
            }
        }
    }
}
