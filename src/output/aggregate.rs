//! The shape of an aggregate as columns and results.

use super::Finding;
use super::columns::columns;
use crate::observe::aggregate::AggregateShape;

columns! {
    /// The shape of an aggregate. The words `initial` and `final` stand before the names of results of a stage.
    pub const SHAPE {
        /// Mean number of spheres whose gap is below 1 % of the diameter (Eq. 26 of Demidov, Gor & Khalizov 2024).
        COORDINATION = "coordination number";
        /// Volume of the spheres over the volume of their convex hull; the spread is the bound of its error.
        CONVEXITY = "convexity";
        /// Radius of gyration of the centres.
        GYRATION_RADIUS = "radius of gyration" in "nm";
        /// Slope of the logarithm of the number of pairs against that of their distance, between two diameters and the radius of gyration.
        FRACTAL_DIMENSION = "fractal dimension";
        /// Prefactor of the fractal law with this dimension, the radius of gyration and the geometric mean radius (Eq. 24 of Demidov, Gor & Khalizov 2024).
        FRACTAL_PREFACTOR = "fractal prefactor";
        /// Projected area, averaged over all directions.
        PROJECTED_AREA = "projected area" in "nm^2";
        /// Hydrodynamic radius, estimated by the electrostatic capacitance: random walks hit the aggregate or escape.
        HYDRODYNAMIC_RADIUS = "hydrodynamic radius" in "nm";
        /// Radius of the sphere with the same friction factor (Eq. 14 of Laube et al. 2018) in air at 296.15 K and 101.3 kPa (18.3245 µPa s, mean free path 67.3 nm).
        MOBILITY_RADIUS = "mobility radius in air" in "nm";
    }
}

/// The first of these, which a series has as well.
pub const IN_SERIES: [super::Column; 3] = [COORDINATION, CONVEXITY, GYRATION_RADIUS];

impl AggregateShape {
    /// The shape as results.
    pub fn findings(&self) -> Vec<Finding> {
        let fractal = self.fractal.as_ref();
        let (few, many) = ("too few spheres", "too many spheres");
        let dimension = Finding::reached(FRACTAL_DIMENSION, fractal.map(|law| law.dimension), few);
        let convexity = Finding::number(CONVEXITY, self.convexity.value);
        let radius = |result, radius: Option<[f64; 2]>| match radius {
            Some([radius, error]) => Finding::number(result, radius).spread(error),
            None => Finding::reached(result, None, many),
        };
        vec![
            Finding::number(COORDINATION, self.coordination),
            if self.convexity.error > 0.0 { convexity.spread(self.convexity.error) } else { convexity },
            Finding::number(GYRATION_RADIUS, self.gyration_radius),
            fractal.map_or(dimension.clone(), |law| dimension.spread(law.error)),
            Finding::reached(FRACTAL_PREFACTOR, fractal.map(|law| law.prefactor), few),
            Finding::number(PROJECTED_AREA, self.projected_area),
            radius(HYDRODYNAMIC_RADIUS, self.hydrodynamic_radius),
            radius(MOBILITY_RADIUS, self.mobility_radius),
        ]
    }
}
