//! The pair tests of ON-DEM: prescribed motions of two spheres.

use super::{NO_SPRINGS, UP, near, read, rough};
use std::f64::consts::PI;
use veridem::spec::mechanics::four_springs::{Memory, Springs};
use veridem::spec::soot::{Along, Coefficients, Following, Reading};
use veridem::spec::{Contact, PairModel, Vec3, Wrench};

/// The pair tests of ON-DEM, the European network on the discrete element method (working group 4, testingInteractions): two fixed spheres of radius 1
/// overlap by 0.05 and turn so that their surfaces slide at a given velocity. Returns the friction on the first after each of 200 steps, and the torques.
fn sheared(
    whole: Vec3<f64>,
    branch: impl Fn(f64) -> Vec3<f64>,
    slide: impl Fn(f64) -> Vec3<f64>,
) -> Vec<(Vec3<f64>, Wrench<f64>)> {
    sheared_with(Along, whole, branch, slide)
}

/// The same with springs read like this.
fn sheared_with<S: Reading>(
    reading: S,
    whole: Vec3<f64>,
    branch: impl Fn(f64) -> Vec3<f64>,
    slide: impl Fn(f64) -> Vec3<f64>,
) -> Vec<(Vec3<f64>, Wrench<f64>)> {
    let law = read(Springs { k_n: 1e7, k_t: 5e6, ..NO_SPRINGS }, [0.5, 0.0, 0.0], reading);
    let mut memory = Memory::zero();
    let one = |step: usize| {
        let t = step as f64 * DT;
        let n = branch(t);
        // Both spheres turn alike: their surfaces meet at twice the arm.
        let spin = whole + n.cross(slide(t)) * (1.0 / 1.95);
        let x = n * 1.95;
        let contact = Contact::new(x, whole.cross(x), spin, spin, 1.0, 1.0);
        let outcome = law.pair(&contact, &Coefficients { bonded: 0.0 }, memory, DT);
        memory = outcome.memory;
        (outcome.wrench.force.perpendicular_to(n), outcome.wrench)
    };
    (1..=200).map(one).collect()
}

const DT: f64 = 6.0 * PI / 200.0;
const X: Vec3<f64> = Vec3([1.0, 0.0, 0.0]);
/// Where the friction of half the normal force of 5e5 N ends.
const SLIP: f64 = 2.5e5;

fn largest(forces: &[(Vec3<f64>, Wrench<f64>)]) -> f64 {
    forces.iter().map(|(force, _)| force.norm()).fold(0.0, f64::max)
}

/// ON-DEM, `testingInteractions`, tests 1 and 2. The reference counts the sliding of one surface; here both together slide at that velocity.
///
/// Equations: `soot-contact`, `soot-8`, `soot-12`, `soot-17`.
#[test]
fn a_sheared_contact_is_elastic_and_then_slips_as_in_on_dem() {
    let swing = |amplitude: f64| sheared(Vec3::zero(), |_| UP, move |t: f64| X * (amplitude * t.sin()));
    let elastic = swing(0.02);
    near(elastic[0].0.norm(), 886.949957289513, 1e-12);
    near(elastic[0].1.torque_i.norm(), 864.7762083572752, 1e-12);
    near(elastic[1].0.norm(), 2652.9772412570437, 1e-12);
    near(largest(&elastic), 199950.64629463377, 1e-12);
    assert_eq!(elastic[0].1.torque_i, elastic[0].1.torque_j);
    near(largest(&swing(0.08)), SLIP, 1e-12);
}

/// ON-DEM, `testingInteractions`, test 3: the pair turns about the direction of shear, and the friction stays along it.
///
/// Equations: `soot-contact`, `soot-8`, `soot-rotated`, `soot-12`, `soot-17`.
#[test]
fn friction_across_the_plane_in_which_a_pair_turns_grows_as_in_on_dem() {
    let turning = sheared(X, |t| Vec3([0.0, -t.sin(), t.cos()]), |_| X * 0.02);
    for (step, (force, _)) in turning.iter().enumerate() {
        let expected = (5e6 * 0.02 * DT * (step + 1) as f64).min(SLIP);
        near(force.0[0].abs(), expected, 1e-12);
        near(force.norm(), expected, 1e-12);
    }
}

/// ON-DEM, `testingInteractions`, test 4: the pair spins about its normal. The springs of the papers stay fixed in space and are relaxed after each turn; an objective law, as that of the
/// network, slips from t = 2.5 on.
///
/// Equations: `soot-contact`, `soot-8`, `soot-rotated`, `soot-12`.
#[test]
fn springs_do_not_follow_a_pair_that_spins_about_its_normal_unlike_in_on_dem() {
    let spinning = sheared(UP, |_| UP, |t| Vec3([t.cos(), t.sin(), 0.0]) * 0.02);
    for (step, (force, _)) in spinning.iter().enumerate() {
        // The sum of the steps of 2e5 |sin(t / 2)|.
        let t = DT * (step + 1) as f64;
        let expected = 1e5 * DT * (0.5 * t).sin().abs() / (0.5 * DT).sin();
        assert!((force.norm() - expected).abs() < 1e-12 * SLIP, "{step}: {force:?} {expected}");
    }
    assert!(largest(&spinning) < 0.81 * SLIP);
}

/// Test 4 with springs that are carried: the friction grows in proportion to the time and slips from t = 2.5 on, as that of the network. A step turns the pair by 0.094 and
/// the spring by 2 arctan(0.047), 7e-5 less.
///
/// Equations: `mechanics-carried-spring`, `soot-rotated`.
#[test]
fn carried_springs_follow_a_pair_that_spins_about_its_normal_as_in_on_dem() {
    let spinning = sheared_with(Following, UP, |_| UP, |t| Vec3([t.cos(), t.sin(), 0.0]) * 0.02);
    for (step, (force, _)) in spinning.iter().enumerate() {
        let expected = (1e5 * DT * (step + 1) as f64).min(SLIP);
        near(force.norm(), expected, 1e-6);
    }
}

/// ON-DEM, `testingInteractions`, test 5 in 200 steps: the spheres approach, slide, part and slide back, twice. They slip when the load gets small, lose their springs where they part, and begin anew.
///
/// Equations: `soot-contact`, `soot-8`, `soot-12`, `soot-17`.
#[test]
fn a_cycle_of_load_and_shear_slips_parts_and_begins_anew_as_in_on_dem() {
    let law = rough(Springs { k_n: 1e7, k_t: 5e6, ..NO_SPRINGS }, [0.5, 0.0, 0.0]);
    let (rate, mut memory) = (2.0 / 3.0, Memory::zero());
    let mut one = |step: i32| {
        let phase = rate * DT * f64::from(step);
        let distance = 1.95 - 0.06 / rate * phase.sin();
        // Both spheres turn alike: their surfaces meet at twice the arm.
        let spin = UP.cross(X * (-0.03 * phase.sin())) * (1.0 / distance);
        let contact = Contact::new(UP * distance, UP * (-0.06 * phase.cos()), spin, spin, 1.0, 1.0);
        let outcome = law.pair(&contact, &Coefficients { bonded: 0.0 }, memory, DT);
        memory = outcome.memory;
        outcome.wrench
    };
    let all: Vec<Wrench<f64>> = (1..=200).map(&mut one).collect();
    for (step, friction, load, torque) in [
        (1, 887.6800569076977, 556511.4675763816, 862.9798503472982),
        (25, 231994.5565666564, 1400000.0000000012, 215754.93760699042),
        (43, 431454.734818127, 883201.3624085655, 412401.6643376772),
        (44, 415656.0487081051, 831312.0974162102, 398379.0536253416),
        (59, 8877.942259452044, 17755.884518904088, 8870.060473575828),
        (60, 0.0, 0.0, 0.0),
        (191, -7575.07285216162, 17755.884518901865, -7568.347746222357),
        (200, -38802.229266425675, 500000.00000000047, -37832.17353476503),
    ] {
        let Wrench { force, torque_i, torque_j } = all[step - 1];
        // The load is the stiffness times a small difference of distances of 2.
        let rounding = |expected: f64| 1e-12 * expected.abs() + 1e-8;
        assert!((force.0[0] + friction).abs() < rounding(friction), "{step}: {force:?}, expected {friction}");
        assert!((force.0[2] - load).abs() < rounding(load), "{step}: {force:?}, expected {load}");
        assert!((torque_i.0[1] - torque).abs() < rounding(torque), "{step}: {torque_i:?}, expected {torque}");
        assert_eq!(torque_i, torque_j);
    }
}

/// ON-DEM, `testingInteractions`, test 6 as it was with a dashpot, before Maxwell arms took its place: the spheres approach and part. Its law is known in closed form, and never pulls.
///
/// Equations: `soot-contact`, `soot-4`.
#[test]
fn a_dashpot_never_pulls_as_in_on_dem() {
    let law = rough(Springs { k_n: 1e7, eta_n: 1e7, ..NO_SPRINGS }, [0.0; 3]);
    let mut pressed = vec![];
    for step in 0..=3334 {
        let t = 6.0 * PI / 1e4 * f64::from(step);
        let (distance, rate) = (2.02 - 0.04 * (1.0 - t.cos()), -0.04 * t.sin());
        let contact = Contact::new(UP * distance, UP * rate, Vec3::zero(), Vec3::zero(), 1.0, 1.0);
        let load = law.pair(&contact, &Coefficients { bonded: 0.0 }, Memory::zero(), DT).wrench.force.0[2];
        let expected = if distance < 2.0 { (1e7 * (2.0 - distance) - 1e7 * rate).max(0.0) } else { 0.0 };
        assert!((load - expected).abs() < 1e-8, "{step}: {load}, expected {expected}");
        if load > 0.0 {
            pressed.push(step);
        }
    }
    // They touch at a third of a period of 2 pi before and after its middle, and press no longer than to 0.68 of it.
    assert_eq!((pressed[0], pressed[pressed.len() - 1], pressed.len()), (556, 2275, 1720));
}
