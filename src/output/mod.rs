//! The run folder: the output of a run, written so that an incomplete file is never mistaken for a result.

pub mod aggregate;
mod apart;
mod appending;
mod checkpoint;
mod claim;
pub mod columns;
mod files;
mod finding;
mod folder;
pub mod frames;
mod lammps;
mod lock;
mod manifest;
mod read_frame;
mod reading;
mod series;
mod spheres;

pub use crate::error::read_file as read;
pub use apart::Apart;
pub use appending::{Appending, Fingerprint};
pub use checkpoint::{Checkpoints, Origin, encoded_size, load_sample, save_sample, state_hash};
pub use claim::{Claim, Place};
pub use columns::Column;
pub use files::{create_folder, sha256, sha256_file, sync_folder, with_suffix, write_atomically};
pub use finding::{Finding, Found};
pub use folder::{INPUTS, RunFolder};
pub use frames::{Frame, FrameName, collections, is_of_frames};
pub use lammps::{LammpsScript, for_lammps};
pub use lock::Lock;
pub use manifest::{Manifest, Status, command_line};
pub use read_frame::{Mesh, Property, ReadFrame};
pub use reading::{Event, ReadTable, Series, between};
pub use series::{Cell, Layout, Table, row};
pub use spheres::{bod, mstm, ply};
