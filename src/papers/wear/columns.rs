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

columns! {
    /// Columns of two sliding bodies.
    pub(super) const SLIDING {
        /// Displacement of the upper wall along the normal.
        RISE = "rise" in "nm";
    }
}

columns! {
    /// Quantities of a window of the sliding of two bodies.
    pub(super) const IN_SLIDING_WINDOW {
        /// Mean friction force over mean normal force in the window.
        FRICTION_COEFFICIENT = "friction coefficient";
        /// Distance of the heights at which the mean velocity of the window is a tenth and nine tenths of that of the upper body, over 0.8: the height of a layer whose velocity is linear. A plane on which bodies slide gives the thickness of a layer of the profile.
        SHEARED_THICKNESS = "thickness of the shear layer" in "nm";
        /// Number of spheres that have left both bodies: each has moved relative to either body by more than the most frequent diameter since the beginning.
        SPHERES_BETWEEN = "spheres of the third body";
        /// Their mass over the density of the solid and the cross-section.
        THIRD_BODY_THICKNESS = "thickness of the third body" in "nm";
    }
}

columns! {
    /// Columns of a profile: layers as thick as the most frequent diameter from the bottom of the box upwards, those without spheres left out.
    pub(super) const PROFILE {
        /// Height of the middle of the layer.
        LAYER_HEIGHT = "height" in "nm";
        /// Number of spheres with their centres in the layer at the end of the window.
        LAYER_SPHERES = "spheres";
        /// Their velocity in the direction of sliding, averaged over the window and by mass.
        LAYER_VELOCITY = "mean velocity" in "m/s";
        /// Their displacement in the direction of sliding since the beginning, averaged by mass.
        LAYER_DISPLACEMENT = "mean displacement" in "nm";
    }
}

/// Columns of a window of two sliding bodies.
pub(super) fn sliding_windows() -> Vec<Column> {
    [&[SLID, RISE, MEAN_FRICTION, MEAN_NORMAL_FORCE], IN_SLIDING_WINDOW].concat()
}

/// The columns of a stage.
pub(super) fn columns_of(setup: &Setup) -> Vec<Column> {
    match setup {
        Setup::None => RELAXATION.into(),
        Setup::Walls { .. } => TEST.into(),
        Setup::Junction(_) => JUNCTION.into(),
        Setup::Bodies(_) => vec![SLID, RISE, FRICTION, NORMAL_FORCE],
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
            /// Thickness of the shear layer between two sliding bodies, averaged over the windows in the second half of the sliding distance.
            SHEARED_THICKNESS = "thickness of the shear layer" in "nm";
            /// That thickness over the critical junction size d* (Eq. 22).
            SHEARED_OVER_CRITICAL = "thickness of the shear layer over d*";
            /// Thickness of a solid layer with the mass of all spheres that have left both bodies, in the last window.
            THIRD_BODY_THICKNESS = "thickness of the third body" in "nm";
            /// That thickness over d*.
            THIRD_BODY_OVER_CRITICAL = "thickness of the third body over d*";
        }
    }
}
