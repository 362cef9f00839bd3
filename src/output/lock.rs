//! The lock of a folder: held by the process that writes it, and released by the operating system when that process ends.

use crate::error::{AtPath, Error};
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Error as Cause, ErrorKind, Write};
use std::path::Path;
use std::time::Duration;

/// The name of the file of a lock in its folder.
pub(super) const LOCK: &str = "lock";

/// How often a lock is tried, as a reader holds it for a moment to see whether it is free.
const TRIES: u32 = 5;
const PAUSE: Duration = Duration::from_millis(20);

/// The right of this process to write a folder, until it is dropped.
#[derive(Debug)]
pub struct Lock {
    file: File,
}

impl Lock {
    /// Locks an existing folder, and writes into the lock which process holds it.
    ///
    /// # Errors
    ///
    /// If another process holds it, which is named; if the file of the lock cannot be written.
    pub fn take(folder: &Path) -> Result<Self, Error> {
        let path = folder.join(LOCK);
        if std::fs::symlink_metadata(&path).is_ok_and(|found| !found.is_file()) {
            return Err(Error::Io(path, Cause::new(ErrorKind::AlreadyExists, "is not the file of a lock")));
        }
        let mut file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path).at(&path)?;
        let mut tries = 1;
        loop {
            match file.try_lock() {
                Ok(()) => break,
                // Some file systems of clusters have no locks.
                Err(TryLockError::Error(cause)) if cause.kind() == ErrorKind::Unsupported => break,
                Err(TryLockError::Error(cause)) => return Err(Error::Io(path, cause)),
                Err(TryLockError::WouldBlock) if tries < TRIES => std::thread::sleep(PAUSE),
                Err(TryLockError::WouldBlock) => {
                    let holder = std::fs::read_to_string(&path).unwrap_or_default();
                    let holder = if holder.is_empty() { "another process" } else { holder.trim_end() };
                    let what = format!("is being written by {holder}");
                    return Err(Error::Io(folder.into(), Cause::new(ErrorKind::ResourceBusy, what)));
                }
            }
            tries += 1;
        }
        let holder = format!("process {}{}: {}\n", std::process::id(), on_host(), super::command_line());
        file.set_len(0).and_then(|()| file.write_all(holder.as_bytes())).at(&path)?;
        Ok(Self { file })
    }

    /// Whether a process holds the lock of a folder.
    pub fn is_held(folder: &Path) -> bool {
        let held = |file: File| matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock));
        File::open(folder.join(LOCK)).is_ok_and(held)
    }
}

impl Drop for Lock {
    /// The file stays: to remove it would let two processes lock two files of the same name.
    fn drop(&mut self) {
        self.file.set_len(0).ok();
    }
}

fn on_host() -> String {
    let name = std::fs::read_to_string("/proc/sys/kernel/hostname").or_else(|_| std::env::var("COMPUTERNAME"));
    name.map(|name| format!(" on {}", name.trim())).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lock_has_one_holder_who_is_named() {
        let folder = tempfile::tempdir().unwrap();
        assert!(!Lock::is_held(folder.path()));
        let lock = Lock::take(folder.path()).unwrap();
        assert!(Lock::is_held(folder.path()));
        let refused = Lock::take(folder.path()).unwrap_err();
        let expected = format!("{}: is being written by process {}", folder.path().display(), std::process::id());
        assert!(refused.to_string().starts_with(&expected), "{refused}");
        assert_eq!(refused.exit_code(), 74);
        drop(lock);
        assert!(!Lock::is_held(folder.path()));
        assert_eq!(std::fs::read(folder.path().join(LOCK)).unwrap(), b"");
        Lock::take(folder.path()).unwrap();
    }
}
