//! Inline code in which words stay whole: a browser would break `--only` behind a hyphen.

use std::ops::Range;

use pulldown_cmark::{Event, Options, Parser};

use crate::book::formula::without_marks;
use crate::explain::render::{escaped, whole_words};

/// A text as inline code.
pub(super) fn code(text: &str) -> String {
    format!("<code>{}</code>", whole_words(&escaped(text)))
}

/// The inline code of a chapter that has a word to keep whole: where it stands, and what comes in its place.
pub(super) fn inline_code(content: &str) -> Vec<(Range<usize>, String)> {
    let options = Options::ENABLE_TABLES | Options::ENABLE_GFM;
    let events = Parser::new_ext(content, options).into_offset_iter();
    let codes = events.filter_map(|(event, range)| match event {
        Event::Code(text) => Some((text, range)),
        _ => None,
    });
    let all = codes.filter_map(|(text, range)| {
        // the backslash before a directive that is shown is for mdBook
        let html = code(&text.replace("\\{{", "{{"));
        html.contains("<span")
            .then(|| (range, without_marks(&html)))
    });
    all.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inline_code_is_found_where_markdown_has_it() {
        let chapter = "`--only`, `\\{{#raystep-log x}}` and `plain`, a | b\n\n```sh\n`--not`\n```\n\n| `a \\| --b` |\n|---|\n";
        let found = inline_code(chapter);
        let texts: Vec<&str> = found.iter().map(|(at, _)| &chapter[at.clone()]).collect();
        assert_eq!(texts, ["`--only`", "`\\{{#raystep-log x}}`", "`a \\| --b`"]);
        assert!(
            found[0].1.contains("&#45;&#45;only</span></code>"),
            "{found:?}"
        );
        // no preprocessor finds a directive, no table a column
        let [_, (_, directive), (_, column)] = &found[..] else {
            panic!("{found:?}");
        };
        assert!(!directive.contains(['{', '\\']), "{directive}");
        assert!(!column.contains('|'), "{column}");
    }
}
