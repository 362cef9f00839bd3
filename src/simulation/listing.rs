//! The neighbour list, and the order of spheres and bodies in memory.

use super::Simulation;
use super::shares::Shares;
use crate::error::{Halt, Reason};
use crate::forces;
use crate::geometry::{Neighbour, neighbours_but};
use crate::interrupt::Interrupt;
use crate::motion::{LoadTable, MotionTotals};
use crate::spec::{PairModel, Vec3};
use crate::system::Springs;
use crate::system::{Domain, Pose, System, bounded};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// What the neighbour list was built from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Listed {
    pub x: Vec<Vec3<f64>>,
    pub sides: [f64; 3],
    pub poses: Vec<Pose>,
    /// The first particles are moved every step: those by themselves, then the members of bodies that have a partner in range or are pulled by a spring.
    pub moving: usize,
}

impl Listed {
    /// Whether it can be what the list of a sound system was built from.
    pub(super) fn is_sound(&self, system: &System) -> bool {
        let Self { x, sides, poses, moving } = self;
        let body = &system.particles.body;
        let numbers = x.iter().flat_map(|x| &x.0);
        x.len() == body.len()
            && poses.len() == system.bodies.len()
            && *moving <= body.len()
            && bounded(numbers)
            && poses.iter().all(Pose::is_sound)
            && Domain { sides: *sides, ..system.domain }.suits(&system.particles, x)
            && body[..*moving].is_sorted()
            && body[*moving..].iter().all(|&body| body > 0)
    }
}

impl<M: PairModel> Simulation<M> {
    /// Records how far spheres have moved since neighbours were listed; whether some may have come into range that the list does not hold.
    pub(super) fn stale(&mut self, moved: &MotionTotals) -> bool {
        let strain =
            (0..3).map(|a| (self.system.domain.sides[a] / self.listed.sides[a] - 1.0).abs()).fold(0.0, f64::max);
        let deformed = strain * self.reach;
        let strayed = moved.approach() + deformed;
        self.shares.strayed = self.shares.strayed.max(strayed);
        #[expect(clippy::neg_cmp_op_on_partial_ord, reason = "a NaN is stale too")]
        let stale = !(strayed < self.settings.skin);
        stale
    }

    /// Orders bodies and particles and builds the neighbour list; contacts continue with the given springs.
    pub(super) fn list_neighbours(&mut self, springs: &Springs, interrupt: &Interrupt) -> Result<(), Halt> {
        self.place_members();
        self.put_in_order();
        let sides = self.system.domain.sides;
        let poses = self.system.bodies.iter().map(|body| body.pose).collect();
        self.listed = Listed { x: self.system.particles.x.clone(), sides, poses, moving: self.system.particles.len() };
        let mut pairs = self.search(interrupt)?;
        self.unless(interrupt)?;
        // Surfaces may touch any sphere.
        if !self.system.bodies.is_empty() && self.system.surfaces.is_empty() {
            self.part(&mut pairs);
        }
        self.build_blocks(pairs, springs)
    }

    /// Builds the list from what it was built from, which the particles are already in the order of.
    pub(super) fn relist(&mut self, springs: &Springs) -> Result<(), Halt> {
        let pairs = self.search(&Interrupt::default())?;
        if pairs.iter().any(|pair| pair.p.max(pair.q) as usize >= self.listed.moving) {
            return Err(self.halt(Reason::Snapshot));
        }
        self.build_blocks(pairs, springs)?;
        // How far spheres have moved since is not known.
        self.shares.strayed = f64::INFINITY;
        Ok(())
    }

    /// Orders particles so that neighbours in space are close in memory: first single particles, then the members of each body.
    fn put_in_order(&mut self) {
        let side = self.system.particles.mean_diameter();
        let system = &mut self.system;
        let particles = &mut system.particles;
        let mut order = forces::spatial_order(&particles.x, &system.domain, side);
        if !system.bodies.is_empty() {
            let centres: Vec<_> = system.bodies.iter().map(|body| body.pose.x).collect();
            let bodies = forces::spatial_order(&centres, &system.domain, side);
            let mut number = vec![0; bodies.len() + 1];
            for (new, &old) in (1..).zip(&bodies) {
                number[old as usize + 1] = new;
            }
            particles.body.iter_mut().for_each(|body| *body = number[*body as usize]);
            system.bodies = bodies.into_iter().map(|old| system.bodies[old as usize].clone()).collect();
            order.par_sort_by_key(|&p| particles.body[p as usize]);
        }
        *particles = particles.pick(&order);
    }

    /// All pairs near enough, and those joined by necks at any distance, but none within a rigid body or wall.
    fn search(&mut self, interrupt: &Interrupt) -> Result<Vec<Neighbour>, Halt> {
        let (model, skin, particles) = (&self.model, self.settings.skin, &self.system.particles);
        let domain = Domain { sides: self.listed.sides, ..self.system.domain };
        let largest = particles.radius.iter().copied().fold(0.0, f64::max);
        self.reach = model.range(largest, largest) + skin;
        let same = |of: &[u32], p: usize, q: usize| of[p] > 0 && of[p] == of[q];
        // A body may meet its own copy across the side of the box.
        let within = |p, q, image| same(&particles.wall, p, q) || same(&particles.body, p, q) && image == [0; 3];
        let reach = |r_i, r_j| model.range(r_i, r_j) + skin;
        let found = neighbours_but(&self.listed.x, &particles.radius, &domain, reach, within, interrupt);
        let mut pairs = found.map_err(|_| self.halt(Reason::Interrupted))?;
        let far_apart = self.necks_beyond(&pairs);
        if let Some(&(pair, _)) =
            far_apart.iter().find(|&&(_, Neighbour { p, q, image })| within(p as usize, q as usize, image))
        {
            return Err(self.halt(Reason::Neck { pair }));
        }
        if !far_apart.is_empty() {
            pairs.extend(far_apart.into_iter().map(|(_, neighbours)| neighbours));
            pairs.sort_unstable();
        }
        Ok(pairs)
    }

    /// The necks that join none of these pairs: the ids of the spheres, and their nearest copies.
    fn necks_beyond(&self, pairs: &[Neighbour]) -> Vec<((u32, u32), Neighbour)> {
        let System { particles, necks, domain, .. } = &self.system;
        let mut missing: BTreeSet<_> = necks.iter().copied().collect();
        for pair in pairs {
            if missing.is_empty() {
                return Vec::new();
            }
            let (i, j, _) = forces::bond(particles, pair.p as usize, pair.q as usize, pair.image);
            missing.remove(&(i, j));
        }
        let place = self.system.places();
        let domain = Domain { sides: self.listed.sides, ..*domain };
        let neighbours = |(i, j): (u32, u32)| {
            let (p, q) = (place[&i].min(place[&j]), place[&i].max(place[&j]));
            let image = domain.nearest_image(self.listed.x[p] - self.listed.x[q]);
            ((i, j), Neighbour { p: p as u32, q: q as u32, image })
        };
        missing.into_iter().map(neighbours).collect()
    }

    /// Moves the members of bodies that have no partner, and that no spring pulls, behind all others: their positions need no update until the next rebuild.
    fn part(&mut self, pairs: &mut [Neighbour]) {
        let particles = &self.system.particles;
        let mut moving: Vec<bool> = particles.body.iter().map(|&body| body == 0).collect();
        for p in self.system.steerings.iter().flat_map(|steering| steering.places(particles)) {
            moving[p] = true;
        }
        for pair in pairs.iter() {
            (moving[pair.p as usize], moving[pair.q as usize]) = (true, true);
        }
        let (mut order, still): (Vec<u32>, Vec<u32>) = (0..particles.len() as u32).partition(|&p| moving[p as usize]);
        self.listed.moving = order.len();
        let mut place = vec![0; particles.len()];
        for (new, &old) in (0..).zip(&order) {
            place[old as usize] = new;
        }
        for pair in pairs {
            (pair.p, pair.q) = (place[pair.p as usize], place[pair.q as usize]);
        }
        order.extend(still);
        self.system.particles = particles.pick(&order);
        self.listed.x.clone_from(&self.system.particles.x);
    }

    /// Cuts the pairs into blocks.
    fn build_blocks(&mut self, pairs: Vec<Neighbour>, springs: &Springs) -> Result<(), Halt> {
        let (particles, necks) = (&self.system.particles, &self.system.necks);
        let domain = Domain { sides: self.listed.sides, ..self.system.domain };
        self.blocks = forces::partition(
            &self.model,
            particles,
            (&self.listed.x, &domain, self.settings.skin),
            pairs,
            necks,
            springs,
            self.listed.moving,
        )
        .map_err(|reason| self.halt(reason))?;
        self.far_known = false;
        self.shares = Shares::default();
        self.load_table = LoadTable::find(particles, self.listed.moving, self.system.bodies.len(), &self.blocks);
        self.on_walls = forces::places(&self.blocks)
            .filter_map(|(p, block, place)| Some((particles.wall[p].checked_sub(1)?, block, place)))
            .collect();
        Ok(())
    }
}
