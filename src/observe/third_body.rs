//! The third body between two sliding bodies.
//!
//! Over a window of sliding, every sphere is assigned to the closest of three rigid motions: that of the lower
//! body, that of the upper body, or a third one, which is fitted to its own members until nothing changes. The *third body* is
//! the largest cluster of spheres of the third motion. No velocity threshold is needed: the surface of a rolling particle is as fast as the
//! body it touches, but it does not stay so.

use super::Link;
use super::rotation::RigidMotion;
use crate::geometry::clusters::Clusters;
use crate::spec::Vec3;
use crate::system::System;

/// The motion that a sphere took part in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mover {
    /// That of the lower body.
    Bottom,
    /// That of the upper body.
    Top,
    /// Neither.
    Third,
}

/// Every sphere's motion over one window, and the third body.
#[derive(Clone, Debug)]
pub struct Motions {
    /// By place. Spheres of the third motion outside the third body are of the nearer of the two other bodies.
    pub of: Vec<Mover>,
    /// None when no cluster of at least three spheres moves on its own.
    pub third: Option<ThirdBody>,
}

/// The third body over one window.
#[derive(Clone, Debug)]
pub struct ThirdBody {
    /// Places of its spheres.
    pub members: Vec<usize>,
    /// Their mass, ag.
    pub mass: f64,
    /// Their extent along the normal, surfaces included, nm.
    pub height: f64,
    /// Rotation in the window in the sense of rolling (the upper body moving to +x), rad.
    pub rolled: f64,
    /// How well its motion is a rotation: see [`RigidMotion::rigidity`].
    pub rigidity: f64,
}

/// What the window is compared with.
pub struct Window<'a> {
    /// Centres at the beginning, in the order of ids.
    pub before: &'a [Vec3<f64>],
    /// Displacement of the upper body since, nm; the lower one rests.
    pub slid: Vec3<f64>,
}

/// Fits of the third motion before giving up: each lowers the sum of squared distances, few are ever needed.
const MOST_FITS: usize = 50;

impl Motions {
    /// Finds them.
    pub fn find(system: &System, links: &[Link], window: &Window) -> Self {
        let p = &system.particles;
        let moved: Vec<Vec3<f64>> = (0..p.len()).map(|i| p.x[i] - window.before[p.id[i] as usize]).collect();
        let distance = |i: usize| moved[i].norm().min((moved[i] - window.slid).norm());
        let mut of: Vec<Mover> = moved
            .iter()
            .map(|&u| if u.norm() <= (u - window.slid).norm() { Mover::Bottom } else { Mover::Top })
            .collect();
        let third = third_body(system, links, &moved, distance, 0.25 * window.slid.norm());
        for &i in third.iter().flat_map(|body| &body.members) {
            of[i] = Mover::Third;
        }
        Self { of, third }
    }

    /// Number of links between spheres of two motions.
    pub fn links_between(&self, links: &[Link], one: Mover, other: Mover) -> usize {
        let joins = |link: &&Link| {
            let pair = (self.of[link.i], self.of[link.j]);
            pair == (one, other) || pair == (other, one)
        };
        links.iter().filter(joins).count()
    }
}

/// `distance` measures the difference of a sphere's motion from the motions of both bodies; the first guess keeps `clear` of them.
fn third_body(
    system: &System,
    links: &[Link],
    moved: &[Vec3<f64>],
    distance: impl Fn(usize) -> f64,
    clear: f64,
) -> Option<ThirdBody> {
    let p = &system.particles;
    let n = p.len();
    let mut third: Vec<bool> = (0..n).map(|i| p.wall[i] == 0 && distance(i) > clear).collect();
    let origin = periodic_centre(system, &third)?;
    let near: Vec<Vec3<f64>> = (0..n).map(|i| near_image(system, p.x[i], origin)).collect();
    for _ in 0..MOST_FITS {
        let motion = fit(&near, moved, &p.mass, |i| third[i])?;
        let miss = |i: usize| (motion.apply(near[i] - moved[i]) - near[i]).norm();
        let next: Vec<bool> = (0..n).map(|i| p.wall[i] == 0 && miss(i) < distance(i)).collect();
        if next == third {
            break;
        }
        third = next;
    }
    let bonds = links.iter().filter(|link| third[link.i] && third[link.j]).map(|link| (link.i, link.j));
    let members = Clusters::new(n, bonds).largest(|i| third[i]);
    let mut body = vec![false; n];
    members.iter().for_each(|&i| body[i] = true);
    let own = fit(&near, moved, &p.mass, |i| body[i])?;
    let extreme =
        |sign: f64| members.iter().map(|&i| sign * p.x[i].0[1] + p.radius[i]).fold(f64::NEG_INFINITY, f64::max);
    Some(ThirdBody {
        mass: members.iter().map(|&i| p.mass[i]).sum(),
        height: extreme(1.0) + extreme(-1.0),
        rolled: -own.angle_about_z(),
        rigidity: own.rigidity,
        members,
    })
}

fn fit(near: &[Vec3<f64>], moved: &[Vec3<f64>], mass: &[f64], member: impl Fn(usize) -> bool) -> Option<RigidMotion> {
    let members: Vec<usize> = (0..near.len()).filter(|&i| member(i)).collect();
    let after: Vec<_> = members.iter().map(|&i| near[i]).collect();
    let before: Vec<_> = members.iter().map(|&i| near[i] - moved[i]).collect();
    let mass: Vec<_> = members.iter().map(|&i| mass[i]).collect();
    RigidMotion::fit(&before, &after, &mass)
}

/// Centre of the spheres that `member` picks, by the mean direction on the circle that a periodic axis is.
fn periodic_centre(system: &System, member: &[bool]) -> Option<Vec3<f64>> {
    let p = &system.particles;
    let members: Vec<usize> = (0..p.len()).filter(|&i| member[i]).collect();
    if members.is_empty() {
        return None;
    }
    Some(Vec3(std::array::from_fn(|a| {
        let mean = |f: &dyn Fn(f64) -> f64| members.iter().map(|&i| f(p.x[i].0[a])).sum::<f64>() / members.len() as f64;
        if !system.domain.periodic[a] {
            return mean(&|x| x);
        }
        let scale = std::f64::consts::TAU / system.domain.sides[a];
        libm::atan2(mean(&|x| libm::sin(scale * x)), mean(&|x| libm::cos(scale * x))) / scale
    })))
}

/// The image of `x` that is nearest to `origin`.
fn near_image(system: &System, x: Vec3<f64>, origin: Vec3<f64>) -> Vec3<f64> {
    Vec3(std::array::from_fn(|a| {
        let side = system.domain.sides[a];
        let images = if system.domain.periodic[a] { ((x.0[a] - origin.0[a]) / side).round() } else { 0.0 };
        x.0[a] - images * side
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::{Domain, Particles};

    const SIDE: f64 = 24.0;

    /// Two slabs of unit spheres and a disc of diameter 8 between them, at `x` across the periodic boundary or not; returns
    /// the state before and after the upper slab slid by `slid` while the disc did what `motion` says about its centre.
    fn slide(x: f64, slid: f64, motion: impl Fn(Vec3<f64>) -> Vec3<f64>) -> (System, Vec<Vec3<f64>>) {
        let mut particles = Particles::default();
        let mut after = Vec::new();
        let mut add = |at: Vec3<f64>, tag: u32, displacement: Vec3<f64>| {
            particles.push(at, 0.5, 1.0, tag);
            after.push(at + displacement);
        };
        for a in 0..24 {
            for c in 0..4 {
                let (along, across) = (f64::from(a), f64::from(c));
                add(Vec3([along, 0.5, across]), 1, Vec3::zero());
                add(Vec3([along, 9.5, across]), 2, Vec3([slid, 0.0, 0.0]));
            }
        }
        let centre = Vec3([x, 5.0, 1.5]);
        for a in -4..=4 {
            for b in -4..=4 {
                for c in 0..4 {
                    let at = Vec3([f64::from(a), f64::from(b), f64::from(c) - 1.5]);
                    if a * a + b * b <= 16 {
                        add(centre + at, 3, motion(at));
                    }
                }
            }
        }
        let before = particles.x.clone();
        particles.x = after;
        (System::new(particles, Domain { sides: [SIDE, 10.0, 4.0], periodic: [true, false, true] }), before)
    }

    fn touching(system: &System) -> Vec<Link> {
        let x = &system.particles.x;
        let mut links = Vec::new();
        for i in 0..x.len() {
            for j in 0..i {
                let branch = near_image(system, x[j], x[i]) - x[i];
                if branch.norm() < 1.3 {
                    links.push(Link { i, j, branch, gap: branch.norm() - 1.0, force: Vec3::zero() });
                }
            }
        }
        links
    }

    fn found(system: &System, before: &[Vec3<f64>], slid: f64) -> Motions {
        Motions::find(system, &touching(system), &Window { before, slid: Vec3([slid, 0.0, 0.0]) })
    }

    #[test]
    fn a_rolling_disc_is_found_wherever_it_is_in_the_periodic_box() {
        for x in [12.0, 0.0, 23.0] {
            let (slid, angle) = (1.8f64, 1.8f64 / 9.0);
            let roll = |at: Vec3<f64>| {
                let [u, v, _] = at.0;
                let (sin, cos) = angle.sin_cos();
                Vec3([u * (cos - 1.0) + v * sin + 0.5 * slid, v * (cos - 1.0) - u * sin, 0.0])
            };
            let (system, before) = slide(x, slid, roll);
            let third = found(&system, &before, slid).third.unwrap();
            let disc = system.particles.tag.iter().filter(|&&tag| tag == 3).count();
            // Spheres at the rims, which touch the slabs, may be taken for theirs.
            assert!(
                third.members.len() >= disc * 3 / 4 && third.members.len() <= disc,
                "{} of {disc}",
                third.members.len()
            );
            assert!(third.members.iter().all(|&i| system.particles.tag[i] == 3));
            assert!((third.rolled - angle).abs() < 1e-9, "{}", third.rolled);
            assert!(third.rigidity > 1.0 - 1e-9);
        }
    }

    #[test]
    fn a_sheared_disc_turns_half_as_much_and_is_not_rigid() {
        let slid = 0.9;
        let (system, before) = slide(12.0, slid, |at| Vec3([slid * (0.5 + at.0[1] / 9.0), 0.0, 0.0]));
        let third = found(&system, &before, slid).third.unwrap();
        assert!(third.rolled < 0.6 * slid / 9.0, "{}", third.rolled);
        assert!(third.rigidity < 0.6, "{}", third.rigidity);
    }

    #[test]
    fn a_disc_that_stays_on_one_body_is_no_third_body() {
        let (system, before) = slide(12.0, 2.0, |_| Vec3([2.0, 0.0, 0.0]));
        let motions = found(&system, &before, 2.0);
        assert!(motions.third.is_none());
        assert_eq!(motions.of.iter().filter(|&&m| m == Mover::Bottom).count(), 96);
        // The disc, moving with the upper body, slides over the lower one.
        assert!(motions.links_between(&touching(&system), Mover::Bottom, Mover::Top) > 0);
    }

    #[test]
    fn the_centre_of_spheres_on_both_sides_of_a_boundary_is_between_them() {
        let (mut system, _) = slide(12.0, 0.0, |_| Vec3::zero());
        (system.particles.x[0], system.particles.x[1]) = (Vec3([23.5, 1.0, 0.5]), Vec3([0.9, 2.0, 0.7]));
        let member: Vec<bool> = (0..system.particles.len()).map(|i| i < 2).collect();
        let centre = periodic_centre(&system, &member).expect("two spheres");
        assert!((centre - Vec3([0.2, 1.5, 0.6])).norm() < 1e-12, "{centre:?}");
        assert!(periodic_centre(&system, &vec![false; system.particles.len()]).is_none());
    }
}
