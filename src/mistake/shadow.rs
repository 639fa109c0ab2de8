//! The shadow ray: is the light hidden?

use crate::geometry::{Ray, TRange};
use crate::mistake::{Mistake, Wrong};
use crate::scene::Scene;
use crate::tracer::simple::{Own, Parts};

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "any hit counts",
        sentence: "An object behind the light blocks it too, because t of the light does not end the shadow ray.",
        spoils: "blocked",
        wrong: Wrong::Blocked(any_hit_counts),
    },
    Mistake {
        name: "no shadow ray",
        sentence: "No shadow ray is cast, so every light in front of the surface counts as visible.",
        spoils: "blocked",
        wrong: Wrong::Blocked(no_shadow_ray),
    },
    Mistake {
        name: "from the eye",
        sentence: "The shadow ray starts at the eye and not at the point that is shaded.",
        spoils: "blocked",
        wrong: Wrong::Blocked(from_the_eye),
    },
    Mistake {
        name: "first light only",
        sentence: "A shadow ray is cast to the first light alone, and every other light counts as visible.",
        spoils: "blocked",
        wrong: Wrong::Blocked(first_light_only),
    },
];

fn any_hit_counts(scene: &Scene, ray: &Ray, range: TRange) -> bool {
    let endless = TRange {
        max: f64::INFINITY,
        ..range
    };
    Own.blocked(scene, ray, endless)
}

fn from_the_eye(scene: &Scene, ray: &Ray, range: TRange) -> bool {
    let moved = Ray::new(scene.camera.cop, ray.direction);
    Own.blocked(scene, &moved, range)
}

/// The light that the ray is cast to is the one nearest to its end.
fn first_light_only(scene: &Scene, ray: &Ray, range: TRange) -> bool {
    let end = ray.at(range.max);
    let from_end = |light: usize| scene.lights[light].position.distance_squared(end);
    let lights = 0..scene.lights.len();
    let light = lights.min_by(|&one, &other| from_end(one).total_cmp(&from_end(other)));
    light == Some(0) && Own.blocked(scene, ray, range)
}

fn no_shadow_ray(_scene: &Scene, _ray: &Ray, _range: TRange) -> bool {
    false
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::scene::small_scene::{object, one_pixel, sphere};

    /// Balls of radius 1 around (5, 0, 0) and (0, 5, 0), and lights at (9, 0, 0) and (0, 9, 0). The eye is in the origin.
    fn scene() -> Scene {
        let ball = |name, center| object(name, "m", &sphere(center, 1.0));
        one_pixel(&format!(
            r#""materials":{{"m":{{"colour":[1,1,1]}}}},
            "lights":[{{"position":[9,0,0],"colour":[1,1,1]}},{{"position":[0,9,0],"colour":[1,1,1]}}],
            "objects":[{},{}]"#,
            ball("A", [5.0, 0.0, 0.0]),
            ball("B", [0.0, 5.0, 0.0])
        ))
    }

    #[test]
    fn only_what_stands_between_the_point_and_this_light_blocks_it() {
        let scene = scene();
        let from = |origin: [f64; 3], direction: DVec3, max: f64| {
            let ray = Ray::new(origin.into(), direction);
            let range = TRange { min: 1e-9, max };
            [Own.blocked(&scene, &ray, range)]
                .into_iter()
                .chain(
                    [
                        any_hit_counts,
                        from_the_eye,
                        first_light_only,
                        no_shadow_ray,
                    ]
                    .map(|wrong| wrong(&scene, &ray, range)),
                )
                .collect::<Vec<_>>()
        };
        // from the origin to each light the ball is in between, at t = 4
        assert_eq!(
            from([0.0; 3], DVec3::X, 9.0),
            [true, true, true, true, false]
        );
        assert_eq!(
            from([0.0; 3], DVec3::Y, 9.0),
            [true, true, true, false, false]
        );
        // the ball begins behind a light that is 3 away
        assert_eq!(
            from([0.0; 3], DVec3::X, 3.0),
            [false, true, false, false, false]
        );
        // from z = 2 the ray passes the ball, from the eye it does not
        assert_eq!(
            from([0.0, 0.0, 2.0], DVec3::X, 9.0),
            [false, false, true, false, false]
        );
    }
}
