//! Head-on collisions of two equal spheres with a spring and a dashpot.

use super::{UP, dashpot, near};
use std::f64::consts::PI;
use veridem::spec::mechanics::kick_and_drift::{drift, kick};
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::spec::wear::def_contact::Parameters;
use veridem::spec::{Contact, Vec3};

/// Place and velocity of one sphere that is `x` from the plane of symmetry and approaches it with `v`, after some steps; the other one is its mirror image.
fn collide(k_n: f64, c_n: f64, [r, m]: [f64; 2], [x, v]: [f64; 2], steps: usize, dt: f64) -> [f64; 2] {
    let law = Parameters { k_n, c_n, k_t: 0.0, delta_e: 0.0, delta_f: 0.0, f_mt: 0.0, c_t: 0.0 };
    let (mut x, mut v) = (UP * x, UP * -v);
    for _ in 0..steps {
        let contact = Contact::new(x * 2.0, v * 2.0, Vec3::zero(), Vec3::zero(), r, r);
        v = kick(v, law.act(&contact, Vec3::zero(), dt).wrench.force, m, dt);
        x = drift(x, v, dt);
    }
    [x.0[2], v.0[2]]
}

/// LAMMPS, `unittest/granular/tests`: `dem01-hooke-twosphere` with restitutions of 0.8, 0.5 and 0.2, `dem01-hooke-veldamp`, `dem01-hooke-massvel` and `dem01-legacy-hooke-twosphere`, whose damping is given. The
/// dashpot may pull.
///
/// Equations: `wear-contact`, `wear-2`, `wear-3`, `mechanics-kick`, `mechanics-drift`.
#[test]
fn two_spheres_rebound_as_in_lammps() {
    let (r, k) = (0.0025, 1e6);
    let m = sphere_mass(2700.0, r);
    let reversed = |e: f64| dashpot(0.5 * m, k, e);
    for (c_n, x, v) in [
        (reversed(0.8), 2.5118996608531133e-3, 1.5997548989987018),
        (reversed(0.5), 2.506804594433399e-3, 0.9993293792676254),
        (reversed(0.2), 2.501550633180154e-3, 0.39988658958497214),
        (4.05, 2.5068052837844447e-3, 0.9994057600771722),
        (45_000.0 * 0.5 * m, 2.5069240303402292e-3, 1.012915942061946),
        (46_000.0 * 0.5 * m, 2.5067840755741795e-3, 0.997056415615803),
    ] {
        let [found_x, found_v] = collide(k, c_n, [r, m], [0.00255, 2.0], 2068, 3e-8);
        near(found_x, x, 1e-14);
        near(found_v, v, 1e-13);
    }
}

/// YADE, `checks/checkViscElPM.py`: two spheres in the midst of a damped collision of 0.2 s, by the closed form that its check holds to 1e-4. The spring of each of them, of which the pair has half the stiffness and
/// half the damping, is made for the mass of one.
///
/// Equations: `wear-contact`, `wear-2`, `wear-3`, `mechanics-kick`, `mechanics-drift`.
#[test]
fn two_spheres_overlap_as_in_yade() {
    let (r, t_c, e, v, dt, steps) = (0.1, 0.2, 0.3f64, 2.0, 1e-5, 5000);
    let m = sphere_mass(2000.0, r);
    let (k, c) = (m / (t_c * t_c) * (PI * PI + e.ln() * e.ln()), -2.0 * m / t_c * e.ln());
    let t = f64::from(steps) * dt;
    let expected = v * t_c / PI * (e.ln() * t / t_c).exp() * (PI * t / t_c).sin();
    let [x, _] = collide(0.5 * k, 0.5 * c, [r, m], [r, v], steps as usize, dt);
    near(r - x, expected, 1e-4);
}
