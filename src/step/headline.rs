//! The title of a step: what it is about, and what became of it.

use crate::explain::name::{light_title, primitive_name, ray_title};
use crate::explain::{Part, Section, cell_name, grouped, printable};
use crate::scene::{PrimitiveId, Scene};
use crate::step::level::Level;
use crate::step::step::Step;
use crate::step::tree::StepLog;
use crate::step::verdict::Became;
use crate::trace::{Bounded, Event, Kind, Record, Verdict, Why};

/// The title of a step, in one line: `A: sphere: hit`, `7 379 spheres missed: 7 379 no root`.
pub fn headline(log: &StepLog, number: usize) -> String {
    let step = log.step(number);
    if step.is_fold() {
        return of_fold(log, step);
    }
    let what = subject(log, number);
    match step.became {
        None => what,
        Some(became) => format!("{what}: {}", became.text()),
    }
}

/// What a step is about, in one line without its verdict: `A: sphere`. A fold is named by its first member.
pub fn subject(log: &StepLog, number: usize) -> String {
    let step = log.step(number);
    let record = &log.records[step.lead];
    match step.level {
        Level::Section => of_section(record),
        Level::Ray => {
            let start = match &record.event {
                Event::Ray(start) => Some(start),
                _ => None,
            };
            let id = record.ray.unwrap_or_default();
            ray_title(log.scene, id, record.parent, start)
        }
        _ if step.is_leaf() && step.level == Level::Term => of_event(log.scene, record),
        _ => of_group(log.scene, record),
    }
}

fn of_section(record: &Record) -> String {
    match (Section::of(record), record.pixel) {
        (Section::Building, _) => "Building".into(),
        (Section::Path(path), _) => format!("Path {path} of light"),
        (Section::Pixel, Some([x, y])) => format!("Pixel ({x}, {y})"),
        (Section::Pixel, None) => "Pixel".into(),
    }
}

fn of_bound(scene: &Scene, of: Bounded) -> String {
    match of {
        Bounded::Node(node) => format!("node {node}"),
        Bounded::Object(object) => {
            let object = scene.objects.get(object as usize);
            object.map_or("an object".into(), |object| printable(&object.name))
        }
    }
}

/// A place or a test by the event that leads it.
fn of_group(scene: &Scene, record: &Record) -> String {
    let name = |object: PrimitiveId| primitive_name(scene, object);
    match record.event {
        Event::Merge(step) => format!("node {}", step.node),
        Event::Assign(step) => {
            format!("cells of {}", name(step.object))
        }
        Event::SlabRay(_) => format!("{} of each slab", Part::SlabRay),
        Event::SlabTest(test) => format!("{} of {}", Part::Bound, of_bound(scene, test.of)),
        Event::PlaneTest { object, .. } | Event::Edge { object, .. } => {
            format!("{}: polygon", name(object))
        }
        Event::Listed { object } => name(object),
        Event::ZSort(_) => Part::ZSort.to_string(),
        Event::Nearby(_) | Event::Gathered(_) => Part::Gathered.to_string(),
        Event::Alternative(_) => "connecting line".into(),
        _ => of_event(scene, record),
    }
}

/// A single event.
fn of_event(scene: &Scene, record: &Record) -> String {
    let name = |object: PrimitiveId| primitive_name(scene, object);
    let ray = record.ray.unwrap_or_default();
    match record.event {
        Event::Merge(step) => format!("slab {} of node {} and its child", step.slab, step.node),
        Event::Assign(step) => {
            let object = name(step.object);
            format!("cell {} lists {object}", cell_name(step.cell))
        }
        Event::Path(start) => format!("photon from {}", light_title(scene, start.light)),
        Event::Pixel(_) => Part::WindowPoint.to_string(),
        Event::Ray(_) => format!("start of ray {ray}"),
        Event::Align(_) => Part::Alignment.to_string(),
        Event::GridEnter(_) => Part::Grid.to_string(),
        Event::Queue(step) => format!("{}: {} node {}", Part::Heap, step.action.word(), step.node),
        Event::SlabRay(line) => format!("{} of slab {}", Part::SlabRay, line.slab),
        Event::SlabTest(test) => format!("slab {} of {}", test.step.slab, of_bound(scene, test.of)),
        Event::BoundTest(test) => format!("{} of {}", Part::Bound, of_bound(scene, test.of)),
        Event::Node(visit) => format!("node {}", visit.node),
        Event::Cell(visit) => format!("cell {}", cell_name(visit.step.cell)),
        Event::Listed { object } => format!("{} is listed", name(object)),
        Event::Mailbox { object } => format!("mailbox of {}", name(object)),
        Event::Aligned(point) => format!("{} of {}", Part::AlignedPoint, name(point.object)),
        Event::SphereTest { object, .. } => format!("{}: sphere", name(object)),
        Event::EllipsoidTest { object, .. } => format!("{}: ellipsoid", name(object)),
        Event::ConeTest { object, .. } => format!("{}: cone", name(object)),
        Event::BoxTest { object, .. } => format!("{}: box", name(object)),
        Event::PlaneTest { object, .. } => format!("{}: plane", name(object)),
        Event::Edge { object, edge } => format!("{}: edge {}", name(object), edge.index),
        Event::PolygonTest { object, .. } => format!("{}: inside or outside", name(object)),
        Event::Nearest(hit) => format!("{}: {}", Part::Nearest, name(hit.object)),
        Event::HitOutsideCell(hit) => format!("{}: {}", Part::HitOutside, name(hit.object)),
        Event::GridExit(_) => Part::WalkEnd.to_string(),
        Event::ZSort(sorted) => {
            format!(
                "place {} of the {}: {}",
                sorted.place,
                Part::ZSort,
                name(sorted.object)
            )
        }
        Event::Arrival(_) => Part::Arrival.to_string(),
        Event::Stored(stored) => format!("{} on {}", Part::Stored, name(stored.object)),
        Event::Nearby(photon) => format!("photon of path {}", photon.path),
        Event::Gathered(found) => format!("{} on {}", Part::Gathered, name(found.object)),
        Event::LightTerm(term) => light_title(scene, term.light),
        Event::Refraction(_) => Part::Snell.to_string(),
        Event::Photon(photon) => format!("{} on {}", Part::Roulette, name(photon.object)),
        Event::Alternative(edge) => format!("edge {} of the path", edge.edge),
        Event::Connection(_) => "connecting line".into(),
        Event::Shade(shade) => format!("shade of {}", name(shade.object)),
        Event::RayEnd(_) => format!("end of ray {ray}"),
        Event::PixelColour(_) => Part::PixelColour.to_string(),
    }
}

/// `7 379 spheres missed: 7 000 no root, 379 behind`
fn of_fold(log: &StepLog, fold: &Step) -> String {
    let count = grouped(fold.folded as u64);
    let many = many(log.records[fold.lead].event.kind(), fold.level);
    let became = match fold.became {
        None => "",
        Some(Became::Tested(Verdict::Hit, _)) => " hit",
        Some(Became::Tested(Verdict::Rejected, _)) => " missed",
        Some(Became::Counted(true)) => " count as crossings",
        Some(Became::Counted(false)) => " do not count",
        Some(Became::Saved) => " not tested again",
        Some(other) => &format!(": {}", other.text()),
    };
    let mut reasons: Vec<(Why, u64)> = Vec::new();
    for member in &log.steps()[fold.children.clone()] {
        if let Some(Became::Tested(_, Some(why))) = member.became {
            match reasons.iter_mut().find(|(known, _)| *known == why) {
                Some((_, number)) => *number += 1,
                None => reasons.push((why, 1)),
            }
        }
    }
    let reasons: Vec<String> = reasons
        .into_iter()
        .map(|(why, number)| format!("{} {}", grouped(number), spaced(why.word())))
        .collect();
    if reasons.is_empty() {
        format!("{count} {many}{became}")
    } else {
        format!("{count} {many}{became}: {}", reasons.join(", "))
    }
}

/// Several steps that are led by events of a kind.
fn many(kind: Kind, level: Level) -> String {
    let single = level == Level::Term;
    match kind {
        Kind::SphereTest => "spheres".into(),
        Kind::EllipsoidTest => "ellipsoids".into(),
        Kind::ConeTest => "cones".into(),
        Kind::BoxTest => "boxes".into(),
        Kind::PlaneTest | Kind::PolygonTest => "polygons".into(),
        Kind::BoundTest => "bounding volumes".into(),
        Kind::SlabTest => "slabs".into(),
        Kind::Edge | Kind::Alternative => "edges".into(),
        Kind::Mailbox => "objects".into(),
        Kind::Aligned => "aligned points".into(),
        Kind::Nearby => "photons".into(),
        Kind::ZSort => "hits in their order".into(),
        Kind::Merge if !single => "nodes joined".into(),
        Kind::Assign if !single => "objects on the lists of their cells".into(),
        Kind::Assign => "cells".into(),
        other => format!("steps {}", other.name()),
    }
}

impl Became {
    /// The words of the verdict.
    pub fn text(self) -> String {
        match self {
            Self::Tested(verdict, None) => verdict.word().into(),
            Self::Tested(verdict, Some(why)) => {
                format!("{}, {}", verdict.word(), spaced(why.word()))
            }
            Self::Saved => "not tested again".into(),
            Self::Counted(true) => "counts".into(),
            Self::Counted(false) => "does not count".into(),
            Self::Node(verdict) => verdict.word().into(),
            Self::Ray(verdict) => spaced(verdict.word()),
            Self::Photon(verdict) => verdict.word().into(),
            Self::Light(visibility) => spaced(visibility.word()),
        }
    }
}

/// A word of the log as people write it.
fn spaced(word: &str) -> String {
    word.replace('_', " ")
}
