//! The rigid motion closest to the motion of a set of points.

use crate::geometry::jacobi::eigenvectors;
use crate::spec::Vec3;
use crate::spec::mechanics::rotation::to_space;

/// A rotation about a centre and the displacement of the centre.
#[derive(Clone, Copy, Debug)]
pub struct RigidMotion {
    /// Centre of mass before.
    pub from: Vec3<f64>,
    /// Centre of mass after.
    pub to: Vec3<f64>,
    /// Rotation matrix, rows first.
    pub rotation: [Vec3<f64>; 3],
    /// The part of the mean square relative displacement (after subtracting that of the centre) which the rotation
    /// explains: 1 for a rigid body, 1/2 for a round body in simple shear, 0 when nothing turned.
    pub rigidity: f64,
}

impl RigidMotion {
    /// The best fit, in the sense of least squares weighted by mass (Kabsch); none for fewer than three points.
    pub fn fit(before: &[Vec3<f64>], after: &[Vec3<f64>], mass: &[f64]) -> Option<Self> {
        if before.len() < 3 {
            return None;
        }
        let (from, to) = (centre(before, mass), centre(after, mass));
        let mut product = [[0.0; 3]; 3];
        for ((&a, &b), &m) in before.iter().zip(after).zip(mass) {
            let (a, b) = (a - from, b - to);
            for row in 0..3 {
                for column in 0..3 {
                    product[row][column] += m * a.0[row] * b.0[column];
                }
            }
        }
        let (q_0, q) = nearest_turn(product);
        let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|e| to_space(q_0, q, Vec3(e)));
        let rotation = std::array::from_fn(|row| Vec3(columns.map(|column| column.0[row])));
        let mut motion = Self { from, to, rotation, rigidity: 0.0 };
        let (mut left, mut all) = (0.0, 0.0);
        for ((&a, &b), &m) in before.iter().zip(after).zip(mass) {
            let (miss, relative) = (b - motion.apply(a), (b - to) - (a - from));
            left += m * miss.dot(miss);
            all += m * relative.dot(relative);
        }
        motion.rigidity = if all > 0.0 { 1.0 - left / all } else { 1.0 };
        Some(motion)
    }

    /// Where the motion takes a point.
    pub fn apply(&self, x: Vec3<f64>) -> Vec3<f64> {
        let x = x - self.from;
        self.to + Vec3(self.rotation.map(|row| row.dot(x)))
    }

    /// Angle of the rotation about z, rad, from -pi to pi: of the rotation's projection on the plane of shear.
    pub fn angle_about_z(&self) -> f64 {
        let [x, y, _] = self.rotation;
        libm::atan2(y.0[0] - x.0[1], x.0[0] + y.0[1])
    }
}

/// The unit quaternion of the rotation `R` for which `sum m b . R a` is largest, given `sum m a_row b_column`: the eigenvector of Horn's matrix with the
/// largest eigenvalue. It is a rotation even where a reflection would fit better, as when the cloud is flat or torn.
fn nearest_turn([[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]]: [[f64; 3]; 3]) -> (f64, Vec3<f64>) {
    let (values, axes) = eigenvectors([
        [xx + yy + zz, yz - zy, zx - xz, xy - yx],
        [yz - zy, xx - yy - zz, xy + yx, zx + xz],
        [zx - xz, xy + yx, yy - xx - zz, yz + zy],
        [xy - yx, zx + xz, yz + zy, zz - xx - yy],
    ]);
    let largest = (0..4).fold(0, |most, k| if values[k] > values[most] { k } else { most });
    let [q_0, a, b, c] = axes[largest];
    let scale = 1.0 / (q_0 * q_0 + a * a + b * b + c * c).sqrt();
    (q_0 * scale, Vec3([a, b, c]) * scale)
}

/// Centre of mass.
pub fn centre(x: &[Vec3<f64>], mass: &[f64]) -> Vec3<f64> {
    let total: f64 = mass.iter().sum();
    x.iter().zip(mass).fold(Vec3::zero(), |sum, (&x, &m)| sum + x * (m / total))
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::Mat;
    use proptest::prelude::*;

    /// Kabsch's way: by the singular values of the covariance.
    fn kabsch(before: &[Vec3<f64>], after: &[Vec3<f64>], mass: &[f64]) -> [Vec3<f64>; 3] {
        let (from, to) = (centre(before, mass), centre(after, mass));
        let entry = |row: usize, column: usize| {
            let parts = before.iter().zip(after).zip(mass);
            parts.map(|((&a, &b), m)| m * (b - to).0[row] * (a - from).0[column]).sum::<f64>()
        };
        let svd = Mat::from_fn(3, 3, entry).svd().unwrap();
        let (u, v) = (svd.U(), svd.V());
        let mirrored = (u * v.transpose()).determinant() < 0.0;
        let sign = |k: usize| if mirrored && k == 2 { -1.0 } else { 1.0 };
        let entry = |row: usize, column: usize| (0..3).map(|k| sign(k) * u[(row, k)] * v[(column, k)]).sum::<f64>();
        std::array::from_fn(|row| Vec3(std::array::from_fn(|column| entry(row, column))))
    }

    fn turned(axis: Vec3<f64>, angle: f64, x: Vec3<f64>) -> Vec3<f64> {
        // Rodrigues' formula.
        let n = axis * (1.0 / axis.norm());
        x * angle.cos() + n.cross(x) * angle.sin() + n * (n.dot(x) * (1.0 - angle.cos()))
    }

    fn vector(size: f64) -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-size..size).prop_map(Vec3)
    }

    proptest! {
        #[test]
        fn the_motion_of_a_rigid_cloud_is_recovered(
            cloud in prop::collection::vec(vector(3.0), 8..20),
            axis in vector(1.0).prop_filter("an axis", |a| a.norm() > 0.1),
            angle in -3.0..3.0,
            shift in vector(10.0),
        ) {
            let mass: Vec<f64> = (1..=cloud.len()).map(|k| k as f64).collect();
            let after: Vec<_> = cloud.iter().map(|&x| turned(axis, angle, x) + shift).collect();
            let motion = RigidMotion::fit(&cloud, &after, &mass).unwrap();
            for (&x, &y) in cloud.iter().zip(&after) {
                prop_assert!((motion.apply(x) - y).norm() < 1e-11);
            }
            prop_assert!(1.0 - motion.rigidity < 1e-12 || angle.abs() < 1e-6);
        }

        #[test]
        fn a_cloud_that_is_deformed_turns_as_its_singular_values_say(
            cloud in prop::collection::vec((vector(3.0), vector(0.3)), 8..20),
            axis in vector(1.0).prop_filter("an axis", |a| a.norm() > 0.1),
            angle in -3.0..3.0,
        ) {
            let mass: Vec<f64> = (1..=cloud.len()).map(|k| k as f64).collect();
            let (before, after): (Vec<_>, Vec<_>) =
                cloud.iter().map(|&(x, off)| (x, turned(axis, angle, x) + off)).unzip();
            let motion = RigidMotion::fit(&before, &after, &mass).unwrap();
            let known = kabsch(&before, &after, &mass);
            for row in 0..3 {
                prop_assert!((motion.rotation[row] - known[row]).norm() < 1e-11, "{motion:?} {known:?}");
            }
        }

        #[test]
        fn the_angle_about_z_is_recovered(cloud in prop::collection::vec(vector(3.0), 8..20), angle in -3.1..3.1) {
            let mass = vec![1.0; cloud.len()];
            let after: Vec<_> = cloud.iter().map(|&x| turned(Vec3([0.0, 0.0, 1.0]), angle, x)).collect();
            let motion = RigidMotion::fit(&cloud, &after, &mass).unwrap();
            prop_assert!((motion.angle_about_z() - angle).abs() < 1e-10);
        }
    }

    #[test]
    fn simple_shear_of_a_round_cloud_turns_by_half_the_shear_and_is_half_rigid() {
        let n = 400;
        let ring: Vec<_> = (0..n).map(|k| f64::from(k) * std::f64::consts::TAU / f64::from(n)).collect();
        let before: Vec<_> = ring.iter().map(|t| Vec3([t.cos(), t.sin(), 0.1 * (3.0 * t).sin()])).collect();
        let shear = 1e-4;
        let after: Vec<_> = before.iter().map(|&x| x + Vec3([shear * x.0[1], 0.0, 0.0])).collect();
        let motion = RigidMotion::fit(&before, &after, &vec![1.0; ring.len()]).unwrap();
        assert!((motion.angle_about_z() / (-0.5 * shear) - 1.0).abs() < 1e-4);
        assert!((motion.rigidity - 0.5).abs() < 1e-3, "{}", motion.rigidity);
    }

    #[test]
    fn two_points_have_no_rotation() {
        assert!(RigidMotion::fit(&[Vec3::zero(); 2], &[Vec3::zero(); 2], &[1.0; 2]).is_none());
    }

    #[test]
    fn three_points_have_a_motion_and_two_have_none() {
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]].map(Vec3);
        let after = points.map(|x| turned(Vec3([0.0, 0.0, 1.0]), 0.5, x));
        let of = |count: usize| RigidMotion::fit(&points[..count], &after[..count], &[1.0; 3][..count]);
        let motion = of(3).expect("a motion");
        assert!(points.iter().zip(after).all(|(&x, to)| (motion.apply(x) - to).norm() < 1e-12));
        assert!(of(2).is_none());
    }
}
