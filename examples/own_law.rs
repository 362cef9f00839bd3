//! A contact law of your own: a spring without damping or friction between spheres that overlap.
//!
//!     cargo run --example own_law
//!
//! The law is written once, over any number [`Real`], and without branches: the engine evaluates several pairs at once with it.

use std::error::Error;
use veridem::run::advance;
use veridem::simulation::{Settings, Simulation};
use veridem::spec::mechanics::stable_step::stable_time_step;
use veridem::spec::{Contact, Outcome, PairModel, Real, Vec3, Wrench, flat_struct};
use veridem::system::System;

flat_struct! {
    /// Energy by cause, zJ.
    pub struct Energies {
        /// Of the spring.
        pub spring,
    }
}

/// Spheres that overlap repel each other in proportion to their overlap.
struct Linear {
    /// Stiffness, pN/nm.
    k_n: f64,
}

impl PairModel for Linear {
    type Coefficients<R: Real> = R;
    type Memory<R: Real> = [R; 0];
    type Losses<R: Real> = Energies<R>;
    type Stored<R: Real> = Energies<R>;

    fn coefficients<R: Real>(&self, _r_i: R, _r_j: R, _m_i: R, _m_j: R) -> R {
        R::lit(self.k_n)
    }

    fn range(&self, r_i: f64, r_j: f64) -> f64 {
        r_i + r_j
    }

    fn pair<R: Real>(&self, c: &Contact<R>, k_n: &R, memory: [R; 0], _dt: R) -> Outcome<R, [R; 0], Energies<R>> {
        let overlap = (-c.gap).max(R::zero());
        let wrench = Wrench { force: c.n * (*k_n * overlap), torque_i: Vec3::zero(), torque_j: Vec3::zero() };
        Outcome { wrench, memory, losses: Energies { spring: R::zero() } }
    }

    fn stored<R: Real>(&self, c: &Contact<R>, k_n: &R, _memory: &[R; 0]) -> Energies<R> {
        Energies { spring: R::lit(0.5) * *k_n * (-c.gap).max(R::zero()).squared() }
    }

    fn critical_time_step(&self, _r: f64, m: f64) -> f64 {
        stable_time_step(0.5 * m, self.k_n, 0.0)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    // Radius 5 nm, mass 1 ag, approach at 2 m/s.
    let spheres = System::builder()
        .sphere([0.0, 0.0, 0.0], 5.0, 1.0)
        .velocity([1.0, 0.0, 0.0])
        .sphere([10.3, 0.0, 0.0], 5.0, 1.0)
        .velocity([-1.0, 0.0, 0.0])
        .build()?;
    let mut simulation = Simulation::new(Linear { k_n: 100.0 }, spheres, Settings::new(1e-3).skin(1.0))?;
    println!("   time [ns]  overlap [nm]  kinetic [zJ]  spring [zJ]  residual [zJ]");
    for _ in 0..12 {
        let ledger = simulation.ledger();
        println!(
            "{:12.3} {:13.4} {:13.4} {:12.4} {:14.1e}",
            simulation.system().time,
            simulation.largest_overlap().map_or(0.0, |(_, ratio)| 10.0 * ratio),
            ledger.kinetic,
            ledger.stored[0],
            ledger.physical_residual(),
        );
        advance(&mut simulation, 40)?;
    }
    Ok(())
}
