//! The command line.

#[global_allocator]
static ALLOCATOR: veridem::allocator::LargePages = veridem::allocator::LargePages;

fn main() -> std::process::ExitCode {
    veridem::cli::main(veridem::papers::PAPERS)
}
