//! Derived values of a case of the wear paper: its scales in engine units, and the resolved keys.

use super::case::{
    Amorphous, Case, Experiment, Hcp, InCriticalDampings, InCriticalSteps, Material, Model, Readings, Sample,
};
use crate::case::units::{in_unit, rounded};
use crate::initial::lattice::{hcp_number, hcp_sides};
use crate::spec::mechanics::solids::sphere_volume;
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::mechanics::truncated_lognormal::truncated_moments;
use crate::spec::wear::eq06_critical_time_step::critical_time_step;
use crate::spec::wear::eq18_critical_diameter::critical_diameter;
use crate::spec::wear::eq19_minimum_diameter::minimum_diameter;
use crate::spec::wear::eq21_critical_damping::critical_damping;
use crate::spec::wear::eq22_critical_length::{critical_length, shear_modulus};
use crate::spec::{PairModel, wear};

impl Material {
    /// The material in engine units.
    pub fn spec(&self) -> wear::Material {
        wear::Material {
            young_modulus: self.young_modulus.value,
            poisson_ratio: self.poisson_ratio,
            tensile_strength: self.tensile_strength.value,
            shear_strength: self.shear_strength.value,
            surface_energy: self.surface_energy.value,
            restitution: self.restitution,
            scaling: self.scaling,
            forget_stretched_springs: self.forget_stretched_springs,
        }
    }
    /// The contact law, with the forces of a stage.
    pub fn law(&self, interaction: wear::Interaction) -> wear::Wear {
        wear::Wear { material: self.spec(), interaction }
    }
}

/// Sets the key that the authors' program decides.
pub(super) fn read_as_published(case: &mut Case) {
    let Model::Wear(material) = &mut case.model;
    if material.readings == Readings::AsPublished {
        material.forget_stretched_springs = true;
    }
}

/// The material of a case.
pub fn material(case: &Case) -> &Material {
    let Model::Wear(material) = &case.model;
    material
}

/// The scales of which quantities of a case may be multiples, in engine units.
#[derive(Clone, Copy, Debug)]
pub struct Scales {
    /// Critical diameter, Eq. 18.
    pub d_c: f64,
    /// Most frequent diameter.
    pub d_0: f64,
    /// Smallest diameter.
    pub d_s: f64,
    /// Largest diameter.
    pub d_l: f64,
    /// Side lengths of the box.
    pub size: [f64; 3],
    /// Thickness of the walls.
    pub walls: f64,
}

impl Scales {
    /// The scales of a case.
    pub fn of(case: &Case) -> Self {
        let material = material(case).spec();
        let d_c = critical_diameter(material.surface_energy, material.young_modulus, material.tensile_strength);
        let (d_0, d_s, d_l, size) = match &case.sample {
            Sample::Hcp(Hcp { diameter, .. }) => {
                let d_0 = diameter.value(d_c);
                (d_0, d_0, d_0, hcp_sides(d_0, asked(case, d_0)))
            }
            Sample::Amorphous(Amorphous { diameter, smallest, largest, .. }) => {
                let d_0 = diameter.value(d_c);
                (d_0, smallest.value(d_0), largest.value(d_0), asked(case, d_0))
            }
        };
        let walls = match &case.experiment {
            Experiment::Patch(patch) => &patch.walls,
            Experiment::Junction(junction) => &junction.walls,
            Experiment::Sliding(sliding) => &sliding.walls,
        };
        Self { d_c, d_0, d_s, d_l, size, walls: walls.value(d_0) }
    }
}

/// The side lengths of the box that a case asks for, nm, where `d_0` is the most frequent diameter.
fn asked(case: &Case, d_0: f64) -> [f64; 3] {
    let (Sample::Hcp(Hcp { size, .. }) | Sample::Amorphous(Amorphous { size, .. })) = &case.sample;
    std::array::from_fn(|axis| size[axis].value(d_0))
}

/// The number of spheres of a case; estimated before a random packing is made.
pub(super) fn spheres(case: &Case) -> f64 {
    let Scales { d_0, d_s, d_l, size, .. } = Scales::of(case);
    let volume: f64 = size.iter().product();
    match &case.sample {
        Sample::Hcp(_) => hcp_number(d_0, size),
        Sample::Amorphous(sample) => {
            let mixed = d_s < d_0 && d_0 < d_l;
            let cube = if mixed { truncated_moments(d_0, d_s, d_l).3 } else { d_0 * d_0 * d_0 };
            sample.volume_fraction * volume / sphere_volume(0.5 * cube.cbrt())
        }
    }
}

/// The scales of time steps and dampings, set by the sphere with the smallest critical time step.
#[derive(Clone, Copy, Debug)]
pub struct Critical {
    /// Critical time step, Eq. 6.
    pub dt: f64,
    /// Critical damping, Eq. 21.
    pub damping: f64,
    /// The largest stable time step, limited also by dashpots and by sliding coupled with rotation.
    pub limit: f64,
}

impl Critical {
    /// For two equal spheres of radius `r` and mass `m`.
    pub fn of(law: &wear::Wear, r: f64, m: f64) -> Self {
        let k_n = law.coefficients(r, r, m, m).k_n;
        Self { dt: critical_time_step(m, k_n), damping: critical_damping(k_n, m), limit: law.critical_time_step(r, m) }
    }

    /// For the smallest sphere of a case, before masses are rescaled.
    pub fn of_case(case: &Case) -> Self {
        let (r, material) = (0.5 * Scales::of(case).d_s, material(case));
        Self::of(&material.law(wear::Interaction::Full), r, sphere_mass(material.density.value, r))
    }
}

/// Every time step of the case, with its key.
pub(super) fn time_steps(case: &Case) -> Vec<(&'static str, &InCriticalSteps)> {
    let relaxation = match &case.sample {
        Sample::Amorphous(sample) => Some(("sample.amorphous.relaxation.dt", &sample.relaxation.dt)),
        _ => None,
    };
    let experiments = match &case.experiment {
        Experiment::Patch(patch) => vec![
            patch.compression.as_ref().map(|test| ("experiment.patch.compression.dt", &test.dt)),
            patch.tension.as_ref().map(|test| ("experiment.patch.tension.dt", &test.dt)),
            patch.shear.as_ref().map(|test| ("experiment.patch.shear.dt", &test.dt)),
        ],
        Experiment::Junction(junction) => vec![Some(("experiment.junction.dt", &junction.dt))],
        Experiment::Sliding(sliding) => vec![Some(("experiment.sliding.dt", &sliding.dt))],
    };
    experiments.into_iter().chain([relaxation]).flatten().collect()
}

/// Every damping of the case, with its key.
pub(super) fn dampings(case: &Case) -> Vec<(&'static str, &InCriticalDampings)> {
    let relaxation = match &case.sample {
        Sample::Amorphous(sample) => vec![
            ("sample.amorphous.relaxation.repulsion_damping", &sample.relaxation.repulsion_damping),
            ("sample.amorphous.relaxation.cohesion_damping", &sample.relaxation.cohesion_damping),
        ],
        _ => Vec::new(),
    };
    let experiments = match &case.experiment {
        Experiment::Patch(patch) => vec![
            patch.compression.as_ref().map(|test| ("experiment.patch.compression.damping", &test.damping)),
            patch.tension.as_ref().map(|test| ("experiment.patch.tension.damping", &test.damping)),
            patch.shear.as_ref().map(|test| ("experiment.patch.shear.damping", &test.damping)),
        ],
        Experiment::Junction(junction) => vec![Some(("experiment.junction.damping", &junction.damping))],
        Experiment::Sliding(sliding) => vec![Some(("experiment.sliding.damping", &sliding.damping))],
    };
    experiments.into_iter().flatten().chain(relaxation).collect()
}

/// Critical junction size d*, nm, Eq. 22.
pub(super) fn critical_size(material: &wear::Material) -> f64 {
    let modulus = shear_modulus(material.young_modulus, material.poisson_ratio);
    critical_length(material.surface_energy, modulus, material.shear_strength)
}

/// The derived values of a case, with units.
pub(super) fn derived(case: &Case) -> Vec<(String, String)> {
    let (scales, own) = (Scales::of(case), material(case));
    let material = own.spec();
    let Critical { dt, damping, limit } = Critical::of_case(case);
    let wear::Material { tensile_strength, surface_energy, .. } = material;
    let d_star = critical_size(&material);
    let r = 0.5 * scales.d_0;
    let mass = |d: f64| sphere_mass(own.density.value, 0.5 * d);
    let law = own.law(wear::Interaction::Full);
    let pair = law.coefficients(r, r, mass(scales.d_0), mass(scales.d_0));
    let lengths = |sides: [f64; 3]| sides.map(|side| in_unit(side, "nm")).join(" x ");
    let size = match &case.sample {
        Sample::Hcp(_) => {
            format!("{}, whole cells for {}", lengths(scales.size), lengths(asked(case, scales.d_0)))
        }
        Sample::Amorphous(_) => format!("{} before the relaxation", lengths(scales.size)),
    };
    let rows = [
        ("critical diameter d_c", in_unit(scales.d_c, "nm")),
        ("minimum diameter d_min", in_unit(minimum_diameter(surface_energy, tensile_strength), "nm")),
        ("critical junction size d*", in_unit(d_star, "nm")),
        ("most frequent diameter d_0", in_unit(scales.d_0, "nm")),
        ("smallest diameter d_s", in_unit(scales.d_s, "nm")),
        ("largest diameter d_l", in_unit(scales.d_l, "nm")),
        ("box", size),
        ("thickness of a wall", in_unit(scales.walls, "nm")),
        ("mass of a sphere of d_s", in_unit(mass(scales.d_s), "kg")),
        ("mass of a sphere of d_0", in_unit(mass(scales.d_0), "kg")),
        ("mass of a sphere of d_l", in_unit(mass(scales.d_l), "kg")),
        ("normal stiffness of a pair of d_0", in_unit(pair.k_n, "N/m")),
        ("tangential stiffness of a pair of d_0", in_unit(pair.k_t, "N/m")),
        ("elastic separation of a pair of d_0", in_unit(pair.delta_e, "nm")),
        ("fracture separation of a pair of d_0", in_unit(pair.delta_f, "nm")),
        ("critical time step dt_c", in_unit(dt, "fs")),
        ("largest stable time step", in_unit(limit, "fs")),
        ("critical damping c_c", in_unit(damping, "kg/s")),
    ];
    let steps = time_steps(case).into_iter().map(|(key, step)| {
        let value = step.value(dt);
        (key.into(), format!("{} = {} of the largest stable time step", in_unit(value, "fs"), rounded(value / limit)))
    });
    rows.into_iter().map(|(key, value)| (key.to_string(), value)).chain(steps).collect()
}
