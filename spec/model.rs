//! The interface between a paper's contact law and an engine.

use crate::{Contact, Real, Vec3};

/// The action of a pair: forces and torques, never accelerations, so that Newton's third law is visible.
#[derive(Clone, Copy, Debug)]
pub struct Wrench<R> {
    /// Force on `i`, N; the force on `j` is its negative.
    pub force: Vec3<R>,
    /// Torque on `i` about its centre, N m.
    pub torque_i: Vec3<R>,
    /// Torque on `j` about its centre, N m.
    pub torque_j: Vec3<R>,
}

impl<R: Real> Wrench<R> {
    /// Power that the pair delivers to its two spheres, W.
    #[inline(always)]
    pub fn power(&self, c: &Contact<R>) -> R {
        self.force.dot(c.v) + self.torque_i.dot(c.omega_i) + self.torque_j.dot(c.omega_j)
    }
}

/// A pair after one evaluation.
#[derive(Clone, Copy, Debug)]
pub struct Outcome<R, M, L> {
    /// Forces and torques now.
    pub wrench: Wrench<R>,
    /// The springs with which the next step starts.
    pub memory: M,
    /// Energy lost in this step, J, by cause.
    pub losses: L,
}

/// A sphere at a point of a surface with prescribed motion.
#[derive(Clone, Copy, Debug)]
pub struct Touch<R> {
    /// Unit vector from the surface to the centre.
    pub n: Vec3<R>,
    /// Distance between surface and sphere, m: negative for an overlap.
    pub gap: R,
    /// Velocity of the centre relative to the surface, m/s.
    pub v: Vec3<R>,
    /// Angular velocity of the sphere, 1/s.
    pub omega: Vec3<R>,
    /// Radius of the sphere, m.
    pub r: R,
}

/// A fixed number of `R`, in order: the form in which an engine stores the contact history of a model without knowing its meaning.
pub trait Flat<R>: Copy + Send + Sync {
    /// How many numbers.
    const LEN: usize;
    /// Builds the value from its numbers.
    fn from_fn(f: impl FnMut(usize) -> R) -> Self;
    /// The number at place `k`, below `LEN`.
    fn at(&self, k: usize) -> &R;
    /// The number at place `k`, below `LEN`, to be changed.
    fn at_mut(&mut self, k: usize) -> &mut R;
}

impl<R: Real> Flat<R> for R {
    const LEN: usize = 1;
    #[inline(always)]
    fn from_fn(mut f: impl FnMut(usize) -> R) -> Self {
        f(0)
    }
    #[inline(always)]
    fn at(&self, _: usize) -> &R {
        self
    }
    #[inline(always)]
    fn at_mut(&mut self, _: usize) -> &mut R {
        self
    }
}

impl<R, A: Flat<R>, B: Flat<R>> Flat<R> for (A, B) {
    const LEN: usize = A::LEN + B::LEN;
    #[inline(always)]
    fn from_fn(mut f: impl FnMut(usize) -> R) -> Self {
        let first = A::from_fn(&mut f);
        (first, B::from_fn(|k| f(A::LEN + k)))
    }
    #[inline(always)]
    fn at(&self, k: usize) -> &R {
        if k < A::LEN { self.0.at(k) } else { self.1.at(k - A::LEN) }
    }
    #[inline(always)]
    fn at_mut(&mut self, k: usize) -> &mut R {
        if k < A::LEN { self.0.at_mut(k) } else { self.1.at_mut(k - A::LEN) }
    }
}

/// Numbers with names: energies by cause, and the springs of a contact.
pub trait Named<R>: Flat<R> {
    /// The names, in order, in words; empty for a single number.
    fn names() -> Vec<String>;
}

impl<R: Real> Named<R> for R {
    fn names() -> Vec<String> {
        vec![String::new()]
    }
}

impl<R: Copy + Send + Sync> Named<R> for Vec3<R> {
    fn names() -> Vec<String> {
        ["x", "y", "z"].map(String::from).to_vec()
    }
}

impl<R: Copy + Send + Sync, const N: usize> Named<R> for [R; N] {
    fn names() -> Vec<String> {
        (1..=N).map(|number| number.to_string()).collect()
    }
}

impl<R, A: Named<R>, B: Named<R>> Named<R> for (A, B) {
    fn names() -> Vec<String> {
        A::names().into_iter().chain(B::names()).collect()
    }
}

impl<R: Copy + Send + Sync, const N: usize> Flat<R> for [R; N] {
    const LEN: usize = N;
    #[inline(always)]
    fn from_fn(f: impl FnMut(usize) -> R) -> Self {
        std::array::from_fn(f)
    }
    #[inline(always)]
    fn at(&self, k: usize) -> &R {
        &self[k]
    }
    #[inline(always)]
    fn at_mut(&mut self, k: usize) -> &mut R {
        &mut self[k]
    }
}

impl<R: Copy + Send + Sync> Flat<R> for Vec3<R> {
    const LEN: usize = 3;
    #[inline(always)]
    fn from_fn(mut f: impl FnMut(usize) -> R) -> Self {
        Self([f(0), f(1), f(2)])
    }
    #[inline(always)]
    fn at(&self, k: usize) -> &R {
        &self.0[k]
    }
    #[inline(always)]
    fn at_mut(&mut self, k: usize) -> &mut R {
        &mut self.0[k]
    }
}

/// Declares a structure of numbers that is also [`Flat`], and [`Named`] after its fields.
#[macro_export]
macro_rules! flat_struct {
    ($(#[$doc:meta])* pub struct $name:ident { $($(#[$field_doc:meta])* pub $field:ident),* $(,)? }) => {
        $(#[$doc])*
        #[allow(unreachable_pub, reason = "laws and tests declare them too")]
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<R> { $($(#[$field_doc])* pub $field: R),* }
        impl<R: Copy + Send + Sync> $crate::Flat<R> for $name<R> {
            const LEN: usize = [$(stringify!($field)),*].len();
            #[inline(always)]
            fn from_fn(mut f: impl FnMut(usize) -> R) -> Self {
                let mut place = 0..;
                Self { $($field: f(place.next().expect("places without end"))),* }
            }
            #[inline(always)]
            fn at(&self, k: usize) -> &R {
                [$(&self.$field),*][k]
            }
            #[inline(always)]
            fn at_mut(&mut self, k: usize) -> &mut R {
                [$(&mut self.$field),*].into_iter().nth(k).expect("a place below LEN")
            }
        }
        impl<R: Copy + Send + Sync> $crate::Named<R> for $name<R> {
            fn names() -> Vec<String> {
                [$(stringify!($field)),*].map(|field| field.replace('_', " ")).to_vec()
            }
        }
    };
}

/// A contact model: the interaction of two spheres.
///
/// Units are those of SI here; any consistent system will do. The engine calls it with nm, ag and ns, hence pN and zJ.
pub trait PairModel: Sync {
    /// Constants of a pair while its spheres are neighbours.
    type Coefficients<R: Real>: Flat<R>;
    /// The springs of a contact; all zero for a new contact.
    type Memory<R: Real>: Named<R>;
    /// Energy dissipated in one time step, J, by cause.
    type Losses<R: Real>: Named<R>;
    /// Energy stored in a pair, J, by cause; all zero for spheres far apart.
    type Stored<R: Real>: Named<R>;

    /// The constants of a pair of given radii (m) and masses (kg).
    fn coefficients<R: Real>(&self, r_i: R, r_j: R, m_i: R, m_j: R) -> Self::Coefficients<R>;
    /// The constants of a pair that a neck joins, where the model has necks.
    fn joined<R: Real>(&self, constants: Self::Coefficients<R>) -> Self::Coefficients<R> {
        constants
    }
    /// The contact history with which a contact takes the place of a neck that breaks or is removed: none, unless the shape of the spheres is part of it.
    fn left_by_neck<R: Real>(_memory: Self::Memory<R>) -> Self::Memory<R> {
        Flat::from_fn(|_| R::zero())
    }
    /// Whether friction is limited by the inertia it may stop in a step, which [`turning`](Self::turning) receives.
    const FRICTION_STOPS: bool = false;
    /// The constants of a pair of which the engine knows what its friction may stop: the reduced moment of inertia (kg m²) of two spheres, or
    /// of the rigid bodies that they are parts of, each shared by all contacts that touch.
    fn turning<R: Real>(&self, constants: Self::Coefficients<R>, _inertia: R) -> Self::Coefficients<R> {
        constants
    }
    /// Largest distance of centres at which two spheres of these radii act on each other, m.
    fn range(&self, r_i: f64, r_j: f64) -> f64;
    /// The pair at one instant: advances its springs by `dt` and returns their forces. Beyond its range everything is zero.
    fn pair<R: Real>(
        &self,
        c: &Contact<R>,
        k: &Self::Coefficients<R>,
        memory: Self::Memory<R>,
        dt: R,
    ) -> Outcome<R, Self::Memory<R>, Self::Losses<R>>;
    /// The springs that a pair keeps when the neighbour list is rebuilt, and the energy lost with the others, J, by cause: all are kept unless
    /// the model follows a program that resets some.
    fn relisted<R: Real>(
        &self,
        _c: &Contact<R>,
        _k: &Self::Coefficients<R>,
        memory: Self::Memory<R>,
    ) -> (Self::Memory<R>, Self::Losses<R>) {
        (memory, Flat::from_fn(|_| R::zero()))
    }
    /// Whether most pairs in range only attract or repel each other along the line of centres: those need not be evaluated in full.
    const MOSTLY_FAR: bool = false;
    /// The pairs that must be evaluated in full; all others have no spring, and only [`far`](Self::far) acts.
    fn is_near<R: Real>(&self, _c: &Contact<R>, _k: &Self::Coefficients<R>) -> R::Mask {
        R::zero().le(R::zero())
    }
    /// The force on `i` of a pair that is not near.
    fn far<R: Real>(&self, _c: &Contact<R>) -> Vec3<R> {
        Vec3::zero()
    }
    /// The energy stored in a pair.
    fn stored<R: Real>(&self, c: &Contact<R>, k: &Self::Coefficients<R>, memory: &Self::Memory<R>) -> Self::Stored<R>;
    /// Largest stable time step of two equal spheres in contact, s.
    fn critical_time_step(&self, r: f64, m: f64) -> f64;
    /// The same of a sphere among others of the same density with radii up to `largest`, m: they need no other step unless a model says so.
    fn critical_time_step_among(&self, r: f64, m: f64, _largest: f64) -> f64 {
        self.critical_time_step(r, m)
    }

    /// Number of materials of surfaces; none for a model without surfaces.
    const SURFACES: usize = 0;
    /// Distance of a centre from a surface of this material up to which the surface acts, m; zero for a model without surfaces.
    fn surface_range(&self, _material: usize, _r: f64) -> f64 {
        0.0
    }
    /// A contact of a sphere and a surface: advances its springs by `dt` and returns the forces on the sphere.
    fn surface_contact(
        &self,
        _material: usize,
        _touch: &Touch<f64>,
        memory: Self::Memory<f64>,
        _dt: f64,
    ) -> Outcome<f64, Self::Memory<f64>, Self::Losses<f64>> {
        let zero = Vec3::zero();
        let wrench = Wrench { force: zero, torque_i: zero, torque_j: zero };
        Outcome { wrench, memory, losses: Flat::from_fn(|_| 0.0) }
    }
    /// The force with which a place of a surface attracts a sphere, N.
    fn surface_pull(&self, _material: usize, _touch: &Touch<f64>) -> f64 {
        0.0
    }
    /// The energy of this attraction, J.
    fn surface_energy(&self, _material: usize, _touch: &Touch<f64>) -> f64 {
        0.0
    }
    /// The energy that the springs of a contact hold, and the share of its place in the energy of attraction, J.
    fn surface_stored(
        &self,
        _material: usize,
        _touch: &Touch<f64>,
        _memory: &Self::Memory<f64>,
        _share: f64,
    ) -> Self::Stored<f64> {
        Flat::from_fn(|_| 0.0)
    }
    /// The share of a place in the attraction of a surface beside a nearer place, and its gradient, by the vectors from the places to the
    /// centre and their changes when the centre is displaced by the other.
    fn surface_share(&self, _sight: [Vec3<f64>; 2], _change: [Vec3<f64>; 2]) -> (f64, Vec3<f64>) {
        (0.0, Vec3::zero())
    }
}

#[cfg(test)]
pub(crate) mod laws {
    use super::*;
    use crate::mechanics::samples::vector;
    use proptest::prelude::*;

    flat_struct! {
        /// Three numbers.
        pub struct Three {
            /// First.
            pub first,
            /// Second.
            pub next_one,
            /// Third.
            pub last,
        }
    }

    /// Numbers that are laid end to end stay in order, and a change of one changes no other.
    pub(crate) fn lies_in_order<F: Flat<f64>>(len: usize) {
        assert_eq!(F::LEN, len);
        let mut flat = F::from_fn(|k| k as f64);
        for changed in 0..len {
            *flat.at_mut(changed) += 100.0;
            for k in 0..len {
                let expected = if k <= changed { 100.0 } else { 0.0 } + k as f64;
                assert_eq!(*flat.at(k), expected, "place {k} after a change of place {changed}");
            }
        }
    }

    #[test]
    fn every_place_is_written_where_it_is_read() {
        lies_in_order::<f64>(1);
        lies_in_order::<Vec3<f64>>(3);
        lies_in_order::<[f64; 4]>(4);
        lies_in_order::<Three<f64>>(3);
        lies_in_order::<(f64, f64)>(2);
        lies_in_order::<(Vec3<f64>, Three<f64>)>(6);
        lies_in_order::<((f64, [f64; 2]), Vec3<f64>)>(6);
    }

    #[test]
    fn every_place_has_its_name() {
        assert_eq!(Three::<f64>::names(), ["first", "next one", "last"]);
        assert_eq!(<([f64; 2], Vec3<f64>)>::names(), ["1", "2", "x", "y", "z"]);
        assert_eq!(f64::names(), [""]);
    }

    /// A model that says only what it must.
    struct Nothing;

    impl PairModel for Nothing {
        type Coefficients<R: Real> = R;
        type Memory<R: Real> = R;
        type Losses<R: Real> = R;
        type Stored<R: Real> = R;

        fn coefficients<R: Real>(&self, _: R, _: R, _: R, _: R) -> R {
            R::zero()
        }
        fn range(&self, r_i: f64, r_j: f64) -> f64 {
            r_i + r_j
        }
        fn pair<R: Real>(&self, _: &Contact<R>, _: &R, memory: R, _: R) -> Outcome<R, R, R> {
            let zero = Vec3::zero();
            Outcome { wrench: Wrench { force: zero, torque_i: zero, torque_j: zero }, memory, losses: R::zero() }
        }
        fn stored<R: Real>(&self, _: &Contact<R>, _: &R, _: &R) -> R {
            R::zero()
        }
        fn critical_time_step(&self, r: f64, m: f64) -> f64 {
            r * m
        }
    }

    #[test]
    fn a_model_has_no_necks_and_surfaces_and_forgets_nothing_unless_it_says_so() {
        let (none, along) = (Vec3::zero(), Vec3::new(1.0, 0.0, 0.0));
        let (c, touch) = (
            Contact::new(along, along, none, none, 0.5, 0.5),
            Touch { n: along, gap: -0.1, v: along, omega: none, r: 0.5 },
        );
        assert_eq!((Nothing.joined(3.0), Nothing::left_by_neck(3.0), Nothing.turning(3.0, 2.0)), (3.0, 0.0, 3.0));
        assert_eq!(Nothing.relisted(&c, &1.0, 3.0), (3.0, 0.0));
        assert!(Nothing.is_near(&c, &1.0) && Nothing.far(&c) == none);
        assert_eq!(Nothing.critical_time_step_among(2.0, 3.0, 5.0), 6.0);
        let Outcome { wrench, memory, losses } = Nothing.surface_contact(0, &touch, 3.0, 0.1);
        assert_eq!([wrench.force, wrench.torque_i, wrench.torque_j], [none; 3]);
        assert_eq!((memory, losses, Nothing.surface_stored(0, &touch, &3.0, 0.5)), (3.0, 0.0, 0.0));
        let of_surface =
            [Nothing.surface_range(0, 1.0), Nothing.surface_pull(0, &touch), Nothing.surface_energy(0, &touch)];
        assert_eq!((of_surface, Nothing.surface_share([along; 2], [along; 2])), ([0.0; 3], (0.0, none)));
    }

    proptest! {
        /// The force on i and its reaction on j, whose velocities differ by `v`.
        #[test]
        fn the_power_of_a_pair_is_that_of_its_forces_and_torques(
            v_i in vector(), v_j in vector(), omega_i in vector(), omega_j in vector(),
            force in vector(), torque_i in vector(), torque_j in vector(),
        ) {
            let c = Contact::new(Vec3::new(1.0, 0.0, 0.0), v_i - v_j, omega_i, omega_j, 0.5, 0.5);
            let of_i = force.dot(v_i) + torque_i.dot(omega_i);
            let of_j = (-force).dot(v_j) + torque_j.dot(omega_j);
            let wrench = Wrench { force, torque_i, torque_j };
            prop_assert!((wrench.power(&c) - of_i - of_j).abs() < 1e-13);
        }
    }
}
