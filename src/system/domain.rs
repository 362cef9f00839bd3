//! The orthogonal box, periodic along the axes that say so.

use serde::{Deserialize, Serialize};

/// Which copy of the box a neighbour is seen in, along each axis.
pub type Image = [i16; 3];

/// A box from the origin to `sides`, nm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Domain {
    /// Lengths of the sides.
    pub sides: [f64; 3],
    /// Whether the box is periodic along each axis.
    pub periodic: [bool; 3],
}

impl Domain {
    /// A box that is periodic along every axis.
    pub fn periodic(sides: [f64; 3]) -> Self {
        Self { sides, periodic: [true; 3] }
    }
}
