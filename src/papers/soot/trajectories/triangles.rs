//! Three spheres in a triangle fall, collide and vibrate in the engine as their golden trajectories, under both ways to step.

use super::engine::{BOTH, Motion, law, spheres};
use crate::golden::{Complaints, Run};
use crate::spec::Vec3;
use crate::spec::mechanics::sphere::sphere_mass;

/// From SI to the units of the engine.
const NANO: f64 = 1e9;
const RADIUS: f64 = 14.0;

pub(super) fn check(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let samples = run.samples::<3>()?;
    let dt = samples[samples.len() - 1][0] * NANO / 20_000.0;
    let corner = |k: usize| {
        let angle = std::f64::consts::TAU / 3.0 * k as f64;
        Vec3([angle.cos(), angle.sin(), 0.0])
    };
    let from_centre = (2.0 * RADIUS + NANO * run.number("delta_start")?) / 3f64.sqrt();
    let inwards = -run.number("speed")? / 3f64.sqrt();
    let most = |k: usize, unit: f64| samples.iter().map(|sample| unit * sample[k].abs()).fold(0.0, f64::max);
    let (way, speed) = (most(1, NANO), most(2, 1.0));
    for integrator in BOTH {
        let mut system = spheres(&[0, 1, 2].map(|k| corner(k) * from_centre), RADIUS, sphere_mass(1.7e-3, RADIUS));
        // The dashpots act from first touch on.
        system.particles.x.iter_mut().for_each(|x| *x = *x * (1.0 - 1e-14));
        for (k, v) in system.particles.v.iter_mut().enumerate() {
            *v = corner(k) * inwards;
        }
        if run.word("name")?.contains("neck") {
            system.necks = vec![(0, 1), (0, 2), (1, 2)];
        }
        let mut law = law(run)?;
        for springs in [&mut law.neck, &mut law.contact] {
            (springs.k_n, springs.eta_n) = (springs.k_n * 1e3, springs.eta_n * 1e12);
        }
        law.attraction.a *= 1e21;
        let mut motion = Motion::new(law, system, integrator, dt)?;
        for (number, sample) in samples.iter().enumerate() {
            let what = format!("{integrator:?}, sample {number}");
            let late = motion.until(NANO * sample[0])?;
            let [a, b, c] = [0, 1, 2].map(|id| motion.state(id, late));
            let sides = [[a, b], [b, c], [c, a]].map(|[a, b]| {
                let side = a[0] - b[0];
                (side.norm() - 2.0 * RADIUS, (a[1] - b[1]).dot(side) / side.norm())
            });
            let (gap, rate) = sides[0];
            for (k, side) in sides.iter().enumerate().skip(1) {
                complaints.near(format_args!("{what}: gap of pair {k} and of pair 0"), side.0, gap, 1e-12 * RADIUS);
            }
            complaints.near(format_args!("{what}: gap"), gap, NANO * sample[1], 5e-4 * way);
            // Velocities half a step behind are wrong by as much as half a step of acceleration.
            complaints.near(format_args!("{what}: rate"), rate, sample[2], 2e-3 * speed);
        }
        for (id, w) in motion.simulation.system().particles.w.iter().enumerate() {
            complaints.near_vector(format_args!("{integrator:?}: spin of sphere {id}"), *w, Vec3::zero(), 1e-12);
        }
    }
    Ok(())
}
