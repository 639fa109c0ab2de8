//! Data inside a page, as JSON in a `<script type="application/json">`.

use std::io;

use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::Formatter;

/// The data as JSON on one line, in which every text stays text, whatever is made of the page: what could end the script,
/// begin a directive of a book or a formula, or is no letter of ASCII's own signs, is written as an escape.
pub(super) fn inline_json(data: &impl Serialize) -> String {
    let mut json = Vec::new();
    let mut serializer = Serializer::with_formatter(&mut json, Inline);
    // writing into memory does not fail, and no key of the data is anything but a text
    let written = data.serialize(&mut serializer);
    debug_assert!(written.is_ok(), "{written:?}");
    String::from_utf8(json).unwrap_or_default()
}

struct Inline;

impl Formatter for Inline {
    fn write_string_fragment<W: ?Sized + io::Write>(
        &mut self,
        out: &mut W,
        fragment: &str,
    ) -> io::Result<()> {
        for c in fragment.chars() {
            match c {
                '<' | '>' | '&' | '{' | '}' | '$' | '`' | '\u{2028}' | '\u{2029}' => {
                    write!(out, "\\u{:04x}", u32::from(c))?;
                }
                _ => write!(out, "{c}")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_ends_no_script_and_begins_no_directive_and_is_read_back_as_it_was() {
        let text = "</script><!-- {{#include x}} $x$ `a` \\( \u{2028} \" \n ✓";
        let json = inline_json(&[text]);
        assert!(
            !json.contains(['<', '>', '{', '$', '`', '\n', '\u{2028}']),
            "{json}"
        );
        assert_eq!(serde_json::from_str::<[String; 1]>(&json).unwrap(), [text]);
    }
}
