//! A point on a surface, with what the rays spawned there need.

use glam::DVec3;

use crate::geometry::{Ray, Refraction, TRange, refract};
use crate::scene::{Material, Normals, PrimitiveId, Scene};
use crate::strategy::Hit;
use crate::trace::{Event, Purpose, RayStart, Recorder};
use crate::tracer::epsilon::start_epsilon;

/// A point on a surface where a ray hits it, with what shading and spawned rays need.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a> {
    /// The primitive that was hit.
    pub object: PrimitiveId,
    /// The material of the object that was hit.
    pub material: &'a Material,
    /// p, in world coordinates.
    pub point: DVec3,
    /// N: the unit normal to shade with, on the side that the ray comes from.
    pub normal: DVec3,
    /// The unit normal across the surface itself, on the same side. It differs where a mesh is shaded smoothly.
    pub across: DVec3,
    /// The ray hits the back of the surface: from inside, in a solid.
    pub back: bool,
    /// Unit direction of the ray that hit the surface.
    pub incoming: DVec3,
    /// Depth of that ray; an eye ray has depth 1.
    pub depth: u32,
    /// ε: the smallest t that counts for rays that start here.
    pub epsilon: f64,
}

impl<'a> Surface<'a> {
    /// The surface that a ray of this depth hits, with its unit normals at that point. They are turned to the side
    /// that the ray comes from.
    pub fn new(scene: &'a Scene, ray: &Ray, depth: u32, hit: Hit, normals: Normals) -> Self {
        let shape = &scene.primitive(hit.object).shape;
        let point = ray.at(hit.t);
        let incoming = ray.direction;
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
        Self {
            object: hit.object,
            material: scene.material_of(hit.object),
            point,
            normal,
            across,
            back,
            incoming,
            depth,
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

    /// n₁ and n₂: the refractive indices on the side that the ray comes from and on the other side.
    ///
    /// Outside of every object the index is 1, also where another object contains the point.
    pub fn indices(&self) -> [f64; 2] {
        let index = self.material.index;
        if self.back {
            [index, 1.0]
        } else {
            [1.0, index]
        }
    }

    /// Snell's law at this surface.
    pub(super) fn refraction<R: Recorder>(&self, normal: DVec3, recorder: &mut R) -> Refraction {
        let [from, to] = self.indices();
        let refraction = refract(self.incoming, normal, from, to);
        recorder.note(|| Event::Refraction(refraction));
        refraction
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{object, one_pixel, sphere};

    /// A sphere of radius 2 around (0, 0, −10), of glass.
    fn glass_ball() -> Scene {
        one_pixel(&format!(
            r#""materials":{{"glass":{{"colour":[0.5,1,0.25],"diffuse":0.5,"transmission":0.5,"index":1.5}}}},
            "objects":[{}]"#,
            object("ball", "glass", &sphere([0.0, 0.0, -10.0], 2.0))
        ))
    }

    fn surface(scene: &Scene, origin: f64, t: f64, shading: DVec3) -> Surface<'_> {
        let ray = Ray::new(DVec3::new(0.0, 0.0, origin), -DVec3::Z);
        let hit = Hit {
            object: PrimitiveId(0),
            t,
        };
        let geometric = scene
            .primitive(hit.object)
            .shape
            .normals(ray.at(t))
            .geometric;
        Surface::new(scene, &ray, 3, hit, Normals { geometric, shading })
    }

    #[test]
    fn from_outside_the_normal_is_that_of_the_surface_and_light_comes_from_the_air() {
        let scene = glass_ball();
        let found = surface(&scene, 0.0, 8.0, DVec3::Z);
        assert_eq!(
            (found.point, found.normal),
            (DVec3::new(0.0, 0.0, -8.0), DVec3::Z)
        );
        assert_eq!((found.across, found.back), (DVec3::Z, false));
        assert_eq!(found.indices(), [1.0, 1.5]);
        assert_eq!(found.albedo(), DVec3::new(0.25, 0.5, 0.125));
        // a billionth of the coordinate and of t, both 8
        assert!((found.epsilon - 8e-9).abs() <= 1e-23);
    }

    #[test]
    fn from_inside_both_normals_are_turned_and_light_comes_from_the_glass() {
        let scene = glass_ball();
        let found = surface(&scene, -9.0, 3.0, -DVec3::Z);
        assert_eq!(
            (found.point, found.normal),
            (DVec3::new(0.0, 0.0, -12.0), DVec3::Z)
        );
        assert_eq!((found.across, found.back), (DVec3::Z, true));
        assert_eq!(found.indices(), [1.5, 1.0]);
    }

    #[test]
    fn a_smooth_normal_is_taken_unless_it_leans_away_from_the_viewer() {
        let scene = glass_ball();
        let leaning = DVec3::new(0.6, 0.0, 0.8);
        let found = surface(&scene, 0.0, 8.0, leaning);
        assert_eq!((found.normal, found.across), (leaning, DVec3::Z));
        for away in [DVec3::new(0.6, 0.0, -0.8), DVec3::X] {
            assert_eq!(surface(&scene, 0.0, 8.0, away).normal, DVec3::Z);
        }
    }

    #[test]
    fn a_ray_that_is_sent_on_starts_at_the_point_one_deeper() {
        let scene = glass_ball();
        let found = surface(&scene, 0.0, 8.0, DVec3::Z);
        let start = found.sends(DVec3::Y, Purpose::Reflected);
        assert_eq!(
            (start.ray.origin, start.ray.direction),
            (found.point, DVec3::Y)
        );
        assert_eq!((start.depth, start.purpose), (4, Purpose::Reflected));
        assert_eq!(
            (start.range.min, start.range.max),
            (found.epsilon, f64::INFINITY)
        );
        assert_eq!((start.window_t, start.light), (None, None));
    }

    #[test]
    fn a_ray_along_a_surface_meets_its_front() {
        let scene = glass_ball();
        let ray = Ray::new(DVec3::ZERO, -DVec3::Z);
        let hit = Hit {
            object: PrimitiveId(0),
            t: 8.0,
        };
        let normals = Normals {
            geometric: DVec3::X,
            shading: DVec3::X,
        };
        let found = Surface::new(&scene, &ray, 1, hit, normals);
        assert_eq!((found.back, found.across), (false, DVec3::X));
    }
}
