//! The shape of an aggregate, and its motion through a gas.

use super::fractal::FractalLaw;
use super::morphology::{Bounded, convexity, coordination_number};
use crate::error::Error;
use crate::geometry::capacity::capacity;
use crate::geometry::shadow::{mean_projected_area, projected_area};
use crate::geometry::{Sphere, SphereExtent, gyration_radius};
use crate::interrupt::Interrupt;
use crate::random::Stream;
use crate::spec::Vec3;
use crate::spec::titania::eq14_friction_factor::friction_factor;
use serde::{Deserialize, Serialize};

/// A gas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gas {
    /// Viscosity, MPa ns.
    pub viscosity: f64,
    /// Mean free path, nm.
    pub free_path: f64,
}

/// Air at 296.15 K and 101.3 kPa (ISO 15900): 18.3245 µPa s, 67.3 nm.
pub const AIR: Gas = Gas { viscosity: 18.3245e-3, free_path: 67.3 };

/// The shape of an aggregate.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AggregateShape {
    /// Number of spheres.
    pub number: usize,
    /// Mean coordination number (Eq. 26 of Demidov, Gor & Khalizov 2024).
    pub coordination: f64,
    /// Volume of the spheres over that of their convex hull.
    pub convexity: Bounded,
    /// Radius of gyration of the centres, nm.
    pub gyration_radius: f64,
    /// The fractal law; none for few spheres.
    pub fractal: Option<FractalLaw>,
    /// Mean projected area, nm^2.
    pub projected_area: f64,
    /// Hydrodynamic radius, nm, and its standard error; none for many spheres.
    pub hydrodynamic_radius: Option<[f64; 2]>,
    /// Radius of the sphere that air resists alike (Eq. 14 of Laube et al. 2018), nm, and its standard error.
    pub mobility_radius: Option<[f64; 2]>,
}

/// Walks that measure the hydrodynamic radius: its standard error is 1.6 % where half of them hit.
const WALKS: usize = 4000;
/// Largest number of spheres about which walks are taken.
const MOST: usize = 20_000;
/// Directions in which the projected area is taken.
const DIRECTIONS: usize = 56;

impl AggregateShape {
    /// Measures spheres; the random walks are always the same.
    ///
    /// # Errors
    ///
    /// [`Error::Interrupted`].
    pub fn of(spheres: &[Sphere], interrupt: &Interrupt) -> Result<Self, Error> {
        let projected_area = mean_projected_area(spheres, DIRECTIONS, interrupt)?;
        let mut stream = Stream::new(1, "hydrodynamic radius");
        let walks = (spheres.len() <= MOST).then(|| capacity(spheres, WALKS, &mut stream, interrupt));
        let hydrodynamic_radius = walks.transpose()?;
        interrupt.check()?;
        Ok(Self {
            number: spheres.len(),
            coordination: coordination_number(spheres),
            convexity: convexity(spheres),
            gyration_radius: gyration_radius(spheres, SphereExtent::Centres),
            fractal: FractalLaw::of(spheres),
            projected_area,
            hydrodynamic_radius,
            mobility_radius: hydrodynamic_radius.map(|[r_h, error]| {
                let of = |r_h| mobility_radius(r_h, projected_area, AIR);
                [of(r_h), 0.5 * (of(r_h + error) - of(r_h - error))]
            }),
        })
    }
}

/// The area that a sphere shows, nm^2.
fn disc_area(radius: f64) -> f64 {
    let one = [Sphere { centre: Vec3::zero(), radius }];
    projected_area(&one, Vec3([0.0, 0.0, 1.0]), &Interrupt::default()).expect("nothing asks to stop")
}

/// The radius of the sphere with the friction factor of an aggregate: a sphere is its own hydrodynamic radius, and shows a disc.
pub fn mobility_radius(r_h: f64, projected_area: f64, gas: Gas) -> f64 {
    let friction = |r_h: f64, area: f64| friction_factor(gas.viscosity, gas.free_path, r_h, area).2;
    let wanted = friction(r_h, projected_area);
    // Friction grows with the radius, and a disc of the projected area, or the hydrodynamic radius, bounds it.
    let disc = (projected_area / disc_area(1.0)).sqrt();
    let (mut low, mut high) = (0.5 * r_h.min(disc), 2.0 * r_h.max(disc));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if friction(middle, disc_area(middle)) < wanted { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sphere_has_its_own_radius_by_every_measure() {
        let shape =
            AggregateShape::of(&[Sphere { centre: Vec3([3.0, 2.0, 1.0]), radius: 14.0 }], &Interrupt::default())
                .unwrap();
        assert_eq!((shape.number, shape.coordination, shape.gyration_radius), (1, 0.0, 0.0));
        assert!((shape.convexity.value - 1.0).abs() < 1e-12);
        assert!((shape.projected_area / disc_area(14.0) - 1.0).abs() < 1e-12);
        let [r_h, error] = shape.hydrodynamic_radius.expect("one sphere");
        assert!((r_h - 14.0).abs() <= 5.0 * error + 1e-9, "{r_h} {error}");
        assert!((mobility_radius(14.0, disc_area(14.0), AIR) - 14.0).abs() < 1e-9);
    }

    #[test]
    fn a_measurement_that_is_interrupted_gives_nothing() {
        let over = Interrupt::default().within(std::time::Duration::ZERO);
        let chain: Vec<Sphere> =
            (0..300).map(|k| Sphere { centre: Vec3([2.0 * f64::from(k), 0.0, 0.0]), radius: 1.0 }).collect();
        assert!(matches!(AggregateShape::of(&chain, &over), Err(Error::Interrupted)));
    }

    #[test]
    fn in_a_thin_gas_the_projected_area_decides_and_in_a_dense_one_the_hydrodynamic_radius() {
        let area = disc_area(20.0);
        let of = |free_path| mobility_radius(30.0, area, Gas { viscosity: 1.0, free_path });
        // Free molecules: friction goes as the projected area, hence the radius of its disc; a continuum: the hydrodynamic radius.
        assert!((of(1e7) - 20.0).abs() < 1e-3, "{}", of(1e7));
        assert!((of(1e-3) - 30.0).abs() < 1e-2, "{}", of(1e-3));
    }
}
