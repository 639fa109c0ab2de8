//! Lesson 5: shading.
//!
//! - normal: the unit vector N across the surface
//! - L, N·L: the unit vector to the light, and the cosine
//! - diffuse: light·colour·diffuse·(N·L)
//! - specular: light·specular·max(0, R·V)^shininess
//! - point: p, and the ε of the rays that start there
//! - visibility: whether anything stands between the point and the light
//! - ambient: ambient·colour
//! - sum over the visible lights: of the diffuse and the specular terms
//! - colour of the ray: ambient and that sum

use glam::DVec3;
use raystep::Scene;
use raystep::geometry::{Ray, TRange};
use raystep::lesson::exercise::supplied::hit;
use raystep::scene::{Emission, Light, Material, Normals, PhongTerm, Shape};
use raystep::tracer::Surface;

/// The unit normal at a point of a sphere or a polygon, outwards and towards the front.
///
/// The front of a polygon is where its vertices run counter-clockwise: the cross product `a.cross(b)` of two edges in that order.
/// The polygons of the cases are convex; in a concave one the first corner may turn the wrong way. `match shape { Shape::Sphere(sphere) =>
/// …, Shape::Polygon(polygon) => …, _ => return shape.normals(point) }` tells them apart; `polygon.vertices()` iterates over the
/// vertices. Both normals of `Normals` are the same here.
pub fn normals(shape: &Shape, point: DVec3) -> Normals {
    // the other shapes, and smooth shading, are the crate's
    let is_smooth = matches!(shape, Shape::Polygon(polygon) if polygon.normals().is_some());
    if is_smooth || !matches!(shape, Shape::Sphere(_) | Shape::Polygon(_)) {
        return shape.normals(point);
    }
    // BEGIN SOLUTION
    let normal = match shape {
        Shape::Sphere(sphere) => (point - sphere.center) / sphere.radius,
        Shape::Polygon(polygon) => {
            let v: Vec<DVec3> = polygon.vertices().collect();
            (v[1] - v[0]).cross(v[2] - v[0]).normalize()
        }
        _ => return shape.normals(point),
    };
    Normals {
        geometric: normal,
        shading: normal,
    }
    // END SOLUTION
}

/// What one light adds, if nothing stands between.
///
/// `normal` N and `to_viewer` V have unit length. `material.colour` is an array: `DVec3::from(material.colour)` is the vector,
/// and two vectors are multiplied channel by channel. `x.powf(y)` is xʸ.
pub fn light_term(
    light: &Light,
    material: &Material,
    point: DVec3,
    normal: DVec3,
    to_viewer: DVec3,
) -> PhongTerm {
    // a light in watts comes in lesson 8
    let Emission::Colour(intensity) = light.emission else {
        return light.phong(material, point, normal, to_viewer);
    };
    // BEGIN SOLUTION
    // L, N·L
    let distance = (light.position - point).length();
    let to_light = (light.position - point) / distance;
    let n_dot_l = normal.dot(to_light);
    // R·V
    let mirrored = 2.0 * n_dot_l * normal - to_light;
    let r_dot_v = mirrored.dot(to_viewer);
    let mut term = PhongTerm {
        to_light,
        distance,
        n_dot_l,
        r_dot_v,
        diffuse: DVec3::ZERO,
        specular: DVec3::ZERO,
    };
    if 0.0 < n_dot_l {
        let colour = DVec3::from(material.colour);
        term.diffuse = intensity * colour * (material.diffuse * n_dot_l);
        let highlight = r_dot_v.max(0.0).powf(material.shininess);
        term.specular = intensity * (material.specular * highlight);
    }
    term
    // END SOLUTION
}

/// ε = max(10⁻⁹ · max(|x|, |y|, |z|, t), 10⁻¹³ · reach): the smallest t that counts for a ray that starts at a point.
///
/// `t` is that of the ray that hit the point, `reach` the largest coordinate or radius of the surface.
pub fn epsilon(point: DVec3, t: f64, reach: f64) -> f64 {
    // BEGIN SOLUTION
    let numbers = point.abs().max_element().max(t);
    (1e-9 * numbers).max(1e-13 * reach)
    // END SOLUTION
}

/// Does any object stand between the ray's origin and the end of the range?
///
/// The ray starts at the point that is shaded and runs to the light; the range begins at ε and ends just before the light.
/// `hit(primitive, ray, range)` tests one of `scene.primitives`.
pub fn blocked(scene: &Scene, ray: &Ray, range: TRange) -> bool {
    // BEGIN SOLUTION
    let mut objects = scene.primitives.iter();
    objects.any(|primitive| hit(primitive, ray, range).is_some())
    // END SOLUTION
}

/// The colour of a point without mirrors and glass: I = ambient·colour + Σ over visible lights (diffuse + specular).
///
/// `surface` has the point, the unit normal on the viewer's side, the material, the direction `incoming` from the viewer to the
/// point, and ε. The shadow ray's range ends at the light's distance times (1 − 10⁻⁹), so that a light in a surface is not
/// blocked by it.
pub fn shade(scene: &Scene, surface: &Surface<'_>) -> DVec3 {
    // BEGIN SOLUTION
    let material = surface.material;
    // ambient
    let mut sum = scene.ambient * DVec3::from(material.colour);
    // sum over the visible lights
    for light in &scene.lights {
        let term = light_term(
            light,
            material,
            surface.point,
            surface.normal,
            -surface.incoming,
        );
        let range = TRange {
            min: surface.epsilon,
            max: term.distance * (1.0 - 1e-9),
        };
        let ray = Ray::new(surface.point, term.to_light);
        if 0.0 < term.n_dot_l && !blocked(scene, &ray, range) {
            sum += term.diffuse + term.specular;
        }
    }
    sum
    // END SOLUTION
}
