//! The largest stable time step of two particles on a spring.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 6**, Section 2.1: critical time step of two equal particles in the elastic range.
///
/// ```math
/// \Delta t_c = \sqrt{\frac{2m}{k_N}}
/// ```
///
/// # Reading
///
/// Erratum: a simulation does not remain stable at this time step. Exactly there the motion grows linearly; and for a damped pair
/// ([`damped_limit`](super::def_stable_step::damped_limit)) or one that slides and turns
/// ([`sliding_limit`](super::def_stable_step::sliding_limit)) the limit is lower.
/// This is the time step the paper calls critical, to take fractions of; the pair law offers the smallest of the three as limit.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m` | $m$ | kg | > 0 | mass of either particle |
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | → `dt_c` | $\Delta t_c$ | s | | critical time step |
///
/// # Laws
///
/// * `is_twice_the_inverse_frequency_of_the_pair`
#[inline(always)]
pub fn critical_time_step<R: Real>(m: R, k_n: R) -> R {
    (R::lit(2.0) * m / k_n).sqrt()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq06_critical_time_step.rs", "wear-6", ["6"], critical_time_step)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::eq17_effective_mass::effective_mass;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn is_twice_the_inverse_frequency_of_the_pair(m in 0.1..10.0, k_n in 0.1..10.0f64) {
            let frequency = f64::sqrt(k_n / effective_mass(m, m));
            prop_assert!(relative_eq!(critical_time_step(m, k_n) * frequency, 2.0, max_relative = 1e-14));
        }
    }
}
