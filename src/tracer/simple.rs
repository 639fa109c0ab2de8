//! The simple ray tracer of Fig. 15.56, from top to bottom on one page.
//!
//! ```text
//! select center of projection and window on viewplane;
//! for (each scan line in image) {
//!   for (each pixel in scan line) {
//!     determine ray from center of projection through pixel;
//!     for (each object in scene) {
//!       if (object is intersected and is closest considered thus far)
//!         record intersection and object name;
//!     }
//!     set pixel's color to that at closest object intersection;
//!   }
//! }
//! ```
//!
//! The loops are [`picture`], [`pixel`] and [`closest`]; the colour at the closest intersection is [`shade`], with a shadow ray to
//! each light, a reflected and a refracted ray (T. Whitted 1980). Each function that a lesson explains is a method of
//! [`Parts`], whose default is the crate's own function. So a picture can be made with one of them replaced: by a
//! student's function, by a wrong one, or by a faster search for the nearest object.
//!
//! It leaves out what is there for speed and for the record: threads, structures, events. Its picture is, bit for bit,
//! the one of [`Transport::HybridLight`](crate::trace::Transport::HybridLight).

use glam::DVec3;

use crate::geometry::{Polygon, Ray, Refraction, Sides, Sphere, TRange};
use crate::scene::{
    Camera, Light, Material, Normals, PhongTerm, Primitive, PrimitiveId, Scene, Shape,
};
use crate::strategy::Hit;
use crate::tracer::epsilon::EPSILON;
use crate::tracer::eye::picture::Picture;
use crate::tracer::surface::Surface;

/// Traces a picture of a scene: "for (each scan line in image) for (each pixel in scan line)".
///
/// The eye ray passes through the centre of the pixel. The scene's `max_depth` ends the rays that mirrors and glass spawn.
pub fn picture(scene: &Scene, parts: &impl Parts) -> Picture {
    let camera = &scene.camera;
    let [width, height] = camera.pixels;
    let mut colours = Vec::new();
    for y in 0..height {
        for x in 0..width {
            colours.push(pixel(scene, parts, [x, y]));
        }
    }
    Picture {
        pixels: camera.pixels,
        colours,
    }
}

/// The colour of a pixel: "determine ray from center of projection through pixel".
pub fn pixel(scene: &Scene, parts: &impl Parts, [x, y]: [u32; 2]) -> DVec3 {
    let camera = &scene.camera;
    let to_window = parts.window_point(camera, f64::from(x) + 0.5, f64::from(y) + 0.5);
    let ray = parts.eye_ray(camera, to_window);
    colour(scene, parts, &ray, TRange::FORWARD, 1)
}

/// The colour that a ray sees: the background, or the colour at the closest intersection.
fn colour<P: Parts>(scene: &Scene, parts: &P, ray: &Ray, range: TRange, depth: u32) -> DVec3 {
    match parts.nearest(scene, ray, range) {
        None => scene.background,
        Some(hit) => {
            let shape = &scene.primitive(hit.object).shape;
            let normals = parts.normals(shape, ray.at(hit.t));
            parts.shade(scene, &Surface::new(scene, ray, depth, hit, normals))
        }
    }
}

/// Which object does the ray hit first? "for (each object in scene) if (object is intersected and is closest considered
/// thus far) record intersection and object name".
///
/// Of two hits at equal t the object that comes first in the scene stays.
pub fn closest<P: Parts>(scene: &Scene, parts: &P, ray: &Ray, range: TRange) -> Option<Hit> {
    let mut closest: Option<Hit> = None;
    for (object, primitive) in (0..).map(PrimitiveId).zip(&scene.primitives) {
        if let Some(t) = parts.hit(primitive, ray, range)
            && closest.is_none_or(|closest| t < closest.t)
        {
            closest = Some(Hit { object, t });
        }
    }
    closest
}

/// Where does the ray hit this primitive, if it does so in the range?
///
/// A sphere by its quadratic (iii); a polygon by its plane (v), then by whether the point lies inside (Fig. 15.57).
pub fn hit<P: Parts>(parts: &P, primitive: &Primitive, ray: &Ray, range: TRange) -> Option<f64> {
    let sides = primitive.sides;
    match &primitive.shape {
        Shape::Sphere(sphere) => parts.root(sphere, ray, range, sides),
        Shape::Polygon(polygon) => {
            let t = parts.plane_t(polygon, ray, range, sides)?;
            parts.inside(polygon, ray, t).then_some(t)
        }
        Shape::Ellipsoid(ellipsoid) => ellipsoid.test(ray, range, sides).roots.chosen(),
        Shape::Box(solid) => solid.test(ray, range, sides).roots.chosen(),
        Shape::Cone(cone) => cone.test(ray, range, sides).roots.chosen(),
    }
}

/// The colour at a point: I = ambient·colour + Σ lights + reflection·I_reflected + transmission·I_refracted.
pub fn shade<P: Parts>(scene: &Scene, parts: &P, surface: &Surface<'_>) -> DVec3 {
    let material = surface.material;
    let (from, epsilon) = parts.leaves_from(surface);
    let mut direct = DVec3::ZERO;
    for light in &scene.lights {
        let term = parts.light_term(
            light,
            material,
            surface.point,
            surface.normal,
            -surface.incoming,
        );
        let to_light = TRange {
            min: epsilon,
            // a light in a surface is not blocked by that surface
            max: term.distance * (1.0 - EPSILON),
        };
        // a surface that faces away has no term, and needs no shadow ray
        if 0.0 < term.n_dot_l && !parts.blocked(scene, &Ray::new(from, term.to_light), to_light) {
            direct += term.diffuse + term.specular;
        }
    }

    // total internal reflection: the reflected ray takes the weight of the refracted one
    let (mut reflection, mut transmission) = (material.reflection, material.transmission);
    let mut refracted = None;
    if 0.0 < transmission {
        let [index_from, index_to] = surface.indices();
        refracted = parts
            .refract(surface.incoming, surface.normal, index_from, index_to)
            .direction;
        if refracted.is_none() {
            reflection += transmission;
            transmission = 0.0;
        }
    }

    let spawn = |direction| {
        let range = TRange {
            min: epsilon,
            max: f64::INFINITY,
        };
        let depth = surface.depth + 1;
        if depth <= scene.max_depth {
            colour(scene, parts, &Ray::new(from, direction), range, depth)
        } else {
            DVec3::ZERO
        }
    };
    let mut sum = scene.ambient * DVec3::from(material.colour) + direct;
    if 0.0 < reflection {
        sum += reflection * spawn(parts.reflect(surface.incoming, surface.normal));
    }
    if let Some(direction) = refracted {
        sum += transmission * spawn(direction);
    }
    sum
}

/// Does an object stand between the ray's origin and the end of the range? Every object casts a full shadow.
#[doc(alias = "shadow ray")]
pub fn blocked<P: Parts>(scene: &Scene, parts: &P, ray: &Ray, range: TRange) -> bool {
    let mut objects = scene.primitives.iter();
    objects.any(|primitive| parts.hit(primitive, ray, range).is_some())
}

/// The functions of the simple ray tracer that a lesson explains, each with the crate's own as its default.
///
/// All points and directions are in world coordinates; directions of rays have unit length, and so have normals.
pub trait Parts: Sized {
    /// P − COP: the point of the window at a place counted in pixels from the top left corner
    /// ([`Camera::to_window`]). The centre of pixel (x, y) is at (x + ½, y + ½).
    fn window_point(&self, camera: &Camera, x: f64, y: f64) -> DVec3 {
        camera.to_window(x, y)
    }

    /// The ray from the COP through a point of the window, given relative to the COP ([`Camera::ray_through`]).
    fn eye_ray(&self, camera: &Camera, to_window: DVec3) -> Ray {
        camera.ray_through(to_window).0
    }

    /// The nearest object that the ray hits in the range: every object is tested ([`closest`]). A bound, a hierarchy or a
    /// grid may take its place.
    fn nearest(&self, scene: &Scene, ray: &Ray, range: TRange) -> Option<Hit> {
        closest(scene, self, ray, range)
    }

    /// t of the hit with one primitive ([`hit`]).
    fn hit(&self, primitive: &Primitive, ray: &Ray, range: TRange) -> Option<f64> {
        hit(self, primitive, ray, range)
    }

    /// The root of the sphere's quadratic (iii) that counts: the smallest in the range ([`Sphere::test`]).
    fn root(&self, sphere: &Sphere, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
        sphere.test(ray, range, sides).roots.chosen()
    }

    /// t of the polygon's plane (v), if it is in the range ([`Polygon::plane_test`]). A parallel plane has none.
    fn plane_t(&self, polygon: &Polygon, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
        polygon.plane_test(ray, range, sides).chosen()
    }

    /// Does the point at t lie inside the polygon ([`Polygon::contains`], Fig. 15.57)?
    fn inside(&self, polygon: &Polygon, ray: &Ray, t: f64) -> bool {
        polygon.contains(ray, t).inside
    }

    /// The unit normals at a point of a surface, outwards ([`Shape::normals`]). They are turned towards the ray later.
    fn normals(&self, shape: &Shape, point: DVec3) -> Normals {
        shape.normals(point)
    }

    /// Where the rays that a surface spawns start, and ε: the smallest t that counts on them.
    fn leaves_from(&self, surface: &Surface<'_>) -> (DVec3, f64) {
        (surface.point, surface.epsilon)
    }

    /// Is the light hidden: does the shadow ray hit any object in the range ([`blocked`])?
    fn blocked(&self, scene: &Scene, ray: &Ray, range: TRange) -> bool {
        blocked(scene, self, ray, range)
    }

    /// The diffuse and the specular term of one light ([`Light::phong`]).
    fn light_term(
        &self,
        light: &Light,
        material: &Material,
        point: DVec3,
        normal: DVec3,
        to_viewer: DVec3,
    ) -> PhongTerm {
        light.phong(material, point, normal, to_viewer)
    }

    /// The mirror direction ([`reflect`](crate::geometry::reflect)).
    fn reflect(&self, direction: DVec3, normal: DVec3) -> DVec3 {
        crate::geometry::reflect(direction, normal)
    }

    /// The direction behind the surface, after Snell ([`refract`](crate::geometry::refract)).
    fn refract(
        &self,
        direction: DVec3,
        normal: DVec3,
        index_from: f64,
        index_to: f64,
    ) -> Refraction {
        crate::geometry::refract(direction, normal, index_from, index_to)
    }

    /// The colour at a point, with all rays that it spawns ([`shade`]).
    fn shade(&self, scene: &Scene, surface: &Surface<'_>) -> DVec3 {
        shade(scene, self, surface)
    }
}

/// The crate's own functions.
#[derive(Clone, Copy, Debug, Default)]
pub struct Own;

impl Parts for Own {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{cube_at, object, one_pixel, polygon, scene_of, sphere, wall};

    const ROUNDED: f64 = 1e-15;

    #[track_caller]
    fn check(scene: &Scene, expected: [f64; 3]) {
        let picture = picture(scene, &Own);
        assert_eq!((picture.pixels, picture.colours.len()), ([1, 1], 1));
        let off = (picture.colours[0] - DVec3::from(expected))
            .abs()
            .max_element();
        assert!(
            off <= ROUNDED,
            "{:?}, expected {expected:?}",
            picture.colours
        );
    }

    #[test]
    fn the_closest_hit_is_the_smallest_t_and_of_equal_ones_the_first_object_s() {
        let across = polygon(&[[7.0, -1.0, -1.0], [7.0, 2.0, -1.0], [7.0, -1.0, 2.0]]);
        let scene = scene_of(&[
            across,
            cube_at(9.0),
            sphere([5.0, 0.25, 0.25], 1.0),
            sphere([5.0, 0.25, 0.25], 1.0),
            r#"{"cone":{"base":[14,0.25,0.25],"base_radius":2,"apex":[14,9,0.25],"apex_radius":2}}"#.to_string(),
            r#"{"ellipsoid":{"center":[30,0.25,0.25],"radii":[8,1,1]}}"#.to_string(),
        ]);
        let ray = Ray::new(DVec3::new(0.0, 0.25, 0.25), DVec3::X);
        let from = |min: f64| {
            let range = TRange {
                min,
                ..TRange::FORWARD
            };
            closest(&scene, &Own, &ray, range).map(|hit| (hit.object.0, hit.t))
        };
        assert_eq!(from(0.0), Some((2, 4.0)));
        assert_eq!(from(6.5), Some((0, 7.0)));
        assert_eq!(from(7.5), Some((1, 9.0)));
        assert_eq!(from(11.0), Some((4, 12.0)));
        assert_eq!(from(17.0), Some((5, 22.0)));
        assert_eq!(from(39.0), None);
        let is_blocked = |max| blocked(&scene, &Own, &ray, TRange::FORWARD.up_to(max));
        assert!(is_blocked(4.5) && !is_blocked(3.5));
        // beside the triangle
        let beside = Ray::new(DVec3::new(6.5, 1.5, 1.5), DVec3::X);
        assert_eq!(
            closest(&scene, &Own, &beside, TRange::FORWARD.up_to(2.0)),
            None
        );
    }

    /// A wall 5 ahead, of colour (1, 0.5, 0) and diffuse ½, and a light at (0, 3, −1): 5 away at a cosine of 0.8.
    fn lit(more: &str, light: [f64; 3]) -> Scene {
        one_pixel(&format!(
            r#""ambient":[0.1,0.1,0.1],"materials":{{"m":{{"colour":[1,0.5,0],"diffuse":0.5}}}},
            "lights":[{{"position":{light:?},"colour":[1,1,2]}}],"objects":[{}{more}]"#,
            object("wall", "m", &wall(-5.0))
        ))
    }

    #[test]
    fn a_light_adds_its_terms_where_nothing_stands_between() {
        let lamp = [0.0, 3.0, -1.0];
        check(&lit("", lamp), [0.5, 0.25, 0.0]);
        let ball = |center| format!(",{}", object("ball", "m", &sphere(center, 0.5)));
        check(&lit(&ball([0.0, 1.5, -3.0]), lamp), [0.1, 0.05, 0.0]);
        check(&lit(&ball([0.0, 4.5, 1.0]), lamp), [0.5, 0.25, 0.0]);
        // a surface through the light does not block it; a light behind the wall or in it adds nothing
        let pane = polygon(&[
            [-1.0, 3.0, -2.0],
            [1.0, 3.0, -2.0],
            [1.0, 3.0, 0.0],
            [-1.0, 3.0, 0.0],
        ]);
        check(
            &lit(&format!(",{}", object("pane", "m", &pane)), lamp),
            [0.5, 0.25, 0.0],
        );
        check(&lit("", [0.0, 3.0, -9.0]), [0.1, 0.05, 0.0]);
        check(&lit("", [4.0, 3.0, -5.0]), [0.1, 0.05, 0.0]);
    }

    #[test]
    fn spawned_rays_count_with_their_weights_up_to_the_depth_limit() {
        let scene = |depth: u32| {
            one_pixel(&format!(
                r#""ambient":[1,1,1],"max_depth":{depth},"materials":{{"m":{{"colour":[1,1,1],"reflection":0.5}}}},
                "objects":[{},{}]"#,
                object("ahead", "m", &wall(-5.0)),
                object("behind", "m", &wall(5.0))
            ))
        };
        check(&scene(1), [1.0; 3]);
        check(&scene(3), [1.75; 3]);
        let pane = one_pixel(&format!(
            r#""ambient":[0.1,0.2,0.3],"background":[0.4,0.8,0.2],
            "materials":{{"glass":{{"colour":[1,0.5,1],"reflection":0.25,"transmission":0.5}}}},"objects":[{}]"#,
            object("pane", "glass", &wall(-5.0))
        ));
        check(&pane, [0.4, 0.7, 0.45]);
    }

    #[test]
    fn where_no_ray_can_pass_the_reflected_one_has_the_weight_of_both() {
        // the back of a pane at 45°, which mirrors the ray along −x: there a wall with an ambient light of 0.1
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
        check(&scene(1.2), [0.425; 3]);
        check(&scene(2.0), [0.075; 3]);
    }

    #[test]
    fn the_highlight_is_seen_in_the_mirror_direction_of_the_light() {
        // N·L = 0.8 and R·V = 0.8: ½·0.8 and ¼·0.8²
        let scene = one_pixel(&format!(
            r#""materials":{{"m":{{"colour":[1,0.5,0],"diffuse":0.5,"specular":0.25,"shininess":2}}}},
            "lights":[{{"position":[0,3,-1],"colour":[1,1,1]}}],"objects":[{}]"#,
            object("wall", "m", &wall(-5.0))
        ));
        check(&scene, [0.56, 0.36, 0.16]);
    }
}
