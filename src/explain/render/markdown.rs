//! Markdown: nested lists, headings in bold, asides in italics.
//!
//! What stands in a scene file is text: each character that could be a mark, in CommonMark or in what GitHub and mdBook
//! add to it, is escaped.

use crate::explain::page::{Page, Tone};
use crate::explain::render::{Hint, hint_of};

/// The page as Markdown.
pub fn markdown(page: &Page, hint: Hint) -> String {
    let mut text = String::new();
    // the indents of the items that the line may stand in: a list has no level without an item
    let mut around: Vec<usize> = Vec::new();
    for (number, line) in page.lines.iter().enumerate() {
        while around.last().is_some_and(|&above| line.indent <= above) {
            around.pop();
        }
        if line.gap && around.is_empty() && 0 < number {
            text.push('\n');
        }
        let mark = match line.tone {
            Tone::Heading => "**",
            Tone::Aside | Tone::Folded(_) => "*",
            Tone::Plain | Tone::Found | Tone::Refused => "",
        };
        let whole = line.text.clone() + &hint_of(line, hint);
        let words = whole.trim_matches(' ');
        // blanks that mean something at the beginning, as in "  = 3": Markdown drops others
        let blanks = whole.len() - whole.trim_start_matches(' ').len();
        text.push_str(&"  ".repeat(around.len()));
        text.push_str("- ");
        text.push_str(&"\u{a0}".repeat(blanks));
        text.push_str(mark);
        text.push_str(&escaped(words));
        text.push_str(mark);
        text.push('\n');
        around.push(line.indent);
    }
    text
}

/// Text with a backslash before each character that could be a mark.
pub(crate) fn escaped(text: &str) -> String {
    let mut markdown = String::with_capacity(text.len());
    let mut before = None;
    let mut all_digits = true;
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        let after = rest.peek().copied();
        let starts = before.is_none();
        let is_mark = match c {
            '\\' | '`' | '*' | '_' | '{' | '}' | '[' | ']' | '<' | '>' | '#' | '&' | '~' | '|'
            | '$' | '^' | '@' => true,
            // a bullet, a line under a heading
            '+' | '=' => starts,
            // the same, and two of them a dash
            '-' => starts || before == Some('-') || after == Some('-'),
            // a number of a list, "www.", three of them an ellipsis
            '.' | ')' => all_digits || before == Some('w') || after == Some('.'),
            // "https://", ":smile:"
            ':' => starts || after.is_some_and(|after| after != ' '),
            _ => false,
        };
        if is_mark {
            markdown.push('\\');
        }
        markdown.push(c);
        all_digits &= c.is_ascii_digit();
        before = Some(c);
    }
    markdown
}
