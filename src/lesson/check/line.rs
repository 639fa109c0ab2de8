//! One line of a foreign log: what it is about, and what is wrong with it.

use std::collections::{BTreeMap, BTreeSet};

use crate::lesson::check::value::{Fields, Value};
use crate::scene::{Scene, nearest_name, printable, quoted};
use crate::trace::{Kind, Purpose, fields_of};

/// A line.
#[derive(Clone, Debug)]
pub(super) struct Line {
    /// From 1.
    pub(super) number: u64,
    pub(super) kind: Kind,
    pub(super) pixel: [u32; 2],
    /// The number that the log has for the ray, if it numbers rays.
    pub(super) ray: Option<u64>,
    /// The number of the ray at whose hit this one starts.
    pub(super) parent: Option<u64>,
    pub(super) purpose: Option<Purpose>,
    pub(super) fields: Fields,
    /// Keys that no line of this kind has.
    pub(super) unknown: Vec<String>,
}

/// What a line can be.
pub(super) enum Read {
    Line(Box<Line>),
    /// A head, an object, a path of light: nothing to compare.
    Aside(String),
}

/// What is wrong with a line, and what to do.
pub(super) struct Wrong {
    pub(super) what: String,
    pub(super) fix: String,
}

fn wrong(what: impl Into<String>, fix: impl Into<String>) -> Wrong {
    Wrong {
        what: what.into(),
        fix: fix.into(),
    }
}

/// Names that a line may mention.
pub(super) struct Known<'a> {
    objects: BTreeSet<&'a str>,
    lights: BTreeSet<&'a str>,
    pixels: [u32; 2],
    fields: BTreeMap<Kind, BTreeMap<String, Vec<String>>>,
}

/// Keys that a line of any kind may have.
const EVERYWHERE: [&str; 6] = ["kind", "step", "pixel", "ray", "parent", "purpose"];

impl<'a> Known<'a> {
    pub(super) fn of(scene: &'a Scene) -> Self {
        Self {
            objects: scene.objects.iter().map(|of| of.name.as_str()).collect(),
            lights: scene.lights.iter().map(|of| of.name.as_str()).collect(),
            pixels: scene.camera.pixels,
            fields: Kind::ALL
                .map(|kind| (kind, fields_of(kind).into_iter().collect()))
                .into(),
        }
    }

    /// The key of this kind that a word is most like.
    pub(super) fn nearest_key(&self, kind: Kind, key: &str) -> Option<String> {
        let keys = self.fields.get(&kind)?.keys();
        nearest_name(key, keys.map(String::as_str))
    }

    /// The keys that no line of this kind has. A word in the place of one of a few others is a mistake of the line.
    fn unknown(&self, kind: Kind, fields: &Fields) -> Result<Vec<String>, Wrong> {
        let known = &self.fields[&kind];
        let mut unknown = Vec::new();
        for (key, value) in &fields.0 {
            if EVERYWHERE.contains(&key.as_str()) {
                continue;
            }
            match (known.get(key), value) {
                (None, _) => unknown.push(key.clone()),
                (Some(words), Value::Text(word)) if !words.is_empty() && !words.contains(word) => {
                    return Err(no_such_word(key, word, words));
                }
                _ => {}
            }
        }
        Ok(unknown)
    }

    fn check(&self, fields: &Fields) -> Result<(), Wrong> {
        for (key, what, names) in [
            ("object", "object", &self.objects),
            ("light", "light", &self.lights),
        ] {
            let Some(value) = fields.get(key) else {
                continue;
            };
            let Value::Text(name) = value else {
                let has = value.what();
                return Err(wrong(
                    format!("{key:?} has {has}; it is the name of an {what} of the scene")
                        .replace("an light", "a light"),
                    "write the name in quotation marks",
                ));
            };
            if !names.contains(name.as_str()) {
                let near = nearest_name(name, names.iter().copied());
                let fix = match near {
                    Some(near) => format!("did you mean {near:?}?"),
                    None => format!(
                        "write one of its names, such as {:?}",
                        names.first().unwrap_or(&"")
                    ),
                };
                return Err(wrong(
                    format!("the scene has no {what} {:?}", printable(name)),
                    fix,
                ));
            }
        }
        Ok(())
    }
}

/// Lines of our own log that say nothing of a ray.
const ASIDE: [&str; 4] = ["trace", "object", "picture", "pixel_tests"];

impl Line {
    /// A line without its end; `pixel` is that of the line before.
    pub(super) fn read(
        text: &[u8],
        number: u64,
        known: &Known<'_>,
        before: Option<[u32; 2]>,
    ) -> Result<Read, Wrong> {
        let fields: Fields = serde_json::from_slice(text).map_err(|error| of_json(text, &error))?;
        let kind = match fields.get("kind") {
            Some(Value::Text(kind)) => kind,
            Some(other) => {
                let what = format!("\"kind\" has {}; it is a word", other.what());
                return Err(wrong(what, "as in \"kind\": \"sphere_test\""));
            }
            None => {
                return Err(wrong(
                    "the line has no \"kind\"",
                    "say what the line is about, as in \"kind\": \"sphere_test\"",
                ));
            }
        };
        if ASIDE.contains(&kind.as_str()) || fields.get("path").is_some() {
            return Ok(Read::Aside(kind.clone()));
        }
        let Some(kind) = Kind::named(kind) else {
            let near = nearest_name(kind, Kind::ALL.into_iter().map(Kind::name));
            let fix = match near {
                Some(near) => format!("did you mean {near:?}?"),
                None => "write one such as pixel, ray, sphere_test, plane_test, nearest, light_term, shade or pixel_colour".into(),
            };
            return Err(wrong(
                format!("there is no kind {:?}", printable(kind)),
                fix,
            ));
        };
        known.check(&fields)?;
        let unknown = known.unknown(kind, &fields)?;
        let pixel = match pixel_of(&fields)? {
            Some(pixel) => pixel,
            None => before.ok_or_else(|| {
                wrong(
                    "the line has no \"pixel\"",
                    "say which pixel it belongs to, as in \"pixel\": [80, 60]",
                )
            })?,
        };
        let [width, height] = known.pixels;
        if width <= pixel[0] || height <= pixel[1] {
            let [x, y] = pixel;
            return Err(wrong(
                format!("pixel {x},{y} is not in the picture of {width} × {height} pixels"),
                "count columns from 0 at the left and rows from 0 at the top",
            ));
        }
        let purpose = match fields.get("purpose") {
            None | Some(Value::Nothing) => None,
            Some(Value::Text(word)) => Some(purpose(word)?),
            Some(other) => {
                let what = format!("\"purpose\" has {}; it is a word", other.what());
                return Err(wrong(
                    what,
                    "write \"eye\", \"shadow\", \"reflected\" or \"refracted\"",
                ));
            }
        };
        Ok(Read::Line(Box::new(Self {
            number,
            kind,
            pixel,
            ray: whole(&fields, "ray")?,
            parent: whole(&fields, "parent")?,
            purpose,
            fields,
            unknown,
        })))
    }
}

/// A word that is none of those that a field has.
fn no_such_word(key: &str, word: &str, words: &[String]) -> Wrong {
    let all: Vec<String> = words.iter().map(|word| format!("{word:?}")).collect();
    let all = match all.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        _ => all.concat(),
    };
    let fix = match nearest_name(word, words.iter().map(String::as_str)) {
        Some(near) => format!("it is {all}; did you mean {near:?}?"),
        None => format!("it is {all}"),
    };
    wrong(format!("{key:?} has the word {}", quoted(word)), fix)
}

/// A number of a ray.
fn whole(fields: &Fields, key: &str) -> Result<Option<u64>, Wrong> {
    match fields.get(key) {
        None | Some(Value::Nothing) => Ok(None),
        Some(Value::Number(number)) if is_whole(*number) => Ok(Some(*number as u64)),
        Some(other) => Err(wrong(
            format!(
                "{key:?} has {}; it is the number of a ray in its pixel",
                said(other)
            ),
            "count the rays of a pixel from 0, or leave the key out and write \"purpose\"",
        )),
    }
}

fn is_whole(number: f64) -> bool {
    /// All whole numbers up to here are f64s.
    const MOST: f64 = 9_007_199_254_740_992.0;
    (0.0..=MOST).contains(&number) && number.fract() == 0.0
}

fn pixel_of(fields: &Fields) -> Result<Option<[u32; 2]>, Wrong> {
    let value = match fields.get("pixel") {
        None | Some(Value::Nothing) => return Ok(None),
        Some(value) => value,
    };
    if let Value::List(list) = value
        && let [x, y] = list.as_slice()
        && is_whole(*x)
        && is_whole(*y)
        && x.max(*y) <= f64::from(u32::MAX)
    {
        return Ok(Some([*x as u32, *y as u32]));
    }
    Err(wrong(
        format!("\"pixel\" has {}; it is [column, row]", said(value)),
        "write two whole numbers, as in \"pixel\": [80, 60]",
    ))
}

fn purpose(word: &str) -> Result<Purpose, Wrong> {
    const ALL: [Purpose; 4] = [
        Purpose::Eye,
        Purpose::Shadow,
        Purpose::Reflected,
        Purpose::Refracted,
    ];
    let found = ALL.into_iter().find(|purpose| purpose.word() == word);
    found.ok_or_else(|| {
        let near = nearest_name(word, ALL.into_iter().map(Purpose::word));
        let fix = near.map_or(
            "write \"eye\", \"shadow\", \"reflected\" or \"refracted\"".into(),
            |near| format!("did you mean {near:?}?"),
        );
        wrong(format!("there is no purpose {:?}", printable(word)), fix)
    })
}

fn said(value: &Value) -> String {
    match value {
        Value::Text(text) => format!("the word {:?}", printable(text)),
        Value::Number(number) => format!("the number {number}"),
        Value::List(_) => value.to_string(),
        other => other.what().into(),
    }
}

/// Why a line is no JSON object.
fn of_json(text: &[u8], error: &serde_json::Error) -> Wrong {
    if error.is_data() {
        let what = error.to_string();
        let what = what.split(" at line ").next().unwrap_or_default();
        return wrong(
            format!("the line is no object of fields: {what}"),
            "write one object a line, as in {\"kind\": \"ray\", \"pixel\": [80, 60]}",
        );
    }
    let column = error.column();
    let rest = &text[column.saturating_sub(1).min(text.len())..];
    let begins = |words: &[&str]| {
        words.iter().any(|word| {
            rest.len() >= word.len() && rest[..word.len()].eq_ignore_ascii_case(word.as_bytes())
        })
    };
    let around = &text[column.saturating_sub(4).min(text.len())..];
    let is_no_number = ["nan", "inf"].iter().any(|word| {
        around
            .windows(word.len())
            .take(6)
            .any(|letters| letters.eq_ignore_ascii_case(word.as_bytes()))
    });
    if begins(&["nan", "inf"]) || is_no_number {
        return wrong(
            format!("NaN and infinity are no numbers in JSON, at column {column}"),
            "leave the field out where there is no number",
        );
    }
    if error.is_eof() {
        return wrong(
            "the line ends before its object does",
            "write one object a line, with its closing brace; was the log cut off?",
        );
    }
    let what = error.to_string();
    let what = what.split(" at line ").next().unwrap_or_default();
    wrong(
        format!("the line is no JSON: {what}, at column {column}"),
        "write one object a line, as in {\"kind\": \"ray\", \"pixel\": [80, 60]}",
    )
}
