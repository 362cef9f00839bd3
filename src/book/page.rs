//! The pages.

use super::text::{escaped, markdown, math, sentence};
use super::{Chapter, Entry, curve};
use crate::spec::document::Quantity;
use crate::spec::languages::graph;
use crate::spec::languages::mathematics::{Computed, Formula, computed};

/// The name of an equation's page.
pub(super) fn file(id: &str) -> String {
    format!("{id}.html")
}

/// The numbers of an equation, as a paper prints them, or its name.
fn label(entry: &Entry) -> String {
    let printed = |number: &&str| number.replace('A', "A.");
    match entry.equation.covers {
        [] => entry.equation.id.split_once('-').map_or(entry.equation.id, |(_, name)| name).replace('-', " "),
        [number] => format!("Eq. {}", printed(number)),
        numbers => format!("Eqs. {}", numbers.iter().map(printed).collect::<Vec<_>>().join(", ")),
    }
}

fn plain(markdown: &str) -> String {
    markdown.replace("**", "").replace(['`', '$'], "").replace('\n', " ")
}

fn chapter_title(chapter: &Chapter) -> String {
    if chapter.reference.is_empty() { "Mechanics that the papers share".into() } else { chapter.reference.into() }
}

/// What the search looks through.
pub(super) fn entries(chapters: &[Chapter]) -> String {
    let of = |chapter: &Chapter| -> Vec<serde_json::Value> {
        let entry = |entry: &Entry| {
            serde_json::json!({ "id": entry.equation.id, "numbers": entry.equation.covers, "label": label(entry),
                                "paper": chapter_title(chapter), "title": plain(&entry.document.title) })
        };
        chapter.entries.iter().map(entry).collect()
    };
    let all: Vec<serde_json::Value> = chapters.iter().flat_map(of).collect();
    format!("const ENTRIES = {};\n", serde_json::Value::from(all))
}

fn whole(title: &str, body: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{}</title><link rel=\"icon\" href=\"data:,\"><link rel=\"stylesheet\" href=\"book.css\"><script src=\"entries.js\"></script><script src=\"book.js\"></script></head>\n\
         <body><header><a href=\"index.html\">veridem</a><div class=\"search\"><input type=\"search\" placeholder=\"Number or word\" aria-label=\"Search\"><ul></ul></div></header>\n\
         <main>{body}</main></body></html>\n",
        escaped(title)
    )
}

/// The table of contents.
pub(super) fn contents(chapters: &[Chapter]) -> String {
    let chapter = |chapter: &Chapter| {
        let row = |entry: &Entry| {
            let id = entry.equation.id;
            format!(
                "<tr><td><a href=\"{}\">{}</a></td><td>{}</td></tr>\n",
                file(id),
                escaped(&label(entry)),
                escaped(&plain(&entry.document.title))
            )
        };
        let rows: String = chapter.entries.iter().map(row).collect();
        format!("<h2 id=\"{}\">{}</h2>\n<table>{rows}</table>\n", chapter.name, escaped(&chapter_title(chapter)))
    };
    let body: String = chapters.iter().map(chapter).collect();
    whole("veridem: the equations", &format!("<h1>The equations</h1>\n{body}"))
}

/// The page of an equation, between its neighbours.
pub(super) fn equation(chapter: &Chapter, entry: &Entry, neighbours: [Option<&Entry>; 2]) -> String {
    let (equation, document) = (entry.equation, entry.document);
    let laws: String = document.laws.iter().map(|law| format!("<li>{}</li>\n", escaped(&sentence(law)))).collect();
    let rounding =
        document.rounding.map_or("Not stated.".into(), |bound| format!("At most {bound} units in the last place."));
    let used = match &entry.users[..] {
        [] => "<p>By nothing else: it is here because the paper has it.</p>".to_string(),
        users => format!(
            "<ul>{}</ul>",
            users.iter().map(|user| format!("<li><code>{}</code></li>", escaped(user))).collect::<String>()
        ),
    };
    let reading =
        if document.reading.is_empty() { String::new() } else { section("Reading", &markdown(&document.reading)) };
    let body = [
        format!(
            "<h1>{}</h1>\n<p class=\"note\">{} · {}</p>\n",
            escaped(&label(entry)),
            escaped(&chapter_title(chapter)),
            equation.id
        ),
        markdown(&document.title),
        section("As printed", &format!("<div class=\"formula\">{}</div>", math(&document.formula, true))),
        section("As computed", &as_computed(entry)),
        reading,
        section("Arguments", &table(&document.arguments)),
        section("Results", &table(&document.results)),
        curve::section(entry),
        section("Laws", &format!("<ul>{laws}</ul>")),
        section("Rounding", &format!("<p>{rounding}</p>")),
        section(
            "Independent values",
            &format!(
                "<p>{} vectors in <code>golden/</code> were computed independently of this code.</p>",
                entry.independent
            ),
        ),
        section("Used in", &used),
        section("Source", &format!("<p><code>{}</code> in <code>spec/{}</code></p>", equation.function, equation.file)),
        turning(neighbours),
    ];
    whole(&format!("{}, {}", label(entry), chapter_title(chapter)), &body.concat())
}

fn section(title: &str, body: &str) -> String {
    format!("<section><h2>{title}</h2>\n{body}</section>\n")
}

/// Most lines of a computed form on a page.
const MOST_LINES: usize = 40;

fn as_computed(entry: &Entry) -> String {
    let graph = graph(entry.equation);
    let Computed { parts, results } = computed(&graph, entry.document);
    if parts.len() + results.len() > MOST_LINES {
        let (id, steps) = (entry.equation.id, graph.nodes.len());
        return format!("<p>In {steps} steps, which <code>veridem eq export --language c {id}</code> writes.</p>");
    }
    let line = |Formula { symbol, formula }: &Formula| {
        format!("<div class=\"formula\">{}</div>", math(&format!("{symbol} = {formula}"), true))
    };
    parts.iter().chain(&results).map(line).collect()
}

fn table(quantities: &[Quantity]) -> String {
    let row = |q: &Quantity| {
        let unit = if q.size == 1 { q.unit.clone() } else { format!("{} ({})", q.unit, q.size) };
        format!(
            "<tr><td>{}</td><td><code>{}</code></td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            math(&q.symbol, false),
            q.name,
            escaped(&unit),
            escaped(&q.domain.to_string()),
            markdown(&q.meaning).trim().trim_start_matches("<p>").trim_end_matches("</p>")
        )
    };
    let rows: String = quantities.iter().map(row).collect();
    format!(
        "<div class=\"wide\"><table><thead><tr><th>symbol</th><th>name</th><th>unit</th><th>domain</th><th>meaning</th></tr></thead><tbody>{rows}</tbody></table></div>"
    )
}

fn turning([before, after]: [Option<&Entry>; 2]) -> String {
    let link = |entry: Option<&Entry>, mark: &str| {
        entry.map_or(String::new(), |entry| {
            format!("<a rel=\"{mark}\" href=\"{}\">{}</a>", file(entry.equation.id), escaped(&label(entry)))
        })
    };
    format!("<nav><span>{}</span><span>{}</span></nav>", link(before, "prev"), link(after, "next"))
}
