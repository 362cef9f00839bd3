//! A spring of a contact: it rotates with the pair, and is stretched.
//!
//! Equations and sections are numbered as in Demidov, Gor & Khalizov 2024.

use crate::equation::Equation;
use crate::{Named, Real, Vec3, equation};
use std::ops::{Add, Mul, Sub};

/// The length of a spring: a vector of the contact plane, or a number along the normal.
pub trait Span<R: Real>: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<R, Output = Self> {
    /// No length.
    fn none() -> Self;
    /// Its square.
    fn square(self) -> R;
    /// Its magnitude.
    fn size(self) -> R;
    /// Its scalar product with another.
    fn inner(self, other: Self) -> R;
    /// `yes` where the mask is true, `no` elsewhere.
    fn select(mask: R::Mask, yes: Self, no: Self) -> Self;
}
impl<R: Real> Span<R> for R {
    #[inline(always)]
    fn none() -> Self {
        R::zero()
    }
    #[inline(always)]
    fn square(self) -> R {
        self.squared()
    }
    #[inline(always)]
    fn size(self) -> R {
        self.abs()
    }
    #[inline(always)]
    fn inner(self, other: Self) -> R {
        self * other
    }
    #[inline(always)]
    fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        <R as Real>::select(mask, yes, no)
    }
}
impl<R: Real> Span<R> for Vec3<R> {
    #[inline(always)]
    fn none() -> Self {
        Self::zero()
    }
    #[inline(always)]
    fn square(self) -> R {
        self.dot(self)
    }
    #[inline(always)]
    fn size(self) -> R {
        self.norm()
    }
    #[inline(always)]
    fn inner(self, other: Self) -> R {
        self.dot(other)
    }
    #[inline(always)]
    fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        Vec3::select(mask, yes, no)
    }
}

/// The torsion spring of a pair: a number along the normal, which follows the normal ([`rotated_torsion`]), or, following the text of the paper, a vector that every step rotates
/// into the contact plane.
pub trait Twist<R: Real>: Span<R> + Named<R> {
    /// The spring after the normal has turned.
    fn rotated(self, n: Vec3<R>) -> Self;
    /// The spring of length `along` the normal.
    fn of(along: R, n: Vec3<R>) -> Self;
    /// Its torque on i, at an arm `r`, as a quasi-force.
    fn torque(self, n: Vec3<R>, r: R) -> Vec3<R>;
}
impl<R: Real> Twist<R> for R {
    #[inline(always)]
    fn rotated(self, _: Vec3<R>) -> Self {
        self
    }
    #[inline(always)]
    fn of(along: R, _: Vec3<R>) -> Self {
        along
    }
    #[inline(always)]
    fn torque(self, n: Vec3<R>, r: R) -> Vec3<R> {
        n * (r * self)
    }
}
impl<R: Real> Twist<R> for Vec3<R> {
    #[inline(always)]
    fn rotated(self, n: Vec3<R>) -> Self {
        rotated_spring(self, n)
    }
    #[inline(always)]
    fn of(along: R, n: Vec3<R>) -> Self {
        n * along
    }
    #[inline(always)]
    fn torque(self, _: Vec3<R>, r: R) -> Vec3<R> {
        self * r
    }
}

/// **Section 2.1.1**, step 2, unnumbered: a tangential or rolling spring after the contact plane has turned.
///
/// ```math
/// \boldsymbol{\xi} = \boldsymbol{\xi}'_\perp \frac{|\boldsymbol{\xi}'|}{|\boldsymbol{\xi}'_\perp|}, \quad
/// \boldsymbol{\xi}'_\perp = \boldsymbol{\xi}' - (\boldsymbol{\xi}' \cdot \mathbf{n}) \, \mathbf{n}
/// ```
///
/// # Reading
///
/// "Rotating to be orthogonal to n and re-scaling". In the limit of small steps this is the parallel transport of the spring with the contact plane.
/// A spin of the pair about its normal does not turn it. A spring without a component in the plane, which cannot result from small steps, vanishes.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `xi` | $\boldsymbol{\xi}'$ | m (3) | any | spring before |
/// | `n` | $\mathbf{n}$ | 1 (3) | unit | normal now |
/// | → `rotated` | $\boldsymbol{\xi}$ | m (3) | | spring in the contact plane, as long as before |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `turning_keeps_the_length_of_a_spring_and_puts_it_into_the_plane`
/// * `a_spring_in_the_plane_stays_as_it_is`
/// * `a_spring_carried_round_with_its_pair_turns_with_it`
/// * `a_spring_along_the_normal_is_lost_and_a_torsion_across_it_counts_as_positive`
#[inline(always)]
pub fn rotated_spring<R: Real>(xi: Vec3<R>, n: Vec3<R>) -> Vec3<R> {
    let in_plane = xi.perpendicular_to(n);
    let (was, is) = (xi.dot(xi), in_plane.dot(in_plane));
    in_plane * R::select(is.gt(R::zero()), (was / is).sqrt(), R::one())
}

/// **Section 2.1.1**, step 2, unnumbered: a torsion spring after the normal has turned.
///
/// ```math
/// \boldsymbol{\xi} = \operatorname{sgn}(\boldsymbol{\xi}' \cdot \mathbf{n}) \, |\boldsymbol{\xi}'| \, \mathbf{n}
/// ```
///
/// # Reading
///
/// Erratum: the text rotates all three springs to be orthogonal to the normal. The torsion spring lies along the normal; its projection
/// onto the contact plane is only rounding, or the rotation of the normal in one step, and rescaling it to the full length makes a spring in an arbitrary direction, or none. It must stay parallel.
/// Then only its signed length needs to be remembered, $\xi_\mathrm{o} = \boldsymbol{\xi} \cdot \mathbf{n}$, which rotation does not change; the models do that.
///
/// Effect: as printed the torsion is lost and never resisted, and the remaining spring bends the pair. Aggregates all of whose contacts are necks, which would be rigid, then compact under a coating by 9 %.
///
/// Proof: `a_torsion_spring_turns_with_its_pair_which_the_published_step_forgets`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `xi` | $\boldsymbol{\xi}'$ | m (3) | any | spring before |
/// | `n` | $\mathbf{n}$ | 1 (3) | unit | normal now |
/// | → `rotated` | $\boldsymbol{\xi}$ | m (3) | | spring along the normal, as long as before |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_torsion_spring_turns_with_its_pair_which_the_published_step_forgets`
#[inline(always)]
pub fn rotated_torsion<R: Real>(xi: Vec3<R>, n: Vec3<R>) -> Vec3<R> {
    let size = xi.norm();
    n * R::select(xi.dot(n).lt(R::zero()), -size, size)
}

/// **Section 2.1.1**, steps 2 and 3, unnumbered: a tangential or rolling spring after a time step.
///
/// ```math
/// \boldsymbol{\xi} := \boldsymbol{\xi} + \dot{\boldsymbol{\xi}} \Delta t
/// ```
///
/// # Reading
///
/// [`rotated_spring`], then the increment, and only then the force (step 4). Used before it is incremented, the spring lags by one step behind the
/// positions, and $k\boldsymbol{\xi} + \eta\dot{\boldsymbol{\xi}}$ acts like a dashpot of $\eta - k \Delta t$, which may be negative.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `xi` | $\boldsymbol{\xi}'$ | m (3) | any | spring before |
/// | `n` | $\mathbf{n}$ | 1 (3) | unit | normal now |
/// | `xi_dot` | $\dot{\boldsymbol{\xi}}$ | m/s (3) | any | rate, in the contact plane |
/// | `dt` | $\Delta t$ | s | >= 0 | time step |
/// | → `xi_next` | $\boldsymbol{\xi}$ | m (3) | | spring now |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `moving_back_relaxes_a_spring`
/// * `an_undamped_spring_keeps_the_energy_which_the_lagged_order_raises`
#[inline(always)]
pub fn stretched_spring<R: Real>(xi: Vec3<R>, n: Vec3<R>, xi_dot: Vec3<R>, dt: R) -> Vec3<R> {
    stretched(rotated_spring(xi, n), xi_dot, dt)
}

/// Step 3: a spring of any kind, incremented.
#[inline(always)]
pub fn stretched<R: Real, S: Span<R>>(xi: S, xi_dot: S, dt: R) -> S {
    xi + xi_dot * dt
}

/// **Section 2.1.1**, steps 3 and 4, unnumbered: largest stable time step of a spring that acts before it is stretched.
///
/// ```math
/// \Delta t_{\max} = \frac{\eta}{k}
/// ```
///
/// # Reading
///
/// The springs of the published program lag, see [`stretched_spring`]: above this step the effective damping coefficient is negative and drives the pair. This limit holds in addition to the
/// frequency limits, and does not depend on masses: where all springs have the same ratio it holds for any number of necks.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k` | $k$ | N/m | > 0 | stiffness |
/// | `eta` | $\eta$ | kg/s | >= 0 | damping coefficient |
/// | → `dt_max` | $\Delta t_{\max}$ | s | | largest stable time step |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `beyond_its_limit_a_spring_that_lags_gains_energy`
#[inline(always)]
pub fn lag_limit<R: Real>(k: R, eta: R) -> R {
    eta / k
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/rotated_spring.rs", "soot-rotated", [], rotated_spring),
        equation!("mechanics/rotated_spring.rs", "soot-rotated-torsion", [], rotated_torsion),
        equation!("mechanics/rotated_spring.rs", "soot-spring", [], stretched_spring),
        equation!("mechanics/rotated_spring.rs", "soot-lag-limit", [], lag_limit),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::{rotated, unit, vector};
    use crate::mechanics::spring_force::force;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn turning_keeps_the_length_of_a_spring_and_puts_it_into_the_plane(xi in vector(), n in unit()) {
            prop_assume!(xi.cross(n).norm() > 1e-3);
            let spring = rotated_spring(xi, n);
            prop_assert!((spring.norm() / xi.norm() - 1.0).abs() < 1e-15 && spring.dot(n).abs() < 1e-12);
            prop_assert_eq!(rotated_spring(Vec3::zero(), n), Vec3::zero());
        }

        #[test]
        fn a_spring_in_the_plane_stays_as_it_is(x in -1.0..1.0, y in -1.0..1.0) {
            let xi = Vec3::new(x, y, 0.0);
            prop_assert_eq!(rotated_spring(xi, Vec3::new(0.0, 0.0, 1.0)), xi);
        }

        #[test]
        fn a_spring_carried_round_with_its_pair_turns_with_it(xi in vector(), n in unit(), axis in unit(), angle in -2.0..2.0) {
            // About an axis in the contact plane, in small steps.
            prop_assume!(axis.cross(n).norm() > 0.1);
            let axis = axis.perpendicular_to(n);
            let (axis, steps) = (axis * (1.0 / axis.norm()), 1000);
            let start = xi.perpendicular_to(n);
            let end = (1..=steps).fold(start, |xi, k| rotated_spring(xi, rotated(n, axis, angle * f64::from(k) / f64::from(steps))));
            // Rescaling lengthens both components alike: an error of second order in each step.
            prop_assert!((end - rotated(start, axis, angle)).norm() < 1e-9 + angle * angle / f64::from(steps));
        }

        #[test]
        fn a_torsion_spring_turns_with_its_pair_which_the_published_step_forgets(n in unit(), to in unit(), twist in -1.0..1.0f64) {
            prop_assume!(twist.abs() > 0.01 && n.dot(to) > 0.01);
            let spring = rotated_torsion(n * twist, to);
            prop_assert!((spring - to * twist).norm() < 1e-15);
            prop_assert!((spring.dot(to) - twist).abs() < 1e-15);
            let published = rotated_spring(n * twist, to);
            prop_assert!(published.dot(to).abs() < 1e-12 + 1e-15 / n.cross(to).norm());
        }

        #[test]
        fn moving_back_relaxes_a_spring(v in vector(), n in unit(), dt in 0.01..1.0) {
            let v = v.perpendicular_to(n);
            prop_assume!(v.norm() > 1e-3);
            let there = stretched_spring(Vec3::zero(), n, v, dt);
            prop_assert!((there - v * dt).norm() < 1e-14);
            prop_assert!(stretched_spring(there, n, -v, dt).norm() < 1e-12);
        }

        #[test]
        fn an_undamped_spring_keeps_the_energy_which_the_lagged_order_raises(omega in 0.5..2.0f64, dt in 0.001..0.02) {
            // A unit mass on a tangential spring of stiffness omega squared, velocities half a step behind.
            let steps = (20.0 / dt) as usize;
            let end = |lagged: bool| {
                let (mut xi, mut v) = (0.0, 1.0);
                let mut largest = 0.0f64;
                for _ in 0..steps {
                    let used = if lagged { xi } else { stretched(xi, v, dt) };
                    xi = stretched(xi, v, dt);
                    v += -force(omega * omega, used, 0.0, v) * dt;
                    largest = largest.max(v.abs());
                }
                largest
            };
            prop_assert!((end(false) - 1.0).abs() < 2.0 * omega * dt);
            // A dashpot of minus k dt: the amplitude grows with the rate k dt / 2m.
            let growth = (0.5 * omega * omega * dt * 20.0).exp();
            prop_assert!((end(true) / growth - 1.0).abs() < 4.0 * omega * dt * (1.0 + growth.ln()) + 0.2 * growth.ln());
            prop_assert!(end(true) > 1.0 + 0.5 * growth.ln());
        }

        #[test]
        fn beyond_its_limit_a_spring_that_lags_gains_energy(k in 0.5..2.0f64, eta in 0.05..0.2f64) {
            // A unit mass, velocities half a step behind; its largest speed over the second half of the way and over the first.
            let gain = |fraction: f64| {
                let dt = fraction * lag_limit(k, eta);
                let (mut xi, mut v, mut largest) = (0.0, 1.0, [0.0f64; 2]);
                // The amplitude changes by half of (1 - fraction) eta dt a step: by e^2 on the whole way.
                let steps = (4.0 / ((1.0 - fraction).abs() * eta * dt)) as usize;
                for step in 0..steps {
                    let f = force(k, xi, eta, v);
                    xi = stretched(xi, v, dt);
                    v -= f * dt;
                    let half = &mut largest[2 * step / steps];
                    *half = half.max(v.abs());
                }
                largest[1] / largest[0]
            };
            prop_assert!(gain(0.995) < 0.5 && gain(1.005) > 2.0);
        }
    }

    #[test]
    fn a_spring_along_the_normal_is_lost_and_a_torsion_across_it_counts_as_positive() {
        let (x, z) = (Vec3::new(3.0, 0.0, 0.0), Vec3::new(0.0, 0.0, 1.0));
        assert_eq!((rotated_spring(z * 2.0, z), rotated_spring(x, z)), (Vec3::zero(), x));
        assert_eq!([rotated_torsion(x, z), rotated_torsion(-z, z)], [z * 3.0, -z]);
    }
}
