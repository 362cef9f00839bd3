//! From stress and strain to the stiffness of the springs.

use super::eq07_normal_stiffness::normal_stiffness;
use super::eq08_tangential_stiffness::tangential_stiffness;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.24**, Appendix A.2: the stiffness from the force.
///
/// ```math
/// k_N = \frac{F_N}{\delta_N}
/// ```
///
/// # Reading
///
/// As printed; valid in the elastic range, except at zero separation.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `f_n` | $F_N$ | N | any | normal force, positive when it attracts |
/// | `delta_n` | $\delta_N$ | m | any | separation of the surfaces, not zero |
/// | → `k_n` | $k_N$ | N/m | | normal stiffness |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_three_lines_are_one_stiffness`
#[inline(always)]
pub fn stiffness_of_force<R: Real>(f_n: R, delta_n: R) -> R {
    f_n / delta_n
}

/// **Eq. A.25**, Appendix A.2: the stiffness from stress and strain.
///
/// ```math
/// k_N = \frac{A_N \sigma_N}{(r_i + r_j)\, \varepsilon_N}
/// ```
///
/// # Reading
///
/// As printed: A.20 and A.22 substituted into A.24. The next line, A.26, substitutes Hooke's law A.23 and is Eq. 7; A.27
/// is Eq. 8. The tangential stiffness also contains Young's modulus, not the shear modulus: A.65 compensates for this.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `a_n` | $A_N$ | m^2 | > 0 | cross section in the normal direction |
/// | `sigma_n` | $\sigma_N$ | Pa | any | normal stress |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | `epsilon_n` | $\varepsilon_N$ | 1 | any | normal strain, not zero |
/// | → `k_n` | $k_N$ | N/m | | normal stiffness |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_three_lines_are_one_stiffness`
#[inline(always)]
pub fn stiffness_of_stress<R: Real>(a_n: R, sigma_n: R, r_i: R, r_j: R, epsilon_n: R) -> R {
    a_n * sigma_n / ((r_i + r_j) * epsilon_n)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a24_stiffness.rs", "wear-A24", ["A24"], stiffness_of_force),
        equation!("wear/a24_stiffness.rs", "wear-A25", ["A25"], stiffness_of_stress),
        equation!("wear/eq07_normal_stiffness.rs", "wear-A26", ["A26"], normal_stiffness),
        equation!("wear/eq08_tangential_stiffness.rs", "wear-A27", ["A27"], tangential_stiffness),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::a20_stress::{elastic_stress, normal_strain};
    use crate::wear::eq03_normal_force::normal_force;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_three_lines_are_one_stiffness(
            (e, a_n) in (0.1..10.0, 0.1..10.0), (r_i, r_j) in (0.1..10.0, 0.1..10.0), delta in 0.01..0.1,
        ) {
            let k_n = normal_stiffness(a_n, e, r_i, r_j);
            let epsilon = normal_strain(delta, r_i, r_j);
            let from_stress = stiffness_of_stress(a_n, elastic_stress(e, epsilon), r_i, r_j, epsilon);
            let from_force = stiffness_of_force(normal_force(k_n, 0.2, 0.3, delta), delta);
            assert_relative_eq!(from_stress, k_n, epsilon = 0.0, max_relative = 8.0 * f64::EPSILON);
            assert_relative_eq!(from_force, k_n, epsilon = 0.0, max_relative = 8.0 * f64::EPSILON);
        }
    }
}
