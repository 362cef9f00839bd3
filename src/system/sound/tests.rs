//! A sound state, and states that violate one condition each.

use super::*;
use crate::system::System;

const ZERO: Vec3<f64> = Vec3([0.0; 3]);
const NAN: Vec3<f64> = Vec3([0.0, f64::NAN, 0.0]);
const TOO_LARGE: Vec3<f64> = Vec3([0.0, 0.0, -1.1 * LARGEST]);

/// Five spheres, two of them a body in a wall, a plane and a mesh with contacts, a spring, necks and contact history.
fn sound() -> System {
    let rate = PrescribedMotion::Reversal { velocity: -1.0, rate: 2.0, turn: 3.0 };
    let surface = |shape, motion| {
        let force = Forces { contact: ZERO, friction: ZERO, van_der_waals: ZERO };
        let contacts = ContactTable { places: vec![(1, ZERO), (4, ZERO)], springs: vec![0.5; 6] };
        let (name, velocity, way) = ("tip".into(), ZERO, ZERO);
        Surface { name, material: 0, shape, motion, velocity, way, age: 0.0, force, contacts }
    };
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3);
    let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3]];
    let mesh = Mesh::new(&faces.map(|face| face.map(|corner: usize| corners[corner]))).expect("a surface");
    let mut builder = System::builder().domain(Domain { sides: [20.0, 8.0, 30.0], periodic: [true, true, false] });
    for k in 0..5 {
        builder = builder.sphere([2.0 * f64::from(k), 0.0, 0.0], 1.0, 1.0);
    }
    let motion = [Motion::Velocity(0.0), Motion::Load(1.0), Motion::Return { speed: 2.0, turn: 1.0 }];
    let mut system = builder
        .body(&[0, 1])
        .wall(&[0, 1], motion)
        .neck(1, 2)
        .neck(1, 3)
        .surface(surface(Shape::Plane { point: ZERO, normal: Vec3([0.0, 0.0, 1.0]) }, rate))
        .surface(surface(Shape::Mesh(mesh), PrescribedMotion::Still))
        .build()
        .expect("a system");
    let (stiffness, velocity) = (Vec3([0.0, 1.0, 0.0]), Vec3([0.0, 1.0, 0.0]));
    let steering = Steering {
        spheres: vec![2, 4],
        stiffness,
        velocity,
        ramp: 0.0,
        origin: ZERO,
        travel: ZERO,
        force: ZERO,
        age: 0.0,
    };
    system.steerings.push(steering);
    system.springs = Springs::new(3);
    system.springs.add((0, 2, [0; 3]), [1.0, 0.0, 0.0].into_iter());
    system.springs.add((3, 4, [0; 3]), [0.0, 1.0, 0.0].into_iter());
    system
}

type Change = fn(&mut System);

fn mesh(system: &mut System) -> &mut Mesh {
    match &mut system.surfaces[1].shape {
        Shape::Mesh(mesh) => mesh,
        Shape::Plane { .. } => panic!("no mesh"),
    }
}

fn plane(system: &mut System) -> (&mut Vec3<f64>, &mut Vec3<f64>) {
    match &mut system.surfaces[0].shape {
        Shape::Plane { point, normal } => (point, normal),
        Shape::Mesh(_) => panic!("no plane"),
    }
}

/// Each change alone makes the state unsound.
fn refused(changes: &[(&str, Change)]) {
    for (name, change) in changes {
        let mut system = sound();
        change(&mut system);
        assert!(!system.is_sound(), "{name}");
    }
}

/// No change alone makes the state unsound.
fn accepted(changes: &[(&str, Change)]) {
    for (name, change) in changes {
        let mut system = sound();
        change(&mut system);
        assert!(system.is_sound(), "{name}");
    }
}

#[test]
fn what_lies_on_a_bound_is_sound() {
    accepted(&[
        ("nothing is changed", |_| {}),
        ("the largest number", |s| s.time = LARGEST),
        ("the smallest number", |s| s.lag = -LARGEST),
        ("the largest radius along an axis without periods", |s| {
            s.domain.periodic = [false; 3];
            s.particles.radius[2] = LARGEST;
        }),
        ("a radius of a side", |s| s.particles.radius[2] = 8.0),
        ("the farthest copy of the box", |s| s.particles.x[2] = Vec3([-20.0 * FAR, 8.0 * FAR, 0.0])),
        ("as far as may be along an axis without periods", |s| s.particles.x[2] = Vec3([0.0, 0.0, LARGEST])),
        ("the last tag", |s| s.particles.tag[0] = 5),
        ("a corner without a triangle", |s| {
            mesh(s).vertices.push(ZERO);
            mesh(s).corners.push(ZERO);
        }),
        ("two contacts of a sphere", |s| s.surfaces[0].contacts.places[1].0 = 1),
        ("no contacts", |s| s.surfaces[0].contacts = ContactTable::default()),
        ("contacts without springs", |s| s.surfaces[0].contacts.springs.clear()),
        ("no springs", |s| s.springs = Springs::default()),
        ("a wall that does not move", |s| s.walls[0].motion = [Motion::Velocity(0.0); 3]),
        ("a weightless wall", |s| s.walls[0].mass = 0.0),
    ]);
}

#[test]
fn numbers_of_the_system_are_bounded_and_its_necks_in_order() {
    refused(&[
        ("time", |s| s.time = f64::NAN),
        ("lag", |s| s.lag = f64::INFINITY),
        ("too long", |s| s.time = 1.1 * LARGEST),
        ("too early", |s| s.time = -1.1 * LARGEST),
        ("neck of a sphere and itself", |s| s.necks = vec![(1, 1)]),
        ("neck with the higher sphere first", |s| s.necks = vec![(2, 1)]),
        ("neck of a sphere too many", |s| s.necks = vec![(1, 5)]),
        ("necks out of order", |s| s.necks = vec![(1, 3), (1, 2)]),
        ("a neck twice", |s| s.necks = vec![(1, 2), (1, 2)]),
    ]);
}

#[test]
fn spheres_have_lists_of_one_length_numbers_and_names() {
    refused(&[
        ("no spheres", |s| *s = System::new(Particles::default(), s.domain)),
        ("velocities", |s| s.particles.v.truncate(4)),
        ("spins", |s| s.particles.w.truncate(4)),
        ("radii", |s| s.particles.radius.truncate(4)),
        ("masses", |s| s.particles.mass.truncate(4)),
        ("walls", |s| s.particles.wall.truncate(4)),
        ("bodies", |s| s.particles.body.truncate(4)),
        ("arms", |s| s.particles.arm.truncate(4)),
        ("ids", |s| s.particles.id.push(4)),
        ("tags", |s| s.particles.tag.truncate(4)),
        ("centre", |s| s.particles.x[3] = Vec3([0.0, 0.0, f64::NAN])),
        ("velocity", |s| s.particles.v[3] = NAN),
        ("spin", |s| s.particles.w[3] = TOO_LARGE),
        ("arm", |s| s.particles.arm[3] = NAN),
        ("radius", |s| s.particles.radius[3] = 0.0),
        ("negative radius", |s| s.particles.radius[3] = -1.0),
        ("mass", |s| s.particles.mass[4] = 0.0),
        ("large mass", |s| s.particles.mass[4] = 1.1 * LARGEST),
        ("mass that is no number", |s| s.particles.mass[4] = f64::NAN),
        ("wall", |s| s.particles.wall[3] = 2),
        ("body", |s| s.particles.body[3] = 2),
        ("tag", |s| s.particles.tag[3] = 6),
        ("an id twice", |s| s.particles.id[3] = 2),
        ("an id too high", |s| s.particles.id[4] = 5),
    ]);
}

#[test]
fn spheres_are_no_larger_than_a_period_and_not_beyond_the_copies_that_are_counted() {
    refused(&[
        ("no side", |s| s.domain.sides[2] = 0.0),
        ("side that is no number", |s| s.domain.sides[2] = f64::NAN),
        ("wide", |s| s.particles.radius[2] = 8.1),
        ("far left", |s| s.particles.x[2] = Vec3([-20.1 * FAR, 0.0, 0.0])),
        ("far back", |s| s.particles.x[2] = Vec3([0.0, 8.1 * FAR, 0.0])),
    ]);
}

#[test]
fn bodies_and_walls_have_numbers() {
    refused(&[
        ("place", |s| s.bodies[0].pose.x = NAN),
        ("turn", |s| s.bodies[0].pose.q_0 = f64::NAN),
        ("axis of the turn", |s| s.bodies[0].pose.q = NAN),
        ("velocity", |s| s.bodies[0].v = NAN),
        ("angular momentum", |s| s.bodies[0].l = TOO_LARGE),
        ("lever", |s| s.bodies[0].lever = NAN),
        ("spread", |s| s.bodies[0].spread[2] = NAN),
        ("moments", |s| s.bodies[0].moments = Vec3([1.0, 1.0, 0.0])),
        ("mass of a body", |s| s.bodies[0].mass = 0.0),
        ("count", |s| s.bodies[0].count = -1.0),
        ("extent", |s| s.bodies[0].extent = f64::NAN),
        ("wall of a body", |s| s.bodies[0].wall = 2),
        ("prescribed velocity", |s| s.walls[0].motion[2] = Motion::Velocity(f64::NAN)),
        ("load", |s| s.walls[0].motion[0] = Motion::Load(f64::INFINITY)),
        ("speed of return", |s| s.walls[0].motion[1] = Motion::Return { speed: f64::NAN, turn: 1.0 }),
        ("turn of return", |s| s.walls[0].motion[1] = Motion::Return { speed: 1.0, turn: 0.0 }),
        ("velocity of a wall", |s| s.walls[0].velocity = NAN),
        ("spin of a wall", |s| s.walls[0].spin = NAN),
        ("force", |s| s.walls[0].force = NAN),
        ("torque", |s| s.walls[0].torque = NAN),
        ("travel", |s| s.walls[0].travel = NAN),
        ("mass of a wall", |s| s.walls[0].mass = f64::NAN),
        ("age", |s| s.walls[0].age = f64::NAN),
    ]);
}

#[test]
fn surfaces_have_numbers_and_triangles_of_corners_that_are_there() {
    refused(&[
        ("point", |s| *plane(s).0 = NAN),
        ("normal", |s| *plane(s).1 = NAN),
        ("velocity of reversal", |s| {
            s.surfaces[0].motion = PrescribedMotion::Reversal { velocity: f64::NAN, rate: 0.0, turn: 0.0 };
        }),
        ("rate of reversal", |s| {
            s.surfaces[0].motion = PrescribedMotion::Reversal { velocity: 0.0, rate: f64::NAN, turn: 0.0 };
        }),
        ("turn of reversal", |s| {
            s.surfaces[0].motion = PrescribedMotion::Reversal { velocity: 0.0, rate: 0.0, turn: f64::NAN };
        }),
        ("velocity", |s| s.surfaces[0].velocity = NAN),
        ("way", |s| s.surfaces[0].way = NAN),
        ("contact", |s| s.surfaces[0].force.contact = NAN),
        ("friction", |s| s.surfaces[0].force.friction = NAN),
        ("attraction", |s| s.surfaces[0].force.van_der_waals = NAN),
        ("age", |s| s.surfaces[0].age = f64::NAN),
        ("no triangles", |s| {
            mesh(s).triangles.clear();
            mesh(s).across.clear();
            mesh(s).faces.clear();
        }),
        ("neighbours", |s| mesh(s).across.truncate(2)),
        ("faces", |s| mesh(s).faces.truncate(2)),
        ("corners", |s| mesh(s).corners.truncate(3)),
        ("corner too many", |s| mesh(s).triangles[1][2] = 4),
        ("triangle too many", |s| mesh(s).across[1][2] = 3),
        ("vertex", |s| mesh(s).vertices[3] = NAN),
        ("face", |s| mesh(s).faces[2] = NAN),
        ("normal of a corner", |s| mesh(s).corners[3] = NAN),
        ("bounds", |s| mesh(s).bounds[1] = NAN),
    ]);
}

#[test]
fn contacts_springs_and_steered_spheres_are_those_of_spheres() {
    refused(&[
        ("springs without contacts", |s| s.surfaces[1].contacts.places.clear()),
        ("half a spring", |s| s.surfaces[1].contacts.springs.truncate(5)),
        ("contacts out of order", |s| s.surfaces[1].contacts.places.reverse()),
        ("contact of a sphere too many", |s| s.surfaces[1].contacts.places[1].0 = 5),
        ("place of a contact", |s| s.surfaces[1].contacts.places[1].1 = NAN),
        ("spring of a contact", |s| s.surfaces[1].contacts.springs[5] = f64::NAN),
        ("steering nothing", |s| s.steerings[0].spheres.clear()),
        ("steering a sphere twice", |s| s.steerings[0].spheres = vec![2, 2]),
        ("steering a sphere too many", |s| s.steerings[0].spheres = vec![5]),
        ("negative stiffness", |s| s.steerings[0].stiffness = Vec3([0.0, -1.0, 0.0])),
        ("negative ramp", |s| s.steerings[0].ramp = -1.0),
        ("ramp", |s| s.steerings[0].ramp = f64::INFINITY),
        ("stiffness", |s| s.steerings[0].stiffness = Vec3([0.0, f64::INFINITY, 0.0])),
        ("steering velocity", |s| s.steerings[0].velocity = NAN),
        ("origin", |s| s.steerings[0].origin = NAN),
        ("travel", |s| s.steerings[0].travel = NAN),
        ("force", |s| s.steerings[0].force = NAN),
        ("age", |s| s.steerings[0].age = f64::NAN),
        ("first sphere of a pair", |s| s.springs.bonds[1].0 = (5, 4, [0; 3])),
        ("second sphere of a pair", |s| s.springs.bonds[1].0 = (3, 5, [0; 3])),
        ("springs that are not there", |s| s.springs.bonds[1].1 = 4),
        ("springs at the end of numbers", |s| s.springs.bonds[1].1 = u32::MAX),
        ("pairs out of order", |s| s.springs.bonds.reverse()),
        ("a pair twice", |s| s.springs.bonds[1].0 = s.springs.bonds[0].0),
        ("spring", |s| s.springs.numbers[0] = f64::NAN),
    ]);
}
