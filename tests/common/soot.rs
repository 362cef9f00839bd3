//! Aggregates of soot for the tests of the engine.

use std::path::Path;
use veridem::geometry::Sphere;
use veridem::initial::aggregate::necks::{NeckLength, necks};
use veridem::initial::aggregate::{Method, Radii, Recipe, aggregate};
use veridem::interrupt::Interrupt;
use veridem::papers::parse;
use veridem::papers::soot::tip::tetrahedron;
use veridem::papers::soot::{self, case::parts};
use veridem::run::advance;
use veridem::simulation::{Settings, Simulation};
use veridem::spec::Vec3;
use veridem::spec::soot::{Along, SUBSTRATE, Soot, TIP};
use veridem::system::{Domain, Particles, PrescribedMotion, Shape, Surface, System};

/// Spheres of the aggregate.
pub(crate) const SPHERES: usize = 30;
/// Their radius, nm.
pub(crate) const RADIUS: f64 = 14.0;
/// Their mass, ag.
pub(crate) const MASS: f64 = 19.54;
/// A time step that is stable and quick with the softer necks, ns.
pub(crate) const DT: f64 = 20e-6;

/// The published interactions with the softer necks.
pub(crate) fn law() -> Soot {
    let text = "title: t\nmodel: {soot: {necks: S}}\nsample: {aggregate: {}}\nexperiment: {restructuring: {}}\n";
    parts(&parse::<soot::Soot>(Path::new("published"), text).expect("a case of defaults"))
        .expect("an aggregate")
        .0
        .law(Along)
}

/// The same without a coating.
pub(crate) fn dry() -> Soot {
    let mut law = law();
    law.attraction.psi = 0.0;
    law
}

/// An aggregate about the origin, those of its contacts joined by necks whose numbers satisfy `joined`.
pub(crate) fn system(joined: impl Fn(usize) -> bool) -> System {
    let recipe = Recipe { number: SPHERES, d_f: 1.8, k_f: 1.4, radii: Radii::Equal(RADIUS), method: Method::Clusters };
    let spheres = aggregate(&recipe, 1, &Interrupt::default()).expect("an ordinary aggregate");
    let mut particles = Particles::default();
    for &Sphere { centre, radius } in &spheres {
        particles.push(centre, radius, MASS, 0);
    }
    let all = necks(&spheres, 0.01, NeckLength::Touching, true, &Interrupt::default()).expect("necks");
    let all = all.into_iter().enumerate();
    let necks = all.filter(|(k, _)| joined(*k)).map(|(_, (i, j))| (i as u32, j as u32)).collect();
    System { necks, ..System::new(particles, space()) }
}

/// Free space.
pub(crate) fn space() -> Domain {
    Domain { sides: [400.0; 3], periodic: [false; 3] }
}

/// A third of the necks.
pub(crate) fn third(k: usize) -> bool {
    k.is_multiple_of(3)
}

/// The substrate of the paper.
pub(crate) fn plane() -> Shape {
    Shape::Plane { point: Vec3::zero(), normal: Vec3([0.0, 0.0, 1.0]) }
}

/// An aggregate that has all but reached a substrate with some velocity, and a tip that comes down on its highest sphere.
pub(crate) fn between(substrate: Shape) -> System {
    let mut system = system(third);
    let particles = &mut system.particles;
    let lowest = particles.x.iter().map(|x| x.0[2]).fold(f64::INFINITY, f64::min);
    particles.x.iter_mut().for_each(|x| *x = *x + Vec3([0.0, 0.0, 0.2 + RADIUS - lowest]));
    particles.v.fill(Vec3([2.0, 1.0, -8.0]));
    particles.w.fill(Vec3([0.1, -0.2, 0.3]));
    let highest = particles.x.iter().copied().reduce(|a, b| if b.0[2] > a.0[2] { b } else { a }).expect("spheres");
    let tip = tetrahedron(RADIUS).displaced(highest + Vec3([1.0, 2.0, RADIUS + 0.3]));
    let motion = PrescribedMotion::Reversal { velocity: 15.0, rate: 5.0, turn: 0.15 };
    system.surfaces = vec![
        Surface::new("substrate", SUBSTRATE, substrate, PrescribedMotion::Still),
        Surface::new("tip", TIP, Shape::Mesh(tip), motion),
    ];
    system
}

/// Settings for a time step.
pub(crate) fn settings(dt: f64) -> Settings {
    Settings::new(dt).skin(2.0).max_overlap(0.1)
}

/// A simulation after some steps.
pub(crate) fn run(law: Soot, system: System, settings: Settings, steps: usize) -> Simulation<Soot> {
    let mut simulation = Simulation::new(law, system, settings).expect("a stable step");
    advance(&mut simulation, steps as u64).expect("a stable step");
    simulation
}

/// Sum of momenta, ag m/s.
pub(crate) fn momentum(particles: &Particles) -> Vec3<f64> {
    particles.v.iter().zip(&particles.mass).fold(Vec3::zero(), |sum, (v, m)| sum + *v * *m)
}
