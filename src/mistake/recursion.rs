//! The shade with the rays that it spawns: weights, and where the tree of rays ends.

use glam::DVec3;

use crate::mistake::{Mistake, Wrong};
use crate::scene::{Material, Scene};
use crate::tracer::Surface;
use crate::tracer::simple::shade;

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "ambient in the loop",
        sentence: "The ambient term is added once for each light instead of once.",
        spoils: "ambient",
        wrong: Wrong::Shade(ambient_in_the_loop),
    },
    Mistake {
        name: "no weight",
        sentence: "The colours of the reflected and the refracted ray are added in full, without their coefficients.",
        spoils: "reflection and transmission",
        wrong: Wrong::Shade(no_weight),
    },
    Mistake {
        name: "background at the limit",
        sentence: "A ray beyond the depth limit returns the background instead of black.",
        spoils: "I_reflected and I_refracted",
        wrong: Wrong::Shade(background_at_the_limit),
    },
    Mistake {
        name: "limit one too high",
        sentence: "The ray behind the last surface is still traced, so the tree of rays has one level more.",
        spoils: "I_reflected and I_refracted",
        wrong: Wrong::Shade(limit_too_high),
    },
    Mistake {
        name: "limit one too low",
        sentence: "The last ray that the depth limit allows is not traced, so the tree of rays has one level less.",
        spoils: "I_reflected and I_refracted",
        wrong: Wrong::Shade(limit_too_low),
    },
];

fn ambient_in_the_loop(scene: &Scene, parts: &Wrong, surface: &Surface<'_>) -> DVec3 {
    let ambient = scene.ambient * DVec3::from(surface.material.colour);
    shade(scene, parts, surface) + (scene.lights.len() as f64 - 1.0) * ambient
}

fn no_weight(scene: &Scene, parts: &Wrong, surface: &Surface<'_>) -> DVec3 {
    let full = |weight: f64| if 0.0 < weight { 1.0 } else { 0.0 };
    let material = Material {
        reflection: full(surface.material.reflection),
        transmission: full(surface.material.transmission),
        ..*surface.material
    };
    let surface = Surface {
        material: &material,
        ..*surface
    };
    shade(scene, parts, &surface)
}

fn background_at_the_limit(scene: &Scene, parts: &Wrong, surface: &Surface<'_>) -> DVec3 {
    let spawned = surface.material.reflection + surface.material.transmission;
    let is_limit = scene.max_depth <= surface.depth;
    let beyond = if is_limit { spawned } else { 0.0 };
    shade(scene, parts, surface) + beyond * scene.background
}

/// At the last surface the spawned rays are traced as if it were the one before, and what they hit spawns none.
fn limit_too_high(scene: &Scene, parts: &Wrong, surface: &Surface<'_>) -> DVec3 {
    if surface.depth < scene.max_depth {
        return shade(scene, parts, surface);
    }
    let before = Surface {
        depth: scene.max_depth.saturating_sub(1),
        ..*surface
    };
    shade(scene, &Wrong::Shade(as_the_last), &before)
}

fn as_the_last(scene: &Scene, parts: &Wrong, surface: &Surface<'_>) -> DVec3 {
    let last = Surface {
        depth: scene.max_depth,
        ..*surface
    };
    shade(scene, parts, &last)
}

fn limit_too_low(scene: &Scene, parts: &Wrong, surface: &Surface<'_>) -> DVec3 {
    if surface.depth + 1 < scene.max_depth {
        shade(scene, parts, surface)
    } else {
        as_the_last(scene, parts, surface)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{object, one_pixel, wall};
    use crate::tracer::simple::{Own, Parts, picture};

    /// Walls 5 ahead and 5 behind that reflect this share, with an ambient light of 1, and lights behind the first wall.
    fn walls(reflection: f64, depth: u32, lights: usize, background: f64) -> Scene {
        let light = r#"{"position":[0,0,-9],"colour":[1,1,1]}"#;
        one_pixel(&format!(
            r#""ambient":[1,1,1],"background":[{background},{background},{background}],"max_depth":{depth},
            "materials":{{"m":{{"colour":[1,1,1],"reflection":{reflection}}}}},"lights":[{}],
            "objects":[{},{}]"#,
            vec![light; lights].join(","),
            object("ahead", "m", &wall(-5.0)),
            object("behind", "m", &wall(5.0))
        ))
    }

    #[track_caller]
    fn check(wrong: fn(&Scene, &Wrong, &Surface<'_>) -> DVec3, scene: &Scene, expected: [f64; 2]) {
        fn seen(scene: &Scene, parts: &impl Parts) -> f64 {
            picture(scene, parts).colours[0].x
        }
        let found = [seen(scene, &Own), seen(scene, &Wrong::Shade(wrong))];
        assert_eq!(found, expected);
    }

    #[test]
    fn ambient_light_is_there_once() {
        check(ambient_in_the_loop, &walls(0.0, 1, 3, 0.0), [1.0, 3.0]);
        check(ambient_in_the_loop, &walls(0.0, 1, 1, 0.0), [1.0, 1.0]);
    }

    #[test]
    fn what_is_mirrored_has_its_weight() {
        // 1 + ½·(1 + ½·1) and 1 + 1·(1 + 1·1)
        check(no_weight, &walls(0.5, 3, 0, 0.0), [1.75, 3.0]);
        check(no_weight, &walls(0.0, 3, 0, 0.0), [1.0, 1.0]);
    }

    #[test]
    fn the_last_ray_is_that_of_the_limit_and_no_other() {
        // 1 + ½·(1 + ½·(1 + ½·0)), one term more, and one less
        check(limit_too_high, &walls(0.5, 3, 0, 0.0), [1.75, 1.875]);
        check(limit_too_low, &walls(0.5, 3, 0, 0.0), [1.75, 1.5]);
        // a limit of 1 is the eye ray alone, which is always traced
        check(limit_too_high, &walls(0.5, 1, 0, 0.0), [1.0, 1.5]);
        check(limit_too_low, &walls(0.5, 1, 0, 0.0), [1.0, 1.0]);
        // what mirrors nothing spawns nothing
        check(limit_too_high, &walls(0.0, 2, 0, 0.0), [1.0, 1.0]);
        check(limit_too_low, &walls(0.0, 2, 0, 0.0), [1.0, 1.0]);
    }

    #[test]
    fn beyond_the_limit_everything_is_black() {
        // 1 + ½·(1 + ½·0), and with ½·0.5 for the last ray
        check(
            background_at_the_limit,
            &walls(0.5, 2, 0, 0.5),
            [1.5, 1.625],
        );
        check(background_at_the_limit, &walls(0.5, 2, 0, 0.0), [1.5, 1.5]);
    }
}
