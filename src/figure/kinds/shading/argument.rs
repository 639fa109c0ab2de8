//! The stages in which the shade of a point comes together.

use crate::explain::Part;
use crate::figure::kinds::shading::point::{Point, counts};
use crate::figure::parts::angle::degrees;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::stage::StageId;

/// The stages, in their order. The terms of a light are made by one event, which needs the point and its normal.
pub(super) struct Argument {
    pub(super) point: StageId,
    pub(super) normal: StageId,
    pub(super) to_light: StageId,
    pub(super) diffuse: StageId,
    pub(super) mirrored: StageId,
    pub(super) to_viewer: StageId,
    pub(super) specular: StageId,
    pub(super) ambient: StageId,
    pub(super) sum: StageId,
}

impl Argument {
    pub(super) fn new(sheet: &mut Sheet, point: &Point, name: &str) -> Self {
        let (term, shade) = (&point.light.term, point.shade);
        let (with_light, with_shade) = (point.light_step, point.shade_step);
        let at = sheet.stage(
            Part::Point,
            with_light,
            format!("The ray hits {name} in the point p."),
        );
        let normal = sheet.stage(
            Part::Normal,
            with_light,
            "N is the unit normal of the surface in p.",
        );
        let to_light = sheet.stage(
            Part::ToLight,
            with_light,
            format!(
                "L points to the light, at θ = {} to N, so N·L = cos θ = {}.",
                degrees(term.n_dot_l),
                quantity(term.n_dot_l)
            ),
        );
        let diffuse = sheet.stage(
            Part::Diffuse,
            with_light,
            format!(
                "The diffuse term is proportional to N·L: {}.",
                coordinates(term.diffuse)
            ),
        );
        let mirrored = sheet.stage(
            "R",
            with_light,
            "R is L mirrored at N, on the other side at the same angle θ.",
        );
        let to_viewer = sheet.stage(
            "V, R·V",
            with_light,
            format!(
                "V points to the viewer, at α = {} to R, so R·V = cos α = {}.",
                degrees(term.r_dot_v),
                quantity(term.r_dot_v)
            ),
        );
        let specular = sheet.stage(
            Part::Specular,
            with_light,
            format!(
                "The specular term is proportional to R·V to the power of the shininess {}: {}.",
                quantity(point.material.shininess),
                coordinates(term.specular)
            ),
        );
        let ambient = sheet.stage(
            Part::Ambient,
            with_shade,
            format!(
                "The ambient term comes from everywhere: {}.",
                coordinates(shade.ambient)
            ),
        );
        let sum = coordinates(shade.ambient + shade.direct);
        let sum = sheet.stage(
            Part::LightSum,
            with_shade,
            if counts(point.light) {
                format!("The sum is the light I = {sum} that leaves p towards the viewer.")
            } else {
                format!("No light from this lamp arrives, so the sum is I = {sum}.")
            },
        );
        Self {
            point: at,
            normal,
            to_light,
            diffuse,
            mirrored,
            to_viewer,
            specular,
            ambient,
            sum,
        }
    }
}
