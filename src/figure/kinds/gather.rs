//! The photons nearest to a point, as they lie on its surface, and the density that follows from them (slides, "Type
//! of Ray Tracing Algorithm": hybrid with storage on surfaces; Jensen 1996).

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};

use crate::explain::{Part, grouped};
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::disc;
use crate::figure::parts::gathering::Gathering;
use crate::figure::parts::light_path::{Leg, LightPath};
use crate::figure::parts::outline::{self, Outline, Rim};
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::{Colour, Fill, Look};
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::formula;
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;
use crate::geometry::{Plane, Sphere};
use crate::scene::{PrimitiveId, Shape};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 480.0,
    usual: &[Layer::Objects, Layer::Hits, Layer::Numbers],
    more: &[],
};

/// The stages, in their order.
struct Argument {
    photons: StageId,
    point: StageId,
    nearest: StageId,
    sum: StageId,
}

impl Argument {
    fn new(figure: &Figure, sheet: &mut Sheet, gathering: &Gathering, radius: f64) -> Self {
        let object = scenery::name_of(figure.scene, gathering.gathered.object);
        let sections = figure.first.paths();
        let paths: Vec<LightPath> = sections.iter().filter_map(LightPath::of).collect();
        let on_it = paths.iter().flat_map(|path| &path.legs).filter(|leg| {
            leg.stored
                .is_some_and(|photon| photon.object == gathering.gathered.object)
        });
        let stored = on_it.clone().count();
        let last = on_it.map(|leg| leg.step).max();
        let found = gathering.nearby.first().map(|(step, _)| *step);
        Self {
            photons: sheet.stage(
                "photons",
                last,
                format!(
                    "{} paths of light have left {} photons on {object}.",
                    grouped(paths.len() as u64),
                    grouped(stored as u64)
                ),
            ),
            point: sheet.stage(
                Part::Point,
                found,
                format!("The eye ray hits {object} in p."),
            ),
            nearest: sheet.stage(
                "nearest photons",
                gathering.step,
                format!(
                    "Of the {} nearest photons the last one sets the radius of the disc, r = {}, and does not count.",
                    gathering.nearby.len(),
                    quantity(radius)
                ),
            ),
            sum: sheet.stage(
                Part::Irradiance,
                gathering.step,
                format!(
                    "The power of the {} others over the area of the disc is the irradiance: {}.",
                    gathering.counted().len(),
                    gathering.working().join(" ")
                ),
            ),
        }
    }
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let section = figure.section_of(figure.pixel()?)?;
    let gatherings = Gathering::all(&section);
    let with_disc = gatherings
        .iter()
        .find_map(|of| Some((of, of.gathered.radius?, of.disc(figure.scene)?)));
    let Some((gathering, radius, rim)) = with_disc else {
        return Err(FigureError::new(
            "pixel",
            "no photons were gathered at this pixel without a map",
            "add \"transport\": \"hybrid-stored\" without \"map\", and name a pixel that shows a diffuse surface",
        ));
    };
    let numbers = numbers(gathering);
    let argument = Argument::new(figure, sheet, gathering, radius);
    let body = if figure.shows(Layer::Numbers) {
        let body = sheet.at(argument.nearest, |sheet| sheet.lines(body, &numbers[..1]));
        sheet.at(argument.sum, |sheet| sheet.lines(body, &gathering.lines()))
    } else {
        body
    };
    let space = figure.space(body, rim.iter().copied());
    let object = gathering.gathered.object;
    if figure.shows(Layer::Objects) {
        let shape = &figure.scene.primitive(object).shape;
        let outline = Outline::of(shape, &space.projection);
        outline::draw(sheet, &space, &outline, Look::OBJECT);
        let name = scenery::name_of(figure.scene, object);
        sheet.label_in(space.frame, name);
        above(figure, sheet, &space, object);
    }
    sheet.within(space.frame, |sheet| {
        if figure.shows(Layer::Hits) {
            stored(figure, sheet, &space, (gathering, argument.photons));
        }
        let rim: Vec<DVec2> = rim.iter().map(|at| space.projection.of(*at)).collect();
        let rim = Rim::Points(rim);
        sheet.at(argument.nearest, |sheet| {
            outline::rim(sheet, &space, &rim, Look::THIN.wide(1.25));
        });
        sheet.at(argument.sum, |sheet| {
            // a filled disc would tint the photons
            let ring = Look {
                fill: Fill::Empty,
                ..Look::ANSWER
            };
            outline::rim(sheet, &space, &rim, ring);
        });
        photons(sheet, &space, (gathering, radius), &argument);
    });
    let object = scenery::name_of(figure.scene, object);
    Ok(format!(
        "Photons on {object} around the point p that the eye ray hits. {}.",
        numbers.join(", ")
    ))
}

/// The outlines of the other objects, which lie above the surface: where light is missing, or gathered by glass.
fn above(figure: &Figure, sheet: &mut Sheet, space: &Space, object: PrimitiveId) {
    for id in figure.near.iter().copied().filter(|id| *id != object) {
        let shape = &figure.scene.primitive(id).shape;
        let outline = Outline::of(shape, &space.projection);
        outline::rim(sheet, space, &outline.rim, Look::HELP);
        shadows(figure, sheet, space, (object, id));
        let points = outline.rim.points().into_iter();
        let points = points.map(|at| space.place_flat(at));
        let lowest = points.max_by(|a, b| a.y.total_cmp(&b.y));
        if let Some(at) = lowest.filter(|at| space.frame.contains(*at)) {
            let name = scenery::name_of(figure.scene, id);
            sheet.label(space.frame, at, DVec2::Y, format!("{name}, above"));
        }
    }
}

/// The shadows that a ball casts on the surface, by the point lights; other shapes have none drawn.
fn shadows(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    (on, ball): (PrimitiveId, PrimitiveId),
) {
    let scene = figure.scene;
    let (Shape::Polygon(ground), Shape::Sphere(ball)) =
        (&scene.primitive(on).shape, &scene.primitive(ball).shape)
    else {
        return;
    };
    for light in &scene.lights {
        let Some(rim) = shadow_rim(light.position, ball, &ground.plane()) else {
            continue;
        };
        let rim: Vec<DVec2> = rim.into_iter().map(|at| space.projection.of(at)).collect();
        let seen = rim.iter().map(|at| space.place_flat(*at));
        let seen: Vec<DVec2> = seen
            .map(|at| at.clamp(space.frame.min, space.frame.max))
            .collect();
        outline::rim(sheet, space, &Rim::Points(rim), Look::HIDDEN);
        if let Some(around) = Frame::around(seen) {
            // in what is seen of it, above the middle and to the right of it
            let middle = around.middle();
            let quarter = 0.25 * around.size();
            let room = Frame {
                min: middle + DVec2::new(quarter.x, -quarter.y),
                max: DVec2::new(around.max.x, middle.y),
            };
            sheet.label_in(room, "shadow");
        }
    }
}

/// Where the rays from a light that graze a ball arrive on a plane; `None` if one of them does not.
///
/// They touch it on a circle across the line from the light to the center at the distance d: d·cos²α away from the light, of
/// the radius r·cos α, where sin α = r/d.
fn shadow_rim(light: DVec3, ball: &Sphere, plane: &Plane) -> Option<Vec<DVec3>> {
    let to_center = ball.center - light;
    let distance = to_center.length();
    let sin = ball.radius / distance;
    if 1.0 <= sin {
        return None;
    }
    let cos = (1.0 - sin * sin).sqrt();
    let touched = disc::rim(
        light + cos * cos * to_center,
        to_center / distance,
        ball.radius * cos,
    );
    let on_plane = |at: DVec3| {
        let along = at - light;
        let t = -plane.distance(light) / plane.normal.dot(along);
        (0.0 < t && t.is_finite()).then(|| light + t * along)
    };
    touched.into_iter().map(on_plane).collect()
}

/// Below the photons that came through an object, its name.
fn through(sheet: &mut Sheet, space: &Space, points: &[DVec2], name: &str) {
    let seen = points.iter().filter(|at| space.frame.contains(**at));
    if let Some(around) = Frame::around(seen.copied()) {
        let below = DVec2::new(around.middle().x, around.max.y);
        let text = format!("light through {name}");
        sheet.label(space.frame, below, DVec2::Y, text);
    }
}

/// The working of the density, in lines.
fn numbers(gathering: &Gathering) -> Vec<String> {
    let near = gathering.nearby.len();
    let counted = gathering.gathered.count;
    let mut lines = vec![format!(
        "Nearest photons: number {near} sets r, and the {counted} before it are summed"
    )];
    lines.extend(gathering.working());
    lines
}

/// All photons on the surface that the shown paths have left.
fn stored(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    (gathering, stage): (&Gathering, StageId),
) {
    let sections = figure.first.paths();
    let mut through_glass = BTreeMap::new();
    for path in sections.iter().filter_map(LightPath::of) {
        for (place, leg) in path.legs.iter().enumerate() {
            let Some(photon) = leg.stored else {
                continue;
            };
            if photon.object != gathering.gathered.object {
                continue;
            }
            if let Some(object) = passed(figure, &path.legs[..place]) {
                let points: &mut Vec<DVec2> = through_glass.entry(object).or_default();
                points.push(space.place(photon.point));
            }
            sheet.at(stage, |sheet| {
                sheet.step(leg.step, |sheet| {
                    let radius = 2.0 * sheet.unit();
                    sheet.circle(PHOTON, space.place(photon.point), radius);
                });
            });
        }
    }
    sheet.at(stage, |sheet| {
        for (object, points) in &through_glass {
            let name = scenery::name_of(figure.scene, *object);
            through(sheet, space, points, &name);
        }
    });
}

/// The object that light has gone through, in at one surface and out at another.
fn passed(figure: &Figure, legs: &[Leg]) -> Option<PrimitiveId> {
    let [.., enters, leaves] = legs else {
        return None;
    };
    let object = leaves.end.object?;
    let passes = 0.0 < figure.scene.material_of(object).transmission;
    (passes && enters.end.object == Some(object)).then_some(object)
}

/// A photon.
const PHOTON: Look = Look {
    colour: Colour::Light,
    ..Look::THIN.inside().full()
};

/// The point, the photons around it and how far the last of them is.
fn photons(
    sheet: &mut Sheet,
    space: &Space,
    (gathering, radius): (&Gathering, f64),
    argument: &Argument,
) {
    let at = space.place(gathering.gathered.point);
    let counted = gathering.counted().len();
    sheet.at(argument.point, |sheet| {
        sheet.dot(Look::RAY, at);
        sheet.label(space.frame, at, DVec2::new(-1.0, 1.0), formula("p"));
    });
    for (place, (step, photon)) in gathering.nearby.iter().enumerate() {
        let to = space.place(photon.point);
        if place < counted {
            sheet.at(argument.nearest, |sheet| {
                sheet.step(*step, |sheet| sheet.circle(PHOTON, to, 4.0 * sheet.unit()));
            });
            continue;
        }
        sheet.at(argument.nearest, |sheet| {
            sheet.line(Look::HELP, at, to);
            sheet.ring(Look::REJECTED, to);
            let middle = at.lerp(to, 0.5);
            let across = (to - at).perp().normalize_or_zero();
            let text = formula("r = ") + quantity(radius);
            sheet.label(space.frame, middle, across, text);
            // a slide has room for few words: there the line above must do
            if sheet.width == Width::Book {
                let outwards = (to - at).normalize_or_zero();
                sheet.label(space.frame, to, outwards, "does not count");
            }
        });
    }
}
