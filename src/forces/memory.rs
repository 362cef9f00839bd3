//! Contact memory carried from one neighbour list to the next.

use crate::system::Image;

/// The springs of the pairs that have any, found again by who the two spheres are.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Springs {
    /// Sorted by the ids of the spheres, the lower first, and the copy of the second.
    pairs: Vec<((u32, u32, Image), Vec<f64>)>,
}

impl Springs {
    /// Collects springs; those that are all zero need no entry.
    pub fn new(pairs: impl Iterator<Item = ((u32, u32, Image), Vec<f64>)>) -> Self {
        let mut pairs: Vec<_> = pairs.filter(|(_, numbers)| numbers.iter().any(|&s| s != 0.0)).collect();
        pairs.sort_by_key(|&(key, _)| key);
        Self { pairs }
    }

    /// The springs of a pair, if it has any.
    pub fn of(&self, key: (u32, u32, Image)) -> Option<&[f64]> {
        let place = self.pairs.binary_search_by_key(&key, |&(key, _)| key).ok()?;
        Some(&self.pairs[place].1)
    }
}
