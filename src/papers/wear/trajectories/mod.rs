//! The golden trajectories of the wear paper.

mod euler;
mod lattice;
mod pair;
mod paths;

use crate::golden::Trajectory;
use crate::spec::wear::def_contact::Parameters;

/// The files, each with its comparison.
pub(super) const TRAJECTORIES: &[Trajectory] = &[
    Trajectory { file: "euler.json", check: euler::check },
    Trajectory { file: "collisions.json", check: pair::collision },
    Trajectory { file: "passages.json", check: pair::passage },
    Trajectory { file: "quasistatic_loop.json", check: paths::quasistatic_loop },
    Trajectory { file: "tangential_path.json", check: paths::tangential_path },
    Trajectory { file: "lattice.json", check: lattice::check },
];

/// Radius of the spheres of a pair.
const RADIUS: f64 = 10.0;

const NO_LAW: Parameters<f64> =
    Parameters { k_n: 0.0, k_t: 0.0, delta_e: 0.0, delta_f: 0.0, f_mt: 0.0, c_n: 0.0, c_t: 0.0 };
