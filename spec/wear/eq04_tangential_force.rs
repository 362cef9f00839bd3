//! The tangential force: elastic in the sliding distance, up to a cap.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 4**, Section 2.1: tangential force between two particles as a function of the sliding distance.
///
/// ```math
/// F_T = \min(k_T \delta_T, F_{m,T})
/// ```
///
/// # Reading
///
/// Erratum: a prime is missing. The cap is $F'_{m,T}$ of Eq. 5, which has no other use, and Figure 3 shows it.
///
/// Effect: with the printed cap the force would not vanish at the fracture separation, where the interaction ends.
///
/// Proof: `vanishes_at_the_fracture_separation_which_the_printed_cap_does_not`.
///
/// A cap alone is not enough: the sliding distance must not grow beyond it, see [`trimmed_distance`].
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_t` | $k_T$ | N/m | >= 0 | tangential stiffness |
/// | `delta_t` | $\delta_T$ | m | >= 0 | sliding distance |
/// | `f_mt_rescaled` | $F'_{m,T}$ | N | >= 0 | largest tangential force at this separation |
/// | → `f_t` | $F_T$ | N | | magnitude of the tangential force |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `linear_then_flat`
/// * `continuous_at_the_cap`
/// * `vanishes_at_the_fracture_separation_which_the_printed_cap_does_not`
#[inline(always)]
pub fn tangential_force<R: Real>(k_t: R, delta_t: R, f_mt_rescaled: R) -> R {
    (k_t * delta_t).min(f_mt_rescaled)
}

/// **Section 2.1**, unnumbered: sliding distance that remains once the force has reached its cap.
///
/// ```math
/// \delta_T := \min\left(\delta_T, \frac{F'_{m,T}}{k_T}\right)
/// ```
///
/// # Reading
///
/// The paper does not define the sliding distance beyond the cap. If it kept growing, a pair could slide at a large
/// separation, where the cap is small, and recover the distance in contact, where it is large: such a loop delivers
/// work. The slider of the spring must therefore slip. Computed from the retained fraction $F_T / k_T \delta_T$, one
/// without slip, so that `k_t = 0` is allowed.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_t` | $k_T$ | N/m | >= 0 | tangential stiffness |
/// | `delta_t` | $\delta_T$ | m | >= 0 | sliding distance |
/// | `f_mt_rescaled` | $F'_{m,T}$ | N | >= 0 | largest tangential force at this separation |
/// | → `delta_t_trimmed` | $\delta_T$ | m | | sliding distance retained by the spring |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `trimming_leaves_the_force`
/// * `trimming_never_lengthens`
/// * `a_closed_tangential_loop_delivers_no_work_which_the_untrimmed_one_does`
#[inline(always)]
pub fn trimmed_distance<R: Real>(k_t: R, delta_t: R, f_mt_rescaled: R) -> R {
    delta_t * kept_fraction(k_t, delta_t, f_mt_rescaled)
}

/// The fraction of the sliding distance that [`trimmed_distance`] retains.
#[inline(always)]
pub fn kept_fraction<R: Real>(k_t: R, delta_t: R, f_mt_rescaled: R) -> R {
    let (elastic, f_t) = (k_t * delta_t, tangential_force(k_t, delta_t, f_mt_rescaled));
    R::select(f_t.lt(elastic), f_t / elastic, R::one())
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/eq04_tangential_force.rs", "wear-4", ["4"], tangential_force),
        equation!("wear/eq04_tangential_force.rs", "wear-trim", [], trimmed_distance),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::eq05_rescaled_maximum::rescaled_maximum;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn linear_then_flat(k_t in 0.0..10.0, delta_t in 0.0..1.0, cap in 0.0..5.0) {
            let f_t = tangential_force(k_t, delta_t, cap);
            prop_assert_eq!(f_t, if k_t * delta_t < cap { k_t * delta_t } else { cap });
        }

        #[test]
        fn continuous_at_the_cap(k_t in 0.1..10.0, cap in 0.1..5.0) {
            let (below, above) = (cap / k_t * (1.0 - 1e-15), cap / k_t * (1.0 + 1e-15));
            prop_assert!(relative_eq!(tangential_force(k_t, below, cap), tangential_force(k_t, above, cap), max_relative = 4e-15));
        }

        #[test]
        fn vanishes_at_the_fracture_separation_which_the_printed_cap_does_not(
            k_t in 0.1..10.0, delta_t in 0.1..1.0, f_mt in 0.1..5.0, delta_f in 0.1..2.0,
        ) {
            prop_assert_eq!(tangential_force(k_t, delta_t, rescaled_maximum(delta_f, delta_f, f_mt)), 0.0);
            prop_assert!(tangential_force(k_t, delta_t, f_mt) > 0.0);
        }

        #[test]
        fn trimming_leaves_the_force(k_t in 0.0..10.0, delta_t in 0.0..1.0, cap in 0.0..5.0) {
            let trimmed = trimmed_distance(k_t, delta_t, cap);
            prop_assert!(relative_eq!(tangential_force(k_t, trimmed, cap), tangential_force(k_t, delta_t, cap), max_relative = 4e-16));
        }

        #[test]
        fn trimming_never_lengthens(k_t in 0.0..10.0, delta_t in 0.0..1.0, cap in 0.0..5.0) {
            prop_assert!(trimmed_distance(k_t, delta_t, cap) <= delta_t);
        }

        #[test]
        fn a_closed_tangential_loop_delivers_no_work_which_the_untrimmed_one_does(
            near in 0.0..0.2, far in 0.25..0.5, length in 0.5..3.0,
        ) {
            // Slide out by `length` at the separation `far`, approach to `near`, slide back, return to `far`.
            let (k_t, f_mt, delta_f) = (2.0, 0.3, 0.5);
            let work = |trim: bool| {
                let steps = 1000;
                let step = length / f64::from(steps);
                let (mut spring, mut work) = (0.0f64, 0.0);
                for (separation, direction) in [(far, 1.0), (near, -1.0)] {
                    let cap = rescaled_maximum(separation, delta_f, f_mt);
                    for _ in 0..steps {
                        spring += direction * step;
                        work += direction * step * spring.signum() * tangential_force(k_t, spring.abs(), cap);
                        if trim {
                            spring = spring.signum() * trimmed_distance(k_t, spring.abs(), cap);
                        }
                    }
                }
                work
            };
            prop_assert!(work(true) >= 0.0);
            prop_assert!(work(false) < 0.0);
        }
    }
}
