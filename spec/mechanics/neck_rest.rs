//! The gap at which the normal spring of a neck or a contact is at rest.

use crate::equation::Equation;
use crate::{Real, equation, piecewise};

/// Elongation of the normal spring of a neck.
///
/// ```math
/// \xi_\mathrm{n} = \delta - \delta_0
/// ```
///
/// # Reading
///
/// A neck between spheres that only touch is at rest at $\delta_0 = 0$, as in Demidov, Gor & Khalizov 2024. Sintered spheres overlap ($\delta_0 < 0$), and material may fill a gap between
/// others ($\delta_0 > 0$): their neck is at rest at the gap at which it was made. Arms and torques count with the gap itself.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `delta` | $\delta$ | m | any | gap, negative for an overlap |
/// | `delta_0` | $\delta_0$ | m | any | gap at rest |
/// | → `xi` | $\xi_\mathrm{n}$ | m | | elongation of the spring, negative if it is compressed |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_neck_at_rest_exerts_no_force_and_stores_no_energy`
/// * `the_force_of_a_neck_is_minus_the_gradient_of_its_energy`
/// * `a_neck_at_rest_in_touch_is_the_neck_of_the_paper_bit_for_bit`
/// * `a_neck_without_dashpots_retraces_its_motion`
#[inline(always)]
pub fn elongation<R: Real>(delta: R, delta_0: R) -> R {
    delta - delta_0
}

/// Gap below which a contact of two spheres repels.
///
/// ```math
/// \delta_\mathrm{c} = \begin{cases} \min(\delta_0, 0) & \text{if } \delta < 0 \\ 0 & \text{otherwise} \end{cases}
/// ```
///
/// # Reading
///
/// Where a neck between overlapping spheres is missing or has broken, its cross-section is left: two flat faces, which touch at the gap at which the neck was at rest and not where whole spheres would touch. Nothing
/// acts between them while they are apart. As soon as the spheres no longer overlap they may turn other places towards each other and are whole again. Nowhere does
/// the energy jump: in both cases the spring is relaxed at $\delta = 0$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `delta` | $\delta$ | m | any | gap, negative for an overlap |
/// | `delta_0` | $\delta_0$ | m | any | gap at rest of the neck, or of the contact before; 0 for whole spheres |
/// | → `delta_c` | $\delta_\mathrm{c}$ | m | | gap below which the contact repels |
///
/// Rounding: at most 0 ULP.
///
/// # Laws
///
/// * `what_a_broken_neck_leaves_repels_only_below_its_gap_at_rest`
/// * `spheres_that_have_parted_are_whole_again`
/// * `the_energy_of_a_contact_is_continuous_as_spheres_part`
#[inline(always)]
pub fn contact_rest<R: Real>(delta: R, delta_0: R) -> R {
    piecewise([(delta.lt(R::zero()), delta_0.min(R::zero()))], R::zero())
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/neck_rest.rs", "mechanics-elongation", [], elongation),
        equation!("mechanics/neck_rest.rs", "mechanics-contact-rest", [], contact_rest),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::contact_kinematics::ContactKinematics;
    use crate::mechanics::four_springs::{Friction, Memory, Springs, SpringsOutcome};
    use crate::mechanics::kick_and_drift::{drift, kick};
    use crate::mechanics::samples::vector;
    use crate::numbers::Dual;
    use crate::{Contact, Flat, Vec3};
    use proptest::prelude::*;

    const SPRINGS: [f64; 8] = [2.0, 0.7, 0.4, 0.3, 0.1, 0.07, 0.05, 0.03];

    /// A pair of spheres at rest, of radii 1 and 0.75, whose normal spring is at rest at `rest`.
    fn act<R: Real>(bonded: R::Mask, gap: R, rest: f64) -> (SpringsOutcome<R>, R) {
        let (springs, rest) = (Springs::from_fn(|k| R::lit(SPRINGS[k])), R::lit(rest));
        let (x, still) = (Vec3::new(R::lit(1.75) + gap, R::zero(), R::zero()), Vec3::zero());
        let contact = Contact::new(x, still, still, still, R::one(), R::lit(0.75));
        let memory = Memory { rest, ..Memory::zero() };
        let friction = Friction::from_ratio([R::zero(); 3], R::zero());
        let at = ContactKinematics { delta: gap, ..ContactKinematics::of_spheres(&contact) };
        let outcome = springs.evaluate(&friction, bonded, &at, memory, R::zero());
        (outcome, springs.stored(bonded, gap, &memory)[0])
    }
    fn pull(bonded: bool, gap: f64, rest: f64) -> (f64, f64) {
        let (outcome, energy) = act(bonded, gap, rest);
        (outcome.wrench.force.0[0], energy)
    }
    fn gap() -> impl Strategy<Value = f64> {
        -0.7..0.7f64
    }

    proptest! {
        #[test]
        fn a_neck_at_rest_exerts_no_force_and_stores_no_energy(rest in gap()) {
            prop_assert_eq!((elongation(rest, rest), pull(true, rest, rest)), (0.0, (0.0, 0.0)));
            prop_assert!(pull(true, rest + 0.1, rest).0 < 0.0 && pull(true, rest - 0.1, rest).0 > 0.0);
        }

        #[test]
        fn the_force_of_a_neck_is_minus_the_gradient_of_its_energy(delta in gap(), rest in gap()) {
            for bonded in [true, false] {
                let (outcome, energy) = act(bonded, Dual::variable(delta), rest);
                prop_assert!((outcome.wrench.force.0[0].value + energy.slope).abs() < 1e-14);
            }
        }

        #[test]
        fn a_neck_at_rest_in_touch_is_the_neck_of_the_paper_bit_for_bit(delta in gap()) {
            prop_assert_eq!(elongation(delta, 0.0).to_bits(), delta.to_bits());
            prop_assert_eq!(elongation(-0.0f64, 0.0).to_bits(), (-0.0f64).to_bits());
            prop_assert_eq!(pull(true, delta, 0.0).1, 0.5 * SPRINGS[0] * (delta * delta));
        }

        #[test]
        fn a_neck_without_dashpots_retraces_its_motion(rest in gap(), beyond in -0.1..0.1f64, v in vector()) {
            let springs = Springs { k_n: 2.0, ..Springs::from_fn(|_| 0.0) };
            let memory = Memory { rest, ..Memory::zero() };
            let force = |x: Vec3<f64>| {
                let still = Vec3::zero();
                let at = ContactKinematics::of_spheres(&Contact::new(x, still, still, still, 1.0, 0.75));
                springs.evaluate(&Friction::from_ratio([0.0; 3], 0.0), true, &at, memory, 0.0).wrench.force
            };
            let begin = Vec3::new(1.75 + rest + beyond, 0.0, 0.0);
            let (mut x, mut v) = (begin, v * 0.1);
            for _ in 0..2 {
                // Symmetric in time: half a drift, a kick, half a drift.
                for _ in 0..300 {
                    x = drift(x, v, 5e-3);
                    v = kick(v, force(x), 1.0, 1e-2);
                    x = drift(x, v, 5e-3);
                }
                v = -v;
            }
            prop_assert!((x - begin).norm() < 1e-12, "{x:?} {begin:?}");
        }

        #[test]
        fn what_a_broken_neck_leaves_repels_only_below_its_gap_at_rest(delta in -0.7..0.0f64, rest in -0.7..0.0f64) {
            let (force, energy) = pull(false, delta, rest);
            prop_assert_eq!(force > 0.0, delta < rest);
            prop_assert_eq!((contact_rest(delta, rest), contact_rest(delta, -rest), contact_rest(-delta, rest)), (rest, 0.0, 0.0));
            prop_assert_eq!((force, energy), if delta < rest { pull(true, delta, rest) } else { (0.0, 0.0) });
            prop_assert_eq!(act(false, delta, rest).0.memory.rest, rest);
            // A neck across a gap leaves nothing.
            prop_assert_eq!(pull(false, delta, -rest), pull(false, delta, 0.0));
        }

        #[test]
        fn spheres_that_have_parted_are_whole_again(delta in prop_oneof![Just(0.0), 0.0..0.7f64], rest in gap()) {
            let outcome = act(false, delta, rest).0;
            prop_assert_eq!((outcome.wrench.force.norm(), outcome.memory), (0.0, Memory::zero()));
            // A neck remembers.
            prop_assert_eq!(act(true, delta, rest).0.memory.rest, rest);
        }

        #[test]
        fn the_energy_of_a_contact_is_continuous_as_spheres_part(delta in gap(), rest in gap()) {
            let energy = |delta: f64| pull(false, delta, rest).1;
            prop_assert!((energy(delta + 1e-9) - energy(delta)).abs() < 1e-8);
            prop_assert!((energy(1e-9) - energy(-1e-9)).abs() < 1e-8);
        }
    }
}
