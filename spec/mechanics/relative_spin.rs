//! Relative rotation of two spheres.
//!
//! Equations and sections are numbered as in Demidov, Gor & Khalizov 2024.

use super::pair_geometry::{arm, gap, mean_arm, normal};
use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Eq. 9**, Section 2.1.1: angular velocity of j relative to i.
///
/// ```math
/// \boldsymbol{\omega}_{ij} = \boldsymbol{\omega}_j - \boldsymbol{\omega}_i
/// ```
///
/// # Reading
///
/// As printed: a spin that both share drops out.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `omega_i` | $\boldsymbol{\omega}_i$ | rad/s (3) | any | angular velocity of i |
/// | `omega_j` | $\boldsymbol{\omega}_j$ | rad/s (3) | any | angular velocity of j |
/// | → `omega_ij` | $\boldsymbol{\omega}_{ij}$ | rad/s (3) | | relative angular velocity |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_common_spin_drops_out`
#[inline(always)]
pub fn relative_spin<R: Real>(omega_i: Vec3<R>, omega_j: Vec3<R>) -> Vec3<R> {
    omega_j - omega_i
}

/// **Eq. 10**, Section 2.1.1: torsion, the part of the relative angular velocity along the normal.
///
/// ```math
/// \boldsymbol{\omega}_{ij,\mathrm{n}} = (\boldsymbol{\omega}_{ij} \cdot \mathbf{n}) \, \mathbf{n}
/// ```
///
/// # Reading
///
/// As printed.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, distinct from `x_i` |
/// | `omega_i` | $\boldsymbol{\omega}_i$ | rad/s (3) | any | angular velocity of i |
/// | `omega_j` | $\boldsymbol{\omega}_j$ | rad/s (3) | any | angular velocity of j |
/// | → `omega_n` | $\boldsymbol{\omega}_{ij,\mathrm{n}}$ | rad/s (3) | | torsional angular velocity |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `torsion_and_rolling_are_perpendicular_and_add_up`
#[inline(always)]
pub fn torsional_spin<R: Real>(x_i: Vec3<R>, x_j: Vec3<R>, omega_i: Vec3<R>, omega_j: Vec3<R>) -> Vec3<R> {
    let n = normal(x_i, x_j);
    n * relative_spin(omega_i, omega_j).dot(n)
}

/// **Eq. 11**, Section 2.1.1: rolling, the part of the relative angular velocity in the contact plane.
///
/// ```math
/// \boldsymbol{\omega}_{ij,\mathrm{r}} = \boldsymbol{\omega}_{ij} - (\boldsymbol{\omega}_{ij} \cdot \mathbf{n}) \, \mathbf{n}
/// ```
///
/// # Reading
///
/// As printed.
///
/// Where the axis and a component of the spin nearly agree, little of that component is left: such pairs determine the rounding bound.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, distinct from `x_i` |
/// | `omega_i` | $\boldsymbol{\omega}_i$ | rad/s (3) | any | angular velocity of i |
/// | `omega_j` | $\boldsymbol{\omega}_j$ | rad/s (3) | any | angular velocity of j |
/// | → `omega_r` | $\boldsymbol{\omega}_{ij,\mathrm{r}}$ | rad/s (3) | | rolling angular velocity |
///
/// Rounding: at most 14 ULP.
///
/// # Laws
///
/// * `torsion_and_rolling_are_perpendicular_and_add_up`
#[inline(always)]
pub fn rolling_spin<R: Real>(x_i: Vec3<R>, x_j: Vec3<R>, omega_i: Vec3<R>, omega_j: Vec3<R>) -> Vec3<R> {
    relative_spin(omega_i, omega_j).perpendicular_to(normal(x_i, x_j))
}

/// **Section 2.1.1**, unnumbered: rates at which rotation stretches the rolling and the torsion spring.
///
/// ```math
/// \dot{\boldsymbol{\xi}}_\mathrm{r} = \boldsymbol{\omega}_{ij,\mathrm{r}} \times a \mathbf{n}, \quad
/// \dot{\boldsymbol{\xi}}_\mathrm{o} = r \boldsymbol{\omega}_{ij,\mathrm{n}}
/// ```
///
/// # Reading
///
/// For unequal spheres $a$ and $r$ are the [`mean_arm`]s of the two arms and of the two radii. The rates of the normal and the tangential spring are Eqs. 7 and 8.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, distinct from `x_i` |
/// | `omega_i` | $\boldsymbol{\omega}_i$ | rad/s (3) | any | angular velocity of i |
/// | `omega_j` | $\boldsymbol{\omega}_j$ | rad/s (3) | any | angular velocity of j |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | → `rate_rolling` | $\dot{\boldsymbol{\xi}}_\mathrm{r}$ | m/s (3) | | rate of the rolling spring, in the contact plane |
/// | → `rate_torsion` | $\dot{\boldsymbol{\xi}}_\mathrm{o}$ | m/s (3) | | rate of the torsion spring, along the normal |
///
/// Rounding: at most 3 ULP.
///
/// # Laws
///
/// * `seen_from_the_other_particle_rolling_is_the_same_and_torsion_reversed`
/// * `equal_spheres_in_touch_roll_against_the_ways_of_both_contact_points`
#[inline(always)]
pub fn turning_rates<R: Real>(
    x_i: Vec3<R>,
    x_j: Vec3<R>,
    omega_i: Vec3<R>,
    omega_j: Vec3<R>,
    r_i: R,
    r_j: R,
) -> (Vec3<R>, Vec3<R>) {
    let (n, delta) = (normal(x_i, x_j), gap(x_i, x_j, r_i, r_j));
    let spin = relative_spin(omega_i, omega_j);
    let a = mean_arm(arm(r_i, delta), arm(r_j, delta));
    (rolling_rate(spin, n, a), n * torsion_rate(spin, n, mean_arm(r_i, r_j)))
}

/// Rate of the rolling spring for a relative angular velocity, a normal and an arm. The torsional part drops out of the product.
#[inline(always)]
pub fn rolling_rate<R: Real>(spin: Vec3<R>, n: Vec3<R>, a: R) -> Vec3<R> {
    spin.cross(n) * a
}

/// Rate of the torsion spring along the normal.
#[inline(always)]
pub fn torsion_rate<R: Real>(spin: Vec3<R>, n: Vec3<R>, r: R) -> R {
    r * spin.dot(n)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/relative_spin.rs", "soot-9", ["9"], relative_spin),
        equation!("mechanics/relative_spin.rs", "soot-10", ["10"], torsional_spin),
        equation!("mechanics/relative_spin.rs", "soot-11", ["11"], rolling_spin),
        equation!("mechanics/relative_spin.rs", "soot-rates", [], turning_rates),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::{unit, vector};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_common_spin_drops_out(omega in vector(), other in vector()) {
            let relative: Vec3<f64> = relative_spin(omega, omega + other);
            prop_assert!((relative - other).norm() < 1e-15);
            prop_assert_eq!(relative_spin(omega, omega), Vec3::zero());
        }

        #[test]
        fn torsion_and_rolling_are_perpendicular_and_add_up(x in vector(), omega_i in vector(), omega_j in vector()) {
            prop_assume!(x.norm() > 0.1);
            let (torsion, rolling) = (torsional_spin(Vec3::zero(), x, omega_i, omega_j), rolling_spin(Vec3::zero(), x, omega_i, omega_j));
            prop_assert!((torsion + rolling - (omega_j - omega_i)).norm() < 1e-14);
            prop_assert!(torsion.cross(x).norm() < 1e-14 && rolling.dot(x).abs() < 1e-14);
        }

        #[test]
        fn equal_spheres_in_touch_roll_against_the_ways_of_both_contact_points(n in unit(), omega_i in vector(), omega_j in vector(), r in 0.1..3.0) {
            let (rolling, torsion) = turning_rates(Vec3::zero(), n * (2.0 * r), omega_i, omega_j, r, r);
            let ways = omega_i.cross(n * r) + omega_j.cross(n * -r);
            prop_assert!((rolling + ways).norm() < 1e-13);
            prop_assert!((torsion - n * (r * (omega_j - omega_i).dot(n))).norm() < 1e-13);
        }

        #[test]
        fn seen_from_the_other_particle_rolling_is_the_same_and_torsion_reversed(
            x in vector(), omega_i in vector(), omega_j in vector(), r_i in 0.1..0.3, r_j in 0.1..0.3,
        ) {
            prop_assume!(x.norm() > 0.1);
            let here = turning_rates(Vec3::zero(), x, omega_i, omega_j, r_i, r_j);
            let there = turning_rates(x, Vec3::zero(), omega_j, omega_i, r_j, r_i);
            // Springs in space: rolling turns round with its normal and its spin; torsion lies along what both agree upon.
            prop_assert!((here.0 - there.0).norm() < 1e-13);
            prop_assert!((here.1 + there.1).norm() < 1e-13);
        }
    }
}
