//! The coefficient of the normal damping.

use crate::equation::Equation;
use crate::{Real, equation};

/// The damping constants in use, N s/m³: the paper's and the authors' program's.
pub const GAMMA_0: (f64, f64) = (0.5e6, 5e6);

/// The radii of which the damping coefficient takes the effective one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DampingRadius {
    /// Those of the bare particles.
    Bare,
    /// Those of the contact spheres, as in the authors' program.
    Contact,
}

/// **Eq. 7**, Section 2.2: damping coefficient of a pair.
///
/// ```math
/// \gamma_n = 0.5 \cdot 10^6 \, \text{Ns/m}^3 \cdot R^{*2}
/// ```
///
/// # Reading
///
/// The constant is an argument, because two are in use: 0.5e6 N s/m³ in the paper and 5e6 N s/m³ in the authors' program. Linearised about
/// equilibrium the former gives a damping ratio of 0.04, the latter 0.4 and with it the quick approach to
/// equilibrium that Fig. 3 shows. The paper's is the default. The program takes $R^*$ of the contact spheres instead of the bare ones.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_star` | $R^*$ | m | > 0 | effective radius |
/// | `gamma_0` | $\gamma_0$ | N s/m^3 | >= 0 | damping constant, 0.5e6 N s/m³ |
/// | → `gamma_n` | $\gamma_n$ | kg/s | | damping coefficient |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_quadratic_in_the_effective_radius`
/// * `is_8e12_and_32e12_kilogram_per_second_for_4_and_8_nanometre`
#[inline(always)]
pub fn damping_coefficient<R: Real>(r_star: R, gamma_0: R) -> R {
    gamma_0 * r_star.squared()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("titania/eq07_damping_coefficient.rs", "titania-7", ["7"], damping_coefficient)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn is_quadratic_in_the_effective_radius(r_star in 0.1..10.0, factor in 0.1..10.0) {
            let grown = damping_coefficient(factor * r_star, 0.5);
            prop_assert!(relative_eq!(grown, factor * factor * damping_coefficient(r_star, 0.5), max_relative = 1e-14));
        }
    }

    #[test]
    fn is_8e12_and_32e12_kilogram_per_second_for_4_and_8_nanometre() {
        assert!(relative_eq!(damping_coefficient(4e-9, 0.5e6), 8e-12, max_relative = 1e-15));
        assert!(relative_eq!(damping_coefficient(8e-9, 0.5e6), 3.2e-11, max_relative = 1e-15));
    }
}
