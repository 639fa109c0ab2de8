//! Backward ray tracing: from the eye into the scene, and on from what is met.
//!
//! The slides' simple ray tracer (Fig. 15.56) sets the pixel to the colour at the closest intersection.
//! From there T. Whitted (1980) sends rays on: one to each light, one in the mirror direction, one
//! through the surface.

use glam::DVec3;

use crate::geometry::{Ray, TRange, reflect, refract};
use crate::scene::{Light, Material, PrimitiveId, Scene};
use crate::strategy::{Hit, Strategy};
use crate::trace::{
    Event, LightTerm, Outcome, Purpose, RayEnd, RayStart, Recorder, Shade, Transport, Visibility,
};
use crate::tracer::epsilon::{EPSILON, start_epsilon};

/// Traces rays through a scene.
#[derive(Clone, Copy, Debug)]
pub struct Tracer<'a, S> {
    /// What is there.
    pub scene: &'a Scene,
    /// Which objects a ray is tested against.
    pub strategy: &'a S,
    /// Which rays are cast.
    pub transport: Transport,
}

/// A point on a surface, as all that is sent on from it needs it.
struct Surface<'a> {
    object: PrimitiveId,
    material: &'a Material,
    point: DVec3,
    /// N: the unit normal to shade with, on the side that the ray comes from.
    normal: DVec3,
    /// The ray meets the back of the surface: from inside, in a solid.
    back: bool,
    /// Unit direction of the ray that met the surface.
    incoming: DVec3,
    /// Depth of that ray.
    depth: u32,
    /// ε for rays that start here.
    epsilon: f64,
}

impl<S: Strategy> Tracer<'_, S> {
    /// The colour that an eye ray sees.
    pub fn eye_ray<R: Recorder>(&self, ray: Ray, window_t: f64, recorder: &mut R) -> DVec3 {
        let start = RayStart {
            ray,
            range: TRange::FORWARD,
            purpose: Purpose::Eye,
            depth: 1,
            window_t: Some(window_t),
            light: None,
        };
        self.trace(start, recorder)
    }

    /// The colour that a ray sees: the background, or the shade of what it meets.
    fn trace<R: Recorder>(&self, start: RayStart, recorder: &mut R) -> DVec3 {
        recorder.note(|| Event::Ray(start));
        let hit = self.strategy.nearest(&start.ray, start.range, recorder);
        let colour = match hit {
            None => self.scene.background,
            Some(hit) => self.shade(&self.surface(&start, hit), recorder),
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
        colour
    }

    fn surface(&self, start: &RayStart, hit: Hit) -> Surface<'_> {
        let shape = &self.scene.primitive(hit.object).shape;
        let point = start.ray.at(hit.t);
        let normals = shape.normals(point);
        let incoming = start.ray.direction;
        let back = 0.0 < incoming.dot(normals.geometric);
        let turned = |normal: DVec3| if back { -normal } else { normal };
        // a smooth normal that leans away from the viewer would light the surface from behind
        let smooth = turned(normals.shading);
        let normal = if incoming.dot(smooth) < 0.0 {
            smooth
        } else {
            turned(normals.geometric)
        };
        Surface {
            object: hit.object,
            material: self.scene.material_of(hit.object),
            point,
            normal,
            back,
            incoming,
            depth: start.depth,
            epsilon: start_epsilon(point, hit.t, shape.reach()),
        }
    }

    /// I = ambient·colour + Σ lights + reflection·I_reflected + transmission·I_refracted
    fn shade<R: Recorder>(&self, surface: &Surface<'_>, recorder: &mut R) -> DVec3 {
        let material = surface.material;
        let ambient = self.scene.ambient * DVec3::from(material.colour);

        let mut direct = DVec3::ZERO;
        for (number, light) in (0..).zip(&self.scene.lights) {
            direct += self.light(number, light, surface, recorder);
        }

        // a ray that cannot pass is reflected with all its weight
        let mut reflection = material.reflection;
        let mut transmission = material.transmission;
        let mut through = None;
        if 0.0 < transmission {
            through = refracted(surface, recorder);
            if through.is_none() {
                reflection += transmission;
                transmission = 0.0;
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
            colour += reflection * self.send_on(surface, mirrored, Purpose::Reflected, recorder);
        }
        if let Some(direction) = through {
            colour += transmission * self.send_on(surface, direction, Purpose::Refracted, recorder);
        }
        colour
    }

    /// What one light adds; with a shadow ray, unless the surface faces away from the light.
    fn light<R: Recorder>(
        &self,
        number: u32,
        light: &Light,
        surface: &Surface<'_>,
        recorder: &mut R,
    ) -> DVec3 {
        let to_viewer = -surface.incoming;
        let term = light.phong(surface.material, surface.point, surface.normal, to_viewer);
        let visibility = if term.n_dot_l <= 0.0 {
            Visibility::FacesAway
        } else if self.transport == Transport::Backward {
            Visibility::NotTested
        } else if self.is_blocked(number, surface, term.to_light, term.distance, recorder) {
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
        match visibility {
            Visibility::Visible | Visibility::NotTested => term.diffuse + term.specular,
            Visibility::Shadowed | Visibility::FacesAway => DVec3::ZERO,
        }
    }

    /// Does anything stand between the point and the light? Every object casts a full shadow.
    fn is_blocked<R: Recorder>(
        &self,
        light: u32,
        surface: &Surface<'_>,
        to_light: DVec3,
        distance: f64,
        recorder: &mut R,
    ) -> bool {
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
        recorder.note(|| Event::Ray(start));
        let hit = self.strategy.any(&start.ray, start.range, recorder);
        recorder.note(|| {
            Event::RayEnd(RayEnd {
                outcome: hit.map_or(Outcome::ReachesLight, |_| Outcome::Blocked),
                object: hit.map(|hit| hit.object),
                t: hit.map(|hit| hit.t),
                ..RayEnd::default()
            })
        });
        hit.is_some()
    }

    /// The colour that a ray from the surface sees; black beyond the depth limit.
    fn send_on<R: Recorder>(
        &self,
        surface: &Surface<'_>,
        direction: DVec3,
        purpose: Purpose,
        recorder: &mut R,
    ) -> DVec3 {
        let start = RayStart {
            ray: Ray::new(surface.point, direction),
            range: TRange {
                min: surface.epsilon,
                max: f64::INFINITY,
            },
            purpose,
            depth: surface.depth + 1,
            window_t: None,
            light: None,
        };
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
        DVec3::ZERO
    }
}

/// The direction behind the surface; `None` if all light is reflected.
///
/// Outside of every object the index is 1: what lies in another object is not told apart.
fn refracted<R: Recorder>(surface: &Surface<'_>, recorder: &mut R) -> Option<DVec3> {
    let index = surface.material.index;
    let (from, to) = if surface.back {
        (index, 1.0)
    } else {
        (1.0, index)
    };
    let refraction = refract(surface.incoming, surface.normal, from, to);
    recorder.note(|| Event::Refraction(refraction));
    refraction.direction
}
