//! A film from a file.

use super::Plan;
use crate::error::Error;
use crate::geometry::Sphere;
use crate::geometry::clusters::Clusters;
use crate::initial::aggregate::import::{Extras, Import, read_necks};
use crate::initial::aggregate::necks::Neck;
use crate::initial::film::column::Column;
use crate::initial::film::{Bonding, DepositedFilm, FilmSphere};
use crate::interrupt::Interrupt;
use crate::papers::titania::law::Law;
use crate::papers::titania::{check, imported};
use crate::system::System;

/// Height above the floor up to which spheres touch it, nm: enough for rounding.
const TOUCH: f64 = 0.01;

impl<M: Law> Plan<M> {
    /// The film of a file: bodies that touch the floor are fixed, the others begin with their momenta.
    pub(super) fn imported(&self, import: &Import, interrupt: &Interrupt) -> Result<System, Error> {
        // A film need not be one aggregate, and may hold together across the sides of the box.
        let (particles, extras) = imported::particles(&Import { disconnected: true, ..import.clone() }, interrupt)?;
        let [smallest, largest] = particles.iter().fold([f64::INFINITY, 0.0], |[a, b], p| [p.1.min(a), p.1.max(b)]);
        let mut found = Vec::new();
        check::step(&self.titania, [smallest, largest], ("experiment.spectroscopy.dt", &self.test.dt), &mut found);
        let (least, sides) = (Column::least_side(0.5 * largest), [&self.film.sides[0], &self.film.sides[1]]);
        if let Some(axis) = sides.iter().position(|side| side.value < least) {
            let what = format!("found `{}`, expected at least {least} nm for the largest particles", sides[axis]);
            found.push((format!("sample.film.sides[{axis}]"), what));
        }
        if let Some((key, what)) = found.into_iter().next() {
            return Err(Error::of_key(key, what));
        }
        let spheres: Vec<Sphere> = particles.iter().map(|&(centre, d)| Sphere { centre, radius: 0.5 * d }).collect();
        let necks = import.necks.as_ref().map(|file| read_necks(file, &spheres, interrupt)).transpose()?;
        let aggregates = aggregates(spheres.len(), &extras, necks.as_deref().unwrap_or(&[]));
        let count = aggregates.iter().max().map_or(0, |&last| last as usize + 1);
        let mut on_floor = vec![false; count];
        for (sphere, &aggregate) in spheres.iter().zip(&aggregates) {
            on_floor[aggregate as usize] |= sphere.centre.0[2] - sphere.radius <= TOUCH;
        }
        if !on_floor.contains(&true) {
            let lowest = spheres.iter().map(|s| s.centre.0[2] - s.radius).fold(f64::INFINITY, f64::min);
            let what = format!("the lowest sphere ends at z = {lowest} nm, expected one that touches the floor, z = 0");
            return Err(Error::input(&import.file, what));
        }
        let thickness = spheres.iter().map(|s| s.centre.0[2] + s.radius).fold(0.0, f64::max);
        let film = DepositedFilm {
            spheres: (particles.iter().zip(&aggregates))
                .map(|(&(centre, diameter), &aggregate)| FilmSphere { centre, diameter, aggregate })
                .collect(),
            on_floor,
            sides: sides.map(|side| side.value),
            thickness,
        };
        let mut system = film.system(M::BONDING, |d| self.titania.particle(d));
        if let (Bonding::Necks, Some(necks)) = (M::BONDING, necks) {
            // The floor is one body, in which no neck acts.
            let free = |&(i, j): &Neck| system.particles.body[i] == 0 || system.particles.body[j] == 0;
            system.necks = necks.into_iter().filter(free).map(|(i, j)| (i as u32, j as u32)).collect();
        }
        // Necks come aggregate by aggregate, whose spheres may stand anywhere in the file.
        system.necks.sort_unstable();
        imported::few_sizes(&import.file, &system)?;
        imported::move_all(&extras, &mut system);
        Ok(system)
    }
}

/// The aggregate of each sphere: its body, or what necks join; all others are aggregates of their own.
fn aggregates(number: usize, extras: &Extras, necks: &[Neck]) -> Vec<u32> {
    let of_bodies = extras
        .members()
        .into_iter()
        .flat_map(|members| members.windows(2).map(|pair| (pair[0], pair[1])).collect::<Vec<_>>());
    let mut clusters = Clusters::new(number, of_bodies.chain(necks.iter().copied()));
    let mut numbers = std::collections::BTreeMap::new();
    (0..number)
        .map(|sphere| {
            let next = numbers.len() as u32;
            *numbers.entry(clusters.root(sphere)).or_insert(next)
        })
        .collect()
}
