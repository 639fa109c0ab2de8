//! The words of a step: the lines of the worked solution that tell it.

use std::collections::BTreeSet;
use std::ops::Range;

use crate::explain::{Line, Section, StepAddress, Tone, WorkedSteps};
use crate::step::level::Level;
use crate::step::tree::StepLog;
use crate::trace::{Event, Kind};

/// Finds the lines that tell a step.
#[derive(Debug)]
pub struct StepWords<'a> {
    solution: WorkedSteps<'a>,
    /// All lines, if they were written in advance.
    written: Option<Written>,
}

/// A line with the places of its events; a heading has none.
type Placed = (Line, Option<Range<usize>>);

/// All lines of a log, to be looked up by events.
#[derive(Debug)]
struct Written {
    lines: Vec<Placed>,
    /// Of each event the lines about it and few others.
    of_event: Vec<Vec<usize>>,
    /// The lines about many events.
    long: Vec<usize>,
}

impl<'a> StepWords<'a> {
    /// The words of a log, found step by step.
    pub fn new(log: &StepLog<'a>) -> Self {
        Self {
            solution: WorkedSteps::new(log.scene, log.settings, log.records),
            written: None,
        }
    }

    /// The words of a log of which all steps are asked for: they are written in advance, in one go.
    pub fn of_all(log: &StepLog<'a>) -> Self {
        let found = Self::new(log);
        let lines = placed(log, found.solution.all_lines().lines);
        Self {
            written: Some(Written::new(lines, log.records.len())),
            ..found
        }
    }

    /// The lines that tell a step, from the left edge.
    ///
    /// Of a test or a single event they are the lines of the worked solution whose range of steps lies within it; if there are
    /// none, as for `listed`, those of the range that it belongs to. The lines of a bound begin with S and T of all slabs, which were
    /// computed before it; they are of its test. A heading stands above the first of its lines. A section, a
    /// ray or a place is told by its own events, and the steps that it holds tell themselves; so does a fold.
    pub fn of(&self, log: &StepLog, number: usize) -> Vec<Line> {
        let own = own_events(log, number);
        if own.is_empty() {
            return Vec::new();
        }
        let wanted: Vec<Range<usize>> = own.iter().map(|own| with_neighbours(log, own)).collect();
        let lines = match &self.written {
            Some(written) => written.about(&wanted),
            None => placed(log, self.solution.lines(&wanted).lines),
        };
        let step = &log.step(number).events;
        let meets = |line: &Range<usize>| {
            let overlap = |own: &Range<usize>| line.start < own.end && own.start < line.end;
            own.iter().any(overlap)
        };
        // the lines of a bound's first slab tell S and T of all slabs too, which were computed before the bound
        let begins = |line: &Range<usize>| {
            let is_slab_ray = |at: &usize| matches!(log.records[*at].event, Event::SlabRay(_));
            let first = line.clone().find(|at| !is_slab_ray(at));
            first.unwrap_or(line.start)
        };
        let within =
            |line: &Range<usize>| step.start <= begins(line) && line.end <= step.end && meets(line);
        let has_words = lines
            .iter()
            .filter_map(|(_, place)| place.as_ref())
            .any(within);
        let tells = |line: &Range<usize>| if has_words { within(line) } else { meets(line) };

        let mut told = Vec::new();
        let mut headings = Vec::new();
        for (line, place) in lines {
            match place {
                None if line.tone == Tone::Heading => headings.push(line),
                None => {}
                Some(place) if tells(&place) => {
                    told.append(&mut headings);
                    told.push(line);
                }
                Some(_) => headings.clear(),
            }
        }
        let left = told.iter().map(|line: &Line| line.indent).min();
        for line in &mut told {
            line.indent -= left.unwrap_or_default();
        }
        if let Some(first) = told.first_mut() {
            first.gap = false;
        }
        told
    }
}

impl Written {
    /// A line about more events is no line of one of them.
    const MANY: usize = 64;

    fn new(lines: Vec<Placed>, events: usize) -> Self {
        let mut of_event = vec![Vec::new(); events];
        let mut long = Vec::new();
        for (number, (_, place)) in lines.iter().enumerate() {
            match place {
                Some(place) if place.len() <= Self::MANY => {
                    for event in place.clone() {
                        of_event[event].push(number);
                    }
                }
                Some(_) => long.push(number),
                None => {}
            }
        }
        Self {
            lines,
            of_event,
            long,
        }
    }

    /// The lines about some events, each with the headings right above it.
    fn about(&self, wanted: &[Range<usize>]) -> Vec<Placed> {
        let of_few = wanted.iter().cloned().flatten();
        let mut numbers: BTreeSet<usize> = of_few
            .flat_map(|event| &self.of_event[event])
            .copied()
            .collect();
        let is_wanted = |number: &&usize| {
            let place = self.lines[**number].1.as_ref();
            place.is_some_and(|place| {
                wanted
                    .iter()
                    .any(|of| place.start < of.end && of.start < place.end)
            })
        };
        numbers.extend(self.long.iter().filter(is_wanted));
        let mut found = Vec::new();
        for number in numbers {
            let above = self.lines[..number].iter().rev();
            let headings = above.take_while(|(_, place)| place.is_none()).count();
            found.extend_from_slice(&self.lines[number - headings..=number]);
        }
        found
    }
}

/// The lines with the places of their events.
fn placed(log: &StepLog, lines: Vec<Line>) -> Vec<Placed> {
    let with_place = |line: Line| {
        let places = line
            .steps
            .and_then(|steps| Some(place(log, steps.first)?..place(log, steps.last)? + 1));
        (line, places)
    };
    lines.into_iter().map(with_place).collect()
}

/// The events that tell a step.
fn own_events(log: &StepLog, number: usize) -> Vec<Range<usize>> {
    let step = log.step(number);
    if step.is_leaf() {
        return vec![step.events.clone()];
    }
    match step.level {
        _ if step.is_fold() => Vec::new(),
        Level::Test | Level::Term => vec![step.events.clone()],
        Level::Section | Level::Ray | Level::Place => {
            let held = &log.steps()[step.children.clone()];
            let own = held
                .iter()
                .filter(|held| held.is_leaf() && held.level == Level::Term);
            own.map(|own| own.events.clone()).collect()
        }
    }
}

/// The events with their tests, and with what has words before them and behind: an event without words is told with one of
/// them.
fn with_neighbours(log: &StepLog, events: &Range<usize>) -> Range<usize> {
    let whole = |event: usize| log.step(log.landing(event)).events.clone();
    let has_words = |event: usize| {
        let lead = log.step(log.landing(event)).lead;
        let kind = log.records[lead].event.kind();
        !matches!(kind, Kind::RayEnd | Kind::Node | Kind::SlabRay | Kind::Path)
    };
    let mut start = whole(events.start).start;
    while let Some(before) = start.checked_sub(1) {
        start = whole(before).start;
        if has_words(before) {
            break;
        }
    }
    let mut end = whole(events.end - 1).end;
    while end < log.records.len() {
        let behind = end;
        end = whole(behind).end;
        if has_words(behind) {
            break;
        }
    }
    start..end
}

/// The place of an event among the records.
fn place(log: &StepLog, at: StepAddress) -> Option<usize> {
    let key = |section: Section| match section {
        Section::Building => (0, 0),
        Section::Path(path) => (1, path),
        Section::Pixel => (2, 0),
    };
    let wanted = (key(at.section), at.step);
    let of = |event: usize| {
        let at = StepAddress::of(&log.records[event]);
        (key(at.section), at.step)
    };
    // sections are in this order in the log, and a path comes before those with larger numbers
    let (mut low, mut high) = (0, log.records.len());
    while low < high {
        let middle = usize::midpoint(low, high);
        if of(middle) < wanted {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    (low < log.records.len() && of(low) == wanted).then_some(low)
}
