//! The amplification matrix of a time step, for the laws of stability.

use crate::Vec3;
use crate::mechanics::kick_and_drift::{drift, kick};

/// Largest modulus of the eigenvalues of a step of the symplectic Euler method of a mass on a spring and a dashpot.
pub(crate) fn spectral_radius(m: f64, k: f64, c: f64, dt: f64) -> f64 {
    let along = |x: f64| Vec3::new(x, 0.0, 0.0);
    let step = |x: f64, v: f64| {
        let force = along(-k * x - c * v);
        let v = kick(along(v), force, m, dt);
        [drift(along(x), v, dt).0[0], v.0[0]]
    };
    // Position and velocity in units that balance the matrix.
    let columns = [step(1.0, 0.0), step(0.0, 1.0 / dt)];
    let matrix = faer::Mat::from_fn(2, 2, |i, j| columns[j][i] * [1.0, dt][i]);
    matrix
        .eigenvalues()
        .expect("eigenvalues of a 2 by 2 matrix")
        .into_iter()
        .map(|z| z.re.hypot(z.im))
        .fold(0.0, f64::max)
}
