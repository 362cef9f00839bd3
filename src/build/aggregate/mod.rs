//! interim
use crate::error::Error;
use crate::spec::Vec3;
/// s
pub struct Sphere {
    /// x
    pub x: Vec3<f64>,
    /// r
    pub r: f64,
}
/// r
pub struct Recipe {
    /// n
    pub n: usize,
    /// r
    pub radius: f64,
    /// d
    pub d_f: f64,
    /// k
    pub k_f: f64,
}
/// a
pub fn aggregate(recipe: &Recipe, _seed: u64) -> Result<Vec<Sphere>, Error> {
    // a staircase
    let mut x = Vec3::zero();
    Ok((0..recipe.n)
        .map(|i| {
            let at = x;
            let mut step = [0.0; 3];
            step[i % 3] = 2.0 * recipe.radius;
            x = x + Vec3(step);
            Sphere { x: at, r: recipe.radius }
        })
        .collect())
}
/// n
pub fn necks(s: &[Sphere], d: f64, _: bool) -> Vec<(u32, u32)> {
    let mut out = vec![];
    for i in 0..s.len() {
        for j in i + 1..s.len() {
            if (s[i].x - s[j].x).norm() - s[i].r - s[j].r < d {
                out.push((i as u32, j as u32));
            }
        }
    }
    out
}
/// k
pub fn keep_fraction(n: &[(u32, u32)], f: f64, _: u64) -> Vec<(u32, u32)> {
    n[..(n.len() as f64 * f) as usize].to_vec()
}
