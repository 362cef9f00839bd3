//! Markdown and TeX as HTML.

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd, html};
use pulldown_latex::config::DisplayMode;
use pulldown_latex::mathml::push_mathml;
use pulldown_latex::{RenderConfig, Storage};

/// Text that is safe between tags and in attributes.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A formula as MathML, on a line of its own or within one.
///
/// # Panics
///
/// If the formula cannot be read; the book has all formulas, so that none remains unnoticed.
pub(super) fn math(tex: &str, is_block: bool) -> String {
    let storage = Storage::new();
    let display_mode = if is_block { DisplayMode::Block } else { DisplayMode::Inline };
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    let mut out = String::new();
    let events: Result<Vec<_>, _> = pulldown_latex::Parser::new(tex, &storage).collect();
    let events = events.unwrap_or_else(|error| panic!("`{tex}`: {error}"));
    push_mathml(&mut out, events.into_iter().map(Ok::<_, std::convert::Infallible>), config)
        .expect("a string takes all");
    out
}

/// Markdown with formulas as HTML. Links lead to documentation that is not part of the book, and are left out.
pub(super) fn markdown(text: &str) -> String {
    let events = Parser::new_ext(text, Options::ENABLE_MATH | Options::ENABLE_TABLES).filter_map(|event| match event {
        Event::InlineMath(tex) => Some(Event::InlineHtml(math(&tex, false).into())),
        Event::DisplayMath(tex) => Some(Event::Html(math(&tex, true).into())),
        Event::Start(Tag::Link { .. }) | Event::End(TagEnd::Link) => None,
        other => Some(other),
    });
    let mut out = String::new();
    html::push_html(&mut out, events);
    out
}

/// A name such as `a_force_does_no_work` as a sentence.
pub(super) fn sentence(name: &str) -> String {
    let words = name.replace('_', " ");
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| format!("{}{}.", first.to_uppercase(), letters.as_str()))
}
