//! A picture so small that it fits beside other things: to see which pixel of the scene one looks at.

use crate::scene::Scene;
use crate::strategy::Chosen;
use crate::structure::StructureOptions;
use crate::trace::{Off, StrategyName, Through, Transport};
use crate::tracer::{Tracer, render};

/// A small picture of a scene, row by row from the top left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Thumbnail {
    /// Its size.
    pub size: [u32; 2],
    /// The colour of each pixel.
    pub rgb: Vec<[u8; 3]>,
}

/// A scene with more objects takes longer to be built than one waits for a key.
const MOST_OBJECTS: usize = 100_000;

/// Above, a hierarchy is faster than testing all objects.
const FEW_OBJECTS: usize = 32;

/// So many rays of a pixel are followed: mirrors may face each other.
const MOST_RAYS: u64 = 1000;

/// Traces a small picture of a scene, no larger than that, of the same form as the scene's picture: with eye rays and shadow
/// rays, whatever the transport. `None` of a scene with too many objects or rays.
pub fn thumbnail(scene: &Scene, most: [u32; 2]) -> Option<Thumbnail> {
    if MOST_OBJECTS < scene.primitives.len() {
        return None;
    }
    let size = small(scene.camera.pixels, most);
    let mut small = scene.clone();
    small.camera.pixels = size;
    let strategy = if small.primitives.len() <= FEW_OBJECTS {
        StrategyName::Exhaustive
    } else {
        StrategyName::Hierarchy
    };
    let strategy = Chosen::new(&small, strategy, &StructureOptions::default()).ok()?;
    let tracer = Tracer::new(&small, &strategy, Transport::HybridLight).with_max_rays(MOST_RAYS);
    let (picture, _) = render::<_, Off>(&tracer, Through::Centres, |_| {}).ok()?;
    let rgb = picture.colours.iter().map(|colour| {
        let levels = (colour.clamp(glam::DVec3::ZERO, glam::DVec3::ONE) * 255.0).round();
        levels.to_array().map(|level| level as u8)
    });
    Some(Thumbnail {
        size,
        rgb: rgb.collect(),
    })
}

/// The largest size of the same form that fits.
fn small([width, height]: [u32; 2], [most_wide, most_high]: [u32; 2]) -> [u32; 2] {
    let (width, height) = (f64::from(width), f64::from(height));
    let scale = (f64::from(most_wide) / width).min(f64::from(most_high) / height);
    [width, height].map(|side| (side * scale).round().max(1.0) as u32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{object, one_pixel, wall};

    #[test]
    fn a_small_picture_has_the_form_of_the_large_one() {
        for (pixels, expected) in [
            ([160, 120], [32, 24]),
            ([1024, 256], [32, 8]),
            ([8, 6], [32, 24]),
            ([10, 400], [1, 24]),
        ] {
            assert_eq!(small(pixels, [32, 24]), expected, "{pixels:?}");
        }
    }

    #[test]
    fn its_colours_are_those_of_the_scene() {
        // ambient (1, 0.4, 0) on a wall of colour (1, 0.5, 1) that fills the picture
        let scene = one_pixel(&format!(
            r#""ambient":[1,0.4,0],"materials":{{"m":{{"colour":[1,0.5,1]}}}},"objects":[{}]"#,
            object("wall", "m", &wall(-5.0))
        ));
        let picture = thumbnail(&scene, [3, 2]).unwrap();
        assert_eq!(picture.size, [2, 2]);
        assert_eq!(picture.rgb, [[255, 51, 0]; 4]);
    }
}
