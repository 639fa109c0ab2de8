//! `--stats`: what a trace cost, in counts and seconds.

use std::io::{self, Write};
use std::time::Duration;

use raystep::explain::{
    CrowdedCell, counts_json, counts_text, in_advance, in_advance_json, in_advance_text,
    strategy_title,
};
use raystep::{Counts, Record, Recorder, Scene, Settings};
use serde_json::{Value, json};

use crate::cli::Error;
use crate::cli::args::Format;
use crate::cli::output::Output;

/// How long each part took.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Times {
    /// Reading and checking the scene or the log.
    pub(crate) loading: Duration,
    /// Building what the strategy needs.
    pub(crate) building: Duration,
    /// Tracing and writing.
    pub(crate) tracing: Duration,
}

/// What a trace was made with, and what it cost.
pub(crate) struct Report<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) settings: &'a Settings,
    /// Did the verb choose the strategy, and no option?
    pub(crate) is_usual: bool,
    /// The grid that was walked, if most objects lie in one of its cells.
    pub(crate) crowded: Option<CrowdedCell>,
    pub(crate) counts: &'a Counts,
    pub(crate) times: Times,
}

/// Prints the report: as text on standard error, as JSON on standard output.
pub(crate) fn tell(format: Format, report: &Report<'_>) -> Result<(), Error> {
    let Report {
        scene,
        settings,
        is_usual,
        crowded,
        counts,
        times,
    } = report;
    let advance = in_advance(scene, settings, counts);
    let parts = [
        ("loading", times.loading),
        ("building", times.building),
        ("tracing", times.tracing),
    ];
    match format {
        Format::Text => {
            let seconds = parts.map(|(part, time)| format!("{part} {:.3} s", time.as_secs_f64()));
            let by_whom = if *is_usual {
                " (chosen by raystep; --strategy chooses another)"
            } else {
                ""
            };
            let strategy = format!("strategy: {}{by_whom}\n", strategy_title(settings));
            let crowded = crowded.as_ref().map(|crowded| format!("{crowded}\n"));
            let [table, advance] = [counts_text(counts), in_advance_text(&advance)];
            // counts that nobody can read stop nothing
            let _ = writeln!(
                io::stderr(),
                "{strategy}{table}{advance}{}{}",
                crowded.unwrap_or_default(),
                seconds.join(", ")
            );
            Ok(())
        }
        Format::Json => {
            let mut report = counts_json(counts);
            report["strategy"] = strategy_title(settings).into();
            if let Some(crowded) = crowded {
                report["crowded_cell"] = crowded.json();
            }
            report["in_advance"] = in_advance_json(&advance);
            let seconds = parts.map(|(part, time)| (part.into(), json!(time.as_secs_f64())));
            report["seconds"] = Value::Object(seconds.into_iter().collect());
            Output::standard().write_whole(format!("{report:#}\n").as_bytes())
        }
    }
}

/// Counts what a log holds.
#[derive(Debug, Default)]
pub(crate) struct LogCounts(Counts);

impl LogCounts {
    /// Counts of a log; refused where it was filtered by kind, since the sums would be wrong.
    pub(crate) fn new(file: &str, settings: &Settings) -> Result<Self, Error> {
        match &settings.only {
            None => Ok(Self::default()),
            Some(only) => Err(Error::NotInLog {
                file: file.into(),
                what: format!(
                    "--stats counts all kinds, and this log has only {}",
                    only.join(", ")
                ),
                fix: "count a log that was made without --only",
            }),
        }
    }

    /// One more event.
    pub(crate) fn add(&mut self, record: &Record) {
        self.0.note(|| record.event);
    }

    /// The sums.
    pub(crate) fn counts(&self) -> &Counts {
        &self.0
    }
}
