//! The structure of a film: porosity, profile, contacts, pores.

mod pores;

use crate::geometry::neighbours;
use crate::initial::film::{DepositedFilm, FilmSphere};
use crate::spec::Vec3;
use crate::spec::mechanics::solids::{cap_volume, sphere_volume};
use crate::system::Domain;

/// The bulk of a film lies between the heights below which these parts of its solid are: neither floor nor surface count.
const BULK: [f64; 2] = [0.2, 0.8];
/// Layers of the profile.
const LAYERS: usize = 20;

/// The structure of a film.
#[derive(Clone, Debug, PartialEq)]
pub struct Structure {
    /// Height of the highest point, nm.
    pub thickness: f64,
    /// Lowest and highest height of the bulk, nm.
    pub bulk: [f64; 2],
    /// Part of the bulk that is not solid.
    pub porosity: f64,
    /// Solid part of equal layers, from the floor to the highest point.
    pub profile: Vec<f64>,
    /// Mean coordination number within an aggregate.
    pub contacts_within: f64,
    /// Mean number of contacts of an aggregate with others.
    pub contacts_between: f64,
    /// Pore diameter (nm), 10th, 50th and 90th percentile: the diameter of the largest empty sphere that contains a random point of the bulk.
    pub pores: [f64; 3],
}

impl Structure {
    /// Measures a film, in which spheres touch if their gap is less than `touch` (nm); the same `seed` gives the same pores.
    pub fn of(film: &DepositedFilm, touch: f64, seed: u64) -> Self {
        let bulk = bulk(film);
        let solid = |low, high| solid_between(film, low, high);
        let layer = film.thickness / LAYERS as f64;
        let [within, between] = contacts(film, touch);
        Self {
            thickness: film.thickness,
            bulk,
            porosity: 1.0 - solid(bulk[0], bulk[1]),
            profile: (0..LAYERS).map(|k| solid(k as f64 * layer, (k + 1) as f64 * layer)).collect(),
            contacts_within: 2.0 * within as f64 / film.spheres.len() as f64,
            contacts_between: 2.0 * between as f64 / film.aggregates() as f64,
            pores: pores::pores(film, bulk, seed),
        }
    }
}

fn radius(sphere: &FilmSphere) -> f64 {
    0.5 * sphere.diameter
}

fn bulk(film: &DepositedFilm) -> [f64; 2] {
    let mut heights: Vec<(f64, f64)> = film.spheres.iter().map(|s| (s.centre.0[2], sphere_volume(radius(s)))).collect();
    heights.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = heights.iter().map(|s| s.1).sum();
    BULK.map(|part| {
        let mut below = 0.0;
        let reached = |s: &&(f64, f64)| {
            below += s.1;
            below >= part * total
        };
        heights.iter().find(reached).map_or(0.0, |s| s.0)
    })
}

/// The solid part between two heights.
fn solid_between(film: &DepositedFilm, low: f64, high: f64) -> f64 {
    let volume: f64 = film.spheres.iter().map(|s| below(s, high) - below(s, low)).sum();
    volume / (film.sides[0] * film.sides[1] * (high - low))
}

/// Volume of that part of a sphere which is below a height: a cap.
fn below(sphere: &FilmSphere, height: f64) -> f64 {
    let r = radius(sphere);
    let cap = (height - sphere.centre.0[2] + r).clamp(0.0, 2.0 * r);
    cap_volume(r, cap)
}

/// Numbers of contacts within aggregates and between them.
fn contacts(film: &DepositedFilm, touch: f64) -> [usize; 2] {
    let centres: Vec<Vec3<f64>> = film.spheres.iter().map(|s| s.centre).collect();
    let radii: Vec<f64> = film.spheres.iter().map(radius).collect();
    let column = Domain { sides: [film.sides[0], film.sides[1], film.thickness], periodic: [true, true, false] };
    let mut numbers = [0; 2];
    for pair in neighbours(&centres, &radii, &column, |r, s| r + s + touch) {
        let [p, q] = [pair.p, pair.q].map(|k| film.spheres[k as usize].aggregate);
        numbers[usize::from(p != q)] += 1;
    }
    numbers
}

#[cfg(test)]
mod tests;
