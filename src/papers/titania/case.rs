//! The sections of a case of the titania paper. Defaults are its published values or, where it gives none, the values of the authors'
//! program.

mod film;
mod model;

pub use film::*;
pub use model::*;

use super::chain::{Recipe, corner, margin};
use crate::case::InSteps;
use crate::case::quantity::{Drag, Force, Length, Quantity, Scaled, Stiffness, Time, Velocity, quantity};
use crate::case::section::{choice, section, words};
use crate::case::units::{in_unit, rounded};
use crate::initial::aggregate::import::{FileSizes, Import, shift_of_import};
use crate::papers::path::Leg;
use crate::spec::titania::def_radius::radii;
use crate::spec::{PairModel, Vec3};
use std::path::PathBuf;

/// A case of the titania paper.
pub type Case = crate::case::Case<Model, Sample, Experiment>;

choice! {
    /// The contact model.
    pub enum Model {
        /// Laube et al. 2018: water-covered oxide nanoparticles.
        Titania = "titania": Titania,
    }
}

choice! {
    /// The initial arrangement of the particles.
    pub enum Sample {
        /// Two water-covered particles.
        Pair = "pair": TwoParticles,
        /// A chain of water-covered particles of different sizes.
        Agglomerate = "agglomerate": Agglomerate,
        /// A film of aggregates.
        Film = "film": Film,
    }
}

choice! {
    /// The experiment.
    pub enum Experiment {
        /// Tests of a single contact: a particle approaches another, and slides or rolls over a slab.
        Contact = "contact": ContactTests,
        /// A path of two particles: sliding, rolling, twisting, and pulling.
        Path = "path": Path,
        /// Stretching of an agglomerate.
        Stretching = "stretching": Stretching,
        /// Free motion of an agglomerate, with the velocities of its file.
        Release = "release": Release,
        /// Force spectroscopy: a film under the tip of an atomic force microscope.
        Spectroscopy = "spectroscopy": Spectroscopy,
    }
}

section! {
    /// Two particles.
    pub struct TwoParticles {
        /// Nominal diameters; half their sum is the equilibrium distance of the centres.
        diameters: [Quantity<Length>; 2] = [quantity("8 nm"), quantity("8 nm")],
    }
}

section! {
    /// A chain in which every particle touches the preceding two, Section 3.1.
    pub struct Agglomerate {
        /// Number of particles.
        particles: u64 = 14,
        /// Smallest nominal diameter.
        smallest: Quantity<Length> = quantity("8 nm"),
        /// Largest nominal diameter.
        largest: Quantity<Length> = quantity("20 nm"),
        /// Length of the chain, met to within 5 %.
        length: Quantity<Length> = quantity("100 nm"),
        /// Imports the particles from a file instead; the keys above are then ignored. Radii in the file are nominal: particles at rest touch there. Particles of a body are
        /// rigidly joined; a body begins with the momentum and the angular momentum of its particles.
        import: Option<Import> = None,
    }
}

section! {
    /// Tests of a single contact, each starting anew.
    pub struct ContactTests {
        /// Both particles are released from a distance, Fig. 3.
        approach: Option<Approach> = None,
        /// The first particle slides over a slab without rotating, Fig. 8.
        slide: Option<Dragging> = None,
        /// The first particle rolls over a slab without sliding, Fig. 8.
        roll: Option<Dragging> = None,
        /// Time step, a fifth of the authors' value, because friction may at most stop a rolling particle within one step.
        dt: Quantity<Time> = quantity("0.1 ps"),
    }
}

section! {
    /// Release of two particles near each other.
    pub struct Approach {
        /// Initial distance beyond the equilibrium distance.
        from: Quantity<Length> = quantity("0.5 nm"),
        /// Duration.
        duration: InSteps = Scaled::Absolute(quantity("3 ns")),
    }
}

section! {
    /// A particle is dragged over a slab under a load.
    pub struct Dragging {
        /// Nominal diameter of the sphere that represents the slab.
        slab: Quantity<Length> = quantity("1 µm"),
        /// Normal load on the particle.
        load: Quantity<Force> = quantity("2 nN"),
        /// Time that the particle is given to come to rest under the load.
        settling: InSteps = Scaled::Absolute(quantity("2 ns")),
        /// Velocity of the particle.
        velocity: Quantity<Velocity> = quantity("1 m/s"),
        /// Distance over which it is dragged.
        distance: Quantity<Length> = quantity("3 nm"),
    }
}

section! {
    /// Two particles slide, roll, twist and are pulled apart by prescription, leg by leg.
    pub struct Path {
        /// Distance of their centres, if not that at rest.
        distance: Option<Quantity<Length>> = None,
        /// The legs, one after the other; the tangential spring goes on from leg to leg.
        legs: Vec<Leg>,
        /// Time step.
        dt: Quantity<Time> = quantity("0.1 ps"),
    }
}

section! {
    /// An agglomerate is pulled along x at the last particles of one end while the first of the other end are held, Section 3.1.
    pub struct Stretching {
        /// Duration of the relaxation before, with both ends frozen.
        relaxation: InSteps = Scaled::Absolute(quantity("2 ns")),
        /// Drag coefficient of every particle during the relaxation.
        drag: Quantity<Drag> = quantity("1e-11 kg/s"),
        /// Number of particles at each end that are held and pulled: the first and the last ones, in the order of a file.
        drawn: u64 = 2,
        /// How the other end is held while one is pulled.
        hold: Hold = Hold::Springs,
        /// Stiffness of the springs, which act on the centres of mass of the ends.
        stiffness: Quantity<Stiffness> = quantity("160 N/m"),
        /// Directions in which the springs act.
        spring_along: SpringAlong = SpringAlong::All,
        /// Velocity of the far end of the pulling spring.
        velocity: Quantity<Velocity> = quantity("5 m/s"),
        /// Time in which this velocity grows linearly from zero.
        ramp: Quantity<Time> = quantity("0 ns"),
        /// Distance over which the far end of the spring moves.
        distance: Quantity<Length> = quantity("60 nm"),
        /// Time step, a fifth of the authors' value, because friction may at most stop a rolling particle within one step.
        dt: Quantity<Time> = quantity("0.1 ps"),
    }
}

words! {
    /// How an end of an agglomerate is held.
    pub enum Hold {
        /// By a spring like the pulling one, whose far end stands still: its particles move and turn.
        Springs = "springs",
        /// Frozen: its particles neither move nor turn, nor do the rigid bodies to which they belong.
        Frozen = "frozen",
    }
}

words! {
    /// Directions in which a spring acts.
    pub enum SpringAlong {
        /// Along x alone, the direction of pulling.
        X = "x",
        /// Along all axes.
        All = "all",
    }
}

section! {
    /// All particles of an agglomerate are let go, with the velocities of its file, at rest without any.
    pub struct Release {
        /// Duration.
        duration: InSteps = Scaled::Absolute(quantity("2 ns")),
        /// Drag coefficient of every particle.
        drag: Quantity<Drag> = quantity("0 kg/s"),
        /// Time step, a fifth of the authors' value, because friction may at most stop a rolling particle within one step.
        dt: Quantity<Time> = quantity("0.1 ps"),
    }
}

/// What is done with an agglomerate.
#[derive(Clone, Debug, PartialEq)]
pub enum ChainTest {
    /// It is stretched.
    Stretching(Stretching),
    /// It is let go.
    Release(Release),
}

/// The experiment of a case of the titania paper, with its sample.
#[derive(Clone, Debug)]
pub enum TitaniaTest<'a> {
    /// Two particles.
    Contact(&'a TwoParticles, &'a ContactTests),
    /// Two particles at a fixed distance.
    Path(&'a TwoParticles, &'a Path),
    /// An agglomerate.
    Chain(&'a Agglomerate, Box<ChainTest>),
    /// A film.
    Spectroscopy(&'a Film, &'a Spectroscopy),
}

impl TitaniaTest<'_> {
    /// The file from which the sample comes.
    pub fn import(&self) -> Option<&Import> {
        match self {
            Self::Contact(..) | Self::Path(..) => None,
            Self::Chain(Agglomerate { import, .. }, _) | Self::Spectroscopy(Film { import, .. }, _) => import.as_ref(),
        }
    }

    /// The smallest and the largest nominal diameter, nm; none if they are in a file that cannot be read.
    pub fn diameters(&self) -> Option<[f64; 2]> {
        if let Some(import) = self.import() {
            return import.sizes().map(|FileSizes { least, largest, .. }| [2.0 * least, 2.0 * largest]);
        }
        Some(match self {
            Self::Contact(TwoParticles { diameters: [first, second] }, _)
            | Self::Path(TwoParticles { diameters: [first, second] }, _) => {
                [first.value.min(second.value), first.value.max(second.value)]
            }
            Self::Chain(agglomerate, _) => [agglomerate.smallest.value, agglomerate.largest.value],
            Self::Spectroscopy(film, _) => [film.diameters.smallest.value, film.diameters.largest.value],
        })
    }

    /// The time step, and its key.
    pub fn dt(&self) -> (&'static str, &Quantity<Time>) {
        match self {
            Self::Contact(_, tests) => ("experiment.contact.dt", &tests.dt),
            Self::Path(_, test) => ("experiment.path.dt", &test.dt),
            Self::Chain(_, test) => test.dt(),
            Self::Spectroscopy(_, test) => ("experiment.spectroscopy.dt", &test.dt),
        }
    }
}

impl ChainTest {
    /// The time step, and its key.
    pub fn dt(&self) -> (&'static str, &Quantity<Time>) {
        match self {
            Self::Stretching(test) => ("experiment.stretching.dt", &test.dt),
            Self::Release(test) => ("experiment.release.dt", &test.dt),
        }
    }
}

impl Agglomerate {
    /// The parameters of its construction, in engine units.
    pub fn recipe(&self) -> Recipe {
        Recipe {
            particles: self.particles as usize,
            smallest: self.smallest.value,
            largest: self.largest.value,
            length: self.length.value,
        }
    }
}

/// The model of a case, and its test if sample and experiment match.
pub fn parts(case: &Case) -> (&Titania, Option<TitaniaTest<'_>>) {
    let Model::Titania(titania) = &case.model;
    let test = match (&case.sample, &case.experiment) {
        (Sample::Pair(pair), Experiment::Contact(tests)) => TitaniaTest::Contact(pair, tests),
        (Sample::Pair(pair), Experiment::Path(test)) => TitaniaTest::Path(pair, test),
        (Sample::Agglomerate(chain), Experiment::Stretching(test)) => {
            TitaniaTest::Chain(chain, Box::new(ChainTest::Stretching(test.clone())))
        }
        (Sample::Agglomerate(chain), Experiment::Release(test)) => {
            TitaniaTest::Chain(chain, Box::new(ChainTest::Release(test.clone())))
        }
        (Sample::Film(film), Experiment::Spectroscopy(test)) => TitaniaTest::Spectroscopy(film, test),
        _ => return (titania, None),
    };
    (titania, Some(test))
}

/// The model and the test of a checked case.
///
/// # Panics
///
/// If the case has not been checked.
pub fn checked(case: &Case) -> (&Titania, TitaniaTest<'_>) {
    let (titania, test) = parts(case);
    (titania, test.expect("in a checked case, sample and experiment match"))
}

/// The largest stable time step of particles with diameters in this range, nm, if necks join them or not, ns.
pub fn step_limit(titania: &Titania, [smallest, largest]: [f64; 2]) -> f64 {
    let (r, mass) = titania.particle(smallest);
    let limit = titania.law().critical_time_step(r, mass);
    let Some(springs) = &titania.neck_springs else { return limit };
    limit.min(springs.spec().critical_time_step(r, mass, titania.particle(largest).0))
}

/// The keys of generated samples, which an imported one does not use.
pub fn unused(case: &Case) -> &'static [&'static str] {
    match &case.sample {
        Sample::Agglomerate(Agglomerate { import: Some(_), .. }) => &[
            "sample.agglomerate.particles",
            "sample.agglomerate.smallest",
            "sample.agglomerate.largest",
            "sample.agglomerate.length",
        ],
        Sample::Film(Film { import: Some(_), .. }) => &[
            "sample.film.particles",
            "sample.film.diameters",
            "sample.film.aggregates",
            "sample.film.cluster",
            "sample.film.prefactor",
            "sample.film.dimension",
            "sample.film.gas",
            "sample.film.drift",
        ],
        _ => &[],
    }
}

/// The files that a case reads.
pub fn reads(case: &mut Case) -> Vec<&mut PathBuf> {
    match &mut case.sample {
        Sample::Pair(_) => Vec::new(),
        Sample::Agglomerate(Agglomerate { import, .. }) => import.iter_mut().flat_map(Import::files_mut).collect(),
        Sample::Film(Film { import, load, .. }) => import.iter_mut().flat_map(Import::files_mut).chain(load).collect(),
    }
}

/// The files that a case writes beside its run folder, with the sections that ask for them.
pub fn saves(case: &mut Case) -> Vec<(String, &mut PathBuf)> {
    match &mut case.sample {
        Sample::Film(Film { save: Some(file), .. }) => vec![("sample.film".into(), file)],
        _ => Vec::new(),
    }
}

/// The derived values of a case, with units. A file that cannot be read is reported when it is needed.
pub fn derived(case: &Case) -> Vec<(String, String)> {
    let (titania, test) = checked(case);
    let Some([d, largest]) = test.diameters() else { return Vec::new() };
    let (law, limit) = (titania.law(), step_limit(titania, [d, largest]));
    let (r, mass) = titania.particle(d);
    let attraction = law.attraction(r, r);
    let (key, dt) = test.dt();
    let share = rounded(dt.value / limit);
    let of_file = test.import().and_then(Import::spheres).map(|spheres| {
        let shift = match test {
            // The coordinates of a film are those of its box.
            TitaniaTest::Spectroscopy(..) => Vec3::zero(),
            _ => {
                let chain: Vec<_> = spheres.iter().map(|sphere| (sphere.centre, 2.0 * sphere.radius)).collect();
                corner(&chain, margin(&chain))
            }
        };
        let [number, largest] = [spheres.len().to_string(), in_unit(largest, "nm")];
        let sizes = [("number of particles".into(), number), ("largest diameter".into(), largest)];
        sizes.into_iter().chain([shift_of_import(shift)])
    });
    let rows = [
        ("smallest diameter", in_unit(d, "nm")),
        ("bare radius of the smallest particle", in_unit(radii(d, law.core_gap, law.h_n).0, "nm")),
        ("contact radius of the smallest particle", in_unit(r, "nm")),
        ("mass of the smallest particle", in_unit(mass, "kg")),
        ("contact stiffness of two smallest particles", in_unit(law.parameters(r, r, mass, mass).k_n, "GPa")),
        (
            "attraction of two smallest particles at equilibrium",
            in_unit(-attraction.force(law.equilibrium(r, r)), "nN"),
        ),
        ("rupture distance of the meniscus", in_unit(attraction.rupture(), "nm")),
        ("largest stable time step", in_unit(limit, "fs")),
        (key, format!("{} = {share} of the largest stable time step", in_unit(dt.value, "fs"))),
    ];
    of_file.into_iter().flatten().chain(rows.map(|(key, value)| (key.into(), value))).collect()
}
