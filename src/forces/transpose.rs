//! Rows to columns, eight by eight: how what belongs to one sphere becomes one number of eight pairs, and back.
//!
//! Numbers are only moved here, so every instruction set gives the same bits. The compiler does not find these moves by itself.

use super::LANES;

/// Eight rows of eight numbers.
pub type Square = [[f64; LANES]; LANES];

/// With whatever the compiler makes of it.
#[inline(always)]
pub fn baseline(rows: Square) -> Square {
    std::array::from_fn(|column| std::array::from_fn(|row| rows[row][column]))
}

/// Four quarters, each in two rounds of moves between four vectors.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
#[inline]
pub fn avx2(rows: Square) -> Square {
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
pub fn avx512(rows: Square) -> Square {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forces::Instructions;

    #[test]
    #[cfg(target_arch = "x86_64")]
    #[expect(unsafe_code, reason = "only what the processor has is called")]
    fn every_instruction_set_exchanges_rows_and_columns() {
        let rows: Square = std::array::from_fn(|row| std::array::from_fn(|column| (10 * row + column) as f64));
        for set in Instructions::available() {
            let columns = match set {
                Instructions::Baseline => baseline(rows),
                Instructions::Avx2 => unsafe { avx2(rows) },
                Instructions::Avx512 => unsafe { avx512(rows) },
            };
            for (row, column) in (0..LANES).flat_map(|row| (0..LANES).map(move |column| (row, column))) {
                assert_eq!(columns[column][row], rows[row][column], "{set:?}");
            }
        }
    }
}
