//! The potential energy of the normal force.

use crate::equation::Equation;
use crate::{Real, equation, piecewise};

/// **Section 2.1**, unnumbered: potential of the normal force of Eq. 3, zero for particles far apart.
///
/// ```math
/// V = \begin{cases} \frac{1}{2} k_N \left(\delta_N^2 - \min(\delta_e, \delta_f) \, \delta_f\right) & \delta_N \le \min(\delta_e, \delta_f) \\
///   -\dfrac{k_N \delta_e (\delta_f - \delta_N)^2}{2 (\delta_f - \delta_e)} & \delta_e < \delta_N \le \delta_f \\
///   0 & \text{otherwise} \end{cases}
/// ```
///
/// # Reading
///
/// The integral of Eq. 3 as read in its module. It is continuous even where the force jumps.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `delta_e` | $\delta_e$ | m | > 0 | elastic separation |
/// | `delta_f` | $\delta_f$ | m | > 0 | fracture separation |
/// | `delta_n` | $\delta_N$ | m | any | separation of the surfaces, negative for an overlap |
/// | → `v` | $V$ | J | | potential |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_force_is_its_slope`
/// * `continuous_whatever_the_force_does`
/// * `the_work_to_part_two_particles_is_half_the_stiffness_times_both_separations`
#[inline(always)]
pub fn potential<R: Real>(k_n: R, delta_e: R, delta_f: R, delta_n: R) -> R {
    let half = R::lit(0.5) * k_n;
    let elastic = delta_e.min(delta_f);
    let weakening = -(half * delta_e * (delta_f - delta_n).squared() / (delta_f - delta_e));
    piecewise(
        [(delta_n.le(elastic), half * (delta_n.squared() - elastic * delta_f)), (delta_n.le(delta_f), weakening)],
        R::zero(),
    )
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/def_potential.rs", "wear-potential", [], potential)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::eq03_normal_force::normal_force;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_force_is_its_slope(k_n in 0.1..10.0, delta_e in 0.1..2.0, delta_f in 0.1..2.0, delta_n in -1.0..3.0f64) {
            let (h, elastic) = (1e-4, f64::min(delta_e, delta_f));
            prop_assume!((delta_n - elastic).abs() > h && (delta_n - delta_f).abs() > h);
            // The potential is quadratic between its corners: the central difference is exact up to rounding.
            let v = |delta_n: f64| potential(k_n, delta_e, delta_f, delta_n);
            let slope = (v(delta_n + h) - v(delta_n - h)) / (2.0 * h);
            let scale = k_n * (1.0 + delta_e / (delta_f - delta_e).abs());
            prop_assert!((slope - normal_force(k_n, delta_e, delta_f, delta_n)).abs() <= 1e-9 * scale);
        }

        #[test]
        fn continuous_whatever_the_force_does(k_n in 0.1..10.0, delta_e in 0.1..2.0, delta_f in 0.1..2.0) {
            for corner in [f64::min(delta_e, delta_f), delta_f] {
                let (below, above) = (corner * (1.0 - 1e-13), corner * (1.0 + 1e-13));
                let jump = potential(k_n, delta_e, delta_f, above) - potential(k_n, delta_e, delta_f, below);
                prop_assert!(jump.abs() <= 1e-11 * k_n);
            }
        }

        #[test]
        fn the_work_to_part_two_particles_is_half_the_stiffness_times_both_separations(
            k_n in 0.1..10.0, delta_e in 0.1..1.0, more in 0.0..2.0,
        ) {
            let delta_f = delta_e + more;
            prop_assert!(relative_eq!(-potential(k_n, delta_e, delta_f, 0.0), 0.5 * k_n * delta_e * delta_f, max_relative = 1e-14));
        }
    }
}
