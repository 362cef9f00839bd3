use super::*;
use crate::geometry::{SphereExtent, gyration_radius as measured, pairs_within};
use crate::initial::aggregate::components;
use crate::spec::Vec3;
use law::Sums;
use proptest::prelude::*;

/// The aggregates of the paper.
fn paper(number: usize) -> Recipe {
    Recipe { number, d_f: 1.8, k_f: 1.4, radii: Radii::Equal(14.0), method: Method::Clusters }
}

fn recipes() -> impl Strategy<Value = Recipe> {
    let radii = prop_oneof![
        Just(Radii::Equal(14.0)),
        (1.0..1.6f64).prop_map(|deviation| Radii::LogNormal { median: 10.0, deviation })
    ];
    let methods = prop_oneof![Just(Method::Clusters), Just(Method::Spheres)];
    (20usize..120, 1.6..2.0f64, 1.2..1.5f64, radii, methods).prop_map(|(number, d_f, k_f, radii, method)| Recipe {
        number,
        d_f,
        k_f,
        radii,
        method,
    })
}

/// Gaps of the pairs that are near, as parts of their distance when they touch.
fn gaps(spheres: &[Sphere]) -> Vec<f64> {
    let near = pairs_within(spheres, |r, s| 1.01 * (r + s), &Interrupt::default()).unwrap();
    near.iter().map(|&(i, j)| spheres[i].gap(&spheres[j]) / (spheres[i].radius + spheres[j].radius)).collect()
}

fn lawful(recipe: &Recipe, spheres: &[Sphere]) -> f64 {
    recipe.law().gyration_radius(&Sums::of(spheres))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn a_tree_of_touching_spheres_obeys_the_law(recipe in recipes(), seed: u64) {
        let spheres = aggregate(&recipe, seed, &Interrupt::default()).unwrap();
        prop_assert_eq!(spheres.len(), recipe.number);
        let gaps = gaps(&spheres);
        prop_assert!(gaps.iter().all(|&gap| gap > -1e-12), "{:?}", gaps);
        prop_assert_eq!(gaps.iter().filter(|gap| gap.abs() < 1e-12).count(), recipe.number - 1);
        prop_assert_eq!(components(&spheres, &Interrupt::default()).unwrap(), 1);
        let radius = measured(&spheres, SphereExtent::Centres);
        prop_assert!((radius / lawful(&recipe, &spheres) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_same_seed_gives_the_same_bits(recipe in recipes(), seed: u64) {
        let spheres = aggregate(&recipe, seed, &Interrupt::default()).unwrap();
        prop_assert_eq!(&spheres, &aggregate(&recipe, seed, &Interrupt::default()).unwrap());
        prop_assert_ne!(&spheres, &aggregate(&recipe, seed ^ 1, &Interrupt::default()).unwrap());
    }
}

#[test]
fn the_law_is_met_at_every_joining() {
    // Clusters of every size that occurs on the way are aggregates themselves.
    for number in 3..40 {
        for method in [Method::Clusters, Method::Spheres] {
            let recipe = Recipe { method, ..paper(number) };
            let spheres = aggregate(&recipe, 5, &Interrupt::default()).unwrap();
            assert!((measured(&spheres, SphereExtent::Centres) / lawful(&recipe, &spheres) - 1.0).abs() < 1e-12);
            let mut misses = 0;
            let mut stream = Stream::new(number as u64, "test");
            let mut check = |a: &Cluster, b: &Cluster, stream: &mut Stream| {
                let whole = join(a, b, &recipe.law(), stream, &Interrupt::default()).unwrap();
                let wanted = recipe.law().gyration_radius(&whole.sums);
                misses += usize::from(whole.spheres.len() > 2 && (whole.square.sqrt() / wanted - 1.0).abs() > 1e-12);
                whole
            };
            let mut grown: Vec<Cluster> = (0..number).map(|_| Cluster::single(14.0, SphereExtent::Centres)).collect();
            while grown.len() > 1 {
                let (a, b) = (grown.remove(0), grown.remove(0));
                grown.push(check(&a, &b, &mut stream));
            }
            assert_eq!(misses, 0, "{number}");
        }
    }
}

#[test]
fn the_gyration_radius_of_the_paper_s_aggregates_is_188_nm() {
    let found = measured(&aggregate(&paper(150), 0, &Interrupt::default()).unwrap(), SphereExtent::Centres);
    assert!((found / 187.88208972745044 - 1.0).abs() < 1e-13, "{found}");
    let found = measured(&aggregate(&paper(10), 0, &Interrupt::default()).unwrap(), SphereExtent::Centres);
    assert!((found / 41.73508950162514 - 1.0).abs() < 1e-13, "{found}");
}

#[test]
fn one_and_two_spheres_are_aggregates_too() {
    assert_eq!(
        aggregate(&paper(1), 3, &Interrupt::default()).unwrap(),
        [Sphere { centre: Vec3::zero(), radius: 14.0 }]
    );
    let two = aggregate(&paper(2), 3, &Interrupt::default()).unwrap();
    assert!(two[0].gap(&two[1]).abs() < 1e-13);
}

#[test]
fn directions_are_spread_over_the_sphere() {
    let n = 2000;
    let mut mean = Vec3::zero();
    for seed in 0..n {
        let spheres = aggregate(&paper(4), seed, &Interrupt::default()).unwrap();
        let way = spheres[3].centre - spheres[0].centre;
        mean = mean + way * (1.0 / way.norm() / n as f64);
    }
    // Five standard errors of a component of a random direction.
    assert!(mean.0.iter().all(|c| c.abs() < 5.0 / (3.0 * n as f64).sqrt()), "{mean:?}");
}

#[test]
fn compact_aggregates_grow_one_sphere_after_the_other() {
    let recipe = Recipe { d_f: 2.5, k_f: 1.3, method: Method::Spheres, ..paper(100) };
    assert!(gaps(&aggregate(&recipe, 1, &Interrupt::default()).unwrap()).iter().all(|&gap| gap > -1e-12));
}

#[test]
fn what_cannot_be_grown_is_refused() {
    assert_eq!(aggregate(&paper(0), 0, &Interrupt::default()), Err(Failure::Recipe));
    assert_eq!(aggregate(&Recipe { d_f: f64::NAN, ..paper(5) }, 0, &Interrupt::default()), Err(Failure::Recipe));
    assert_eq!(
        aggregate(
            &Recipe { radii: Radii::LogNormal { median: 1.0, deviation: 0.5 }, ..paper(5) },
            0,
            &Interrupt::default()
        ),
        Err(Failure::Recipe)
    );
    // Three spheres in a row are still too compact for the law.
    match aggregate(&Recipe { k_f: 1.0, ..paper(3) }, 0, &Interrupt::default()) {
        Err(Failure::Unmet { number: 3, wanted, reached }) => assert!(reached < wanted, "{reached} {wanted}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn sizes_are_drawn_within_two_deviations_about_the_median() {
    let mut stream = Stream::new(1, "test");
    let radii = Radii::LogNormal { median: 10.0, deviation: 1.5 };
    let mut drawn: Vec<f64> = (0..4001).map(|_| radii.draw(&mut stream)).collect();
    drawn.sort_by(f64::total_cmp);
    assert!(drawn[0] >= 10.0 / 2.25 && drawn[0] < 10.0 / 2.15 && drawn[4000] <= 22.5 && drawn[4000] > 21.5);
    // Five standard errors of the median; the quarters are 0.6394 deviations away, as those of the normal distribution cut off at two are.
    let logarithm = |k: usize| (drawn[k] / 10.0).ln() / 1.5f64.ln();
    assert!(
        [(1000, -0.6394), (2000, 0.0), (3000, 0.6394)].iter().all(|&(k, known)| (logarithm(k) - known).abs() < 0.11)
    );
    assert_eq!(Radii::Equal(3.0).draw(&mut stream), 3.0);
    // A larger normal number gives a larger sphere.
    let (normal, drawn) = (Stream::new(2, "test").normal(), radii.draw(&mut Stream::new(2, "test")));
    assert!(normal.abs() < 2.0 && (drawn / 10.0 - 1.5f64.powf(normal)).abs() < 1e-14, "{normal} {drawn}");
}

#[test]
fn recipes_have_numbers_in_their_ranges() {
    let recipe = Recipe { number: 2, d_f: 1.0, k_f: 1.0, radii: Radii::Equal(1.0), method: Method::Spheres };
    let log_normal = |median, deviation| Recipe { radii: Radii::LogNormal { median, deviation }, ..recipe };
    let grown = |recipe: Recipe| aggregate(&recipe, 0, &Interrupt::default()).map(|spheres| spheres.len());
    for fine in [recipe, Recipe { number: 1, ..recipe }, log_normal(1.0, 1.0), log_normal(1.0, 2.0)] {
        assert_eq!(grown(fine), Ok(fine.number), "{fine:?}");
    }
    for wrong in [
        Recipe { number: 0, ..recipe },
        Recipe { d_f: 0.0, ..recipe },
        Recipe { d_f: f64::INFINITY, ..recipe },
        Recipe { k_f: 0.0, ..recipe },
        Recipe { k_f: f64::INFINITY, ..recipe },
        Recipe { radii: Radii::Equal(0.0), ..recipe },
        Recipe { radii: Radii::Equal(f64::INFINITY), ..recipe },
        log_normal(0.0, 1.0),
        log_normal(1.0, 0.99),
        log_normal(1.0, f64::INFINITY),
        log_normal(1.0, f64::NAN),
    ] {
        assert_eq!(grown(wrong), Err(Failure::Recipe), "{wrong:?}");
    }
    let interrupt = Interrupt::default();
    interrupt.request();
    assert_eq!(aggregate(&Recipe { number: 3, ..recipe }, 0, &interrupt), Err(Failure::Interrupted));
}

#[test]
fn failures_are_told_in_words() {
    let unmet = |reached| Failure::Unmet { number: 3, wanted: 2.0, reached };
    let text = "no aggregate of 3 spheres with a radius of gyration of 2.000000 nm was found, the closest has";
    for (failure, expected) in [
        (Failure::Interrupted, "the growth was interrupted".to_string()),
        (unmet(1.5), format!("{text} 1.500000 nm")),
        (unmet(2.0), format!("{text} 2.000000 nm")),
        (unmet(2.5), format!("{text} 2.500000 nm; compact aggregates are easier to grow with `growth: spheres`")),
    ] {
        assert_eq!(failure.to_string(), expected);
    }
    assert!(matches!(Failure::Interrupted.of("sample"), Error::Interrupted));
    assert_eq!(unmet(1.5).of("sample").to_string(), format!("sample: {text} 1.500000 nm"));
}

#[test]
fn every_sphere_is_as_likely_as_any_other_to_come_first() {
    let law = Law { k_f: 1.4, d_f: 1.8, form: Form::GeometricMean };
    let mut counts = [0; 4];
    for seed in 0..400 {
        let radii = vec![1.0, 1.001, 1.002, 1.003];
        let mut stream = Stream::new(seed, "test");
        let (spheres, _) = grown(radii, 4, &law, &mut stream, &Interrupt::default()).unwrap();
        let mut found: Vec<usize> = spheres.iter().map(|s| ((s.radius - 1.0) * 1000.0).round() as usize).collect();
        counts[found[0]] += 1;
        found.sort_unstable();
        assert_eq!(found, [0, 1, 2, 3]);
    }
    // Five standard deviations.
    assert!(counts.iter().all(|&count: &i32| (count - 100).abs() < 44), "{counts:?}");
}
