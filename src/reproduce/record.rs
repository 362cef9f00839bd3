//! The recorded results: the tables of the page of findings, which `tests/findings.rs` holds to the program.

/// The page.
const FINDINGS: &str = include_str!("../../docs/findings.md");

/// A row of its tables.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Where the paper makes the claim.
    pub place: String,
    /// The claim.
    pub claim: String,
    /// The paper's value.
    pub paper: String,
    /// The measured value.
    pub measured: String,
    /// The verdict, or one for each of several values.
    pub verdict: String,
    /// The chapter that measures it.
    pub chapter: String,
}

/// The recorded rows of a paper; none for a paper that the page does not know.
pub fn recorded(paper: &str) -> Vec<Row> {
    rows(claims_of(FINDINGS, paper))
}

/// What a page of findings says of the claims of a paper: its table, and what stands beside it.
pub fn claims_of<'a>(findings: &'a str, paper: &str) -> &'a str {
    let heading = format!("Claims of the {paper} paper\n");
    let part = findings.split("\n## ").find_map(|part| part.strip_prefix(&*heading)).unwrap_or_default();
    part.split("\n# ").next().unwrap_or_default()
}

/// The rows of the tables in a part of a page of findings.
pub fn rows(part: &str) -> Vec<Row> {
    part.lines().filter_map(row).filter(|row| row.chapter != "chapter").collect()
}

/// The cells of a line of a table.
fn row(line: &str) -> Option<Row> {
    let cells = line.strip_prefix("| ")?.strip_suffix(" |")?;
    let [place, claim, paper, measured, verdict, chapter] =
        cells.split(" | ").map(String::from).collect::<Vec<_>>().try_into().ok()?;
    Some(Row { place, claim, paper, measured, verdict, chapter: chapter.trim_matches('`').into() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_a_table_is_a_row_and_another_is_none() {
        let found = row("| Eq. 1 | a | 1 | 2 nm | holds | `exact` |").expect("a row");
        assert_eq!((&*found.place, &*found.measured, &*found.chapter), ("Eq. 1", "2 nm", "exact"));
        assert_eq!(row("|---|---|---|---|---|---|"), None);
        assert_eq!(row("text | a | 1 | 2 nm | holds | `exact` |"), None);
    }

    #[test]
    fn an_unknown_paper_has_no_record() {
        assert_eq!(recorded("unknown"), []);
    }
}
