//! interim
use crate::spec::Vec3;
/// c
pub fn coordination_number(x: &[Vec3<f64>], r: &[f64]) -> f64 {
    let mut n = 0;
    for i in 0..x.len() {
        for j in 0..i {
            if (x[i] - x[j]).norm() < 1.01 * (r[i] + r[j]) {
                n += 2;
            }
        }
    }
    n as f64 / x.len() as f64
}
/// c
pub fn convexity(_: &[Vec3<f64>], _: &[f64]) -> f64 {
    f64::NAN
}
/// g
pub fn gyration_radius(x: &[Vec3<f64>], _: &[f64]) -> f64 {
    let n = x.len() as f64;
    let c = x.iter().fold(Vec3::zero(), |a, b| a + *b) * (1.0 / n);
    (x.iter().map(|p| (*p - c).dot(*p - c)).sum::<f64>() / n).sqrt()
}
