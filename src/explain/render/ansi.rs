//! Text for a terminal: the plain text, with each tone in a style of its own.

use std::fmt::Write as _;

use anstyle::{AnsiColor, Style};

use crate::explain::page::{Page, Tone};
use crate::explain::render::{Hint, hint_of};

/// The page as text with ANSI colours.
pub fn ansi(page: &Page, hint: Hint) -> String {
    let mut text = String::new();
    for line in &page.lines {
        let (gap, indent) = (if line.gap { "\n" } else { "" }, "  ".repeat(line.indent));
        let (style, words, more) = (style(line.tone), &line.text, hint_of(line, hint));
        // writing to a String cannot fail
        let _ = writeln!(text, "{gap}{indent}{style}{words}{more}{style:#}");
    }
    text
}

fn style(tone: Tone) -> Style {
    match tone {
        Tone::Heading => Style::new().bold(),
        Tone::Plain => Style::new(),
        Tone::Found => AnsiColor::Green.on_default(),
        Tone::Refused => AnsiColor::Yellow.on_default(),
        Tone::Aside | Tone::Folded(_) => Style::new().dimmed(),
    }
}
