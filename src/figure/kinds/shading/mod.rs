//! Where a ray hits a surface: N, L, R and V, and the terms of the shade that a light adds there.
//!
//! I = ambient + light·[colour·diffuse·max(0, N·L) + specular·max(0, R·V)^shininess]

mod argument;
mod point;
mod table;

use glam::DVec3;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::shading::argument::Argument;
use crate::figure::kinds::shading::point::{Point, find};
use crate::figure::parts::angle::{Angle, degrees};
use crate::figure::parts::scenery;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::formula;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::trace::Visibility;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 360.0,
    usual: &[Layer::Objects, Layer::Names, Layer::Angles, Layer::Numbers],
    more: &[],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    /// Of the width at most; the rest is for the numbers.
    const SHARE: f64 = 0.55;
    let point = find(figure)?;
    let name = scenery::name_of(figure.scene, point.shade.object);
    let argument = Argument::new(sheet, &point, &name);
    let rows = table::rows(sheet, &point, &argument);
    let [left, right] = if figure.shows(Layer::Numbers) {
        let gap = sheet.letters;
        let rest = 1.0 - table::width(sheet, &rows) / (body.size().x - gap);
        body.split(rest.clamp(0.0, SHARE), gap)
    } else {
        [body; 2]
    };
    let length = length(figure, &point);
    let space = figure.space(left, around(&point, length));
    if figure.shows(Layer::Objects) {
        scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
    }
    vectors(figure, sheet, &space, &point, length, &argument);
    if figure.shows(Layer::Numbers) {
        table::draw(sheet, right, rows);
    }
    if figure.shows(Layer::Names) {
        scenery::names(figure, sheet, &space);
    }
    Ok(in_words(figure, &point))
}

/// How long a unit vector is drawn: a little more than half the largest side of the object that was hit.
fn length(figure: &Figure, point: &Point) -> f64 {
    const SHARE: f64 = 0.57;
    let shape = &figure.scene.primitive(point.shade.object).shape;
    let sides = DVec3::AXES.map(|axis| {
        let [low, high] = crate::structure::extent(shape, axis);
        high - low
    });
    SHARE * sides.into_iter().fold(0.0, f64::max)
}

/// The ends of the vectors, and some of what is below the surface.
fn around(point: &Point, length: f64) -> [DVec3; 6] {
    let normal = point.shade.normal;
    let below = -0.6 * normal;
    let to_light = point.light.term.to_light;
    // as much of the surface on the other side of N: L and R mirror each other, V has no counterpart
    let opposite = 2.0 * normal.dot(point.to_viewer) * normal - point.to_viewer;
    let ends = [
        normal,
        to_light,
        point.mirrored,
        point.to_viewer,
        opposite,
        below,
    ];
    ends.map(|end| point.shade.point + length * end)
}

fn vectors(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    point: &Point,
    length: f64,
    argument: &Argument,
) {
    let length = length * space.scale;
    let at = space.place(point.shade.point);
    let (normal, to_light) = (point.shade.normal, point.light.term.to_light);
    let all = [
        (normal, "N", Look::RAY, argument.normal),
        (to_light, "L", Look::SHADOW_RAY, argument.to_light),
        (point.mirrored, "R", Look::REFLECTED_RAY, argument.mirrored),
        (point.to_viewer, "V", Look::RAY, argument.to_viewer),
    ];
    for (direction, name, look, stage) in all {
        let along = space.direction(direction);
        let end = at + length * along;
        sheet.at(stage, |sheet| {
            sheet.arrow(look, at, end);
            sheet.label(space.frame, end, along, formula(name));
        });
    }
    if figure.shows(Layer::Angles) {
        let mut angle = |stage, between: [DVec3; 2], share: f64, name: &str| {
            let angle = Angle {
                at,
                between: between.map(|of| space.direction(of)),
                radius: share * length / sheet.unit(),
            };
            sheet.at(stage, |sheet| {
                angle.draw(sheet, space.frame, formula(name));
            });
        };
        angle(argument.to_light, [normal, to_light], 0.3, "θ");
        angle(argument.mirrored, [normal, point.mirrored], 0.3, "θ");
        let to_viewer = [point.mirrored, point.to_viewer];
        angle(argument.to_viewer, to_viewer, 0.75, "α");
    }
    sheet.at(argument.point, |sheet| {
        sheet.dot(Look::RAY, at);
        let below = space.direction(-normal);
        sheet.label(space.frame, at, below, formula("p"));
    });
}

fn in_words(figure: &Figure, point: &Point) -> String {
    let (term, shade) = (&point.light.term, point.shade);
    let object = scenery::name_of(figure.scene, shade.object);
    let light = figure.scene.lights.get(point.light.light as usize);
    let light = light.map_or(String::new(), |light| {
        format!(" \"{}\"", scenery::short(&light.name))
    });
    let seen = match point.light.visibility {
        Visibility::Visible => "The light is visible.",
        Visibility::Shadowed => "The light is blocked: the point is in shadow.",
        Visibility::FacesAway => "The surface faces away from the light.",
        Visibility::NotTested => "No shadow ray is cast.",
    };
    format!(
        "On {object} the vector L to light{light} is at {} to the normal: N·L = {}. {seen} \
         The reflected R is at {} to the viewer: R·V = {}. \
         Ambient {}, diffuse {}, specular {}; in sum {}.",
        degrees(term.n_dot_l),
        quantity(term.n_dot_l),
        degrees(term.r_dot_v),
        quantity(term.r_dot_v),
        coordinates(shade.ambient),
        coordinates(term.diffuse),
        coordinates(term.specular),
        coordinates(shade.ambient + shade.direct),
    )
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};
    use serde_json::json;

    use crate::figure::read_back::{ReadBack, traced};
    use crate::geometry::Ray;
    use crate::scene::small_scene::{object, one_pixel, sphere};
    use crate::scene::{PhongTerm, PrimitiveId};
    use crate::trace::{Event, LightTerm, PixelSample, RayEnd, RayStart, Shade, Visibility};

    #[test]
    fn the_vectors_are_drawn_in_their_directions_and_equally_long() {
        let ball = object("A", "white", &sphere([0.0; 3], 1.0));
        let scene = one_pixel(&format!(
            r#""lights":[{{"name":"lamp","position":[3,5,0],"colour":[1,1,1]}}],
            "materials":{{"white":{{"colour":[1,1,1],"diffuse":0.5,"specular":0.25,"shininess":2}}}},
            "objects":[{ball}]"#
        ));
        // in the topmost point, seen from the upper left; L rises by 4 on 3
        let point = DVec3::Y;
        let direction = DVec3::new(0.8, -0.6, 0.0);
        let start = RayStart {
            ray: Ray::new(point - 5.0 * direction, direction),
            ..RayStart::default()
        };
        let term = PhongTerm {
            to_light: DVec3::new(0.6, 0.8, 0.0),
            distance: 5.0,
            n_dot_l: 0.8,
            r_dot_v: 0.96,
            diffuse: DVec3::splat(0.4),
            specular: DVec3::splat(0.2304),
        };
        let light = LightTerm {
            light: 0,
            visibility: Visibility::Visible,
            term,
        };
        let shade = Shade {
            object: PrimitiveId(0),
            point,
            normal: DVec3::Y,
            ..Shade::default()
        };
        let events = [
            (None, Event::Pixel(PixelSample::default())),
            (Some(0), Event::Ray(start)),
            (Some(0), Event::LightTerm(light)),
            (Some(0), Event::Shade(shade)),
            (Some(0), Event::RayEnd(RayEnd::default())),
        ];
        let spec = json!({"kind": "shading", "pixel": [0, 0], "view": "front"});
        let drawn = ReadBack::of(spec, traced(scene, events));
        let at = drawn.dots("ink").pop().unwrap();
        // an arrow's head begins at its tip
        let paths = drawn.paths("ink");
        let tips: Vec<DVec2> = paths
            .iter()
            .filter(|points| points.len() == 3)
            .map(|points| points[0] - at)
            .collect();
        let [n, others @ ..] = tips.as_slice() else {
            panic!("no arrows");
        };
        assert!(n.x.abs() < 0.02 && n.y < 0.0, "N goes up: {n}");
        // L, then R, which is L mirrored at N, then V, back along the ray; y goes down on a sheet
        let expected = [[0.6, -0.8], [-0.6, -0.8], [-0.8, -0.6]];
        assert_eq!(others.len(), expected.len());
        for (tip, direction) in others.iter().zip(expected) {
            let off = (tip / n.length() - DVec2::from(direction)).length();
            assert!(off < 1e-3, "{tip} for {direction:?}");
        }
        let texts = drawn.texts();
        assert!(texts.contains(&"= 1·0.25·0.962".into()), "{texts:?}");
    }
}
