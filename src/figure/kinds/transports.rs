//! The five kinds of ray tracing side by side: one scene, the rays of some pixels and some paths of light in each, and how many
//! rays the whole picture takes and wastes (slides, "Type of Ray Tracing Algorithm").

use glam::{DVec2, DVec3};

use crate::explain::grouped;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::light_path::{LightPath, Use, gathered_from};
use crate::figure::parts::percent::percent;
use crate::figure::parts::scenery;
use crate::figure::parts::transport_name::transport_name;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::{Figure, records_in};
use crate::figure::traced::Traced;
use crate::figure::view::Space;
use crate::trace::{Event, Purpose, RayNode, RayTree, RayVerdict, Transport};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 480.0,
    usual: &[
        Layer::Objects,
        Layer::Eye,
        Layer::Lights,
        Layer::LightPaths,
        Layer::Ray,
        Layer::Legend,
    ],
    more: &[],
};

/// Panels beside each other.
const COLUMNS: usize = 3;

/// What lines mean.
const LEGEND: [(Look, &str, Transport); 6] = [
    (Look::RAY, "ray from the eye", Transport::Backward),
    (Look::SHADOW_RAY, "shadow ray", Transport::HybridLight),
    (Look::LIGHT_RAY, "light that is seen", Transport::Forward),
    (
        Look::UNSEEN_LIGHT,
        "light that is stored",
        Transport::HybridStored,
    ),
    (
        Look::WASTED_LIGHT,
        "light that is wasted",
        Transport::Forward,
    ),
    (
        Look::CONNECTION,
        "connecting line",
        Transport::HybridConnected,
    ),
];

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let rows = figure.traced.len().div_ceil(COLUMNS).max(1) as f64;
    let gap = sheet.letters;
    let size = (body.size() - gap * DVec2::new(COLUMNS as f64 - 1.0, rows - 1.0))
        / DVec2::new(COLUMNS as f64, rows);
    let panel = |place: usize| {
        let at = DVec2::new((place % COLUMNS) as f64, (place / COLUMNS) as f64);
        let min = body.min + at * (size + gap);
        Frame {
            min,
            max: min + size,
        }
    };
    let mut sentences = Vec::new();
    let mut stages = Vec::new();
    for (place, traced) in figure.traced.iter().enumerate() {
        let totals = traced.of_pixels.totals.ok_or_else(|| {
            FigureError::new(
                "transports",
                "the log does not have the number of rays of the picture",
                "trace the figure again",
            )
        })?;
        let wasted = 1.0 - totals.contributed as f64 / totals.cast.max(1) as f64;
        let percent = format!("{} % wasted", percent(wasted));
        let of = transport_name(traced.settings.transport);
        let cast = grouped(totals.cast);
        let sentence = format!("{of}: {cast} rays cast, {percent}.");
        let stage = sheet.stage(of, None, sentence.as_str());
        sentences.push(sentence);
        stages.push((traced.settings.transport, stage));
        let what = match sheet.width {
            Width::Book => "rays cast,",
            Width::Slide => "rays,",
        };
        let texts = [of.to_owned(), format!("{cast} {what}"), percent];
        let frame = panel(place);
        let line = sheet.line_height();
        sheet.at(stage, |sheet| {
            for (row, text) in (0..).zip(&texts) {
                let at = frame.min + DVec2::new(0.0, (f64::from(row) + 0.5) * line);
                sheet.text(Anchor::Start, at, text.as_str());
            }
        });
        let [_, drawing] = frame.split_top((texts.len() as f64 + 0.3) * line);
        draw_panel(figure, sheet, traced, drawing, stage)?;
    }
    let rest = figure.traced.len() % COLUMNS;
    if figure.shows(Layer::Legend) && 0 < rest {
        legend(sheet, panel(figure.traced.len()), &stages);
    }
    Ok(sentences.join(" "))
}

/// What the looks mean, a line for each, in the place of a panel; each from the panel on that has it first.
fn legend(sheet: &mut Sheet, frame: Frame, stages: &[(Transport, StageId)]) {
    let line = sheet.line_height();
    let swatch = 2.0 * sheet.letters;
    for (row, (look, text, first)) in (0..).zip(LEGEND) {
        let at = frame.min + DVec2::new(0.0, (f64::from(row) + 1.0) * line);
        let end = at + DVec2::new(swatch, 0.0);
        let Some((_, stage)) = stages.iter().find(|(of, _)| *of == first) else {
            continue;
        };
        sheet.at(*stage, |sheet| {
            sheet.line(look, at, end);
            let text_at = end + DVec2::new(0.5 * sheet.letters, 0.0);
            sheet.text(Anchor::Start, text_at, text);
        });
    }
}

fn draw_panel(
    figure: &Figure,
    sheet: &mut Sheet,
    traced: &Traced,
    frame: Frame,
    stage: StageId,
) -> Result<(), FigureError> {
    let space = figure.space(frame, scenery::points_of(figure));
    scenery::objects(figure, sheet, &space, |_| Look::OBJECT);
    for light in &figure.scene.lights {
        let at = space.place(light.position);
        if space.frame.contains(at) {
            sheet.circle(Look::LIGHT_RAY, at, 5.0 * sheet.unit());
        }
    }
    let eye = space.place(figure.scene.camera.cop);
    sheet.dot(Look::RAY, eye);
    sheet.within(space.frame, |sheet| {
        sheet.at(stage, |sheet| rays(figure, sheet, &space, traced))
    })
}

/// The paths of light, then the rays of the pixels.
fn rays(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    traced: &Traced,
) -> Result<(), FigureError> {
    let mut records = Vec::new();
    for pixel in figure.pixels() {
        records.push(records_in(traced, pixel)?);
    }
    let surfaces = gathered_from(records.iter().copied().flatten());
    let connected: Vec<u32> = records
        .iter()
        .copied()
        .flatten()
        .filter_map(|record| match &record.event {
            Event::Connection(line) => Some(line.path),
            _ => None,
        })
        .collect();
    let is_connected = traced.settings.transport == Transport::HybridConnected;
    for section in traced.paths() {
        let Some(path) = LightPath::of(&section) else {
            continue;
        };
        let number = path.start.path;
        if is_connected && !connected.contains(&number) {
            continue;
        }
        let uses = path.uses(surfaces.get(&number).copied());
        for (leg, of) in path.legs.iter().zip(uses) {
            let look = match of {
                _ if is_connected => Look::LIGHT_RAY,
                Use::Seen => Look::LIGHT_RAY,
                Use::Stored => Look::UNSEEN_LIGHT,
                Use::Wasted => Look::WASTED_LIGHT,
            };
            let from = leg.start.ray.origin;
            let to = leg.arrival.map(|_| figure.scene.camera.cop);
            let to = to.or_else(|| end_of(space, &leg.start.ray, leg.end.t));
            if let Some(to) = to {
                stroke(sheet, space, look, from, to);
            }
        }
    }
    for records in records {
        let tree = RayTree::new(records);
        for node in &tree.rays {
            ray(sheet, space, node);
        }
    }
    Ok(())
}

fn ray(sheet: &mut Sheet, space: &Space, node: &RayNode) {
    let (Some(start), Some(end)) = (node.start, node.end) else {
        return;
    };
    if end.verdict == RayVerdict::DepthLimit {
        return;
    }
    let look = match start.purpose {
        Purpose::Shadow => Look::SHADOW_RAY,
        Purpose::Connection => Look::CONNECTION,
        Purpose::Light => return,
        _ => Look::RAY,
    };
    let t = end
        .t
        .or(start.range.max.is_finite().then_some(start.range.max));
    let Some(to) = end_of(space, &start.ray, t) else {
        return;
    };
    stroke(sheet, space, look, start.ray.origin, to);
    let is_blocked =
        matches!(start.purpose, Purpose::Shadow | Purpose::Connection) && end.t.is_some();
    if is_blocked {
        sheet.cross(Look::REJECTED, space.place(to));
    }
}

/// Where a ray ends: where it hits, or where it leaves the drawing.
fn end_of(space: &Space, ray: &crate::geometry::Ray, t: Option<f64>) -> Option<DVec3> {
    let t = t.or_else(|| space.leaves(ray))?;
    Some(ray.at(t))
}

fn stroke(sheet: &mut Sheet, space: &Space, look: Look, from: DVec3, to: DVec3) {
    let [from, to] = [from, to].map(|at| space.place(at));
    sheet.line(look.wide(0.8 * look.width), from, to);
}
