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
/// Erratum: a simulation does not remain stable at this time step. At the limit itself the motion grows linearly; and for a
/// damped pair ([`damped_limit`](super::def_stable_step::damped_limit)) or one that slides and rotates
/// ([`sliding_limit`](super::def_stable_step::sliding_limit)) the limit is lower. This is the critical time step of which the
/// paper takes fractions; the pair law reports the smallest of the three limits.
///
/// Effect: a simulation at the printed limit gains energy without bound.
///
/// Proof: `not_stable_at_it_the_motion_grows_linearly`.
///
/// Eq. A.18 repeats it.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m` | $m$ | kg | > 0 | mass of either particle |
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | → `dt_c` | $\Delta t_c$ | s | | critical time step |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_twice_the_inverse_frequency_of_the_pair`
/// * `stable_below_it_bounded_at_0_99`
/// * `not_stable_at_it_the_motion_grows_linearly`
/// * `unstable_above_it_the_motion_grows_exponentially`
/// * `the_spectral_radius_crosses_one_there`
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
    use crate::Vec3;
    use crate::mechanics::amplification::spectral_radius;
    use crate::mechanics::reduced_mass::effective_mass;
    use crate::mechanics::symplectic_euler::symplectic_euler;
    use crate::wear::eq03_normal_force::normal_force;
    use approx::relative_eq;
    use proptest::prelude::*;

    /// Separation of two equal particles after `steps` steps of a fraction of the critical one, relative to the initial
    /// separation, which is small enough for the motion to stay in the elastic range of Eq. 3.
    fn separations(m: f64, k_n: f64, fraction: f64, steps: usize) -> Vec<f64> {
        let dt = fraction * critical_time_step(m, k_n);
        let along = |x: f64| Vec3::new(x, 0.0, 0.0);
        let (mut x, mut v) = ([along(0.5), along(-0.5)], [along(0.0); 2]);
        (0..steps)
            .map(|_| {
                let separation = (x[0] - x[1]).0[0];
                let f_n = normal_force(k_n, f64::MAX, f64::MAX, separation);
                for (i, force) in [-f_n, f_n].into_iter().enumerate() {
                    (v[i], x[i], _) = symplectic_euler(x[i], v[i], along(0.0), along(force), along(0.0), m, 1.0, dt);
                }
                (x[0] - x[1]).0[0]
            })
            .collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn is_twice_the_inverse_frequency_of_the_pair(m in 0.1..10.0, k_n in 0.1..10.0f64) {
            let frequency = f64::sqrt(k_n / effective_mass(m, m));
            prop_assert!(relative_eq!(critical_time_step(m, k_n) * frequency, 2.0, max_relative = 1e-14));
        }

        #[test]
        fn stable_below_it_bounded_at_0_99(m in 0.1..10.0, k_n in 0.1..10.0) {
            // x^2 <= E_n / E_0 <= (1 + h/2) / (1 - h/2) with h/2 = 0.99.
            let bound = f64::sqrt(1.99 / 0.01) * (1.0 + 1e-9);
            prop_assert!(separations(m, k_n, 0.99, 5000).into_iter().all(|x| x.abs() <= bound));
        }

        #[test]
        fn not_stable_at_it_the_motion_grows_linearly(m in 0.1..10.0, k_n in 0.1..10.0) {
            for (n, x) in (1..).zip(separations(m, k_n, 1.0, 1000)) {
                prop_assert!(relative_eq!(x.abs(), 2.0 * f64::from(n) + 1.0, max_relative = 1e-6));
            }
        }

        #[test]
        fn unstable_above_it_the_motion_grows_exponentially(m in 0.1..10.0, k_n in 0.1..10.0) {
            // The larger eigenvalue of the step: h^2/2 - 1 + h sqrt(h^2/4 - 1) with h/2 = 1.01.
            let growth = 2.0 * 1.01f64.powi(2) - 1.0 + 2.0 * 1.01 * (1.01f64.powi(2) - 1.0).sqrt();
            let x = separations(m, k_n, 1.01, 200);
            prop_assert!(relative_eq!((x[199] / x[99]).abs().ln(), 100.0 * growth.ln(), max_relative = 1e-6));
        }

        #[test]
        fn the_spectral_radius_crosses_one_there(m in 0.1..10.0, k_n in 0.1..10.0) {
            let radius = |fraction| spectral_radius(effective_mass(m, m), k_n, 0.0, fraction * critical_time_step(m, k_n));
            prop_assert!((radius(0.999) - 1.0).abs() < 1e-10);
            prop_assert!(radius(1.001) > 1.08);
        }
    }
}
