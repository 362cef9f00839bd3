//! The motion of the tip of the force microscope.

use super::eq23_capillary::ln_one_plus;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 25**, Section 3.1.2: velocity of the tip.
///
/// ```math
/// \dot{z}_{\mathrm{tip}} = 1.5 \tanh\left[10^8 (t - 1.08 \cdot 10^{-8})\right]
/// ```
///
/// # Reading
///
/// The numbers have units: 1.5 m/s, $10^8$ 1/s, $1.08 \cdot 10^{-8}$ s. The equation is followed, not the prose around it: the tip starts with 1.19 m/s, never approaches with
/// a constant 1.5 m/s, and turns round at 10.8 ns, not at 10.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `t` | $t$ | s | any | time |
/// | `v_tip` | $v$ | m/s | > 0 | final velocity, 1.5 m/s |
/// | `rate` | $\lambda$ | 1/s | > 0 | rate of the turn, $10^8$ 1/s |
/// | `t_reversal` | $t_\mathrm{r}$ | s | >= 0 | time of the turn, $1.08 \cdot 10^{-8}$ s |
/// | → `v` | $\dot{z}_{\mathrm{tip}}$ | m/s | | velocity, negative downwards |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_tip_comes_slowly_turns_and_leaves`
#[inline(always)]
pub fn tip_velocity<R: Real>(t: R, v_tip: R, rate: R, t_reversal: R) -> R {
    v_tip * (rate * (t - t_reversal)).tanh()
}

/// **Section 3.1.2**, unnumbered: way of the tip since the start.
///
/// ```math
/// z = \frac{v}{\lambda} \ln \frac{\cosh \lambda (t - t_\mathrm{r})}{\cosh \lambda t_\mathrm{r}}
/// ```
///
/// # Reading
///
/// The integral of Eq. 25. Evaluated with $\ln \cosh x = |x| + \ln(1 + e^{-2|x|}) - \ln 2$, in which nothing overflows. For a way that is short compared
/// with $v/\lambda$ the two terms cancel.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `t` | $t$ | s | any | time |
/// | `v_tip` | $v$ | m/s | > 0 | final velocity, 1.5 m/s |
/// | `rate` | $\lambda$ | 1/s | > 0 | rate of the turn, $10^8$ 1/s |
/// | `t_reversal` | $t_\mathrm{r}$ | s | >= 0 | time of the turn, $1.08 \cdot 10^{-8}$ s |
/// | → `z` | $z$ | m | | way, negative downwards |
///
/// Rounding: at most 130 ULP.
///
/// # Laws
///
/// * `the_velocity_is_the_rate_of_the_way`
/// * `the_tip_of_the_paper_goes_7_44_nm_deep`
#[inline(always)]
pub fn tip_way<R: Real>(t: R, v_tip: R, rate: R, t_reversal: R) -> R {
    let ln_two_cosh = |x: R| x.abs() + ln_one_plus((-(R::lit(2.0) * x.abs())).exp());
    v_tip / rate * (ln_two_cosh(rate * (t - t_reversal)) - ln_two_cosh(rate * t_reversal))
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("soot/eq25_tip.rs", "soot-25", ["25"], tip_velocity),
        equation!("soot/eq25_tip.rs", "soot-25-way", [], tip_way),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::Dual;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_tip_comes_slowly_turns_and_leaves(v_tip in 0.1..3.0, t_reversal in 0.1..3.0, later in 0.1..3.0) {
            let velocity = |t| tip_velocity(t, v_tip, 1.0, t_reversal);
            prop_assert!(velocity(0.0) < 0.0 && velocity(0.0) > -v_tip);
            prop_assert_eq!(velocity(t_reversal), 0.0);
            prop_assert!((velocity(t_reversal + later) + velocity(t_reversal - later)).abs() < 1e-14);
            prop_assert!((velocity(t_reversal + 40.0) - v_tip).abs() < 1e-15);
        }

        #[test]
        fn the_velocity_is_the_rate_of_the_way(t in 0.0..5.0f64, v_tip in 0.1..3.0f64, rate in 0.1..3.0f64, t_reversal in 0.1..3.0f64) {
            prop_assume!((t - t_reversal).abs() > 1e-3);
            let [v, l, r] = [v_tip, rate, t_reversal].map(Dual::constant);
            let slope = tip_way(Dual::variable(t), v, l, r).slope;
            prop_assert!((tip_velocity(t, v_tip, rate, t_reversal) - slope).abs() < 1e-12);
            prop_assert_eq!(tip_way(0.0, v_tip, rate, t_reversal), 0.0);
        }
    }

    #[test]
    fn the_tip_of_the_paper_goes_7_44_nm_deep() {
        let way = |t| tip_way(t, 1.5, 1e8, 1.08e-8);
        assert!((way(1.08e-8) + 7.43998e-9f64).abs() < 1e-14);
        assert!((way(5e-7) - 715.96e-9f64).abs() < 1e-11);
        assert!((tip_velocity(0.0, 1.5, 1e8, 1.08e-8) + 1.18979864562f64).abs() < 1e-11);
    }
}
