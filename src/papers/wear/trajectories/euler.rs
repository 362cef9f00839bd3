//! The integrator follows the exact map of an oscillator below, at and above its limit.

use crate::golden::{Complaints, Run, steps};
use crate::spec::mechanics::symplectic_euler::symplectic_euler;
use crate::spec::numbers::Reference;
use crate::spec::wear::a04_time_step::kick_and_drift;
use crate::spec::{Real, Vec3};

pub(super) fn check(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let (h, samples) = (run.exact("h")?, run.exact_samples()?);
    let one = Reference::exact(1.0);
    // the start is one step before the first sample, undone exactly: x_0 = x_1 - h v_1, v_0 = v_1 + h x_0
    let [_, x_1, v_1] = samples[0];
    let mut x = x_1 - h * v_1;
    let mut v = v_1 + h * x;
    let (mut position, mut velocity) = (Vec3::new(x.to_f64(), 0.0, 0.0), Vec3::new(v.to_f64(), 0.0, 0.0));
    let mut n = 0;
    for (number, [until, x_n, v_n]) in samples.into_iter().enumerate() {
        while n < steps(until.to_f64())? {
            (v, x) = kick_and_drift(one, one, h, x, v);
            let (none, dt) = (Vec3::zero(), h.to_f64());
            (velocity, position, _) = symplectic_euler(position, velocity, none, -position, none, 1.0, 1.0, dt);
            n += 1;
        }
        complaints.near(format_args!("sample {number}: n"), n as f64, until.to_f64(), 0.0);
        let size = (x.squared() + v.squared()).sqrt();
        for (name, value, double, expected) in [("x", x, position.0[0], x_n), ("v", v, velocity.0[0], v_n)] {
            // the file has 25 digits
            let digits = (value - expected).abs() / size;
            complaints.near(format_args!("sample {number}: error of {name}"), digits.to_f64(), 0.0, 1e-23);
            // a step makes a few roundings, and the norm may grow 199-fold between its least and its largest
            let tolerance = 4.0 * 199.0 * n as f64 * f64::EPSILON * size.to_f64();
            complaints.near(format_args!("sample {number}: {name}"), double, expected.to_f64(), tolerance);
        }
    }
    Ok(())
}
