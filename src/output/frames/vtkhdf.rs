//! Frames as VTKHDF, the HDF5 format of VTK, which ParaView opens. Where the file format of ON-DEM, the European network on the discrete element
//! method, has a quantity, it has its name and sign: <https://github.com/ON-DEM/ON-DEM-WG3-FileFormat>, `bodies.py` and `interaction.py`, October 2026.

use super::poly_data::{Array, Cells, Numbers, PolyData};
use super::{Digits, Frame, ID, IDS, NORMAL_FORCE, VELOCITY};
use hdf5_pure::{AttrValue, FileBuilder, GroupBuilder};

/// Version of the format: the first with poly data.
const VERSION: [i64; 2] = [2, 0];
/// The groups of cells that every file has.
const SECTIONS: [(&str, Option<Cells>); 4] = [
    ("Vertices", Some(Cells::Vertices)),
    ("Lines", Some(Cells::Lines)),
    ("Polygons", Some(Cells::Triangles)),
    ("Strips", None),
];

impl Frame<'_> {
    /// A file of one part, with the time as data of its own.
    pub(super) fn vtkhdf(&self, poly_data: &PolyData) -> Vec<u8> {
        let PolyData { points, cells, connectivity, data } = poly_data;
        let mut file = FileBuilder::new();
        let mut root = file.create_group("VTKHDF");
        root.set_attr("Version", AttrValue::I64Array(VERSION.to_vec()));
        root.set_attr("Type", AttrValue::AsciiString("PolyData".into()));
        whole(&mut root, "NumberOfPoints", &[points.len() as i64], 1);
        let place: Vec<f64> = points.iter().flat_map(|point| point.0).collect();
        self.real(&mut root, "Points", &place, 3);
        for (name, kind) in SECTIONS {
            let (corners, count) =
                if kind == Some(*cells) { (&**connectivity, poly_data.count()) } else { (&[][..], 0) };
            let offsets: Vec<i64> = (0..=count).map(|cell| (cell * cells.corners()) as i64).collect();
            let mut section = root.create_group(name);
            whole(&mut section, "NumberOfCells", &[count as i64], 1);
            whole(&mut section, "NumberOfConnectivityIds", &[corners.len() as i64], 1);
            whole(&mut section, "Offsets", &offsets, 1);
            whole(&mut section, "Connectivity", corners, 1);
            root.add_group(section.finish());
        }
        let mut quantities = root.create_group(if *cells == Cells::Vertices { "PointData" } else { "CellData" });
        for Array { name, width, numbers } in data {
            match numbers {
                Numbers::Whole(ids) if name == IDS.name => {
                    let (first, second): (Vec<_>, Vec<_>) = ids.chunks_exact(2).map(|pair| (pair[0], pair[1])).unzip();
                    whole(&mut quantities, "id1", &first, 1);
                    whole(&mut quantities, "id2", &second, 1);
                }
                Numbers::Whole(numbers) => whole(&mut quantities, named(name), numbers, *width),
                // Positive in traction there.
                Numbers::Real(numbers) if name == NORMAL_FORCE.name => {
                    self.real(&mut quantities, name, &numbers.iter().map(|force| -force).collect::<Vec<_>>(), *width);
                }
                Numbers::Real(numbers) => self.real(&mut quantities, named(name), numbers, *width),
            }
        }
        root.add_group(quantities.finish());
        let mut fields = root.create_group("FieldData");
        fields.create_dataset("TimeValue").with_f64_data(&[self.time()]);
        root.add_group(fields.finish());
        file.add_group(root.finish());
        file.finish().expect("the names are names of links, and shapes fit their numbers")
    }

    /// A data set with `width` numbers in a row, in single precision if frames have seven digits.
    fn real(&self, group: &mut GroupBuilder, name: &str, numbers: &[f64], width: usize) {
        let set = group.create_dataset(name);
        match self.digits {
            Digits::Seven => set.with_f32_data(&numbers.iter().map(|&number| number as f32).collect::<Vec<_>>()),
            Digits::All => set.with_f64_data(numbers),
        }
        .with_shape(&shape(numbers.len(), width));
    }
}

/// A data set with `width` whole numbers in a row.
fn whole(group: &mut GroupBuilder, name: &str, numbers: &[i64], width: usize) {
    group.create_dataset(name).with_i64_data(numbers).with_shape(&shape(numbers.len(), width));
}

/// The shape of rows of numbers; rows of one number have no length of their own.
fn shape(count: usize, width: usize) -> Vec<u64> {
    if width == 1 { vec![count as u64] } else { vec![(count / width) as u64, width as u64] }
}

/// The name that ON-DEM gives to a quantity, or its own.
fn named(name: &str) -> &str {
    match name {
        _ if name == ID.name => "body_id",
        _ if name == VELOCITY.name => "velocity",
        _ => name,
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Frame, FrameColumn, POSITION, RADIUS, Values};
    use super::*;
    use crate::observe::{ActingPair, PairKind};
    use crate::spec::Vec3;
    use crate::system::{Domain, Particles, System};
    use hdf5_pure::File;

    #[test]
    fn spheres_and_pairs_are_read_back_with_the_names_and_signs_of_on_dem() {
        let mut system = System::new(Particles::default(), Domain { sides: [9.0; 3], periodic: [false; 3] });
        system.time = 2.5;
        let column = |name, values| FrameColumn { name, values };
        let centres = vec![Vec3([1.0, 2.0, 3.0]), Vec3([3.0, 2.0, 3.0])];
        let pair = ActingPair {
            ids: [4, 7],
            kind: PairKind::Neck,
            centre: centres[0],
            branch: centres[0] - centres[1],
            gap: -0.5,
            force: Vec3([-3.0, 0.0, 0.0]),
            normal_force: 3.0,
            energy: 1.0,
            springs: Vec::new(),
        };
        let frame = Frame {
            stage: "shear",
            system: &system,
            digits: Digits::All,
            columns: vec![
                column(ID.name, Values::Counts(vec![4, 7])),
                column(RADIUS.name, Values::Numbers(vec![1.25, 1.25])),
                column(POSITION.name, Values::Vectors(centres)),
                column(VELOCITY.name, Values::Vectors(vec![Vec3([0.1, 0.2, 0.3]); 2])),
            ],
            pairs: vec![pair],
            strengths: None,
            springs: Vec::new(),
        };
        let written = || frame.poly_data().map(|(_, data)| frame.vtkhdf(&data)).collect::<Vec<_>>();
        assert_eq!(written(), written(), "nothing but the frame is in its files");
        let [pairs, spheres] =
            written().try_into().map(|files: [_; 2]| files.map(|file| File::from_bytes(file).unwrap())).unwrap();
        let set = |file: &File, path: &str| file.dataset(path).unwrap();
        assert_eq!(set(&spheres, "VTKHDF/Points").shape().unwrap(), [2, 3]);
        assert_eq!(set(&spheres, "VTKHDF/Points").read_f64().unwrap(), [1.0, 2.0, 3.0, 3.0, 2.0, 3.0]);
        assert_eq!(set(&spheres, "VTKHDF/PointData/body_id").read::<i64>().unwrap(), [4, 7]);
        assert_eq!(set(&spheres, "VTKHDF/PointData/velocity").shape().unwrap(), [2, 3]);
        assert_eq!(set(&spheres, "VTKHDF/Vertices/Offsets").read::<i64>().unwrap(), [0, 1, 2]);
        assert_eq!(set(&spheres, "VTKHDF/FieldData/TimeValue").read_f64().unwrap(), [2.5]);
        assert_eq!(set(&pairs, "VTKHDF/Lines/Connectivity").read::<i64>().unwrap(), [0, 1]);
        assert_eq!(set(&pairs, "VTKHDF/CellData/id2").read::<i64>().unwrap(), [7]);
        assert_eq!(set(&pairs, "VTKHDF/CellData/normal_force").read_f64().unwrap(), [-3.0]);
        assert_eq!(set(&pairs, "VTKHDF/CellData/gap").read_f64().unwrap(), [-0.5]);
    }
}
