//! How far what acts, which limit of the time step is the tightest, what a neck bears and what it leaves.

use super::*;

const STIFF: Springs<f64> = Springs { k_n: 9000.0, k_t: 7000.0, k_r: 5000.0, k_o: 4000.0, ..UNDAMPED };

fn at(distance: f64) -> Contact<f64> {
    Contact::new(along(distance), Vec3::zero(), Vec3::zero(), Vec3::zero(), 1.0, 1.0)
}

#[test]
fn pairs_reach_as_far_as_the_attraction_and_as_far_as_they_touch() {
    let range = |a: f64, psi: f64, r: f64| law(UNDAMPED, Attraction { a, psi, ..NONE }).range(r, r + 1.0);
    assert_eq!([range(0.0, 0.0, 1.0), range(0.5, 0.0, 1.0), range(0.0, 0.2, 1.0)], [3.0, 6.0, 6.0]);
    assert_eq!([range(0.0, 0.0, 3.0), range(0.5, 0.0, 3.0)], [7.0; 2]);
    let surface = |hamaker: f64, r: f64| {
        let mut law = law(UNDAMPED, NONE);
        law.walls[1].hamaker = hamaker;
        law.surface_range(1, r)
    };
    assert_eq!([surface(0.0, 1.0), surface(0.5, 1.0), surface(0.5, 5.0)], [1.0, 4.0, 5.0]);
}

#[test]
fn a_surface_attracts_up_to_the_cutoff_and_its_energies_go_by_share() {
    let law = law(UNDAMPED, NONE);
    let wall = &law.walls[0];
    for (r, gap, pulls) in [(0.5, 3.4, true), (0.5, 3.5, true), (0.5, 3.6, false), (2.0, 1.9, true), (2.0, 2.1, false)]
    {
        assert_eq!([wall.pull(gap, r) != 0.0, wall.energy(gap, r) < 0.0 || gap == 3.5], [pulls; 2], "{r} {gap}");
        let slope = (wall.energy(gap + 1e-6, r) - wall.energy(gap - 1e-6, r)) / 2e-6;
        assert!(gap == 3.5 || (slope - wall.pull(gap, r).abs()).abs() < 1e-6, "{r} {gap}");
        let none = Vec3::zero();
        let touch = Touch { gap, r, n: along(1.0), v: none, omega: none };
        let held = law.surface_stored(0, &touch, &Memory::zero(), 0.25);
        assert_eq!((held.van_der_waals, held.necks, held.capillary), (0.25 * wall.energy(gap, r), 0.0, 0.0));
    }
}

#[test]
fn the_stiffer_of_neck_and_contact_limits_the_step() {
    let limit = STIFF.critical_time_step(1.0, 1.0, 2.0);
    for (neck, contact) in [(STIFF, UNDAMPED), (UNDAMPED, STIFF)] {
        let law = Soot { neck, contact, ..law(UNDAMPED, NONE) };
        assert_eq!(law.critical_time_step_among(1.0, 1.0, 2.0), limit);
        assert_eq!(law.critical_time_step(1.0, 1.0), STIFF.critical_time_step(1.0, 1.0, 1.0));
    }
}

#[test]
fn a_joined_pair_has_the_springs_of_a_neck_and_any_other_those_of_a_contact() {
    let law = Soot { neck: STIFF, contact: UNDAMPED, ..law(UNDAMPED, NONE) };
    let free = law.coefficients(1.0, 1.0, 1.0, 1.0);
    let neck = law.joined(free);
    assert_eq!([free, neck].map(|pair| pair.bonded), [0.0, 1.0]);
    let memory =
        Memory { tangential: Vec3::new(0.0, 0.1, 0.0), rolling: Vec3::new(0.0, 0.0, 0.2), torsion: 0.3, rest: 0.0 };
    let (held, loose) = (law.stored(&at(1.75), &neck, &memory), law.stored(&at(1.75), &free, &memory));
    let four = |s: &Springs<f64>| [s.k_n * 0.0625, s.k_t * 0.01, s.k_r * 0.04, s.k_o * 0.09].map(|twice| 0.5 * twice);
    assert!((held.necks / four(&STIFF).iter().sum::<f64>() - 1.0).abs() < 1e-14);
    assert_eq!([held.normal, held.tangential, held.rolling, held.torsion], [0.0; 4]);
    assert_eq!(loose.necks, 0.0);
    for (stored, expected) in [loose.normal, loose.tangential, loose.rolling, loose.torsion].iter().zip(four(&UNDAMPED))
    {
        assert!((stored / expected - 1.0).abs() < 1e-14);
    }
    assert!(law.is_near(&at(1.75), &free) && !law.is_near(&at(2.0), &free) && law.is_near(&at(2.5), &neck));
}

#[test]
fn a_neck_bears_its_strength_and_leaves_the_gap_of_spheres_that_overlap() {
    let law = Soot { neck: STIFF, ..law(UNDAMPED, NONE) };
    let k = law.joined(law.coefficients(1.0, 1.0, 1.0, 1.0));
    let memory = Memory { tangential: Vec3::new(0.0, 0.1, 0.0), ..Memory::zero() };
    let (c, radius) = (at(2.25), 0.5);
    let held = law.stored(&c, &k, &memory);
    let (tension, shear) = law.neck_stress(&c, &memory, radius);
    let breaks = |energy: Option<f64>, stress: Option<[f64; 3]>| {
        law.neck_breaks(&c, &memory, &held, &Strength { energy, stress })
    };
    assert!(!breaks(None, None) && !breaks(Some(held.necks), None) && breaks(Some(held.necks.next_down()), None));
    assert!(tension > 0.0 && shear > 0.0 && !breaks(None, Some([tension, shear, radius])));
    assert!(
        breaks(None, Some([tension.next_down(), shear, radius]))
            && breaks(None, Some([tension, shear.next_down(), radius]))
    );
    assert!(!breaks(None, Some([2.0 * tension, 2.0 * shear, radius])));
    let left = |rest: f64| Soot::<Along>::left_by_neck(Memory { rest, ..memory });
    assert_eq!([left(-0.1), left(0.2)], [Memory { rest: -0.1, ..Memory::zero() }, Memory::zero()]);
}

#[test]
fn spheres_apart_attract_each_other_as_their_energies_say() {
    let law = law(UNDAMPED, ATTRACTION);
    let free = law.coefficients(1.0, 1.0, 1.0, 1.0);
    let energy = |d: f64| {
        let held = law.stored(&at(d), &free, &Memory::zero());
        held.van_der_waals + held.capillary
    };
    for d in [2.05, 2.2, 2.8, 3.5, 4.0] {
        let force = law.pair(&at(d), &free, Memory::zero(), 0.1).wrench.force;
        let slope = (energy(d + 1e-5) - energy(d - 1e-5)) / 2e-5;
        assert!(slope > 1e-4 && (force + along(slope)).norm() < 1e-6 * (1.0 + slope), "{d}: {force:?} {slope}");
    }
}
