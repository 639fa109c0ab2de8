//! One pixel: its places on the window, its eye rays, its colour.

use std::ops::ControlFlow;

use glam::{DVec2, DVec3};

use crate::strategy::Strategy;
use crate::trace::{Event, PixelColour, PixelSample, Recorder, Through, Transport};
use crate::tracer::light::light_pass::LightPass;
use crate::tracer::ray_limit::within;
use crate::tracer::stopped::Stopped;
use crate::tracer::tracer::Tracer;

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
pub(in crate::tracer) fn mean(colours: impl ExactSizeIterator<Item = DVec3>) -> DVec3 {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{object, one_pixel, polygon};
    use crate::strategy::Exhaustive;
    use crate::trace::{Off, Recording};

    #[test]
    fn eye_rays_pass_the_centre_of_a_pixel_or_its_four_corners() {
        let places = |through| {
            eye_samples([3, 7], through)
                .map(|p| p.to_array())
                .collect::<Vec<_>>()
        };
        assert_eq!(places(Through::Centres), [[3.5, 7.5]]);
        let corners = [[3.0, 7.0], [4.0, 7.0], [3.0, 8.0], [4.0, 8.0]];
        assert_eq!(places(Through::Corners), corners);
    }

    #[test]
    fn a_pixel_is_the_mean_of_its_eye_rays() {
        let colours = [1.0, 2.0, 6.0, 3.0].map(DVec3::splat);
        assert_eq!(mean(colours.into_iter()), DVec3::splat(3.0));
        // a wall on the left: of the four corners two see it
        let left = polygon(&[
            [-9.0, -9.0, -5.0],
            [0.5, -9.0, -5.0],
            [0.5, 9.0, -5.0],
            [-9.0, 9.0, -5.0],
        ]);
        let scene = one_pixel(&format!(
            r#""ambient":[1,1,1],"materials":{{"m":{{"colour":[0.5,1,3]}}}},"objects":[{}]"#,
            object("left", "m", &left)
        ));
        let strategy = Exhaustive::new(&scene);
        let tracer = Tracer::new(&scene, &strategy, Transport::HybridLight);
        let colour = |through| trace_pixel(&tracer, [0, 0], through, &mut Off).unwrap();
        assert_eq!(colour(Through::Centres), DVec3::new(0.5, 1.0, 3.0));
        assert_eq!(colour(Through::Corners), DVec3::new(0.25, 0.5, 1.5));

        let mut recording = Recording::new(Vec::new());
        let _ = trace_pixel(&tracer, [0, 0], Through::Corners, &mut recording);
        let records = recording.into_sink();
        let samples: Vec<_> = records
            .iter()
            .filter_map(|record| match &record.event {
                Event::Pixel(sample) => {
                    Some((sample.sample, sample.samples, sample.point.to_array()))
                }
                _ => None,
            })
            .collect();
        let expected = [
            (0, 4, [-1.0, 1.0, -1.0]),
            (1, 4, [1.0, 1.0, -1.0]),
            (2, 4, [-1.0, -1.0, -1.0]),
            (3, 4, [1.0, -1.0, -1.0]),
        ];
        assert_eq!(samples, expected);
        // what is shown is cut to 0..1
        let raw = DVec3::new(0.25, 0.5, 1.5);
        let clamped = DVec3::new(0.25, 0.5, 1.0);
        let last = records.last().map(|record| record.event);
        assert_eq!(last, Some(Event::PixelColour(PixelColour { raw, clamped })));
    }
}
