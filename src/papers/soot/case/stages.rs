//! What is done to an aggregate of soot.

use crate::case::InSteps;
use crate::case::quantity::{Length, Quantity, Rate, Scaled, SphereRadius, Time, Velocity, quantity};
use crate::case::section::{choice, section, words};
use crate::motion;
use std::path::PathBuf;

/// A length, or a multiple of the radius of the spheres.
pub type InRadii = Scaled<Length, SphereRadius>;

section! {
    /// An aggregate falls on the substrate, the plane z = 0, Section 3.1.1.
    pub struct Deposition {
        /// Velocity of all its spheres, downwards.
        velocity: Quantity<Velocity> = quantity("1 m/s"),
        /// Gap between the lowest sphere and the substrate at the beginning.
        gap: InRadii = Scaled::times(0.1),
        /// A triangulated substrate instead of the plane; its highest point is put at z = 0, its middle below that of the aggregate.
        substrate: Option<Solid> = None,
        /// File to keep the deposited aggregate in.
        save: Option<PathBuf> = None,
        /// How long it is watched.
        duration: InSteps = Scaled::Absolute(quantity("500 ns")),
        /// Time step.
        dt: Quantity<Time> = quantity("50 fs"),
        /// How velocities go with positions.
        integrator: Integrator = Integrator::HalfStep,
        /// Number of steps for which spheres that cannot touch go on attracting each other as they did.
        attraction_every: u64 = 1,
    }
}

section! {
    /// The tip of a force microscope comes down on a sphere that no other hides and that it meets first, and is drawn back, Section 3.1.2.
    pub struct Indentation {
        /// Part of the necks that are kept; which ones is drawn from the seed.
        keep_necks: f64 = 0.98,
        /// Gap between the tip and the sphere at the beginning.
        gap: InRadii = Scaled::times(0.5),
        /// A triangulated tip instead of the tetrahedron; its lowest point is put above the sphere.
        tip: Option<Solid> = None,
        /// Final velocity of the tip, Eq. 25.
        velocity: Quantity<Velocity> = quantity("1.5 m/s"),
        /// How fast it turns round.
        turn_rate: Quantity<Rate> = quantity("0.1 1/ns"),
        /// When it turns round.
        turn: Quantity<Time> = quantity("10.8 ns"),
        /// Natural frequency of the cantilever, in cycles: the angular frequency of Eq. 30 is 2 pi times as large.
        cantilever: Quantity<Rate> = quantity("0.07 1/ns"),
        /// How long it is watched.
        duration: InSteps = Scaled::Absolute(quantity("500 ns")),
        /// Time step.
        dt: Quantity<Time> = quantity("50 fs"),
        /// How velocities go with positions.
        integrator: Integrator = Integrator::HalfStep,
        /// Number of steps for which spheres that cannot touch go on attracting each other as they did.
        attraction_every: u64 = 1,
    }
}

section! {
    /// A coating pulls the spheres together.
    pub struct Restructuring {
        /// Part of the necks that are kept; which ones is drawn from the seed.
        keep_necks: f64 = 1.0,
        /// How long it is watched.
        duration: InSteps = Scaled::Absolute(quantity("50 ns")),
        /// Time step.
        dt: Quantity<Time> = quantity("5 fs"),
        /// How velocities go with positions.
        integrator: Integrator = Integrator::HalfStep,
        /// Number of steps for which spheres that cannot touch go on attracting each other as they did.
        attraction_every: u64 = 1,
    }
}

words! {
    /// How velocities go with positions.
    pub enum Integrator {
        /// Half a step behind them, as in the published program.
        HalfStep = "half-step",
        /// At the same time: velocity Verlet. Forces see the same positions and velocities as with `half-step`.
        VelocityVerlet = "velocity-verlet",
    }
}

section! {
    /// A triangulated surface. A closed one bounds a body and acts on its outside, an open one on both sides.
    pub struct Solid {
        /// A file in the STL format, ASCII or binary.
        stl: PathBuf,
        /// Its unit of length: the format has none.
        unit: Quantity<Length>,
    }
}

choice! {
    /// A stage of a sequence: each starts from the end of the one before.
    pub enum SootStage {
        /// An aggregate falls on a substrate.
        Deposition = "deposition": Deposition,
        /// A deposited aggregate is indented.
        Indentation = "indentation": Indentation,
        /// A coated aggregate collapses.
        Restructuring = "restructuring": Restructuring,
    }
}

impl Integrator {
    /// The same for the engine.
    pub fn engine(self) -> motion::Integrator {
        match self {
            Self::HalfStep => motion::Integrator::HalfStep,
            Self::VelocityVerlet => motion::Integrator::VelocityVerlet,
        }
    }
}

impl SootStage {
    /// Its name.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Deposition(_) => "deposition",
            Self::Indentation(_) => "indentation",
            Self::Restructuring(_) => "restructuring",
        }
    }

    /// The surface that it needs from a file, if any.
    pub fn solid(&self) -> Option<&Solid> {
        match self {
            Self::Deposition(Deposition { substrate: solid, .. })
            | Self::Indentation(Indentation { tip: solid, .. }) => solid.as_ref(),
            Self::Restructuring(_) => None,
        }
    }

    /// Its time step, ns.
    pub fn dt(&self) -> &Quantity<Time> {
        match self {
            Self::Deposition(Deposition { dt, .. })
            | Self::Indentation(Indentation { dt, .. })
            | Self::Restructuring(Restructuring { dt, .. }) => dt,
        }
    }

    /// How its velocities go with its positions.
    pub fn integrator(&self) -> Integrator {
        match self {
            Self::Deposition(Deposition { integrator, .. })
            | Self::Indentation(Indentation { integrator, .. })
            | Self::Restructuring(Restructuring { integrator, .. }) => *integrator,
        }
    }

    /// Number of steps after which the attraction of spheres that cannot touch is evaluated anew.
    pub fn attraction_every(&self) -> u64 {
        match self {
            Self::Deposition(Deposition { attraction_every, .. })
            | Self::Indentation(Indentation { attraction_every, .. })
            | Self::Restructuring(Restructuring { attraction_every, .. }) => *attraction_every,
        }
    }

    /// How long it lasts.
    pub fn duration(&self) -> &InSteps {
        match self {
            Self::Deposition(Deposition { duration, .. })
            | Self::Indentation(Indentation { duration, .. })
            | Self::Restructuring(Restructuring { duration, .. }) => duration,
        }
    }
}
