//! The attraction of a pair, composed of its equations.

use super::def_capillary::{angle_slope, capillary_force, capillary_slope, capillary_work};
use super::def_exact_meniscus::{exact_gap, exact_rupture, exact_slope, exact_work};
use super::def_meniscus::{angle_on, meniscus_gap, rupture};
use super::def_radius::effective_radius;
use super::eq03_attraction::attraction_along_normal;
use super::eq04_solvation::{solvation_force, solvation_integral, solvation_slope};
use crate::{Real, flat_struct};

/// The profile of the meniscus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meniscus {
    /// An arc of a circle, as in the earlier work that the paper refers to.
    Circular,
    /// The profile of constant curvature.
    Exact,
}

impl Meniscus {
    /// Distance of the layers and its slope at a half-filling angle.
    fn gap<R: Real>(self, r_eff: R, r_k: R, theta: R, beta: R) -> (R, R) {
        match self {
            Self::Circular => meniscus_gap(r_eff, r_k, theta, beta),
            Self::Exact => exact_gap(r_eff, r_k, theta, beta),
        }
    }
    /// Half-filling angle and distance at rupture.
    fn rupture<R: Real>(self, r_eff: R, r_k: R, theta: R) -> (R, R) {
        match self {
            Self::Circular => rupture(r_eff, r_k, theta),
            Self::Exact => exact_rupture(r_eff, r_k, theta),
        }
    }
}

/// Capillary and solvation force between two particles of given sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attraction<R> {
    /// The profile of the meniscus.
    pub meniscus: Meniscus,
    /// The numbers of the pair.
    pub pair: Attracted<R>,
}

flat_struct! {
    /// The constants of the attraction of a pair.
    pub struct Attracted {
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
    pub fn new(
        meniscus: Meniscus,
        core_i: R,
        core_j: R,
        h_w: R,
        gamma: R,
        r_k: R,
        theta: R,
        f_0: R,
        sigma: R,
        least: R,
    ) -> Self {
        let (covered_i, covered_j) = (core_i + h_w, core_j + h_w);
        let r_eff = effective_radius(covered_i, covered_j).0;
        let (beta_r, gap_r) = meniscus.rupture(r_eff, r_k, theta);
        let (cores, covered) = (core_i + core_j, covered_i + covered_j);
        let pair = Attracted { gamma, r_k, theta, cores, covered, r_eff, beta_r, gap_r, f_0, sigma, least };
        Self { meniscus, pair }
    }

    /// Distance of the centres at which the meniscus ruptures: beyond it there is no attraction.
    pub fn rupture(&self) -> R {
        self.pair.covered + self.pair.gap_r
    }

    /// Distance of the centres below which there is no solvation force.
    pub fn kink(&self) -> R {
        self.pair.cores + self.pair.least
    }

    fn beta(&self, d: R) -> R {
        self.angle(d - self.pair.covered)
    }

    /// Half-filling angle at a given distance of the layers.
    fn angle(&self, gap: R) -> R {
        let Attracted { r_eff, r_k, theta, beta_r, gap_r, .. } = self.pair;
        angle_on(theta, beta_r, gap_r, gap, |beta| self.meniscus.gap(r_eff, r_k, theta, beta))
    }

    /// Whether the solvation force acts at a given centre distance.
    fn solvated(&self, d: R) -> R::Mask {
        (d - self.pair.cores).ge(self.pair.least) & d.le(self.rupture())
    }

    /// Normal component of Eq. 3 at a given centre distance: negative, because it attracts.
    pub fn force(&self, d: R) -> R {
        let zero = R::zero();
        let f_cap = capillary_force(self.pair.gamma, self.pair.r_k, self.pair.r_eff, self.pair.theta, self.beta(d));
        // one core at the centre of coordinates, all of the sum of radii at the other
        let f_solv = solvation_force(self.pair.f_0, d, self.pair.cores, zero, self.pair.sigma);
        attraction_along_normal(f_cap, R::select(self.solvated(d), f_solv, zero))
    }

    /// Slope of the force; infinite at rupture.
    pub fn slope(&self, d: R) -> R {
        let zero = R::zero();
        let Attracted { gamma, r_k, r_eff, theta, .. } = self.pair;
        let capillary = match self.meniscus {
            Meniscus::Circular => capillary_slope(gamma, r_k, r_eff, theta, self.beta(d)),
            Meniscus::Exact => exact_slope(gamma, r_k, r_eff, theta, self.beta(d)),
        };
        let solvation = solvation_slope(self.pair.f_0, d - self.pair.cores, self.pair.sigma);
        // Eq. 3 is linear
        attraction_along_normal(
            R::select(d.le(self.rupture()), capillary, zero),
            R::select(self.solvated(d), solvation, zero),
        )
    }

    /// Energy at a given centre distance, zero beyond rupture.
    pub fn potential(&self, d: R) -> R {
        let Attracted { gamma, r_k, r_eff, theta, beta_r, .. } = self.pair;
        let work = match self.meniscus {
            Meniscus::Circular => capillary_work(gamma, r_k, r_eff, theta, self.beta(d), beta_r),
            Meniscus::Exact => exact_work(gamma, r_k, r_eff, theta, self.beta(d), beta_r),
        };
        let integral = |d: R| {
            let x = (d - self.pair.cores).max(self.pair.least);
            solvation_integral(self.pair.f_0, x, self.pair.sigma)
        };
        let energy = integral(d) - integral(self.rupture()) - work;
        R::select(d.lt(self.rupture()), energy, R::zero())
    }

    /// The force and its slope as functions of `u`, the square root of the distance remaining to rupture: smooth up to rupture.
    pub fn rooted(&self, u: R) -> (R, R) {
        let (two, zero) = (R::lit(2.0), R::zero());
        let d = self.rupture() - u.squared();
        let beta = self.angle(self.pair.gap_r - u.squared());
        let f_cap = capillary_force(self.pair.gamma, self.pair.r_k, self.pair.r_eff, self.pair.theta, beta);
        let f_solv = solvation_force(self.pair.f_0, d, self.pair.cores, zero, self.pair.sigma);
        // d beta / d u, and at rupture its limit, from the curvature of the distance against the angle
        let tilt = |beta: R| self.meniscus.gap(self.pair.r_eff, self.pair.r_k, self.pair.theta, beta).1;
        let h = self.pair.beta_r * R::lit(1e-4);
        let curvature = (tilt(self.pair.beta_r - h) - tilt(self.pair.beta_r + h)) / (two * h);
        let rate = R::select(u.gt(zero), -(two * u / tilt(beta)), (two / curvature).sqrt());
        let capillary = angle_slope(self.pair.gamma, self.pair.r_k, self.pair.r_eff, self.pair.theta, beta) * rate;
        let solvation = -(two * u * solvation_slope(self.pair.f_0, d - self.pair.cores, self.pair.sigma));
        (attraction_along_normal(f_cap, f_solv), attraction_along_normal(capillary, solvation))
    }
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::titania::Titania;
    use proptest::prelude::*;

    fn pair(d_i: f64, d_j: f64) -> Attraction<f64> {
        with(Meniscus::Circular, d_i, d_j)
    }

    fn with(meniscus: Meniscus, d_i: f64, d_j: f64) -> Attraction<f64> {
        let law = Titania { meniscus, ..Titania::paper(1.0, 1.0, 1.0) };
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
    fn it_begins_to_oscillate_at_the_kink_and_ends_at_the_rupture() {
        // numbers of few bits: distances at the kink and at the rupture are exact
        let pair = pair(8.0, 8.0);
        let gap_r = (pair.pair.gap_r * 1024.0 * 1024.0).floor() / 1024.0 / 1024.0;
        let of = Attracted { cores: 8.0, covered: 8.25, least: 0.25, gap_r, ..pair.pair };
        let pair = Attraction { pair: of, ..pair };
        let (kink, rupture) = (pair.kink(), pair.rupture());
        let solvation = solvation_force(of.f_0, kink, of.cores, 0.0, of.sigma);
        assert!(solvation.abs() > 0.1);
        assert!((pair.force(kink) - pair.force(kink.next_down()) + solvation).abs() < 1e-12);
        assert!((pair.slope(kink) - pair.slope(kink.next_down())).abs() > 0.1);
        let solvation = solvation_force(of.f_0, rupture, of.cores, 0.0, of.sigma);
        assert!(solvation.abs() > 1e-3 && (pair.force(rupture) - pair.rooted(0.0).0).abs() < 1e-4);
        assert_eq!([pair.force(rupture.next_up()), pair.slope(rupture.next_up())], [0.0; 2]);
        assert!(pair.slope(rupture).abs() > 1e3, "{}", pair.slope(rupture));
        assert_eq!(pair.potential(rupture), 0.0);
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

    #[test]
    fn an_exact_meniscus_attracts_more_and_reaches_farther() {
        let (circular, exact) = (pair(8.0, 8.0), with(Meniscus::Exact, 8.0, 8.0));
        for (d, f_cap, more) in [(8.0, 2.7389, 1.039), (8.7, 1.5683, 1.178), (8.88, 1.1578, 1.664)] {
            // the solvation force is the same
            let gained = exact.force(d) - circular.force(d);
            assert!((gained + f_cap * (1.0 - 1.0 / more)).abs() < 2e-3, "{d}: {gained}");
        }
        assert!((exact.rupture() - 9.002).abs() < 5e-4 && exact.force(9.0) < 0.0 && circular.force(9.0) == 0.0);
        // contact stiffness in GPa, pull-off force, rupture and work from the equilibrium on
        for (d, k_n, pull_off, beyond, work) in
            [(8.0, 29.488, -2.7086, 1.0019, 1.9327), (16.0, 37.518, -4.6461, 1.1337, 3.6212)]
        {
            let law = Titania { meniscus: Meniscus::Exact, ..Titania::paper(1.0, 1.0, 1.0) };
            let (r, pair) = (law.contact_radius(d), with(Meniscus::Exact, d, d));
            assert!((law.parameters(r, r, 1.0, 1.0).k_n - k_n).abs() < 1e-3, "{}", law.parameters(r, r, 1.0, 1.0).k_n);
            let at = law.equilibrium(r, r);
            assert!((pair.force(at + 0.26) - pull_off).abs() < 2e-4, "{}", pair.force(at + 0.26));
            assert!((pair.rupture() - at - beyond).abs() < 1e-4 && (pair.potential(at) + work).abs() < 1e-4);
        }
    }

    proptest! {
        #[test]
        fn the_force_is_minus_the_gradient_of_the_potential(exact in any::<bool>(), d_i in 3.0..23.0, d_j in 3.0..23.0, share in 0.01..0.99) {
            let meniscus = if exact { Meniscus::Exact } else { Meniscus::Circular };
            let (pair, h) = (with(meniscus, d_i, d_j), 1e-5);
            let d = pair.pair.cores + share * (pair.rupture() - pair.pair.cores);
            let gradient = (pair.potential(d + h) - pair.potential(d - h)) / (2.0 * h);
            prop_assert!((pair.force(d) + gradient).abs() < 1e-3, "{} {gradient}", pair.force(d));
        }

        #[test]
        fn the_slope_is_that_of_the_force(exact in any::<bool>(), d_i in 3.0..23.0, d_j in 3.0..23.0, share in 0.01..0.95) {
            let meniscus = if exact { Meniscus::Exact } else { Meniscus::Circular };
            let (pair, h) = (with(meniscus, d_i, d_j), 1e-7);
            let d = pair.kink() + 2.0 * h + share * (pair.rupture() - pair.kink());
            let central = (pair.force(d + h) - pair.force(d - h)) / (2.0 * h);
            prop_assert!((pair.slope(d) - central).abs() < 1e-4 * (1.0 + central.abs()), "{} {central}", pair.slope(d));
        }

        #[test]
        fn against_the_root_of_the_distance_it_is_smooth_up_to_the_rupture(exact in any::<bool>(), d_i in 3.0..23.0, d_j in 3.0..23.0, u in 0.0..1.0) {
            let meniscus = if exact { Meniscus::Exact } else { Meniscus::Circular };
            let (pair, h) = (with(meniscus, d_i, d_j), 1e-5);
            let central = (pair.rooted(u + h).0 - pair.rooted(u - h).0) / (2.0 * h);
            prop_assert!((pair.rooted(u).1 - central).abs() < 1e-3 || u < h);
            let forward = (pair.rooted(h).0 - pair.rooted(0.0).0) / h;
            prop_assert!((pair.rooted(0.0).1 - forward).abs() < 1e-2, "{} {forward}", pair.rooted(0.0).1);
        }
    }
}
