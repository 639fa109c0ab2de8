//! Who listens to the tracer, and what a recording adds to each event.
//!
//! The algorithms mention recording in one line after a step: `recorder.note(|| event)`. With [`Off`]
//! the compiler removes the line and all that only it needs; there is no flag to test at run time.

use std::ops::{AddAssign, ControlFlow};

use crate::trace::Event;

/// Hears of every step. A recorder never changes a result.
pub trait Recorder {
    /// Whether events are made at all. `false` removes each [`note`](Recorder::note) at compile time.
    const ENABLED: bool;

    /// A step was taken; the event is made only if somebody wants it.
    fn note(&mut self, event: impl FnOnce() -> Event);

    /// Has the recorder enough? Then tracing stops, and gives no result.
    #[inline]
    fn has_enough(&self) -> bool {
        false
    }

    /// A ray is about to be traced; `Break` if the recorder has enough. Called once for each ray.
    #[inline]
    fn next_ray(&mut self) -> ControlFlow<()> {
        if self.has_enough() {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }
}

/// Nobody listens.
#[derive(Clone, Copy, Debug, Default)]
pub struct Off;

/// Of two who heard nothing: nothing.
impl AddAssign for Off {
    fn add_assign(&mut self, _: Self) {}
}

impl Recorder for Off {
    const ENABLED: bool = false;

    #[inline(always)]
    fn note(&mut self, _: impl FnOnce() -> Event) {}
}

impl<R: Recorder> Recorder for &mut R {
    const ENABLED: bool = R::ENABLED;

    #[inline]
    fn note(&mut self, event: impl FnOnce() -> Event) {
        (**self).note(event);
    }

    #[inline]
    fn has_enough(&self) -> bool {
        (**self).has_enough()
    }

    #[inline]
    fn next_ray(&mut self) -> ControlFlow<()> {
        (**self).next_ray()
    }
}

/// Two recorders are one: both hear every event, and tracing stops when one of them has enough.
impl<A: Recorder, B: Recorder> Recorder for (A, B) {
    const ENABLED: bool = A::ENABLED || B::ENABLED;

    #[inline]
    fn note(&mut self, event: impl FnOnce() -> Event) {
        if Self::ENABLED {
            let event = event();
            self.0.note(|| event);
            self.1.note(|| event);
        }
    }

    #[inline]
    fn has_enough(&self) -> bool {
        self.0.has_enough() || self.1.has_enough()
    }

    #[inline]
    fn next_ray(&mut self) -> ControlFlow<()> {
        self.0.next_ray()?;
        self.1.next_ray()
    }
}

/// An event with its place in the pixel's trace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Record {
    /// Column and row of the pixel; `None` on a path of light, and while a structure is built.
    pub pixel: Option<[u32; 2]>,
    /// The number of the path of light; `None` in a pixel, and while a structure is built.
    pub path: Option<u32>,
    /// The number of the event in the pixel or on the path, from 0.
    pub step: u32,
    /// The ray it belongs to, numbered in the order of their starts from 0; `None` for the pixel's own.
    pub ray: Option<u32>,
    /// For a ray's start: the ray that spawned it.
    pub parent: Option<u32>,
    /// The event, with its working.
    pub event: Event,
}

/// Takes records: a list, a file, a filter in front of one of them.
pub trait Sink {
    /// One more record, in the order in which it happened. `Break` if no further one is wanted: none is handed over
    /// after that.
    fn record(&mut self, record: &Record) -> ControlFlow<()>;
}

impl Sink for Vec<Record> {
    #[inline]
    fn record(&mut self, record: &Record) -> ControlFlow<()> {
        self.push(*record);
        ControlFlow::Continue(())
    }
}

impl<S: Sink> Sink for &mut S {
    #[inline]
    fn record(&mut self, record: &Record) -> ControlFlow<()> {
        (**self).record(record)
    }
}

/// Numbers the events and the rays of each pixel and each path of light.
///
/// Rays nest: between a ray's start and its end are its own tests and the whole of the rays spawned
/// from it. So the ray that an event belongs to is the last one started and not ended.
#[derive(Clone, Debug, Default)]
pub(in crate::trace) struct Numbering {
    pixel: Option<[u32; 2]>,
    path: Option<u32>,
    step: u32,
    rays: u32,
    /// The ray that events belong to now, and before it the rays that spawned it.
    innermost: OpenRay,
    around: Vec<OpenRay>,
}

/// A ray that has started and not ended; without a number the pixel itself, around all its rays.
#[derive(Clone, Copy, Debug, Default)]
struct OpenRay {
    number: Option<u32>,
    tests: u32,
    hits: u32,
}

/// Where an event belongs, and what its ray's end must say.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct Place {
    pub(in crate::trace) pixel: Option<[u32; 2]>,
    pub(in crate::trace) path: Option<u32>,
    pub(in crate::trace) step: u32,
    pub(in crate::trace) ray: Option<u32>,
    pub(in crate::trace) parent: Option<u32>,
    /// For the end of a ray: the tests that were counted on it, and the hits among them.
    pub(in crate::trace) counted: Option<[u32; 2]>,
}

impl Numbering {
    /// The event with its place, and a ray's end with the tests that were counted on it.
    #[inline]
    pub(in crate::trace) fn number(&mut self, mut event: Event) -> Record {
        let Place {
            pixel,
            path,
            step,
            ray,
            parent,
            counted,
        } = self.place(&event);
        if let (Event::RayEnd(end), Some(counted)) = (&mut event, counted) {
            [end.tests, end.hits] = counted;
        }
        Record {
            pixel,
            path,
            step,
            ray,
            parent,
            event,
        }
    }

    /// A pixel or a path begins.
    fn start(&mut self, pixel: Option<[u32; 2]>, path: Option<u32>) {
        self.pixel = pixel;
        self.path = path;
        self.step = 0;
        self.rays = 0;
        self.innermost = OpenRay::default();
        self.around.clear();
    }

    /// The place of the next event.
    #[inline]
    pub(in crate::trace) fn place(&mut self, event: &Event) -> Place {
        let mut parent = None;
        let mut counted = None;
        let mut ray = self.innermost.number;
        match event {
            // numbers start again with each pixel and with each path of light
            Event::Pixel(start) if start.sample == 0 => {
                self.start(Some(start.pixel), None);
                ray = None;
            }
            Event::Path(start) => {
                self.start(None, Some(start.path));
                ray = None;
            }
            Event::Ray(_) => {
                parent = ray;
                ray = Some(self.rays);
                self.around.push(self.innermost);
                self.innermost = OpenRay {
                    number: ray,
                    ..OpenRay::default()
                };
                self.rays += 1;
            }
            Event::RayEnd(_) => {
                if let Some(around) = self.around.pop() {
                    counted = Some([self.innermost.tests, self.innermost.hits]);
                    self.innermost = around;
                }
            }
            other => {
                let (tested, met) = other.object_tested();
                self.innermost.tests += u32::from(tested);
                self.innermost.hits += u32::from(met);
            }
        }
        let step = self.step;
        self.step += 1;
        Place {
            pixel: self.pixel,
            path: self.path,
            step,
            ray,
            parent,
            counted,
        }
    }
}

/// Numbers every event and hands it to a sink, until that wants no more.
#[derive(Clone, Debug, Default)]
pub struct Recording<S> {
    sink: S,
    numbering: Numbering,
    /// The sink wants no more.
    stopped: bool,
}

impl<S: Sink> Recording<S> {
    /// A recording into a sink.
    pub fn new(sink: S) -> Self {
        Self {
            sink,
            numbering: Numbering::default(),
            stopped: false,
        }
    }

    /// The sink, to ask it how it is.
    pub fn sink(&self) -> &S {
        &self.sink
    }

    /// The sink, to empty it between two pixels.
    pub fn sink_mut(&mut self) -> &mut S {
        &mut self.sink
    }

    /// The sink, when all is done.
    pub fn into_sink(self) -> S {
        self.sink
    }
}

impl<S: Sink> Recorder for Recording<S> {
    const ENABLED: bool = true;

    #[inline]
    fn note(&mut self, event: impl FnOnce() -> Event) {
        if self.stopped {
            return;
        }
        let record = self.numbering.number(event());
        self.stopped = self.sink.record(&record).is_break();
    }

    #[inline]
    fn has_enough(&self) -> bool {
        self.stopped
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{QuadraticTest, Root, RootVerdict, Roots};
    use crate::scene::PrimitiveId;
    use crate::trace::{PixelSample, RayEnd, RayStart};

    fn ray() -> Event {
        Event::Ray(RayStart::default())
    }

    fn end() -> Event {
        Event::RayEnd(RayEnd::default())
    }

    fn sphere(hit: bool) -> Event {
        let roots = if hit {
            Roots::Graze(Root {
                t: 1.0,
                verdict: RootVerdict::Chosen,
            })
        } else {
            Roots::None
        };
        Event::SphereTest {
            object: PrimitiveId(0),
            test: QuadraticTest {
                roots,
                ..QuadraticTest::default()
            },
        }
    }

    fn pixel(x: u32) -> Event {
        Event::Pixel(PixelSample {
            pixel: [x, 0],
            samples: 1,
            ..PixelSample::default()
        })
    }

    fn record(events: &[Event]) -> Vec<Record> {
        let mut recording = Recording::new(Vec::new());
        for event in events {
            recording.note(|| *event);
        }
        recording.into_sink()
    }

    #[test]
    fn rays_are_numbered_in_the_order_of_their_starts_and_know_their_parent() {
        let records = record(&[
            pixel(3),
            ray(),
            ray(),
            ray(),
            end(),
            end(),
            ray(),
            end(),
            end(),
        ]);
        let rays: Vec<_> = records.iter().map(|r| r.ray).collect();
        let numbers = [
            None,
            Some(0),
            Some(1),
            Some(2),
            Some(2),
            Some(1),
            Some(3),
            Some(3),
            Some(0),
        ];
        assert_eq!(rays, numbers);
        let parents: Vec<_> = records.iter().map(|r| r.parent).collect();
        let expected = [
            None,
            None,
            Some(0),
            Some(1),
            None,
            None,
            Some(0),
            None,
            None,
        ];
        assert_eq!(parents, expected);
        assert!(
            records
                .iter()
                .enumerate()
                .all(|(i, r)| r.step as usize == i)
        );
        assert!(records.iter().all(|r| r.pixel == Some([3, 0])));
    }

    #[test]
    fn numbers_start_again_in_each_pixel() {
        let records = record(&[pixel(0), ray(), end(), pixel(1), ray(), end()]);
        let again = &records[3..];
        assert_eq!(again.iter().map(|r| r.step).collect::<Vec<_>>(), [0, 1, 2]);
        assert_eq!(again[1].ray, Some(0));
        assert_eq!(again[1].pixel, Some([1, 0]));
    }

    #[test]
    fn each_ray_counts_its_own_tests() {
        let records = record(&[
            pixel(0),
            ray(),
            sphere(true),
            sphere(false),
            ray(),
            sphere(false),
            end(),
            sphere(true),
            end(),
        ]);
        let counts: Vec<_> = records
            .iter()
            .filter_map(|r| match r.event {
                Event::RayEnd(end) => Some((end.tests, end.hits)),
                _ => None,
            })
            .collect();
        assert_eq!(counts, [(1, 0), (3, 2)]);
    }

    #[test]
    fn both_of_a_pair_hear_every_event_and_it_is_made_once() {
        let mut pair = (
            Recording::new(Vec::new()),
            (Off, Recording::new(Vec::new())),
        );
        let mut made = 0;
        pair.note(|| {
            made += 1;
            ray()
        });
        assert_eq!(made, 1);
        assert_eq!(pair.0.into_sink(), pair.1.1.into_sink());
        const { assert!(!<(Off, Off)>::ENABLED) };
    }
}
