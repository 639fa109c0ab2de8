//! Where a chapter asks for something: `{{#raystep 12-grid/walk}}` and its like.
//!
//! What stands in code, between backticks or in a block, is shown as it is, and so is a directive after a backslash.
//! In a comment nothing is followed.

use std::ops::Range;

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

/// What a directive asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Asks {
    /// `{{#raystep NAME}}`: the figure.
    Figure,
    /// `{{#raystep-log NAME}}`: the worked solution of its pixel.
    Log,
    /// `{{#raystep-value NAME PATH}}`: a number.
    Value,
    /// `{{#raystep-compare NAME}}`: what each strategy costs.
    Compare,
}

impl Asks {
    pub(super) const ALL: [Self; 4] = [Self::Figure, Self::Log, Self::Value, Self::Compare];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Figure => "raystep",
            Self::Log => "raystep-log",
            Self::Value => "raystep-value",
            Self::Compare => "raystep-compare",
        }
    }
}

/// A directive in a chapter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Directive {
    /// Where it stands, in bytes.
    pub(super) range: Range<usize>,
    /// Its line, counted from 1.
    pub(super) line: usize,
    /// Its first word, without the `#`.
    pub(super) word: String,
    /// The words after it.
    pub(super) words: Vec<String>,
    /// Does it end on its line, with `}}`?
    pub(super) ends: bool,
    /// What is to follow a block in its place; `None` if other text is on the line.
    pub(super) alone: Option<String>,
}

/// All directives of a chapter, in order.
pub(super) fn directives(content: &str) -> Vec<Directive> {
    const NAME: &str = "#raystep";
    let mut untouched = code(content);
    untouched.extend(comments(content, &untouched));
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(name) = content[at..].find(NAME).map(|offset| at + offset) {
        at = name + NAME.len();
        // as mdBook's own, {{ #raystep … }} may have spaces
        let Some(before) = content[..name]
            .trim_end_matches([' ', '\t'])
            .strip_suffix("{{")
        else {
            continue;
        };
        let start = before.len();
        let is_untouched = untouched.iter().any(|range| range.contains(&start));
        if is_untouched || before.ends_with('\\') {
            continue;
        }
        let line_end = content[start..]
            .find('\n')
            .map_or(content.len(), |end| start + end);
        // a directive ends on its line
        let end = content[name..line_end].find("}}").map(|end| name + end + 2);
        let line = content[..start].matches('\n').count() + 1;
        let range = start..end.unwrap_or(line_end);
        let inner = content[name + 1..range.end].trim_end_matches('}');
        let mut words = inner.split_whitespace().map(String::from);
        found.push(Directive {
            line,
            word: words.next().unwrap_or_default(),
            words: words.collect(),
            ends: end.is_some(),
            alone: alone(content, &range),
            range,
        });
    }
    found
}

/// Where comments stand, from `<!--` to `-->`, outside of code.
fn comments(content: &str, code: &[Range<usize>]) -> Vec<Range<usize>> {
    let mut found: Vec<Range<usize>> = Vec::new();
    for (start, _) in content.match_indices("<!--") {
        let inside = |range: &Range<usize>| range.contains(&start);
        if code.iter().any(inside) || found.iter().any(inside) {
            continue;
        }
        let end = content[start..]
            .find("-->")
            .map_or(content.len(), |end| start + end);
        found.push(start..end);
    }
    found
}

/// Where code stands: blocks, fenced or indented, and pieces between backticks.
fn code(content: &str) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut block = 0;
    let options = Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES;
    for (event, range) in Parser::new_ext(content, options).into_offset_iter() {
        match event {
            Event::Code(_) => found.push(range),
            Event::Start(Tag::CodeBlock(_)) => block = range.start,
            Event::End(TagEnd::CodeBlock) => found.push(block..range.end),
            _ => {}
        }
    }
    found
}

/// What follows a block that takes the place of the directive, if that is all that its line has: the empty line that
/// ends the block where the text goes on in the same lists and block quotes.
fn alone(content: &str, range: &Range<usize>) -> Option<String> {
    let line_start = content[..range.start].rfind('\n').map_or(0, |end| end + 1);
    let before = &content[line_start..range.start];
    let mut lines = content[range.end..].split('\n');
    let after = lines.next().unwrap_or_default();
    if !after.trim().is_empty() || !is_container(before) {
        return None;
    }
    // a block quote is marked on every line, a list by its indentation alone
    let goes_on = before.chars().map(|c| if c == '>' { '>' } else { ' ' });
    let goes_on: String = goes_on.collect();
    let marked = if goes_on.contains('>') {
        goes_on.trim_end()
    } else {
        &goes_on
    };
    let next = lines.next().unwrap_or_default();
    let is_same = next.starts_with(marked) && !next[marked.len()..].trim().is_empty();
    Some(if is_same {
        format!("\n{}", goes_on.trim_end())
    } else {
        String::new()
    })
}

/// Is this nothing but the marks of block quotes and list items?
fn is_container(before: &str) -> bool {
    before.split_whitespace().all(|word| {
        let quotes = word.chars().all(|c| c == '>');
        let number = word.strip_suffix(['.', ')']);
        let is_number = number
            .is_some_and(|digits| !digits.is_empty() && digits.chars().all(|c| c.is_ascii_digit()));
        quotes || is_number || matches!(word, "-" | "*" | "+")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(content: &str) -> Vec<(usize, String, Vec<String>, Option<String>)> {
        let directives = directives(content).into_iter();
        directives
            .map(|of| (of.line, of.word, of.words, of.alone))
            .collect()
    }

    #[test]
    fn a_directive_has_its_line_and_its_words() {
        let content = "# Grid\n\n{{#raystep 12-grid/walk}}\n\nIt visits {{#raystep-value 12-grid/walk cell.count}} cells.\n";
        let [figure, value] = &found(content)[..] else {
            panic!("{content}");
        };
        assert_eq!(figure.0, 3);
        assert_eq!(
            (figure.1.as_str(), figure.2.as_slice()),
            ("raystep", &["12-grid/walk".to_owned()][..])
        );
        assert_eq!(figure.3.as_deref(), Some(""));
        assert_eq!(
            (value.0, value.1.as_str(), value.3.as_deref()),
            (5, "raystep-value", None)
        );
        assert_eq!(value.2, ["12-grid/walk", "cell.count"]);
    }

    #[test]
    fn code_and_what_follows_a_backslash_stay_as_they_are() {
        for content in [
            "`{{#raystep a/b}}`",
            "```\n{{#raystep a/b}}\n```",
            "text\n\n    {{#raystep a/b}}\n",
            "> ```text\n> {{#raystep a/b}}\n> ```",
            "\\{{#raystep a/b}}",
            "<!-- {{#raystep a/b}} -->",
            "<!--\n{{#raystep a/b}}\n-->",
            "{{#include a/b}}",
        ] {
            assert_eq!(found(content), [], "{content}");
        }
    }

    #[test]
    fn a_block_is_ended_where_its_list_or_quote_goes_on_and_only_there() {
        for (content, follows) in [
            ("{{#raystep a/b}}\ntext", "\n"),
            ("{{#raystep a/b}}\n\ntext", ""),
            ("{{#raystep a/b}}", ""),
            ("- {{#raystep a/b}}\n- next", ""),
            ("- {{#raystep a/b}}\n  text", "\n"),
            ("12. {{#raystep a/b}}\n    text", "\n"),
            ("> {{#raystep a/b}}\n> text", "\n>"),
            ("> {{#raystep a/b}}\n>text", "\n>"),
            ("> {{#raystep a/b}}\ntext", ""),
            ("> - {{#raystep a/b}}\n>   text", "\n>"),
            ("> - {{#raystep a/b}}\n> - next", "\n>"),
            ("  * {{#raystep a/b}}  \r\n", ""),
        ] {
            let all = found(content);
            assert_eq!(all[0].3.as_deref(), Some(follows), "{content}");
        }
        assert_eq!(found("see {{#raystep a/b}}")[0].3, None);
        assert_eq!(found("{{#raystep a/b}} there")[0].3, None);
    }

    #[test]
    fn spaces_and_unknown_words_are_seen() {
        assert_eq!(found("{{ #raystep a/b }}")[0].2, ["a/b"]);
        assert_eq!(found("{{#raystepx a/b}}")[0].1, "raystepx");
        assert_eq!(found("`<!--` {{#raystep a/b}}").len(), 1);
    }
}
