//! Units as they stand in the tables: products of SI units, such as `kg m^2/s` or `Pa m^0.5`.

/// Exponents of kilogram, metre and second, in quarters, so that square roots of square roots stay exact.
pub type Exponents = [i16; 3];
/// An exponent of one.
pub const WHOLE: i16 = 4;

/// The units that may be written, each coherent with kilogram, metre and second.
const UNITS: [(&str, Exponents); 10] = [
    ("1", [0, 0, 0]),
    ("rad", [0, 0, 0]),
    ("kg", [WHOLE, 0, 0]),
    ("m", [0, WHOLE, 0]),
    ("s", [0, 0, WHOLE]),
    ("Hz", [0, 0, -WHOLE]),
    ("N", [WHOLE, WHOLE, -2 * WHOLE]),
    ("Pa", [WHOLE, -WHOLE, -2 * WHOLE]),
    ("J", [WHOLE, 2 * WHOLE, -2 * WHOLE]),
    ("W", [WHOLE, 2 * WHOLE, -3 * WHOLE]),
];

/// The dimension of a unit. A slash divides by the one factor after it.
///
/// # Errors
///
/// If a factor is no unit, or a slash stands in the wrong place.
pub fn exponents(unit: &str) -> Result<Exponents, String> {
    let wrong = |what: &str| format!("unit `{unit}`: {what}");
    let mut total = [0; 3];
    for (k, part) in unit.split('/').enumerate() {
        let factors: Vec<&str> = part.split_whitespace().collect();
        if factors.is_empty() || k > 0 && factors.len() > 1 {
            return Err(wrong("a slash stands between factors and divides by one"));
        }
        for factor in factors {
            let (name, power) = factor.split_once('^').unwrap_or((factor, "1"));
            let (_, base) = UNITS.iter().find(|(known, _)| *known == name).ok_or_else(|| wrong("not known"))?;
            let power: f64 = power.parse().map_err(|_| wrong("a power is no number"))?;
            let sign = if k > 0 { -1.0 } else { 1.0 };
            for (sum, exponent) in total.iter_mut().zip(base) {
                let quarters = sign * power * f64::from(*exponent);
                if quarters.fract() != 0.0 || quarters.abs() > 100.0 {
                    return Err(wrong("powers are multiples of a quarter"));
                }
                *sum += quarters as i16;
            }
        }
    }
    Ok(total)
}

#[cfg(test)]
mod laws {
    use super::*;

    #[test]
    fn a_unit_is_a_product_of_powers() {
        assert_eq!(exponents("kg m^2/s^2"), exponents("J"));
        assert_eq!(exponents("N/m"), Ok([4, 0, -8]));
        assert_eq!(exponents("1/s"), exponents("Hz"));
        assert_eq!(exponents("Pa m^0.5"), Ok([4, -2, -8]));
        assert_eq!(exponents("J/m^2/s"), exponents("W/m^2"));
    }

    #[test]
    fn what_is_no_unit_is_refused() {
        for unit in ["", "N/", "/s", "N/m s", "nm", "m^", "m^x", "m^0.1", "N m)"] {
            assert!(exponents(unit).is_err(), "{unit} was read");
        }
    }
}
