//! Work that moves numbers between the lanes of vectors.

use super::transpose::Square;

/// Vectorised work, which is compiled for every instruction set.
pub trait Vectorised {
    /// The result.
    type Outcome;
    /// Does the work; `across` transposes rows and columns. To be inlined.
    fn run(self, across: impl Fn(Square) -> Square) -> Self::Outcome;
}
