//! The largest stable time step of the four springs of a contact.

use super::four_springs::Springs;
use super::pair_frequency::slide_and_roll;
use super::reduced_mass::effective_mass;
use super::rotated_spring::lag_limit;
use super::stable_step::stable_time_step;

impl Springs<f64> {
    /// Largest stable time step of a solid sphere joined by these springs to an equal one, or to one of the same density and a radius up to `largest`,
    /// s.
    pub fn critical_time_step(&self, r: f64, m: f64, largest: f64) -> f64 {
        // Radii between the two need no shorter step.
        self.limit_of_pair(r, m, r).min(self.limit_of_pair(r, m, largest))
    }

    fn limit_of_pair(&self, r: f64, m: f64, other: f64) -> f64 {
        let ratio = other / r;
        let m_j = m * ratio * ratio * ratio;
        // A missing spring and dashpot limit no step, not even an infinite one.
        let of_step = |k: f64, eta: f64, dt: f64| if k + eta > 0.0 { k * dt * dt + 2.0 * eta * dt } else { 0.0 };
        let is_stable = |dt: f64| {
            let turn = |slide: f64, k: f64, eta: f64| slide_and_roll(slide, of_step(k, eta, dt), r, other, m, m_j);
            // A twist turns the spheres as rolling does, and nothing slides.
            turn(of_step(self.k_t, self.eta_t, dt), self.k_r, self.eta_r) <= 4.0
                && turn(0.0, self.k_o, self.eta_o) <= 4.0
        };
        let most = stable_time_step(effective_mass(m, m_j), self.k_n, self.eta_n);
        if is_stable(most) { most } else { bisected(most.min(f64::MAX), is_stable) }
    }

    /// Largest time step, s, at which none of them gains energy if they act before they are stretched: the normal spring never does.
    pub fn lag_limit(&self) -> f64 {
        [(self.k_t, self.eta_t), (self.k_r, self.eta_r), (self.k_o, self.eta_o)]
            .into_iter()
            .filter(|(k, _)| *k > 0.0)
            .map(|(k, eta)| lag_limit(k, eta))
            .fold(f64::INFINITY, f64::min)
    }
}

/// The largest number up to `most` for which a condition holds, if it then holds for all smaller ones.
fn bisected(most: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let (mut least, mut most) = (0.0, most);
    loop {
        let middle = 0.5 * (least + most);
        if middle <= least || middle >= most {
            return least;
        }
        if holds(middle) { least = middle } else { most = middle }
    }
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;

    fn springs([k_n, k_t, k_r, k_o]: [f64; 4], [eta_n, eta_t, eta_r, eta_o]: [f64; 4]) -> Springs<f64> {
        Springs { k_n, k_t, k_r, k_o, eta_n, eta_t, eta_r, eta_o }
    }

    proptest! {
        /// Lengths, masses and times in other units, down to those in which every stiffness is far below one.
        #[test]
        fn the_limit_does_not_depend_on_the_units(
            k in prop::array::uniform4(0.1..10.0), eta in prop::array::uniform4(0.0..3.0), largest in 1.0..4.0,
            mass in -40.0..40.0f64, time in -40.0..40.0f64, length in -10.0..10.0f64,
        ) {
            let (mass, time, length) = (mass.exp2(), time.exp2(), length.exp2());
            let here = springs(k, eta);
            let there = springs(k.map(|k| k * mass / (time * time)), eta.map(|eta| eta * mass / time));
            let limit = there.critical_time_step(length, mass, largest * length);
            prop_assert!(relative_eq!(limit, time * here.critical_time_step(1.0, 1.0, largest), max_relative = 1e-9));
            prop_assert!(relative_eq!(there.lag_limit(), time * here.lag_limit(), max_relative = 1e-9));
        }
    }

    #[test]
    fn each_spring_alone_limits_the_step() {
        // equal solid spheres of radius and mass 1: 1/m_eff = 2 for the normal, 7 for sliding, 5 for rolling and torsion
        for (spring, inverse) in [2.0f64, 7.0, 5.0, 5.0].into_iter().enumerate() {
            let mut k = [0.0; 4];
            k[spring] = 0.25;
            let limit = springs(k, [0.0; 4]).critical_time_step(1.0, 1.0, 1.0);
            assert!((limit - 2.0 / (0.25 * inverse).sqrt()).abs() < 1e-9 * limit, "{spring}: {limit}");
        }
        assert_eq!(springs([0.0; 4], [0.0; 4]).critical_time_step(1.0, 1.0, 1.0), f64::INFINITY);
    }

    #[test]
    fn each_dashpot_alone_limits_the_step() {
        // a dashpot that acts with the velocity of the step before turns it around at eta dt = m_eff, and makes it larger from twice that on
        for (spring, inverse) in [2.0f64, 7.0, 5.0, 5.0].into_iter().enumerate() {
            let mut eta = [0.0; 4];
            eta[spring] = 0.25;
            let limit = springs([0.0; 4], eta).critical_time_step(1.0, 1.0, 1.0);
            assert!((limit - 2.0 / (0.25 * inverse)).abs() < 1e-9 * limit, "{spring}: {limit}");
        }
    }

    #[test]
    fn a_sphere_of_three_times_the_radius_has_27_times_the_mass() {
        // times mass over stiffness: sliding 98/27, rolling and torsion 305/54, and between the first two 100/27
        let torsion = springs([0.0, 0.0, 0.0, 1.0], [0.0; 4]).critical_time_step(1.0, 1.0, 3.0);
        assert!((torsion - 2.0 / (305.0f64 / 54.0).sqrt()).abs() < 1e-9, "{torsion}");
        let both = springs([0.0, 1.0, 1.0, 0.0], [0.0; 4]).critical_time_step(1.0, 1.0, 3.0);
        assert!((both - 2.0 / ((501.0 + 171_881f64.sqrt()) / 108.0).sqrt()).abs() < 1e-9, "{both}");
    }

    #[test]
    fn the_weakest_dashpot_limits_the_lag() {
        let limits = |eta: [f64; 3]| springs([1.0; 4], [0.0, eta[0], eta[1], eta[2]]).lag_limit();
        for eta in [[0.3, 0.7, 0.9], [0.7, 0.3, 0.9], [0.7, 0.9, 0.3]] {
            assert_eq!(limits(eta), lag_limit(1.0, 0.3));
        }
        assert_eq!(springs([1.0, 0.0, 0.0, 0.0], [0.0; 4]).lag_limit(), f64::INFINITY);
    }
}
