//! What contacts do: they slide, come about and come apart, and those of rigid bodies roll.

use super::Law;
use crate::simulation::Simulation;
use crate::spec::Vec3;
use crate::spec::mechanics::quaternion::{product, rotation_vector};
use crate::spec::mechanics::rotation::to_space;
use crate::spec::titania::def_radius::effective_radius;
use crate::system::{Pose, System};
use serde::{Deserialize, Serialize};

/// Contacts as they were at the last look, and what has happened since the first.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Contacts {
    /// In the order of the ids.
    known: Vec<Known>,
    /// Contacts that slipped.
    pub slidings: u64,
    /// Contacts that rolled by the period of stick and slip.
    pub rollings: u64,
    /// Contacts that came apart.
    pub detachments: u64,
}

/// A pair of spheres in range.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct Known {
    ids: (u32, u32),
    /// Length of the tangential spring.
    spring: f64,
    /// How the first lay as seen from the second when it last had rolled.
    lay: (f64, Vec3<f64>),
}

impl Contacts {
    /// Looks for the first time.
    pub fn begin<M: Law>(simulation: &Simulation<M>) -> Self {
        let mut contacts = Self::default();
        contacts.look(simulation);
        contacts
    }

    /// Looks at all contacts; says what has happened to them since the last look. A spring that has lost more than half a period between
    /// two looks has slipped.
    pub fn look<M: Law>(&mut self, simulation: &Simulation<M>) -> Vec<String> {
        let (system, period) = (simulation.system(), simulation.model().tables().law().lambda_t);
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

    /// How many pairs were in range at the last look.
    pub fn count(&self) -> usize {
        self.known.len()
    }
}

/// How the body of a sphere lies; how a sphere by itself lies nobody keeps, and it is not seen to roll.
fn pose(system: &System, sphere: usize) -> Pose {
    match system.particles.body[sphere] as usize {
        0 => Pose { x: Vec3::zero(), q_0: 1.0, q: Vec3::zero() },
        body => system.bodies[body - 1].pose,
    }
}

/// The orientation of `a` as seen from `b`.
fn seen(a: &Pose, b: &Pose) -> (f64, Vec3<f64>) {
    product(b.q_0, -b.q, a.q_0, a.q)
}
