//! `{{#raystep NAME stepper}}`: which steps of a figure are stepped through.

use crate::book::same_trace::place_of;
use crate::book::words::{unknown_option, whole_log};
use crate::figure::{DrawnUpTo, FigureSpec, Traced};
use crate::page::{PixelSteps, TracePlace};
use crate::scene::{nearest_name, quoted};
use crate::step::{Address, Grain, Level, StepLog};

/// The most steps of a stepper: each is in the page twice, as data and in the list.
const MOST_STEPS: usize = 300;

/// What the words behind `stepper` say.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asked {
    /// Is the question asked before the verdict?
    pub(super) predicts: bool,
    level: Level,
    from: Option<Address>,
    to: Option<Address>,
}

impl Asked {
    /// Reads the words.
    ///
    /// # Errors
    /// A word that is no option, or a value that makes no sense.
    pub(super) fn new(words: &[String]) -> Result<Self, String> {
        let mut asked = Self {
            predicts: false,
            level: Level::Test,
            from: None,
            to: None,
        };
        for word in words {
            let address = |text: &str| {
                let address = text.parse::<Address>();
                address.map(Some).map_err(|error| error.to_string())
            };
            match word.split_once('=') {
                None if word == "predict" => asked.predicts = true,
                Some(("level", name)) => asked.level = level(name)?,
                Some(("from", text)) => asked.from = address(text)?,
                Some(("to", text)) => asked.to = address(text)?,
                _ => {
                    let known = ["predict", "level=LEVEL", "from=STEP", "to=STEP"];
                    return Err(unknown_option(word, &known));
                }
            }
        }
        Ok(asked)
    }

    /// The steps of a figure that are asked for, and where the last one is.
    ///
    /// # Errors
    /// The figure has no steps, not these, or too many.
    pub(super) fn steps(
        &self,
        spec: &FigureSpec,
        traced: &Traced,
    ) -> Result<(PixelSteps, Option<TracePlace>), String> {
        let pixel = self.pixel(spec)?;
        let records = traced.of_pixel(pixel);
        let settings = whole_log(traced);
        let log = StepLog::new(&traced.scene, &settings, &records);
        if records.is_empty() {
            return Err(
                "this figure shows no pixel, so it has no steps\n  name a figure with a \"pixel\""
                    .into(),
            );
        }
        let event = |address: Option<Address>| {
            let event = address.map(|address| log.event_at(address)).transpose();
            event.map_err(|error| error.to_string())
        };
        let first = event(self.from)?.unwrap_or(0);
        let last = event(self.to)?.unwrap_or(records.len() - 1);
        if last < first {
            return Err("from is behind to\n  exchange them".into());
        }
        let mut walk = log.walk(Grain::of_level(self.level));
        walk.retain(|&step| {
            let events = &log.step(step).events;
            first < events.end && events.start <= last
        });
        if MOST_STEPS < walk.len() {
            return Err(format!(
                "{} steps are too many for a stepper, which has at most {MOST_STEPS}\n  \
                 choose some by from=STEP and to=STEP, or say level=place or level=ray",
                walk.len()
            ));
        }
        let drawn = DrawnUpTo::new(spec.kind, traced);
        let end = walk.last().map_or(0, |&step| log.step(step).events.end);
        let until = place_of(&traced.scene, &records, end.saturating_sub(1));
        Ok((PixelSteps::of_walk(&log, &walk, &drawn), until))
    }

    /// The pixel that an address names, or the first of the figure.
    fn pixel(&self, spec: &FigureSpec) -> Result<Option<[u32; 2]>, String> {
        let pixels = spec.traced_pixels();
        let mut named = [self.from, self.to].into_iter().flatten();
        let Some(wanted) = named.find_map(|address| address.pixel) else {
            return Ok(pixels.first().copied());
        };
        let of_another = |address: &Address| address.pixel.is_some_and(|pixel| pixel != wanted);
        if named.any(|address| of_another(&address)) {
            return Err("from and to are steps of different pixels\n  choose one pixel".into());
        }
        if !pixels.contains(&wanted) {
            let pixels: Vec<String> = pixels.iter().map(|[x, y]| format!("{x},{y}")).collect();
            let [x, y] = wanted;
            return Err(format!(
                "the figure does not show pixel {x},{y}\n  its pixels are {}",
                pixels.join(" and ")
            ));
        }
        Ok(Some(wanted))
    }
}

fn level(name: &str) -> Result<Level, String> {
    let found = Level::ALL.into_iter().find(|level| level.name() == name);
    found.ok_or_else(|| {
        let names = Level::ALL.map(Level::name);
        match nearest_name(name, names.into_iter()) {
            Some(near) => format!("there is no level {}\n  did you mean {near}?", quoted(name)),
            None => format!(
                "there is no level {}\n  the levels are {}",
                quoted(name),
                names.join(", ")
            ),
        }
    })
}
