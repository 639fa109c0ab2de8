//! Text from outside in a message: on one line, and not too long.

/// A name as it can be printed: control characters, line breaks and marks that turn the direction of writing are shown
/// as escapes, so that a file can neither take over the terminal nor forge a message of its own.
pub fn printable(name: &str) -> String {
    let mut text = String::with_capacity(name.len());
    for c in name.chars() {
        let turns_direction = matches!(c, '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}');
        // U+2028 and U+2029 break a line or a paragraph
        if c.is_control() || turns_direction || matches!(c, '\u{2028}' | '\u{2029}') {
            text.extend(c.escape_unicode());
        } else {
            text.push(c);
        }
    }
    text
}

/// A word in quotation marks, with escapes for what a terminal would obey, and not too long.
pub(crate) fn quoted(word: &str) -> String {
    /// Longer words are cut: a line of a message holds them.
    const LONGEST: usize = 40;
    match word.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{:?}…", &word[..end]),
        None => format!("{word:?}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_cannot_control_the_terminal() {
        assert_eq!(printable("ball\u{1b}[2J"), "ball\\u{1b}[2J");
        assert_eq!(printable("a\u{202e}b"), "a\\u{202e}b");
        assert_eq!(printable("Kugel ä"), "Kugel ä");
    }

    #[test]
    fn a_name_stays_on_its_line() {
        assert_eq!(printable("a\nerror: b\r\t"), "a\\u{a}error: b\\u{d}\\u{9}");
        assert_eq!(
            printable("\u{85}\u{2028}\u{2029}"),
            "\\u{85}\\u{2028}\\u{2029}"
        );
    }

    #[test]
    fn long_words_and_control_characters_are_not_printed() {
        assert_eq!(quoted("\u{1b}[2J"), "\"\\u{1b}[2J\"");
        assert_eq!(quoted(&"é".repeat(99)), format!("\"{}\"…", "é".repeat(40)));
    }
}
