//! Transposition of eight by eight numbers: from the data of one sphere to one quantity of eight pairs, and back.
//!
//! Numbers are only moved here, so every instruction set gives the same bits. The compiler does not find these moves by itself.

use super::LANES;

/// Eight rows of eight numbers.
pub type Square = [[f64; LANES]; LANES];
/// Eight rows of four numbers.
pub(super) type Rows = [[f64; 4]; LANES];
/// Four columns of eight numbers.
pub(super) type Columns = [[f64; LANES]; 4];

/// With whatever the compiler makes of it.
#[inline(always)]
pub(super) fn baseline(rows: Square) -> Square {
    std::array::from_fn(|column| std::array::from_fn(|row| rows[row][column]))
}

/// Four quarters, each in two rounds of moves between four vectors.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
#[inline]
pub(super) fn avx2(rows: Square) -> Square {
    use std::arch::x86_64::{_mm256_permute2f128_pd as halves, _mm256_unpackhi_pd as odd, _mm256_unpacklo_pd as even};
    let rows: [[std::arch::x86_64::__m256d; 2]; LANES] = bytemuck::cast(rows);
    let mut columns = rows;
    for (top, left) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let (a, b, c, d) =
            (rows[4 * top][left], rows[4 * top + 1][left], rows[4 * top + 2][left], rows[4 * top + 3][left]);
        let (even_ab, odd_ab, even_cd, odd_cd) = (even(a, b), odd(a, b), even(c, d), odd(c, d));
        columns[4 * left][top] = halves::<0x20>(even_ab, even_cd);
        columns[4 * left + 1][top] = halves::<0x20>(odd_ab, odd_cd);
        columns[4 * left + 2][top] = halves::<0x31>(even_ab, even_cd);
        columns[4 * left + 3][top] = halves::<0x31>(odd_ab, odd_cd);
    }
    bytemuck::cast(columns)
}

/// Pairs of rows interleaved, then quarters of vectors exchanged in two rounds.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f")]
#[inline]
pub(super) fn avx512(rows: Square) -> Square {
    use std::arch::x86_64::{_mm512_shuffle_f64x2 as quarters, _mm512_unpackhi_pd as odd, _mm512_unpacklo_pd as even};
    let r: [std::arch::x86_64::__m512d; LANES] = bytemuck::cast(rows);
    let mut columns = r;
    let interleaved = [
        [even(r[0], r[1]), even(r[2], r[3]), even(r[4], r[5]), even(r[6], r[7])],
        [odd(r[0], r[1]), odd(r[2], r[3]), odd(r[4], r[5]), odd(r[6], r[7])],
    ];
    for first in 0..2 {
        let [ab, cd, ef, gh] = interleaved[first];
        let (low, high) = (quarters::<0x88>(ab, cd), quarters::<0x88>(ef, gh));
        columns[first] = quarters::<0x88>(low, high);
        columns[first + 4] = quarters::<0xdd>(low, high);
        let (low, high) = (quarters::<0xdd>(ab, cd), quarters::<0xdd>(ef, gh));
        columns[first + 2] = quarters::<0x88>(low, high);
        columns[first + 6] = quarters::<0xdd>(low, high);
    }
    bytemuck::cast(columns)
}

/// Half as much for rows of four.
pub(super) mod narrow {
    use super::{Columns, LANES, Rows};

    /// With whatever the compiler makes of it.
    #[inline(always)]
    pub(crate) fn baseline(rows: Rows) -> Columns {
        std::array::from_fn(|column| std::array::from_fn(|row| rows[row][column]))
    }

    /// The upper four rows, then the lower.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    #[inline]
    pub(crate) fn avx2(rows: Rows) -> Columns {
        use std::arch::x86_64::{
            _mm256_permute2f128_pd as halves, _mm256_unpackhi_pd as odd, _mm256_unpacklo_pd as even,
        };
        let r: [std::arch::x86_64::__m256d; LANES] = bytemuck::cast(rows);
        let mut columns = [[r[0]; 2]; 4];
        for top in 0..2 {
            let [a, b, c, d] = [r[4 * top], r[4 * top + 1], r[4 * top + 2], r[4 * top + 3]];
            let (even_ab, odd_ab, even_cd, odd_cd) = (even(a, b), odd(a, b), even(c, d), odd(c, d));
            columns[0][top] = halves::<0x20>(even_ab, even_cd);
            columns[1][top] = halves::<0x20>(odd_ab, odd_cd);
            columns[2][top] = halves::<0x31>(even_ab, even_cd);
            columns[3][top] = halves::<0x31>(odd_ab, odd_cd);
        }
        bytemuck::cast(columns)
    }

    /// Two rows to a vector, in the order that puts the quarters exchanged last where they belong.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f")]
    #[inline]
    pub(crate) fn avx512(rows: Rows) -> Columns {
        use std::arch::x86_64::{_mm512_castpd256_pd512 as widen, _mm512_insertf64x4 as insert};
        use std::arch::x86_64::{
            _mm512_shuffle_f64x2 as quarters, _mm512_unpackhi_pd as odd, _mm512_unpacklo_pd as even,
        };
        let r: [std::arch::x86_64::__m256d; LANES] = bytemuck::cast(rows);
        let two = |a: usize, b: usize| insert::<1>(widen(r[a]), r[b]);
        let (even_02, odd_02) = (even(two(0, 2), two(1, 3)), odd(two(0, 2), two(1, 3)));
        let (even_46, odd_46) = (even(two(4, 6), two(5, 7)), odd(two(4, 6), two(5, 7)));
        bytemuck::cast([
            quarters::<0x88>(even_02, even_46),
            quarters::<0x88>(odd_02, odd_46),
            quarters::<0xdd>(even_02, even_46),
            quarters::<0xdd>(odd_02, odd_46),
        ])
    }
}

/// The way back from [`narrow`].
pub(super) mod back {
    use super::{Columns, LANES, Rows};

    /// With whatever the compiler makes of it.
    #[inline(always)]
    pub(crate) fn baseline(columns: Columns) -> Rows {
        std::array::from_fn(|row| std::array::from_fn(|column| columns[column][row]))
    }

    /// The upper four rows, then the lower.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    #[inline]
    pub(crate) fn avx2(columns: Columns) -> Rows {
        use std::arch::x86_64::{
            _mm256_permute2f128_pd as halves, _mm256_unpackhi_pd as odd, _mm256_unpacklo_pd as even,
        };
        let c: [[std::arch::x86_64::__m256d; 2]; 4] = bytemuck::cast(columns);
        let mut rows = [c[0][0]; LANES];
        for top in 0..2 {
            let [x, y, z, w] = [c[0][top], c[1][top], c[2][top], c[3][top]];
            let (even_xy, odd_xy, even_zw, odd_zw) = (even(x, y), odd(x, y), even(z, w), odd(z, w));
            rows[4 * top] = halves::<0x20>(even_xy, even_zw);
            rows[4 * top + 1] = halves::<0x20>(odd_xy, odd_zw);
            rows[4 * top + 2] = halves::<0x31>(even_xy, even_zw);
            rows[4 * top + 3] = halves::<0x31>(odd_xy, odd_zw);
        }
        bytemuck::cast(rows)
    }

    /// Pairs of columns interleaved, then every two rows put together.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f")]
    #[inline]
    pub(crate) fn avx512(columns: Columns) -> Rows {
        use std::arch::x86_64::{
            _mm512_castpd512_pd256 as low, _mm512_extractf64x4_pd as half, _mm512_set_epi64 as set,
        };
        use std::arch::x86_64::{
            _mm512_permutex2var_pd as choose, _mm512_unpackhi_pd as odd, _mm512_unpacklo_pd as even,
        };
        let [x, y, z, w]: [std::arch::x86_64::__m512d; 4] = bytemuck::cast(columns);
        let (first, second) = (set(11, 10, 3, 2, 9, 8, 1, 0), set(15, 14, 7, 6, 13, 12, 5, 4));
        let (even_xy, even_zw, odd_xy, odd_zw) = (even(x, y), even(z, w), odd(x, y), odd(z, w));
        let two = |which| (choose(even_xy, which, even_zw), choose(odd_xy, which, odd_zw));
        let ((rows_02, rows_13), (rows_46, rows_57)) = (two(first), two(second));
        bytemuck::cast([
            low(rows_02),
            low(rows_13),
            half::<1>(rows_02),
            half::<1>(rows_13),
            low(rows_46),
            low(rows_57),
            half::<1>(rows_46),
            half::<1>(rows_57),
        ])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::numbers::{Instructions, Set};

    #[test]
    #[cfg(target_arch = "x86_64")]
    #[expect(unsafe_code, reason = "only what the processor has is called")]
    fn every_instruction_set_exchanges_rows_and_columns() {
        let rows: Square = std::array::from_fn(|row| std::array::from_fn(|column| (10 * row + column) as f64));
        for set in Instructions::available() {
            let columns = match set.set() {
                Set::Baseline => baseline(rows),
                // SAFETY: the processor has these instructions, or there were no such `Instructions`.
                Set::Avx2 => unsafe { avx2(rows) },
                // SAFETY: the processor has these instructions, or there were no such `Instructions`.
                Set::Avx512 => unsafe { avx512(rows) },
            };
            let narrow: Rows = rows.map(|row| [row[0], row[1], row[2], row[3]]);
            let (few, again) = match set.set() {
                Set::Baseline => (narrow::baseline(narrow), back::baseline(narrow::baseline(narrow))),
                // SAFETY: the processor has these instructions, or there were no such `Instructions`.
                Set::Avx2 => unsafe { (narrow::avx2(narrow), back::avx2(narrow::avx2(narrow))) },
                // SAFETY: the processor has these instructions, or there were no such `Instructions`.
                Set::Avx512 => unsafe { (narrow::avx512(narrow), back::avx512(narrow::avx512(narrow))) },
            };
            for (row, column) in (0..LANES).flat_map(|row| (0..LANES).map(move |column| (row, column))) {
                assert_eq!(columns[column][row], rows[row][column], "{set:?}");
                assert!(column >= 4 || few[column][row] == rows[row][column], "{set:?}");
            }
            assert_eq!(again, narrow, "{set:?}");
        }
    }
}
