//! Rust source as tokens, as far as items need them: names, marks, literals and doc comments. Other comments are left out,
//! and what stands in strings is no mark.

use std::ops::Range;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Is {
    /// A name, a keyword, a lifetime or a number.
    Word,
    /// One character.
    Mark(u8),
    /// A string or a character.
    Text,
    /// `///` or `/** … */`
    Doc,
}

/// A token and its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Token {
    pub(super) is: Is,
    pub(super) range: Range<usize>,
}

/// All tokens of a source.
pub(super) fn tokens(text: &str) -> Vec<Token> {
    let bytes = text.as_bytes();
    let mut found = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let rest = &text[at..];
        let (is, length) = if rest.starts_with("//") {
            let length = rest.find('\n').unwrap_or(rest.len());
            let is_doc = rest.starts_with("///") && !rest.starts_with("////");
            (is_doc.then_some(Is::Doc), length)
        } else if rest.starts_with("/*") {
            let is_doc =
                rest.starts_with("/**") && !rest.starts_with("/***") && !rest.starts_with("/**/");
            (is_doc.then_some(Is::Doc), block_comment(rest))
        } else if let Some(length) = string(rest) {
            (Some(Is::Text), length)
        } else if let Some(length) = quote(rest) {
            length
        } else {
            plain(rest)
        };
        // a comment at the end of a file may be open
        let end = (at + length).min(bytes.len());
        found.extend(is.map(|is| Token { is, range: at..end }));
        at = end;
    }
    found
}

/// A word, a mark, or space.
fn plain(rest: &str) -> (Option<Is>, usize) {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let first = rest.chars().next().unwrap_or(' ');
    if is_word(first) {
        // a raw name, r#match, is one word
        let raw = if rest.starts_with("r#") { 2 } else { 0 };
        let end = rest[raw..].find(|c| !is_word(c));
        return (Some(Is::Word), end.map_or(rest.len(), |end| raw + end));
    }
    if first.is_ascii_punctuation() {
        return (Some(Is::Mark(rest.as_bytes()[0])), 1);
    }
    (None, first.len_utf8())
}

/// How long a comment `/* … */` is; comments nest.
fn block_comment(rest: &str) -> usize {
    let bytes = rest.as_bytes();
    let (mut depth, mut at) = (0_usize, 0);
    while at < bytes.len() {
        match bytes[at..] {
            [b'/', b'*', ..] => {
                depth += 1;
                at += 2;
            }
            [b'*', b'/', ..] => {
                depth -= 1;
                at += 2;
                if depth == 0 {
                    return at;
                }
            }
            _ => at += 1,
        }
    }
    bytes.len()
}

/// How long the string is that starts here, with its prefix: `"…"`, `b"…"`, `c"…"`, `r#"…"#` and their like.
fn string(rest: &str) -> Option<usize> {
    let prefix = rest.find(|c| !matches!(c, 'b' | 'c' | 'r')).unwrap_or(0);
    let hashes = rest[prefix..]
        .bytes()
        .take_while(|&byte| byte == b'#')
        .count();
    let is_raw = rest[..prefix].ends_with('r');
    let open = prefix + hashes;
    if 2 < prefix || (0 < hashes && !is_raw) || rest.as_bytes().get(open) != Some(&b'"') {
        return None;
    }
    if is_raw {
        let close = format!("\"{}", "#".repeat(hashes));
        let end = rest[open + 1..].find(&close);
        return Some(end.map_or(rest.len(), |end| open + 1 + end + close.len()));
    }
    Some(open + 1 + closed(&rest[open + 1..], b'"'))
}

/// How long the character or the lifetime is that starts here: `'a'`, `b'a'`, `'a`.
fn quote(rest: &str) -> Option<(Option<Is>, usize)> {
    let prefix = usize::from(rest.starts_with("b'"));
    let inner = rest[prefix..].strip_prefix('\'')?;
    let mut chars = inner.chars();
    let first = chars.next()?;
    let is_char = first == '\\' || chars.next() == Some('\'');
    if is_char {
        return Some((Some(Is::Text), prefix + 1 + closed(inner, b'\'')));
    }
    let end = inner.find(|c: char| !c.is_alphanumeric() && c != '_');
    Some((Some(Is::Word), 1 + end.unwrap_or(inner.len())))
}

/// How far it is behind the mark that closes, where a backslash takes the meaning of the next character.
fn closed(inner: &str, mark: u8) -> usize {
    let mut escaped = false;
    for (at, byte) in inner.bytes().enumerate() {
        match byte {
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            _ if byte == mark => return at + 1,
            _ => {}
        }
    }
    inner.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<&str> {
        let all = tokens(text).into_iter();
        all.map(|token| &text[token.range]).collect()
    }

    #[test]
    fn strings_characters_and_comments_hold_no_marks() {
        assert_eq!(
            words("a(\"}\\\"{\", '{', '\\'', b'}', r#\"\"}\"#) // }\n/* { /* } */ { */ b"),
            [
                "a",
                "(",
                "\"}\\\"{\"",
                ",",
                "'{'",
                ",",
                "'\\''",
                ",",
                "b'}'",
                ",",
                "r#\"\"}\"#",
                ")",
                "b"
            ]
        );
        assert_eq!(words("&'a str '}'"), ["&", "'a", "str", "'}'"]);
        assert_eq!(
            words("b\"}\" br\"}\" c\"}\" bc brr"),
            ["b\"}\"", "br\"}\"", "c\"}\"", "bc", "brr"]
        );
        assert_eq!(
            words("r#match 1.5e-3"),
            ["r#match", "1", ".", "5e", "-", "3"]
        );
    }

    #[test]
    fn doc_comments_are_kept_and_open_ends_are_no_trouble() {
        assert_eq!(
            words("/// doc {\n//// line\n//! inner\nx"),
            ["/// doc {", "x"]
        );
        for open in ["\"abc", "/* abc", "r#\"abc", "'", "'\\", "b'", "/**"] {
            let _ = tokens(open);
        }
        assert_eq!(words("größe"), ["größe"]);
    }
}
