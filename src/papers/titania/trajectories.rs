//! The golden trajectories of the titania paper, moved by the contact law.

use crate::golden::{Complaints, Run, Trajectory};
use crate::spec::titania::eq12_sliding::{sawtooth, sliding_spring, spring_energy};
use crate::spec::titania::{Parameters, Titania};
use crate::spec::{Contact, Vec3};

/// The files, each with its comparison.
pub(super) const TRAJECTORIES: &[Trajectory] = &[
    Trajectory { file: "titania_relaxation.json", check: relaxation },
    Trajectory { file: "titania_sawtooth.json", check: sliding },
];

/// A pair approaches and relaxes as integrated independently.
fn relaxation(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let (r, f_a, m_eff) = (run.number("r_i")? + run.number("h_n")?, run.number("f_a")?, run.number("m_eff")?);
    let law = Titania { tau_s: 0.0, tau_r: 0.0, lambda_t: r, ..Titania::paper(1.0, 1.0, 1.0) };
    let k = Parameters { k_n: run.number("k_n")?, r_eff: 0.5 * r, gamma_n: run.number("gamma_n")?, inertia: 1.0 };
    let (samples, none) = (run.samples::<3>()?, Vec3::zero());
    let [t, mut delta, mut rate] = samples[0];
    complaints.near("sample 0: t", 0.0, t, 0.0);
    complaints.near("sample 0: rate", 0.0, rate, 0.0);
    let fastest = samples.iter().map(|sample| sample[2].abs()).fold(0.0, f64::max);
    let steps = 4000;
    for (number, window) in samples.windows(2).enumerate() {
        let dt = (window[1][0] - window[0][0]) / f64::from(steps);
        for _ in 0..steps {
            let along = |x| Vec3::new(x, 0.0, 0.0);
            let c = Contact::new(along(2.0 * r - delta), along(-rate), none, none, r, r);
            let acts = law.act(&k, [r - 0.5 * delta; 2], &c, || -f_a, none, dt);
            rate -= acts.wrench.force.0[0] / m_eff * dt;
            delta += rate * dt;
        }
        // the scheme is of first order: at most a few steps ahead or behind
        complaints.near(format_args!("sample {}: delta_n", number + 1), delta, window[1][1], 4.0 * dt * fastest);
        complaints.near(format_args!("sample {}: rate", number + 1), rate, window[1][2], 5e-3 * fastest);
    }
    Ok(())
}

/// The spring slips back and forth along the exact path.
fn sliding(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    // places are multiples of 0.05 nm: in that unit they are whole and nothing is rounded
    let (unit, tolerance) = (0.05, 1e-12);
    let mut whole = |what: std::fmt::Arguments, length: f64| {
        let number = (length / unit).round();
        complaints.near(what, unit * number, length, tolerance);
        number
    };
    let (tau_s, a) = (run.number("tau_s_gpa")?, run.number("a_nm2")?);
    let lambda = whole(format_args!("lambda_t_nm"), run.number("lambda_t_nm")?);
    let samples = run.samples::<4>()?;
    let places: Vec<f64> = samples
        .iter()
        .enumerate()
        .map(|(number, sample)| whole(format_args!("sample {number}: s_nm"), sample[0]))
        .collect();
    let (x, mut xi, mut at, mut slips, mut lost) = (Vec3::new(1.0, 0.0, 0.0), Vec3::zero(), 0.0, 0.0, 0.0);
    for (number, ([_, xi_nm, force_spring, force_printed], place)) in samples.into_iter().zip(places).enumerate() {
        let stretched = xi + x * (place - at);
        let (force, kept) = sliding_spring(tau_s, a, lambda, stretched, 1.0);
        if stretched.norm() >= lambda {
            slips += 1.0;
            let energy = |xi| unit * spring_energy(tau_s, a, lambda, xi);
            lost += energy(stretched) - energy(kept);
        }
        (xi, at) = (kept, place);
        complaints.near(format_args!("sample {number}: xi, units of 0.05 nm"), kept.0[0], xi_nm / unit, tolerance);
        complaints.near(format_args!("sample {number}: force of the spring"), force.0[0], force_spring, tolerance);
        let direction = x * if place < 0.0 { -1.0 } else { 1.0 };
        let printed = sawtooth(tau_s, a, place.abs(), lambda, direction).1;
        complaints.near(format_args!("sample {number}: force as printed"), printed.0[0], force_printed, tolerance);
    }
    complaints.near("slips", slips, run.number("slips")?, 0.0);
    complaints.near("energy lost", lost, slips * run.number("lost_per_slip_nn_nm")?, tolerance);
    Ok(())
}
