//! Does a surface with edges attract as its distance says, however it is cut into triangles and in whatever order?

mod common;

use common::soot::{DT, MASS, RADIUS, between, dry, run, settings, space};
use veridem::spec::Vec3;
use veridem::spec::soot::SUBSTRATE;
use veridem::system::{Mesh, Particles, PrescribedMotion, Shape, Surface, System};

/// A groove along y with sides that rise at this angle, rad, the right one cut last.
fn groove(rise: f64) -> Vec<[Vec3<f64>; 3]> {
    let at = |x: f64, y: f64| Vec3([x, y, x.abs() * rise.tan()]);
    let side = |x: f64| {
        let [a, b, c, d] = [at(0.0, -100.0), at(x, -100.0), at(x, 100.0), at(0.0, 100.0)];
        if x > 0.0 { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] }
    };
    [side(-90.0), side(90.0)].concat()
}

/// A square of 200 nm in `2 n^2` triangles.
fn square(n: usize) -> Shape {
    let at = |i: usize, j: usize| Vec3([200.0 * i as f64 / n as f64 - 100.0, 200.0 * j as f64 / n as f64 - 100.0, 0.0]);
    let corners = |i, j| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
    let halves = |(i, j)| {
        let [a, b, c, d] = corners(i, j);
        [[a, b, c], [a, c, d]]
    };
    let triangles: Vec<_> = (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).flat_map(halves).collect();
    Shape::Mesh(Mesh::new(&triangles).expect("a square"))
}

fn above(triangles: &[[Vec3<f64>; 3]], x: Vec3<f64>, v: Vec3<f64>) -> System {
    let mut particles = Particles::default();
    particles.push(x, RADIUS, MASS, 0);
    particles.v[0] = v;
    let shape = Shape::Mesh(Mesh::new(triangles).expect("a groove"));
    let surfaces = vec![Surface::new("substrate", SUBSTRATE, shape, PrescribedMotion::Still)];
    System { surfaces, ..System::new(particles, space()) }
}

#[test]
fn a_sphere_stays_in_the_middle_of_a_groove_whatever_the_order_of_its_facets() {
    let mut triangles = groove(std::f64::consts::FRAC_PI_4);
    for _ in 0..triangles.len() {
        triangles.rotate_left(1);
        let height = 2f64.sqrt() * (RADIUS + 1.0);
        let system = above(&triangles, Vec3([0.0, 0.0, height]), Vec3([0.0, 0.0, -5.0]));
        let after = run(dry(), system, settings(DT), 50_000);
        let place = after.system().particles.x[0];
        assert!(place.0[2] < height, "it falls: {place:?}");
        assert!(place.0[0].abs() < 1e-6, "{place:?}");
    }
}

#[test]
fn the_energy_of_a_sphere_that_crosses_a_groove_is_accounted_for() {
    // Sides at right, obtuse and nearly flat angles; the sphere passes from the share of one side to that of the other.
    for rise in [0.79f64, 0.6, 0.3, 0.1] {
        let residual = |dt: f64| {
            let lowest = (RADIUS + 1.5) / rise.cos();
            let system = above(&groove(rise), Vec3([-9.0, 0.0, lowest + 9.0 * rise.tan()]), Vec3([20.0, 0.0, 0.0]));
            let after = run(dry(), system, settings(dt), (0.5 / dt) as usize);
            let ledger = after.ledger();
            let exchanged = (ledger.surfaces.stored.iter().sum::<f64>()
                - ledger.surfaces.stored_at_start.iter().sum::<f64>())
            .abs();
            assert!(exchanged > 1e-3, "the attraction has changed: {exchanged}");
            ledger.physical_residual().abs() / ledger.turnover()
        };
        let (coarse, fine) = (residual(DT), residual(DT / 4.0));
        assert!(coarse < 1e-4 && fine < 0.4 * coarse, "rise {rise}: {coarse} and {fine}");
    }
}

#[test]
fn a_square_of_thousands_of_triangles_attracts_like_one_of_two() {
    let end = |n| run(dry(), between(square(n)), settings(DT), 5_000).system().particles.clone();
    let (few, many) = (end(1), end(40));
    for (a, b) in few.x.iter().zip(&many.x) {
        assert!((*a - *b).norm() < 1e-8, "{a:?} {b:?}");
    }
}
