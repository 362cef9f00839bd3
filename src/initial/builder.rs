//! A builder of systems that checks them as a whole.

mod problems;

use crate::error::Error;
use crate::spec::Vec3;
use crate::system::{Domain, Motion, Particles, Surface, System};
use std::collections::BTreeSet;

/// A system under construction. Spheres are named by their id, counted from zero in the order in which they are added.
///
/// ```
/// use veridem::system::{Motion, System};
///
/// let system = System::builder()
///     .sphere([0.0, 0.0, 0.0], 5.0, 1.0)
///     .sphere([9.9, 0.0, 0.0], 5.0, 1.0)
///     .velocity([-1.0, 0.0, 0.0])
///     .wall(&[0], [Motion::Velocity(0.0); 3])
///     .build()?;
/// assert_eq!(system.particles.len(), 2);
///
/// let error = System::builder().sphere([0.0; 3], 5.0, 1.0).neck(0, 7).build().unwrap_err();
/// assert_eq!(error.to_string(), "neck 0-7: there is no sphere 7, expected an id below 1");
/// # Ok::<(), veridem::error::Error>(())
/// ```
#[derive(Clone, Debug, Default)]
#[must_use]
pub struct Builder {
    particles: Particles,
    domain: Option<Domain>,
    necks: Vec<(u32, u32)>,
    bodies: Vec<Vec<u32>>,
    walls: Vec<(Vec<u32>, [Motion; 3])>,
    surfaces: Vec<Surface>,
}

impl System {
    /// A system to be put together sphere by sphere.
    pub fn builder() -> Builder {
        Builder::default()
    }
}

impl Builder {
    /// The box; without one it has the extent of the spheres, and is not periodic.
    pub fn domain(mut self, domain: Domain) -> Self {
        self.domain = Some(domain);
        self
    }

    /// Adds a sphere at rest: centre, nm; radius, nm; mass, ag.
    pub fn sphere(mut self, x: [f64; 3], radius: f64, mass: f64) -> Self {
        self.particles.push(Vec3(x), radius, mass, 0);
        self
    }

    /// Sets the velocity of the latest sphere, m/s.
    ///
    /// # Panics
    ///
    /// If there is no sphere yet.
    pub fn velocity(mut self, v: [f64; 3]) -> Self {
        *self.particles.v.last_mut().expect("a velocity follows its sphere") = Vec3(v);
        self
    }

    /// Sets the angular velocity of the latest sphere, 1/ns.
    ///
    /// # Panics
    ///
    /// If there is no sphere yet.
    pub fn spin(mut self, w: [f64; 3]) -> Self {
        *self.particles.w.last_mut().expect("a spin follows its sphere") = Vec3(w);
        self
    }

    /// Joins two spheres by a neck. A model without necks ignores it.
    pub fn neck(mut self, i: u32, j: u32) -> Self {
        self.necks.push((i.min(j), i.max(j)));
        self
    }

    /// Makes spheres into one rigid body, which moves with their common velocity.
    pub fn body(mut self, members: &[u32]) -> Self {
        self.bodies.push(members.into());
        self
    }

    /// Makes spheres into one rigid wall, driven axis by axis.
    pub fn wall(mut self, members: &[u32], motion: [Motion; 3]) -> Self {
        self.walls.push((members.into(), motion));
        self
    }

    /// Adds a surface.
    pub fn surface(mut self, surface: Surface) -> Self {
        self.surfaces.push(surface);
        self
    }

    /// The finished system.
    ///
    /// # Errors
    ///
    /// All that is wrong with it: no sphere; a radius, mass or side that is not positive; a position, velocity or spin that is not finite; two spheres in one
    /// place; a wall whose motion is not finite; a neck, body or wall of spheres that do not exist, or share a body or wall with others.
    pub fn build(mut self) -> Result<System, Error> {
        let problems = self.problems();
        if !problems.is_empty() {
            return Err(Error::Input(problems));
        }
        self.necks.sort_unstable();
        let domain = self.domain.unwrap_or_else(|| bounds(&self.particles));
        let velocities = self.particles.v.clone();
        let mut system = System::new(self.particles, domain);
        for (number, members) in self.bodies.iter().enumerate() {
            system.add_body(&members.iter().map(|&id| id as usize).collect::<Vec<_>>());
            let v = velocities[members[0] as usize];
            system.bodies[number].v = v;
            members.iter().for_each(|&id| system.particles.v[id as usize] = v);
        }
        for (members, motion) in self.walls {
            let members: BTreeSet<u32> = members.into_iter().collect();
            system.add_wall(motion, |particles, p| members.contains(&particles.id[p]));
        }
        Ok(System { necks: self.necks, surfaces: self.surfaces, ..system })
    }
}

/// A box with the extent of the spheres.
fn bounds(particles: &Particles) -> Domain {
    let spheres = 0..particles.len();
    let end = |a: usize, sign: f64| {
        spheres.clone().map(|p| sign * particles.x[p].0[a] + particles.radius[p]).fold(f64::NEG_INFINITY, f64::max)
    };
    Domain { sides: std::array::from_fn(|a| end(a, 1.0) + end(a, -1.0)), periodic: [false; 3] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::{ContactTable, Forces, PrescribedMotion, Shape};

    fn three() -> Builder {
        System::builder().sphere([0.0; 3], 1.0, 1.0).sphere([3.0, 0.0, 0.0], 1.0, 1.0).sphere([6.0, 0.0, 0.0], 1.0, 1.0)
    }

    fn problems(builder: Builder) -> Vec<String> {
        let Err(Error::Input(problems)) = builder.build() else { panic!("a wrong system") };
        problems.iter().map(|problem| problem.to_string()).collect()
    }

    #[test]
    fn everything_wrong_with_a_sphere_is_told_at_once() {
        let builder = System::builder().sphere([f64::NAN, 0.0, 0.0], 0.0, -1.0).sphere([0.0; 3], 1.0, 1.0);
        assert_eq!(
            problems(builder.sphere([0.0, -0.0, 0.0], 1.0, 1.0)),
            [
                "sphere 0: its radius is 0, expected a positive number",
                "sphere 0: its mass is -1, expected a positive number",
                "sphere 0: its centre is [NaN, 0.0, 0.0], expected finite numbers",
                "sphere 2: its centre coincides with the centre of another sphere",
            ]
        );
    }

    #[test]
    fn necks_bodies_and_walls_hold_spheres_that_are_there_and_share_none() {
        assert_eq!(problems(three().neck(1, 1)), ["neck 1-1: joins a sphere to itself"]);
        assert_eq!(problems(three().neck(1, 0).neck(0, 1)), ["neck 0-1: is given twice"]);
        let joined = "neck 0-1: joins two spheres of one rigid body or wall";
        assert_eq!(problems(three().body(&[0, 1]).neck(0, 1)), [joined]);
        assert_eq!(problems(three().wall(&[0, 1], [Motion::Velocity(0.0); 3]).neck(0, 1)), [joined]);
        assert_eq!(problems(three().body(&[])), ["body 0: has no spheres"]);
        assert_eq!(
            problems(three().body(&[0, 1]).body(&[1, 9])),
            ["body 1: sphere 1 belongs to body 0 already", "body 1: there is no sphere 9, expected an id below 3"]
        );
        let half = three().body(&[0, 1]).wall(&[1], [Motion::Velocity(0.0); 3]);
        assert_eq!(problems(half), ["body 0: only one of the spheres 0 and 1 belongs to a wall, expected all or none"]);
    }

    #[test]
    fn spheres_that_coincide_across_a_period_and_walls_without_a_speed_are_refused() {
        let periodic = System::builder().domain(Domain::periodic([50.0; 3])).sphere([0.0; 3], 1.0, 1.0);
        let twice = "sphere 1: its centre coincides with the centre of another sphere";
        assert_eq!(problems(periodic.sphere([50.0, 0.0, 0.0], 1.0, 1.0)), [twice]);
        let motion = [Motion::Velocity(0.0), Motion::Velocity(f64::NAN), Motion::Velocity(0.0)];
        let expected = "wall 0: its motion is Velocity(NaN), expected finite numbers and a positive duration";
        assert_eq!(problems(three().wall(&[0], motion)), [expected]);
        assert_eq!(problems(three().body(&[0, 0])), ["body 0: sphere 0 is given twice"]);
    }

    #[test]
    fn each_kind_of_problem_is_told_by_itself() {
        let still = [Motion::Velocity(0.0); 3];
        let sphere = |builder: Builder| builder.sphere([9.0, 0.0, 0.0], 1.0, 1.0);
        let sides = |sides: [f64; 3]| three().domain(Domain { sides, periodic: [false; 3] });
        let along_y = |motion| three().wall(&[0], [Motion::Velocity(0.0), motion, Motion::Load(0.0)]);
        let no_sense =
            |motion: &str| format!("wall 0: its motion is {motion}, expected finite numbers and a positive duration");
        let none = "there is no sphere";
        let table: Vec<(Builder, String)> = vec![
            (System::builder(), "system: has no spheres, expected one at least".into()),
            (sides([9.0, 0.0, 9.0]), "box: side 1 is 0, expected a positive number".into()),
            (sides([9.0, 9.0, -1.0]), "box: side 2 is -1, expected a positive number".into()),
            (
                System::builder().sphere([0.0; 3], 1.0, 1.0).domain(Domain::periodic([f64::INFINITY, 9.0, 9.0])),
                "box: side 0 is inf, expected a positive number".into(),
            ),
            (
                three().sphere([9.0; 3], f64::INFINITY, 1.0),
                "sphere 3: its radius is inf, expected a positive number".into(),
            ),
            (three().sphere([9.0; 3], 1.0, 0.0), "sphere 3: its mass is 0, expected a positive number".into()),
            (three().sphere([9.0; 3], 1.0, f64::NAN), "sphere 3: its mass is NaN, expected a positive number".into()),
            (
                three().sphere([0.0, f64::INFINITY, 0.0], 1.0, 1.0),
                "sphere 3: its centre is [0.0, inf, 0.0], expected finite numbers".into(),
            ),
            (
                sphere(three()).velocity([0.0, 0.0, f64::NAN]),
                "sphere 3: its velocity is [0.0, 0.0, NaN], expected finite numbers".into(),
            ),
            (
                sphere(three()).spin([f64::INFINITY, 0.0, 0.0]),
                "sphere 3: its spin is [inf, 0.0, 0.0], expected finite numbers".into(),
            ),
            (
                three().sphere([3.0, 0.0, 0.0], 2.0, 1.0),
                "sphere 3: its centre coincides with the centre of another sphere".into(),
            ),
            (three().wall(&[], still), "wall 0: has no spheres".into()),
            (three().wall(&[3], still), format!("wall 0: {none} 3, expected an id below 3")),
            (three().wall(&[0, 1, 0], still), "wall 0: sphere 0 is given twice".into()),
            (three().wall(&[0], still).wall(&[1, 0], still), "wall 1: sphere 0 belongs to wall 0 already".into()),
            (three().body(&[2, 3]), format!("body 0: {none} 3, expected an id below 3")),
            (three().body(&[1]).body(&[2, 1]), "body 1: sphere 1 belongs to body 0 already".into()),
            (along_y(Motion::Load(f64::INFINITY)), no_sense("Load(inf)")),
            (along_y(Motion::Return { speed: f64::NAN, turn: 1.0 }), no_sense("Return { speed: NaN, turn: 1.0 }")),
            (along_y(Motion::Return { speed: 1.0, turn: 0.0 }), no_sense("Return { speed: 1.0, turn: 0.0 }")),
            (along_y(Motion::Return { speed: 1.0, turn: f64::NAN }), no_sense("Return { speed: 1.0, turn: NaN }")),
            (
                three().body(&[0, 1, 2]).wall(&[0, 1], still),
                "body 0: only one of the spheres 0 and 2 belongs to a wall, expected all or none".into(),
            ),
            (
                three().velocity([0.0, 1.0, 0.0]).body(&[1, 2]),
                "body 0: spheres 1 and 2 have different velocities, expected one for all".into(),
            ),
            (
                three().spin([0.0, 1.0, 0.0]).body(&[1, 2]),
                "sphere 2: it belongs to a body, expected no spin of its own".into(),
            ),
            (three().neck(3, 0), format!("neck 0-3: {none} 3, expected an id below 3")),
            (
                System::builder()
                    .sphere([0.0; 3], 1.0, 1.0)
                    .spin([0.0, 1.0, 0.0])
                    .sphere([3.0, 0.0, 0.0], 1.0, 1.0)
                    .body(&[0, 1]),
                "sphere 0: it belongs to a body, expected no spin of its own".into(),
            ),
            (three().body(&[1, 2]).neck(2, 2), "neck 2-2: joins a sphere to itself".into()),
            (three().neck(2, 2), "neck 2-2: joins a sphere to itself".into()),
            (three().neck(0, 2).neck(1, 2).neck(2, 0), "neck 0-2: is given twice".into()),
            (three().body(&[1, 2]).neck(1, 2), "neck 1-2: joins two spheres of one rigid body or wall".into()),
            (three().wall(&[1, 2], still).neck(1, 2), "neck 1-2: joins two spheres of one rigid body or wall".into()),
        ];
        for (builder, expected) in table {
            assert_eq!(problems(builder), [expected]);
        }
        let both = [
            format!("neck 7-8: {none} 7, expected an id below 3"),
            format!("neck 7-8: {none} 8, expected an id below 3"),
        ];
        assert_eq!(problems(three().neck(8, 7)), both);
        // A body of no sphere that is there has neither velocity nor wall.
        assert_eq!(problems(three().body(&[9])), [format!("body 0: {none} 9, expected an id below 3")]);
    }

    #[test]
    fn what_looks_like_a_problem_and_is_none_is_built() {
        let motion = [Motion::Velocity(-1.0), Motion::Load(-2.0), Motion::Return { speed: -1.0, turn: 0.1 }];
        let surface = Surface {
            name: "floor".into(),
            material: 0,
            shape: Shape::Plane { point: Vec3::zero(), normal: Vec3([0.0, 0.0, 1.0]) },
            motion: PrescribedMotion::Still,
            velocity: Vec3::zero(),
            way: Vec3::zero(),
            age: 0.0,
            force: Forces { contact: Vec3::zero(), friction: Vec3::zero(), van_der_waals: Vec3::zero() },
            contacts: ContactTable::default(),
        };
        // Free spheres, spheres of two bodies and of two walls may be joined, and a free one may spin; without periods places beyond the box are others.
        let builder = three()
            .spin([0.0, 0.0, 3.0])
            .sphere([9.0, 0.0, 0.0], 1.0, 2.0)
            .sphere([12.0, 0.0, 0.0], 1.0, 2.0)
            .velocity([5.0, 0.0, 0.0])
            .sphere([15.0, 0.0, 0.0], 1.0, 2.0)
            .velocity([5.0, 0.0, 0.0])
            .domain(Domain { sides: [3.0, 9.0, 9.0], periodic: [false, true, true] })
            .body(&[0, 1])
            .body(&[4, 5])
            .wall(&[1, 0], motion)
            .wall(&[3], [Motion::Velocity(2.0); 3])
            .neck(5, 1)
            .neck(3, 2)
            .neck(3, 0)
            .surface(surface.clone());
        let system = builder.build().expect("a system");
        assert_eq!(system.necks, [(0, 3), (1, 5), (2, 3)]);
        assert_eq!((system.particles.wall, system.particles.body), (vec![1, 1, 0, 2, 0, 0], vec![1, 1, 0, 0, 2, 2]));
        assert_eq!((system.particles.w[2], system.particles.tag.clone()), (Vec3([0.0, 0.0, 3.0]), vec![0; 6]));
        let moving = Vec3([-1.0, 0.0, 1.0]);
        assert_eq!(
            (system.particles.v[0], system.particles.v[3], system.particles.v[4]),
            (moving, Vec3([2.0; 3]), Vec3([5.0, 0.0, 0.0]))
        );
        assert_eq!(
            [0, 1].map(|k| (system.bodies[k].v, system.bodies[k].wall)),
            [(moving, 1), (Vec3([5.0, 0.0, 0.0]), 0)]
        );
        assert_eq!([0, 1].map(|k| system.walls[k].mass), [2.0, 2.0]);
        assert_eq!((system.surfaces, system.domain.sides), (vec![surface], [3.0, 9.0, 9.0]));
    }

    #[test]
    fn spheres_may_be_as_near_as_numbers_are_and_a_body_have_one() {
        assert!(three().sphere([1e-20, 0.0, 0.0], 1.0, 1.0).build().is_ok());
        let system = three().velocity([0.0, 1.0, 0.0]).body(&[2]).build().expect("a body");
        assert_eq!((system.bodies[0].v, system.bodies[0].mass), (Vec3([0.0, 1.0, 0.0]), 1.0));
    }

    #[test]
    fn without_a_box_there_is_one_of_the_extent_of_the_spheres() {
        let system = System::builder().sphere([-100.0, 0.0, 5.0], 1.0, 1.0).sphere([-97.0, 0.0, 5.0], 2.0, 1.0).build();
        assert_eq!(system.expect("spheres").domain.sides, [6.0, 4.0, 4.0]);
    }

    #[test]
    fn a_body_moves_with_the_velocity_of_its_spheres_and_they_have_no_other() {
        let moving = System::builder().sphere([0.0; 3], 1.0, 1.0).velocity([1.0, 2.0, 3.0]);
        let moving = moving.sphere([2.0, 0.0, 0.0], 1.0, 1.0).velocity([1.0, 2.0, 3.0]);
        let system = moving.clone().body(&[0, 1]).build().expect("a body");
        assert_eq!(system.bodies[0].v, Vec3([1.0, 2.0, 3.0]));
        assert_eq!(system.particles.v, [Vec3([1.0, 2.0, 3.0]); 2]);
        let apart = moving.sphere([4.0, 0.0, 0.0], 1.0, 1.0).spin([0.0, 0.0, 1.0]).body(&[0, 1, 2]);
        assert_eq!(
            problems(apart),
            [
                "body 0: spheres 0 and 2 have different velocities, expected one for all",
                "sphere 2: it belongs to a body, expected no spin of its own",
            ]
        );
    }
}
