//! The page that a solution is written on: indented lines, and what stands out in colour.

use std::fmt::Write as _;

use anstyle::{AnsiColor, Style};

/// What a line is, apart from its words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tone {
    /// The title of a part.
    Heading,
    /// An ordinary line.
    Plain,
    /// Something was hit or found.
    Found,
    /// Something was missed or refused.
    Refused,
    /// An aside.
    Aside,
}

impl Tone {
    fn style(self) -> Style {
        match self {
            Self::Heading => Style::new().bold(),
            Self::Plain => Style::new(),
            Self::Found => AnsiColor::Green.on_default(),
            Self::Refused => AnsiColor::Yellow.on_default(),
            Self::Aside => Style::new().dimmed(),
        }
    }
}

/// Lines of text, each as deep as the ray it belongs to.
pub(super) struct Page {
    text: String,
    depth: usize,
    colour: bool,
}

impl Page {
    /// An empty page; with ANSI colours or without.
    pub(super) fn new(colour: bool) -> Self {
        Self {
            text: String::new(),
            depth: 0,
            colour,
        }
    }

    /// A line.
    pub(super) fn line(&mut self, tone: Tone, text: impl AsRef<str>) {
        let (indent, text) = ("  ".repeat(self.depth), text.as_ref());
        // writing to a String cannot fail
        let _ = if self.colour && tone != Tone::Plain {
            let style = tone.style();
            writeln!(self.text, "{indent}{style}{text}{style:#}")
        } else {
            writeln!(self.text, "{indent}{text}")
        };
    }

    /// An ordinary line.
    pub(super) fn plain(&mut self, text: impl AsRef<str>) {
        self.line(Tone::Plain, text);
    }

    /// An empty line, unless there is one already.
    pub(super) fn gap(&mut self) {
        if !self.text.is_empty() && !self.text.ends_with("\n\n") {
            self.text.push('\n');
        }
    }

    /// Everything that is written inside stands one step to the right.
    pub(super) fn indented(&mut self, write: impl FnOnce(&mut Self)) {
        self.depth += 1;
        write(self);
        self.depth -= 1;
    }

    /// Moves all that follows one step to the right; undone by [`Page::outdent`].
    pub(super) fn indent(&mut self) {
        self.depth += 1;
    }

    /// Moves all that follows one step to the left.
    pub(super) fn outdent(&mut self) {
        self.depth = self.depth.saturating_sub(1);
    }

    /// What was written.
    pub(super) fn into_text(self) -> String {
        self.text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colour_is_only_there_when_it_is_wanted() {
        for colour in [false, true] {
            let mut page = Page::new(colour);
            page.line(Tone::Found, "hit");
            assert_eq!(page.into_text().contains('\u{1b}'), colour);
        }
    }
}
