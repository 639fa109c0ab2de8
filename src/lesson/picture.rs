//! The picture in a figure: finer than the scene's pixels, and antialiased.

use glam::DVec3;

use crate::figure::{FigureError, FigureSpec, Fineness};
use crate::lesson::error::too_many_rays;
use crate::scene::Scene;
use crate::strategy::Chosen;
use crate::structure::StructureOptions;
use crate::trace::{LoggedPicture, Off, StrategyName, Through, Transport};
use crate::tracer::{LightPass, Tracer, render};

/// The least length of the longer side: a third of a book's column.
const LEAST_SIDE: u32 = 256;

/// Samples along each side of a pixel: four in all make edges smooth, and nine differ from them by less than can be seen at
/// the size of a figure.
const SAMPLES: u32 = 2;

/// The most eye rays of a picture: some seconds.
const MOST_EYE_RAYS: u64 = 4_000_000;

/// Traces the picture of a figure, with recording off. Each pixel is the mean of its samples, which are cut to 0..1 before, so
/// that the edge of a highlight is as smooth as any other.
///
/// The picture is the same with every strategy, so the fastest for many objects traces it. Where light arrives on whole
/// pixels, there is one sample for each of the scene's pixels.
///
/// # Errors
/// A fineness that takes too many eye rays, or a tree of rays that does not end.
pub(super) fn trace_picture(
    scene: &Scene,
    (spec, transport): (&FigureSpec, Transport),
    light: Option<&LightPass>,
) -> Result<LoggedPicture, FigureError> {
    let by_pixel = matches!(transport, Transport::Forward | Transport::HybridConnected);
    let [finer, samples] = if by_pixel {
        [1, 1]
    } else {
        sides(spec.picture, scene.camera.pixels)?
    };
    let mut fine = scene.clone();
    let coarser = if by_pixel || spec.picture.finer.is_some() {
        1
    } else {
        coarser(scene.camera.pixels)
    };
    let pixels = scene
        .camera
        .pixels
        .map(|side| (side * finer).div_ceil(coarser));
    fine.camera.pixels = pixels.map(|side| side * samples);
    let strategy = Chosen::new(&fine, StrategyName::Hierarchy, &StructureOptions::default());
    let strategy = strategy
        .map_err(|fault| FigureError::new("scene", fault.to_string(), "change it in the scene"))?;
    let tracer = Tracer::new(&fine, &strategy, transport).with_light(light);
    let rendered = render::<_, Off>(&tracer, Through::Centres, |_| {});
    let (picture, _) = rendered.map_err(|stopped| too_many_rays(&stopped))?;
    Ok(LoggedPicture {
        pixels,
        samples: samples * samples,
        rgb: means(&picture.colours, pixels, samples),
    })
}

/// Of a large picture, how many of the scene's pixels lie along each side of one of the figure's: it stays between 256 and 512
/// pixels wide.
fn coarser([width, height]: [u32; 2]) -> u32 {
    (width.max(height) / LEAST_SIDE).max(1)
}

/// How many pixels and samples lie along each side of one of the scene's pixels, and of one of the picture's.
fn sides(fineness: Fineness, [width, height]: [u32; 2]) -> Result<[u32; 2], FigureError> {
    let finer = fineness.finer;
    let finer = finer.unwrap_or(LEAST_SIDE.div_ceil(width.max(height)));
    let is_few = |samples: u32| {
        let along = u64::from(finer) * u64::from(samples);
        let of_each = along.checked_mul(along);
        let all = of_each.and_then(|rays| rays.checked_mul(u64::from(width) * u64::from(height)));
        (1..=MOST_EYE_RAYS).contains(&all.unwrap_or(u64::MAX))
    };
    // of a large picture the pixels themselves are fine enough
    let usual = if is_few(SAMPLES) { SAMPLES } else { 1 };
    let samples = fineness.samples.unwrap_or(usual);
    if is_few(samples) {
        return Ok([finer, samples]);
    }
    Err(FigureError::new(
        "picture",
        format!(
            "{finer} × {finer} pixels with {samples} × {samples} eye rays each, for each of {width} × {height} pixels, \
             are none or too many"
        ),
        "lower \"finer\" or \"samples\", or give the figure a smaller \"size\": at most 4 million eye rays in all",
    ))
}

/// The mean of each square of samples, in 8 bits a channel.
fn means(samples: &[DVec3], [width, height]: [u32; 2], side: u32) -> Vec<u8> {
    let [width, height, side] = [width, height, side].map(|of| of as usize);
    let mut rgb = Vec::with_capacity(3 * width * height);
    for y in 0..height {
        for x in 0..width {
            let mut sum = DVec3::ZERO;
            for row in y * side..(y + 1) * side {
                let from = row * width * side + x * side;
                for colour in &samples[from..from + side] {
                    sum += colour.clamp(DVec3::ZERO, DVec3::ONE);
                }
            }
            let mean = sum / (side * side) as f64;
            rgb.extend((mean * 255.0).round().to_array().map(|of| of as u8));
        }
    }
    rgb
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_large_picture_is_drawn_with_fewer_pixels() {
        for (pixels, expected) in [
            ([64, 48], 1),
            ([511, 300], 1),
            ([512, 512], 2),
            ([300, 1920], 7),
        ] {
            assert_eq!(coarser(pixels), expected, "{pixels:?}");
        }
    }

    #[test]
    fn a_pixel_is_the_mean_of_its_square_of_samples() {
        let [black, white] = [DVec3::ZERO, DVec3::ONE];
        // two pixels of 2 × 2 samples: a quarter white, and three quarters of which one is brighter than white
        let samples = [
            black,
            black,
            white,
            black, //
            black,
            white,
            white,
            white * 9.0,
        ];
        // 255/4 = 63.75, 255·3/4 = 191.25
        let rgb = means(&samples, [2, 1], 2);
        assert_eq!(rgb, [64, 64, 64, 191, 191, 191]);
        assert_eq!(means(&[white * 0.5], [1, 1], 1), [128; 3]);
    }

    #[test]
    fn the_longer_side_is_usually_at_least_256_with_four_samples() {
        for (size, expected) in [
            ([61, 45], [5, 2]),
            ([96, 64], [3, 2]),
            ([255, 9], [2, 2]),
            ([256, 9], [1, 2]),
            ([1, 900], [1, 2]),
            ([1, 1], [256, 2]),
            // 3 million pixels of 4 samples are too many
            ([2000, 1500], [1, 1]),
        ] {
            assert_eq!(sides(Fineness::default(), size), Ok(expected), "{size:?}");
        }
        let of = |finer, samples, size| {
            let fineness = Fineness {
                finer: Some(finer),
                samples: Some(samples),
            };
            sides(fineness, size)
        };
        // 1000 · 1000 · 2 · 2 is the most
        assert_eq!(of(1, 2, [1000, 1000]), Ok([1, 2]));
        for (finer, samples, size) in [
            (1, 2, [1001, 1000]),
            (0, 2, [9, 9]),
            (1, 0, [9, 9]),
            (u32::MAX, u32::MAX, [9, 9]),
        ] {
            assert_eq!(of(finer, samples, size).unwrap_err().key, "picture");
        }
    }
}
