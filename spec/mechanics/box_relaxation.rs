//! A box whose sides follow the stress inside it.
//!
//! Each side moves as the homogeneous deformation it imposes would: with the inertia of the spheres it carries along, damped critically for the
//! modulus of the material.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// Inertia of a homogeneous deformation of a box along one of its sides.
///
/// ```math
/// J = \frac{M L^2}{12}
/// ```
///
/// # Reading
///
/// A slab of uniform density whose points move in proportion to their distance from the middle.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `mass` | $M$ | kg | > 0 | mass in the box |
/// | `side` | $L$ | m | > 0 | length of the side |
/// | → `inertia` | $J$ | kg m^2 |  | inertia |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `it_sums_the_layers_of_the_slab`
#[inline(always)]
pub fn box_inertia<R: Real>(mass: R, side: R) -> R {
    mass * side * side / R::lit(12.0)
}

/// Rate of strain of a side after a time step under the stress of the box.
///
/// ```math
/// \dot\varepsilon_{n+1} = \dot\varepsilon_n - \left(\frac{V (\sigma - \sigma_0)}{J} + 2 \sqrt{\frac{V E}{J}} \, \dot\varepsilon_n\right) \Delta t
/// ```
///
/// # Reading
///
/// The stress, positive in tension, shortens the box; the modulus sets the damping, which is critical for a material of that modulus. A box
/// is then never slower than the sound that crosses it.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `rate` | $\dot\varepsilon_n$ | 1/s | any | rate of strain before |
/// | `excess` | $\sigma - \sigma_0$ | Pa | any | stress above its target |
/// | `modulus` | $E$ | Pa | >= 0 | Young's modulus of the material |
/// | `volume` | $V$ | m^3 | > 0 | volume of the box |
/// | `inertia` | $J$ | kg m^2 | > 0 | inertia of the side |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | → `rate_next` | $\dot\varepsilon_{n+1}$ | 1/s |  | rate of strain after |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `an_elastic_box_comes_to_rest_without_overshooting`
#[inline(always)]
pub fn box_strain_rate<R: Real>(rate: R, excess: R, modulus: R, volume: R, inertia: R, dt: R) -> R {
    let frequency = (volume * modulus / inertia).sqrt();
    let pull = volume * excess / inertia;
    rate - (pull + R::lit(2.0) * frequency * rate) * dt
}

/// Strain below which a growth in one time step is lost among the last digits of positions.
const LEAST_STRAIN: f64 = 4.0 * f64::EPSILON;

/// Rate of strain at which a side grows in a time step, and the rate that it owes to the next one.
///
/// ```math
/// (\dot\varepsilon, \dot\varepsilon_o') =
/// \begin{cases}
/// (0, \dot\varepsilon_n + \dot\varepsilon_o) & |\dot\varepsilon_n + \dot\varepsilon_o| \, \Delta t < 2^{-50} \\
/// (\dot\varepsilon_n + \dot\varepsilon_o, 0) & \text{otherwise}
/// \end{cases}
/// ```
///
/// # Reading
///
/// A box of many spheres comes to rest by strains of less than the rounding of a position in each step. They are added up until they can move
/// something: otherwise the box stops while stress remains in it.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `rate` | $\dot\varepsilon_n$ | 1/s | any | rate of strain of the side |
/// | `owed` | $\dot\varepsilon_o$ | 1/s | any | rate of the steps before in which it did not grow |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | → `growing` | $\dot\varepsilon$ | 1/s |  | rate at which it grows |
/// | → `owed_next` | $\dot\varepsilon_o'$ | 1/s |  | rate that it owes |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_strain_is_only_postponed`
/// * `a_side_that_grows_grows_by_more_than_its_rounding`
#[inline(always)]
pub fn growing_rate<R: Real>(rate: R, owed: R, dt: R) -> (R, R) {
    let whole = rate + owed;
    let waits = (whole * dt).abs().lt(R::lit(LEAST_STRAIN));
    (R::select(waits, R::zero(), whole), R::select(waits, whole, R::zero()))
}

/// Factor by which a side and all positions along it grow in a time step.
///
/// ```math
/// g = 1 + \dot\varepsilon \, \Delta t
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `rate` | $\dot\varepsilon$ | 1/s | any | rate of strain |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | → `factor` | $g$ | 1 |  | factor |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `many_short_steps_are_the_exponential_of_the_strain`
#[inline(always)]
pub fn growth<R: Real>(rate: R, dt: R) -> R {
    R::one() + rate * dt
}

/// Work of the sides of a box on the spheres inside it in a time step.
///
/// ```math
/// W = \sum_a (g_a - 1) \sum r_a f_a
/// ```
///
/// # Reading
///
/// Only the static part of the stress works: velocities are not scaled with the box.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `virial` | $\sum r_a f_a$ | J (3) | any | sum over the pairs, by axis |
/// | `factor` | $g_a$ | 1 (3) | any | factors by which the sides grow |
/// | → `work` | $W$ | J |  | work |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_work_stretches_a_spring_between_two_faces`
/// * `each_side_works_alone`
#[inline(always)]
pub fn box_work<R: Real>(virial: Vec3<R>, factor: Vec3<R>) -> R {
    let [x, y, z]: [R; 3] = std::array::from_fn(|a| virial.0[a] * (factor.0[a] - R::one()));
    x + y + z
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/box_relaxation.rs", "mechanics-box-inertia", [], box_inertia),
        equation!("mechanics/box_relaxation.rs", "mechanics-box-strain-rate", [], box_strain_rate),
        equation!("mechanics/box_relaxation.rs", "mechanics-growth", [], growth),
        equation!("mechanics/box_relaxation.rs", "mechanics-growing-rate", [], growing_rate),
        equation!("mechanics/box_relaxation.rs", "mechanics-box-work", [], box_work),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn it_sums_the_layers_of_the_slab(mass in 0.1..10.0f64, side in 0.1..10.0f64) {
            let layers = 1000;
            let sum: f64 = (0..layers)
                .map(|k| ((f64::from(k) + 0.5) / f64::from(layers) - 0.5) * side)
                .map(|z| mass / f64::from(layers) * z * z)
                .sum();
            prop_assert!((box_inertia(mass, side) / sum - 1.0).abs() < 1e-5);
        }

        #[test]
        fn an_elastic_box_comes_to_rest_without_overshooting(modulus in 0.1..10.0f64, volume in 0.1..10.0f64, inertia in 0.1..10.0f64, start in 0.01..0.1f64) {
            // A box that is stretched by a strain pulls back with the stress of its modulus.
            let dt = 1e-2 * (inertia / (volume * modulus)).sqrt();
            let (mut strain, mut rate) = (start, 0.0);
            for step in 1..=2000 {
                rate = box_strain_rate(rate, modulus * strain, modulus, volume, inertia, dt);
                strain += rate * dt;
                prop_assert!(strain > -1e-3 * start);
                // the aperiodic limit, which a step of a hundredth follows within a hundredth
                let phase = f64::from(step) * 1e-2;
                prop_assert!((strain - start * (1.0 + phase) * (-phase).exp()).abs() < 1e-2 * start);
            }
            prop_assert!(strain.abs() < 1e-3 * start);
        }

        #[test]
        fn a_strain_is_only_postponed(rates in prop::collection::vec(-9.0..9.0f64, 1..100), dt in 1e-17..1e-15f64) {
            let (mut owed, mut grown) = (0.0, 0.0);
            for &rate in &rates {
                let growing;
                (growing, owed) = growing_rate(rate, owed, dt);
                prop_assert!(growing == 0.0 || owed == 0.0);
                grown += growing;
            }
            prop_assert!((grown + owed - rates.iter().sum::<f64>()).abs() < 1e-11);
            prop_assert!(owed.abs() * dt < LEAST_STRAIN);
        }

        #[test]
        fn a_side_that_grows_grows_by_more_than_its_rounding(rate in -9.0..9.0f64, owed in -9.0..9.0f64, scale in -20.0..0.0f64) {
            let dt = 10f64.powf(scale);
            let (growing, _) = growing_rate(rate, owed, dt);
            prop_assert_eq!(growing == 0.0, (rate + owed).abs() * dt < LEAST_STRAIN);
            prop_assert_eq!(growth(growing, dt) == 1.0, growing == 0.0);
            prop_assert_eq!(growing_rate(LEAST_STRAIN, 0.0, 1.0), (LEAST_STRAIN, 0.0));
        }

        #[test]
        fn many_short_steps_are_the_exponential_of_the_strain(rate in -1.0..1.0f64) {
            let steps = 100_000;
            let grown = growth(rate, 1.0 / f64::from(steps)).powi(steps);
            prop_assert!((grown / rate.exp() - 1.0).abs() < 1e-5);
            prop_assert_eq!(growth(rate, 0.0), 1.0);
        }

        #[test]
        fn the_work_stretches_a_spring_between_two_faces(k in 0.1..10.0f64, side in 0.1..10.0f64, strain in 0.0..0.1f64) {
            // A spring along x, relaxed at first: small steps of its stretching add up to its energy.
            let steps = 10_000;
            let (mut length, mut work) = (side, 0.0);
            let factor = (strain / f64::from(steps)).exp();
            for _ in 0..steps {
                let pull = k * (length - side);
                work += box_work(Vec3::new(length * pull, 0.0, 0.0), Vec3::new(factor, 1.0, 1.0));
                length *= factor;
            }
            prop_assert!((work - 0.5 * k * (length - side) * (length - side)).abs() <= 1e-3 * k * side * side * strain * strain);
        }

        #[test]
        fn each_side_works_alone(virial in prop::array::uniform3(-9.0..9.0f64), strain in prop::array::uniform3(-0.1..0.1f64)) {
            let found = box_work(Vec3(virial), Vec3(strain.map(|strain| 1.0 + strain)));
            let expected: f64 = (0..3).map(|axis| virial[axis] * strain[axis]).sum();
            prop_assert!((found - expected).abs() < 1e-14 * 27.0);
        }
    }
}
