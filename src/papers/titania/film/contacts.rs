//! Contact events: sliding, formation and detachment, and the rolling of rigid bodies.

use crate::papers::titania::Law;
use crate::simulation::Simulation;
use crate::spec::Vec3;
use crate::spec::mechanics::quaternion::{product, rotation_vector};
use crate::spec::mechanics::rotation::to_space;
use crate::spec::titania::def_radius::effective_radius;
use crate::system::{Pose, System};
use serde::{Deserialize, Serialize};

/// The contacts at the last examination, and the number of events since the first.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Contacts {
    /// The contacts, in the order of their ids.
    known: Vec<Known>,
    /// Number of contacts that slipped.
    pub slidings: u64,
    /// Number of contacts that rolled by the stick-slip period.
    pub rollings: u64,
    /// Number of contacts that detached.
    pub detachments: u64,
}

/// A pair of spheres in range.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct Known {
    ids: (u32, u32),
    /// Length of the tangential spring.
    spring: f64,
    /// Orientation of the first relative to the second at the last rolling event.
    lay: (f64, Vec3<f64>),
}

impl Contacts {
    /// Records the initial contacts.
    pub(super) fn begin<M: Law>(simulation: &Simulation<M>) -> Self {
        let mut contacts = Self::default();
        contacts.look(simulation);
        contacts
    }

    /// Examines all contacts and returns the events since the last examination. A spring that has shortened by more than half a period in
    /// between has slipped.
    pub(super) fn look<M: Law>(&mut self, simulation: &Simulation<M>) -> Vec<String> {
        let (system, period) = (simulation.system(), simulation.model().law().lambda_t);
        let id = &system.particles.id;
        let (mut events, mut now) = (Vec::new(), Vec::with_capacity(self.known.len()));
        for (i, j, contact, memory) in simulation.contacts() {
            let (ids, spring) = ((id[i], id[j]), M::spring(&memory).norm());
            if system.necks.binary_search(&ids).is_ok() {
                continue;
            }
            let (a, b) = (pose(system, i), pose(system, j));
            let mut next = Known { ids, spring, lay: seen(&a, &b) };
            match self.known.binary_search_by_key(&ids, |known| known.ids) {
                Err(_) if self.known.is_empty() => {}
                Err(_) => events.push(format!("meniscus between {} and {}", ids.0, ids.1)),
                Ok(place) => {
                    let before = self.known[place];
                    if before.spring - spring > 0.5 * period {
                        self.slidings += 1;
                        events.push(format!("sliding of {} and {}", ids.0, ids.1));
                    }
                    let ((from_0, from), (to_0, to)) = (before.lay, next.lay);
                    let turn = to_space(b.q_0, b.q, rotation_vector(from_0, from, to_0, to));
                    let (_, r_eff) = effective_radius(contact.r_i, contact.r_j);
                    if turn.perpendicular_to(contact.n).norm() * r_eff < period {
                        next.lay = before.lay;
                    } else {
                        self.rollings += 1;
                        events.push(format!("rolling of {} and {}", ids.0, ids.1));
                    }
                }
            }
            now.push(next);
        }
        now.sort_unstable_by_key(|known| known.ids);
        for Known { ids, .. } in &self.known {
            if now.binary_search_by_key(ids, |known| known.ids).is_err() {
                self.detachments += 1;
                events.push(format!("detachment of {} and {}", ids.0, ids.1));
            }
        }
        self.known = now;
        events
    }

    /// Number of pairs in range at the last examination.
    pub(super) fn count(&self) -> usize {
        self.known.len()
    }
}

/// The orientation of the body of a sphere; single spheres have no stored orientation, so their rolling is not observed.
fn pose(system: &System, sphere: usize) -> Pose {
    match system.particles.body[sphere] as usize {
        0 => Pose { x: Vec3::zero(), q_0: 1.0, q: Vec3::zero() },
        body => system.bodies[body - 1].pose,
    }
}

/// The orientation of `a` relative to `b`.
fn seen(a: &Pose, b: &Pose) -> (f64, Vec3<f64>) {
    product(b.q_0, -b.q, a.q_0, a.q)
}
