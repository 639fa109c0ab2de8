//! A page of words as data: lines that say what they are and what they are about.
//!
//! Who reads a page decides how it looks: [`render`](crate::explain::render) makes plain text, ANSI, Markdown and
//! HTML of the same lines, and a stepper asks which lines belong to the step it stands at.

use std::fmt;

use crate::explain::part::Part;
use crate::trace::Record;

/// The lines of a worked solution, from top to bottom.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Page {
    /// The lines. None is empty, and none holds a line break.
    pub lines: Vec<Line>,
}

/// A line of a page.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// A new paragraph starts here. Whether that is an empty line, a margin or nothing is the renderer's choice.
    pub gap: bool,
    /// The number of levels that the line is indented by; 0 is the left edge.
    pub indent: usize,
    /// What the line is, apart from its words.
    pub tone: Tone,
    /// The number of the ray that the line is about, in its section; `None` outside of all rays.
    pub ray: Option<u32>,
    /// The steps of the log that the line is about; `None` for a heading, and for a line about the whole page.
    pub steps: Option<StepRange>,
    /// The named part of a derivation that the line is, or the first of several.
    pub part: Option<Part>,
    /// The words. A name from a scene file is [`printable`](crate::scene::printable) in them, and has no markup otherwise.
    pub text: String,
}

/// Steps of the log, from a first to a last.
///
/// All of one section, but for the line that stands for several paths of light: it goes from the first step of the first
/// of them to the last step of the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct StepRange {
    /// The first step of the range, in the order of the log.
    pub first: StepAddress,
    /// The last step, which may be the first.
    pub last: StepAddress,
}

/// A step of a pixel's log. Addresses are in the order of the log.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct StepAddress {
    /// Steps are numbered in each section.
    pub section: Section,
    /// `step` in the log, from 0.
    pub step: u32,
}

/// A section of a pixel's log.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Section {
    /// What is built before the first ray.
    Building,
    /// The path of light with this number.
    Path(u32),
    /// The pixel itself.
    Pixel,
}

impl StepRange {
    /// Does the range hold a step?
    pub fn holds(&self, step: StepAddress) -> bool {
        self.first <= step && step <= self.last
    }
}

impl StepAddress {
    /// The address of an event.
    pub fn of(record: &Record) -> Self {
        Self {
            section: Section::of(record),
            step: record.step,
        }
    }
}

impl Section {
    /// The section of an event.
    pub fn of(record: &Record) -> Self {
        match record.path {
            Some(path) => Self::Path(path),
            None if record.event.kind().is_of_building() => Self::Building,
            None => Self::Pixel,
        }
    }
}

/// `building:3`, `path17:3` or `pixel:3`.
impl fmt::Display for StepAddress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.section {
            Section::Building => write!(f, "building:{}", self.step),
            Section::Path(path) => write!(f, "path{path}:{}", self.step),
            Section::Pixel => write!(f, "pixel:{}", self.step),
        }
    }
}

/// What a line is, apart from its words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// The title of what follows.
    Heading,
    /// An ordinary line.
    Plain,
    /// Something was hit or found.
    Found,
    /// Something was missed or rejected.
    Refused,
    /// An aside.
    Aside,
    /// The line stands for others that are left out.
    Folded(Fold),
}

/// What a line leaves out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fold {
    /// The number of things that are left out: tests, edges, vertices, photons, paths, rays.
    pub hidden: usize,
    /// The option that shows what is hidden.
    pub shown_by: Unfold,
}

/// What shows the lines that a page leaves out. A renderer has its own words for it: a flag, a word, a click.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfold {
    /// [`WorkedOptions::all`](crate::explain::WorkedOptions::all).
    All,
    /// [`WorkedOptions::ray`](crate::explain::WorkedOptions::ray) with the number of this ray.
    Ray(u32),
}
