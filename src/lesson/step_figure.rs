//! The figure of a step: the kind that shows where a reader stands in a log, drawn from that log up to the step.

use glam::DVec3;

use crate::explain::Section;
use crate::figure::{
    Drawn, DrawnUpTo, Far, FigureError, FigureKind, FigureSpec, Layer, Rendition, Strokes, Traced,
    UpTo, View, Width, around_rays, draw, strokes,
};
use crate::lesson::own_figure::{has_frame, view};
use crate::page::View as PixelView;
use crate::scene::PrimitiveId;
use crate::step::{Level, StepLog};
use crate::structure::VolumeKind;
use crate::trace::{Bounded, Event, OfPixels, Record, StrategyName};

/// Of so many objects the lists of the cells can be read.
const MOST_LISTED: usize = 8;

/// The figures of a log, step by step.
#[derive(Clone, Debug)]
pub struct StepFigures {
    traced: [Traced; 1],
    /// The direction of the first ray, and two corners of a box around what happens; without the window, and with it.
    around: Option<[(DVec3, [DVec3; 2]); 2]>,
}

/// A figure of a step, as it came out.
#[derive(Clone, Debug)]
pub struct StepFigure {
    /// What is drawn.
    pub spec: FigureSpec,
    /// The drawing up to the step.
    pub drawn: Drawn,
}

/// A figure of a step as lines, points and words.
#[derive(Clone, Debug)]
pub struct StepStrokes {
    /// What kind it is.
    pub kind: FigureKind,
    /// The drawing, whole.
    pub strokes: Strokes,
    /// What may show the step, what shows it best first.
    asked: Vec<FigureSpec>,
}

fn title_of(kind: FigureKind) -> &'static str {
    match kind {
        FigureKind::Grid => "Grid",
        FigureKind::Hierarchy => "Hierarchy",
        FigureKind::Heap => "Heap",
        FigureKind::Alignment => "Ray along the z axis",
        _ => "Paths of light",
    }
}

impl StepFigures {
    /// The figures of a log.
    pub fn new(log: &StepLog) -> Self {
        let traced = Traced {
            scene: log.scene.clone(),
            settings: log.settings.clone(),
            of_pixels: OfPixels::default(),
            records: log.records.to_vec(),
        };
        let around = around_rays(&traced);
        Self {
            traced: [traced],
            around,
        }
    }

    /// The figure that shows a step best, up to its last event. The id begins all ids in it.
    ///
    /// # Errors
    /// No kind of figure shows this step.
    pub fn draw(
        &self,
        log: &StepLog,
        step: usize,
        id: &str,
        (width, rendition): (Width, Rendition),
    ) -> Result<StepFigure, FigureError> {
        let mut first = None;
        for spec in self.specs(log, step) {
            let rendition = Rendition {
                up_to: self.up_to(log, step, spec.kind),
                ..rendition
            };
            match draw(&spec, &self.traced, id, width, rendition) {
                Ok(drawn) => return Ok(StepFigure { spec, drawn }),
                Err(error) => first = first.or(Some(error)),
            }
        }
        Err(none(first))
    }

    /// The same figure as lines, points and words, whole. `known` is the drawing of another step: if this one's is the same, it
    /// is given back.
    ///
    /// # Errors
    /// No kind of figure shows this step.
    pub fn strokes(
        &self,
        log: &StepLog,
        step: usize,
        known: Option<StepStrokes>,
    ) -> Result<StepStrokes, FigureError> {
        let asked = self.specs(log, step);
        if let Some(known) = known.filter(|known| known.asked == asked) {
            return Ok(known);
        }
        let mut first = None;
        for spec in &asked {
            match strokes(spec, &self.traced) {
                Ok(strokes) => {
                    return Ok(StepStrokes {
                        kind: spec.kind,
                        asked,
                        strokes,
                    });
                }
                Err(error) => first = first.or(Some(error)),
            }
        }
        Err(none(first))
    }

    /// Of a scene with more objects a page has one view: for each view all objects are looked at, and for the search its structure
    /// is built again, which takes longer than to load the scene.
    pub const MOST_FOR_ALL_VIEWS: usize = 100_000;

    /// What a page shows of a pixel, each as a whole: its rays from the side from where they are longest and in space, and the
    /// search of the strategy or the paths of light. What cannot be drawn is left out.
    pub fn views(&self, log: &StepLog) -> Vec<PixelView> {
        let pixel = log.sections().last();
        let Some(lead) = pixel.map(|pixel| &log.records[log.step(pixel).lead]) else {
            return Vec::new();
        };
        let search = usual(log.settings.strategy).or_else(|| {
            let has_paths = log.records.iter().any(|record| record.path.is_some());
            has_paths.then_some(FigureKind::Paths)
        });
        let wanted = [
            Some((FigureKind::Rays, None, "Rays")),
            Some((FigureKind::Rays, Some(View::Axonometric), "Rays in space")),
            search.map(|kind| (kind, None, title_of(kind))),
        ];
        let draw_view =
            |(place, (kind, from, title)): (usize, (FigureKind, Option<View>, &str))| {
                let mut spec = self.spec(log, kind, lead);
                spec.view = from.unwrap_or(spec.view);
                let id = format!("raystep-view-{place}");
                let drawn = draw(&spec, &self.traced, &id, Width::Book, Rendition::default());
                Some(PixelView {
                    title: title.to_owned(),
                    svg: drawn.ok()?.svg,
                    drawn: DrawnUpTo::new(kind, &self.traced[0]),
                })
            };
        let most = if Self::MOST_FOR_ALL_VIEWS < log.scene.primitives.len() {
            1
        } else {
            wanted.len()
        };
        let wanted = wanted.into_iter().flatten().take(most).enumerate();
        wanted.filter_map(draw_view).collect()
    }

    /// What may show a step, what shows it best first: the innermost test or place, then those around it.
    fn specs(&self, log: &StepLog, step: usize) -> Vec<FigureSpec> {
        let mut specs: Vec<FigureSpec> = Vec::new();
        let with_above = std::iter::once(step).chain(log.above(step));
        let shown = with_above.filter_map(|step| {
            let of = log.step(step);
            let lead = &log.records[of.lead];
            let is_wide = matches!(of.level, Level::Section | Level::Ray);
            let kind = if is_wide {
                wide(lead)
            } else {
                narrow(log, lead)
            };
            kind.map(|kind| (kind, lead))
        });
        let mut shown: Vec<_> = shown.collect();
        if let Some((_, lead)) = shown.first()
            && let Some(kind) = usual(log.settings.strategy)
            && Section::of(lead) == Section::Pixel
            && log.step(step).level != Level::Section
        {
            // the search as a whole shows more of a step than the rays alone
            let place = shown.iter().position(|(of, _)| *of == FigureKind::Rays);
            shown.insert(place.unwrap_or(shown.len()), (kind, *lead));
        }
        for (kind, lead) in shown {
            let spec = self.spec(log, kind, lead);
            if !specs.contains(&spec) {
                specs.push(spec);
            }
        }
        specs
    }

    fn spec(&self, log: &StepLog, kind: FigureKind, lead: &Record) -> FigureSpec {
        let settings = log.settings;
        let mut spec = FigureSpec::new(kind, "");
        let pixels = log.records.iter().rev();
        spec.pixel = pixels.clone().find_map(|record| record.pixel);
        spec.strategy = settings.strategy;
        spec.structure = settings.structure;
        spec.transport = settings.transport;
        spec.light = settings.light;
        spec.through = settings.through;
        spec.ray = lead.ray.filter(|_| lead.path.is_none());
        spec.object = object(log, kind, lead);
        // the names of more objects would lie over each other
        if kind == FigureKind::Partition && log.scene.primitives.len() <= MOST_LISTED {
            spec.show = vec![Layer::Objects, Layer::Names, Layer::Cells, Layer::Lists];
        }
        let with_window = usize::from(kind == FigureKind::Window);
        if let Some((direction, corners)) = self.around.map(|around| around[with_window]) {
            // the lists of cells are drawn across an axis
            let seen = if kind == FigureKind::Partition {
                FigureKind::Grid
            } else {
                kind
            };
            spec.view = view(seen, direction);
            spec.frame = has_frame(kind).then_some(corners.map(|corner| corner.to_array()));
        }
        spec
    }

    /// Up to the last event of a step.
    fn up_to(&self, log: &StepLog, step: usize, kind: FigureKind) -> Option<UpTo> {
        match self.far(log, log.step(step).events.end - 1, kind) {
            Far::Nothing => Some(UpTo::Step(0)),
            Far::Step(step) => Some(UpTo::Step(step)),
            Far::Whole => None,
        }
    }

    /// How far a figure is drawn when an event has happened.
    pub fn far(&self, log: &StepLog, event: usize, kind: FigureKind) -> Far {
        DrawnUpTo::new(kind, &self.traced[0]).after(&log.records[event])
    }
}

/// Nothing shows the step.
fn none(why: Option<FigureError>) -> FigureError {
    let why = why.map_or(String::new(), |error| format!(": {}", error.what));
    FigureError::new(
        "kind",
        format!("no figure shows this step{why}"),
        "choose a ray, a place or a test",
    )
}

/// What shows a section or a ray.
fn wide(lead: &Record) -> Option<FigureKind> {
    match Section::of(lead) {
        Section::Building => None,
        Section::Path(_) => Some(FigureKind::Paths),
        Section::Pixel => Some(FigureKind::Rays),
    }
}

/// What shows the search of a strategy.
fn usual(strategy: StrategyName) -> Option<FigureKind> {
    match strategy {
        StrategyName::Hierarchy => Some(FigureKind::Hierarchy),
        StrategyName::Heap => Some(FigureKind::Heap),
        StrategyName::Grid => Some(FigureKind::Grid),
        StrategyName::ZAligned => Some(FigureKind::Alignment),
        StrategyName::Exhaustive | StrategyName::Bounds => None,
    }
}

/// What shows a place, a test or a term by the event that leads it.
fn narrow(log: &StepLog, lead: &Record) -> Option<FigureKind> {
    use FigureKind as Kind;
    if Section::of(lead) == Section::Building {
        return match &lead.event {
            // a figure shows how the root was joined
            Event::Merge(merge) if merge.node == 0 => Some(Kind::Merge),
            Event::Assign(_) => Some(Kind::Partition),
            _ => None,
        };
    }
    if lead.path.is_some() {
        return Some(Kind::Paths);
    }
    let is_aligned = log.settings.strategy == StrategyName::ZAligned;
    match &lead.event {
        Event::Pixel(_) => Some(Kind::Window),
        Event::Align(_) | Event::Aligned(_) | Event::ZSort(_) => Some(Kind::Alignment),
        Event::SphereTest { .. } if is_aligned => Some(Kind::Alignment),
        Event::SphereTest { .. } => Some(Kind::Sphere),
        Event::PlaneTest { .. } | Event::Edge { .. } | Event::PolygonTest { .. } if is_aligned => {
            Some(Kind::Alignment)
        }
        Event::PlaneTest { object, .. }
        | Event::Edge { object, .. }
        | Event::PolygonTest { object, .. } => {
            // a figure names an object, which is the first face of a mesh
            let of = log.scene.primitive(*object).object;
            let first = log.scene.objects.get(of as usize)?.first;
            (first == *object).then_some(Kind::Polygon)
        }
        Event::SlabTest(test) => of_bound(log, test.of),
        Event::BoundTest(test) => of_bound(log, test.of),
        Event::SlabRay(_) => usual(log.settings.strategy).or(Some(Kind::Intervals)),
        Event::Node(_) | Event::Queue(_) => usual(log.settings.strategy),
        Event::GridEnter(_)
        | Event::Cell(_)
        | Event::Listed { .. }
        | Event::Mailbox { .. }
        | Event::HitOutsideCell(_)
        | Event::GridExit(_) => Some(Kind::Grid),
        Event::LightTerm(_) | Event::Shade(_) => Some(Kind::Shading),
        Event::Nearby(_) | Event::Gathered(_) => Some(Kind::Gather),
        Event::Alternative(_) | Event::Connection(_) => Some(Kind::Connections),
        _ => None,
    }
}

/// The bound of an object is shown with the ray's interval, that of a node in its tree.
fn of_bound(log: &StepLog, of: Bounded) -> Option<FigureKind> {
    match of {
        Bounded::Node(_) => usual(log.settings.strategy),
        Bounded::Object(_) if log.settings.structure.volume == VolumeKind::Slabs => {
            Some(FigureKind::Intervals)
        }
        Bounded::Object(_) => Some(FigureKind::Volumes),
    }
}

/// The object that a test is about, for the kinds that draw one.
fn object(log: &StepLog, kind: FigureKind, lead: &Record) -> Option<String> {
    let name = |object: usize| {
        let object = log.scene.objects.get(object);
        object.map(|object| object.name.to_string())
    };
    let whole = |id: PrimitiveId| name(log.scene.primitive(id).object as usize);
    match (kind, &lead.event) {
        (FigureKind::Sphere, Event::SphereTest { object, .. })
        | (
            FigureKind::Polygon,
            Event::PlaneTest { object, .. }
            | Event::Edge { object, .. }
            | Event::PolygonTest { object, .. },
        ) => whole(*object),
        (FigureKind::Intervals | FigureKind::Volumes, Event::SlabTest(test)) => match test.of {
            Bounded::Object(object) => name(object as usize),
            Bounded::Node(_) => None,
        },
        (FigureKind::Intervals | FigureKind::Volumes, Event::BoundTest(test)) => match test.of {
            Bounded::Object(object) => name(object as usize),
            Bounded::Node(_) => None,
        },
        _ => None,
    }
}
