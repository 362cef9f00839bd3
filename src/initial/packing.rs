//! Polydisperse random samples (Section 3.2) before their relaxation.

use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::random::Stream;
use crate::spec::mechanics::solids::sphere_volume;
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::mechanics::truncated_lognormal::lognormal;
use crate::spec::{Real, Vec3};
use crate::system::{Domain, Particles, System};

/// The volume fraction up to which the paper fills a box.
pub const FILL: f64 = 0.75;

/// The distribution of the diameters: log-normal of mode `d_0` and standard deviation 0.2 (`d_l` - `d_s`), truncated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// Most frequent diameter, nm.
    pub d_0: f64,
    /// Smallest diameter, nm.
    pub d_s: f64,
    /// Largest diameter, nm.
    pub d_l: f64,
}

impl Sizes {
    /// The paper's distribution about `d_0`: from 0.75 to 1.25 of it.
    pub fn around(d_0: f64) -> Self {
        Self { d_0, d_s: 0.75 * d_0, d_l: 1.25 * d_0 }
    }

    /// A diameter: drawn from the whole distribution until it lies within the bounds.
    fn draw(&self, (mu, sigma): (f64, f64), stream: &mut Stream) -> f64 {
        // Equal diameters have no deviation: rounding alone would decide whether any is within the bounds.
        if self.d_s == self.d_l {
            return self.d_0;
        }
        loop {
            let d = Real::exp(mu + sigma * stream.normal());
            if d >= self.d_s && d <= self.d_l {
                return d;
            }
        }
    }
}

/// Spheres that are placed between two looks at the interrupt.
const ASKED: usize = 4096;

/// Spheres at random places in a periodic box, overlapping, inserted until they fill it to the fraction `fill`; of the given density.
///
/// # Errors
///
/// [`Error::Interrupted`] when interrupted.
pub fn random_packing(
    sizes: Sizes,
    sides: [f64; 3],
    fill: f64,
    density: f64,
    seed: u64,
    interrupt: &Interrupt,
) -> Result<System, Error> {
    let parameters = lognormal(sizes.d_0, sizes.d_s, sizes.d_l);
    let (mut diameters, mut places) = (Stream::new(seed, "diameters"), Stream::new(seed, "positions"));
    let domain = Domain::periodic(sides);
    let mut particles = Particles::default();
    let mut filled = 0.0;
    while filled < fill * domain.volume() {
        let r = 0.5 * sizes.draw(parameters, &mut diameters);
        let x = Vec3(sides.map(|side| side * places.uniform()));
        particles.push(x, r, sphere_mass(density, r), 0);
        filled += sphere_volume(r);
        if particles.len().is_multiple_of(ASKED) {
            interrupt.check()?;
        }
    }
    Ok(System::new(particles, domain))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observe::packing::volume_fraction;

    #[test]
    fn the_box_is_filled_to_the_fraction_and_by_no_more_than_one_sphere_beyond() {
        let system =
            random_packing(Sizes::around(1.0), [12.0, 10.0, 9.0], FILL, 2.0, 3, &Interrupt::default()).unwrap();
        let last = sphere_volume(*system.particles.radius.last().unwrap()) / system.domain.volume();
        let fraction = volume_fraction(&system);
        assert!(fraction >= FILL && fraction < FILL + last, "{fraction}");
        assert!(system.particles.radius.iter().all(|&r| (0.375..=0.625).contains(&r)));
    }

    #[test]
    fn diameters_have_the_moments_of_the_truncated_distribution() {
        // Mean, standard deviation and mean cube of the truncated distribution by quadrature, mode 1.
        for (d_l, mean, deviation, cube) in [
            (1.25, 1.0107040280929147, 0.0939345215242708, 1.0592860322050324),
            (5.0, 1.6352605472954748, 0.742843336807402, 7.658514172954135),
        ] {
            let sizes = Sizes { d_0: 1.0, d_s: 0.75, d_l };
            let parameters = lognormal(sizes.d_0, sizes.d_s, sizes.d_l);
            let mut stream = Stream::new(11, "test");
            let drawn: Vec<f64> = (0..40_000).map(|_| sizes.draw(parameters, &mut stream)).collect();
            let average = |f: &dyn Fn(f64) -> f64| drawn.iter().map(|&d| f(d)).sum::<f64>() / drawn.len() as f64;
            let error = 5.0 / (drawn.len() as f64).sqrt(); // five standard errors, in units of the deviation
            let spread = (average(&|d| (d - mean) * (d - mean))).sqrt();
            assert!((average(&|d| d) - mean).abs() < error * deviation);
            assert!((spread / deviation - 1.0).abs() < error);
            let cubes = |d: f64| d * d * d;
            let cube_deviation = average(&|d| (cubes(d) - cube) * (cubes(d) - cube)).sqrt();
            assert!((average(&cubes) - cube).abs() < error * cube_deviation);
        }
    }

    #[test]
    fn the_same_seed_gives_the_same_bits() {
        let build =
            |seed| random_packing(Sizes::around(1.5), [8.0; 3], FILL, 1.0, seed, &Interrupt::default()).unwrap();
        assert_eq!(build(5), build(5));
        assert_ne!(build(5), build(6));
    }

    #[test]
    fn equal_diameters_are_all_alike_and_weigh_by_the_density() {
        let sizes = Sizes { d_0: 1.0, d_s: 1.0, d_l: 1.0 };
        let volume = f64::pi() / 6.0;
        // The third sphere fills the box to the fraction.
        let system =
            random_packing(sizes, [2.0, 3.0, 4.0], 2.5 * volume / 24.0, 3.0, 1, &Interrupt::default()).unwrap();
        assert_eq!((system.particles.radius, system.domain), (vec![0.5; 3], Domain::periodic([2.0, 3.0, 4.0])));
        assert!(system.particles.mass.iter().all(|m| (m - 3.0 * volume).abs() < 1e-14));
        assert_eq!(Sizes::around(2.0), Sizes { d_0: 2.0, d_s: 1.5, d_l: 2.5 });
    }

    #[test]
    fn places_are_spread_evenly_over_the_box() {
        let sides = [20.0, 10.0, 5.0];
        let system = random_packing(Sizes::around(1.0), sides, 2.0, 1.0, 1, &Interrupt::default()).unwrap();
        let x = &system.particles.x;
        for a in 0..3 {
            let part = |k: i32| x.iter().map(|c| (c.0[a] / sides[a]).powi(k)).sum::<f64>() / x.len() as f64;
            // Five standard errors of the mean and of the mean square.
            let error = 5.0 / (x.len() as f64).sqrt();
            assert!((part(1) - 0.5).abs() < 0.289 * error && (part(2) - 1.0 / 3.0).abs() < 0.299 * error);
            assert!(x.iter().all(|c| (0.0..sides[a]).contains(&c.0[a])));
        }
    }

    #[test]
    fn a_large_sample_asks_whether_to_stop() {
        let interrupt = Interrupt::default();
        interrupt.request();
        let build = |side: f64| random_packing(Sizes::around(1.0), [side; 3], FILL, 1.0, 1, &interrupt);
        assert!(build(10.0).is_ok_and(|system| system.particles.len() < ASKED));
        assert!(matches!(build(16.0), Err(Error::Interrupted)));
    }
}
