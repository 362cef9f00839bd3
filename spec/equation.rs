//! The list of all equations, as data.
//!
//! A room of the specification ends with one line, `equation!("wear-3", ["3"], normal_force)`. It yields the golden
//! vectors, the unit check, the rounding bounds, the index, the benches and `veridem eq`. Names, units and domains are
//! not repeated there: they are read from the table in the function's documentation.

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
    pub lanes: fn(&[Lanes<8>]) -> Vec<Lanes<8>>,
    #[cfg(feature = "verify")]
    pub dual: fn(&[crate::numbers::Dual]) -> Vec<crate::numbers::Dual>,
    #[cfg(feature = "verify")]
    pub dimension: fn(&[crate::numbers::Dimension]) -> Vec<crate::numbers::Dimension>,
    #[cfg(feature = "verify")]
    pub reference: fn(&[crate::numbers::Reference]) -> Vec<crate::numbers::Reference>,
    #[cfg(feature = "verify")]
    pub interval: fn(&[crate::numbers::Interval]) -> Vec<crate::numbers::Interval>,
}

/// An argument or result: numbers laid end to end.
pub trait Laid<R> {
    /// How many numbers it is; tuples of results list several.
    fn sizes() -> Vec<usize>;
    /// Appends its numbers.
    fn flatten(self, out: &mut Vec<R>);
}
/// An argument that can be taken up again from numbers laid end to end.
pub trait Taken<R>: Laid<R> {
    /// Takes the value from the front of `numbers`.
    fn take(numbers: &mut &[R]) -> Self;
}

impl<R: Real> Laid<R> for R {
    fn sizes() -> Vec<usize> {
        vec![1]
    }
    fn flatten(self, out: &mut Vec<R>) {
        out.push(self);
    }
}
impl<R: Real> Taken<R> for R {
    fn take(numbers: &mut &[R]) -> R {
        let value = numbers[0];
        *numbers = &numbers[1..];
        value
    }
}
impl<R: Real> Laid<R> for Vec3<R> {
    fn sizes() -> Vec<usize> {
        vec![3]
    }
    fn flatten(self, out: &mut Vec<R>) {
        out.extend(self.0);
    }
}
impl<R: Real> Taken<R> for Vec3<R> {
    fn take(numbers: &mut &[R]) -> Self {
        Self(std::array::from_fn(|_| R::take(numbers)))
    }
}
impl<R: Real> Laid<R> for Tensor<R> {
    fn sizes() -> Vec<usize> {
        vec![9]
    }
    fn flatten(self, out: &mut Vec<R>) {
        for row in self {
            row.flatten(out);
        }
    }
}

macro_rules! laid_tuple {
    ($($part:ident)+) => {
        impl<R, $($part: Laid<R>),+> Laid<R> for ($($part,)+) {
            fn sizes() -> Vec<usize> {
                [$($part::sizes()),+].concat()
            }
            #[allow(non_snake_case)]
            fn flatten(self, out: &mut Vec<R>) {
                let ($($part,)+) = self;
                $($part.flatten(out);)+
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
    /// Evaluates it with arguments laid end to end.
    fn apply(&self, numbers: &[R]) -> Vec<R>;
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
            fn apply(&self, mut numbers: &[R]) -> Vec<R> {
                let mut out = Vec::new();
                self($($argument::take(&mut numbers)),+).flatten(&mut out);
                out
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
pub fn apply<R, A, K: Kernel<R, A>>(kernel: K, numbers: &[R]) -> Vec<R> {
    kernel.apply(numbers)
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
                lanes: flat,
                #[cfg(feature = "verify")]
                dual: flat,
                #[cfg(feature = "verify")]
                dimension: flat,
                #[cfg(feature = "verify")]
                reference: flat,
                #[cfg(feature = "verify")]
                interval: flat,
            },
        }
    }};
}
