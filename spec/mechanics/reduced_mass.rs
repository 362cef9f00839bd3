//! The mass that oscillates in a pair.
//!
//! Equations and sections are numbered as in Pham-Ba & Molinari 2022.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 17**, Section 2.2: effective mass of two particles that oscillate against each other.
///
/// ```math
/// m_{\mathrm{eff}} = \frac{m_i m_j}{m_i + m_j}
/// ```
///
/// # Reading
///
/// As printed; Eq. A.3 repeats it.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m_i` | $m_i$ | kg | > 0 | mass of i |
/// | `m_j` | $m_j$ | kg | > 0 | mass of j |
/// | → `m_eff` | $m_{\mathrm{eff}}$ | kg | | effective mass |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `swapping_the_particles_changes_nothing`
/// * `half_the_mass_of_equal_particles`
/// * `below_either_mass_and_that_of_the_lighter_one_against_a_wall`
#[inline(always)]
pub fn effective_mass<R: Real>(m_i: R, m_j: R) -> R {
    m_i * m_j / (m_i + m_j)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![equation!("mechanics/reduced_mass.rs", "wear-17", ["17"], effective_mass)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn swapping_the_particles_changes_nothing(m_i in 0.1..10.0, m_j in 0.1..10.0) {
            prop_assert_eq!(effective_mass(m_i, m_j), effective_mass(m_j, m_i));
        }

        #[test]
        fn half_the_mass_of_equal_particles(m in 0.1..10.0) {
            prop_assert!(relative_eq!(effective_mass(m, m), 0.5 * m));
        }

        #[test]
        fn below_either_mass_and_that_of_the_lighter_one_against_a_wall(m_i in 0.1..10.0, m_j in 0.1..10.0f64) {
            prop_assert!(effective_mass(m_i, m_j) < m_i.min(m_j));
            prop_assert!(relative_eq!(effective_mass(m_i, 1e20), m_i));
        }
    }
}
