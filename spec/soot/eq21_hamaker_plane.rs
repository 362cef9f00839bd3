//! Van der Waals attraction of a sphere and a plane: the substrate, the tip.

use super::eq18_hamaker::energy_of;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 21**, Section 2.1.4: energy of a sphere in front of a plane.
///
/// ```math
/// U = -\frac{A}{6} \left[\frac{r}{\delta} + \frac{r}{2r + \delta} + \ln \frac{\delta}{2r + \delta}\right]
/// ```
///
/// # Reading
///
/// The limit of Eq. 18, and like it evaluated by the series in $t = r/(r + \delta)$ if the sphere is far from the plane.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius |
/// | `delta` | $\delta$ | m | > 0 | gap |
/// | `a` | $A$ | J | >= 0 | Hamaker constant |
/// | → `u` | $U$ | J | | energy, zero for a sphere far away |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `a_plane_is_the_limit_of_a_large_sphere`
/// * `is_the_printed_energy_of_a_plane`
#[inline(always)]
pub fn plane_energy<R: Real>(r: R, delta: R, a: R) -> R {
    let far = R::lit(2.0) * r + delta;
    energy_of(r / (r + delta), r / delta + r / far, delta / far, a)
}

/// **Eq. 22**, Section 2.1.4: force on a sphere in front of a plane.
///
/// ```math
/// \mathbf{f} = \frac{2A}{3} \left[\frac{r^3}{\delta^2 (\delta + 2r)^2}\right] \mathbf{n}
/// ```
///
/// # Reading
///
/// The coefficient of the normal, which points from the sphere to the plane: attraction.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius |
/// | `delta` | $\delta$ | m | > 0 | gap |
/// | `a` | $A$ | J | >= 0 | Hamaker constant |
/// | → `f` | $\mathbf{f} \cdot \mathbf{n}$ | N | | attraction |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_force_of_a_plane_is_the_slope_of_its_energy`
/// * `a_plane_attracts_twice_as_much_as_an_equal_sphere_at_contact`
#[inline(always)]
pub fn plane_force<R: Real>(r: R, delta: R, a: R) -> R {
    R::lit(2.0) / R::lit(3.0) * a * (r * r * r) / (delta * (delta + R::lit(2.0) * r)).squared()
}

/// **Section 2.1.4**, unnumbered: force and energy in front of a plane with the saturation distance.
///
/// ```math
/// f(\delta) = f(\max(\delta, \delta_0)), \quad U(\delta) = U(\max(\delta, \delta_0)) - f \cdot (\max(\delta, \delta_0) - \delta)
/// ```
///
/// # Reading
///
/// As between spheres, see [`saturated_hamaker`](super::eq19_equal_hamaker::saturated_hamaker).
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius |
/// | `delta` | $\delta$ | m | any | gap, negative for an overlap |
/// | `a` | $A$ | J | >= 0 | Hamaker constant |
/// | `delta_0` | $\delta_0$ | m | > 0 | saturation distance |
/// | → `f` | $f$ | N | | attraction |
/// | → `u` | $U$ | J | | energy |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `saturated_in_front_of_a_plane_the_force_is_the_slope_of_its_energy`
#[inline(always)]
pub fn saturated_plane<R: Real>(r: R, delta: R, a: R, delta_0: R) -> (R, R) {
    let apart = delta.max(delta_0);
    let f = plane_force(r, apart, a);
    (f, plane_energy(r, apart, a) - f * (apart - delta))
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("soot/eq21_hamaker_plane.rs", "soot-21", ["21"], plane_energy),
        equation!("soot/eq21_hamaker_plane.rs", "soot-22", ["22"], plane_force),
        equation!("soot/eq21_hamaker_plane.rs", "soot-22-sat", [], saturated_plane),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::{Dual, Reference};
    use crate::soot::eq18_hamaker::{hamaker_energy, hamaker_force};
    use crate::soot::eq19_equal_hamaker::equal_hamaker_force;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_plane_is_the_limit_of_a_large_sphere(r in 0.1..10.0, delta in 0.01..10.0, a in 0.1..10.0) {
            let large = 1e9;
            prop_assert!((hamaker_energy(r, large, delta, a) / plane_energy(r, delta, a) - 1.0).abs() < 1e-6);
            prop_assert!((hamaker_force(r, large, delta, a) / plane_force(r, delta, a) - 1.0).abs() < 1e-6);
        }

        #[test]
        fn is_the_printed_energy_of_a_plane(r in 0.1..10.0, log_gap in -6.0..6.0f64, a in 0.1..10.0) {
            let [r, d, a] = [r, 10f64.powf(log_gap), a].map(Reference::exact);
            let far = Reference::exact(2.0) * r + d;
            let printed = -(a / Reference::exact(6.0)) * (r / d + r / far + (d / far).ln());
            prop_assert!(((plane_energy(r, d, a) - printed) / printed).abs().to_f64() < 1e-33);
        }

        #[test]
        fn the_force_of_a_plane_is_the_slope_of_its_energy(r in 0.1..10.0, log_gap in -3.0..3.0f64, a in 0.1..10.0) {
            let delta = 10f64.powf(log_gap);
            let slope = plane_energy(Dual::constant(r), Dual::variable(delta), Dual::constant(a)).slope;
            prop_assert!((plane_force(r, delta, a) / slope - 1.0).abs() < 1e-11);
        }

        #[test]
        fn a_plane_attracts_twice_as_much_as_an_equal_sphere_at_contact(r in 0.1..10.0) {
            let delta = 1e-7 * r;
            prop_assert!((plane_force(r, delta, 1.0) / equal_hamaker_force(r, delta, 1.0) - 2.0).abs() < 1e-5);
        }

        #[test]
        fn saturated_in_front_of_a_plane_the_force_is_the_slope_of_its_energy(r in 0.1..10.0, delta in -1.0..3.0, delta_0 in 0.1..1.0) {
            let [x, a, d] = [r, 2.0, delta_0].map(Dual::constant);
            let (f, u) = saturated_plane(x, Dual::variable(delta), a, d);
            prop_assert!((f.value / u.slope - 1.0).abs() < 1e-12);
            // farther away nothing is saturated
            let away = delta_0 + 0.5;
            prop_assert_eq!(saturated_plane(r, away, 2.0, delta_0), (plane_force(r, away, 2.0), plane_energy(r, away, 2.0)));
        }
    }
}
