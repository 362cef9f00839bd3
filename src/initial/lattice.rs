//! Hexagonal close packing.

use crate::spec::Vec3;
use crate::spec::mechanics::solids::hcp_cell;
use crate::system::{Domain, Particles, System};

/// Sides of the orthogonal cell of four spheres: along a close-packed row (x), across it in the basal plane (y), along the hexagonal axis (z).
fn cell(diameter: f64) -> [f64; 3] {
    hcp_cell(diameter).into()
}

/// Places of the four spheres in the cell, as fractions of its sides. Rows stand a quarter of a row distance off the faces,
/// so that no sphere lies on a face.
const BASIS: [[f64; 3]; 4] =
    [[0.25, 1.0 / 12.0, 0.25], [0.75, 7.0 / 12.0, 0.25], [0.75, 11.0 / 12.0, 0.75], [0.25, 5.0 / 12.0, 0.75]];

/// Whole numbers of cells whose sides are nearest to `lengths`, at least two along each axis: one cell is too short for a
/// sphere to tell a neighbour from its own image.
pub fn hcp_cells(diameter: f64, lengths: [f64; 3]) -> [usize; 3] {
    let cell = cell(diameter);
    std::array::from_fn(|a| ((lengths[a] / cell[a]).round() as usize).max(2))
}

/// Side lengths of the box of whole cells that is nearest to `lengths`.
pub fn hcp_sides(diameter: f64, lengths: [f64; 3]) -> [f64; 3] {
    let (cell, cells) = (cell(diameter), hcp_cells(diameter, lengths));
    std::array::from_fn(|a| cells[a] as f64 * cell[a])
}

/// Number of spheres in a box of whole cells.
pub fn hcp_number(diameter: f64, sides: [f64; 3]) -> f64 {
    BASIS.len() as f64 * hcp_cells(diameter, sides).iter().map(|&cells| cells as f64).product::<f64>()
}

/// Touching equal spheres on the lattice in a periodic box of whole cells, at rest. The mass of a sphere is such that the
/// *box* has the given density, as the paper does with its relaxed samples.
pub fn hcp(diameter: f64, cells: [usize; 3], density: f64) -> System {
    let cell = cell(diameter);
    let mass = density * cell.iter().product::<f64>() / BASIS.len() as f64;
    let mut particles = Particles::default();
    for a in 0..cells[0] {
        for b in 0..cells[1] {
            for c in 0..cells[2] {
                for place in BASIS {
                    let corner = [a as f64, b as f64, c as f64];
                    let x = std::array::from_fn(|k| (corner[k] + place[k]) * cell[k]);
                    particles.push(Vec3(x), 0.5 * diameter, mass, 0);
                }
            }
        }
    }
    System::new(particles, Domain::periodic(std::array::from_fn(|k| cells[k] as f64 * cell[k])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observe::packing::volume_fraction;
    use crate::spec::Real;

    #[test]
    fn every_sphere_touches_twelve_and_no_other_is_nearer_than_the_square_root_of_two() {
        let d = 2.5;
        let system = hcp(d, [3, 2, 2], 1.0);
        let x = &system.particles.x;
        for i in 0..x.len() {
            let mut touching = 0;
            for j in 0..x.len() {
                for image in images() {
                    let distance = (x[j] + system.domain.shift(image) - x[i]).norm() / d;
                    if distance > 0.0 && distance < 1.4 {
                        assert!((distance - 1.0).abs() < 1e-14, "{distance}");
                        touching += 1;
                    }
                }
            }
            assert_eq!(touching, 12);
        }
    }

    fn images() -> impl Iterator<Item = [i16; 3]> {
        (-1..=1).flat_map(|a| (-1..=1).flat_map(move |b| (-1..=1).map(move |c| [a, b, c])))
    }

    #[test]
    fn its_volume_fraction_is_that_of_close_packing() {
        let system = hcp(0.3, [2, 3, 4], 1.0);
        assert!((volume_fraction(&system) - f64::pi() / (3.0 * 2f64.sqrt())).abs() < 1e-14);
        let total: f64 = system.particles.mass.iter().sum();
        assert!((total / system.domain.volume() - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_paper_s_patch_is_25_by_14_by_2_cells() {
        assert_eq!(hcp_cells(1.0, [25.0, 25.0, 3.0]), [25, 14, 2]);
    }

    #[test]
    fn boxes_hold_whole_cells_at_least_two_along_each_axis() {
        // Sides of a cell: the diameter times 1, 1.732 and 1.633.
        assert_eq!(hcp_cells(2.0, [0.1, 8.0, 0.1]), [2, 2, 2]);
        assert_eq!(hcp_cells(2.0, [4.9, 8.7, 11.4]), [2, 3, 3]);
        assert_eq!(hcp_cells(2.0, [5.1, 8.6, 11.5]), [3, 2, 4]);
        let [x, y, z] = hcp_sides(2.0, [5.1, 8.6, 11.5]);
        assert!(x == 6.0 && (y - 4.0 * 3f64.sqrt()).abs() < 1e-14 && (z - 8.0 * (8.0f64 / 3.0).sqrt()).abs() < 1e-14);
        assert_eq!(hcp_number(2.0, [5.1, 8.6, 11.5]), 96.0);
        let system = hcp(2.0, [3, 2, 4], 0.5);
        assert_eq!((system.particles.len(), system.domain), (96, Domain::periodic([x, y, z])));
        assert!(system.particles.radius.iter().all(|&r| r == 1.0));
        // None lies on a face.
        assert!(system.particles.x.iter().all(|c| (0..3).all(|a| c.0[a] > 0.1 && c.0[a] < [x, y, z][a] - 0.1)));
    }
}
