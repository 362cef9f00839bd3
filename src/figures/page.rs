//! The report page: a table of results and the figures.

use std::fmt::Write;

/// A page under construction.
pub struct Report {
    html: String,
}

impl Report {
    /// An empty page.
    pub fn new(title: &str) -> Self {
        let title = escaped(title);
        let html = format!(
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title>\n<style>\n\
             body {{ font: 16px/1.45 sans-serif; max-width: 72em; margin: 2em auto; padding: 0 1em; color: #222 }}\n\
             table {{ border-collapse: collapse; margin: 1em 0 }}\n\
             th, td {{ text-align: left; padding: .3em .8em; border-bottom: 1px solid #ddd; vertical-align: top }}\n\
             figure {{ display: inline-block; margin: .5em; vertical-align: top }} figcaption {{ font-size: 85%; max-width: 640px }}\n\
             </style></head><body>\n<h1>{title}</h1>\n"
        );
        Self { html }
    }

    /// A heading.
    pub fn heading(&mut self, text: &str) {
        let _ = writeln!(self.html, "<h2>{}</h2>", escaped(text));
    }

    /// A paragraph.
    pub fn paragraph(&mut self, text: &str) {
        let _ = writeln!(self.html, "<p>{}</p>", escaped(text));
    }

    /// A table.
    pub fn table<Row: AsRef<[String]>>(&mut self, head: &[&str], rows: &[Row]) {
        let line = |tag: &str, cells: &mut dyn Iterator<Item = &str>| {
            let cells: String = cells.map(|cell| format!("<{tag}>{}</{tag}>", escaped(cell))).collect();
            format!("<tr>{cells}</tr>\n")
        };
        self.html.push_str("<table>\n");
        self.html.push_str(&line("th", &mut head.iter().copied()));
        for row in rows {
            self.html.push_str(&line("td", &mut row.as_ref().iter().map(String::as_str)));
        }
        self.html.push_str("</table>\n");
    }

    /// A figure, embedded so that the page is self-contained.
    pub fn figure(&mut self, svg: &str, caption: &str) {
        // An image element separates the identifiers of one figure from those of the next.
        let source = svg.replace('%', "%25").replace('#', "%23").replace('"', "'").replace('\n', " ");
        let _ = writeln!(
            self.html,
            "<figure><img alt=\"{0}\" src=\"data:image/svg+xml,{source}\"><figcaption>{0}</figcaption></figure>",
            escaped(caption)
        );
    }

    /// The finished page.
    pub fn finish(mut self) -> String {
        self.html.push_str("</body></html>\n");
        self.html
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped_and_pictures_cannot_end_their_attribute() {
        let mut report = Report::new("a < b");
        report.table(&["x"], &[["1 & 2".to_string()]]);
        report.figure("<svg fill=\"#fff\">\n</svg>", "one \"two\"");
        let html = report.finish();
        assert!(html.contains("<h1>a &lt; b</h1>"));
        assert!(html.contains("<td>1 &amp; 2</td>"));
        assert!(html.contains("src=\"data:image/svg+xml,<svg fill='%23fff'> </svg>\""));
        assert!(html.contains("alt=\"one &quot;two&quot;\""));
    }
}
