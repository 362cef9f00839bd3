//! Advances a periodic HCP crystal: what `lammps.py` sets against LAMMPS.
//!
//!     cargo run --release -p veridem-peers --bin hcp_steps -- CELLS_X CELLS_Y CELLS_Z STEPS THREADS [INSTRUCTIONS]

mod crystal;

use veridem::error::Halt;
use veridem::forces::Instructions;
use veridem::run::advance;

#[global_allocator]
static ALLOCATOR: veridem::allocator::LargePages = veridem::allocator::LargePages;

fn main() -> Result<(), Halt> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let numbers: Vec<usize> = words.iter().take(5).map(|word| word.parse().expect("whole numbers")).collect();
    let [x, y, z, steps, threads] = numbers[..] else { panic!("expected CELLS_X CELLS_Y CELLS_Z STEPS THREADS") };
    if let Some(name) = words.get(5) {
        Instructions::named(name).expect("instructions that this processor has: baseline, avx2 or avx512").choose();
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).use_current_thread();
    pool.build_global().expect("the first thread pool");
    let mut simulation = crystal::simulation([x, y, z], Instructions::best())?;
    assert_eq!(simulation.pairs().count(), 24 * x * y * z, "every sphere has twelve neighbours");
    advance(&mut simulation, steps as u64)?;
    Ok(())
}
