//! Mutations of a small file.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// What stands in files that readers stumble over.
const PIECES: [&[u8]; 34] = [
    b"nan",
    b"inf",
    b"-1",
    b"0",
    b"1e400",
    b"-1e400",
    b"1e-400",
    b"1e308",
    b"99999999999",
    b"18446744073709551616",
    b"\n",
    b"\r",
    b" ",
    b"#",
    b"\"",
    b"'",
    b"[",
    b"]",
    b"{",
    b"}",
    b"<",
    b">",
    b"&",
    b"*",
    b":",
    b"- ",
    b"|",
    b"%",
    b"\0",
    b"\xff",
    b"\xc2\x85",
    b"\xe2\x80\xa8",
    b"\xef\xbb\xbf",
    b"\t",
];

/// The first file after some mutations, one of which may take a part of the second.
pub(crate) fn mutated(first: &[u8], second: &[u8], random: &mut ChaCha8Rng) -> Vec<u8> {
    let mut bytes = first.to_vec();
    let mut below = |n: usize| random.next_u64() as usize % n.max(1);
    for _ in 0..1 + below(4) {
        let (at, length) = (below(bytes.len() + 1), below(20));
        let end = bytes.len().min(at + length);
        match below(7) {
            0 => drop(bytes.drain(at..end)),
            1 => drop(bytes.splice(at..end, PIECES[below(PIECES.len())].iter().copied())),
            2 => drop(bytes.splice(at..at, PIECES[below(PIECES.len())].iter().copied())),
            3 => {
                let part = bytes[at..end].repeat(1 + below(4));
                drop(bytes.splice(at..at, part));
            }
            4 if at < bytes.len() => bytes[at] ^= 1 << below(8),
            5 => bytes.truncate(at),
            _ => {
                let from = below(second.len() + 1);
                let part = &second[from..second.len().min(from + below(200))];
                drop(bytes.splice(at..at, part.iter().copied()));
            }
        }
    }
    bytes
}
