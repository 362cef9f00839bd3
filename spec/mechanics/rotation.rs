//! Motion of a rigid body about its centre of mass.
//!
//! The orientation is a unit quaternion $(q_0, \mathbf{q})$ that takes the frame of the body, along its principal axes, to that of space;
//! the state of motion is the angular momentum $\mathbf{L}$ in the frame of the body.
//!
//! Equations and sections are numbered as in Laube et al. 2018.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Section 5.3**, unnumbered: free motion of a rigid aggregate over a time step.
///
/// ```math
/// A_3\left(\tfrac{\Delta t}{2}\right) A_2\left(\tfrac{\Delta t}{2}\right) A_1(\Delta t) \, A_2\left(\tfrac{\Delta t}{2}\right) A_3\left(\tfrac{\Delta t}{2}\right), \quad
/// A_k(t): \; \text{rotation about the principal axis } k \text{ by } 4 \arctan \frac{L_k t}{4 I_k}
/// ```
///
/// # Reading
///
/// The paper says only "rigid aggregates". The kinetic energy is a sum of three terms, one for each principal axis, and each alone generates a rotation that
/// can be evaluated exactly; in symmetric order they form a symplectic, reversible step of second order that preserves the lengths of the angular momentum
/// and of the quaternion to rounding and the energy without drift (Dullweber, Leimkuhler & McLachlan; "no squish" of Miller et al.).
///
/// The exact angle is $L_k t / I_k$. With the arctangent, which differs from it in the third order, sine and cosine are ratios, and the rate still depends
/// on $L_k$ alone: the rotation belongs to a slightly different kinetic energy, so the step stays symplectic, reversible and of second order.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `q_0` | $q_0$ | 1 | any | scalar part of the orientation |
/// | `q` | $\mathbf{q}$ | 1 (3) | any | vector part of the orientation |
/// | `l` | $\mathbf{L}$ | kg m^2/s (3) | any | angular momentum in the frame of the body |
/// | `i` | $I$ | kg m^2 (3) | > 0 | principal moments of inertia |
/// | `dt` | $\Delta t$ | s | any | time step |
/// | → `q_0_next` | $q_0$ | 1 | | scalar part of the orientation now |
/// | → `q_next` | $\mathbf{q}$ | 1 (3) | | vector part of the orientation now |
/// | → `l_next` | $\mathbf{L}$ | kg m^2/s (3) | | angular momentum now |
///
/// Rounding: at most 5 ULP.
///
/// # Laws
///
/// * `energy_and_angular_momentum_of_a_free_top_do_not_drift`
/// * `the_step_is_reversible`
/// * `of_second_order`
/// * `a_tennis_racket_flips`
/// * `a_sphere_turns_at_a_constant_rate`
#[inline(always)]
pub fn free_rotation<R: Real>(q_0: R, q: Vec3<R>, l: Vec3<R>, i: Vec3<R>, dt: R) -> (R, Vec3<R>, Vec3<R>) {
    let half = R::lit(0.5) * dt;
    let before = about_axis(about_axis((q_0, q, l), i, 2, half), i, 1, half);
    about_axis(about_axis(about_axis(before, i, 0, dt), i, 1, half), i, 2, half)
}

/// Orientation, a quaternion, and angular momentum.
type Turn<R> = (R, Vec3<R>, Vec3<R>);

/// Rotation about one principal axis with the component of the angular momentum along it.
#[inline(always)]
fn about_axis<R: Real>((q_0, q, l): Turn<R>, i: Vec3<R>, axis: usize, dt: R) -> Turn<R> {
    let quarter = R::lit(0.25) * (l.0[axis] / i.0[axis] * dt);
    let square = quarter.squared();
    let scale = R::one() / (R::one() + square);
    let (c, s) = ((R::one() - square) * scale, (quarter + quarter) * scale);
    let mut e = Vec3::zero();
    e.0[axis] = R::one();
    // in the frame of the body the angular momentum turns the other way
    (q_0 * c - q.0[axis] * s, q * c + e * (q_0 * s) + q.cross(e) * s, turned(c, -s, e, l))
}

/// The vector turned about the unit vector `e` by twice the angle whose cosine and sine are `c` and `s`.
#[inline(always)]
fn turned<R: Real>(c: R, s: R, e: Vec3<R>, v: Vec3<R>) -> Vec3<R> {
    let (two, across) = (R::lit(2.0), e.cross(v));
    v + across * (two * c * s) + e.cross(across) * (two * s * s)
}

/// **Section 5.3**, unnumbered: a vector of the body in the frame of space.
///
/// ```math
/// \mathbf{v}' = \mathbf{v} + 2 q_0 \, \mathbf{q} \times \mathbf{v} + 2 \, \mathbf{q} \times (\mathbf{q} \times \mathbf{v})
/// ```
///
/// # Reading
///
/// For a quaternion of length one. With $-\mathbf{q}$ it is the inverse, from space to the body: a torque $\mathbf{M}$ in the frame of space changes
/// $\mathbf{L}$ by the transformed $\mathbf{M} \Delta t$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `q_0` | $q_0$ | 1 | any | scalar part of the orientation |
/// | `q` | $\mathbf{q}$ | 1 (3) | any | vector part of the orientation |
/// | `v` | $\mathbf{v}$ | m (3) | any | vector in the frame of the body |
/// | → `v_space` | $\mathbf{v}'$ | m (3) | | the vector in the frame of space |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_vector_keeps_its_length_and_comes_back`
/// * `a_right_angle_turns_as_the_right_hand_does`
#[inline(always)]
pub fn to_space<R: Real>(q_0: R, q: Vec3<R>, v: Vec3<R>) -> Vec3<R> {
    let two = R::lit(2.0);
    let across = q.cross(v);
    v + across * (two * q_0) + q.cross(across) * two
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/rotation.rs", "titania-free-rotation", [], free_rotation),
        equation!("mechanics/rotation.rs", "titania-to-space", [], to_space),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    type State = (f64, Vec3<f64>, Vec3<f64>);
    const MOMENTS: Vec3<f64> = Vec3([1.0, 2.0, 3.5]);

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-1.0..1.0).prop_map(Vec3)
    }
    fn states() -> impl Strategy<Value = State> {
        (0.1..1.0, vector(), vector()).prop_map(|(q_0, q, l): State| {
            let length = (q_0 * q_0 + q.dot(q)).sqrt();
            (q_0 / length, q * (1.0 / length), l)
        })
    }
    fn step((q_0, q, l): State, dt: f64) -> State {
        free_rotation(q_0, q, l, MOMENTS, dt)
    }
    fn energy(l: Vec3<f64>) -> f64 {
        (0..3).map(|k| 0.5 * l.0[k] * l.0[k] / MOMENTS.0[k]).sum()
    }
    fn apart(a: State, b: State) -> f64 {
        (a.0 - b.0).abs() + (a.1 - b.1).norm() + (a.2 - b.2).norm()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(16))]

        #[test]
        fn energy_and_angular_momentum_of_a_free_top_do_not_drift(start in states()) {
            let (dt, e_0) = (0.05, energy(start.2));
            let l_0 = to_space(start.0, start.1, start.2);
            let (mut state, mut worst) = (start, [0.0f64; 2]);
            for n in 0..20_000 {
                state = step(state, dt);
                let early = usize::from(n >= 10_000);
                worst[early] = worst[early].max((energy(state.2) - e_0).abs());
                prop_assert!((to_space(state.0, state.1, state.2) - l_0).norm() < 1e-11);
            }
            prop_assert!((state.0 * state.0 + state.1.dot(state.1) - 1.0).abs() < 1e-11);
            // the error oscillates as the body tumbles: it must not grow from the first half to the second
            prop_assert!(worst[1] <= 1.1 * worst[0] + 1e-12 && worst[0] < 1e-3 * e_0.max(0.01));
        }

        #[test]
        fn the_step_is_reversible(start in states(), dt in 0.01..0.5) {
            let mut state = start;
            // few steps: near the middle axis rounding errors grow exponentially, up to exp(0.57 t) here
            (0..10).for_each(|_| state = step(state, dt));
            (0..10).for_each(|_| state = step(state, -dt));
            prop_assert!(apart(state, start) < 1e-12);
        }

        #[test]
        fn of_second_order(start in states()) {
            let end = |steps: u32| (0..steps).fold(start, |state, _| step(state, 2.0 / f64::from(steps)));
            let exact = end(3200);
            let (coarse, fine) = (apart(end(50), exact), apart(end(100), exact));
            prop_assert!(coarse < 1e-9 || (coarse / fine - 4.0).abs() < 0.2, "{coarse} {fine}");
        }

        #[test]
        fn a_sphere_turns_at_a_constant_rate(start in states(), t in 0.1..3.0) {
            let moments = Vec3([2.0; 3]);
            let (q_0, q, l) = free_rotation(start.0, start.1, start.2, moments, t);
            // the splitting is not exact even here, but the angular momentum of space is
            prop_assert!((to_space(q_0, q, l) - to_space(start.0, start.1, start.2)).norm() < 1e-13);
            let steps = 4000;
            let state = (0..steps).fold(start, |(q_0, q, l), _| free_rotation(q_0, q, l, moments, t / f64::from(steps)));
            prop_assert!((state.2 - start.2).norm() < 1e-5);
        }

        #[test]
        fn a_right_angle_turns_as_the_right_hand_does(e in vector(), v in vector()) {
            prop_assume!(e.norm() > 0.1);
            let e = e * (1.0 / e.norm());
            let half = 0.5f64.sqrt();
            let turned = to_space(half, e * half, v);
            prop_assert!((turned - e.cross(v) - e * e.dot(v)).norm() < 1e-14);
        }

        #[test]
        fn a_vector_keeps_its_length_and_comes_back(state in states(), v in vector()) {
            let there = to_space(state.0, state.1, v);
            prop_assert!((there.norm() - v.norm()).abs() < 1e-14);
            prop_assert!((to_space(state.0, -state.1, there) - v).norm() < 1e-14);
        }
    }

    #[test]
    fn a_tennis_racket_flips() {
        // Slightly perturbed, rotation about the intermediate axis flips again and again; about the others it does not.
        let flips = |axis: usize| {
            let mut l = Vec3([1e-3; 3]);
            l.0[axis] = 1.0;
            let (mut state, mut flips, mut sign) = ((1.0, Vec3::zero(), l), 0, 1.0);
            for _ in 0..40_000 {
                state = step(state, 0.02);
                if state.2.0[axis] * sign < -0.5 {
                    (flips, sign) = (flips + 1, -sign);
                }
            }
            flips
        };
        assert_eq!((flips(0), flips(2)), (0, 0));
        assert!(flips(1) > 10, "{}", flips(1));
    }
}
