//! Sums over all pairs of a step.

use crate::spec::Flat;

/// Sums over pairs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Totals<L> {
    /// Power of the pairs on the spheres.
    pub power: f64,
    /// Energy lost in this step, by cause.
    pub losses: L,
    /// Diagonal of the sum of branch vector times force, positive in tension.
    pub virial: [f64; 3],
    /// The least `gap + max_overlap (r_i + r_j)`: negative where two spheres overlap too much.
    pub clearance: f64,
}

impl<L: Flat<f64>> Default for Totals<L> {
    fn default() -> Self {
        Self { power: 0.0, losses: L::from_fn(|_| 0.0), virial: [0.0; 3], clearance: f64::INFINITY }
    }
}

impl<L: Flat<f64>> Totals<L> {
    /// Both together.
    pub fn and(self, other: Self) -> Self {
        Self {
            power: self.power + other.power,
            losses: L::from_fn(|k| self.losses.at(k) + other.losses.at(k)),
            virial: std::array::from_fn(|k| self.virial[k] + other.virial[k]),
            clearance: self.clearance.min(other.clearance),
        }
    }
}
