//! Frames: the state of all particles, pairs and surfaces at one moment, in the formats that are asked for.

mod name;
mod poly_data;
mod surfaces;
mod vtkhdf;
mod vtp;
mod xyz;

pub use name::{FrameName, is_of_frames};
pub use vtp::collections;

use super::columns::columns;
use crate::case::{Digits, Extra, Format};
use crate::motion::inertia;
use crate::observe::{ActingPair, Loads, PairKind};
use crate::simulation::Simulation;
use crate::spec::mechanics::newton::{acceleration, angular_acceleration};
use crate::spec::{Contact, Named, PairModel, Vec3};
use crate::system::System;
use std::collections::BTreeMap;

columns! {
    /// The columns of spheres in frames.
    pub const FRAME_COLUMNS {
        /// Id of the sphere, which it keeps throughout a run: `body_id` in VTKHDF.
        ID = "id";
        /// Body that the sphere belonged to at the beginning.
        BODY = "body";
        /// Wall that the sphere is part of; 0 for none.
        WALL = "wall";
        /// Radius.
        RADIUS = "radius" in "nm";
        /// Mass.
        MASS = "mass" in "ag";
        /// Centre, folded into the box, whose corner is the origin.
        POSITION = "pos" in "nm";
        /// Velocity: `velocity` in VTKHDF.
        VELOCITY = "velo" in "m/s";
        /// Angular velocity.
        ANGULAR_VELOCITY = "angular_velocity" in "1/ns";
        /// Force of pairs and surfaces in the next step; drag, drives and loads are not part of it.
        FORCE = "force" in "pN";
        /// Number of contacts and necks.
        COORDINATION = "coordination";
        /// Number of necks.
        NECKS = "necks";
        /// Whether the sphere is part of the third body in the last window, or has left both of two sliding bodies by its end: only in stages with a third body.
        THIRD_BODY = "third_body";
        /// Virial stress of the sphere by the forces of pairs and surfaces, positive in tension: xx, yy, zz, xy, xz, yz.
        STRESS = "stress" in "MPa";
        /// Torque of pairs and surfaces in the next step, with `output.columns: [torque]`.
        TORQUE = "torque" in "pN nm";
        /// Force over mass, with `output.columns: [acceleration]`: the acceleration of a sphere that is part of no rigid body or wall, without drag.
        ACCELERATION = "acceleration" in "nm/ns^2";
        /// Torque over moment of inertia, with `output.columns: [angular_acceleration]`.
        ANGULAR_ACCELERATION = "angular_acceleration" in "1/ns^2";
    }
}

columns! {
    /// The columns of pairs in frames.
    pub const PAIR_COLUMNS {
        /// Ids of both spheres, the lower first: `batom1` and `batom2` in local dumps, `ids` in VTK, `id1` and `id2` in VTKHDF.
        IDS = "ids";
        /// 1 for a contact, 2 for a neck, 3 for a meniscus between spheres that do not touch: `btype` in local dumps.
        KIND = "kind";
        /// Distance of the surfaces, negative for an overlap.
        GAP = "gap" in "nm";
        /// Force along the line of centres, positive for a repulsion; in VTKHDF positive for an attraction, as the names that it takes from ON-DEM want it.
        NORMAL_FORCE = "normal_force" in "pN";
        /// Force on the sphere with the lower id along x.
        FORCE_X = "force_x" in "pN";
        /// The same along y.
        FORCE_Y = "force_y" in "pN";
        /// The same along z.
        FORCE_Z = "force_z" in "pN";
        /// Energy stored in the pair.
        ENERGY = "energy" in "zJ";
        /// Strength of the neck relative to that of the case, 0 for a pair without one: only where necks have strengths of their own.
        STRENGTH = "strength";
        /// Springs of the contact, one column each: lengths of the tangential, rolling and torsion springs, and the gap at rest, as the contact model has them.
        SPRINGS = "spring_..." in "nm";
    }
}

/// A column of a frame: a quantity of every sphere, in the order of ids.
struct FrameColumn {
    /// Its name.
    name: &'static str,
    /// Its values.
    values: Values,
}

/// The values of a column.
enum Values {
    /// Counts, numbers of things, and flags.
    Counts(Vec<u32>),
    /// Numbers.
    Numbers(Vec<f64>),
    /// Vectors.
    Vectors(Vec<Vec3<f64>>),
    /// Symmetric tensors: xx, yy, zz, xy, xz, yz.
    Tensors(Vec<[f64; 6]>),
}

impl Values {
    /// How many numbers it has for every sphere.
    fn width(&self) -> usize {
        match self {
            Self::Counts(_) | Self::Numbers(_) => 1,
            Self::Vectors(_) => 3,
            Self::Tensors(_) => 6,
        }
    }
    /// The numbers of a sphere; counts are exact.
    fn of(&self, k: usize) -> [f64; 6] {
        match self {
            Self::Counts(values) => [f64::from(values[k]), 0.0, 0.0, 0.0, 0.0, 0.0],
            Self::Numbers(values) => [values[k], 0.0, 0.0, 0.0, 0.0, 0.0],
            Self::Vectors(values) => {
                let [x, y, z] = values[k].0;
                [x, y, z, 0.0, 0.0, 0.0]
            }
            Self::Tensors(values) => values[k],
        }
    }
    /// Its numbers, sphere by sphere.
    fn numbers(&self) -> impl Iterator<Item = f64> {
        let count = match self {
            Self::Counts(values) => values.len(),
            Self::Numbers(values) => values.len(),
            Self::Vectors(values) => values.len(),
            Self::Tensors(values) => values.len(),
        };
        (0..count).flat_map(move |k| self.of(k).into_iter().take(self.width()))
    }
}

/// The state at one moment.
pub struct Frame<'a> {
    stage: &'a str,
    system: &'a System,
    digits: Digits,
    /// The columns of spheres, in the order of ids.
    columns: Vec<FrameColumn>,
    /// The pairs, by ids.
    pairs: Vec<ActingPair>,
    /// The strengths of necks, if they have strengths of their own.
    strengths: Option<&'a BTreeMap<(u32, u32), f64>>,
    /// The names of their springs.
    springs: Vec<String>,
}

impl<'a> Frame<'a> {
    /// The state of a simulation. `kind` tells the kind of a pair that no neck joins, if it has one; `flags` are further columns by place, `strengths` those of
    /// necks if they have strengths of their own.
    pub fn of<M: PairModel>(
        simulation: &'a Simulation<M>,
        stage: &'a str,
        kind: impl Fn(&Contact<f64>) -> Option<PairKind>,
        flags: Vec<(&'static str, Vec<bool>)>,
        strengths: Option<&'a BTreeMap<(u32, u32), f64>>,
        digits: Digits,
        extra: &[Extra],
    ) -> Self {
        let (system, loads) = (simulation.system(), Loads::of(simulation, kind));
        let (p, domain) = (&system.particles, &system.domain);
        let order = p.by_id();
        let counts = |values: &[u32]| Values::Counts(order.iter().map(|&k| values[k]).collect());
        let numbers = |values: &[f64]| Values::Numbers(order.iter().map(|&k| values[k]).collect());
        let vectors = |value: &dyn Fn(usize) -> Vec3<f64>| Values::Vectors(order.iter().map(|&k| value(k)).collect());
        let mut columns = Vec::new();
        let mut add = |name, values| columns.push(FrameColumn { name, values });
        add(ID.name, counts(&p.id));
        add(BODY.name, counts(&p.tag));
        add(WALL.name, counts(&p.wall));
        add(RADIUS.name, numbers(&p.radius));
        add(MASS.name, numbers(&p.mass));
        add(POSITION.name, vectors(&|k| domain.folded(p.x[k])));
        add(VELOCITY.name, vectors(&|k| p.v[k]));
        add(ANGULAR_VELOCITY.name, vectors(&|k| p.w[k]));
        add(FORCE.name, vectors(&|k| loads.force[k]));
        add(COORDINATION.name, counts(&loads.coordination));
        add(NECKS.name, counts(&loads.necks));
        for (name, flags) in flags {
            add(name, Values::Counts(order.iter().map(|&k| u32::from(flags[k])).collect()));
        }
        add(STRESS.name, Values::Tensors(order.iter().map(|&k| loads.stress[k]).collect()));
        for extra in extra {
            match extra {
                Extra::Torque => add(TORQUE.name, vectors(&|k| loads.torque[k])),
                Extra::Acceleration => {
                    add(ACCELERATION.name, vectors(&|k| acceleration(loads.force[k], p.mass[k])));
                }
                Extra::AngularAcceleration => {
                    add(ANGULAR_ACCELERATION.name, vectors(&|k| angular_acceleration(loads.torque[k], inertia(p, k))))
                }
            }
        }
        let names = <M::Memory<f64> as Named<f64>>::names();
        let springs = names.into_iter().map(|name| format!("spring {name}").trim_end().replace(' ', "_")).collect();
        Self { stage, system, digits, columns, pairs: loads.pairs, strengths, springs }
    }

    /// The stage.
    pub fn stage(&self) -> &str {
        self.stage
    }

    /// The time, ns.
    pub fn time(&self) -> f64 {
        self.system.time
    }

    /// Checks that every number of a column or a pair is finite, also in single precision if it is written so.
    ///
    /// # Errors
    ///
    /// The quantity that is not.
    pub fn check(&self) -> Result<(), String> {
        let bad = |number: f64| match self.digits {
            Digits::Seven => !(number as f32).is_finite(),
            Digits::All => !number.is_finite(),
        };
        for FrameColumn { name, values } in &self.columns {
            if let Some(place) = values.numbers().position(bad) {
                let id = self.ids()[place / values.width()];
                return Err(format!("{} of particle {id}", name.replace('_', " ")));
            }
        }
        let of_pair = |pair: &&ActingPair| self.numbers(pair).into_iter().any(bad);
        match self.pairs.iter().find(of_pair) {
            Some(ActingPair { ids: [i, j], .. }) => Err(format!("force or energy of the pair {i} and {j}")),
            None => Ok(()),
        }
    }

    fn ids(&self) -> &[u32] {
        match &self.columns[0].values {
            Values::Counts(ids) => ids,
            _ => unreachable!("the first column are the ids"),
        }
    }

    /// The names of the numbers of a pair: gap in nm, forces in pN, energy in zJ, strength if it has one, springs in nm.
    fn numbers_of_pairs(&self) -> Vec<&str> {
        let first = [GAP, NORMAL_FORCE, FORCE_X, FORCE_Y, FORCE_Z, ENERGY].map(|column| column.name);
        let strength = self.strengths.map(|_| STRENGTH.name);
        first.into_iter().chain(strength).chain(self.springs.iter().map(String::as_str)).collect()
    }

    /// The numbers of a pair.
    fn numbers(&self, pair: &ActingPair) -> Vec<f64> {
        let [x, y, z] = pair.force.0;
        let [i, j] = pair.ids;
        let of_neck = |all: &BTreeMap<_, _>| if pair.kind == PairKind::Neck { all[&(i, j)] } else { 0.0 };
        let first = [pair.gap, pair.normal_force, x, y, z, pair.energy];
        first.into_iter().chain(self.strengths.map(of_neck)).chain(pair.springs.iter().copied()).collect()
    }

    /// A number as text.
    fn text(&self, number: f64) -> String {
        let plain = number == 0.0 || (1e-4..1e15).contains(&number.abs());
        match (self.digits, plain) {
            (Digits::Seven, true) => (number as f32).to_string(),
            (Digits::Seven, false) => format!("{:e}", number as f32),
            (Digits::All, true) => number.to_string(),
            (Digits::All, false) => format!("{number:e}"),
        }
    }

    /// Its files: ending and content, that of the spheres last.
    pub fn files(&self, formats: &[Format]) -> Vec<(String, Vec<u8>)> {
        let mut files: Vec<(String, Vec<u8>)> = Vec::new();
        for format in formats {
            match format {
                Format::Extxyz => {
                    if !self.system.surfaces.is_empty() {
                        files.push(("obj".into(), surfaces::wavefront(self.system).into_bytes()));
                    }
                    files.push(("bonds".into(), self.bonds().into_bytes()));
                    files.push(("xyz".into(), self.extended_xyz().into_bytes()));
                }
                Format::Vtp => {
                    files.extend(self.poly_data().map(|(kind, data)| (kind + "vtp", self.vtp(&data).into_bytes())));
                }
                Format::Vtkhdf => {
                    files.extend(self.poly_data().map(|(kind, data)| (kind + "vtkhdf", self.vtkhdf(&data))));
                }
            }
        }
        files
    }
}
