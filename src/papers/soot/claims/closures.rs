//! The loops that close when an aggregate restructures: new contacts, and how far apart along the aggregate their spheres were.

use crate::error::Error;
use crate::geometry::Sphere;
use crate::initial::aggregate::neighbouring;
use crate::interrupt::Interrupt;
use std::collections::{BTreeSet, VecDeque};

/// A pair of spheres that touch at the end and did not at the beginning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Closure {
    /// Number of initial contacts between the two, along the aggregate.
    pub(super) contacts: f64,
    /// Time from which they touch, of the frames.
    pub(super) time: f64,
}

/// The closures of a sequence of states with their times, by the criterion of Eq. 26. Pairs that were never connected are left out.
///
/// # Errors
///
/// [`Error::Interrupted`].
pub(super) fn closures(states: &[(f64, Vec<Sphere>)], interrupt: &Interrupt) -> Result<Vec<Closure>, Error> {
    let touching = |spheres: &[Sphere]| Ok(neighbouring(spheres, interrupt)?.into_iter().collect::<BTreeSet<_>>());
    let all: Vec<BTreeSet<(usize, usize)>> =
        states.iter().map(|(_, spheres)| touching(spheres)).collect::<Result<_, Error>>()?;
    let (Some(first), Some(last)) = (all.first(), all.last()) else { return Ok(Vec::new()) };
    let number = states[0].1.len();
    let mut beside = vec![Vec::new(); number];
    for &(i, j) in first {
        beside[i].push(j);
        beside[j].push(i);
    }
    let from: Vec<Vec<Option<u32>>> = (0..number).map(|start| contacts_from(start, &beside)).collect();
    let closure = |pair: &(usize, usize)| {
        let since = all.iter().rposition(|touching| !touching.contains(pair)).map_or(0, |before| before + 1);
        Some(Closure { contacts: from[pair.0][pair.1]?.into(), time: states[since].0 })
    };
    Ok(last.difference(first).filter_map(closure).collect())
}

/// Number of contacts from one sphere to each other along the aggregate.
fn contacts_from(start: usize, beside: &[Vec<usize>]) -> Vec<Option<u32>> {
    let mut found = vec![None; beside.len()];
    let mut queue = VecDeque::from([(start, 0)]);
    while let Some((sphere, contacts)) = queue.pop_front() {
        if found[sphere].is_none() {
            found[sphere] = Some(contacts);
            queue.extend(beside[sphere].iter().map(|next| (*next, contacts + 1)));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::Vec3;

    fn spheres(places: &[[f64; 2]]) -> Vec<Sphere> {
        places.iter().map(|&[x, y]| Sphere { centre: Vec3([x, y, 0.0]), radius: 1.0 }).collect()
    }

    #[test]
    fn a_chain_that_folds_closes_loops_of_their_lengths_at_their_times() {
        let straight = spheres(&[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [6.0, 0.0]]);
        let bent = spheres(&[[0.0, 0.0], [2.0, 0.0], [1.0, 3f64.sqrt()], [3.0, 3.0]]);
        let folded = spheres(&[[0.0, 0.0], [2.0, 0.0], [1.0, 3f64.sqrt()], [-1.0, 3f64.sqrt()]]);
        let found = closures(&[(0.0, straight), (1.0, bent), (2.0, folded)], &Interrupt::default()).expect("no stop");
        let closure = |contacts, time| Closure { contacts, time };
        assert_eq!(found, [closure(2.0, 1.0), closure(3.0, 2.0)]);
    }

    #[test]
    fn a_contact_counts_from_when_it_lasts() {
        let (apart, together) =
            (spheres(&[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0]]), [[0.0, 0.0], [2.0, 0.0], [1.0, 1.7321]]);
        let states =
            [0.0, 1.0, 2.0, 3.0].map(|time| (time, if time % 2.0 < 1.0 { apart.clone() } else { spheres(&together) }));
        let found = closures(&states, &Interrupt::default()).expect("no stop");
        assert_eq!(found, [Closure { contacts: 2.0, time: 3.0 }]);
    }
}
