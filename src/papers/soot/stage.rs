//! The set-up of a stage: surfaces, velocities and necks of the aggregate.

use super::case::{Deposition, Indentation, Indented, Restructuring, Solid, SootStage};
use super::tip::tetrahedron;
use crate::error::Error;
use crate::initial::aggregate::necks::keep_fraction;
use crate::initial::stl::read_stl;
use crate::random::Stream;
use crate::simulation::remove_necks;
use crate::spec::soot::{SUBSTRATE, TIP};
use crate::spec::{PairModel, Vec3};
use crate::system::Mesh;
use crate::system::{Particles, PrescribedMotion, Shape, Surface, System};
use std::collections::BTreeSet;
use std::path::Path;

/// The inputs common to all stages.
pub(super) struct Ground {
    /// Random numbers that choose which necks are removed.
    pub necks: Stream,
    /// Random numbers that choose the sphere to be indented.
    pub target: Stream,
    /// Radius of the spheres, nm.
    pub radius: f64,
    /// The key of the stage in the case.
    pub key: String,
}

/// The initial system of a stage.
pub(super) fn set_up<M: PairModel>(stage: &SootStage, mut ground: Ground, mut system: System) -> Result<System, Error> {
    system.surfaces.retain(|surface| surface.material != TIP);
    match stage {
        SootStage::Deposition(test) => deposit(test, solid(stage)?, ground.radius, &mut system),
        SootStage::Indentation(test) => {
            break_necks::<M>(test.keep_necks, &mut ground.necks, &mut system);
            indent(test, solid(stage)?, &mut ground, &mut system)?;
        }
        SootStage::Restructuring(Restructuring { keep_necks, .. }) => {
            break_necks::<M>(*keep_necks, &mut ground.necks, &mut system);
        }
    }
    Ok(system)
}

/// Whether a stage removes necks.
pub(super) fn removes_necks(stage: &SootStage) -> bool {
    match stage {
        SootStage::Deposition(_) => false,
        SootStage::Indentation(Indentation { keep_necks, .. })
        | SootStage::Restructuring(Restructuring { keep_necks, .. }) => *keep_necks < 1.0,
    }
}

/// The surface that a stage reads from a file, if any. The aggregate is placed outside it.
pub(super) fn solid(stage: &SootStage) -> Result<Option<Mesh>, Error> {
    let Some(Solid { stl, unit }) = stage.solid() else { return Ok(None) };
    let mesh = read_stl(stl, unit.value)?;
    if mesh.is_closed() && mesh.volume() < 0.0 {
        return Err(Error::input(stl, "its normals point inwards, expected normals that point out of the body"));
    }
    Ok(Some(mesh))
}

fn deposit(test: &Deposition, solid: Option<Mesh>, radius: f64, system: &mut System) {
    let particles = &mut system.particles;
    let lowest = (0..particles.len()).map(|p| particles.x[p].0[2] - particles.radius[p]).fold(f64::INFINITY, f64::min);
    let lowered = Vec3([0.0, 0.0, test.gap.value(radius) - lowest]);
    particles.x.iter_mut().for_each(|x| *x = *x + lowered);
    particles.v.fill(Vec3([0.0, 0.0, -test.velocity.value]));
    particles.w.fill(Vec3::zero());
    system.lag = 0.0;
    let substrate = match solid {
        None => plane(),
        Some(mesh) => {
            let [low, high] = mesh.bounds();
            let middle = (low + high) * 0.5;
            let [a, b, _] = system.domain.sides;
            let shape = Shape::Mesh(mesh.displaced(Vec3([0.5 * a - middle.0[0], 0.5 * b - middle.0[1], -high.0[2]])));
            Surface::new("substrate", SUBSTRATE, shape, PrescribedMotion::Still)
        }
    };
    system.surfaces = vec![substrate];
}

/// The substrate as a plane.
pub(super) fn plane() -> Surface {
    let shape = Shape::Plane { point: Vec3::zero(), normal: Vec3([0.0, 0.0, 1.0]) };
    Surface::new("substrate", SUBSTRATE, shape, PrescribedMotion::Still)
}

fn indent(test: &Indentation, solid: Option<Mesh>, ground: &mut Ground, system: &mut System) -> Result<(), Error> {
    let (mesh, lowest) = match solid {
        None => (tetrahedron(ground.radius), Vec3::zero()),
        Some(mesh) => {
            let lowest = mesh.vertices().iter().copied().reduce(|a, b| if b.0[2] < a.0[2] { b } else { a });
            (mesh, lowest.expect("a surface has corners"))
        }
    };
    let particles = &system.particles;
    let motion =
        PrescribedMotion::Reversal { velocity: test.velocity.value, rate: test.turn_rate.value, turn: test.turn.value };
    let gap = test.gap.value(ground.radius);
    let at = |apex: Vec3<f64>| Surface::new("tip", TIP, Shape::Mesh(mesh.displaced(apex - lowest)), motion);
    let above = |p: usize| at(particles.x[p] + Vec3([0.0, 0.0, particles.radius[p] + gap]));
    let is_free = |p: usize| is_unhindered(particles, p) && is_met_first(particles, p, &above(p));
    let tip = match &test.indent {
        None => {
            let mut free: Vec<usize> = (0..particles.len()).filter(|&p| is_free(p)).collect();
            free.sort_by_key(|&p| particles.id[p]);
            let drawn = ground.target.uniform() * free.len() as f64;
            let Some(&target) = free.get(drawn as usize) else {
                let file = test.tip.as_ref().map(|tip| tip.stl.as_path()).unwrap_or(Path::new("tip"));
                return Err(Error::input(file, "its lowest point is above no sphere that it would touch first"));
            };
            above(target)
        }
        Some(Indented::Sphere(number)) => {
            let place = particles.id.iter().position(|&id| u64::from(id) == *number);
            let Some(target) = place.filter(|&p| is_free(p)) else {
                let free = (0..particles.len()).filter(|&p| is_free(p)).map(|p| particles.id[p]);
                let free: BTreeSet<u32> = free.collect();
                let few: Vec<String> = free.iter().take(20).map(u32::to_string).collect();
                let others = if free.len() > few.len() { ", ..." } else { "" };
                let what = format!("found `{number}`, expected an exposed sphere: {}{others}", few.join(", "));
                return Err(Error::of_key(format!("{}.indent.sphere", ground.key), what));
            };
            above(target)
        }
        Some(Indented::Place([x, y])) => {
            let [a, b, _] = system.domain.sides;
            let over = |z: f64| at(Vec3([0.5 * a + x.value, 0.5 * b + y.value, z]));
            lowered(particles, gap, over).ok_or_else(|| {
                let what = format!("found `{x}, {y}`, expected a place above a sphere");
                Error::of_key(format!("{}.indent.place", ground.key), what)
            })?
        }
    };
    system.surfaces.push(tip);
    Ok(())
}

/// The tip above a place, so low that its gap to the nearest sphere is this; none if it would reach the substrate before. Its gaps change by at most the way
/// that it is lowered, so it never goes too far.
fn lowered(Particles { x, radius, .. }: &Particles, gap: f64, over: impl Fn(f64) -> Surface) -> Option<Surface> {
    let mut height = (0..x.len()).map(|p| x[p].0[2] + radius[p]).fold(0.0, f64::max) + gap;
    let mut seen = Vec::new();
    loop {
        let tip = over(height);
        let mut nearest = f64::INFINITY;
        for p in 0..x.len() {
            seen.clear();
            tip.distance_minima(x[p], f64::INFINITY, &mut seen);
            nearest = seen.iter().map(|place| place.distance - radius[p]).fold(nearest, f64::min);
        }
        if nearest - gap <= NEAR {
            return Some(tip);
        }
        height -= nearest - gap;
        if height <= gap {
            return None;
        }
    }
}

/// Precision of the gap between the tip and the sphere that it approaches, nm.
const NEAR: f64 = 1e-9;

/// Whether no other sphere hides a sphere from above.
fn is_unhindered(Particles { x, radius, .. }: &Particles, p: usize) -> bool {
    let hides = |q: usize| {
        let [a, b, c] = (x[q] - x[p]).0;
        q != p && c > 0.0 && (a * a + b * b).sqrt() < radius[p] + radius[q]
    };
    !(0..x.len()).any(hides)
}

/// Whether a tip above a sphere touches that sphere first: its flanks have a small slope, so a higher sphere may be in its way. The highest sphere is
/// always touched first.
fn is_met_first(Particles { x, radius, .. }: &Particles, p: usize, tip: &Surface) -> bool {
    let mut seen = Vec::new();
    let mut gap = |q: usize| {
        seen.clear();
        tip.distance_minima(x[q], f64::INFINITY, &mut seen);
        seen[0].distance - radius[q]
    };
    let least = gap(p);
    (0..x.len()).all(|q| q == p || gap(q) > least)
}

/// Removes necks of a model, chosen at random.
pub(super) fn break_necks<M: PairModel>(keep: f64, stream: &mut Stream, system: &mut System) {
    let all: Vec<(usize, usize)> = system.necks.iter().map(|&(i, j)| (i as usize, j as usize)).collect();
    let kept = keep_fraction(&all, keep, stream).into_iter().map(|(i, j)| (i as u32, j as u32));
    let kept: BTreeSet<(u32, u32)> = kept.collect();
    remove_necks::<M>(&mut system.necks, &mut system.springs, |pair| !kept.contains(&pair));
}
