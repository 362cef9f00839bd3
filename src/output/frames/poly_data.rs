//! The content of the files for VTK, whatever their format: spheres as points, pairs as lines, surfaces as triangles.

use super::surfaces::outlines;
use super::{ActingPair, Frame, FrameColumn, Values};
use crate::spec::Vec3;

/// The kind of all cells of poly data.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Cells {
    /// Single points.
    Vertices,
    /// Lines of two points.
    Lines,
    /// Triangles.
    Triangles,
}

impl Cells {
    /// Number of points of a cell.
    pub(super) fn corners(self) -> usize {
        match self {
            Self::Vertices => 1,
            Self::Lines => 2,
            Self::Triangles => 3,
        }
    }
}

/// The numbers of an array.
pub(super) enum Numbers {
    /// Counts, ids and flags.
    Whole(Vec<i64>),
    /// Other numbers.
    Real(Vec<f64>),
}

/// A quantity of every cell; a cell of spheres is its point.
pub(super) struct Array {
    /// Its name.
    pub(super) name: String,
    /// How many numbers it has for a cell.
    pub(super) width: usize,
    /// The numbers, cell by cell.
    pub(super) numbers: Numbers,
}

impl Array {
    fn whole(name: &str, width: usize, numbers: impl Iterator<Item = impl Into<i64>>) -> Self {
        Self { name: name.into(), width, numbers: Numbers::Whole(numbers.map(Into::into).collect()) }
    }
}

/// Points, cells between them and their quantities.
pub(super) struct PolyData {
    /// The points, nm.
    pub(super) points: Vec<Vec3<f64>>,
    /// The kind of the cells.
    pub(super) cells: Cells,
    /// The points of the cells, cell by cell.
    pub(super) connectivity: Vec<i64>,
    /// The quantities: of points if the cells are vertices, of cells otherwise.
    pub(super) data: Vec<Array>,
}

impl PolyData {
    /// Number of cells.
    pub(super) fn count(&self) -> usize {
        self.connectivity.len() / self.cells.corners()
    }
}

impl Frame<'_> {
    /// What it holds, with the beginnings of the endings of its files: surfaces if there are any, pairs, and last spheres.
    pub(super) fn poly_data(&self) -> impl Iterator<Item = (String, PolyData)> {
        let surfaces = (!self.system.surfaces.is_empty()).then(|| ("surfaces.".into(), self.triangles()));
        surfaces.into_iter().chain([("pairs.".into(), self.lines()), (String::new(), self.spheres())])
    }

    /// The spheres as vertices, with their columns.
    fn spheres(&self) -> PolyData {
        let position = |column: &&FrameColumn| column.name == super::POSITION.name;
        let at = self.columns.iter().find(position).expect("every frame has positions");
        let Values::Vectors(points) = &at.values else { unreachable!("positions are vectors") };
        let array = |FrameColumn { name, values }: &FrameColumn| match values {
            Values::Counts(counts) => Array::whole(name, 1, counts.iter().copied()),
            _ => Array {
                name: (*name).into(),
                width: values.width(),
                numbers: Numbers::Real(values.numbers().collect()),
            },
        };
        PolyData {
            points: points.clone(),
            cells: Cells::Vertices,
            connectivity: (0..points.len() as i64).collect(),
            data: self.columns.iter().filter(|column| !position(column)).map(array).collect(),
        }
    }

    /// The pairs as lines from centre to centre, which leave the box where it is periodic, with their numbers.
    fn lines(&self) -> PolyData {
        let ends = |pair: &ActingPair| {
            let from = self.system.domain.folded(pair.centre);
            [from, from - pair.branch]
        };
        let points: Vec<Vec3<f64>> = self.pairs.iter().flat_map(ends).collect();
        let mut data = vec![
            Array::whole(super::IDS.name, 2, self.pairs.iter().flat_map(|pair| pair.ids)),
            Array::whole(super::KIND.name, 1, self.pairs.iter().map(|pair| pair.kind as u8)),
        ];
        let rows: Vec<Vec<f64>> = self.pairs.iter().map(|pair| self.numbers(pair)).collect();
        data.extend(self.numbers_of_pairs().into_iter().enumerate().map(|(k, name)| Array {
            name: name.into(),
            width: 1,
            numbers: Numbers::Real(rows.iter().map(|row| row[k]).collect()),
        }));
        PolyData { connectivity: (0..points.len() as i64).collect(), points, cells: Cells::Lines, data }
    }

    /// The surfaces as triangles, with the number of the surface.
    fn triangles(&self) -> PolyData {
        let (mut points, mut connectivity, mut numbers) = (Vec::new(), Vec::new(), Vec::new());
        for (number, (_, vertices, faces)) in (1_i64..).zip(outlines(self.system)) {
            let first = points.len() as i64;
            connectivity.extend(faces.iter().flatten().map(|&corner| i64::from(corner) + first));
            numbers.extend(faces.iter().map(|_| number));
            points.extend(vertices);
        }
        let data = vec![Array::whole("surface", 1, numbers.into_iter())];
        PolyData { points, cells: Cells::Triangles, connectivity, data }
    }
}
