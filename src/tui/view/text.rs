//! Words in lines that fit.

use ratatui::text::{Line, Span};

use crate::explain::{Line as Words, Tone};
use crate::figure::Colour;
use crate::tui::look::Look;
use ratatui::style::Style;

/// How many columns a text fills.
pub(super) fn width(text: &str) -> usize {
    Span::raw(text).width()
}

/// The text as far as it fits, with … in place of the rest.
pub(super) fn cut(text: &str, room: usize) -> String {
    if width(text) <= room {
        return text.into();
    }
    let mut short = String::new();
    for letter in text.chars() {
        short.push(letter);
        if room < width(&short) + 1 {
            short.pop();
            break;
        }
    }
    if 0 < room {
        short.push('…');
    }
    short
}

/// The text in lines that are no wider than that, broken at blanks; all but the first are indented. A word that is wider than a
/// line is broken anywhere.
pub(super) fn wrapped(text: &str, room: usize, indent: usize) -> Vec<String> {
    let indent = if room <= 2 * indent { 0 } else { indent };
    let mut lines: Vec<String> = Vec::new();
    let mut line = String::new();
    let mut is_empty = true;
    for word in text.split(' ') {
        let apart = usize::from(!is_empty);
        if !is_empty && room < width(&line) + apart + width(word) {
            lines.push(std::mem::replace(&mut line, " ".repeat(indent)));
            is_empty = true;
        }
        if !is_empty {
            line.push(' ');
        }
        for letter in word.chars() {
            let more = width(letter.encode_utf8(&mut [0; 4]));
            if room < width(&line) + more && room != 0 {
                lines.push(std::mem::replace(&mut line, " ".repeat(indent)));
            }
            line.push(letter);
        }
        is_empty = false;
    }
    lines.push(line);
    lines
}

/// The lines of a page in a column; what of a line is wrapped is indented.
pub(super) fn page(lines: &[Words], look: Look, room: usize, hanging: usize) -> Vec<Line<'static>> {
    let mut shown = Vec::new();
    for line in lines {
        if line.gap && !shown.is_empty() {
            shown.push(Line::default());
        }
        let indent = (2 * line.indent).min(room / 3);
        let style = tone(line.tone, look);
        let texts = wrapped(&line.text, room.saturating_sub(indent), hanging);
        shown.extend(
            texts
                .into_iter()
                .map(|text| Line::styled(format!("{}{text}", " ".repeat(indent)), style)),
        );
    }
    shown
}

fn tone(tone: Tone, look: Look) -> Style {
    match tone {
        Tone::Heading => Look::strong(),
        Tone::Plain => Style::new(),
        Tone::Found => Style::new().fg(look.figure(Colour::Answer)),
        Tone::Refused => Style::new().fg(look.figure(Colour::Rejected)),
        Tone::Aside | Tone::Folded(_) => Look::faint(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_broken_at_blanks_and_long_words_anywhere() {
        assert_eq!(wrapped("a bc def", 4, 0), ["a bc", "def"]);
        assert_eq!(wrapped("a bc def", 6, 2), ["a bc", "  def"]);
        assert_eq!(wrapped("abcdefgh", 3, 0), ["abc", "def", "gh"]);
        assert_eq!(wrapped("", 3, 0), [""]);
        assert_eq!(wrapped("a b", 0, 2), ["a", "b"]);
        for room in 1..12 {
            let text = "  ∞ = −1.5 · (x, y) and a_very_long_name";
            let lines = wrapped(text, room, 2);
            assert!(lines.iter().all(|line| width(line) <= room), "{lines:?}");
            let words: String = lines.concat().split_whitespace().collect();
            assert_eq!(words, text.split_whitespace().collect::<String>());
        }
    }

    #[test]
    fn a_text_that_is_cut_says_so() {
        assert_eq!(cut("abcdef", 6), "abcdef");
        assert_eq!(cut("abcdef", 4), "abc…");
        assert_eq!([cut("abcdef", 1), cut("abcdef", 0)], ["…", ""]);
    }
}
