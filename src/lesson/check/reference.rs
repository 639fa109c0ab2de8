//! A pixel as the crate traces it: its rays with their events, and what a ray of the log's own is tested against.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;

use crate::geometry::{Ray, TRange};
use crate::lesson::check::error::CheckError;
use crate::lesson::check::value::Fields;
use crate::scene::{PrimitiveId, Scene};
use crate::strategy::{Chosen, Exhaustive, Hit, Search, Strategy};
use crate::trace::{
    Event, Kind, LogNames, Off, RayStart, Record, Recorder, Recording, Settings, Shade,
};
use crate::tracer::{Tracer, trace_pixel};

/// The scene and the strategies by which it is traced.
pub(super) struct Reference<'a, 's> {
    pub(super) scene: &'a Scene,
    chosen: &'a [(&'a Settings, &'a Chosen<'s>)],
    pub(super) names: LogNames,
}

/// A pixel.
pub(super) struct ExpectedPixel {
    /// What belongs to no ray.
    pub(super) own: Vec<Expected>,
    pub(super) rays: Vec<ExpectedRay>,
    /// The kinds of the first strategy: what a plain ray tracer does.
    pub(super) kinds: BTreeSet<Kind>,
}

/// A ray.
pub(super) struct ExpectedRay {
    pub(super) start: RayStart,
    pub(super) parent: Option<usize>,
    pub(super) events: Vec<Expected>,
    /// What the ray ends with.
    pub(super) hit: Option<Hit>,
}

impl ExpectedRay {
    /// The shade of the point that the ray hits.
    pub(super) fn shade(&self) -> Option<&Shade> {
        self.events.iter().find_map(|of| match &of.event {
            Event::Shade(shade) => Some(shade),
            _ => None,
        })
    }
}

/// An event with its fields.
#[derive(Clone, Debug)]
pub(super) struct Expected {
    pub(super) event: Event,
    pub(super) step: u32,
    pub(super) fields: Fields,
}

impl Expected {
    pub(super) fn kind(&self) -> Kind {
        self.event.kind()
    }
}

impl<'a, 's> Reference<'a, 's> {
    pub(super) fn new(scene: &'a Scene, chosen: &'a [(&'a Settings, &'a Chosen<'s>)]) -> Self {
        Self {
            scene,
            chosen,
            names: LogNames::new(scene),
        }
    }

    /// The events of a pixel. Of each kind the first strategy that has any of it counts.
    pub(super) fn pixel(&self, pixel: [u32; 2]) -> Result<ExpectedPixel, CheckError> {
        let mut found = ExpectedPixel {
            own: Vec::new(),
            rays: Vec::new(),
            kinds: BTreeSet::new(),
        };
        for (settings, chosen) in self.chosen {
            let tracer = Tracer::new(self.scene, *chosen, settings.transport);
            let mut recording = Recording::new(Vec::new());
            trace_pixel(&tracer, pixel, settings.through, &mut recording)?;
            self.add(&mut found, recording.into_sink());
        }
        Ok(found)
    }

    fn add(&self, found: &mut ExpectedPixel, records: Vec<Record>) {
        let is_first = found.kinds.is_empty();
        let mut places = BTreeMap::new();
        let has: Vec<Vec<Kind>> = found
            .rays
            .iter()
            .map(|ray| ray.events.iter().map(Expected::kind).collect())
            .collect();
        for record in records {
            // a half-line from p′ may go either way, so its edges are not compared
            if is_first && record.event.kind() != Kind::Edge {
                found.kinds.insert(record.event.kind());
            }
            let expected = Expected {
                event: record.event,
                step: record.step,
                fields: Fields::of(&record, &self.names),
            };
            let Some(ray) = record.ray else {
                if is_first {
                    found.own.push(expected);
                }
                continue;
            };
            let count = places.len();
            let place = *places.entry(ray).or_insert(count);
            if let (true, Event::Ray(start)) = (is_first, &record.event) {
                let parent = record.parent.and_then(|of| places.get(&of).copied());
                found.rays.push(ExpectedRay {
                    start: *start,
                    parent,
                    events: Vec::new(),
                    hit: None,
                });
            }
            let Some(ray) = found.rays.get_mut(place) else {
                continue;
            };
            if let (true, Event::RayEnd(end)) = (is_first, &record.event) {
                ray.hit = end.object.zip(end.t).map(|(object, t)| Hit { object, t });
            }
            let known = has
                .get(place)
                .is_some_and(|kinds| kinds.contains(&expected.kind()));
            if !known {
                ray.events.push(expected);
            }
        }
    }

    /// What every object says to a ray, whichever is the nearest.
    pub(super) fn tests(&self, ray: &Ray, range: TRange) -> Vec<Expected> {
        let mut recording = Recording::new(Vec::new());
        let mut everything = Everything { range };
        let searched = Exhaustive::new(self.scene).search(ray, &mut everything, &mut recording);
        debug_assert!(searched.is_continue(), "nothing ends this search");
        let records: Vec<Record> = recording.into_sink();
        records
            .iter()
            .map(|record| Expected {
                event: record.event,
                step: record.step,
                fields: Fields::of_event(record.event, &self.names),
            })
            .collect()
    }

    /// The nearest hit of a ray.
    pub(super) fn nearest(&self, ray: &Ray, range: TRange) -> Option<Hit> {
        Exhaustive::new(self.scene).nearest(ray, range, &mut Off)
    }

    pub(super) fn name(&self, object: PrimitiveId) -> &str {
        &self.scene.object_of(object).name
    }
}

/// A search that takes no hit, so that every object is tested in the whole range.
struct Everything {
    range: TRange,
}

impl Search for Everything {
    fn range(&self) -> TRange {
        self.range
    }

    fn offer<R: Recorder>(&mut self, _: PrimitiveId, _: f64, _: &mut R) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}
