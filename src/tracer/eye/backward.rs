//! Backward ray tracing: from the eye into the scene, and on from what is hit.
//!
//! The slides' simple ray tracer (Fig. 15.56) sets the pixel to the colour at the closest intersection.
//! From there T. Whitted (1980) sends rays on: one in the mirror direction, one through the surface. What light
//! the lamps throw on a point is asked of the transport: without a ray to them
//! ([`Transport::Backward`]), with one ([`hybrid_light`](crate::tracer::eye::hybrid_light)), or of what paths of
//! light have stored there ([`hybrid_stored`](crate::tracer::light::hybrid_stored)).

use std::ops::ControlFlow;

use glam::DVec3;

use crate::geometry::{Ray, TRange, reflect};
use crate::strategy::Strategy;
use crate::trace::{Event, Purpose, RayEnd, RayStart, RayVerdict, Recorder, Shade};
use crate::tracer::surface::Surface;
use crate::tracer::tracer::Tracer;

impl<S: Strategy> Tracer<'_, S> {
    /// The colour that an eye ray sees.
    pub(in crate::tracer) fn eye_ray<R: Recorder>(
        &self,
        ray: Ray,
        window_t: f64,
        recorder: &mut R,
    ) -> ControlFlow<(), DVec3> {
        self.trace(eye_ray_start(ray, window_t), recorder)
    }

    /// The colour that a ray sees: the background, or the shade of what it hits. `Break` if the recorder has enough.
    fn trace<R: Recorder>(&self, start: RayStart, recorder: &mut R) -> ControlFlow<(), DVec3> {
        recorder.next_ray()?;
        recorder.note(|| Event::Ray(start));
        let hit = self.strategy.nearest(&start.ray, start.range, recorder);
        let colour = match hit {
            None if self.transport.follows_light() => DVec3::ZERO,
            None => self.scene.background,
            Some(hit) => self.shade(&self.surface(&start, hit), recorder)?,
        };
        recorder.note(|| {
            Event::RayEnd(RayEnd {
                verdict: hit.map_or(RayVerdict::Miss, |_| RayVerdict::Hit),
                object: hit.map(|hit| hit.object),
                t: hit.map(|hit| hit.t),
                colour: Some(colour),
                ..RayEnd::default()
            })
        });
        ControlFlow::Continue(colour)
    }

    /// I = ambient·colour + Σ lights + reflection·I_reflected + transmission·I_refracted
    fn shade<R: Recorder>(
        &self,
        surface: &Surface<'_>,
        recorder: &mut R,
    ) -> ControlFlow<(), DVec3> {
        let material = surface.material;
        let (ambient, direct) = match self.light {
            // light that came by other surfaces is stored too: ambient light would stand for it again
            Some(light) => (
                DVec3::ZERO,
                light.stored().gather(self.scene, surface, recorder),
            ),
            None => (
                self.scene.ambient * DVec3::from(material.colour),
                self.direct_light(surface, recorder)?,
            ),
        };

        // a ray that cannot pass is reflected with all its weight
        let mut reflection = material.reflection;
        let mut transmission = material.transmission;
        let mut through = None;
        if 0.0 < transmission {
            let refraction = surface.refraction(surface.normal, recorder);
            through = refraction.direction;
            if through.is_none() {
                reflection += transmission;
                transmission = 0.0;
            } else if self.transport.follows_light() {
                transmission *= refraction.radiance_factor();
            }
        }

        recorder.note(|| {
            Event::Shade(Shade {
                object: surface.object,
                point: surface.point,
                normal: surface.normal,
                back: surface.back,
                ambient,
                direct,
                reflection,
                transmission,
            })
        });

        let mut colour = ambient + direct;
        if 0.0 < reflection {
            let mirrored = reflect(surface.incoming, surface.normal);
            colour += reflection * self.send_on(surface, mirrored, Purpose::Reflected, recorder)?;
        }
        if let Some(direction) = through {
            colour +=
                transmission * self.send_on(surface, direction, Purpose::Refracted, recorder)?;
        }
        ControlFlow::Continue(colour)
    }

    /// The colour that a ray from the surface sees; black beyond the depth limit.
    fn send_on<R: Recorder>(
        &self,
        surface: &Surface<'_>,
        direction: DVec3,
        purpose: Purpose,
        recorder: &mut R,
    ) -> ControlFlow<(), DVec3> {
        let start = surface.sends(direction, purpose);
        if start.depth <= self.scene.max_depth {
            return self.trace(start, recorder);
        }
        recorder.note(|| Event::Ray(start));
        recorder.note(|| {
            Event::RayEnd(RayEnd {
                verdict: RayVerdict::DepthLimit,
                colour: Some(DVec3::ZERO),
                ..RayEnd::default()
            })
        });
        ControlFlow::Continue(DVec3::ZERO)
    }
}

/// An eye ray at its start.
pub(in crate::tracer) fn eye_ray_start(ray: Ray, window_t: f64) -> RayStart {
    RayStart {
        ray,
        range: TRange::FORWARD,
        purpose: Purpose::Eye,
        depth: 1,
        window_t: Some(window_t),
        light: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::scene::small_scene::{object, one_pixel, polygon, wall};
    use crate::strategy::Exhaustive;
    use crate::trace::{Off, Recording, Through, Transport};
    use crate::tracer::trace_pixel;

    /// Roundings of a few products of numbers up to 1.
    const ROUNDED: f64 = 1e-15;

    #[track_caller]
    fn check(scene: &Scene, transport: Transport, expected: [f64; 3]) {
        let strategy = Exhaustive::new(scene);
        let tracer = Tracer::new(scene, &strategy, transport);
        let found = trace_pixel(&tracer, [0, 0], Through::Centres, &mut Off).unwrap();
        let off = (found - DVec3::from(expected)).abs().max_element();
        assert!(off <= ROUNDED, "{found}, expected {expected:?}");
    }

    const GLASS: &str = r#""glass":{"colour":[1,0.5,1],"reflection":0.25,"transmission":0.5}"#;

    #[test]
    fn a_ray_that_meets_nothing_sees_the_background_unless_light_is_followed() {
        let scene = one_pixel(r#""background":[0.5,0.25,1],"objects":[]"#);
        check(&scene, Transport::HybridLight, [0.5, 0.25, 1.0]);
        check(&scene, Transport::HybridStored, [0.0; 3]);
    }

    #[test]
    fn reflected_and_refracted_rays_count_with_the_weights_of_the_material() {
        let scene = |depth: u32| {
            one_pixel(&format!(
                r#""ambient":[0.1,0.2,0.3],"background":[0.4,0.8,0.2],"max_depth":{depth},
                "materials":{{{GLASS}}},"objects":[{}]"#,
                object("wall", "glass", &wall(-5.0))
            ))
        };
        // ambient (0.1, 0.1, 0.3), and the background behind the eye with ¼ and behind the wall with ½
        check(&scene(2), Transport::HybridLight, [0.4, 0.7, 0.45]);
        // no ray is spawned
        check(&scene(1), Transport::HybridLight, [0.1, 0.1, 0.3]);
    }

    #[test]
    fn rays_between_two_mirrors_end_at_the_depth_limit() {
        // the eye between two mirrors of ½: 1 + ½ + ¼ for three rays
        let scene = |depth: u32| {
            one_pixel(&format!(
                r#""ambient":[1,1,1],"max_depth":{depth},"materials":{{"m":{{"colour":[1,1,1],"reflection":0.5}}}},
                "objects":[{},{}]"#,
                object("ahead", "m", &wall(-5.0)),
                object("behind", "m", &wall(5.0))
            ))
        };
        check(&scene(1), Transport::HybridLight, [1.0; 3]);
        check(&scene(3), Transport::HybridLight, [1.75; 3]);

        let scene = scene(3);
        let strategy = Exhaustive::new(&scene);
        let tracer = Tracer::new(&scene, &strategy, Transport::HybridLight);
        let mut recording = Recording::new(Vec::new());
        let _ = trace_pixel(&tracer, [0, 0], Through::Centres, &mut recording);
        let records = recording.into_sink();
        let depths = records.iter().filter_map(|record| match &record.event {
            Event::Ray(start) => Some(start.depth),
            _ => None,
        });
        // the fourth is noted and not traced
        assert_eq!(depths.collect::<Vec<_>>(), [1, 2, 3, 4]);
        let ends = records.iter().filter_map(|record| match &record.event {
            Event::RayEnd(end) => Some((end.verdict, end.t, end.colour)),
            _ => None,
        });
        let grey = |light| Some(DVec3::splat(light));
        let expected = [
            (RayVerdict::DepthLimit, None, grey(0.0)),
            (RayVerdict::Hit, Some(10.0), grey(1.0)),
            (RayVerdict::Hit, Some(10.0), grey(1.5)),
            (RayVerdict::Hit, Some(5.0), grey(1.75)),
        ];
        assert_eq!(ends.collect::<Vec<_>>(), expected);
    }

    #[test]
    fn where_no_ray_can_pass_the_reflected_one_has_the_weight_of_both() {
        // the back of a pane at 45° to the ray, which mirrors it along −x: there a wall with an ambient light of 0.1
        let scene = |index: f64| {
            let pane = [
                [-2.0, 9.0, -7.0],
                [2.0, 9.0, -3.0],
                [2.0, -9.0, -3.0],
                [-2.0, -9.0, -7.0],
            ];
            let beside = [
                [-9.0, -9.0, -9.0],
                [-9.0, -9.0, 9.0],
                [-9.0, 9.0, 9.0],
                [-9.0, 9.0, -9.0],
            ];
            one_pixel(&format!(
                r#""ambient":[0.1,0.1,0.1],"background":[0.8,0.8,0.8],"materials":{{"white":{{"colour":[1,1,1]}},
                "glass":{{"colour":[0,0,0],"reflection":0.25,"transmission":0.5,"index":{index}}}}},
                "objects":[{},{}]"#,
                object("pane", "glass", &polygon(&pane)),
                object("beside", "white", &polygon(&beside))
            ))
        };
        // sin 45°·1.2 is below 1: ¼ of the wall and ½ of the background; sin 45°·2 is not: ¾ of the wall
        check(&scene(1.2), Transport::HybridLight, [0.425; 3]);
        check(&scene(2.0), Transport::HybridLight, [0.075; 3]);
    }

    #[test]
    fn where_light_is_followed_radiance_behind_glass_counts_with_the_square_of_the_indices() {
        let scene = one_pixel(&format!(
            r#""ambient":[1,1,1],"materials":{{"white":{{"colour":[1,1,1]}},
            "glass":{{"colour":[0,0,0],"transmission":0.5,"index":2}}}},"objects":[{},{}]"#,
            object("pane", "glass", &wall(-5.0)),
            object("behind", "white", &wall(-9.0))
        ));
        // ½ of what the wall shows; ½·(1/2)² of it
        check(&scene, Transport::HybridLight, [0.5; 3]);
        check(&scene, Transport::HybridStored, [0.125; 3]);
    }

    #[test]
    fn an_eye_ray_has_depth_1_and_knows_where_it_passes_the_window() {
        let start = eye_ray_start(Ray::new(DVec3::ZERO, DVec3::Y), 2.5);
        assert_eq!(
            (start.depth, start.purpose, start.window_t),
            (1, Purpose::Eye, Some(2.5))
        );
        assert_eq!((start.range, start.light), (TRange::FORWARD, None));
    }
}
