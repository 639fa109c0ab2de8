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

/// Text in HTML with the indices that follow a letter lowered: `D_min` becomes `D<sub>min</sub>`.
pub(super) fn with_indices(html: &str) -> String {
    let letters: Vec<char> = html.chars().collect();
    let mut lowered = String::with_capacity(html.len());
    let mut at = 0;
    while at < letters.len() {
        let is_word = |place: usize| letters.get(place).is_some_and(|c| c.is_alphanumeric());
        let stands_alone = 0 < at && is_word(at - 1) && !(1 < at && is_word(at - 2));
        if letters[at] == '_' && stands_alone && is_word(at + 1) {
            let rest = letters[at + 1..].iter();
            let end = at + 1 + rest.take_while(|c| c.is_alphanumeric()).count();
            let index: String = letters[at + 1..end].iter().collect();
            let _ = write!(lowered, "<sub>{index}</sub>");
            at = end;
        } else {
            lowered.push(letters[at]);
            at += 1;
        }
    }
    lowered
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
    fn an_index_behind_a_letter_is_lowered_and_a_name_is_left_alone() {
        let html = with_indices("from −D_max to −D_min, t_1 of scan_line and x_");
        assert_eq!(
            html,
            "from −D<sub>max</sub> to −D<sub>min</sub>, t<sub>1</sub> of scan_line and x_"
        );
    }

    #[test]
    fn a_long_text_ends_in_dots() {
        assert_eq!(shortened("éé", 2), "éé");
        assert_eq!(shortened("ééé", 2), "éé…");
    }
}
