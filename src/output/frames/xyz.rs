//! Frames as extended XYZ files, which OVITO and ASE open, and their pairs as the local dumps of LAMMPS, which OVITO loads as bonds.

use super::{Frame, FrameColumn, Values};
use std::fmt::Write;

impl Frame<'_> {
    /// All particles in the order of their ids, folded into the box. Their species is `X`, which stands for no element. Units: nm, ns, ag, hence pN and MPa.
    pub(super) fn extended_xyz(&self) -> String {
        let domain = &self.system.domain;
        let [a, b, c] = domain.sides;
        let periodic = domain.periodic.map(|yes| if yes { "T" } else { "F" }).join(" ");
        let property = |FrameColumn { name, values }: &FrameColumn| {
            let kind = if matches!(values, Values::Counts(_)) { 'I' } else { 'R' };
            format!(":{name}:{kind}:{}", values.width())
        };
        let mut text = format!(
            "{}\nLattice=\"{a} 0 0 0 {b} 0 0 0 {c}\" Origin=\"0 0 0\" pbc=\"{periodic}\" Time={} step={} stage={} \
             Properties=species:S:1{}\n",
            self.ids().len(),
            self.system.time,
            self.system.step,
            quoted(self.stage),
            self.columns.iter().map(property).collect::<String>(),
        );
        for k in 0..self.ids().len() {
            text.push('X');
            for FrameColumn { values, .. } in &self.columns {
                for number in values.of(k).into_iter().take(values.width()) {
                    text.push(' ');
                    text.push_str(&if matches!(values, Values::Counts(_)) {
                        number.to_string()
                    } else {
                        self.text(number)
                    });
                }
            }
            text.push('\n');
        }
        text
    }

    /// All pairs in the order of their ids, as a local dump of LAMMPS. Their type is 1 for a contact, 2 for a neck, 3 for a meniscus. Units: nm, pN, zJ.
    pub(super) fn bonds(&self) -> String {
        let domain = &self.system.domain;
        let bounds = domain.periodic.map(|yes| if yes { "pp" } else { "ff" }).join(" ");
        let mut text = format!("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ENTRIES\n{}\n", self.system.step, self.pairs.len());
        let _ = writeln!(text, "ITEM: BOX BOUNDS {bounds}");
        for side in domain.sides {
            let _ = writeln!(text, "0 {side}");
        }
        let _ = writeln!(text, "ITEM: ENTRIES batom1 batom2 btype {}", self.numbers_of_pairs().join(" "));
        for pair in &self.pairs {
            let [i, j] = pair.ids;
            let _ = write!(text, "{i} {j} {}", pair.kind as u8);
            for number in self.numbers(pair) {
                text.push(' ');
                text.push_str(&self.text(number));
            }
            text.push('\n');
        }
        text
    }
}

/// A value of a comment, in quotes if it holds more than letters, digits and signs.
fn quoted(value: &str) -> String {
    let plain = !value.is_empty() && value.chars().all(|c| c.is_alphanumeric() || "_-.+".contains(c));
    if plain { value.into() } else { format!("\"{}\"", value.replace(['"', '\\'], "'")) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::initial::aggregate::import::OF_FRAMES;
    use crate::output::frames::FRAME_COLUMNS;

    #[test]
    fn import_knows_every_column_of_a_frame() {
        const READ: [&str; 6] = ["id", "body", "radius", "pos", "velo", "angular_velocity"];
        let known = |name: &&str| READ.contains(name) || OF_FRAMES.contains(name);
        assert!(FRAME_COLUMNS.iter().map(|column| column.name).all(|name| known(&name)));
        assert_eq!(FRAME_COLUMNS.len(), READ.len() + OF_FRAMES.len());
    }

    #[test]
    fn a_stage_of_two_words_is_quoted() {
        assert_eq!([quoted("restructuring 2"), quoted("shear")], ["\"restructuring 2\"", "shear"]);
        assert_eq!(quoted("a \"b\""), "\"a 'b'\"");
    }
}
