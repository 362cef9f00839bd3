//! Arrays taken apart into columns, a stretch at a time, for the loops of the specification.

use crate::arrays::{Numbers, common_shape};
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use veridem_spec::columns::Results;

/// How many evaluations are in the columns at a time: all of them stay in the second cache.
const STRETCH: usize = 1024;

/// An argument: its name, how many numbers it is, and its values.
pub(crate) struct Argument<'a, 'py> {
    pub name: &'a str,
    pub size: usize,
    pub numbers: Numbers<'py>,
}

/// Results, each in an array of its own, one after the other.
pub(crate) struct Computed {
    /// The shape of the broadcast arguments.
    pub shape: Vec<usize>,
    /// The numbers of each result, and the axes of its components.
    results: Vec<(Vec<f64>, Vec<usize>)>,
}

/// Evaluates something over columns: it receives those of the arguments and fills those of the results, whose components have these axes.
pub(crate) fn over_columns<'py>(
    py: Python<'py>,
    arguments: Vec<Argument<'_, 'py>>,
    results: &[&[usize]],
    evaluate: impl Fn(&[&[f64]], Results<'_, '_>) + Send,
) -> PyResult<Computed> {
    let shapes: Vec<_> = arguments.iter().map(|a| (a.name, a.numbers.shape(a.size))).collect();
    let shape = common_shape(&shapes)?;
    let count: usize = shape.iter().product();
    let spread = |a: Argument<'_, 'py>| Ok((a.size, a.numbers.broadcast(py, &shape, a.size)?));
    let arguments = arguments.into_iter().map(spread).collect::<PyResult<Vec<_>>>()?;
    let sources: Vec<(usize, &[f64])> =
        arguments.iter().map(|(size, numbers)| Ok((*size, numbers.slice()?))).collect::<PyResult<_>>()?;
    let room = |axes: &&[usize]| vec![0.0; axes.iter().product::<usize>() * count];
    let mut numbers: Vec<Vec<f64>> = results.iter().map(room).collect();
    py.detach(|| {
        let sizes = results.iter().map(|axes| axes.iter().product());
        let mut computed: Vec<(usize, &mut [f64])> = sizes.zip(numbers.iter_mut().map(Vec::as_mut_slice)).collect();
        stretches(count, &sources, &mut computed, evaluate);
    });
    Ok(Computed { results: numbers.into_iter().zip(results.iter().map(|axes| axes.to_vec())).collect(), shape })
}

fn stretches(
    count: usize,
    sources: &[(usize, &[f64])],
    computed: &mut [(usize, &mut [f64])],
    evaluate: impl Fn(&[&[f64]], Results<'_, '_>),
) {
    let width = STRETCH.min(count);
    // Numbers one after the other are columns already; components of vectors, and what is the same everywhere, are copied.
    let is_column = |&(size, numbers): &(usize, &[f64])| size == 1 && numbers.len() > 1;
    let copied = sources.iter().filter(|source| !is_column(source)).map(|source| source.0).sum();
    let apart = computed.iter().filter(|result| result.0 > 1).map(|result| result.0).sum();
    let (mut input, mut output) = (vec![vec![0.0; width]; copied], vec![vec![0.0; width]; apart]);
    for begin in (0..count).step_by(STRETCH) {
        let length = width.min(count - begin);
        let mut columns = input.iter_mut();
        for &(size, numbers) in sources.iter().filter(|source| !is_column(source)) {
            let columns = columns.by_ref().take(size).enumerate();
            if numbers.len() > size {
                let vectors = &numbers[begin * size..][..length * size];
                columns.for_each(|(component, column)| gather(vectors, size, component, column));
            } else if begin == 0 {
                columns.for_each(|(component, column)| column.fill(numbers[component]));
            }
        }
        let (mut columns, mut arguments) = (input.iter(), Vec::new());
        for source in sources {
            if is_column(source) {
                arguments.push(&source.1[begin..][..length]);
            } else {
                arguments.extend(columns.by_ref().take(source.0).map(|column| &column[..length]));
            }
        }
        let (mut columns, mut results) = (output.iter_mut(), Vec::new());
        for (size, numbers) in &mut *computed {
            if *size == 1 {
                results.push(&mut numbers[begin..][..length]);
            } else {
                results.extend(columns.by_ref().take(*size).map(|column| &mut column[..length]));
            }
        }
        evaluate(&arguments, &mut results);
        let mut columns = output.iter();
        for (size, numbers) in computed.iter_mut().filter(|result| result.0 > 1) {
            let vectors = &mut numbers[begin * *size..][..length * *size];
            columns.by_ref().take(*size).enumerate().for_each(|(at, column)| scatter(column, vectors, *size, at));
        }
    }
}

/// Takes a component of every vector.
fn gather(vectors: &[f64], size: usize, component: usize, column: &mut [f64]) {
    column.iter_mut().zip(vectors.chunks_exact(size)).for_each(|(to, vector)| *to = vector[component]);
}

/// Sets a component of every vector.
fn scatter(column: &[f64], vectors: &mut [f64], size: usize, component: usize) {
    vectors.chunks_exact_mut(size).zip(column).for_each(|(vector, number)| vector[component] = *number);
}

impl Computed {
    /// The first evaluation with a result that is not finite, and its results.
    pub(crate) fn first_not_finite(&self) -> Option<(usize, Vec<f64>)> {
        let sized = || self.results.iter().map(|(numbers, axes)| (numbers, axes.iter().product::<usize>()));
        // Without a way out of the loop several numbers are looked at together.
        let finite = |numbers: &[f64]| numbers.iter().fold(true, |all, x| all & x.is_finite());
        let first = |(numbers, size): (&Vec<f64>, usize)| {
            (!finite(numbers)).then(|| numbers.iter().position(|x| !x.is_finite()).map(|at| at / size))?
        };
        let at = sized().filter_map(first).min()?;
        let found = sized().flat_map(|(numbers, size)| &numbers[at * size..][..size]);
        Some((at, found.copied().collect()))
    }

    /// The results as Python has them: floats, or arrays with the axes of their components last.
    pub(crate) fn into_python(self, py: Python<'_>) -> PyResult<Vec<Bound<'_, PyAny>>> {
        let Self { shape, results } = self;
        let object = |(numbers, axes): (Vec<f64>, Vec<usize>)| {
            if shape.is_empty() && axes.is_empty() {
                return Ok(numbers[0].into_pyobject(py)?.into_any());
            }
            Ok(numbers.into_pyarray(py).reshape([&shape[..], &axes].concat())?.into_any())
        };
        results.into_iter().map(object).collect()
    }
}
