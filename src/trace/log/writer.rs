//! The log as JSON Lines: a header, one line per object, then one line per event.

use std::io::{self, Write};
use std::ops::ControlFlow;

use serde::Serialize;
use smol_str::SmolStr;

use crate::scene::file::{CameraFile, LightFile, Materials, ObjectFile, ShapeFile, SidesFile};
use crate::scene::{PrimitiveId, Scene, SceneFile};
use crate::trace::event::fields::{Field, Visitor};
use crate::trace::log::fast::number_texts::NumberTexts;
use crate::trace::log::fast::short_text::ShortText;
use crate::trace::{Kind, Record, Settings, Sink};

/// The version of the log that this program writes and reads.
pub const LOG_VERSION: u32 = 2;

/// The first line: how the trace was made, and the scene but for its objects.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub(in crate::trace) struct Header {
    /// `trace`.
    pub(in crate::trace) kind: String,
    /// The version of the format: 2.
    pub(in crate::trace) version: u32,
    /// What the scene shows.
    #[serde(default)]
    pub(in crate::trace) name: String,
    /// How the trace was made.
    pub(in crate::trace) settings: Settings,
    /// The eye and the window.
    pub(in crate::trace) camera: CameraFile,
    /// The colour of a ray that meets nothing.
    pub(in crate::trace) background: [f64; 3],
    /// The ambient light.
    pub(in crate::trace) ambient: [f64; 3],
    /// The point lights.
    pub(in crate::trace) lights: Vec<LightFile>,
    /// The materials by name.
    pub(in crate::trace) materials: Materials,
    /// The largest depth of a ray.
    pub(in crate::trace) max_depth: u32,
    /// The scene's own set of slabs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(in crate::trace) slabs: Option<Vec<Vec<f64>>>,
}

/// A line that describes an object, its mesh inlined.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub(in crate::trace) struct ObjectLine {
    /// `object`.
    pub(in crate::trace) kind: String,
    /// Its name.
    pub(in crate::trace) name: SmolStr,
    /// The name of its material.
    pub(in crate::trace) material: SmolStr,
    /// Its form.
    pub(in crate::trace) shape: ShapeFile,
    /// Which sides of its surface can be seen.
    #[serde(default)]
    pub(in crate::trace) sides: SidesFile,
}

/// Writes the header and the objects: what a log needs to stand alone.
///
/// # Errors
/// Those of the output.
pub fn write_log_head(scene: &Scene, settings: &Settings, out: &mut impl Write) -> io::Result<()> {
    let SceneFile {
        name,
        camera,
        background,
        ambient,
        lights,
        materials,
        objects: _,
        max_depth,
        slabs,
    } = scene.head();
    let header = Header {
        kind: "trace".into(),
        version: LOG_VERSION,
        name,
        settings: settings.clone(),
        camera,
        background,
        ambient,
        lights,
        materials,
        max_depth,
        slabs,
    };
    write_line(&header, out)?;
    for object in &scene.objects {
        let ObjectFile {
            name,
            material,
            shape,
            sides,
        } = scene.object_file(object);
        let line = ObjectLine {
            kind: "object".into(),
            name,
            material,
            shape,
            sides,
        };
        write_line(&line, out)?;
    }
    Ok(())
}

fn write_line(line: &impl Serialize, out: &mut impl Write) -> io::Result<()> {
    serde_json::to_writer(&mut *out, line)?;
    out.write_all(b"\n")
}

/// The names of a scene as JSON strings, made once.
#[derive(Clone, Debug)]
pub struct LogNames {
    /// For each primitive its object, and for a face of a mesh its number.
    primitives: Vec<(u32, Option<u32>)>,
    objects: Vec<String>,
    lights: Vec<String>,
}

impl LogNames {
    /// The names of this scene.
    pub fn new(scene: &Scene) -> Self {
        let quoted = |name: &str| serde_json::Value::from(name).to_string();
        let ids = (0..scene.primitives.len() as u32).map(PrimitiveId);
        Self {
            primitives: ids
                .map(|id| (scene.primitive(id).object, scene.name_of(id).1))
                .collect(),
            objects: scene.objects.iter().map(|o| quoted(&o.name)).collect(),
            lights: scene.lights.iter().map(|l| quoted(&l.name)).collect(),
        }
    }
}

/// Makes lines of records and keeps them in one buffer, for their taker to empty.
#[derive(Clone, Debug)]
pub struct LineSink<'a> {
    writer: EventWriter<'a>,
    /// Whole lines, each with its end.
    pub lines: Vec<u8>,
    /// How many lines were made.
    pub count: u64,
}

impl<'a> LineSink<'a> {
    /// An empty buffer.
    pub fn new(names: &'a LogNames) -> Self {
        Self {
            writer: EventWriter::new(names),
            lines: Vec::new(),
            count: 0,
        }
    }
}

impl Sink for LineSink<'_> {
    #[inline]
    fn record(&mut self, record: &Record) -> ControlFlow<()> {
        self.writer.line(record, &mut self.lines);
        self.count += 1;
        ControlFlow::Continue(())
    }
}

/// Writes the events of a scene, one after the other.
#[derive(Clone, Debug)]
pub(crate) struct EventWriter<'a> {
    names: &'a LogNames,
    texts: NumberTexts,
    place: PlaceText,
}

impl<'a> EventWriter<'a> {
    /// A writer for the scene of these names.
    pub(crate) fn new(names: &'a LogNames) -> Self {
        Self {
            names,
            texts: NumberTexts::remembering(),
            place: PlaceText::default(),
        }
    }

    /// Appends a record as a line.
    #[inline]
    pub(crate) fn line(&mut self, record: &Record, lines: &mut Vec<u8>) {
        self.object(record, lines);
        lines.push(b'\n');
    }

    /// Appends a record as a JSON object.
    fn object(&mut self, record: &Record, line: &mut Vec<u8>) {
        let mut record = *record;
        LINE_STARTS[record.event.kind() as usize].append_to(line);
        let mut writer = LineWriter {
            names: self.names,
            texts: &mut self.texts,
            line,
        };
        record.step_field(&mut writer);
        self.place.append(&mut record, &mut writer);
        record.event_fields(&mut writer);
        line.push(b'}');
    }
}

/// Appends a single record as one JSON object, without a line's end.
pub(crate) fn write_event(record: &Record, names: &LogNames, line: &mut Vec<u8>) {
    let mut writer = EventWriter {
        names,
        texts: NumberTexts::default(),
        place: PlaceText::default(),
    };
    writer.object(record, line);
}

/// How the lines of each kind begin, by its number.
static LINE_STARTS: [ShortText<31>; Kind::ALL.len()] = {
    let mut starts = [ShortText::EMPTY; Kind::ALL.len()];
    let mut at = 0;
    while at < starts.len() {
        let kind = Kind::ALL[at];
        let start = ShortText::EMPTY.with(b"{\"kind\":\"").expect("room");
        let start = start.with(kind.name().as_bytes()).expect("room");
        starts[kind as usize] = start.with(b"\"").expect("room");
        at += 1;
    }
    starts
};

/// The fields of a line that tell where its event belongs: the next line mostly has the same.
#[derive(Clone, Debug, Default)]
struct PlaceText {
    /// Pixel, path, ray and parent of the line before.
    of: (Option<[u32; 2]>, Option<u32>, Option<u32>, Option<u32>),
    text: Vec<u8>,
}

impl PlaceText {
    /// Appends the fields of a record's place.
    #[inline]
    fn append(&mut self, record: &mut Record, writer: &mut LineWriter<'_>) {
        let of = (record.pixel, record.path, record.ray, record.parent);
        if self.of == of {
            writer.line.extend_from_slice(&self.text);
            return;
        }
        let start = writer.line.len();
        record.place_fields(writer);
        self.of = of;
        self.text.clear();
        self.text.extend_from_slice(&writer.line[start..]);
    }
}

/// Puts each field into the line.
struct LineWriter<'a> {
    names: &'a LogNames,
    texts: &'a mut NumberTexts,
    line: &'a mut Vec<u8>,
}

/// No key is longer.
const LONGEST_KEY: usize = 28;

#[expect(
    clippy::inline_always,
    reason = "where its key is known, a key is a few stores; elsewhere it is three calls"
)]
impl LineWriter<'_> {
    #[inline(always)]
    fn key(&mut self, key: &'static str) {
        // put together while compiling, and one copy into the line
        let mut text = [0; LONGEST_KEY + 4];
        let end = 2 + key.len();
        text[..2].copy_from_slice(b",\"");
        text[2..end].copy_from_slice(key.as_bytes());
        text[end..end + 2].copy_from_slice(b"\":");
        self.line.extend_from_slice(&text[..end + 2]);
    }
}

#[expect(
    clippy::inline_always,
    reason = "where its key is known, a key is a few stores; elsewhere it is three calls"
)]
impl Visitor for LineWriter<'_> {
    #[inline(always)]
    fn field<T: Field>(&mut self, key: &'static str, _: &'static str, value: &mut T) {
        let start = self.line.len();
        self.key(key);
        // infinity has no JSON: the field is absent
        if !value.write(self.texts, self.line) {
            self.line.truncate(start);
        }
    }

    #[inline(always)]
    fn optional<T: Field>(
        &mut self,
        key: &'static str,
        meaning: &'static str,
        value: &mut Option<T>,
    ) {
        if let Some(value) = value {
            self.field(key, meaning, value);
        }
    }

    #[inline(always)]
    fn object(
        &mut self,
        [name, face]: [&'static str; 2],
        _: &'static str,
        value: &mut Option<PrimitiveId>,
        _: bool,
    ) {
        if let Some(id) = value {
            let (object, number) = self.names.primitives[id.0 as usize];
            self.key(name);
            let quoted = &self.names.objects[object as usize];
            self.line.extend_from_slice(quoted.as_bytes());
            self.optional(face, "", &mut { number });
        }
    }

    fn whole_object(&mut self, key: &'static str, _: &'static str, value: &mut Option<u32>) {
        if let Some(object) = value {
            self.key(key);
            let quoted = &self.names.objects[*object as usize];
            self.line.extend_from_slice(quoted.as_bytes());
        }
    }

    fn light(&mut self, _: &'static str, value: &mut Option<u32>, _: bool) {
        if let Some(light) = value {
            self.key("light");
            let quoted = &self.names.lights[*light as usize];
            self.line.extend_from_slice(quoted.as_bytes());
        }
    }

    fn fail(&mut self, why: &'static str) {
        debug_assert!(false, "an event of the tracer contradicts itself: {why}");
    }
}
