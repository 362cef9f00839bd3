//! The stability limit of a sphere with several contacts.

use crate::equation::Equation;
use crate::{Real, equation};

/// Time step below which a sphere with several contacts or necks is stable.
///
/// ```math
/// \Delta t_z = \frac{\Delta t_c}{\sqrt{z}}
/// ```
///
/// # Reading
///
/// The elastic energy of every pair is at most $\tfrac{1}{2}\omega_c^2$ times the inertia of its two spheres, where $\omega_c = 2 / \Delta t_c$ is the largest frequency of a pair on its own.
/// Summed over all pairs, every sphere counts as often as it has contacts: no frequency of the assembly is above $\omega_c \sqrt{z}$, with the largest coordination number $z$.
/// It is sufficient, and attained where all neighbours of a sphere move against it, as in a ring of an even number of equal spheres. Without dashpots.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `dt_c` | $\Delta t_c$ | s | > 0 | stability limit of two spheres |
/// | `z` | $z$ | 1 | > 0 | coordination number |
/// | → `dt_z` | $\Delta t_z$ | s | | stable time step |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `no_frequency_of_an_assembly_is_above_it`
/// * `an_even_ring_attains_it`
#[inline(always)]
pub fn coordinated_time_step<R: Real>(dt_c: R, z: R) -> R {
    dt_c / z.sqrt()
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![equation!("mechanics/coordinated_step.rs", "mechanics-coordinated-step", [], coordinated_time_step)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::stable_step::stable_time_step;
    use faer::{Mat, Side};
    use proptest::prelude::*;

    /// The stability limit of masses on a line, each joined by springs to others.
    fn limit(masses: &[f64], springs: &[(usize, usize, f64)]) -> f64 {
        let mut matrix = Mat::<f64>::zeros(masses.len(), masses.len());
        for &(i, j, k) in springs {
            for (a, b, sign) in [(i, i, 1.0), (j, j, 1.0), (i, j, -1.0), (j, i, -1.0)] {
                matrix[(a, b)] += sign * k / (masses[a] * masses[b]).sqrt();
            }
        }
        let squares = matrix.self_adjoint_eigenvalues(Side::Lower).expect("a symmetric matrix has eigenvalues");
        2.0 / squares.last().expect("there are masses").sqrt()
    }

    proptest! {
        #[test]
        fn no_frequency_of_an_assembly_is_above_it(
            masses in prop::collection::vec(0.1..10.0f64, 8),
            springs in prop::collection::btree_map((0..8usize, 0..8usize), 0.1..10.0f64, 1..20),
        ) {
            let springs: Vec<_> = springs.into_iter().filter(|((i, j), _)| i < j).map(|((i, j), k)| (i, j, k)).collect();
            let reduced = |i: usize, j: usize| masses[i] * masses[j] / (masses[i] + masses[j]);
            let stiffest = springs.iter().map(|&(i, j, k)| stable_time_step(reduced(i, j), k, 0.0)).fold(f64::INFINITY, f64::min);
            let contacts = |p| springs.iter().filter(|&&(i, j, _)| i == p || j == p).count();
            let z = (0..masses.len()).map(contacts).max().unwrap_or(0);
            prop_assume!(z > 0);
            prop_assert!(coordinated_time_step(stiffest, z as f64) <= limit(&masses, &springs) * (1.0 + 1e-9));
        }

        #[test]
        fn an_even_ring_attains_it(half in 2..6usize, m in 0.1..10.0f64, k in 0.1..10.0f64) {
            let n = 2 * half;
            let ring: Vec<_> = (0..n).map(|i| (i, (i + 1) % n, k)).collect();
            let bound = coordinated_time_step(stable_time_step(0.5 * m, k, 0.0), 2.0);
            prop_assert!((limit(&vec![m; n], &ring) / bound - 1.0).abs() < 1e-9);
        }
    }
}
