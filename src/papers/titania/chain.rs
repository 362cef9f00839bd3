//! A chain of particles of different sizes, each of which touches the preceding two.

use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::random::Stream;
use crate::spec::{Real, Vec3};
use std::f64::consts::TAU;

/// The parameters of a chain; lengths in nm, diameters are nominal: particles touch at half their sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recipe {
    /// Number of particles, at least three.
    pub particles: usize,
    /// Smallest diameter.
    pub smallest: f64,
    /// Largest diameter; the diameters are distributed uniformly.
    pub largest: f64,
    /// Length from end to end.
    pub length: f64,
}

/// A particle: its centre and diameter.
pub type Particle = (Vec3<f64>, f64);

/// Relative tolerance of the length.
pub const TOLERANCE: f64 = 0.05;
/// Number of chains tried before the length is given up.
const CHAINS: usize = 5000;
/// Number of positions tried for a particle before its chain is given up.
const PLACES: usize = 50;

/// The first of many random chains that has the required length, aligned with x and starting at zero; none if no chain has it.
///
/// # Errors
///
/// [`Error::Interrupted`] when interrupted.
pub fn agglomerate(recipe: &Recipe, seed: u64, interrupt: &Interrupt) -> Result<Option<Vec<Particle>>, Error> {
    let mut stream = Stream::new(seed, "agglomerate");
    for _ in 0..CHAINS {
        interrupt.check()?;
        let Some(chain) = chain(recipe, &mut stream).map(aligned) else { continue };
        let [low, high] = extent(&chain, 0);
        if (high - low - recipe.length).abs() <= TOLERANCE * recipe.length {
            return Ok(Some(chain));
        }
    }
    Ok(None)
}

/// The lowest and the highest coordinate of the chain along an axis, radii included.
pub fn extent(chain: &[Particle], axis: usize) -> [f64; 2] {
    chain.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], (x, d)| {
        [low.min(x.0[axis] - 0.5 * d), high.max(x.0[axis] + 0.5 * d)]
    })
}

/// How far a chain is moved into its box, in which it has this margin: by whole nanometres beyond it, so that places in a file keep their digits.
pub fn corner(chain: &[Particle], margin: f64) -> Vec3<f64> {
    Vec3(std::array::from_fn(|axis| margin - extent(chain, axis)[0].round()))
}

/// The margin of a chain from a file: its largest diameter in whole nanometres.
pub fn margin(chain: &[Particle]) -> f64 {
    chain.iter().map(|particle| particle.1).fold(0.0, f64::max).ceil()
}

fn chain(recipe: &Recipe, stream: &mut Stream) -> Option<Vec<Particle>> {
    let Recipe { particles, smallest, largest, .. } = *recipe;
    let mut diameters = (0..particles).map(|_| smallest + (largest - smallest) * stream.uniform()).collect::<Vec<_>>();
    let rest = diameters.split_off(2);
    let mut chain =
        vec![(Vec3::zero(), diameters[0]), (Vec3::new(0.5 * (diameters[0] + diameters[1]), 0.0, 0.0), diameters[1])];
    for d in rest {
        let [.., before, last] = chain[..] else { unreachable!("a chain begins with two particles") };
        let place = (0..PLACES).map(|_| touching(before, last, d, TAU * stream.uniform()));
        let free = |x: &Vec3<f64>| chain[..chain.len() - 2].iter().all(|(y, e)| (*x - *y).norm() >= 0.5 * (d + e));
        let place = place.into_iter().find(free)?;
        chain.push((place, d));
    }
    Some(chain)
}

/// The position at which a particle of diameter `d` touches two others that touch each other, at `azimuth` about the line through their centres.
fn touching((p, d_p): Particle, (q, d_q): Particle, d: f64, azimuth: f64) -> Vec3<f64> {
    let (to_p, to_q, apart) = (0.5 * (d + d_p), 0.5 * (d + d_q), (q - p).norm());
    let [e, u, w] = frame(q - p);
    let along = 0.5 * (to_p * to_p - to_q * to_q + apart * apart) / apart;
    let aside = (to_p * to_p - along * along).sqrt();
    p + e * along + (u * Real::cos(azimuth) + w * Real::sin(azimuth)) * aside
}

/// Three orthogonal unit vectors, the first along `x`.
fn frame(x: Vec3<f64>) -> [Vec3<f64>; 3] {
    let unit = |v: Vec3<f64>| v * (1.0 / v.norm());
    let e = unit(x);
    let other = if e.0[0].abs() < 0.7 { Vec3::new(1.0, 0.0, 0.0) } else { Vec3::new(0.0, 1.0, 0.0) };
    let u = unit(e.cross(other));
    [e, u, e.cross(u)]
}

/// The chain, rotated so that its two ends, of two particles each, are aligned along x, and shifted so that it starts at zero.
fn aligned(mut chain: Vec<Particle>) -> Vec<Particle> {
    let [(a, _), (b, _), .., (y, _), (z, _)] = chain[..] else { unreachable!("a chain has two ends") };
    let axes = frame(y + z - (a + b));
    for (x, _) in &mut chain {
        *x = Vec3(axes.map(|axis| axis.dot(*x)));
    }
    let low = Vec3(std::array::from_fn(|axis| extent(&chain, axis)[0]));
    for (x, _) in &mut chain {
        *x = *x - low;
    }
    chain
}

#[cfg(test)]
mod tests {
    use super::*;
    use quickcheck::quickcheck;

    const RECIPE: Recipe = Recipe { particles: 14, smallest: 8.0, largest: 20.0, length: 100.0 };

    fn grown(recipe: &Recipe, seed: u64) -> Option<Vec<Particle>> {
        agglomerate(recipe, seed, &Interrupt::default()).unwrap()
    }

    #[test]
    fn growth_that_is_interrupted_gives_nothing() {
        let over = Interrupt::default().within(std::time::Duration::ZERO);
        assert!(matches!(agglomerate(&RECIPE, 1, &over), Err(Error::Interrupted)));
    }

    quickcheck! {
        fn every_particle_touches_the_two_before_it_and_none_overlap(seed: u64) -> bool {
            let chain = grown(&RECIPE, seed).unwrap();
            let gap = |i: usize, j: usize| (chain[i].0 - chain[j].0).norm() - 0.5 * (chain[i].1 + chain[j].1);
            let good = |i: usize, j: usize| gap(i, j) > -1e-12 && (i - j > 2 || gap(i, j) < 1e-12);
            (0..chain.len()).all(|i| (8.0..20.0).contains(&chain[i].1) && (0..i).all(|j| good(i, j)))
        }

        fn the_length_is_met_and_begins_at_zero(seed: u64) -> bool {
            let [low, high] = extent(&grown(&RECIPE, seed).unwrap(), 0);
            low.abs() < 1e-12 && (95.0..=105.0).contains(&high)
        }
    }

    #[test]
    fn a_seed_is_a_chain() {
        assert_eq!(grown(&RECIPE, 7), grown(&RECIPE, 7));
        assert_ne!(grown(&RECIPE, 7), grown(&RECIPE, 8));
    }

    #[test]
    fn an_impossible_length_is_given_up() {
        assert_eq!(grown(&Recipe { length: 1000.0, ..RECIPE }, 1), None);
    }
}
