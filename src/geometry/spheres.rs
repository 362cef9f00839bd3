//! Sets of spheres: mass, centre of mass, radius of gyration, and pairs of neighbours.

use super::neighbours_but;
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::spec::Vec3;
use crate::spec::mechanics::gyration::{gyration_term, own_gyration};
use crate::spec::mechanics::pair_geometry;
use crate::system::{Domain, Particles};

/// A primary particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Centre, nm.
    pub centre: Vec3<f64>,
    /// Radius, nm.
    pub radius: f64,
}

impl Sphere {
    /// Distance of the surfaces of two spheres, nm.
    pub fn gap(&self, other: &Self) -> f64 {
        pair_geometry::gap(self.centre, other.centre, self.radius, other.radius)
    }
}

impl Particles {
    /// The spheres, in the order of their ids.
    pub fn spheres(&self) -> Vec<Sphere> {
        self.by_id().into_iter().map(|p| Sphere { centre: self.x[p], radius: self.radius[p] }).collect()
    }
    /// Mean diameter, nm.
    pub fn mean_diameter(&self) -> f64 {
        2.0 * self.radius.iter().sum::<f64>() / self.radius.len() as f64
    }
}

/// Whether the size of the spheres counts in the radius of gyration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SphereExtent {
    /// Only the centres count, as in the fractal law.
    Centres,
    /// Each sphere adds its squared radius, so that one alone has its radius as gyration radius (Filippov, Zurita & Rosner 2000).
    Radii,
}

/// Mass of a sphere, in units in which one of radius 1 nm has mass 1.
pub fn mass(sphere: &Sphere) -> f64 {
    let r = sphere.radius;
    r * r * r
}

/// Centre of mass, nm.
pub fn centre_of_mass(spheres: &[Sphere]) -> Vec3<f64> {
    let (mut sum, mut total) = (Vec3::zero(), 0.0);
    for s in spheres {
        sum = sum + s.centre * mass(s);
        total += mass(s);
    }
    sum * (1.0 / total)
}

/// Square of [`gyration_radius`], nm^2.
pub fn square_gyration_radius(spheres: &[Sphere], extent: SphereExtent) -> f64 {
    let centre = centre_of_mass(spheres);
    let total: f64 = spheres.iter().map(mass).sum();
    let mut sum = [0.0; 3];
    for s in spheres {
        let own = match extent {
            SphereExtent::Centres => 0.0,
            SphereExtent::Radii => own_gyration(s.radius, mass(s), total),
        };
        for (sum, term) in sum.iter_mut().zip(gyration_term(s.centre - centre, mass(s), total).0) {
            *sum += term;
            *sum += own;
        }
    }
    sum.iter().sum()
}

/// Root mean square distance from the centre of mass, weighted by mass, nm.
pub fn gyration_radius(spheres: &[Sphere], extent: SphereExtent) -> f64 {
    square_gyration_radius(spheres, extent).sqrt()
}

/// The pairs `i < j` whose centres are closer than `reach` of their radii, which must not decrease with either, in ascending order.
///
/// # Errors
///
/// [`Error::Interrupted`].
pub fn pairs_within(
    spheres: &[Sphere],
    reach: impl Fn(f64, f64) -> f64 + Sync,
    interrupt: &Interrupt,
) -> Result<Vec<(usize, usize)>, Error> {
    let x: Vec<Vec3<f64>> = spheres.iter().map(|s| s.centre).collect();
    let radii: Vec<f64> = spheres.iter().map(|s| s.radius).collect();
    let open = Domain { sides: [1.0; 3], periodic: [false; 3] };
    let pairs = neighbours_but(&x, &radii, &open, reach, |_, _, _| false, interrupt)?;
    Ok(pairs.into_iter().map(|pair| (pair.p as usize, pair.q as usize)).collect())
}

/// The same spheres with their centre of mass at the origin.
pub fn centred(mut spheres: Vec<Sphere>) -> Vec<Sphere> {
    let centre = centre_of_mass(&spheres);
    for sphere in &mut spheres {
        sphere.centre = sphere.centre - centre;
    }
    spheres
}
