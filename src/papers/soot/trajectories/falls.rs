//! Two spheres, and a sphere and a plane, fall onto each other as the energy integral says.

use crate::golden::{Complaints, Run};
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::soot::eq18_hamaker::{hamaker_energy, hamaker_force};
use crate::spec::soot::eq21_hamaker_plane::{plane_energy, plane_force};

pub(super) fn check(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let (r, a, rho, start) = (run.number("r")?, run.number("a")?, run.number("rho")?, run.number("delta_start")?);
    let mass = sphere_mass(rho, r);
    // the gap closes with the acceleration of both spheres, or of one
    type Law = fn(f64, f64, f64) -> f64;
    let (energy, force, m): (Law, Law, f64) = match run.word("partner")? {
        "plane" => (plane_energy, plane_force, mass),
        _ => (|r, d, a| hamaker_energy(r, r, d, a), |r, d, a| hamaker_force(r, r, d, a), 0.5 * mass),
    };
    let speed_at = |gap| (2.0 * (energy(r, start, a) - energy(r, gap, a)) / m).sqrt();
    let (samples, total) = (run.samples::<3>()?, run.number("total_time")?);
    let dt = total / 200_000.0;
    let (mut gap, mut speed, mut time) = (start, -0.5 * dt * force(r, start, a) / m, 0.0);
    for (number, [delta, t, by_energy]) in samples.iter().copied().enumerate() {
        complaints.near(format_args!("sample {number}: speed"), speed_at(delta), by_energy, 1e-13 * by_energy);
        while gap > delta && time < total {
            speed += dt * force(r, gap, a) / m;
            gap -= dt * speed;
            time += dt;
        }
        // the last step may be too long by a step
        complaints.near(format_args!("sample {number}: time"), time, t, 1.5 * dt + 1e-8 * total);
    }
    let [delta, t, speed] = samples[samples.len() - 1];
    complaints.near("last sample: gap", delta, run.number("delta_end")?, 0.0);
    complaints.near("last sample: time", t, total, 0.0);
    complaints.near("last sample: speed", speed, run.number("final_speed")?, 0.0);
    Ok(())
}
