//! What is left on a disk after a power cut: a model of files and folders in which only what was synced is certain to survive.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::collections::{BTreeMap, HashMap};
use std::path::Path;

/// A file or folder: as the program sees it, and as it was synced last.
#[derive(Clone)]
enum Node {
    File { now: Vec<u8>, synced: Vec<u8> },
    Folder { now: BTreeMap<String, usize>, synced: BTreeMap<String, usize> },
}

/// Files and folders below one folder.
#[derive(Clone)]
pub(crate) struct Disk {
    nodes: Vec<Node>,
    handles: HashMap<String, usize>,
}

/// The fate of what was not synced.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Unsynced {
    /// All is lost.
    Lost,
    /// Every file and every entry of a folder by itself is lost, survives, or survives in part; the number seeds the choice.
    Either(u64),
}

impl Disk {
    /// The disk on which everything below `folder` is safe.
    pub(crate) fn of(folder: &Path) -> Self {
        let mut disk = Self { nodes: vec![], handles: HashMap::new() };
        disk.take(folder);
        disk
    }

    fn take(&mut self, path: &Path) -> usize {
        let place = self.nodes.len();
        if !path.is_dir() {
            let bytes = std::fs::read(path).unwrap();
            self.nodes.push(Node::File { now: bytes.clone(), synced: bytes });
            return place;
        }
        self.nodes.push(folder(BTreeMap::new()));
        let mut entries = BTreeMap::new();
        for entry in std::fs::read_dir(path).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap().to_string();
            entries.insert(name, self.take(&path));
        }
        self.nodes[place] = folder(entries);
        place
    }

    fn entries(&mut self, place: usize) -> &mut BTreeMap<String, usize> {
        match &mut self.nodes[place] {
            Node::Folder { now, .. } => now,
            Node::File { .. } => panic!("a file has no entries"),
        }
    }

    /// The folder that a path lies in, and its last name.
    fn place<'p>(&mut self, path: &'p str) -> (usize, &'p str) {
        let (folders, name) = path.rsplit_once('/').unwrap_or(("", path));
        let parts = folders.split('/').filter(|part| !part.is_empty() && *part != ".");
        (parts.fold(0, |at, part| self.entries(at)[part]), name)
    }

    fn at(&mut self, path: &str) -> usize {
        let (folder, name) = self.place(path);
        if name.is_empty() || name == "." { folder } else { self.entries(folder)[name] }
    }

    fn content(&mut self, handle: &str) -> &mut Vec<u8> {
        let node = self.handles[handle];
        match &mut self.nodes[node] {
            Node::File { now, .. } => now,
            Node::Folder { .. } => panic!("a folder has no content"),
        }
    }

    /// Carries out a line of the journal.
    pub(crate) fn apply(&mut self, line: &str) {
        let words: Vec<&str> = line.split('\t').collect();
        match words[..] {
            ["open", handle, path, creates, truncates] => {
                let (folder, name) = self.place(path);
                if creates == "1" && !self.entries(folder).contains_key(name) {
                    let new = self.nodes.len();
                    self.nodes.push(Node::File { now: vec![], synced: vec![] });
                    self.entries(folder).insert(name.into(), new);
                }
                let node = self.at(path);
                self.handles.insert(handle.into(), node);
                if truncates == "1" {
                    self.content(handle).clear();
                }
            }
            ["write", handle, start, digits] => {
                let start: usize = start.parse().unwrap();
                let digit = |at: usize| u8::from_str_radix(&digits[at..at + 2], 16).unwrap();
                let bytes: Vec<u8> = (0..digits.len()).step_by(2).map(digit).collect();
                let content = self.content(handle);
                let end = start + bytes.len();
                content.resize(content.len().max(end), 0);
                content[start..end].copy_from_slice(&bytes);
            }
            ["length", handle, length] => self.content(handle).resize(length.parse().unwrap(), 0),
            ["sync", handle] => match &mut self.nodes[self.handles[handle]] {
                Node::File { now, synced } => synced.clone_from(now),
                Node::Folder { now, synced } => synced.clone_from(now),
            },
            ["rename", from, to] => {
                let node = self.at(from);
                let (folder, name) = self.place(from);
                self.entries(folder).remove(name);
                let (folder, name) = self.place(to);
                self.entries(folder).insert(name.into(), node);
            }
            ["remove", path] => {
                let (folder, name) = self.place(path);
                self.entries(folder).remove(name);
            }
            ["folder", path] => {
                let new = self.nodes.len();
                self.nodes.push(folder(BTreeMap::new()));
                let (folder, name) = self.place(path);
                self.entries(folder).insert(name.into(), new);
            }
            ["calls", _] => {}
            _ => panic!("the journal holds `{line}`"),
        }
    }

    /// Writes to `folder` all that a power cut leaves.
    pub(crate) fn after_power_cut(&self, unsynced: Unsynced, folder: &Path) {
        let mut chance = match unsynced {
            Unsynced::Lost => None,
            Unsynced::Either(seed) => Some(ChaCha8Rng::seed_from_u64(seed)),
        };
        self.restore(0, folder, &mut chance);
    }

    fn restore(&self, place: usize, path: &Path, chance: &mut Option<ChaCha8Rng>) {
        let mut toss = |sides: u32| chance.as_mut().map_or(0, |chance| chance.next_u32() % sides);
        match &self.nodes[place] {
            Node::File { now, synced } => {
                // What was synced is safe as far as it has not been written over.
                let safe = synced.iter().zip(now).take_while(|(a, b)| a == b).count();
                let content = match toss(4) {
                    0 => synced.clone(),
                    1 => now.clone(),
                    // The new length without the new content, or a part of it.
                    2 => synced.iter().copied().chain(std::iter::repeat(0)).take(now.len()).collect(),
                    _ => now[..safe + toss(1 << 30) as usize % (now.len() - safe + 1)].to_vec(),
                };
                std::fs::write(path, content).unwrap();
            }
            Node::Folder { now, synced } => {
                std::fs::create_dir_all(path).unwrap();
                let mut entries = synced.clone();
                for name in now.keys().chain(synced.keys()).filter(|name| now.get(*name) != synced.get(*name)) {
                    match (toss(2), now.get(name)) {
                        (0, _) => None,
                        (_, Some(&node)) => entries.insert(name.clone(), node),
                        (_, None) => entries.remove(name),
                    };
                }
                entries.iter().for_each(|(name, &node)| self.restore(node, &path.join(name), chance));
            }
        }
    }
}

fn folder(entries: BTreeMap<String, usize>) -> Node {
    Node::Folder { now: entries.clone(), synced: entries }
}

#[test]
fn only_synced_bytes_and_synced_names_survive() {
    let place = tempfile::tempdir().unwrap();
    let mut disk = Disk::of(place.path());
    let steps = ["open\t1\ta.part\t1\t1", "write\t1\t0\t4142", "sync\t1", "rename\ta.part\ta", "open\t2\t.\t0\t0"];
    steps.iter().for_each(|step| disk.apply(step));
    let names = |disk: &Disk| {
        let left = tempfile::tempdir().unwrap();
        disk.after_power_cut(Unsynced::Lost, left.path());
        let entries = std::fs::read_dir(left.path()).unwrap();
        entries.map(|entry| entry.unwrap().path()).map(|path| std::fs::read(path).unwrap()).collect::<Vec<_>>()
    };
    assert!(names(&disk).is_empty(), "the folder was not synced");
    disk.apply("sync\t2");
    disk.apply("write\t1\t2\t43");
    assert_eq!(names(&disk), [b"AB"], "the last byte was not synced");
}
