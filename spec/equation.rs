//! The list of all equations, as data.
//!
//! A room of the specification ends with one line, `equation!("wear-3", ["3"], normal_force)`. It yields the golden
//! vectors, the unit check, the rounding bounds, the index, the benches and `veridem eq`. Names, units and domains are
//! not repeated there: they are read from the table in the function's documentation.

#[cfg(feature = "columns")]
use crate::numbers::Lanes;
use crate::{Real, Tensor, Vec3};

/// An equation of a paper, ready to be looked up, documented and evaluated with any number.
pub struct Equation {
    /// Its name in the list, such as `wear-3`.
    pub id: &'static str,
    /// The equation numbers of the paper that it carries; none for a definition the paper does not number.
    pub covers: &'static [&'static str],
    /// The Rust function.
    pub function: &'static str,
    /// The source file, relative to the specification.
    pub file: &'static str,
    /// The text of that file.
    pub source: &'static str,
    /// How many numbers each argument and each result is.
    pub shape: fn() -> Shape,
    /// The function over each kind of number, arguments and results laid end to end.
    pub eval: Evaluate,
    /// The function over columns of numbers.
    #[cfg(feature = "columns")]
    pub many: crate::columns::Many,
}

/// A paper: its room, the numbers that its equations carry in print, and the equations.
pub struct Paper {
    /// Name of the room; ids begin with it.
    pub name: &'static str,
    /// The printed numbers, such as `3` or `A17`.
    pub numbers: Vec<String>,
    /// The equations, in the order of the paper.
    pub equations: fn() -> Vec<Equation>,
}

/// How many numbers each argument and each result of an equation is: 1 for a scalar, 3 for a vector, 9 for a tensor.
#[derive(Debug, PartialEq, Eq)]
pub struct Shape {
    /// Sizes of the arguments.
    pub arguments: Vec<usize>,
    /// Sizes of the results.
    pub results: Vec<usize>,
}

/// One function, over each kind of number.
#[expect(missing_docs, reason = "each field is the number it is named after")]
pub struct Evaluate {
    pub f64: fn(&[f64]) -> Vec<f64>,
    pub f32: fn(&[f32]) -> Vec<f32>,
    #[cfg(feature = "columns")]
    pub lanes: fn(&[Lanes<8>]) -> Vec<Lanes<8>>,
    #[cfg(feature = "source")]
    pub source: fn(&[crate::numbers::Source]) -> Vec<crate::numbers::Source>,
    #[cfg(feature = "verify")]
    pub dual: fn(&[crate::numbers::Dual]) -> Vec<crate::numbers::Dual>,
    #[cfg(feature = "verify")]
    pub dimension: fn(&[crate::numbers::Dimension]) -> Vec<crate::numbers::Dimension>,
    #[cfg(feature = "verify")]
    pub reference: fn(&[crate::numbers::Reference]) -> Vec<crate::numbers::Reference>,
    #[cfg(feature = "verify")]
    pub interval: fn(&[crate::numbers::Interval]) -> Vec<crate::numbers::Interval>,
    #[cfg(feature = "verify")]
    pub rounded: fn(&[crate::numbers::Rounded]) -> Vec<crate::numbers::Rounded>,
    #[cfg(feature = "verify")]
    pub slope: fn(&[crate::numbers::Slope]) -> Vec<crate::numbers::Slope>,
}

/// An argument or result: numbers laid end to end.
pub trait Laid<R> {
    /// How many numbers it is; tuples of results list several.
    fn sizes() -> Vec<usize>;
    /// Hands over its numbers, one after the other.
    fn put(self, to: &mut impl FnMut(R));
}
/// An argument that can be taken up again from numbers laid end to end.
pub trait Taken<R>: Laid<R> {
    /// Takes its numbers, one after the other.
    fn take(from: &mut impl FnMut() -> R) -> Self;
}

impl<R: Real> Laid<R> for R {
    fn sizes() -> Vec<usize> {
        vec![1]
    }
    #[inline(always)]
    fn put(self, to: &mut impl FnMut(R)) {
        to(self);
    }
}
impl<R: Real> Taken<R> for R {
    #[inline(always)]
    fn take(from: &mut impl FnMut() -> R) -> R {
        from()
    }
}
impl<R: Real> Laid<R> for Vec3<R> {
    fn sizes() -> Vec<usize> {
        vec![3]
    }
    #[inline(always)]
    fn put(self, to: &mut impl FnMut(R)) {
        let [x, y, z] = self.0;
        to(x);
        to(y);
        to(z);
    }
}
impl<R: Real> Taken<R> for Vec3<R> {
    #[inline(always)]
    fn take(from: &mut impl FnMut() -> R) -> Self {
        Self([from(), from(), from()])
    }
}
impl<R: Real> Laid<R> for Tensor<R> {
    fn sizes() -> Vec<usize> {
        vec![9]
    }
    #[inline(always)]
    fn put(self, to: &mut impl FnMut(R)) {
        let [x, y, z] = self;
        x.put(to);
        y.put(to);
        z.put(to);
    }
}

macro_rules! laid_tuple {
    ($($part:ident)+) => {
        impl<R, $($part: Laid<R>),+> Laid<R> for ($($part,)+) {
            fn sizes() -> Vec<usize> {
                [$($part::sizes()),+].concat()
            }
            #[allow(non_snake_case)]
            #[inline(always)]
            fn put(self, to: &mut impl FnMut(R)) {
                let ($($part,)+) = self;
                $($part.put(to);)+
            }
        }
    };
}
laid_tuple!(A B);
laid_tuple!(A B C);
laid_tuple!(A B C D);
laid_tuple!(A B C D E);
laid_tuple!(A B C D E F);
laid_tuple!(A B C D E F G);

/// A function over numbers of type `R`, with arguments `A`.
pub trait Kernel<R, A> {
    /// Sizes of its arguments and results.
    fn shape(&self) -> Shape;
    /// Evaluates it: takes its arguments from one, hands its results to the other, laid end to end.
    fn apply(&self, from: &mut impl FnMut() -> R, to: &mut impl FnMut(R));
}

macro_rules! kernel {
    ($($argument:ident)+) => {
        impl<R, Function, Out: Laid<R>, $($argument: Taken<R>),+> Kernel<R, ($($argument,)+)> for Function
        where
            Function: Fn($($argument),+) -> Out,
        {
            fn shape(&self) -> Shape {
                Shape { arguments: [$($argument::sizes()),+].concat(), results: Out::sizes() }
            }
            #[inline(always)]
            fn apply(&self, from: &mut impl FnMut() -> R, to: &mut impl FnMut(R)) {
                self($($argument::take(from)),+).put(to);
            }
        }
    };
}
macro_rules! kernels {
    ($first:ident) => { kernel!($first); };
    ($first:ident $($rest:ident)+) => { kernel!($first $($rest)+); kernels!($($rest)+); };
}
kernels!(A B C D E F G H I J K L M N O P Q S T U V W X Y);

/// Evaluates a kernel with arguments laid end to end.
pub fn apply<R: Copy, A, K: Kernel<R, A>>(kernel: K, numbers: &[R]) -> Vec<R> {
    let (mut next, mut out) = (numbers.iter().copied(), Vec::new());
    kernel.apply(&mut || next.next().expect("a number for each argument"), &mut |number| out.push(number));
    out
}
/// Sizes of a kernel's arguments and results.
pub fn shape<R, A, K: Kernel<R, A>>(kernel: K) -> Shape {
    kernel.shape()
}

/// Makes the list's entry of a function of the file it is called in: `equation!("wear/eq03_normal_force.rs", "wear-3", ["3"], normal_force)`.
#[macro_export]
macro_rules! equation {
    ($file:literal, $id:literal, [$($number:literal),*], $function:ident) => {{
        fn flat<R: $crate::Real>(numbers: &[R]) -> Vec<R> {
            $crate::equation::apply($function::<R>, numbers)
        }
        $crate::equation::Equation {
            id: $id,
            covers: &[$($number),*],
            function: stringify!($function),
            file: $file,
            source: include_str!(concat!("../", $file)),
            shape: || $crate::equation::shape($function::<f64>),
            eval: $crate::equation::Evaluate {
                f64: flat,
                f32: flat,
                #[cfg(feature = "columns")]
                lanes: flat,
                #[cfg(feature = "source")]
                source: flat,
                #[cfg(feature = "verify")]
                dual: flat,
                #[cfg(feature = "verify")]
                dimension: flat,
                #[cfg(feature = "verify")]
                reference: flat,
                #[cfg(feature = "verify")]
                interval: flat,
                #[cfg(feature = "verify")]
                rounded: flat,
                #[cfg(feature = "verify")]
                slope: flat,
            },
            #[cfg(feature = "columns")]
            many: $crate::columns::Many {
                f64: |arguments, results| $crate::columns::one_by_one($function::<f64>, arguments, results),
                rows: |instructions, arguments, results| {
                    $crate::columns::in_rows($function::<f64>, instructions, arguments, results)
                },
            },
        }
    }};
}
