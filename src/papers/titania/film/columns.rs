//! The columns of the tables of a film under a tip, and its results.

use super::FilmStage;
use crate::initial::film::Bonding;
use crate::output::Column;
use crate::output::columns::columns;

columns! {
    /// Columns of stages with a tip.
    pub(in super::super) const TIPPED {
        /// Displacement of the tip, upwards.
        MOVED = "tip moved" in "nm";
        /// Upward force of the film on the tip, at this instant.
        FORCE_NOW = "force on the tip" in "pN";
        /// Number of bodies and single spheres that contacts and menisci connect to the tip.
        ON_TIP = "bodies on the tip";
    }
}

columns! {
    /// Columns of all stages.
    pub(in super::super) const COUNTS {
        /// Number of pairs that contacts or menisci join, beyond necks and bodies.
        MENISCI = "menisci";
        /// Number of times so far that a tangential spring reached its period.
        SLIDINGS = "slidings";
        /// Number of menisci that have broken.
        DETACHMENTS = "detachments";
    }
}

columns! {
    /// The column of a film of rigid aggregates, and that of a film with necks.
    pub(in super::super) const BY_BONDING {
        /// Number of times so far that a pair rolled by the period of the friction.
        ROLLINGS = "rollings";
        /// Number of necks that hold.
        NECKS = "necks";
    }
}

columns! {
    /// Quantities of a window, as long as `average`.
    pub(in super::super) const IN_WINDOW {
        /// Upward force of the film on the tip, averaged over the window.
        FORCE = "mean force on the tip" in "pN";
    }
}

/// Columns of a window.
pub(in super::super) fn windows() -> Vec<Column> {
    [&[MOVED], IN_WINDOW].concat()
}

/// The columns of a stage.
pub(super) fn columns_of(stage: FilmStage, bonding: Bonding) -> Vec<Column> {
    let tip = if stage == FilmStage::Relaxation { &[] } else { TIPPED };
    let own = match bonding {
        Bonding::Rigid => ROLLINGS,
        Bonding::Necks => NECKS,
    };
    [tip, COUNTS, &[own]].concat()
}

/// Results.
pub(in super::super) mod results {
    use crate::output::columns::columns;

    columns! {
        /// The results.
        pub(crate) const ALL {
            /// Part of the bulk of the relaxed film that is not solid; the bulk lies between the heights below which a fifth and four fifths of the solid are.
            POROSITY = "porosity of the relaxed film";
            /// Height of the highest point of the relaxed film.
            THICKNESS = "thickness of the relaxed film" in "nm";
            /// Mean number of contacts of an aggregate with others in the relaxed film.
            CONTACTS_BETWEEN = "mean number of contacts between an aggregate and others";
            /// Mean coordination number within an aggregate of the relaxed film.
            CONTACTS_WITHIN = "mean coordination number within an aggregate";
            /// Pore diameter of the relaxed film, 10th percentile: the diameter of the largest empty sphere that holds a random point of the bulk.
            PORE_10 = "pore diameter, 10th percentile" in "nm";
            /// The same, 50th percentile.
            PORE_50 = "pore diameter, 50th percentile" in "nm";
            /// The same, 90th percentile.
            PORE_90 = "pore diameter, 90th percentile" in "nm";
            /// Solid fraction of equal layers of the relaxed film, from the floor to the highest point.
            PROFILE = "solid fraction of layers";
            /// Whether the tip reached its setpoint.
            END_OF_APPROACH = "end of the approach";
            /// Last mean force on the tip during the approach.
            APPROACH_FORCE = "force at the end of the approach" in "nN";
            /// Way of the tip down.
            DEPTH = "depth of the approach" in "nm";
            /// Largest mean of the pulling force on the tip during the retraction.
            LARGEST = "largest pulling force on the tip" in "nN";
            /// Last peak of the mean pulling force before the tip was free.
            LAST = "last peak of the pulling force" in "nN";
            /// Displacement of the tip from the setpoint to the moment when nothing connected it to the bottom.
            RUPTURE = "displacement of the tip from the setpoint to the rupture" in "nm";
            /// Number of bodies and single spheres that the tip kept.
            LEFT_ON_TIP = "bodies left on the tip";
            /// Number of slips of all contacts in a stage.
            SLIDINGS = "slidings";
            /// Number of times that a pair rolled by the period of the friction in a stage.
            ROLLINGS = "rollings";
            /// Number of necks that broke in a stage.
            BROKEN_NECKS = "broken necks";
            /// Number of menisci that broke in a stage.
            DETACHMENTS = "detachments";
        }
    }
}
