//! The stages of an experiment with an aggregate of soot.

use crate::case::InSteps;
use crate::case::quantity::{Length, Quantity, Rate, Scaled, SphereRadius, Time, Velocity, quantity};
use crate::case::section::{choice, section, words};
use crate::motion;
use std::path::PathBuf;

/// A length, or a multiple of the radius of the spheres.
pub type InRadii = Scaled<Length, SphereRadius>;

section! {
    /// Deposition on the substrate, the plane z = 0, Section 3.1.1.
    pub struct Deposition {
        /// Initial downward velocity of the aggregate.
        velocity: Quantity<Velocity> = quantity("1 m/s"),
        /// Initial gap between the lowest sphere and the substrate.
        gap: InRadii = Scaled::times(0.1),
        /// A triangulated substrate instead of the plane, centred below the aggregate with its highest point at z = 0.
        substrate: Option<Solid> = None,
        /// File in which the deposited aggregate is saved.
        save: Option<PathBuf> = None,
        /// Duration.
        duration: InSteps = Scaled::Absolute(quantity("500 ns")),
        /// Time step.
        dt: Quantity<Time> = quantity("50 fs"),
        /// Time integration: velocities staggered by half a step, or synchronous with the positions.
        integrator: Integrator = Integrator::HalfStep,
        /// Interval, in steps, at which the attraction of non-touching pairs is recomputed.
        attraction_every: u64 = 1,
    }
}

section! {
    /// Indentation by the tip of an atomic force microscope, which approaches an exposed sphere and is retracted, Section 3.1.2.
    pub struct Indentation {
        /// Fraction of the necks that are kept, chosen at random; the others are removed when the stage begins.
        keep_necks: f64 = 0.98,
        /// What is indented; by default an exposed sphere that is drawn at random: one that no other hides from above, and that the tip touches first.
        indent: Option<Indented> = None,
        /// Initial gap between the tip and the sphere that it approaches.
        gap: InRadii = Scaled::times(0.5),
        /// A triangulated tip instead of the tetrahedron, placed with its lowest point above the sphere.
        tip: Option<Solid> = None,
        /// Final retraction velocity of the tip, Eq. 25.
        velocity: Quantity<Velocity> = quantity("1.5 m/s"),
        /// Rate of the reversal, Eq. 25.
        turn_rate: Quantity<Rate> = quantity("0.1 1/ns"),
        /// Time of the reversal.
        turn: Quantity<Time> = quantity("10.8 ns"),
        /// Natural frequency of the cantilever, in cycles per time; the angular frequency of Eq. 30 is 2 pi times as large.
        cantilever: Quantity<Rate> = quantity("0.07 1/ns"),
        /// Duration.
        duration: InSteps = Scaled::Absolute(quantity("500 ns")),
        /// Time step.
        dt: Quantity<Time> = quantity("50 fs"),
        /// Time integration: velocities staggered by half a step, or synchronous with the positions.
        integrator: Integrator = Integrator::HalfStep,
        /// Interval, in steps, at which the attraction of non-touching pairs is recomputed.
        attraction_every: u64 = 1,
    }
}

choice! {
    /// What is indented.
    pub enum Indented {
        /// The exposed sphere with this number, counted from 0, in the order of a file.
        Sphere = "sphere": u64,
        /// The place below the lowest point of the tip: x and y from where the centre of mass of the aggregate was at first, or from the origin of the file of an aggregate that lies `on_substrate`.
        Place = "place": [Quantity<Length>; 2],
    }
}

section! {
    /// Restructuring under the capillary force of a coating.
    pub struct Restructuring {
        /// Fraction of the necks that are kept, chosen at random; the others are removed when the stage begins.
        keep_necks: f64 = 1.0,
        /// Duration.
        duration: InSteps = Scaled::Absolute(quantity("50 ns")),
        /// Time step.
        dt: Quantity<Time> = quantity("5 fs"),
        /// Time integration: velocities staggered by half a step, or synchronous with the positions.
        integrator: Integrator = Integrator::HalfStep,
        /// Interval, in steps, at which the attraction of non-touching pairs is recomputed.
        attraction_every: u64 = 1,
    }
}

words! {
    /// Time integration.
    pub enum Integrator {
        /// Velocities lag the positions by half a step, as in the published program.
        HalfStep = "half-step",
        /// Velocities and positions belong to the same time: velocity Verlet. Forces are evaluated with the same positions and velocities as with `half-step`.
        VelocityVerlet = "velocity-verlet",
    }
}

section! {
    /// A triangulated surface. A closed surface bounds a body and acts on its outside, an open surface acts on both sides.
    pub struct Solid {
        /// STL file, ASCII or binary.
        stl: PathBuf,
        /// Unit of length of the file; the format does not define one.
        unit: Quantity<Length>,
    }
}

choice! {
    /// A stage of a sequence: each starts from the end of the one before.
    pub enum SootStage {
        /// Deposition of an aggregate on a substrate.
        Deposition = "deposition": Deposition,
        /// Indentation of a deposited aggregate.
        Indentation = "indentation": Indentation,
        /// Restructuring of a coated aggregate.
        Restructuring = "restructuring": Restructuring,
    }
}

impl Integrator {
    /// The corresponding integrator of the engine.
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

    /// Its key in the case, by its place in the sequence if there is one.
    pub fn key(&self, place: Option<usize>) -> String {
        let place = place.map_or_else(String::new, |place| format!("sequence[{place}]."));
        format!("experiment.{place}{}", self.name())
    }

    /// The surface that it needs from a file, if any.
    pub fn solid(&self) -> Option<&Solid> {
        match self {
            Self::Deposition(Deposition { substrate: solid, .. })
            | Self::Indentation(Indentation { tip: solid, .. }) => solid.as_ref(),
            Self::Restructuring(_) => None,
        }
    }

    /// The same, to be changed.
    pub fn solid_mut(&mut self) -> Option<&mut Solid> {
        match self {
            Self::Deposition(Deposition { substrate: solid, .. })
            | Self::Indentation(Indentation { tip: solid, .. }) => solid.as_mut(),
            Self::Restructuring(_) => None,
        }
    }

    /// The file in which it saves the aggregate, if any, to be changed.
    pub fn save_mut(&mut self) -> Option<&mut PathBuf> {
        if let Self::Deposition(Deposition { save, .. }) = self { save.as_mut() } else { None }
    }

    /// Its time step, ns.
    pub fn dt(&self) -> &Quantity<Time> {
        match self {
            Self::Deposition(Deposition { dt, .. })
            | Self::Indentation(Indentation { dt, .. })
            | Self::Restructuring(Restructuring { dt, .. }) => dt,
        }
    }

    /// Its time integration.
    pub fn integrator(&self) -> Integrator {
        match self {
            Self::Deposition(Deposition { integrator, .. })
            | Self::Indentation(Indentation { integrator, .. })
            | Self::Restructuring(Restructuring { integrator, .. }) => *integrator,
        }
    }

    /// Interval, in steps, at which the attraction of non-touching pairs is recomputed.
    pub fn attraction_every(&self) -> u64 {
        match self {
            Self::Deposition(Deposition { attraction_every, .. })
            | Self::Indentation(Indentation { attraction_every, .. })
            | Self::Restructuring(Restructuring { attraction_every, .. }) => *attraction_every,
        }
    }

    /// Its duration.
    pub fn duration(&self) -> &InSteps {
        match self {
            Self::Deposition(Deposition { duration, .. })
            | Self::Indentation(Indentation { duration, .. })
            | Self::Restructuring(Restructuring { duration, .. }) => duration,
        }
    }
}
