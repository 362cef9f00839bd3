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

#[cfg(test)]
mod tests {
    use super::*;

    const DOMAIN: Domain = Domain { sides: [2.0, 3.0, 5.0], periodic: [true, false, true] };

    #[test]
    fn copies_of_the_box_are_counted_along_periodic_axes() {
        assert_eq!(DOMAIN.volume(), 30.0);
        assert_eq!(DOMAIN.shift([1, -2, 3]), Vec3([2.0, -6.0, 15.0]));
        for (x, image, folded) in [
            ([0.0; 3], [0; 3], [0.0; 3]),
            ([2.0, 3.0, 5.0], [1, 0, 1], [0.0, 3.0, 0.0]),
            ([1.5, 7.0, -0.5], [0, 0, -1], [1.5, 7.0, 4.5]),
            ([-4.5, -7.0, 12.0], [-3, 0, 2], [1.5, -7.0, 2.0]),
        ] {
            assert_eq!((DOMAIN.image_of(Vec3(x)), DOMAIN.folded(Vec3(x))), (image, Vec3(folded)), "{x:?}");
        }
        assert_eq!(Domain::periodic([2.0, 3.0, 5.0]).image_of(Vec3([1.0, 3.5, -6.0])), [0, 1, -2]);
    }

    #[test]
    fn the_nearest_copy_is_at_most_half_a_side_away() {
        for (apart, image) in [
            ([0.9, 2.0, 2.4], [0, 0, 0]),
            ([1.1, 9.0, 2.6], [1, 0, 1]),
            ([-1.1, -9.0, -2.6], [-1, 0, -1]),
            ([4.5, 0.0, -11.0], [2, 0, -2]),
        ] {
            assert_eq!(DOMAIN.nearest_image(Vec3(apart)), image, "{apart:?}");
        }
    }
}
