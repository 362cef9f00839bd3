//! The forces of surfaces on the spheres in contact with them.

use super::{Block, Load};
use crate::geometry::triangles::{DistanceMinimum, NearTriangles, Support};
use crate::spec::numbers::Lanes;
use crate::spec::{Flat, Outcome, PairModel, Touch, Vec3};
use crate::system::{ContactTable, Forces, Particles, Surface};

/// Displacement of a contact point in one step, in radii, above which the contact is a new one.
const JUMP: f64 = 0.1;

/// Largest gap of the contact search, in radii: larger than the displacement in one step.
const JUST: f64 = 0.01;

/// The contributions of one surface in one step.
pub struct SurfaceTotals<M: PairModel> {
    /// Forces on the spheres.
    pub force: Forces,
    /// Power of the surface on the spheres.
    pub power: f64,
    /// Energy lost, by cause.
    pub losses: M::Losses<f64>,
    /// Contacts and their springs: id of the sphere, contact point in the frame of the surface.
    pub contacts: Vec<(u32, Vec3<f64>, M::Memory<f64>)>,
    /// The deepest sphere and its overlap over its radius.
    pub deepest: (u32, f64),
}

impl<M: PairModel> Default for SurfaceTotals<M> {
    fn default() -> Self {
        let losses = Flat::from_fn(|_| 0.0);
        Self { force: Forces::zero(), power: 0.0, losses, contacts: Vec::new(), deepest: (0, f64::NEG_INFINITY) }
    }
}

impl<M: PairModel> SurfaceTotals<M> {
    /// Both together.
    pub fn and(mut self, other: Self) -> Self {
        self.contacts.extend(other.contacts);
        Self {
            force: self.force.and(other.force),
            power: self.power + other.power,
            losses: Flat::from_fn(|k| self.losses.at(k) + other.losses.at(k)),
            contacts: self.contacts,
            deepest: if other.deepest.1 > self.deepest.1 { other.deepest } else { self.deepest },
        }
    }

    /// The contacts as the surface keeps them.
    pub fn store_contacts(mut self, contacts: &mut ContactTable) {
        self.contacts.sort_by_key(|contact| contact.0);
        contacts.places.clear();
        contacts.springs.clear();
        for (sphere, place, springs) in self.contacts {
            contacts.places.push((sphere, place));
            contacts.springs.extend((0..M::Memory::<f64>::LEN).map(|k| *springs.at(k)));
        }
    }
}

/// Evaluates a surface and the free spheres that a block owns, advances the springs of their contacts by `dt`, and adds to the
/// loads of the block.
pub fn surface_forces<M: PairModel>(
    model: &M,
    (number, surface): (usize, &Surface),
    particles: &Particles,
    block: &mut Block<M>,
    dt: f64,
) -> SurfaceTotals<M> {
    let mut totals = SurfaceTotals::default();
    let mut seen = Vec::new();
    let Block { own, near, loads, .. } = block;
    if near.len() <= number {
        near.resize(number + 1, vec![NearTriangles::default(); own.len()]);
    }
    for (place, p) in own.clone().enumerate() {
        let near = &mut near[number][place];
        each_touch(model, surface, particles, p, (near, &mut seen), |at, touch, springs, share| {
            let (id, load) = (particles.id[p], &mut loads[place]);
            *load = *load + totals.enter(model, surface, (id, at, share), touch, springs, dt);
        });
    }
    totals
}

impl<M: PairModel> SurfaceTotals<M> {
    /// The forces on a sphere at one contact point of the surface.
    pub fn enter(
        &mut self,
        model: &M,
        surface: &Surface,
        (sphere, at, share): (u32, &DistanceMinimum, Share),
        touch: &Touch<f64>,
        springs: Option<M::Memory<f64>>,
        dt: f64,
    ) -> Load {
        let material = surface.material;
        let (mut force, mut torque) = (Vec3::zero(), Vec3::zero());
        // A contact that has just ended is evaluated once more: its springs release their energy.
        if touch.gap < 0.0 || springs.is_some() {
            let springs = springs.unwrap_or(Flat::from_fn(|_| 0.0));
            let Outcome { wrench, memory, losses } = model.surface_contact(material, touch, springs, dt);
            (force, torque) = (wrench.force, wrench.torque_i);
            if touch.gap < 0.0 {
                self.contacts.push((sphere, at.place, memory));
            }
            self.losses = Flat::from_fn(|k| self.losses.at(k) + losses.at(k));
        }
        let contact = touch.n * force.dot(touch.n);
        let friction = force - contact;
        let van_der_waals = share.attraction(model, material, touch);
        self.force = self.force.and(Forces { contact, friction, van_der_waals });
        let force = force + van_der_waals;
        self.power += force.dot(touch.v + surface.velocity) + torque.dot(touch.omega);
        let overlap = -touch.gap / touch.r;
        if overlap > self.deepest.1 {
            self.deepest = (sphere, overlap);
        }
        let (Vec3([fx, fy, fz]), Vec3([tx, ty, tz])) = (force, torque);
        Lanes([fx, fy, fz, tx, ty, tz, 0.0, 0.0])
    }
}

/// The share of a place in the attraction of its surface, and its gradient, 1/nm.
#[derive(Clone, Copy, Debug)]
pub struct Share {
    /// The share.
    pub value: f64,
    slope: Vec3<f64>,
}

impl Share {
    const NOTHING: Self = Self { value: 0.0, slope: Vec3([0.0; 3]) };
    const WHOLE: Self = Self { value: 1.0, slope: Vec3([0.0; 3]) };

    /// The share of a minimum of the distance beside nearer ones: the smallest counts.
    fn beside<M: PairModel>(model: &M, nearer: &[DistanceMinimum], at: &DistanceMinimum) -> Self {
        nearer.iter().fold(Self::WHOLE, |least, other| {
            let [d, d_0] = [at.sight(), other.sight()];
            let (value, slope) = model.surface_share([d, d_0], [at.change_of_sight(d_0), other.change_of_sight(d)]);
            if value < least.value { Self { value, slope } } else { least }
        })
    }

    /// The force of attraction: minus the gradient of the share times the energy.
    fn attraction<M: PairModel>(self, model: &M, material: usize, touch: &Touch<f64>) -> Vec3<f64> {
        if self.value == 0.0 {
            return Vec3::zero();
        }
        let force = -(touch.n * (self.value * model.surface_pull(material, touch)));
        if self.value == 1.0 { force } else { force - self.slope * model.surface_energy(material, touch) }
    }
}

/// Shows every place where a surface acts on a free sphere, with the springs of the contact there if it is not new and its share in the attraction,
/// the nearest place first; then the contact points that the sphere has left since the last step, out of contact and at rest, whose springs have not
/// been released yet.
pub fn each_touch<M: PairModel>(
    model: &M,
    surface: &Surface,
    particles: &Particles,
    p: usize,
    (near, seen): (&mut NearTriangles, &mut Vec<DistanceMinimum>),
    mut show: impl FnMut(&DistanceMinimum, &Touch<f64>, Option<M::Memory<f64>>, Share),
) {
    if particles.wall[p] > 0 {
        return;
    }
    let Particles { x, v, w, radius, id, .. } = particles;
    seen.clear();
    let just = (1.0 + JUST) * radius[p];
    near.distance_minima(surface, x[p], model.surface_range(surface.material, radius[p]).max(just), seen);
    let mut contacts = surface.contacts.of(id[p]);
    for (k, at) in seen.iter().enumerate() {
        let (gap, v) = (at.distance - radius[p], v[p] - surface.velocity);
        let touch = Touch { n: at.n, gap, v, omega: w[p], r: radius[p] };
        let springs = if at.distance < just { contacts.take(at.place, JUMP * radius[p]) } else { None };
        let springs = springs.map(|springs| Flat::from_fn(|k| springs[k]));
        show(at, &touch, springs, Share::beside(model, &seen[..k], at));
    }
    for (place, springs) in contacts.rest() {
        let from = x[p] - surface.way - place;
        let distance = from.norm();
        let n = if distance > 0.0 { from * (1.0 / distance) } else { Vec3([0.0, 0.0, 1.0]) };
        let touch =
            Touch { n, gap: (distance - radius[p]).max(0.0), v: Vec3::zero(), omega: Vec3::zero(), r: radius[p] };
        let left = DistanceMinimum { n, distance, place, support: Support::Corner };
        show(&left, &touch, Some(Flat::from_fn(|k| springs[k])), Share::NOTHING);
    }
}
