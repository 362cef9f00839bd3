//! The box: its volume and its periodic images.

use crate::spec::Vec3;
use crate::system::{Domain, Image};

impl Domain {
    /// Volume, nm^3.
    pub fn volume(&self) -> f64 {
        self.sides.iter().product()
    }

    /// The displacement of a copy of the box.
    pub fn shift(&self, image: Image) -> Vec3<f64> {
        Vec3(std::array::from_fn(|a| f64::from(image[a]) * self.sides[a]))
    }

    /// The copy of the box that `x` lies in; zero along axes that are not periodic.
    pub fn image_of(&self, x: Vec3<f64>) -> Image {
        std::array::from_fn(|a| if self.periodic[a] { (x.0[a] / self.sides[a]).floor() as i16 } else { 0 })
    }

    /// The copy of `q` that is nearest to `p`, of two points that are `apart = p - q`.
    pub fn nearest_image(&self, apart: Vec3<f64>) -> Image {
        std::array::from_fn(|a| if self.periodic[a] { (apart.0[a] / self.sides[a]).round() as i16 } else { 0 })
    }

    /// The point of the box that `x` is a copy of.
    pub fn folded(&self, x: Vec3<f64>) -> Vec3<f64> {
        x - self.shift(self.image_of(x))
    }
}
