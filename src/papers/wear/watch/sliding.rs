//! The measurements of two bodies that slide on each other for long.

use crate::case::units::in_unit;
use crate::observe::shear_layer::{Layer, left_both, profile, sheared_thickness, thickness_of};
use crate::observe::statistics::standard_error;
use crate::observe::upper_wall;
use crate::output::{Cell, Column, Finding};
use crate::papers::wear::case::{Case, Experiment};
use crate::papers::wear::columns::results;
use crate::papers::wear::derived::{Scales, critical_size, material};
use crate::papers::wear::fate::{WallForces, by_id};
use crate::spec::Vec3;
use crate::system::System;
use serde::{Deserialize, Serialize};

/// Two sliding bodies.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Sliding {
    /// Most frequent diameter, nm, and density of the solid, ag/nm^3.
    diameter: f64,
    density: f64,
    /// Sliding distance of a window, nm.
    window: f64,
    /// The beginning, and the beginning of the window.
    start: Moment,
    mark: Moment,
    /// The forces in the window, and since the beginning.
    forces: WallForces,
    all_forces: WallForces,
    /// The windows that have closed, and whether one has closed in the last step.
    windows: Vec<Window>,
    closed: bool,
    /// The profile of the last window: of the mean velocity, m/s, and of the displacement since the beginning, nm.
    profile: Vec<Layer>,
    /// Ids of the spheres that had left both bodies at the end of the last window, in ascending order.
    members: Vec<u32>,
}

/// The state at a moment.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Moment {
    /// ns.
    time: f64,
    /// Position of the upper wall, nm.
    upper: [f64; 3],
    /// Centres of the spheres in the order of ids, nm.
    centres: Vec<[f64; 3]>,
}

/// The measurements of a window.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct Window {
    /// Displacement of the upper wall since the beginning, along the sliding and along the normal, nm.
    slid: f64,
    rise: f64,
    /// Mean friction and normal force, pN.
    forces: [f64; 2],
    sheared: f64,
    third_body: f64,
}

impl Moment {
    fn of(system: &System) -> Self {
        Self { time: system.time, upper: upper_wall(system).0, centres: by_id(system) }
    }
    /// Displacement of the upper wall since then.
    fn slid(&self, system: &System) -> Vec3<f64> {
        upper_wall(system) - Vec3(self.upper)
    }
    fn places(&self) -> Vec<Vec3<f64>> {
        self.centres.iter().map(|&x| Vec3(x)).collect()
    }
}

impl Sliding {
    /// Starts observing the bodies of a case.
    pub(super) fn begin(system: &System, case: &Case) -> Self {
        let Experiment::Sliding(sliding) = &case.experiment else {
            unreachable!("two bodies belong to their experiment")
        };
        let diameter = Scales::of(case).d_0;
        let start = Moment::of(system);
        Self {
            diameter,
            density: material(case).density.value,
            window: sliding.window.value(diameter),
            mark: start.clone(),
            start,
            forces: WallForces::default(),
            all_forces: WallForces::default(),
            windows: Vec::new(),
            closed: false,
            profile: Vec::new(),
            members: Vec::new(),
        }
    }

    /// Number of spheres that it observes.
    pub(super) fn spheres(&self) -> usize {
        self.start.centres.len()
    }

    /// Ids of the spheres that had left both bodies at the end of the last window, in ascending order.
    pub(super) fn members(&self) -> &[u32] {
        &self.members
    }

    pub(super) fn follow(&mut self, system: &System) {
        self.forces.add(&system.walls[1]);
        self.all_forces.add(&system.walls[1]);
        self.closed = self.start.slid(system).0[0] >= (self.windows.len() + 1) as f64 * self.window;
        if self.closed {
            self.close(system);
        }
    }

    /// Closes a window and opens the next.
    fn close(&mut self, system: &System) {
        let p = &system.particles;
        let (start, before) = (self.start.places(), self.mark.places());
        let [slid, rise, _] = self.start.slid(system).0;
        let time = system.time - self.mark.time;
        let velocity = self.mark.slid(system).0[0] / time;
        let along = |i: usize, from: &[Vec3<f64>]| p.x[i].0[0] - from[p.id[i] as usize].0[0];
        let layers = profile(system, self.diameter, |i| [along(i, &before) / time, along(i, &start)]);
        let third = left_both(system, &start, self.start.slid(system), self.diameter);
        self.members = p.by_id().into_iter().filter(|&i| third[i]).map(|i| p.id[i]).collect();
        self.windows.push(Window {
            slid,
            rise,
            forces: std::mem::take(&mut self.forces).mean(),
            sheared: sheared_thickness(layers.iter().map(|layer| (layer.height, layer.means[0] / velocity))),
            third_body: thickness_of(system, self.density, |i| third[i]),
        });
        self.profile = layers;
        self.mark = Moment::of(system);
    }

    pub(super) fn look(&self, system: &System) -> Vec<Cell> {
        let [slid, rise, _] = self.start.slid(system).0;
        let force = system.walls[1].force.0;
        [slid, rise, 0.0 - force[0], force[1]].map(Cell::Number).into()
    }

    pub(super) fn window(&self) -> Option<Vec<Cell>> {
        let &Window { slid, rise, forces: [friction, normal], sheared, third_body } =
            self.windows.last().filter(|_| self.closed)?;
        let mut cells: Vec<Cell> = [slid, rise, friction, normal, friction / normal, sheared].map(Cell::Number).into();
        cells.extend([Cell::Count(self.members.len() as u64), Cell::Number(third_body)]);
        Some(cells)
    }

    pub(super) fn profile(&self) -> Vec<Vec<Cell>> {
        let cells = |&Layer { height, spheres, means: [velocity, displacement] }: &Layer| {
            let spheres = Cell::Count(spheres as u64);
            vec![Cell::Number(height), spheres, Cell::Number(velocity), Cell::Number(displacement)]
        };
        if self.closed { self.profile.iter().map(cells).collect() } else { Vec::new() }
    }

    pub(super) fn findings(&self, case: &Case, system: &System) -> Vec<Finding> {
        let critical = critical_size(&material(case).spec());
        let slid = self.start.slid(system).0[0];
        let short = format!("slid by less than {}", in_unit(2.0 * self.window, "nm"));
        let [friction, load] = self.all_forces.mean();
        let peak = self.windows.iter().map(|window| window.forces[0] / load).reduce(f64::max);
        // The bodies are judged by the second half of their way: the first has the static peak and the growth of the layer in it.
        let late = || self.windows.iter().filter(|window| window.slid > 0.5 * slid);
        let over = |result: Column, value: &dyn Fn(&Window) -> f64| {
            let values: Vec<f64> = late().map(value).collect();
            if values.len() < 2 {
                return Finding::reached(result, None, &*short);
            }
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            Finding::number(result, mean).spread(standard_error(&values, mean))
        };
        let last = |scale: f64| self.windows.last().map(|window| window.third_body / scale);
        vec![
            over(results::SHEARED_OVER_CRITICAL, &|window| window.sheared / critical),
            over(results::SHEARED_THICKNESS, &|window| window.sheared),
            Finding::reached(results::THIRD_BODY_OVER_CRITICAL, last(critical), &*short),
            Finding::reached(results::THIRD_BODY_THICKNESS, last(1.0), &*short),
            Finding::number(results::SLIDING_DISTANCE, slid),
            Finding::number(results::FRICTION_FORCE, friction),
            Finding::reached(results::PEAK_FRICTION, peak, &*short),
            over(results::KINETIC_FRICTION, &|window| window.forces[0] / load),
        ]
    }
}
