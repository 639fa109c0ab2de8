//! A recording that stops.

use std::ops::ControlFlow;

use raystep::strategy::{Exhaustive, Strategy};
use raystep::trace::{Budget, Sink};
use raystep::tracer::trace_pixel;
use raystep::{
    Chosen, Off, Record, Recorder, Recording, Scene, Settings, Stopped, Through, Tracer, Transport,
};

use crate::trace_log::strategies::{ways, with_slabs};
use crate::trace_log::{EXAMPLE, built};

/// The scene of the design: a glass ellipsoid among others, with a lamp.
fn scene() -> Scene {
    with_slabs(built(EXAMPLE))
}

/// The pixel's records up to a budget, and whether it was traced to its end.
fn traced<S: Strategy>(
    tracer: &Tracer<'_, S>,
    pixel: [u32; 2],
    budget: u64,
) -> (Vec<Record>, Result<(), Stopped>) {
    let mut recording = Recording::new(Budget {
        left: budget,
        sink: Vec::new(),
    });
    let traced = trace_pixel(tracer, pixel, Through::Centres, &mut recording);
    (recording.into_sink().sink, traced.map(|_| ()))
}

#[test]
fn a_budget_cuts_a_pixel_at_any_event_and_keeps_what_came_before() {
    let scene = scene();
    for settings in ways() {
        let strategy = Chosen::new(&scene, settings.strategy, &settings.structure).unwrap();
        let tracer = Tracer::new(&scene, &strategy, Transport::HybridLight);
        // B, of glass: a tree of rays
        let pixel = [135, 60];
        let (all, whole) = traced(&tracer, pixel, u64::MAX);
        assert_eq!(whole, Ok(()));
        let rays = all.iter().filter_map(|record| record.ray).max();
        assert!(Some(2) < rays, "{rays:?} is too small a tree");
        for budget in 0..=all.len() {
            let (kept, whole) = traced(&tracer, pixel, budget as u64);
            assert!(kept == all[..budget], "{budget}");
            let expected = if budget == all.len() {
                Ok(())
            } else {
                Err(Stopped::Recorder)
            };
            assert_eq!(whole, expected, "{budget} of {}", all.len());
        }
    }
}

/// Wants so many records, and counts how many are handed over.
struct Wants {
    records: usize,
    handed_over: usize,
}

impl Sink for Wants {
    fn record(&mut self, _: &Record) -> ControlFlow<()> {
        self.handed_over += 1;
        if self.handed_over < self.records {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    }
}

#[test]
fn a_sink_that_wants_no_more_is_handed_no_more() {
    let scene = scene();
    let strategy = Exhaustive::new(&scene);
    let tracer = Tracer::new(&scene, &strategy, Transport::HybridLight);
    for records in [1, 2, 7, 100] {
        let wants = Wants {
            records,
            handed_over: 0,
        };
        let mut recording = Recording::new(wants);
        let whole = trace_pixel(&tracer, [135, 60], Through::Centres, &mut recording);
        assert_eq!(whole, Err(Stopped::Recorder));
        // and of the next pixel nothing at all
        let whole = trace_pixel(&tracer, [80, 60], Through::Centres, &mut recording);
        assert_eq!(whole, Err(Stopped::Recorder));
        assert_eq!(recording.into_sink().handed_over, records);
    }
}

/// Counts the rays that it is asked about, and has enough of them.
struct Rays {
    asked: u32,
    most: u32,
}

impl Recorder for Rays {
    const ENABLED: bool = false;

    fn note(&mut self, _: impl FnOnce() -> raystep::Event) {
        panic!("no event is wanted");
    }

    fn has_enough(&self) -> bool {
        self.most < self.asked
    }

    fn next_ray(&mut self) -> ControlFlow<()> {
        self.asked += 1;
        if self.has_enough() {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }
}

#[test]
fn a_recorder_is_asked_once_before_each_ray_that_is_traced() {
    let scene = scene();
    let strategy = Exhaustive::new(&scene);
    let settings = Settings::default();
    let tracer = Tracer::new(&scene, &strategy, settings.transport);
    for pixel in [[80, 60], [135, 60], [10, 100]] {
        let mut counts = raystep::Counts::default();
        trace_pixel(&tracer, pixel, Through::Corners, &mut counts).unwrap();
        let cast: u64 = counts.rays.iter().map(|rays| rays.traced).sum();
        let most = cast as u32;
        let mut rays = Rays { asked: 0, most };
        let mut both = (Off, &mut rays);
        trace_pixel(&tracer, pixel, Through::Corners, &mut both).unwrap();
        assert_eq!(u64::from(rays.asked), cast);
        for most in 0..most {
            let mut rays = Rays { asked: 0, most };
            let whole = trace_pixel(&tracer, pixel, Through::Corners, &mut rays);
            assert_eq!(whole, Err(Stopped::Recorder));
            assert_eq!(rays.asked, most + 1);
        }
    }
}
