//! The papers' claims, tested: `veridem reproduce`.

pub mod amorphous;
pub mod contact;
pub mod exact;
pub mod experiment;
pub mod junction;
pub mod lattice;

use crate::spec::wear::Material;

/// How much is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// Smaller samples and fewer of them: about ten minutes on two cores.
    Reduced,
    /// The paper's sizes.
    Full,
}

impl Extent {
    /// The one for each extent.
    pub fn of<T>(self, reduced: T, full: T) -> T {
        if self == Self::Full { full } else { reduced }
    }
}

/// A claim of a paper beside what came out.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Claim {
    /// Its name.
    pub id: &'static str,
    /// What is claimed.
    pub claim: String,
    /// The paper's figure.
    pub paper: String,
    /// Ours.
    pub measured: String,
    /// Whether they agree.
    pub verdict: Verdict,
}

/// Whether a claim agrees with what came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Within the tolerance that the claim names.
    Holds,
    /// Not; the findings say what is known about it.
    Differs,
}

impl Claim {
    /// A claim and whether it `holds`.
    pub fn new(
        id: &'static str,
        claim: impl Into<String>,
        paper: impl Into<String>,
        measured: impl Into<String>,
        holds: bool,
    ) -> Self {
        let verdict = if holds { Verdict::Holds } else { Verdict::Differs };
        Self { id, claim: claim.into(), paper: paper.into(), measured: measured.into(), verdict }
    }
}

/// A picture.
#[derive(Clone, Debug)]
pub struct Figure {
    /// Its file name, without ending.
    pub name: String,
    /// What it shows.
    pub caption: String,
    /// The picture.
    pub svg: String,
}

/// The claims about one kind of system.
#[derive(Clone, Debug, Default)]
pub struct Chapter {
    /// What was left out against the paper, if anything.
    pub note: String,
    /// The claims.
    pub claims: Vec<Claim>,
    /// The figures.
    pub figures: Vec<Figure>,
}

/// The material of the patch tests (Table 4), in any coherent units.
pub fn patch_material(poisson_ratio: f64, scaling: f64) -> Material {
    Material {
        young_modulus: 1.0,
        poisson_ratio,
        tensile_strength: 0.2,
        shear_strength: 0.1,
        surface_energy: 1.5,
        restitution: 0.95,
        scaling,
        forget_stretched_springs: false,
    }
}

/// The density of the patch tests.
pub const PATCH_DENSITY: f64 = 1.0;

/// Amorphous silica (Table 5) in engine units: MPa, and mN/m for the surface energy.
pub fn silica() -> Material {
    Material {
        young_modulus: 73e3,
        poisson_ratio: 0.17,
        tensile_strength: 16e3,
        shear_strength: 9e3,
        surface_energy: 1500.0,
        restitution: 0.9,
        scaling: 0.5,
        forget_stretched_springs: false,
    }
}

/// The density of silica, ag/nm^3.
pub const SILICA_DENSITY: f64 = 2.2e-3;

/// `|a / b - 1| <= tolerance`; false for a NaN.
pub(crate) fn near(a: f64, b: f64, tolerance: f64) -> bool {
    (a / b - 1.0).abs() <= tolerance
}

/// The slope of the straight line through the logarithms of the points.
pub(crate) fn log_slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let logs: Vec<(f64, f64)> = points.iter().map(|&(x, y)| (libm::log(x), libm::log(y))).collect();
    let (mx, my) = logs.iter().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / n, b + y / n));
    let (top, bottom) =
        logs.iter().fold((0.0, 0.0), |(t, b), (x, y)| (t + (x - mx) * (y - my), b + (x - mx) * (x - mx)));
    top / bottom
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slope_of_a_power_law_is_its_exponent() {
        let points: Vec<(f64, f64)> = (1..6).map(|k| (f64::from(k), 3.0 / f64::from(k).sqrt())).collect();
        assert!((log_slope(&points) + 0.5).abs() < 1e-14);
    }

    #[test]
    fn silica_in_engine_units_has_the_wave_velocity_and_critical_diameter_of_the_paper() {
        use crate::spec::wear::eq18_critical_diameter::critical_diameter;
        use crate::spec::wear::eq22_critical_length::wave_velocity;
        let material = silica();
        assert!(near(wave_velocity(material.young_modulus, SILICA_DENSITY), 5760.4, 1e-4));
        let d_c = critical_diameter(material.surface_energy, material.young_modulus, material.tensile_strength);
        assert!(near(d_c, 1.7109, 1e-4));
    }

    #[test]
    fn nothing_is_near_a_nan() {
        assert!(!near(f64::NAN, 1.0, 1.0) && !near(1.0, f64::NAN, 1.0));
    }
}
