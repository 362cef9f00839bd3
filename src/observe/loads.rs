//! The loads on every sphere, and the pairs that exert them.

use super::stress::of_sphere;
use crate::simulation::Simulation;
use crate::spec::{Contact, Flat, PairModel, Vec3};

/// The kind of a pair that acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PairKind {
    /// Two spheres in contact.
    Contact = 1,
    /// Two spheres joined by a neck.
    Neck = 2,
    /// Two spheres joined by a meniscus, which do not touch.
    Meniscus = 3,
}

/// A pair that acts, as a frame holds it.
#[derive(Clone, Debug, PartialEq)]
pub struct ActingPair {
    /// Ids, the lower first.
    pub ids: [u32; 2],
    /// Its kind.
    pub kind: PairKind,
    /// Centre of the sphere with the lower id, nm.
    pub centre: Vec3<f64>,
    /// From the centre of the sphere with the higher id to the other, nm.
    pub branch: Vec3<f64>,
    /// Distance of the surfaces, nm: negative for an overlap.
    pub gap: f64,
    /// Force on the sphere with the lower id, pN.
    pub force: Vec3<f64>,
    /// Its component along the line of centres, pN: positive for a repulsion.
    pub normal_force: f64,
    /// Energy stored in the pair, zJ.
    pub energy: f64,
    /// The springs of the contact.
    pub springs: Vec<f64>,
}

/// The loads on the spheres in the next step, by place, and the pairs by ids.
#[derive(Clone, Debug, Default)]
pub struct Loads {
    /// Force of pairs and surfaces, pN.
    pub force: Vec<Vec3<f64>>,
    /// Torque of pairs and surfaces, pN nm.
    pub torque: Vec<Vec3<f64>>,
    /// Number of contacts and necks.
    pub coordination: Vec<u32>,
    /// Number of necks.
    pub necks: Vec<u32>,
    /// Stress by the contact forces, MPa, tension positive: xx, yy, zz, xy, xz, yz.
    pub stress: Vec<[f64; 6]>,
    /// The pairs that have a kind.
    pub pairs: Vec<ActingPair>,
}

impl Loads {
    /// The loads now; `kind` tells the kind of a pair that no neck joins, if it has one.
    pub fn of<M: PairModel>(simulation: &Simulation<M>, kind: impl Fn(&Contact<f64>) -> Option<PairKind>) -> Self {
        let (particles, necks) = (&simulation.system().particles, &simulation.system().necks);
        let n = particles.len();
        let mut loads = Self {
            force: vec![Vec3::zero(); n],
            torque: vec![Vec3::zero(); n],
            coordination: vec![0; n],
            necks: vec![0; n],
            stress: vec![[0.0; 6]; n],
            pairs: Vec::new(),
        };
        for pair in simulation.pairs() {
            let (i, j, wrench) = (pair.i, pair.j, pair.outcome.wrench);
            let Contact { n, gap, r_i, r_j, .. } = pair.contact;
            loads.enter(i, (wrench.force, wrench.torque_i), -n * (r_i + 0.5 * gap), r_i);
            loads.enter(j, (-wrench.force, wrench.torque_j), n * (r_j + 0.5 * gap), r_j);
            let ids = [particles.id[i], particles.id[j]];
            let neck = necks.binary_search(&(ids[0], ids[1])).is_ok();
            let Some(kind) = (if neck { Some(PairKind::Neck) } else { kind(&pair.contact) }) else { continue };
            for p in [i, j] {
                loads.coordination[p] += u32::from(kind != PairKind::Meniscus);
                loads.necks[p] += u32::from(kind == PairKind::Neck);
            }
            loads.pairs.push(ActingPair {
                ids,
                kind,
                centre: particles.x[i],
                branch: pair.branch,
                gap: pair.contact.gap,
                force: wrench.force,
                normal_force: wrench.force.dot(pair.contact.n),
                energy: (0..M::Stored::<f64>::LEN).map(|k| *pair.stored.at(k)).sum(),
                springs: (0..M::Memory::<f64>::LEN).map(|k| *pair.memory.at(k)).collect(),
            });
        }
        simulation.each_load_by_surfaces(|p, arm, load| loads.enter(p, load, arm, particles.radius[p]));
        loads.pairs.sort_by_key(|pair| pair.ids);
        loads
    }

    /// Adds a load that acts on a sphere at the end of an arm.
    fn enter(&mut self, p: usize, (force, torque): (Vec3<f64>, Vec3<f64>), arm: Vec3<f64>, radius: f64) {
        self.force[p] = self.force[p] + force;
        self.torque[p] = self.torque[p] + torque;
        for (sum, part) in self.stress[p].iter_mut().zip(of_sphere(radius, arm, force)) {
            *sum += part;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulation::Settings;
    use crate::spec::titania::Titania;
    use crate::system::System;

    #[test]
    fn necks_and_contacts_of_a_sphere_are_counted_and_menisci_are_not() {
        let law = Titania::paper(1.0, 1.0, 1.0);
        let radius = law.contact_radius(8.0);
        let touching = 1.99 * radius;
        // A row of four, the first three joined by necks, and a sphere beside the third with a meniscus.
        let row = (0..4).map(|k| [touching * f64::from(k), 0.0, 0.0]).chain([[2.0 * touching, 2.01 * radius, 0.0]]);
        let spheres = row.fold(System::builder(), |system, x| system.sphere(x, radius, 1.0));
        let system = System { necks: vec![(0, 1), (1, 2)], ..spheres.build().expect("five spheres") };
        let simulation = Simulation::new(law, system, Settings::new(1e-4).skin(1.0)).expect("a stable step");
        let kind = |contact: &Contact<f64>| {
            let kind = if contact.gap < 0.0 { PairKind::Contact } else { PairKind::Meniscus };
            (contact.gap < 0.5).then_some(kind)
        };
        let loads = Loads::of(&simulation, kind);
        let by_id =
            |counts: &[u32]| simulation.system().particles.by_id().iter().map(|&p| counts[p]).collect::<Vec<_>>();
        assert_eq!(by_id(&loads.necks), [1, 2, 1, 0, 0]);
        assert_eq!(by_id(&loads.coordination), [1, 2, 2, 1, 0]);
        assert_eq!(loads.pairs.len(), 4);
    }
}
