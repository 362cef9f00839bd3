#![no_main]
#[path = "../../tests/fuzz/checkpoints.rs"]
mod checkpoints;
#[path = "../../tests/fuzz/targets.rs"]
mod targets;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| targets::call("necks", bytes));
