//! How far two frames are apart.

use super::ReadFrame;
use serde::Serialize;
use std::collections::BTreeMap;

/// The largest difference between the numbers of a column in two frames.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Apart {
    /// The column.
    pub column: String,
    /// Its largest difference, in its unit.
    pub difference: f64,
    /// Its largest number.
    pub largest: f64,
    /// The sphere that differs most.
    pub sphere: usize,
}

impl Apart {
    /// Whether the numbers differ by more than this fraction of the largest.
    pub fn is_beyond(&self, fraction: f64) -> bool {
        self.difference.is_nan() || self.difference > fraction * self.largest
    }
}

impl ReadFrame {
    /// Its spheres by id; by place, if it has no ids.
    fn by_id(&self) -> BTreeMap<usize, usize> {
        let ids = self.property("id").map(|ids| &ids.numbers);
        (0..self.count).map(|place| (ids.map_or(place, |ids| ids[place] as usize), place)).collect()
    }

    /// The columns of numbers that both frames have, sphere by sphere. Centres may be in different copies of a periodic box.
    ///
    /// # Errors
    ///
    /// If they are not frames of the same spheres.
    pub fn apart(&self, other: &Self) -> Result<Vec<Apart>, String> {
        let (ours, theirs) = (self.by_id(), other.by_id());
        if ours.len() != theirs.len() {
            return Err(format!("found {} and {} spheres", ours.len(), theirs.len()));
        }
        if let Some(id) = ours.keys().find(|id| !theirs.contains_key(id)) {
            return Err(format!("found the sphere {id} in one of the frames only"));
        }
        let boxed = if self.periodic == [false; 3] { other } else { self };
        let both = self.properties.iter().filter(|property| !property.whole);
        let both = both
            .filter_map(|a| Some((a, other.property(&a.name).filter(|b| !b.whole && b.components == a.components)?)));
        let of_column = |(a, b): (&super::Property, &super::Property)| {
            let mut apart = Apart { column: a.name.clone(), difference: 0.0, largest: 0.0, sphere: 0 };
            for (&id, &place) in &ours {
                for k in 0..a.components {
                    let [one, two] = [(a, place), (b, theirs[&id])].map(|(of, at)| of.numbers[at * a.components + k]);
                    let mut way = one - two;
                    if a.name == "pos" && boxed.periodic[k] {
                        way -= boxed.sides[k] * (way / boxed.sides[k]).round();
                    }
                    apart.largest = apart.largest.max(one.abs()).max(two.abs());
                    if way.is_nan() || way.abs() > apart.difference {
                        (apart.difference, apart.sphere) = (way.abs(), id);
                    }
                }
            }
            apart
        };
        Ok(both.map(of_column).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::Property;

    fn frame(ids: &[f64], centres: &[f64], whole: bool) -> ReadFrame {
        let property = |name: &str, whole, components, numbers: &[f64]| Property {
            name: name.into(),
            whole,
            components,
            numbers: numbers.into(),
        };
        ReadFrame {
            count: ids.len(),
            sides: [10.0; 3],
            periodic: [true, false, false],
            properties: vec![property("id", true, 1, ids), property("pos", whole, 3, centres)],
            ..ReadFrame::default()
        }
    }

    #[test]
    fn spheres_are_compared_by_id_and_centres_over_the_sides_of_the_box() {
        let one = frame(&[4.0, 2.0], &[9.0, 1.0, 1.0, 5.0, 2.0, 3.0], false);
        let two = frame(&[2.0, 4.0], &[5.0, 2.0, 2.5, -1.0, 1.0, 1.25], false);
        let found = one.apart(&two).expect("the same spheres");
        assert_eq!(found, [Apart { column: "pos".into(), difference: 0.5, largest: 9.0, sphere: 2 }]);
        assert!(found[0].is_beyond(0.05) && !found[0].is_beyond(0.06));
        assert!(one.apart(&frame(&[2.0, 3.0], &[0.0; 6], false)).is_err());
        assert!(one.apart(&frame(&[2.0], &[0.0; 3], false)).is_err());
        assert_eq!(one.apart(&frame(&[2.0, 4.0], &[0.0; 6], true)).map(|found| found.len()), Ok(0));
    }
}
