//! Positions and velocities of two particles relative to their contact point.

use crate::equation::Equation;
use crate::{Contact, Real, Vec3, equation};

/// **Section 2**, unnumbered: separation of the surfaces, their normal, and the normal velocity.
///
/// ```math
/// \delta_N = d_{ij} - r_i - r_j, \quad \mathbf{n}_N = \frac{\mathbf{x}_i - \mathbf{x}_j}{d_{ij}}, \quad
/// v_N = (\mathbf{v}_i - \mathbf{v}_j) \cdot \mathbf{n}_N = \dot\delta_N
/// ```
///
/// # Reading
///
/// The paper does not state the direction of the normal. A positive force of Eq. 2 attracts if it points from j to i.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, distinct from `x_i` |
/// | `v_i` | $\mathbf{v}_i$ | m/s (3) | any | velocity of i |
/// | `v_j` | $\mathbf{v}_j$ | m/s (3) | any | velocity of j |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | → `delta_n` | $\delta_N$ | m | | separation of the surfaces, negative for an overlap |
/// | → `n` | $\mathbf{n}_N$ | 1 (3) | | normal, from j to i |
/// | → `v_n` | $v_N$ | m/s | | rate of the separation |
///
/// Rounding: at most 1.5 ULP.
///
/// # Laws
///
/// * `the_normal_velocity_is_the_rate_of_the_separation`
/// * `radii_and_separation_add_up_to_the_distance_along_the_normal`
/// * `swapping_the_particles_turns_the_normal_round`
#[inline(always)]
pub fn separation<R: Real>(x_i: Vec3<R>, x_j: Vec3<R>, v_i: Vec3<R>, v_j: Vec3<R>, r_i: R, r_j: R) -> (R, Vec3<R>, R) {
    let c = Contact::new(x_i - x_j, v_i - v_j, Vec3::zero(), Vec3::zero(), r_i, r_j);
    (c.gap, c.n, c.normal_velocity())
}

/// **Section 2**, unnumbered: sliding velocity of i over j at the contact point.
///
/// ```math
/// \mathbf{v}_T = \big(\mathbf{v}_i - \mathbf{v}_j\big)_{\perp \mathbf{n}} - (a_i \boldsymbol{\omega}_i + a_j \boldsymbol{\omega}_j) \times \mathbf{n}_N
/// ```
///
/// # Reading
///
/// The paper cites the relative rolling velocity. It means the velocity of one surface relative to the other, which
/// vanishes for a pair that rotates as a rigid body. [`moment_arm`] gives the arms.
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
/// | → `v_t` | $\mathbf{v}_T$ | m/s (3) | | sliding velocity |
///
/// Rounding: at most 4 ULP.
///
/// # Laws
///
/// * `a_pair_that_turns_as_one_body_does_not_slide`
/// * `sliding_lies_in_the_contact_plane`
/// * `spheres_without_spin_slide_by_what_the_gap_does_not_take`
/// * `a_spin_alone_slides_by_its_arm`
/// * `sliding_does_not_depend_on_the_place`
#[inline(always)]
pub fn sliding_velocity<R: Real>(
    x_i: Vec3<R>,
    x_j: Vec3<R>,
    v_i: Vec3<R>,
    v_j: Vec3<R>,
    omega_i: Vec3<R>,
    omega_j: Vec3<R>,
    r_i: R,
    r_j: R,
) -> Vec3<R> {
    let c = Contact::new(x_i - x_j, v_i - v_j, omega_i, omega_j, r_i, r_j);
    c.sliding_velocity(moment_arm(r_i, c.gap), moment_arm(r_j, c.gap))
}

/// **Section 2.1**, unnumbered: distance of the contact point from the centre of a particle.
///
/// ```math
/// a = r + \frac{\delta_N}{2}
/// ```
///
/// # Reading
///
/// Erratum: "the force acts on the surface of the particles" (Section 2.1, of Eq. 2) would give arms of $r$, which do not add up to the distance between the
/// centres. With a contact point halfway between the surfaces they do.
///
/// Effect: with arms of $r$ a force in the contact plane creates angular momentum at the rate $\delta_N \mathbf{n} \times \mathbf{F}$.
///
/// Proof: `the_arms_add_up_to_the_distance_of_the_centres_which_the_radii_do_not`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius of the particle |
/// | `delta_n` | $\delta_N$ | m | any | separation of the surfaces, negative for an overlap |
/// | → `arm` | $a$ | m | | moment arm |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_arms_add_up_to_the_distance_of_the_centres_which_the_radii_do_not`
#[inline(always)]
pub fn moment_arm<R: Real>(r: R, delta_n: R) -> R {
    r + R::lit(0.5) * delta_n
}

/// **Section 2.1**, unnumbered: torque that the tangential force exerts on a particle.
///
/// ```math
/// \mathbf{T}_i = a_i \, \mathbf{F}_T \times \mathbf{n}_N, \quad \mathbf{T}_j = a_j \, \mathbf{F}_T \times \mathbf{n}_N
/// ```
///
/// # Reading
///
/// "Computed directly from F and the appropriate moment arms". The contact point of i lies at $-a_i \mathbf{n}_N$ and
/// experiences $\mathbf{F}_T$, the one of j at $+a_j \mathbf{n}_N$ and experiences $-\mathbf{F}_T$: both torques have the
/// same sign.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `arm` | $a$ | m | any | moment arm of the particle |
/// | `force_t` | $\mathbf{F}_T$ | N (3) | any | force on i in the contact plane |
/// | `n` | $\mathbf{n}_N$ | 1 (3) | unit | normal, from j to i |
/// | → `torque` | $\mathbf{T}$ | N m (3) | | torque on the particle about its centre |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_torques_balance_the_couple_of_the_forces`
#[inline(always)]
pub fn contact_torque<R: Real>(arm: R, force_t: Vec3<R>, n: Vec3<R>) -> Vec3<R> {
    force_t.cross(n) * arm
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/def_kinematics.rs", "wear-separation", [], separation),
        equation!("wear/def_kinematics.rs", "wear-sliding-velocity", [], sliding_velocity),
        equation!("wear/def_kinematics.rs", "wear-arm", [], moment_arm),
        equation!("wear/def_kinematics.rs", "wear-torque", [], contact_torque),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-3.0..3.0).prop_map(Vec3)
    }

    proptest! {
        #[test]
        fn the_normal_velocity_is_the_rate_of_the_separation(x in vector(), v in vector()) {
            prop_assume!(x.norm() > 0.5);
            let h = 1e-6;
            let at = |t: f64| separation(x + v * t, Vec3::zero(), v, Vec3::zero(), 0.2, 0.3);
            prop_assert!(((at(h).0 - at(-h).0) / (2.0 * h) - at(0.0).2).abs() < 1e-8);
        }

        #[test]
        fn radii_and_separation_add_up_to_the_distance_along_the_normal(x_i in vector(), x_j in vector(), r_i in 0.1..2.0, r_j in 0.1..2.0) {
            prop_assume!((x_i - x_j).norm() > 0.1);
            let (delta_n, n, _) = separation(x_i, x_j, Vec3::zero(), Vec3::zero(), r_i, r_j);
            prop_assert!((n * (r_i + delta_n + r_j) - (x_i - x_j)).norm() < 1e-13);
        }

        #[test]
        fn swapping_the_particles_turns_the_normal_round(x_i in vector(), x_j in vector(), v_i in vector(), v_j in vector()) {
            prop_assume!((x_i - x_j).norm() > 0.1);
            let (delta_n, n, v_n) = separation(x_i, x_j, v_i, v_j, 0.5, 0.25);
            prop_assert_eq!(separation(x_j, x_i, v_j, v_i, 0.25, 0.5), (delta_n, -n, v_n));
        }

        #[test]
        fn a_pair_that_turns_as_one_body_does_not_slide(x in vector(), drift in vector(), omega in vector(), r_i in 0.1..2.0, r_j in 0.1..2.0) {
            prop_assume!(x.norm() > 0.1);
            let v_t = sliding_velocity(x, Vec3::zero(), drift + omega.cross(x), drift, omega, omega, r_i, r_j);
            prop_assert!(v_t.norm() < 1e-13);
        }

        #[test]
        fn sliding_does_not_depend_on_the_place(x in vector(), place in vector(), v in vector(), omega in vector()) {
            prop_assume!(x.norm() > 0.1);
            let zero = Vec3::zero();
            let at = |place| sliding_velocity(x + place, place, v, zero, omega, zero, 0.2, 0.3);
            prop_assert!((at(place) - at(zero)).norm() < 1e-13);
        }

        #[test]
        fn sliding_lies_in_the_contact_plane(x in vector(), v in vector(), omega in vector(), r_i in 0.1..2.0, r_j in 0.1..2.0) {
            prop_assume!(x.norm() > 0.1);
            let v_t = sliding_velocity(x, Vec3::zero(), v, Vec3::zero(), omega, Vec3::zero(), r_i, r_j);
            prop_assert!(v_t.dot(x).abs() < 1e-12);
        }

        #[test]
        fn spheres_without_spin_slide_by_what_the_gap_does_not_take(x in vector(), v in vector(), drift in vector()) {
            prop_assume!(x.norm() > 0.1);
            let (_, n, v_n) = separation(x, Vec3::zero(), v, Vec3::zero(), 0.2, 0.3);
            let v_t = sliding_velocity(x, Vec3::zero(), v + drift, drift, Vec3::zero(), Vec3::zero(), 0.2, 0.3);
            prop_assert!((v_t + n * v_n - v).norm() < 1e-13);
        }

        #[test]
        fn a_spin_alone_slides_by_its_arm(x in vector(), omega in vector(), r_i in 0.1..2.0, r_j in 0.1..2.0) {
            prop_assume!(x.norm() > 0.1);
            let zero = Vec3::zero();
            let (delta_n, n, _) = separation(x, zero, zero, zero, r_i, r_j);
            let slides = |omega_i, omega_j| sliding_velocity(x, zero, zero, zero, omega_i, omega_j, r_i, r_j);
            // the contact point of i lies towards j, at minus its arm along the normal, the one of j at plus its own
            prop_assert!((slides(omega, zero) - omega.cross(n * -moment_arm(r_i, delta_n))).norm() < 1e-12);
            prop_assert!((slides(zero, omega) + omega.cross(n * moment_arm(r_j, delta_n))).norm() < 1e-12);
        }

        #[test]
        fn the_arms_add_up_to_the_distance_of_the_centres_which_the_radii_do_not(
            r_i in 0.1..2.0f64, r_j in 0.1..2.0, delta_n in 0.01..0.1,
        ) {
            let distance = r_i + r_j + delta_n;
            prop_assert!(relative_eq!(moment_arm(r_i, delta_n) + moment_arm(r_j, delta_n), distance, max_relative = 1e-15));
            prop_assert!(distance - (r_i + r_j) > 0.009);
        }

        #[test]
        fn the_torques_balance_the_couple_of_the_forces(x in vector(), f in vector(), r_i in 0.1..2.0, r_j in 0.1..2.0) {
            prop_assume!(x.norm() > 0.1);
            let (delta_n, n, _) = separation(x, Vec3::zero(), Vec3::zero(), Vec3::zero(), r_i, r_j);
            let force_t = f.perpendicular_to(n);
            let torque = |r| contact_torque(moment_arm(r, delta_n), force_t, n);
            prop_assert!((torque(r_i) + torque(r_j) + x.cross(force_t)).norm() < 1e-13);
        }
    }
}
