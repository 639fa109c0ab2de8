//! What a figure is drawn from: a scene, how it was traced, and what was recorded. It comes from the tracer or from a
//! saved log, and nothing else enters a figure.

use std::io::{self, BufRead, Write};

use crate::figure::sheet::image::Image;
use crate::scene::{LONGEST_LINE, ReadEnd, Scene, read_up_to};
use crate::trace::{
    Event, EventWriter, LogError, LogNames, LogReader, OfPixels, Record, Settings,
    keep_paths_behind, write_log_head, write_of_pixels,
};

/// The log of a figure: every event of the pixels that it draws, and of all pixels what else it shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Traced {
    /// The scene that was traced, read from the log where the figure is drawn from one.
    pub scene: Scene,
    /// How it was traced; `whole` names the pixels that are drawn.
    pub settings: Settings,
    /// What it holds of every pixel: the picture, or how many tests each took.
    pub of_pixels: OfPixels,
    /// What was recorded, pixel after pixel, the building of the structure first.
    pub records: Vec<Record>,
}

/// A stretch of the trace in which steps and rays are numbered from 0: a path of light, or a pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section<'a> {
    pub(super) records: &'a [Record],
    /// How many steps a figure has before it.
    before: u32,
}

impl Section<'_> {
    /// The step of the whole figure that a record is: the paths of light come one after the other, then the pixels.
    pub(super) fn step(&self, record: &Record) -> u32 {
        self.before + record.step
    }

    /// How many steps a figure has up to its end.
    pub(super) fn after(&self) -> u32 {
        self.records
            .last()
            .map_or(self.before, |last| self.step(last) + 1)
    }
}

#[cfg(test)]
impl<'a> Section<'a> {
    /// The first of a trace.
    pub(super) fn first(records: &'a [Record]) -> Self {
        let before = 0;
        Self { records, before }
    }
}

impl Traced {
    /// Writes it as a log. Several logs behind each other are one figure's.
    ///
    /// # Errors
    /// A failing output.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        write_log_head(&self.scene, &self.settings, out)?;
        write_of_pixels(&self.of_pixels, out)?;
        let names = LogNames::new(&self.scene);
        let mut writer = EventWriter::new(&names);
        let mut lines = Vec::new();
        for record in &self.records {
            writer.line(record, &mut lines);
        }
        out.write_all(&lines)
    }

    /// Reads the logs of a figure, one behind the other.
    ///
    /// # Errors
    /// A log that cannot be read or is damaged, or none at all.
    pub fn read(file: &str, mut input: impl BufRead) -> Result<Vec<Self>, LogError> {
        let mut all = Vec::new();
        let mut log = Vec::new();
        loop {
            let next = next_log(file, &mut input, &mut log)?;
            let mut reader = LogReader::open(file, &log[..])?;
            let mut records = Vec::new();
            while let Some(record) = reader.next_record()? {
                records.push(record);
            }
            all.push(Self {
                scene: reader.scene().clone(),
                settings: reader.settings().clone(),
                of_pixels: reader.of_pixels().clone(),
                records,
            });
            if next.is_empty() {
                return Ok(all);
            }
            log = next;
        }
    }

    /// The records of one pixel.
    pub(super) fn pixel(&self, pixel: [u32; 2]) -> &[Record] {
        let of = |record: &Record| record.pixel == Some(pixel);
        let first = self.records.iter().position(of).unwrap_or(0);
        let count = self.records[first..].iter().take_while(|record| of(record));
        &self.records[first..first + count.count()]
    }

    /// The paths of light that were recorded whole, in order, each with its steps after those of the one before.
    pub(super) fn paths(&self) -> Vec<Section<'_>> {
        let of_paths = self
            .records
            .chunk_by(|a, b| a.path == b.path && a.pixel == b.pixel)
            .filter(|records| records[0].path.is_some());
        let mut before = 0;
        let section = |records| {
            let section = Section { records, before };
            before = section.after();
            section
        };
        of_paths.map(section).collect()
    }

    /// The records of one pixel, with its steps after those of all paths of light.
    pub(super) fn after_paths<'a>(&self, records: &'a [Record]) -> Section<'a> {
        let before = self.paths().last().map_or(0, Section::after);
        Section { records, before }
    }

    /// What was recorded of one pixel, with the building and the paths of light that led to it before; without a pixel the
    /// building and all paths.
    pub fn of_pixel(&self, pixel: Option<[u32; 2]>) -> Vec<Record> {
        let wanted = |record: &&Record| record.pixel.is_none() || record.pixel == pixel;
        let mut records = self.records.iter().filter(wanted).copied().collect();
        if let Some(pixel) = pixel {
            keep_paths_behind(pixel, &self.settings, &mut records);
        }
        records
    }

    /// How the structure was built.
    pub(super) fn building(&self) -> impl Iterator<Item = &Record> {
        let of_none = |record: &&Record| record.pixel.is_none() && record.path.is_none();
        self.records.iter().filter(of_none)
    }

    /// The picture: the one that was traced for the figure, or the colours of the pixels that the log has, as squares.
    /// `None` if it has none.
    pub(super) fn picture(&self) -> Option<Image> {
        if let Some(picture) = &self.of_pixels.picture {
            return Some(Image::of_rgb(picture.pixels, &picture.rgb).in_squares());
        }
        let mut colours = vec![None; self.pixel_count()];
        for (place, event) in self.events_of_pixels() {
            if let (Some(seen), Event::PixelColour(colour)) = (colours.get_mut(place), event) {
                let rgb = (colour.clamped * 255.0).round().to_array();
                *seen = Some(rgb.map(|of| of as u8));
            }
        }
        let is_known = colours.iter().any(Option::is_some);
        is_known.then(|| Image::new(self.scene.camera.pixels, colours).in_squares())
    }

    /// Has this pixel a colour? It is the last event of a pixel.
    pub(super) fn has_colour(&self, pixel: [u32; 2]) -> bool {
        let last = self.pixel(pixel).last();
        last.is_some_and(|record| matches!(record.event, Event::PixelColour(_)))
    }

    /// How many pixels the scene's camera has.
    pub(super) fn pixel_count(&self) -> usize {
        let [width, height] = self.scene.camera.pixels.map(|side| side as usize);
        width * height
    }

    /// The events of pixels, each with the place of its pixel, row by row from the top left.
    pub(super) fn events_of_pixels(&self) -> impl Iterator<Item = (usize, &Event)> {
        let width = self.scene.camera.pixels[0] as usize;
        self.records.iter().filter_map(move |record| {
            let [x, y] = record.pixel?;
            Some((y as usize * width + x as usize, &record.event))
        })
    }
}

/// Appends the lines of a log up to the first line of the one behind it, which is given back; empty if there is none.
fn next_log(file: &str, input: &mut impl BufRead, log: &mut Vec<u8>) -> Result<Vec<u8>, LogError> {
    /// How the writer begins a log.
    const HEAD: &[u8] = b"{\"kind\":\"trace\"";
    let mut line = Vec::new();
    loop {
        line.clear();
        let end = read_up_to(input, b'\n', LONGEST_LINE, &mut line);
        let end = end.map_err(|source| LogError::Read {
            file: file.into(),
            source,
        })?;
        if !log.is_empty() && line.starts_with(HEAD) {
            return Ok(line);
        }
        log.extend_from_slice(&line);
        // the reader of the log reports a line without an end
        if end != ReadEnd::Stop {
            return Ok(Vec::new());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::SceneFile;
    use crate::trace::{PathStart, PixelSample, RayEnd};

    #[test]
    fn steps_of_paths_come_one_after_the_other_and_those_of_pixels_after_them() {
        let file: SceneFile = serde_json::from_str(
            r#"{"camera":{"window":{"cop":[0,1,6],"corner":[-1,0,5],"right":[2,0,0],"up":[0,2,0]},
                "pixels":[2,2]},"objects":[],"materials":{}}"#,
        )
        .unwrap();
        let end = Event::RayEnd(RayEnd::default());
        let path = Event::Path(PathStart::default());
        let pixel = Event::Pixel(PixelSample::default());
        let record = |pixel, path, step, event| Record {
            pixel,
            path,
            step,
            ray: None,
            parent: None,
            event,
        };
        let records = vec![
            record(None, None, 0, end),
            record(None, Some(3), 0, path),
            record(None, Some(3), 1, end),
            record(None, Some(8), 0, path),
            record(Some([1, 0]), None, 0, pixel),
            record(Some([1, 0]), None, 1, end),
        ];
        let traced = Traced {
            scene: Scene::new(file).unwrap(),
            settings: Settings::default(),
            of_pixels: OfPixels::default(),
            records,
        };
        let steps = |section: &Section| {
            let of = section.records.iter().map(|record| section.step(record));
            of.collect::<Vec<_>>()
        };
        let paths: Vec<_> = traced.paths().iter().map(steps).collect();
        assert_eq!(paths, [vec![0, 1], vec![2]]);
        let pixel = traced.after_paths(traced.pixel([1, 0]));
        assert_eq!(steps(&pixel), [3, 4]);
        assert_eq!(traced.building().count(), 1);
    }
}
