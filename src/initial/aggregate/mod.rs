//! Aggregates of touching spheres: grown by a fractal law or imported, and the necks between them.
//!
//! An aggregate is grown by joining two clusters at a time. The law gives the radius of gyration of the result, hence the
//! distance of the two centres of mass; the clusters are then turned until they touch at one point and overlap nowhere.
//! The two methods differ only in the order of joining.
//!
//! Choices for unequal spheres: one density, so that mass goes with the cube of the radius, and gyration radii weighted by mass.
//! [`law`] defines for each paper whether the size of the spheres counts, and the mean size in use.

mod cluster;
pub mod import;
mod join;
pub mod law;
pub mod necks;
mod neighbours;

pub use neighbours::{NEIGHBOURLY, components, neighbouring};

use crate::error::Error;
use crate::geometry::Sphere;
use crate::interrupt::Interrupt;
use crate::random::Stream;
use crate::spec::Real;
use cluster::Cluster;
use join::join;
use law::{Form, Law};
use std::fmt;

/// The sizes of the spheres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Radii {
    /// All alike, nm.
    Equal(f64),
    /// Log-normal, cut off at two standard deviations of the logarithm.
    LogNormal {
        /// Median, which is also the geometric mean, nm.
        median: f64,
        /// Geometric standard deviation, at least 1.
        deviation: f64,
    },
}

impl Radii {
    fn draw(self, stream: &mut Stream) -> f64 {
        match self {
            Self::Equal(radius) => radius,
            Self::LogNormal { median, deviation } => loop {
                let z = stream.normal();
                if z.abs() <= 2.0 {
                    return median * Real::exp(z * Real::ln(deviation));
                }
            },
        }
    }

    fn are_valid(self) -> bool {
        let (size, deviation) = match self {
            Self::Equal(radius) => (radius, 1.0),
            Self::LogNormal { median, deviation } => (median, deviation),
        };
        size > 0.0 && size.is_finite() && deviation >= 1.0 && deviation.is_finite()
    }
}

/// The order of aggregation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Cluster-cluster aggregation: clusters of similar size are joined, by repeated bisection.
    Clusters,
    /// Particle-cluster aggregation: one sphere after the other, for compact aggregates. The work grows with the square of the number.
    Spheres,
}

/// What to grow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recipe {
    /// Number of spheres.
    pub number: usize,
    /// Fractal dimension.
    pub d_f: f64,
    /// Prefactor of the fractal law.
    pub k_f: f64,
    /// Sizes of the spheres.
    pub radii: Radii,
    /// Order of joining.
    pub method: Method,
}

/// Why a recipe cannot be grown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// It was interrupted.
    Interrupted,
    /// A number in it is out of its range.
    Recipe,
    /// No arrangement was found that meets the law.
    Unmet {
        /// Number of spheres.
        number: usize,
        /// The gyration radius of the law, nm.
        wanted: f64,
        /// The nearest that was reached, nm.
        reached: f64,
    },
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Interrupted => f.write_str("the growth was interrupted"),
            Self::Recipe => f.write_str(
                "expected at least one sphere, a radius, a prefactor and a dimension above 0 and a geometric standard deviation of at least 1",
            ),
            Self::Unmet { number, wanted, reached } => write!(
                f,
                "no aggregate of {number} spheres with a radius of gyration of {wanted:.6} nm was found, the closest has {reached:.6} nm{}",
                if reached > wanted { "; compact aggregates are easier to grow with `growth: spheres`" } else { "" }
            ),
        }
    }
}

impl std::error::Error for Failure {}

impl Failure {
    /// The error of a case whose section `key` asked for the aggregate.
    pub fn of(self, key: &str) -> Error {
        match self {
            Self::Interrupted => Error::Interrupted,
            other => Error::of_key(key, other.to_string()),
        }
    }
}

/// Ends the growth when it is interrupted.
fn going(interrupt: &Interrupt) -> Result<(), Failure> {
    if interrupt.is_due() { Err(Failure::Interrupted) } else { Ok(()) }
}

/// Number of attempts at a whole aggregate before the recipe is given up.
const BEGINNINGS: usize = 20;

/// Relative errors of the gyration radius below it are rounding, which grows with the number of spheres: 5e-12 for 100,000. A law
/// that is not met is missed by more.
const ROUNDING: f64 = 1e-9;

/// Grows an aggregate about its centre of mass. All its contacts touch to rounding, there are `number - 1` of them, nothing
/// overlaps, and from three spheres on the fractal law is met to rounding. Clusters on the way meet it too, except
/// where no arrangement of so few spheres does: these come as near as they can.
///
/// # Errors
///
/// Why the recipe cannot be grown, or that the growth was interrupted.
pub fn aggregate(recipe: &Recipe, seed: u64, interrupt: &Interrupt) -> Result<Vec<Sphere>, Failure> {
    let positive = |value: f64| value > 0.0 && value.is_finite();
    if recipe.number == 0 || !positive(recipe.d_f) || !positive(recipe.k_f) || !recipe.radii.are_valid() {
        return Err(Failure::Recipe);
    }
    let (mut sizes, mut places) = (Stream::new(seed, "aggregate radii"), Stream::new(seed, "aggregate places"));
    let radii = (0..recipe.number).map(|_| recipe.radii.draw(&mut sizes)).collect();
    let largest_cluster = match recipe.method {
        Method::Clusters => 1,
        Method::Spheres => recipe.number,
    };
    let (spheres, missed) = grown(radii, largest_cluster, &recipe.law(), &mut places, interrupt)?;
    missed.map_or(Ok(spheres), Err)
}

/// Grows an aggregate of given spheres, in any order: one after the other up to clusters of `largest_cluster`, as few and as equal
/// as can be, which are then joined, halves of halves. Where the law was not met, the nearest is given, and by how much it was missed.
///
/// # Errors
///
/// That the growth was interrupted.
pub fn grown(
    mut radii: Vec<f64>,
    largest_cluster: usize,
    law: &Law,
    places: &mut Stream,
    interrupt: &Interrupt,
) -> Result<(Vec<Sphere>, Option<Failure>), Failure> {
    let number = radii.len();
    let clusters = number.div_ceil(largest_cluster);
    let mut nearest: Option<(f64, Vec<Sphere>, Failure)> = None;
    for _ in 0..BEGINNINGS {
        // Another order may do what this one cannot: the last sphere may be too small or too large to meet the law.
        for k in (1..number).rev() {
            radii.swap(k, (places.uniform() * (k + 1) as f64) as usize);
        }
        let grown = grow(law, &radii, clusters, places, interrupt)?;
        let wanted = law.gyration_radius(&grown.sums);
        let reached = grown.square.sqrt();
        if number < 3 || (reached / wanted - 1.0).abs() < ROUNDING {
            return Ok((grown.spheres, None));
        }
        let miss = (reached - wanted).abs();
        if nearest.as_ref().is_none_or(|best| miss < best.0) {
            nearest = Some((miss, grown.spheres, Failure::Unmet { number, wanted, reached }));
        }
    }
    let (_, spheres, failure) = nearest.expect("it was begun at least once");
    Ok((spheres, Some(failure)))
}

fn grow(
    law: &Law,
    radii: &[f64],
    clusters: usize,
    stream: &mut Stream,
    interrupt: &Interrupt,
) -> Result<Cluster, Failure> {
    let single = |radius| Cluster::single(radius, law.extent());
    if clusters == 1 {
        return radii[1..]
            .iter()
            .try_fold(single(radii[0]), |grown, &radius| join(&single(radius), &grown, law, stream, interrupt));
    }
    let half = clusters / 2;
    let (left, right) = radii.split_at(radii.len() * half / clusters);
    let left = grow(law, left, half, stream, interrupt)?;
    let right = grow(law, right, clusters - half, stream, interrupt)?;
    join(&left, &right, law, stream, interrupt)
}

impl Recipe {
    /// The law that the aggregate is to obey.
    pub fn law(&self) -> Law {
        Law { k_f: self.k_f, d_f: self.d_f, form: Form::GeometricMean }
    }
}

#[cfg(test)]
mod tests;
