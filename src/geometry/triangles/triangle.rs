//! The point of a triangle that is nearest to another point.

use crate::spec::Vec3;

/// On which part of a triangle a point is. Edge `k` goes from corner `k` to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Inside.
    Face,
    /// On an edge.
    Edge(usize),
    /// On a corner.
    Corner(usize),
}

/// The nearest point to `p`, and where on the triangle it is: the corners' and edges' regions are told apart by projections, those of
/// the edges and the face by areas.
pub fn nearest([a, b, c]: [Vec3<f64>; 3], p: Vec3<f64>) -> (Vec3<f64>, Part) {
    let (ab, ac, bc) = (b - a, c - a, c - b);
    let (ap, bp, cp) = (p - a, p - b, p - c);
    let (along_ab, along_ac) = (ab.dot(ap), ac.dot(ap));
    if along_ab <= 0.0 && along_ac <= 0.0 {
        return (a, Part::Corner(0));
    }
    let (beyond_ab, ac_at_b) = (ab.dot(bp), ac.dot(bp));
    if beyond_ab >= 0.0 && ac_at_b <= beyond_ab {
        return (b, Part::Corner(1));
    }
    let (ab_at_c, beyond_ac) = (ab.dot(cp), ac.dot(cp));
    if beyond_ac >= 0.0 && ab_at_c <= beyond_ac {
        return (c, Part::Corner(2));
    }
    let area_c = along_ab * ac_at_b - beyond_ab * along_ac;
    if area_c <= 0.0 && along_ab >= 0.0 && beyond_ab <= 0.0 {
        return (a + ab * (along_ab / (along_ab - beyond_ab)), Part::Edge(0));
    }
    let area_b = ab_at_c * along_ac - along_ab * beyond_ac;
    if area_b <= 0.0 && along_ac >= 0.0 && beyond_ac <= 0.0 {
        return (a + ac * (along_ac / (along_ac - beyond_ac)), Part::Edge(2));
    }
    let area_a = beyond_ab * beyond_ac - ab_at_c * ac_at_b;
    let (from_b, from_c) = (ac_at_b - beyond_ab, ab_at_c - beyond_ac);
    if area_a <= 0.0 && from_b >= 0.0 && from_c >= 0.0 {
        return (b + bc * (from_b / (from_b + from_c)), Part::Edge(1));
    }
    let share = 1.0 / (area_a + area_b + area_c);
    (a + ab * (area_b * share) + ac * (area_c * share), Part::Face)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-2.0..2.0).prop_map(Vec3)
    }

    proptest! {
        #[test]
        fn no_point_of_the_triangle_is_nearer(corners in prop::array::uniform3(vector()), p in vector(), u in 0.0..1.0, v in 0.0..1.0) {
            let [a, b, c] = corners;
            prop_assume!((b - a).cross(c - a).norm() > 1e-3);
            let (point, part) = nearest(corners, p);
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            let other = a + (b - a) * u + (c - a) * v;
            prop_assert!((p - point).norm() <= (p - other).norm() + 1e-9);
            // It lies on the part that is named.
            match part {
                Part::Corner(k) => prop_assert_eq!(point, corners[k]),
                Part::Edge(k) => {
                    let (from, to) = (corners[k], corners[(k + 1) % 3]);
                    prop_assert!(((point - from).norm() + (to - point).norm() - (to - from).norm()).abs() < 1e-12);
                }
                Part::Face => prop_assert!((p - point).dot(b - a).abs() < 1e-9 && (p - point).dot(c - a).abs() < 1e-9),
            }
        }
    }
}
