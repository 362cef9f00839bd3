//! Markdown and TeX as HTML.

use maud::{Markup, PreEscaped};
use pulldown_cmark::{BrokenLink, CowStr, Event, Options, Parser, Tag, TagEnd, html};
use pulldown_latex::config::DisplayMode;
use pulldown_latex::mathml::push_mathml;
use pulldown_latex::{RenderConfig, Storage};

/// A formula as MathML, on a line of its own or within one.
///
/// # Panics
///
/// If the formula cannot be read; the book has all formulas, so that none remains unnoticed.
pub(super) fn math(tex: &str, is_block: bool) -> Markup {
    let storage = Storage::new();
    let display_mode = if is_block { DisplayMode::Block } else { DisplayMode::Inline };
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    let mut out = String::new();
    let events: Result<Vec<_>, _> = pulldown_latex::Parser::new(tex, &storage).collect();
    let events = events.unwrap_or_else(|error| panic!("`{tex}`: {error}"));
    push_mathml(&mut out, events.into_iter().map(Ok::<_, std::convert::Infallible>), config)
        .expect("a string takes all");
    PreEscaped(out)
}

/// Markdown with formulas as HTML. `page` is where the target of a link is in the book; other links lead to what is not part of it, and are left out.
pub(super) fn markdown(text: &str, page: &dyn Fn(&str) -> Option<String>) -> Markup {
    // Documentation may link to a name without saying where it is.
    let named = |link: BrokenLink| Some((link.reference.trim_matches('`').to_string().into(), CowStr::from("")));
    let options = Options::ENABLE_MATH | Options::ENABLE_TABLES;
    let mut kept = vec![];
    let tag = |text: &'static str| Event::Html(text.into());
    let events = Parser::new_with_broken_link_callback(text, options, Some(named)).flat_map(|event| match event {
        Event::InlineMath(tex) => vec![Event::InlineHtml(math(&tex, false).into_string().into())],
        Event::DisplayMath(tex) => vec![Event::Html(math(&tex, true).into_string().into())],
        Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
            let found = page(&dest_url);
            kept.push(found.is_some());
            found
                .map(|url| Event::Start(Tag::Link { link_type, dest_url: url.into(), title, id }))
                .into_iter()
                .collect()
        }
        Event::End(TagEnd::Link) if !kept.pop().unwrap_or_default() => vec![],
        Event::Start(Tag::Table(_)) => vec![tag("<div class=\"wide\">"), event],
        Event::End(TagEnd::Table) => vec![event, tag("</div>")],
        other => vec![other],
    });
    let mut out = String::new();
    html::push_html(&mut out, events);
    PreEscaped(out)
}

/// Markdown of one paragraph, without the tags around it.
pub(super) fn inline(text: &str, page: &dyn Fn(&str) -> Option<String>) -> Markup {
    let PreEscaped(out) = markdown(text, page);
    PreEscaped(out.trim().trim_start_matches("<p>").trim_end_matches("</p>").to_string())
}

/// Markdown that begins in small letters, as after a colon.
pub(super) fn after_colon(text: &str, page: &dyn Fn(&str) -> Option<String>) -> Markup {
    markdown(&capitalised(text), page)
}

/// Markdown as plain text.
pub(super) fn plain(markdown: &str) -> String {
    markdown.replace("**", "").replace(['`', '$'], "").replace('\n', " ")
}

/// A text with a capital letter at its beginning.
pub(super) fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// A name such as `a_force_does_no_work` as a sentence.
pub(super) fn sentence(name: &str) -> String {
    format!("{}.", capitalised(&name.replace('_', " ")))
}
