//! The terms of the shade as bars over the angle θ between normal and light: ambient, diffuse and specular of several points
//! of one object, from θ = 0 to beyond 90°, and what each term would be without its clamp.
//!
//! I = ambient + light·[colour·diffuse·max(0, N·L) + specular·max(0, R·V)^shininess], of the red channel.

use glam::{DVec2, DVec3};

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::outline::{self, Outline};
use crate::figure::parts::ticks;
use crate::figure::sheet::canvas::brief;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::{Colour, Look};
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::subject::{DrawnRay, Figure};
use crate::figure::view::Space;
use crate::scene::Emission;
use crate::trace::{Event, LightTerm, Shade, Visibility};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 400.0,
    usual: &[],
    more: &[],
};

const AMBIENT: Look = Look::OBJECT;
const DIFFUSE: Look = Look::VISITED;
const SPECULAR: Look = Look {
    colour: Colour::Light,
    ..Look::REJECTED.wide(1.5)
};
const CUT: Look = Look::REJECTED.outline();

/// A point with its terms.
struct Bar {
    shade: Shade,
    term: LightTerm,
    /// θ in degrees.
    angle: f64,
    /// The diffuse and the specular term that count.
    counted: [f64; 2],
    /// The same without a clamp.
    uncut: [f64; 2],
}

impl Bar {
    fn find(figure: &Figure, pixel: [u32; 2]) -> Result<Self, FigureError> {
        let drawn = DrawnRay::find(figure.records_of(pixel)?, 0)?;
        let mut events = drawn.events.iter().map(|record| record.event);
        let term = events.find_map(|event| match event {
            Event::LightTerm(term) => Some(term),
            _ => None,
        });
        let shade = events.find_map(|event| match event {
            Event::Shade(shade) => Some(shade),
            _ => None,
        });
        let [x, y] = pixel;
        let (Some(term), Some(shade)) = (term, shade) else {
            return Err(FigureError::new(
                "pixels",
                format!("pixel ({x}, {y}) shows no point with a light term"),
                "name pixels that show an object of a scene with a light",
            ));
        };
        let material = figure.scene.material_of(shade.object);
        let light = figure.scene.lights.get(term.light as usize);
        let colour = light.map_or(1.0, |light| match light.emission {
            Emission::Colour(colour) => colour.x,
            Emission::Power(_) => 1.0,
        });
        let counts = matches!(term.visibility, Visibility::Visible | Visibility::NotTested);
        let count = |of: DVec3| if counts { of.x } else { 0.0 };
        let of_surface: DVec3 = material.colour.into();
        let raised = libm::pow(term.term.r_dot_v, material.shininess);
        Ok(Self {
            angle: libm::acos(term.term.n_dot_l.clamp(-1.0, 1.0)).to_degrees(),
            counted: [term.term.diffuse, term.term.specular].map(count),
            uncut: [
                colour * of_surface.x * material.diffuse * term.term.n_dot_l,
                // an odd or a broken power of a negative number is nothing to draw
                if raised.is_finite() {
                    colour * material.specular * raised
                } else {
                    0.0
                },
            ],
            shade,
            term,
        })
    }

    fn sum(&self) -> f64 {
        self.shade.ambient.x + self.counted[0] + self.counted[1]
    }

    /// θ in whole degrees.
    fn degrees(&self) -> String {
        format!("{:.0}°", self.angle)
    }
}

struct Stages {
    points: StageId,
    ambient: StageId,
    diffuse: StageId,
    specular: StageId,
    cut: StageId,
    sum: StageId,
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let pixels = figure.pixels();
    if pixels.is_empty() {
        figure.pixel()?;
    }
    let bars = pixels.iter().map(|pixel| Bar::find(figure, *pixel));
    let mut bars: Vec<Bar> = bars.collect::<Result<_, FigureError>>()?;
    bars.sort_by(|a, b| a.angle.total_cmp(&b.angle));
    let stages = stages(sheet, &bars);
    let entries = [
        (Some(stages.ambient), AMBIENT, "ambient"),
        (Some(stages.diffuse), DIFFUSE, "diffuse"),
        (Some(stages.specular), SPECULAR, "specular"),
        (Some(stages.cut), CUT, "cut to 0"),
    ];
    let rest = sheet.staged_legend(body, &entries);
    let [left, right] = rest.split(0.27, 1.5 * sheet.letters);
    points(figure, sheet, left, &bars, &stages);
    chart(sheet, right, &bars, &stages);
    let told = bars.iter().map(|bar| {
        format!(
            "θ = {}: ambient {}, diffuse {}, specular {}, in sum {}.",
            bar.degrees(),
            brief(bar.shade.ambient.x),
            brief(bar.counted[0]),
            brief(bar.counted[1]),
            brief(bar.sum())
        )
    });
    let told: Vec<String> = told.collect();
    Ok(format!(
        "Bars of the terms of the shade over the angle between normal and light. {}",
        told.join(" ")
    ))
}

fn stages(sheet: &mut Sheet, bars: &[Bar]) -> Stages {
    let behind = bars
        .iter()
        .filter(|bar| bar.term.term.n_dot_l <= 0.0)
        .count();
    let count = bars.len();
    Stages {
        points: sheet.stage(
            Part::Point,
            None,
            format!("{count} points of the same object turn away from the light step by step."),
        ),
        ambient: sheet.stage(
            Part::Ambient,
            None,
            "The ambient term is the same everywhere.",
        ),
        diffuse: sheet.stage(
            Part::Diffuse,
            None,
            "The diffuse term falls as cos θ = N·L, and ends at 90°.",
        ),
        specular: sheet.stage(
            Part::Specular,
            None,
            "The specular term is large where R points to the viewer, and ends at 90° as well.",
        ),
        cut: sheet.stage(
            "clamp",
            None,
            format!(
                "At {behind} of the points the light is behind the surface: each term is cut to 0 by itself, and none becomes negative."
            ),
        ),
        sum: sheet.stage(
            Part::LightSum,
            None,
            "The sum of what is left is the shade.",
        ),
    }
}

/// The object with its points, and the direction to the light.
fn points(figure: &Figure, sheet: &mut Sheet, frame: Frame, bars: &[Bar], stages: &Stages) {
    /// How long N and L are drawn, of the object's size.
    const LENGTH: f64 = 0.3;
    let object = bars[0].shade.object;
    let projection = figure.projection();
    let outline = Outline::of(&figure.scene.primitive(object).shape, &projection);
    let rim = outline.rim.points();
    let around = Frame::around(rim.iter().copied()).unwrap_or_default();
    let length = LENGTH * around.size().max_element();
    let tips = bars
        .iter()
        .map(|bar| projection.of(bar.shade.point + length * bar.shade.normal));
    let shown = rim.iter().copied().chain(tips);
    let space = Space::fitted_flat(projection, frame.wider(-1.5 * sheet.letters), shown);
    sheet.at(stages.points, |sheet| {
        outline::draw(sheet, &space, &outline, Look::OBJECT);
        for (number, bar) in (1..).zip(bars) {
            let at = space.place(bar.shade.point);
            let along = space.direction(bar.shade.normal);
            sheet.arrow(Look::THIN, at, at + length * space.scale * along);
            sheet.dot(Look::RAY, at);
            sheet.label(frame, at, -along, format!("{number}"));
        }
        // parallel, as far as a drawing of the object alone can tell
        let first = &bars[0];
        let at = space.place(first.shade.point);
        let along = space.direction(first.term.term.to_light);
        let tip = at + 1.4 * length * space.scale * along;
        sheet.arrow(Look::SHADOW_RAY, at, tip);
        sheet.label(frame, tip, along, formula("L"));
    });
}

/// The bars over θ.
fn chart(sheet: &mut Sheet, frame: Frame, bars: &[Bar], stages: &Stages) {
    let line = sheet.line_height();
    let most = bars
        .iter()
        .map(|bar| bar.sum().max(bar.shade.ambient.x + bar.uncut[1]));
    let most = most.fold(0.0, f64::max);
    let least = bars.iter().map(|bar| bar.uncut[0]).fold(0.0, f64::min);
    let last = bars.iter().map(|bar| bar.angle).fold(90.0, f64::max);
    // two rows of letters under the lowest bar, one over the highest
    let top = frame.min.y + 1.2 * line;
    let bottom = frame.max.y - 2.2 * line;
    let left = frame.min.x + 2.2 * sheet.letters;
    let scale = (bottom - top) / (most - least);
    let zero = top + scale * most;
    let slot = (frame.max.x - left) / (bars.len() as f64 + 0.3);
    let half = 0.3 * slot;
    // from the middle of the first bar to the middle of the last
    let x = |angle: f64| left + 0.6 * slot + (frame.max.x - left - 1.2 * slot) * angle / last;
    let at = |angle: f64, value: f64| DVec2::new(x(angle), zero - scale * value);
    sheet.at(stages.points, |sheet| {
        sheet.line(
            Look::THIN,
            DVec2::new(left, zero),
            DVec2::new(frame.max.x, zero),
        );
        sheet.line(Look::THIN, DVec2::new(left, top), DVec2::new(left, bottom));
        for tenths in ticks::linear((10.0 * most) as u128) {
            let value = tenths as f64 / 10.0;
            if most < value {
                continue;
            }
            let y = zero - scale * value;
            let tick = DVec2::new(0.3 * sheet.letters, 0.0);
            sheet.line(Look::THIN, DVec2::new(left, y) - tick, DVec2::new(left, y));
            let beside = DVec2::new(left, y) - 1.5 * tick;
            sheet.text(Anchor::End, beside, brief(value));
        }
        // beyond 90° the light is behind the surface
        let [from, to] = [most, least].map(|value| at(90.0, value));
        sheet.line(Look::HELP, from, to);
        let above = DVec2::new(from.x, frame.min.y + 0.5 * line);
        sheet.text(Anchor::Middle, above, "90°");
        for (number, bar) in (1..).zip(bars) {
            let below = DVec2::new(x(bar.angle), bottom + 0.8 * line);
            sheet.text(Anchor::Middle, below, format!("{number}"));
            let angle: Text = match (number, sheet.width) {
                (1, _) => formula("θ = ") + bar.degrees(),
                (_, Width::Book) => bar.degrees().into(),
                // a slide has room for the numbers alone
                (_, Width::Slide) => bar.degrees().trim_end_matches('°').into(),
            };
            let lower = below + DVec2::new(0.0, line);
            sheet.text(Anchor::Middle, lower, angle);
        }
    });
    let rectangle = |sheet: &mut Sheet, look: Look, angle: f64, [from, to]: [f64; 2]| {
        let corners = [at(angle, from.max(to)), at(angle, from.min(to))];
        let aside = DVec2::new(half, 0.0);
        let (min, max) = (corners[0] - aside, corners[1] + aside);
        sheet.rectangle(look, Frame { min, max });
    };
    for bar in bars {
        let ambient = bar.shade.ambient.x;
        let [diffuse, specular] = bar.counted;
        sheet.at(stages.ambient, |sheet| {
            rectangle(sheet, AMBIENT, bar.angle, [0.0, ambient]);
        });
        if 0.0 < diffuse {
            sheet.at(stages.diffuse, |sheet| {
                rectangle(sheet, DIFFUSE, bar.angle, [ambient, ambient + diffuse]);
            });
        }
        if 0.0 < specular {
            let from = ambient + diffuse;
            sheet.at(stages.specular, |sheet| {
                rectangle(sheet, SPECULAR, bar.angle, [from, from + specular]);
            });
        }
        sheet.at(stages.cut, |sheet| {
            let [uncut, bright] = bar.uncut;
            if uncut < 0.0 {
                rectangle(sheet, CUT, bar.angle, [0.0, uncut]);
            }
            if specular == 0.0 && 0.002 * most < bright {
                rectangle(sheet, CUT, bar.angle, [ambient, ambient + bright]);
            }
        });
        sheet.at(stages.sum, |sheet| {
            let highest = if specular == 0.0 {
                bar.sum().max(ambient + bar.uncut[1])
            } else {
                bar.sum()
            };
            let above = at(bar.angle, highest) - DVec2::new(0.0, 0.5 * line);
            // beside the dashed line of 90°
            sheet.text(Anchor::Middle, above, brief(bar.sum()));
        });
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use serde_json::json;

    use crate::figure::read_back::{DRAWN, ReadBack, traced};
    use crate::figure::sheet::frame::Frame;
    use crate::scene::small_scene::{object, one_pixel, sphere};
    use crate::scene::{PhongTerm, PrimitiveId};
    use crate::trace::{Event, LightTerm, PixelSample, RayEnd, RayStart, Shade, Visibility};

    /// The bars of a point with this N·L and R·V.
    fn drawn(n_dot_l: f64, r_dot_v: f64, visibility: Visibility) -> ReadBack {
        let ball = object("A", "white", &sphere([0.0; 3], 1.0));
        let scene = one_pixel(&format!(
            r#""lights":[{{"name":"lamp","position":[3,5,0],"colour":[1,1,1]}}],
            "materials":{{"white":{{"colour":[1,1,1],"diffuse":0.5,"specular":0.25,"shininess":2}}}},
            "objects":[{ball}]"#
        ));
        let lit = 0.0 < n_dot_l;
        let term = PhongTerm {
            to_light: DVec3::new(0.6, 0.8, 0.0),
            distance: 5.0,
            n_dot_l,
            r_dot_v,
            diffuse: if lit {
                DVec3::splat(0.5 * n_dot_l)
            } else {
                DVec3::ZERO
            },
            specular: if lit {
                DVec3::splat(0.25 * r_dot_v * r_dot_v)
            } else {
                DVec3::ZERO
            },
        };
        let light = LightTerm {
            light: 0,
            visibility,
            term,
        };
        let shade = Shade {
            object: PrimitiveId(0),
            point: DVec3::Y,
            normal: DVec3::Y,
            ambient: DVec3::splat(0.2),
            ..Shade::default()
        };
        let events = [
            (None, Event::Pixel(PixelSample::default())),
            (Some(0), Event::Ray(RayStart::default())),
            (Some(0), Event::LightTerm(light)),
            (Some(0), Event::Shade(shade)),
            (Some(0), Event::RayEnd(RayEnd::default())),
        ];
        ReadBack::of(
            json!({"kind": "terms", "pixel": [0, 0], "view": "front"}),
            traced(scene, events),
        )
    }

    #[test]
    fn a_bar_is_as_high_as_its_term() {
        let drawn = drawn(0.8, 0.6, Visibility::Visible);
        // ambient 0.2, diffuse 0.5·0.8, specular 0.25·0.36; the swatches of the legend are wider than high
        let height = |colour: &str| {
            let bars = drawn.rectangles(colour).into_iter().map(Frame::size);
            let bars = bars.filter(|size| 14.0 < size.y);
            bars.map(|size| size.y).next().unwrap()
        };
        let [ambient, diffuse, specular] = ["ink", "visited", "light"].map(height);
        assert!(
            (diffuse / ambient - 2.0).abs() < DRAWN,
            "{diffuse} {ambient}"
        );
        assert!(
            (specular / ambient - 0.45).abs() < DRAWN,
            "{specular} {ambient}"
        );
        let texts = drawn.texts();
        assert!(
            texts.contains(&"0.69".into()) && texts.contains(&"θ = 37°".into()),
            "{texts:?}"
        );
    }

    #[test]
    fn what_is_cut_is_dashed_and_the_sum_is_the_ambient_term() {
        let drawn = drawn(-0.8, -0.6, Visibility::FacesAway);
        // below the axis the diffuse one, above the ambient bar the square of R·V; the third is the legend's line
        assert_eq!(drawn.rectangles("rejected").len(), 2);
        let texts = drawn.texts();
        assert!(texts.contains(&"θ = 143°".into()), "{texts:?}");
        // as tick and as sum
        assert!(
            texts.iter().filter(|text| *text == "0.2").count() >= 1,
            "{texts:?}"
        );
        assert_eq!(drawn.rectangles("light").len(), 1, "the legend alone");
    }
}
