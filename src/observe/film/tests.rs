use super::*;

/// More than rounding, nm.
const TOUCH: f64 = 1e-6;

/// A cubic lattice of touching spheres with a diameter of 20 nm, three of them in each direction sideways.
fn lattice(layers: usize) -> DepositedFilm {
    let sphere = |k: usize| FilmSphere {
        centre: Vec3([k % 3, k / 3 % 3, k / 9].map(|i| 10.0 + 20.0 * i as f64)),
        diameter: 20.0,
        aggregate: (k / 9) as u32,
    };
    DepositedFilm {
        spheres: (0..9 * layers).map(sphere).collect(),
        on_floor: (0..layers).map(|layer| layer == 0).collect(),
        sides: [60.0; 2],
        thickness: 20.0 * layers as f64,
    }
}

#[test]
fn a_cubic_lattice_has_its_porosity_contacts_and_pores() {
    let structure = Structure::of(&lattice(20), TOUCH, 1);
    let porosity = 1.0 - std::f64::consts::PI / 6.0;
    assert_eq!(structure.thickness, 400.0);
    // Layers of the profile are layers of the lattice; the bulk begins and ends in the middle of one.
    assert!(structure.profile.iter().all(|solid| (1.0 - solid - porosity).abs() < 1e-12));
    assert!((structure.porosity - porosity).abs() < 1e-12, "{structure:?}");
    // Four neighbours in the layer, nine contacts with each of the two layers beside; the outermost layers have but one.
    assert_eq!(structure.contacts_within, 4.0);
    assert!((structure.contacts_between - 9.0 * 2.0 * 19.0 / 20.0).abs() < 1e-12);
    // The middle of a cube is sqrt(3) radii from the centres at its corners.
    let largest = 20.0 * (3f64.sqrt() - 1.0);
    assert!(structure.pores[2] <= largest && structure.pores[2] > 0.9 * largest, "{:?} {largest}", structure.pores);
}

#[test]
fn a_wide_gap_is_a_pore_of_its_width() {
    // Two slabs of the lattice with a gap of 60 nm between their surfaces, where most of the empty volume is.
    let mut film = lattice(4);
    for s in &mut film.spheres[18..] {
        s.centre.0[2] += 60.0;
    }
    film.thickness += 60.0;
    let [_, median, large] = Structure::of(&film, TOUCH, 1).pores;
    // Balls that reach between the spheres of both sides are a little wider than the gap.
    assert!(median > 60.0 && median <= large && large < 60.0 + 2.0 * 20.0 * (1.0 - 0.5f64.sqrt()), "{median} {large}");
}
