//! A paper of one's own beside the library's: a contact law, the sections of its case files, two stages, an observer, a graph, and a claim.
//!
//! In the law of Cundall and Strack (1979) overlapping spheres repel each other by a linear spring and a dashpot. After a head-on collision two spheres separate
//! with a constant fraction of their relative velocity, the coefficient of restitution. The program has the complete command line:
//!
//! ```sh
//! cargo run --example own_paper -- check examples/own_paper.yaml
//! cargo run --example own_paper -- run examples/own_paper.yaml
//! cargo run --example own_paper -- reproduce linear
//! ```

use serde::{Deserialize, Serialize};
use std::path::Path;
use std::process::ExitCode;
use veridem::case::InSteps;
use veridem::case::check::{Found, expect};
use veridem::case::quantity::{Density, Length, Quantity, Scale, Scaled, SphereRadius, Stiffness, Time, Velocity};
use veridem::case::section::{choice, section};
use veridem::case::units::{decimal, in_unit};
use veridem::error::Error;
use veridem::figures::{Curve, Graph, Mark};
use veridem::interrupt::Interrupt;
use veridem::output::columns::TIME;
use veridem::output::{Cell, Column, Finding};
use veridem::papers::{CaseOf, Paper, Papers, parse};
use veridem::reproduce::{Chapter, Claim, Evidence, Figure, Setting, near};
use veridem::run::{Driver, Progress, Runnable, Study};
use veridem::simulation::{Settings, Simulation};
use veridem::spec::mechanics::reduced_mass::effective_mass;
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::spec::mechanics::stable_step::stable_time_step;
use veridem::spec::{Contact, Outcome, PairModel, Real, Vec3, Wrench, flat_struct, piecewise};
use veridem::system::{Domain, Particles, System};

/// The program: its papers, and the library's command line.
pub fn main() -> ExitCode {
    veridem::cli::main(Papers(&[&LinearContacts]))
}

// ---- The equations: generic over the number, without branches ----

/// Damping coefficient of a dashpot with the damping ratio `zeta`.
fn damping_factor<R: Real>(m: R, k: R, zeta: R) -> R {
    R::lit(2.0) * zeta * (m * k).sqrt()
}

/// Force of spring and dashpot along the normal, positive for repulsion; zero without an overlap.
fn normal_force<R: Real>(k: R, c: R, gap: R, velocity: R) -> R {
    piecewise([(gap.lt(R::zero()), -(k * gap) - c * velocity)], R::zero())
}

/// Duration of the contact in a head-on collision.
fn contact_time<R: Real>(m: R, k: R, zeta: R) -> R {
    R::pi() / (k / m * (R::one() - zeta.squared())).sqrt()
}

/// Coefficient of restitution: velocity of separation relative to velocity of approach.
fn restitution<R: Real>(zeta: R) -> R {
    (-(R::pi() * zeta) / (R::one() - zeta.squared()).sqrt()).exp()
}

// ---- The contact law: the only part of the paper that the engine uses ----

/// A linear spring with a dashpot between spheres that overlap.
#[derive(Clone, Copy, Debug)]
pub struct Linear {
    stiffness: f64,
    damping_ratio: f64,
}

flat_struct! {
    /// The constants of a pair.
    pub struct Constants {
        /// Stiffness.
        pub k,
        /// Damping coefficient.
        pub c,
    }
}
flat_struct! {
    /// The energy stored in a pair.
    pub struct Stored {
        /// In its spring.
        pub spring,
    }
}
flat_struct! {
    /// The energy dissipated by a pair.
    pub struct Losses {
        /// By its dashpot.
        pub dashpots,
    }
}

impl PairModel for Linear {
    type Coefficients<R: Real> = Constants<R>;
    /// The compression of the spring is the overlap, so there is no contact history.
    type Memory<R: Real> = [R; 0];
    type Losses<R: Real> = Losses<R>;
    type Stored<R: Real> = Stored<R>;

    fn coefficients<R: Real>(&self, _: R, _: R, m_i: R, m_j: R) -> Constants<R> {
        let k = R::lit(self.stiffness);
        Constants { k, c: damping_factor(effective_mass(m_i, m_j), k, R::lit(self.damping_ratio)) }
    }
    fn range(&self, r_i: f64, r_j: f64) -> f64 {
        r_i + r_j
    }
    #[inline(always)]
    fn pair<R: Real>(
        &self,
        contact: &Contact<R>,
        &Constants { k, c }: &Constants<R>,
        memory: [R; 0],
        dt: R,
    ) -> Outcome<R, [R; 0], Losses<R>> {
        let (gap, velocity) = (contact.gap, contact.normal_velocity());
        let force = contact.n * normal_force(k, c, gap, velocity);
        let wrench = Wrench { force, torque_i: Vec3::zero(), torque_j: Vec3::zero() };
        let dashpots = piecewise([(gap.lt(R::zero()), c * velocity.squared() * dt)], R::zero());
        Outcome { wrench, memory, losses: Losses { dashpots } }
    }
    fn stored<R: Real>(&self, contact: &Contact<R>, constants: &Constants<R>, _: &[R; 0]) -> Stored<R> {
        let overlap = -contact.gap.min(R::zero());
        Stored { spring: R::lit(0.5) * constants.k * overlap.squared() }
    }
    fn critical_time_step(&self, r: f64, m: f64) -> f64 {
        let Constants { k, c } = self.coefficients(r, r, m, m);
        stable_time_step(effective_mass(m, m), k, c)
    }
}

// ---- The case file: every key with its type, its default, and its meaning ----

/// Marks multiples of the duration of a contact.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactTime;
impl Scale for ContactTime {
    const SYMBOL: &'static str = "t_c";
}

choice! {
    /// The contact model.
    pub enum Model {
        /// Cundall & Strack 1979: linear springs with dashpots.
        Linear = "linear": Material,
    }
}
section! {
    /// A material.
    pub struct Material {
        /// Stiffness of the spring.
        stiffness: Quantity<Stiffness>,
        /// Damping ratio: damping coefficient relative to the critical one, below 1.
        damping_ratio: f64 = 0.1,
        /// Density of the spheres.
        density: Quantity<Density>,
    }
}
choice! {
    /// The spheres.
    pub enum Sample {
        /// Two equal spheres.
        Pair = "pair": Pair,
    }
}
section! {
    /// Two equal spheres.
    pub struct Pair {
        /// Radius of the spheres.
        radius: Quantity<Length>,
        /// The gap between them.
        gap: Scaled<Length, SphereRadius> = Scaled::times(0.1),
    }
}
choice! {
    /// The experiment.
    pub enum Experiment {
        /// A head-on collision.
        Collision = "collision": Collision,
    }
}
section! {
    /// A head-on collision.
    pub struct Collision {
        /// Velocity of approach.
        velocity: Quantity<Velocity>,
        /// Time step, as a fraction of the duration of the contact.
        dt: Scaled<Time, ContactTime> = Scaled::times(0.01),
        /// Largest duration of either stage.
        most: InSteps = Scaled::times(100_000.0),
    }
}

// ---- The study: the stages and their observer ----

/// Two spheres approach each other, and rebound.
pub struct Plan {
    law: Linear,
    radius: f64,
    mass: f64,
    gap: f64,
    velocity: f64,
    dt: f64,
    most: InSteps,
    max_overlap: f64,
}

/// The number of the second stage.
const REBOUND: usize = 1;
/// The gap between the spheres.
const GAP: Column = Column::new("gap", "nm");

/// The state of the observer: the present gap and the smallest one so far, nm.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Watch {
    gap: f64,
    least: f64,
}

fn gap(system: &System) -> f64 {
    let spheres = &system.particles;
    (spheres.x[0] - spheres.x[1]).norm() - spheres.radius[0] - spheres.radius[1]
}

impl Plan {
    fn of(case: &CaseOf<LinearContacts>) -> Self {
        let (Model::Linear(material), Sample::Pair(pair)) = (&case.model, &case.sample);
        let Experiment::Collision(collision) = &case.experiment;
        let law = Linear { stiffness: material.stiffness.value, damping_ratio: material.damping_ratio };
        let radius = pair.radius.value;
        let mass = sphere_mass(material.density.value, radius);
        Self {
            law,
            radius,
            mass,
            gap: pair.gap.value(radius),
            velocity: collision.velocity.value,
            dt: collision.dt.value(contact_time(effective_mass(mass, mass), law.stiffness, law.damping_ratio)),
            most: collision.most.clone(),
            max_overlap: case.limits.overlap,
        }
    }

    /// Velocity of separation relative to velocity of approach.
    fn bounce(&self, system: &System) -> f64 {
        (system.particles.v[0] - system.particles.v[1]).norm() / self.velocity
    }
}

impl Study for Plan {
    type Model = Linear;
    type Watch = Watch;

    fn stages(&self) -> Vec<&'static str> {
        vec!["approach", "rebound"]
    }
    fn initial(&self, _: &Interrupt) -> Result<System, Error> {
        let side = 8.0 * self.radius + self.gap;
        let mut spheres = Particles::default();
        for direction in [-1.0, 1.0] {
            let x = 0.5 * side + direction * (self.radius + 0.5 * self.gap);
            spheres.push(Vec3::new(x, 0.5 * side, 0.5 * side), self.radius, self.mass, 0);
        }
        spheres.v = [0.5, -0.5].map(|share| Vec3::new(share * self.velocity, 0.0, 0.0)).into();
        Ok(System::new(spheres, Domain { sides: [side; 3], periodic: [false; 3] }))
    }
    fn model(&self, _: usize) -> Linear {
        self.law
    }
    fn settings(&self, _: usize, _: &System) -> Settings {
        Settings { skin: 0.1 * self.radius, max_overlap: self.max_overlap, ..Settings::new(self.dt) }
    }
    fn steps(&self, _: usize, dt: f64) -> u64 {
        self.most.value(dt).div_euclid(dt) as u64
    }
    fn progress(&self, stage: usize, watch: &Watch, simulation: &Simulation<Linear>) -> Progress {
        let late = simulation.system().step >= self.steps(stage, self.dt);
        match stage {
            REBOUND if watch.gap >= 0.0 => Progress::Done,
            REBOUND if late => Progress::Failed("the spheres have not separated"),
            REBOUND => Progress::Going,
            _ if watch.gap < 0.0 => Progress::Done,
            _ if late => Progress::Failed("the spheres have not met"),
            _ => Progress::Going,
        }
    }
    fn columns(&self) -> Vec<Column> {
        vec![GAP]
    }
    fn watch(&self, _: usize, simulation: &Simulation<Linear>) -> Watch {
        let gap = gap(simulation.system());
        Watch { gap, least: gap }
    }
    fn follow(&self, stage: usize, watch: &mut Watch, simulation: &Simulation<Linear>) -> Vec<String> {
        let before = watch.gap;
        watch.gap = gap(simulation.system());
        watch.least = watch.least.min(watch.gap);
        let turns = stage == REBOUND && watch.least == before && watch.gap > before;
        if turns { vec!["the overlap is deepest".into()] } else { Vec::new() }
    }
    fn look(&self, watch: &mut Watch, _: &Simulation<Linear>) -> Vec<Cell> {
        vec![Cell::Number(watch.gap)]
    }
    fn findings(&self, stage: usize, watch: &Watch, simulation: &Simulation<Linear>) -> Result<Vec<Finding>, Error> {
        if stage != REBOUND {
            return Ok(Vec::new());
        }
        let expected = restitution(self.law.damping_ratio);
        Ok(vec![
            Finding::number("restitution", self.bounce(simulation.system()), "", Some(expected)),
            Finding::number("largest overlap", -watch.least, "nm", None),
        ])
    }
}

// ---- The claim ----

/// A collision at each of several damping ratios.
fn collisions(setting: &Setting) -> Result<Evidence, Error> {
    let (mut evidence, mut curve) = (Evidence::default(), Vec::new());
    for ratio in [0.05, 0.2, 0.5] {
        let text = include_str!("own_paper.yaml").replace("damping_ratio: 0.2", &format!("damping_ratio: {ratio}"));
        let plan = Plan { dt: 1e-4, ..Plan::of(&parse::<LinearContacts>(Path::new("own_paper.yaml"), &text)?) };
        let (measured, expected) =
            (plan.bounce(&Driver::new(&plan, setting.interrupt).run(&mut ())?.system), restitution(ratio));
        let [paper, ours] = [expected, measured].map(|bounce| format!("{bounce:.4}"));
        let claim = format!("coefficient of restitution at a damping ratio of {ratio}");
        evidence.claims.push(Claim::new("restitution", claim, paper, ours, near(measured, expected, 0.01)).exact());
        curve.push((ratio, measured));
    }
    let (axes, curves) = (["damping ratio", "restitution"], vec![Curve::new("", Mark::Points, curve)]);
    evidence.figures.push(Figure::linear("restitution", "Coefficient of restitution of a collision", axes, curves));
    Ok(evidence)
}

// ---- The paper, for the command line ----

/// The paper.
pub struct LinearContacts;

impl Paper for LinearContacts {
    const NAME: &'static str = "linear";
    const REFERENCE: &'static str = "Cundall & Strack 1979";
    const TITLE: &'static str = "Linear springs and dashpots: claims and results";
    const GRAPHS: &'static [Graph] =
        &[Graph { name: "gap", stages: &["approach", "rebound"], x: TIME, y: GAP, marks: &["deepest"] }];
    const CHAPTERS: &'static [Chapter] =
        &[Chapter { name: "collisions", about: "two spheres", title: "Collisions", compute: collisions }];

    type Model = Model;
    type Sample = Sample;
    type Experiment = Experiment;

    fn check(case: &CaseOf<Self>, found: &mut Found) {
        let (Model::Linear(material), Sample::Pair(pair)) = (&case.model, &case.sample);
        let Experiment::Collision(collision) = &case.experiment;
        for (key, value, text) in [
            ("model.linear.stiffness", material.stiffness.value, material.stiffness.to_string()),
            ("model.linear.density", material.density.value, material.density.to_string()),
            ("sample.pair.radius", pair.radius.value, pair.radius.to_string()),
            ("experiment.collision.velocity", collision.velocity.value, collision.velocity.to_string()),
            ("experiment.collision.dt", collision.dt.number(), collision.dt.to_string()),
        ] {
            expect(found, value > 0.0, key, text, "more than zero");
        }
        let ratio = material.damping_ratio;
        expect(found, (0.0..1.0).contains(&ratio), "model.linear.damping_ratio", decimal(ratio), "0 or more, below 1");
    }
    fn derived(case: &CaseOf<Self>) -> Vec<(String, String)> {
        let plan = Plan::of(case);
        vec![
            ("mass".into(), in_unit(plan.mass, "ag")),
            ("dt".into(), in_unit(plan.dt, "ps")),
            ("restitution".into(), decimal(restitution(plan.law.damping_ratio))),
        ]
    }
    fn study(case: CaseOf<Self>) -> Box<dyn Runnable> {
        Box::new(Plan::of(&case))
    }
}
