//! The list of a paper's claims: the command that measures each and its recorded result, or why nothing measures it.

use super::record::{Row, recorded};

/// A claim of a paper.
pub struct Listed {
    /// Its name.
    pub id: &'static str,
    /// Where the paper makes it.
    pub place: &'static str,
    /// The claim.
    pub claim: &'static str,
    /// The paper's value.
    pub paper: &'static str,
    /// What measures it: chapters, and for each a phrase of place and claim, joined by a colon, in the rows that do.
    pub rows: &'static [(&'static str, &'static str)],
    /// What was never looked at, and why; empty if nothing was left.
    pub open: &'static str,
}

/// A line of the list.
#[derive(Debug, serde::Serialize)]
pub struct Line {
    /// The name of the claim.
    pub id: &'static str,
    /// Where the paper makes it.
    pub place: &'static str,
    /// The claim.
    pub claim: &'static str,
    /// The paper's value.
    pub paper: &'static str,
    /// The commands that measure it.
    pub commands: Vec<String>,
    /// Verdicts of the rows, and what they measured.
    pub result: String,
}

/// Longest value that is repeated in the list, in characters.
const LONGEST: usize = 90;

impl Listed {
    /// Whether a row of the record measures it.
    pub fn is_measured_by(&self, row: &Row) -> bool {
        let text = format!("{}: {}", row.place, row.claim);
        self.rows.iter().any(|(chapter, phrase)| *chapter == row.chapter && text.contains(phrase))
    }

    fn line(&self, paper: &str, record: &[Row]) -> Line {
        let mut chapters: Vec<&str> = self.rows.iter().map(|row| row.0).collect();
        chapters.dedup();
        let commands = chapters.iter().map(|chapter| format!("veridem reproduce {paper} --only {chapter}")).collect();
        let rows: Vec<&Row> = record.iter().filter(|row| self.is_measured_by(row)).collect();
        let open = |before: &str| if self.open.is_empty() { String::new() } else { format!("{before}{}", self.open) };
        let result = match rows.as_slice() {
            [] if self.rows.is_empty() => open("never measured: "),
            [] => "no recorded result".to_string() + &open(": "),
            rows => verdict(rows) + &open("; not covered: "),
        };
        Line { id: self.id, place: self.place, claim: self.claim, paper: self.paper, commands, result }
    }
}

/// How many of the verdicts of the rows are "holds", and what was measured.
fn verdict(rows: &[&Row]) -> String {
    let verdicts: Vec<&str> = rows.iter().flat_map(|row| row.verdict.split(", ")).collect();
    let held = verdicts.iter().filter(|verdict| **verdict == "holds").count();
    let sum = match (held, verdicts.len()) {
        (held, all) if held == all => "holds".into(),
        (0, _) => "DIFFERS".into(),
        (held, all) => format!("{held} of {all} hold, the others DIFFER"),
    };
    let measured: Vec<String> = rows.iter().map(|row| shortened(&row.measured)).collect();
    format!("{sum}: {}", measured.join(" / "))
}

fn shortened(text: &str) -> String {
    if text.chars().count() <= LONGEST {
        return text.into();
    }
    let start: String = text.chars().take(LONGEST).collect();
    let end = start.rfind(' ').unwrap_or(start.len());
    format!("{} ...", &start[..end])
}

/// The lines of a paper's list.
pub fn lines(paper: &str, listed: &[Listed]) -> Vec<Line> {
    let record = recorded(paper);
    listed.iter().map(|claim| claim.line(paper, &record)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLAIM: Listed = Listed {
        id: "A1",
        place: "Fig. 1",
        claim: "a claim",
        paper: "1",
        rows: &[("contact", "Fig. 1: a"), ("contact", "second")],
        open: "the rest",
    };

    fn row(place: &str, claim: &str, verdict: &str) -> Row {
        let text = |text: &str| text.to_string();
        Row {
            place: text(place),
            claim: text(claim),
            paper: text("1"),
            measured: text("2"),
            verdict: text(verdict),
            chapter: text("contact"),
        }
    }

    #[test]
    fn a_line_counts_the_verdicts_of_the_rows_that_measure_its_claim() {
        let rows = [row("Fig. 1", "a", "holds"), row("Fig. 2", "second", "DIFFERS"), row("Fig. 2", "a", "DIFFERS")];
        let line = CLAIM.line("paper", &rows);
        assert_eq!(line.result, "1 of 2 hold, the others DIFFER: 2 / 2; not covered: the rest");
        assert_eq!(line.commands, ["veridem reproduce paper --only contact"]);
        assert_eq!(CLAIM.line("paper", &[]).result, "no recorded result: the rest");
        assert_eq!(Listed { rows: &[], ..CLAIM }.line("paper", &rows).result, "never measured: the rest");
        assert!(CLAIM.line("paper", &rows[1..2]).result.starts_with("DIFFERS: 2;"));
    }

    #[test]
    fn a_long_value_ends_between_two_words() {
        assert_eq!(shortened("short"), "short");
        let long = shortened(&"word ".repeat(40));
        assert!(long.chars().count() <= LONGEST + 4 && long.ends_with("word ..."), "{long}");
    }
}
