//! The torques of a contact.

use crate::equation::Equation;
use crate::{Contact, Real, Vec3, equation};

/// Position of the contact point of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arms {
    /// Midway between the bare surfaces: the arms add up to the distance of the centres.
    HalfGap,
    /// Half a compressed layer above each bare surface, at any distance: a tangential force creates angular momentum.
    HalfLayer,
}

impl Arms {
    /// The moment arms of the particles of a contact, whose radii contain the compressed layer `h_n`.
    #[inline(always)]
    pub fn of<R: Real>(self, c: &Contact<R>, h_n: f64) -> [R; 2] {
        let layered = R::always(self == Self::HalfLayer);
        let arm =
            |r, other| R::select(layered, layered_arm(r - R::lit(h_n), R::lit(h_n)), moment_arm(r, other, c.distance));
        [arm(c.r_i, c.r_j), arm(c.r_j, c.r_i)]
    }
}

/// **Section 2**, unnumbered: distance of the contact point from the centre of a particle.
///
/// ```math
/// R_i^{aug} = R_i + \frac{d - R_i - R_j}{2}
/// ```
///
/// # Reading
///
/// "Augmented by half the thickness of the compressed water layer": half the gap between the bare surfaces at that distance. The two arms
/// then add up to the distance between the centres; otherwise, as with a constant thickness `h_n`, a tangential force would create
/// angular momentum. Radii that are both augmented by the same length give the same arms.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_i` | $R_i$ | m | > 0 | radius of the particle |
/// | `r_j` | $R_j$ | m | > 0 | radius of its partner |
/// | `d` | $d$ | m | > 0 | distance of the centres |
/// | → `arm` | $R_i^{aug}$ | m | | moment arm |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `arms_add_up_to_the_distance_which_constant_layers_do_not`
/// * `augmenting_both_radii_changes_no_arm`
#[inline(always)]
pub fn moment_arm<R: Real>(r_i: R, r_j: R, d: R) -> R {
    r_i + R::lit(0.5) * (d - r_i - r_j)
}

/// **Section 2**, unnumbered: the same, taken literally.
///
/// ```math
/// R_i^{aug} = R_i + \frac{h_n}{2}
/// ```
///
/// # Reading
///
/// "Augmented by half the thickness of the compressed water layer", whatever the distance. At rest it is 0.1 nm shorter than
/// [`moment_arm`], the default; with this arm a tangential force creates angular momentum.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_i` | $R_i$ | m | > 0 | bare radius of the particle |
/// | `h_n` | $h_n$ | m | >= 0 | thickness of the compressed layer |
/// | → `arm` | $R_i^{aug}$ | m | | moment arm |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `arms_add_up_to_the_distance_which_constant_layers_do_not`
#[inline(always)]
pub fn layered_arm<R: Real>(r_i: R, h_n: R) -> R {
    r_i + R::lit(0.5) * h_n
}

/// **Eq. 2**, Section 2: torques of a contact on its particles.
///
/// ```math
/// \mathbf{M}_{ij} = -\mathbf{F}_t \times R_i^{aug} \mathbf{n}_{ij} - \mathbf{M}_r
/// ```
///
/// # Reading
///
/// Erratum: with $\mathbf{n}_{ij}$ from j to i, as Eqs. 3 and 8 require, the contact point of i lies at $-l_i \mathbf{n}_{ij}$ and the
/// torque of a force there is $+\mathbf{F}_t \times l_i \mathbf{n}_{ij}$.
///
/// ```math
/// \mathbf{M}_i = \mathbf{F}_t \times l_i \mathbf{n}_{ij} - \mathbf{M}_r, \quad
/// \mathbf{M}_j = \mathbf{F}_t \times l_j \mathbf{n}_{ij} + \mathbf{M}_r
/// ```
///
/// The rolling torque $\mathbf{M}_r$ points along $(\boldsymbol{\omega}_i - \boldsymbol{\omega}_j)_{\perp \mathbf{n}}$ and is zero where
/// that vector is. There is no torque about the normal.
///
/// Effect: the printed sign creates angular momentum at the rate $(d + l_i + l_j) \, \mathbf{n}_{ij} \times \mathbf{F}_t$.
///
/// Proof: `the_torques_balance_the_couple_of_the_forces_which_the_printed_sign_does_not`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, distinct from `x_i` |
/// | `r_i` | $R_i$ | m | > 0 | radius of i |
/// | `r_j` | $R_j$ | m | > 0 | radius of j |
/// | `f_t` | $\mathbf{F}_t$ | N (3) | any | force on i; only its tangential part is used |
/// | `omega_i` | $\boldsymbol{\omega}_i$ | rad/s (3) | any | angular velocity of i |
/// | `omega_j` | $\boldsymbol{\omega}_j$ | rad/s (3) | any | angular velocity of j |
/// | `m_r` | $M_r$ | N m | >= 0 | magnitude of the rolling torque, Eq. 13 |
/// | → `n` | $\mathbf{n}_{ij}$ | 1 (3) | | normal, from j to i |
/// | → `l_i` | $l_i$ | m | | moment arm of i |
/// | → `l_j` | $l_j$ | m | | moment arm of j |
/// | → `m_i` | $\mathbf{M}_i$ | N m (3) | | torque on i about its centre |
/// | → `m_j` | $\mathbf{M}_j$ | N m (3) | | torque on j about its centre |
///
/// Rounding: at most 16 ULP.
///
/// # Laws
///
/// * `the_torques_balance_the_couple_of_the_forces_which_the_printed_sign_does_not`
/// * `no_torque_acts_about_the_normal`
/// * `rolling_resistance_takes_energy_and_keeps_angular_momentum`
#[inline(always)]
pub fn torques<R: Real>(
    x_i: Vec3<R>,
    x_j: Vec3<R>,
    r_i: R,
    r_j: R,
    f_t: Vec3<R>,
    omega_i: Vec3<R>,
    omega_j: Vec3<R>,
    m_r: R,
) -> (Vec3<R>, R, R, Vec3<R>, Vec3<R>) {
    let x = x_i - x_j;
    let d = x.norm();
    let n = Vec3(x.0.map(|component| component / d));
    let (l_i, l_j) = (moment_arm(r_i, r_j, d), moment_arm(r_j, r_i, d));
    let omega_r = (omega_i - omega_j).perpendicular_to(n);
    let speed = omega_r.norm();
    let rolling = omega_r * R::select(speed.gt(R::zero()), m_r / speed, R::zero());
    let (m_i, m_j) = contact_torques(l_i, l_j, f_t.perpendicular_to(n), n, rolling);
    (n, l_i, l_j, m_i, m_j)
}

/// Eq. 2 as read above, from the rolling torque as a vector.
#[inline(always)]
pub(super) fn contact_torques<R: Real>(l_i: R, l_j: R, f_t: Vec3<R>, n: Vec3<R>, m_r: Vec3<R>) -> (Vec3<R>, Vec3<R>) {
    let couple = f_t.cross(n);
    (couple * l_i - m_r, couple * l_j + m_r)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("titania/eq02_torque.rs", "titania-arm", [], moment_arm),
        equation!("titania/eq02_torque.rs", "titania-arm-layer", [], layered_arm),
        equation!("titania/eq02_torque.rs", "titania-2", ["2"], torques),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-3.0..3.0).prop_map(Vec3)
    }

    proptest! {
        #[test]
        fn arms_add_up_to_the_distance_which_constant_layers_do_not(r_i in 1.0..4.0f64, r_j in 1.0..4.0f64, delta_n in 0.05..0.3f64) {
            let h_n = 0.36f64;
            let d = r_i + r_j + 2.0 * h_n - delta_n;
            prop_assert!((moment_arm(r_i, r_j, d) + moment_arm(r_j, r_i, d) - d).abs() < 1e-14);
            prop_assert!((layered_arm(r_i, h_n) + layered_arm(r_j, h_n) - d - (delta_n - h_n)).abs() < 1e-14);
        }

        #[test]
        fn augmenting_both_radii_changes_no_arm(r_i in 1.0..4.0f64, r_j in 1.0..4.0, d in 1.0..9.0, h_n in 0.0..1.0) {
            prop_assert!((moment_arm(r_i, r_j, d) - moment_arm(r_i + h_n, r_j + h_n, d)).abs() < 1e-14);
        }

        #[test]
        fn the_torques_balance_the_couple_of_the_forces_which_the_printed_sign_does_not(
            place in vector(), x in vector(), f in vector(), omega_i in vector(), omega_j in vector(),
            r_i in 0.1..2.0, r_j in 0.1..2.0, m_r in 0.0..2.0,
        ) {
            prop_assume!(x.norm() > 0.5);
            let (n, l_i, l_j, m_i, m_j) = torques(place + x, place, r_i, r_j, f, omega_i, omega_j, m_r);
            let f_t = f.perpendicular_to(n);
            let couple = x.cross(f_t);
            prop_assert!((m_i + m_j + couple).norm() < 1e-13);
            let printed = -(f_t.cross(n) * (l_i + l_j));
            prop_assert!((printed + couple - n.cross(f_t) * (x.norm() + l_i + l_j)).norm() < 1e-13);
        }

        #[test]
        fn no_torque_acts_about_the_normal(x in vector(), f in vector(), omega_i in vector(), omega_j in vector(), m_r in 0.0..2.0) {
            prop_assume!(x.norm() > 0.5);
            let (n, _, _, m_i, m_j) = torques(x, Vec3::zero(), 0.7, 0.4, f, omega_i, omega_j, m_r);
            prop_assert!(m_i.dot(n).abs() < 1e-13 && m_j.dot(n).abs() < 1e-13);
        }

        #[test]
        fn rolling_resistance_takes_energy_and_keeps_angular_momentum(x in vector(), omega_i in vector(), omega_j in vector(), m_r in 0.1..2.0) {
            prop_assume!(x.norm() > 0.5);
            let (_, _, _, m_i, m_j) = torques(x, Vec3::zero(), 0.7, 0.4, Vec3::zero(), omega_i, omega_j, m_r);
            prop_assert!((m_i + m_j).norm() < 1e-14);
            // a torque of this magnitude against the rolling, none against the twist
            let n = x * (1.0 / x.norm());
            let rolled = (omega_i - omega_j).perpendicular_to(n).norm();
            prop_assert!((m_i.dot(omega_i) + m_j.dot(omega_j) + m_r * rolled).abs() < 1e-12);
            let (_, _, _, still, _) = torques(x, Vec3::zero(), 0.7, 0.4, Vec3::zero(), omega_i, omega_i, m_r);
            prop_assert_eq!(still, Vec3::zero());
        }
    }
}
