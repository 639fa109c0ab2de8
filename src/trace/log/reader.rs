//! Reading a log back: the scene and the settings from its head, then record after record.

use std::io::BufRead;

use serde::de::DeserializeOwned;

use crate::scene::file::ObjectFile;
use crate::scene::{Scene, SceneFile};
use crate::trace::log::head::{Header, LOG_VERSION, ObjectLine};
use crate::trace::log::limits::Limits;
use crate::trace::log::line_reader::{Damage, parse_event};
use crate::trace::log::lines::LogLines;
use crate::trace::log::name_table::NameTable;
use crate::trace::log::of_pixels::{
    LoggedMistake, LoggedPicture, MistakeLine, OfPixels, PictureLine, TestsLine, TestsOfRow,
    TotalsLine,
};
use crate::trace::record::path_sieve::keep_paths_behind;
use crate::trace::record::recorder::{Numbering, Place};
use crate::trace::{Event, Kind, LogError, PathSieve, Record, Region, Settings, Sink};

/// A log that is being read.
#[derive(Debug)]
pub struct LogReader<R> {
    lines: LogLines<R>,
    names: NameTable,
    scene: Scene,
    settings: Settings,
    of_pixels: OfPixels,
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
        let mut lines = LogLines::new(file, input);
        let header = read_header(&mut lines)?;
        let objects = read_objects(&mut lines)?;
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
        let of_pixels = read_of_pixels(&mut lines, scene.camera.pixels)?;
        Ok(Self {
            lines,
            names: NameTable::new(&scene),
            limits: Limits::new(&scene, &settings),
            scene,
            numbering: settings.only.is_none().then(Numbering::default),
            settings,
            of_pixels,
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

    /// What the log of a figure holds of every pixel; other logs hold nothing of the kind.
    pub fn of_pixels(&self) -> &OfPixels {
        &self.of_pixels
    }

    /// The next record; `None` at the end.
    ///
    /// # Errors
    /// A damaged line, with its number and what is wrong in it.
    pub fn next_record(&mut self) -> Result<Option<Record>, LogError> {
        let mut record = Record::blank(Kind::Pixel);
        Ok(self.read_into(&mut record)?.then_some(record))
    }

    /// Fills in the next record; `false` at the end.
    #[inline]
    fn read_into(&mut self, record: &mut Record) -> Result<bool, LogError> {
        let Some(line) = self.lines.next()? else {
            return Ok(false);
        };
        let read = parse_event(line, &self.names, record).and_then(|()| {
            self.limits.check(record)?;
            match &mut self.numbering {
                Some(numbering) => out_of_place(record, &numbering.place(&record.event)),
                None => Ok(()),
            }
        });
        match read {
            Ok(()) => Ok(true),
            Err(damage) => Err(self.lines.damaged(damage)),
        }
    }

    /// The scene, the settings, and all records that led to one pixel: how the structure was built, the paths of
    /// light behind the pixel, and its own. The whole log is read, so that damage elsewhere in it is reported too.
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
        let mut record = Record::blank(Kind::Pixel);
        while self.read_into(&mut record)? {
            if record.pixel.is_none_or(|of| of == pixel) {
                // a list takes all
                let _ = sieve.record(&record);
            }
        }
        let _ = sieve.finish();
        let mut records = sieve.sink;
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

/// What identifies the lines of the head, at any place in the line.
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

fn read_header(lines: &mut LogLines<impl BufRead>) -> Result<Header, LogError> {
    let file = lines.file().to_owned();
    let Some(line) = lines.next()? else {
        return Err(LogError::NoLog { file });
    };
    // version first: the rest of a later version may look different
    match LineStart::of(line) {
        Some(LineStart { kind, version }) if kind == "trace" => {
            let found = version.unwrap_or_default();
            if found != LOG_VERSION {
                return Err(LogError::Version { file, found });
            }
        }
        _ => return Err(LogError::NoLog { file }),
    }
    let header = serde_json::from_slice(line);
    header.map_err(|error| lines.damaged(Damage::json(&error)))
}

/// The objects' lines, up to the first line that is none.
fn read_objects(lines: &mut LogLines<impl BufRead>) -> Result<Vec<ObjectFile>, LogError> {
    let mut objects = Vec::new();
    while let Some(line) = next_of_kind::<ObjectLine>(lines, "object")? {
        objects.push(ObjectFile {
            name: line.name,
            material: line.material,
            shape: line.shape,
            sides: line.sides,
        });
    }
    Ok(objects)
}

/// The lines about every pixel, up to the first line that is none.
fn read_of_pixels(
    lines: &mut LogLines<impl BufRead>,
    pixels: [u32; 2],
) -> Result<OfPixels, LogError> {
    let mut read = OfPixels::default();
    if let Some(line) = next_of_kind::<PictureLine>(lines, "picture")? {
        let picture = LoggedPicture::of_line(&line, pixels);
        read.picture = Some(picture.map_err(|what| lines.damaged(Damage::new(what)))?);
    }
    if let Some(line) = next_of_kind::<MistakeLine>(lines, "mistake")? {
        let mistake = LoggedMistake::of_line(line, pixels);
        read.mistake = Some(mistake.map_err(|what| lines.damaged(Damage::new(what)))?);
    }
    if let Some(line) = next_of_kind::<TotalsLine>(lines, "totals")? {
        read.totals = Some(line.totals);
    }
    while let Some(line) = next_of_kind::<TestsLine>(lines, "pixel_tests")? {
        let tests = TestsOfRow::of_line(line, read.tests.len(), pixels[0]);
        read.tests
            .push(tests.map_err(|what| lines.damaged(Damage::new(what)))?);
    }
    let [rows, height] = [read.tests.len(), pixels[1] as usize];
    if rows != 0 && rows != height {
        let what =
            format!("there are {rows} rows of tests before it, and the picture has {height}");
        return Err(lines.damaged(Damage::new(what)));
    }
    Ok(read)
}

/// The next line of the head if it is of that kind; any other comes again as the next one.
fn next_of_kind<T: DeserializeOwned>(
    lines: &mut LogLines<impl BufRead>,
    kind: &str,
) -> Result<Option<T>, LogError> {
    let Some(line) = lines.next()? else {
        return Ok(None);
    };
    let is_of_kind = match LineStart::of(line) {
        Some(start) => start.kind == kind,
        // a damaged line is identified by its beginning, so that its damage is reported below
        None => line.starts_with(format!("{{\"kind\":\"{kind}\"").as_bytes()),
    };
    if !is_of_kind {
        lines.put_back();
        return Ok(None);
    }
    let line = serde_json::from_slice(line);
    line.map(Some)
        .map_err(|error| lines.damaged(Damage::json(&error)))
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
        format!("step {step}{of} is missing: a line is lost or in the wrong place")
    } else if found.ray != expected.ray || found.parent != expected.parent {
        "\"ray\" or \"parent\" does not fit the rays before it".into()
    } else if expected.counted.is_some() && counted != expected.counted {
        "\"tests\" or \"hits\" does not fit the tests before it".into()
    } else {
        return Ok(());
    };
    Err(Damage::new(what))
}
