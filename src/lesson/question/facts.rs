//! The facts that expressions look names up in, and texts with expressions in braces.

use std::cell::Cell;
use std::collections::BTreeMap;

use serde_json::Value;

use crate::lesson::question::expression::{Datum, Names, evaluate};
use crate::scene::nearest_name;
use crate::trace::{Kind, keys_of};

/// Significant digits of a number in a text, as in the worked solution.
const DIGITS: u32 = 6;

/// No expression refers to others this deep.
const DEEPEST: u32 = 8;

/// An event as facts: its fields, and which keys its kind may have.
#[derive(Clone, Debug)]
pub(super) struct EventFacts {
    pub(super) kind: Kind,
    pub(super) fields: Value,
}

/// What names stand for.
#[derive(Clone, Debug, Default)]
pub(super) struct Facts<'a> {
    /// The event whose fields stand for themselves.
    pub(super) own: Option<EventFacts>,
    /// Events by names.
    pub(super) events: BTreeMap<String, EventFacts>,
    /// How many events of each kind there are.
    pub(super) counts: BTreeMap<&'static str, f64>,
    /// The facts of the changed scene.
    pub(super) after: Option<Box<Facts<'a>>>,
    /// The scene's file.
    pub(super) scene: Option<&'a Value>,
    /// Expressions by names.
    pub(super) names: Option<&'a BTreeMap<String, String>>,
    /// How deep expressions refer to others here.
    pub(super) depth: Cell<u32>,
}

impl Names for Facts<'_> {
    fn find(&self, name: &str) -> Result<Datum, String> {
        let (first, rest) = match name.split_once('.') {
            Some((first, rest)) => (first, Some(rest)),
            None => (name, None),
        };
        if let Some(text) = self.names.and_then(|names| names.get(first)) {
            if DEEPEST <= self.depth.get() {
                return Err(format!("{first:?} refers to itself"));
            }
            self.depth.set(self.depth.get() + 1);
            let value = evaluate(text, self);
            self.depth.set(self.depth.get() - 1);
            return match rest {
                None => value,
                Some(rest) => {
                    part(&value?, rest).ok_or_else(|| format!("nothing is called {name:?}"))
                }
            };
        }
        match (first, rest) {
            ("after", Some(rest)) => {
                let after = self.after.as_deref();
                after
                    .ok_or("nothing is changed, so there is no \"after\"")?
                    .find(rest)
            }
            ("count", Some(rest)) => match Kind::named(rest) {
                Some(kind) => {
                    let count = self.counts.get(kind.name());
                    Ok(Datum::Number(count.copied().unwrap_or(0.0)))
                }
                None => Err(format!("there is no kind of event {rest:?}")),
            },
            ("scene", Some(rest)) => {
                let scene = self.scene.ok_or("there is no scene here")?;
                let found = walked(scene, rest);
                found.ok_or_else(|| format!("the scene has no {rest:?}"))
            }
            (_, Some(rest)) if self.events.contains_key(first) => {
                self.events[first].find(rest, name)
            }
            _ => match &self.own {
                Some(own) => own.find(name, name),
                None => Err(format!("nothing is called {name:?}")),
            },
        }
    }
}

impl EventFacts {
    fn find(&self, path: &str, name: &str) -> Result<Datum, String> {
        if let Some(found) = walked(&self.fields, path) {
            return Ok(found);
        }
        let key = path.split('.').next().unwrap_or(path);
        let known = keys_of(self.kind);
        if known.iter().any(|known| known == key) {
            return Ok(Datum::Nothing);
        }
        let near = nearest_name(key, known.iter().map(String::as_str));
        let near = near.map_or(String::new(), |near| format!("; did you mean {near}?"));
        Err(format!(
            "nothing is called {name:?}: {} has no {key:?}{near}",
            self.kind.name()
        ))
    }
}

/// Where a path leads in JSON: keys, names of what a list holds, or x, y and z of a list of numbers.
fn walked(from: &Value, path: &str) -> Option<Datum> {
    let mut here = from;
    let mut rest = path;
    loop {
        let (key, after) = match rest.split_once('.') {
            Some((key, after)) => (key, Some(after)),
            None => (rest, None),
        };
        here = match here {
            Value::Object(object) => object.get(key)?,
            Value::Array(list) => {
                let named = list
                    .iter()
                    .find(|of| of.get("name").is_some_and(|name| name == key));
                match (named, key) {
                    (Some(named), _) => named,
                    (None, "x") => list.first()?,
                    (None, "y") => list.get(1)?,
                    (None, "z") => list.get(2)?,
                    (None, index) => list.get(index.parse::<usize>().ok()?)?,
                }
            }
            _ => return None,
        };
        match after {
            Some(after) => rest = after,
            None => return datum(here),
        }
    }
}

fn part(value: &Datum, key: &str) -> Option<Datum> {
    let Datum::List(list) = value else {
        return None;
    };
    let place = ["x", "y", "z"].iter().position(|axis| *axis == key)?;
    list.get(place).map(|number| Datum::Number(*number))
}

fn datum(value: &Value) -> Option<Datum> {
    Some(match value {
        Value::Number(number) => Datum::Number(number.as_f64()?),
        Value::Bool(flag) => Datum::Flag(*flag),
        Value::String(text) => Datum::Text(text.clone()),
        Value::Array(list) => Datum::List(list.iter().map(Value::as_f64).collect::<Option<_>>()?),
        Value::Null => Datum::Nothing,
        Value::Object(_) => return None,
    })
}

impl Facts<'_> {
    /// The value of an expression.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn value(&self, expression: &str) -> Result<Datum, String> {
        evaluate(expression, self).map_err(|what| format!("{expression:?}: {what}"))
    }

    /// A text with the values of its expressions: `{t}`, or with so many significant digits `{t:3}`.
    ///
    /// # Errors
    /// A brace without its other one, or an expression that makes no sense.
    pub(super) fn filled(&self, text: &str) -> Result<String, String> {
        let mut filled = String::new();
        let mut rest = text;
        while let Some(start) = rest.find('{') {
            filled.push_str(&rest[..start]);
            let inside = &rest[start + 1..];
            let end = inside.find('}');
            let end = end.ok_or_else(|| format!("{text:?}: a brace is not closed"))?;
            let (expression, digits) = match inside[..end].rsplit_once(':') {
                Some((expression, digits)) => {
                    let digits = digits.trim().parse();
                    let digits = digits.map_err(|_| {
                        format!("{text:?}: a number of digits stands after the colon")
                    })?;
                    (expression, digits)
                }
                None => (&inside[..end], DIGITS),
            };
            filled.push_str(&self.value(expression)?.shown(digits));
            rest = &inside[end + 1..];
        }
        filled.push_str(rest);
        Ok(filled)
    }
}
