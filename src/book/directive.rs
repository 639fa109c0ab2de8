//! Where a chapter asks for something: `{{#raystep 12-grid/walk}}` and its like.
//!
//! What stands in code, between backticks or in a block, is shown as it is, and so is a directive after a backslash.
//! In a comment nothing is followed.

use std::iter::Peekable;
use std::ops::Range;
use std::vec;

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

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
    /// What these words are made of.
    pub(super) rest: String,
    /// Does it end on its line, with `}}`?
    pub(super) ends: bool,
    /// How a block stands in its place; `None` if other text is on the line.
    pub(super) alone: Option<Alone>,
}

/// How a block stands in the place of a directive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Alone {
    /// What begins each further line of the block: the marks of the lists and block quotes around it.
    pub(super) begins: String,
    /// What is to follow the block.
    pub(super) ends: String,
}

/// All directives of a chapter, in order; no two of them overlap.
///
/// One pass from the first byte to the last: every byte is looked at a few times, however many directives there are.
pub(super) fn directives(content: &str) -> Vec<Directive> {
    const NAME: &str = "#raystep";
    let mut untouched = Covered::by(untouched(content));
    let mut lines = Lines::of(content);
    let mut found: Vec<Directive> = Vec::new();
    for (name, _) in content.match_indices(NAME) {
        // as mdBook's own, {{ #raystep … }} may have spaces
        let Some(before) = content[..name]
            .trim_end_matches([' ', '\t'])
            .strip_suffix("{{")
        else {
            continue;
        };
        let start = before.len();
        if untouched.covers(start) || before.ends_with('\\') {
            continue;
        }
        let line = lines.around(start);
        let (end, ends) = end_of(content, name, line.range.end);
        let range = start..end;
        let inner = &content[name + 1..range.end];
        let inner = if ends {
            &inner[..inner.len() - 2]
        } else {
            inner
        };
        let (word, rest) = inner.split_once(char::is_whitespace).unwrap_or((inner, ""));
        // what follows another directive is not alone on its line
        let is_first = found
            .last()
            .is_none_or(|other| other.range.end <= line.range.start);
        found.push(Directive {
            line: line.number,
            word: word.into(),
            words: rest.split_whitespace().map(String::from).collect(),
            rest: rest.into(),
            ends,
            alone: is_first.then(|| alone(content, &range, &line)).flatten(),
            range,
        });
    }
    found
}

/// Where the directive with this name ends, and whether it does so by `}}`: if not, it goes up to the braces of the
/// next one, or to the end of its line.
fn end_of(content: &str, name: usize, line_end: usize) -> (usize, bool) {
    let rest = &content.as_bytes()[name..line_end];
    let braces = rest
        .windows(2)
        .position(|pair| pair == b"}}" || pair == b"{{");
    match braces {
        Some(at) if rest[at] == b'}' => (name + at + 2, true),
        Some(at) => (name + at, false),
        None => (line_end, false),
    }
}

/// A line of a chapter.
#[derive(Clone)]
struct Line {
    /// Counted from 1.
    number: usize,
    /// Where it stands, without its line break.
    range: Range<usize>,
}

/// The lines of a chapter, for places that are asked for in order.
struct Lines<'a> {
    content: &'a str,
    line: Line,
}

impl<'a> Lines<'a> {
    fn of(content: &'a str) -> Self {
        let range = line_from(content, 0);
        let line = Line { number: 1, range };
        Self { content, line }
    }

    /// The line around a place, which lies on the line before or after it.
    fn around(&mut self, place: usize) -> Line {
        while self.line.range.end < place {
            self.line.range = line_from(self.content, self.line.range.end + 1);
            self.line.number += 1;
        }
        self.line.clone()
    }
}

/// The line that starts here.
fn line_from(content: &str, start: usize) -> Range<usize> {
    let end = content[start..].find('\n');
    start..end.map_or(content.len(), |end| start + end)
}

/// Pieces of a chapter, asked in order whether they cover a place.
struct Covered {
    /// By their starts.
    pieces: Peekable<vec::IntoIter<Range<usize>>>,
    /// Where the last of the pieces ends that start up to the place.
    end: usize,
}

impl Covered {
    fn by(mut pieces: Vec<Range<usize>>) -> Self {
        pieces.sort_by_key(|piece| piece.start);
        let pieces = pieces.into_iter().peekable();
        Self { pieces, end: 0 }
    }

    /// Does a piece cover this place, which lies nowhere before the place that was asked about last?
    fn covers(&mut self, place: usize) -> bool {
        while let Some(piece) = self.pieces.next_if(|piece| piece.start <= place) {
            self.end = self.end.max(piece.end);
        }
        place < self.end
    }
}

/// Where nothing is followed: in code and in comments.
pub(super) fn untouched(content: &str) -> Vec<Range<usize>> {
    let code = code(content);
    let mut found = comments(content, code.clone());
    found.extend(code);
    found
}

/// Where comments stand, from `<!--` to `-->`, outside of code.
fn comments(content: &str, code: Vec<Range<usize>>) -> Vec<Range<usize>> {
    let mut code = Covered::by(code);
    let mut found: Vec<Range<usize>> = Vec::new();
    for (start, _) in content.match_indices("<!--") {
        let is_inside = found.last().is_some_and(|last| start < last.end);
        if code.covers(start) || is_inside {
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
fn alone(content: &str, range: &Range<usize>, line: &Line) -> Option<Alone> {
    let before = &content[line.range.start..range.start];
    let after = &content[range.end..line.range.end];
    if !after.trim_start().is_empty() || !is_container(before) {
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
    let next = content.get(line.range.end + 1..).unwrap_or_default();
    let next = next.split('\n').next().unwrap_or_default();
    let is_same = next.starts_with(marked) && !next[marked.len()..].trim().is_empty();
    let ends = if is_same {
        format!("\n{}", goes_on.trim_end())
    } else {
        String::new()
    };
    Some(Alone {
        begins: goes_on,
        ends,
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
            .map(|of| (of.line, of.word, of.words, of.alone.map(|alone| alone.ends)))
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
        let begins = |content: &str| directives(content)[0].alone.clone().unwrap().begins;
        assert_eq!(begins("> - {{#raystep a/b}}"), ">   ");
        assert_eq!(begins("{{#raystep a/b}}"), "");
        assert_eq!(found("see {{#raystep a/b}}")[0].3, None);
        assert_eq!(found("{{#raystep a/b}} there")[0].3, None);
    }

    #[test]
    fn spaces_and_unknown_words_are_seen() {
        assert_eq!(found("{{ #raystep a/b }}")[0].2, ["a/b"]);
        assert_eq!(found("{{#raystepx a/b}}")[0].1, "raystepx");
        assert_eq!(found("`<!--` {{#raystep a/b}}").len(), 1);
    }

    #[test]
    fn a_directive_without_an_end_goes_up_to_the_next_one_on_its_line() {
        let content =
            "a\nSee {{#raystep-value x/y cell.count and {{#raystep x/y}} cells {{ #raystep z/w.\nb";
        let all = directives(content);
        let told = all
            .iter()
            .map(|of| (of.line, &content[of.range.clone()], of.ends));
        assert_eq!(
            told.collect::<Vec<_>>(),
            [
                (2, "{{#raystep-value x/y cell.count and ", false),
                (2, "{{#raystep x/y}}", true),
                (2, "{{ #raystep z/w.", false),
            ]
        );
        assert_eq!(all[0].words, ["x/y", "cell.count", "and"]);
    }

    #[test]
    fn code_in_a_comment_and_a_comment_in_code_end_where_they_end() {
        let all = found(
            "See <!-- `{{#raystep a/b}}` --> {{#raystep c/d}} `<!-- {{#raystep e/f}}` {{#raystep g/h}}",
        );
        let words: Vec<&str> = all.iter().map(|of| of.2[0].as_str()).collect();
        assert_eq!(words, ["c/d", "g/h"]);
    }

    /// A pass that looked at the rest of the chapter or of the line for each directive would look at 10¹² bytes here,
    /// and not come back.
    #[test]
    fn the_time_grows_with_the_length_of_a_chapter_and_not_with_its_square() {
        const MANY: usize = 200_000;
        let quotes = "> ".repeat(MANY);
        let spaces = " ".repeat(MANY);
        let ended = "{{#raystep a/b}}";
        for (content, count) in [
            ("{{#raystep a/b ".repeat(MANY), MANY),
            (format!("{ended} ").repeat(MANY), MANY),
            (format!("{ended}\n").repeat(MANY), MANY),
            (format!("{quotes}{}", ended.repeat(MANY)), MANY),
            (format!("{}{spaces}", ended.repeat(MANY)), MANY),
            (format!("<!-- {ended} -->").repeat(MANY), 0),
            (format!("`{ended}` {ended}").repeat(MANY), MANY),
            (format!("<!-- {ended}").repeat(MANY), 0),
        ] {
            let all = directives(&content);
            assert_eq!(all.len(), count, "{}", &content[..40]);
            if let Some(last) = all.last() {
                assert_eq!(
                    last.line,
                    1 + content[..last.range.start].matches('\n').count()
                );
            }
        }
    }
}
