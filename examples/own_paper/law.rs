//! The equations and the contact law, the only part of the paper that the engine uses. Equations are generic over the number type and select instead of branching.

use veridem::spec::mechanics::reduced_mass::effective_mass;
use veridem::spec::mechanics::stable_step::stable_time_step;
use veridem::spec::{Contact, Outcome, PairModel, Real, Vec3, Wrench, flat_struct, piecewise};

/// Damping coefficient of a dashpot with the damping ratio `zeta`.
fn damping_factor<R: Real>(m: R, k: R, zeta: R) -> R {
    R::lit(2.0) * zeta * (m * k).sqrt()
}

/// Force of spring and dashpot along the normal, positive for repulsion; zero without an overlap.
fn normal_force<R: Real>(k: R, c: R, gap: R, velocity: R) -> R {
    piecewise([(gap.lt(R::zero()), -(k * gap) - c * velocity)], R::zero())
}

/// Duration of the contact in a head-on collision.
pub(super) fn contact_time<R: Real>(m: R, k: R, zeta: R) -> R {
    R::pi() / (k / m * (R::one() - zeta.squared())).sqrt()
}

/// Coefficient of restitution: velocity of separation relative to velocity of approach.
pub(super) fn restitution<R: Real>(zeta: R) -> R {
    (-(R::pi() * zeta) / (R::one() - zeta.squared()).sqrt()).exp()
}

/// A linear spring with a dashpot between spheres that overlap.
#[derive(Clone, Copy, Debug)]
pub(super) struct Linear {
    /// Stiffness of the spring, pN/nm.
    pub stiffness: f64,
    /// Damping ratio.
    pub damping_ratio: f64,
}

flat_struct! {
    /// The constants of a pair.
    pub struct Constants {
        /// Stiffness.
        pub k,
        /// Damping coefficient.
        pub c,
    }
}
flat_struct! {
    /// The energy stored in a pair.
    pub struct Stored {
        /// In its spring.
        pub spring,
    }
}
flat_struct! {
    /// The energy dissipated by a pair.
    pub struct Losses {
        /// By its dashpot.
        pub dashpots,
    }
}

impl PairModel for Linear {
    type Coefficients<R: Real> = Constants<R>;
    /// The compression of the spring is the overlap, so there is no contact history.
    type Memory<R: Real> = [R; 0];
    type Losses<R: Real> = Losses<R>;
    type Stored<R: Real> = Stored<R>;

    fn coefficients<R: Real>(&self, _: R, _: R, m_i: R, m_j: R) -> Constants<R> {
        let k = R::lit(self.stiffness);
        Constants { k, c: damping_factor(effective_mass(m_i, m_j), k, R::lit(self.damping_ratio)) }
    }
    fn range(&self, r_i: f64, r_j: f64) -> f64 {
        r_i + r_j
    }
    #[inline(always)]
    fn pair<R: Real>(
        &self,
        contact: &Contact<R>,
        &Constants { k, c }: &Constants<R>,
        memory: [R; 0],
        dt: R,
    ) -> Outcome<R, [R; 0], Losses<R>> {
        let (gap, velocity) = (contact.gap, contact.normal_velocity());
        let force = contact.n * normal_force(k, c, gap, velocity);
        let wrench = Wrench { force, torque_i: Vec3::zero(), torque_j: Vec3::zero() };
        let dashpots = piecewise([(gap.lt(R::zero()), c * velocity.squared() * dt)], R::zero());
        Outcome { wrench, memory, losses: Losses { dashpots } }
    }
    fn stored<R: Real>(&self, contact: &Contact<R>, constants: &Constants<R>, _: &[R; 0]) -> Stored<R> {
        let overlap = -contact.gap.min(R::zero());
        Stored { spring: R::lit(0.5) * constants.k * overlap.squared() }
    }
    fn critical_time_step(&self, r: f64, m: f64) -> f64 {
        let Constants { k, c } = self.coefficients(r, r, m, m);
        stable_time_step(effective_mass(m, m), k, c)
    }
}
