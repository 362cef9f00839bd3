//! Two spheres of soot and the path of their contact.

use crate::case::quantity::{Length, Quantity, Time, quantity};
use crate::case::section::section;
use crate::papers::path::Leg;

section! {
    /// Two spheres.
    pub struct TwoSpheres {
        /// Their radii.
        radii: [Quantity<Length>; 2] = [quantity("14 nm"), quantity("14 nm")],
        /// Whether a neck joins them, relaxed where they touch.
        neck: bool = false,
    }
}

section! {
    /// Two spheres slide, roll, twist and are pulled apart by prescription, leg by leg. The coating acts as in a restructuring.
    pub struct Path {
        /// Initial distance of their centres; spheres nearer than the sum of their radii press each other.
        distance: Quantity<Length>,
        /// The legs, one after the other; the springs go on from leg to leg.
        legs: Vec<Leg>,
        /// Time step.
        dt: Quantity<Time> = quantity("50 fs"),
    }
}

impl TwoSpheres {
    /// The smaller and the larger radius, nm.
    pub fn radii(&self) -> [f64; 2] {
        let [first, second] = self.radii.each_ref().map(|radius| radius.value);
        [first.min(second), first.max(second)]
    }
}
