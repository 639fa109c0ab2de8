//! The trace that a question is about.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde_json::Value;

use crate::lesson::question::facts::{EventFacts, Facts};
use crate::lesson::question::fault::Fault;
use crate::lesson::question::spec::{QuestionSpec, Selector};
use crate::scene::{Loaded, Scene};
use crate::strategy::Chosen;
use crate::trace::{Event, Kind, LogNames, Record, Region, Settings, write_event};
use crate::tracer::entry::{ChosenTracer, record_pixel};
use crate::tracer::{Tracer, check_light_of, follow_light};

/// The most events of a pixel.
const MOST_EVENTS: u64 = 1_000_000;

/// The pixel that a question is about, traced.
#[derive(Clone, Debug)]
pub struct TracedPixel {
    /// The scene.
    pub scene: Arc<Scene>,
    /// How it was traced.
    pub settings: Settings,
    /// The pixel.
    pub pixel: [u32; 2],
    /// Its events, with those of the building and of the paths of light that led to it.
    pub records: Arc<[Record]>,
    /// The scene's file.
    pub(super) file: Value,
}

/// How a question is traced.
pub(super) fn settings_of(spec: &QuestionSpec) -> Settings {
    Settings {
        strategy: spec.strategy,
        structure: spec.structure,
        building: true,
        transport: spec.transport,
        light: spec.light,
        through: spec.through,
        ..Settings::default()
    }
}

impl TracedPixel {
    /// Traces the question's pixel in a scene.
    pub(super) fn new(loaded: Loaded, spec: &QuestionSpec) -> Result<Self, Fault> {
        let file = serde_json::to_value(&loaded.scene);
        let file =
            file.map_err(|error| Fault::new("scene", error.to_string(), "change the scene"))?;
        let scene = loaded.build().map_err(Fault::load)?;
        let mut found = Vec::new();
        traced(&scene, spec, &[spec.pixel], &mut |_, records| {
            found = records;
            Ok(())
        })?;
        Ok(Self {
            scene: Arc::new(scene),
            settings: settings_of(spec),
            pixel: spec.pixel,
            records: found.into(),
            file,
        })
    }

    /// The scene's file, as JSON.
    pub fn file(&self) -> &Value {
        &self.file
    }

    /// Every pixel of the picture, traced the same way one after the other, in rows from the top.
    pub(super) fn each_pixel(
        &self,
        spec: &QuestionSpec,
        mut hear: impl FnMut([u32; 2], Vec<Record>) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        let [width, height] = self.scene.camera.pixels;
        let all: Vec<[u32; 2]> = (0..height)
            .flat_map(|y| (0..width).map(move |x| [x, y]))
            .collect();
        traced(&self.scene, spec, &all, &mut hear)
    }

    pub(super) fn names(&self) -> LogNames {
        LogNames::new(&self.scene)
    }

    /// The fields of an event.
    pub(super) fn facts(&self, record: &Record) -> EventFacts {
        facts_of(record, &self.names())
    }
}

/// Traces some pixels and hands out their events.
fn traced(
    scene: &Scene,
    spec: &QuestionSpec,
    pixels: &[[u32; 2]],
    hear: &mut dyn FnMut([u32; 2], Vec<Record>) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let settings = settings_of(spec);
    let [width, height] = scene.camera.pixels;
    if let Some([x, y]) = pixels.iter().find(|[x, y]| width <= *x || height <= *y) {
        return Err(Fault::new(
            "pixel",
            format!("pixel {x},{y} is not in the picture of {width} × {height} pixels"),
            "count columns from 0 at the left and rows from 0 at the top",
        ));
    }
    let chosen = Chosen::new(scene, settings.strategy, &settings.structure)
        .map_err(|fault| Fault::new("structure", fault.to_string(), "change \"structure\""))?;
    let no_light = |what: String| Fault::new("light", what, "change \"transport\" or \"light\"");
    check_light_of(scene, &chosen, &settings).map_err(|fault| no_light(fault.to_string()))?;
    let stopped = |stopped: crate::tracer::Stopped| {
        let fix = "choose another pixel, or a scene with fewer objects or a smaller \"max_depth\"";
        Fault::new("pixel", stopped.to_string(), fix)
    };
    let region = pixels.first().map(|pixel| match pixels {
        [_] => Region::pixel(*pixel),
        _ => Region::whole(scene.camera.pixels),
    });
    let light = follow_light(scene, &chosen, &settings, region, None, &|_| {}).map_err(stopped)?;
    let tracer: ChosenTracer<'_, '_> =
        Tracer::new(scene, &chosen, settings.transport).with_light(light.as_ref());
    for &pixel in pixels {
        let records = record_pixel(&tracer, pixel, settings.through, true, MOST_EVENTS);
        hear(pixel, records.map_err(stopped)?)?;
    }
    Ok(())
}

/// The fields of an event as the log has them.
pub(super) fn facts_of(record: &Record, names: &LogNames) -> EventFacts {
    let mut line = Vec::new();
    write_event(record, names, &mut line);
    EventFacts {
        kind: record.event.kind(),
        fields: serde_json::from_slice(&line).unwrap_or_default(),
    }
}

/// The same of an event that is in no log.
pub(super) fn facts_of_event(event: Event, like: &Record, names: &LogNames) -> EventFacts {
    facts_of(&Record { event, ..*like }, names)
}

/// The places of the events that a selector chooses, in the order of the log. `nth` is not looked at.
pub(super) fn chosen(
    records: &[Record],
    names: &LogNames,
    selector: &Selector,
    facts: &Facts<'_>,
) -> Result<Vec<usize>, String> {
    let kind = kind_of(selector)?;
    let mut found = Vec::new();
    for (place, record) in records.iter().enumerate() {
        let is_there = record.event.kind() == kind
            && selector.ray.is_none_or(|ray| record.ray == Some(ray))
            && record.path == selector.path;
        if !is_there {
            continue;
        }
        let own = facts_of(record, names);
        let is_object = |name: &String| own.fields.get("object").is_some_and(|of| of == name);
        if !selector.object.as_ref().is_none_or(is_object) {
            continue;
        }
        if let Some(holds) = &selector.holds {
            let facts = Facts {
                own: Some(own),
                ..facts.clone()
            };
            if !facts
                .value(holds)?
                .flag()
                .map_err(|what| format!("{holds:?}: {what}"))?
            {
                continue;
            }
        }
        found.push(place);
    }
    Ok(found)
}

fn kind_of(selector: &Selector) -> Result<Kind, String> {
    Kind::named(&selector.kind).ok_or_else(|| {
        let names = Kind::ALL.map(Kind::name);
        let near = crate::scene::nearest_name(&selector.kind, names.iter().copied());
        let near = near.map_or(String::new(), |near| format!("; did you mean {near}?"));
        format!("there is no kind of event {:?}{near}", selector.kind)
    })
}

/// The place of the one event that a selector chooses.
pub(super) fn chosen_one(
    records: &[Record],
    names: &LogNames,
    selector: &Selector,
    facts: &Facts<'_>,
) -> Result<usize, String> {
    let found = chosen(records, names, selector, facts)?;
    match (selector.nth, found.as_slice()) {
        (None, [one]) => Ok(*one),
        (None, []) => Err(format!("no {} is there that is asked for", selector.kind)),
        (None, several) => Err(format!(
            "{} of kind {} are there, and one is asked for",
            several.len(),
            selector.kind
        )),
        (Some(nth), found) => found.get(nth).copied().ok_or_else(|| {
            format!(
                "there is no {} number {nth}: {} are there, from 0",
                selector.kind,
                found.len()
            )
        }),
    }
}

/// Scene values changed by their JSON pointers.
pub(in crate::lesson) fn edited(
    loaded: &Loaded,
    change: &BTreeMap<String, Value>,
) -> Result<Loaded, (String, String)> {
    let mut file =
        serde_json::to_value(&loaded.scene).map_err(|error| (String::new(), error.to_string()))?;
    for (pointer, value) in change {
        let place = file.pointer_mut(pointer);
        let place =
            place.ok_or_else(|| (pointer.clone(), format!("the scene has no {pointer:?}")))?;
        *place = match value.as_f64() {
            // what counts stays a whole number: 640.0 pixels are 640
            Some(number) if place.is_u64() && 0.0 <= number && number.fract() == 0.0 => {
                Value::from(number as u64)
            }
            _ => value.clone(),
        };
    }
    let mut changed = loaded.clone();
    changed.scene = serde_json::from_value(file)
        .map_err(|error| (String::new(), format!("the changed scene is none: {error}")))?;
    Ok(changed)
}
