//! Does the neighbour list agree with a search over all pairs?

mod common;

use common::{settings, uniform, wear};
use quickcheck::{QuickCheck, TestResult};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use veridem::geometry::{Neighbour, neighbours};
use veridem::motion::BoxRelaxation;
use veridem::run::advance;
use veridem::simulation::Simulation;
use veridem::spec::mechanics::box_relaxation::box_inertia;
use veridem::spec::{PairModel, Vec3};
use veridem::system::{Domain, Particles, System};

/// Every pair and every copy within two boxes, the long way.
fn brute_force(x: &[Vec3<f64>], radius: &[f64], domain: &Domain, reach: impl Fn(f64, f64) -> f64) -> Vec<Neighbour> {
    let copies = |a: usize| if domain.periodic[a] { -9..=9 } else { 0..=0 };
    let mut all = Vec::new();
    for p in 0..x.len() {
        for q in p..x.len() {
            for i in copies(0) {
                for j in copies(1) {
                    for k in copies(2) {
                        let image = [i, j, k];
                        let apart = x[p] - (x[q] + domain.shift(image));
                        let near = apart.dot(apart) < reach(radius[p], radius[q]) * reach(radius[p], radius[q]);
                        if near && (p != q || image > [0; 3]) {
                            all.push(Neighbour { p: p as u32, q: q as u32, image });
                        }
                    }
                }
            }
        }
    }
    all.sort_unstable();
    all
}

#[test]
fn spheres_far_apart_in_a_plane_need_no_cells_between_them() {
    let domain = Domain { sides: [1.0; 3], periodic: [false; 3] };
    let x = [[0.0, 0.0], [1e9, 1e9], [1e9, 1e9 + 1.0]].map(|[x, y]| Vec3([x, y, 0.0]));
    let found = neighbours(&x, &[1.0; 3], &domain, |r, s| r + s);
    assert_eq!(found, [Neighbour { p: 1, q: 2, image: [0; 3] }]);
}

#[test]
fn the_list_is_every_pair_in_reach() {
    fn same(seed: u64, count: u8, axes: u8) -> TestResult {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let periodic = [axes & 1 != 0, axes & 2 != 0, axes & 4 != 0];
        // Boxes down to less than one reach across, positions some boxes away, radii over three octaves.
        let domain = Domain { sides: [1.5 + 5.0 * uniform(&mut rng), 6.0, 2.0 + 3.0 * uniform(&mut rng)], periodic };
        let x: Vec<_> = (0..count % 40)
            .map(|_| Vec3(std::array::from_fn(|a| domain.sides[a] * (3.0 * uniform(&mut rng) - 1.0))))
            .collect();
        let radius: Vec<_> = x.iter().map(|_| 0.1 + 0.9 * uniform(&mut rng) * uniform(&mut rng)).collect();
        let reach = |r_i: f64, r_j: f64| 1.1 * (r_i + r_j) + 0.2;
        TestResult::from_bool(neighbours(&x, &radius, &domain, reach) == brute_force(&x, &radius, &domain, reach))
    }
    QuickCheck::new().tests(60).quickcheck(same as fn(u64, u8, u8) -> TestResult);
}

/// A sphere, and another beyond its range.
fn apart(offset: Vec3<f64>, particles: &mut Particles) {
    let x = offset + Vec3([30.0 * particles.len() as f64; 3]);
    [Vec3::zero(), offset].into_iter().for_each(|from| particles.push(x + from, 1.0, 1.0, 0));
}

#[test]
fn spheres_that_a_shrinking_box_brings_together_are_listed() {
    let mut particles = Particles::default();
    let range = wear().range(1.0, 1.0);
    apart(Vec3([1.5 * range, 0.0, 0.0]), &mut particles);
    let side = 40.0 * range;
    // The box shrinks to half its size in some hundred steps.
    let pull = 1e-5 / (1e-5f64 * 1e-5) * box_inertia(2.0, side) / side.powi(3);
    let relaxation = BoxRelaxation { target: [-pull; 3], modulus: 1e-9 };
    let system = System::new(particles, Domain::periodic([side; 3]));
    let mut simulation = Simulation::new(wear(), system, settings(1e-5).relax_box(relaxation)).expect("a valid system");
    assert_eq!(simulation.pairs().count(), 0);
    while simulation.system().domain.sides[0] > 0.55 * side {
        advance(&mut simulation, 1).expect("a stable step");
    }
    assert_eq!(simulation.pairs().count(), 1);
}

#[test]
fn spheres_that_fly_together_along_any_axis_are_listed() {
    let range = wear().range(1.0, 1.0);
    for axis in 0..3 {
        let mut particles = Particles::default();
        let mut offset = Vec3::zero();
        offset.0[axis] = 2.0 * range;
        // Eight of them are advanced at once.
        for pair in 0..8 {
            apart(offset, &mut particles);
            particles.v[2 * pair] = offset * 100.0;
        }
        let domain = Domain { sides: [1e3; 3], periodic: [false; 3] };
        let system = System::new(particles, domain);
        let mut simulation = Simulation::new(wear(), system, settings(1e-5)).expect("a valid system");
        assert_eq!(simulation.pairs().count(), 0);
        advance(&mut simulation, 550).expect("a stable step");
        assert_eq!(simulation.pairs().count(), 8, "axis {axis}");
    }
}
