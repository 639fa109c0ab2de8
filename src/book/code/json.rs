//! A value of a JSON file by its pointer, such as `/figures/walk`, as it is written there.

use serde_json::Value;

use crate::book::code::text::{dedented, others};
use crate::scene::quoted;

/// The text of a value.
///
/// # Errors
/// The file is no JSON, or the pointer leads nowhere.
pub(super) fn item(text: &str, pointer: &str) -> Result<String, String> {
    let whole: Value = serde_json::from_str(text)
        .map_err(|error| format!("the file is no JSON: {error}\n  mend it"))?;
    let Some(steps) = pointer.strip_prefix('/') else {
        return Err(format!(
            "{} is no pointer into JSON\n  as in /figures/walk",
            quoted(pointer)
        ));
    };
    let (mut at, mut start, mut key_start) = (&whole, skip_space(text, 0), None);
    for step in steps.split('/') {
        let step = step.replace("~1", "/").replace("~0", "~");
        let missing = |names: Vec<String>| {
            format!(
                "in {pointer} there is no {}\n  {}",
                quoted(&step),
                others(&step, &names)
            )
        };
        let parts = parts(text, start);
        let place = match at {
            Value::Object(map) => {
                let names = || map.keys().cloned().collect();
                let place = parts
                    .iter()
                    .position(|part| part.key.as_deref() == Some(&*step));
                at = map.get(&step).ok_or_else(|| missing(names()))?;
                place
            }
            Value::Array(list) => {
                let place = step.parse::<usize>().ok();
                let found = place.and_then(|place| list.get(place));
                at = found.ok_or_else(|| missing(Vec::new()))?;
                place
            }
            _ => return Err(missing(Vec::new())),
        };
        let part = place.and_then(|place| parts.get(place));
        let part = part.ok_or_else(|| missing(Vec::new()))?;
        start = part.value;
        key_start = Some(part.start);
    }
    let shown = &text[key_start.unwrap_or(start)..end_of(text, start)];
    let line = text[..key_start.unwrap_or(start)]
        .rfind('\n')
        .map_or(0, |at| at + 1);
    let indentation = text[line..].len() - text[line..].trim_start_matches(' ').len();
    Ok(dedented(shown, indentation))
}

/// A value in an object or a list.
struct Part {
    /// Where it begins, with its key.
    start: usize,
    key: Option<String>,
    value: usize,
}

/// The values in the object or the list that starts here, in valid JSON.
fn parts(text: &str, start: usize) -> Vec<Part> {
    let bytes = text.as_bytes();
    let mut parts = Vec::new();
    let mut at = skip_space(text, start + 1);
    while at < bytes.len() && !matches!(bytes[at], b'}' | b']') {
        let begins = at;
        let mut key = None;
        if bytes[start] == b'{' {
            let end = end_of(text, at);
            key = serde_json::from_str(&text[at..end]).ok();
            // the colon behind it
            at = skip_space(text, skip_space(text, end) + 1);
        }
        parts.push(Part {
            start: begins,
            key,
            value: at,
        });
        at = skip_space(text, end_of(text, at));
        if bytes.get(at) == Some(&b',') {
            at = skip_space(text, at + 1);
        }
    }
    parts
}

fn skip_space(text: &str, at: usize) -> usize {
    text.len() - text[at.min(text.len())..].trim_start().len()
}

/// Where the value ends that starts here.
fn end_of(text: &str, start: usize) -> usize {
    let bytes = text.as_bytes();
    let (mut depth, mut in_text, mut escaped) = (0_usize, false, false);
    for (at, &byte) in bytes.iter().enumerate().skip(start) {
        if in_text {
            match byte {
                _ if escaped => escaped = false,
                b'\\' => escaped = true,
                b'"' => {
                    in_text = false;
                    if depth == 0 {
                        return at + 1;
                    }
                }
                _ => {}
            }
            continue;
        }
        match byte {
            b'"' => in_text = true,
            b'{' | b'[' => depth += 1,
            b'}' | b']' | b',' | b':' if depth == 0 => return at,
            b'}' | b']' => {
                depth -= 1;
                if depth == 0 {
                    return at + 1;
                }
            }
            _ if depth == 0 && byte.is_ascii_whitespace() => return at,
            _ => {}
        }
    }
    bytes.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "{ \"a\": [1, {\"}\": \"\\\"]\"}, -2.5e3],\n  \"figures\": {\n    \"walk\": {\n      \"kind\": \"grid\"\n    },\n    \"hit\": 7 } }";

    #[test]
    fn a_value_is_shown_as_it_is_written_with_its_key() {
        assert_eq!(
            item(TEXT, "/figures/walk").unwrap(),
            "\"walk\": {\n  \"kind\": \"grid\"\n}"
        );
        assert_eq!(item(TEXT, "/figures/hit").unwrap(), "\"hit\": 7");
        assert_eq!(item(TEXT, "/a/1").unwrap(), "{\"}\": \"\\\"]\"}");
        assert_eq!(item(TEXT, "/a/2").unwrap(), "-2.5e3");
        assert_eq!(item(TEXT, "/a/1/}").unwrap(), "\"}\": \"\\\"]\"");
    }

    #[test]
    fn a_pointer_that_leads_nowhere_is_told() {
        for (pointer, says) in [
            ("/figures/wlak", "did you mean walk?"),
            ("figures", "is no pointer"),
            ("/a/9", "there is no \"9\""),
            ("/figures/hit/x", "there is no \"x\""),
        ] {
            let told = item(TEXT, pointer).unwrap_err();
            assert!(told.contains(says), "{pointer}: {told}");
        }
        assert!(item("{", "/a").unwrap_err().contains("is no JSON"));
    }
}
