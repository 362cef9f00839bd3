//! The forces of a surface on a sphere.

use super::super::eq21_hamaker_plane::{plane_force, saturated_plane};
use super::lifted;
use crate::mechanics::contact_kinematics::ContactKinematics;
use crate::mechanics::four_springs::{Friction, Memory, Order, Springs, SpringsOutcome, never};
use crate::mechanics::rotated_spring::Twist;
use crate::{Real, Touch};

/// A wall: the substrate, or the tip. Its motion is prescribed.
///
/// # Reading
///
/// In the paper the tip consists of facets, each of which acts on a sphere. Here facets that share an edge or a corner share the contact there: a sphere has one contact with a surface, or
/// one for each place where its distance from the surface has a minimum. From each of these places Eq. 22, the force of a whole half-space, attracts, with the share that
/// [`facet_share`](super::super::def_facets::facet_share) gives it. Below a corner a half-space exceeds the actual body, so the force is an upper bound; the published program adds
/// the half-spaces of all facets and gives three times this force below the apex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// The four springs of its contacts.
    pub contact: Springs<f64>,
    /// Their friction.
    pub friction: Friction<f64>,
    /// Hamaker constant, J.
    pub hamaker: f64,
    /// Saturation distance, m.
    pub delta_0: f64,
    /// Distance of a centre from the wall beyond which nothing acts, m.
    pub cutoff: f64,
}

impl Wall {
    /// A contact: advances its springs by `dt` and returns the forces on the sphere.
    #[inline(always)]
    pub fn evaluate<R: Real, O: Twist<R>>(
        &self,
        order: Order,
        touch: &Touch<R>,
        memory: Memory<R, O>,
        dt: R,
    ) -> SpringsOutcome<R, O> {
        let at = ContactKinematics::of_wall(touch.n, touch.gap, touch.v, touch.omega, touch.r);
        self.springs().grip_in(order, &lifted(&self.friction), never::<R>(), &at, memory, dt)
    }

    /// The attraction, N.
    #[inline(always)]
    pub fn pull<R: Real>(&self, gap: R, r: R) -> R {
        self.within(r + gap, plane_force(r, gap.max(R::lit(self.delta_0)), R::lit(self.hamaker)))
    }

    /// The energy of that attraction, zero at the cutoff and beyond, J.
    #[inline(always)]
    pub fn energy<R: Real>(&self, gap: R, r: R) -> R {
        let [a, delta_0, cutoff] = [self.hamaker, self.delta_0, self.cutoff].map(R::lit);
        let energy = |gap| saturated_plane(r, gap, a, delta_0).1;
        self.within(r + gap, energy(gap) - energy(cutoff - r))
    }

    /// Energies stored in the springs of a contact, J: normal, tangential, rolling, torsion.
    #[inline(always)]
    pub fn stored<R: Real, O: Twist<R>>(&self, gap: R, memory: &Memory<R, O>) -> [R; 4] {
        self.springs().stored(never::<R>(), gap, memory)
    }

    #[inline(always)]
    fn within<R: Real>(&self, distance: R, value: R) -> R {
        R::select(distance.le(R::lit(self.cutoff)), value, R::zero())
    }

    #[inline(always)]
    fn springs<R: Real>(&self) -> Springs<R> {
        lifted(&self.contact)
    }
}
