//! The electrostatic capacity of touching spheres, an estimate of their hydrodynamic radius, by a walk on spheres.

use super::balls::Ball;
use super::{Sphere, centre_of_mass};
use crate::error::Error;
use crate::geometry::directions::{cone, direction};
use crate::interrupt::Interrupt;
use crate::random::Stream;
use crate::spec::mechanics::capacity::{self as spec, return_cosine, return_probability};

/// A walk has hit when it is this near a surface, as a part of the radius of the sphere on which it began.
const SKIN: f64 = 1e-6;

/// The capacity and its standard error, nm: `walks` Brownian walks from a sphere about the spheres hit them or escape.
///
/// # Errors
///
/// [`Error::Interrupted`].
pub fn capacity(
    spheres: &[Sphere],
    walks: usize,
    stream: &mut Stream,
    interrupt: &Interrupt,
) -> Result<[f64; 2], Error> {
    let centre = centre_of_mass(spheres);
    let about: Vec<Sphere> = spheres.iter().map(|s| Sphere { centre: s.centre - centre, ..*s }).collect();
    let begin = about.iter().map(|s| s.centre.norm() + s.radius).fold(0.0, f64::max);
    let about = Ball::of(about);
    let mut hits = 0;
    for _ in 0..walks {
        interrupt.check()?;
        hits += u32::from(walk_hits(&about, begin, stream));
    }
    let share = f64::from(hits) / walks as f64;
    // The number of hits has a binomial distribution.
    Ok([share, (share * (1.0 - share) / walks as f64).sqrt()].map(|share| spec::capacity(share, begin)))
}

/// One walk: each step leads to anywhere on the largest ball that is free.
fn walk_hits(spheres: &Ball, begin: f64, stream: &mut Stream) -> bool {
    let mut at = direction(stream) * begin;
    loop {
        let free = spheres.distance(at);
        if free < SKIN * begin {
            return true;
        }
        at = at + direction(stream) * free;
        let rho = at.norm();
        if rho > begin {
            let back = return_probability(begin, rho);
            if stream.uniform() >= back {
                return false;
            }
            at = cone(at * (1.0 / rho), return_cosine(stream.uniform(), back), stream) * begin;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::Vec3;

    fn at(places: &[[f64; 3]]) -> Vec<Sphere> {
        places.iter().map(|&x| Sphere { centre: Vec3(x), radius: 1.0 }).collect()
    }

    fn taken(spheres: &[Sphere], walks: usize, seed: u64) -> [f64; 2] {
        capacity(spheres, walks, &mut Stream::new(seed, "test"), &Interrupt::default()).unwrap()
    }

    /// Five standard errors.
    fn agrees(spheres: &[Sphere], exact: f64, begin: f64) {
        let walks = 20_000;
        let [found, _] = taken(spheres, walks, 3);
        let p = exact / begin;
        let error = 5.0 * begin * (p * (1.0 - p) / walks as f64).sqrt();
        assert!((found - exact).abs() < error, "{found} is not {exact} within {error}");
    }

    #[test]
    fn the_capacity_of_a_sphere_is_its_radius() {
        let one = [Sphere { centre: Vec3([5.0, -3.0, 1.0]), radius: 2.5 }];
        assert_eq!(taken(&one, 10, 1), [2.5, 0.0]);
    }

    #[test]
    fn two_touching_spheres_have_the_capacity_of_maxwell() {
        agrees(&at(&[[0.0; 3], [2.0, 0.0, 0.0]]), 2.0 * 2f64.ln(), 2.0);
    }

    #[test]
    fn two_distant_spheres_shield_each_other_as_two_charges() {
        // Bispherical harmonics: C = 2 sinh(a) sum (-1)^(n+1) / sinh(n a) for two unit spheres 2 cosh(a) apart.
        let a = 6f64.acosh();
        let sum: f64 = (1..60).map(|n: i32| (-1f64).powi(n + 1) / (f64::from(n) * a).sinh()).sum();
        agrees(&at(&[[0.0; 3], [12.0, 0.0, 0.0]]), 2.0 * a.sinh() * sum, 7.0);
    }

    #[test]
    fn two_unequal_spheres_that_cut_at_right_angles_have_the_capacity_of_three_charges() {
        let (a, b) = (1.0f64, 0.5f64);
        let distance = a.hypot(b);
        let sphere = |x: f64, radius: f64| Sphere { centre: Vec3([x, 0.0, 0.0]), radius };
        let begin = distance * a.powi(3) / (a.powi(3) + b.powi(3)) + b;
        agrees(&[sphere(0.0, a), sphere(distance, b)], a + b - a * b / distance, begin);
    }

    #[test]
    fn a_hidden_sphere_changes_nothing() {
        let shell = [Sphere { centre: Vec3::zero(), radius: 3.0 }, Sphere { centre: Vec3::zero(), radius: 1.0 }];
        assert_eq!(taken(&shell, 10, 1), [3.0, 0.0]);
    }

    #[test]
    fn the_standard_error_is_that_of_the_hits() {
        // Two distant spheres are hit by a part of the walks; the error is that of a binomial distribution times the radius of the beginning.
        let two = at(&[[0.0; 3], [12.0, 0.0, 0.0]]);
        let [found, error] = taken(&two, 400, 7);
        let share = found / 7.0;
        assert!(share > 0.1 && share < 0.5 && (share * 400.0 - (share * 400.0).round()).abs() < 1e-9, "{share}");
        assert!((error - 7.0 * (share * (1.0 - share) / 400.0).sqrt()).abs() < 1e-12);
        let interrupt = Interrupt::default();
        interrupt.request();
        assert!(matches!(capacity(&two, 1, &mut Stream::new(1, "test"), &interrupt), Err(Error::Interrupted)));
    }
}
