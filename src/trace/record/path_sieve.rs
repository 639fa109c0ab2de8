//! Which paths of light of a log have led to a region.
//!
//! In a log the paths come before the pixels. Whether a photon arrives at a pixel is known at the end of its path; to which
//! pixel a path was connected follows from its number; but which stored photons a pixel has gathered is known only
//! when the pixel itself has been read.

use std::collections::BTreeSet;
use std::ops::ControlFlow;

use crate::trace::{Event, Kind, Record, Region, Settings, Sink, Transport};

/// Lets through the paths of light that can have led to a region, and all that belongs to no path.
///
/// A path is held back up to its end. Of light that is stored on surfaces, every path passes; so does every path of
/// a log without the kind of event that would show it.
#[derive(Clone, Debug)]
pub struct PathSieve<S> {
    /// The sink that receives the records of the paths that count.
    pub sink: S,
    region: Option<Region>,
    tells: Tells,
    held: Vec<Record>,
}

/// How a path shows where it led.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Tells {
    /// By what of it arrived at the eye.
    Arrivals,
    /// By that, and by its number: each pixel has this number of own paths, in pictures of this width.
    Number { samples: u32, width: u32 },
    /// Not at all.
    Nothing,
}

impl<S: Sink> PathSieve<S> {
    /// A sieve for a log with these settings, of a picture of this width in pixels; without a region everything passes.
    pub fn new(settings: &Settings, width: u32, region: Option<Region>, sink: S) -> Self {
        let tells = match settings.transport {
            _ if !names_paths(settings) => Tells::Nothing,
            Transport::Forward => Tells::Arrivals,
            Transport::HybridConnected => Tells::Number {
                samples: settings.light.samples,
                width,
            },
            _ => Tells::Nothing,
        };
        Self {
            sink,
            region,
            tells,
            held: Vec::new(),
        }
    }

    /// All is read: the path that is held back has ended.
    pub fn finish(&mut self) -> ControlFlow<()> {
        if self.held.is_empty() {
            return ControlFlow::Continue(());
        }
        let mut held = std::mem::take(&mut self.held);
        if self
            .region
            .is_none_or(|region| self.can_lead_to(region, &held))
        {
            for record in &held {
                self.sink.record(record)?;
            }
        }
        // its memory serves the next path
        held.clear();
        self.held = held;
        ControlFlow::Continue(())
    }

    fn can_lead_to(&self, region: Region, held: &[Record]) -> bool {
        let is_own = |path: u32| match self.tells {
            Tells::Arrivals => false,
            Tells::Nothing => true,
            Tells::Number { samples, width } => {
                let pixel = path / samples.max(1);
                region.contains([pixel % width, pixel / width])
            }
        };
        held.first()
            .and_then(|first| first.path)
            .is_some_and(is_own)
            || held.iter().any(|record| comes_to(record, region))
    }
}

impl<S: Sink> Sink for PathSieve<S> {
    #[inline]
    fn record(&mut self, record: &Record) -> ControlFlow<()> {
        let Some(path) = record.path.filter(|_| self.region.is_some()) else {
            self.finish()?;
            return self.sink.record(record);
        };
        let held = self.held.first().and_then(|first| first.path);
        if held.is_some_and(|held| held != path) {
            self.finish()?;
        }
        self.held.push(*record);
        ControlFlow::Continue(())
    }
}

/// The paths of light that led to a pixel, of records that hold the pixel's own and those of paths.
pub(crate) fn keep_paths_behind(pixel: [u32; 2], settings: &Settings, records: &mut Vec<Record>) {
    let region = Region::pixel(pixel);
    if !names_paths(settings) {
        // only the log's head shows it: the log was made for this pixel
        let is_for_it = settings.region == Some(region);
        records.retain(|record| record.path.is_none() || is_for_it);
        return;
    }
    let mut behind = BTreeSet::new();
    for record in records.iter() {
        match (record.path, &record.event) {
            (None, Event::Nearby(photon)) => behind.insert(photon.path),
            (None, Event::Connection(connection)) => behind.insert(connection.path),
            (Some(path), _) if comes_to(record, region) => behind.insert(path),
            _ => false,
        };
    }
    records.retain(|record| record.path.is_none_or(|path| behind.contains(&path)));
}

/// Does light arrive at the eye here, through a pixel of the region?
fn comes_to(record: &Record, region: Region) -> bool {
    match &record.event {
        Event::Arrival(arrival) => region.contains(arrival.pixel),
        Event::Connection(line) => {
            line.visible && line.pixel.is_some_and(|pixel| region.contains(pixel))
        }
        _ => false,
    }
}

/// Does the log hold the kind of event that names the paths behind a pixel?
fn names_paths(settings: &Settings) -> bool {
    let kind = match settings.transport {
        Transport::Forward => Kind::Arrival,
        Transport::HybridStored => Kind::Nearby,
        Transport::HybridConnected => Kind::Connection,
        Transport::Backward | Transport::HybridLight => return false,
    };
    // the log of a figure holds all of the paths and of the pixels that it shows, whatever it keeps of other pixels
    let only = settings.only.as_ref().filter(|_| settings.figure.is_none());
    only.is_none_or(|kept| kept.iter().any(|name| name == kind.name()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::{Arrival, Connection, Nearby, PathStart, PixelSample};

    fn of_path(path: u32, event: Event) -> Record {
        Record {
            pixel: None,
            path: Some(path),
            step: 0,
            ray: None,
            parent: None,
            event,
        }
    }

    fn of_pixel(pixel: [u32; 2], event: Event) -> Record {
        Record {
            pixel: Some(pixel),
            path: None,
            ..of_path(0, event)
        }
    }

    fn start(path: u32) -> Record {
        let start = PathStart {
            path,
            ..PathStart::default()
        };
        of_path(path, Event::Path(start))
    }

    fn arrival(path: u32, pixel: [u32; 2]) -> Record {
        let arrival = Arrival {
            pixel,
            ..Arrival::default()
        };
        of_path(path, Event::Arrival(arrival))
    }

    fn line(path: u32, pixel: [u32; 2], visible: bool) -> Record {
        let line = Connection {
            path,
            pixel: Some(pixel),
            visible,
            ..Connection::default()
        };
        of_path(path, Event::Connection(line))
    }

    fn settings(transport: Transport) -> Settings {
        let mut settings = Settings {
            transport,
            ..Settings::default()
        };
        settings.light.samples = 2;
        settings
    }

    /// The paths that pass, each once.
    fn passed(transport: Transport, region: Option<&str>, records: &[Record]) -> Vec<Option<u32>> {
        let region = region.map(|text| text.parse().unwrap());
        let mut sieve = PathSieve::new(&settings(transport), 4, region, Vec::new());
        for record in records {
            assert!(sieve.record(record).is_continue());
        }
        assert!(sieve.finish().is_continue());
        let mut paths: Vec<_> = sieve.sink.iter().map(|record| record.path).collect();
        paths.dedup();
        paths
    }

    #[test]
    fn of_a_forward_trace_the_paths_pass_that_arrive_in_the_region() {
        let pixel = of_pixel([1, 1], Event::Pixel(PixelSample::default()));
        let records = [
            start(0),
            arrival(0, [3, 3]),
            start(1),
            arrival(1, [0, 0]),
            arrival(1, [1, 1]),
            start(2),
            pixel,
        ];
        let forward = |region| passed(Transport::Forward, region, &records);
        assert_eq!(forward(Some("1,1")), [Some(1), None]);
        assert_eq!(forward(None), [Some(0), Some(1), Some(2), None]);
    }

    #[test]
    fn of_connected_paths_those_pass_that_are_a_pixels_own_or_are_seen_there() {
        // a picture 4 wide with two paths to a pixel: 10 and 11 are those of (1, 1)
        let records = [
            start(9),
            line(9, [1, 1], false),
            start(10),
            start(11),
            start(12),
            line(12, [1, 1], true),
            start(13),
        ];
        let connected = passed(Transport::HybridConnected, Some("1,1"), &records);
        assert_eq!(connected, [Some(10), Some(11), Some(12)]);
    }

    #[test]
    fn stored_light_may_be_gathered_anywhere_and_every_path_passes() {
        let records = [start(0), start(1)];
        let stored = passed(Transport::HybridStored, Some("1,1"), &records);
        assert_eq!(stored, [Some(0), Some(1)]);
    }

    #[test]
    fn behind_a_pixel_are_the_paths_that_it_names() {
        let nearby = Nearby {
            path: 1,
            ..Nearby::default()
        };
        let records = [start(0), start(1), of_pixel([1, 1], Event::Nearby(nearby))];
        let mut kept = records.to_vec();
        keep_paths_behind([1, 1], &settings(Transport::HybridStored), &mut kept);
        assert_eq!(kept, records[1..]);

        // nothing in the log says which
        let mut unnamed = Settings {
            only: Some(vec!["path".into()]),
            ..settings(Transport::HybridStored)
        };
        let mut kept = records[..2].to_vec();
        keep_paths_behind([1, 1], &unnamed, &mut kept);
        assert_eq!(kept, []);
        unnamed.region = Some(Region::pixel([1, 1]));
        let mut kept = records[..2].to_vec();
        keep_paths_behind([1, 1], &unnamed, &mut kept);
        assert_eq!(kept.len(), 2);
    }
}
