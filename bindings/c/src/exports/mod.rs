//! The functions of the header.

mod equations;
mod laws;
mod lists;
mod steps;

/// A law as the caller holds it.
struct VeridemLaw(Box<dyn crate::law::Law>);

#[unsafe(no_mangle)]
extern "C" fn veridem_abi() -> u32 {
    crate::spheres::ABI
}
