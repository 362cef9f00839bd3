//! The columns of the tables of soot, and its results.

use super::case::SootStage;
use crate::output::Column;
use crate::output::aggregate::IN_SERIES;
use crate::output::columns::{OF_SURFACES, columns};

columns! {
    /// Columns of all stages, beside those of shape and surfaces.
    pub const AGGREGATE {
        /// Height of the centre of mass.
        HEIGHT = "height" in "nm";
        /// Number of necks that hold.
        NECKS = "necks";
        /// Work of the surfaces on the aggregate.
        WORK_OF_SURFACES = "work of surfaces" in "zJ";
    }
}

columns! {
    /// Columns of stages with a substrate.
    pub const ON_SUBSTRATE {
        /// Number of spheres whose gap to the substrate is below 1 % of their diameter.
        SPHERES_ON_SUBSTRATE = "spheres on the substrate";
        /// Normal contact force of the aggregate on the substrate, upwards.
        CONTACT_ON_SUBSTRATE = "contact on the substrate" in "pN";
        /// Magnitude of the friction force of the aggregate on the substrate.
        FRICTION_ON_SUBSTRATE = "friction on the substrate" in "pN";
        /// Van der Waals force of the aggregate on the substrate, upwards.
        VAN_DER_WAALS_ON_SUBSTRATE = "van der Waals on the substrate" in "pN";
    }
}

columns! {
    /// Columns of an indentation.
    pub const ON_TIP {
        /// Displacement of the tip, upwards.
        TIP_DISPLACEMENT = "tip displacement" in "nm";
        /// Number of spheres whose gap to the tip is below 1 % of their diameter.
        SPHERES_ON_TIP = "spheres on the tip";
        /// Normal contact force of the aggregate on the tip, upwards.
        CONTACT_ON_TIP = "contact on the tip" in "pN";
        /// Upward part of the friction force of the aggregate on the tip.
        FRICTION_ON_TIP = "friction on the tip" in "pN";
        /// Van der Waals force of the aggregate on the tip, upwards.
        VAN_DER_WAALS_ON_TIP = "van der Waals on the tip" in "pN";
        /// Downward force of the aggregate on the tip.
        PULL = "pull on the tip" in "pN";
        /// The same force, filtered by the cantilever (Eq. 27).
        READING = "cantilever reading" in "pN";
    }
}

/// The columns of a stage.
pub(super) fn columns_of(stage: &SootStage) -> Vec<Column> {
    let own: &[&[Column]] = match stage {
        SootStage::Deposition(_) => &[ON_SUBSTRATE],
        SootStage::Indentation(_) => &[ON_SUBSTRATE, ON_TIP],
        SootStage::Restructuring(_) => &[],
    };
    [&IN_SERIES, AGGREGATE, OF_SURFACES, &own.concat()].concat()
}

/// Results.
pub(super) mod results {
    use crate::output::columns::columns;

    columns! {
        /// The results.
        pub(crate) const ALL {
            /// Whether the aggregate adheres, rests or compacts, in a sentence.
            END = "end";
            /// Number of spheres on the substrate at the end of a deposition.
            ON_SUBSTRATE = "spheres on the substrate";
            /// Kinetic energy at the beginning of a deposition.
            INITIAL_KINETIC = "initial kinetic energy" in "aJ";
            /// Kinetic energy at the end of a deposition.
            FINAL_KINETIC = "final kinetic energy" in "aJ";
            /// Energy dissipated in a deposition.
            DISSIPATED = "energy dissipated" in "aJ";
            /// Largest downward force of the aggregate on the tip in any step, unfiltered.
            LARGEST_PULL = "largest pulling force" in "nN";
            /// Number of peaks of the filtered force after the reversal of the tip.
            PEAKS = "peaks of the force curve";
            /// The highest of these peaks.
            HIGHEST_PEAK = "highest peak" in "nN";
            /// Displacement of the tip at which it was free of the aggregate.
            RUPTURE_HEIGHT = "rupture height" in "nm";
            /// Number of necks at the end.
            NECKS = "necks";
        }
    }
}
