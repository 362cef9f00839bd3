//! Stress, from forces and velocities.
//!
//! Equations and sections are numbered as in Pham-Ba & Molinari 2022.

use crate::equation::Equation;
use crate::{Real, Tensor, Vec3, equation};

/// **Section 3**, unnumbered: contribution of one pair to the virial stress, positive in tension.
///
/// ```math
/// \sigma_{ab} = \frac{1}{V} r_a f_b
/// ```
///
/// # Reading
///
/// The paper refers to a citation. The stress of a volume is the sum over its pairs, each counted once; `r` leads from i to j and `f`
/// is the force on i, so that attraction is tension.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `volume` | $V$ | m^3 | > 0 | volume |
/// | `r` | $\mathbf{r}$ | m (3) | any | from the centre of i to that of j |
/// | `f` | $\mathbf{f}$ | N (3) | any | force of j on i |
/// | → `sigma` | $\sigma_{ab}$ | Pa (9) | | stress |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `swapping_the_particles_changes_nothing`
/// * `attraction_is_tension`
/// * `the_stress_does_the_work_of_the_pair`
/// * `a_central_force_gives_a_symmetric_stress`
#[inline(always)]
pub fn pair_stress<R: Real>(volume: R, r: Vec3<R>, f: Vec3<R>) -> Tensor<R> {
    (r * (R::one() / volume)).outer(f)
}

/// **Section 3**, unnumbered: contribution of one particle's motion to the virial stress.
///
/// ```math
/// \sigma_{ab} = -\frac{1}{V} m v_a v_b
/// ```
///
/// # Reading
///
/// With the velocity relative to the mean motion; otherwise the stress would depend on the observer.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `volume` | $V$ | m^3 | > 0 | volume |
/// | `m` | $m$ | kg | > 0 | mass |
/// | `v` | $\mathbf{v}$ | m/s (3) | any | velocity relative to the mean motion |
/// | → `sigma` | $\sigma_{ab}$ | Pa (9) | | stress |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `motion_is_pressure`
/// * `the_pressure_of_motion_is_two_thirds_of_its_energy_density_and_along_the_velocity`
#[inline(always)]
pub fn kinetic_stress<R: Real>(volume: R, m: R, v: Vec3<R>) -> Tensor<R> {
    (v * (-m / volume)).outer(v)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/virial.rs", "wear-virial", [], pair_stress),
        equation!("mechanics/virial.rs", "wear-virial-kinetic", [], kinetic_stress),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::kinetic_energy::translational_energy;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-3.0..3.0).prop_map(Vec3)
    }

    fn trace(t: Tensor<f64>) -> f64 {
        t[0].0[0] + t[1].0[1] + t[2].0[2]
    }

    proptest! {
        #[test]
        fn swapping_the_particles_changes_nothing(volume in 0.1..10.0, r in vector(), f in vector()) {
            prop_assert_eq!(pair_stress(volume, r, f), pair_stress(volume, -r, -f));
        }

        #[test]
        fn attraction_is_tension(volume in 0.1..10.0, r in vector(), pull in 0.1..10.0) {
            prop_assume!(r.norm() > 0.1);
            prop_assert!(trace(pair_stress(volume, r, r * pull)) > 0.0);
        }

        /// A small deformation `g` displaces j relative to i by `g r`.
        #[test]
        fn the_stress_does_the_work_of_the_pair(volume in 0.1..10.0, r in vector(), f in vector(), g in prop::array::uniform3(vector())) {
            let sigma = pair_stress(volume, r, f);
            let work: f64 = (0..3).map(|b| (0..3).map(|a| sigma[a].0[b] * g[b].0[a]).sum::<f64>()).sum();
            let displaced = Vec3(g.map(|row| row.dot(r)));
            prop_assert!((volume * work - f.dot(displaced)).abs() < 1e-12);
        }

        #[test]
        fn a_central_force_gives_a_symmetric_stress(volume in 0.1..10.0, r in vector(), pull in -10.0..10.0) {
            let sigma = pair_stress(volume, r, r * pull);
            for a in 0..3 {
                for b in 0..3 {
                    prop_assert!((sigma[a].0[b] - sigma[b].0[a]).abs() <= 1e-15 * (r.dot(r) * pull / volume).abs());
                }
            }
        }

        #[test]
        fn the_pressure_of_motion_is_two_thirds_of_its_energy_density_and_along_the_velocity(volume in 0.1..10.0, m in 0.1..10.0, v in vector(), w in vector()) {
            let sigma = kinetic_stress(volume, m, v);
            prop_assert!((trace(sigma) / 3.0 + 2.0 / 3.0 * translational_energy(m, v) / volume).abs() < 1e-11);
            let across = w.perpendicular_to(v * (1.0 / v.norm()));
            prop_assert!(sigma.iter().all(|row| row.dot(across).abs() < 1e-11));
        }

        #[test]
        fn motion_is_pressure(volume in 0.1..10.0, m in 0.1..10.0, v in vector()) {
            prop_assume!(v.norm() > 0.1);
            prop_assert!(trace(kinetic_stress(volume, m, v)) < 0.0);
        }
    }
}
