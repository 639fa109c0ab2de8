//! A whole picture: scan lines over threads.

use std::sync::atomic::{AtomicUsize, Ordering};

use glam::DVec3;

use crate::parallel;
use crate::strategy::Strategy;
use crate::trace::{Recorder, Through, Transport};
use crate::tracer::eye::pixel::mean;
use crate::tracer::eye::pixel::trace_pixel;
use crate::tracer::ray_limit::within;
use crate::tracer::stopped::Stopped;
use crate::tracer::tracer::Tracer;

/// The colours of a picture, row by row from the top left, before they are cut to 0..1.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Width and height of the picture in pixels.
    pub pixels: [u32; 2],
    /// One colour per pixel.
    pub colours: Vec<DVec3>,
}

impl Picture {
    /// The picture in 8 bits a channel, cut to 0..1, without gamma.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(3 * self.colours.len());
        for colour in &self.colours {
            bytes.extend_from_slice(&[byte(colour.x), byte(colour.y), byte(colour.z)]);
        }
        bytes
    }
}

/// A channel in 255 steps, rounded to the nearest, a half upwards. As `f64::round` says, of which few processors have an
/// instruction; what is cut off at the point is known without rounding.
#[inline]
fn byte(value: f64) -> u8 {
    let steps = value.clamp(0.0, 1.0) * 255.0;
    let whole = steps as u8;
    whole + u8::from(0.5 <= steps - f64::from(whole))
}

/// Traces a picture on the threads of the current pool: "for (each scan line in image) for (each pixel
/// in scan line)" (Fig. 15.56), and what the recorders of the scan lines heard, from top to bottom.
///
/// Through the corners, a picture of W × H pixels takes (W + 1) × (H + 1) eye rays, each shared by the
/// pixels around it. `done` hears how many scan lines of eye rays are finished.
///
/// # Errors
/// A recorder that has enough, or more rays than [`Tracer::max_rays`]: of the first such pixel from the top left,
/// on any number of threads.
#[doc(alias = "ray casting")]
pub fn render<S: Strategy, R: Recorder + Default + Send>(
    tracer: &Tracer<'_, S>,
    through: Through,
    done: impl Fn(usize) + Sync,
) -> Result<(Picture, Vec<R>), Stopped> {
    let camera = &tracer.scene.camera;
    let [width, height] = camera.pixels.map(|side| side as usize);
    // what paths of light bring arrives on the whole area of a pixel
    let by_pixel = matches!(
        tracer.transport,
        Transport::Forward | Transport::HybridConnected
    );
    let through = if by_pixel { Through::Centres } else { through };
    // the grid of eye rays: one in each cell, or one on each crossing of its lines
    let (columns, rows, offset) = match through {
        Through::Centres => (width, height, 0.5),
        Through::Corners => (width + 1, height + 1, 0.0),
    };

    let trace = |column: usize, row: usize, recorder: &mut R| {
        // the last corners to the right and below belong to the last pixels
        let pixel = [column.min(width - 1) as u32, row.min(height - 1) as u32];
        if by_pixel {
            return trace_pixel(tracer, pixel, through, recorder);
        }
        let (ray, window_t) = camera.eye_ray(column as f64 + offset, row as f64 + offset);
        within(tracer.max_rays, pixel, recorder, |recorder| {
            tracer.eye_ray(ray, window_t, recorder)
        })
    };
    let finished = AtomicUsize::new(0);
    let topmost_stopped = AtomicUsize::new(rows);
    let trace_row = |row: usize| -> Option<Result<(Vec<DVec3>, R), Stopped>> {
        if topmost_stopped.load(Ordering::Relaxed) < row {
            return None;
        }
        let mut recorder = R::default();
        let mut line = Vec::with_capacity(columns);
        let traced = (0..columns).try_for_each(|column| {
            line.push(trace(column, row, &mut recorder)?);
            Ok(())
        });
        if traced.is_err() {
            topmost_stopped.fetch_min(row, Ordering::Relaxed);
        }
        done(finished.fetch_add(1, Ordering::Relaxed) + 1);
        Some(traced.map(|()| (line, recorder)))
    };
    // a line is left out only below one that stopped
    let traced: Result<Vec<_>, Stopped> = parallel::map(rows, trace_row)
        .into_iter()
        .flatten()
        .collect();
    let (lines, recorders): (Vec<_>, Vec<_>) = traced?.into_iter().unzip();

    let colours = match through {
        Through::Centres => lines.into_iter().flatten().collect(),
        Through::Corners => lines
            .windows(2)
            .flat_map(|pair| {
                let (above, below) = (&pair[0], &pair[1]);
                (0..width).map(move |x| {
                    mean([above[x], above[x + 1], below[x], below[x + 1]].into_iter())
                })
            })
            .collect(),
    };
    let picture = Picture {
        pixels: camera.pixels,
        colours,
    };
    Ok((picture, recorders))
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use super::*;
    use crate::scene::small_scene::{object, polygon, scene_from};
    use crate::strategy::Exhaustive;
    use crate::trace::Off;

    #[test]
    fn a_channel_is_rounded_to_255_steps_and_cut_to_0_and_1() {
        let colours = vec![DVec3::new(0.5, 0.2, 2.0), DVec3::new(-1.0, 1.0, 0.001)];
        let picture = Picture {
            pixels: [2, 1],
            colours,
        };
        // 127.5, 51 and 0.255
        assert_eq!(picture.bytes(), [128, 51, 255, 0, 255, 0]);
    }

    #[test]
    fn a_channel_is_the_nearest_step_with_the_numbers_just_beside_a_half_too() {
        for step in 0..255 {
            let half = (f64::from(step) + 0.5) / 255.0;
            for value in [
                half.next_down(),
                half,
                half.next_up(),
                half - 0.001,
                half + 0.001,
            ] {
                assert_eq!(byte(value), (value * 255.0).round() as u8, "{value}");
            }
        }
        assert_eq!(
            [byte(f64::NAN), byte(-0.0), byte(1.0), byte(f64::INFINITY)],
            [0, 0, 255, 255]
        );
    }

    /// 3 × 2 pixels with sides of 1, and a wall that covers the window left of x = 0.25 and below y = 0.75.
    fn rendered(through: Through) -> (Picture, Vec<usize>) {
        let corners = [
            [-50.0, -50.0, -10.0],
            [2.5, -50.0, -10.0],
            [2.5, 7.5, -10.0],
            [-50.0, 7.5, -10.0],
        ];
        let scene = scene_from(&format!(
            r#"{{"camera":{{"window":{{"cop":[0,0,0],"corner":[-1.5,-1,-1],"right":[3,0,0],"up":[0,2,0]}},
            "pixels":[3,2]}},"ambient":[1,1,1],"materials":{{"m":{{"colour":[1,1,1]}}}},"objects":[{}]}}"#,
            object("wall", "m", &polygon(&corners))
        ));
        let strategy = Exhaustive::new(&scene);
        let tracer = Tracer::new(&scene, &strategy, Transport::HybridLight);
        let lines = Mutex::new(Vec::new());
        let done = |line| lines.lock().unwrap().push(line);
        let (picture, recorders) = render::<_, Off>(&tracer, through, done).unwrap();
        let mut lines = lines.into_inner().unwrap();
        lines.sort_unstable();
        assert_eq!(recorders.len(), lines.len());
        (picture, lines)
    }

    #[test]
    fn through_the_centres_a_pixel_has_one_eye_ray() {
        let (picture, lines) = rendered(Through::Centres);
        assert_eq!(picture.pixels, [3, 2]);
        // centres at x = −1, 0, 1 and y = ½, −½: the wall covers the first two of both lines
        let expected = [1.0, 1.0, 0.0, 1.0, 1.0, 0.0].map(DVec3::splat);
        assert_eq!(picture.colours, expected);
        assert_eq!(lines, [1, 2]);
    }

    #[test]
    fn through_the_corners_a_pixel_is_the_mean_of_the_four_around_it() {
        let (picture, lines) = rendered(Through::Corners);
        // corners at x = −1½, −½, ½, 1½ and y = 1, 0, −1: the wall covers the first two columns but for the top line
        let expected = [0.5, 0.25, 0.0, 1.0, 0.5, 0.0].map(DVec3::splat);
        assert_eq!(picture.colours, expected);
        assert_eq!(lines, [1, 2, 3]);
    }

    #[test]
    fn a_corner_beyond_the_last_pixels_belongs_to_them_where_it_takes_too_many_rays() {
        // mirrors that the corners to the right or below alone see: two rays, where one is allowed
        let stopped = |corners: [[f64; 3]; 4]| {
            let scene = scene_from(&format!(
                r#"{{"camera":{{"window":{{"cop":[0,0,0],"corner":[-1.5,-1,-1],"right":[3,0,0],"up":[0,2,0]}},
                "pixels":[3,2]}},"materials":{{"m":{{"colour":[1,1,1],"reflection":1}}}},"objects":[{}]}}"#,
                object("mirror", "m", &polygon(&corners))
            ));
            let strategy = Exhaustive::new(&scene);
            let tracer = Tracer::new(&scene, &strategy, Transport::HybridLight).with_max_rays(1);
            render::<_, Off>(&tracer, Through::Corners, |_| {}).map(|_| ())
        };
        let right = [
            [14.0, -50.0, -10.0],
            [50.0, -50.0, -10.0],
            [50.0, 50.0, -10.0],
            [14.0, 50.0, -10.0],
        ];
        let max_rays = 1;
        let pixel = [2, 0];
        assert_eq!(stopped(right), Err(Stopped::Rays { pixel, max_rays }));
        let below = [
            [-50.0, -50.0, -10.0],
            [50.0, -50.0, -10.0],
            [50.0, -9.0, -10.0],
            [-50.0, -9.0, -10.0],
        ];
        let pixel = [0, 1];
        assert_eq!(stopped(below), Err(Stopped::Rays { pixel, max_rays }));
    }
}
