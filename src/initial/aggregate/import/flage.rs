//! FLAGE: `geometry_complex/data_particle/particle/position`, in units of the monomer radius.

use super::{Raw, Source};
use crate::error::Error;
use roxmltree::{Document, Node, ParsingOptions};

/// Three numbers in each `position`, with anything between them that is no number; a `radius` beside it is optional.
pub(super) fn read(source: &Source) -> Result<Raw, Error> {
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let document = Document::parse_with_options(source.text, options)
        .map_err(|trouble| source.at(trouble.pos().row as usize, &format!("is not well-formed XML: {trouble}")))?;
    let line = |node: Node| document.text_pos_at(node.range().start).row as usize;
    let mut raw = Raw { in_radii: true, ..Raw::default() };
    for particle in document.descendants().filter(|node| node.has_tag_name("particle")) {
        let child = |name| particle.children().find(|node: &Node| node.has_tag_name(name));
        let text =
            |node: Node| node.children().filter_map(|part| part.text().filter(|_| part.is_text())).collect::<String>();
        let Some(position) = child("position") else {
            return Err(source.at(line(particle), "found a `particle` without a `position`"));
        };
        let words = text(position);
        let words: Vec<&str> = words
            .split(|c: char| !c.is_ascii_digit() && !"+-.eEdD".contains(c))
            .filter(|word| word.contains(|c: char| c.is_ascii_digit()))
            .collect();
        let [x, y, z] = words[..] else {
            return Err(
                source.at(line(position), &format!("found {} numbers, expected the 3 coordinates", words.len()))
            );
        };
        raw.push(source, line(position), [x, y, z], child("radius").map(text).as_deref().map(str::trim))?;
    }
    if raw.centres.is_empty() {
        let root = document.root_element();
        return Err(source.at(line(root), &format!("found `{}` without a `particle`", root.tag_name().name())));
    }
    Ok(raw)
}
