//! Slow paths through the contact law: a pull there and back, and slides and partings in turn.

use super::{NO_LAW, RADIUS};
use crate::golden::{Complaints, Run};
use crate::spec::wear::def_contact::Parameters;
use crate::spec::wear::eq03_normal_force::normal_force;
use crate::spec::wear::eq05_rescaled_maximum::rescaled_maximum;
use crate::spec::{Contact, Vec3};

/// A slow pull follows the curve, and a closed loop does no work.
pub(super) fn quasistatic_loop(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let (k_n, delta_e, delta_f) = (run.number("k_n")?, run.number("delta_e")?, run.number("delta_f")?);
    let force = |hundredths: f64| normal_force(k_n, delta_e, delta_f, hundredths / 100.0);
    let samples = run.samples::<2>()?;
    for (number, [hundredths, expected]) in samples.iter().copied().enumerate() {
        complaints.near(format_args!("sample {number}: force"), force(hundredths), expected, 2.0 * f64::EPSILON);
    }
    for (number, pair) in samples.windows(2).enumerate() {
        complaints.near(format_args!("sample {}: step", number + 1), pair[1][0] - pair[0][0], 1.0, 0.0);
    }
    // trapezoids are exact between corners
    let work = |path: &mut dyn Iterator<Item = f64>| {
        let forces: Vec<f64> = path.map(force).collect();
        forces.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]) * 0.01).sum::<f64>()
    };
    let out = work(&mut samples.iter().map(|sample| sample[0]));
    let back = work(&mut samples.iter().rev().map(|sample| sample[0]));
    complaints.near("work_outward", out, run.number("work_outward")?, 100.0 * f64::EPSILON);
    complaints.near("work of the loop", out - back, 0.0, 100.0 * f64::EPSILON);
    Ok(())
}

/// Sliding and parting in turn follows the exact path.
pub(super) fn tangential_path(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let (delta_f, f_mt) = (run.number("delta_f")?, run.number("f_mt")?);
    let law = Parameters { k_t: run.number("k_t")?, f_mt, delta_e: delta_f, delta_f, ..NO_LAW };
    let (mut s, mut spring, none) = (0.0, Vec3::zero(), Vec3::zero());
    for (number, [slid, delta_n, xi, cap, f_t]) in run.samples()?.into_iter().enumerate() {
        // one step of unit time in which j slides by the change of s
        let slide = Vec3::new(0.0, slid - s, 0.0);
        let apart = Vec3::new(2.0 * RADIUS + delta_n, 0.0, 0.0);
        let outcome = law.act(&Contact::new(apart, slide, none, none, RADIUS, RADIUS), spring, 1.0);
        (s, spring) = (slid, outcome.memory);
        // the separation is the difference of the distance and the radii, divided by delta_f in the cap
        let tolerance = 64.0 * RADIUS * f64::EPSILON;
        complaints.near(format_args!("sample {number}: xi"), spring.0[1], xi, tolerance);
        complaints.near(format_args!("sample {number}: cap"), rescaled_maximum(delta_n, delta_f, f_mt), cap, tolerance);
        complaints.near(format_args!("sample {number}: f_t"), -outcome.wrench.force.0[1], f_t, tolerance);
    }
    Ok(())
}
