//! One pixel: its places on the window, its eye rays, its colour.

use std::ops::ControlFlow;

use glam::{DVec2, DVec3};

use crate::strategy::Strategy;
use crate::trace::{Event, PixelColour, PixelSample, Recorder, Through, Transport};
use crate::tracer::ray_limit::within;
use crate::tracer::{LightPass, Stopped, Tracer};

/// The places through which a pixel's eye rays pass, in pixels from the window's top left corner.
///
/// One in its centre, (x + ½, y + ½), or four in its corners.
pub fn eye_samples([x, y]: [u32; 2], through: Through) -> impl ExactSizeIterator<Item = DVec2> {
    const CENTRE: &[[f64; 2]] = &[[0.5, 0.5]];
    const CORNERS: &[[f64; 2]] = &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    let offsets = match through {
        Through::Centres => CENTRE,
        Through::Corners => CORNERS,
    };
    let corner = DVec2::new(f64::from(x), f64::from(y));
    offsets
        .iter()
        .map(move |&offset| corner + DVec2::from(offset))
}

/// The mean of a pixel's eye rays, added in the order of [`eye_samples`] wherever it is formed.
pub(super) fn mean(colours: impl ExactSizeIterator<Item = DVec3>) -> DVec3 {
    let count = colours.len() as f64;
    colours.sum::<DVec3>() / count
}

/// The colour of one pixel, before it is cut to 0..1, with everything that led to it.
///
/// # Errors
/// A recorder that has enough, or more rays than [`Tracer::max_rays`].
pub fn trace_pixel<S: Strategy, R: Recorder>(
    tracer: &Tracer<'_, S>,
    pixel: [u32; 2],
    through: Through,
    recorder: &mut R,
) -> Result<DVec3, Stopped> {
    within(tracer.max_rays, pixel, recorder, |recorder| {
        let raw = match (tracer.transport, tracer.light) {
            (Transport::Forward, Some(light)) => seen_pixel(tracer, light, pixel, recorder),
            (Transport::HybridConnected, Some(light)) => {
                tracer.connected_pixel(light, pixel, recorder)?
            }
            _ => eye_pixel(tracer, pixel, through, recorder)?,
        };
        recorder.note(|| {
            Event::PixelColour(PixelColour {
                raw,
                clamped: raw.clamp(DVec3::ZERO, DVec3::ONE),
            })
        });
        ControlFlow::Continue(raw)
    })
}

/// A pixel into which eye rays are sent.
fn eye_pixel<S: Strategy, R: Recorder>(
    tracer: &Tracer<'_, S>,
    pixel: [u32; 2],
    through: Through,
    recorder: &mut R,
) -> ControlFlow<(), DVec3> {
    let places = eye_samples(pixel, through);
    let samples = places.len();
    let mut colours = [DVec3::ZERO; 4];
    for (sample, place) in places.enumerate() {
        let camera = &tracer.scene.camera;
        let point = camera.window_point(place.x, place.y);
        recorder.note(|| {
            Event::Pixel(PixelSample {
                pixel,
                sample: sample as u32,
                samples: samples as u32,
                place,
                point,
            })
        });
        let (ray, window_t) = camera.eye_ray(place.x, place.y);
        colours[sample] = tracer.eye_ray(ray, window_t, recorder)?;
    }
    ControlFlow::Continue(mean(colours[..samples].iter().copied()))
}

/// A pixel into which photons have come: no ray is sent from it.
fn seen_pixel<S: Strategy, R: Recorder>(
    tracer: &Tracer<'_, S>,
    light: &LightPass,
    pixel: [u32; 2],
    recorder: &mut R,
) -> DVec3 {
    recorder.note(|| {
        let place = DVec2::new(f64::from(pixel[0]) + 0.5, f64::from(pixel[1]) + 0.5);
        Event::Pixel(PixelSample {
            pixel,
            sample: 0,
            samples: 0,
            place,
            point: tracer.scene.camera.window_point(place.x, place.y),
        })
    });
    light.seen(pixel)
}
