//! Coulomb friction of a spring: largest force, onset of slip, and spring after a slip.
//!
//! Equations and sections are numbered as in Demidov, Gor & Khalizov 2024.

use super::rotated_spring::Span;
use super::spring_force::force;
use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Eq. 13**, Section 2.1.3: whether friction is static.
///
/// ```math
/// \lVert \mathbf{f}_0 \rVert \le f_{\mathrm{C,s}}
/// ```
///
/// # Reading
///
/// As printed; at equality the contact holds. The test force is Eq. 12 with the spring of this step.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `f_0` | $\mathbf{f}_0$ | N (3) | any | test force |
/// | `f_cs` | $f_{\mathrm{C,s}}$ | N | >= 0 | static friction force |
/// | → `holds` | | 1 | | one if friction is static, else zero |
///
/// Rounding: at most 0 ULP.
///
/// # Laws
///
/// * `a_contact_either_holds_or_slips`
/// * `at_the_largest_static_force_a_contact_holds`
#[inline(always)]
pub fn is_static<R: Real>(f_0: Vec3<R>, f_cs: R) -> R {
    R::select(f_0.norm().le(f_cs), R::one(), R::zero())
}

/// **Eq. 14**, Section 2.1.3: whether friction is dynamic.
///
/// ```math
/// \lVert \mathbf{f}_0 \rVert > f_{\mathrm{C,s}}
/// ```
///
/// # Reading
///
/// As printed.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `f_0` | $\mathbf{f}_0$ | N (3) | any | test force |
/// | `f_cs` | $f_{\mathrm{C,s}}$ | N | >= 0 | static friction force |
/// | → `slips` | | 1 | | one if friction is dynamic, else zero |
///
/// Rounding: at most 0 ULP.
///
/// # Laws
///
/// * `a_contact_either_holds_or_slips`
#[inline(always)]
pub fn is_dynamic<R: Real>(f_0: Vec3<R>, f_cs: R) -> R {
    R::select(f_0.norm().gt(f_cs), R::one(), R::zero())
}

/// **Eq. 15**, Section 2.1.3: largest force of static friction.
///
/// ```math
/// f_{\mathrm{C,s}} = \mu_\mathrm{s} f_\mathrm{n}
/// ```
///
/// # Reading
///
/// $f_\mathrm{n}$ is the repulsion of the contact, spring and dashpot, without van der Waals and capillary forces, which act
/// through the overlap; where their sum would pull, it is zero and so is all friction.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `mu_s` | $\mu_\mathrm{s}$ | 1 | >= 0 | static friction coefficient |
/// | `f_n` | $f_\mathrm{n}$ | N | >= 0 | normal force of the contact |
/// | → `f_cs` | $f_{\mathrm{C,s}}$ | N | | static friction force |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `no_normal_force_no_friction`
/// * `friction_grows_by_its_coefficient_with_the_normal_force`
#[inline(always)]
pub fn static_friction<R: Real>(mu_s: R, f_n: R) -> R {
    mu_s * f_n
}

/// **Eq. 16**, Section 2.1.3: force of dynamic friction.
///
/// ```math
/// f_{\mathrm{C,d}} = \mu_\mathrm{d} f_\mathrm{n}
/// ```
///
/// # Reading
///
/// The normal force is that of Eq. 15. With $\mu_\mathrm{d} < \mu_\mathrm{s}$ a steadily driven contact does not slide at $f_{\mathrm{C,d}}$: it slips
/// back to it and sticks again, so that its force is a sawtooth between the two.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `mu_d` | $\mu_\mathrm{d}$ | 1 | >= 0 | dynamic friction coefficient, at most the static one |
/// | `f_n` | $f_\mathrm{n}$ | N | >= 0 | normal force of the contact |
/// | → `f_cd` | $f_{\mathrm{C,d}}$ | N | | dynamic friction force |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `friction_grows_by_its_coefficient_with_the_normal_force`
#[inline(always)]
pub fn dynamic_friction<R: Real>(mu_d: R, f_n: R) -> R {
    mu_d * f_n
}

/// **Eq. 17**, Section 2.1.3: the spring after it has slipped.
///
/// ```math
/// \boldsymbol{\xi}' = -\frac{1}{k} \left(f_{\mathrm{C,d}} \frac{\mathbf{f}_0}{\lVert \mathbf{f}_0 \rVert} + \eta \dot{\boldsymbol{\xi}}\right)
/// ```
///
/// # Reading
///
/// Erratum: the signs belong to a force $-k\boldsymbol{\xi} - \eta\dot{\boldsymbol{\xi}}$. The spring is meant to continue with the force that was applied, which with Eq. 12 is
/// $\boldsymbol{\xi}' = \frac{1}{k} \big(f_{\mathrm{C,d}} \mathbf{f}_0 / \lVert \mathbf{f}_0 \rVert - \eta\dot{\boldsymbol{\xi}}\big)$. Without stiffness there is no spring, and its length is zero.
///
/// Effect: the printed spring pulls the other way in the step after a slip. Driven steadily, friction would
/// jump from $f_{\mathrm{C,s}}$ to $-f_{\mathrm{C,d}}$ at every slip and be $(f_{\mathrm{C,s}} - f_{\mathrm{C,d}})/2$ on average, zero if the two are equal.
///
/// Proof: `the_spring_goes_on_with_the_force_that_was_applied_which_the_printed_one_reverses`, `a_steady_drive_is_held_by_half_the_difference_of_static_and_dynamic_friction_as_printed`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k` | $k$ | N/m | >= 0 | stiffness |
/// | `eta` | $\eta$ | kg/s | >= 0 | damping coefficient |
/// | `f_cd` | $f_{\mathrm{C,d}}$ | N | >= 0 | dynamic friction force |
/// | `f_0` | $\mathbf{f}_0$ | N (3) | any | test force, above the static friction force |
/// | `xi_dot` | $\dot{\boldsymbol{\xi}}$ | m/s (3) | any | rate |
/// | → `xi_next` | $\boldsymbol{\xi}'$ | m (3) | | spring after the step |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_spring_goes_on_with_the_force_that_was_applied_which_the_printed_one_reverses`
/// * `a_steady_drive_is_held_by_half_the_difference_of_static_and_dynamic_friction_as_printed`
/// * `a_dashpot_alone_keeps_no_spring`
#[inline(always)]
pub fn slipped_spring<R: Real>(k: R, eta: R, f_cd: R, f_0: Vec3<R>, xi_dot: Vec3<R>) -> Vec3<R> {
    slipped(k, eta, f_0 * (f_cd / f_0.norm()), xi_dot)
}

/// Eq. 17 for a spring of any kind and the force that is applied to it.
#[inline(always)]
fn slipped<R: Real, S: Span<R>>(k: R, eta: R, applied: S, xi_dot: S) -> S {
    let exists = k.gt(R::zero());
    S::select(exists, (applied - xi_dot * eta) * (R::one() / k), S::none())
}

/// **Section 2.1.3**, Eqs. 12 to 17 together, unnumbered: force of a spring with friction, and the spring after the step.
///
/// ```math
/// (\mathbf{f}, \boldsymbol{\xi}') = \begin{cases} (\mathbf{f}_0, \boldsymbol{\xi}) & \lVert \mathbf{f}_0 \rVert \le f_{\mathrm{C,s}} \\
///   \big(f_{\mathrm{C,d}} \mathbf{f}_0 / \lVert \mathbf{f}_0 \rVert, \; \text{Eq. 17}\big) & \text{otherwise} \end{cases}
/// ```
///
/// # Reading
///
/// The spring has already been incremented, see [`stretched_spring`](super::rotated_spring::stretched_spring).
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `xi` | $\boldsymbol{\xi}$ | m (3) | any | spring, incremented |
/// | `xi_dot` | $\dot{\boldsymbol{\xi}}$ | m/s (3) | any | rate |
/// | `k` | $k$ | N/m | > 0 | stiffness |
/// | `eta` | $\eta$ | kg/s | >= 0 | damping coefficient |
/// | `mu_s` | $\mu_\mathrm{s}$ | 1 | >= 0 | static friction coefficient |
/// | `mu_d` | $\mu_\mathrm{d}$ | 1 | >= 0 | dynamic friction coefficient, at most the static one |
/// | `f_n` | $f_\mathrm{n}$ | N | >= 0 | normal force of the contact |
/// | → `slip` | | 1 | | one if the spring slips, else zero |
/// | → `f_cs` | $f_{\mathrm{C,s}}$ | N | | static friction force |
/// | → `f_cd` | $f_{\mathrm{C,d}}$ | N | | dynamic friction force |
/// | → `f` | $\mathbf{f}$ | N (3) | | force on i |
/// | → `xi_next` | $\boldsymbol{\xi}'$ | m (3) | | spring after the step |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `friction_never_exceeds_its_cap`
/// * `friction_driven_in_a_closed_path_delivers_no_work`
/// * `a_steady_drive_makes_a_sawtooth_between_static_and_dynamic_friction`
#[inline(always)]
pub fn spring_with_friction<R: Real>(
    xi: Vec3<R>,
    xi_dot: Vec3<R>,
    k: R,
    eta: R,
    mu_s: R,
    mu_d: R,
    f_n: R,
) -> (R, R, R, Vec3<R>, Vec3<R>) {
    let (f_cs, f_cd) = (static_friction(mu_s, f_n), dynamic_friction(mu_d, f_n));
    let f_0 = force(k, xi, eta, xi_dot);
    let holds = f_0.norm().le(f_cs);
    let (f, xi_next) = rubbed(k, eta, xi, xi_dot, holds, f_cd);
    (is_dynamic(f_0, f_cs), f_cs, f_cd, f, xi_next)
}

/// Force and next length of a spring of any kind that holds where the mask is true and slips elsewhere.
#[inline(always)]
pub fn rubbed<R: Real, S: Span<R>>(k: R, eta: R, xi: S, xi_dot: S, holds: R::Mask, f_cd: R) -> (S, S) {
    let f_0 = force(k, xi, eta, xi_dot);
    let f = S::select(holds, f_0, f_0 * (f_cd / f_0.size()));
    (f, S::select(holds, xi, slipped(k, eta, f, xi_dot)))
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/friction.rs", "soot-13", ["13"], is_static),
        equation!("mechanics/friction.rs", "soot-14", ["14"], is_dynamic),
        equation!("mechanics/friction.rs", "soot-15", ["15"], static_friction),
        equation!("mechanics/friction.rs", "soot-16", ["16"], dynamic_friction),
        equation!("mechanics/friction.rs", "soot-17", ["17"], slipped_spring),
        equation!("mechanics/friction.rs", "soot-friction", [], spring_with_friction),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::vector;
    use crate::mechanics::spring_force::{spring_energy, spring_force};
    use crate::numbers::Dual;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_contact_either_holds_or_slips(f_0 in vector(), f_cs in 0.0..2.0) {
            prop_assert_eq!(is_static(f_0, f_cs) + is_dynamic(f_0, f_cs), 1.0);
            prop_assert_eq!(is_static(f_0, f_0.norm()), 1.0);
        }

        #[test]
        fn no_normal_force_no_friction(xi in vector(), v in vector(), k in 0.1..10.0, eta in 0.0..2.0, mu in 0.0..2.0) {
            prop_assert_eq!(static_friction(mu, 0.0), 0.0);
            prop_assert_eq!(spring_with_friction(xi, v, k, eta, mu, mu, 0.0).3.norm(), 0.0);
        }

        #[test]
        fn friction_grows_by_its_coefficient_with_the_normal_force(mu in 0.0..2.0f64, f_n in 0.0..3.0f64) {
            for friction in [static_friction::<Dual>, dynamic_friction::<Dual>] {
                let force = friction(Dual::constant(mu), Dual::variable(f_n));
                prop_assert_eq!((force.slope, force.value - mu * f_n), (mu, 0.0));
            }
        }

        #[test]
        fn the_spring_goes_on_with_the_force_that_was_applied_which_the_printed_one_reverses(
            f_0 in vector(), xi_dot in vector(), k in 0.1..10.0, eta in 0.0..2.0, share in 0.1..1.0,
        ) {
            let f_cd = share * f_0.norm();
            let applied = f_0 * share;
            let spring = slipped_spring(k, eta, f_cd, f_0, xi_dot);
            prop_assert!((spring_force(k, spring, eta, xi_dot) - applied).norm() < 1e-14);
            let printed = -slipped_spring(k, -eta, f_cd, f_0, xi_dot);
            prop_assert!((spring_force(k, printed, eta, xi_dot) + applied).norm() < 1e-14);
        }

        #[test]
        fn a_steady_drive_is_held_by_half_the_difference_of_static_and_dynamic_friction_as_printed(mu_s in 0.5..1.0f64, share in 0.2..1.0f64) {
            let step = Vec3::new(5e-3, 0.0, 0.0);
            let (mut spring, mut forces) = (Vec3::zero(), vec![]);
            for _ in 0..20_000 {
                let (slip, .., f, next) = spring_with_friction(spring + step, Vec3::zero(), 1.0, 0.0, mu_s, share * mu_s, 1.0);
                spring = if slip > 0.0 { -next } else { next };
                forces.push(f.0[0]);
            }
            let mean = forces.iter().sum::<f64>() / forces.len() as f64;
            prop_assert!((mean - 0.5 * (1.0 - share) * mu_s).abs() < 0.03);
            let least = forces.iter().copied().fold(0.0, f64::min);
            prop_assert!((least + share * mu_s).abs() < 0.01);
        }

        #[test]
        fn a_dashpot_alone_keeps_no_spring(f_0 in vector(), xi_dot in vector(), eta in 0.0..2.0) {
            prop_assert_eq!(slipped_spring(0.0, eta, 1.0, f_0, xi_dot), Vec3::zero());
        }

        #[test]
        fn friction_never_exceeds_its_cap(
            xi in vector(), v in vector(), k in 0.1..10.0, eta in 0.0..2.0, mu_s in 0.0..2.0, share in 0.0..1.0, f_n in 0.0..3.0,
        ) {
            let (slip, f_cs, f_cd, f, next) = spring_with_friction(xi, v, k, eta, mu_s, share * mu_s, f_n);
            prop_assert!(f.norm() <= f_cs * (1.0 + 1e-15));
            // what holds keeps its bits
            prop_assert!(slip == 1.0 || next == xi);
            prop_assert!(slip == 0.0 || (f.norm() - f_cd).abs() <= 1e-14);
        }

        #[test]
        fn friction_driven_in_a_closed_path_delivers_no_work(corners in prop::collection::vec(vector(), 3..7), mu in 0.05..1.0) {
            let (k, steps) = (2.0, 400);
            let mut spring = Vec3::zero();
            let mut round = || {
                let (mut work, mut lost, mut coarse) = (0.0, 0.0, 0.0);
                let held = spring_energy(k, spring);
                for n in 0..corners.len() {
                    let step = (corners[(n + 1) % corners.len()] - corners[n]) * (1.0 / f64::from(steps));
                    for _ in 0..steps {
                        let (.., f, next) = spring_with_friction(spring + step, Vec3::zero(), k, 0.0, mu, mu, 1.0);
                        work += f.dot(step);
                        lost += f.dot(spring + step - next);
                        coarse += spring_energy(k, next - spring);
                        spring = next;
                    }
                }
                // the force is that of the end of each step
                (work, lost, work - lost - coarse - spring_energy(k, spring) + held)
            };
            // The second round starts where the first one ended; the drive pays for what slips and gains nothing.
            round();
            let (work, lost, missing) = round();
            prop_assert!(missing.abs() < 1e-12, "{missing}");
            prop_assert!(lost >= -1e-15 && work > -1e-2);
            // along each side the spring aligns itself, on a tractrix of the length at which it slips, and then slips all the way
            let sides = (0..corners.len()).map(|n| (corners[(n + 1) % corners.len()] - corners[n]).norm());
            let slipping: f64 = sides.map(|side| (side - 8.0 * mu / k).max(0.0)).sum();
            prop_assert!(work >= 0.98 * mu * slipping - 1e-2, "{work} {slipping}");
        }

        #[test]
        fn a_steady_drive_makes_a_sawtooth_between_static_and_dynamic_friction(mu_s in 0.5..1.0f64, share in 0.2..1.0f64) {
            let (k, f_n, step) = (1.0, 1.0, Vec3::new(1e-4, 0.0, 0.0));
            let (mut spring, mut forces) = (Vec3::zero(), vec![]);
            for _ in 0..100_000 {
                let (.., f, next) = spring_with_friction(spring + step, Vec3::zero(), k, 0.0, mu_s, share * mu_s, f_n);
                spring = next;
                forces.push(f.0[0]);
            }
            let settled = &forces[20_000..];
            let mean = settled.iter().sum::<f64>() / settled.len() as f64;
            prop_assert!((mean - 0.5 * (1.0 + share) * mu_s).abs() < 0.05);
            prop_assert!(settled.iter().all(|f| *f >= share * mu_s - 1e-12 && *f <= mu_s + 1e-12));
        }
    }

    #[test]
    fn at_the_largest_static_force_a_contact_holds() {
        let f_0 = Vec3::new(3.0, 0.0, -4.0);
        assert_eq!([is_static(f_0, 5.0), is_dynamic(f_0, 5.0)], [1.0, 0.0]);
        assert_eq!([is_static(f_0, 5.0f64.next_down()), is_dynamic(f_0, 5.0f64.next_down())], [0.0, 1.0]);
        let (slips, .., force, kept) = spring_with_friction(f_0, Vec3::zero(), 1.0, 0.0, 0.5, 0.25, 10.0);
        assert_eq!((slips, force, kept), (0.0, f_0, f_0));
    }
}
