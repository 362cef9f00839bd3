//! The transfer function of the cantilever.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 30**, Appendix: transfer function from the force to the reading, for a complex frequency.
///
/// ```math
/// \frac{G(s)}{F(s)} = \frac{\omega_0^2}{(\omega_0 + s)^2}
/// ```
///
/// # Reading
///
/// For a cantilever that starts at rest, without deflection. With $\omega_0 / (\omega_0 + s) = x + i y$ the parts are $(x - y)(x + y)$ and $2xy$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `omega_0` | $\omega_0$ | rad/s | > 0 | natural frequency |
/// | `s_re` | $\operatorname{Re} s$ | 1/s | >= 0 | rate of growth |
/// | `s_im` | $\operatorname{Im} s$ | 1/s | any | frequency |
/// | → `h_re` | $\operatorname{Re} G/F$ | 1 | | in phase |
/// | → `h_im` | $\operatorname{Im} G/F$ | 1 | | out of phase |
/// | → `gain` | $\lvert G/F \rvert$ | 1 | | magnitude |
///
/// Rounding: at most 4 ULP.
///
/// # Laws
///
/// * `half_of_a_wave_of_the_natural_frequency_passes_and_lags_by_a_right_angle`
/// * `a_constant_force_is_read_as_it_is`
#[inline(always)]
pub fn transfer_function<R: Real>(omega_0: R, s_re: R, s_im: R) -> (R, R, R) {
    let (re, im) = (omega_0 + s_re, -s_im);
    let square = re.squared() + im.squared();
    let (x, y) = (omega_0 * re / square, omega_0 * im / square);
    ((x - y) * (x + y), R::lit(2.0) * x * y, omega_0.squared() / square)
}

/// **Eq. 32**, Appendix: transfer function of a stiff cantilever.
///
/// ```math
/// \lim_{\omega_0 \to \infty} \frac{\omega_0^2}{(s + \omega_0)^2} = 1
/// ```
///
/// # Reading
///
/// The expression under the limit, Eq. 30 for a real frequency.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `omega_0` | $\omega_0$ | rad/s | > 0 | natural frequency |
/// | `s` | $s$ | 1/s | >= 0 | frequency |
/// | → `h` | $G/F$ | 1 | | transmitted fraction |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `a_stiff_cantilever_preserves_the_input`
#[inline(always)]
pub fn preserved<R: Real>(omega_0: R, s: R) -> R {
    transfer_function(omega_0, s, R::zero()).0
}

/// **Eq. 33**, Appendix: transfer function of a soft cantilever.
///
/// ```math
/// \lim_{\omega_0 \to 0} \frac{\omega_0^2}{(s + \omega_0)^2} = 0
/// ```
///
/// # Reading
///
/// The expression under the limit. It holds for $s \ne 0$ only: a constant force is always read without error.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `omega_0` | $\omega_0$ | rad/s | > 0 | natural frequency |
/// | `s` | $s$ | 1/s | > 0 | frequency |
/// | → `h` | $G/F$ | 1 | | transmitted fraction |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `a_soft_cantilever_attenuates_the_input`
#[inline(always)]
pub fn attenuated<R: Real>(omega_0: R, s: R) -> R {
    transfer_function(omega_0, s, R::zero()).0
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("soot/eq30_transfer.rs", "soot-30", ["30"], transfer_function),
        equation!("soot/eq30_transfer.rs", "soot-32", ["32"], preserved),
        equation!("soot/eq30_transfer.rs", "soot-33", ["33"], attenuated),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn half_of_a_wave_of_the_natural_frequency_passes_and_lags_by_a_right_angle(omega_0 in 0.1..10.0) {
            let (re, im, gain) = transfer_function(omega_0, 0.0, omega_0);
            prop_assert!(re.abs() < 1e-15 && (im + 0.5f64).abs() < 1e-15 && (gain - 0.5).abs() < 1e-15);
        }

        #[test]
        fn a_constant_force_is_read_as_it_is(omega_0 in 0.1..10.0, s in 0.0..10.0, w in -10.0..10.0) {
            prop_assert!((transfer_function(omega_0, 0.0, 0.0).0 - 1.0f64).abs() < 1e-15);
            let (re, im, gain): (f64, f64, f64) = transfer_function(omega_0, s, w);
            prop_assert!((re.hypot(im) - gain).abs() < 1e-15 && gain <= 1.0 + 1e-15);
        }

        #[test]
        fn a_stiff_cantilever_preserves_the_input(s in 0.1..10.0f64) {
            prop_assert!((preserved(1e9 * s, s) - 1.0).abs() < 3e-9);
            prop_assert!(preserved(2.0 * s, s) > preserved(s, s));
        }

        #[test]
        fn a_soft_cantilever_attenuates_the_input(s in 0.1..10.0f64) {
            // it falls with the square of the frequency
            prop_assert!((attenuated(1e-6 * s, s) / 1e-12 - 1.0).abs() < 3e-6);
            prop_assert!(attenuated(1e-9 * s, s) < 1e-17);
            prop_assert!((attenuated(1e-6 * s, s) / attenuated(1e-7 * s, s) - 100.0).abs() < 1e-3);
        }
    }
}
