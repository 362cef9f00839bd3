//! Integration of rigid bodies under their loads, several in one vector.

use crate::forces::{LANES, Square, Vectorised};
use crate::spec::mechanics::body::spin;
use crate::spec::mechanics::kick_and_drift::{drift, kick};
use crate::spec::mechanics::kinetic_energy::translational_energy;
use crate::spec::mechanics::quaternion::largest_displacement;
use crate::spec::mechanics::rotation::{free_rotation, to_space};
use crate::spec::numbers::Lanes;
use crate::spec::{Real, Vec3};
use crate::system::{Body, Pose};
use num_traits::One;

type Row = Lanes<LANES>;

/// Bodies and their loads: four rows of numbers for each.
pub struct Push {
    /// Place, velocity, scalar part of the orientation, mass.
    state: Square,
    /// Vector part of the orientation, angular momentum, two moments of inertia.
    turning: Square,
    /// Force, torque, the third moment, how far the farthest sphere is.
    loads: Square,
    /// Orientation when neighbours were listed.
    listed: Square,
    /// Time step, ns.
    dt: f64,
}

impl Push {
    /// Nothing is pushed.
    pub fn new(dt: f64) -> Self {
        let at_rest = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0];
        Self {
            state: [at_rest; LANES],
            turning: [at_rest; LANES],
            loads: [at_rest; LANES],
            listed: [at_rest; LANES],
            dt,
        }
    }

    /// Puts a body, how it lay when neighbours were listed, and the loads on it in a lane.
    #[inline]
    pub fn put(&mut self, lane: usize, body: &Body, listed: &Pose, force: Vec3<f64>, torque: Vec3<f64>) {
        let Body { pose, mass, moments: Vec3([i_x, i_y, i_z]), extent, .. } = *body;
        let (p_0, Vec3([p_x, p_y, p_z])) = (listed.q_0, listed.q);
        let (Vec3([x, y, z]), Vec3([v_x, v_y, v_z])) = (pose.x, body.v);
        let (Vec3([q_x, q_y, q_z]), Vec3([l_x, l_y, l_z])) = (pose.q, body.l);
        let (Vec3([f_x, f_y, f_z]), Vec3([t_x, t_y, t_z])) = (force, torque);
        self.state[lane] = [x, y, z, v_x, v_y, v_z, pose.q_0, mass];
        self.turning[lane] = [q_x, q_y, q_z, l_x, l_y, l_z, i_x, i_y];
        self.loads[lane] = [f_x, f_y, f_z, t_x, t_y, t_z, i_z, extent];
        self.listed[lane] = [p_0, p_x, p_y, p_z, 0.0, 0.0, 0.0, 0.0];
    }

    /// Brings a body to the state after the push; also returns its angular velocity.
    #[inline]
    pub fn take(&self, lane: usize, body: &mut Body) -> Vec3<f64> {
        let [x, y, z, v_x, v_y, v_z, q_0, omega_x] = self.state[lane];
        let [q_x, q_y, q_z, l_x, l_y, l_z, omega_y, omega_z] = self.turning[lane];
        (body.pose.x, body.pose.q_0, body.pose.q) = (Vec3([x, y, z]), q_0, Vec3([q_x, q_y, q_z]));
        (body.v, body.l) = (Vec3([v_x, v_y, v_z]), Vec3([l_x, l_y, l_z]));
        Vec3([omega_x, omega_y, omega_z])
    }
}

impl Vectorised for &mut Push {
    type Outcome = [Row; 3];

    /// Kicks the bodies by the loads on them, then drifts and rotates them freely for a step. Returns their kinetic energies, what the scheme
    /// added to them, and how far points of them may have turned away since neighbours were listed.
    #[inline(always)]
    fn run(self, across: impl Fn(Square) -> Square) -> [Row; 3] {
        let columns = |rows| across(rows).map(Lanes);
        let rows = |columns: [Row; LANES]| across(columns.map(|column| column.0));
        let [x, y, z, v_x, v_y, v_z, q_0, mass] = columns(self.state);
        let [q_x, q_y, q_z, l_x, l_y, l_z, i_x, i_y] = columns(self.turning);
        let [f_x, f_y, f_z, t_x, t_y, t_z, i_z, extent] = columns(self.loads);
        let [p_0, p_x, p_y, p_z, ..] = columns(self.listed);
        let (x, v, force) = (Vec3([x, y, z]), Vec3([v_x, v_y, v_z]), Vec3([f_x, f_y, f_z]));
        let (q, l, torque) = (Vec3([q_x, q_y, q_z]), Vec3([l_x, l_y, l_z]), Vec3([t_x, t_y, t_z]));
        let (moments, dt) = (Vec3([i_x, i_y, i_z]), Row::lit(self.dt));

        let energy = |l: Vec3<Row>| spin(q_0, q, l, moments).1;
        let kicked = kick(l, to_space(q_0, -q, torque), Row::one(), dt);
        let after = kick(v, force, mass, dt);
        let (q_0_next, q_next, l_next) = free_rotation(q_0, q, kicked, moments, dt);
        let (omega, turning) = spin(q_0_next, q_next, l_next, moments);
        let kinetic = translational_energy(mass, after) + turning;
        // The step of free rotation is not exact either: its energy error belongs to the scheme.
        let scheme = translational_energy(mass, after - v) + energy(kicked - l) + (turning - energy(kicked));
        let away = largest_displacement(q_0_next, q_next, p_0, Vec3([p_x, p_y, p_z]), extent);

        let (Vec3([x, y, z]), Vec3([v_x, v_y, v_z])) = (drift(x, after, dt), after);
        let (Vec3([q_x, q_y, q_z]), Vec3([l_x, l_y, l_z]), Vec3([omega_x, omega_y, omega_z])) = (q_next, l_next, omega);
        self.state = rows([x, y, z, v_x, v_y, v_z, q_0_next, omega_x]);
        self.turning = rows([q_x, q_y, q_z, l_x, l_y, l_z, omega_y, omega_z]);
        [kinetic, scheme, away]
    }
}
