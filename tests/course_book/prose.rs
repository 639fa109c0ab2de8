//! Digits in the prose of a chapter: outside of directives, code, formulas, comments, addresses, and the numbers of what has a
//! number for its name.

/// What comes before a number that is a name: a part of the slides or of the textbook.
const NAMED: [&str; 12] = [
    "erratum", "Erratum", "errata", "Fig.", "Figs", "Figs.", "figure", "figures", "chapter",
    "equation", "lesson", "CSE",
];

/// Words with digits that are no numbers.
const WORDS: [&str; 6] = ["2D", "3D", "§15.10", "UTF-8", "MIT-0", "8-bit"];

/// The numbers in a text, each with its line.
pub(super) fn numbers(file: &str, text: &str) -> Vec<String> {
    let prose = prose(text);
    let mut found = Vec::new();
    let (mut before, mut was_name) = (String::new(), false);
    for (line, words) in prose.lines().enumerate() {
        let mut words = words.split_whitespace().peekable();
        // the number of an item of a list
        if words.peek().is_some_and(|word| {
            let digits = word.strip_suffix('.').unwrap_or("");
            !digits.is_empty() && digits.chars().all(|c| c.is_ascii_digit())
        }) {
            words.next();
        }
        for word in words {
            let bare = word.trim_matches(|c: char| !c.is_alphanumeric() && c != '§');
            let is_number = bare.contains(|c: char| c.is_ascii_digit());
            let is_year = bare.len() == 4
                && (bare.starts_with("19") || bare.starts_with("20"))
                && bare.chars().all(|c| c.is_ascii_digit());
            let is_name = is_number
                && (NAMED.contains(&before.trim_start_matches(['(', '*', '"', '“']))
                    || WORDS.contains(&bare)
                    // Figs 15.57, 15.58 and 15.61
                    || (was_name && (before.ends_with(',') || before == "and"))
                    || (is_year && file == "references.md"));
            if is_number && !is_name {
                found.push(format!("{file}, line {}: {bare}", line + 1));
            }
            was_name = is_name || (was_name && word == "and");
            before = word.into();
        }
    }
    found
}

/// The text with spaces in the place of all that is no prose, line by line.
fn prose(text: &str) -> String {
    let mut kept = String::with_capacity(text.len());
    let mut fence: Option<String> = None;
    for line in text.lines() {
        let start = line.trim_start_matches([' ', '>']);
        let ticks: String = start.chars().take_while(|c| *c == '`').collect();
        match &fence {
            Some(open) if start.trim_end() == open => fence = None,
            Some(_) => {}
            None if 3 <= ticks.len() => fence = Some(ticks),
            None => kept.push_str(line),
        }
        kept.push('\n');
    }
    for (open, close) in [
        ("<!--", "-->"),
        ("{{#", "}}"),
        ("`", "`"),
        ("$$", "$$"),
        ("$", "$"),
        ("](", ")"),
        ("<http", ">"),
    ] {
        kept = blanked(&kept, open, close);
    }
    kept
}

/// The text with a space in the place of each piece between two marks; its line breaks stay.
fn blanked(text: &str, open: &str, close: &str) -> String {
    let mut kept = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(open) {
        let inner = &rest[start + open.len()..];
        let Some(end) = inner.find(close) else {
            break;
        };
        kept.push_str(&rest[..start]);
        kept.push(' ');
        kept.extend(inner[..end].chars().filter(|c| *c == '\n'));
        rest = &inner[end + close.len()..];
    }
    kept.push_str(rest);
    kept
}
