//! What is drawn of a volume: its outline, and its rays with what became of them.

use crate::figure::error::FigureError;
use crate::figure::parts::outline::{Outline, Rim, hull};
use crate::figure::parts::volume_outline;
use crate::figure::sheet::look::Look;
use crate::figure::subject::{DrawnRay, Figure, records_in};
use crate::figure::traced::Traced;
use crate::figure::view::Projection;
use crate::geometry::Ray;
use crate::scene::{Object, Scene, Shape};
use crate::structure::VolumeKind;
use crate::trace::{BoundTest, BoundVerdict, Bounded, Event, StrategyName};

/// What became of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    /// It hits the volume and the object.
    Hit,
    /// It hits the volume and misses the object: the test of the object is wasted.
    Wasted,
    /// It misses the volume: the object is not tested.
    Rejected,
}

impl Verdict {
    pub(super) const ALL: [Self; 3] = [Self::Hit, Self::Wasted, Self::Rejected];

    pub(super) fn look(self) -> Look {
        match self {
            Self::Hit => Look::ANSWER.outline(),
            Self::Wasted => Look::REJECTED.outline(),
            Self::Rejected => Look::CULLED,
        }
    }

    pub(super) fn words(self) -> &'static str {
        match self {
            Self::Hit => "object hit",
            Self::Wasted => "wasted test",
            Self::Rejected => "volume missed",
        }
    }
}

/// A ray and its test against a volume.
pub(super) struct Tested {
    pub(super) ray: Ray,
    pub(super) bound: BoundTest,
    pub(super) verdict: Verdict,
    /// Where the object was hit.
    pub(super) t: Option<f64>,
    /// The step at which it starts, if the trace has it.
    pub(super) starts: Option<u32>,
    /// The step at which its verdict is known.
    pub(super) step: u32,
}

/// A volume with its rays.
pub(super) struct Panel {
    pub(super) kind: VolumeKind,
    pub(super) volume: Outline,
    pub(super) rays: Vec<Tested>,
    /// How much of the volume's outline the object leaves empty.
    pub(super) wasted: f64,
}

/// The object that the specification names, or the first one whose volume is tested.
pub(super) fn bounded_object(figure: &Figure) -> Result<usize, FigureError> {
    if let Some(id) = figure.object()? {
        return Ok(figure.scene.primitive(id).object as usize);
    }
    let first = figure
        .records()?
        .iter()
        .find_map(|record| match record.event {
            Event::BoundTest(BoundTest {
                of: Bounded::Object(number),
                ..
            }) => Some(number as usize),
            _ => None,
        });
    first.ok_or_else(no_volumes)
}

fn no_volumes() -> FigureError {
    FigureError::new(
        "strategy",
        "this ray is tested against no volume around an object",
        "add \"strategy\": \"bounds\"",
    )
}

/// The outline of an object as one closed line.
pub(super) fn rim_of(scene: &Scene, object: &Object, projection: &Projection) -> Rim {
    let first = object.first.0 as usize;
    let primitives = &scene.primitives[first..first + object.count as usize];
    let outline = |shape: &Shape| Outline::of(shape, projection).rim;
    match primitives {
        [only] => outline(&only.shape),
        faces => {
            let points = faces.iter().flat_map(|face| outline(&face.shape).points());
            Rim::Points(hull(points.collect()))
        }
    }
}

/// What is drawn of one volume.
pub(super) fn panel(
    figure: &Figure,
    traced: &Traced,
    number: usize,
    rim: &Rim,
) -> Result<Panel, FigureError> {
    if traced.settings.strategy != StrategyName::Bounds {
        return Err(no_volumes());
    }
    let volume = volume_outline::around_object(figure, traced, number)?;
    let mut rays = Vec::new();
    for pixel in figure.pixels() {
        let records = records_in(traced, pixel)?;
        let ray = DrawnRay::find(records, figure.spec.ray.unwrap_or(0))?;
        let starts = ray.node.ends_at[0].and_then(|at| Some(records.get(at)?.step));
        let tested = tested(figure.scene, &ray, number).ok_or_else(no_volumes)?;
        rays.push(Tested { starts, ..tested });
    }
    Ok(Panel {
        kind: traced.settings.structure.volume,
        wasted: wasted(&volume.rim, rim),
        volume,
        rays,
    })
}

/// The share of a volume's outline that the object in it leaves empty; nothing of nothing.
pub(super) fn wasted(volume: &Rim, object: &Rim) -> f64 {
    let area = volume.area();
    if 0.0 < area {
        1.0 - object.area() / area
    } else {
        0.0
    }
}

/// What became of a ray at the volume around an object; `None` if it was not tested.
fn tested(scene: &Scene, ray: &DrawnRay, number: usize) -> Option<Tested> {
    let start = ray.node.start?;
    let (bound, step) = ray.events.iter().find_map(|record| match record.event {
        Event::BoundTest(bound) if bound.of == Bounded::Object(number as u32) => {
            Some((bound, record.step))
        }
        _ => None,
    })?;
    let of_object = |id| scene.primitive(id).object as usize == number;
    // the hit of this object, whatever lies before it later
    let nearest = ray
        .events
        .iter()
        .rev()
        .find_map(|record| match record.event {
            Event::Nearest(nearest) if of_object(nearest.object) => Some((nearest.t, record.step)),
            _ => None,
        });
    let verdict = match (bound.verdict, nearest) {
        (BoundVerdict::Hit, Some(_)) => Verdict::Hit,
        (BoundVerdict::Hit, None) => Verdict::Wasted,
        _ => Verdict::Rejected,
    };
    Some(Tested {
        ray: start.ray,
        bound,
        verdict,
        t: nearest.map(|(t, _)| t),
        starts: None,
        // a hit is known behind the test of the volume
        step: nearest.map_or(step, |(_, of_hit)| step.max(of_hit)),
    })
}

pub(super) fn name(kind: VolumeKind) -> &'static str {
    match kind {
        VolumeKind::Sphere => "sphere",
        VolumeKind::Ellipsoid => "ellipsoid",
        VolumeKind::Box => "rectangular solid",
        VolumeKind::Slabs => "slabs",
    }
}

/// The share that is wasted, in whole percent.
pub(super) fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}

impl Panel {
    /// How many rays hit the volume and miss the object.
    pub(super) fn wasted_tests(&self) -> usize {
        let is_wasted = |ray: &&Tested| ray.verdict == Verdict::Wasted;
        self.rays.iter().filter(is_wasted).count()
    }
}
