//! The rays of a pixel in the scene: from the eye through the window, to the lights, reflected and refracted; before
//! them the paths of light that led to it (slides, "Type of Ray Tracing Algorithm" and "Ray Tracing Algorithm Example").

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::scenery;
use crate::figure::parts::surface;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::traced::Section;
use crate::figure::view::Space;
use crate::geometry::Ray;
use crate::scene::PrimitiveId;
use crate::trace::{Purpose, RayNode, RayTree, RayVerdict};

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
    let mut sections = figure.first.paths();
    for pixel in figure.pixels() {
        sections.push(figure.section_of(pixel)?);
    }
    if sections.is_empty() {
        figure.pixel()?;
    }
    let trees: Vec<_> = sections
        .into_iter()
        .map(|section| (section, RayTree::new(section.records)))
        .collect();
    let shown = |node: &&RayNode| {
        node.start
            .is_some_and(|start| figure.shows(layer(start.purpose)))
    };
    let body = if figure.shows(Layer::Legend) {
        legend(&trees, figure, sheet, body)
    } else {
        body
    };

    let mut points = scenery::points_of(figure);
    for (_, tree) in &trees {
        points.extend(tree.rays.iter().filter(shown).filter_map(end_of));
    }
    let space = figure.space(body, points);
    let met: Vec<PrimitiveId> = trees
        .iter()
        .flat_map(|(_, tree)| tree.rays.iter().filter(shown))
        .filter_map(|node| node.end?.object)
        .collect();
    if figure.shows(Layer::Objects) {
        scenery::objects_met(figure, sheet, &space, &met);
    }
    // before the rays: their labels find other places more easily
    if figure.shows(Layer::Names) {
        scenery::names(figure, sheet, &space);
    }
    scenery::camera_and_lights(figure, sheet, &space);
    let mut sentences = Vec::new();
    let mut named = Vec::new();
    for (section, tree) in &trees {
        let records = section.records;
        for node in tree.rays.iter().filter(shown) {
            sheet.step(
                node.ends_at[0].map(|at| section.step(&records[at])),
                |sheet| {
                    ray(figure, sheet, &space, node, &mut named);
                    sentences.extend(in_words(figure, node));
                    surface::draw(figure, sheet, &space, records, node);
                    sentences.extend(surface::in_words(records, node));
                },
            );
        }
    }
    Ok(sentences.join(" "))
}

fn layer(purpose: Purpose) -> Layer {
    match purpose {
        Purpose::Eye => Layer::Ray,
        Purpose::Shadow => Layer::ShadowRays,
        Purpose::Reflected | Purpose::Refracted | Purpose::Scattered => Layer::Secondary,
        Purpose::Light => Layer::LightPaths,
        Purpose::Connection => Layer::Connections,
    }
}

fn look(purpose: Purpose) -> Look {
    match purpose {
        Purpose::Eye => Look::RAY,
        Purpose::Shadow => Look::SHADOW_RAY,
        Purpose::Reflected | Purpose::Scattered => Look::REFLECTED_RAY,
        Purpose::Refracted => Look::REFRACTED_RAY,
        Purpose::Light => Look::LIGHT_RAY,
        Purpose::Connection => Look::CONNECTION,
    }
}

/// What a ray is called beside its line.
fn name(purpose: Purpose) -> &'static str {
    match purpose {
        Purpose::Eye => "eye ray",
        Purpose::Shadow => "shadow ray",
        Purpose::Reflected => "reflected",
        Purpose::Refracted => "refracted",
        Purpose::Scattered => "scattered",
        Purpose::Light => "path of light",
        Purpose::Connection => "connecting line",
    }
}

/// Which looks there are in this figure.
fn legend(trees: &[(Section, RayTree)], figure: &Figure, sheet: &mut Sheet, body: Frame) -> Frame {
    let is_there = |purpose: &Purpose| {
        let nodes = trees.iter().flat_map(|(_, tree)| &tree.rays);
        let mut starts = nodes.filter_map(|node| node.start);
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
        .map(|purpose| (look(purpose), name(purpose)))
        .collect();
    sheet.legend(body, &entries)
}

/// Where a ray ends, if it ends anywhere.
fn end_of(node: &RayNode) -> Option<DVec3> {
    let (start, end) = (node.start?, node.end?);
    let t = end.t.or_else(|| {
        // a ray to a light ends there, a connecting line at its other end
        matches!(end.verdict, RayVerdict::ReachesLight | RayVerdict::Connects)
            .then_some(start.range.max)
    })?;
    t.is_finite().then(|| start.ray.at(t))
}

/// Draws a ray. Of the rays that are called the same the first has the name beside it.
fn ray(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    node: &RayNode,
    named: &mut Vec<&'static str>,
) {
    let (Some(start), Some(end)) = (node.start, node.end) else {
        return;
    };
    if end.verdict == RayVerdict::DepthLimit {
        return;
    }
    let from = space.place(start.ray.origin);
    let to = match end_of(node) {
        Some(end) => space.place(end),
        None => match leaves(space, &start.ray) {
            Some(edge) => edge,
            None => return,
        },
    };
    let Some([from, to]) = space.frame.cut_line([from, to]) else {
        return;
    };
    let along = (to - from).normalize_or_zero();
    let has_mark = figure.shows(Layer::Hits) && end.t.is_some();
    // the head ends where the mark begins, or the light
    let head = if has_mark {
        4.0 * sheet.unit()
    } else if end.verdict == RayVerdict::ReachesLight && figure.shows(Layer::Lights) {
        11.0 * sheet.unit()
    } else {
        0.0
    };
    sheet.arrow(look(start.purpose), from, to - head * along);
    if end.verdict == RayVerdict::Blocked {
        // where it would have gone
        let light = space.place(start.ray.at(start.range.max));
        if let Some([from, to]) = space.frame.cut_line([to, light]) {
            sheet.line(Look::LINE_OF_RAY, from, to);
        }
    }
    if has_mark && end.verdict == RayVerdict::Blocked {
        sheet.cross(Look::REJECTED, to);
    } else if has_mark {
        sheet.dot(Look::ANSWER, to);
    }
    let text = match (start.purpose, end.verdict) {
        (Purpose::Shadow, RayVerdict::Blocked) => "blocked",
        (Purpose::Eye, RayVerdict::Miss) => "eye ray, misses",
        (purpose, _) => name(purpose),
    };
    if !figure.shows(Layer::Legend) && !named.contains(&text) {
        named.push(text);
        let middle = from.lerp(to, 0.45);
        sheet.label(space.frame, middle, upwards(along.perp()), text);
    }
}

/// Of the two directions across a line the one that goes up.
fn upwards(across: DVec2) -> DVec2 {
    if 0.0 < across.y { -across } else { across }
}

/// Where a ray that hits nothing leaves the frame.
fn leaves(space: &Space, ray: &Ray) -> Option<DVec2> {
    let t = space.leaves(ray)?;
    Some(space.place(ray.at(t)))
}

/// A ray in words.
fn in_words(figure: &Figure, node: &RayNode) -> Option<String> {
    let (start, end) = (node.start?, node.end?);
    let object = end.object.map(|id| scenery::name_of(figure.scene, id));
    let object = object.unwrap_or_default();
    let lamp = start
        .light
        .and_then(|light| figure.scene.lights.get(light as usize));
    let to_light = lamp.map_or(String::new(), |light| {
        format!(" \"{}\"", scenery::short(&light.name))
    });
    let what = match start.purpose {
        Purpose::Eye => "The eye ray".into(),
        Purpose::Shadow => format!("The shadow ray to light{to_light}"),
        Purpose::Reflected => "The reflected ray".into(),
        Purpose::Refracted => "The refracted ray".into(),
        Purpose::Scattered => "The scattered ray".into(),
        Purpose::Light => format!("The path from light{to_light}"),
        Purpose::Connection => "The connecting line".into(),
    };
    Some(match end.verdict {
        RayVerdict::Hit => format!("{what} hits {object}."),
        RayVerdict::Miss => format!("{what} misses all objects."),
        RayVerdict::Blocked => format!("{what} is blocked by {object}."),
        RayVerdict::ReachesLight => format!("{what} reaches the light."),
        RayVerdict::DepthLimit => format!("{what} is not traced: the depth limit is reached."),
        RayVerdict::Absorbed => format!("{what} is absorbed by {object}."),
        RayVerdict::CutOff => format!("{what} is cut off at {object}."),
        RayVerdict::Connects => format!("{what} hits no object."),
    })
}
