//! The rays of a pixel in the scene: from the eye through the window, to the lights, reflected and refracted; before
//! them the paths of light that led to it (slides, "Type of Ray Tracing Algorithm" and "Ray Tracing Algorithm Example").

mod argument;
mod drawn;
mod line;
mod words;

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::rays::argument::{Argument, Of};
use crate::figure::kinds::rays::drawn::{Drawn, layer};
use crate::figure::kinds::rays::line::{end_of, look};
use crate::figure::parts::scenery;
use crate::figure::parts::surface;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::image::Image;
use crate::figure::sheet::look::Look;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::trace::{Event, Purpose, RayVerdict};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 400.0,
    usual: &[
        Layer::Objects,
        Layer::Names,
        Layer::Eye,
        Layer::Window,
        Layer::Lights,
        Layer::Ray,
        Layer::ShadowRays,
        Layer::Secondary,
        Layer::LightPaths,
        Layer::Connections,
        Layer::Hits,
    ],
    more: &[Layer::Normals, Layer::Angles, Layer::Legend],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let drawn = Drawn::find(figure)?;
    let argument = Argument::new(figure, sheet, &drawn);
    let mut body = body;
    if figure.shows(Layer::Legend) {
        body = legend(figure, sheet, body, &drawn);
    }
    let law = if figure.shows(Layer::Angles) {
        drawn.law(figure)
    } else {
        None
    };
    if let Some((place, law)) = &law {
        body = sheet.at(argument.of(Of::Surface(*place)), |sheet| {
            sheet.lines(body, &[law.text()])
        });
    }
    let first = law.as_ref().map(|(place, _)| *place);
    let law = law.as_ref().map(|(_, law)| law);
    let mut points = scenery::points_of(figure);
    points.extend(drawn.nodes().filter_map(|(.., node)| end_of(node)));
    let space = figure.space(body, points);
    if figure.shows(Layer::Objects) {
        scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
        met(figure, sheet, &space, &drawn, &argument);
    }
    // before the rays: their labels find other places more easily
    if figure.shows(Layer::Names) {
        names(figure, sheet, &space);
    }
    scenery::camera_and_lights(figure, sheet, &space);
    let mut named = Vec::new();
    for (place, section, node) in drawn.nodes() {
        let stages = [Of::Starts(place), Of::Ends(place)].map(|of| argument.of(of));
        let sends_on = drawn.rays.iter().enumerate().any(|(other, _)| {
            let is_on = |purpose| matches!(layer(purpose), Layer::Secondary);
            let (tree, node) = drawn.rays[other];
            let start = drawn.trees[tree].1.rays[node].start;
            drawn.parent(other) == Some(place) && start.is_some_and(|start| is_on(start.purpose))
        });
        line::draw(figure, sheet, &space, node, (stages, sends_on), &mut named);
        // behind the first surface it may come out parallel to what it was
        let enters = first
            .filter(|first| *first != place && !drawn.has_total_reflection(figure))
            .and_then(|first| drawn.nodes().nth(first))
            .and_then(|(_, section, node)| surface::Met::shown(figure, section.records, node));
        if let Some(enters) = enters {
            sheet.at(stages[1], |sheet| {
                enters.draw_offset(sheet, &space, node);
            });
        }
        if let Some(met) = surface::Met::shown(figure, section.records, node) {
            let at = argument.of(Of::Surface(place));
            met.draw(figure, sheet, &space, (at, law), &mut named);
            if first == Some(place) && !drawn.has_total_reflection(figure) {
                sheet.at(at, |sheet| met.draw_straight(sheet, &space));
            }
        }
        // the angle at which it leaves comes with it
        if let Some(from) = drawn.parent(place)
            && let Some((_, section, parent)) = drawn.nodes().nth(from)
            && let Some(met) = surface::Met::shown(figure, section.records, parent)
            && let Some(start) = node.start
        {
            sheet.at(stages[0], |sheet| {
                met.angle_of_child(figure, sheet, &space, (start.purpose, law));
            });
        }
    }
    lit(figure, sheet, &space, &drawn, &argument);
    if drawn.shows_colour {
        colour(figure, sheet, &space, &drawn, &argument);
    }
    let mut sentences = Vec::new();
    for (_, section, node) in drawn.nodes() {
        sentences.extend(words::of_end(figure, node));
        sentences.extend(surface::in_words(section.records, node));
    }
    Ok(sentences.join(" "))
}

/// Which looks there are in this figure.
fn legend(figure: &Figure, sheet: &mut Sheet, body: Frame, drawn: &Drawn) -> Frame {
    let is_there = |purpose: &Purpose| {
        let mut starts = drawn.nodes().filter_map(|(.., node)| node.start);
        figure.shows(layer(*purpose)) && starts.any(|start| start.purpose == *purpose)
    };
    let all = [
        Purpose::Eye,
        Purpose::Shadow,
        Purpose::Reflected,
        Purpose::Refracted,
        Purpose::Scattered,
        Purpose::Light,
        Purpose::Connection,
    ];
    let entries: Vec<(Look, &str)> = all
        .into_iter()
        .filter(is_there)
        .map(|purpose| (look(purpose), words::of_purpose(purpose)))
        .collect();
    sheet.legend(body, &entries)
}

/// What rays meet, from then on when it is known.
fn met(figure: &Figure, sheet: &mut Sheet, space: &Space, drawn: &Drawn, argument: &Argument) {
    if !figure.shows(Layer::Hits) {
        return;
    }
    let mut seen = Vec::new();
    for (place, _, node) in drawn.nodes() {
        let Some(object) = node.end.and_then(|end| end.object) else {
            continue;
        };
        if !seen.contains(&object) {
            seen.push(object);
            sheet.at(argument.of(Of::Ends(place)), |sheet| {
                scenery::some_objects(figure, sheet, space, &[object], Look::MET.outline());
            });
        }
    }
}

/// The names of the objects; those that light passes have their index of refraction.
fn names(figure: &Figure, sheet: &mut Sheet, space: &Space) {
    let index = |first| {
        let material = figure.scene.material_of(first);
        (0.0 < material.transmission && figure.shows(Layer::Angles)).then_some(material.index)
    };
    scenery::names_of(figure, sheet, space, |object| index(object.first).is_none());
    for object in &figure.scene.objects {
        if let Some(index) = index(object.first)
            && 0 < object.count
        {
            surface::name_with_index(figure, sheet, space, object, index);
        }
    }
}

/// Beside each hit whose shadow ray reaches the light, that it is lit.
fn lit(figure: &Figure, sheet: &mut Sheet, space: &Space, drawn: &Drawn, argument: &Argument) {
    if !figure.shows(Layer::Hits) || figure.shows(Layer::Legend) {
        return;
    }
    for (place, _, node) in drawn.nodes() {
        let (Some(start), Some(end)) = (node.start, node.end) else {
            continue;
        };
        if (start.purpose, end.verdict) != (Purpose::Shadow, RayVerdict::ReachesLight) {
            continue;
        }
        let at = space.place(start.ray.origin);
        // outside of the object: between the shadow ray and the ray that came
        let came = drawn
            .parent(place)
            .and_then(|of| drawn.nodes().nth(of)?.2.start);
        let came = came.map_or(DVec3::ZERO, |came| came.ray.direction.normalize_or_zero());
        let outwards = start.ray.direction.normalize_or_zero() - came;
        sheet.at(argument.of(Of::Ends(place)), |sheet| {
            let towards = space.direction(outwards);
            sheet.name(space.frame, at, towards, ("lit", Vec::new()));
        });
    }
}

/// A square of the pixel's colour below the window.
fn colour(figure: &Figure, sheet: &mut Sheet, space: &Space, drawn: &Drawn, argument: &Argument) {
    for (place, (section, tree)) in drawn.trees.iter().enumerate() {
        let colour = section
            .records
            .iter()
            .find_map(|record| match &record.event {
                Event::PixelColour(colour) => Some(colour.clamped),
                _ => None,
            });
        let (Some(colour), Some(eye)) = (colour, tree.rays.first()) else {
            continue;
        };
        let corners = scenery::window_corners(figure.scene).map(|corner| space.place(corner));
        let lowest = corners.into_iter().max_by(|a, b| a.y.total_cmp(&b.y));
        let Some(low) = lowest else { continue };
        let half = 0.6 * sheet.letters;
        let middle = low + DVec2::new(0.0, 2.0 * half);
        let square = Frame {
            min: middle - half,
            max: middle + half,
        };
        let rgb = (colour.clamp(DVec3::ZERO, DVec3::ONE) * 255.0).round();
        let is_miss = eye.end.is_some_and(|end| end.object.is_none());
        sheet.at(argument.of(Of::Colour(place)), |sheet| {
            let rgb = rgb.to_array().map(|of| of as u8);
            let colour = Image::new([1, 1], vec![Some(rgb)]).in_squares();
            sheet.image(square, colour);
            sheet.rectangle(Look::THIN, square);
            let text = if is_miss {
                "pixel: background"
            } else {
                "pixel"
            };
            let beside = middle + DVec2::new(half, 0.0);
            sheet.label(space.frame, beside, DVec2::X, text);
        });
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};
    use serde_json::json;

    use crate::figure::read_back::{ReadBack, traced};
    use crate::geometry::{Ray, TRange};
    use crate::scene::PrimitiveId;
    use crate::scene::small_scene::{object, one_pixel, sphere};
    use crate::trace::{Event, PixelSample, Purpose, RayEnd, RayStart, RayVerdict};

    #[test]
    fn a_blocked_shadow_ray_ends_where_its_event_says() {
        let ball = object("A", "white", &sphere([0.0, 0.0, -5.0], 1.0));
        let scene = one_pixel(&format!(
            r#""lights":[{{"name":"lamp","position":[3,0,0],"colour":[1,1,1]}}],
            "materials":{{"white":{{"colour":[1,1,1],"diffuse":1}}}},"objects":[{ball}]"#
        ));
        // from the hit (0, 0, −4) to the lamp, 5 away, and blocked at 2
        let eye = RayStart {
            ray: Ray::new(DVec3::ZERO, DVec3::NEG_Z),
            ..RayStart::default()
        };
        let to_light = RayStart {
            ray: Ray::new(DVec3::new(0.0, 0.0, -4.0), DVec3::new(0.6, 0.0, 0.8)),
            range: TRange { min: 0.0, max: 5.0 },
            purpose: Purpose::Shadow,
            light: Some(0),
            ..RayStart::default()
        };
        let end = |verdict, t| RayEnd {
            verdict,
            t: Some(t),
            object: Some(PrimitiveId(0)),
            ..RayEnd::default()
        };
        let events = [
            (None, Event::Pixel(PixelSample::default())),
            (Some(0), Event::Ray(eye)),
            (Some(1), Event::Ray(to_light)),
            (Some(1), Event::RayEnd(end(RayVerdict::Blocked, 2.0))),
            (Some(0), Event::RayEnd(end(RayVerdict::Hit, 4.0))),
        ];
        let spec = json!({"kind": "rays", "pixel": [0, 0]});
        let drawn = ReadBack::of(spec, traced(scene, events));
        let [hit] = drawn.dots("answer")[..] else {
            panic!("{:?}", drawn.dots("answer"));
        };
        let [blocked] = drawn.crosses("rejected")[..] else {
            panic!("{:?}", drawn.crosses("rejected"));
        };
        // from above z goes down: 0.6·2 to the right and 0.8·2 down, in the scale of the lamp's 3 and 4
        let lamp = hit + (blocked - hit) * 5.0 / 2.0;
        let scale = (lamp.x - hit.x) / 3.0;
        let near = |at: DVec2| drawn.dots("ink").iter().any(|of| of.distance(at) < 0.05);
        assert!((lamp.y - hit.y - 4.0 * scale).abs() < 0.05, "{hit} {lamp}");
        assert!(near(lamp), "no lamp at {lamp}");
        assert!(near(hit + DVec2::new(0.0, 4.0 * scale)), "no COP");
    }
}
