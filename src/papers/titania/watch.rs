//! The measurements of the stages: sliding, rolling and detachment of contacts, and the forces that cause them.

use super::columns::results;
use super::law::Law;
use super::stage::StageAct;
use crate::case::units::in_unit;
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::observe::aggregate::AggregateShape;
use crate::output::{Cell, Finding};
use crate::simulation::{Pair, Simulation};
use crate::spec::Vec3;
use crate::spec::mechanics::rolling::rolled_path;
use crate::spec::titania::Titania;
use crate::spec::titania::def_radius::effective_radius;
use crate::spec::titania::eq02_torque::moment_arm;
use crate::spec::titania::eq10_peak_friction::peak_friction;
use serde::{Deserialize, Serialize};

/// Time over which the force of the pulling spring is averaged, ns.
const AVERAGE: f64 = 0.05;

/// Largest deviation from the equilibrium distance at which a released pair counts as settled, nm.
const SETTLED: f64 = 5e-3;

/// The observer of a stage.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Watch {
    /// Pairs in range, by their ids, with the rolling displacement since the last rolling event.
    bonds: Vec<((u32, u32), Vec3<f64>)>,
    slips: Vec<Slip>,
    rollings: u64,
    detachments: Vec<Detachment>,
    /// Force of the pulling spring, summed since the last mean was taken, and the last mean.
    window: (f64, u64),
    mean: f64,
    /// Whether a mean has been taken in the last step.
    closed: bool,
    /// The largest of these means after the initial oscillation of the pulled particles.
    largest_pull: Option<f64>,
    /// The largest of those before.
    start_up_peak: Option<f64>,
    /// Sums of the measured rolling resistance and of its value by the law, and the number of summands.
    resistance: (f64, f64, u64),
    /// Smallest distance of a released pair, and the time, since the release, of the last step in which it was not settled.
    swing: (f64, f64),
}

/// A slip: a tangential spring that has reached its period.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct Slip {
    moved: f64,
    friction: f64,
    strength: f64,
}

/// A pair that left its range.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct Detachment {
    pulled: f64,
    /// At the instant.
    force: f64,
    /// The last mean before.
    mean: f64,
}

fn ids<M: Law>(simulation: &Simulation<M>, pair: &Pair<M>) -> (u32, u32) {
    let id = &simulation.system().particles.id;
    (id[pair.i].min(id[pair.j]), id[pair.i].max(id[pair.j]))
}

/// Energy that a slip of a pair loses, zJ.
fn slipped<M: Law>(pair: &Pair<M>) -> f64 {
    M::slipped(&pair.outcome.losses)
}

impl Watch {
    /// Starts observing.
    pub fn begin(simulation: &Simulation<impl Law>) -> Self {
        let mut bonds: Vec<_> = simulation.pairs().map(|pair| (ids(simulation, &pair), Vec3::zero())).collect();
        bonds.sort_unstable_by_key(|bond| bond.0);
        Self { bonds, swing: (f64::INFINITY, 0.0), ..Self::default() }
    }

    /// Observes a step and returns its events.
    pub fn follow(&mut self, act: &StageAct, simulation: &Simulation<impl Law>) -> Vec<String> {
        self.measure(act, simulation);
        let mut events = Vec::new();
        let (law, dt) = (simulation.model().law(), simulation.settings().dt);
        let mut bonds = Vec::with_capacity(self.bonds.len());
        for pair in simulation.pairs() {
            let (ids, contact) = (ids(simulation, &pair), &pair.contact);
            let known = self.bonds.binary_search_by_key(&ids, |bond| bond.0);
            let mut rolled = known.map_or(Vec3::zero(), |place| self.bonds[place].1);
            if known.is_err() {
                events.push(format!("meniscus between {} and {}", ids.0, ids.1));
            }
            if contact.gap < 0.0 {
                let (_, r_eff) = effective_radius(contact.r_i, contact.r_j);
                rolled = rolled + rolled_path(contact.omega_i, contact.omega_j, contact.n, r_eff, dt);
                if slipped(&pair) > 0.0 {
                    events.push(format!("sliding of {} and {}", ids.0, ids.1));
                    let wall = simulation.system().walls.get(1);
                    self.slips.push(Slip {
                        moved: wall.map_or(0.0, |wall| wall.travel.0[0]),
                        friction: wall.map_or(0.0, |wall| -wall.force.0[0]),
                        strength: peak_friction(Titania::area(contact), law.tau_s, law.tau_r).0,
                    });
                }
            }
            if rolled.norm() >= law.lambda_t {
                events.push(format!("rolling of {} and {}", ids.0, ids.1));
                self.rollings += 1;
                rolled = Vec3::zero();
            }
            bonds.push((ids, rolled));
        }
        bonds.sort_unstable_by_key(|bond| bond.0);
        for &(ids, _) in &self.bonds {
            if bonds.binary_search_by_key(&ids, |bond| bond.0).is_err() {
                events.push(format!("detachment of {} and {}", ids.0, ids.1));
                let pulled = self.pulled(simulation);
                let force = simulation.system().steerings.last().map_or(0.0, |spring| spring.force.0[0]);
                self.detachments.push(Detachment { pulled, force, mean: self.mean });
            }
        }
        self.bonds = bonds;
        events
    }

    /// Updates means and extremes over steps.
    fn measure(&mut self, act: &StageAct, simulation: &Simulation<impl Law>) {
        let system = simulation.system();
        match act {
            StageAct::Approach { diameters: [first, second], .. } => {
                let d = distance(simulation);
                self.swing.0 = self.swing.0.min(d);
                if (d - 0.5 * (first + second)).abs() > SETTLED {
                    self.swing.1 = simulation.elapsed();
                }
            }
            StageAct::Drag { rolls: true, .. } => {
                if let Some(pair) = simulation.pairs().next() {
                    let law = simulation.model().law();
                    self.resistance.0 += rolling_resistance(simulation);
                    self.resistance.1 += peak_friction(Titania::area(&pair.contact), law.tau_s, law.tau_r).1;
                    self.resistance.2 += 1;
                }
            }
            StageAct::Pull { .. } => {
                let Some(spring) = system.steerings.last() else { return };
                let force = spring.force.0[0];
                self.window = (self.window.0 + force, self.window.1 + 1);
                let every = ((AVERAGE / simulation.settings().dt).round() as u64).max(1);
                self.closed = system.step.is_multiple_of(every);
                if self.closed {
                    self.mean = self.window.0 / self.window.1 as f64;
                    self.window = (0.0, 0);
                    let swung = spring.age > spring.swing(&system.particles);
                    let largest = if swung { &mut self.largest_pull } else { &mut self.start_up_peak };
                    *largest = Some(largest.map_or(self.mean, |most| most.max(self.mean)));
                }
            }
            _ => {}
        }
    }

    /// Mean force of the pulling spring over a window that has closed in this step, pN.
    pub fn mean_pull(&self) -> Option<f64> {
        self.closed.then_some(self.mean)
    }

    /// The largest mean force over 50 ps after the initial oscillation of the pulled particles, pN.
    pub fn largest_pull(&self) -> Option<f64> {
        self.largest_pull
    }

    /// Displacement of the far end of the pulling spring, nm.
    pub fn pulled(&self, simulation: &Simulation<impl Law>) -> f64 {
        simulation.system().steerings.last().map_or(0.0, |spring| spring.drawn().0[0])
    }

    /// The cells of the columns of the stage.
    pub fn look(&self, act: &StageAct, simulation: &Simulation<impl Law>) -> Vec<Cell> {
        let system = simulation.system();
        let own: Vec<f64> = match act {
            StageAct::Approach { .. } | StageAct::Press { .. } => vec![distance(simulation)],
            StageAct::Drag { .. } => {
                let wall = &system.walls[1];
                vec![distance(simulation), wall.travel.0[0], -wall.force.0[0], rolling_resistance(simulation)]
            }
            StageAct::Relax { .. } | StageAct::Release => Vec::new(),
            StageAct::Pull { .. } => {
                let spring = system.steerings.last().expect("a pulling spring");
                vec![self.pulled(simulation), spring.travel.0[0], spring.force.0[0]]
            }
        };
        let contacts = simulation.pairs().filter(|pair| pair.contact.gap < 0.0).count();
        let counts = [contacts, self.bonds.len(), self.slips.len(), self.rollings as usize, self.detachments.len()];
        own.into_iter().map(Cell::Number).chain(counts.map(|count| Cell::Count(count as u64))).collect()
    }

    /// The cells of a window that has closed in this step.
    pub fn window(&self, simulation: &Simulation<impl Law>) -> Option<Vec<Cell>> {
        self.mean_pull().map(|mean| [self.pulled(simulation), mean].map(Cell::Number).into())
    }

    /// The findings of the stage.
    ///
    /// # Errors
    ///
    /// [`Error::Interrupted`].
    pub fn findings(
        &self,
        act: &StageAct,
        simulation: &Simulation<impl Law>,
        interrupt: &Interrupt,
    ) -> Result<Vec<Finding>, Error> {
        let law = simulation.model().law();
        let now = simulation.elapsed();
        Ok(match act {
            StageAct::Approach { diameters: [first, second], .. } => {
                let settled = (self.swing.1 < now).then_some(self.swing.1);
                vec![
                    Finding::number(results::FINAL_DISTANCE, distance(simulation)).target(0.5 * (first + second)),
                    Finding::number(results::SMALLEST_DISTANCE, self.swing.0),
                    Finding::reached(results::SETTLING_TIME, settled, within(now, "ns")),
                ]
            }
            StageAct::Drag { rolls: false, .. } => {
                let slips = self.slips.len();
                let mean = |of: fn(&Slip) -> f64| self.slips.iter().map(of).sum::<f64>() / slips as f64;
                let moved = simulation.system().walls.get(1).map_or(0.0, |wall| wall.travel.0[0]);
                let period = match self.slips[..] {
                    [first, .., last] => Some((last.moved - first.moved) / (slips - 1) as f64),
                    _ => None,
                };
                let few = |needed: &str| format!("no {needed} {}", within(moved, "nm").trim_start_matches("not "));
                let friction = (slips > 0).then(|| mean(|slip| slip.friction));
                let mut peak = Finding::reached(results::PEAK_FRICTION, friction, few("slip"));
                if slips > 0 {
                    peak = peak.target(mean(|slip| slip.strength));
                }
                vec![
                    Finding::count(results::SLIPS, slips as u64),
                    Finding::reached(results::PERIOD, period, few("second slip")).target(law.lambda_t),
                    peak,
                ]
            }
            StageAct::Drag { rolls: true, .. } => {
                let (resistance, strength, n) = self.resistance;
                let mean = |sum: f64| (n > 0).then(|| sum / n as f64);
                let found =
                    Finding::reached(results::ROLLING_RESISTANCE, mean(resistance), "the particle left the slab");
                vec![mean(strength).map_or(found.clone(), |strength| found.target(strength))]
            }
            StageAct::Pull { .. } => {
                let early = "the initial oscillation has not ended";
                let mut found = vec![
                    Finding::count(results::SLIDINGS, self.slips.len() as u64),
                    Finding::count(results::ROLLINGS, self.rollings),
                    Finding::count(results::DETACHMENTS, self.detachments.len() as u64),
                    Finding::reached(results::LARGEST_PULL, self.largest_pull, early),
                    Finding::reached(results::START_UP_PEAK, self.start_up_peak, "no mean over 50 ps was taken"),
                    Finding::numbers(results::DETACHED_AT, self.detachments.iter().map(|one| one.pulled)),
                    Finding::numbers(results::DETACHED_WITH, self.detachments.iter().map(|one| one.force)),
                    Finding::numbers(results::DETACHED_AFTER, self.detachments.iter().map(|one| one.mean)),
                ];
                let shape = AggregateShape::of(&simulation.system().particles.spheres(), interrupt)?;
                found.extend(shape.findings().into_iter().map(|finding| finding.at("final")));
                found
            }
            StageAct::Release => {
                vec![
                    Finding::count(results::MENISCI, self.bonds.len() as u64),
                    Finding::count(results::SLIDINGS, self.slips.len() as u64),
                    Finding::count(results::ROLLINGS, self.rollings),
                    Finding::count(results::DETACHMENTS, self.detachments.len() as u64),
                ]
            }
            StageAct::Press { .. } | StageAct::Relax { .. } => Vec::new(),
        })
    }
}

/// Why nothing was reached.
fn within(extent: f64, unit: &str) -> String {
    format!("not within {}", in_unit(extent, unit))
}

/// Centre distance of two particles.
fn distance(simulation: &Simulation<impl Law>) -> f64 {
    let x = &simulation.system().particles.x;
    (x[0] - x[1]).norm()
}

/// The rolling resistance torque of the slab, as a force at the centre of the particle.
pub fn rolling_resistance(simulation: &Simulation<impl Law>) -> f64 {
    let system = simulation.system();
    let (particle, slab, radius) = (system.place(0), system.place(1), &system.particles.radius);
    system.walls[1].torque.0[2].abs() / moment_arm(radius[particle], radius[slab], distance(simulation))
}
