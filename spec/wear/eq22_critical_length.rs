//! The size that separates plastic from brittle junctions.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 22**, Section 4: critical length scale of a sheared cylindrical junction.
///
/// ```math
/// d^* \approx \frac{32 \gamma G}{\sigma_{m,T}^2}
/// ```
///
/// # Reading
///
/// For silica it is 18.487 nm, which the paper truncates to 18 nm.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `gamma` | $\gamma$ | J/m^2 | > 0 | surface energy |
/// | `g` | $G$ | Pa | > 0 | shear modulus |
/// | `sigma_mt` | $\sigma_{m,T}$ | Pa | > 0 | shear strength |
/// | → `d_star` | $d^*$ | m | | critical length scale |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `of_silica_lies_between_the_two_junctions`
/// * `quarters_for_twice_the_strength`
#[inline(always)]
pub fn critical_length<R: Real>(gamma: R, g: R, sigma_mt: R) -> R {
    R::lit(32.0) * gamma * g / sigma_mt.squared()
}

/// **Section 4**, unnumbered: shear modulus of an isotropic solid.
///
/// ```math
/// G = \frac{E}{2 (1 + \nu)}
/// ```
///
/// # Reading
///
/// Not printed: Eq. 22 uses $G$, Table 5 states $E$ and $\nu$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `e` | $E$ | Pa | > 0 | Young's modulus |
/// | `nu` | $\nu$ | 1 | (-1, 1/2) | Poisson's ratio |
/// | → `g` | $G$ | Pa | | shear modulus |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `half_the_difference_of_the_elastic_constants`
#[inline(always)]
pub fn shear_modulus<R: Real>(e: R, nu: R) -> R {
    e / (R::lit(2.0) * (R::one() + nu))
}

/// **Section 4**, unnumbered: velocity of a pressure wave in a bar, which must far exceed the sliding velocity.
///
/// ```math
/// c = \sqrt{\frac{E}{\rho}}
/// ```
///
/// # Reading
///
/// The paper calls it the velocity in the medium; it is the velocity in a thin bar. In bulk silica it would be 5972
/// m/s.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `e` | $E$ | Pa | > 0 | Young's modulus |
/// | `rho` | $\rho$ | kg/m^3 | > 0 | density |
/// | → `c` | $c$ | m/s | | wave velocity |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `of_silica_is_5760_m_per_s`
#[inline(always)]
pub fn wave_velocity<R: Real>(e: R, rho: R) -> R {
    (e / rho).sqrt()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/eq22_critical_length.rs", "wear-22", ["22"], critical_length),
        equation!("wear/eq22_critical_length.rs", "wear-shear-modulus", [], shear_modulus),
        equation!("wear/eq22_critical_length.rs", "wear-wave-velocity", [], wave_velocity),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::def_elastic_constants::elastic_moduli;
    use approx::{assert_relative_eq, relative_eq};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn quarters_for_twice_the_strength(gamma in 0.1..10.0, g in 0.1..10.0, sigma_mt in 0.1..10.0) {
            prop_assert_eq!(critical_length(gamma, g, 2.0 * sigma_mt), 0.25 * critical_length(gamma, g, sigma_mt));
        }

        #[test]
        fn half_the_difference_of_the_elastic_constants(c11 in 1.0..2.0, c12 in -0.3..0.9) {
            let (nu, e) = elastic_moduli(c11, c12);
            prop_assert!(relative_eq!(shear_modulus(e, nu), 0.5 * (c11 - c12), max_relative = 1e-13));
        }
    }

    #[test]
    fn of_silica_lies_between_the_two_junctions() {
        let d_star = critical_length(1.5, shear_modulus(73e9, 0.17), 9e9);
        assert!(10e-9 < d_star && d_star < 20e-9);
        assert_relative_eq!(d_star, 18.486862930730737e-9, max_relative = 1e-14);
    }

    #[test]
    fn of_silica_is_5760_m_per_s() {
        assert_relative_eq!(wave_velocity(73e9, 2200.0), 5760.4, max_relative = 1e-5);
    }
}
