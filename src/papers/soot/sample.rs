//! The aggregate of a case of the soot paper: its spheres and its necks.

use super::case::{Aggregate, Growth};
use super::check::sized;
use super::energy::InitialEnergy;
use super::study::{NECK_REMOVAL, Plan};
use crate::error::{Error, notice};
use crate::geometry::{Sphere, centred};
use crate::initial::aggregate::import::{self, Extras, Import};
use crate::initial::aggregate::necks::{Neck, keep_fraction, missing_necks, necks};
use crate::initial::aggregate::{Method, Radii, Recipe, aggregate};
use crate::interrupt::Interrupt;
use crate::random::Stream;
use crate::spec::soot::Reading;

impl<S: Reading> Plan<S> {
    /// The spheres of the sample, centred at their centre of mass, its necks, and its motion.
    pub(super) fn aggregate(&self, interrupt: &Interrupt) -> Result<(Vec<Sphere>, Vec<Neck>, Extras), Error> {
        let (spheres, decimals, extras) = self.spheres(interrupt)?;
        let Aggregate { neck_distance, neck_length, neck_cycles, .. } = &self.sample;
        interrupt.check()?;
        let joined = match self.sample.import.as_ref().and_then(|import| import.necks.as_ref()) {
            Some(file) => import::read_necks(file, &spheres, interrupt)?,
            None => necks(&spheres, neck_distance.value, *neck_length, !neck_cycles, interrupt)?,
        };
        if let Some(Import { file, .. }) = &self.sample.import
            && let Some(remark) =
                missing_necks(&spheres, joined.len(), neck_distance.value, *neck_length, decimals, interrupt)?
        {
            notice(format!("{}: {remark}", file.display()));
        }
        interrupt.check()?;
        let (necks, energy) = self.kept(&spheres, &joined, interrupt)?;
        energy.allowed(self.sample.initial_energy)?;
        Ok((spheres, necks, extras))
    }

    /// The necks that are kept of those that an aggregate may have, and the energies at the start.
    pub(super) fn kept(
        &self,
        spheres: &[Sphere],
        necks: &[Neck],
        interrupt: &Interrupt,
    ) -> Result<(Vec<Neck>, InitialEnergy), Error> {
        let mut stream = Stream::new(self.seed, NECK_REMOVAL);
        let kept = keep_fraction(necks, self.sample.neck_fraction, &mut stream);
        let joined = (&kept[..], self.sample.neck_length);
        let (density, first) = (self.soot.density.value, self.stages.first());
        let energy = InitialEnergy::of(&self.law(0), spheres, joined, density, first, interrupt)?;
        Ok((kept, energy))
    }

    /// Checks the time steps, the cutoff and the necks for spheres from a file with these radii, at least one.
    pub(super) fn suits(&self, radii: impl Iterator<Item = f64>) -> Result<(), Error> {
        let radii = radii.fold([f64::INFINITY, 0.0], |[least, largest], r| [r.min(least), r.max(largest)]);
        let mut found = Vec::new();
        sized(
            &self.soot,
            radii,
            self.stages.iter().enumerate().map(|(number, stage)| (stage, self.key(number))),
            &mut found,
        );
        found.into_iter().next().map_or(Ok(()), |(key, what)| Err(Error::of_key(key, what)))
    }

    /// The spheres, the most decimals of their coordinates in a file, and how they move.
    fn spheres(&self, interrupt: &Interrupt) -> Result<(Vec<Sphere>, usize, Extras), Error> {
        let sample = &self.sample;
        if let Some(import) = &sample.import {
            let imported = import::read(&import.file, &import.options(), interrupt)?;
            let spheres = if sample.on_substrate { imported.spheres } else { centred(imported.spheres) };
            if sample.on_substrate
                && let Some(below) = spheres.iter().position(|sphere| sphere.centre.0[2] <= 0.0)
            {
                let what = format!("the centre of the sphere {below} is not above the substrate, the plane z = 0");
                return Err(Error::input(&import.file, what));
            }
            self.suits(spheres.iter().map(|sphere| sphere.radius))?;
            if imported.extras.bodies.iter().any(|&body| body > 0) {
                notice(format!("{}: the bodies are not read, necks join the spheres", import.file.display()));
            }
            return Ok((spheres, imported.decimals, imported.extras));
        }
        let median = sample.radius.value;
        let recipe = Recipe {
            number: sample.spheres as usize,
            d_f: sample.fractal_dimension,
            k_f: sample.prefactor,
            radii: if sample.deviation == 1.0 {
                Radii::Equal(median)
            } else {
                Radii::LogNormal { median, deviation: sample.deviation }
            },
            method: match sample.growth {
                Growth::Clusters => Method::Clusters,
                Growth::Spheres => Method::Spheres,
            },
        };
        let grown = aggregate(&recipe, self.seed, interrupt).map_err(|failure| failure.of("sample.aggregate"))?;
        Ok((grown, usize::MAX, Extras::default()))
    }
}
