//! Source files as the tests of the house read them.

use std::path::Path;

/// A source file.
pub(crate) struct Source {
    /// Its path from the root of the repository.
    pub path: String,
    /// Its module, without the name of the crate.
    pub module: Vec<String>,
    /// Its text, blank where it is for tests only.
    pub text: String,
    /// The same, blank where it is no code.
    pub code: String,
}

/// All source files of a folder, without those that are for tests only.
pub(crate) fn sources(folder: &str) -> Vec<Source> {
    let root = std::env::var("CARGO_MANIFEST_DIR").expect("tests are run by cargo");
    let mut found = Vec::new();
    read(Path::new(&root), folder, &mut found);
    found.sort_by(|a, b| a.path.cmp(&b.path));
    found
}

fn read(root: &Path, folder: &str, found: &mut Vec<Source>) {
    for entry in std::fs::read_dir(root.join(folder)).expect("a folder of sources") {
        let name = entry.expect("an entry").file_name().to_string_lossy().to_string();
        let path = format!("{folder}/{name}");
        if root.join(&path).is_dir() {
            read(root, &path, found);
        } else if name.ends_with(".rs") && name != "tests.rs" {
            found.push(Source::new(&path, &std::fs::read_to_string(root.join(&path)).expect("a text")));
        }
    }
}

impl Source {
    /// A file and its text.
    pub(crate) fn new(path: &str, text: &str) -> Self {
        let (code, mut text) = (code(text), text.to_string());
        let mut kept = code.clone();
        while let Some(start) = kept.find("#[cfg(test)]") {
            let end = start + item(&kept[start..]);
            for part in [&mut kept, &mut text] {
                let blank: String = part[start..end].chars().flat_map(blank).collect();
                part.replace_range(start..end, &blank);
            }
        }
        let inside = path.split_once('/').map_or("", |(_, inside)| inside).trim_end_matches(".rs");
        let module = inside.split('/').filter(|part| !["lib", "mod"].contains(part)).map(String::from).collect();
        Self { path: path.into(), module, text, code: kept }
    }

    /// The folder or file below the root that it belongs to.
    pub(crate) fn room(&self) -> &str {
        self.module.first().map_or("lib", String::as_str)
    }

    /// What it uses of its own crate, as paths from there, without what follows a `*` or the arguments of a type.
    pub(crate) fn paths(&self) -> Vec<Vec<String>> {
        let words = words(&self.code);
        let mut found = Vec::new();
        for at in 0..words.len() {
            let starts = ["crate", "super", "self"].contains(&words[at]) && words.get(at + 1) == Some(&"::");
            if starts && at.checked_sub(1).is_none_or(|before| words[before] != "::" && words[before] != "$") {
                tree(&words, at, &[], &mut found);
            }
        }
        found.iter().map(|path| self.absolute(path)).filter(|path| !path.is_empty()).collect()
    }

    fn absolute(&self, path: &[&str]) -> Vec<String> {
        let mut from = if path[0] == "crate" { Vec::new() } else { self.module.clone() };
        for &part in path {
            match part {
                "crate" | "self" => {}
                "super" => drop(from.pop()),
                part => from.push(part.into()),
            }
        }
        from
    }
}

/// Reads a path, or a tree of them, beginning at a word; returns the place after it.
fn tree<'a>(words: &[&'a str], mut at: usize, before: &[&'a str], found: &mut Vec<Vec<&'a str>>) -> usize {
    let mut path = before.to_vec();
    loop {
        match words.get(at).copied() {
            Some("{") => {
                at += 1;
                while words.get(at).is_some_and(|&word| word != "}") {
                    at = tree(words, at, &path, found);
                    while words.get(at).is_some_and(|&word| word != "," && word != "}") {
                        at += 1; // another name
                    }
                    at += usize::from(words.get(at) == Some(&","));
                }
                return at + 1;
            }
            Some(word) if is_name(word) => path.push(word),
            _ => break,
        }
        at += 1;
        if words.get(at) != Some(&"::") {
            break;
        }
        at += 1;
    }
    found.push(path);
    at + usize::from(words.get(at) == Some(&"*"))
}

fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// Names, pairs of colons, and single signs.
fn words(code: &str) -> Vec<&str> {
    let (mut found, mut rest) = (Vec::new(), code.trim_start());
    while let Some(first) = rest.chars().next() {
        let in_name = |c: char| c.is_alphanumeric() || c == '_';
        let length = match first {
            ':' if rest.starts_with("::") => 2,
            first if in_name(first) => rest.find(|c| !in_name(c)).unwrap_or(rest.len()),
            first => first.len_utf8(),
        };
        found.push(&rest[..length]);
        rest = rest[length..].trim_start();
    }
    found
}

/// Where an item ends that begins with an attribute.
fn item(code: &str) -> usize {
    let mut depth = 0;
    for (at, c) in code.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 1 => return at + 1,
            '}' => depth -= 1,
            ';' if depth == 0 => return at + 1,
            _ => {}
        }
    }
    code.len()
}

/// As many blanks as the character has bytes, so that places stay what they are.
fn blank(c: char) -> impl Iterator<Item = char> {
    std::iter::repeat_n(if c == '\n' { c } else { ' ' }, c.len_utf8())
}

/// A text with blanks for comments, strings and characters.
fn code(text: &str) -> String {
    let (mut out, mut rest) = (String::with_capacity(text.len()), text);
    while let Some(first) = rest.chars().next() {
        let length = comment_or_literal(rest);
        if length > 0 {
            out.extend(rest[..length].chars().flat_map(blank));
            rest = &rest[length..];
            continue;
        }
        // A name is taken whole, so that its last letter is not read as the beginning of a raw string.
        let name = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        let length = name.max(first.len_utf8());
        out.push_str(&rest[..length]);
        rest = &rest[length..];
    }
    out
}

/// The length of the comment or literal that a text begins with; 0 if it begins with neither.
fn comment_or_literal(text: &str) -> usize {
    let closed = |open: usize, close: &str| text[open..].find(close).map_or(text.len(), |at| open + at + close.len());
    if text.starts_with("//") {
        return text.find('\n').unwrap_or(text.len());
    }
    if text.starts_with("/*") {
        return closed(2, "*/");
    }
    let raw = text.trim_start_matches('b');
    if let Some(hashes) =
        raw.strip_prefix('r').and_then(|raw| raw.find('"').filter(|&at| raw[..at].bytes().all(|c| c == b'#')))
    {
        let open = text.len() - raw.len() + 2 + hashes;
        return closed(open, &format!("\"{}", "#".repeat(hashes)));
    }
    let mut chars = text.char_indices();
    match chars.next() {
        Some((_, '"')) => {
            while let Some((at, c)) = chars.next() {
                match c {
                    '\\' => drop(chars.next()),
                    '"' => return at + 1,
                    _ => {}
                }
            }
            text.len()
        }
        // A character, not a lifetime.
        Some((_, '\'')) if text.starts_with("'\\") => closed(3, "'"),
        Some((_, '\'')) => match (chars.next(), chars.next()) {
            (Some(_), Some((at, '\''))) => at + 1,
            _ => 0,
        },
        _ => 0,
    }
}
