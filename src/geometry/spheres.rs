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

#[cfg(test)]
mod tests {
    use super::*;

    fn sphere(x: [f64; 3], radius: f64) -> Sphere {
        Sphere { centre: Vec3(x), radius }
    }

    #[test]
    fn spheres_weigh_as_the_cube_of_their_radii() {
        assert_eq!([1.0, 3.0].map(|radius| mass(&sphere([0.0; 3], radius))), [1.0, 27.0]);
        // One of mass 8 and two of mass 1: the centre is a tenth of the way.
        let three = [sphere([1.0, 2.0, 3.0], 2.0), sphere([11.0, 2.0, 3.0], 1.0), sphere([1.0, 12.0, 3.0], 1.0)];
        assert!((centre_of_mass(&three) - Vec3([2.0, 3.0, 3.0])).norm() < 1e-14);
        let moved = centred(three.to_vec());
        assert!((moved[1].centre - Vec3([9.0, -1.0, 0.0])).norm() < 1e-14 && moved[1].radius == 1.0);
        // (8 * 2 + 1 * 82 + 1 * 82) / 10.
        assert!((square_gyration_radius(&three, SphereExtent::Centres) - 18.0).abs() < 1e-13);
        // By extent each sphere adds its own square, weighted by mass: (8 * 4 + 1 + 1) / 10.
        assert!((square_gyration_radius(&three, SphereExtent::Radii) - 21.4).abs() < 1e-13);
        assert!((gyration_radius(&three, SphereExtent::Centres) - 18f64.sqrt()).abs() < 1e-14);
        assert!((gyration_radius(&[sphere([5.0; 3], 1.5)], SphereExtent::Radii) - 1.5).abs() < 1e-14);
    }

    #[test]
    fn pairs_are_closer_than_their_reach() {
        let row =
            [sphere([0.0; 3], 1.0), sphere([3.0, 0.0, 0.0], 1.0), sphere([0.0, 3.5, 0.0], 2.0), sphere([-9.0; 3], 1.0)];
        let within = |by: f64| pairs_within(&row, |r, s| r + s + by, &Interrupt::default()).unwrap();
        assert_eq!((within(0.5), within(0.51)), (vec![], vec![(0, 2)]));
        assert_eq!((within(1.0), within(1.01)), (vec![(0, 2)], vec![(0, 1), (0, 2)]));
        assert_eq!((row[0].gap(&row[1]), row[2].gap(&row[0])), (1.0, 0.5));
        let interrupt = Interrupt::default();
        interrupt.request();
        assert!(matches!(pairs_within(&row, |r, s| r + s, &interrupt), Err(Error::Interrupted)));
    }

    #[test]
    fn particles_are_spheres_in_the_order_of_their_ids() {
        let mut particles = Particles::default();
        [1.0, 2.0, 6.0].into_iter().for_each(|r| particles.push(Vec3([10.0 * r, 0.0, 0.0]), r, 1.0, 0));
        assert_eq!(particles.mean_diameter(), 6.0);
        let turned = particles.pick(&[2, 0, 1]);
        let expected = [1.0, 2.0, 6.0].map(|r| sphere([10.0 * r, 0.0, 0.0], r));
        assert_eq!((turned.spheres(), turned.mean_diameter()), (expected.to_vec(), 6.0));
    }
}
