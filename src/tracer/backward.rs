//! Backward ray tracing: from the eye into the scene, and on from what is met.
//!
//! The slides' simple ray tracer (Fig. 15.56) sets the pixel to the colour at the closest intersection.
//! From there T. Whitted (1980) sends rays on: one in the mirror direction, one through the surface. What light
//! the lamps throw on a point is asked of the transport: without a ray to them
//! ([`Transport::Backward`]), with one ([`hybrid_light`](crate::tracer::hybrid_light)), or of what paths of
//! light have stored there ([`hybrid_stored`](crate::tracer::hybrid_stored)).

use std::ops::ControlFlow;

use glam::DVec3;

use crate::geometry::{Ray, TRange, reflect};
use crate::scene::Scene;
use crate::strategy::Strategy;
use crate::trace::{Event, Outcome, Purpose, RayEnd, RayStart, Recorder, Shade, Transport};
use crate::tracer::LightPass;
use crate::tracer::ray_limit::MAX_RAYS;
use crate::tracer::surface::Surface;

/// Traces rays through a scene.
#[derive(Clone, Copy, Debug)]
pub struct Tracer<'a, S> {
    /// What is there.
    pub scene: &'a Scene,
    /// Which objects a ray is tested against.
    pub strategy: &'a S,
    /// Which rays are cast.
    pub transport: Transport,
    /// What the paths of light have left, where the transport follows any.
    pub light: Option<&'a LightPass>,
    /// How many rays may be traced for a pixel; through the corners, from each of them.
    pub max_rays: u64,
}

impl<'a, S: Strategy> Tracer<'a, S> {
    /// A tracer that follows no light from the lamps.
    pub fn new(scene: &'a Scene, strategy: &'a S, transport: Transport) -> Self {
        Self {
            scene,
            strategy,
            transport,
            light: None,
            max_rays: MAX_RAYS,
        }
    }

    /// The same, over what paths of light have left.
    #[must_use]
    pub fn with_light(self, light: Option<&'a LightPass>) -> Self {
        Self { light, ..self }
    }

    /// The same, with another limit of the rays that may be traced for a pixel.
    #[must_use]
    pub fn with_max_rays(self, max_rays: u64) -> Self {
        Self { max_rays, ..self }
    }

    /// The colour that an eye ray sees.
    pub(super) fn eye_ray<R: Recorder>(
        &self,
        ray: Ray,
        window_t: f64,
        recorder: &mut R,
    ) -> ControlFlow<(), DVec3> {
        self.trace(eye_ray_start(ray, window_t), recorder)
    }

    /// The colour that a ray sees: the background, or the shade of what it meets. `Break` if the recorder has enough.
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
                outcome: hit.map_or(Outcome::Miss, |_| Outcome::Hit),
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
                outcome: Outcome::DepthLimit,
                colour: Some(DVec3::ZERO),
                ..RayEnd::default()
            })
        });
        ControlFlow::Continue(DVec3::ZERO)
    }
}

/// An eye ray at its start.
pub(super) fn eye_ray_start(ray: Ray, window_t: f64) -> RayStart {
    RayStart {
        ray,
        range: TRange::FORWARD,
        purpose: Purpose::Eye,
        depth: 1,
        window_t: Some(window_t),
        light: None,
    }
}
