//! What the book shows of the paper beside its equations.

use super::case::{FrictionCoefficients, NeckSet, published_contact};
use crate::case::section::defaults;
use crate::case::springs::FourSprings;
use crate::case::units::from_engine;
use crate::papers::shown::{Law, Table};

pub(super) const TABLES: &[Table] = &[
    Table {
        number: "Fig. 3",
        title: "Parameters of the restructuring, by the authors' published input",
        case: "cases/soot/restructuring.yaml",
        keys: &[],
    },
    Table {
        number: "Fig. 3",
        title: "Parameters of deposition and indentation, by the authors' published input",
        case: "cases/soot/indentation.yaml",
        keys: &[],
    },
];

/// A frictional contact and a neck of two spheres of the paper.
pub(super) fn laws() -> Vec<Law> {
    let FrictionCoefficients { at_rest: [mu_t, mu_r, mu_o], in_motion } = defaults();
    let friction = [("mu_t", mu_t), ("mu_r", mu_r), ("mu_o", mu_o), ("phi", in_motion[0] / mu_t)];
    vec![
        Law {
            id: "soot-contact",
            title: "A frictional contact of soot spheres of 28 nm in diameter",
            gaps: [-0.05e-9, 0.05e-9],
            gap: -0.02e-9,
            path: 0.1e-9,
            values: springs(&published_contact()).into_iter().chain(friction).collect(),
        },
        Law {
            id: "soot-neck",
            title: "A neck of set S of soot spheres of 28 nm in diameter",
            gaps: [-0.05e-9, 0.05e-9],
            gap: 0.0,
            path: 0.1e-9,
            values: springs(&NeckSet::S.springs()),
        },
    ]
}

/// Radii and springs, in SI.
fn springs(springs: &FourSprings) -> Vec<(&'static str, f64)> {
    let (springs, r) = (springs.spec(), 14e-9);
    let stiffness = [("k_n", springs.k_n), ("k_t", springs.k_t), ("k_r", springs.k_r), ("k_o", springs.k_o)];
    let damping =
        [("eta_n", springs.eta_n), ("eta_t", springs.eta_t), ("eta_r", springs.eta_r), ("eta_o", springs.eta_o)];
    let stiffness = stiffness.map(|(name, value)| (name, from_engine(value, "N/m")));
    let damping = damping.map(|(name, value)| (name, from_engine(value, "kg/s")));
    [("r_i", r), ("r_j", r)].into_iter().chain(stiffness).chain(damping).collect()
}
