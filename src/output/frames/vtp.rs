//! Frames as VTK poly data, which ParaView opens: spheres as points, pairs as lines, surfaces as triangles, and the collections that give their times.

use super::surfaces::outlines;
use super::{Frame, FrameColumn, FrameName, Values};
use crate::spec::Vec3;
use std::collections::BTreeMap;
use std::fmt::Write;

/// The parts of a piece: their VTK names, and how many points each of their cells has.
const VERTS: (&str, usize) = ("Verts", 1);
const LINES: (&str, usize) = ("Lines", 2);
const POLYS: (&str, usize) = ("Polys", 3);

impl Frame<'_> {
    /// The spheres as vertices, with the columns as data of points.
    pub(super) fn vtp(&self) -> String {
        let position = |column: &&FrameColumn| column.name == super::POSITION.name;
        let at = self.columns.iter().find(position).expect("every frame has positions");
        let Values::Vectors(points) = &at.values else { unreachable!("positions are vectors") };
        let data = self.columns.iter().filter(|column| !position(column)).map(|FrameColumn { name, values }| {
            let numbers = values.numbers().map(|number| self.text(number));
            array(name, values.width(), matches!(values, Values::Counts(_)), numbers)
        });
        self.piece(points, VERTS, (0..points.len()).map(|k| k.to_string()), ("PointData", data.collect()))
    }

    /// The pairs as lines from centre to centre, which leave the box where it is periodic, with their numbers as data of cells.
    pub(super) fn vtp_of_pairs(&self) -> String {
        let ends = |pair: &super::ActingPair| {
            let from = self.system.domain.folded(pair.centre);
            [from, from - pair.branch]
        };
        let points: Vec<Vec3<f64>> = self.pairs.iter().flat_map(ends).collect();
        let ids = self.pairs.iter().flat_map(|pair| pair.ids).map(|id| id.to_string());
        let kinds = self.pairs.iter().map(|pair| (pair.kind as u8).to_string());
        let mut data = array(super::IDS.name, 2, true, ids) + &array(super::KIND.name, 1, true, kinds);
        let numbers: Vec<Vec<f64>> = self.pairs.iter().map(|pair| self.numbers(pair)).collect();
        for (k, name) in self.numbers_of_pairs().into_iter().enumerate() {
            data += &array(name, 1, false, numbers.iter().map(|pair| self.text(pair[k])));
        }
        self.piece(&points, LINES, (0..points.len()).map(|k| k.to_string()), ("CellData", data))
    }

    /// The surfaces as triangles, with the number of the surface as data of cells.
    pub(super) fn vtp_of_surfaces(&self) -> String {
        let (mut points, mut corners, mut numbers) = (Vec::new(), Vec::new(), Vec::new());
        for (number, (_, vertices, faces)) in (1..).zip(outlines(self.system)) {
            let first = points.len() as u32;
            corners.extend(faces.iter().flatten().map(|corner| (corner + first).to_string()));
            numbers.extend(faces.iter().map(|_| i32::to_string(&number)));
            points.extend(vertices);
        }
        self.piece(&points, POLYS, corners.into_iter(), ("CellData", array("surface", 1, true, numbers.into_iter())))
    }

    /// A file with one piece.
    fn piece(
        &self,
        points: &[Vec3<f64>],
        (cells, corners): (&str, usize),
        connectivity: impl Iterator<Item = String>,
        (kind, data): (&str, String),
    ) -> String {
        let connectivity: Vec<String> = connectivity.collect();
        let number = connectivity.len() / corners;
        let counts =
            |(name, _): (&str, usize)| format!("NumberOf{name}=\"{}\"", if name == cells { number } else { 0 });
        let [verts, lines, polys] = [VERTS, LINES, POLYS].map(counts);
        let place = points.iter().flat_map(|point| point.0).map(|number| self.text(number));
        let offsets = (1..=number).map(|cell| (cell * corners).to_string());
        let mut text = String::from(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n",
        );
        let _ = write!(
            text,
            "<FieldData>\n{}</FieldData>\n<Piece NumberOfPoints=\"{}\" {verts} {lines} {polys}>\n<{kind}>\n{data}</{kind}>\n\
             <Points>\n{}</Points>\n<{cells}>\n{}{}</{cells}>\n</Piece>\n</PolyData>\n</VTKFile>\n",
            format_args!(
                "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n",
                self.time()
            ),
            points.len(),
            array("position", 3, false, place),
            array("connectivity", 1, true, connectivity.into_iter()),
            array("offsets", 1, true, offsets),
        );
        text
    }
}

/// An array of numbers.
fn array(name: &str, width: usize, whole: bool, numbers: impl Iterator<Item = String>) -> String {
    let kind = if whole { "Int64" } else { "Float64" };
    let numbers = numbers.collect::<Vec<_>>().join(" ");
    format!(
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{width}\" format=\"ascii\">{numbers}</DataArray>\n"
    )
}

/// The files that list the frames of each stage with their times for ParaView, by name: one for each kind of content that is poly data.
pub fn collections<'a>(files: impl Iterator<Item = (&'a FrameName, &'a str, f64)>) -> BTreeMap<String, String> {
    let mut lists = BTreeMap::<String, String>::new();
    for (name, ending, time) in files.filter(|(_, ending, _)| ending.ends_with("vtp")) {
        let list = lists.entry(name.collection(ending)).or_default();
        let _ = writeln!(list, "<DataSet timestep=\"{time}\" part=\"0\" file=\"{}\"/>", name.file(ending));
    }
    let head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    lists.values_mut().for_each(|list| *list = format!("{head}{list}</Collection>\n</VTKFile>\n"));
    lists
}
