
// How results are multiplied by a factor: the end of the module in the copy of the specification.

use crate::{Real, Vec3};

/// What an equation returns.
pub(crate) trait Scaled<R> {
    /// All of its numbers times a factor.
    fn scaled(self, factor: R) -> Self;
}

impl<R: Real> Scaled<R> for R {
    fn scaled(self, factor: R) -> Self {
        self * factor
    }
}
impl<R: Real> Scaled<R> for Vec3<R> {
    fn scaled(self, factor: R) -> Self {
        self * factor
    }
}
impl<R: Real> Scaled<R> for [Vec3<R>; 3] {
    fn scaled(self, factor: R) -> Self {
        self.map(|row| row * factor)
    }
}
macro_rules! scaled_tuple {
    ($($part:ident)+) => {
        #[allow(non_snake_case)]
        impl<R: Real, $($part: Scaled<R>),+> Scaled<R> for ($($part,)+) {
            fn scaled(self, factor: R) -> Self {
                let ($($part,)+) = self;
                ($($part.scaled(factor),)+)
            }
        }
    };
}
scaled_tuple!(A B);
scaled_tuple!(A B C);
scaled_tuple!(A B C D);
scaled_tuple!(A B C D E);
scaled_tuple!(A B C D E F);
scaled_tuple!(A B C D E F G);

/// The result of an equation, or 1.01, 0 or -1 times it if one of its three mutants is active.
#[inline(always)]
pub(crate) fn result<R: Real, S: Scaled<R>>(first: u32, result: S) -> S {
    if on(first) {
        result.scaled(R::lit(1.01))
    } else if on(first + 1) {
        result.scaled(R::zero())
    } else if on(first + 2) {
        result.scaled(-R::one())
    } else {
        result
    }
}
