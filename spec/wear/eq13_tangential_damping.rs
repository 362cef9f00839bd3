//! The tangential damping of a pair.

use crate::equation::Equation;
use crate::wear::eq12_normal_damping::normal_damping;
use crate::{Real, equation};

/// **Eq. 13**, Section 2.2: damping factor of the tangential dashpot.
///
/// ```math
/// c_T = \frac{2 (1 - \eta)}{\pi} \sqrt{k_T m_{\mathrm{eff}}}
/// ```
///
/// # Reading
///
/// Erratum: the formula is Eq. 12 with the tangential stiffness, as if the spheres could not rotate. They can: solid spheres slide with 2/7 of
/// the effective mass, see [`sliding_damping_ratio`]. Used as printed.
///
/// Effect: the damping ratio of sliding is $\sqrt{7/2}$ times as large as wanted.
///
/// Proof: `is_the_damping_ratio_of_the_mass_that_slides`.
///
/// Eq. A.47 repeats it.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `eta` | $\eta$ | 1 | [0, 1] | restitution coefficient wanted |
/// | `k_t` | $k_T$ | N/m | >= 0 | tangential stiffness |
/// | `m_eff` | $m_{\mathrm{eff}}$ | kg | > 0 | effective mass |
/// | → `c_t` | $c_T$ | kg/s | | tangential damping factor |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_to_the_normal_damping_as_the_roots_of_the_stiffnesses`
#[inline(always)]
pub fn tangential_damping<R: Real>(eta: R, k_t: R, m_eff: R) -> R {
    normal_damping(eta, k_t, m_eff)
}

/// **Eq. 13**, unnumbered: the actual damping ratio of two equal solid spheres that slide and rotate.
///
/// ```math
/// \zeta_T = \sqrt{\frac{7}{2}} \, \frac{1 - \eta}{\pi}
/// ```
///
/// # Reading
///
/// The effective mass of a solid sphere at its contact point is 2/7 of its mass: $1/m + r^2/I = 7/(2m)$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `eta` | $\eta$ | 1 | [0, 1] | restitution coefficient wanted |
/// | → `zeta_t` | $\zeta_T$ | 1 | | damping ratio of sliding |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_the_damping_ratio_of_the_mass_that_slides`
#[inline(always)]
pub fn sliding_damping_ratio<R: Real>(eta: R) -> R {
    R::lit(3.5).sqrt() * (R::one() - eta) / R::pi()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/eq13_tangential_damping.rs", "wear-13", ["13"], tangential_damping),
        equation!("wear/eq13_tangential_damping.rs", "wear-sliding-damping", [], sliding_damping_ratio),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::sphere::sliding_mass;
    use crate::wear::def_restitution::damping_ratio_of;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn is_to_the_normal_damping_as_the_roots_of_the_stiffnesses(
            eta in 0.0..0.99, k_n in 0.1..10.0, k_t in 0.0..10.0f64, m_eff in 0.1..10.0,
        ) {
            let ratio = tangential_damping(eta, k_t, m_eff) / normal_damping(eta, k_n, m_eff);
            prop_assert!(relative_eq!(ratio, (k_t / k_n).sqrt(), max_relative = 1e-14));
        }

        #[test]
        fn is_the_damping_ratio_of_the_mass_that_slides(eta in 0.0..0.99, k_t in 0.1..10.0, m_eff in 0.1..10.0) {
            let zeta = damping_ratio_of(tangential_damping(eta, k_t, m_eff), k_t, sliding_mass(m_eff));
            prop_assert!(relative_eq!(zeta, sliding_damping_ratio(eta), max_relative = 1e-14));
        }
    }
}
