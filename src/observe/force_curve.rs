//! The force on a tip, filtered by a cantilever.

use crate::spec::soot::def_filter::filter_step;
use serde::{Deserialize, Serialize};

/// A maximum counts as a peak if the reading falls by this part of its highest value on both sides before it rises above it.
const PROMINENT: f64 = 0.1;
/// Tip and sample have separated once the reading stays below this fraction of its largest value.
const PARTED: f64 = 0.05;

/// A force curve under way. Units: pN, nm, ns.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ForceCurve {
    omega_0: f64,
    force: f64,
    reading: f64,
    rate: f64,
    points: Vec<(f64, f64)>,
    /// The largest force, unfiltered, if any was positive.
    largest: Option<f64>,
}

impl ForceCurve {
    /// A cantilever at rest, of the natural angular frequency `omega_0`.
    pub fn new(omega_0: f64) -> Self {
        Self { omega_0, force: 0.0, reading: 0.0, rate: 0.0, points: Vec::new(), largest: None }
    }

    /// The force after a time step.
    pub fn follow(&mut self, force: f64, dt: f64) {
        (self.reading, self.rate) = filter_step(self.omega_0, dt, self.reading, self.rate, self.force, force);
        self.force = force;
        self.largest = self.largest.into_iter().chain([force]).filter(|&force| force > 0.0).reduce(f64::max);
    }

    /// The largest force in any step, unfiltered; none if there was no positive one.
    pub fn largest(&self) -> Option<f64> {
        self.largest
    }

    /// The present reading of the cantilever.
    pub fn reading(&self) -> f64 {
        self.reading
    }

    /// Records the reading at a displacement of the tip.
    pub fn look(&mut self, displacement: f64) {
        self.points.push((displacement, self.reading));
    }

    /// The curve, displacement and reading, since the reversal of the tip: what came before is the approach.
    pub fn retraction(&self) -> &[(f64, f64)] {
        let depth = |point: &(f64, f64)| point.0;
        let lowest = self.points.iter().map(depth).fold(f64::INFINITY, f64::min);
        &self.points[self.points.iter().position(|point| depth(point) == lowest).unwrap_or(0)..]
    }

    /// The largest reading during the retraction.
    pub fn highest(&self) -> f64 {
        self.retraction().iter().map(|point| point.1).fold(0.0, f64::max)
    }

    /// The peaks during the retraction, displacement and reading.
    pub fn peaks(&self) -> Vec<(f64, f64)> {
        let (points, least) = (self.retraction(), PROMINENT * self.highest());
        let reading = |k: usize| points[k].1;
        let falls = |k: usize, side: &mut dyn Iterator<Item = usize>| {
            let mut lowest = reading(k);
            for other in side {
                if reading(other) > reading(k) {
                    break;
                }
                lowest = lowest.min(reading(other));
            }
            reading(k) - lowest >= least
        };
        let is_peak = |k: &usize| {
            let rises = *k == 0 || reading(*k - 1) < reading(*k);
            rises && reading(*k) > 0.0 && falls(*k, &mut (0..*k).rev()) && falls(*k, &mut (*k + 1..points.len()))
        };
        (0..points.len()).filter(is_peak).map(|k| points[k]).collect()
    }

    /// The displacement at which tip and sample separated; none while they are attached.
    pub fn rupture(&self) -> Option<f64> {
        let points = self.retraction();
        let last = points.iter().rposition(|point| point.1.abs() > PARTED * self.highest())?;
        points.get(last + 1).map(|point| point.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(readings: &[f64]) -> ForceCurve {
        let points = readings.iter().enumerate().map(|(k, &reading)| (k as f64, reading)).collect();
        ForceCurve { points, ..ForceCurve::new(1.0) }
    }

    #[test]
    fn what_the_cantilever_reads_is_recorded_where_the_tip_is() {
        let mut curve = ForceCurve::new(1.0);
        for (displacement, force) in [(0.0, 0.0), (-1.0, 4.0), (-0.5, 6.0)] {
            curve.follow(force, 0.5);
            curve.look(displacement);
        }
        let [(lowest, pressed), (risen, now)] = curve.retraction() else { panic!("{:?}", curve.retraction()) };
        assert_eq!((*lowest, *risen, *now), (-1.0, -0.5, curve.reading()));
        assert!(*pressed > 0.0 && now > pressed);
    }

    #[test]
    fn the_teeth_of_a_saw_are_counted_and_ripples_are_not() {
        let saw = curve(&[-3.0, 0.0, 4.0, 10.0, 2.0, 5.0, 5.5, 5.2, 5.6, 1.0, 3.0, 0.2, 0.3, 0.1]);
        assert_eq!(saw.peaks(), [(3.0, 10.0), (8.0, 5.6), (10.0, 3.0)]);
        assert_eq!(saw.highest(), 10.0);
        assert_eq!(saw.rupture(), Some(11.0));
    }

    #[test]
    fn the_pull_on_a_tip_that_comes_is_no_tooth() {
        let points = vec![(0.0, 0.0), (-1.0, 20.0), (-2.0, 5.0), (-3.0, -4.0), (-2.0, 3.0), (-1.0, 10.0), (0.0, 0.0)];
        let curve = ForceCurve { points, ..ForceCurve::new(1.0) };
        assert_eq!((curve.highest(), curve.peaks()), (10.0, vec![(-1.0, 10.0)]));
    }

    #[test]
    fn a_sample_that_still_pulls_has_not_parted() {
        assert_eq!(curve(&[0.0, 4.0, 2.0, 3.0]).rupture(), None);
        assert_eq!(curve(&[]).peaks(), []);
        assert_eq!(curve(&[0.0, 0.0]).rupture(), None);
    }

    #[test]
    fn a_steady_force_is_read_in_the_end() {
        let mut curve = ForceCurve::new(0.44);
        (0..1000).for_each(|_| curve.follow(7.0, 0.1));
        assert!((curve.reading() - 7.0).abs() < 1e-9);
    }
}
