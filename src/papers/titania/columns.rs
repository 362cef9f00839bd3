//! The columns of the tables of contacts and agglomerates, and their results.

use super::stage::StageAct;
use crate::output::Column;
use crate::output::columns::columns;

columns! {
    /// Columns of a pair.
    pub(super) const PAIR {
        /// Centre distance of the two particles.
        DISTANCE = "distance" in "nm";
    }
}

columns! {
    /// Columns of a particle that is dragged over another.
    pub(super) const DRAGGED {
        /// Distance over which the particle has been dragged.
        MOVED = "moved" in "nm";
        /// Force against the drag.
        FRICTION = "friction" in "pN";
        /// Torque of the rolling resistance over the arm of rolling, as a force at the centre.
        ROLLING_RESISTANCE = "rolling resistance" in "pN";
    }
}

columns! {
    /// Columns of an agglomerate that is stretched.
    pub(super) const STRETCHED {
        /// Displacement of the far end of the pulling spring.
        PULLED = "pulled" in "nm";
        /// Displacement of the near end of the spring, which holds the drawn particles.
        ELONGATION = "elongation" in "nm";
        /// Force of the pulling spring, at this instant.
        PULL = "pulling force" in "pN";
    }
}

columns! {
    /// Columns of all stages.
    pub(super) const COUNTS {
        /// Number of pairs that touch.
        CONTACTS = "contacts";
        /// Number of pairs that a meniscus joins, those that touch among them.
        MENISCI = "menisci";
        /// Number of times so far that a tangential spring reached its period.
        SLIDINGS = "slidings";
        /// Number of times so far that a pair rolled by the period of the friction.
        ROLLINGS = "rollings";
        /// Number of menisci that have broken.
        DETACHMENTS = "detachments";
    }
}

columns! {
    /// Quantities of a window of 50 ps.
    pub(super) const IN_WINDOW {
        /// Force of the pulling spring, averaged over the window.
        MEAN_PULL = "mean pulling force" in "pN";
    }
}

/// Columns of a window of an agglomerate that is stretched.
pub(super) fn windows() -> Vec<Column> {
    [&[PULLED], IN_WINDOW].concat()
}

/// The columns of a stage.
pub(super) fn columns_of(act: &StageAct) -> Vec<Column> {
    let own: &[&[Column]] = match act {
        StageAct::Approach { .. } | StageAct::Press { .. } => &[PAIR],
        StageAct::Drag { .. } => &[PAIR, DRAGGED],
        StageAct::Relax { .. } | StageAct::Release => &[],
        StageAct::Pull { .. } => &[STRETCHED],
    };
    [&own.concat(), COUNTS].concat()
}

/// Results.
pub(super) mod results {
    use crate::output::columns::columns;

    columns! {
        /// The results.
        pub(crate) const ALL {
            /// Centre distance of the released pair at the end.
            FINAL_DISTANCE = "final distance" in "nm";
            /// Smallest centre distance of the released pair.
            SMALLEST_DISTANCE = "smallest distance" in "nm";
            /// Time after the release from which the distance stays within 5 pm of the equilibrium.
            SETTLING_TIME = "time to settle within 5 pm" in "ns";
            /// Number of slips of the dragged particle.
            SLIPS = "slips";
            /// Mean distance between two slips.
            PERIOD = "stick-slip period" in "nm";
            /// Friction force at a slip, averaged over all slips.
            PEAK_FRICTION = "peak friction" in "nN";
            /// Torque of the rolling resistance over the arm of rolling, averaged over all steps in which the particle touches the slab.
            ROLLING_RESISTANCE = "rolling resistance" in "nN";
            /// Number of menisci of a released agglomerate at the end.
            MENISCI = "menisci";
            /// Number of slips of all contacts of the agglomerate.
            SLIDINGS = "slidings";
            /// Number of times that a pair of the agglomerate rolled by the period of the friction.
            ROLLINGS = "rollings";
            /// Number of menisci of the agglomerate that broke.
            DETACHMENTS = "detachments";
            /// Largest mean over 50 ps of the pulling force, after the first oscillation of the drawn particles.
            LARGEST_PULL = "largest pulling force" in "nN";
            /// Largest mean over 50 ps of the pulling force in the first oscillation of the drawn particles, which the start of the drive causes.
            START_UP_PEAK = "peak at the start" in "nN";
            /// Displacement of the far end of the spring at each detachment, in their order; `events.jsonl` names the particles.
            DETACHED_AT = "displacement at detachments" in "nm";
            /// Pulling force at the instant of each detachment, in their order.
            DETACHED_WITH = "pulling force at detachments" in "nN";
            /// Last mean over 50 ps of the pulling force before each detachment, in their order.
            DETACHED_AFTER = "mean pulling force before detachments" in "nN";
        }
    }
}
