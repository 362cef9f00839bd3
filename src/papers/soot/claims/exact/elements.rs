//! Section 3: every elementary interaction by itself, between two or three spheres, conserves energy and momentum.

use super::{DENSITY, RADIUS};
use crate::case::section::defaults;
use crate::motion::inertia;
use crate::papers::soot::case::{NeckSet, Soot};
use crate::reproduce::Claim;
use crate::run::advance;
use crate::simulation::{Integrator, Settings, Simulation};
use crate::spec::Vec3;
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::soot::{self, Along};
use crate::system::{Domain, Particles, System};

/// Largest change of a momentum relative to that of a sphere with all of the energy: rounding.
const ROUNDING: f64 = 1e-12;
/// Largest part of the converted energy that is unaccounted for: first order in the time step.
const UNACCOUNTED: f64 = 1e-3;

/// An element by itself.
struct Element {
    name: &'static str,
    /// Its spheres with their necks.
    set_up: fn(System) -> System,
    /// Whether they attract each other.
    attracts: bool,
    /// Time step, ns, and the number of steps after which they have parted, swung several times or come to rest.
    dt: f64,
    steps: u64,
}

const ELEMENTS: [Element; 3] = [
    Element {
        name: "a frictional contact, an oblique collision of two spinning spheres",
        set_up: collision,
        attracts: false,
        dt: 1e-6,
        steps: 15_000,
    },
    Element {
        name: "necks, a bent chain of three spheres of which one is pushed",
        set_up: chain,
        attracts: false,
        dt: 1e-6,
        steps: 15_000,
    },
    Element {
        name: "van der Waals attraction, two spheres that fall onto each other from a gap of 1.5 nm",
        set_up: fall,
        attracts: true,
        dt: 1e-5,
        steps: 80_000,
    },
];

fn collision(mut system: System) -> System {
    let of = &mut system.particles;
    push(of, Vec3([0.0; 3]), Vec3([3.0, 0.5, 0.0]), Vec3([0.0, 0.02, 0.05]));
    let apart = 2.0 * RADIUS + 0.005;
    push(of, Vec3([0.96 * apart, 0.28 * apart, 0.0]), Vec3([-3.0, 0.0, 0.3]), Vec3([0.01, 0.0, 0.03]));
    system
}

fn chain(mut system: System) -> System {
    let of = &mut system.particles;
    let bend = Vec3([2.0 * RADIUS * 0.6, 2.0 * RADIUS * 0.8, 0.0]);
    push(of, Vec3([0.0; 3]), Vec3([0.0; 3]), Vec3([0.0; 3]));
    push(of, Vec3([2.0 * RADIUS, 0.0, 0.0]), Vec3([0.0; 3]), Vec3([0.0; 3]));
    push(of, Vec3([2.0 * RADIUS, 0.0, 0.0]) + bend, Vec3([0.3, -0.2, 0.5]), Vec3([0.01, 0.0, 0.02]));
    system.necks = vec![(0, 1), (1, 2)];
    system
}

fn fall(mut system: System) -> System {
    let of = &mut system.particles;
    let (place, apart) = (Vec3([5.0, 7.0, 3.0]), 2.0 * RADIUS + 1.5);
    push(of, place, Vec3([0.0; 3]), Vec3([0.0; 3]));
    push(of, place + Vec3([0.6 * apart, 0.8 * apart, 0.0]), Vec3([0.0; 3]), Vec3([0.0; 3]));
    system
}

fn push(particles: &mut Particles, x: Vec3<f64>, v: Vec3<f64>, w: Vec3<f64>) {
    let p = particles.len();
    particles.push(x, RADIUS, sphere_mass(DENSITY, RADIUS), 0);
    (particles.v[p], particles.w[p]) = (v, w);
}

/// Momentum and angular momentum.
fn momenta(system: &System) -> [Vec3<f64>; 2] {
    let of = &system.particles;
    (0..of.len()).fold([Vec3::zero(); 2], |[linear, angular], p| {
        let momentum = of.v[p] * of.mass[p];
        [linear + momentum, angular + of.x[p].cross(momentum) + of.w[p] * inertia(of, p)]
    })
}

/// The law with one element alone: without a coating, without attraction unless it is asked for.
fn law(attracts: bool) -> soot::Soot {
    let mut law = Soot { necks: Some(NeckSet::S), ..defaults() }.law(Along);
    law.attraction.psi = 0.0;
    if !attracts {
        law.attraction.a = 0.0;
    }
    law
}

/// One row for each element.
pub(super) fn claims() -> Vec<Claim> {
    ELEMENTS.iter().map(claim).collect()
}

fn claim(Element { name, set_up, attracts, dt, steps }: &Element) -> Claim {
    let none = System::new(Particles::default(), Domain { sides: [20.0 * RADIUS; 3], periodic: [false; 3] });
    let system = set_up(none);
    let settings = Settings::new(*dt).integrator(Integrator::VelocityVerlet).skin(0.1 * RADIUS);
    let before = momenta(&system);
    let simulation = Simulation::new(law(*attracts), system, settings).and_then(|mut simulation| {
        advance(&mut simulation, *steps)?;
        Ok(simulation)
    });
    let simulation = simulation.expect("a stable step");
    let after = momenta(simulation.system());
    let ledger = simulation.ledger();
    // What a sphere with all of the energy has, at a distance of two radii.
    let momentum = (2.0 * sphere_mass(DENSITY, RADIUS) * ledger.turnover()).sqrt();
    let changed = [momentum, 2.0 * RADIUS * momentum].into_iter().enumerate();
    let changed = changed.map(|(k, scale)| (after[k] - before[k]).norm() / scale).fold(0.0, f64::max);
    let unaccounted = ledger.physical_residual().abs() / ledger.turnover();
    let kept = if changed < ROUNDING { "to rounding" } else { "not to rounding" };
    Claim::new(
        "Section 3",
        format!("energy, momentum and angular momentum are conserved: {name}"),
        "conserved; in the supplement",
        format!(
            "momenta {kept}; {unaccounted:.0e} of the energy converted is unaccounted for, {:.0} zJ are dissipated",
            ledger.lost()
        ),
        changed < ROUNDING && unaccounted < UNACCOUNTED && ledger.lost() > 0.0,
    )
}
