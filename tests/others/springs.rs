//! Springs that turn, slip and decay.

use super::{NO_SPRINGS, UP, near, rough};
use veridem::spec::mechanics::four_springs::{Memory, Springs};
use veridem::spec::mechanics::friction::spring_with_friction;
use veridem::spec::mechanics::kick_and_drift::kick;
use veridem::spec::mechanics::primary_particle::solid_inertia;
use veridem::spec::mechanics::rotated_spring::rotated_spring;
use veridem::spec::soot::Coefficients;
use veridem::spec::{Contact, PairModel, Vec3};

/// MercuryDPM, `Drivers/SelfTests/Interactions/TorsionFrictionSelfTest`: a sphere twists between two fixed ones.
///
/// Equations: `soot-contact`, `soot-10`, `soot-12`, `soot-17`.
#[test]
fn torsion_slips_swings_and_decays_as_in_mercury_dpm() {
    let (k, eta, dt) = (12496.0268, 17.83375, 4e-4);
    let law = rough(Springs { k_n: k, k_o: 0.4 * k, eta_o: 0.4 * eta, ..NO_SPRINGS }, [0.0, 0.0, 0.1]);
    let (mut omega, mut memory, mut torques) = (UP, Memory::zero(), vec![]);
    for step in 0..=480 {
        let contact = Contact::new(UP * 0.995, Vec3::zero(), Vec3::zero(), omega, 0.5, 0.5);
        let outcome = law.pair(&contact, &Coefficients { bonded: 0.0 }, memory, dt);
        memory = outcome.memory;
        torques.push(outcome.wrench.torque_i.0[2]);
        // From both neighbours; the spin is one at the start, so the first kick lasts half a step.
        let kicked = if step == 0 { 0.5 * dt } else { dt };
        omega = kick(omega, outcome.wrench.torque_j * 2.0, solid_inertia(1.0, 0.5), kicked);
    }
    for (step, printed) in [(1, 2.7622), (40, 3.05719), (80, -1.99477), (480, -0.11824)] {
        near(torques[step], printed, 5e-6);
    }
}

/// 4C, unit tests of `particle_interaction_dem_contact_tangential`.
///
/// Equations: `soot-rotated`, `soot-12`, `soot-13`, `soot-17`.
#[test]
fn a_tangential_spring_turns_sticks_and_slips_as_in_4c() {
    let n = Vec3([1.0, 2.0, 4.0]) * (1.0 / 21f64.sqrt());
    let (rate, k, eta) = (Vec3([-0.03, 0.1, 0.12]), 3.0, 0.4480966430480714);
    let turned = rotated_spring(Vec3([0.1, 0.05, -0.25]), n);
    let (.., sticking, _) = spring_with_friction(turned, rate, k, eta, 0.2, 0.2, 1e3);
    let (slips, .., slipping, left) = spring_with_friction(turned, rate, k, eta, 0.2, 0.2, 1.5);
    assert_eq!(slips, 1.0);
    for (found, printed) in [
        (turned, [0.17923102017884, 0.16378007016342, -0.12669779012642]),
        (sticking, [0.52425016124507, 0.53614987479507, -0.32632177321349]),
        (slipping, [0.19231710945136, 0.19668242716113, -0.11970861396859]),
        (left, [0.068586669580933, 0.050624254285441, -0.057826737044788]),
    ] {
        assert!((found - Vec3(printed)).norm() < 1e-14, "{found:?} {printed:?}");
    }
}
