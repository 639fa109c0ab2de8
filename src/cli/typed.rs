//! The options as they were typed, for a command that is printed.

use clap::parser::ValueSource;
use clap::{ArgMatches, CommandFactory};

use crate::cli::args::Args;

/// The options of a verb that were typed and that another verb has too, but for some, each followed by its values.
pub(crate) fn options(
    matches: &ArgMatches,
    [typed, other]: [&str; 2],
    but: &[&str],
) -> Vec<String> {
    let command = Args::command();
    let known = command.find_subcommand(other);
    let given = matches.subcommand_matches(typed);
    let (Some(known), Some(given)) = (known, given) else {
        return Vec::new();
    };
    let mut options = Vec::new();
    for option in known.get_arguments() {
        let id = option.get_id().as_str();
        let (Some(long), false) = (option.get_long(), but.contains(&id)) else {
            continue;
        };
        let is_typed = given.try_contains_id(id).is_ok()
            && given.value_source(id) == Some(ValueSource::CommandLine);
        if !is_typed {
            continue;
        }
        options.push(format!("--{long}"));
        if option.get_action().takes_values() && !option.is_require_equals_set() {
            let values = given.get_raw(id).into_iter().flatten();
            options.extend(values.map(|value| value.to_string_lossy().into_owned()));
        }
    }
    options
}

/// A word as a shell takes it, in quotation marks where it needs some.
pub(crate) fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./,:=+@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        return word.into();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_is_quoted_where_a_shell_would_take_it_for_something_else() {
        assert_eq!(quoted("scenes/a-1.json"), "scenes/a-1.json");
        assert_eq!(quoted("#path17:37"), "'#path17:37'");
        assert_eq!(quoted("it's"), "'it'\\''s'");
        assert_eq!(quoted(""), "''");
    }
}
