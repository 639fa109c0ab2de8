//! Paths of light in the scene: those that lead to the eye, by its aperture or by photons that it gathers, and those
//! that are wasted (slides, "Type of Ray Tracing Algorithm": forward, and hybrid with storage on surfaces).

mod argument;
mod shown;

use std::collections::BTreeSet;

use glam::DVec2;

use crate::explain::grouped;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::paths::argument::{Argument, aperture};
use crate::figure::kinds::paths::shown::Shown;
use crate::figure::parts::depth::hit_at;
use crate::figure::parts::disc;
use crate::figure::parts::gathering::Gathering;
use crate::figure::parts::light_path::{Leg, Use};
use crate::figure::parts::outline::{self, Rim};
use crate::figure::parts::percent::percent;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::traced::Section;
use crate::figure::view::Space;
use crate::geometry::{Ray, TRange};
use crate::scene::PrimitiveId;
use crate::trace::{Purpose, RayTree, Totals, Transport};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 440.0,
    usual: &[
        Layer::Objects,
        Layer::Names,
        Layer::Eye,
        Layer::Window,
        Layer::Lights,
        Layer::LightPaths,
        Layer::Ray,
        Layer::Hits,
        Layer::Legend,
        Layer::Numbers,
    ],
    more: &[Layer::ShadowRays, Layer::Normals],
};

/// Which legs are drawn: of stored light those that leave a photon, and if only what leads to the pixels was asked for, those
/// that do.
fn drawn(figure: &Figure) -> &'static [Use] {
    match (figure.spec.paths, figure.first.settings.transport) {
        (None, _) => &[Use::Seen],
        (Some(_), Transport::HybridStored) => &[Use::Seen, Use::Stored],
        (Some(_), _) => &[Use::Seen, Use::Stored, Use::Wasted],
    }
}

/// What the looks of the paths mean, each from the first path on that has it.
fn legend(
    figure: &Figure,
    shown: &Shown,
    argument: &Argument,
) -> Vec<(Option<StageId>, Look, &'static str)> {
    let words = |of: Use| match (of, shown.transport) {
        (Use::Seen, Transport::HybridStored) => "leads to a photon that is summed",
        (Use::Seen, _) => "reaches the eye",
        (Use::Stored, _) => "leads to another photon",
        (Use::Wasted, _) => "does not",
    };
    let since = |of: Use| {
        let mut parts = argument.paths.iter();
        parts.find_map(|(range, stage)| {
            let mut paths = shown.paths.get(range.clone())?.iter();
            paths.any(|(_, uses)| uses.contains(&of)).then_some(*stage)
        })
    };
    let uses = drawn(figure).iter().copied();
    uses.filter_map(|of| Some((Some(since(of)?), look(of), words(of))))
        .collect()
}

fn look(of: Use) -> Look {
    match of {
        Use::Seen => Look::LIGHT_RAY,
        Use::Stored => Look::UNSEEN_LIGHT,
        Use::Wasted => Look::WASTED_LIGHT,
    }
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let shown = Shown::of(figure)?;
    let argument = Argument::new(figure, sheet, &shown);
    let body = if figure.shows(Layer::Legend) {
        let entries = legend(figure, &shown, &argument);
        if entries.is_empty() {
            body
        } else {
            sheet.staged_legend(body, &entries)
        }
    } else {
        body
    };
    let body = if figure.shows(Layer::Numbers) {
        numbers(figure, sheet, body, (&shown, &argument))
    } else {
        body
    };
    // below the floor there is room for the width of a disc
    let below = match argument.nearest {
        Some(_) => 2.8 * sheet.letters,
        None => 0.0,
    };
    let [drawing, _] = body.split_top(body.size().y - below);
    let space = figure.space(drawing, scenery::points_of(figure));
    if figure.shows(Layer::Objects) {
        scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
    }
    if figure.shows(Layer::Names) {
        scenery::names(figure, sheet, &space);
    }
    if figure.shows(Layer::Window) {
        scenery::window(figure, sheet, &space);
    }
    if figure.shows(Layer::Eye) {
        eye(figure, sheet, &space, &shown);
    }
    if figure.shows(Layer::Lights) {
        scenery::lights(figure, sheet, &space);
    }
    if figure.shows(Layer::LightPaths) {
        paths(figure, sheet, &space, (&shown, &argument));
    }
    if figure.shows(Layer::Normals) {
        normal(figure, sheet, &space, (&shown, &argument));
    }
    for (section, gatherings) in &shown.pixels {
        if let Some(stage) = argument.eye.filter(|_| figure.shows(Layer::Ray)) {
            sheet.at(stage, |sheet| eye_rays(figure, sheet, &space, section));
        }
        if let Some(stage) = argument.nearest.filter(|_| figure.shows(Layer::Hits)) {
            sheet.at(stage, |sheet| {
                for gathering in gatherings {
                    disc_around(figure, sheet, (&space, body), gathering);
                }
            });
        }
        if figure.shows(Layer::ShadowRays) {
            sheet.at(argument.end, |sheet| {
                for gathering in gatherings {
                    to_the_lights(figure, sheet, &space, gathering);
                }
            });
        }
    }
    Ok(in_words(figure, &shown))
}

/// What came of the paths, in lines at the top; gives back the frame that is left.
fn numbers(
    figure: &Figure,
    sheet: &mut Sheet,
    body: Frame,
    (shown, argument): (&Shown, &Argument),
) -> Frame {
    let (first, drawn) = (shown.first(figure), shown.paths.len());
    let all = shown.all();
    let of_paths = match (shown.transport, drawn.checked_sub(first)) {
        (Transport::HybridStored, _) => format!(
            "Step 1: {} of {all} paths of light, and the {} photons that they store",
            grouped(drawn as u64),
            grouped(shown.stored() as u64)
        ),
        (_, Some(1..)) if 0 < first => format!("The first {first} of {all} paths of light"),
        _ => format!("{} of {all} paths of light", grouped(drawn as u64)),
    };
    let with_paths = argument
        .paths
        .first()
        .map_or(argument.end, |(_, stage)| *stage);
    let mut rest = sheet.at(with_paths, |sheet| sheet.lines(body, &[of_paths]));
    let mut at_end: Vec<Text> = Vec::new();
    if shown.transport == Transport::HybridStored {
        let gathered = shown.pixels.iter().flat_map(|(_, gatherings)| gatherings);
        for of in gathered {
            let start = Text::from(match sheet.width {
                Width::Book => "Step 2: the eye ray gathers ",
                Width::Slide => "Step 2: ",
            });
            let mut lines = of.lines().into_iter();
            at_end.extend(lines.next().map(|first| start + first));
            at_end.extend(lines);
        }
    } else {
        let seen = shown.count(Use::Seen);
        let sought = drawn.saturating_sub(first);
        let all = totals(figure).filter(|of| of.arrived == seen as u64 && seen == sought);
        at_end.push(if let Some(of) = all {
            let share = 1.0 - of.arrived as f64 / of.paths as f64;
            format!(
                "{} of all {} reach the eye, and are drawn too: {} % are wasted",
                grouped(of.arrived),
                grouped(of.paths),
                percent(share)
            )
            .into()
        } else if 0 < first && 0 < sought {
            let so = match seen - sought {
                0 => "None of them reaches the eye".to_owned(),
                1 => "One of them reaches the eye".to_owned(),
                several => format!("{several} of them reach the eye"),
            };
            format!("{so}. Drawn as well: {sought} of the others, which do.").into()
        } else {
            format!("{seen} of them reach the eye.").into()
        });
    }
    rest.min.y -= 0.4 * sheet.line_height();
    sheet.at(argument.end, |sheet| sheet.lines(rest, &at_end))
}

/// The numbers of all paths, if they were followed for the picture.
fn totals(figure: &Figure) -> Option<Totals> {
    figure.first.of_pixels.totals.filter(|of| 0 < of.paths)
}

/// The eye with its aperture, where light must pass it.
fn eye(figure: &Figure, sheet: &mut Sheet, space: &Space, shown: &Shown) {
    if let Some(radius) = aperture(figure, shown) {
        let camera = &figure.scene.camera;
        let rim = disc::rim(camera.cop, camera.window_normal(), radius);
        let rim: Vec<DVec2> = rim.iter().map(|at| space.projection.of(*at)).collect();
        let top = rim.iter().copied().max_by(|a, b| a.y.total_cmp(&b.y));
        outline::rim(sheet, space, &Rim::Points(rim), Look::THIN.wide(3.0));
        let top = top.map(|top| space.place_flat(top));
        if let Some(top) = top.filter(|top| space.frame.contains(*top)) {
            sheet.label(space.frame, top, DVec2::NEG_Y, "aperture");
        }
    }
    scenery::eye(figure, sheet, space);
}

/// The legs of all paths with the photons at their ends. Which photons are summed shows when that is known.
fn paths(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    (shown, argument): (&Shown, &Argument),
) {
    let gathers = shown.transport == Transport::HybridStored;
    for (range, stage) in &argument.paths {
        for (path, uses) in &shown.paths[range.clone()] {
            let Some(step) = path.legs.last().map(|leg| leg.step) else {
                continue;
            };
            for (leg, of) in path.legs.iter().zip(uses) {
                if !drawn(figure).contains(of) {
                    continue;
                }
                let first = if gathers { Use::Stored } else { *of };
                sheet.at(*stage, |sheet| {
                    // what became of a path is known at its end
                    sheet.step(step, |sheet| draw_leg(figure, sheet, space, leg, first));
                });
                if gathers && *of == Use::Seen {
                    sheet.at(argument.end, |sheet| {
                        draw_leg(figure, sheet, space, leg, *of);
                    });
                }
            }
        }
    }
}

/// The normal where the first path enters an object, on both sides of its surface.
fn normal(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    (shown, argument): (&Shown, &Argument),
) {
    /// How long a normal is, in sizes of letters.
    const LENGTH: f64 = 2.4;
    let (Some((path, _)), Some((_, stage))) = (shown.paths.first(), argument.paths.first()) else {
        return;
    };
    sheet.at(*stage, |sheet| {
        if let Some(leg) = path.legs.first()
            && let (Some(object), Some(t), None) = (leg.end.object, leg.end.t, leg.stored)
        {
            let point = leg.start.ray.at(t);
            let normal = figure
                .scene
                .primitive(object)
                .shape
                .normals(point)
                .geometric;
            let at = space.place(point);
            let reach = LENGTH * sheet.letters * space.direction(normal);
            sheet.line(Look::HELP, at, at - reach);
            sheet.arrow(Look::THIN.wide(1.25), at, at + reach);
            sheet.label(space.frame, at + reach, reach, formula("N"));
        }
    });
}

fn draw_leg(figure: &Figure, sheet: &mut Sheet, space: &Space, leg: &Leg, of: Use) {
    let ray = &leg.start.ray;
    let end = match (leg.arrival, leg.end.t) {
        // it goes on behind the eye, which the figure does not show
        (Some(arrival), _) => Some(arrival.aperture),
        (None, t) => t.map(|t| ray.at(t)),
    };
    let to = match end {
        Some(end) => space.place(end),
        None => match space.leaves(ray) {
            Some(t) => space.place(ray.at(t)),
            None => return,
        },
    };
    let Some([from, to]) = space.frame.cut_line([space.place(ray.origin), to]) else {
        return;
    };
    let is_seen = of == Use::Seen;
    if is_seen && figure.first.settings.transport == Transport::Forward {
        // in the middle: many end at the same place
        sheet.arrow(look(of), from, from.lerp(to, 0.55));
    }
    sheet.line(look(of), from, to);
    if leg.stored.is_some() && figure.shows(Layer::Hits) {
        let radius = if is_seen { 3.0 } else { 2.0 } * sheet.unit();
        sheet.circle(look(of).inside().full(), to, radius);
    }
}

/// The rays from the eye, and the rays that they spawned.
fn eye_rays(figure: &Figure, sheet: &mut Sheet, space: &Space, section: &Section) {
    let tree = RayTree::new(section.records);
    for node in &tree.rays {
        let (Some(start), Some(end)) = (node.start, node.end) else {
            continue;
        };
        let Some(t) = end.t.or_else(|| space.leaves(&start.ray)) else {
            continue;
        };
        let ends = [start.ray.origin, start.ray.at(t)].map(|of| space.place(of));
        let Some([from, to]) = space.frame.cut_line(ends) else {
            continue;
        };
        let look = match start.purpose {
            Purpose::Eye => Look::RAY,
            Purpose::Refracted => Look::REFRACTED_RAY,
            _ => Look::REFLECTED_RAY,
        };
        sheet.arrow(look, from, to);
        if start.purpose == Purpose::Eye {
            let across = (to - from).perp().normalize_or_zero();
            let up = if 0.0 < across.y { -across } else { across };
            sheet.label(space.frame, from.lerp(to, 0.45), up, "eye ray");
        }
        if figure.shows(Layer::Hits) && end.t.is_some() {
            sheet.dot(Look::RAY, to);
        }
    }
}

/// The disc around a point that holds its nearest photons, and how wide it is.
fn disc_around(
    figure: &Figure,
    sheet: &mut Sheet,
    (space, body): (&Space, Frame),
    gathering: &Gathering,
) {
    let (Some(rim), Some(radius)) = (gathering.disc(figure.scene), gathering.gathered.radius)
    else {
        return;
    };
    let rim: Vec<DVec2> = rim.iter().map(|at| space.projection.of(*at)).collect();
    let [left, right] = ends_across(&rim).map(|at| space.place_flat(at));
    outline::rim(sheet, space, &Rim::Points(rim), Look::ANSWER.wide(4.0));
    let below = DVec2::new(0.0, 1.1 * sheet.letters);
    let ends = [left + below, right + below];
    // the disc from its edge: a bracket below it says how wide it is
    for (end, at) in ends.into_iter().zip([left, right]) {
        sheet.line(Look::THIN.wide(0.75), at, end + 0.3 * below);
    }
    sheet.line(Look::THIN.wide(0.75), ends[0], ends[1]);
    let middle = ends[0].midpoint(ends[1]);
    if body.contains(middle) {
        let text = formula("2r = ") + quantity(2.0 * radius);
        sheet.label(body, middle, DVec2::Y, text);
    }
}

/// What a shadow ray from the point would meet: no such ray is cast here, since light was stored.
fn to_the_lights(figure: &Figure, sheet: &mut Sheet, space: &Space, gathering: &Gathering) {
    /// Of the way to the light: the surface itself does not count.
    const START: f64 = 1e-6;
    let point = gathering.gathered.point;
    for light in &figure.scene.lights {
        let ray = Ray::new(point, light.position - point);
        let range = TRange {
            min: START,
            max: 1.0,
        };
        let primitives = (0..).map(PrimitiveId).zip(&figure.scene.primitives);
        let met = primitives.filter_map(|(id, of)| Some((id, hit_at(of, &ray, range)?)));
        let blocker = met.min_by(|(_, a), (_, b)| a.total_cmp(b));
        let [from, to] = [0.0, blocker.map_or(1.0, |(_, t)| t)].map(|t| space.place(ray.at(t)));
        sheet.line(Look::SHADOW_RAY.in_front(), from, to);
        if let Some((object, _)) = blocker {
            sheet.cross(Look::REJECTED, to);
            let name = scenery::name_of(figure.scene, object);
            let text = format!("a shadow ray would meet the {name}");
            sheet.label(space.frame, from.lerp(to, 0.5), DVec2::X, text);
        }
    }
}

/// The two points that are farthest apart to the right and to the left.
fn ends_across(rim: &[DVec2]) -> [DVec2; 2] {
    let first = rim.first().copied().unwrap_or_default();
    rim.iter().fold([first; 2], |[left, right], &at| {
        [
            if at.x < left.x { at } else { left },
            if right.x < at.x { at } else { right },
        ]
    })
}

fn in_words(figure: &Figure, shown: &Shown) -> String {
    let (of, are) = (shown.paths.len(), shown.count(Use::Seen));
    let mut sentences = vec![format!(
        "Of {} paths of light {} are shown.",
        shown.all(),
        grouped(of as u64)
    )];
    match shown.transport {
        Transport::Forward => {
            let radius = figure
                .first
                .settings
                .light
                .aperture_radius(&figure.scene.camera);
            let mut through = BTreeSet::new();
            let legs = shown.paths.iter().flat_map(|(path, _)| &path.legs);
            through.extend(legs.filter_map(|leg| Some(leg.arrival?.pixel)));
            let through: Vec<String> = through.iter().map(|[x, y]| format!("({x}, {y})")).collect();
            sentences.extend(totals(figure).map(|of| {
                let share = 1.0 - of.arrived as f64 / of.paths as f64;
                format!(
                    "Of all {} reach the eye: {} % are wasted.",
                    grouped(of.arrived),
                    percent(share)
                )
            }));
            sentences.push(format!(
                "{are} of those shown reach the eye, through a disc of radius {} around the COP; {} are wasted.",
                quantity(radius),
                of - are
            ));
            if !through.is_empty() {
                sentences.push(format!("They arrive at the pixels {}.", through.join(", ")));
            }
        }
        _ => {
            let stored = grouped(shown.stored() as u64);
            sentences.push(format!("They store {stored} photons on surfaces."));
            for (_, gatherings) in &shown.pixels {
                sentences.extend(gatherings.iter().map(|of| gathered_in_words(figure, of)));
            }
        }
    }
    sentences.join(" ")
}

/// What was gathered at a point.
fn gathered_in_words(figure: &Figure, gathering: &Gathering) -> String {
    let object = scenery::name_of(figure.scene, gathering.gathered.object);
    let within = gathering
        .gathered
        .radius
        .map_or(String::new(), |r| format!(" within {}", quantity(r)));
    format!(
        "An eye ray hits {object}; there {} photons are summed{within}: {}.",
        gathering.gathered.count,
        gathering.working().join(" ")
    )
}
