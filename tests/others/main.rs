//! Values that other projects publish with their tests, computed with these laws. Each is compared to the digits in which it is printed, or to a
//! bound with its reason. The documentation of a test names the source, and in its last line the equations; the book shows it with them.

mod attraction;
mod bonds;
mod capacity;
mod collisions;
mod engine;
mod on_dem;
mod springs;
mod wall;

use std::f64::consts::PI;
use veridem::spec::Vec3;
use veridem::spec::mechanics::four_springs::{Friction, Springs};
use veridem::spec::soot::{Along, Attraction, Soot, Wall};

const NO_SPRINGS: Springs<f64> =
    Springs { k_n: 0.0, k_t: 0.0, k_r: 0.0, k_o: 0.0, eta_n: 0.0, eta_t: 0.0, eta_r: 0.0, eta_o: 0.0 };
const UP: Vec3<f64> = Vec3([0.0, 0.0, 1.0]);

/// Friction of spheres and walls, with `mu` of sliding, rolling and torsion, and no attraction.
fn rough(contact: Springs<f64>, mu: [f64; 3]) -> Soot {
    read(contact, mu, Along)
}

/// The same with springs read like this.
fn read<S>(contact: Springs<f64>, mu: [f64; 3], reading: S) -> Soot<S> {
    let friction = Friction::from_ratio(mu, 1.0);
    let wall = Wall { contact, friction, hamaker: 0.0, delta_0: 1.0, cutoff: 10.0 };
    let attraction = Attraction { a: 0.0, delta_0: 1.0, psi: 0.0, kappa: 1.0, d_cutoff: 10.0, cutoff: 10.0 };
    Soot { neck: contact, contact, friction, attraction, reading, walls: [wall; 2] }
}

#[track_caller]
fn near(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs(), "found {found}, expected {expected}");
}

/// The dashpot of a spring that reverses a mass with a restitution `e`.
fn dashpot(m: f64, k: f64, e: f64) -> f64 {
    -2.0 * e.ln() * (m * k / (PI * PI + e.ln() * e.ln())).sqrt()
}
