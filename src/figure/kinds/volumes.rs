//! Bounding volumes around the same object, and what they waste: the space between object and volume, and the rays
//! that hit the volume and miss the object (slides, "Optimizing Intersection Calculations").
//!
//! Of a mesh the hull of its outline counts as the object.

use glam::DVec2;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::hatch;
use crate::figure::parts::outline::{self, Outline, Rim, hull};
use crate::figure::parts::scenery;
use crate::figure::parts::volume_outline;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::{Dash, Look};
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::spec::Layer;
use crate::figure::subject::{DrawnRay, Figure, records_in};
use crate::figure::traced::Traced;
use crate::figure::view::{Projection, Space};
use crate::geometry::Ray;
use crate::scene::{Object, Scene, Shape};
use crate::structure::VolumeKind;
use crate::trace::{BoundTest, BoundVerdict, Bounded, Event, StrategyName};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 480.0,
    usual: &[Layer::Ray, Layer::Legend],
    more: &[],
};

/// What became of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verdict {
    /// It hits the volume and the object.
    Hit,
    /// It hits the volume and misses the object: the test of the object is wasted.
    Wasted,
    /// It misses the volume: the object is not tested.
    Rejected,
}

impl Verdict {
    const ALL: [Self; 3] = [Self::Hit, Self::Wasted, Self::Rejected];

    fn look(self) -> Look {
        match self {
            Self::Hit => Look::ANSWER.outline(),
            Self::Wasted => Look::REJECTED.outline(),
            Self::Rejected => Look::CULLED,
        }
    }

    fn words(self) -> &'static str {
        match self {
            Self::Hit => "object hit",
            Self::Wasted => "wasted test",
            Self::Rejected => "volume missed",
        }
    }
}

/// A ray and its test against a volume.
struct Tested {
    ray: Ray,
    bound: BoundTest,
    verdict: Verdict,
    /// Where the object was hit.
    t: Option<f64>,
    /// The step of the volume's test.
    step: u32,
}

/// A volume with its rays.
struct Panel {
    kind: VolumeKind,
    volume: Outline,
    rays: Vec<Tested>,
    /// How much of the volume's outline the object leaves empty.
    wasted: f64,
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let number = bounded_object(figure)?;
    let object = &figure.scene.objects[number];
    let projection = figure.projection();
    let rim = rim_of(figure.scene, object, &projection);
    let panels = figure.traced.iter();
    let panels = panels.map(|traced| panel(figure, traced, number, &rim));
    let panels = panels.collect::<Result<Vec<_>, _>>()?;

    let body = if figure.shows(Layer::Legend) && figure.shows(Layer::Ray) {
        let is_there = |verdict: &Verdict| {
            let mut rays = panels.iter().flat_map(|panel| &panel.rays);
            rays.any(|ray| ray.verdict == *verdict)
        };
        let entries = Verdict::ALL.into_iter().filter(is_there);
        let entries: Vec<(Look, &str)> = entries
            .map(|verdict| (verdict.look(), verdict.words()))
            .collect();
        sheet.legend(body, &entries)
    } else {
        body
    };
    let shown = panels.iter().flat_map(|panel| panel.volume.rim.points());
    let shown: Vec<DVec2> = shown.collect();
    for (panel, frame) in panels.iter().zip(frames(sheet, body, panels.len())) {
        let [title, frame] = frame.split_top(sheet.line_height());
        let space = match figure.spec.frame {
            Some(_) => figure.space(frame, []),
            None => Space::fitted_flat(projection, frame, shown.iter().copied()),
        };
        let place = DVec2::new(title.middle().x, title.middle().y);
        sheet.text(Anchor::Middle, place, title_of(figure, panel));
        draw_panel(figure, sheet, &space, panel, &rim);
    }
    let name = scenery::short(&object.name);
    let sentences = panels.iter().map(|panel| in_words(figure, panel));
    let sentences: Vec<String> = sentences.collect();
    Ok(format!("Volumes around {name}: {}.", sentences.join("; ")))
}

/// The object that the specification names, or the first one whose volume is tested.
fn bounded_object(figure: &Figure) -> Result<usize, FigureError> {
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
fn rim_of(scene: &Scene, object: &Object, projection: &Projection) -> Rim {
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
fn panel(figure: &Figure, traced: &Traced, number: usize, rim: &Rim) -> Result<Panel, FigureError> {
    if traced.settings.strategy != StrategyName::Bounds {
        return Err(no_volumes());
    }
    let volume = volume_outline::around_object(figure, traced, number)?;
    let mut rays = Vec::new();
    for pixel in figure.pixels() {
        let records = records_in(traced, pixel)?;
        let ray = DrawnRay::find(records, figure.spec.ray.unwrap_or(0))?;
        rays.push(tested(figure.scene, &ray, number).ok_or_else(no_volumes)?);
    }
    Ok(Panel {
        kind: traced.settings.structure.volume,
        wasted: wasted(&volume.rim, rim),
        volume,
        rays,
    })
}

/// The share of a volume's outline that the object in it leaves empty; nothing of nothing.
fn wasted(volume: &Rim, object: &Rim) -> f64 {
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
            Event::Nearest(nearest) if of_object(nearest.object) => Some(nearest.t),
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
        t: nearest,
        step,
    })
}

/// Frames for a number of panels: one above the other if there is one or two, else two beside each other.
fn frames(sheet: &Sheet, body: Frame, count: usize) -> Vec<Frame> {
    let rows = count.div_ceil(2).max(1);
    let gap = sheet.letters;
    let height = (body.size().y - gap * (rows as f64 - 1.0)) / rows as f64;
    let mut frames = Vec::new();
    let mut rest = body;
    for row in 0..rows {
        let [line, below] = rest.split_top(height);
        rest = Frame {
            min: below.min + DVec2::new(0.0, gap),
            ..below
        };
        if 2 * row + 1 == count {
            frames.push(line);
        } else {
            frames.extend(line.split(0.5, 2.0 * gap));
        }
    }
    frames
}

fn name(kind: VolumeKind) -> &'static str {
    match kind {
        VolumeKind::Sphere => "sphere",
        VolumeKind::Ellipsoid => "ellipsoid",
        VolumeKind::Box => "rectangular solid",
        VolumeKind::Slabs => "slabs",
    }
}

/// The share that is wasted, in whole percent.
fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}

fn rays(count: usize) -> String {
    match count {
        1 => "1 ray".into(),
        _ => format!("{count} rays"),
    }
}

fn title_of(figure: &Figure, panel: &Panel) -> String {
    let mut title = format!("{}: {} empty", name(panel.kind), percent(panel.wasted));
    if figure.shows(Layer::Ray) {
        let wasted_tests = panel
            .rays
            .iter()
            .filter(|ray| ray.verdict == Verdict::Wasted);
        title = match wasted_tests.count() {
            1 => format!("{title}, 1 wasted test"),
            count => format!("{title}, {count} wasted tests"),
        };
    }
    title
}

fn draw_panel(figure: &Figure, sheet: &mut Sheet, space: &Space, panel: &Panel, object: &Rim) {
    let seen = |rim: &Rim| {
        let points = rim.points().into_iter().map(|p| space.place_flat(p));
        space.frame.cut_polygon(&points.collect::<Vec<_>>())
    };
    hatch::between(
        sheet,
        Look::THIN.wide(0.5),
        &[seen(&panel.volume.rim), seen(object)],
    );
    outline::draw(sheet, space, &panel.volume, Look::VISITED.outline());
    outline::rim(sheet, space, object, Look::OBJECT.wide(1.5));
    if !figure.shows(Layer::Ray) {
        return;
    }
    sheet.within(space.frame, |sheet| {
        for tested in &panel.rays {
            let place = |t: f64| space.place(tested.ray.at(t));
            let Some(edge) = space.leaves(&tested.ray) else {
                continue;
            };
            let to = place(tested.t.unwrap_or(edge));
            sheet.step(tested.step, |sheet| {
                sheet.arrow(tested.verdict.look(), place(0.0), to);
                if let (Verdict::Wasted, Some([near, far])) = (tested.verdict, tested.bound.inside)
                {
                    let solid = Look {
                        dash: Dash::Solid,
                        ..tested.verdict.look()
                    };
                    sheet.line(solid.wide(3.5), place(near), place(far));
                }
                if tested.verdict == Verdict::Hit {
                    sheet.dot(Look::ANSWER, to);
                }
            });
        }
    });
}

/// One volume in words.
fn in_words(figure: &Figure, panel: &Panel) -> String {
    let empty = percent(panel.wasted);
    let mut sentence = format!("{}, {empty} of its outline empty", name(panel.kind));
    if figure.shows(Layer::Ray) {
        for verdict in Verdict::ALL {
            let count = panel
                .rays
                .iter()
                .filter(|ray| ray.verdict == verdict)
                .count();
            if 0 < count {
                sentence = format!("{sentence}, {}: {}", verdict.words(), rays(count));
            }
        }
    }
    sentence
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::parts::volume_outline::around;
    use crate::figure::sheet::Width;
    use crate::scene::{NoFiles, load_bytes};
    use crate::structure::SlabSet;

    /// A square prism of the side 2 and the height 4, upright.
    fn scene() -> Scene {
        let json = r#"{"camera":{"look_at":{"cop":[0,0,9],"target":[0,0,0],"up":[0,1,0],"fov_degrees":40},
            "pixels":[2,2]},"materials":{"m":{"colour":[1,1,1]}},
            "objects":[{"name":"A","material":"m","shape":{"box":{"min":[-1,-2,-1],"max":[1,2,1]}}}]}"#;
        let loaded = load_bytes("scene.json", json.as_bytes(), &NoFiles).unwrap();
        loaded.build().unwrap()
    }

    /// The share of its volume's outline that the prism leaves empty, seen from the front.
    #[track_caller]
    fn check(kind: VolumeKind, expected: f64) {
        let scene = scene();
        let projection = Projection::new(glam::DVec3::X, glam::DVec3::Y);
        let object = rim_of(&scene, &scene.objects[0], &projection);
        let volume = around(&scene, 0, kind, &SlabSet::AXES, &projection);
        let found = wasted(&volume.rim, &object);
        assert!((found - expected).abs() < 1e-8, "{kind:?}: {found}");
    }

    #[test]
    fn the_share_that_is_empty_is_that_of_areas_in_the_view() {
        use std::f64::consts::PI;
        // 2 × 4 = 8 of a circle with the radius √(1 + 4 + 1)
        check(VolumeKind::Sphere, 1.0 - 8.0 / (6.0 * PI));
        // of an ellipse with the half axes √3 and 2√3
        check(VolumeKind::Ellipsoid, 1.0 - 8.0 / (6.0 * PI));
        check(VolumeKind::Box, 0.0);
        check(VolumeKind::Slabs, 0.0);
    }

    #[test]
    fn panels_stand_in_rows_of_two_and_the_last_may_be_alone() {
        let sheet = Sheet::new(Width::Book, 400.0);
        let body = sheet.body();
        for (count, rows) in [(1, 1.0), (2, 1.0), (3, 2.0), (4, 2.0)] {
            let frames = frames(&sheet, body, count);
            assert_eq!(frames.len(), count);
            let height = (body.size().y - sheet.letters * (rows - 1.0)) / rows;
            for (i, frame) in frames.iter().enumerate() {
                assert!((frame.size().y - height).abs() < 1e-9, "{count}");
                assert!(body.wider(1e-9).holds(*frame), "{count}: {frame:?}");
                for other in &frames[..i] {
                    assert_eq!(frame.shared_area(*other), 0.0);
                }
            }
        }
    }
}
