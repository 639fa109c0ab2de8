//! The words of a directive, and what they are said of.

use crate::figure::Traced;
use crate::scene::quoted;
use crate::trace::Settings;

/// A word that is none of a directive's options.
pub(super) fn unknown_option(word: &str, known: &[&str]) -> String {
    let known = known.join(", ");
    format!(
        "{} is not one of its options\n  they are {known}",
        quoted(word)
    )
}

/// A number behind an option.
pub(super) fn whole_number(option: &str, text: &str) -> Result<u32, String> {
    let number = text.parse();
    number.map_err(|_| {
        format!(
            "{option}={} is not a whole number\n  as in {option}=12",
            quoted(text)
        )
    })
}

/// The settings of a figure's log for one of its pixels: of that everything was kept.
pub(super) fn whole_log(traced: &Traced) -> Settings {
    Settings {
        only: None,
        ..traced.settings.clone()
    }
}

/// Letters, digits and `-`: what an id may have.
pub(super) fn word(text: &str) -> String {
    let letters = text
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '-' });
    letters.collect()
}
