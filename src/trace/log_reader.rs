//! Reading a log back: the scene and the settings from its head, then record after record.

use std::io::BufRead;

use crate::scene::file::ObjectFile;
use crate::scene::{Scene, SceneFile};
use crate::trace::limits::Limits;
use crate::trace::line_reader::{Damage, parse_event};
use crate::trace::log_writer::{Header, LOG_VERSION, ObjectLine};
use crate::trace::name_table::NameTable;
use crate::trace::path_sieve::keep_paths_behind;
use crate::trace::recorder::{Numbering, Place};
use crate::trace::{Event, LogError, PathSieve, Record, Region, Settings, Sink};

/// A log that is being read.
#[derive(Debug)]
pub struct LogReader<R> {
    file: String,
    input: R,
    /// The line that was read last, and its number from 1.
    line: Vec<u8>,
    number: usize,
    /// The first line after the head, read to find where the head ends.
    pending: bool,
    names: NameTable,
    scene: Scene,
    settings: Settings,
    /// What each line's numbers must be, if no kind was left out.
    numbering: Option<Numbering>,
    /// What its numbers can be at all.
    limits: Limits,
}

impl<R: BufRead> LogReader<R> {
    /// Reads the head of a log.
    ///
    /// # Errors
    /// A file that cannot be read, is no log, or whose head is damaged.
    pub fn open(file: &str, input: R) -> Result<Self, LogError> {
        let mut lines = Lines {
            file: file.into(),
            input,
            line: Vec::new(),
            number: 0,
        };
        let header = read_header(&mut lines)?;
        let (objects, pending) = read_objects(&mut lines)?;
        let settings = header.settings;
        let scene = Scene::new(SceneFile {
            name: header.name,
            camera: header.camera,
            background: header.background,
            ambient: header.ambient,
            lights: header.lights,
            materials: header.materials,
            objects,
            max_depth: header.max_depth,
            slabs: header.slabs,
        })
        .map_err(|fault| LogError::Scene {
            file: file.into(),
            fault,
        })?;
        let scene = if settings.one_sided {
            scene.one_sided()
        } else {
            scene
        };
        let Lines {
            file,
            input,
            line,
            number,
        } = lines;
        Ok(Self {
            file,
            input,
            line,
            number,
            pending,
            names: NameTable::new(&scene),
            limits: Limits::new(&scene, &settings),
            scene,
            numbering: settings.only.is_none().then(Numbering::default),
            settings,
        })
    }

    /// The scene that was traced.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// How it was traced.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The next record; `None` at the end.
    ///
    /// # Errors
    /// A damaged line, with its number and what is wrong in it.
    pub fn next_record(&mut self) -> Result<Option<Record>, LogError> {
        if !std::mem::take(&mut self.pending)
            && !next_line(
                &self.file,
                &mut self.input,
                &mut self.line,
                &mut self.number,
            )?
        {
            return Ok(None);
        }
        let damaged = |damage: Damage| damage.at(&self.file, self.number);
        let record = parse_event(&self.line, &self.names).map_err(damaged)?;
        self.limits.check(&record).map_err(damaged)?;
        if let Some(numbering) = &mut self.numbering {
            out_of_place(&record, &numbering.place(&record.event)).map_err(damaged)?;
        }
        Ok(Some(record))
    }

    /// The scene, the settings, and all records that led to one pixel: how the structure was built, the paths of
    /// light behind the pixel, and its own. The whole log is read, so that damage elsewhere in it is told too.
    ///
    /// Which photons a pixel has gathered stands after them: of light that was stored, all paths are kept in memory
    /// up to the end.
    ///
    /// # Errors
    /// As [`LogReader::next_record`].
    pub fn pixel(mut self, pixel: [u32; 2]) -> Result<(Scene, Settings, Vec<Record>), LogError> {
        let width = self.scene.camera.pixels[0];
        let mut sieve = PathSieve::new(
            &self.settings,
            width,
            Some(Region::pixel(pixel)),
            Vec::new(),
        );
        while let Some(record) = self.next_record()? {
            if record.pixel.is_none_or(|of| of == pixel) {
                sieve.record(&record);
            }
        }
        let mut records = sieve.finish();
        keep_paths_behind(pixel, &self.settings, &mut records);
        Ok((self.scene, self.settings, records))
    }
}

impl<R: BufRead> Iterator for LogReader<R> {
    type Item = Result<Record, LogError>;
    fn next(&mut self) -> Option<Self::Item> {
        self.next_record().transpose()
    }
}

struct Lines<R> {
    file: String,
    input: R,
    line: Vec<u8>,
    number: usize,
}

impl<R: BufRead> Lines<R> {
    fn next(&mut self) -> Result<bool, LogError> {
        next_line(
            &self.file,
            &mut self.input,
            &mut self.line,
            &mut self.number,
        )
    }
}

/// Reads one line into the buffer; `false` at the end. A last line without its end was cut off.
fn next_line(
    file: &str,
    input: &mut impl BufRead,
    line: &mut Vec<u8>,
    number: &mut usize,
) -> Result<bool, LogError> {
    line.clear();
    *number += 1;
    let read = input.read_until(b'\n', line);
    read.map_err(|source| LogError::Read {
        file: file.into(),
        source,
    })?;
    if line.is_empty() {
        return Ok(false);
    }
    if line.pop() != Some(b'\n') {
        let what = "the line has no end: the log was cut off here".into();
        return Err(Damage { column: None, what }.at(file, *number));
    }
    Ok(true)
}

/// What the head's lines are told by, wherever it stands in the line.
#[derive(serde::Deserialize)]
struct LineStart {
    kind: String,
    version: Option<u32>,
}

impl LineStart {
    fn of(line: &[u8]) -> Option<Self> {
        serde_json::from_slice(line).ok()
    }
}

/// Is this the first line of a log?
pub fn begins_log(first_line: &[u8]) -> bool {
    LineStart::of(first_line).is_some_and(|start| start.kind == "trace")
}

fn read_header(lines: &mut Lines<impl BufRead>) -> Result<Header, LogError> {
    let no_log = |file: &str| LogError::NoLog { file: file.into() };
    if !lines.next()? {
        return Err(no_log(&lines.file));
    }
    // version first: the rest of a later version may look different
    match LineStart::of(&lines.line) {
        Some(LineStart { kind, version }) if kind == "trace" => {
            let found = version.unwrap_or_default();
            if found != LOG_VERSION {
                return Err(LogError::Version {
                    file: lines.file.clone(),
                    found,
                });
            }
        }
        _ => return Err(no_log(&lines.file)),
    }
    serde_json::from_slice(&lines.line)
        .map_err(|error| Damage::json(&error).at(&lines.file, lines.number))
}

/// The object lines, and whether a line that is none was read after them.
fn read_objects(lines: &mut Lines<impl BufRead>) -> Result<(Vec<ObjectFile>, bool), LogError> {
    let mut objects = Vec::new();
    while lines.next()? {
        let is_object = match LineStart::of(&lines.line) {
            Some(start) => start.kind == "object",
            // a damaged line is told by how it begins, so that its damage is told below
            None => lines.line.starts_with(b"{\"kind\":\"object\""),
        };
        if !is_object {
            return Ok((objects, true));
        }
        let line: ObjectLine = serde_json::from_slice(&lines.line)
            .map_err(|error| Damage::json(&error).at(&lines.file, lines.number))?;
        objects.push(ObjectFile {
            name: line.name,
            material: line.material,
            shape: line.shape,
            sides: line.sides,
        });
    }
    Ok((objects, false))
}

/// A whole log has every event in its place; a line that was lost, moved or changed shows by its numbers.
fn out_of_place(found: &Record, expected: &Place) -> Result<(), Damage> {
    let counted = match found.event {
        Event::RayEnd(end) => Some([end.tests, end.hits]),
        _ => None,
    };
    let out_of_place =
        found.pixel != expected.pixel || found.path != expected.path || found.step != expected.step;
    let what = if out_of_place {
        let step = expected.step;
        let of = match (expected.pixel, expected.path) {
            (Some([x, y]), _) => format!(" of pixel [{x},{y}]"),
            (None, Some(path)) => format!(" of path {path}"),
            (None, None) => String::new(),
        };
        format!("step {step}{of} was to follow: a line is missing or out of its place")
    } else if found.ray != expected.ray || found.parent != expected.parent {
        "\"ray\" or \"parent\" does not fit the rays before it".into()
    } else if expected.counted.is_some() && counted != expected.counted {
        "\"tests\" or \"hits\" does not fit the tests before it".into()
    } else {
        return Ok(());
    };
    Err(Damage::new(what))
}
