//! The page of every report: one file that needs no other, with its style and its programs.

use super::raised::raised;
use std::fmt::Write;

/// Number of columns that fit into any page.
const MANY: usize = 4;

/// A page under construction.
pub struct Report {
    html: String,
    /// Whether a plot stands on it.
    plots: bool,
}

/// A cell of a table.
pub struct Cell {
    text: String,
    /// Where it leads.
    link: Option<String>,
}

impl Cell {
    /// A text that leads to a file beside the page.
    pub fn link(text: impl Into<String>, to: &str) -> Self {
        Self { text: text.into(), link: Some(to.into()) }
    }

    fn html(&self) -> String {
        match &self.link {
            Some(to) => anchor(&self.text, to),
            None => escaped(&self.text),
        }
    }

    /// The digits before the decimal point, and the rest, if it is a number, with or without an error and a unit.
    fn number(&self) -> Option<(&str, &str)> {
        let is_number = |word: &str| word.parse::<f64>().is_ok_and(f64::is_finite);
        let words: Vec<&str> = self.text.split(' ').collect();
        let known = match words[..] {
            [number] | [number, _] => is_number(number),
            [number, "±", error] | [number, "±", error, _] => is_number(number) && is_number(error),
            _ => false,
        };
        if self.link.is_some() || !known {
            return None;
        }
        let end = self.text.find(|c: char| !c.is_ascii_digit() && c != '-').unwrap_or(self.text.len());
        Some(self.text.split_at(end))
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self { text, link: None }
    }
}

impl Report {
    /// An empty page.
    pub fn new(title: &str) -> Self {
        let title = escaped(title);
        let style = include_str!("page.css");
        let html = format!(
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title>\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <link rel=\"icon\" href=\"data:,\">\n<style>\n{style}</style></head><body>\n<h1>{title}</h1>\n"
        );
        Self { html, plots: false }
    }

    /// What the page says, in a sentence.
    pub fn verdict(&mut self, text: &str) {
        let _ = writeln!(self.html, "<p class=\"verdict\">{}</p>", escaped(text));
    }

    /// A heading.
    pub fn heading(&mut self, text: &str) {
        let _ = writeln!(self.html, "<h2>{}</h2>", escaped(text));
    }

    /// A heading below a heading.
    pub(super) fn subheading(&mut self, text: &str) {
        let _ = writeln!(self.html, "<h3>{}</h3>", escaped(text));
    }

    /// A paragraph.
    pub fn paragraph(&mut self, text: &str) {
        let _ = writeln!(self.html, "<p>{}</p>", escaped(text));
    }

    /// A remark.
    pub fn note(&mut self, text: &str) {
        let _ = writeln!(self.html, "<p class=\"note\">{}</p>", escaped(text));
    }

    /// Lines as they would be typed.
    pub fn lines<'a>(&mut self, lines: impl IntoIterator<Item = &'a str>) {
        let lines: Vec<String> = lines.into_iter().map(escaped).collect();
        let _ = writeln!(self.html, "<pre><code>{}</code></pre>", lines.join("\n"));
    }

    /// A list of files beside the page, each with what it holds.
    pub fn files<'a>(&mut self, files: impl IntoIterator<Item = (&'a str, &'a str)>) {
        self.html.push_str("<ul>\n");
        for (name, what) in files {
            let _ = writeln!(self.html, "<li>{}: {}</li>", anchor(name, name), escaped(what));
        }
        self.html.push_str("</ul>\n");
    }

    /// A table; the decimal points of a column of numbers stand below each other.
    pub fn table<Row: IntoIterator<Item: Into<Cell>>>(&mut self, head: &[&str], rows: impl IntoIterator<Item = Row>) {
        let shown = |cell: Cell| Cell { text: raised(&cell.text), ..cell };
        let rows: Vec<Vec<Cell>> =
            rows.into_iter().map(|row| row.into_iter().map(Into::into).map(shown).collect()).collect();
        let numbers = |column: usize| {
            let written = || rows.iter().filter_map(|row| row.get(column)).filter(|cell| !cell.text.is_empty());
            2 * written().filter(|cell| cell.number().is_some()).count() > written().count()
        };
        let wide =
            (0..head.len()).map(|column| if numbers(column) { " colspan=\"2\"" } else { "" }).collect::<Vec<_>>();
        // Words of many columns are not broken: the table is moved within the page.
        let class = if head.len() > MANY { "scroll wide" } else { "scroll" };
        let _ = write!(self.html, "<div class=\"{class}\"><table>\n<tr>");
        for (name, wide) in head.iter().zip(&wide) {
            let _ = write!(self.html, "<th{wide}>{}</th>", escaped(&raised(name)));
        }
        for row in &rows {
            self.html.push_str("</tr>\n<tr>");
            for (cell, wide) in row.iter().zip(&wide) {
                let _ = match cell.number().filter(|_| !wide.is_empty()) {
                    Some((whole, rest)) => {
                        write!(
                            self.html,
                            "<td class=\"whole\">{}</td><td class=\"rest\">{}</td>",
                            whole.replace('-', "−"),
                            escaped(rest)
                        )
                    }
                    None => write!(self.html, "<td{wide}>{}</td>", cell.html()),
                };
            }
        }
        self.html.push_str("</tr>\n</table></div>\n");
    }

    /// A figure, embedded so that the page is self-contained; a plot can be read off.
    pub fn figure(&mut self, svg: &str, caption: &str) {
        let caption = escaped(caption);
        if let Some(at) = svg.find("<svg ").filter(|_| svg.contains("<metadata>")) {
            self.plots = true;
            let svg =
                svg[at..].replacen("<svg ", &format!("<svg role=\"img\" tabindex=\"0\" aria-label=\"{caption}\" "), 1);
            let _ = writeln!(self.html, "<figure class=\"plot\">{svg}<figcaption>{caption}</figcaption></figure>");
            return;
        }
        // An image element separates the identifiers of one figure from those of the next.
        let source = svg.replace('%', "%25").replace('#', "%23").replace('"', "'").replace('\n', " ");
        let _ = writeln!(
            self.html,
            "<figure><img alt=\"{caption}\" src=\"data:image/svg+xml,{source}\"><figcaption>{caption}</figcaption></figure>",
        );
    }

    /// By which program the page was made, with which commands.
    pub fn made_by(&mut self, commands: &[String]) {
        self.heading("How it was made");
        let (version, commit) = (env!("CARGO_PKG_VERSION"), env!("VERIDEM_COMMIT"));
        self.paragraph(&format!("veridem {version} (commit {commit})."));
        self.lines(commands.iter().map(String::as_str));
    }

    /// Parts in two columns where there is room for them: the second stands at the right, beside all others.
    pub(super) fn columns(&mut self, parts: [&mut dyn FnMut(&mut Self); 3]) {
        self.html.push_str("<div class=\"columns\">");
        for part in parts {
            self.html.push_str("<section>\n");
            part(self);
            self.html.push_str("</section>");
        }
        self.html.push_str("</div>\n");
    }

    /// Figures side by side where there is room for them.
    pub fn grid(&mut self, figures: impl FnOnce(&mut Self)) {
        self.side_by_side("grid", figures);
    }

    /// The same, smaller.
    pub(super) fn gallery(&mut self, figures: impl FnOnce(&mut Self)) {
        self.side_by_side("gallery", figures);
    }

    fn side_by_side(&mut self, class: &str, figures: impl FnOnce(&mut Self)) {
        let _ = writeln!(self.html, "<div class=\"{class}\">");
        figures(self);
        self.html.push_str("</div>\n");
    }

    /// What is shown on request.
    pub fn on_request(&mut self, summary: &str, content: impl FnOnce(&mut Self)) {
        let _ = writeln!(self.html, "<details><summary>{}</summary>", escaped(summary));
        content(self);
        self.html.push_str("</details>\n");
    }

    /// Markup of this house.
    pub(super) fn markup(&mut self, html: &str) {
        self.html.push_str(html);
    }

    /// The finished page.
    pub fn finish(mut self) -> String {
        if self.plots {
            let _ = writeln!(self.html, "<script>\n(() => {{\n{}}})();\n</script>", include_str!("plots.js"));
        }
        self.html.push_str("</body></html>\n");
        self.html
    }
}

fn anchor(text: &str, to: &str) -> String {
    // A name may hold what has a meaning in an address.
    let to = to.replace('%', "%25").replace('#', "%23").replace('?', "%3F");
    format!("<a href=\"{}\">{}</a>", escaped(&to), escaped(text))
}

/// A text as content or attribute of HTML and SVG.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped_and_pictures_cannot_end_their_attribute() {
        let mut report = Report::new("a < b");
        report.table(&["x [nm^2]"], [["1 & 2 m^-1".to_string()]]);
        report.figure("<svg fill=\"#fff\">\n</svg>", "one \"two\"");
        report.files([("a#1.csv", "<what>")]);
        let html = report.finish();
        assert!(html.contains("<h1>a &lt; b</h1>"));
        assert!(html.contains("<th>x [nm²]</th>") && html.contains("<td>1 &amp; 2 m⁻¹</td>"));
        assert!(html.contains("src=\"data:image/svg+xml,<svg fill='%23fff'> </svg>\""));
        assert!(html.contains("alt=\"one &quot;two&quot;\""));
        assert!(html.contains("<a href=\"a%231.csv\">a#1.csv</a>: &lt;what&gt;"));
    }

    #[test]
    fn decimal_points_stand_below_each_other() {
        let mut report = Report::new("");
        report.table(
            &["value"],
            ["-269.4 ± 1.2 nN", "3", "not reached", "1e-7", "5 nm", "6 and 8"].map(|text| [text.to_string()]),
        );
        let html = report.finish();
        for cells in [
            "<th colspan=\"2\">value</th>",
            "<td class=\"whole\">−269</td><td class=\"rest\">.4 ± 1.2 nN</td>",
            "<td class=\"whole\">3</td><td class=\"rest\"></td>",
            "<td class=\"whole\">5</td><td class=\"rest\"> nm</td>",
            "<td colspan=\"2\">6 and 8</td>",
            "<td colspan=\"2\">not reached</td>",
            "<td class=\"whole\">1</td><td class=\"rest\">e-7</td>",
        ] {
            assert!(html.contains(cells), "{cells} in {html}");
        }
    }

    #[test]
    fn a_page_needs_no_other_file() {
        let mut report = Report::new("a");
        report.figure("<svg ><metadata>{}</metadata></svg>", "plot");
        let html = report.finish();
        assert!(
            html.contains("<script>")
                && !html.contains("src=\"http")
                && !html.contains("url(http")
                && !html.contains("@import")
        );
        assert!(!Report::new("a").finish().contains("<script>"), "a page without plots has no program");
    }
}
