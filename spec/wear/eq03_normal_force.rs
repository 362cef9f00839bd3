//! The normal force: Hookean through contact into cohesion, then a linear weakening.

use crate::equation::Equation;
use crate::{Real, equation, piecewise};

/// **Eq. 3**, Section 2.1: normal force between two particles against their separation.
///
/// ```math
/// F_N = \begin{cases} k_N \delta_N & \delta_N \le \delta_e \\
///   -\dfrac{k_N \delta_e}{\delta_f - \delta_e} (\delta_N - \delta_f) & \delta_e < \delta_N \le \delta_f \\
///   0 & \text{otherwise} \end{cases}
/// ```
///
/// # Reading
///
/// Erratum. For spheres larger than the critical diameter, Eq. 10 gives
/// `delta_f < delta_e`; the first case, read literally, then reaches `delta_e` and the scaling of the strength has no effect.
/// Figure A.2 shows what is meant: Hooke's law up to `min(delta_e, delta_f)`, nothing beyond `delta_f`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `delta_e` | $\delta_e$ | m | > 0 | elastic separation |
/// | `delta_f` | $\delta_f$ | m | > 0 | fracture separation |
/// | `delta_n` | $\delta_N$ | m | any | separation of the surfaces, negative for an overlap |
/// | → `f_n` | $F_N$ | N | | force along the normal, positive when it attracts |
///
/// # Laws
///
/// * `hookean_up_to_the_elastic_separation`
/// * `zero_beyond_the_fracture_separation`
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
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn hookean_up_to_the_elastic_separation(k_n in 0.1..10.0, delta_n in -1.0..1.0) {
            prop_assert_eq!(normal_force(k_n, 1.0, 2.0, delta_n), k_n * delta_n);
        }

        #[test]
        fn zero_beyond_the_fracture_separation(beyond in 0.0..10.0f64, delta_e in 0.1..3.0) {
            let delta_f = 1.0f64;
            prop_assert_eq!(normal_force(1.0, delta_e, delta_f, delta_f.next_up() + beyond), 0.0);
        }
    }
}
