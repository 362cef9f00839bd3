//! The golden trajectories of the soot paper: falls, necks, collisions, the tip, and what the cantilever reads. Spheres are moved twice: by the
//! equations, and by the engine under both ways to step, as the elementary validations of Section 3 ask.

mod engine;
mod falls;
mod springs;
mod surface;
mod tip;
mod triangles;

use crate::golden::Trajectory;

/// The files, each with its comparison.
pub(super) const TRAJECTORIES: &[Trajectory] = &[
    Trajectory {
        file: "soot_falls.json",
        check: |run, complaints| {
            falls::check(run, complaints)?;
            surface::fall(run, complaints)
        },
    },
    Trajectory {
        file: "soot_necks.json",
        check: |run, complaints| {
            springs::neck(run, complaints)?;
            engine::neck(run, complaints)
        },
    },
    Trajectory {
        file: "soot_oblique.json",
        check: |run, complaints| {
            springs::oblique(run, complaints)?;
            engine::oblique(run, complaints)
        },
    },
    Trajectory {
        file: "soot_planar.json",
        check: |run, complaints| {
            springs::planar(run, complaints)?;
            engine::planar(run, complaints)
        },
    },
    Trajectory { file: "soot_triangles.json", check: triangles::check },
    Trajectory { file: "soot_filter.json", check: tip::reading },
    Trajectory { file: "soot_tip.json", check: tip::way },
];
