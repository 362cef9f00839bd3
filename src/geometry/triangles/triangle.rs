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

    /// The nearest point by another way: the foot on the plane if it is inside, or the nearest of the three sides.
    fn searched([a, b, c]: [Vec3<f64>; 3], p: Vec3<f64>) -> Vec3<f64> {
        let n = (b - a).cross(c - a);
        let foot = p - n * (n.dot(p - a) / n.dot(n));
        if [[a, b], [b, c], [c, a]].iter().all(|[from, to]| (*to - *from).cross(foot - *from).dot(n) >= 0.0) {
            return foot;
        }
        let on_side = |[from, to]: [Vec3<f64>; 2]| {
            let along = to - from;
            from + along * (along.dot(p - from) / along.dot(along)).clamp(0.0, 1.0)
        };
        let sides = [[a, b], [b, c], [c, a]].map(on_side);
        sides.into_iter().min_by(|x, y| (*x - p).norm().total_cmp(&(*y - p).norm())).expect("three sides")
    }

    #[test]
    fn around_triangles_of_all_sizes_and_shapes_the_nearest_point_is_found() {
        let grid = || (-6..=6).map(|k| 0.5 * f64::from(k));
        for scale in [0.2, 1.0, 5.0] {
            for third in [[0.5, 1.5], [2.5, 1.0], [-1.5, 1.0], [0.0, 2.0], [2.0, 1.5]] {
                let corners = [[0.0, 0.0], [2.0, 0.0], third].map(|[x, y]| Vec3([x, y, 0.3 * x]) * scale);
                for [first, second, last] in [[0, 1, 2], [1, 2, 0], [2, 1, 0]] {
                    let corners = [corners[first], corners[second], corners[last]];
                    for (x, y, z) in grid().flat_map(|x| grid().flat_map(move |y| [-1.0, 0.0, 0.7].map(|z| (x, y, z))))
                    {
                        let p = Vec3([x, y, z + 0.3 * x]) * scale;
                        let (point, expected) = (nearest(corners, p).0, searched(corners, p));
                        assert!((point - expected).norm() < 1e-12 * scale, "{corners:?} {p:?}: {point:?} {expected:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_bounds_of_a_region_belong_to_the_corner_or_to_the_edge() {
        let corners = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]].map(Vec3);
        for (p, part, place) in [
            ([1.0, 1.0, 5.0], Part::Face, [1.0, 1.0, 0.0]),
            // Straight before an edge, above it and beyond a corner, at right angles to either edge of the corner.
            ([1.0, -1.0, 2.0], Part::Edge(0), [1.0, 0.0, 0.0]),
            ([1.0, 0.0, 2.0], Part::Edge(0), [1.0, 0.0, 0.0]),
            ([0.5, -1.0, 2.0], Part::Edge(0), [0.5, 0.0, 0.0]),
            ([-1.0, 1.0, 2.0], Part::Edge(2), [0.0, 1.0, 0.0]),
            ([0.0, 1.0, 2.0], Part::Edge(2), [0.0, 1.0, 0.0]),
            ([-1.0, 0.5, 2.0], Part::Edge(2), [0.0, 0.5, 0.0]),
            ([3.0, 3.0, 2.0], Part::Edge(1), [2.0, 2.0, 0.0]),
            ([2.0, 2.0, 2.0], Part::Edge(1), [2.0, 2.0, 0.0]),
            ([4.0, 3.5, 2.0], Part::Edge(1), [2.25, 1.75, 0.0]),
            ([-1.0, -1.0, 2.0], Part::Corner(0), [0.0; 3]),
            ([0.0, -1.0, 2.0], Part::Corner(0), [0.0; 3]),
            ([-1.0, 0.0, 2.0], Part::Corner(0), [0.0; 3]),
            ([0.0, 0.0, 2.0], Part::Corner(0), [0.0; 3]),
            ([4.0, -1.0, 2.0], Part::Corner(1), [4.0, 0.0, 0.0]),
            ([5.0, 1.0, 2.0], Part::Corner(1), [4.0, 0.0, 0.0]),
            ([6.0, 0.0, 2.0], Part::Corner(1), [4.0, 0.0, 0.0]),
            ([4.0, 0.0, 2.0], Part::Corner(1), [4.0, 0.0, 0.0]),
            ([-1.0, 4.0, 2.0], Part::Corner(2), [0.0, 4.0, 0.0]),
            ([1.0, 5.0, 2.0], Part::Corner(2), [0.0, 4.0, 0.0]),
            ([0.0, 6.0, 2.0], Part::Corner(2), [0.0, 4.0, 0.0]),
            ([0.0, 4.0, 2.0], Part::Corner(2), [0.0, 4.0, 0.0]),
        ] {
            assert_eq!(nearest(corners, Vec3(p)), (Vec3(place), part), "{p:?}");
        }
    }
}
