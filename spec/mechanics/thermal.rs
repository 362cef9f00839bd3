//! The energy of thermal motion.

use crate::equation::Equation;
use crate::{Real, equation};

/// Energy of thermal motion: the Boltzmann constant times a temperature.
///
/// ```math
/// k_B T
/// ```
///
/// # Reading
///
/// The Boltzmann constant is exactly $1.380649 \times 10^{-23}$ J/K. The tables have no unit of temperature: it is the number of kelvins.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_b` | $k_B$ | J | > 0 | Boltzmann constant, per kelvin |
/// | `t` | $T$ | 1 | > 0 | temperature in kelvin |
/// | → `kt` | $k_B T$ | J |  | energy |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `at_room_temperature_it_is_four_zeptojoule`
#[inline(always)]
pub fn thermal_energy<R: Real>(k_b: R, t: R) -> R {
    k_b * t
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![equation!("mechanics/thermal.rs", "mechanics-thermal-energy", [], thermal_energy)]
}

#[cfg(test)]
mod laws {
    use super::*;

    #[test]
    fn at_room_temperature_it_is_four_zeptojoule() {
        assert!((thermal_energy(1.380649e-23, 293.15) / 4.0474e-21 - 1.0).abs() < 1e-4);
    }
}
