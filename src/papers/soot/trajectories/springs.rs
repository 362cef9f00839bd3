//! Two solid spheres of unit mass and radius, moved by the four springs and the half-step scheme.

use crate::golden::{Complaints, Run, steps};
use crate::spec::mechanics::contact_kinematics::ContactKinematics;
use crate::spec::mechanics::four_springs::{Friction, Memory, Springs, SpringsOutcome};
use crate::spec::mechanics::kinetic_energy::{kinetic_energy, translational_energy};
use crate::spec::mechanics::primary_particle::solid_inertia;
use crate::spec::mechanics::verlet::{half_step, half_step_start};
use crate::spec::{Contact, Flat, Vec3};

/// The springs and the friction of a run; what it does not have is nought.
pub(super) fn of_run(run: &Run) -> Result<(Springs<f64>, Friction<f64>), String> {
    let get = |key| run.number_or_nought(key);
    let springs = Springs {
        k_n: get("k_n")?,
        k_t: get("k_t")?,
        k_r: get("k_r")?,
        k_o: get("k_o")?,
        eta_n: get("eta_n")?,
        eta_t: get("eta_t")?,
        eta_r: get("eta_r")?,
        eta_o: get("eta_o")?,
    };
    Ok((springs, Friction::from_ratio([get("mu_t")?, get("mu_r")?, get("mu_o")?], 1.0)))
}

/// The vector that begins with a number of a row.
pub(super) fn vector(row: &[f64], k: usize) -> Vec3<f64> {
    Vec3([row[k], row[k + 1], row[k + 2]])
}

/// A pair of numbers as a vector in the plane.
pub(super) fn plane([x, y]: [f64; 2]) -> Vec3<f64> {
    Vec3([x, y, 0.0])
}

/// A spin in the plane.
pub(super) fn spin(omega: f64) -> Vec3<f64> {
    Vec3([0.0, 0.0, omega])
}

struct Pair {
    springs: Springs<f64>,
    friction: Friction<f64>,
    bonded: bool,
    x: [Vec3<f64>; 2],
    v: [Vec3<f64>; 2],
    omega: [Vec3<f64>; 2],
    memory: Memory<f64>,
}

impl Pair {
    fn new(run: &Run, bonded: bool, v: [Vec3<f64>; 2], omega: [Vec3<f64>; 2]) -> Result<Self, String> {
        let (springs, friction) = of_run(run)?;
        let x = [Vec3::zero(), Vec3::new(2.0, 0.0, 0.0)];
        Ok(Self { springs, friction, bonded, x, v, omega, memory: Memory::from_fn(|_| 0.0) })
    }
    fn act(&self, dt: f64) -> SpringsOutcome<f64> {
        let c = Contact::new(self.x[0] - self.x[1], self.v[0] - self.v[1], self.omega[0], self.omega[1], 1.0, 1.0);
        self.springs.evaluate(&self.friction, self.bonded, &ContactKinematics::of_spheres(&c), self.memory, dt)
    }
    fn start(&mut self, dt: f64) {
        let w = self.act(0.0).wrench;
        for (k, (force, torque)) in [(w.force, w.torque_i), (-w.force, w.torque_j)].into_iter().enumerate() {
            (self.v[k], self.omega[k]) =
                half_step_start(self.v[k], self.omega[k], force, torque, 1.0, solid_inertia(1.0, 1.0), dt);
        }
    }
    fn step(&mut self, dt: f64) {
        let SpringsOutcome { wrench: w, memory, .. } = self.act(dt);
        self.memory = memory;
        for (k, (force, torque)) in [(w.force, w.torque_i), (-w.force, w.torque_j)].into_iter().enumerate() {
            let (v, x, omega) =
                half_step(self.x[k], self.v[k], self.omega[k], force, torque, 1.0, solid_inertia(1.0, 1.0), dt);
            (self.v[k], self.x[k], self.omega[k]) = (v, x, omega);
        }
    }
    /// Steps of about `dt` from one sample to the next; before the comparison the velocities are brought to the time of the positions.
    fn follow<const N: usize>(
        &mut self,
        samples: &[[f64; N]],
        dt: f64,
        mut compare: impl FnMut(&Self, usize, &[f64; N]),
    ) -> Result<(), String> {
        compare(self, 0, &samples[0]);
        for (k, window) in samples.windows(2).enumerate() {
            let time = window[1][0] - window[0][0];
            let count = steps((time / dt).ceil())?;
            let dt = time / count as f64;
            self.start(dt);
            (0..count).for_each(|_| self.step(dt));
            self.start(-dt);
            compare(self, k + 1, &window[1]);
        }
        Ok(())
    }
    fn distance(&self) -> Vec3<f64> {
        self.x[1] - self.x[0]
    }
    /// Unit vectors from the first sphere to the second, and a quarter turn from it.
    fn directions(&self) -> [Vec3<f64>; 2] {
        let n = self.distance() * (1.0 / self.distance().norm());
        [n, Vec3::new(-n.0[1], n.0[0], 0.0)]
    }
    /// Energy of the springs and of the motion about the centre of mass.
    fn energy(&self) -> f64 {
        let held = self.springs.stored(self.bonded, self.distance().norm() - 2.0, &self.memory);
        let moving = [0, 1].map(|k| kinetic_energy(1.0, self.v[k], solid_inertia(1.0, 1.0), self.omega[k]));
        let of_the_centre = translational_energy(2.0, (self.v[0] + self.v[1]) * 0.5);
        held.into_iter().chain(moving).sum::<f64>() - of_the_centre
    }
}

/// A kicked neck follows the planar motion.
pub(super) fn neck(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let (none, kick) = (Vec3::zero(), plane([0.0, run.number("kick")?]));
    let samples = run.samples::<10>()?;
    complaints.near("sample 0: t", 0.0, samples[0][0], 0.0);
    Pair::new(run, true, [none, kick], [none, none])?.follow(&samples, 2e-5, |pair, number, sample| {
        let [_, side] = pair.directions();
        let now = [
            ("x_i", pair.x[0].0[0]),
            ("y_i", pair.x[0].0[1]),
            ("x_j", pair.x[1].0[0]),
            ("y_j", pair.x[1].0[1]),
            ("omega_i", pair.omega[0].0[2]),
            ("omega_j", pair.omega[1].0[2]),
            ("xi_t", pair.memory.tangential.dot(side)),
            ("xi_r", pair.memory.rolling.dot(side)),
            ("energy", pair.energy()),
        ];
        // the first step stretches the springs by a step of the kick, which stays
        let tolerance = 5e-6;
        for ((name, now), expected) in now.into_iter().zip(&sample[1..]) {
            complaints.near(format_args!("sample {number}: {name}"), now, *expected, tolerance);
        }
    })
}

/// Oblique collisions with spin follow the events of holding and slipping.
pub(super) fn oblique(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let samples = run.samples::<26>()?;
    let (start, last) = (&samples[0], samples.len() - 1);
    let mut pair = Pair::new(run, false, [4, 13].map(|k| vector(start, k)), [7, 16].map(|k| vector(start, k)))?;
    complaints.near("sample 0: t", 0.0, start[0], 0.0);
    complaints.near("last sample: t", samples[last][0], run.number("contact_time")?, 0.0);
    let state = |pair: &Pair| {
        let of_both =
            |k: usize, name: [&'static str; 3]| [(name[0], pair.x[k]), (name[1], pair.v[k]), (name[2], pair.omega[k])];
        [of_both(0, ["x_i", "v_i", "omega_i"]), of_both(1, ["x_j", "v_j", "omega_j"])].concat()
    };
    // the start is at first touch, where there is no force yet; friction is of first order in the step
    let tolerance = 2e-5;
    pair.follow(&samples, 1e-4, |pair, number, sample| {
        for (k, (name, now)) in state(pair).into_iter().enumerate() {
            complaints.near_vector(format_args!("sample {number}: {name}"), now, vector(sample, 1 + 3 * k), tolerance);
        }
        // at the end the springs are let go
        if number < last {
            for (name, now, k) in [("xi_t", pair.memory.tangential, 19), ("xi_r", pair.memory.rolling, 22)] {
                complaints.near_vector(format_args!("sample {number}: {name}"), now, vector(sample, k), tolerance);
            }
            complaints.near(format_args!("sample {number}: xi_o"), pair.memory.torsion, sample[25], tolerance);
        }
    })?;
    let end = run.numbers::<18>("final")?;
    let parted = state(&pair);
    (0..30_000).for_each(|_| pair.step(1e-4));
    for (k, ((name, now), (_, at_end))) in state(&pair).into_iter().zip(parted).enumerate() {
        // places are those of the end of the contact, velocities do not change any more
        let found = if k % 3 == 0 { at_end } else { now };
        complaints.near_vector(format_args!("final: {name}"), found, vector(&end, 3 * k), tolerance);
    }
    Ok(())
}

/// Planar collisions with dashpots slip and part as they should.
pub(super) fn planar(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let velocities = [plane(run.numbers("v_i")?), plane(run.numbers("v_j")?)];
    let spins = [spin(run.number("omega_i")?), spin(run.number("omega_j")?)];
    let mut pair = Pair::new(run, false, velocities, spins)?;
    // an overlap below every other scale: the dashpots act from first touch on
    pair.x[1].0[0] -= 1e-12;
    let samples = run.samples::<7>()?;
    complaints.near("sample 0: t", 0.0, samples[0][0], 0.0);
    complaints.near("last sample: t", samples[samples.len() - 1][0], run.number("contact_time")?, 0.0);
    pair.follow(&samples, 2e-5, |pair, number, sample| {
        let [n, side] = pair.directions();
        let now = [
            ("d", pair.distance().norm()),
            ("d_dot", (pair.v[1] - pair.v[0]).dot(n)),
            ("omega_i", pair.omega[0].0[2]),
            ("omega_j", pair.omega[1].0[2]),
            ("xi_t", pair.memory.tangential.dot(side)),
            ("xi_r", pair.memory.rolling.dot(side)),
        ];
        for ((name, now), expected) in now.into_iter().zip(&sample[1..]) {
            complaints.near(format_args!("sample {number}: {name}"), now, *expected, 5e-5);
        }
    })?;
    (0..50_000).for_each(|_| pair.step(2e-5));
    let end = run.numbers::<6>("final")?;
    for k in [0, 1] {
        let [x, y, omega] = [pair.v[k].0[0], pair.v[k].0[1], pair.omega[k].0[2]];
        for (name, now, expected) in
            [("v_x", x, end[3 * k]), ("v_y", y, end[3 * k + 1]), ("omega", omega, end[3 * k + 2])]
        {
            complaints.near(format_args!("final: {name} of sphere {k}"), now, expected, 2e-5);
        }
    }
    Ok(())
}
