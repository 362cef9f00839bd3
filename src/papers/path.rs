//! Two spheres at a fixed distance whose contact slides, rolls and twists by prescription, leg by leg.

use crate::case::InSteps;
use crate::case::check::{Found, expect};
use crate::case::quantity::{Quantity, Rate, Time, Velocity, quantity};
use crate::case::section::section;
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::output::columns::columns;
use crate::output::{Cell, Column, Finding};
use crate::run::Study;
use crate::simulation::{Pair, Settings, Simulation};
use crate::spec::{PairModel, Vec3, Wrench};
use crate::system::{Domain, Motion, Particles, System, Wall};

section! {
    /// A leg of a path. The first sphere is beyond the second along x; neither moves, both turn.
    pub struct Leg {
        /// Duration.
        duration: InSteps,
        /// Velocity, along y and z, of the first sphere relative to the second at the contact. So that the distance and the direction of the contact stay the same, it comes from turns of both
        /// spheres, about the same axis by this velocity over their distance, beside their spins.
        velocity: [Quantity<Velocity>; 2] = [quantity("0 m/s"), quantity("0 m/s")],
        /// Angular velocity of the first sphere about x, y and z: about x for torsion, about y and z for rolling.
        spin_of_first: [Quantity<Rate>; 3] = [quantity("0 1/ns"), quantity("0 1/ns"), quantity("0 1/ns")],
        /// Angular velocity of the second sphere.
        spin_of_second: [Quantity<Rate>; 3] = [quantity("0 1/ns"), quantity("0 1/ns"), quantity("0 1/ns")],
    }
}

impl Leg {
    /// The angular velocities of both spheres at this distance of their centres.
    fn spins(&self, distance: f64) -> [Vec3<f64>; 2] {
        let [y, z] = self.velocity.each_ref().map(|v| v.value);
        let rolled = ALONG.cross(Vec3([0.0, y, z])) * (-1.0 / distance);
        [&self.spin_of_first, &self.spin_of_second].map(|spin| Vec3(spin.each_ref().map(|w| w.value)) + rolled)
    }
}

/// The direction of the contact, from the second sphere to the first.
const ALONG: Vec3<f64> = Vec3([1.0, 0.0, 0.0]);

/// Checks the legs of a path.
pub(super) fn legs(legs: &[Leg], dt: &Quantity<Time>, found: &mut Found) {
    expect(found, !legs.is_empty(), "experiment.path.legs", "nothing", "at least one leg");
    expect(found, dt.value > 0.0, "experiment.path.dt", dt, "more than zero");
    for (number, Leg { duration, .. }) in legs.iter().enumerate() {
        let key = format!("experiment.path.legs[{number}].duration");
        expect(found, duration.value(dt.value) >= dt.value, &key, duration, &format!("at least a time step, {dt}"));
    }
}

/// The plan of a path under a contact law.
pub(super) struct PathPlan<M> {
    pub model: M,
    /// Radius and mass of both spheres.
    pub spheres: [(f64, f64); 2],
    /// Distance of their centres, nm.
    pub distance: f64,
    /// Whether a neck joins them.
    pub neck: bool,
    pub legs: Vec<Leg>,
    pub dt: f64,
    pub overlap: f64,
}

columns! {
    /// The columns of the series: what acts on each sphere in the last step.
    pub(super) const COLUMNS {
        /// Force on the first sphere along x.
        FORCE_X_FIRST = "force x on the first" in "pN";
        /// Force on the first sphere along y.
        FORCE_Y_FIRST = "force y on the first" in "pN";
        /// Force on the first sphere along z.
        FORCE_Z_FIRST = "force z on the first" in "pN";
        /// Torque about the centre of the first sphere along x.
        TORQUE_X_FIRST = "torque x on the first" in "pN nm";
        /// Torque about the centre of the first sphere along y.
        TORQUE_Y_FIRST = "torque y on the first" in "pN nm";
        /// Torque about the centre of the first sphere along z.
        TORQUE_Z_FIRST = "torque z on the first" in "pN nm";
        /// Force on the second sphere along x.
        FORCE_X_SECOND = "force x on the second" in "pN";
        /// Force on the second sphere along y.
        FORCE_Y_SECOND = "force y on the second" in "pN";
        /// Force on the second sphere along z.
        FORCE_Z_SECOND = "force z on the second" in "pN";
        /// Torque about the centre of the second sphere along x.
        TORQUE_X_SECOND = "torque x on the second" in "pN nm";
        /// Torque about the centre of the second sphere along y.
        TORQUE_Y_SECOND = "torque y on the second" in "pN nm";
        /// Torque about the centre of the second sphere along z.
        TORQUE_Z_SECOND = "torque z on the second" in "pN nm";
    }
}

/// The results.
pub(super) mod results {
    use crate::output::columns::columns;

    columns! {
        /// The results of each leg.
        pub(in crate::papers) const ALL {
            /// Force on the first sphere away from the second at the end of the leg.
            NORMAL = "normal force at the end" in "nN";
            /// Size of the force on the first sphere in the plane of the contact at the end of the leg.
            TANGENTIAL = "tangential force at the end" in "nN";
            /// Size of the torque on the first sphere at the end of the leg.
            TORQUE = "torque on the first at the end" in "nN nm";
        }
    }
}

impl<M: PairModel + Clone> Study for PathPlan<M> {
    type Model = M;
    type Watch = ();

    fn stages(&self) -> Vec<&'static str> {
        vec!["leg"; self.legs.len()]
    }

    fn initial(&self, _: &Interrupt) -> Result<System, Error> {
        let [first, second] = self.spheres;
        let margin = first.0.max(second.0);
        let side = self.distance + 4.0 * margin;
        let place = Vec3([2.0 * margin, 0.5 * side, 0.5 * side]);
        let mut particles = Particles::default();
        particles.push(place + ALONG * self.distance, first.0, first.1, 0);
        particles.push(place, second.0, second.1, 1);
        let mut system = System::new(particles, Domain { sides: [side; 3], periodic: [false; 3] });
        system.necks = if self.neck { vec![(0, 1)] } else { Vec::new() };
        for sphere in 0..2 {
            system.add_wall([Motion::Velocity(0.0); 3], |p, i| p.id[i] == sphere);
        }
        Ok(system)
    }

    fn set_up(&self, stage: usize, mut system: System) -> Result<System, Error> {
        for (sphere, spin) in self.legs[stage].spins(self.distance).into_iter().enumerate() {
            let place = system.place(sphere as u32);
            (system.walls[sphere].spin, system.particles.w[place]) = (spin, spin);
        }
        Ok(system)
    }

    fn model(&self, _: usize, _: &System) -> M {
        self.model.clone()
    }

    fn settings(&self, _: usize, _: &System) -> Settings {
        Settings { skin: 1.0, max_overlap: self.overlap, ..Settings::new(self.dt) }
    }

    fn steps(&self, stage: usize, dt: f64) -> u64 {
        ((self.legs[stage].duration.value(dt) / dt).round() as u64).max(1)
    }

    fn columns(&self, _: usize) -> Vec<Column> {
        COLUMNS.into()
    }

    fn watch(&self, _: usize, _: &Simulation<M>, _: &Interrupt) -> Result<(), Error> {
        Ok(())
    }

    fn can_hold(&self, _: usize, system: &System, (): &()) -> bool {
        let System { particles, walls, bodies, steerings, surfaces, .. } = system;
        (particles.len(), walls.len()) == (2, 2) && bodies.is_empty() && steerings.is_empty() && surfaces.is_empty()
    }

    fn look(&self, _: usize, (): &mut (), simulation: &Simulation<M>) -> Vec<Cell> {
        let walls = &simulation.system().walls;
        let acting = match simulation.pairs().next() {
            // Nothing has acted on the walls yet: the first step will do this.
            Some(Pair { outcome, .. }) if walls[0].age == 0.0 => {
                let Wrench { force, torque_i, torque_j } = outcome.wrench;
                [force, torque_i, -force, torque_j]
            }
            _ => [walls[0].force, walls[0].torque, walls[1].force, walls[1].torque],
        };
        acting.into_iter().flat_map(|v| v.0.map(Cell::Number)).collect()
    }

    fn findings(
        &self,
        stage: usize,
        (): &(),
        simulation: &Simulation<M>,
        _: &Interrupt,
    ) -> Result<Vec<Finding>, Error> {
        let Wall { force: Vec3([x, y, z]), torque, .. } = simulation.system().walls[0];
        let stage = &self.names()[stage];
        let found = [
            Finding::number(results::NORMAL, x),
            Finding::number(results::TANGENTIAL, Vec3([0.0, y, z]).norm()),
            Finding::number(results::TORQUE, torque.norm()),
        ];
        Ok(found.map(|finding| finding.during(stage)).into())
    }
}
