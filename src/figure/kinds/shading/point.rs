//! What was recorded at a shaded point.

use glam::DVec3;

use crate::figure::error::FigureError;
use crate::figure::subject::Figure;
use crate::scene::{Emission, Material};
use crate::trace::{Event, LightTerm, Shade, Visibility};

/// What was recorded at the point, and what follows from it.
pub(super) struct Point<'a> {
    pub(super) shade: &'a Shade,
    pub(super) shade_step: u32,
    pub(super) light: &'a LightTerm,
    pub(super) light_step: u32,
    /// V: back along the ray.
    pub(super) to_viewer: DVec3,
    /// R = 2(N·L)N − L.
    pub(super) mirrored: DVec3,
    /// Of what the surface is made.
    pub(super) material: &'a Material,
    /// The light's colour; none for a light with a power.
    pub(super) colour: Option<DVec3>,
}

pub(super) fn find<'a>(figure: &Figure<'a>) -> Result<Point<'a>, FigureError> {
    let drawn = figure.ray()?;
    let shade = drawn.events.iter().find_map(|record| match &record.event {
        Event::Shade(shade) => Some((shade, record.step)),
        _ => None,
    });
    let (Some((shade, shade_step)), Some(start)) = (shade, drawn.node.start) else {
        return Err(FigureError::new(
            "pixel",
            "the ray hits no object, so no point is shaded",
            "name a pixel, or a \"ray\" of it, that hits an object",
        ));
    };
    let terms = drawn
        .events
        .iter()
        .filter_map(|record| match &record.event {
            Event::LightTerm(term) => Some((term, record.step)),
            _ => None,
        });
    let terms: Vec<_> = terms.collect();
    let counts = |(term, _): &&(&LightTerm, u32)| counts(term);
    let Some(&(light, light_step)) = terms.iter().find(counts).or(terms.first()) else {
        return Err(FigureError::new(
            "scene",
            "the scene has no light, so the shade has no terms to draw",
            "add a light to the scene",
        ));
    };
    let to_light = light.term.to_light;
    let lamp = figure.scene.lights.get(light.light as usize);
    Ok(Point {
        material: figure.scene.material_of(shade.object),
        colour: lamp.and_then(|lamp| match lamp.emission {
            Emission::Colour(colour) => Some(colour),
            Emission::Power(_) => None,
        }),
        shade,
        shade_step,
        light,
        light_step,
        to_viewer: -start.ray.direction,
        mirrored: 2.0 * light.term.n_dot_l * shade.normal - to_light,
    })
}

/// Do the terms of the light count?
pub(super) fn counts(light: &LightTerm) -> bool {
    matches!(
        light.visibility,
        Visibility::Visible | Visibility::NotTested
    )
}
