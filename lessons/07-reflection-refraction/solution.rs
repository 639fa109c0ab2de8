//! Lesson 7: reflection and refraction.
//!
//! - direction: of the reflected ray, R
//! - Snell's law: n₁·sin θ₁ = n₂·sin θ₂, with the two cosines
//! - T: the direction of the refracted ray, or none
//! - colour of the ray: with the colours that the reflected and the refracted ray bring

use glam::DVec3;
use raystep::Scene;
use raystep::geometry::Refraction;
use raystep::lesson::exercise::supplied::{direct, seen};
use raystep::tracer::Surface;

/// The mirror direction R of a direction Δ that runs towards the surface. N has unit length and may point to either side.
pub fn reflect(direction: DVec3, normal: DVec3) -> DVec3 {
    // BEGIN SOLUTION
    direction - 2.0 * direction.dot(normal) * normal
    // END SOLUTION
}

/// The refracted direction. N points to the side that Δ comes from; `index_from` is n₁ on that side, `index_to` n₂ behind.
///
/// A `Refraction` has both indices, `cos_incident` cos θ₁, `cos_refracted_squared` cos²θ₂ (negative under total internal
/// reflection), and `direction`: None under total internal reflection.
pub fn refract(direction: DVec3, normal: DVec3, index_from: f64, index_to: f64) -> Refraction {
    // BEGIN SOLUTION
    let eta = index_from / index_to;
    let cos_incident = -direction.dot(normal);
    let cos_refracted_squared = 1.0 - eta * eta * (1.0 - cos_incident * cos_incident);
    let transmitted = if cos_refracted_squared < 0.0 {
        None
    } else {
        let cos_refracted = cos_refracted_squared.sqrt();
        Some(eta * direction + (eta * cos_incident - cos_refracted) * normal)
    };
    Refraction {
        index_from,
        index_to,
        cos_incident,
        cos_refracted_squared,
        direction: transmitted,
    }
    // END SOLUTION
}

/// The colour of a point: I = direct + reflection·I_reflected + transmission·I_refracted.
///
/// `direct(scene, surface)` is the light of lesson 5. `seen(scene, surface, direction)` is the colour that a ray from the point
/// brings. `surface.incoming` is Δ, `surface.normal` N, `surface.indices()` is [n₁, n₂]; `surface.material` has `reflection`
/// and `transmission`. A ray deeper than `scene.max_depth` brings black; `surface.depth` is the depth of the ray that came.
/// Under total internal reflection the reflected ray takes the weight of the refracted one. A weight of 0 spawns no ray.
pub fn children(scene: &Scene, surface: &Surface<'_>) -> DVec3 {
    // BEGIN SOLUTION
    let spawned = |direction: DVec3| {
        if surface.depth < scene.max_depth {
            seen(scene, surface, direction)
        } else {
            DVec3::ZERO
        }
    };
    let mut sum = direct(scene, surface);
    let mut reflection = surface.material.reflection;
    let transmission = surface.material.transmission;
    if 0.0 < transmission {
        let [from, to] = surface.indices();
        match refract(surface.incoming, surface.normal, from, to).direction {
            Some(direction) => sum += transmission * spawned(direction),
            None => reflection += transmission,
        }
    }
    if 0.0 < reflection {
        sum += reflection * spawned(reflect(surface.incoming, surface.normal));
    }
    sum
    // END SOLUTION
}
