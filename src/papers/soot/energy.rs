//! The energy that springs hold at the start, beside the energies that an aggregate can take.

use super::case::{Deposition, SootStage};
use crate::case::units::BOLTZMANN;
use crate::error::Error;
use crate::geometry::{Sphere, pairs_within};
use crate::initial::aggregate::NEIGHBOURLY;
use crate::initial::aggregate::necks::{Neck, NeckLength};
use crate::interrupt::Interrupt;
use crate::spec::mechanics::four_springs::Memory;
use crate::spec::mechanics::kinetic_energy::translational_energy;
use crate::spec::mechanics::rotated_spring::Twist;
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::mechanics::thermal::thermal_energy;
use crate::spec::soot::{Reading, Soot};
use crate::spec::{Contact, Flat, PairModel, Vec3};
use crate::system::Springs;

/// The springs of a neck or a contact of spheres with this gap, nm, at the start.
fn at_start<O: Twist<f64>>(length: NeckLength, gap: f64) -> Memory<f64, O> {
    let rest = if length == NeckLength::AsGiven { gap } else { 0.0 };
    Memory { rest, ..Memory::zero() }
}

/// The springs of all necks and of all spheres that overlap, at the start.
pub(super) fn initial_springs<S: Reading>(length: NeckLength, spheres: &[Sphere], necks: &[Neck]) -> Springs {
    let width = Memory::<f64, S::Torsion<f64>>::LEN;
    let mut springs = Springs::new(width);
    if length == NeckLength::AsGiven {
        let pairs = near_or_joined(spheres, necks, &Interrupt::default()).expect("nothing asks to stop");
        for (i, j) in pairs {
            let gap = spheres[i].gap(&spheres[j]);
            if gap < 0.0 || necks.binary_search(&(i, j)).is_ok() {
                let memory: Memory<f64, S::Torsion<f64>> = at_start(length, gap);
                springs.add((i as u32, j as u32, [0; 3]), (0..width).map(|k| *memory.at(k)));
            }
        }
    }
    springs.sorted()
}

/// The pairs of spheres that touch, nearly so, or by a neck, in ascending order.
fn near_or_joined(spheres: &[Sphere], necks: &[Neck], interrupt: &Interrupt) -> Result<Vec<Neck>, Error> {
    let mut pairs = pairs_within(spheres, |r, s| (1.0 + NEIGHBOURLY) * (r + s), interrupt)?;
    pairs.extend(necks);
    pairs.sort_unstable();
    pairs.dedup();
    Ok(pairs)
}

/// Number of pairs between two questions whether to stop.
const ASKED: usize = 4096;

/// Room temperature, K.
const ROOM: f64 = 298.0;

/// Energies at the start, zJ.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct InitialEnergy {
    /// Held by the springs of necks and of contacts that overlap.
    pub stored: f64,
    /// Of the velocity of the deposition.
    pub kinetic: f64,
    /// Work that separates the spheres that touch.
    pub adhesion: f64,
    /// Of thermal motion.
    pub thermal: f64,
    /// Largest gap of a neck, nm.
    pub stretched: f64,
    /// Deepest overlap, nm.
    pub overlap: f64,
}

impl InitialEnergy {
    /// The energies of an aggregate.
    ///
    /// # Errors
    ///
    /// [`Error::Interrupted`].
    pub(super) fn of<S: Reading>(
        law: &Soot<S>,
        spheres: &[Sphere],
        (necks, length): (&[Neck], NeckLength),
        density: f64,
        stage: Option<&SootStage>,
        interrupt: &Interrupt,
    ) -> Result<Self, Error> {
        let mass = |sphere: &Sphere| sphere_mass(density, sphere.radius);
        let mut sums = Self::default();
        for (place, (i, j)) in near_or_joined(spheres, necks, interrupt)?.into_iter().enumerate() {
            if place.is_multiple_of(ASKED) {
                interrupt.check()?;
            }
            let (a, b) = (&spheres[i], &spheres[j]);
            let rest = Vec3::zero();
            let contact = Contact::new(a.centre - b.centre, rest, rest, rest, a.radius, b.radius);
            let is_neck = necks.binary_search(&(i, j)).is_ok();
            let free = law.coefficients(a.radius, b.radius, mass(a), mass(b));
            let coefficients = if is_neck { law.joined(free) } else { free };
            let held = law.stored(&contact, &coefficients, &at_start(length, contact.gap));
            sums.stored += held.necks + held.normal;
            sums.adhesion -= held.van_der_waals + held.capillary;
            sums.overlap = sums.overlap.max(-contact.gap);
            if is_neck {
                sums.stretched = sums.stretched.max(contact.gap);
            }
        }
        if let Some(SootStage::Deposition(Deposition { velocity, .. })) = stage {
            let v = Vec3([0.0, 0.0, velocity.value]);
            sums.kinetic = spheres.iter().map(|sphere| translational_energy(mass(sphere), v)).sum();
        }
        sums.thermal = spheres.len() as f64 * thermal_energy(BOLTZMANN, ROOM);
        Ok(sums)
    }

    /// Refuses an aggregate whose springs store more than a given multiple of the energy that it can absorb.
    ///
    /// # Errors
    ///
    /// The energies and the remedy.
    pub(super) fn allowed(&self, times: f64) -> Result<(), Error> {
        let Self { stored, kinetic, adhesion, thermal, stretched, overlap } = self;
        if *stored <= times * (kinetic + adhesion + thermal) {
            return Ok(());
        }
        let what = format!(
            "found springs that hold {stored:.3e} zJ at the start (overlaps up to {overlap:.3} nm, necks across gaps up to {stretched:.3} nm), expected at most {times} times the sum \
             of the kinetic energy {kinetic:.3e} zJ, the adhesion of the contacts {adhesion:.3e} zJ and the thermal energy {thermal:.3e} zJ, or the aggregate is thrown apart; \
             give spheres that touch, with more decimals, let necks be at rest as they are with `neck_length: as-given` and a suitable `neck_distance`, or raise `initial_energy`"
        );
        Err(Error::of_key("sample.aggregate", what))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::papers::parse;
    use crate::papers::soot::case::{Case, Experiment, Model};
    use crate::spec::soot::Along;
    use std::path::Path;

    /// A case of the published law with this experiment.
    fn case(experiment: &str) -> Case {
        let text = format!(
            "title: x\nmodel: {{soot: {{}}}}\nsample: {{aggregate: {{spheres: 2}}}}\nexperiment: {{{experiment}}}\n"
        );
        parse::<crate::papers::soot::Soot>(Path::new("x.yaml"), &text).expect("a case")
    }

    /// The published law without a coating.
    fn law() -> Soot {
        let Model::Soot(soot) = case("deposition: {}").model;
        let mut law = soot.law(Along);
        law.attraction.psi = 0.0;
        law
    }

    /// Spheres of radius 10 nm in a row with these gaps.
    fn row(gaps: &[f64]) -> Vec<Sphere> {
        let mut x = 0.0;
        let places = std::iter::once(0.0).chain(gaps.iter().map(|gap| {
            x += 20.0 + gap;
            x
        }));
        places.map(|x| Sphere { centre: Vec3([x, 0.0, 0.0]), radius: 10.0 }).collect()
    }

    fn energy(gaps: &[f64], necks: &[Neck], length: NeckLength, stage: Option<&SootStage>) -> InitialEnergy {
        let joined = (necks, length);
        InitialEnergy::of(&law(), &row(gaps), joined, 1.0, stage, &Interrupt::default()).expect("no interrupt")
    }

    #[test]
    fn spheres_interact_at_the_start_across_a_hundredth_of_their_distance_or_by_a_neck() {
        let of = |necks: &[Neck]| {
            near_or_joined(&row(&[0.19, 0.21, -0.5]), necks, &Interrupt::default()).expect("no interrupt")
        };
        assert_eq!(of(&[]), [(0, 1), (2, 3)]);
        assert_eq!(of(&[(0, 1), (1, 2)]), [(0, 1), (1, 2), (2, 3)]);
    }

    #[test]
    fn an_aggregate_absorbs_k_t_for_each_sphere_at_room_temperature() {
        let alone = energy(&[50.0], &[], NeckLength::Touching, None);
        let known = 2.0 * 1.380_649e-2 * 298.0;
        assert!((alone.thermal / known - 1.0).abs() < 1e-12, "{}", alone.thermal);
        assert_eq!(alone, InitialEnergy { thermal: alone.thermal, ..InitialEnergy::default() });
    }

    #[test]
    fn necks_store_energy_in_their_gap_unless_they_are_at_rest_as_given() {
        let stretched = |length| energy(&[0.1, 0.7, -0.3], &[(0, 1), (1, 2)], length, None);
        let (touching, as_given) = (stretched(NeckLength::Touching), stretched(NeckLength::AsGiven));
        let law = law();
        let known = 0.5 * (law.neck.k_n * (0.1f64.powi(2) + 0.7f64.powi(2)) + law.contact.k_n * 0.3f64.powi(2));
        assert!((touching.stored / known - 1.0).abs() < 1e-11, "{} {known}", touching.stored);
        assert_eq!(as_given.stored, 0.0);
        for found in [touching, as_given] {
            assert!((found.stretched - 0.7).abs() < 1e-13 && (found.overlap - 0.3).abs() < 1e-13);
        }
        let springs = |length| initial_springs::<Along>(length, &row(&[0.1, 0.7, -0.3]), &[(1, 2)]);
        assert_eq!([NeckLength::Touching, NeckLength::AsGiven].map(|length| springs(length).bonds().len()), [0, 2]);
    }

    #[test]
    fn adhesion_is_the_work_against_the_attraction_of_all_spheres_that_nearly_touch() {
        let adhesion = |gaps: &[f64]| energy(gaps, &[], NeckLength::Touching, None).adhesion;
        let [near, far] = [0.1, 0.15].map(|gap| adhesion(&[gap]));
        assert!(near > far && far > 0.0);
        assert!((adhesion(&[0.1, 0.15]) / (near + far) - 1.0).abs() < 1e-12);
        assert_eq!(adhesion(&[0.3]), 0.0);
    }

    #[test]
    fn deposited_spheres_have_the_energy_of_their_velocity() {
        let Experiment::Deposition(deposition) = case("deposition: {velocity: 3 m/s}").experiment else {
            panic!("a deposition")
        };
        let stage = SootStage::Deposition(deposition);
        let found = energy(&[50.0], &[], NeckLength::Touching, Some(&stage)).kinetic;
        // two spheres of density 1
        let known = 4.0 / 3.0 * std::f64::consts::PI * 1000.0 * 9.0;
        assert!((found / known - 1.0).abs() < 1e-12, "{found} {known}");
    }

    #[test]
    fn springs_may_store_a_multiple_of_what_an_aggregate_absorbs() {
        let found =
            InitialEnergy { stored: 12.0, kinetic: 1.0, adhesion: 2.0, thermal: 3.0, stretched: 0.5, overlap: 0.25 };
        assert!(found.allowed(2.0).is_ok());
        let refused = found.allowed(1.99).expect_err("too much").to_string();
        for part in ["1.200e1 zJ", "up to 0.250 nm", "up to 0.500 nm", "1.99 times", "1.000e0", "2.000e0", "3.000e0"] {
            assert!(refused.contains(part), "{refused}");
        }
    }
}
