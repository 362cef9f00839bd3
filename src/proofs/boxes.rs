//! The boxes over which claims are proved: a finite range of every argument, from the domain in its table.

use veridem_spec::document::{Document, Domain, Quantity};
use veridem_spec::numbers::Interval;
use veridem_spec::unit::exponents;

/// Which magnitudes the arguments have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// From 1/8 to 8 in any coherent units: a change of units by powers of sixteen changes no digit of any result.
    One,
    /// In SI, from the smallest to the largest that occur for particles of nanometres to micrometres.
    Si,
}

/// The magnitudes in SI, by unit.
const MAGNITUDES: [(&str, [f64; 2]); 20] = [
    ("1", [0.125, 8.0]),
    ("m", [1e-10, 1e-5]),
    ("m^2", [1e-20, 1e-10]),
    ("m^3", [1e-30, 1e-15]),
    ("kg", [1e-24, 1e-12]),
    ("kg/m^3", [1e2, 1e4]),
    ("kg m^2", [1e-44, 1e-22]),
    ("s", [1e-15, 1e-3]),
    ("1/s", [1e3, 1e13]),
    ("m/s", [1e-6, 1e3]),
    ("m/s^2", [1e-3, 1e12]),
    ("N", [1e-13, 1e-3]),
    ("N m", [1e-22, 1e-9]),
    ("Pa", [1e5, 1e12]),
    ("N/m", [1e-3, 1e6]),
    ("kg/s", [1e-15, 1e-3]),
    ("N/s", [1e-3, 1e9]),
    ("1/m", [1e5, 1e10]),
    ("W/m^2", [1e-3, 1e9]),
    ("Pa m^0.5", [1e3, 1e7]),
];

impl Scale {
    /// Both.
    pub const ALL: [Self; 2] = [Self::One, Self::Si];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::One => "order one",
            Self::Si => "SI",
        }
    }
    /// The smallest and largest size of a number of this quantity; products of powers of nanometre, nanosecond and attogram,
    /// a thousand times smaller or larger, for a unit that is in no list.
    fn magnitudes(self, quantity: &Quantity) -> [f64; 2] {
        let listed = || MAGNITUDES.iter().find(|(unit, _)| exponents(unit) == Ok(quantity.exponents)).map(|row| row.1);
        let engine = || {
            let [kg, m, s] = quantity.exponents.map(|quarters| f64::from(quarters) / 4.0);
            let unit = 10f64.powf(-21.0 * kg - 9.0 * m - 9.0 * s);
            [1e-3 * unit, 1e3 * unit]
        };
        match self {
            Self::One => [0.125, 8.0],
            Self::Si => listed().unwrap_or_else(engine),
        }
    }
}

/// Part of a bounded domain that is left out at a bound that does not belong to it.
const MARGIN: f64 = 1.0 / 1024.0;
/// Widest interval that is taken whole.
const WIDE: f64 = 100.0;

/// The range of a number of a quantity.
pub fn range(quantity: &Quantity, scale: Scale) -> Interval {
    let [small, large] = scale.magnitudes(quantity);
    match quantity.domain {
        Domain::Unit => Interval::new(-1.0, 1.0),
        Domain::Between { lo, hi, with_lo, with_hi } if hi - lo <= WIDE => {
            let margin = MARGIN * (hi - lo);
            Interval::new(if with_lo { lo } else { lo + margin }, if with_hi { hi } else { hi - margin })
        }
        Domain::Between { lo, with_lo, .. } if lo.is_finite() => {
            Interval::new(if with_lo { lo } else { lo + small }, lo + large)
        }
        Domain::Between { hi, with_hi, .. } if hi.is_finite() => {
            Interval::new(hi - large, if with_hi { hi } else { hi - small })
        }
        Domain::Between { .. } => Interval::new(-large, large),
    }
}

/// The box of an equation: the ranges of its arguments, laid end to end.
pub fn whole(document: &Document, scale: Scale) -> Vec<Interval> {
    let ranges = |quantity: &Quantity| std::iter::repeat_n(range(quantity, scale), quantity.size);
    document.arguments.iter().flat_map(ranges).collect()
}
