//! Two spheres whose contact slides, rolls, twists and is pulled apart by prescription, leg by leg.

use crate::case::InSteps;
use crate::case::check::{Found, expect};
use crate::case::quantity::{Quantity, Rate, Time, Velocity, quantity};
use crate::case::section::section;
use crate::error::{Error, Halt};
use crate::interrupt::Interrupt;
use crate::output::columns::columns;
use crate::output::{Cell, Column, Finding};
use crate::papers::necks;
use crate::run::Study;
use crate::simulation::{Pair, Settings, Simulation};
use crate::spec::necked::EXAMINED;
use crate::spec::{Contact, PairModel, Vec3, Wrench};
use crate::system::{Domain, Motion, Particles, System, Wall};
use serde::{Deserialize, Serialize};

section! {
    /// A leg of a path. The first sphere is beyond the second along x; both turn, and unless it is pulled neither moves.
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
        /// Velocity with which the first sphere is pulled away from the second, along x, in a leg without `velocity`; less than zero presses them together.
        pull: Quantity<Velocity> = quantity("0 m/s"),
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
    for (number, Leg { duration, velocity, pull, .. }) in legs.iter().enumerate() {
        let key = format!("experiment.path.legs[{number}].duration");
        expect(found, duration.value(dt.value) >= dt.value, &key, duration, &format!("at least a time step, {dt}"));
        let slides = velocity.iter().any(|v| v.value != 0.0);
        let key = format!("experiment.path.legs[{number}].pull");
        expect(
            found,
            !slides || pull.value == 0.0,
            &key,
            pull,
            "no such key beside `velocity`, which keeps the distance",
        );
    }
}

/// Whether a neck breaks under a contact law, given its pair, its springs, and what it holds.
pub(super) type Breaks<M> = Box<
    dyn Fn(&M, &Contact<f64>, &<M as PairModel>::Memory<f64>, &<M as PairModel>::Stored<f64>) -> bool + Send + Sync,
>;

/// The plan of a path under a contact law.
pub(super) struct PathPlan<M: PairModel> {
    pub model: M,
    /// Radius and mass of both spheres.
    pub spheres: [(f64, f64); 2],
    /// Distance of their centres, nm.
    pub distance: f64,
    /// Whether a neck joins them.
    pub neck: bool,
    /// When it breaks, if it ever does.
    pub breaks: Option<Breaks<M>>,
    /// Its strength relative to that of the case, if it has one of its own.
    pub strength: Option<f64>,
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

columns! {
    /// The column that a path has beside them if a leg pulls.
    pub(super) const PULLED {
        /// Distance of the surfaces of the spheres, less than zero where they overlap.
        ELONGATION = "elongation" in "nm";
    }
}

/// What became of a neck.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Watch {
    /// Whether no neck joins the spheres any more.
    parted: bool,
    /// Force between the spheres, pN, positive where it pulls, and their distance, nm, in the step in which the neck broke in this leg.
    broke: Option<(f64, f64)>,
}

impl<M: PairModel> PathPlan<M> {
    /// The number of steps of a leg.
    fn steps_of(&self, leg: usize, dt: f64) -> u64 {
        ((self.legs[leg].duration.value(dt) / dt).round() as u64).max(1)
    }

    /// Whether a leg pulls.
    fn pulls(&self) -> bool {
        self.legs.iter().any(|leg| leg.pull.value != 0.0)
    }

    /// The distance of the centres after the first `legs` legs, nm.
    fn distance_after(&self, legs: usize) -> f64 {
        let pulled = |leg: usize| self.legs[leg].pull.value * (self.steps_of(leg, self.dt) as f64 * self.dt);
        (0..legs).map(pulled).fold(self.distance, |distance, pulled| distance + pulled)
    }

    /// The distance of the surfaces of the spheres, nm.
    fn elongation(&self, system: &System) -> f64 {
        let [first, second] = [0, 1].map(|id| system.particles.x[system.place(id)]);
        (first - second).norm() - (self.spheres[0].0 + self.spheres[1].0)
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

    columns! {
        /// The results of a leg in which the neck of two spheres may break.
        pub(in crate::papers) const BREAKING {
            /// Force that pulls the spheres together in the step in which the neck breaks.
            FORCE = "force at which the neck breaks" in "nN";
            /// Distance of the surfaces in this step.
            ELONGATION = "elongation at which the neck breaks" in "nm";
            /// This distance over the sum of the radii.
            STRAIN = "strain at which the neck breaks";
        }
    }
}

impl<M: PairModel + Clone> Study for PathPlan<M> {
    type Model = M;
    type Watch = Watch;

    fn stages(&self) -> Vec<&'static str> {
        vec!["leg"; self.legs.len()]
    }

    fn initial(&self, _: &Interrupt) -> Result<System, Error> {
        let [first, second] = self.spheres;
        let margin = first.0.max(second.0);
        let longest = (0..=self.legs.len()).map(|legs| self.distance_after(legs)).fold(self.distance, f64::max);
        let side = longest + 4.0 * margin;
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
        for (sphere, spin) in self.legs[stage].spins(self.distance_after(stage)).into_iter().enumerate() {
            let place = system.place(sphere as u32);
            (system.walls[sphere].spin, system.particles.w[place]) = (spin, spin);
        }
        let (pull, first) = (self.legs[stage].pull.value, system.place(0));
        system.walls[0].motion[0] = Motion::Velocity(pull);
        (system.walls[0].velocity, system.particles.v[first]) = (ALONG * pull, ALONG * pull);
        Ok(system)
    }

    fn model(&self, _: usize, _: &System) -> M {
        self.model.clone()
    }

    fn settings(&self, _: usize, _: &System) -> Settings {
        Settings { skin: 1.0, max_overlap: self.overlap, ..Settings::new(self.dt) }
    }

    fn steps(&self, stage: usize, dt: f64) -> u64 {
        self.steps_of(stage, dt)
    }

    fn columns(&self, _: usize) -> Vec<Column> {
        if self.pulls() { [COLUMNS, PULLED].concat() } else { COLUMNS.into() }
    }

    fn watch(&self, _: usize, simulation: &Simulation<M>, _: &Interrupt) -> Result<Watch, Error> {
        Ok(Watch { parted: simulation.system().necks.is_empty(), broke: None })
    }

    fn can_hold(&self, _: usize, system: &System, _: &Watch) -> bool {
        let System { particles, walls, bodies, steerings, surfaces, .. } = system;
        (particles.len(), walls.len()) == (2, 2) && bodies.is_empty() && steerings.is_empty() && surfaces.is_empty()
    }

    fn intervene(&self, _: usize, _: &Watch, simulation: &mut Simulation<M>) -> Result<Vec<String>, Halt> {
        let Some(breaks) = self.breaks.as_ref().filter(|_| simulation.system().step.is_multiple_of(EXAMINED)) else {
            return Ok(Vec::new());
        };
        let law = simulation.model().clone();
        let broken = simulation.break_necks(|_, contact, memory, held| breaks(&law, contact, memory, held))?;
        Ok(broken.into_iter().map(|neck| necks::breaks(neck, self.strength)).collect())
    }

    fn follow(&self, _: usize, watch: &mut Watch, simulation: &Simulation<M>) -> Vec<String> {
        let system = simulation.system();
        if self.neck && system.necks.is_empty() && !watch.parted {
            watch.parted = true;
            watch.broke = Some((-system.walls[0].force.0[0], self.elongation(system)));
        }
        Vec::new()
    }

    fn look(&self, _: usize, _: &mut Watch, simulation: &Simulation<M>) -> Vec<Cell> {
        let walls = &simulation.system().walls;
        let acting = match simulation.pairs().next() {
            // Nothing has acted on the walls yet: the first step will do this.
            Some(Pair { outcome, .. }) if walls[0].age == 0.0 => {
                let Wrench { force, torque_i, torque_j } = outcome.wrench;
                [force, torque_i, -force, torque_j]
            }
            _ => [walls[0].force, walls[0].torque, walls[1].force, walls[1].torque],
        };
        let pulled = self.pulls().then(|| Cell::Number(self.elongation(simulation.system())));
        acting.into_iter().flat_map(|v| v.0.map(Cell::Number)).chain(pulled).collect()
    }

    fn findings(
        &self,
        stage: usize,
        watch: &Watch,
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
        let breaking = self.neck && self.breaks.is_some();
        let (force, elongation) = watch.broke.unzip();
        let strain = elongation.map(|elongation| elongation / (self.spheres[0].0 + self.spheres[1].0));
        let results = [(results::FORCE, force), (results::ELONGATION, elongation), (results::STRAIN, strain)];
        let of_neck = results.map(|(result, value)| Finding::reached(result, value, "the neck does not break"));
        let found = found.into_iter().chain(of_neck.into_iter().filter(|_| breaking));
        Ok(found.map(|finding| finding.during(stage)).collect())
    }
}
