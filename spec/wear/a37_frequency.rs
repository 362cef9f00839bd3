//! The frequency of a pair.

use super::a19_critical_damping::critical_pair_damping;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.37**, Appendix A.2: frequency of a damped pair.
///
/// ```math
/// \omega = \sqrt{\frac{k_N}{m_{\text{eff}}}} \sqrt{1 - \frac{c_N^2}{4 k_N m_{\text{eff}}}}
/// ```
///
/// # Reading
///
/// Erratum: the paper calls it the natural frequency; it is the damped one, with which A.35 is exact.
///
/// Effect: none on what follows, which uses the damped frequency. The natural one is larger by $1 / \sqrt{1 - (c_N / c_c)^2}$.
///
/// Proof: `zero_at_critical_damping_and_only_there`, `undamped_it_is_the_natural_frequency`.
///
/// With
/// $c_c = 2 \sqrt{k_N m_{\text{eff}}}$ it is $\sqrt{(c_c - c_N)(c_c + c_N)} / 2 m_{\text{eff}}$, which is evaluated because
/// the printed difference suffers from cancellation close to critical damping. Beyond critical damping the frequency is
/// imaginary and the motion a sum of two decays; the function then returns the magnitude, the deviation of their rates from
/// the mean rate.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `c_n` | $c_N$ | kg/s | >= 0 | normal damping |
/// | → `omega` | $\omega$ | rad/s | | damped frequency |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_the_printed_frequency`
/// * `zero_at_critical_damping_and_only_there`
/// * `undamped_it_is_the_natural_frequency`
#[inline(always)]
pub fn damped_frequency<R: Real>(k_n: R, m_eff: R, c_n: R) -> R {
    let c_c = critical_pair_damping(k_n, m_eff);
    ((c_c - c_n) * (c_c + c_n)).abs().sqrt() / (R::lit(2.0) * m_eff)
}

/// **Eq. A.38**, Appendix A.2: frequency of an undamped pair.
///
/// ```math
/// \omega \approx \sqrt{\frac{k_N}{m_{\text{eff}}}}
/// ```
///
/// # Reading
///
/// This is the natural frequency; as an approximation of A.37 it is too large by half the square of the damping ratio.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | → `omega_0` | $\omega_0$ | rad/s | | natural frequency |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `undamped_it_is_the_natural_frequency`
/// * `too_large_by_half_the_square_of_the_damping_ratio`
#[inline(always)]
pub fn natural_frequency<R: Real>(k_n: R, m_eff: R) -> R {
    (k_n / m_eff).sqrt()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a37_frequency.rs", "wear-A37", ["A37"], damped_frequency),
        equation!("wear/a37_frequency.rs", "wear-A38", ["A38"], natural_frequency),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    const ROUNDING: f64 = 8.0 * f64::EPSILON;

    proptest! {
        #[test]
        fn is_the_printed_frequency((k, m) in (0.1f64..10.0, 0.1f64..10.0), zeta in 0.0f64..0.9) {
            let c = zeta * critical_pair_damping(k, m);
            let printed = (k / m).sqrt() * (1.0 - c * c / (4.0 * k * m)).sqrt();
            assert_relative_eq!(damped_frequency(k, m, c), printed, epsilon = 0.0, max_relative = 2.0 * ROUNDING);
        }

        #[test]
        fn zero_at_critical_damping_and_only_there((k, m) in (0.1..10.0, 0.1..10.0)) {
            let c_c: f64 = critical_pair_damping(k, m);
            prop_assert_eq!(damped_frequency(k, m, c_c), 0.0);
            prop_assert!(damped_frequency(k, m, c_c.next_down()) > 0.0);
            prop_assert!(damped_frequency(k, m, c_c.next_up()) > 0.0);
        }

        #[test]
        fn undamped_it_is_the_natural_frequency((k, m) in (0.1..10.0, 0.1..10.0)) {
            let damped = damped_frequency(k, m, 0.0);
            assert_relative_eq!(damped, natural_frequency(k, m), epsilon = 0.0, max_relative = ROUNDING);
        }

        #[test]
        fn too_large_by_half_the_square_of_the_damping_ratio((k, m) in (0.1..10.0, 0.1..10.0), zeta in 0.001f64..0.1) {
            let damped = damped_frequency(k, m, zeta * critical_pair_damping(k, m));
            let excess: f64 = natural_frequency(k, m) / damped - 1.0;
            // The next term of the series is 3/8 zeta^4.
            prop_assert!((excess - 0.5 * zeta * zeta).abs() < 0.4 * zeta.powi(4) + ROUNDING);
        }
    }
}
