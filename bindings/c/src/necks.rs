//! Necks that break, as the engine breaks them.

use crate::error::{Done, wrong};
use crate::law::width;
use crate::list::Pairs;
use crate::spheres::Spheres;
use veridem_spec::{Flat, PairModel};

/// The pairs whose necks are loaded beyond their strength.
pub(crate) fn overloaded<'a, M: PairModel>(pairs: &'a mut Pairs<M>, spheres: &Spheres) -> Done<&'a [u32]> {
    pairs.prepare(spheres)?;
    let mut found = std::mem::take(&mut pairs.overloaded);
    found.clear();
    if let Some(breaks) = &pairs.breaks {
        for pair in (0..pairs.i.len()).filter(|pair| pairs.history[pair * width::<M>()] > 0.5) {
            let (contact, memory) = (pairs.contact(spheres, pair), pairs.memory(pair));
            if breaks(&pairs.model, &contact, &memory, &pairs.stored(&contact, pair, &memory)) {
                found.push(pair as u32);
            }
        }
    }
    pairs.overloaded = found;
    Ok(&pairs.overloaded)
}

/// Breaks the necks of some pairs; returns the energy that they held, less that of the contacts that take their place.
pub(crate) fn break_necks<M: PairModel>(pairs: &mut Pairs<M>, spheres: &Spheres, broken: &[u32]) -> Done<f64> {
    pairs.prepare(spheres)?;
    let mut lost = 0.0;
    for &pair in broken {
        let pair = pair as usize;
        if pair >= pairs.i.len() || pairs.history[pair * width::<M>()] <= 0.5 {
            return wrong(format!("the pair {pair} has no neck"));
        }
        let (i, j) = (pairs.i[pair] as usize, pairs.j[pair] as usize);
        let (share, contact) = (pairs.share(spheres, pair), pairs.contact(spheres, pair));
        let held = |pairs: &Pairs<M>| {
            let stored = pairs.stored(&contact, pair, &pairs.memory(pair));
            (0..M::Stored::<f64>::LEN).map(|k| *stored.at(k)).sum::<f64>()
        };
        let before = held(pairs);
        let left = M::left_by_neck(pairs.memory(pair));
        let of_pair = &mut pairs.history[pair * width::<M>()..][..width::<M>()];
        of_pair[0] = 0.0;
        of_pair[1..].iter_mut().enumerate().for_each(|(k, number)| *number = *left.at(k));
        let [of_i, of_j] = [i, j].map(|p| (spheres.radius[p], spheres.mass[p]));
        pairs.constants[pair] = pairs.model.coefficients(of_i.0, of_j.0, of_i.1, of_j.1);
        lost += share * (before - held(pairs));
    }
    Ok(lost)
}
