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

#[cfg(test)]
mod tests {
    use super::super::{Options, parse};
    use crate::interrupt::Interrupt;
    use std::path::Path;

    fn read(particles: &str) -> Result<Vec<([f64; 3], f64)>, String> {
        let options = Options { unit: Some(2.0), disconnected: true, ..Options::default() };
        let text = format!("<g>\n{particles}\n</g>");
        let found =
            parse(Path::new("a.xml"), text, &options, &Interrupt::default()).map_err(|error| error.to_string())?;
        Ok(found.spheres.iter().map(|sphere| (sphere.centre.0, sphere.radius)).collect())
    }

    #[test]
    fn a_particle_has_a_position_and_may_have_a_radius() {
        let position = "<position>(1d0; -2.5E-1 | +3.)</position>";
        let sphere = [2.0, -0.5, 6.0];
        assert_eq!(read(&format!("<particle>{position}</particle>")), Ok(vec![(sphere, 2.0)]));
        assert_eq!(
            read(&format!("<a><particle><radius> 3 </radius>{position}</particle></a>")),
            Ok(vec![(sphere, 6.0)])
        );
        for (particles, expected) in [
            ("<particle/>", "2: found a `particle` without a `position`"),
            ("\n<particle>\n<position>1 2</position></particle>", "4: found 2 numbers, expected the 3 coordinates"),
            ("<particle><position>1 2 3 4</position></particle>", "2: found 4 numbers, expected the 3 coordinates"),
            ("<particle><position>1 e 2 3.3.3</position></particle>", "2: found `3.3.3`, expected a number"),
            (
                "<particle><position>1 2 3</position><radius>0</radius></particle>",
                "2: found a radius of `0`, expected one above 0",
            ),
            ("<part/>", "1: found `g` without a `particle`"),
        ] {
            assert_eq!(read(particles), Err(format!("a.xml:{expected}")), "{particles}");
        }
        assert!(read("<particle>").unwrap_err().starts_with("a.xml:3: is not well-formed XML: "));
    }
}
