//! Text in HTML, on one line: what is on one line stands in any list, block quote or table, and ends no block.

use std::fmt::Write;

/// Text as Markdown prose has it: what could be a mark is written as a reference.
pub(super) fn prose(text: &str) -> String {
    let mut markdown = String::with_capacity(text.len());
    for c in text.chars() {
        if c.is_ascii_punctuation() && !matches!(c, '.' | ',' | '-' | '(' | ')' | '+') {
            let _ = write!(markdown, "&#{};", u32::from(c));
        } else {
            markdown.push(c);
        }
    }
    markdown
}

/// A drawing on one line.
pub(super) fn one_line(svg: &str) -> String {
    let braces = svg.trim_end().replace("{{", "{&#123;");
    braces.replace('\n', " ")
}

/// The first `longest` characters of a text, and three dots if there are more.
pub(super) fn shortened(text: &str, longest: usize) -> String {
    match text.char_indices().nth(longest) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::explain::render::escaped;

    #[test]
    fn text_stays_text() {
        let name = "</svg><script>alert(1)</script> {{#include x}}\n\"";
        let html = escaped(name);
        assert!(!html.contains(['<', '>', '{', '\n', '"']), "{html}");
        assert_eq!(prose("*a*|b 1.5e-9"), "&#42;a&#42;&#124;b 1.5e-9");
    }

    #[test]
    fn a_long_text_ends_in_dots() {
        assert_eq!(shortened("éé", 2), "éé");
        assert_eq!(shortened("ééé", 2), "éé…");
    }
}
