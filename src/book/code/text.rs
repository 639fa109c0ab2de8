//! Text of a source, and names of what is in it.

use crate::scene::nearest_name;

/// The text with the indentation of its first line taken from each line.
pub(super) fn dedented(text: &str, indentation: usize) -> String {
    let lines = text.lines().map(|line| {
        let spaces = line.len() - line.trim_start_matches([' ', '\t']).len();
        &line[spaces.min(indentation)..]
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// The names that there are, for a message: the nearest one, or the first few.
pub(super) fn others(wanted: &str, names: &[String]) -> String {
    /// More names are no help in one message.
    const MOST: usize = 12;
    match nearest_name(wanted, names.iter().map(String::as_str)) {
        Some(near) => format!("did you mean {near}?"),
        None if names.is_empty() => "the file has none".into(),
        None if names.len() <= MOST => format!("it has {}", names.join(", ")),
        None => format!(
            "it has {}, … ({} in all)",
            names[..MOST].join(", "),
            names.len()
        ),
    }
}
