//! What a figure is drawn from: a scene, how it was traced, and what was recorded. It comes from the tracer or from a
//! saved log, and nothing else enters a figure.

use std::io::{self, Write};

use glam::DVec3;

use crate::scene::Scene;
use crate::trace::{
    Event, EventWriter, Kind, LogError, LogNames, LogReader, Record, Settings, write_log_head,
};

/// The log of a figure: every event of the pixels that it draws, and of all others the colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Traced {
    /// The scene.
    pub scene: Scene,
    /// How it was traced; `whole` names the pixels that are drawn.
    pub settings: Settings,
    /// What was recorded, pixel after pixel, the building of the structure first.
    pub records: Vec<Record>,
}

/// The kinds of event that a figure's log keeps of every pixel: its colour, and how many tests each ray took.
pub const OF_EVERY_PIXEL: [Kind; 2] = [Kind::PixelColour, Kind::RayEnd];

impl Traced {
    /// Writes it as a log. Several logs behind each other are one figure's.
    ///
    /// # Errors
    /// A failing output.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        write_log_head(&self.scene, &self.settings, out)?;
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
    /// A log that is damaged, or none at all.
    pub fn read(file: &str, bytes: &[u8]) -> Result<Vec<Self>, LogError> {
        let mut all = Vec::new();
        let mut rest = bytes;
        while !rest.is_empty() || all.is_empty() {
            let end = next_head(rest);
            let mut reader = LogReader::open(file, &rest[..end])?;
            let mut records = Vec::new();
            while let Some(record) = reader.next_record()? {
                records.push(record);
            }
            all.push(Self {
                scene: reader.scene().clone(),
                settings: reader.settings().clone(),
                records,
            });
            rest = &rest[end..];
        }
        Ok(all)
    }

    /// The records of one pixel.
    pub(super) fn pixel(&self, pixel: [u32; 2]) -> &[Record] {
        let of = |record: &Record| record.pixel == Some(pixel);
        let first = self.records.iter().position(of).unwrap_or(0);
        let count = self.records[first..].iter().take_while(|record| of(record));
        &self.records[first..first + count.count()]
    }

    /// How the structure was built.
    pub(super) fn building(&self) -> impl Iterator<Item = &Record> {
        let of_none = |record: &&Record| record.pixel.is_none() && record.path.is_none();
        self.records.iter().filter(of_none)
    }

    /// The colour of each pixel, from the top left, cut to 0..1; `None` where the log has none.
    pub(super) fn picture(&self) -> Vec<Option<DVec3>> {
        self.of_pixels(None, |seen, event| {
            if let Event::PixelColour(colour) = event {
                *seen = Some(colour.clamped);
            }
        })
    }

    /// Something about each pixel, gathered from its events.
    pub(super) fn of_pixels<T: Clone>(&self, none: T, gather: impl Fn(&mut T, &Event)) -> Vec<T> {
        let [width, height] = self.scene.camera.pixels.map(|side| side as usize);
        let mut all = vec![none; width * height];
        for record in &self.records {
            let Some([x, y]) = record.pixel else {
                continue;
            };
            if let Some(seen) = all.get_mut(y as usize * width + x as usize) {
                gather(seen, &record.event);
            }
        }
        all
    }
}

/// Where the next log begins, or the end.
fn next_head(bytes: &[u8]) -> usize {
    /// How the writer begins a log.
    const HEAD: &[u8] = b"{\"kind\":\"trace\"";
    let mut at = 0;
    while let Some(end) = bytes[at..].iter().position(|&byte| byte == b'\n') {
        at += end + 1;
        if bytes[at..].starts_with(HEAD) {
            return at;
        }
    }
    bytes.len()
}
