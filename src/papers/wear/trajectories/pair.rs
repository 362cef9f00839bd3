//! Two spheres on a line, moved by the contact law and Eq. 1, follow closed forms.

use super::{NO_LAW, RADIUS};
use crate::golden::{Complaints, Run};
use crate::spec::mechanics::symplectic_euler::symplectic_euler;
use crate::spec::wear::a35_impact::{impact_separation, impact_velocity};
use crate::spec::wear::def_contact::Parameters;
use crate::spec::{Contact, Vec3};

struct Pair {
    law: Parameters<f64>,
    masses: [f64; 2],
    x: [Vec3<f64>; 2],
    v: [Vec3<f64>; 2],
    lost: f64,
}

fn along(x: f64) -> Vec3<f64> {
    Vec3::new(x, 0.0, 0.0)
}

impl Pair {
    /// Surfaces `gap` apart, `i` moving with `v_i` and `j` with `v_j` along the normal, which is the x axis.
    fn new(law: Parameters<f64>, masses: [f64; 2], gap: f64, v_i: f64, v_j: f64) -> Self {
        Self { law, masses, x: [along(2.0 * RADIUS + gap), along(0.0)], v: [along(v_i), along(v_j)], lost: 0.0 }
    }
    fn gap(&self) -> f64 {
        (self.x[0] - self.x[1]).0[0] - 2.0 * RADIUS
    }
    fn speed(&self) -> f64 {
        (self.v[0] - self.v[1]).0[0]
    }
    fn step(&mut self, dt: f64) {
        let none = Vec3::zero();
        let contact = Contact::new(self.x[0] - self.x[1], self.v[0] - self.v[1], none, none, RADIUS, RADIUS);
        let outcome = self.law.act(&contact, none, dt);
        self.lost += outcome.losses.normal_damping;
        for (k, force) in [outcome.wrench.force, -outcome.wrench.force].into_iter().enumerate() {
            (self.v[k], self.x[k], _) =
                symplectic_euler(self.x[k], self.v[k], none, force, none, self.masses[k], 1.0, dt);
        }
    }
    /// Steps to each time of the samples in turn and compares separation and relative velocity, and the velocities of both if the samples have
    /// them. The scheme is of first order: it is at most a step of the fastest motion ahead or behind.
    fn follow<const N: usize>(&mut self, samples: &[[f64; N]], complaints: &mut Complaints) {
        let m_eff = self.masses[0] * self.masses[1] / (self.masses[0] + self.masses[1]);
        let fastest = samples.iter().map(|sample| sample[2].abs()).fold(0.0, f64::max);
        let steps = 4000;
        complaints.near("sample 0: t", 0.0, samples[0][0], 0.0);
        for (number, sample) in samples.iter().enumerate() {
            let end = number.max(1);
            let dt = (samples[end][0] - samples[end - 1][0]) / f64::from(steps);
            if number > 0 {
                (0..steps).for_each(|_| self.step(dt));
            }
            let per_time = (self.law.k_n / m_eff).sqrt() + self.law.c_n / m_eff;
            let of_speed = dt * fastest * per_time.max(per_time * per_time);
            complaints.near(format_args!("sample {number}: separation"), self.gap(), sample[1], dt * fastest);
            complaints.near(format_args!("sample {number}: velocity"), self.speed(), sample[2], of_speed);
            for (k, (v, expected)) in self.v.iter().zip(sample.iter().skip(3)).enumerate() {
                let of_sphere = of_speed * m_eff / self.masses[k];
                complaints.near(format_args!("sample {number}: velocity of sphere {k}"), v.0[0], *expected, of_sphere);
            }
        }
    }
}

/// A collision.
pub(super) fn collision(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let (m_i, m_j, v_0, t_f) = (run.number("m_i")?, run.number("m_j")?, run.number("v0")?, run.number("t_f")?);
    let [max_overlap, restitution] = [run.number("max_overlap")?, run.number("restitution")?];
    let m_eff = m_i * m_j / (m_i + m_j);
    let law = Parameters { k_n: run.number("k_n")?, c_n: run.number("c_n")?, ..NO_LAW };
    let samples = run.samples::<6>()?;
    let scale = 8.0 * f64::EPSILON;
    let separation = |t| impact_separation(law.k_n, m_eff, law.c_n, -v_0, t);
    let velocity = |t| impact_velocity(law.k_n, m_eff, law.c_n, -v_0, t);
    for (number, [t, delta_n, v_n, .., force]) in samples.iter().copied().enumerate() {
        let (x, v) = (separation(t), velocity(t));
        complaints.near(format_args!("sample {number}: separation by Eq. A.35"), x, delta_n, scale * max_overlap);
        complaints.near(format_args!("sample {number}: velocity by Eq. A.36"), v, v_n, scale * v_0);
        let none = Vec3::zero();
        let contact = Contact::new(along(2.0 * RADIUS + x), along(v), none, none, RADIUS, RADIUS);
        // the separation is the difference of the distance and the radii
        let lost = 4.0 * RADIUS * f64::EPSILON * law.k_n;
        let acts = law.act(&contact, Vec3::zero(), 0.0).wrench.force.0[0];
        complaints.near(format_args!("sample {number}: force"), acts, force, lost + scale);
    }
    complaints.near("separation at t_f", separation(t_f), 0.0, scale * max_overlap);
    complaints.near("restitution by Eq. A.36", velocity(t_f) / v_0, restitution, scale);
    // the overlap is largest where the velocity passes through zero
    let mut times = [0.0, t_f];
    for _ in 0..f64::MANTISSA_DIGITS {
        let middle = 0.5 * (times[0] + times[1]);
        times[usize::from(velocity(middle) > 0.0)] = middle;
    }
    complaints.near("max_overlap", -separation(times[0]), max_overlap, scale * max_overlap);

    let [.., v_i, v_j, _] = samples[0];
    let mut pair = Pair::new(law, [m_i, m_j], 0.0, v_i, v_j);
    pair.follow(&samples, complaints);
    // a first-order scheme of 32 000 steps
    complaints.near("restitution", pair.speed() / v_0, restitution, 1e-3);
    complaints.near("energy_lost", pair.lost, run.number("energy_lost")?, 1e-3 * (0.5 * m_eff * v_0 * v_0));
    Ok(())
}

/// A passage through the cohesive range.
pub(super) fn passage(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let (v_0, mass) = (run.number("v0")?, 2.0 * run.number("m_eff")?);
    let (delta_e, delta_f) = (run.number("delta_e")?, run.number("delta_f")?);
    let law = Parameters { k_n: run.number("k_n")?, c_n: run.number("c_n")?, delta_e, delta_f, ..NO_LAW };
    let mut pair = Pair::new(law, [mass, mass], law.delta_f, -0.5 * v_0, 0.5 * v_0);
    let samples = run.samples::<3>()?;
    pair.follow(&samples, complaints);
    let (dt, mut time) = (1e-5, samples[samples.len() - 1][0]);
    let late = time + 1.0;
    while pair.gap() <= law.delta_f && time < late {
        pair.step(dt);
        time += dt;
    }
    complaints.near("exit_t", time, run.number("exit_t")?, 1e-3);
    complaints.near("exit_v", pair.speed(), run.number("exit_v")?, 1e-3);
    Ok(())
}
