//! Forces and separations of one pair as stresses and strains.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.20**, Appendix A.2: normal stress of a pair.
///
/// ```math
/// \sigma_N = \frac{F_N}{A_N}
/// ```
///
/// # Reading
///
/// As printed. The cross section follows from A.64.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `f_n` | $F_N$ | N | any | normal force, positive when it attracts |
/// | `a_n` | $A_N$ | m^2 | > 0 | cross section in the normal direction |
/// | → `sigma_n` | $\sigma_N$ | Pa | | normal stress, positive in tension |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `stress_times_cross_section_is_the_force`
#[inline(always)]
pub fn normal_stress<R: Real>(f_n: R, a_n: R) -> R {
    f_n / a_n
}

/// **Eq. A.21**, Appendix A.2: tangential stress of a pair.
///
/// ```math
/// \sigma_T = \frac{F_T}{A_T}
/// ```
///
/// # Reading
///
/// As printed. The cross section vanishes at a Poisson's ratio of 1/4.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `f_t` | $F_T$ | N | any | tangential force |
/// | `a_t` | $A_T$ | m^2 | > 0 | cross section in the tangential direction |
/// | → `sigma_t` | $\sigma_T$ | Pa | | tangential stress |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `stress_times_cross_section_is_the_force`
#[inline(always)]
pub fn tangential_stress<R: Real>(f_t: R, a_t: R) -> R {
    f_t / a_t
}

/// **Eq. A.22**, Appendix A.2: normal strain of a pair.
///
/// ```math
/// \varepsilon_N = \frac{\delta_N}{r_i + r_j}
/// ```
///
/// # Reading
///
/// As printed: the spheres are at rest when they just touch.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `delta_n` | $\delta_N$ | m | any | separation of the surfaces, negative for an overlap |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | → `epsilon_n` | $\varepsilon_N$ | 1 | | normal strain, positive in tension |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `does_not_depend_on_the_scale`
/// * `is_the_stress_of_the_elastic_force`
#[inline(always)]
pub fn normal_strain<R: Real>(delta_n: R, r_i: R, r_j: R) -> R {
    delta_n / (r_i + r_j)
}

/// **Eq. A.23**, Appendix A.2: Hooke's law of a pair.
///
/// ```math
/// \sigma_N = E \varepsilon_N
/// ```
///
/// # Reading
///
/// As printed; valid in the elastic range.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `e` | $E$ | Pa | > 0 | Young's modulus |
/// | `epsilon_n` | $\varepsilon_N$ | 1 | any | normal strain |
/// | → `sigma_n` | $\sigma_N$ | Pa | | normal stress |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_the_stress_of_the_elastic_force`
#[inline(always)]
pub fn elastic_stress<R: Real>(e: R, epsilon_n: R) -> R {
    e * epsilon_n
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a20_stress.rs", "wear-A20", ["A20"], normal_stress),
        equation!("wear/a20_stress.rs", "wear-A21", ["A21"], tangential_stress),
        equation!("wear/a20_stress.rs", "wear-A22", ["A22"], normal_strain),
        equation!("wear/a20_stress.rs", "wear-A23", ["A23"], elastic_stress),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::eq03_normal_force::normal_force;
    use crate::wear::eq07_normal_stiffness::normal_stiffness;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    const ROUNDING: f64 = 8.0 * f64::EPSILON;

    proptest! {
        #[test]
        fn stress_times_cross_section_is_the_force(force in -1.0..1.0, area in 0.1..10.0) {
            assert_relative_eq!(normal_stress(force, area) * area, force, epsilon = 0.0, max_relative = ROUNDING);
            assert_relative_eq!(tangential_stress(force, area) * area, force, epsilon = 0.0, max_relative = ROUNDING);
        }

        #[test]
        fn does_not_depend_on_the_scale(delta in -0.1..0.1, (r_i, r_j) in (0.1..10.0, 0.1..10.0)) {
            prop_assert_eq!(normal_strain(8.0 * delta, 8.0 * r_i, 8.0 * r_j), normal_strain(delta, r_i, r_j));
        }

        #[test]
        fn is_the_stress_of_the_elastic_force(
            (e, a_n) in (0.1..10.0, 0.1..10.0), (r_i, r_j) in (0.1..10.0, 0.1..10.0), delta in -0.1..0.1,
        ) {
            let force = normal_force(normal_stiffness(a_n, e, r_i, r_j), 0.2, 0.3, delta);
            assert_relative_eq!(
                elastic_stress(e, normal_strain(delta, r_i, r_j)),
                normal_stress(force, a_n),
                epsilon = 0.0,
                max_relative = ROUNDING
            );
        }
    }
}
