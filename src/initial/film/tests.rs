use super::aggregates::aggregates;
use super::deposition::Path;
use super::*;
use crate::geometry::Sphere;
use crate::geometry::neighbours;
use crate::geometry::{SphereExtent, gyration_radius, pairs_within};
use crate::initial::aggregate::law::{Form, Law, Sums};
use crate::interrupt::Interrupt;
use crate::observe::film::Structure;
use crate::random::Stream;
use crate::system::Domain;

/// More than rounding, nm.
const TOUCH: f64 = 1e-6;

fn small() -> FilmPlan {
    FilmPlan::paper(3000, [400.0, 500.0])
}

/// Equal spheres that fall one by one.
fn single_spheres(number: usize, side: f64, drift: f64) -> FilmPlan {
    FilmPlan {
        diameters: Diameters { median: 10.0, deviation: 1.45, smallest: 10, largest: 10 },
        numbers: Numbers { median: 1.0, deviation: 0.1, largest: 1 },
        drift,
        ..FilmPlan::paper(number, [side; 2])
    }
}

#[test]
fn aggregates_obey_the_law_and_are_trees_of_touching_spheres() {
    for aggregate in aggregates(&small(), 3, &Interrupt::default()).unwrap() {
        let spheres = aggregate.spheres;
        let n = spheres.len();
        let lawful = Law { k_f: 1.0, d_f: 1.8, form: Form::SauterDiameter }.gyration_radius(&Sums::of(&spheres));
        assert!((gyration_radius(&spheres, SphereExtent::Radii) / lawful - 1.0).abs() < 1e-9);
        let gaps: Vec<f64> = pairs_within(&spheres, |r, s| 1.01 * (r + s), &Interrupt::default())
            .unwrap()
            .iter()
            .map(|&(i, j)| spheres[i].gap(&spheres[j]))
            .collect();
        assert!(gaps.iter().all(|&gap| gap > -1e-11));
        assert_eq!(gaps.iter().filter(|gap| gap.abs() < 1e-11).count(), n - 1);
    }
}

#[test]
fn aggregates_too_small_for_the_law_come_as_near_as_they_can() {
    let plan = FilmPlan { numbers: Numbers { median: 3.0, deviation: 0.5, largest: 6 }, ..small() };
    let aggregates = aggregates(&FilmPlan { spheres: 300, ..plan }, 3, &Interrupt::default()).unwrap();
    assert!(aggregates.iter().any(|a| a.spheres.len() == 3) && aggregates.iter().all(|a| a.spheres.len() <= 6));
}

#[test]
fn an_aggregate_rests_on_the_floor_or_touches_one_earlier_sphere_and_overlaps_none() {
    let plan = small();
    let film = plan.build(5, &Interrupt::default()).unwrap();
    let centres: Vec<Vec3<f64>> = film.spheres.iter().map(|s| s.centre).collect();
    let radii: Vec<f64> = film.spheres.iter().map(|s| 0.5 * s.diameter).collect();
    let [width, depth] = film.sides;
    let column = Domain { sides: [width, depth, film.thickness], periodic: [true, true, false] };
    let mut touches = vec![0; film.aggregates()];
    for pair in neighbours(&centres, &radii, &column, |r, s| 1.01 * (r + s)) {
        let (p, q) = (pair.p as usize, pair.q as usize);
        let gap = (centres[p] - centres[q] - column.shift(pair.image)).norm() - radii[p] - radii[q];
        assert!(gap > -1e-10, "{p} {q} {gap}");
        let (a, b) = (film.spheres[p].aggregate, film.spheres[q].aggregate);
        if a != b && gap < 1e-10 {
            touches[a.max(b) as usize] += 1;
        }
    }
    let mut lowest = vec![f64::INFINITY; film.aggregates()];
    for (s, r) in film.spheres.iter().zip(&radii) {
        let low = &mut lowest[s.aggregate as usize];
        *low = low.min(s.centre.0[2] - r);
    }
    for aggregate in 0..film.aggregates() {
        let on_floor = lowest[aggregate].abs() < 1e-10;
        assert_eq!(on_floor, film.on_floor[aggregate]);
        assert_eq!(touches[aggregate], usize::from(!on_floor), "aggregate {aggregate}");
        assert!(lowest[aggregate] > -1e-10);
    }
    assert!(film.spheres.len() >= plan.spheres && film.on_floor[0] && !film.on_floor.iter().all(|&floor| floor));
    let highest = film.spheres.iter().zip(&radii).map(|(s, r)| s.centre.0[2] + r).fold(0.0, f64::max);
    assert_eq!(film.thickness, highest);
}

#[test]
fn the_same_seed_gives_the_same_film_on_any_number_of_threads() {
    let plan = FilmPlan { spheres: 500, ..small() };
    let build = |seed, threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| plan.build(seed, &Interrupt::default()).unwrap())
    };
    assert_eq!(build(1, 1), build(1, 3));
    assert_ne!(build(1, 1), build(2, 1));
}

#[test]
fn sizes_have_the_distributions_of_the_paper() {
    let plan = FilmPlan { cluster: 1000, ..FilmPlan::paper(20_000, [2000.0; 2]) };
    let mut stream = Stream::new(1, "test");
    let mut numbers: Vec<usize> = (0..4001).map(|_| plan.numbers.draw(&mut stream)).collect();
    numbers.sort_unstable();
    // Five standard errors of the median of a log-normal distribution.
    let error = 5.0 * 36.0 * 0.5 * (std::f64::consts::FRAC_PI_2 / 4001.0).sqrt();
    assert!((numbers[2000] as f64 - 36.0).abs() < error, "{}", numbers[2000]);
    assert!(numbers[0] >= 1 && numbers[4000] <= 128);
    let classes = plan.diameters.classes();
    let drawn: Vec<f64> = (0..40_000).map(|_| aggregates::draw(&classes, &mut stream)).collect();
    let moment = |power: i32| drawn.iter().map(|d| d.powi(power)).sum::<f64>();
    // Means of the shares; about five standard errors.
    assert!((moment(1) / 40_000.0 - 9.561).abs() < 0.1 && (moment(3) / moment(2) - 12.210).abs() < 0.15);
}

#[test]
fn a_fall_spreads_as_far_as_diffusion_in_the_time_of_the_drift() {
    // From the height of one tiny sphere down to the floor: <x^2> = 2 D t with t = height / drift on average, whatever the floor does.
    let (height, drift, diffusion) = (1000.0, 0.1, 2.0);
    let sides = [2000.0; 2];
    let mut column = Column::new(sides, 5.0);
    column.add(Vec3([0.0, 0.0, height]), 1e-3);
    let sphere = [Sphere { centre: Vec3::zero(), radius: 0.1 }];
    let path = Path { drift, diffusion, graze: 1e-4 };
    let falls = 1000;
    let mut squares = 0.0;
    for seed in 0..falls {
        let mut begin = Stream::new(seed, "fall");
        let (x, y) = (sides[0] * begin.uniform(), sides[1] * begin.uniform());
        let (at, on_floor) =
            path.fall(&column, &sphere, sides, &mut Stream::new(seed, "fall"), &Interrupt::default()).expect("a place");
        assert!(on_floor && (at.0[2] - 0.1).abs() < 1e-12);
        squares += (at.0[0] - x).powi(2) + (at.0[1] - y).powi(2);
    }
    let expected = 2.0 * 2.0 * diffusion * height / drift;
    // The square of a way in the plane is exponential but for the spread of the times, which is small: five standard errors and a bit.
    let found = squares / falls as f64;
    assert!((found / expected - 1.0).abs() < 6.0 / (falls as f64).sqrt(), "{found} {expected}");
}

#[test]
fn spheres_that_rain_straight_down_fill_0_147_of_the_volume() {
    // Ballistic deposition of equal spheres that stick where they touch: 0.1465 (Jullien & Meakin, Europhys. Lett. 4, 1385, 1987).
    let film = single_spheres(8000, 200.0, 1e6).build(1, &Interrupt::default()).unwrap();
    let solid = 1.0 - Structure::of(&film, TOUCH, 1).porosity;
    assert!((solid / 0.1465 - 1.0).abs() < 0.04, "{solid}");
}

#[test]
fn the_slower_the_drift_the_more_porous_the_film() {
    let porosity = |drift| {
        Structure::of(&single_spheres(1500, 150.0, drift).build(1, &Interrupt::default()).unwrap(), TOUCH, 1).porosity
    };
    let (fast, slow) = (porosity(100.0), porosity(0.1));
    assert!(slow > fast + 0.02, "{fast} {slow}");
}

#[test]
fn a_column_knows_the_room_that_a_search_of_all_spheres_finds() {
    let film = small().build(2, &Interrupt::default()).unwrap();
    let mut column = Column::new(film.sides, 11.5);
    for s in &film.spheres {
        column.add(s.centre, 0.5 * s.diameter);
    }
    let mut stream = Stream::new(4, "test");
    for _ in 0..300 {
        let [x, y, z] = [film.sides[0], film.sides[1], film.thickness].map(|side| side * stream.uniform());
        let x = Vec3([x, y, z]);
        let exact = film.spheres.iter().fold(z, |least, s| {
            let to = s.centre - x;
            let nearest = |a: usize| to.0[a] - (to.0[a] / film.sides[a]).round() * film.sides[a];
            least.min(Vec3([nearest(0), nearest(1), to.0[2]]).norm() - 0.5 * s.diameter)
        });
        assert!((column.clearance(x) - exact).abs() < 1e-9 || (exact < 0.0 && column.clearance(x) < 0.0));
        let anything = column::FreeDistance { gap: f64::INFINITY, nearest: column::Nearest::Unknown };
        let room = column.room(x, 0.0, anything);
        assert!(room.gap <= exact + 1e-9 && (exact <= 0.0 || room.gap > 0.0), "{} {exact}", room.gap);
    }
}

#[test]
fn what_cannot_be_built_is_refused() {
    assert_eq!(FilmPlan::paper(10, [30.0; 2]).build(1, &Interrupt::default()), Err(Failure::Narrow { least: 34.5 }));
    let numbers = Numbers { median: 100.0, deviation: 0.1, largest: 128 };
    match (FilmPlan { numbers, ..FilmPlan::paper(1000, [35.0; 2]) }).build(1, &Interrupt::default()) {
        Err(Failure::Wide { number, extent }) => assert!(number > 50 && extent > 100.0, "{number} {extent}"),
        other => panic!("{:?}", other.map(|film| film.thickness)),
    }
    let open = FilmPlan { k_f: 0.1, ..small() }.build(1, &Interrupt::default());
    assert!(matches!(open, Err(Failure::Ungrown(Ungrown::Unmet { .. }))));
}

#[test]
fn a_class_holds_the_shares_from_the_one_before_it_up_to_its_own() {
    let share = Stream::new(1, "test").uniform();
    let drawn = |first: f64| aggregates::draw(&[(3.0, first), (4.0, 1.0)], &mut Stream::new(1, "test"));
    assert_eq!([drawn(share.next_up()), drawn(share), drawn(0.0)], [3.0, 4.0, 4.0]);
    // Rounding may leave the last share below one.
    assert_eq!(aggregates::draw(&[(3.0, 0.0), (4.0, 0.0)], &mut Stream::new(1, "test")), 4.0);
}

#[test]
fn shares_of_diameters_rise_to_one_and_numbers_are_whole_from_one_on() {
    let classes = Diameters { median: 9.0, deviation: 1.45, smallest: 3, largest: 23 }.classes();
    assert!(classes.iter().map(|class| class.0).eq((3..=23).map(f64::from)));
    assert!(classes.is_sorted_by(|a, b| a.1 < b.1) && (classes[20].1 - 1.0).abs() < 1e-12);
    // Of one class alone the share is one.
    let one = Diameters { median: 9.0, deviation: 1.45, smallest: 9, largest: 9 }.classes();
    assert!(one.len() == 1 && one[0].0 == 9.0 && (one[0].1 - 1.0).abs() < 1e-12);
    let mut stream = Stream::new(1, "test");
    let mut numbers = |median, largest| {
        let numbers = Numbers { median, deviation: 0.5, largest };
        let drawn: Vec<usize> = (0..200).map(|_| numbers.draw(&mut stream)).collect();
        [drawn.iter().min(), drawn.iter().max()].map(|end| *end.expect("numbers"))
    };
    assert_eq!([numbers(0.7, 2), numbers(3.0, 3)], [[1, 2], [1, 3]]);
}

#[test]
fn failures_are_told_in_words() {
    for (failure, text) in [
        (Failure::Narrow { least: 34.5 }, "the column is too narrow, its sides must not be below 34.5 nm"),
        (
            Failure::Wide { number: 7, extent: 12.4 },
            "an aggregate of 7 spheres is 12 nm long and touches its own periodic image: the column is too narrow",
        ),
        (Failure::Ungrown(Ungrown::Interrupted), "the growth was interrupted"),
    ] {
        assert_eq!(failure.to_string(), text);
    }
    assert!(matches!(Failure::Ungrown(Ungrown::Interrupted).of("film"), Error::Interrupted));
    assert_eq!(
        Failure::Narrow { least: 1.0 }.of("film").to_string(),
        "film: the column is too narrow, its sides must not be below 1 nm"
    );
}

#[test]
fn a_film_may_have_sides_of_just_one_cell() {
    let plan = single_spheres(3, 15.0, 1e3);
    let film = plan.build(1, &Interrupt::default()).unwrap();
    assert_eq!((film.spheres.len(), film.aggregates()), (3, 3));
    let narrow = FilmPlan { sides: [15.0, 14.9], ..plan };
    assert_eq!(narrow.build(1, &Interrupt::default()), Err(Failure::Narrow { least: 15.0 }));
}

#[test]
fn aggregates_have_as_many_spheres_as_are_drawn_and_small_ones_need_not_meet_the_law() {
    let numbers = Numbers { median: 3.0, deviation: 1e-9, largest: 3 };
    let plan = FilmPlan { spheres: 10, numbers, cluster: 3, ..small() };
    let found = aggregates(&plan, 1, &Interrupt::default()).unwrap();
    assert_eq!(found.iter().map(|aggregate| aggregate.spheres.len()).collect::<Vec<_>>(), [3; 4]);
    let open = FilmPlan { k_f: 0.1, ..plan };
    assert_eq!(aggregates(&open, 1, &Interrupt::default()).unwrap().len(), 4);
    let joined = aggregates(&FilmPlan { cluster: 2, ..open }, 1, &Interrupt::default());
    assert!(matches!(joined.map(|found| found.len()), Err(Failure::Ungrown(Ungrown::Unmet { number: 3, .. }))));
}

#[test]
fn aggregates_come_to_rest_in_the_column() {
    let film = single_spheres(40, 40.0, 1e-2).build(1, &Interrupt::default()).unwrap();
    assert!(film.spheres.iter().all(|s| (0..2).all(|a| (0.0..40.0).contains(&s.centre.0[a]))));
}

#[test]
fn a_film_is_a_system_of_fixed_and_of_free_aggregates() {
    let sphere = |x: f64, z: f64, diameter, aggregate| FilmSphere { centre: Vec3([x, 5.0, z]), diameter, aggregate };
    let spheres = vec![
        sphere(2.0, 2.0, 4.0, 0),
        sphere(12.0, 12.0, 4.0, 1),
        sphere(6.0, 2.0, 4.0, 0),
        sphere(16.0, 12.0, 4.0, 1),
        sphere(19.0, 12.0, 2.0, 1),
        sphere(30.0, 1.0, 2.0, 2),
    ];
    let film = DepositedFilm { spheres, on_floor: vec![true, false, true], sides: [40.0, 10.0], thickness: 14.0 };
    let [rigid, necked] = [Bonding::Rigid, Bonding::Necks].map(|bonding| film.system(bonding, |d| (0.4 * d, d)));
    for system in [&rigid, &necked] {
        assert_eq!(system.domain, Domain { sides: [40.0, 10.0, 14.0], periodic: [true, true, false] });
        assert_eq!(system.particles.tag, [0, 1, 0, 1, 1, 2]);
        assert_eq!((system.particles.radius[4], system.particles.mass[4]), (0.8, 2.0));
        assert_eq!(system.particles.x[3], Vec3([16.0, 5.0, 12.0]));
        assert_eq!(system.particles.wall, [1, 0, 1, 0, 0, 1]);
        assert_eq!((system.walls.len(), system.walls[0].mass), (1, 10.0));
    }
    assert_eq!((rigid.particles.body, rigid.necks), (vec![2, 1, 2, 1, 1, 2], vec![]));
    assert_eq!((necked.particles.body, necked.necks), (vec![1, 0, 1, 0, 0, 1], vec![(1, 3), (3, 4)]));
}
