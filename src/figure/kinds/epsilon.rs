//! Why rays that start on a surface need ε: the root of the shadow ray that is its own surface, magnified, and on an axis of
//! powers of ten between the rounding of 10⁻¹⁶ and the light (erratum 8).
//!
//! Its sign is chance: where it is above 0, a ray without ε is blocked by the surface that it starts on.

use glam::DVec2;

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::scenery;
use crate::figure::sheet::canvas::{in_powers, power_of_ten, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::subject::Figure;
use crate::geometry::{PlaneVerdict, RootVerdict};
use crate::trace::{Event, Item, Purpose, RayTree, Shade};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 400.0,
    usual: &[],
    more: &[],
};

/// A shadow ray whose start lies on the surface but for rounding.
struct Start {
    pixel: [u32; 2],
    /// The root that is the surface itself.
    t: f64,
    /// ε, and the t of the light.
    range: [f64; 2],
    /// N·L.
    cosine: f64,
}

impl Start {
    fn is_blocked(&self) -> bool {
        0.0 < self.t
    }

    fn sentence(&self) -> String {
        let [x, y] = self.pixel;
        let so = if self.is_blocked() {
            "above 0: without ε the surface shadows itself"
        } else {
            "not above 0: here nothing happens without ε"
        };
        format!("Pixel ({x}, {y}): t = {}, {so}.", quantity(self.t))
    }
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let mut starts = Vec::new();
    for pixel in figure.pixels() {
        starts.extend(start(figure, pixel)?);
    }
    let Some(shown) = starts
        .iter()
        .find(|start| start.is_blocked())
        .or(starts.first())
    else {
        figure.pixel()?;
        return Err(FigureError::new(
            "pixels",
            "no shadow ray of these pixels has a root below ε",
            "name pixels that show a sphere or a polygon in the light",
        ));
    };
    let name = starts_on(figure, shown)?;
    let point = sheet.stage(
        Part::Point,
        None,
        format!(
            "A shadow ray starts at a point p of {name}, and p is off the surface by rounding."
        ),
    );
    let root = sheet.stage(
        Part::Roots,
        None,
        format!(
            "One of its roots is the surface itself, at t = {} instead of 0.",
            quantity(shown.t)
        ),
    );
    let rows: Vec<StageId> = starts
        .iter()
        .map(|start| sheet.stage(Part::Choice, None, start.sentence()))
        .collect();
    let [epsilon, light] = shown.range;
    let last = sheet.stage(
        "ε",
        None,
        format!(
            "ε = {} is far above all of them and far below the light at t = {}: only t from ε on counts.",
            quantity(epsilon),
            quantity(light)
        ),
    );
    let line = sheet.line_height();
    let height = (starts.len() as f64 + 3.4) * line;
    let [above, below] = body.split_top(body.size().y - height);
    magnified(sheet, above, shown, [point, root]);
    axis(sheet, below, &starts, (&rows, last, point));
    let told: Vec<String> = starts.iter().map(Start::sentence).collect();
    Ok(format!(
        "Shadow rays that start on {name}. {} ε is {}.",
        told.join(" "),
        quantity(epsilon)
    ))
}

/// The name of what the ray starts on.
fn starts_on(figure: &Figure, start: &Start) -> Result<String, FigureError> {
    let shade = figure
        .records_of(start.pixel)?
        .iter()
        .find_map(|record| match record.event {
            Event::Shade(shade) => Some(shade.object),
            _ => None,
        });
    Ok(shade.map_or_else(String::new, |id| scenery::name_of(figure.scene, id)))
}

/// The shadow ray of a pixel's hit, if a root of it lies within ε of 0.
fn start(figure: &Figure, pixel: [u32; 2]) -> Result<Option<Start>, FigureError> {
    let records = figure.records_of(pixel)?;
    let tree = RayTree::new(records);
    let shade = records.iter().find_map(|record| match record.event {
        Event::Shade(shade) if record.ray == Some(0) => Some(shade),
        _ => None,
    });
    let Some(Shade {
        object: on, normal, ..
    }) = shade
    else {
        return Ok(None);
    };
    let is_shadow = |purpose| purpose == Purpose::Shadow;
    let found = tree.rays.iter().find_map(|node| {
        let of = node.start.filter(|start| is_shadow(start.purpose))?;
        let events = node.items.iter().filter_map(|item| match item {
            Item::Event(at) => Some(&records[*at]),
            Item::Ray(_) => None,
        });
        let mut roots = events.filter_map(|record| {
            let root = match record.event {
                Event::SphereTest { object, test } if object == on => test
                    .roots
                    .iter()
                    .find(|root| root.verdict == RootVerdict::BelowEpsilon)?,
                Event::PlaneTest { object, test } if object == on => match test.verdict {
                    PlaneVerdict::Meets(root) => {
                        Some(root).filter(|root| root.verdict == RootVerdict::BelowEpsilon)?
                    }
                    _ => return None,
                },
                _ => return None,
            };
            Some(root.t)
        });
        let t = roots.next()?;
        Some(Start {
            pixel,
            t,
            range: [of.range.min, of.range.max],
            cosine: of.ray.direction.dot(normal),
        })
    });
    Ok(found)
}

/// The start of the ray and its root, so large that the root can be seen.
fn magnified(sheet: &mut Sheet, frame: Frame, start: &Start, [point, root]: [StageId; 2]) {
    let line = sheet.line_height();
    let middle = frame.middle();
    let cosine = start.cosine.clamp(0.2, 1.0);
    let along = DVec2::new((1.0 - cosine * cosine).sqrt(), -cosine);
    // the root is as long as this on the sheet
    let length = 0.3 * frame.size().y;
    let surface_y = middle.y + 0.1 * frame.size().y;
    let crossing = DVec2::new(frame.min.x + 0.3 * frame.size().x, surface_y);
    let p = crossing - length * start.t.signum() * along;
    sheet.at(point, |sheet| {
        let ground = Frame {
            min: DVec2::new(frame.min.x, surface_y),
            max: frame.max,
        };
        sheet.rectangle(Look::OBJECT.inside(), ground);
        sheet.line(
            Look::OBJECT.outline().wide(1.75),
            ground.min,
            DVec2::new(frame.max.x, surface_y),
        );
        let beside = DVec2::new(frame.max.x, surface_y + 0.6 * line);
        sheet.text(Anchor::End, beside, "the surface");
        sheet.dot(Look::RAY, p);
        sheet.label(frame, p, DVec2::new(-1.0, 0.3), formula("p"));
        let end = (p.y - frame.min.y) / -along.y;
        sheet.arrow(Look::SHADOW_RAY, p, p + end * along);
        let beside = p + 0.8 * end * along + DVec2::new(0.8 * sheet.letters, 0.0);
        sheet.text(Anchor::Start, beside, "shadow ray to the light");
    });
    sheet.at(root, |sheet| {
        sheet.cross(Look::REJECTED, crossing);
        let off = DVec2::new(1.2 * sheet.letters, -0.7 * line);
        let text = formula("t = ") + powers(start.t) + ", the surface itself";
        sheet.text(Anchor::Start, crossing + off, text);
        // how much larger than it is
        let scale = length / sheet.letters / start.t.abs();
        let at = DVec2::new(frame.max.x, frame.max.y - 0.6 * line);
        let text = Text::from("one letter is ") + powers(1.0 / scale) + " wide";
        if sheet.width == Width::Book {
            sheet.text(Anchor::End, at, text);
        }
    });
}

/// A number in powers of ten with two digits, as 4.5·10⁻¹⁷.
fn powers(value: f64) -> Text {
    let sign = if value < 0.0 { "−" } else { "" };
    let written = format!("{:.1e}", value.abs()).replace(".0e", "e");
    in_powers(&format!("{sign}{written}")).into()
}

/// The axis of powers of ten, with a row for each ray.
fn axis(
    sheet: &mut Sheet,
    frame: Frame,
    starts: &[Start],
    (stages, last, first): (&[StageId], StageId, StageId),
) {
    let line = sheet.line_height();
    let sizes = starts
        .iter()
        .map(|start| start.t.abs())
        .filter(|t| 0.0 < *t);
    let least = sizes.fold(1e-16, f64::min);
    let most = starts
        .iter()
        .map(|start| start.range[1])
        .fold(1.0, f64::max);
    let [low, high] = [libm::log10(least).floor() - 1.0, libm::log10(most).ceil()];
    let names: Vec<String> = starts
        .iter()
        .map(|Start { pixel: [x, y], .. }| format!("({x}, {y})"))
        .collect();
    let widths = names.iter().map(|name| sheet.width_of(name.as_str()));
    let left = frame.min.x + widths.fold(0.0, f64::max) + 2.0 * sheet.letters;
    let right = frame.max.x - 2.0 * sheet.letters;
    let x = |t: f64| {
        let power = libm::log10(t.abs().max(libm::pow(10.0, low)));
        left + (right - left) * (power - low) / (high - low)
    };
    let row = |number: usize| frame.min.y + (number as f64 + 1.7) * line;
    let axis = row(starts.len());
    sheet.at(first, |sheet| {
        sheet.arrow(
            Look::THIN,
            DVec2::new(left, axis),
            DVec2::new(right + sheet.letters, axis),
        );
        let every = match sheet.width {
            Width::Book => 2,
            Width::Slide => 4,
        };
        for power in (low as i32..=high as i32).filter(|power| power.rem_euclid(every) == 0) {
            let at = DVec2::new(x(libm::pow(10.0, f64::from(power))), axis);
            let tick = DVec2::new(0.0, 0.3 * sheet.letters);
            sheet.line(Look::THIN, at - tick, at + tick);
            let text = match power {
                0 => "1".into(),
                _ => Text::from(power_of_ten(power)),
            };
            sheet.text(Anchor::Middle, at + DVec2::new(0.0, 0.8 * line), text);
        }
        let end = DVec2::new(right + 1.2 * sheet.letters, axis);
        sheet.text(Anchor::Start, end, formula("|t|"));
    });
    for (number, (start, stage)) in starts.iter().zip(stages).enumerate() {
        let at = DVec2::new(x(start.t), row(number));
        sheet.at(*stage, |sheet| {
            let name = DVec2::new(frame.min.x, at.y);
            sheet.text(Anchor::Start, name, names[number].as_str());
            sheet.cross(Look::REJECTED, at);
            let so: Text = match (start.is_blocked(), sheet.width) {
                (true, Width::Book) => " > 0: blocked".into(),
                (true, Width::Slide) => " > 0".into(),
                (false, Width::Book) => Text::from(" < 0: behind ") + formula("p"),
                (false, Width::Slide) => " < 0".into(),
            };
            let beside = at + DVec2::new(0.9 * sheet.letters, 0.0);
            sheet.text(Anchor::Start, beside, powers(start.t) + so);
        });
    }
    let Some(shown) = starts.first() else { return };
    let top = frame.min.y + 1.1 * line;
    sheet.at(last, |sheet| {
        let [epsilon, light] = shown.range.map(x);
        for (at, name) in [(epsilon, formula("ε")), (light, Text::from("light"))] {
            let (from, to) = (DVec2::new(at, top), DVec2::new(at, axis));
            let look = if at == epsilon {
                Look::ANSWER.outline()
            } else {
                Look::HELP
            };
            sheet.line(look, from, to);
            sheet.text(Anchor::Middle, from - DVec2::new(0.0, 0.5 * line), name);
        }
        // what counts
        let between = [DVec2::new(epsilon, axis), DVec2::new(light, axis)];
        sheet.line(Look::ANSWER.outline().wide(4.0), between[0], between[1]);
    });
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use serde_json::json;

    use crate::figure::read_back::{DRAWN, ReadBack, traced};
    use crate::geometry::{QuadraticTest, Ray, Root, RootVerdict, Roots, TRange};
    use crate::scene::PrimitiveId;
    use crate::scene::small_scene::{object, one_pixel, sphere};
    use crate::trace::{Event, PixelSample, Purpose, RayEnd, RayStart, Shade};

    #[test]
    fn the_root_and_epsilon_stand_where_their_logarithms_are() {
        let ball = object("A", "white", &sphere([0.0; 3], 1.0));
        let scene = one_pixel(&format!(
            r#""lights":[{{"name":"lamp","position":[0,11,0],"colour":[1,1,1]}}],
            "materials":{{"white":{{"colour":[1,1,1],"diffuse":0.5}}}},"objects":[{ball}]"#
        ));
        let on = PrimitiveId(0);
        let to_light = RayStart {
            ray: Ray::new(DVec3::Y, DVec3::Y),
            range: TRange {
                min: 1e-9,
                max: 10.0,
            },
            purpose: Purpose::Shadow,
            light: Some(0),
            ..RayStart::default()
        };
        let root = |t, verdict| Root { t, verdict };
        let test = QuadraticTest {
            roots: Roots::Two {
                near: root(-2.0, RootVerdict::Behind),
                far: root(4.5e-17, RootVerdict::BelowEpsilon),
            },
            ..QuadraticTest::default()
        };
        let shade = Shade {
            object: on,
            point: DVec3::Y,
            normal: DVec3::Y,
            ..Shade::default()
        };
        let events = [
            (None, Event::Pixel(PixelSample::default())),
            (Some(0), Event::Ray(RayStart::default())),
            (Some(1), Event::Ray(to_light)),
            (Some(1), Event::SphereTest { object: on, test }),
            (Some(1), Event::RayEnd(RayEnd::default())),
            (Some(0), Event::Shade(shade)),
            (Some(0), Event::RayEnd(RayEnd::default())),
        ];
        let drawn = ReadBack::of(
            json!({"kind": "epsilon", "pixel": [0, 0]}),
            traced(scene, events),
        );
        let crosses = drawn.crosses("rejected");
        // the magnified one is higher; on the axis it stands at 4.5·10⁻¹⁷
        let lowest = crosses
            .iter()
            .copied()
            .max_by(|a, b| a.y.total_cmp(&b.y))
            .unwrap();
        let epsilon = drawn.upright("answer")[0];
        let texts = drawn.placed_texts();
        let at = |power: &str| texts.iter().find(|(text, _)| text == power).unwrap().1.x;
        let decade = (at("10−2") - at("10−16")) / 14.0;
        // −9 and log₁₀ 4.5·10⁻¹⁷ = −16.34679
        assert!((at("10−2") - epsilon - 7.0 * decade).abs() < 4.0 * DRAWN);
        assert!((epsilon - lowest.x - 7.34679 * decade).abs() < 4.0 * DRAWN);
        assert!(
            texts.iter().any(|(text, _)| text.contains("4.5·10−17 > 0")),
            "{texts:?}"
        );
    }
}
