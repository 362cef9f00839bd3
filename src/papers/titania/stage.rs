//! What is done in a stage.

use super::case::{Approach, Dragging, Stretching};
use super::pair::drag;
use crate::spec::Vec3;
use crate::system::{Motion, Steering, System};

/// A stage.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// Its name in the records of a run.
    pub name: &'static str,
    /// What is done.
    pub act: Act,
    /// Coefficient of the drag on every particle, ag/ns.
    pub damping: f64,
    /// How long, ns.
    pub duration: f64,
}

/// What is done in a stage. Units: nm, m/s, pN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Act {
    /// Two particles are released.
    Approach {
        /// Their nominal diameters.
        diameters: [f64; 2],
        /// How far from their distance at rest.
        from: f64,
    },
    /// A particle is pressed on a slab.
    Press {
        /// Nominal diameters of both.
        diameters: [f64; 2],
        /// The load.
        load: f64,
    },
    /// A pressed particle is moved over the slab.
    Drag {
        /// How fast.
        velocity: f64,
        /// The load.
        load: f64,
        /// Whether it turns as it moves, so that it does not slide.
        rolls: bool,
    },
    /// A chain comes to rest between its ends, which are held.
    Relax {
        /// Number of particles.
        particles: u32,
    },
    /// A chain is drawn at its end.
    Pull {
        /// Number of particles.
        particles: u32,
        /// Stiffness of the spring that draws, pN/nm.
        stiffness: f64,
        /// Velocity of its other end.
        velocity: f64,
    },
}

const HELD: [Motion; 3] = [Motion::Velocity(0.0); 3];

impl Stage {
    /// Two particles released.
    pub fn approach(test: &Approach, diameters: [f64; 2], dt: f64) -> Self {
        let act = Act::Approach { diameters, from: test.from.value };
        Self { name: "approach", act, damping: 0.0, duration: test.duration.value(dt) }
    }

    /// A particle pressed on a slab and moved.
    pub fn dragging(test: &Dragging, diameter: f64, rolls: bool, dt: f64) -> [Self; 2] {
        let (load, velocity) = (test.load.value, test.velocity.value);
        let press = Act::Press { diameters: [diameter, test.slab.value], load };
        let drag = Act::Drag { velocity, load, rolls };
        let names = if rolls { ["pressing to roll", "rolling"] } else { ["pressing to slide", "sliding"] };
        [
            Self { name: names[0], act: press, damping: 0.0, duration: test.settling.value(dt) },
            Self { name: names[1], act: drag, damping: 0.0, duration: test.distance.value / velocity },
        ]
    }

    /// A chain relaxed and drawn.
    pub fn stretching(test: &Stretching, particles: u32, dt: f64) -> [Self; 2] {
        let (stiffness, velocity) = (test.stiffness.value, test.velocity.value);
        let relax = Act::Relax { particles };
        let pull = Act::Pull { particles, stiffness, velocity };
        [
            Self { name: "relaxation", act: relax, damping: test.drag.value, duration: test.relaxation.value(dt) },
            Self { name: "pulling", act: pull, damping: 0.0, duration: test.distance.value / velocity },
        ]
    }

    /// Holds what is held, and drives what is driven: the second wall, or, of a chain that is pulled, the second spring.
    pub fn drive(&self, system: &mut System) {
        system.remove_walls();
        system.steerings.clear();
        match self.act {
            Act::Approach { .. } => {}
            Act::Press { load, .. } => drag(system, 0.0, load, false),
            Act::Drag { velocity, load, rolls } => drag(system, velocity, load, rolls),
            Act::Relax { particles } => system.add_wall(HELD, |p, i| p.id[i] < 2 || p.id[i] + 2 >= particles),
            Act::Pull { particles, stiffness, velocity } => {
                let end = |ids: std::ops::Range<u32>, velocity: f64| {
                    let velocity = Vec3([velocity, 0.0, 0.0]);
                    Steering::new(&system.particles, ids.collect(), stiffness, velocity)
                };
                system.steerings = vec![end(0..2, 0.0), end(particles - 2..particles, velocity)];
            }
        }
    }
}
