//! The run folder: the output of a run, written so that an incomplete file is never mistaken for a result.

mod appending;
mod checkpoint;
pub mod columns;
mod files;
mod folder;
mod frames;
mod manifest;
mod reading;
mod series;

pub use appending::{Appending, Fingerprint};
pub use checkpoint::{Checkpoints, SavedKind, load_state, save_state};
pub use columns::Column;
pub use files::{create_folder, read, sha256_file, sync_folder, write_atomically};
pub use folder::RunFolder;
pub use frames::{SURFACES, extended_xyz, frame_name, wavefront};
pub use manifest::{Manifest, Status};
pub use reading::{Event, Series, between};
pub use series::{Cell, Finding, row};
