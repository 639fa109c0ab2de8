//! Bounding volumes around the same object, and what they waste: the space between object and volume, and the rays
//! that hit the volume and miss the object (slides, "Optimizing Intersection Calculations").
//!
//! Of a mesh the hull of its outline counts as the object.

mod argument;
mod panel;

use glam::DVec2;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::volumes::argument::{Argument, Rays};
use crate::figure::kinds::volumes::panel::{
    Panel, Tested, Verdict, bounded_object, name, panel, percent, rim_of,
};
use crate::figure::parts::hatch;
use crate::figure::parts::outline::{self, Rim};
use crate::figure::parts::scenery;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::{Dash, Look};
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::Space;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 480.0,
    usual: &[Layer::Ray, Layer::Legend],
    more: &[],
};

/// The part of a ray inside a volume in which it meets no object.
const IN_VAIN: Look = Look {
    dash: Dash::Solid,
    ..Look::REJECTED.outline().wide(3.5)
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let number = bounded_object(figure)?;
    let object = &figure.scene.objects[number];
    let projection = figure.projection();
    let rim = rim_of(figure.scene, object, &projection);
    let panels = figure.traced.iter();
    let panels = panels.map(|traced| panel(figure, traced, number, &rim));
    let panels = panels.collect::<Result<Vec<_>, _>>()?;
    let of = scenery::short(&object.name);
    let argument = Argument::new(sheet, &of, &panels, figure.shows(Layer::Ray));

    let body = match &argument.rays {
        Some(rays) if figure.shows(Layer::Legend) => {
            let entries = legend(sheet, &panels, rays);
            sheet.staged_legend(body, &entries)
        }
        _ => body,
    };
    let shown = panels.iter().flat_map(|panel| panel.volume.rim.points());
    let shown: Vec<DVec2> = shown.collect();
    let headings: Vec<[String; 3]> = panels.iter().map(heading).collect();
    for ((panel, frame), heading) in panels
        .iter()
        .zip(frames(sheet, body, panels.len()))
        .zip(&headings)
    {
        let frame = match sheet.width {
            Width::Book => in_a_line(sheet, frame, heading, &argument),
            Width::Slide => in_a_column(sheet, frame, heading, (&headings, &argument)),
        };
        let space = match figure.spec.frame {
            Some(_) => figure.space(frame, []),
            None => Space::fitted_flat(projection, frame, shown.iter().copied()),
        };
        draw_panel(sheet, &space, panel, &rim, &argument);
    }
    let sentences = panels.iter().map(|panel| in_words(figure, panel));
    let sentences: Vec<String> = sentences.collect();
    Ok(format!("Volumes around {of}: {}.", sentences.join("; ")))
}

/// What the looks of rays say, each from the first ray on that has it.
fn legend(
    sheet: &Sheet,
    panels: &[Panel],
    stages: &Rays,
) -> Vec<(Option<StageId>, Look, &'static str)> {
    let mut entries = Vec::new();
    for verdict in Verdict::ALL {
        let first = panels.iter().filter_map(|panel| {
            let mut rays = panel.rays.iter();
            rays.position(|ray| ray.verdict == verdict)
        });
        let Some(first) = first.min() else {
            continue;
        };
        entries.push((Some(stages.of(first)), verdict.look(), verdict.words()));
        // the letters of a slide have no room for it
        if verdict == Verdict::Wasted && sheet.width == Width::Book {
            let words = "inside the volume, beside the object";
            entries.push((Some(stages.wasted), IN_VAIN, words));
        }
    }
    entries
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

/// What a volume is, how much of it is empty, and how many tests it wastes.
fn heading(panel: &Panel) -> [String; 3] {
    let wasted = match panel.wasted_tests() {
        1 => "1 wasted test".into(),
        count => format!("{count} wasted tests"),
    };
    let empty = format!("{} empty", percent(panel.wasted));
    [name(panel.kind).into(), empty, wasted]
}

/// The stages of what a heading says; without rays no test is wasted.
fn stages(argument: &Argument) -> Vec<StageId> {
    let rays = argument.rays.as_ref().map(|rays| rays.wasted);
    let stages = [argument.object, argument.volumes];
    stages.into_iter().chain(rays).collect()
}

/// The heading above a panel; gives back the frame that is left below.
fn in_a_line(sheet: &mut Sheet, frame: Frame, heading: &[String; 3], argument: &Argument) -> Frame {
    let [title, rest] = frame.split_top(1.2 * sheet.line_height());
    let (y, middle) = (title.middle().y, title.middle().x);
    let places = [
        (Anchor::Start, title.min.x),
        (Anchor::Middle, middle),
        (Anchor::End, title.max.x),
    ];
    for (stage, (text, (anchor, x))) in stages(argument).into_iter().zip(heading.iter().zip(places))
    {
        sheet.at(stage, |sheet| sheet.text(anchor, DVec2::new(x, y), text));
    }
    rest
}

/// The heading to the left of a panel, as a slide has the room; gives back the frame that is left to the right.
fn in_a_column(
    sheet: &mut Sheet,
    frame: Frame,
    heading: &[String; 3],
    (all, argument): (&[[String; 3]], &Argument),
) -> Frame {
    let widths = all.iter().flatten().map(|text| sheet.width_of(text));
    let column = widths.fold(0.0, f64::max);
    let gap = 0.5 * sheet.letters;
    let [texts, rest] = frame.split(column / (frame.size().x - gap), gap);
    for (line, (stage, text)) in (0..).zip(stages(argument).into_iter().zip(heading)) {
        let down = (f64::from(line) + 0.5) * sheet.line_height();
        let at = texts.min + DVec2::new(0.0, down);
        sheet.at(stage, |sheet| sheet.text(Anchor::Start, at, text));
    }
    rest
}

fn draw_panel(sheet: &mut Sheet, space: &Space, panel: &Panel, object: &Rim, argument: &Argument) {
    sheet.at(argument.object, |sheet| {
        outline::rim(sheet, space, object, Look::OBJECT.wide(1.5));
    });
    let seen = |rim: &Rim| {
        let points = rim.points().into_iter().map(|p| space.place_flat(p));
        space.frame.cut_polygon(&points.collect::<Vec<_>>())
    };
    sheet.at(argument.volumes, |sheet| {
        let rims = [seen(&panel.volume.rim), seen(object)];
        hatch::between(sheet, Look::THIN.wide(0.5), &rims);
        outline::draw(sheet, space, &panel.volume, Look::VISITED.outline());
    });
    let Some(rays) = &argument.rays else { return };
    sheet.within(space.frame, |sheet| {
        for (number, tested) in panel.rays.iter().enumerate() {
            ray(sheet, space, (number, tested), rays);
        }
    });
}

/// A ray, first as it is cast, then with what became of it.
fn ray(sheet: &mut Sheet, space: &Space, (number, tested): (usize, &Tested), rays: &Rays) {
    let place = |t: f64| space.place(tested.ray.at(t));
    let Some(edge) = space.leaves(&tested.ray) else {
        return;
    };
    sheet.at(rays.all, |sheet| {
        sheet.step(tested.starts, |sheet| {
            sheet.arrow(Look::LINE_OF_RAY, place(0.0), place(edge));
        });
    });
    let to = place(tested.t.unwrap_or(edge));
    sheet.at(rays.of(number), |sheet| {
        sheet.step(tested.step, |sheet| {
            let look = tested.verdict.look().in_front();
            sheet.arrow(look, place(0.0), to);
            if let (Verdict::Wasted, Some([near, far])) = (tested.verdict, tested.bound.inside) {
                sheet.line(IN_VAIN, place(near), place(far));
            }
            if tested.verdict == Verdict::Hit {
                sheet.dot(Look::ANSWER, to);
            }
        });
    });
}

fn rays(count: usize) -> String {
    match count {
        1 => "1 ray".into(),
        _ => format!("{count} rays"),
    }
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
    use glam::DVec3;
    use serde_json::json;

    use super::*;
    use crate::figure::kinds::volumes::panel::wasted;
    use crate::figure::parts::volume_outline::around;
    use crate::figure::read_back::{ReadBack, traced};
    use crate::figure::sheet::Width;
    use crate::figure::view::Projection;
    use crate::geometry::Ray;
    use crate::scene::{NoFiles, Scene, load_bytes};
    use crate::structure::{SlabSet, VolumeKind};
    use crate::trace::{
        BoundTest, BoundVerdict, Bounded, Event, PixelSample, RayEnd, RayStart, StrategyName,
    };

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

    #[test]
    fn the_part_of_a_wasted_ray_inside_a_sphere_ends_on_its_outline() {
        // y = 2.2 passes above the prism and crosses the sphere of radius √6 where x² = 6 − 4.84
        let half = 1.16_f64.sqrt();
        let start = RayStart {
            ray: Ray::new(DVec3::new(-9.0, 2.2, 0.0), DVec3::X),
            ..RayStart::default()
        };
        let bound = BoundTest {
            of: Bounded::Object(0),
            volume: VolumeKind::Sphere,
            inside: Some([9.0 - half, 9.0 + half]),
            verdict: BoundVerdict::Hit,
            ..BoundTest::default()
        };
        let events = [
            (None, Event::Pixel(PixelSample::default())),
            (Some(0), Event::Ray(start)),
            (Some(0), Event::BoundTest(bound)),
            (Some(0), Event::RayEnd(RayEnd::default())),
        ];
        let mut traced = traced(scene(), events);
        traced.settings.strategy = StrategyName::Bounds;
        traced.settings.structure.volume = VolumeKind::Sphere;
        let spec = json!({"kind": "volumes", "pixels": [[0, 0]], "view": "front"});
        let drawn = ReadBack::of(spec, traced);
        let circles = drawn.circles("visited");
        let [(center, radius)] = circles[..] else {
            panic!("{circles:?}");
        };
        let lines = drawn.paths("rejected");
        let on_rim = |at: &DVec2| (at.distance(center) - radius).abs() < 0.03;
        let chord = lines.iter().find(|line| line.iter().all(on_rim));
        let chord = chord.expect("no line from rim to rim");
        let length = chord[0].distance(chord[1]);
        assert!(
            (length / radius - 2.0 * half / 6f64.sqrt()).abs() < 1e-3,
            "{length}"
        );
        let texts = drawn.texts();
        assert!(texts.contains(&"1 wasted test".into()), "{texts:?}");
    }
}
