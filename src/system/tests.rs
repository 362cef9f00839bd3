use super::*;

fn at(x: f64) -> Vec3<f64> {
    Vec3([x, 2.0 * x, -x])
}

/// Three spheres, the last two a body, all of them in motion.
fn three() -> System {
    let mut particles = Particles::default();
    (0..3).for_each(|k| particles.push(at(10.0 * f64::from(k)), 1.0 + f64::from(k), 4.0 + f64::from(k), 7 + k));
    let mut system = System::new(particles, Domain::periodic([100.0; 3]));
    system.add_body(&[1, 2]);
    for k in 0..3 {
        (system.particles.v[k], system.particles.w[k]) = (at(k as f64 + 0.5), at(k as f64 + 1.5));
    }
    (system.bodies[0].v, system.bodies[0].l) = (at(3.0), at(4.0));
    system
}

#[test]
fn spheres_keep_their_ids_when_they_change_places() {
    let system = three();
    let picked = system.particles.pick(&[2, 0]);
    assert_eq!((picked.len(), picked.is_empty(), Particles::default().is_empty()), (2, false, true));
    assert_eq!(
        (&picked.x, &picked.v, &picked.w),
        (&vec![at(20.0), at(0.0)], &vec![at(2.5), at(0.5)], &vec![at(3.5), at(1.5)])
    );
    assert_eq!((&picked.radius, &picked.mass, &picked.tag), (&vec![3.0, 1.0], &vec![6.0, 4.0], &vec![9, 7]));
    assert_eq!((&picked.body, &picked.wall, &picked.id), (&vec![1, 0], &vec![0, 0], &vec![2, 0]));
    assert_eq!(picked.arm, [system.particles.arm[2], Vec3::zero()]);
    assert_eq!(picked.by_id(), [1, 0]);
    assert_eq!((system.time, system.lag, system.step), (0.0, 0.0, 0));
    let turned = System { particles: picked, ..system };
    assert_eq!((turned.place(0), turned.place(2)), (1, 0));
    assert_eq!(turned.places(), BTreeMap::from([(0, 1), (2, 0)]));
}

#[test]
fn a_new_sphere_is_free_and_at_rest() {
    let mut particles = three().particles;
    particles.push(at(5.0), 0.5, 0.25, 3);
    assert_eq!(
        (particles.x[3], particles.v[3], particles.w[3], particles.arm[3]),
        (at(5.0), at(0.0), at(0.0), at(0.0))
    );
    assert_eq!((particles.radius[3], particles.mass[3], particles.tag[3], particles.id[3]), (0.5, 0.25, 3, 3));
    assert_eq!((particles.wall[3], particles.body[3]), (0, 0));
}

#[test]
fn a_wall_takes_its_spheres_and_bodies_along_and_sets_them_free() {
    let mut system = three();
    let (free, spin) = (system.particles.v[0], system.particles.w[0]);
    system.add_wall([Motion::Velocity(1.0), Motion::Load(2.0), Motion::Return { speed: 3.0, turn: 1.0 }], |_, i| i > 0);
    let velocity = Vec3([1.0, 0.0, -3.0]);
    assert_eq!(system.particles.wall, [0, 1, 1]);
    assert_eq!(system.particles.v, [free, velocity, velocity]);
    assert_eq!(system.particles.w, [spin, Vec3::zero(), Vec3::zero()]);
    let body = &system.bodies[0];
    assert_eq!((body.wall, body.v, body.l), (1, velocity, Vec3::zero()));
    assert_eq!((system.walls[0].mass, system.walls[0].velocity, system.walls[0].age), (11.0, velocity, 0.0));
    assert_eq!([0, 1, 2].map(|axis| system.walls[0].load(axis)), [None, Some(2.0), None]);
    // Another wall leaves the first as it is.
    system.add_wall([Motion::Velocity(5.0); 3], |_, i| i == 0);
    assert_eq!((system.particles.wall.clone(), system.bodies[0].wall), (vec![2, 1, 1], 1));
    assert_eq!((system.walls[1].mass, system.particles.v[0], system.particles.v[1]), (4.0, Vec3([5.0; 3]), velocity));
    system.walls[0].age = 9.0;
    system.walls[0].redirect([Motion::Load(1.0); 3]);
    let wall = &system.walls[0];
    assert_eq!((wall.motion, wall.age, wall.velocity), ([Motion::Load(1.0); 3], 0.0, velocity));
    system.remove_walls();
    assert_eq!((system.walls.len(), system.particles.wall, system.bodies[0].wall), (0, vec![0, 0, 0], 0));
}

#[test]
fn springs_are_kept_for_the_pairs_that_have_any() {
    let here = [0; 3];
    let mut springs = Springs::new(2);
    springs.add((4, 5, here), [3.0, 4.0].into_iter());
    springs.add((1, 2, here), [0.0, 0.0].into_iter());
    springs.add((0, 2, here), [0.0, 1.0].into_iter());
    springs.add((0, 2, [0, 0, 1]), [2.0, 0.0].into_iter());
    let mut springs = springs.sorted();
    let bonds = |springs: &Springs| springs.bonds().collect::<Vec<_>>();
    assert_eq!(bonds(&springs), [(0, 2, here), (0, 2, [0, 0, 1]), (4, 5, here)]);
    let of = |springs: &Springs, bond: Bond| springs.of(bond).map(<[f64]>::to_vec);
    assert_eq!(of(&springs, (4, 5, here)), Some(vec![3.0, 4.0]));
    assert_eq!(of(&springs, (0, 2, here)), Some(vec![0.0, 1.0]));
    assert_eq!(of(&springs, (0, 2, [0, 0, 1])), Some(vec![2.0, 0.0]));
    assert_eq!([(1, 2, here), (4, 5, [1, 0, 0]), (5, 4, here)].map(|bond| of(&springs, bond)), [None, None, None]);
    springs.replace(|pair| pair == (0, 2), |old| vec![old[0] - 2.0 * old[0], 0.0]);
    assert_eq!(bonds(&springs), [(0, 2, [0, 0, 1]), (4, 5, here)]);
    assert_eq!(of(&springs, (0, 2, [0, 0, 1])), Some(vec![-2.0, 0.0]));
    assert_eq!(of(&springs, (4, 5, here)), Some(vec![3.0, 4.0]));
}

#[test]
fn a_contact_is_found_again_where_it_was_nearest_and_only_once() {
    let places = [(1, 9.0), (3, 0.0), (3, 1.0), (3, 5.0), (6, 1.0)].map(|(sphere, x)| (sphere, Vec3([x, 0.0, 0.0])));
    let contacts = ContactTable { places: places.to_vec(), springs: (0..10).map(f64::from).collect() };
    let place = |x: f64| Vec3([x, 0.0, 0.0]);
    let mut of = contacts.of(3);
    assert_eq!(of.take(place(3.25), 1.5), None);
    assert_eq!(of.take(place(0.75), 0.25), Some(&[4.0, 5.0][..]));
    assert_eq!(of.take(place(0.75), 0.75), Some(&[2.0, 3.0][..]));
    assert_eq!(of.take(place(0.75), 0.75), None);
    assert_eq!(of.rest().collect::<Vec<_>>(), [(place(5.0), &[6.0, 7.0][..])]);
    assert_eq!(contacts.of(1).rest().collect::<Vec<_>>(), [(place(9.0), &[0.0, 1.0][..])]);
    assert_eq!(contacts.of(6).take(place(1.0), 0.0), Some(&[8.0, 9.0][..]));
    for sphere in [0, 2, 7] {
        assert_eq!((contacts.of(sphere).rest().count(), contacts.of(sphere).take(place(1.0), 9.0)), (0, None));
    }
}
