//! Close-packed lattices have the stiffness of linear algebra.

use super::NO_LAW;
use crate::golden::{Complaints, Run};
use crate::spec::mechanics::virial::pair_stress;
use crate::spec::wear::def_contact::Parameters;
use crate::spec::wear::eq07_normal_stiffness::normal_stiffness;
use crate::spec::wear::eq08_tangential_stiffness::tangential_stiffness;
use crate::spec::wear::eq15_normal_cross_section::normal_cross_section;
use crate::spec::wear::eq16_tangential_cross_section::tangential_cross_section;
use crate::spec::{Contact, Vec3};

/// Directions to the twelve neighbours of a particle, and whether the neighbour is the other one of its cell.
type Around = Vec<(Vec3<f64>, bool)>;

/// The neighbours of the two particles of a cell.
fn neighbours(lattice: &str) -> Result<[Around; 2], String> {
    let polar = |degrees: f64, radius: f64, z: f64| {
        let angle = degrees.to_radians();
        Vec3::new(radius * angle.cos(), radius * angle.sin(), z)
    };
    match lattice {
        "hcp" => {
            let of = |first: f64| {
                let layer = (0..6).map(|k| (polar(60.0 * f64::from(k), 1.0, 0.0), false));
                let beyond = [1.0, -1.0].into_iter().flat_map(|side| (0..3).map(move |k| (120.0 * f64::from(k), side)));
                let hollow = beyond
                    .map(|(turn, side)| (polar(first + turn, (1f64 / 3.0).sqrt(), side * (2f64 / 3.0).sqrt()), true));
                layer.chain(hollow).collect()
            };
            Ok([of(90.0), of(270.0)])
        }
        "fcc" => {
            let corners =
                [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|pair| pair.map(|x: f64| x / 2f64.sqrt()));
            let faces = corners
                .iter()
                .flat_map(|[a, b]| [Vec3::new(*a, *b, 0.0), Vec3::new(*a, 0.0, *b), Vec3::new(0.0, *a, *b)]);
            let all: Vec<_> = faces.map(|n| (n, false)).collect();
            Ok([all.clone(), all])
        }
        other => Err(format!("`lattice`: found `{other}`, expected hcp or fcc")),
    }
}

pub(super) fn check(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let (lattice, relaxed) = (neighbours(run.word("lattice")?)?, run.flag("relaxed")?);
    for (number, [nu, expected @ ..]) in run.samples::<5>()?.into_iter().enumerate() {
        let (e, r) = (1.0, 1.0);
        let law = Parameters {
            k_n: normal_stiffness(normal_cross_section(r, nu), e, r, r),
            k_t: tangential_stiffness(tangential_cross_section(r, nu), e, r, r),
            delta_e: 1.0,
            delta_f: 1.0,
            f_mt: 1e3,
            ..NO_LAW
        };
        // stress of a small strain, the second particle of each cell moved by `shift` along y; and the force on the first along y
        let respond = |strain: [f64; 3], shift: f64| {
            let (mut stress, mut pull) = ([0.0; 3], 0.0);
            for (particle, around) in lattice.iter().enumerate() {
                for (to, other) in around {
                    let moved = Vec3(std::array::from_fn(|k| 2.0 * strain[k] * to.0[k]));
                    let side = if particle == 0 { shift } else { -shift };
                    let moved = moved + Vec3::new(0.0, if *other { side } else { 0.0 }, 0.0);
                    // the force on i of a neighbour j towards `to`; the response is linear, so directions stay those at rest
                    let (n, none) = (-*to, Vec3::zero());
                    let at = Contact { gap: moved.dot(*to), ..Contact::new(n * 2.0, none, none, none, r, r) };
                    let force = law.act(&at, (-moved).perpendicular_to(n), 0.0).wrench.force;
                    // every pair is seen from both its particles; the cell of two has twice the volume 4 sqrt(2) r^3
                    let share = pair_stress(2.0 * (8.0 * 2f64.sqrt()), *to * 2.0, force);
                    (0..3).for_each(|k| stress[k] += share[k].0[k]);
                    pull += if particle == 0 { force.0[1] } else { 0.0 };
                }
            }
            (stress, pull)
        };
        let relax = |strain: [f64; 3]| {
            let stiffness = respond([0.0; 3], 1.0).1;
            let shift = if relaxed { -respond(strain, 0.0).1 / stiffness } else { 0.0 };
            respond(strain, shift).0
        };
        let (along_y, along_z) = (relax([0.0, 1e-3, 0.0]), relax([0.0, 0.0, 1e-3]));
        let names = ["C_yyyy", "C_yyxx", "C_yyzz", "C_zzzz"];
        let stiffness = [along_y[1], along_y[0], along_y[2], along_z[2]].map(|stress| stress / 1e-3);
        for ((name, value), expected) in names.into_iter().zip(stiffness).zip(expected) {
            complaints.near(format_args!("sample {number}: {name}"), value, expected, 1e-12);
        }
    }
    Ok(())
}
