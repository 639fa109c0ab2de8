//! Paths of light in the scene: those that lead to the eye, by its aperture or by photons that it gathers, and those
//! that are wasted (slides, "Type of Ray Tracing Algorithm": forward, and hybrid with storage on surfaces).

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;

use crate::explain::grouped;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::disc;
use crate::figure::parts::gathering::Gathering;
use crate::figure::parts::light_path::{Leg, LightPath, Use, gathered_from};
use crate::figure::parts::outline::{self, Rim};
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::traced::Section;
use crate::figure::view::Space;
use crate::trace::{Purpose, RayTree, Transport};

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
    more: &[],
};

/// The paths that are shown, and what each leg of them is good for.
struct Shown<'a> {
    paths: Vec<(LightPath<'a>, Vec<Use>)>,
    /// What was gathered at the pixels, with their events.
    pixels: Vec<(Section<'a>, Vec<Gathering<'a>>)>,
    transport: Transport,
}

impl<'a> Shown<'a> {
    fn of(figure: &Figure<'a>) -> Result<Self, FigureError> {
        let mut pixels = Vec::new();
        let mut surfaces: BTreeMap<u32, u32> = BTreeMap::new();
        for pixel in figure.pixels() {
            let section = figure.section_of(pixel)?;
            for (path, surface) in gathered_from(section.records) {
                let last = surfaces.entry(path).or_default();
                *last = surface.max(*last);
            }
            pixels.push((section, Gathering::all(&section)));
        }
        let with_uses = |section: &Section<'a>| {
            let path = LightPath::of(section)?;
            let uses = path.uses(surfaces.get(&path.start.path).copied());
            Some((path, uses))
        };
        let sections = figure.first.paths();
        let paths: Vec<_> = sections.iter().filter_map(with_uses).collect();
        if paths.is_empty() {
            return Err(FigureError::new(
                "paths",
                "the log has no path of light",
                "add a \"transport\" that traces light, and show some paths: \"paths\": 20",
            ));
        }
        Ok(Self {
            paths,
            pixels,
            transport: figure.first.settings.transport,
        })
    }

    /// Of how many paths is this the best use? Their first legs lead to all that the others lead to.
    fn count(&self, of: Use) -> usize {
        let paths = self.paths.iter();
        paths.filter(|(_, uses)| uses.first() == Some(&of)).count()
    }

    /// How many paths there are, shown or not.
    fn all(&self) -> String {
        let first = self.paths.first();
        grouped(first.map_or(0, |(path, _)| path.start.paths.into()))
    }

    /// How many photons the shown paths have stored.
    fn stored(&self) -> usize {
        let legs = self.paths.iter().flat_map(|(path, _)| &path.legs);
        legs.filter(|leg| leg.stored.is_some()).count()
    }

    /// Which paths are shown: how many of all there are says nothing about how many reach the eye, since those that do
    /// are sought out.
    fn which(&self, figure: &Figure) -> String {
        let (of, all) = (self.paths.len() as u64, self.all());
        let first = figure.spec.paths.map_or(0, u64::from);
        match of.checked_sub(first) {
            Some(others) if 0 < first && 0 < others => format!(
                "The first {} of {all} paths of light, and {} more that arrive at the pixels shown",
                grouped(first),
                grouped(others)
            ),
            _ => format!("{} of {all} paths of light", grouped(of)),
        }
    }

    fn legend(&self, figure: &Figure) -> Vec<(Look, String)> {
        let words = |of: Use| match (of, self.transport) {
            (Use::Seen, Transport::HybridStored) => "stores one of the nearest photons",
            (Use::Seen, _) => "reaches the eye",
            (Use::Stored, _) => "stores another photon",
            (Use::Wasted, _) => "wasted",
        };
        let is_there = |of: &Use| self.paths.iter().any(|(_, uses)| uses.contains(of));
        let entry = |of: Use| match self.count(of) {
            // such legs are the ends of better paths
            0 => (look(of), words(of).to_owned()),
            count => (look(of), format!("{}: {count}", words(of))),
        };
        drawn(figure)
            .iter()
            .copied()
            .filter(is_there)
            .map(entry)
            .collect()
    }
}

/// Which legs are drawn.
fn drawn(figure: &Figure) -> &'static [Use] {
    if figure.spec.paths.is_some() {
        &[Use::Seen, Use::Stored, Use::Wasted]
    } else {
        // only what leads to the pixels was asked for
        &[Use::Seen]
    }
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
    let body = if figure.shows(Layer::Legend) {
        let entries = shown.legend(figure);
        let entries: Vec<(Look, &str)> = entries
            .iter()
            .map(|(look, text)| (*look, text.as_str()))
            .collect();
        sheet.legend(body, &entries)
    } else {
        body
    };
    let body = if figure.shows(Layer::Numbers) {
        numbers(figure, sheet, body, &shown)
    } else {
        body
    };
    let space = figure.space(body, scenery::points_of(figure));
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
        eye(figure, sheet, &space);
    }
    if figure.shows(Layer::Lights) {
        scenery::lights(figure, sheet, &space);
    }
    if figure.shows(Layer::LightPaths) {
        paths(figure, sheet, &space, &shown);
    }
    for (section, gatherings) in &shown.pixels {
        if figure.shows(Layer::Ray) {
            eye_rays(figure, sheet, &space, section);
        }
        if figure.shows(Layer::Hits) {
            for gathering in gatherings {
                disc_around(figure, sheet, &space, gathering);
            }
        }
    }
    Ok(in_words(figure, &shown))
}

/// What came of the paths, in lines at the top; gives back the frame that is left.
fn numbers(figure: &Figure, sheet: &mut Sheet, body: Frame, shown: &Shown) -> Frame {
    let all = shown.all();
    let of = grouped(shown.paths.len() as u64);
    let first = match shown.transport {
        Transport::HybridStored => format!(
            "Step 1: {of} of {all} paths of light, and the {} photons that they store",
            grouped(shown.stored() as u64)
        ),
        _ => shown.which(figure),
    };
    let mut lines = vec![(None, first)];
    for (_, gatherings) in &shown.pixels {
        for of in gatherings {
            let mut working = of.working();
            if let Some(first) = working.first_mut() {
                first.insert_str(0, "Step 2: the eye ray gathers ");
            }
            lines.extend(working.into_iter().map(|text| (Some(of.step), text)));
        }
    }
    for (place, (step, text)) in lines.iter().enumerate() {
        sheet.step(*step, |sheet| {
            let down = (place as f64 + 0.5) * sheet.line_height();
            let at = body.min + DVec2::new(0.0, down);
            sheet.text(Anchor::Start, at, text.as_str());
        });
    }
    let [_, rest] = body.split_top((lines.len() as f64 + 0.4) * sheet.line_height());
    rest
}

/// The eye with its aperture, where light must pass it.
fn eye(figure: &Figure, sheet: &mut Sheet, space: &Space) {
    let settings = &figure.first.settings;
    if settings.transport == Transport::Forward {
        let camera = &figure.scene.camera;
        let radius = settings.light.aperture_radius(camera);
        let rim = disc::rim(camera.cop, camera.window_normal(), radius);
        let rim: Vec<DVec2> = rim.iter().map(|at| space.projection.of(*at)).collect();
        let top = rim.iter().copied().max_by(|a, b| a.y.total_cmp(&b.y));
        outline::rim(sheet, space, &Rim::Points(rim), Look::VISITED.wide(3.0));
        let top = top.map(|top| space.place_flat(top));
        if let Some(top) = top.filter(|top| space.frame.contains(*top)) {
            sheet.label(space.frame, top, DVec2::NEG_Y, "aperture");
        }
    }
    scenery::eye(figure, sheet, space);
}

/// The legs of all paths with the photons at their ends.
fn paths(figure: &Figure, sheet: &mut Sheet, space: &Space, shown: &Shown) {
    for (path, uses) in &shown.paths {
        for (leg, of) in path.legs.iter().zip(uses) {
            if drawn(figure).contains(of) {
                sheet.step(leg.step, |sheet| {
                    draw_leg(figure, sheet, space, leg, *of);
                });
            }
        }
    }
}

fn draw_leg(figure: &Figure, sheet: &mut Sheet, space: &Space, leg: &Leg, of: Use) {
    let ray = &leg.start.ray;
    let end = match (leg.arrival, leg.end.t) {
        // it goes on behind the eye, where nobody looks
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
    let has_dot = leg.stored.is_some() && figure.shows(Layer::Hits);
    if is_seen && (has_dot || leg.arrival.is_some()) {
        // where it arrives
        let gap = if has_dot { 3.0 * sheet.unit() } else { 0.0 };
        let along = (to - from).normalize_or_zero();
        sheet.arrow(look(of), from, to - gap * along);
    } else {
        sheet.line(look(of), from, to);
    }
    if has_dot {
        let radius = if is_seen { 3.0 } else { 2.0 } * sheet.unit();
        sheet.circle(look(of).inside().full(), to, radius);
    }
}

/// The rays from the eye, and the rays that they spawned.
fn eye_rays(figure: &Figure, sheet: &mut Sheet, space: &Space, section: &Section) {
    let tree = RayTree::new(section.records);
    for node in &tree.rays {
        let (Some(start), Some(end), [_, Some(at)]) = (node.start, node.end, node.ends_at) else {
            continue;
        };
        let Some(t) = end.t.or_else(|| space.leaves(&start.ray)) else {
            continue;
        };
        let ends = [start.ray.origin, start.ray.at(t)].map(|of| space.place(of));
        let Some([from, to]) = space.frame.cut_line(ends) else {
            continue;
        };
        sheet.step(section.step(&section.records[at]), |sheet| {
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
                sheet.dot(Look::ANSWER, to);
            }
        });
    }
}

/// The disc around a point that holds its nearest photons.
fn disc_around(figure: &Figure, sheet: &mut Sheet, space: &Space, gathering: &Gathering) {
    let Some(rim) = gathering.disc(figure.scene) else {
        return;
    };
    sheet.step(gathering.step, |sheet| {
        let rim: Vec<DVec2> = rim.iter().map(|at| space.projection.of(*at)).collect();
        let [left, right] = ends_across(&rim).map(|at| space.place_flat(at));
        outline::rim(sheet, space, &Rim::Points(rim), Look::ANSWER.wide(5.0));
        let end = if left.x < right.x { right } else { left };
        if space.frame.contains(end) {
            let text = format!("disc of {} photons", gathering.gathered.count);
            sheet.label(space.frame, end, DVec2::ONE, text);
        }
    });
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
            sentences.push(format!(
                "{are} of them reach the eye, through a disc of radius {} around the COP; {} are wasted.",
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
