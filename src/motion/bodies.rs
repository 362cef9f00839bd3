//! Rigid bodies: sums of the loads on their spheres, one time step, and the update of the spheres that have partners in range.

use super::members::Members;
use super::push::Push;
use super::{MotionTotals, Step};
use crate::forces::{Block, LANES, places, vectorised};
use crate::spec::mechanics::body::aggregate_drag;
use crate::spec::mechanics::kick_and_drift::drift;
use crate::spec::mechanics::rotation::to_space;
use crate::spec::mechanics::work::work;
use crate::spec::{PairModel, Vec3};
use crate::system::{Body, Particles, Pose};
use rayon::prelude::*;
use std::ops::Range;

/// Where in the blocks the loads on the members of bodies are, body by body.
#[derive(Default)]
pub struct LoadTable {
    /// How many particles are by themselves; they come first.
    pub single: usize,
    /// Where the moving members of each body begin, counted from the first member of any body.
    members: Vec<usize>,
    /// Where the loads on each body begin.
    loads: Vec<usize>,
    /// The loads: member, block, place within the block.
    at: Vec<(u32, u32, u32)>,
}

/// Bodies that one thread advances at a time: the sums over them do not depend on how many threads there are.
const CHUNK: usize = 128;

impl LoadTable {
    /// Finds the loads on members, which follow the particles by themselves in the order of their bodies, the first `moving` particles in all.
    pub fn find<M: PairModel>(particles: &Particles, moving: usize, bodies: usize, blocks: &[Block<M>]) -> Self {
        let single = particles.body[..moving].partition_point(|&body| body == 0);
        let mut load_table = Self { single, members: vec![0; bodies + 1], loads: vec![0; bodies + 1], at: Vec::new() };
        for (p, block, place) in places(blocks).filter(|place| place.0 >= single) {
            load_table.at.push(((p - single) as u32, block, place));
            load_table.loads[particles.body[p] as usize] += 1;
        }
        load_table.at.sort_unstable();
        for p in single..moving {
            load_table.members[particles.body[p] as usize] += 1;
        }
        for b in 0..bodies {
            load_table.members[b + 1] += load_table.members[b];
            load_table.loads[b + 1] += load_table.loads[b];
        }
        load_table
    }
}

/// Some bodies, and their members that move every step.
struct BodyGroup<'a> {
    bodies: &'a mut [Body],
    listed: &'a [Pose],
    x: &'a mut [Vec3<f64>],
    v: &'a mut [Vec3<f64>],
    w: &'a mut [Vec3<f64>],
}

/// Advances all bodies by one step, together with their members in `moving`; also returns the correction of the sum of branch
/// vector times force, because forces inside a body do not contribute to the stress of the whole.
pub fn advance_bodies<M: PairModel>(
    (bodies, listed): (&mut [Body], &[Pose]),
    particles: &mut Particles,
    moving: Range<usize>,
    (load_table, blocks): (&LoadTable, &[Block<M>]),
    step: &Step,
) -> (MotionTotals, [f64; 3]) {
    let arms = &particles.arm[moving.clone()];
    let (mut x, mut v, mut w) =
        (&mut particles.x[moving.clone()], &mut particles.v[moving.clone()], &mut particles.w[moving]);
    let mut groups = Vec::with_capacity(bodies.len().div_ceil(CHUNK));
    for (number, (bodies, listed)) in bodies.chunks_mut(CHUNK).zip(listed.chunks(CHUNK)).enumerate() {
        let first = number * CHUNK;
        let count = load_table.members[first + bodies.len()] - load_table.members[first];
        let (own_x, own_v, own_w);
        ((own_x, x), (own_v, v), (own_w, w)) = (x.split_at_mut(count), v.split_at_mut(count), w.split_at_mut(count));
        groups.push((first, BodyGroup { bodies, listed, x: own_x, v: own_v, w: own_w }));
    }
    let moved: Vec<(MotionTotals, [f64; 3])> = groups
        .into_par_iter()
        .with_max_len(1)
        .map(|(first, mut crew)| {
            let mut sums = (MotionTotals::default(), [0.0; 3]);
            for begin in (0..crew.bodies.len()).step_by(LANES) {
                let group = begin..(begin + LANES).min(crew.bodies.len());
                crew.advance(group, first, arms, (load_table, blocks), step, &mut sums);
            }
            sums
        })
        .collect();
    let both = |a: (MotionTotals, [f64; 3]), b: (MotionTotals, [f64; 3])| {
        (a.0.and(b.0), std::array::from_fn(|k| a.1[k] + b.1[k]))
    };
    moved.into_iter().fold((MotionTotals::default(), [0.0; 3]), both)
}

impl BodyGroup<'_> {
    /// Advances up to as many bodies as are computed side by side.
    fn advance<M: PairModel>(
        &mut self,
        group: Range<usize>,
        first: usize,
        arms: &[Vec3<f64>],
        (load_table, blocks): (&LoadTable, &[Block<M>]),
        step: &Step,
        (moved, virial): &mut (MotionTotals, [f64; 3]),
    ) {
        let begin = load_table.members[first];
        let mut push = Push::new(step.dt);
        for (lane, k) in group.clone().enumerate() {
            let body = &self.bodies[k];
            let (mut force, mut torque) = (Vec3::zero(), Vec3::zero());
            for &(p, block, place) in &load_table.at[load_table.loads[first + k]..load_table.loads[first + k + 1]] {
                let [fx, fy, fz, tx, ty, tz, ..] = blocks[block as usize].loads[place as usize].0;
                let (pull, r) = (Vec3([fx, fy, fz]), self.x[p as usize - begin] - body.pose.x);
                force = force + pull;
                torque = torque + r.cross(pull) + Vec3([tx, ty, tz]);
                for a in 0..3 {
                    virial[a] += r.0[a] * pull.0[a];
                }
            }
            if step.damping > 0.0 && body.wall == 0 {
                let (drag, brake) = drag(body, step.damping);
                moved.drag -= work(drag, body.v, brake, body.omega(), step.dt);
                (force, torque) = (force + drag, torque + brake);
            }
            push.put(lane, body, &self.listed[k], force, torque);
        }
        let [kinetic, scheme, away] = vectorised(step.instructions, &mut push);
        let mut omegas = [Vec3::zero(); LANES];
        for (lane, k) in group.clone().enumerate() {
            let (body, before) = (&mut self.bodies[k], &self.listed[k]);
            let turned = match (body.wall as usize).checked_sub(1) {
                None => {
                    omegas[lane] = push.take(lane, body);
                    moved.kinetic += kinetic.0[lane];
                    moved.scheme += scheme.0[lane];
                    moved.add_momentum_flux(body.mass, body.v);
                    away.0[lane]
                }
                Some(wall) => {
                    body.v = step.walls[wall].velocity;
                    body.pose.x = drift(body.pose.x, body.v, step.dt);
                    0.0
                }
            };
            for a in 0..3 {
                body.pose.x.0[a] *= step.growth[a];
                let displacement = body.pose.x.0[a] - before.x.0[a] * step.stretch[a];
                moved.least[a] = moved.least[a].min(displacement - turned);
                moved.most[a] = moved.most[a].max(displacement + turned);
            }
        }
        let ends = &load_table.members[first + group.start..=first + group.end];
        let (arms, own) = (&arms[ends[0]..ends[group.len()]], ends[0] - begin..ends[group.len()] - begin);
        let (x, v, w) = (&mut self.x[own.clone()], &mut self.v[own.clone()], &mut self.w[own]);
        vectorised(step.instructions, Members { bodies: &self.bodies[group], omegas: &omegas, ends, arms, x, v, w });
    }
}

/// Drag on all spheres of a body: force and torque.
fn drag(body: &Body, eta: f64) -> (Vec3<f64>, Vec3<f64>) {
    let Body { pose: Pose { q_0, q, .. }, v, lever, spread: [d_x, d_y, d_z], .. } = *body;
    let into = |u: Vec3<f64>| to_space(q_0, -q, u);
    let (force, torque) = aggregate_drag(eta, body.count, lever, d_x, d_y, d_z, into(v), into(body.omega()));
    (to_space(q_0, q, force), to_space(q_0, q, torque))
}
