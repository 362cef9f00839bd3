//! The stages of tests of single contacts and of the stretching of an agglomerate.

use super::case::{Approach, Dragging, Stretching};
use super::pair::drag;
use crate::spec::Vec3;
use crate::system::{Motion, Steering, System};

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
        /// Number of particles.
        particles: u32,
    },
    /// Pulls a chain at one end.
    Pull {
        /// Number of particles.
        particles: u32,
        /// Stiffness of the pulling spring, pN/nm.
        stiffness: f64,
        /// Velocity of the far end of the spring.
        velocity: f64,
    },
}

impl StageAct {
    /// Number of spheres, if it is always the same, of walls, and of springs at centres of mass.
    pub(super) fn parts(&self) -> (Option<usize>, usize, usize) {
        match self {
            Self::Approach { .. } => (Some(2), 0, 0),
            Self::Press { .. } | Self::Drag { .. } => (Some(2), 2, 0),
            Self::Relax { .. } => (None, 1, 0),
            Self::Pull { .. } => (None, 0, 2),
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
    pub(super) fn stretching(test: &Stretching, particles: u32, dt: f64) -> [Self; 2] {
        let (stiffness, velocity) = (test.stiffness.value, test.velocity.value);
        let relax = StageAct::Relax { particles };
        let pull = StageAct::Pull { particles, stiffness, velocity };
        [
            Self { name: "relaxation", act: relax, damping: test.drag.value, duration: test.relaxation.value(dt) },
            Self { name: "pulling", act: pull, damping: 0.0, duration: test.distance.value / velocity },
        ]
    }

    /// Holds and drives the walls or springs of the act: the second wall, or the second spring of a pulled chain, is driven.
    pub(super) fn drive(&self, system: &mut System) {
        system.remove_walls();
        system.steerings.clear();
        match self.act {
            StageAct::Approach { .. } => {}
            StageAct::Press { load, .. } => drag(system, 0.0, load, false),
            StageAct::Drag { velocity, load, rolls } => drag(system, velocity, load, rolls),
            StageAct::Relax { particles } => system.add_wall(HELD, |p, i| p.id[i] < 2 || p.id[i] + 2 >= particles),
            StageAct::Pull { particles, stiffness, velocity } => {
                let end = |ids: std::ops::Range<u32>, velocity: f64| {
                    let velocity = Vec3([velocity, 0.0, 0.0]);
                    Steering::new(&system.particles, ids.collect(), stiffness, velocity)
                };
                system.steerings = vec![end(0..2, 0.0), end(particles - 2..particles, velocity)];
            }
        }
    }
}
