//! The command line.

fn main() -> std::process::ExitCode {
    veridem::cli::main(veridem::papers::PAPERS)
}
