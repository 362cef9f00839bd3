//! A prescribed motion: approach, reversal and withdrawal by a hyperbolic tangent.
//!
//! Equations and sections are numbered as in Demidov, Gor & Khalizov 2024.

use crate::equation::Equation;
use crate::real::ln_one_plus;
use crate::{Real, equation};

/// **Eq. 25**, Section 3.1.2: velocity of the tip.
///
/// ```math
/// \dot{z}_{\mathrm{tip}} = 1.5 \tanh\left[10^8 (t - 1.08 \cdot 10^{-8})\right]
/// ```
///
/// # Reading
///
/// Erratum: the prose around the equation says something else, a constant 1.5 m/s and a reversal after 10 ns. The equation is followed: the tip starts with 1.19 m/s, never approaches with
/// a constant velocity, and reverses at 10.8 ns. Its numbers have units: 1.5 m/s, $10^8$ 1/s, $1.08 \cdot 10^{-8}$ s.
///
/// Effect: the tip goes 7.44 nm deep, 0.44 nm into a sphere half a radius below it. By the prose it would go 15 nm deep.
///
/// Proof: `the_tip_comes_slowly_turns_and_leaves`, `the_tip_of_the_paper_goes_7_44_nm_deep`.
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

/// **Section 3.1.2**, unnumbered: displacement of the tip since the start.
///
/// ```math
/// z = \frac{v}{\lambda} \ln \frac{\cosh \lambda (t - t_\mathrm{r})}{\cosh \lambda t_\mathrm{r}}
/// ```
///
/// # Reading
///
/// The integral of Eq. 25. With $p = \lambda |t|$ and $q = \lambda |t - 2 t_\mathrm{r}|$ the logarithm is, up to its sign,
/// $\ln \frac{1 + e^{-p - q}}{e^{-p} + e^{-q}} = \min(p, q) + \ln(1 + e^{-p - q}) - \ln(1 + e^{-|p - q|})$, in which nothing overflows. For a displacement that is short compared with
/// $v/\lambda$ these terms cancel: where the smaller of $p$ and $q$ is below one, it is evaluated as $2 \operatorname{artanh} |h| = \ln(1 + 2|h|/(1 - |h|))$ with
/// $h = \tanh \frac{\lambda t}{2} \tanh \lambda \big(\frac{t}{2} - t_\mathrm{r}\big)$, which has the sign of the displacement.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `t` | $t$ | s | any | time |
/// | `v_tip` | $v$ | m/s | > 0 | final velocity, 1.5 m/s |
/// | `rate` | $\lambda$ | 1/s | > 0 | rate of the turn, $10^8$ 1/s |
/// | `t_reversal` | $t_\mathrm{r}$ | s | >= 0 | time of the turn, $1.08 \cdot 10^{-8}$ s |
/// | → `z` | $z$ | m | | displacement, negative downwards |
///
/// Rounding: at most 1.5 ULP.
///
/// # Laws
///
/// * `the_velocity_is_the_rate_of_the_way`
/// * `the_tip_of_the_paper_goes_7_44_nm_deep`
/// * `is_the_printed_way`
/// * `a_short_way_keeps_the_digits_that_the_difference_of_two_logarithms_loses`
/// * `the_way_keeps_its_digits_where_the_tip_is_back`
#[inline(always)]
pub fn tip_way<R: Real>(t: R, v_tip: R, rate: R, t_reversal: R) -> R {
    let (half, one, two) = (R::lit(0.5), R::one(), R::lit(2.0));
    let (a, b) = (half * rate * t, rate * (half * t - t_reversal));
    let h = a.tanh() * b.tanh();
    let (p, q) = (two * a.abs(), two * b.abs());
    // held where it is used, so that the form that is not used stays finite
    let near = h.abs().min(half);
    let short = ln_one_plus(two * near / (one - near));
    let long = p.min(q) + ln_one_plus((-(p + q)).exp()) - ln_one_plus((-(p - q).abs()).exp());
    let ln_ratio = R::select(p.min(q).lt(one), short, long);
    v_tip / rate * R::select(h.lt(R::zero()), -ln_ratio, ln_ratio)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/approach.rs", "soot-25", ["25"], tip_velocity),
        equation!("mechanics/approach.rs", "soot-25-way", [], tip_way),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::{Dual, Reference};
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

        #[test]
        fn is_the_printed_way(log_t in -6.0..1.5f64, side in prop_oneof![Just(1.0), Just(-1.0)], v_tip in 0.1..3.0, rate in 0.1..3.0, t_reversal in 0.0..10.0) {
            let [t, v, l, r] = [side * 10f64.powf(log_t), v_tip, rate, t_reversal].map(Reference::exact);
            let cosh = |x: Reference| (x.exp() + (-x).exp()) / Reference::exact(2.0);
            let printed = v / l * (cosh(l * (t - r)) / cosh(l * r)).ln();
            prop_assert!(((tip_way(t, v, l, r) - printed) / printed).abs().to_f64() < 1e-33);
        }
    }

    #[test]
    fn the_way_keeps_its_digits_where_the_tip_is_back() {
        // at twice the time of reversal, and a little before and after
        for beyond in [-1e-3, -1e-9, -1e-14, 1e-12, 1e-6, 0.1] {
            let (t, v, l, r) = (4.0 + beyond, 1.5, 1.0, 2.0);
            let exact = tip_way(Reference::exact(t), Reference::exact(v), Reference::exact(l), Reference::exact(r));
            assert!((tip_way(t, v, l, r) / exact.to_f64() - 1.0).abs() < 1e-14, "{beyond}");
        }
        assert_eq!(tip_way(4.0, 1.5, 1.0, 2.0), 0.0);
    }

    #[test]
    fn the_tip_of_the_paper_goes_7_44_nm_deep() {
        let way = |t| tip_way(t, 1.5, 1e8, 1.08e-8);
        assert!((way(1.08e-8) + 7.43998e-9f64).abs() < 1e-14);
        assert!((way(5e-7) - 715.96e-9f64).abs() < 1e-11);
        assert!((tip_velocity(0.0, 1.5, 1e8, 1.08e-8) + 1.18979864562f64).abs() < 1e-11);
    }

    #[test]
    fn a_short_way_keeps_the_digits_that_the_difference_of_two_logarithms_loses() {
        // from a tenth of the time step of the paper to beyond where the two forms meet
        let (v, l, r) = (1.5, 1e8, 1.08e-8);
        let exact = |t: f64| {
            let [t, v, l, r] = [t, v, l, r].map(Reference::exact);
            tip_way(t, v, l, r).to_f64()
        };
        for k in 0..700 {
            let t = 5e-15 * 10f64.powf(f64::from(k) / 100.0);
            assert!((tip_way(t, v, l, r) / exact(t) - 1.0).abs() < 2e-15, "{t}");
        }
        let ln_two_cosh = |x: f64| x.abs() + ln_one_plus(Real::exp(-2.0 * x.abs()));
        let difference = |t| v / l * (ln_two_cosh(l * (t - r)) - ln_two_cosh(l * r));
        assert!((difference(5e-14) / exact(5e-14) - 1.0).abs() > 1e-13);
    }
}
