//! Three published contact models for the discrete element method, from the equation to the simulation.
//!
//! An **equation** is a function over any number [`Real`](spec::Real) in [`spec`]:
//!
//! ```
//! use veridem::spec::wear::eq03_normal_force::normal_force;
//!
//! // k_n, delta_e, delta_f, delta_n: in tension beyond the elastic separation the force decreases.
//! assert_eq!(normal_force(10.0, 1.0, 3.0, 0.5), 5.0);
//! assert_eq!(normal_force(10.0, 1.0, 3.0, 2.0), 5.0);
//! ```
//!
//! A **model** composes equations into a contact law, [`PairModel`](spec::PairModel). A **system** is the state of spheres, bodies, walls and
//! surfaces. A [`Simulation`](simulation::Simulation) puts a system under a model, and keeps an account of its energy:
//!
//! ```
//! use veridem::run::advance;
//! use veridem::simulation::{Settings, Simulation};
//! use veridem::spec::titania::Titania;
//! use veridem::system::System;
//!
//! // Units: nm, ns, ag; hence m/s, pN and zJ.
//! let law = Titania::paper(1.0, 1e3, 1.0);
//! let radius = law.contact_radius(8.0);
//! let system = System::builder()
//!     .sphere([0.0, 0.0, 0.0], radius, 1.0)
//!     .sphere([2.0 * radius, 0.0, 0.0], radius, 1.0)
//!     .velocity([1.0, 0.0, 0.0])
//!     .build()?;
//! let mut simulation = Simulation::new(law, system, Settings::new(1e-4).skin(1.0))?;
//! advance(&mut simulation, 1000)?;
//! let ledger = simulation.ledger();
//! assert!(ledger.physical_residual().abs() < 1e-2 * ledger.turnover());
//! # Ok::<(), veridem::error::Error>(())
//! ```
//!
//! A **case** is a file that says with units which sample is made and what is done to it. A **paper** ([`papers`]) reads its cases and turns each into a
//! [`Study`](run::Study): stages that one [`Driver`](run::Driver) takes step by step. An **observer** reads the system, into a run folder
//! ([`output`]), into memory ([`run::Memory`]) or in a closure ([`run::Each`]).
//!
//! The programs in `examples/` show each of these: `two_spheres`, `own_law`, `own_observer`, `own_paper`. The feature `cli` adds the command line, reports and the
//! claims of the papers, `verify` the number types that check the equations; the library builds without either.

pub mod allocator;
#[cfg(feature = "book")]
pub mod book;
pub mod case;
#[cfg(feature = "cli")]
pub mod cli;
pub mod equations;
pub mod error;
pub mod figures;
pub mod forces;
pub mod geometry;
#[cfg(feature = "verify")]
pub mod golden;
pub mod initial;
pub mod interrupt;
pub mod motion;
pub mod observe;
pub mod output;
pub mod papers;
#[cfg(feature = "verify")]
pub mod proofs;
pub mod random;
#[cfg(feature = "cli")]
pub mod reproduce;
pub mod run;
pub mod simulation;
pub mod system;

pub use veridem_spec as spec;
