//! The attraction of a pair, composed of its equations.

use super::def_capillary::{angle_slope, capillary_force, capillary_slope, capillary_work};
use super::def_meniscus::{angle, meniscus_gap, rupture};
use super::def_radius::effective_radius;
use super::eq03_attraction::attraction_along_normal;
use super::eq04_solvation::{solvation_force, solvation_integral, solvation_slope};
use crate::{Real, flat_struct};

flat_struct! {
    /// Capillary and solvation force between two particles of given sizes.
    pub struct Attraction {
        /// Surface tension, N/m.
        pub gamma,
        /// Kelvin radius, m.
        pub r_k,
        /// Contact angle, rad.
        pub theta,
        /// Sum of the bare radii, m.
        pub cores,
        /// Sum of the radii with the free water layer, m.
        pub covered,
        /// Harmonic mean of the radii with the free water layer, m.
        pub r_eff,
        /// Half-filling angle at rupture, rad.
        pub beta_r,
        /// Distance of the layers at rupture, m.
        pub gap_r,
        /// Amplitude of the solvation force as Eq. 3 takes it, positive when it attracts, N.
        pub f_0,
        /// Period and decay length of the solvation force, m.
        pub sigma,
        /// Distance of the bare surfaces below which there is no solvation force, m.
        pub least,
    }
}

impl<R: Real> Attraction<R> {
    /// The attraction between particles of bare radii `core_i` and `core_j` under a layer of thickness `h_w`, with a solvation force of amplitude `f_0`,
    /// positive when it attracts, that acts where the bare surfaces are at least `least` apart.
    pub fn new(core_i: R, core_j: R, h_w: R, gamma: R, r_k: R, theta: R, f_0: R, sigma: R, least: R) -> Self {
        let (covered_i, covered_j) = (core_i + h_w, core_j + h_w);
        let r_eff = effective_radius(covered_i, covered_j).0;
        let (beta_r, gap_r) = rupture(r_eff, r_k, theta);
        let (cores, covered) = (core_i + core_j, covered_i + covered_j);
        Self { gamma, r_k, theta, cores, covered, r_eff, beta_r, gap_r, f_0, sigma, least }
    }

    /// Distance of the centres at which the meniscus ruptures: beyond it there is no attraction.
    pub fn rupture(&self) -> R {
        self.covered + self.gap_r
    }

    /// Distance of the centres below which there is no solvation force.
    pub fn kink(&self) -> R {
        self.cores + self.least
    }

    fn beta(&self, d: R) -> R {
        angle(self.r_eff, self.r_k, self.theta, self.beta_r, self.gap_r, d - self.covered)
    }

    /// Whether the solvation force acts at a given centre distance.
    fn solvated(&self, d: R) -> R::Mask {
        (d - self.cores).ge(self.least) & d.le(self.rupture())
    }

    /// Normal component of Eq. 3 at a given centre distance: negative, because it attracts.
    pub fn force(&self, d: R) -> R {
        let zero = R::zero();
        let f_cap = capillary_force(self.gamma, self.r_k, self.r_eff, self.theta, self.beta(d));
        // one core at the centre of coordinates, all of the sum of radii at the other
        let f_solv = solvation_force(self.f_0, d, self.cores, zero, self.sigma);
        attraction_along_normal(f_cap, R::select(self.solvated(d), f_solv, zero))
    }

    /// Slope of the force; infinite at rupture.
    pub fn slope(&self, d: R) -> R {
        let zero = R::zero();
        let capillary = capillary_slope(self.gamma, self.r_k, self.r_eff, self.theta, self.beta(d));
        let solvation = solvation_slope(self.f_0, d - self.cores, self.sigma);
        // Eq. 3 is linear
        attraction_along_normal(
            R::select(d.le(self.rupture()), capillary, zero),
            R::select(self.solvated(d), solvation, zero),
        )
    }

    /// Energy at a given centre distance, zero beyond rupture.
    pub fn potential(&self, d: R) -> R {
        let work = capillary_work(self.gamma, self.r_k, self.r_eff, self.theta, self.beta(d), self.beta_r);
        let integral = |d: R| {
            let x = (d - self.cores).max(self.least);
            solvation_integral(self.f_0, x, self.sigma)
        };
        let energy = integral(d) - integral(self.rupture()) - work;
        R::select(d.lt(self.rupture()), energy, R::zero())
    }

    /// The force and its slope as functions of `u`, the square root of the distance remaining to rupture: smooth up to rupture.
    pub fn rooted(&self, u: R) -> (R, R) {
        let (two, zero) = (R::lit(2.0), R::zero());
        let d = self.rupture() - u.squared();
        let beta = angle(self.r_eff, self.r_k, self.theta, self.beta_r, self.gap_r, self.gap_r - u.squared());
        let f_cap = capillary_force(self.gamma, self.r_k, self.r_eff, self.theta, beta);
        let f_solv = solvation_force(self.f_0, d, self.cores, zero, self.sigma);
        // d beta / d u, and at rupture its limit, from the curvature of the distance against the angle
        let tilt = |beta: R| meniscus_gap(self.r_eff, self.r_k, self.theta, beta).1;
        let h = self.beta_r * R::lit(1e-4);
        let curvature = (tilt(self.beta_r - h) - tilt(self.beta_r + h)) / (two * h);
        let rate = R::select(u.gt(zero), -(two * u / tilt(beta)), (two / curvature).sqrt());
        let capillary = angle_slope(self.gamma, self.r_k, self.r_eff, self.theta, beta) * rate;
        let solvation = -(two * u * solvation_slope(self.f_0, d - self.cores, self.sigma));
        (attraction_along_normal(f_cap, f_solv), attraction_along_normal(capillary, solvation))
    }
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::titania::Titania;
    use proptest::prelude::*;

    fn pair(d_i: f64, d_j: f64) -> Attraction<f64> {
        let law = Titania::paper(1.0, 1.0, 1.0);
        law.attraction(law.contact_radius(d_i), law.contact_radius(d_j))
    }

    #[test]
    fn the_worked_example_of_two_particles_of_4_nanometre() {
        let pair = pair(8.0, 8.0);
        let rows = [
            (7.8, 2.93791, -0.25557),
            (7.9, 2.78909, -0.15875),
            (8.0, 2.63570, 0.29361),
            (8.15, 2.39568, 0.58197),
            (8.5, 1.76926, -0.10080),
            (8.7, 1.33107, -0.04498),
            (8.88, 0.69568, -0.01650),
        ];
        for (d, f_cap, f_solv) in rows {
            assert!((pair.force(d) - (f_solv - f_cap)).abs() < 3e-5, "{d}: {}", pair.force(d));
        }
        assert!((pair.rupture() - 8.889).abs() < 1e-4);
        assert_eq!(pair.force(8.8890), 0.0);
    }

    #[test]
    fn the_pull_off_forces_and_the_work_of_separation() {
        for (d_i, d_j, pull_off, at, work) in
            [(8.0, 8.0, -2.570, 8.26, 1.521), (16.0, 16.0, -4.456, 16.26, 2.959), (8.0, 20.0, -3.651, 14.26, 2.416)]
        {
            let pair = pair(d_i, d_j);
            // the authors' program takes both from a table of linear pieces
            assert!((pair.force(at) - pull_off).abs() < 8e-3, "{}", pair.force(at));
            let d = 0.5 * (d_i + d_j);
            let repulsion = -0.4 * 0.15 * pair.force(d);
            assert!((-pair.potential(d) - repulsion - work).abs() < 1e-2, "{}", pair.potential(d));
        }
    }

    proptest! {
        #[test]
        fn the_force_is_minus_the_gradient_of_the_potential(d_i in 3.0..23.0, d_j in 3.0..23.0, share in 0.01..0.99) {
            let (pair, h) = (pair(d_i, d_j), 1e-5);
            let d = pair.cores + share * (pair.rupture() - pair.cores);
            let gradient = (pair.potential(d + h) - pair.potential(d - h)) / (2.0 * h);
            prop_assert!((pair.force(d) + gradient).abs() < 1e-3, "{} {gradient}", pair.force(d));
        }

        #[test]
        fn the_slope_is_that_of_the_force(d_i in 3.0..23.0, d_j in 3.0..23.0, share in 0.01..0.95) {
            let (pair, h) = (pair(d_i, d_j), 1e-7);
            let d = pair.kink() + 2.0 * h + share * (pair.rupture() - pair.kink());
            let central = (pair.force(d + h) - pair.force(d - h)) / (2.0 * h);
            prop_assert!((pair.slope(d) - central).abs() < 1e-4 * (1.0 + central.abs()), "{} {central}", pair.slope(d));
        }

        #[test]
        fn against_the_root_of_the_distance_it_is_smooth_up_to_the_rupture(d_i in 3.0..23.0, d_j in 3.0..23.0, u in 0.0..1.0) {
            let (pair, h) = (pair(d_i, d_j), 1e-5);
            let central = (pair.rooted(u + h).0 - pair.rooted(u - h).0) / (2.0 * h);
            prop_assert!((pair.rooted(u).1 - central).abs() < 1e-3 || u < h);
            let forward = (pair.rooted(h).0 - pair.rooted(0.0).0) / h;
            prop_assert!((pair.rooted(0.0).1 - forward).abs() < 1e-2, "{} {forward}", pair.rooted(0.0).1);
        }
    }
}
