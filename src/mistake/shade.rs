//! The terms of a light.

use glam::DVec3;

use crate::geometry::reflect;
use crate::mistake::{Mistake, Wrong};
use crate::scene::{Emission, Light, Material, PhongTerm};

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "L from light to point",
        sentence: "L runs from the light to the point, so N·L has the wrong sign.",
        spoils: "L",
        wrong: Wrong::LightTerm(from_light_to_point),
    },
    Mistake {
        name: "only the sum clamped",
        sentence: "Only the sum of the terms is cut off at 0, so behind the surface the diffuse term is negative and the specular one remains.",
        spoils: "diffuse and specular term",
        wrong: Wrong::LightTerm(only_the_sum_clamped),
    },
    Mistake {
        name: "R made of V",
        sentence: "V is mirrored instead of L, so R·V compares the viewer's direction with its own mirror image.",
        spoils: "R·V",
        wrong: Wrong::LightTerm(mirrored_viewer),
    },
];

fn from_light_to_point(
    light: &Light,
    material: &Material,
    point: DVec3,
    normal: DVec3,
    to_viewer: DVec3,
) -> PhongTerm {
    let opposite = Light {
        position: 2.0 * point - light.position,
        ..light.clone()
    };
    opposite.phong(material, point, normal, to_viewer)
}

fn only_the_sum_clamped(
    light: &Light,
    material: &Material,
    point: DVec3,
    normal: DVec3,
    to_viewer: DVec3,
) -> PhongTerm {
    let term = light.phong(material, point, normal, to_viewer);
    let Emission::Colour(colour) = light.emission else {
        return term;
    };
    let diffuse = colour * DVec3::from(material.colour) * (material.diffuse * term.n_dot_l);
    let specular = specular(colour, material, term.r_dot_v);
    let is_lit = 0.0 < (diffuse + specular).element_sum();
    PhongTerm {
        diffuse: if is_lit { diffuse } else { DVec3::ZERO },
        specular: if is_lit { specular } else { DVec3::ZERO },
        ..term
    }
}

fn mirrored_viewer(
    light: &Light,
    material: &Material,
    point: DVec3,
    normal: DVec3,
    to_viewer: DVec3,
) -> PhongTerm {
    let term = light.phong(material, point, normal, to_viewer);
    let r_dot_v = reflect(-to_viewer, normal).dot(to_viewer);
    match light.emission {
        Emission::Colour(colour) if 0.0 < term.n_dot_l => PhongTerm {
            r_dot_v,
            specular: specular(colour, material, r_dot_v),
            ..term
        },
        _ => PhongTerm { r_dot_v, ..term },
    }
}

/// light·specular·max(0, R·V)^shininess
fn specular(light: DVec3, material: &Material, r_dot_v: f64) -> DVec3 {
    light * (material.specular * libm::pow(r_dot_v.max(0.0), material.shininess))
}

#[cfg(test)]
mod tests {
    use super::*;

    const GREY: Material = Material {
        colour: [1.0; 3],
        diffuse: 0.125,
        specular: 0.5,
        shininess: 1.0,
        reflection: 0.0,
        transmission: 0.0,
        index: 1.0,
    };

    type Term = fn(&Light, &Material, DVec3, DVec3, DVec3) -> PhongTerm;

    /// N·L, R·V, the diffuse and the specular term at the origin with N = (0, 1, 0), of a white light at (3, y, 0).
    fn of(term: Term, y: f64, to_viewer: [f64; 3]) -> [f64; 4] {
        let light = Light {
            name: "lamp".into(),
            position: DVec3::new(3.0, y, 0.0),
            emission: Emission::Colour(DVec3::ONE),
        };
        let term = term(&light, &GREY, DVec3::ZERO, DVec3::Y, to_viewer.into());
        [term.n_dot_l, term.r_dot_v, term.diffuse.x, term.specular.x]
    }

    fn right(light: &Light, material: &Material, p: DVec3, n: DVec3, v: DVec3) -> PhongTerm {
        light.phong(material, p, n, v)
    }

    #[track_caller]
    fn check(found: [f64; 4], expected: [f64; 4]) {
        // some roundings of numbers up to 1
        let close = found
            .iter()
            .zip(expected)
            .all(|(a, b)| (a - b).abs() <= 1e-15);
        assert!(close, "{found:?}, expected {expected:?}");
    }

    #[test]
    fn with_l_turned_a_light_in_front_counts_as_behind() {
        // L = (0.6, 0.8, 0), R = (−0.6, 0.8, 0), V = N
        let up = [0.0, 1.0, 0.0];
        check(of(right, 4.0, up), [0.8, 0.8, 0.1, 0.4]);
        check(of(from_light_to_point, 4.0, up), [-0.8, -0.8, 0.0, 0.0]);
        // a light in the surface has no terms either way
        check(of(right, 0.0, up), [0.0; 4]);
        check(of(from_light_to_point, 0.0, up), [0.0; 4]);
    }

    #[test]
    fn a_highlight_behind_the_surface_needs_a_clamp_of_its_own() {
        // the light at (3, −4, 0): L = (0.6, −0.8, 0), R = (−0.6, −0.8, 0), V = −x
        let side = [-1.0, 0.0, 0.0];
        check(of(right, -4.0, side), [-0.8, 0.6, 0.0, 0.0]);
        check(of(only_the_sum_clamped, -4.0, side), [-0.8, 0.6, -0.1, 0.3]);
        // in front of the surface there is nothing to clamp
        let up = [0.0, 1.0, 0.0];
        check(of(only_the_sum_clamped, 4.0, up), of(right, 4.0, up));
        // and seen from above the light behind has R·V < 0
        check(of(only_the_sum_clamped, -4.0, up), of(right, -4.0, up));
    }

    #[test]
    fn the_mirrored_viewer_sees_a_highlight_wherever_he_looks_straight() {
        // V = N: V mirrored at N is V itself
        check(
            of(mirrored_viewer, 4.0, [0.0, 1.0, 0.0]),
            [0.8, 1.0, 0.1, 0.5],
        );
        // V = L: both are L mirrored times L, 0.64 − 0.36
        let at_light = [0.6, 0.8, 0.0];
        check(of(right, 4.0, at_light), [0.8, 0.28, 0.1, 0.14]);
        check(of(mirrored_viewer, 4.0, at_light), [0.8, 0.28, 0.1, 0.14]);
    }
}
