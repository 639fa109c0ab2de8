//! The line of a value in a JSON text, found by its path.
//!
//! What makes no sense is noticed after the text has become a scene. This walks the text again along the
//! path and stops there with an error, which `serde_json` furnishes with the line.

use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

/// The line of the value at a path such as `objects[0].shape.sphere.radius`, counted from 1; of the
/// innermost part of the path that is there. `None` if not even the first part is.
pub(crate) fn line_of(text: &str, path: &str) -> Option<usize> {
    let steps: Vec<String> = path
        .split(['.', '['])
        .map(|step| step.trim_end_matches(']').into())
        .collect();
    (1..=steps.len()).rev().find_map(|count| {
        let mut json = serde_json::Deserializer::from_str(text);
        let found = Find(&steps[..count]).deserialize(&mut json).err()?;
        found.to_string().starts_with(FOUND).then(|| found.line())
    })
}

/// The message that says that the end of the path was reached.
const FOUND: &str = "the value is here";

/// What is left of the path.
struct Find<'a>(&'a [String]);

impl<'de> DeserializeSeed<'de> for Find<'_> {
    type Value = ();
    fn deserialize<D: Deserializer<'de>>(self, input: D) -> Result<(), D::Error> {
        if self.0.is_empty() {
            // scalars are passed before their place is known, containers are not
            input.deserialize_any(Here)
        } else {
            input.deserialize_any(self)
        }
    }
}

/// Stops at the value.
struct Here;

impl<'de> Visitor<'de> for Here {
    type Value = ();
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("anything")
    }
    fn visit_bool<E: Error>(self, _: bool) -> Result<(), E> {
        Err(E::custom(FOUND))
    }
    fn visit_i64<E: Error>(self, _: i64) -> Result<(), E> {
        Err(E::custom(FOUND))
    }
    fn visit_u64<E: Error>(self, _: u64) -> Result<(), E> {
        Err(E::custom(FOUND))
    }
    fn visit_f64<E: Error>(self, _: f64) -> Result<(), E> {
        Err(E::custom(FOUND))
    }
    fn visit_str<E: Error>(self, _: &str) -> Result<(), E> {
        Err(E::custom(FOUND))
    }
    fn visit_unit<E: Error>(self) -> Result<(), E> {
        Err(E::custom(FOUND))
    }
    fn visit_seq<A: SeqAccess<'de>>(self, _: A) -> Result<(), A::Error> {
        Err(A::Error::custom(FOUND))
    }
    fn visit_map<A: MapAccess<'de>>(self, _: A) -> Result<(), A::Error> {
        Err(A::Error::custom(FOUND))
    }
}

impl<'de> Visitor<'de> for Find<'_> {
    type Value = ();
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "something with the key or index {:?}", self.0[0])
    }
    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(key) = map.next_key::<String>()? {
            if key == self.0[0] {
                return map.next_value_seed(Find(&self.0[1..]));
            }
            map.next_value::<IgnoredAny>()?;
        }
        Ok(())
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
        let Ok(index) = self.0[0].parse::<usize>() else {
            return Ok(());
        };
        for _ in 0..index {
            list.next_element::<IgnoredAny>()?;
        }
        list.next_element_seed(Find(&self.0[1..]))?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"{
  "a": [1, 2,
    { "b": "x",
      "c": [[0, 1], [2,
             3]] }],
  "d": null
}"#;

    #[test]
    fn a_path_of_keys_and_indices_leads_to_its_line() {
        for (path, line) in [
            ("a", 2),
            ("a[1]", 2),
            ("a[2]", 3),
            ("a[2].b", 3),
            ("a[2].c[0][1]", 4),
            ("a[2].c[1][1]", 5),
            ("d", 6),
        ] {
            assert_eq!(line_of(TEXT, path), Some(line), "{path}");
        }
    }

    #[test]
    fn a_path_that_ends_early_gives_the_line_of_what_is_there() {
        assert_eq!(line_of(TEXT, "a[2].missing"), Some(3));
        assert_eq!(line_of(TEXT, "missing"), None);
    }
}
