//! The stages of tests of single contacts and of the stretching of an agglomerate.

use super::case::{Approach, Dragging, Hold, Release, SpringAlong, Stretching};
use super::pair::drag;
use crate::spec::Vec3;
use crate::system::{Motion, Particles, Steering, System};
use std::collections::BTreeSet;
use std::ops::Range;

/// A stage.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Stage {
    /// Its name in the records of a run.
    pub name: &'static str,
    /// The act.
    pub act: StageAct,
    /// Drag coefficient of every particle, ag/ns.
    pub damping: f64,
    /// Duration, ns.
    pub duration: f64,
}

/// The act of a stage. Units: nm, m/s, pN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StageAct {
    /// Releases two particles.
    Approach {
        /// Their nominal diameters.
        diameters: [f64; 2],
        /// Initial distance beyond the equilibrium distance.
        from: f64,
    },
    /// Presses a particle onto a slab.
    Press {
        /// Nominal diameters of both.
        diameters: [f64; 2],
        /// The load.
        load: f64,
    },
    /// Drags the pressed particle over the slab.
    Drag {
        /// The velocity.
        velocity: f64,
        /// The load.
        load: f64,
        /// Whether it rolls without sliding.
        rolls: bool,
    },
    /// Relaxes a chain with both ends held.
    Relax {
        /// Number of particles of an end.
        drawn: u32,
    },
    /// Pulls a chain at one end.
    Pull {
        /// Number of particles of an end.
        drawn: u32,
        /// Whether the other end is frozen, not held by a spring.
        frozen: bool,
        /// Stiffness of the springs along each axis, pN/nm.
        stiffness: Vec3<f64>,
        /// Velocity of the far end of the pulling spring.
        velocity: f64,
        /// Time in which it grows, ns.
        ramp: f64,
    },
    /// Lets all particles go.
    Release,
}

impl StageAct {
    /// Number of spheres, if it is always the same, of walls, and of springs at centres of mass.
    pub(super) fn parts(&self) -> (Option<usize>, usize, usize) {
        match self {
            Self::Approach { .. } => (Some(2), 0, 0),
            Self::Press { .. } | Self::Drag { .. } => (Some(2), 2, 0),
            Self::Relax { .. } => (None, 1, 0),
            Self::Pull { frozen: false, .. } => (None, 0, 2),
            Self::Pull { frozen: true, .. } => (None, 1, 1),
            Self::Release => (None, 0, 0),
        }
    }
}

const HELD: [Motion; 3] = [Motion::Velocity(0.0); 3];

impl Stage {
    /// The release of two particles.
    pub(super) fn approach(test: &Approach, diameters: [f64; 2], dt: f64) -> Self {
        let act = StageAct::Approach { diameters, from: test.from.value };
        Self { name: "approach", act, damping: 0.0, duration: test.duration.value(dt) }
    }

    /// A particle is pressed onto a slab and dragged over it.
    pub(super) fn dragging(test: &Dragging, diameter: f64, rolls: bool, dt: f64) -> [Self; 2] {
        let (load, velocity) = (test.load.value, test.velocity.value);
        let press = StageAct::Press { diameters: [diameter, test.slab.value], load };
        let drag = StageAct::Drag { velocity, load, rolls };
        let names = if rolls { ["pressing to roll", "rolling"] } else { ["pressing to slide", "sliding"] };
        [
            Self { name: names[0], act: press, damping: 0.0, duration: test.settling.value(dt) },
            Self { name: names[1], act: drag, damping: 0.0, duration: test.distance.value / velocity },
        ]
    }

    /// A chain is relaxed and pulled.
    pub(super) fn stretching(test: &Stretching, dt: f64) -> [Self; 2] {
        let (velocity, ramp, drawn) = (test.velocity.value, test.ramp.value, test.drawn as u32);
        let aside = if test.spring_along == SpringAlong::All { 1.0 } else { 0.0 };
        let stiffness = Vec3([1.0, aside, aside]) * test.stiffness.value;
        let pull = StageAct::Pull { drawn, frozen: test.hold == Hold::Frozen, stiffness, velocity, ramp };
        // While the velocity grows its far end moves half as far.
        let duration = test.distance.value / velocity + 0.5 * ramp;
        let relax = StageAct::Relax { drawn };
        [
            Self { name: "relaxation", act: relax, damping: test.drag.value, duration: test.relaxation.value(dt) },
            Self { name: "pulling", act: pull, damping: 0.0, duration },
        ]
    }

    /// All particles are let go.
    pub(super) fn release(test: &Release, dt: f64) -> Self {
        Self { name: "release", act: StageAct::Release, damping: test.drag.value, duration: test.duration.value(dt) }
    }

    /// Holds and drives the walls or springs of the act: the second wall, or the last spring of a pulled chain, is driven.
    pub(super) fn drive(&self, system: &mut System) {
        system.remove_walls();
        system.steerings.clear();
        let number = system.particles.len() as u32;
        match self.act {
            StageAct::Approach { .. } | StageAct::Release => {}
            StageAct::Press { load, .. } => drag(system, 0.0, load, false),
            StageAct::Drag { velocity, load, rolls } => drag(system, velocity, load, rolls),
            StageAct::Relax { drawn } => {
                let [first, last] = ends(number, drawn);
                freeze(system, |id| first.contains(&id) || last.contains(&id));
            }
            StageAct::Pull { drawn, frozen, stiffness, velocity, ramp } => {
                let [first, last] = ends(number, drawn);
                if frozen {
                    freeze(system, |id| first.contains(&id));
                }
                let end = |ids: Range<u32>, velocity: f64| {
                    let velocity = Vec3([velocity, 0.0, 0.0]);
                    let spring = Steering::new(&system.particles, ids.collect(), 0.0, velocity);
                    Steering { stiffness, ramp, ..spring }
                };
                let holding = (!frozen).then(|| end(first, 0.0));
                system.steerings = holding.into_iter().chain([end(last, velocity)]).collect();
            }
        }
    }
}

/// The ids of the particles of both ends of a chain.
pub(super) fn ends(number: u32, drawn: u32) -> [Range<u32>; 2] {
    [0..drawn, number - drawn..number]
}

/// Holds the spheres with these ids, and the whole of the bodies to which they belong.
fn freeze(system: &mut System, held: impl Fn(u32) -> bool) {
    let Particles { id, body, .. } = &system.particles;
    let bodies: BTreeSet<u32> = (0..id.len()).filter(|&p| body[p] > 0 && held(id[p])).map(|p| body[p]).collect();
    system.add_wall(HELD, |p, i| held(p.id[i]) || bodies.contains(&p.body[i]));
}
