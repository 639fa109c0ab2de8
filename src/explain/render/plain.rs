//! Plain text: two spaces for each level, an empty line before a paragraph.

use crate::explain::page::Page;
use crate::explain::render::{Hint, hint_of};

/// The page as plain text.
pub fn plain(page: &Page, hint: Hint) -> String {
    let mut text = String::new();
    for line in &page.lines {
        if line.gap {
            text.push('\n');
        }
        text.push_str(&"  ".repeat(line.indent));
        text.push_str(&line.text);
        text.push_str(&hint_of(line, hint));
        text.push('\n');
    }
    text
}
