//! The normal force: Hookean in contact and cohesion, then weakening linearly.

use crate::equation::Equation;
use crate::{Real, equation, piecewise};

/// **Eq. 3**, Section 2.1: normal force between two particles as a function of their separation.
///
/// ```math
/// F_N = \begin{cases} k_N \delta_N & \delta_N \le \delta_e \\
///   -\dfrac{k_N \delta_e}{\delta_f - \delta_e} (\delta_N - \delta_f) & \delta_e < \delta_N \le \delta_f \\
///   0 & \text{otherwise} \end{cases}
/// ```
///
/// # Reading
///
/// Erratum: for spheres larger than the critical diameter, Eq. 10 gives `delta_f < delta_e`, and the first case, read literally,
/// reaches `delta_e`. Figure A.2 shows the intended law: Hooke's law up to `min(delta_e, delta_f)`, nothing beyond `delta_f`.
///
/// Effect: read literally the scaling of the strength has no effect; large spheres would hold as much as small ones.
///
/// Proof: `breaks_while_it_grows_if_the_fracture_separation_is_the_smaller_which_the_printed_cases_do_not`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `delta_e` | $\delta_e$ | m | > 0 | elastic separation |
/// | `delta_f` | $\delta_f$ | m | > 0 | fracture separation |
/// | `delta_n` | $\delta_N$ | m | any | separation of the surfaces, negative for an overlap |
/// | → `f_n` | $F_N$ | N | | force along the normal, positive when it attracts |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `hookean_up_to_the_elastic_separation`
/// * `weakens_linearly_from_there_to_the_fracture_separation`
/// * `zero_beyond_the_fracture_separation`
/// * `continuous_if_it_weakens_before_it_breaks`
/// * `breaks_while_it_grows_if_the_fracture_separation_is_the_smaller_which_the_printed_cases_do_not`
/// * `reversible_a_closed_loop_through_the_whole_range_does_no_work_at_any_speed`
/// * `a_passage_leaves_with_the_velocity_it_came_with`
#[inline(always)]
pub fn normal_force<R: Real>(k_n: R, delta_e: R, delta_f: R, delta_n: R) -> R {
    let weakening = k_n * delta_e * (delta_f - delta_n) / (delta_f - delta_e);
    piecewise([(delta_n.le(delta_e.min(delta_f)), k_n * delta_n), (delta_n.le(delta_f), weakening)], R::zero())
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq03_normal_force.rs", "wear-3", ["3"], normal_force)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::def_potential::potential;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn hookean_up_to_the_elastic_separation(k_n in 0.1..10.0, delta_n in -1.0..1.0) {
            prop_assert_eq!(normal_force(k_n, 1.0, 2.0, delta_n), k_n * delta_n);
        }

        #[test]
        fn weakens_linearly_from_there_to_the_fracture_separation(k_n in 0.1..10.0, delta_e in 0.1..1.0, range in 0.1..1.0, share in 0.0..1.0f64) {
            let (delta_f, peak) = (delta_e + range, k_n * delta_e);
            let force: f64 = normal_force(k_n, delta_e, delta_f, delta_e + share * range);
            prop_assert!((force - (1.0 - share) * peak).abs() < 1e-13 * peak);
        }

        #[test]
        fn zero_beyond_the_fracture_separation(beyond in 0.0..10.0f64, delta_e in 0.1..3.0) {
            let delta_f = 1.0f64;
            prop_assert_eq!(normal_force(1.0, delta_e, delta_f, delta_f.next_up() + beyond), 0.0);
        }

        #[test]
        fn continuous_if_it_weakens_before_it_breaks(k_n in 0.1..10.0, delta_e in 0.1..1.0, range in 0.1..1.0) {
            let delta_f = delta_e + range;
            for corner in [0.0, delta_e, delta_f] {
                let force = |delta_n| normal_force(k_n, delta_e, delta_f, delta_n);
                prop_assert!((force(corner + 1e-13) - force(corner - 1e-13)).abs() < 1e-11 * k_n);
            }
        }

        #[test]
        fn breaks_while_it_grows_if_the_fracture_separation_is_the_smaller_which_the_printed_cases_do_not(
            k_n in 0.1..10.0, delta_f in 0.1..0.9, delta_n in 0.0..1.0,
        ) {
            let delta_e = 1.0;
            let printed = |delta_n: f64| if delta_n <= delta_e { k_n * delta_n } else { 0.0 };
            let force = normal_force(k_n, delta_e, delta_f, delta_n);
            prop_assert_eq!(force, if delta_n <= delta_f { k_n * delta_n } else { 0.0 });
            // Beyond the fracture separation, where "the total force is zero", the printed force still attracts.
            let beyond = 0.5 * (delta_f + delta_e);
            prop_assert!(printed(beyond) > 0.0 && normal_force(k_n, delta_e, delta_f, beyond) == 0.0);
        }

        #[test]
        fn reversible_a_closed_loop_through_the_whole_range_does_no_work_at_any_speed(
            delta_e in 0.1..1.0, delta_f in 0.1..1.0, out in 0.1..3.0f64, back in 0.1..3.0f64,
        ) {
            // Out at one speed and back at another, midpoint rule in time: the force depends on position alone.
            let (low, high) = (-0.5, 1.5);
            let leg = |speed: f64, from: f64, to: f64| -> f64 {
                let steps = (4000.0 / speed) as usize;
                let step = (to - from) / steps as f64;
                (0..steps).map(|n| normal_force(1.0, delta_e, delta_f, from + (n as f64 + 0.5) * step) * step).sum()
            };
            let (there, home) = (leg(out, low, high), leg(back, high, low));
            let expected = potential(1.0, delta_e, delta_f, high) - potential(1.0, delta_e, delta_f, low);
            prop_assert!((there - expected).abs() < 5e-3);
            prop_assert!((there + home).abs() < 5e-3);
            // The same nodes both ways cancel to rounding.
            prop_assert!((leg(out, low, high) + leg(out, high, low)).abs() < 1e-12);
        }

        #[test]
        fn a_passage_leaves_with_the_velocity_it_came_with(delta_e in 0.1..0.4, range in 0.01..0.3, speed in 0.1..2.0f64) {
            // Unit mass, from beyond the range through an overlap and out again, by the leapfrog method.
            let delta_f = delta_e + range;
            let force = |x| -normal_force(1.0, delta_e, delta_f, x);
            let (dt, mut x, mut v) = (1e-3, delta_f + 0.05, -speed);
            let mut turned = false;
            while x <= delta_f + 0.05 {
                let half = v + 0.5 * dt * force(x);
                x += dt * half;
                v = half + 0.5 * dt * force(x);
                turned |= x < 0.0;
            }
            prop_assert!(turned);
            prop_assert!((v - speed).abs() < 2e-3);
        }
    }
}
