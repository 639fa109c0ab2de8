//! A point on a surface, as all that is sent on from it needs it.

use glam::DVec3;

use crate::geometry::{Ray, Refraction, TRange, refract};
use crate::scene::{Material, PrimitiveId};
use crate::strategy::{Hit, Strategy};
use crate::trace::{Event, Purpose, RayStart, Recorder};
use crate::tracer::Tracer;
use crate::tracer::epsilon::start_epsilon;

/// A point on a surface.
#[derive(Clone, Copy)]
pub(super) struct Surface<'a> {
    pub(super) object: PrimitiveId,
    pub(super) material: &'a Material,
    pub(super) point: DVec3,
    /// N: the unit normal to shade with, on the side that the ray comes from.
    pub(super) normal: DVec3,
    /// The unit normal across the surface itself, on the same side. It differs where a mesh is shaded smoothly.
    pub(super) across: DVec3,
    /// The ray meets the back of the surface: from inside, in a solid.
    pub(super) back: bool,
    /// Unit direction of the ray that met the surface.
    pub(super) incoming: DVec3,
    /// Depth of that ray.
    pub(super) depth: u32,
    /// ε for rays that start here.
    pub(super) epsilon: f64,
}

impl<S: Strategy> Tracer<'_, S> {
    /// The surface that a ray has met.
    pub(super) fn surface(&self, start: &RayStart, hit: Hit) -> Surface<'_> {
        let shape = &self.scene.primitive(hit.object).shape;
        let point = start.ray.at(hit.t);
        let normals = shape.normals(point);
        let incoming = start.ray.direction;
        let back = 0.0 < incoming.dot(normals.geometric);
        let turned = |normal: DVec3| if back { -normal } else { normal };
        // a smooth normal that leans away from the viewer would light the surface from behind
        let smooth = turned(normals.shading);
        let across = turned(normals.geometric);
        let normal = if incoming.dot(smooth) < 0.0 {
            smooth
        } else {
            across
        };
        Surface {
            object: hit.object,
            material: self.scene.material_of(hit.object),
            point,
            normal,
            across,
            back,
            incoming,
            depth: start.depth,
            epsilon: start_epsilon(point, hit.t, shape.reach()),
        }
    }
}

impl Surface<'_> {
    /// colour·diffuse: the share of each channel that goes on diffusely.
    pub(super) fn albedo(&self) -> DVec3 {
        DVec3::from(self.material.colour) * self.material.diffuse
    }

    /// A ray that goes on from here.
    pub(super) fn sends(&self, direction: DVec3, purpose: Purpose) -> RayStart {
        RayStart {
            ray: Ray::new(self.point, direction),
            range: TRange {
                min: self.epsilon,
                max: f64::INFINITY,
            },
            purpose,
            depth: self.depth + 1,
            window_t: None,
            light: None,
        }
    }

    /// Snell's law at this surface.
    ///
    /// Outside of every object the index is 1: what lies in another object is not told apart.
    pub(super) fn refraction<R: Recorder>(&self, normal: DVec3, recorder: &mut R) -> Refraction {
        let index = self.material.index;
        let (from, to) = if self.back {
            (index, 1.0)
        } else {
            (1.0, index)
        };
        let refraction = refract(self.incoming, normal, from, to);
        recorder.note(|| Event::Refraction(refraction));
        refraction
    }
}
