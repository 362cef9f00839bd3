//! The stress of a whole box.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// Momentum that a moving mass carries through faces normal to the axes, times the volume.
///
/// ```math
/// p_a = m v_a^2
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m` | $m$ | kg | > 0 | mass |
/// | `v` | $\mathbf{v}$ | m/s (3) | any | velocity |
/// | → `flux` | $p_a$ | J (3) |  | contribution to the diagonal |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `it_is_the_kinetic_part_of_the_virial_stress`
#[inline(always)]
pub fn momentum_flux<R: Real>(m: R, v: Vec3<R>) -> Vec3<R> {
    Vec3(v.0.map(|v_a| m * v_a * v_a))
}

/// Diagonal of the stress of a box, positive in tension.
///
/// ```math
/// \sigma_a = \frac{1}{V} \left(\sum r_a f_a - \sum m v_a^2\right)
/// ```
///
/// # Reading
///
/// The sums of [`pair_stress`](super::virial::pair_stress) and [`kinetic_stress`](super::virial::kinetic_stress) over all pairs and particles of the box, divided by
/// the volume once. Each pair counts once, with its branch vector from i to j and the force on i.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `virial` | $\sum r_a f_a$ | J (3) | any | sum over the pairs |
/// | `flux` | $\sum m v_a^2$ | J (3) | any | sum over the particles |
/// | `volume` | $V$ | m^3 | > 0 | volume of the box |
/// | → `sigma` | $\sigma_a$ | Pa (3) |  | stress |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `it_sums_the_virial_stress_of_pairs_and_particles`
#[inline(always)]
pub fn box_stress<R: Real>(virial: Vec3<R>, flux: Vec3<R>, volume: R) -> Vec3<R> {
    Vec3(std::array::from_fn(|a| (virial.0[a] - flux.0[a]) / volume))
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/box_stress.rs", "mechanics-momentum-flux", [], momentum_flux),
        equation!("mechanics/box_stress.rs", "mechanics-box-stress", [], box_stress),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::vector;
    use crate::mechanics::virial::{kinetic_stress, pair_stress};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn it_is_the_kinetic_part_of_the_virial_stress(m in 0.1..10.0f64, v in vector(), volume in 0.1..10.0f64) {
            let (flux, stress) = (momentum_flux(m, v), kinetic_stress(volume, m, v));
            prop_assert!((0..3).all(|a| (stress[a].0[a] * volume + flux.0[a]).abs() < 1e-14 * m));
        }

        #[test]
        fn it_sums_the_virial_stress_of_pairs_and_particles(r in vector(), f in vector(), m in 0.1..10.0f64, v in vector(), volume in 0.1..10.0f64) {
            let sigma = box_stress(Vec3(std::array::from_fn(|a| r.0[a] * f.0[a])), momentum_flux(m, v), volume);
            let (pair, motion) = (pair_stress(volume, r, f), kinetic_stress(volume, m, v));
            prop_assert!((0..3).all(|a| (sigma.0[a] - pair[a].0[a] - motion[a].0[a]).abs() < 1e-14 * (1.0 + m) / volume));
        }
    }
}
