//! Fractal laws: the size of an aggregate of given spheres.

use crate::geometry::Sphere;
use crate::geometry::SphereExtent;
use crate::spec::Real;
use crate::spec::mechanics::solids::sphere_volume;
use crate::spec::soot::eq24_fractal;
use crate::spec::titania::def_aggregate::{fractal_diameter, sauter_diameter};

/// A law with its prefactor and dimension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    /// Prefactor.
    pub k_f: f64,
    /// Fractal dimension.
    pub d_f: f64,
    /// What it compares.
    pub form: Form,
}

/// The measures that a law uses for the size of an aggregate and of its spheres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// The gyration radius of the centres and the geometric mean of the radii: Eq. 24 of Demidov, Gor & Khalizov 2024.
    GeometricMean,
    /// The gyration radius by which one sphere has its own radius and the Sauter diameter: Section 5.3 of Laube et al. 2018.
    SauterDiameter,
}

/// Sums over spheres.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sums {
    /// How many they are.
    pub number: usize,
    /// Logarithms of the radii.
    pub logarithms: f64,
    /// Squares of the radii.
    pub squares: f64,
    /// Cubes of the radii: the mass, in units in which a sphere of radius 1 has mass 1.
    pub cubes: f64,
}

impl Sums {
    /// The sums over some spheres.
    pub fn of(spheres: &[Sphere]) -> Self {
        let sum = |part: fn(f64) -> f64| spheres.iter().map(|s| part(s.radius)).sum();
        Self {
            number: spheres.len(),
            logarithms: sum(Real::ln),
            squares: sum(|r| r.squared()),
            cubes: sum(|r| r * r * r),
        }
    }

    /// The sums over these spheres and others.
    pub fn with(&self, others: &Self) -> Self {
        Self {
            number: self.number + others.number,
            logarithms: self.logarithms + others.logarithms,
            squares: self.squares + others.squares,
            cubes: self.cubes + others.cubes,
        }
    }
}

impl Law {
    /// The gyration radius that the law demands.
    pub fn gyration_radius(&self, sums: &Sums) -> f64 {
        let n = sums.number as f64;
        match self.form {
            Form::GeometricMean => eq24_fractal::gyration_radius(self.k_f, n, Real::exp(sums.logarithms / n), self.d_f),
            Form::SauterDiameter => {
                let (volume, surface) = (sums.cubes * sphere_volume(1.0), 4.0 * f64::pi() * sums.squares);
                0.5 * fractal_diameter(self.k_f, n, sauter_diameter(volume, surface), self.d_f)
            }
        }
    }

    /// The extent of the spheres that counts in its gyration radius.
    pub fn extent(&self) -> SphereExtent {
        match self.form {
            Form::GeometricMean => SphereExtent::Centres,
            Form::SauterDiameter => SphereExtent::Radii,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::Vec3;

    fn sums(radii: &[f64]) -> Sums {
        Sums::of(&radii.iter().map(|&radius| Sphere { centre: Vec3::zero(), radius }).collect::<Vec<_>>())
    }

    #[test]
    fn sums_are_those_of_all_spheres() {
        for Sums { number, logarithms, squares, cubes } in
            [sums(&[1.0, 2.0, 4.0]), sums(&[1.0]).with(&sums(&[2.0, 4.0]))]
        {
            assert_eq!((number, squares, cubes), (3, 21.0, 73.0));
            assert!((logarithms - 8f64.ln()).abs() < 1e-15);
        }
    }

    #[test]
    fn laws_demand_radii_of_gyration() {
        let radius = |form, radii: &[f64]| Law { k_f: 0.5, d_f: 2.0, form }.gyration_radius(&sums(radii));
        // Eight spheres per prefactor: the root of 16 times the geometric mean, or half the Sauter diameter.
        let radii = [1.0, 4.0, 1.0, 4.0, 1.0, 4.0, 1.0, 4.0];
        assert!((radius(Form::GeometricMean, &radii) - 8.0).abs() < 1e-13);
        // 6 V / S = 2 * 65 / 17.
        assert!((radius(Form::SauterDiameter, &radii) - 4.0 * 65.0 / 17.0).abs() < 1e-13);
        let extent = |form| Law { k_f: 1.0, d_f: 1.0, form }.extent();
        assert_eq!(
            [Form::GeometricMean, Form::SauterDiameter].map(extent),
            [SphereExtent::Centres, SphereExtent::Radii]
        );
    }
}
