//! What writes a page: each line as deep as what it belongs to, with the ray and the events that it is about.

use std::fmt;
use std::ops::Range;

use crate::explain::page::{Fold, Line, Tone, Unfold};
use crate::explain::part::Part;
use crate::explain::worked::extent::Extent;

/// Writes the lines of a page, from top to bottom.
#[derive(Debug, Default)]
pub(super) struct Pen {
    drafts: Vec<Draft>,
    indent: usize,
    gap: bool,
    ray: Option<u32>,
    extent: Option<Extent>,
    part: Option<Part>,
    next_part: Option<Part>,
    /// What is said once on a page.
    said: Vec<&'static str>,
    /// Is it said at each of its places?
    repeats: bool,
    /// The events whose lines are written; absent: all.
    wanted: Option<Wanted>,
}

/// Some of the records, by their places.
#[derive(Clone, Debug)]
pub(super) struct Wanted(Vec<Extent>);

impl Wanted {
    /// From each first place to just before each end.
    pub(super) fn new(ranges: &[Range<usize>]) -> Self {
        let some = ranges.iter().filter(|range| !range.is_empty());
        let mut extents: Vec<Extent> = some
            .map(|range| Extent::at(range.start).to(Extent::at(range.end - 1)))
            .collect();
        extents.sort_unstable();
        Self(extents)
    }

    /// Is a part of it among them?
    pub(super) fn meets(&self, extent: Extent) -> bool {
        let next = self.0.partition_point(|wanted| wanted.last < extent.first);
        self.0
            .get(next)
            .is_some_and(|wanted| wanted.first <= extent.last)
    }
}

/// A line whose steps are not settled.
#[derive(Debug)]
pub(super) struct Draft {
    pub(super) line: Line,
    /// The events that it has words for.
    pub(super) extent: Option<Extent>,
}

impl Pen {
    /// A pen that writes only the lines about some events, and the headings above them; without any it writes all. What is said
    /// once on a page is said at each of its places: a line is the same whatever is written beside it.
    pub(super) fn of_events(wanted: Option<Wanted>) -> Self {
        Self {
            repeats: true,
            wanted,
            ..Self::default()
        }
    }

    /// Are lines about these events written?
    pub(super) fn writes(&self, extent: Extent) -> bool {
        let wanted = self.wanted.as_ref();
        wanted.is_none_or(|wanted| wanted.meets(extent))
    }

    /// A line.
    pub(super) fn line(&mut self, tone: Tone, text: impl Into<String>) {
        // nothing is above the first line to be apart from
        let gap = std::mem::take(&mut self.gap) && !self.drafts.is_empty();
        let line = Line {
            gap,
            indent: self.indent,
            tone,
            ray: self.ray,
            steps: None,
            part: self.next_part.take().or(self.part),
            text: text.into(),
        };
        // a heading is about all that stands below it
        let extent = self.extent.filter(|_| tone != Tone::Heading);
        self.drafts.push(Draft { line, extent });
    }

    /// An ordinary line.
    pub(super) fn plain(&mut self, text: impl Into<String>) {
        self.line(Tone::Plain, text);
    }

    /// The first line of a part: the name of the part, then the words.
    pub(super) fn headed(&mut self, part: Part, words: impl fmt::Display) {
        self.headed_line(Tone::Plain, part, words);
    }

    /// The same in a tone.
    pub(super) fn headed_line(&mut self, tone: Tone, part: Part, words: impl fmt::Display) {
        self.part(part).line(tone, format!("{part}{words}"));
    }

    /// The result of a part: an arrow, its name, then the words.
    pub(super) fn result(&mut self, tone: Tone, part: Part, words: impl fmt::Display) {
        self.part(part).line(tone, format!("→ {part}{words}"));
    }

    /// The heading of a part, with the words that follow its name.
    pub(super) fn titled(&mut self, part: Part, words: impl fmt::Display) {
        let title = part.title();
        self.part(part)
            .line(Tone::Heading, format!("{title}{words}"));
    }

    /// Says something once on a page, however often it holds: how the program computes what the text shows.
    pub(super) fn once(&mut self, part: Part, words: &'static str) {
        if self.repeats || !self.said.contains(&words) {
            self.said.push(words);
            self.part(part).line(Tone::Aside, words);
        }
    }

    /// A line in place of `hidden` others, which [`WorkedOptions::all`](crate::explain::WorkedOptions::all) shows.
    pub(super) fn folded(&mut self, hidden: usize, text: impl Into<String>) {
        let shown_by = Unfold::All;
        self.line(Tone::Folded(Fold { hidden, shown_by }), text);
    }

    /// The next line is this part of its derivation.
    pub(super) fn part(&mut self, part: Part) -> &mut Self {
        self.next_part = Some(part);
        self
    }

    /// Everything that is written inside is this part of its derivation, unless it says another.
    pub(super) fn of_part(&mut self, part: Part, write: impl FnOnce(&mut Self)) {
        let around = self.part.replace(part);
        write(self);
        self.part = around;
    }

    /// A paragraph ends here.
    pub(super) fn gap(&mut self) {
        self.gap = true;
    }

    /// Everything that is written inside stands one level to the right.
    pub(super) fn indented(&mut self, write: impl FnOnce(&mut Self)) {
        self.indent += 1;
        write(self);
        self.indent -= 1;
    }

    /// Everything that is written inside is about these events. Nothing is written if their lines are not wanted.
    pub(super) fn telling(
        &mut self,
        extent: impl Into<Option<Extent>>,
        write: impl FnOnce(&mut Self),
    ) {
        let extent = extent.into();
        if extent.is_some_and(|extent| !self.writes(extent)) {
            return;
        }
        let around = std::mem::replace(&mut self.extent, extent);
        write(self);
        self.extent = around;
    }

    /// Everything that is written inside is about this ray.
    pub(super) fn of_ray(&mut self, ray: u32, write: impl FnOnce(&mut Self)) {
        let around = self.ray.replace(ray);
        write(self);
        self.ray = around;
    }

    /// What was written.
    pub(super) fn into_drafts(self) -> Vec<Draft> {
        self.drafts
    }
}
