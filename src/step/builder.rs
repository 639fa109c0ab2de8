//! Puts the steps of a log together, in one pass over its records.

use std::ops::Range;

use crate::step::fold::{self, FoldKey};
use crate::step::group::{Belongs, OpenGroup, decides};
use crate::step::interest::{Interest, Interests};
use crate::step::level::Level;
use crate::step::quantity::Changed;
use crate::step::state::{Entered, State};
use crate::step::states::States;
use crate::step::step::Step;
use crate::step::verdict::Became;
use crate::trace::{Event, Kind, Record, Settings};

/// The steps of a log, and what was found on the way.
pub(in crate::step) struct Built {
    /// All steps: siblings have numbers in a row.
    pub(in crate::step) steps: Vec<Step>,
    /// The number of the leaf of each event.
    pub(in crate::step) leaves: Vec<usize>,
    /// The sections, by their numbers.
    pub(in crate::step) sections: Range<usize>,
    /// The states, of which some are kept.
    pub(in crate::step) states: States,
    /// The events that are of interest by themselves.
    pub(in crate::step) interests: Vec<(usize, Interest)>,
}

/// Puts the steps together.
pub(in crate::step) fn build(settings: &Settings, records: &[Record]) -> Built {
    let mut builder = Builder {
        records,
        steps: Vec::with_capacity(records.len()),
        leaves: vec![0; records.len()],
        open: Vec::new(),
        sections: Vec::new(),
        group: OpenGroup::default(),
        states: States::new(State::new(settings), records.len()),
        interests: Interests::default(),
    };
    for (at, record) in records.iter().enumerate() {
        builder.add(at, record);
    }
    builder.close_to(0);
    let sections = std::mem::take(&mut builder.sections);
    let sections = builder.append(sections);
    Built {
        steps: builder.steps,
        leaves: builder.leaves,
        sections,
        states: builder.states,
        interests: builder.interests.found,
    }
}

/// A step that goes on.
struct Open {
    level: Level,
    start: usize,
    lead: usize,
    nesting: usize,
    changed: Changed,
    children: Vec<Step>,
}

/// Puts the steps together.
struct Builder<'a> {
    records: &'a [Record],
    steps: Vec<Step>,
    leaves: Vec<usize>,
    /// From the section to the test, each held by the one before it.
    open: Vec<Open>,
    sections: Vec<Step>,
    /// What is open on the innermost ray.
    group: OpenGroup,
    states: States,
    interests: Interests,
}

impl Builder<'_> {
    fn add(&mut self, at: usize, record: &Record) {
        let event = &record.event;
        let entered = self.states.enter(at, record);
        if entered.is_new_section {
            self.close_to(0);
            self.push(Level::Section, at);
        }
        self.follow_rays(at, entered);
        let belongs = self.group.belongs(event);
        match belongs {
            Belongs::Ray => self.close(Level::Place),
            Belongs::Alone => self.close(Level::Test),
            Belongs::Visits => {
                self.close(Level::Test);
                if let Some(place) = self.open.last_mut() {
                    place.lead = at;
                }
                self.group.place = self.group.place.map(|(key, _)| (key, true));
            }
            Belongs::OpensPlace(key) => {
                self.close(Level::Place);
                self.push(Level::Place, at);
                self.group.place = Some((key, !matches!(event, Event::Queue(_))));
            }
            Belongs::OpensTest(key) => {
                self.close(Level::Test);
                self.push(Level::Test, at);
                self.group.test = Some((key, false));
            }
            Belongs::Joins => {}
        }
        if let (Some((key, false)), true) = (self.group.test, decides(event)) {
            self.group.test = Some((key, true));
            if let Some(test) = self.open.last_mut() {
                test.lead = at;
            }
        }
        let changed = entered.changed().and(self.states.take(at, record));
        self.interests.hear(at, record);
        let nesting = self.open.iter().filter(|open| open.level == Level::Ray);
        let leaf = Step {
            events: at..at + 1,
            level: Level::Term,
            parent: None,
            children: 0..0,
            lead: at,
            became: Became::of(event),
            folded: 0,
            nesting: nesting.count(),
            changed,
        };
        if let Some(open) = self.open.last_mut() {
            open.changed = open.changed.and(changed);
            open.children.push(leaf);
        }
        if let Event::RayEnd(_) = event {
            self.close(Level::Ray);
        }
    }

    /// Closes the steps of rays that have ended, and opens one for a ray that begins.
    fn follow_rays(&mut self, at: usize, entered: Entered) {
        let rays = self.open.iter().enumerate();
        let mut rays = rays.filter(|(_, open)| open.level == Level::Ray);
        if let Some((ended, _)) = rays.nth(entered.kept) {
            self.close_to(ended);
        }
        if entered.is_new {
            self.close(Level::Place);
            self.push(Level::Ray, at);
        }
    }

    fn nesting(&self) -> usize {
        let is_ray = |open: &&Open| open.level == Level::Ray;
        self.open.iter().filter(is_ray).count()
    }

    fn push(&mut self, level: Level, at: usize) {
        let nesting = self.nesting();
        self.open.push(Open {
            level,
            start: at,
            lead: at,
            nesting,
            changed: Changed::default(),
            children: Vec::new(),
        });
    }

    /// Closes the innermost step of this level and all that it holds, if one is open: a place and a test on the innermost
    /// ray alone. What is no place may be a test.
    fn close(&mut self, level: Level) {
        let ray = self.open.iter().rposition(|open| open.level == Level::Ray);
        let from = ray.filter(|_| level != Level::Ray).unwrap_or(0);
        let is_closed = |open: &Open| match level {
            Level::Place => matches!(open.level, Level::Place | Level::Test),
            _ => open.level == level,
        };
        // of a place and its test the place comes first
        let place = match level {
            Level::Place => self.open[from..].iter().position(is_closed),
            _ => self.open[from..].iter().rposition(is_closed),
        };
        if let Some(place) = place {
            self.close_to(from + place);
        }
    }

    /// Closes all but the outermost steps.
    fn close_to(&mut self, stay: usize) {
        while stay < self.open.len()
            && let Some(open) = self.open.pop()
        {
            match open.level {
                Level::Test => self.group.test = None,
                Level::Place => self.group.place = None,
                _ => self.group = OpenGroup::default(),
            }
            let changed = open.changed;
            let step = self.finished(open);
            match self.open.last_mut() {
                Some(around) => {
                    around.changed = around.changed.and(changed);
                    around.children.push(step);
                }
                None => self.sections.push(step),
            }
        }
    }

    /// The step of what was open.
    fn finished(&mut self, open: Open) -> Step {
        let Open {
            level,
            start,
            lead,
            nesting,
            changed,
            mut children,
        } = open;
        let is_group = matches!(level, Level::Place | Level::Test);
        if let ([_], true) = (children.as_slice(), is_group)
            && let Some(mut only) = children.pop()
        {
            // a test of one event is that event, and so is a node that is left out
            if only.is_leaf() {
                only.level = level;
                return only;
            }
            children.push(only);
        }
        let end = children.last().map_or(start, |last| last.events.end);
        let became = match level {
            Level::Section => None,
            Level::Ray => children.iter().rev().find_map(|child| match child.became {
                Some(became @ Became::Ray(_)) if child.is_leaf() => Some(became),
                _ => None,
            }),
            Level::Place => children.iter().find_map(|child| match child.became {
                Some(became @ Became::Node(_)) if child.is_leaf() => Some(became),
                _ => None,
            }),
            _ => Became::of_test(self.records, start..end),
        };
        let children = self.fold(level, children);
        let children = self.append(children);
        Step {
            events: start..end,
            level,
            parent: None,
            children,
            lead,
            became,
            folded: 0,
            nesting,
            changed,
        }
    }

    /// The children of a step with runs of one kind and verdict as one step each.
    fn fold(&mut self, parent: Level, children: Vec<Step>) -> Vec<Step> {
        let key = |child: &Step| {
            let alone = fold::stands_alone(child.level, child.changed);
            (!alone).then(|| FoldKey {
                level: child.level,
                kind: self.kind(child),
                became: child.became,
            })
        };
        let keys: Vec<Option<FoldKey>> = children.iter().map(key).collect();
        let keeps_all = matches!(parent, Level::Place | Level::Test);
        let runs = fold::runs(&keys, keeps_all);
        if runs.is_empty() {
            return children;
        }
        let mut rest = children.into_iter();
        let mut taken = 0;
        let mut folded = Vec::new();
        for run in runs {
            folded.extend(rest.by_ref().take(run.start - taken));
            let members: Vec<Step> = rest.by_ref().take(run.len()).collect();
            taken = run.end;
            folded.extend(self.one_of(members));
        }
        folded.extend(rest);
        folded
    }

    /// Several siblings as one step.
    fn one_of(&mut self, members: Vec<Step>) -> Option<Step> {
        let (first, last) = (members.first()?, members.last()?);
        let changed = members
            .iter()
            .fold(Changed::default(), |all, step| all.and(step.changed));
        let mut fold = Step {
            events: first.events.start..last.events.end,
            folded: members.len(),
            parent: None,
            children: 0..0,
            changed,
            ..first.clone()
        };
        fold.children = self.append(members);
        Some(fold)
    }

    fn kind(&self, step: &Step) -> Kind {
        self.records[step.lead].event.kind()
    }

    /// Gives numbers to siblings, and tells their children.
    fn append(&mut self, siblings: Vec<Step>) -> Range<usize> {
        let first = self.steps.len();
        for step in siblings {
            let number = self.steps.len();
            for child in step.children.clone() {
                self.steps[child].parent = Some(number);
            }
            if step.is_leaf() {
                self.leaves[step.events.start] = number;
            }
            self.steps.push(step);
        }
        first..self.steps.len()
    }
}
