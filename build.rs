//! Tells the program what it was built from.

use std::process::Command;

fn main() {
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    let first_line = |program: &str, arguments: &[&str]| {
        let output = Command::new(program).args(arguments).output().ok().filter(|output| output.status.success());
        output.map_or_else(
            || "unknown".into(),
            |o| String::from_utf8_lossy(&o.stdout).lines().next().unwrap_or("unknown").to_string(),
        )
    };
    println!("cargo::rustc-env=VERIDEM_COMMIT={}", first_line("git", &["rev-parse", "HEAD"]));
    println!("cargo::rustc-env=VERIDEM_COMPILER={}", first_line(&rustc, &["--version"]));
    println!("cargo::rustc-env=VERIDEM_TARGET={}", std::env::var("TARGET").unwrap_or_else(|_| "unknown".into()));
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=.git/HEAD");
}
