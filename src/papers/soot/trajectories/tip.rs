//! The tip, and what its cantilever reads.

use crate::golden::{Complaints, Run};
use crate::spec::soot::def_filter::filter_step;
use crate::spec::soot::eq25_tip::{tip_velocity, tip_way};

/// The cantilever reads a sawtooth exactly.
pub(super) fn reading(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let (omega_0, period, peak) = (run.number("omega_0")?, run.number("period")?, run.number("peak")?);
    let samples = run.samples::<3>()?;
    let [t, f, reading] = samples[0];
    for (name, value) in [("t", t), ("f", f), ("g", reading)] {
        complaints.near(format_args!("sample 0: {name}"), 0.0, value, 0.0);
    }
    let (mut g, mut g_dot) = (0.0, 0.0);
    for (number, window) in samples.windows(2).enumerate() {
        let ([t, f, _], [t_next, f_next, expected]) = (window[0], window[1]);
        let dt = t_next - t;
        // the force rises to the end of the interval, drop or not
        let rise = peak * dt / period;
        (g, g_dot) = filter_step(omega_0, dt, g, g_dot, f, f + rise);
        complaints.near(format_args!("sample {}: g", number + 1), g, expected, 1e-14 * peak);
        let dropped = if f_next > 0.0 { 0.0 } else { peak };
        complaints.near(format_args!("sample {}: f", number + 1), f + rise - dropped, f_next, 1e-14 * peak);
    }
    Ok(())
}

/// The tip moves as Eq. 25 says.
pub(super) fn way(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let (velocity, rate, t_reversal) = (1.5, 1e8, 1.08e-8);
    for (number, [t, v, z]) in run.samples()?.into_iter().enumerate() {
        // the time of reversal is rounded, and so is its difference from the time
        complaints.near(format_args!("sample {number}: v"), tip_velocity(t, velocity, rate, t_reversal), v, 1e-15);
        complaints.near(format_args!("sample {number}: z"), tip_way(t, velocity, rate, t_reversal), z, 1e-22);
    }
    Ok(())
}
