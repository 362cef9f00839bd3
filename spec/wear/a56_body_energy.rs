//! From one pair to the body: the energy of all neighbours, the volume of a particle, the stress.

use super::a60_elastic_constants::{constant_11, constant_12};
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.56**, Appendix A.2.2: energy of a particle with neighbours in every direction.
///
/// ```math
/// U = \frac12 \int_{\phi=0}^{2\pi} \int_{\theta=-\pi/2}^{\pi/2} U_{\text{pair}} \cos\theta \, d\theta \, d\phi
/// ```
///
/// # Reading
///
/// The integral of A.50 to A.55, evaluated: with the latitude and its weight $\cos\theta$ it is
///
/// ```math
/// U = 4 \pi r^2 \left[\frac{3 k_N + 2 k_T}{15} (\varepsilon_x^2 + \varepsilon_z^2) +
///   \frac{2 (k_N - k_T)}{15} \varepsilon_x \varepsilon_z\right]
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius |
/// | `k_n` | $k_N$ | N/m | >= 0 | normal stiffness |
/// | `k_t` | $k_T$ | N/m | >= 0 | tangential stiffness |
/// | `epsilon_x` | $\varepsilon_x$ | 1 | any | strain along x |
/// | `epsilon_z` | $\varepsilon_z$ | 1 | any | strain along z |
/// | → `u` | $U$ | J | | energy with neighbours in all directions |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_the_integral_over_all_directions`
/// * `x_and_z_are_alike`
/// * `a_polar_angle_would_give_nothing`
#[inline(always)]
pub fn surrounded_energy<R: Real>(r: R, k_n: R, k_t: R, epsilon_x: R, epsilon_z: R) -> R {
    let (two, fifteen) = (R::lit(2.0), R::lit(15.0));
    let squares = (R::lit(3.0) * k_n + two * k_t) / fifteen * (epsilon_x.squared() + epsilon_z.squared());
    let mixed = two * (k_n - k_t) / fifteen * (epsilon_x * epsilon_z);
    R::lit(4.0) * R::pi() * r.squared() * (squares + mixed)
}

/// **Eq. A.57**, Appendix A.2.2: energy of a particle with twelve neighbours.
///
/// ```math
/// U' = \frac{12}{4\pi} U
/// ```
///
/// # Reading
///
/// As printed.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `u` | $U$ | J | >= 0 | energy with neighbours in all directions |
/// | → `u_prime` | $U'$ | J | | energy with twelve neighbours |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `twelve_times_the_mean_of_half_a_pair`
#[inline(always)]
pub fn close_packed_energy<R: Real>(u: R) -> R {
    R::lit(12.0) / (R::lit(4.0) * R::pi()) * u
}

/// **Eq. A.58**, Appendix A.2.2: volume of a particle and its share of the voids, in close packing.
///
/// ```math
/// V = 4 \sqrt2 r^3
/// ```
///
/// # Reading
///
/// As printed. The twelve neighbours "at the edges of a cube" are those of cubic close packing; hexagonal packing has the same
/// volume.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius |
/// | → `v` | $V$ | m^3 | | volume of the body per particle |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_a_quarter_of_the_cubic_cell`
/// * `spheres_fill_seventy_four_percent`
#[inline(always)]
pub fn close_packed_volume<R: Real>(r: R) -> R {
    R::lit(4.0) * R::lit(2.0).sqrt() * (r * r * r)
}

/// **Eq. A.59**, Appendix A.2.2: stress along x of the strained body.
///
/// ```math
/// \frac1V \frac{\partial U'}{\partial \varepsilon_x} = C_{11} \varepsilon_x + C_{12} \varepsilon_z
/// ```
///
/// # Reading
///
/// Evaluates the right-hand side, with A.60 and A.61; a law checks that it is the derivative.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius |
/// | `k_n` | $k_N$ | N/m | >= 0 | normal stiffness |
/// | `k_t` | $k_T$ | N/m | >= 0 | tangential stiffness |
/// | `epsilon_x` | $\varepsilon_x$ | 1 | any | strain along x |
/// | `epsilon_z` | $\varepsilon_z$ | 1 | any | strain along z |
/// | → `sigma_x` | $\sigma_x$ | Pa | | stress along x |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_stress_is_the_slope_of_the_energy`
#[inline(always)]
pub fn body_stress<R: Real>(r: R, k_n: R, k_t: R, epsilon_x: R, epsilon_z: R) -> R {
    constant_11(r, k_n, k_t) * epsilon_x + constant_12(r, k_n, k_t) * epsilon_z
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a56_body_energy.rs", "wear-A56", ["A56"], surrounded_energy),
        equation!("wear/a56_body_energy.rs", "wear-A57", ["A57"], close_packed_energy),
        equation!("wear/a56_body_energy.rs", "wear-A58", ["A58"], close_packed_volume),
        equation!("wear/a56_body_energy.rs", "wear-A59", ["A59"], body_stress),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::Dual;
    use crate::wear::a50_pair_strain::{
        pair_strain_energy, separation_meridional, separation_radial, separation_x, separation_z, separation_zonal,
    };
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use proptest::prelude::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    /// A.50 to A.55 for one neighbour.
    fn pair(r: f64, (k_n, k_t): (f64, f64), (e_x, e_z): (f64, f64), phi: f64, theta: f64) -> f64 {
        let (x, z) = (separation_x(r, e_x, phi, theta), separation_z(r, e_z, theta));
        let [radial, north] = [separation_radial, separation_meridional].map(|component| component(x, z, phi, theta));
        pair_strain_energy(k_n, k_t, radial, north, separation_zonal(x, phi))
    }
    /// Integral over all directions, theta running over half a turn that starts at `from`. In either angle the integrand
    /// is a sum of waves: equidistant points are exact for phi, and Gauss points more than sufficient for theta.
    fn integral(r: f64, k: (f64, f64), e: (f64, f64), from: f64) -> f64 {
        let gauss = [(0.0, 8.0), (0.6f64.sqrt(), 5.0), (-0.6f64.sqrt(), 5.0)];
        let (panels, azimuths) = (64, 8);
        let width = PI / f64::from(panels);
        let mut sum = 0.0;
        for (panel, (place, weight)) in (0..panels).flat_map(|panel| gauss.map(|point| (panel, point))) {
            let theta = from + width * (f64::from(panel) + 0.5 + 0.5 * place);
            for step in 0..azimuths {
                let phi = 2.0 * PI / f64::from(azimuths) * f64::from(step);
                sum += weight / 18.0 * width * theta.cos() * pair(r, k, e, phi, theta);
            }
        }
        0.5 * sum * 2.0 * PI / f64::from(azimuths)
    }

    proptest! {
        #[test]
        fn is_the_integral_over_all_directions(
            r in 0.5..2.0, k in (0.1..2.0, 0.0..2.0), e in (-0.1..0.1, 0.01..0.1),
        ) {
            let closed = surrounded_energy(r, k.0, k.1, e.0, e.1);
            // Gauss's rule of sixth order on 64 panels.
            assert_relative_eq!(closed, integral(r, k, e, -FRAC_PI_2), epsilon = 0.0, max_relative = 1e-8);
        }

        /// With theta measured from the pole, zero to pi, the weight cos(theta) is odd about the equator.
        #[test]
        fn a_polar_angle_would_give_nothing(k in (0.1..2.0, 0.0..2.0), e in (-0.1..0.1, 0.01..0.1)) {
            let scale = surrounded_energy(1.0, k.0, k.1, e.0, e.1);
            assert_abs_diff_eq!(integral(1.0, k, e, 0.0), 0.0, epsilon = 1e-13 * scale);
        }

        #[test]
        fn x_and_z_are_alike(k in (0.1..2.0, 0.0..2.0), e in (-0.1..0.1, -0.1..0.1)) {
            prop_assert_eq!(
                surrounded_energy(1.0, k.0, k.1, e.0, e.1),
                surrounded_energy(1.0, k.0, k.1, e.1, e.0)
            );
        }

        #[test]
        fn twelve_times_the_mean_of_half_a_pair(k in (0.1..2.0, 0.0..2.0), e in (-0.1..0.1, 0.01..0.1)) {
            // U is the sum of half a pair per unit of solid angle, 4 pi in all.
            let mean = integral(1.0, k, e, -FRAC_PI_2) / (4.0 * PI);
            let energy = close_packed_energy(surrounded_energy(1.0, k.0, k.1, e.0, e.1));
            assert_relative_eq!(energy, 12.0 * mean, epsilon = 0.0, max_relative = 1e-8);
        }

        #[test]
        fn is_a_quarter_of_the_cubic_cell(r in 0.1f64..10.0) {
            // Four particles in a cube whose face diagonal is four radii.
            let edge = 4.0 * r / 2f64.sqrt();
            let quarter = edge * edge * edge / 4.0;
            assert_relative_eq!(close_packed_volume(r), quarter, epsilon = 0.0, max_relative = 8.0 * f64::EPSILON);
        }

        #[test]
        fn the_stress_is_the_slope_of_the_energy(
            r in 0.5..2.0, k in (0.1..2.0, 0.0..2.0), e in (-0.1..0.1, -0.1..0.1),
        ) {
            let [r_d, k_n, k_t, e_z] = [r, k.0, k.1, e.1].map(Dual::constant);
            let energy = close_packed_energy(surrounded_energy(r_d, k_n, k_t, Dual::variable(e.0), e_z));
            let stress = body_stress(r, k.0, k.1, e.0, e.1);
            assert_abs_diff_eq!(energy.slope / close_packed_volume(r), stress, epsilon = 8.0 * f64::EPSILON);
        }
    }

    #[test]
    fn spheres_fill_seventy_four_percent() {
        assert_abs_diff_eq!(4.0 / 3.0 * PI / close_packed_volume(1.0), 0.74048, epsilon = 5e-6);
    }
}
