//! Text in HTML, on one line: what is on one line stands in any list, block quote or table, and ends no block.

use std::fmt::Write;

/// Text as HTML has it. A line break becomes a reference, and a brace too, so that no other preprocessor takes a name
/// for a directive of its own.
pub(super) fn escaped(text: &str) -> String {
    let mut html = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => html.push_str("&amp;"),
            '<' => html.push_str("&lt;"),
            '>' => html.push_str("&gt;"),
            '"' => html.push_str("&quot;"),
            '\n' | '{' | '}' => {
                // writing into a String does not fail
                let _ = write!(html, "&#{};", u32::from(c));
            }
            _ => html.push(c),
        }
    }
    html
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_stays_text() {
        let name = "</svg><script>alert(1)</script> {{#include x}}\n\"";
        let html = escaped(name);
        assert!(!html.contains(['<', '>', '{', '\n', '"']), "{html}");
        assert_eq!(prose("*a*|b 1.5e-9"), "&#42;a&#42;&#124;b 1.5e-9");
    }
}
