//! One line of a log back into a record, or the first thing that is wrong with it.

use std::collections::HashMap;

use crate::scene::{PrimitiveId, Scene, nearest_name};
use crate::trace::fields::{Field, Fields, Visitor};
use crate::trace::flat_json::{FlatJson, Json};
use crate::trace::{Event, Kind, LogError, Record};

/// What is wrong in a line.
pub(super) struct Damage {
    pub(super) column: Option<usize>,
    pub(super) what: String,
}

impl Damage {
    /// Damage to a line that is JSON.
    pub(super) fn new(what: impl Into<String>) -> Self {
        Self {
            column: None,
            what: what.into(),
        }
    }

    /// What `serde_json` said, with its place taken out of the sentence.
    pub(super) fn json(error: &serde_json::Error) -> Self {
        let message = error.to_string();
        let end = message.rfind(" at line ").unwrap_or(message.len());
        Self {
            column: (0 < error.column()).then(|| error.column()),
            what: message[..end].into(),
        }
    }

    /// The error, with its place.
    pub(super) fn at(self, file: &str, line: usize) -> LogError {
        LogError::Line {
            file: file.into(),
            line,
            column: self.column,
            what: self.what,
        }
    }
}

/// The numbers that belong to the names of a scene.
#[derive(Debug)]
pub(super) struct NameTable {
    /// For each object its first primitive, how many it has, and whether they are faces of a mesh.
    objects: HashMap<String, (u32, u32, bool)>,
    /// For each object its place in the scene.
    places: HashMap<String, u32>,
    lights: HashMap<String, u32>,
}

impl NameTable {
    /// The names of this scene.
    pub(super) fn new(scene: &Scene) -> Self {
        let objects = scene.objects.iter();
        let lights = scene.lights.iter().enumerate();
        Self {
            objects: objects
                .map(|o| (o.name.clone(), (o.first.0, o.count, o.is_mesh)))
                .collect(),
            places: (0..)
                .zip(&scene.objects)
                .map(|(place, o)| (o.name.clone(), place))
                .collect(),
            lights: lights.map(|(i, l)| (l.name.clone(), i as u32)).collect(),
        }
    }
}

/// The record that a line holds.
pub(super) fn parse_event(line: &[u8], names: &NameTable) -> Result<Record, Damage> {
    if line.trim_ascii().is_empty() {
        return Err(Damage::new("the line is empty"));
    }
    let fields: FlatJson<'_> = serde_json::from_slice(line).map_err(|e| Damage::json(&e))?;
    let kind = match fields.peek("kind") {
        Some(Json::Text(name)) => Kind::named(name).ok_or_else(|| {
            let known = Kind::ALL.into_iter().map(Kind::name);
            let hint = nearest_name(name, known).map(|near| format!(", did you mean {near:?}?"));
            Damage::new(format!(
                "there is no kind {name:?}{}",
                hint.unwrap_or_default()
            ))
        })?,
        _ => return Err(Damage::new("the line has no \"kind\"")),
    };
    let mut reader = LineReader {
        names,
        fields,
        damage: None,
    };
    let mut record = Record {
        pixel: None,
        step: 0,
        ray: None,
        parent: None,
        event: kind.blank(),
    };
    reader.fields.take("kind");
    reader.field("step", "", &mut record.step);
    if !kind.is_of_building() {
        let mut place = [0.0; 2];
        reader.field("pixel", "", &mut place);
        let mut pixel = [0; 2];
        for (side, value) in pixel.iter_mut().zip(place) {
            *side = reader
                .expect("pixel", u32::read(&Json::Number(value)))
                .unwrap_or_default();
        }
        record.pixel = Some(pixel);
    }
    reader.optional("ray", "", &mut record.ray);
    if let Event::Ray(_) = record.event {
        reader.optional("parent", "", &mut record.parent);
    }
    record.event.fields(&mut reader);
    if let Event::Pixel(sample) = &mut record.event {
        sample.pixel = record.pixel.unwrap_or_default();
    }
    reader.finish(kind)?;
    Ok(record)
}

/// Takes each field out of the line; keeps the first thing that is wrong.
struct LineReader<'a> {
    names: &'a NameTable,
    fields: FlatJson<'a>,
    damage: Option<String>,
}

impl LineReader<'_> {
    fn finish(self, kind: Kind) -> Result<(), Damage> {
        if let Some(what) = self.damage {
            return Err(Damage::new(what));
        }
        if self.fields.all_taken() {
            return Ok(());
        }
        // something is left over: ask for the key that the kind does not have
        let known = crate::trace::schema::keys_of(kind);
        let extra = self
            .fields
            .keys()
            .find(|key| !known.iter().any(|k| k == key));
        let extra = extra.unwrap_or_default();
        let what = format!("the key {extra:?} does not belong to {:?}", kind.name());
        Err(Damage::new(what))
    }

    fn expect<T>(&mut self, key: &str, value: Result<T, String>) -> Option<T> {
        value
            .map_err(|expected| self.wrong(format!("{key:?} must be {expected}")))
            .ok()
    }

    fn wrong(&mut self, what: String) {
        self.damage.get_or_insert(what);
    }
}

impl Visitor for LineReader<'_> {
    #[inline]
    fn field<T: Field>(&mut self, key: &'static str, meaning: &'static str, value: &mut T) {
        let mut found = None;
        self.optional(key, meaning, &mut found);
        match found {
            Some(found) => *value = found,
            None => self.wrong(format!("the key {key:?} is missing")),
        }
    }

    #[inline]
    fn optional<T: Field>(&mut self, key: &'static str, _: &'static str, value: &mut Option<T>) {
        let found = self.fields.take(key).map(T::read);
        *value = found.and_then(|found| self.expect(key, found));
    }

    fn object(
        &mut self,
        [name_key, face_key]: [&'static str; 2],
        _: &'static str,
        value: &mut Option<PrimitiveId>,
        required: bool,
    ) {
        *value = None;
        let name = match self.fields.take(name_key) {
            Some(Json::Text(name)) => name.clone(),
            Some(_) => return self.wrong(format!("{name_key:?} must be a string")),
            None if required => return self.wrong(format!("the key {name_key:?} is missing")),
            None => return,
        };
        let mut face: Option<u32> = None;
        self.optional(face_key, "", &mut face);
        let Some(&(first, count, is_mesh)) = self.names.objects.get(&*name) else {
            return self.wrong(format!("there is no object {name:?}"));
        };
        match face {
            Some(face) if is_mesh && face < count => *value = Some(PrimitiveId(first + face)),
            None if !is_mesh => *value = Some(PrimitiveId(first)),
            _ => self.wrong(format!("{face_key:?} does not fit the object {name:?}")),
        }
    }

    fn whole_object(&mut self, key: &'static str, _: &'static str, value: &mut Option<u32>) {
        *value = None;
        match self.fields.take(key) {
            Some(Json::Text(name)) => match self.names.places.get(&**name) {
                Some(&place) => *value = Some(place),
                None => {
                    let what = format!("there is no object {name:?}");
                    self.wrong(what);
                }
            },
            Some(_) => self.wrong(format!("{key:?} must be a string")),
            None => {}
        }
    }

    fn light(&mut self, _: &'static str, value: &mut Option<u32>, required: bool) {
        *value = None;
        match self.fields.take("light") {
            Some(Json::Text(name)) => match self.names.lights.get(&**name) {
                Some(&light) => *value = Some(light),
                None => {
                    let what = format!("there is no light {name:?}");
                    self.wrong(what);
                }
            },
            Some(_) => self.wrong("\"light\" must be a string".into()),
            None if required => self.wrong("the key \"light\" is missing".into()),
            None => {}
        }
    }

    fn fail(&mut self, why: &'static str) {
        self.wrong(why.into());
    }
}
