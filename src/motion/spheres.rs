//! One time step of the spheres of a block.

use crate::forces::{AHEAD, Instructions, LANES, MergedLoads, Square, Vectorised, prefetch, vectorised};
use crate::spec::Vec3;
use crate::spec::mechanics::box_stress::momentum_flux;
use crate::spec::mechanics::drag::global_damping;
use crate::spec::mechanics::kick_and_drift::drift;
use crate::spec::mechanics::kinetic_energy::kinetic_energy;
use crate::spec::mechanics::sphere::moment_of_inertia;
use crate::spec::mechanics::symplectic_euler::symplectic_euler;
use crate::spec::mechanics::work::drag_loss;
use crate::system::{Particles, Wall};

/// Moment of inertia of a sphere, ag nm^2.
pub fn inertia(particles: &Particles, p: usize) -> f64 {
    moment_of_inertia(particles.mass[p], particles.radius[p])
}

/// The state of the spheres of a block that are by themselves, and where they were when the neighbour list was built.
pub struct Spheres<'a> {
    /// Centres.
    pub x: &'a mut [Vec3<f64>],
    /// Velocities.
    pub v: &'a mut [Vec3<f64>],
    /// Angular velocities.
    pub w: &'a mut [Vec3<f64>],
    /// Radii.
    pub radius: &'a [f64],
    /// Masses.
    pub mass: &'a [f64],
    /// Walls they belong to.
    pub wall: &'a [u32],
    /// Centres when the neighbour list was built.
    pub listed: &'a [Vec3<f64>],
}

impl<'a> Spheres<'a> {
    /// The first `count` spheres, and the rest.
    pub fn split(self, count: usize) -> (Self, Self) {
        let (x, other_x) = self.x.split_at_mut(count);
        let (v, other_v) = self.v.split_at_mut(count);
        let (w, other_w) = self.w.split_at_mut(count);
        let (radius, other_radius) = self.radius.split_at(count);
        let (mass, other_mass) = self.mass.split_at(count);
        let (wall, other_wall) = self.wall.split_at(count);
        let (listed, other_listed) = self.listed.split_at(count);
        let rest = Self {
            x: other_x,
            v: other_v,
            w: other_w,
            radius: other_radius,
            mass: other_mass,
            wall: other_wall,
            listed: other_listed,
        };
        (Self { x, v, w, radius, mass, wall, listed }, rest)
    }
}

/// The parameters of a step, common to all spheres.
pub struct Step<'a> {
    /// Time step, ns.
    pub dt: f64,
    /// Coefficient of the global damping, ag/ns.
    pub damping: f64,
    /// The walls, already driven.
    pub walls: &'a [Wall],
    /// Factors by which the box grows.
    pub growth: [f64; 3],
    /// Factors by which it will have grown since the neighbour list was built.
    pub stretch: [f64; 3],
    /// Vector instructions in use.
    pub instructions: Instructions,
}

/// Sums over the spheres of a block in one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionTotals {
    /// Kinetic energy after the step, zJ.
    pub kinetic: f64,
    /// Diagonal of the sum of `m v v` after the step, zJ.
    pub momentum_flux: [f64; 3],
    /// Energy lost to the global damping, zJ.
    pub drag: f64,
    /// What the integration scheme adds to the kinetic energy: `dt^2 (F^2 / m + T^2 / I) / 2`.
    pub scheme: f64,
    /// Least displacement since the neighbour list was built, by axis.
    pub least: [f64; 3],
    /// Largest displacement since the neighbour list was built, by axis.
    pub most: [f64; 3],
}

impl Default for MotionTotals {
    fn default() -> Self {
        Self {
            kinetic: 0.0,
            momentum_flux: [0.0; 3],
            drag: 0.0,
            scheme: 0.0,
            least: [f64::INFINITY; 3],
            most: [f64::NEG_INFINITY; 3],
        }
    }
}

impl MotionTotals {
    /// Both together.
    pub fn and(self, other: Self) -> Self {
        Self {
            kinetic: self.kinetic + other.kinetic,
            momentum_flux: std::array::from_fn(|a| self.momentum_flux[a] + other.momentum_flux[a]),
            drag: self.drag + other.drag,
            scheme: self.scheme + other.scheme,
            least: std::array::from_fn(|a| self.least[a].min(other.least[a])),
            most: std::array::from_fn(|a| self.most[a].max(other.most[a])),
        }
    }

    /// Adds the momentum flux of a mass.
    pub fn add_momentum_flux(&mut self, m: f64, v: Vec3<f64>) {
        for (sum, flux) in self.momentum_flux.iter_mut().zip(momentum_flux(m, v).0) {
            *sum += flux;
        }
    }

    /// Enters a sphere's part in the sums.
    #[inline(always)]
    fn enter(&mut self, [kinetic, drag, scheme, xx, yy, zz]: [f64; 6]) {
        self.kinetic += kinetic;
        self.drag += drag;
        self.scheme += scheme;
        for (sum, part) in self.momentum_flux.iter_mut().zip([xx, yy, zz]) {
            *sum += part;
        }
    }

    /// Enters the displacement of a sphere since the neighbour list was built.
    #[inline(always)]
    pub fn stray(&mut self, way: Vec3<f64>) {
        for (a, way) in way.0.into_iter().enumerate() {
            self.least[a] = if way < self.least[a] { way } else { self.least[a] };
            self.most[a] = if way > self.most[a] { way } else { self.most[a] };
        }
    }

    /// No two spheres have come closer than this since the neighbour list was built, nm.
    pub fn approach(&self) -> f64 {
        let range = Vec3(std::array::from_fn(|a| self.most[a] - self.least[a])).norm();
        let farthest = Vec3(std::array::from_fn(|a| self.most[a].abs().max(self.least[a].abs()))).norm();
        range.min(2.0 * farthest)
    }
}

/// Moves spheres, on which these loads act, by one step of Eq. 1.
pub fn advance(loads: MergedLoads, spheres: Spheres, step: &Step) -> MotionTotals {
    vectorised(step.instructions, Advance { loads, spheres, step })
}

/// Spheres of a block, the loads on them, and the step they take.
struct Advance<'a> {
    loads: MergedLoads<'a>,
    spheres: Spheres<'a>,
    step: &'a Step<'a>,
}

/// A sphere after a step, and its part in the sums.
struct Moved {
    x: Vec3<f64>,
    v: Vec3<f64>,
    w: Vec3<f64>,
    /// Kinetic energy, loss to the drag, addition by the scheme, momentum flux.
    sums: [f64; 6],
}

impl Vectorised for Advance<'_> {
    type Outcome = MotionTotals;

    #[inline(always)]
    fn run(mut self, across: impl Fn(Square) -> Square) -> MotionTotals {
        let mut moved = MotionTotals::default();
        let mut extremes = [[[f64::INFINITY; LANES]; 3], [[f64::NEG_INFINITY; LANES]; 3]];
        let (count, whole) = (self.loads.len(), self.loads.len() / LANES * LANES);
        for begin in (0..whole).step_by(LANES) {
            if self.spheres.wall[begin..begin + LANES] == [0; LANES] {
                self.advance_free(begin, &across, &mut moved, &mut extremes);
            } else {
                (begin..begin + LANES).for_each(|p| self.advance_one(p, &mut moved));
            }
        }
        (whole..count).for_each(|p| self.advance_one(p, &mut moved));
        for a in 0..3 {
            moved.least[a] = extremes[0][a].into_iter().fold(moved.least[a], f64::min);
            moved.most[a] = extremes[1][a].into_iter().fold(moved.most[a], f64::max);
        }
        moved
    }
}

impl Advance<'_> {
    #[inline(always)]
    fn next_load(&mut self) -> [f64; LANES] {
        self.loads.next().expect("a load for every sphere").0
    }

    /// Advances spheres side by side, none of which belongs to a wall. Sums are taken in the order of the spheres.
    #[inline(always)]
    fn advance_free(
        &mut self,
        begin: usize,
        across: impl Fn(Square) -> Square,
        moved: &mut MotionTotals,
        [least, most]: &mut [[[f64; LANES]; 3]; 2],
    ) {
        let mut loads = [[0.0; LANES]; LANES];
        for load in &mut loads {
            *load = self.next_load();
        }
        let [fx, fy, fz, tx, ty, tz, ..] = across(loads);
        let (mut sums, mut ways) = ([[0.0; LANES]; 6], [[0.0; LANES]; 3]);
        let Self { spheres: Spheres { x, v, w, radius, mass, listed, .. }, step, .. } = self;
        for of in [&**x, &**v, &**w, *listed] {
            if let Some(ahead) = of.get(begin + AHEAD..).and_then(<[_]>::first_chunk::<LANES>) {
                prefetch(ahead);
            }
        }
        // Copies, of which the compiler knows that they do not overlap.
        let (mut places, mut velocities, mut spins) = (chunk(x, begin), chunk(v, begin), chunk(w, begin));
        let (radius, mass, listed) = (chunk(radius, begin), chunk(mass, begin), chunk(listed, begin));
        for lane in 0..LANES {
            let load = [fx[lane], fy[lane], fz[lane], tx[lane], ty[lane], tz[lane]];
            let before = [places[lane], velocities[lane], spins[lane]];
            let after = free(step, before, (mass[lane], radius[lane]), load);
            (places[lane], velocities[lane], spins[lane]) = (grown(step, after.x), after.v, after.w);
            let way = displacement(step, places[lane], listed[lane]);
            for k in 0..6 {
                sums[k][lane] = after.sums[k];
            }
            for a in 0..3 {
                ways[a][lane] = way.0[a];
            }
        }
        x[begin..begin + LANES].copy_from_slice(&places);
        v[begin..begin + LANES].copy_from_slice(&velocities);
        w[begin..begin + LANES].copy_from_slice(&spins);
        for lane in 0..LANES {
            moved.enter(std::array::from_fn(|k| sums[k][lane]));
        }
        for a in 0..3 {
            for lane in 0..LANES {
                let way = ways[a][lane];
                least[a][lane] = if way < least[a][lane] { way } else { least[a][lane] };
                most[a][lane] = if way > most[a][lane] { way } else { most[a][lane] };
            }
        }
    }

    /// Advances a sphere.
    #[inline(always)]
    fn advance_one(&mut self, p: usize, moved: &mut MotionTotals) {
        let [fx, fy, fz, tx, ty, tz, ..] = self.next_load();
        let Self { spheres: Spheres { x, v, w, radius, mass, wall, listed }, step, .. } = self;
        if wall[p] == 0 {
            let after = free(step, [x[p], v[p], w[p]], (mass[p], radius[p]), [fx, fy, fz, tx, ty, tz]);
            (x[p], v[p], w[p]) = (after.x, after.v, after.w);
            moved.enter(after.sums);
        } else {
            let Wall { velocity, spin, .. } = step.walls[wall[p] as usize - 1];
            (x[p], v[p], w[p]) = (drift(x[p], velocity, step.dt), velocity, spin);
        }
        x[p] = grown(step, x[p]);
        moved.stray(displacement(step, x[p], listed[p]));
    }
}

/// A copy of the numbers of a chunk of spheres.
#[inline(always)]
fn chunk<T: Copy>(of: &[T], begin: usize) -> [T; LANES] {
    *of[begin..].first_chunk().expect("a chunk of spheres")
}

/// A free sphere after a step.
#[inline(always)]
fn free(
    &Step { dt, damping, .. }: &Step,
    [x, v, w]: [Vec3<f64>; 3],
    (m, r): (f64, f64),
    [fx, fy, fz, tx, ty, tz]: [f64; 6],
) -> Moved {
    let i = moment_of_inertia(m, r);
    let (force, torque) = (Vec3([fx, fy, fz]) + global_damping(damping, v), Vec3([tx, ty, tz]));
    let (after, x, spin) = symplectic_euler(x, v, w, force, torque, m, i, dt);
    let scheme = kinetic_energy(m, after - v, i, spin - w);
    let Vec3([xx, yy, zz]) = momentum_flux(m, after);
    let sums = [kinetic_energy(m, after, i, spin), drag_loss(damping, v, dt), scheme, xx, yy, zz];
    Moved { x, v: after, w: spin, sums }
}

/// A place after the growth of the box in a step.
#[inline(always)]
fn grown(step: &Step, x: Vec3<f64>) -> Vec3<f64> {
    Vec3(std::array::from_fn(|a| x.0[a] * step.growth[a]))
}

/// The displacement since the neighbour list was built, but for that of the box.
#[inline(always)]
fn displacement(step: &Step, x: Vec3<f64>, listed: Vec3<f64>) -> Vec3<f64> {
    x - Vec3(std::array::from_fn(|a| listed.0[a] * step.stretch[a]))
}
