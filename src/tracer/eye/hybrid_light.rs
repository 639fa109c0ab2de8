//! Hybrid ray tracing with rays to the light: backward, and from each point a ray to each light, as T. Whitted
//! (1980) does. What it hits on the way throws a shadow.

use std::ops::ControlFlow;

use glam::DVec3;

use crate::geometry::{Ray, TRange};
use crate::scene::Light;
use crate::strategy::Strategy;
use crate::trace::{
    Event, LightTerm, Purpose, RayStart, RayVerdict, Recorder, Transport, Visibility,
};
use crate::tracer::epsilon::EPSILON;
use crate::tracer::surface::Surface;
use crate::tracer::tracer::Tracer;

impl<S: Strategy> Tracer<'_, S> {
    /// Σ over the lights that reach a point.
    pub(in crate::tracer) fn direct_light<R: Recorder>(
        &self,
        surface: &Surface<'_>,
        recorder: &mut R,
    ) -> ControlFlow<(), DVec3> {
        let mut direct = DVec3::ZERO;
        for (number, light) in (0..).zip(&self.scene.lights) {
            direct += self.light(number, light, surface, recorder)?;
        }
        ControlFlow::Continue(direct)
    }

    /// What one light adds; with a shadow ray, unless the surface faces away from the light.
    fn light<R: Recorder>(
        &self,
        number: u32,
        light: &Light,
        surface: &Surface<'_>,
        recorder: &mut R,
    ) -> ControlFlow<(), DVec3> {
        let to_viewer = -surface.incoming;
        let term = light.phong(surface.material, surface.point, surface.normal, to_viewer);
        let visibility = if term.n_dot_l <= 0.0 {
            Visibility::FacesAway
        } else if self.transport == Transport::Backward {
            Visibility::NotTested
        } else if self.is_blocked(number, surface, term.to_light, term.distance, recorder)? {
            Visibility::Shadowed
        } else {
            Visibility::Visible
        };
        recorder.note(|| {
            Event::LightTerm(LightTerm {
                light: number,
                visibility,
                term,
            })
        });
        ControlFlow::Continue(match visibility {
            Visibility::Visible | Visibility::NotTested => term.diffuse + term.specular,
            Visibility::Shadowed | Visibility::FacesAway => DVec3::ZERO,
        })
    }

    /// Does anything stand between the point and the light? Every object casts a full shadow.
    fn is_blocked<R: Recorder>(
        &self,
        light: u32,
        surface: &Surface<'_>,
        to_light: DVec3,
        distance: f64,
        recorder: &mut R,
    ) -> ControlFlow<(), bool> {
        let start = RayStart {
            ray: Ray::new(surface.point, to_light),
            range: TRange {
                min: surface.epsilon,
                // a light in a surface is not blocked by that surface
                max: distance * (1.0 - EPSILON),
            },
            purpose: Purpose::Shadow,
            depth: surface.depth + 1,
            window_t: None,
            light: Some(light),
        };
        let is_clear = self.is_clear(start, RayVerdict::ReachesLight, recorder)?;
        ControlFlow::Continue(!is_clear)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::scene::small_scene::{object, one_pixel, polygon, sphere, wall};
    use crate::strategy::Exhaustive;
    use crate::trace::{Off, Recording, Through};
    use crate::tracer::trace_pixel;

    /// A wall 5 ahead, of colour 1 and diffuse ½, and a light at (0, 3, −1): 5 from the point that the eye sees, at a cosine of 0.8.
    fn lit(more: &[String], light: [f64; 3]) -> Scene {
        let mut objects = vec![object("wall", "m", &wall(-5.0))];
        objects.extend_from_slice(more);
        one_pixel(&format!(
            r#""materials":{{"m":{{"colour":[1,0.5,0],"diffuse":0.5}}}},
            "lights":[{{"position":{light:?},"colour":[1,1,2]}}],"objects":[{}]"#,
            objects.join(",")
        ))
    }

    const LAMP: [f64; 3] = [0.0, 3.0, -1.0];

    #[track_caller]
    fn check(scene: &Scene, transport: Transport, expected: [f64; 3]) {
        let strategy = Exhaustive::new(scene);
        let tracer = Tracer::new(scene, &strategy, transport);
        let found = trace_pixel(&tracer, [0, 0], Through::Centres, &mut Off).unwrap();
        let off = (found - DVec3::from(expected)).abs().max_element();
        assert!(off <= 1e-15, "{found}, expected {expected:?}");
    }

    fn ball(center: [f64; 3]) -> String {
        object("ball", "m", &sphere(center, 0.5))
    }

    #[test]
    fn an_object_between_the_point_and_the_light_throws_a_shadow_and_one_beyond_does_not() {
        let light = Transport::HybridLight;
        // ½·0.8 of (1, 0.5, 0)
        check(&lit(&[], LAMP), light, [0.4, 0.2, 0.0]);
        check(&lit(&[ball([0.0, 1.5, -3.0])], LAMP), light, [0.0; 3]);
        check(&lit(&[ball([0.0, 4.5, 1.0])], LAMP), light, [0.4, 0.2, 0.0]);
        // nobody asks
        check(
            &lit(&[ball([0.0, 1.5, -3.0])], LAMP),
            Transport::Backward,
            [0.4, 0.2, 0.0],
        );
    }

    #[test]
    fn a_surface_through_the_light_does_not_block_it() {
        let pane = polygon(&[
            [-1.0, 3.0, -2.0],
            [1.0, 3.0, -2.0],
            [1.0, 3.0, 0.0],
            [-1.0, 3.0, 0.0],
        ]);
        check(
            &lit(&[object("pane", "m", &pane)], LAMP),
            Transport::HybridLight,
            [0.4, 0.2, 0.0],
        );
    }

    #[test]
    fn a_light_behind_the_surface_or_in_its_plane_adds_nothing() {
        for transport in [Transport::HybridLight, Transport::Backward] {
            check(&lit(&[], [0.0, 3.0, -9.0]), transport, [0.0; 3]);
            check(&lit(&[], [4.0, 3.0, -5.0]), transport, [0.0; 3]);
        }
    }

    #[test]
    fn a_shadow_ray_goes_from_a_billionth_on_to_a_billionth_before_the_light() {
        let scene = lit(&[ball([0.0, 1.5, -3.0])], LAMP);
        let strategy = Exhaustive::new(&scene);
        let tracer = Tracer::new(&scene, &strategy, Transport::HybridLight);
        let mut recording = Recording::new(Vec::new());
        let _ = trace_pixel(&tracer, [0, 0], Through::Centres, &mut recording);
        let records = recording.into_sink();
        let shadow = records.iter().find_map(|record| match &record.event {
            Event::Ray(start) if start.purpose == Purpose::Shadow => Some(*start),
            _ => None,
        });
        let shadow = shadow.unwrap();
        assert_eq!((shadow.depth, shadow.light), (2, Some(0)));
        assert!(
            (shadow.range.min - 5e-9).abs() <= 1e-23,
            "{:?}",
            shadow.range
        );
        assert!(
            (shadow.range.max - (5.0 - 5e-9)).abs() <= 1e-15,
            "{:?}",
            shadow.range
        );
        let end = records.iter().find_map(|record| match &record.event {
            Event::RayEnd(end) => Some(*end),
            _ => None,
        });
        // the ball's center lies 2.5 along the ray
        let end = end.unwrap();
        assert_eq!(
            (end.verdict, end.object.map(|id| id.0)),
            (RayVerdict::Blocked, Some(1))
        );
        assert!((end.t.unwrap() - 2.0).abs() <= 1e-14);
        let visibility = records.iter().find_map(|record| match &record.event {
            Event::LightTerm(term) => Some(term.visibility),
            _ => None,
        });
        assert_eq!(visibility, Some(Visibility::Shadowed));
    }

    #[test]
    fn the_highlight_is_seen_in_the_mirror_direction_of_the_light() {
        // N·L = 0.8 and R·V = 0.8: ½·0.8 and ¼·0.8²
        let scene = one_pixel(&format!(
            r#""materials":{{"m":{{"colour":[1,0.5,0],"diffuse":0.5,"specular":0.25,"shininess":2}}}},
            "lights":[{{"position":{LAMP:?},"colour":[1,1,1]}}],"objects":[{}]"#,
            object("wall", "m", &wall(-5.0))
        ));
        check(&scene, Transport::HybridLight, [0.56, 0.36, 0.16]);
    }
}
