//! The contact stiffness, from the equilibrium of a pair.

use super::def_radius::effective_radius;
use crate::equation::Equation;
use crate::{Real, equation};

/// Equilibrium from which the contact stiffness of a pair is derived.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stiffness {
    /// The equilibrium of the pair itself: every pair is in equilibrium at the same overlap.
    PerPair,
    /// The equilibria of pairs of equal particles of either size, [mixed](mixed_stiffness).
    PerSize,
}

/// **Eq. 9**, Section 2.3: contact stiffness that keeps a pair in equilibrium at a given overlap.
///
/// ```math
/// k_n = \frac{-F_{na}(0)}{\delta_n(0)^{3/2} \sqrt{0.5 (R + h_n)}}
/// ```
///
/// # Reading
///
/// Erratum: the star is missing, the radius is the $(R + h_n)^*$ of Eq. 8 that the equation inverts. The paper tabulates a stiffness per size; here each pair of sizes
/// has its own, as in the authors' program, which alone is exact for all pairs. $F_{na}(0)$ is the component along the normal,
/// negative because it attracts.
///
/// Effect: without the star two unlike particles are not in equilibrium at the distance of which the equation is derived. For equal ones it makes no difference.
///
/// Proof: `balances_repulsion_and_attraction_which_bare_radii_without_star_do_not`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `f_na_0` | $F_{na}(0)$ | N | < 0 | attraction at equilibrium, along the normal |
/// | `delta_n_0` | $\delta_n(0)$ | m | > 0 | overlap at equilibrium |
/// | `r_i` | $R_i$ | m | > 0 | bare radius of i |
/// | `r_j` | $R_j$ | m | > 0 | bare radius of j |
/// | `h_n` | $h_n$ | m | >= 0 | thickness of the compressed layer |
/// | → `k_n` | $k_n$ | Pa | | contact stiffness |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `balances_repulsion_and_attraction_which_bare_radii_without_star_do_not`
/// * `does_not_depend_on_which_particle_is_first`
#[inline(always)]
pub fn stiffness<R: Real>(f_na_0: R, delta_n_0: R, r_i: R, r_j: R, h_n: R) -> R {
    let (_, r_eff) = effective_radius(r_i + h_n, r_j + h_n);
    -f_na_0 / (delta_n_0 * (delta_n_0 * r_eff).sqrt())
}

/// **Section 2.3**, unnumbered: contact stiffness of unlike particles, from the stiffnesses of equal pairs of either size.
///
/// ```math
/// \frac{1}{k_n} = \frac{1}{2} \left(\frac{1}{k_i} + \frac{1}{k_j}\right)
/// ```
///
/// # Reading
///
/// Ambiguous: the paper speaks of the stiffness of a particle size, for which the star that Eq. 9 lacks makes no difference, and does not define the stiffness of two different sizes. Hertz adds the
/// compliances of two bodies. The equilibrium distance of unlike particles then differs slightly from the nominal one, and the default is the stiffness of the pair.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_i` | $k_i$ | Pa | > 0 | stiffness of two particles like i |
/// | `k_j` | $k_j$ | Pa | > 0 | stiffness of two particles like j |
/// | → `k_n` | $k_n$ | Pa | | contact stiffness |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `unlike_particles_are_as_stiff_as_half_the_sum_of_their_compliances`
#[inline(always)]
pub fn mixed_stiffness<R: Real>(k_i: R, k_j: R) -> R {
    R::lit(2.0) * k_i * k_j / (k_i + k_j)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("titania/eq09_stiffness.rs", "titania-9", ["9"], stiffness),
        equation!("titania/eq09_stiffness.rs", "titania-9-mixed", [], mixed_stiffness),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::titania::eq08_repulsion::repulsion;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn balances_repulsion_and_attraction_which_bare_radii_without_star_do_not(
            f in 0.1..6.0f64, delta in 0.05..0.3f64, r_i in 1.0..5.0, r_j in 6.0..12.0,
        ) {
            let k_n = stiffness(-f, delta, r_i, r_j, 0.36);
            prop_assert!(k_n > 0.0);
            prop_assert!(relative_eq!(repulsion(k_n, delta, r_i, r_j, 0.36).1, f, max_relative = 1e-14));
            for r in [r_i, r_j] {
                let printed = f / (delta * (0.5 * delta * (r + 0.36)).sqrt());
                let off = repulsion(printed, delta, r_i, r_j, 0.36).1 / f - 1.0;
                prop_assert!(off.abs() > 0.03);
            }
        }

        #[test]
        fn unlike_particles_are_as_stiff_as_half_the_sum_of_their_compliances(k_i in 20.0..45.0, k_j in 20.0..45.0) {
            let k_n = mixed_stiffness(k_i, k_j);
            prop_assert!(relative_eq!(1.0 / k_n, 0.5 * (1.0 / k_i + 1.0 / k_j), max_relative = 1e-15));
            prop_assert!(relative_eq!(mixed_stiffness(k_i, k_i), k_i, max_relative = 1e-15));
        }

        #[test]
        fn does_not_depend_on_which_particle_is_first(r_i in 0.5..10.0, r_j in 0.5..10.0) {
            prop_assert_eq!(stiffness(-2.3, 0.15, r_i, r_j, 0.36), stiffness(-2.3, 0.15, r_j, r_i, 0.36));
        }
    }
}
