//! The functions of `veridem.h`, where they are documented: thin translations between pointers and the kernels.

mod columns;
mod error;
mod exports;
mod law;
mod laws;
mod list;
mod motion;
mod necks;
mod plane;
mod pointers;
mod spheres;
mod step;
mod words;
