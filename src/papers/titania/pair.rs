//! Two particles of the titania paper, and the dragging of one over the other.

use super::case::{Path, Titania, TwoParticles};
use super::law::Law;
use crate::papers::path::PathPlan;
use crate::spec::Vec3;
use crate::spec::titania::eq02_torque::moment_arm;
use crate::system::{Domain, Motion, Particles, System};

/// Two particles of given nominal diameters, the first beyond the second along `axis`, at the equilibrium distance plus `gap`.
pub fn pair(titania: &Titania, diameters: [f64; 2], axis: usize, gap: f64) -> System {
    let [first, second] = diameters;
    let side = 2.0 * (first + first.min(second)) + gap;
    let mut above = Vec3([0.5 * side; 3]);
    let mut below = above;
    above.0[axis] += 0.5 * first;
    below.0[axis] =
        above.0[axis] - titania.law().equilibrium(titania.particle(first).0, titania.particle(second).0) - gap;
    let mut particles = Particles::default();
    for (x, d, tag) in [(above, first, 0), (below, second, 1)] {
        let (radius, mass) = titania.particle(d);
        particles.push(x, radius, mass, tag);
    }
    System::new(particles, Domain { sides: [side; 3], periodic: [false; 3] })
}

/// The plan of a path of two particles.
pub(super) fn path<M: Law>(titania: &Titania, pair: &TwoParticles, path: &Path, overlap: f64) -> PathPlan<M> {
    let spheres = pair.diameters.each_ref().map(|d| titania.particle(d.value));
    let model = M::new(titania, &spheres.map(|(radius, _)| radius));
    let at_rest = || model.law().equilibrium(spheres[0].0, spheres[1].0);
    let distance = path.distance.as_ref().map_or_else(at_rest, |distance| distance.value);
    PathPlan {
        model,
        spheres,
        distance,
        neck: false,
        breaks: None,
        strength: None,
        legs: path.legs.clone(),
        dt: path.dt.value,
        overlap,
    }
}

/// Holds the second particle and drags the first along x under a load along y; if it rolls, it rotates without sliding.
pub fn drag(system: &mut System, velocity: f64, load: f64, rolls: bool) {
    let (particle, slab) = (system.place(0), system.place(1));
    let p = &system.particles;
    let arm = moment_arm(p.radius[particle], p.radius[slab], (p.x[particle] - p.x[slab]).norm());
    system.remove_walls();
    system.add_wall([Motion::Velocity(0.0); 3], |p, i| p.id[i] == 1);
    let driven = [Motion::Velocity(velocity), Motion::Load(-load), Motion::Velocity(0.0)];
    system.add_wall(driven, |p, i| p.id[i] == 0);
    let spin = Vec3::new(0.0, 0.0, if rolls { -velocity / arm } else { 0.0 });
    system.walls[1].spin = spin;
    system.particles.w[particle] = spin;
}
