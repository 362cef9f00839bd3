//! The largest stable time step of an oscillator.
//!
//! Equations and sections are numbered as in Pham-Ba & Molinari 2022.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Appendix A.1**, unnumbered: largest stable time step of a mass on a spring and a dashpot.
///
/// ```math
/// \Delta t_{\max} = \frac{2}{\sqrt{k/m + (c/2m)^2} + c/2m}
/// ```
///
/// # Reading
///
/// For the symplectic Euler method, whose dashpot acts with the old velocity. With $m = m_{\mathrm{eff}}$ it is
/// $\Delta t_c (\sqrt{1 + \zeta^2} - \zeta)$, with $\tfrac{2}{7} m_{\mathrm{eff}}$ and the tangential spring it is the limit of sliding.
/// Written so that a missing spring or dashpot needs no exception.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m` | $m$ | kg | > 0 | mass |
/// | `k` | $k$ | N/m | >= 0 | stiffness |
/// | `c` | $c$ | kg/s | >= 0 | damping factor |
/// | → `dt_max` | $\Delta t_{\max}$ | s | | largest stable time step |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `there_the_spectral_radius_of_the_step_crosses_one`
#[inline(always)]
pub fn stable_time_step<R: Real>(m: R, k: R, c: R) -> R {
    let rate = R::lit(0.5) * c / m;
    R::lit(2.0) / ((k / m + rate.squared()).sqrt() + rate)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![equation!("mechanics/stable_step.rs", "wear-dtlim", [], stable_time_step)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::amplification::spectral_radius;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn there_the_spectral_radius_of_the_step_crosses_one(m in 0.1..10.0, k in 0.1..10.0, c in 0.0..10.0) {
            let dt = stable_time_step(m, k, c);
            prop_assert!(spectral_radius(m, k, c, 0.999 * dt) <= 1.0 + 1e-10);
            prop_assert!(spectral_radius(m, k, c, 1.001 * dt) > 1.0 + 1e-4);
        }
    }
}
