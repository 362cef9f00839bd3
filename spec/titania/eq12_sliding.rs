//! The tangential force: stick-slip motion of two rough surfaces.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// The tangential spring after its elongation has reached the period.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slip {
    /// The spring is released: the force of that step is the largest one, and the spring restarts from zero, as in the authors' program.
    Reset,
    /// The spring loses whole periods and keeps the remainder, so that steady sliding has exactly the printed period.
    Remainder,
}

/// **Eq. 12**, Section 2.4: tangential force as a function of the distance slid along a straight line.
///
/// ```math
/// \mathbf{F}_t = -\tau_S A_{ij} \left(\frac{\delta_t}{\lambda_t} - \left\lfloor\frac{\delta_t}{\lambda_t}\right\rfloor\right) \mathbf{t}_{ij}
/// ```
///
/// # Reading
///
/// Erratum: the formula is valid for continued sliding in one direction, and no law for general motion. The
/// paper calls it a spring and a slider, which [`sliding_spring`] implements; here it is as printed.
///
/// Effect: a function of the displacement alone loses nothing on a closed path, and below zero the floor gives the full force at once.
///
/// Proof: `as_printed_it_is_not_odd_and_loses_nothing_on_a_closed_path_which_the_spring_does`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `tau_s` | $\tau_S$ | Pa | >= 0 | shear strength of sliding |
/// | `a` | $A_{ij}$ | m^2 | >= 0 | contact area |
/// | `delta_t` | $\delta_t$ | m | >= 0 | distance slid |
/// | `lambda_t` | $\lambda_t$ | m | > 0 | period, 0.5 nm |
/// | `t` | $\mathbf{t}_{ij}$ | 1 (3) | unit | direction of sliding |
/// | → `frac` | $\delta_t / \lambda_t - \lfloor\delta_t / \lambda_t\rfloor$ | 1 | | fraction of the period |
/// | → `f_t` | $\mathbf{F}_t$ | N (3) | | force on i |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_a_saw_tooth_whose_mean_is_half_its_peak`
/// * `as_printed_it_is_not_odd_and_loses_nothing_on_a_closed_path_which_the_spring_does`
#[inline(always)]
pub fn sawtooth<R: Real>(tau_s: R, a: R, delta_t: R, lambda_t: R, t: Vec3<R>) -> (R, Vec3<R>) {
    let periods = delta_t / lambda_t;
    let frac = periods - periods.floor();
    (frac, t * -(tau_s * a * frac))
}

/// **Eq. 12** as a spring and a slider in three dimensions: force of the spring and its remaining elongation.
///
/// ```math
/// \mathbf{F}_t = -\frac{\tau_S A_{ij}}{\lambda_t} \boldsymbol{\xi}, \quad
/// |\boldsymbol{\xi}| \ge \lambda_t: \; \boldsymbol{\xi} := \boldsymbol{\xi} - \lambda_t \left\lfloor\frac{|\boldsymbol{\xi}|}{\lambda_t}\right\rfloor \hat{\boldsymbol{\xi}}
/// ```
///
/// # Reading
///
/// The spring $\boldsymbol{\xi}$ lies in the contact plane and was advanced to this instant. Below one period it is elastic. At one period the surfaces slip, in
/// one of two ways, see [`Slip`]: with `slip` 1 the spring keeps the remainder, and for steady sliding along a line the force is the printed one; with `slip` 0 the
/// force is the peak force $-\tau_S A_{ij} \hat{\boldsymbol{\xi}}$ of this step and nothing remains. The energy lost by the spring is dissipated.
///
/// The stiffness follows the area, without a corresponding normal force: a spring loaded at one area and released at
/// another delivers $\tau_S \, \Delta A \, \xi^2 / 2 \lambda_t$. That is the paper's law; the contact law records it as
/// lost to the contact area.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `tau_s` | $\tau_S$ | Pa | >= 0 | shear strength of sliding |
/// | `a` | $A_{ij}$ | m^2 | >= 0 | contact area |
/// | `lambda_t` | $\lambda_t$ | m | > 0 | period |
/// | `xi` | $\boldsymbol{\xi}$ | m (3) | any | spring, advanced |
/// | `slip` | $s$ | 1 | [0, 1] | 1 to keep the remainder, 0 to start from zero |
/// | → `f_t` | $\mathbf{F}_t$ | N (3) | | force on i |
/// | → `xi_next` | $\boldsymbol{\xi}$ | m (3) | | spring that remains |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `steady_sliding_is_the_printed_saw_tooth`
/// * `the_force_never_exceeds_the_peak`
/// * `a_closed_path_costs_what_the_slips_lose`
/// * `changing_the_area_under_load_delivers_work`
/// * `a_spring_slips_when_it_is_as_long_as_a_period`
#[inline(always)]
pub fn sliding_spring<R: Real>(tau_s: R, a: R, lambda_t: R, xi: Vec3<R>, slip: R) -> (Vec3<R>, Vec3<R>) {
    let (zero, one, length) = (R::zero(), R::one(), xi.norm());
    let slips = length.ge(lambda_t);
    let (periods, period) = (length / lambda_t, lambda_t / length);
    let remainder = R::select(slips, slip * (periods - periods.floor()) * period, one);
    let kept = R::select(slip.gt(zero), remainder, period);
    let acting = R::select(slips, kept, one);
    (xi * -(tau_s / lambda_t * a * acting), xi * remainder)
}

/// **Section 2.4**, unnumbered: energy stored in the tangential spring.
///
/// ```math
/// V_t = \frac{\tau_S A_{ij}}{2 \lambda_t} |\boldsymbol{\xi}|^2
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `tau_s` | $\tau_S$ | Pa | >= 0 | shear strength of sliding |
/// | `a` | $A_{ij}$ | m^2 | >= 0 | contact area |
/// | `lambda_t` | $\lambda_t$ | m | > 0 | period |
/// | `xi` | $\boldsymbol{\xi}$ | m (3) | any | spring |
/// | → `v_t` | $V_t$ | J | | energy |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_slip_loses_half_the_peak_force_times_the_period`
#[inline(always)]
pub fn spring_energy<R: Real>(tau_s: R, a: R, lambda_t: R, xi: Vec3<R>) -> R {
    R::lit(0.5) * (tau_s / lambda_t * a) * xi.dot(xi)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("titania/eq12_sliding.rs", "titania-12", ["12"], sawtooth),
        equation!("titania/eq12_sliding.rs", "titania-12-spring", [], sliding_spring),
        equation!("titania/eq12_sliding.rs", "titania-12-energy", [], spring_energy),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    const TAU: f64 = 0.65;
    const AREA: f64 = 1.9;
    const LAMBDA: f64 = 0.5;
    const PEAK: f64 = TAU * AREA;
    const X: Vec3<f64> = Vec3([1.0, 0.0, 0.0]);

    /// Work of moving one surface over the other along a line through the given positions, in steps of `step`.
    fn work(places: &[f64], step: f64, mut force: impl FnMut(f64) -> f64) -> f64 {
        let (mut sum, mut last) = (0.0, force(0.0));
        for leg in places.windows(2) {
            let steps = ((leg[1] - leg[0]) / step).abs().round();
            let by = (leg[1] - leg[0]) / steps;
            for _ in 0..steps as usize {
                let next = force(by);
                sum -= 0.5 * (last + next) * by;
                last = next;
            }
        }
        sum
    }

    fn spring(slip: f64) -> impl FnMut(f64) -> f64 {
        let mut xi = Vec3::zero();
        move |by| {
            let (force, next) = sliding_spring(TAU, AREA, LAMBDA, xi + X * by, slip);
            xi = next;
            force.0[0]
        }
    }

    proptest! {
        #[test]
        fn is_a_saw_tooth_whose_mean_is_half_its_peak(periods in 1..6) {
            let n = 1000 * periods;
            let force = |k: i32| -sawtooth(TAU, AREA, (f64::from(k) + 0.5) * 1e-3 * LAMBDA, LAMBDA, X).1.0[0];
            let mean = (0..n).map(force).sum::<f64>() / f64::from(n);
            prop_assert!((mean - 0.5 * PEAK).abs() < 1e-12);
            prop_assert!((force(n + 3) - force(3)).abs() < 1e-12 && force(999) < PEAK);
        }

        #[test]
        fn steady_sliding_is_the_printed_saw_tooth(step in 0.001..0.1, x in -1.0..1.0f64, y in -1.0..1.0f64) {
            prop_assume!(x * x + y * y > 0.01);
            let t = Vec3::new(x, y, 0.0) * (1.0 / (x * x + y * y).sqrt());
            let mut xi = Vec3::zero();
            for k in 1..100 {
                let (force, next) = sliding_spring(TAU, AREA, LAMBDA, xi + t * step, 1.0);
                xi = next;
                let (frac, printed) = sawtooth(TAU, AREA, f64::from(k) * step, LAMBDA, t);
                // at the end of a tooth the two may round to different sides
                prop_assert!((force - printed).norm() < 1e-10 || !(1e-9..1.0 - 1e-9).contains(&frac));
            }
        }

        #[test]
        fn the_force_never_exceeds_the_peak(x in -3.0..3.0, y in -3.0..3.0, slip in 0..2) {
            let xi = Vec3::new(x, y, 0.0);
            let (force, next) = sliding_spring(TAU, AREA, LAMBDA, xi, f64::from(slip));
            prop_assert!(force.norm() <= PEAK * (1.0 + 1e-15) && next.norm() <= LAMBDA);
            prop_assert!(spring_energy(TAU, AREA, LAMBDA, next) <= spring_energy(TAU, AREA, LAMBDA, xi));
        }
    }

    #[test]
    fn as_printed_it_is_not_odd_and_loses_nothing_on_a_closed_path_which_the_spring_does() {
        let printed = |delta: f64| sawtooth(TAU, AREA, delta, LAMBDA, X).1.0[0];
        assert!((printed(-1e-9) + PEAK).abs() < 1e-8 && printed(1e-9).abs() < 1e-8);
        let mut at = 0.0;
        let there_and_back = work(&[0.0, 1.125, 0.0], 1e-3, |by| {
            at += by;
            printed(at)
        });
        assert!(there_and_back.abs() < 2e-3 * PEAK, "{there_and_back}");
        assert!(work(&[0.0, 1.125, 0.0], 1e-3, spring(1.0)) > 0.9 * PEAK);
    }

    #[test]
    fn a_closed_path_costs_what_the_slips_lose() {
        // Two slips out, and two back: each costs half the peak force times the period.
        for slip in [0.0, 1.0] {
            let closed = work(&[0.0, 1.125, -0.375, 0.0], 1e-4, spring(slip));
            let lost = 4.0 * 0.5 * PEAK * LAMBDA;
            assert!((closed - lost).abs() < 2e-3 * lost, "{closed} {lost}");
        }
    }

    #[test]
    fn changing_the_area_under_load_delivers_work() {
        let force = |area: f64, xi: f64| sliding_spring(TAU, area, LAMBDA, X * xi, 0.0).0.0[0];
        let leg = |area: f64, from: f64, to: f64| -0.5 * (force(area, from) + force(area, to)) * (to - from);
        let (small, large, xi) = (1.9, 2.4, 0.4);
        let delivered = -(leg(small, 0.0, xi) + leg(large, xi, 0.0));
        assert!((delivered - 0.5 * TAU * (large - small) * xi * xi / LAMBDA).abs() < 1e-14);
    }

    #[test]
    fn a_spring_slips_when_it_is_as_long_as_a_period() {
        let at_period = |slip: f64| sliding_spring(TAU, AREA, LAMBDA, X * LAMBDA, slip);
        assert_eq!([0.0, 1.0].map(|slip| at_period(slip).1), [Vec3::zero(); 2]);
        assert!((at_period(0.0).0 + X * PEAK).norm() < 1e-15 && at_period(1.0).0 == Vec3::zero());
        // the next slip takes the whole periods alone, or all
        let beyond = |slip: f64| sliding_spring(TAU, AREA, LAMBDA, X * (2.25 * LAMBDA), slip);
        assert!((beyond(1.0).1 - X * (0.25 * LAMBDA)).norm() < 1e-15 && beyond(0.0).1 == Vec3::zero());
        assert!((beyond(1.0).0 + X * (0.25 * PEAK)).norm() < 1e-15 && (beyond(0.0).0 + X * PEAK).norm() < 1e-15);
    }

    #[test]
    fn a_slip_loses_half_the_peak_force_times_the_period() {
        assert!((spring_energy(TAU, AREA, LAMBDA, X * LAMBDA) - 0.5 * PEAK * LAMBDA).abs() < 1e-15);
    }
}
