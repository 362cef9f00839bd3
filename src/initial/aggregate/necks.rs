//! The necks of an aggregate.

use super::{components, neighbouring};
use crate::case::section::words;
use crate::error::Error;
use crate::geometry::Sphere;
use crate::geometry::clusters::Clusters;
use crate::geometry::pairs_within;
use crate::interrupt::Interrupt;
use crate::random::Stream;

/// A neck between the `i`-th and the `j`-th sphere, `i < j`.
pub type Neck = (usize, usize);

/// The default for the largest gap of a neck, nm: enough for rounding.
pub const NECK_DISTANCE: f64 = 0.01;

/// Largest gap of touching spheres, relative to the sum of their radii: the rounding error of files in single precision.
const TOUCHING: f64 = 1e-6;

words! {
    /// The length of necks at rest.
    pub enum NeckLength {
        /// Necks are at rest where their spheres touch.
        Touching = "touching",
        /// Necks are at rest at the distance that their spheres have at the start, as between sintered particles; spheres that overlap, by any length, have necks too. Where two spheres that overlap have no neck,
        /// or theirs breaks, they repel each other only below that distance, until they have parted.
        AsGiven = "as-given",
    }
}

/// The pairs of spheres whose surfaces are less than `d_crit` (nm) apart or overlap by less, with necks as given by any length, in ascending order. If `acyclic`,
/// a neck between spheres that other necks already connect is omitted: the necks then form a forest. Spheres that touch come first, or one
/// that is merely near would be joined by a neck that begins stretched, in place of one that touches; with necks as given the deepest overlaps come first.
///
/// # Errors
///
/// [`Error::Interrupted`].
pub fn necks(
    spheres: &[Sphere],
    d_crit: f64,
    length: NeckLength,
    acyclic: bool,
    interrupt: &Interrupt,
) -> Result<Vec<Neck>, Error> {
    let gap = |&(i, j): &Neck| spheres[i].gap(&spheres[j]);
    let mut all: Vec<Neck> = pairs_within(spheres, |s, t| s + t + d_crit, interrupt)?;
    all.retain(|pair| gap(pair) < d_crit && (length == NeckLength::AsGiven || gap(pair) > -d_crit));
    if acyclic {
        let mut trees = Clusters::new(spheres.len(), []);
        let touch = |pair: &Neck| gap(pair).abs() < TOUCHING * (spheres[pair.0].radius + spheres[pair.1].radius);
        match length {
            NeckLength::Touching => all.sort_by_key(|pair| !touch(pair)),
            NeckLength::AsGiven => all.sort_by(|a, b| gap(a).total_cmp(&gap(b))),
        }
        all.retain(|&(i, j)| trees.join(i, j));
        all.sort_unstable();
    }
    Ok(all)
}

/// Largest distance of surfaces, nm, a gap or unless necks are as given an overlap, that the necks of a connected aggregate bridge if each bridges the smallest that it can.
/// None if the spheres are not connected.
fn joining_distance(spheres: &[Sphere], length: NeckLength, interrupt: &Interrupt) -> Result<Option<f64>, Error> {
    let distance = |&(i, j): &Neck| {
        let gap = spheres[i].gap(&spheres[j]);
        if length == NeckLength::AsGiven { gap.max(0.0) } else { gap.abs() }
    };
    let mut near = neighbouring(spheres, interrupt)?;
    near.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
    let mut trees = Clusters::new(spheres.len(), []);
    near.retain(|&(i, j)| trees.join(i, j));
    Ok((near.len() + 1 == spheres.len()).then(|| near.iter().map(distance).fold(0.0, f64::max)))
}

/// A remark if an aggregate has fewer necks than are needed to connect its spheres as they touch.
///
/// # Errors
///
/// [`Error::Interrupted`].
pub fn missing_necks(
    spheres: &[Sphere],
    made: usize,
    d_crit: f64,
    length: NeckLength,
    decimals: usize,
    interrupt: &Interrupt,
) -> Result<Option<String>, Error> {
    let expected = spheres.len() - components(spheres, interrupt)?;
    if made >= expected {
        return Ok(None);
    }
    let (across, farther) = match length {
        NeckLength::Touching => ("gaps and overlaps", "farther apart or overlap more"),
        NeckLength::AsGiven => ("gaps", "farther apart"),
    };
    let of = match decimals {
        0 => "; its coordinates are integers".to_string(),
        1 => "; its coordinates have one decimal".into(),
        2..=4 => format!("; its coordinates have {decimals} decimals"),
        _ => String::new(),
    };
    let remedy = joining_distance(spheres, length, interrupt)?.map_or(String::new(), |least| {
        // Rounded up to two digits.
        let digits = 1.0 - libm::floor(libm::log10(least));
        let (unit, places) = (libm::exp10(-digits), digits.max(0.0) as usize);
        let enough = ((least / unit * (1.0 + 1e-9)).floor() + 1.0) * unit;
        let rest = if length == NeckLength::AsGiven { "" } else { ", and are at rest with `neck_length: as-given`" };
        format!("; {across} up to {least:.3} nm are joined by `neck_distance: {enough:.places$} nm`{rest}")
    });
    Ok(Some(format!(
        "found {made} necks across {across} below {d_crit} nm, expected at least {expected}: {} spheres are connected only if those that are {farther} are joined too{of}{remedy}",
        spheres.len()
    )))
}

/// `floor(n * fraction)` of the `n` necks, in their order, a whole share not being lost to rounding: the others are removed one at a time, each time any one that is left
/// with the same probability.
pub fn keep_fraction(necks: &[Neck], fraction: f64, stream: &mut Stream) -> Vec<Neck> {
    let n = necks.len();
    // The fraction and the product are rounded by half of EPSILON each: 100 * 0.29 falls just short of 29.
    let share = n as f64 * fraction.clamp(0.0, 1.0) * (1.0 + 2.0 * f64::EPSILON);
    let kept = share.floor() as usize;
    // A tree of sums over those that are left finds the one of a given rank without moving the others: every place sums up as many as its lowest bit says.
    let lowest_bit = |place: usize| place & place.wrapping_neg();
    let mut sums: Vec<usize> = (0..=n).map(lowest_bit).collect();
    let mut is_left = vec![true; n];
    for left in (kept + 1..=n).rev() {
        let mut rank = (stream.uniform() * left as f64) as usize;
        let mut before = 0;
        for step in (0..=n.ilog2()).rev().map(|power| 1 << power) {
            if before + step <= n && sums[before + step] <= rank {
                before += step;
                rank -= sums[before];
            }
        }
        is_left[before] = false;
        let mut place = before + 1;
        while place <= n {
            sums[place] -= 1;
            place += lowest_bit(place);
        }
    }
    necks.iter().zip(is_left).filter_map(|(neck, is_left)| is_left.then_some(*neck)).collect()
}

#[cfg(test)]
mod tests {
    use super::NeckLength::{AsGiven, Touching};
    use super::*;
    use crate::spec::Vec3;
    use quickcheck::quickcheck;

    fn kept(necks: &[Neck], fraction: f64, seed: u64) -> Vec<Neck> {
        keep_fraction(necks, fraction, &mut Stream::new(seed, "neck removal"))
    }

    fn joined(spheres: &[Sphere], d_crit: f64, acyclic: bool) -> Vec<Neck> {
        necks(spheres, d_crit, Touching, acyclic, &Interrupt::default()).unwrap()
    }

    fn as_given(spheres: &[Sphere], d_crit: f64, acyclic: bool) -> Vec<Neck> {
        necks(spheres, d_crit, AsGiven, acyclic, &Interrupt::default()).unwrap()
    }

    fn missing(spheres: &[Sphere], made: usize, length: NeckLength) -> Option<String> {
        missing_necks(spheres, made, 0.01, length, 2, &Interrupt::default()).unwrap()
    }

    fn at(places: &[[f64; 3]]) -> Vec<Sphere> {
        places.iter().map(|&x| Sphere { centre: Vec3(x), radius: 1.0 }).collect()
    }

    #[test]
    fn a_neck_that_would_close_a_cycle_is_left_out_by_order_of_the_indices() {
        let triangle = at(&[[0.0; 3], [2.0, 0.0, 0.0], [1.0, 3f64.sqrt(), 0.0], [-2.1, 0.0, 0.0]]);
        assert_eq!(joined(&triangle, 0.05, false), [(0, 1), (0, 2), (1, 2)]);
        assert_eq!(joined(&triangle, 0.05, true), [(0, 1), (0, 2)]);
        assert_eq!(joined(&triangle, 0.2, true), [(0, 1), (0, 2), (0, 3)]);
    }

    #[test]
    fn spheres_that_touch_are_joined_before_those_that_are_merely_near() {
        let apex = [1.001, (4.0 - 1.001 * 1.001f64).sqrt(), 0.0];
        assert_eq!(joined(&at(&[[0.0; 3], [2.002, 0.0, 0.0], apex]), 0.01, true), [(0, 2), (1, 2)]);
    }

    #[test]
    fn necks_that_rounded_coordinates_lose_are_reported_with_their_remedy() {
        let chain = at(&[[0.0; 3], [2.0, 0.0, 0.0], [4.013, 0.0, 0.0], [5.99, 0.0, 0.0]]);
        assert_eq!(missing(&chain, 3, Touching), None);
        let remark = missing(&chain, joined(&chain, 0.01, true).len(), Touching).expect("two necks are missing");
        assert!(remark.starts_with("found 1 necks") && remark.contains("expected at least 3"), "{remark}");
        assert!(remark.contains("2 decimals") && remark.contains("`neck_distance: 0.024 nm`"), "{remark}");
        assert_eq!(joined(&chain, 0.024, true).len(), 3);
    }

    #[test]
    fn a_deep_overlap_is_no_neck() {
        let overlap = at(&[[0.0; 3], [1.5, 0.0, 0.0]]);
        assert!(joined(&overlap, 0.1, false).is_empty());
        // One of just the distance is none either, as a gap of just the distance is none.
        assert!(
            joined(&overlap, 0.5, false).is_empty() && joined(&at(&[[0.0; 3], [2.5, 0.0, 0.0]]), 0.5, false).is_empty()
        );
        assert_eq!(joined(&overlap, 0.51, false), [(0, 1)]);
    }

    #[test]
    fn a_remedy_has_two_digits_above_the_distance_and_is_told_in_words() {
        // Spheres so large that a wide gap is a small part of their diameter.
        let remark = |gap: f64, length, decimals| {
            let spheres = [0.0, 1e5 + gap].map(|x| Sphere { centre: Vec3([x, 0.0, 0.0]), radius: 5e4 });
            missing_necks(&spheres, 0, 0.001, length, decimals, &Interrupt::default()).unwrap().expect("no neck")
        };
        let begin = |length: &str, apart: &str, of: &str| {
            let only = format!("2 spheres are connected only if those that are {apart} are joined too{of}");
            format!("found 0 necks across {length} below 0.001 nm, expected at least 1: {only}")
        };
        for (gap, least, enough) in [
            (0.02, "0.020", "0.021"),
            (0.25, "0.250", "0.26"),
            (1.5, "1.500", "1.6"),
            (9.95, "9.950", "10.0"),
            (12.25, "12.250", "13"),
            (125.5, "125.500", "130"),
        ] {
            for (length, across, apart, end) in [
                (
                    Touching,
                    "gaps and overlaps",
                    "farther apart or overlap more",
                    ", and are at rest with `neck_length: as-given`",
                ),
                (AsGiven, "gaps", "farther apart", ""),
            ] {
                let rest = format!("; {across} up to {least} nm are joined by `neck_distance: {enough} nm`{end}");
                assert_eq!(remark(gap, length, 9), begin(across, apart, "") + &rest, "{gap}");
            }
        }
        for (decimals, of) in [
            (0, "; its coordinates are integers; gaps"),
            (1, "; its coordinates have one decimal; gaps"),
            (2, "; its coordinates have 2 decimals; gaps"),
            (4, "; its coordinates have 4 decimals; gaps"),
            (5, "too; gaps"),
        ] {
            assert!(remark(1.5, AsGiven, decimals).contains(of), "{decimals}");
        }
    }

    #[test]
    fn parts_that_are_far_apart_need_fewer_necks_and_have_no_remedy() {
        let spheres = at(&[[0.0; 3], [2.005, 0.0, 0.0], [9.0, 0.0, 0.0], [11.0, 0.0, 0.0]]);
        assert_eq!(missing(&spheres, 2, Touching), None);
        let remark = missing(&spheres, 1, Touching).expect("a neck is missing");
        assert!(remark.contains("expected at least 2: 4 spheres") && remark.ends_with("have 2 decimals"), "{remark}");
        // As given an overlap is no distance, however deep; touching it is one.
        let overlap = at(&[[0.0; 3], [1.5, 0.0, 0.0]]);
        let distance = |length| joining_distance(&overlap, length, &Interrupt::default()).unwrap();
        assert_eq!([distance(AsGiven), distance(Touching)], [Some(0.0), Some(0.5)]);
    }

    #[test]
    fn necks_are_in_ascending_order_and_the_shortest_ones_join() {
        assert_eq!(joined(&at(&[[0.0; 3], [2.005, 0.0, 0.0], [4.005, 0.0, 0.0]]), 0.01, true), [(0, 1), (1, 2)]);
        // Two spheres 2.015 apart, and one 2.001 from both.
        let height = (2.001f64.powi(2) - 1.0075f64.powi(2)).sqrt();
        let three = at(&[[-1.0075, 0.0, 0.0], [1.0075, 0.0, 0.0], [0.0, height, 0.0]]);
        let distance = joining_distance(&three, Touching, &Interrupt::default()).unwrap().expect("one part");
        assert!((distance - 0.001).abs() < 1e-12, "{distance}");
    }

    #[test]
    fn a_near_sphere_is_joined_after_one_that_touches_to_a_millionth() {
        // The first two are nearly in touch, the third is as far from both.
        let joined = |gap: f64| {
            let (half, side) = (1.0 + 1e-5, 2.0 + gap);
            let height = (side * side - half * half).sqrt();
            joined(&at(&[[-half, 0.0, 0.0], [half, 0.0, 0.0], [0.0, height, 0.0]]), 0.01, true)
        };
        for (gap, expected) in
            [(1e-6, [(0, 2), (1, 2)]), (-1e-6, [(0, 2), (1, 2)]), (3e-6, [(0, 1), (0, 2)]), (-3e-6, [(0, 1), (0, 2)])]
        {
            assert_eq!(joined(gap), expected, "{gap}");
        }
    }

    #[test]
    fn as_given_spheres_that_overlap_are_joined_by_any_length_the_deepest_first() {
        let row = at(&[[0.0; 3], [1.9, 0.0, 0.0], [0.95, 1.6, 0.0], [3.915, 0.0, 0.0]]);
        assert_eq!(as_given(&row, 0.1, false), [(0, 1), (0, 2), (1, 2), (1, 3)]);
        // The overlap of the first two is 0.1, those with the third are 0.14.
        assert_eq!(as_given(&row, 0.1, true), [(0, 2), (1, 2), (1, 3)]);
        assert_eq!(as_given(&row, 0.01, true), [(0, 2), (1, 2)]);
        let remark = missing(&row, 2, AsGiven).expect("a neck is missing");
        assert!(remark.contains("across gaps below") && remark.ends_with("`neck_distance: 0.016 nm`"), "{remark}");
    }

    #[test]
    fn every_neck_is_removed_equally_often() {
        let all: Vec<Neck> = (0..8).map(|i| (i, i + 1)).collect();
        let mut count = [0.0; 8];
        for seed in 0..4000 {
            for (i, _) in kept(&all, 0.5, seed) {
                count[i] += 1.0;
            }
        }
        // Five standard deviations of the binomial distribution.
        assert!(count.iter().all(|&k: &f64| (k - 2000.0).abs() < 5.0 * 1000f64.sqrt()), "{count:?}");
    }

    #[test]
    fn a_whole_share_is_not_lost_to_rounding() {
        let kept = |n: usize, fraction| kept(&vec![(0, 1); n], fraction, 1).len();
        assert_eq!([0.29, 0.57, 0.58].map(|fraction| kept(100, fraction)), [29, 57, 58]);
        assert_eq!([0.25, 0.5, 0.9].map(|fraction| kept(149, fraction)), [37, 74, 134]);
    }

    quickcheck! {
        fn the_same_are_removed_as_from_a_list(n: u8, percent: u8, seed: u64) -> bool {
            let mut list: Vec<Neck> = (0..usize::from(n)).map(|i| (i, i + 1)).collect();
            let left = kept(&list, f64::from(percent % 101) / 100.0, seed);
            let mut stream = Stream::new(seed, "neck removal");
            while list.len() > left.len() {
                list.remove((stream.uniform() * list.len() as f64) as usize);
            }
            left == list
        }

        fn the_floor_of_the_share_is_kept_in_order_and_repeatably(n: u8, percent: u8, seed: u64) -> bool {
            let all: Vec<Neck> = (0..usize::from(n)).map(|i| (i, i + 1)).collect();
            let fraction = f64::from(percent % 101) / 100.0;
            let left = kept(&all, fraction, seed);
            left.len() == usize::from(n) * usize::from(percent % 101) / 100
                && left.is_sorted()
                && left.iter().all(|neck| all.contains(neck))
                && left == kept(&all, fraction, seed)
        }
    }
}
