//! Frames as VTK poly data in XML, which ParaView opens, and the collections that give their times.

use super::poly_data::{Array, Cells, Numbers, PolyData};
use super::{Frame, FrameName};
use std::collections::BTreeMap;
use std::fmt::Write;

impl Frame<'_> {
    /// A file with one piece.
    pub(super) fn vtp(&self, poly_data: &PolyData) -> String {
        let PolyData { points, cells, connectivity, data } = poly_data;
        let (section, count) = (section(*cells), poly_data.count());
        let counts = [Cells::Vertices, Cells::Lines, Cells::Triangles].map(|kind| {
            let count = if kind == *cells { count } else { 0 };
            format!("NumberOf{}=\"{count}\"", self::section(kind))
        });
        let kind = if *cells == Cells::Vertices { "PointData" } else { "CellData" };
        let data: String =
            data.iter().map(|Array { name, width, numbers }| self.array(name, *width, numbers)).collect();
        let place = Numbers::Real(points.iter().flat_map(|point| point.0).collect());
        let offsets = (1..=count).map(|cell| (cell * cells.corners()) as i64).collect();
        let mut text = String::from(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n",
        );
        let _ = write!(
            text,
            "<FieldData>\n{}</FieldData>\n<Piece NumberOfPoints=\"{}\" {}>\n<{kind}>\n{data}</{kind}>\n\
             <Points>\n{}</Points>\n<{section}>\n{}{}</{section}>\n</Piece>\n</PolyData>\n</VTKFile>\n",
            format_args!(
                "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n",
                self.time()
            ),
            points.len(),
            counts.join(" "),
            self.array("position", 3, &place),
            self.array("connectivity", 1, &Numbers::Whole(connectivity.clone())),
            self.array("offsets", 1, &Numbers::Whole(offsets)),
        );
        text
    }

    /// An array of numbers.
    fn array(&self, name: &str, width: usize, numbers: &Numbers) -> String {
        let (kind, numbers): (_, Vec<String>) = match numbers {
            Numbers::Whole(numbers) => ("Int64", numbers.iter().map(i64::to_string).collect()),
            Numbers::Real(numbers) => ("Float64", numbers.iter().map(|&number| self.text(number)).collect()),
        };
        format!(
            "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{width}\" format=\"ascii\">{}</DataArray>\n",
            numbers.join(" ")
        )
    }
}

/// The section of a piece that holds the cells of a kind.
fn section(cells: Cells) -> &'static str {
    match cells {
        Cells::Vertices => "Verts",
        Cells::Lines => "Lines",
        Cells::Triangles => "Polys",
    }
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
