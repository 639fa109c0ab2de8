//! `raystep convert`: any scene as JSON that is pleasant to read.
//!
//! What there are many of (objects, lights, materials) stands one to a line.

use std::fmt::Write;
use std::io;

use raystep::Scene;
use raystep::scene::SceneFile;
use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};

use crate::cli::Error;
use crate::cli::args::ConvertArgs;
use crate::cli::input::{self, Input};
use crate::cli::output::Output;
use crate::cli::same_file::Taken;

/// Writes the scene as JSON.
pub(crate) fn run(args: &ConvertArgs) -> Result<(), Error> {
    refuse_target(args)?;
    // a scene may take its own place, but not that of its meshes
    let mut taken = Taken::nothing();
    let scene = match input::open(&args.scene, &args.reading)? {
        Input::Scene(loaded) => {
            for mesh in &loaded.files {
                taken.read(mesh);
            }
            let scene = loaded.scene.clone();
            // a scene that makes no sense is refused here, not by whoever reads the JSON
            loaded.build()?;
            scene
        }
        Input::Log(log) => file_of(log.scene()),
    };
    Output::create(&args.output, &taken)?.write_whole(json(&scene).as_bytes())
}

/// JSON under the ending of another format would be read as that.
fn refuse_target(args: &ConvertArgs) -> Result<(), Error> {
    let ending = args.output.extension().and_then(|ending| ending.to_str());
    if matches!(ending, Some("nff" | "obj" | "jsonl")) {
        return Err(Error::Target {
            file: args.output.display().to_string(),
            what: "convert writes JSON, and this file name has the ending of another format".into(),
            fix: "name a file that ends in .json".into(),
        });
    }
    Ok(())
}

/// A checked scene as a file again.
fn file_of(scene: &Scene) -> SceneFile {
    let objects = scene.objects.iter();
    SceneFile {
        objects: objects.map(|object| scene.object_file(object)).collect(),
        ..scene.head()
    }
}

/// The scene as JSON.
fn json(scene: &SceneFile) -> String {
    let SceneFile {
        name,
        camera,
        background,
        ambient,
        lights,
        materials,
        objects,
        max_depth,
        slabs,
    } = scene;
    let mut parts = Vec::new();
    if !name.is_empty() {
        parts.push(("name", inline(name)));
    }
    let material =
        |(name, material): &(String, _)| format!("{}: {}", inline(name), inline(material));
    parts.extend([
        ("camera", inline(camera)),
        ("background", inline(background)),
        ("ambient", inline(ambient)),
        ("lights", lines('[', lights.iter().map(inline), ']')),
        (
            "materials",
            lines('{', materials.0.iter().map(material), '}'),
        ),
        ("objects", lines('[', objects.iter().map(inline), ']')),
        ("max_depth", inline(max_depth)),
    ]);
    if let Some(slabs) = slabs {
        parts.push(("slabs", inline(slabs)));
    }
    let parts: Vec<String> = parts
        .into_iter()
        .map(|(key, value)| format!("  \"{key}\": {value}"))
        .collect();
    format!("{{\n{}\n}}\n", parts.join(",\n"))
}

/// A list or map with one item to a line.
fn lines(open: char, items: impl Iterator<Item = String>, close: char) -> String {
    let mut text = String::from(open);
    for (i, item) in items.enumerate() {
        let comma = if i == 0 { "" } else { "," };
        // writing to a string does not fail
        let _ = write!(text, "{comma}\n    {item}");
    }
    if 1 < text.len() {
        text.push_str("\n  ");
    }
    text.push(close);
    text
}

/// A value on one line.
fn inline(value: &impl Serialize) -> String {
    let mut text = Vec::new();
    // memory does not fail, and a scene has neither odd keys nor numbers without JSON
    let written = value.serialize(&mut Serializer::with_formatter(&mut text, OneLine));
    debug_assert!(written.is_ok(), "{written:?}");
    String::from_utf8(text).unwrap_or_default()
}

/// `{ "center": [0, 1.5, 0], "radius": 1 }`
struct OneLine;

impl Formatter for OneLine {
    fn begin_array_value<W: ?Sized + io::Write>(
        &mut self,
        out: &mut W,
        first: bool,
    ) -> io::Result<()> {
        out.write_all(if first { b"" } else { b", " })
    }

    fn begin_object_key<W: ?Sized + io::Write>(
        &mut self,
        out: &mut W,
        first: bool,
    ) -> io::Result<()> {
        out.write_all(if first { b" " } else { b", " })
    }

    fn begin_object_value<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        out.write_all(b": ")
    }

    fn end_object<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        out.write_all(b" }")
    }

    fn write_f64<W: ?Sized + io::Write>(&mut self, out: &mut W, value: f64) -> io::Result<()> {
        /// Below this every whole number has a value of its own: 2⁵³.
        const EXACT: f64 = 9_007_199_254_740_992.0;
        // −0 keeps its sign only as −0.0
        let is_negative_zero = value == 0.0 && value.is_sign_negative();
        if value.fract() == 0.0 && value.abs() < EXACT && !is_negative_zero {
            write!(out, "{}", value as i64)
        } else {
            serde_json::ser::CompactFormatter.write_f64(out, value)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_back_bit_for_bit() {
        for value in [
            0.0,
            -0.0,
            1.0,
            -3.0,
            0.1,
            1e300,
            9_007_199_254_740_992.0_f64,
            1e-50,
        ] {
            let back: f64 = serde_json::from_str(&inline(&value)).unwrap();
            assert_eq!(back.to_bits(), value.to_bits(), "{value}");
        }
    }

    #[test]
    fn lists_have_one_item_to_a_line_and_empty_ones_no_line() {
        assert_eq!(
            lines('[', [1, 2].iter().map(inline), ']'),
            "[\n    1,\n    2\n  ]"
        );
        assert_eq!(lines('[', std::iter::empty(), ']'), "[]");
    }
}
