//! Point lights and the terms of the shade that one light adds.
//!
//! I = ambient·colour + Σ over visible lights of light·[colour·diffuse·max(0, N·L)
//! + specular·max(0, R·V)^shininess] + reflection·I_reflected + transmission·I_refracted
//!
//! No fall-off. A light with a power Φ in watts gives instead the irradiance E = Φ·cos θ / (4π·r²), of
//! which the surface reflects colour·diffuse/π.

use std::f64::consts::PI;

use glam::DVec3;

use crate::geometry::reflect;
use crate::scene::file::Material;

/// A point light.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Its name in the log.
    pub name: String,
    /// Where it stands, in world coordinates.
    pub position: DVec3,
    /// What it sends out.
    pub emission: Emission,
}

/// What a light sends out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Emission {
    /// An intensity that does not depend on the distance.
    Colour(DVec3),
    /// Φ in watts.
    Power(f64),
}

/// What one light adds to the shade of a point, if nothing stands between them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PhongTerm {
    /// L: the unit vector from the point to the light; zero if the light stands in the point.
    pub to_light: DVec3,
    /// How far away the light is.
    pub distance: f64,
    /// N·L: the cosine of the angle of incidence; at most 0 if the surface faces away.
    pub n_dot_l: f64,
    /// R·V: the cosine between the mirrored light and the viewer.
    pub r_dot_v: f64,
    /// light·colour·diffuse·max(0, N·L), or colour·diffuse/π · E.
    pub diffuse: DVec3,
    /// light·specular·max(0, R·V)^shininess; 0 for a light that has a power.
    pub specular: DVec3,
}

impl Light {
    /// The diffuse and the specular term at a point of a surface.
    ///
    /// `normal` N and `to_viewer` V have unit length; N is on the viewer's side. Where N·L ≤ 0 the
    /// light stands behind the surface and both terms are 0.
    #[doc(alias = "Phong reflection model")]
    #[doc(alias = "Lambertian reflection")]
    pub fn phong(
        &self,
        material: &Material,
        point: DVec3,
        normal: DVec3,
        to_viewer: DVec3,
    ) -> PhongTerm {
        let offset = self.position - point;
        let distance = offset.length();
        let to_light = offset.normalize_or_zero();
        let n_dot_l = normal.dot(to_light);
        // R = 2(N·L)N − L, the mirror image of −L
        let r_dot_v = reflect(-to_light, normal).dot(to_viewer);

        let colour = DVec3::from(material.colour);
        let (diffuse, specular) = if n_dot_l <= 0.0 {
            (DVec3::ZERO, DVec3::ZERO)
        } else {
            match self.emission {
                Emission::Colour(light) => {
                    let highlight = libm::pow(r_dot_v.max(0.0), material.shininess);
                    (
                        light * colour * (material.diffuse * n_dot_l),
                        light * (material.specular * highlight),
                    )
                }
                Emission::Power(power) => {
                    let irradiance = power * n_dot_l / (4.0 * PI * distance * distance);
                    (colour * (material.diffuse / PI * irradiance), DVec3::ZERO)
                }
            }
        };
        PhongTerm {
            to_light,
            distance,
            n_dot_l,
            r_dot_v,
            diffuse,
            specular,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RED: Material = Material {
        colour: [0.8, 0.2, 0.1],
        diffuse: 0.5,
        specular: 0.25,
        shininess: 2.0,
        reflection: 0.0,
        transmission: 0.0,
        index: 1.0,
    };

    fn light(emission: Emission) -> Light {
        Light {
            name: "lamp".into(),
            position: DVec3::new(3.0, 4.0, 0.0),
            emission,
        }
    }

    #[test]
    fn the_terms_are_those_of_a_light_at_a_slant() {
        // L = (0.6, 0.8, 0), N = (0, 1, 0): N·L = 0.8, R = (−0.6, 0.8, 0), V = N: R·V = 0.8
        let term = light(Emission::Colour(DVec3::new(1.0, 0.5, 1.0))).phong(
            &RED,
            DVec3::ZERO,
            DVec3::Y,
            DVec3::Y,
        );
        assert_eq!((term.distance, term.n_dot_l), (5.0, 0.8));
        assert!((term.r_dot_v - 0.8).abs() <= 1e-15);
        // 0.8·0.5·0.8 = 0.32, 0.5·0.2·0.5·0.8 = 0.04, 0.1·0.5·0.8 = 0.04
        assert!((term.diffuse - DVec3::new(0.32, 0.04, 0.04)).length() <= 1e-15);
        // 0.25·0.8² = 0.16
        assert!((term.specular - DVec3::new(0.16, 0.08, 0.16)).length() <= 1e-15);
    }

    #[test]
    fn a_light_behind_the_surface_adds_nothing() {
        let lamp = light(Emission::Colour(DVec3::ONE));
        let term = lamp.phong(&RED, DVec3::ZERO, -DVec3::Y, -DVec3::Y);
        assert_eq!((term.diffuse, term.specular), (DVec3::ZERO, DVec3::ZERO));
        assert_eq!(term.n_dot_l, -0.8);
    }

    #[test]
    fn a_power_falls_off_with_the_square_of_the_distance() {
        // E = 100π·0.8/(4π·25) = 0.8; of it colour·0.5/π is reflected
        let term = light(Emission::Power(100.0 * PI)).phong(&RED, DVec3::ZERO, DVec3::Y, DVec3::Y);
        let expected = DVec3::new(0.8, 0.2, 0.1) * (0.5 * 0.8 / PI);
        assert!(
            (term.diffuse - expected).length() <= 1e-15,
            "{}",
            term.diffuse
        );
        assert_eq!(term.specular, DVec3::ZERO);
    }

    #[test]
    fn a_light_in_the_point_itself_adds_nothing() {
        let lamp = light(Emission::Power(1.0));
        let term = lamp.phong(&RED, lamp.position, DVec3::Y, DVec3::Y);
        assert_eq!((term.diffuse, term.specular), (DVec3::ZERO, DVec3::ZERO));
    }
}
