//! `--color`: when the output has colours.

use std::ffi::OsString;

use clap::ValueEnum;

/// When the output has colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Colours {
    /// In a terminal, unless the environment says otherwise (`NO_COLOR`, `CLICOLOR`, `CLICOLOR_FORCE`).
    #[default]
    Auto,
    /// Everywhere.
    Always,
    /// Nowhere.
    Never,
}

impl From<Colours> for anstream::ColorChoice {
    fn from(colours: Colours) -> Self {
        match colours {
            Colours::Auto => Self::Auto,
            Colours::Always => Self::Always,
            Colours::Never => Self::Never,
        }
    }
}

impl From<Colours> for clap::ColorChoice {
    fn from(colours: Colours) -> Self {
        match colours {
            Colours::Auto => Self::Auto,
            Colours::Always => Self::Always,
            Colours::Never => Self::Never,
        }
    }
}

impl Colours {
    /// What the arguments say before they are parsed: help and usage errors have colours too. The last word counts;
    /// `Auto` if there is none, or if it is wrong: the error is reported later.
    pub(crate) fn of(arguments: &[OsString]) -> Self {
        let words = arguments.iter().map(|word| word.to_string_lossy());
        let options: Vec<_> = words.take_while(|word| word != "--").collect();
        let places = options.iter().enumerate();
        let mut values = places.filter_map(|(i, word)| match word.split_once('=') {
            Some(("--color", value)) => Some(value),
            None if word == "--color" => options.get(i + 1).map(|next| &**next),
            _ => None,
        });
        let known = values
            .next_back()
            .and_then(|value| Self::from_str(value, false).ok());
        known.unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_choice_of_colours_counts_before_the_arguments_are_parsed() {
        let colours = |words: &[&str]| {
            let words: Vec<OsString> = words.iter().map(OsString::from).collect();
            Colours::of(&words)
        };
        assert_eq!(colours(&["raystep", "pixel"]), Colours::Auto);
        assert_eq!(colours(&["--color", "never"]), Colours::Never);
        assert_eq!(colours(&["--color=always"]), Colours::Always);
        assert_eq!(
            colours(&["--color=always", "--color", "never"]),
            Colours::Never
        );
        assert_eq!(colours(&["--color", "blue"]), Colours::Auto);
        assert_eq!(colours(&["--color"]), Colours::Auto);
        assert_eq!(colours(&["--", "--color=always"]), Colours::Auto);
    }
}
