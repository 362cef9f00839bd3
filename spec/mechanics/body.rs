//! A rigid aggregate and its spheres.
//!
//! Equations and sections are numbered as in Laube et al. 2018.

use super::rotation::to_space;
use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Section 5.3**, unnumbered: angular velocity and kinetic energy of rotation of a rigid aggregate.
///
/// ```math
/// \omega_k = \frac{L_k}{I_k}, \quad K = \frac{1}{2} \sum_k \frac{L_k^2}{I_k}
/// ```
///
/// # Reading
///
/// Both in the frame of the body; the angular velocity is then rotated to the space frame.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `q_0` | $q_0$ | 1 | any | scalar part of the orientation |
/// | `q` | $\mathbf{q}$ | 1 (3) | any | vector part of the orientation |
/// | `l` | $\mathbf{L}$ | kg m^2/s (3) | any | angular momentum in the frame of the body |
/// | `i` | $I$ | kg m^2 (3) | > 0 | principal moments of inertia |
/// | → `omega` | $\boldsymbol{\omega}$ | rad/s (3) | | angular velocity in the frame of space |
/// | → `energy` | $K$ | J | | kinetic energy of rotation |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_energy_is_half_the_product_of_angular_velocity_and_momentum`
/// * `moments_of_inertia_times_angular_velocity_are_the_angular_momentum`
#[inline(always)]
pub fn spin<R: Real>(q_0: R, q: Vec3<R>, l: Vec3<R>, i: Vec3<R>) -> (Vec3<R>, R) {
    let omega = Vec3(std::array::from_fn(|k| l.0[k] / i.0[k]));
    (to_space(q_0, q, omega), R::lit(0.5) * omega.dot(l))
}

/// **Section 5.3**, unnumbered: velocity of a sphere of a rigid aggregate.
///
/// ```math
/// \mathbf{v}_p = \mathbf{v} + \boldsymbol{\omega} \times \mathbf{r}
/// ```
///
/// # Reading
///
/// The sphere turns with the aggregate, at $\boldsymbol{\omega}$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `v` | $\mathbf{v}$ | m/s (3) | any | velocity of the centre of mass |
/// | `omega` | $\boldsymbol{\omega}$ | rad/s (3) | any | angular velocity |
/// | `r` | $\mathbf{r}$ | m (3) | any | centre of the sphere from the centre of mass |
/// | → `v_p` | $\mathbf{v}_p$ | m/s (3) | | velocity of the sphere |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `spheres_neither_approach_nor_slide_over_each_other`
#[inline(always)]
pub fn member_velocity<R: Real>(v: Vec3<R>, omega: Vec3<R>, r: Vec3<R>) -> Vec3<R> {
    v + omega.cross(r)
}

/// **Section 5.4**, unnumbered: environmental viscosity on a rigid aggregate.
///
/// ```math
/// \mathbf{F} = -\eta \sum_p \mathbf{v}_p = -\eta \left(N \mathbf{v} + \boldsymbol{\omega} \times \mathbf{s}\right), \quad
/// \mathbf{M} = -\eta \sum_p \mathbf{r}_p \times \mathbf{v}_p = -\eta \left(\mathbf{s} \times \mathbf{v} + \mathbf{D} \, \boldsymbol{\omega}\right)
/// ```
///
/// # Reading
///
/// "Acting on all particles": the drag of each sphere, summed over the aggregate, with $\mathbf{s} = \sum_p \mathbf{r}_p$ and
/// $\mathbf{D} = \sum_p (r_p^2 \, \mathbf{1} - \mathbf{r}_p \mathbf{r}_p)$, all in one frame.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `eta` | $\eta$ | kg/s | >= 0 | drag coefficient of each sphere |
/// | `count` | $N$ | 1 | >= 1 | number of spheres |
/// | `s` | $\mathbf{s}$ | m (3) | any | sum of the places of the spheres from the centre of mass |
/// | `d_x` | $\mathbf{D}_x$ | m^2 (3) | any | first row of the tensor |
/// | `d_y` | $\mathbf{D}_y$ | m^2 (3) | any | second row |
/// | `d_z` | $\mathbf{D}_z$ | m^2 (3) | any | third row |
/// | `v` | $\mathbf{v}$ | m/s (3) | any | velocity of the centre of mass |
/// | `omega` | $\boldsymbol{\omega}$ | rad/s (3) | any | angular velocity |
/// | → `force` | $\mathbf{F}$ | N (3) | | force on the aggregate |
/// | → `torque` | $\mathbf{M}$ | N m (3) | | torque about its centre of mass |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_the_sum_of_the_drags_on_the_spheres`
#[inline(always)]
pub fn aggregate_drag<R: Real>(
    eta: R,
    count: R,
    s: Vec3<R>,
    d_x: Vec3<R>,
    d_y: Vec3<R>,
    d_z: Vec3<R>,
    v: Vec3<R>,
    omega: Vec3<R>,
) -> (Vec3<R>, Vec3<R>) {
    let spread = Vec3([d_x, d_y, d_z].map(|row| row.dot(omega)));
    ((v * count + omega.cross(s)) * -eta, (s.cross(v) + spread) * -eta)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/body.rs", "titania-spin", [], spin),
        equation!("mechanics/body.rs", "titania-member-velocity", [], member_velocity),
        equation!("mechanics/body.rs", "titania-aggregate-drag", [], aggregate_drag),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::drive::drag;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-1.0..1.0).prop_map(Vec3)
    }

    proptest! {
        #[test]
        fn the_energy_is_half_the_product_of_angular_velocity_and_momentum(q_0 in 0.1f64..1.0, q in vector(), l in vector()) {
            let length: f64 = (q_0 * q_0 + q.dot(q)).sqrt();
            let (q_0, q) = (q_0 / length, q * (1.0 / length));
            let (omega, energy) = spin(q_0, q, l, Vec3([1.0, 2.0, 3.5]));
            prop_assert!((energy - 0.5 * omega.dot(to_space(q_0, q, l))).abs() < 1e-14);
        }

        #[test]
        fn moments_of_inertia_times_angular_velocity_are_the_angular_momentum(q_0 in 0.1f64..1.0, q in vector(), l in vector(), i in prop::array::uniform3(0.1..4.0)) {
            let length: f64 = (q_0 * q_0 + q.dot(q)).sqrt();
            let (q_0, q) = (q_0 / length, q * (1.0 / length));
            let in_body = to_space(q_0, -q, spin(q_0, q, l, Vec3(i)).0);
            prop_assert!((0..3).all(|k| (i[k] * in_body.0[k] - l.0[k]).abs() < 1e-13));
        }

        #[test]
        fn spheres_neither_approach_nor_slide_over_each_other(v in vector(), omega in vector(), a in vector(), b in vector()) {
            let apart = member_velocity(v, omega, a) - member_velocity(v, omega, b);
            prop_assert!((apart - omega.cross(a - b)).norm() < 1e-14);
            prop_assert!(apart.dot(a - b).abs() < 1e-14);
        }

        #[test]
        fn is_the_sum_of_the_drags_on_the_spheres(v in vector(), omega in vector(), places in prop::array::uniform4(vector())) {
            let (mut force, mut torque) = (Vec3::zero(), Vec3::zero());
            let (mut s, mut rows) = (Vec3::zero(), [Vec3::zero(); 3]);
            for r in places {
                let push = drag(0.3, member_velocity(v, omega, r));
                (force, torque) = (force + push, torque + r.cross(push));
                s = s + r;
                for (k, row) in rows.iter_mut().enumerate() {
                    row.0[k] += r.dot(r);
                    *row = *row - r * r.0[k];
                }
            }
            let whole = aggregate_drag(0.3, 4.0, s, rows[0], rows[1], rows[2], v, omega);
            prop_assert!((whole.0 - force).norm() < 1e-14 && (whole.1 - torque).norm() < 1e-14);
        }
    }
}
