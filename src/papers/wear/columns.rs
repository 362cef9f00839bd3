//! The columns of the tables of the wear paper, and its results.

use super::protocol::Setup;
use crate::output::Column;
use crate::output::columns::columns;

columns! {
    /// Columns of a relaxation.
    pub(super) const RELAXATION {
        /// Volume of the spheres, overlaps counted twice, over the volume of the box.
        VOLUME_FRACTION = "volume fraction";
    }
}

columns! {
    /// Columns of a test between two walls.
    pub(super) const TEST {
        /// Strain normal to the walls, fitted to the displacements of the spheres in the middle of the sample.
        NORMAL_STRAIN = "normal strain";
        /// Shear strain parallel to the walls, fitted alike.
        SHEAR_STRAIN = "shear strain";
        /// Virial stress normal to the walls in the middle of the sample, positive in tension.
        NORMAL_STRESS = "normal stress" in "MPa";
        /// Virial stress along the walls.
        LATERAL_STRESS = "lateral stress" in "MPa";
        /// Virial shear stress.
        SHEAR_STRESS = "shear stress" in "MPa";
        /// Largest stress of the kind that the test applies so far.
        PEAK_STRESS = "peak stress" in "MPa";
    }
}

columns! {
    /// Columns of a sheared junction.
    pub(super) const JUNCTION {
        /// Displacement of the upper wall along the direction of sliding.
        SLID = "slid" in "nm";
        /// Distance between the bodies: the height of the junction plus the rise of the upper wall.
        SEPARATION = "separation" in "nm";
        /// Force of the spheres on the upper wall against the sliding, at this instant.
        FRICTION = "friction" in "pN";
        /// Normal force of the spheres on the upper wall, at this instant.
        NORMAL_FORCE = "normal force" in "pN";
    }
}

columns! {
    /// Quantities of a window of sliding.
    pub(super) const IN_WINDOW {
        /// Friction force, averaged over the steps of the window.
        MEAN_FRICTION = "mean friction" in "pN";
        /// Normal force, averaged over the steps of the window.
        MEAN_NORMAL_FORCE = "mean normal force" in "pN";
        /// Number of spheres in the third body: the largest cluster that moves rigidly with neither of the two bodies.
        THIRD_BODY_SIZE = "third body size";
        /// Number of them that belonged to the junction.
        THIRD_BODY_FROM_JUNCTION = "third body from junction";
        /// Mass of the third body.
        THIRD_BODY_MASS = "third body mass" in "ag";
        /// Extent of the third body along the normal, surfaces included.
        THIRD_BODY_HEIGHT = "third body height" in "nm";
        /// Revolutions of the third body since the beginning, in the sense of rolling.
        TURNS = "third body turns";
        /// Fraction of the third body's motion that a rigid motion explains.
        THIRD_BODY_RIGIDITY = "third body rigidity";
        /// Number of pairs in range between the third body and the lower body.
        LINKS_TO_BOTTOM = "links to bottom";
        /// Number of pairs in range between the third body and the upper body.
        LINKS_TO_TOP = "links to top";
        /// Number of pairs in range between the two bodies.
        LINKS_BETWEEN = "links between bodies";
    }
}

/// Columns of a window of a sheared junction.
pub(super) fn windows() -> Vec<Column> {
    [&[SLID, SEPARATION], IN_WINDOW].concat()
}

/// The columns of a stage.
pub(super) fn columns_of(setup: &Setup) -> &'static [Column] {
    match setup {
        Setup::None => RELAXATION,
        Setup::Walls { .. } => TEST,
        Setup::Junction(_) => JUNCTION,
    }
}

/// Results.
pub(super) mod results {
    use crate::output::columns::columns;

    columns! {
        /// The results.
        pub(crate) const ALL {
            /// Volume fraction at the end of a relaxation.
            VOLUME_FRACTION = "volume fraction";
            /// Stress over strain normal to the walls in compression (Section 3.1), corrected for the lateral stress.
            YOUNG_MODULUS = "Young's modulus" in "GPa";
            /// Lateral over normal stress in compression, as Poisson's ratio.
            POISSON_RATIO = "Poisson's ratio";
            /// Normal stress over normal strain without lateral strain.
            C_11 = "stiffness C11" in "GPa";
            /// Lateral stress over normal strain without lateral strain.
            C_12 = "stiffness C12" in "GPa";
            /// Largest normal stress in tension, once the stress has fallen below nine tenths of it.
            TENSILE_STRENGTH = "tensile strength" in "GPa";
            /// Normal strain at that stress.
            TENSILE_STRAIN = "strain at the peak of tension";
            /// Largest normal stress in tension, whether or not the stress has fallen since.
            LARGEST_TENSION = "largest stress in tension" in "GPa";
            /// Largest shear stress, once the stress has fallen below nine tenths of it.
            SHEAR_STRENGTH = "shear strength" in "GPa";
            /// Shear strain at that stress.
            SHEAR_STRAIN = "strain at the peak of shear";
            /// Largest shear stress, whether or not the stress has fallen since.
            LARGEST_SHEAR = "largest stress in shear" in "GPa";
            /// Whether the junction is squeezed flat, detached and rolling, cut, or still attached, by the motion of the third body over all windows.
            FATE = "fate of the junction";
            /// Displacement of the upper wall at the end.
            SLIDING_DISTANCE = "sliding distance" in "nm";
            /// Distance between the bodies at the end.
            SEPARATION = "distance between the bodies" in "nm";
            /// Friction force, averaged over all steps: the peak at the beginning is part of it.
            FRICTION_FORCE = "mean friction force" in "nN";
            /// Largest mean friction force of a window, over the mean normal force of all steps.
            PEAK_FRICTION = "peak friction coefficient";
            /// Mean friction force of the windows in the second half of the sliding distance, over the mean normal force of all steps; the spread is the standard error of the windows.
            KINETIC_FRICTION = "kinetic friction coefficient";
            /// Mass of the third body over the density of the solid, averaged over the windows in the second half of the sliding distance.
            WEAR_VOLUME = "wear volume" in "nm^3";
            /// That volume over the distance slid, averaged over the same windows.
            WEAR_RATE = "wear rate" in "nm^2";
            /// Number of spheres in the third body, averaged over the same windows.
            THIRD_BODY = "particles in the third body";
            /// Revolutions of the third body from the beginning to the end, in the sense of rolling.
            TURNS = "turns of the third body";
            /// Fraction of the third body's motion that a rigid motion explains, averaged over the same windows.
            RIGIDITY = "rigidity of the third body's motion";
        }
    }
}
