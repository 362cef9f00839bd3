//! Relative velocity of two surfaces.
//!
//! Equations and sections are numbered as in Demidov, Gor & Khalizov 2024.

use super::pair_geometry::{arm, gap, normal};
use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Eq. 4**, Section 2.1.1: velocity of j relative to i at their contact point.
///
/// ```math
/// \mathbf{v}_{ij} = \mathbf{v}_j - \mathbf{v}_i + \boldsymbol{\omega}_j \times a \mathbf{n} + \boldsymbol{\omega}_i \times a \mathbf{n}
/// ```
///
/// # Reading
///
/// Erratum: both angular velocities have the wrong sign for the normal of Eq. 3. The contact point lies at $+a\mathbf{n}$ from the centre of i and at $-a\mathbf{n}$ from that of j, so
/// $\mathbf{v}_{ij} = \mathbf{v}_j - \mathbf{v}_i - \boldsymbol{\omega}_j \times a_j \mathbf{n} - \boldsymbol{\omega}_i \times a_i \mathbf{n}$.
///
/// Effect: with the printed signs a pair that rotates as one body slides, and a necked pair that is pushed aside accelerates without bound.
///
/// Proof: `a_pair_that_turns_as_one_body_has_no_relative_velocity_which_the_printed_signs_give_it`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, distinct from `x_i` |
/// | `v_i` | $\mathbf{v}_i$ | m/s (3) | any | velocity of i |
/// | `v_j` | $\mathbf{v}_j$ | m/s (3) | any | velocity of j |
/// | `omega_i` | $\boldsymbol{\omega}_i$ | rad/s (3) | any | angular velocity of i |
/// | `omega_j` | $\boldsymbol{\omega}_j$ | rad/s (3) | any | angular velocity of j |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | → `v_ij` | $\mathbf{v}_{ij}$ | m/s (3) | | relative velocity |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `a_pair_that_turns_as_one_body_has_no_relative_velocity_which_the_printed_signs_give_it`
/// * `rolling_on_each_other_without_sliding_is_no_relative_velocity`
/// * `swapping_the_particles_reverses_it`
#[inline(always)]
pub fn relative_velocity<R: Real>(
    x_i: Vec3<R>,
    x_j: Vec3<R>,
    v_i: Vec3<R>,
    v_j: Vec3<R>,
    omega_i: Vec3<R>,
    omega_j: Vec3<R>,
    r_i: R,
    r_j: R,
) -> Vec3<R> {
    let delta = gap(x_i, x_j, r_i, r_j);
    at_contact(v_j - v_i, omega_i, omega_j, normal(x_i, x_j), arm(r_i, delta), arm(r_j, delta))
}

/// Eq. 4 for given normal and arms, with `v` the velocity of the centre of j relative to that of i.
#[inline(always)]
pub fn at_contact<R: Real>(v: Vec3<R>, omega_i: Vec3<R>, omega_j: Vec3<R>, n: Vec3<R>, a_i: R, a_j: R) -> Vec3<R> {
    v - (omega_j * a_j + omega_i * a_i).cross(n)
}

/// **Eq. 7**, Section 2.1.1: normal part of the relative velocity, the rate of the normal spring.
///
/// ```math
/// \mathbf{v}_{ij,\mathrm{n}} = (\mathbf{v}_{ij} \cdot \mathbf{n}) \, \mathbf{n}
/// ```
///
/// # Reading
///
/// As printed, with the relative velocity of Eq. 4 as read there. The contribution of the spins is perpendicular to the normal, whatever the radii: they cancel
/// and are omitted, so that rounding does not let a rotating sphere approach. The normal part is that of $\mathbf{v}_j - \mathbf{v}_i$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, distinct from `x_i` |
/// | `v_i` | $\mathbf{v}_i$ | m/s (3) | any | velocity of i |
/// | `v_j` | $\mathbf{v}_j$ | m/s (3) | any | velocity of j |
/// | `omega_i` | $\boldsymbol{\omega}_i$ | rad/s (3) | any | angular velocity of i |
/// | `omega_j` | $\boldsymbol{\omega}_j$ | rad/s (3) | any | angular velocity of j |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | → `v_n` | $\mathbf{v}_{ij,\mathrm{n}}$ | m/s (3) | | normal velocity |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `the_two_parts_are_perpendicular_and_add_up`
/// * `spheres_that_turn_on_the_spot_do_not_approach`
#[inline(always)]
pub fn normal_velocity<R: Real>(
    x_i: Vec3<R>,
    x_j: Vec3<R>,
    v_i: Vec3<R>,
    v_j: Vec3<R>,
    omega_i: Vec3<R>,
    omega_j: Vec3<R>,
    r_i: R,
    r_j: R,
) -> Vec3<R> {
    let _ = (omega_i, omega_j, r_i, r_j);
    let n = normal(x_i, x_j);
    n * (v_j - v_i).dot(n)
}

/// **Eq. 8**, Section 2.1.1: tangential part of the relative velocity, the rate of the tangential spring.
///
/// ```math
/// \mathbf{v}_{ij,\mathrm{t}} = \mathbf{v}_{ij} - (\mathbf{v}_{ij} \cdot \mathbf{n}) \, \mathbf{n}
/// ```
///
/// # Reading
///
/// As printed, with the relative velocity of Eq. 4 as read there.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, distinct from `x_i` |
/// | `v_i` | $\mathbf{v}_i$ | m/s (3) | any | velocity of i |
/// | `v_j` | $\mathbf{v}_j$ | m/s (3) | any | velocity of j |
/// | `omega_i` | $\boldsymbol{\omega}_i$ | rad/s (3) | any | angular velocity of i |
/// | `omega_j` | $\boldsymbol{\omega}_j$ | rad/s (3) | any | angular velocity of j |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | → `v_t` | $\mathbf{v}_{ij,\mathrm{t}}$ | m/s (3) | | sliding velocity |
///
/// Rounding: at most 11 ULP.
///
/// # Laws
///
/// * `the_two_parts_are_perpendicular_and_add_up`
#[inline(always)]
pub fn tangential_velocity<R: Real>(
    x_i: Vec3<R>,
    x_j: Vec3<R>,
    v_i: Vec3<R>,
    v_j: Vec3<R>,
    omega_i: Vec3<R>,
    omega_j: Vec3<R>,
    r_i: R,
    r_j: R,
) -> Vec3<R> {
    relative_velocity(x_i, x_j, v_i, v_j, omega_i, omega_j, r_i, r_j).perpendicular_to(normal(x_i, x_j))
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/relative_velocity.rs", "soot-4", ["4"], relative_velocity),
        equation!("mechanics/relative_velocity.rs", "soot-7", ["7"], normal_velocity),
        equation!("mechanics/relative_velocity.rs", "soot-8", ["8"], tangential_velocity),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::vector;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_pair_that_turns_as_one_body_has_no_relative_velocity_which_the_printed_signs_give_it(
            x in vector(), drift in vector(), omega in vector(), r_i in 0.1..2.0, r_j in 0.1..2.0,
        ) {
            prop_assume!(x.norm() > 0.1);
            let turning = |spin: Vec3<f64>| relative_velocity(Vec3::zero(), x, drift, drift + omega.cross(x), spin, spin, r_i, r_j);
            prop_assert!(turning(omega).norm() < 1e-13);
            // The printed signs are those of the opposite spins.
            prop_assert!((turning(-omega) - omega.cross(x) * 2.0).norm() < 1e-13);
        }

        #[test]
        fn rolling_on_each_other_without_sliding_is_no_relative_velocity(x in vector(), omega in vector(), r_i in 0.1..2.0, r_j in 0.1..2.0) {
            // Fixed centres, opposite spins inversely proportional to the arms, like gears.
            prop_assume!(x.norm() > 0.1);
            let zero = Vec3::zero();
            let delta = gap(zero, x, r_i, r_j);
            prop_assume!(arm(r_i, delta).abs() > 0.05 && arm(r_j, delta).abs() > 0.05);
            let (spin_i, spin_j) = (omega * (1.0 / arm(r_i, delta)), -omega * (1.0 / arm(r_j, delta)));
            prop_assert!(relative_velocity(zero, x, zero, zero, spin_i, spin_j, r_i, r_j).norm() < 1e-13);
        }

        #[test]
        fn swapping_the_particles_reverses_it(
            x in vector(), v_i in vector(), v_j in vector(), omega_i in vector(), omega_j in vector(), r_i in 0.1..2.0, r_j in 0.1..2.0,
        ) {
            prop_assume!(x.norm() > 0.1);
            let here = relative_velocity(Vec3::zero(), x, v_i, v_j, omega_i, omega_j, r_i, r_j);
            let there = relative_velocity(x, Vec3::zero(), v_j, v_i, omega_j, omega_i, r_j, r_i);
            prop_assert!((here + there).norm() < 1e-13);
        }

        #[test]
        fn the_two_parts_are_perpendicular_and_add_up(
            x in vector(), v_i in vector(), v_j in vector(), omega_i in vector(), omega_j in vector(), r_i in 0.1..2.0, r_j in 0.1..2.0,
        ) {
            prop_assume!(x.norm() > 0.1);
            let zero = Vec3::zero();
            let normal = normal_velocity(zero, x, v_i, v_j, omega_i, omega_j, r_i, r_j);
            let tangential = tangential_velocity(zero, x, v_i, v_j, omega_i, omega_j, r_i, r_j);
            let both = relative_velocity(zero, x, v_i, v_j, omega_i, omega_j, r_i, r_j);
            prop_assert!((normal + tangential - both).norm() < 1e-13);
            prop_assert!(tangential.dot(x).abs() < 1e-12 && normal.cross(x).norm() < 1e-12);
        }

        #[test]
        fn spheres_that_turn_on_the_spot_do_not_approach(
            x in vector(), drift in vector(), omega_i in vector(), omega_j in vector(), r_i in 0.1..2.0, r_j in 0.1..2.0,
        ) {
            prop_assume!(x.norm() > 0.1);
            let turning = normal_velocity(Vec3::zero(), x, drift, drift, omega_i, omega_j, r_i, r_j);
            prop_assert_eq!(turning.norm(), 0.0);
        }
    }
}
