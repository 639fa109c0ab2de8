//! The head of a log: how the trace was made and the scene, on a line of its own, then one line per object; in a figure's log
//! what it holds of every pixel comes after them.

use std::io::{self, Write};

use serde::Serialize;
use smol_str::SmolStr;

use crate::scene::file::{CameraFile, LightFile, Materials, ObjectFile, ShapeFile, SidesFile};
use crate::scene::{Scene, SceneFile};
use crate::trace::log::of_pixels::OfPixels;
use crate::trace::log::settings::Settings;

/// The version of the log that this program writes and reads.
pub const LOG_VERSION: u32 = 2;

/// The first line: how the trace was made, and the scene but for its objects.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct Header {
    /// `trace`.
    pub(super) kind: String,
    /// The version of the format: 2.
    pub(super) version: u32,
    /// What the scene shows.
    #[serde(default)]
    pub(super) name: String,
    /// How the trace was made.
    pub(super) settings: Settings,
    /// The eye and the window.
    pub(super) camera: CameraFile,
    /// The colour of a ray that hits nothing.
    pub(super) background: [f64; 3],
    /// The ambient light.
    pub(super) ambient: [f64; 3],
    /// The point lights.
    pub(super) lights: Vec<LightFile>,
    /// The materials by name.
    pub(super) materials: Materials,
    /// The largest depth of a ray.
    pub(super) max_depth: u32,
    /// The scene's own set of slabs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) slabs: Option<Vec<Vec<f64>>>,
}

/// A line that describes an object, its mesh inlined.
#[derive(Clone, Debug, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct ObjectLine {
    /// `object`.
    pub(super) kind: String,
    /// Its name.
    pub(super) name: SmolStr,
    /// The name of its material.
    pub(super) material: SmolStr,
    /// Its form.
    pub(super) shape: ShapeFile,
    /// Which sides of its surface can be seen.
    #[serde(default)]
    pub(super) sides: SidesFile,
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

/// Writes what a log holds of every pixel, after its head and before its events.
///
/// # Errors
/// Those of the output.
pub fn write_of_pixels(of_pixels: &OfPixels, out: &mut impl Write) -> io::Result<()> {
    if let Some(picture) = &of_pixels.picture {
        write_line(&picture.line(), out)?;
    }
    if let Some(mistake) = &of_pixels.mistake {
        write_line(&mistake.line(), out)?;
    }
    if let Some(totals) = of_pixels.totals {
        write_line(&totals.line(), out)?;
    }
    for (row, tests) in of_pixels.tests.iter().enumerate() {
        write_line(&tests.line(row), out)?;
    }
    Ok(())
}

fn write_line(line: &impl Serialize, out: &mut impl Write) -> io::Result<()> {
    serde_json::to_writer(&mut *out, line)?;
    out.write_all(b"\n")
}
