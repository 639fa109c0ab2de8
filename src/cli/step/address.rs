//! The command that leads to a step, as one types it.

use std::path::Path;

use clap::parser::ValueSource;
use clap::{ArgMatches, CommandFactory};
use raystep::StrategyName;

use crate::cli::args::{Args, StepArgs};
use crate::cli::word::word;

/// The options that the command is made of anew.
const OWN: [&str; 6] = ["scene", "pixel", "strategy", "at", "script", "plain"];

/// The words of the command that was typed, but for what changes.
#[derive(Debug)]
pub(crate) struct Words {
    scene: String,
    pixel: [u32; 2],
    /// The strategy; absent for a log, which has been traced.
    strategy: Option<StrategyName>,
    options: Vec<String>,
}

impl Words {
    /// From what was typed.
    pub(crate) fn new(
        args: &StepArgs,
        matches: &ArgMatches,
        pixel: [u32; 2],
        strategy: Option<StrategyName>,
    ) -> Self {
        let command = Args::command();
        let known = command.find_subcommand("step");
        let given = matches.subcommand_matches("step");
        let mut options = Vec::new();
        if let (Some(known), Some(given)) = (known, given) {
            for option in known.get_arguments() {
                let id = option.get_id().as_str();
                let (Some(long), false) = (option.get_long(), OWN.contains(&id)) else {
                    continue;
                };
                let typed = given.try_contains_id(id).is_ok()
                    && given.value_source(id) == Some(ValueSource::CommandLine);
                if !typed {
                    continue;
                }
                options.push(format!("--{long}"));
                if option.get_action().takes_values() && !option.is_require_equals_set() {
                    let values = given.get_raw(id).into_iter().flatten();
                    options.extend(values.map(|value| value.to_string_lossy().into_owned()));
                }
            }
        }
        Self {
            scene: args.scene.to_string_lossy().into_owned(),
            pixel,
            strategy,
            options,
        }
    }

    /// Another pixel or strategy is stepped through.
    pub(crate) fn moved(&mut self, pixel: [u32; 2], strategy: Option<StrategyName>) {
        self.pixel = pixel;
        self.strategy = strategy;
    }

    /// The pixel that is stepped through.
    pub(crate) fn pixel(&self) -> [u32; 2] {
        self.pixel
    }

    /// The name of the scene's file, or of the log's, without folder and ending.
    pub(crate) fn stem(&self) -> String {
        let stem = Path::new(&self.scene).file_stem();
        stem.unwrap_or_default().to_string_lossy().into_owned()
    }

    /// The command that begins at a step.
    pub(crate) fn command(&self, at: &str) -> String {
        self.words(at, &self.options)
    }

    /// The command that begins at a step, does what a script says, and ends.
    pub(crate) fn doing(&self, at: &str, script: &str) -> String {
        // a question would keep the step from being shown
        let options = self.options.iter().filter(|option| *option != "--predict");
        let options: Vec<String> = options.cloned().collect();
        format!("{} --script {}", self.words(at, &options), quoted(script))
    }

    fn words(&self, at: &str, options: &[String]) -> String {
        let [x, y] = self.pixel;
        let mut words = vec!["raystep".into(), "step".into(), self.scene.clone()];
        words.push(format!("{x},{y}"));
        if let Some(strategy) = self.strategy {
            words.extend(["--strategy".into(), word(strategy).into()]);
        }
        words.extend(options.iter().cloned());
        words.extend(["--at".into(), at.into()]);
        let quoted: Vec<String> = words.iter().map(|word| quoted(word)).collect();
        quoted.join(" ")
    }
}

/// A word as a shell takes it, in quotation marks where it needs some.
fn quoted(word: &str) -> String {
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
