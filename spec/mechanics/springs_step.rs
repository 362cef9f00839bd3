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
