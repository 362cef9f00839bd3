//! The contact law, composed from its equations, for an engine.

use super::def_body_forces::Attraction;
use super::def_facets::{facet_share, facet_share_slope};
use super::def_neck_stress::neck_stress;
use super::eq12_spring_force::turning_torque;
use crate::mechanics::carried_spring::carried_spring;
use crate::mechanics::contact_kinematics::ContactKinematics;
use crate::mechanics::four_springs::{Friction, Losses, Memory, Order, Springs, SpringsOutcome, never};
use crate::mechanics::rotated_spring::Twist;
use crate::{Contact, Flat, PairModel, Real, Touch, Vec3, flat_struct};

pub use wall::Wall;

/// The reading of the springs of contacts and necks.
pub trait Reading: Copy + Send + Sync {
    /// The torsion spring that is stored.
    type Torsion<R: Real>: Twist<R>;
    /// Order of stretching and acting within a step.
    const ORDER: Order;
    /// Whether a pair that spins about its normal carries its springs along, see [`carried_spring`].
    const CARRIED: bool = false;
}

/// Torsion springs lie along the normal: torsion is resisted by a spring and a dashpot, like every other motion. See [`rotated_torsion`](crate::mechanics::rotated_spring::rotated_torsion).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Along;
impl Reading for Along {
    type Torsion<R: Real> = R;
    const ORDER: Order = Order::StretchFirst;
}

/// As [`Along`], and tangential and rolling springs follow a pair that spins about its normal. A surface does not spin: there they follow half the spin of the sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Following;
impl Reading for Following {
    type Torsion<R: Real> = R;
    const ORDER: Order = Order::StretchFirst;
    const CARRIED: bool = true;
}

/// Torsion springs along the normal, and all springs act before they are stretched, lagging by one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lagging;
impl Reading for Lagging {
    type Torsion<R: Real> = R;
    const ORDER: Order = Order::ActFirst;
}

/// As printed: torsion springs are rotated into the contact plane before every step. Only the last increment remains along the normal, so torsion meets no lasting
/// resistance. The spring in the plane only grows, and bends the pair in the directions in which the normal has moved, with work that is not taken from a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Printed;
impl Reading for Printed {
    type Torsion<R: Real> = Vec3<R>;
    const ORDER: Order = Order::StretchFirst;
}

/// As the springs are in the authors' program: as printed, and all act before they are stretched, lagging by one step. The program differs from it in these: it turns rolling and torsion springs into torques with the
/// radius as arm, not with the distance from the centre to the contact for rolling; while spheres part and their dashpot outweighs their overlap it lets the normal force pull, and friction push along the motion, where
/// nothing acts here; at its start it evaluates all forces three times and stretches the springs each time; and facets of a surface act one by one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Programmed;
impl Reading for Programmed {
    type Torsion<R: Real> = Vec3<R>;
    const ORDER: Order = Order::ActFirst;
}

flat_struct! {
    /// The coefficients of a pair.
    pub struct Coefficients {
        /// One for a pair that is joined by a neck, zero for one that is not.
        pub bonded,
    }
}

flat_struct! {
    /// Energy stored in a pair, J, by cause.
    pub struct Stored {
        /// All four springs of a neck.
        pub necks,
        /// Normal spring of a contact.
        pub normal,
        /// Tangential spring of a contact.
        pub tangential,
        /// Rolling spring of a contact.
        pub rolling,
        /// Torsion spring of a contact.
        pub torsion,
        /// Van der Waals attraction, zero at the cutoff and beyond.
        pub van_der_waals,
        /// Capillary attraction, zero at the cutoff and beyond.
        pub capillary,
    }
}

/// Which of the walls a surface is.
pub const SUBSTRATE: usize = 0;
/// Which of the walls a surface is.
pub const TIP: usize = 1;

/// Strength of a neck; without either it never breaks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Strength {
    /// Energy in its four springs at which it breaks, J.
    pub energy: Option<f64>,
    /// Largest tensile and largest shear stress, Pa, and the radius of its cross-section, m.
    pub stress: Option<[f64; 3]>,
}

impl Strength {
    /// The strength of a neck that breaks at stresses this many times as large, and hence at that square of the energy.
    pub fn times(self, factor: f64) -> Self {
        let stress = self.stress.map(|[tension, shear, radius]| [factor * tension, factor * shear, radius]);
        Self { energy: self.energy.map(|energy| factor * factor * energy), stress }
    }
}

/// Soot: necks, frictional contacts, van der Waals and capillary attraction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Soot<S = Along> {
    /// The four springs of a neck.
    pub neck: Springs<f64>,
    /// The four springs of a frictional contact.
    pub contact: Springs<f64>,
    /// The friction of such a contact.
    pub friction: Friction<f64>,
    /// The attractions that act at a distance.
    pub attraction: Attraction<f64>,
    /// How all these springs are read.
    pub reading: S,
    /// The [substrate](SUBSTRATE) and the [tip](TIP).
    pub walls: [Wall; 2],
}

/// The same values in another number type.
#[inline(always)]
fn lifted<R: Real, A: Flat<f64>, B: Flat<R>>(numbers: &A) -> B {
    B::from_fn(|k| R::lit(*numbers.at(k)))
}

impl<S: Reading> PairModel for Soot<S> {
    type Coefficients<R: Real> = Coefficients<R>;
    type Memory<R: Real> = Memory<R, S::Torsion<R>>;
    type Losses<R: Real> = Losses<R>;
    type Stored<R: Real> = Stored<R>;

    /// A pair without a neck.
    fn coefficients<R: Real>(&self, _: R, _: R, _: R, _: R) -> Coefficients<R> {
        Coefficients { bonded: R::zero() }
    }

    fn joined<R: Real>(&self, _: Coefficients<R>) -> Coefficients<R> {
        Coefficients { bonded: R::one() }
    }

    /// Two spheres at one instant: advances their springs by `dt` and returns their forces. A neck acts at any distance; everything else ends at the cutoff. Pairs that overlap are
    /// [near](Self::is_near) also where nothing acts: they remember at which gap they touch.
    #[inline(always)]
    fn pair<R: Real>(
        &self,
        c: &Contact<R>,
        k: &Coefficients<R>,
        memory: Self::Memory<R>,
        dt: R,
    ) -> SpringsOutcome<R, S::Torsion<R>> {
        let bonded = is_bonded(k);
        let at = ContactKinematics::of_spheres(c);
        let memory = carried::<R, S>(memory, c.n, c.omega_i, c.omega_j, dt);
        let mut evaluate = self.springs(bonded).grip_in(S::ORDER, &lifted(&self.friction), bonded, &at, memory, dt);
        evaluate.wrench.force = evaluate.wrench.force + self.far(c);
        evaluate
    }

    /// The gap at rest of overlapping spheres.
    fn left_by_neck<R: Real>(memory: Self::Memory<R>) -> Self::Memory<R> {
        Memory { rest: memory.rest.min(R::zero()), ..Memory::zero() }
    }

    const MOSTLY_FAR: bool = true;

    #[inline(always)]
    fn is_near<R: Real>(&self, c: &Contact<R>, k: &Coefficients<R>) -> R::Mask {
        is_bonded(k) | c.gap.lt(R::zero())
    }

    #[inline(always)]
    fn far<R: Real>(&self, c: &Contact<R>) -> Vec3<R> {
        let attraction: Attraction<R> = lifted(&self.attraction);
        -(c.n * attraction.force(c.distance, c.gap, c.r_i, c.r_j))
    }

    #[inline(always)]
    fn stored<R: Real>(&self, c: &Contact<R>, k: &Coefficients<R>, memory: &Self::Memory<R>) -> Stored<R> {
        let bonded = is_bonded(k);
        let attraction: Attraction<R> = lifted(&self.attraction);
        let held = self.springs(bonded).stored(bonded, c.gap, memory);
        let necks = R::select(bonded, held[0] + held[1] + held[2] + held[3], R::zero());
        let [normal, tangential, rolling, torsion] = held.map(|energy| R::select(bonded, R::zero(), energy));
        let (van_der_waals, capillary) = attraction.energies(c.distance, c.r_i, c.r_j);
        Stored { necks, normal, tangential, rolling, torsion, van_der_waals, capillary }
    }

    /// Largest distance of centres at which two spheres without a neck act on each other, m.
    fn range(&self, r_i: f64, r_j: f64) -> f64 {
        let reaches = self.attraction.a > 0.0 || self.attraction.psi > 0.0;
        if reaches { self.attraction.cutoff.max(r_i + r_j) } else { r_i + r_j }
    }

    fn critical_time_step(&self, r: f64, m: f64) -> f64 {
        self.critical_time_step_among(r, m, r)
    }

    /// Largest stable time step of a sphere in contact or with a neck, s. Springs of a contact may lag by more: they slip before they gain much energy.
    fn critical_time_step_among(&self, r: f64, m: f64, largest: f64) -> f64 {
        let limit = self.neck.critical_time_step(r, m, largest).min(self.contact.critical_time_step(r, m, largest));
        if S::ORDER == Order::ActFirst { limit.min(self.neck.lag_limit()) } else { limit }
    }

    const SURFACES: usize = 2;

    fn surface_range(&self, material: usize, r: f64) -> f64 {
        let Wall { hamaker, cutoff, .. } = self.walls[material];
        if hamaker > 0.0 { cutoff.max(r) } else { r }
    }

    fn surface_contact(
        &self,
        material: usize,
        touch: &Touch<f64>,
        memory: Self::Memory<f64>,
        dt: f64,
    ) -> SpringsOutcome<f64, S::Torsion<f64>> {
        let memory = carried::<f64, S>(memory, touch.n, touch.omega, Vec3::zero(), dt);
        self.walls[material].evaluate(S::ORDER, touch, memory, dt)
    }

    fn surface_pull(&self, material: usize, touch: &Touch<f64>) -> f64 {
        self.walls[material].pull(touch.gap, touch.r)
    }

    fn surface_energy(&self, material: usize, touch: &Touch<f64>) -> f64 {
        self.walls[material].energy(touch.gap, touch.r)
    }

    fn surface_share(&self, [d, d_0]: [Vec3<f64>; 2], [q_d_0, q_0_d]: [Vec3<f64>; 2]) -> (f64, Vec3<f64>) {
        (facet_share(d, d_0), facet_share_slope(d, d_0, q_d_0, q_0_d))
    }

    fn surface_stored(
        &self,
        material: usize,
        touch: &Touch<f64>,
        memory: &Self::Memory<f64>,
        share: f64,
    ) -> Stored<f64> {
        let (wall, &Touch { gap, r, .. }) = (&self.walls[material], touch);
        let van_der_waals = share * wall.energy(gap, r);
        let [normal, tangential, rolling, torsion] = wall.stored(gap, memory);
        Stored { necks: 0.0, normal, tangential, rolling, torsion, van_der_waals, capillary: 0.0 }
    }
}

impl<S: Reading> Soot<S> {
    /// Largest tensile and largest shear stress, Pa, that the springs of a neck cause in its thinnest cross-section, of radius `r_b`.
    pub fn neck_stress<R: Real>(&self, c: &Contact<R>, memory: &Memory<R, S::Torsion<R>>, r_b: R) -> (R, R) {
        let (at, neck) = (ContactKinematics::of_spheres(c), lifted::<R, _, Springs<R>>(&self.neck));
        let turning = turning_torque(at.n, at.a, memory.rolling * neck.k_r, at.r, memory.torsion * neck.k_o);
        let xi_n = memory.elongation(!never::<R>(), at.delta);
        neck_stress(neck.k_n * xi_n, memory.tangential * neck.k_t, turning, at.n, r_b)
    }
}

impl<S: Reading> Soot<S> {
    /// Whether a neck is loaded beyond its strength.
    pub fn neck_breaks(
        &self,
        c: &Contact<f64>,
        memory: &Memory<f64, S::Torsion<f64>>,
        held: &Stored<f64>,
        strength: &Strength,
    ) -> bool {
        strength.energy.is_some_and(|energy| held.necks > energy)
            || strength.stress.is_some_and(|[tension, shear, radius]| {
                let (sigma, tau) = self.neck_stress(c, memory, radius);
                sigma > tension || tau > shear
            })
    }
}

impl<S> Soot<S> {
    /// The springs of a neck where `bonded` is true, those of a contact elsewhere.
    #[inline(always)]
    fn springs<R: Real>(&self, bonded: R::Mask) -> Springs<R> {
        Springs::from_fn(|k| R::select(bonded, R::lit(*self.neck.at(k)), R::lit(*self.contact.at(k))))
    }
}

/// The springs of a pair that has spun, where the reading carries them.
#[inline(always)]
fn carried<R: Real, S: Reading>(
    memory: Memory<R, S::Torsion<R>>,
    n: Vec3<R>,
    omega_i: Vec3<R>,
    omega_j: Vec3<R>,
    dt: R,
) -> Memory<R, S::Torsion<R>> {
    if S::CARRIED { memory.turned(|xi| carried_spring(xi, n, omega_i, omega_j, dt)) } else { memory }
}

#[inline(always)]
fn is_bonded<R: Real>(k: &Coefficients<R>) -> R::Mask {
    k.bonded.gt(R::lit(0.5))
}

mod wall;

#[cfg(test)]
mod laws;
