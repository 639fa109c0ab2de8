//! The command that leads to a step, as one types it.

use std::path::Path;

use clap::ArgMatches;
use raystep::StrategyName;

use crate::cli::args::StepArgs;
use crate::cli::typed::{options, quoted};
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
        let options = options(matches, ["step", "step"], &OWN);
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
