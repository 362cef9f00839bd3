//! What stands above a procedure: the equation, its paper, the table of its arguments and results.

use super::procedure::{Procedure, Value};
use super::{Exported, Row};

/// Longest line of a comment.
const WIDTH: usize = 110;

/// The comment of a procedure; lines without marks.
pub(super) fn comment(exported: &Exported, procedure: &Procedure) -> String {
    let table = |values: &[Value], rows: &[Row], mark: &str| -> Vec<[String; 4]> {
        let cells = |(value, row): (&Value, &Row)| {
            let unit = if row.size == 1 { row.unit.clone() } else { format!("{} ({})", row.unit, row.size) };
            [format!("{mark}{}", value.name), unit, row.domain.clone(), row.meaning.clone()]
        };
        values.iter().zip(rows).map(cells).collect()
    };
    let rows =
        [table(&procedure.arguments, &exported.arguments, ""), table(&procedure.results, &exported.results, "-> ")]
            .concat();
    let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
    let (names, units, domains) = (width(0), width(1), width(2));
    let line = |[name, unit, domain, meaning]: &[String; 4]| {
        format!("\n  {name:names$}  {unit:units$}  {domain:domains$}  {meaning}")
    };
    rows.iter().fold(exported.title.clone(), |text, row| text + &line(row))
}

/// The lines of a text, broken at spaces, each behind a mark.
pub(super) fn wrapped(text: &str, mark: &str) -> String {
    let mut out = vec![];
    for line in text.lines() {
        if line.chars().count() <= WIDTH || line.starts_with(' ') {
            out.push(line.to_string());
            continue;
        }
        let mut now = String::new();
        for word in line.split(' ') {
            if now.chars().count() + word.chars().count() >= WIDTH {
                out.push(std::mem::take(&mut now));
            }
            if !now.is_empty() {
                now.push(' ');
            }
            now.push_str(word);
        }
        out.push(now);
    }
    out.iter().map(|line| format!("{mark} {line}").trim_end().to_string() + "\n").collect()
}
