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
    // Results come from release builds. Others are not told their commit, so that a commit does not make them outdated.
    let commit = if std::env::var("PROFILE").is_ok_and(|profile| profile == "release") {
        println!("cargo::rerun-if-changed={}", first_line("git", &["rev-parse", "--git-path", "logs/HEAD"]));
        first_line("git", &["rev-parse", "HEAD"])
    } else {
        "unknown (debug build)".into()
    };
    println!("cargo::rustc-env=VERIDEM_COMMIT={commit}");
    println!("cargo::rustc-env=VERIDEM_COMPILER={}", first_line(&rustc, &["--version"]));
    println!("cargo::rustc-env=VERIDEM_TARGET={}", std::env::var("TARGET").unwrap_or_else(|_| "unknown".into()));
    println!("cargo::rerun-if-changed=build.rs");
}
