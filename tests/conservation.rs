//! Does the engine obey the conservation laws of the equations?

mod common;

use common::{crowd, run, settings, sheared_crowd};
use veridem::motion::{BoxRelaxation, inertia};
use veridem::simulation::Simulation;
use veridem::spec::Vec3;
use veridem::spec::wear::law::Wear;
use veridem::system::{Domain, System};

fn momentum(system: &System) -> Vec3<f64> {
    let p = &system.particles;
    (0..p.len()).fold(Vec3::zero(), |sum, k| sum + p.v[k] * p.mass[k])
}

fn angular_momentum(system: &System) -> Vec3<f64> {
    let p = &system.particles;
    (0..p.len()).fold(Vec3::zero(), |sum, k| sum + p.x[k].cross(p.v[k]) * p.mass[k] + p.w[k] * inertia(p, k))
}

/// A crowd in free space: nothing outside acts on it.
fn free(seed: u64) -> System {
    let mut system = crowd(seed, 6);
    system.domain = Domain { periodic: [false; 3], ..system.domain };
    system
}

fn assert_close(a: Vec3<f64>, b: Vec3<f64>, scale: f64) {
    assert!((a - b).norm() < 1e-12 * scale, "{a:?} against {b:?}, scale {scale}");
}

#[test]
fn linear_and_angular_momentum_are_conserved_to_rounding() {
    let before = free(5);
    let after = run(before.clone(), settings(2e-5), 1000);
    let p = &before.particles;
    let scale: f64 = (0..p.len()).map(|k| p.mass[k] * p.v[k].norm()).sum();
    assert_close(momentum(&before), momentum(after.system()), scale);
    assert_close(angular_momentum(&before), angular_momentum(after.system()), scale * before.domain.sides[0]);
}

#[test]
fn the_discrete_account_closes_to_rounding() {
    for system in [crowd(6, 6), sheared_crowd(6, 6)] {
        let ledger = run(system, settings(2e-5), 1000).ledger();
        assert!(ledger.discrete_residual().abs() < 1e-11 * ledger.turnover(), "{ledger:?}");
    }
}

#[test]
fn the_physical_account_closes_with_the_work_of_a_box_that_follows_its_stress() {
    let residual = |dt: f64| {
        let relaxation = BoxRelaxation { target: [-3e3; 3], modulus: 1e4 };
        let ledger = run(crowd(6, 6), settings(dt).relax_box(relaxation), (0.02 / dt) as usize).ledger();
        assert!(ledger.work_box.abs() > 0.02 * ledger.turnover(), "{ledger:?}");
        ledger.physical_residual().abs() / ledger.turnover()
    };
    let (coarse, fine) = (residual(2e-5), residual(5e-6));
    assert!(coarse < 2e-2 && fine < 0.3 * coarse, "{coarse} {fine}");
}

fn physical_residual(dt: f64, steps: usize) -> f64 {
    let simulation: Simulation<Wear> = run(sheared_crowd(7, 6), settings(dt), steps);
    let ledger = simulation.ledger();
    ledger.physical_residual().abs() / ledger.turnover()
}

#[test]
fn the_physical_account_closes_to_first_order_in_the_time_step() {
    let (coarse, fine) = (physical_residual(8e-6, 250), physical_residual(1e-6, 2000));
    assert!(coarse < 1e-2, "{coarse}");
    // First order: an eighth of the step, an eighth of the residual, give or take the higher orders.
    assert!(fine < 0.25 * coarse, "{coarse} {fine}");
}
