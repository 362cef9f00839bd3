//! A pair in a strained body: its separation in Cartesian and spherical components, and its energy.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.50**, Appendix A.2.2: separation of a pair along x in a body strained by `epsilon_x`.
///
/// ```math
/// \delta_x = 2 r \varepsilon_x \cos\phi \cos\theta
/// ```
///
/// # Reading
///
/// Erratum: the paper calls $\theta$ the polar angle, but in every formula from here to A.56 it is the latitude, which is
/// zero on the equator. The neighbour lies at $2r (\cos\phi \cos\theta, \sin\phi \cos\theta, \sin\theta)$.
///
/// Effect: with a polar angle a neighbour on the third axis would be taken for one in the plane of the other two.
///
/// Proof: `theta_is_a_latitude`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius |
/// | `epsilon_x` | $\varepsilon_x$ | 1 | any | strain along x |
/// | `phi` | $\phi$ | rad | any | azimuth of the neighbour |
/// | `theta` | $\theta$ | rad | [-pi/2, pi/2] | latitude of the neighbour |
/// | → `delta_x` | $\delta_x$ | m | | separation along x |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `theta_is_a_latitude`
/// * `a_uniform_strain_in_the_plane_stretches_its_pairs_alike`
#[inline(always)]
pub fn separation_x<R: Real>(r: R, epsilon_x: R, phi: R, theta: R) -> R {
    R::lit(2.0) * r * epsilon_x * phi.cos() * theta.cos()
}

/// **Eq. A.51**, Appendix A.2.2: separation of a pair along z in a body strained by `epsilon_z`.
///
/// ```math
/// \delta_z = 2 r \varepsilon_z \sin\theta
/// ```
///
/// # Reading
///
/// As printed, with the latitude.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius |
/// | `epsilon_z` | $\varepsilon_z$ | 1 | any | strain along z |
/// | `theta` | $\theta$ | rad | [-pi/2, pi/2] | latitude of the neighbour |
/// | → `delta_z` | $\delta_z$ | m | | separation along z |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `theta_is_a_latitude`
/// * `a_uniform_strain_in_the_plane_stretches_its_pairs_alike`
#[inline(always)]
pub fn separation_z<R: Real>(r: R, epsilon_z: R, theta: R) -> R {
    R::lit(2.0) * r * epsilon_z * theta.sin()
}

/// **Eq. A.52**, Appendix A.2.2: radial component of the separation.
///
/// ```math
/// \delta_r = \delta_x \cos\phi \cos\theta + \delta_z \sin\theta
/// ```
///
/// # Reading
///
/// As printed; it is the normal separation of the pair.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `delta_x` | $\delta_x$ | m | any | separation along x |
/// | `delta_z` | $\delta_z$ | m | any | separation along z |
/// | `phi` | $\phi$ | rad | any | azimuth of the neighbour |
/// | `theta` | $\theta$ | rad | [-pi/2, pi/2] | latitude of the neighbour |
/// | → `delta_r` | $\delta_r$ | m | | radial separation |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_spherical_components_keep_the_length`
/// * `the_components_point_outwards_north_and_east`
/// * `a_uniform_strain_in_the_plane_stretches_its_pairs_alike`
#[inline(always)]
pub fn separation_radial<R: Real>(delta_x: R, delta_z: R, phi: R, theta: R) -> R {
    delta_x * phi.cos() * theta.cos() + delta_z * theta.sin()
}

/// **Eq. A.53**, Appendix A.2.2: component of the separation towards the north.
///
/// ```math
/// \delta_\theta = -\delta_x \cos\phi \sin\theta + \delta_z \cos\theta
/// ```
///
/// # Reading
///
/// As printed.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `delta_x` | $\delta_x$ | m | any | separation along x |
/// | `delta_z` | $\delta_z$ | m | any | separation along z |
/// | `phi` | $\phi$ | rad | any | azimuth of the neighbour |
/// | `theta` | $\theta$ | rad | [-pi/2, pi/2] | latitude of the neighbour |
/// | → `delta_theta` | $\delta_\theta$ | m | | separation along the meridian |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_spherical_components_keep_the_length`
/// * `the_components_point_outwards_north_and_east`
/// * `a_uniform_strain_in_the_plane_stretches_its_pairs_alike`
#[inline(always)]
pub fn separation_meridional<R: Real>(delta_x: R, delta_z: R, phi: R, theta: R) -> R {
    -delta_x * phi.cos() * theta.sin() + delta_z * theta.cos()
}

/// **Eq. A.54**, Appendix A.2.2: component of the separation towards the east.
///
/// ```math
/// \delta_\phi = -\delta_x \sin\phi
/// ```
///
/// # Reading
///
/// As printed.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `delta_x` | $\delta_x$ | m | any | separation along x |
/// | `phi` | $\phi$ | rad | any | azimuth of the neighbour |
/// | → `delta_phi` | $\delta_\phi$ | m | | separation along the parallel |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_spherical_components_keep_the_length`
/// * `the_components_point_outwards_north_and_east`
#[inline(always)]
pub fn separation_zonal<R: Real>(delta_x: R, phi: R) -> R {
    -delta_x * phi.sin()
}

/// **Eq. A.55**, Appendix A.2.2: energy of a pair in the elastic range.
///
/// ```math
/// U_{\text{pair}} = \frac12 k_N \delta_N^2 + \frac12 k_T (\delta_\theta^2 + \delta_\phi^2)
/// ```
///
/// # Reading
///
/// As printed.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | >= 0 | normal stiffness |
/// | `k_t` | $k_T$ | N/m | >= 0 | tangential stiffness |
/// | `delta_n` | $\delta_N$ | m | any | radial separation |
/// | `delta_theta` | $\delta_\theta$ | m | any | separation along the meridian |
/// | `delta_phi` | $\delta_\phi$ | m | any | separation along the parallel |
/// | → `u_pair` | $U_{\text{pair}}$ | J | | energy of the pair |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `equal_stiffnesses_store_the_square_of_the_length`
#[inline(always)]
pub fn pair_strain_energy<R: Real>(k_n: R, k_t: R, delta_n: R, delta_theta: R, delta_phi: R) -> R {
    let half = R::lit(0.5);
    half * k_n * delta_n.squared() + half * k_t * (delta_theta.squared() + delta_phi.squared())
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a50_pair_strain.rs", "wear-A50", ["A50"], separation_x),
        equation!("wear/a50_pair_strain.rs", "wear-A51", ["A51"], separation_z),
        equation!("wear/a50_pair_strain.rs", "wear-A52", ["A52"], separation_radial),
        equation!("wear/a50_pair_strain.rs", "wear-A53", ["A53"], separation_meridional),
        equation!("wear/a50_pair_strain.rs", "wear-A54", ["A54"], separation_zonal),
        equation!("wear/a50_pair_strain.rs", "wear-A55", ["A55"], pair_strain_energy),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use proptest::prelude::*;
    use std::f64::consts::FRAC_PI_2;

    const ROUNDING: f64 = 16.0 * f64::EPSILON;

    proptest! {
        /// Strain along x stretches the pair that lies along x, on the equator, and does not affect the pair at the
        /// pole; measured from the pole, theta would give the opposite.
        #[test]
        fn theta_is_a_latitude(r in 0.1..10.0, epsilon in 0.001..0.1) {
            prop_assert_eq!(separation_x(r, epsilon, 0.0, 0.0), 2.0 * r * epsilon);
            assert_abs_diff_eq!(separation_x(r, epsilon, 0.0, FRAC_PI_2), 0.0, epsilon = ROUNDING);
            prop_assert_eq!(separation_z(r, epsilon, 0.0), 0.0);
            assert_relative_eq!(separation_z(r, epsilon, FRAC_PI_2), 2.0 * r * epsilon, max_relative = ROUNDING);
        }

        /// An equal strain along x and z separates every pair in their plane along its own direction.
        #[test]
        fn a_uniform_strain_in_the_plane_stretches_its_pairs_alike(theta in -1.5..1.5, epsilon in -0.1..0.1) {
            let (x, z) = (separation_x(1.0, epsilon, 0.0, theta), separation_z(1.0, epsilon, theta));
            assert_abs_diff_eq!(separation_radial(x, z, 0.0, theta), 2.0 * epsilon, epsilon = ROUNDING);
            assert_abs_diff_eq!(separation_meridional(x, z, 0.0, theta), 0.0, epsilon = ROUNDING);
        }

        #[test]
        fn the_spherical_components_keep_the_length(
            (phi, theta) in (0.0..6.3, -1.5..1.5), (x, z) in (-1.0f64..1.0, 0.1f64..1.0),
        ) {
            let r = separation_radial(x, z, phi, theta);
            let north = separation_meridional(x, z, phi, theta);
            let east = separation_zonal(x, phi);
            let squares = r * r + north * north + east * east;
            assert_relative_eq!(squares, x * x + z * z, epsilon = 0.0, max_relative = ROUNDING);
        }

        /// On the equator outwards is along x at phi = 0, north along z, and east along minus x at phi = pi/2.
        #[test]
        fn the_components_point_outwards_north_and_east(x in 0.1..1.0, z in 0.1..1.0, phi in 0.0..6.3) {
            prop_assert_eq!((separation_radial(x, 0.0, 0.0, 0.0), separation_meridional(0.0, z, phi, 0.0)), (x, z));
            assert_relative_eq!(separation_radial(0.0, z, phi, FRAC_PI_2), z, max_relative = ROUNDING);
            assert_relative_eq!(separation_zonal(x, FRAC_PI_2), -x, max_relative = ROUNDING);
        }

        #[test]
        fn equal_stiffnesses_store_the_square_of_the_length(
            k in 0.1f64..10.0, (a, b, c) in (0.1f64..1.0, -1.0f64..1.0, -1.0f64..1.0),
        ) {
            let expected = 0.5 * k * (a * a + b * b + c * c);
            assert_relative_eq!(pair_strain_energy(k, k, a, b, c), expected, epsilon = 0.0, max_relative = ROUNDING);
        }
    }
}
