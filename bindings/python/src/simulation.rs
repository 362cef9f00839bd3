//! Simulations that are stepped from Python.

use crate::errors::{broken, caught, exception};
use crate::law::Law;
use crate::system::Parts;
use crate::work::{interruptible, limit, pool};
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::ThreadPool;
use std::sync::mpsc::Sender;
use std::sync::{Mutex, MutexGuard, TryLockError};
use std::time::{Duration, Instant};
use veridem::error::Error;
use veridem::interrupt::Interrupt;
use veridem::run::advance_until;
use veridem::simulation::{Integrator, Ledger, Settings, Simulation};
use veridem::system::{Body, Particles, Surface, System, Wall};
use veridem_spec::{Flat, PairModel, Vec3};

/// Interval at which Python is asked whether a signal has come.
const PAUSE: Duration = Duration::from_millis(50);

/// A pair that acts: the ids of its spheres, and the numbers of its columns.
pub(crate) struct PairRow {
    ids: [u32; 2],
    gap: f64,
    force: [f64; 3],
    stored: Vec<f64>,
}

/// A simulation with any contact law.
pub(crate) trait Steps: Send {
    /// Takes steps until this one, or until a moment has come.
    fn advance(&mut self, last: u64, until: Instant) -> Result<(), Error>;
    /// The state, with all positions up to date.
    fn system(&mut self) -> &System;
    fn pairs(&self) -> Vec<PairRow>;
    fn ledger(&self) -> Ledger;
    /// The largest overlap, relative to the sum of the radii.
    fn overlap(&self) -> f64;
}

impl<M: PairModel + Send> Steps for Simulation<M> {
    fn advance(&mut self, last: u64, until: Instant) -> Result<(), Error> {
        let over = |now: &mut Self| now.system().step >= last || Instant::now() >= until;
        let done = advance_until(self, over);
        Ok(done.map_err(|halt| self.explained(halt))?)
    }
    fn system(&mut self) -> &System {
        self.place_members();
        Simulation::system(self)
    }
    fn pairs(&self) -> Vec<PairRow> {
        let id = &Simulation::system(self).particles.id;
        let row = |pair: veridem::simulation::Pair<M>| PairRow {
            ids: [id[pair.i], id[pair.j]],
            gap: pair.contact.gap,
            force: pair.outcome.wrench.force.0,
            stored: (0..M::Stored::<f64>::LEN).map(|k| *pair.stored.at(k)).collect(),
        };
        let mut rows: Vec<PairRow> = Simulation::pairs(self).map(row).collect();
        rows.sort_by_key(|row| row.ids);
        rows
    }
    fn ledger(&self) -> Ledger {
        Simulation::ledger(self)
    }
    fn overlap(&self) -> f64 {
        self.largest_overlap().map_or(0.0, |(_, ratio)| ratio)
    }
}

/// Spheres under a contact law. Units: nm, ns, ag; hence m/s, pN and zJ.
#[pyclass(frozen, name = "Simulation", module = "veridem")]
pub(crate) struct PySimulation {
    steps: Mutex<Box<dyn Steps>>,
    pool: ThreadPool,
    dt: f64,
    /// The causes by which its pairs store energy.
    stored: Vec<String>,
    losses: Vec<String>,
}

impl PySimulation {
    /// The simulation, when no other thread has it.
    fn held(&self, py: Python<'_>) -> PyResult<MutexGuard<'_, Box<dyn Steps>>> {
        // Whoever holds it may need the interpreter to let go.
        loop {
            match self.steps.try_lock() {
                Ok(steps) => return Ok(steps),
                Err(TryLockError::WouldBlock) => py.detach(|| std::thread::sleep(Duration::from_millis(1))),
                Err(TryLockError::Poisoned(_)) => {
                    return Err(broken("an earlier step did not end"));
                }
            }
            py.check_signals()?;
        }
    }

    /// Vectors of all spheres, by id.
    fn vectors<'py>(&self, py: Python<'py>, of: impl Fn(&Particles) -> &[Vec3<f64>]) -> PyResult<Bound<'py, PyAny>> {
        caught(|| {
            let mut steps = self.held(py)?;
            let particles = &steps.system().particles;
            let values = of(particles);
            let numbers: Vec<f64> = particles.by_id().into_iter().flat_map(|place| values[place].0).collect();
            let count = numbers.len() / 3;
            Ok(numbers.into_pyarray(py).reshape([count, 3])?.into_any())
        })
    }

    /// Numbers of all spheres, by id.
    fn numbers<'py>(&self, py: Python<'py>, of: impl Fn(&Particles) -> &[f64]) -> PyResult<Bound<'py, PyAny>> {
        caught(|| {
            let mut steps = self.held(py)?;
            let particles = &steps.system().particles;
            let values = of(particles);
            let numbers: Vec<f64> = particles.by_id().into_iter().map(|place| values[place]).collect();
            Ok(numbers.into_pyarray(py).into_any())
        })
    }
}

#[pymethods]
impl PySimulation {
    #[new]
    fn new(
        py: Python<'_>,
        law: &Bound<'_, Law>,
        parts: Parts<'_>,
        settings: [f64; 4],
        integration: [bool; 2],
        threads: Option<usize>,
    ) -> PyResult<Self> {
        caught(|| {
            let ([dt, skin, damping, max_overlap], [verlet, synchronous]) = (settings, integration);
            let law = law.get().law.clone();
            let system = parts.system(law.surfaces())?;
            let integrator = if verlet { Integrator::VelocityVerlet } else { Integrator::HalfStep };
            let settings = Settings { synchronous_start: synchronous, ..Settings::new(dt) };
            let settings = settings.integrator(integrator).skin(skin).damping(damping).max_overlap(max_overlap);
            let (pool, names) = (pool(threads)?, law.names());
            let begin = |interrupt: &Interrupt, _: &Sender<()>| law.simulation(system, settings, interrupt);
            let steps = interruptible(py, &pool, &limit(None)?, begin, |()| Ok(()))?;
            Ok(Self { steps: Mutex::new(steps), pool, dt, stored: names.stored, losses: names.losses })
        })
    }

    /// Takes steps up to this one.
    fn advance(&self, py: Python<'_>, last: u64) -> PyResult<()> {
        caught(|| {
            loop {
                let mut steps = self.held(py)?;
                let (until, under_way) = (Instant::now() + PAUSE, &mut **steps);
                py.detach(|| self.pool.install(|| under_way.advance(last, until))).map_err(exception)?;
                let done = steps.system().step >= last;
                drop(steps);
                py.check_signals()?;
                if done {
                    return Ok(());
                }
            }
        })
    }

    /// Number of steps taken.
    #[getter]
    fn steps(&self, py: Python<'_>) -> PyResult<u64> {
        caught(|| Ok(self.held(py)?.system().step))
    }

    /// Time, ns.
    #[getter]
    fn time(&self, py: Python<'_>) -> PyResult<f64> {
        caught(|| Ok(self.held(py)?.system().time))
    }

    /// Time step, ns.
    #[getter]
    fn dt(&self) -> f64 {
        self.dt
    }

    /// Centres, nm; a copy, like all arrays.
    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.vectors(py, |particles| &particles.x)
    }

    /// Velocities, m/s: half a step behind the positions, unless the integrator is velocity Verlet.
    #[getter]
    fn velocities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.vectors(py, |particles| &particles.v)
    }

    /// Angular velocities, 1/ns.
    #[getter]
    fn spins<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.vectors(py, |particles| &particles.w)
    }

    /// Radii, nm.
    #[getter]
    fn radii<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.numbers(py, |particles| &particles.radius)
    }

    /// Masses, ag.
    #[getter]
    fn masses<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.numbers(py, |particles| &particles.mass)
    }

    /// The largest overlap of two spheres, relative to the sum of their radii.
    #[getter]
    fn overlap(&self, py: Python<'_>) -> PyResult<f64> {
        caught(|| Ok(self.held(py)?.overlap()))
    }

    /// The energy balance, zJ.
    #[getter]
    fn energies<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        caught(|| {
            let ledger = self.held(py)?.ledger();
            let energies = PyDict::new(py);
            energies.set_item("kinetic", ledger.kinetic)?;
            for (name, energy) in self.stored.iter().zip(&ledger.stored) {
                energies.set_item(format!("stored: {name}"), energy)?;
            }
            for (name, energy) in self.losses.iter().zip(&ledger.lost_by_pairs) {
                energies.set_item(format!("lost: {name}"), energy)?;
            }
            energies.set_item("lost: drag", ledger.lost_drag)?;
            if !self.held(py)?.system().surfaces.is_empty() {
                for (name, energy) in self.stored.iter().zip(&ledger.surfaces.stored) {
                    energies.set_item(format!("stored at surfaces: {name}"), energy)?;
                }
                for (name, energy) in self.losses.iter().zip(&ledger.surfaces.lost) {
                    energies.set_item(format!("lost at surfaces: {name}"), energy)?;
                }
            }
            energies.set_item("work", ledger.work())?;
            energies.set_item("residual", ledger.physical_residual())?;
            energies.set_item("turnover", ledger.turnover())?;
            Ok(energies)
        })
    }

    /// Of every wall its velocity (m/s), its displacement (nm), and force (pN) and torque (pN nm) of the spheres on it in the last step.
    #[getter]
    fn walls<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        caught(|| {
            let mut held = self.held(py)?;
            let walls = &held.system().walls;
            let rows = |of: fn(&Wall) -> Vec3<f64>| walls.iter().map(of).collect();
            let columns = [
                ("velocity", rows(|wall| wall.velocity)),
                ("displacement", rows(|wall| wall.travel)),
                ("force", rows(|wall| wall.force)),
                ("torque", rows(|wall| wall.torque)),
            ];
            columns_of(py, columns)
        })
    }

    /// Of every surface its velocity (m/s), its displacement (nm), and the force (pN) of the spheres on it in the last step.
    #[getter]
    fn surfaces<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        caught(|| {
            let mut held = self.held(py)?;
            let surfaces = &held.system().surfaces;
            let rows = |of: fn(&Surface) -> Vec3<f64>| surfaces.iter().map(of).collect();
            let columns = [
                ("velocity", rows(|surface| surface.velocity)),
                ("displacement", rows(|surface| surface.way)),
                ("force", rows(|surface| surface.force.total())),
            ];
            columns_of(py, columns)
        })
    }

    /// Of every rigid body the place (nm) and velocity (m/s) of its centre of mass.
    #[getter]
    fn bodies<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        caught(|| {
            let mut bodies = self.held(py)?.system().bodies.clone();
            bodies.sort_unstable_by_key(|body| body.id);
            let rows = |of: fn(&Body) -> Vec3<f64>| bodies.iter().map(of).collect();
            columns_of(py, [("position", rows(|body| body.pose.x)), ("velocity", rows(|body| body.v))])
        })
    }

    /// The pairs that act: ids, gaps (nm), forces on the first sphere (pN), stored energies by cause (zJ).
    #[getter]
    fn pairs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        caught(|| {
            let rows = self.held(py)?.pairs();
            let (count, causes) = (rows.len(), self.stored.len());
            let pairs = PyDict::new(py);
            let ids: Vec<i64> = rows.iter().flat_map(|row| row.ids.map(i64::from)).collect();
            let gaps: Vec<f64> = rows.iter().map(|row| row.gap).collect();
            let forces: Vec<f64> = rows.iter().flat_map(|row| row.force).collect();
            let stored: Vec<f64> = rows.into_iter().flat_map(|row| row.stored).collect();
            pairs.set_item("ids", ids.into_pyarray(py).reshape([count, 2])?)?;
            pairs.set_item("gap", gaps.into_pyarray(py))?;
            pairs.set_item("force", forces.into_pyarray(py).reshape([count, 3])?)?;
            pairs.set_item("stored", stored.into_pyarray(py).reshape([count, causes])?)?;
            Ok(pairs)
        })
    }
}

/// Vectors as arrays, by name.
fn columns_of<'py, const N: usize>(
    py: Python<'py>,
    columns: [(&str, Vec<Vec3<f64>>); N],
) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for (name, rows) in columns {
        let numbers: Vec<f64> = rows.iter().flat_map(|row| row.0).collect();
        dict.set_item(name, numbers.into_pyarray(py).reshape([rows.len(), 3])?)?;
    }
    Ok(dict)
}
