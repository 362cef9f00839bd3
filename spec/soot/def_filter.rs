//! The reading of the cantilever in time, and its exact update for sampled forces.

use crate::equation::Equation;
use crate::{Real, equation};

/// Below this number of periods over $2\pi$ the series of [`settled`] are used.
const SHORT: f64 = 2.0;
/// Terms of the series: with them the remainder is below one part in $10^{36}$.
const TERMS: i32 = 42;

/// **Appendix**, Eq. 30 in time, unnumbered: readings of an impulse, a step and a ramp of the force.
///
/// ```math
/// \omega_0^2 t e^{-\omega_0 t}, \quad 1 - (1 + \omega_0 t) e^{-\omega_0 t}, \quad
/// t - \frac{2}{\omega_0} + \left(t + \frac{2}{\omega_0}\right) e^{-\omega_0 t}
/// ```
///
/// # Reading
///
/// Of the unit impulse, the unit step, and $f = t$. Soon after the start the terms cancel: with $y = \omega_0 t$ below two, step and ramp are the series
/// $e^{-y} \sum_{n \ge 2} y^n / n!$ and $t e^{-y} \sum_{n \ge 3} (n - 2) y^{n-1} / n!$ of positive terms.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `omega_0` | $\omega_0$ | rad/s | > 0 | natural frequency |
/// | `t` | $t$ | s | >= 0 | time |
/// | → `impulse` | | 1/s | | reading of a unit impulse |
/// | → `step` | | 1 | | reading of a unit step |
/// | → `ramp` | | s | | reading of $f = t$ |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `impulse_step_and_ramp_are_integrals_of_each_other`
/// * `a_step_is_reached_without_overshoot`
/// * `the_series_are_the_printed_forms`
#[inline(always)]
pub fn time_response<R: Real>(omega_0: R, t: R) -> (R, R, R) {
    let y = omega_0 * t;
    let (decay, step, share, _) = settled(y);
    (omega_0 * y * decay, step, t * share)
}

/// **Appendix**, unnumbered: the reading after a time in which the force changes linearly.
///
/// ```math
/// g(\Delta t) = (S - \varphi) f_0 + \varphi f_1 + \big[(1 + y) g_0 + \Delta t \, \dot{g}_0\big] e^{-y}, \quad
/// \dot{g}(\Delta t) = S \, \frac{f_1 - f_0}{\Delta t} + \big[(1 - y) \dot{g}_0 + \omega_0 y \, (f_0 - g_0)\big] e^{-y}, \quad y = \omega_0 \Delta t
/// ```
///
/// # Reading
///
/// The exact solution of Eq. 28 with Eqs. 29 and 31 for a force that is linear between two samples, by the step response $S$ and the ramp response $\varphi \Delta t$ of
/// [`time_response`]. It is stable for any time step. After a long one little remains of the earlier force, $S - \varphi = \frac{1}{y} \big(2 - (y^2 + 2y + 2) e^{-y}\big)$, which is evaluated as such:
/// $S f_0 + \varphi (f_1 - f_0)$ would lose it. Below two it is the difference of the series.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `omega_0` | $\omega_0$ | rad/s | > 0 | natural frequency |
/// | `dt` | $\Delta t$ | s | > 0 | time between the samples |
/// | `g` | $g_0$ | N | any | reading before |
/// | `g_dot` | $\dot{g}_0$ | N/s | any | its rate before |
/// | `f_0` | $f_0$ | N | any | force before |
/// | `f_1` | $f_1$ | N | any | force now |
/// | → `g_next` | $g$ | N | | reading now |
/// | → `g_dot_next` | $\dot{g}$ | N/s | | its rate now |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `two_half_steps_make_a_step`
/// * `a_steady_force_is_read_and_a_steady_ramp_lags_by_two_time_constants`
/// * `the_area_under_the_force_is_the_area_under_the_reading`
/// * `a_step_of_any_length_keeps_the_digits_of_the_force_before`
/// * `responses_to_short_steps_keep_their_digits`
#[inline(always)]
pub fn filter_step<R: Real>(omega_0: R, dt: R, g: R, g_dot: R, f_0: R, f_1: R) -> (R, R) {
    let y = omega_0 * dt;
    let (decay, step, share, rest) = settled(y);
    let one = R::one();
    (
        rest * f_0 + share * f_1 + ((one + y) * g + dt * g_dot) * decay,
        step * (f_1 - f_0) / dt + ((one - y) * g_dot + omega_0 * y * (f_0 - g)) * decay,
    )
}

/// $e^{-y}$, the step response, the ramp response over the time, and the step response without that.
#[inline(always)]
fn settled<R: Real>(y: R) -> (R, R, R, R) {
    let (one, two) = (R::one(), R::lit(2.0));
    let decay = (-y).exp();
    // sums of y^n / n! from n = 2 and of (n - 2) y^n / n! from n = 3, by Horner's rule, divided by y^2 and y^3
    let mut sums = (R::zero(), R::zero());
    for n in (3..=TERMS).rev() {
        let n = f64::from(n);
        sums = ((sums.0 * y + one) / R::lit(n), (sums.1 * y + R::lit(n - 2.0)) / R::lit(n));
    }
    let (exponential, weighted) = ((sums.0 * y + one) / two, sums.1 / two);
    let short = y.lt(R::lit(SHORT));
    let long = y.max(R::lit(SHORT));
    (
        decay,
        R::select(short, y.squared() * exponential * decay, one - (one + y) * decay),
        R::select(short, y.squared() * weighted * decay, (long - two + (long + two) * decay) / long),
        R::select(
            short,
            y.squared() * (exponential - weighted) * decay,
            (two - (long.squared() + two * long + two) * decay) / long,
        ),
    )
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("soot/def_filter.rs", "soot-30-time", [], time_response),
        equation!("soot/def_filter.rs", "soot-filter", [], filter_step),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::{Dual, Reference};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn impulse_step_and_ramp_are_integrals_of_each_other(omega_0 in 0.1..3.0f64, t in 0.01..10.0f64) {
            prop_assume!((omega_0 * t - SHORT).abs() > 1e-6);
            let (_, step, ramp) = time_response(Dual::constant(omega_0), Dual::variable(t));
            prop_assert!((step.slope - time_response(omega_0, t).0).abs() < 1e-13);
            prop_assert!((ramp.slope - step.value).abs() < 1e-13);
        }

        #[test]
        fn responses_to_short_steps_keep_their_digits(log_y in -40.0..5.0f64) {
            let y = log_y.exp2();
            let (double, exact) = (settled(y), settled(Reference::exact(y)));
            for (double, exact) in [(double.0, exact.0), (double.1, exact.1), (double.2, exact.2), (double.3, exact.3)] {
                prop_assert!((double / exact.to_f64() - 1.0).abs() < 1e-14, "{y}: {double} {}", exact.to_f64());
            }
            // of the first order that is left of each
            prop_assert!(y > 1e-3 || (double.1 / (0.5 * y * y) - 1.0).abs() < y && (double.2 / (y * y / 6.0) - 1.0).abs() < y);
        }

        #[test]
        fn a_step_is_reached_without_overshoot(omega_0 in 0.1..3.0, t in 0.0..100.0f64, later in 0.0..10.0) {
            let step = |t| time_response(omega_0, t).1;
            prop_assert!(step(t) <= step(t + later) + 1e-15 && step(t) <= 1.0 && step(0.0) == 0.0);
        }

        #[test]
        fn the_series_are_the_printed_forms(omega_0 in 0.1..3.0, y in 0.001..5.0) {
            let (w, t) = (Reference::exact(omega_0), Reference::exact(y / omega_0));
            let (one, decay) = (Reference::exact(1.0), (-(w * t)).exp());
            let two_over = Reference::exact(2.0) / w;
            let (_, step, ramp) = time_response(w, t);
            let printed = (one - (one + w * t) * decay, t - two_over + (t + two_over) * decay);
            prop_assert!(((step - printed.0) / printed.0).abs().to_f64() < 1e-33);
            prop_assert!(((ramp - printed.1) / printed.1).abs().to_f64() < 1e-33);
        }

        #[test]
        fn two_half_steps_make_a_step(omega_0 in 0.1..3.0, dt in 0.01..5.0, g in -1.0..1.0, g_dot in -1.0..1.0, f_0 in -1.0..1.0, f_1 in -1.0..1.0) {
            let once = filter_step(omega_0, dt, g, g_dot, f_0, f_1);
            let middle = 0.5 * (f_0 + f_1);
            let half = filter_step(omega_0, 0.5 * dt, g, g_dot, f_0, middle);
            let twice: (f64, f64) = filter_step(omega_0, 0.5 * dt, half.0, half.1, middle, f_1);
            prop_assert!((once.0 - twice.0).abs() < 1e-13 && (once.1 - twice.1).abs() < 1e-12);
        }

        #[test]
        fn a_steady_force_is_read_and_a_steady_ramp_lags_by_two_time_constants(omega_0 in 0.1..3.0, dt in 0.001..5.0, f in -1.0..1.0f64, rate in -1.0..1.0) {
            let steady = filter_step(omega_0, dt, f, 0.0, f, f);
            prop_assert!((steady.0 - f).abs() < 1e-15 && steady.1.abs() < 1e-15);
            let lag = 2.0 * rate / omega_0;
            let ramp = filter_step(omega_0, dt, f - lag, rate, f, f + rate * dt);
            prop_assert!((ramp.0 - (f + rate * dt - lag)).abs() < 1e-13 && (ramp.1 - rate).abs() < 1e-13);
        }

        #[test]
        fn a_step_of_any_length_keeps_the_digits_of_the_force_before(log_y in -5.0..5.0f64, f_0 in 0.1..1.0) {
            let y = 10f64.powf(log_y);
            let printed = {
                let [y, one, two] = [y, 1.0, 2.0].map(Reference::exact);
                let (decay, f_0) = ((-y).exp(), Reference::exact(f_0));
                let (step, ramp) = (one - (one + y) * decay, y - two + (y + two) * decay);
                (step * f_0 + ramp / y * (-f_0)).to_f64()
            };
            let read: f64 = filter_step(1.0, y, 0.0, 0.0, f_0, 0.0).0;
            prop_assert!((read / printed - 1.0).abs() < 2e-15);
        }

        #[test]
        fn the_area_under_the_force_is_the_area_under_the_reading(forces in prop::collection::vec(-1.0..1.0f64, 3..20), omega_0 in 0.5..2.0) {
            // Simpson's rule with many points between the samples, then a long rest.
            let (parts, mut state, mut area, mut of_force) = (64, (0.0, 0.0), 0.0, 0.0);
            let mut path = vec![0.0];
            path.extend(forces);
            path.extend([0.0; 40]);
            for pair in path.windows(2) {
                of_force += 0.5 * (pair[0] + pair[1]);
                for k in 0..parts {
                    let at = |k: f64| pair[0] + (pair[1] - pair[0]) * k / f64::from(parts);
                    let (k, h) = (f64::from(k), 1.0 / f64::from(parts));
                    let middle = filter_step(omega_0, 0.5 * h, state.0, state.1, at(k), at(k + 0.5));
                    let end = filter_step(omega_0, h, state.0, state.1, at(k), at(k + 1.0));
                    area += h / 6.0 * (state.0 + 4.0 * middle.0 + end.0);
                    state = end;
                }
            }
            prop_assert!((area - of_force).abs() < 1e-6);
        }
    }
}
