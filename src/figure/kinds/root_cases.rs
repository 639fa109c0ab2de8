//! All cases of equation (iii) in a row: one ray, several spheres on its line, and under each sphere its parabola, on one
//! axis of t (slides, "Computing Intersection"; erratum 8 for the roots behind the origin).
//!
//! Space and graph have one scale, so that each root stands straight below its point on the ray. The upper part is exact
//! if the centres lie in the plane of the ray and the camera's up.

use glam::DVec2;

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::{parabola, scenery};
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet, Width};
use crate::figure::subject::Figure;
use crate::geometry::{QuadraticTest, Ray, Root, RootVerdict, Roots, Sphere};
use crate::scene::{PrimitiveId, Shape};
use crate::trace::Event;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 520.0,
    usual: &[],
    more: &[],
};

/// A sphere on the line of the ray, with its test.
struct Case {
    id: PrimitiveId,
    sphere: Sphere,
    test: QuadraticTest,
    step: u32,
    name: String,
}

impl Case {
    /// The t nearest to the center.
    fn middle(&self) -> f64 {
        parabola::vertex(&self.test).x
    }

    /// d² − r², the least value of f.
    fn least(&self) -> f64 {
        parabola::vertex(&self.test).y
    }

    /// What the roots say, as a sentence without its end.
    fn verdict(&self) -> String {
        let is = |root: Root, verdict| root.verdict == verdict;
        match self.test.roots {
            Roots::None => "no root: miss".into(),
            Roots::Graze(root) | Roots::Linear(root) if is(root, RootVerdict::Chosen) => {
                "one root: the hit".into()
            }
            Roots::Two { near, far } if is(near, RootVerdict::Behind) => {
                if is(far, RootVerdict::Behind) {
                    "both roots below 0: no hit".into()
                } else {
                    "t₁ below 0: t₂ is the hit".into()
                }
            }
            Roots::Two { near, .. } if is(near, RootVerdict::Chosen) => {
                "t₁ is the hit, t₂ farther".into()
            }
            _ => "no root that counts".into(),
        }
    }

    /// The same for the narrow columns of a slide.
    fn in_a_word(&self) -> &'static str {
        let root = |root: Root| root.verdict == RootVerdict::Chosen;
        match self.test.roots {
            Roots::None => "miss",
            Roots::Graze(_) | Roots::Linear(_) => "graze",
            Roots::Two { near, .. } if root(near) => "ahead",
            Roots::Two { far, .. } if root(far) => "inside",
            Roots::Two { .. } => "behind",
        }
    }

    /// How d and r compare; inside the sphere it is the origin that decides.
    fn compared(&self) -> &'static str {
        let least = self.least();
        if least < 0.0 {
            "d < r"
        } else if 0.0 < least {
            "d > r"
        } else {
            "d = r"
        }
    }

    fn sentence(&self) -> String {
        let roots = parabola::roots(&self.test);
        let told: Vec<String> = roots
            .iter()
            .map(|(name, root)| format!("{name} = {}", quantity(root.t)))
            .collect();
        let told = match told.as_slice() {
            [] => String::new(),
            some => format!(" ({})", some.join(", ")),
        };
        format!(
            "{}: {}, discriminant {}{told}; {}.",
            self.name,
            self.compared(),
            parabola::discriminant(&self.test),
            self.verdict()
        )
    }
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let drawn = figure.ray()?;
    let cases: Vec<Case> = drawn
        .events
        .iter()
        .filter_map(|record| match record.event {
            Event::SphereTest { object, test } if 0.0 < test.a => {
                let Shape::Sphere(sphere) = figure.scene.primitive(object).shape else {
                    return None;
                };
                Some(Case {
                    id: object,
                    sphere,
                    test,
                    step: record.step,
                    name: scenery::name_of(figure.scene, object),
                })
            }
            _ => None,
        })
        .collect();
    let (Some(start), false) = (drawn.node.start, cases.is_empty()) else {
        return Err(FigureError::new(
            "pixel",
            "the ray of this pixel is tested against no sphere",
            "name a pixel of a scene that has spheres",
        ));
    };
    let [starts, ends] = figure.steps_of(&drawn)?;
    let first = sheet.stage(
        Part::Ray,
        starts,
        format!(
            "One ray R and {} spheres: behind its origin, around it, beside the ray and ahead.",
            cases.len()
        ),
    );
    let stages: Vec<StageId> = cases
        .iter()
        .map(|case| sheet.stage(Part::Choice, case.step, case.sentence()))
        .collect();
    let hit = drawn.node.end.and_then(|end| end.t.zip(end.object));
    let said = hit.map(|(t, object)| {
        format!(
            "The smallest t above 0 is the hit: {} at t = {}.",
            scenery::name_of(figure.scene, object),
            quantity(t)
        )
    });
    let last = said
        .clone()
        .map(|said| sheet.stage(Part::Nearest, ends, said));

    let plot = Plot::new(figure, sheet, body, &cases, start.ray);
    plot.axes(sheet, first);
    for (case, stage) in cases.iter().zip(&stages) {
        plot.sphere(sheet, case, first);
        sheet.at(*stage, |sheet| plot.parabola(sheet, case));
        plot.words(sheet, case, *stage);
    }
    if let (Some(last), Some((t, object))) = (last, hit) {
        sheet.at(last, |sheet| {
            sheet.line(Look::RAY, plot.half(), plot.on_ray(t));
            if let Some(case) = cases.iter().find(|case| case.id == object) {
                plot.outline(sheet, case, Look::MET.outline());
            }
            sheet.dot(Look::ANSWER, plot.on_ray(t));
            sheet.dot(Look::ANSWER, plot.on_axis(t, 0.0));
        });
    }
    let mut sentences: Vec<String> = cases.iter().map(Case::sentence).collect();
    sentences.extend(said);
    Ok(sentences.join(" "))
}

/// Where t is on the sheet, for the ray above and for the axis below.
struct Plot<'a> {
    body: Frame,
    ray: Ray,
    up: glam::DVec3,
    /// Units of the sheet for 1.
    scale: f64,
    /// The smallest and the largest t.
    t: [f64; 2],
    /// The height on the sheet of the ray and of the axis.
    ray_y: f64,
    axis_y: f64,
    /// The largest f that is drawn.
    top: f64,
    /// The lowest line of the graph.
    bottom: f64,
    cases: &'a [Case],
}

/// What stands under a sphere: lines of letters.
fn lines_of(case: &Case, room: f64, book: bool) -> Vec<Text> {
    let mut lines = Vec::new();
    if book {
        lines.push(formula(case.compared()));
        lines.push(formula("b² - 4ac = ") + parabola::discriminant(&case.test));
    }
    if book {
        lines.extend(formula(&case.verdict()).wrapped(room));
    } else {
        lines.push(case.in_a_word().into());
    }
    lines
}

impl<'a> Plot<'a> {
    fn new(figure: &Figure, sheet: &Sheet, body: Frame, cases: &'a [Case], ray: Ray) -> Self {
        /// Beyond the outermost sphere, of a radius.
        const BEYOND: f64 = 0.5;
        /// The top of the graph, of the square of the radius: all curves show their bend, and the one above the axis is whole.
        const TOP: f64 = 0.75;
        let up = figure.scene.camera.up;
        let up = up.reject_from(ray.direction).normalize_or_zero();
        let ends = |of: fn(f64, f64) -> f64, sign: f64| {
            let reach = cases
                .iter()
                .map(|case| case.middle() + sign * (1.0 + BEYOND) * case.sphere.radius);
            reach.fold(0.0, of)
        };
        let t = [ends(f64::min, -1.0), ends(f64::max, 1.0)];
        let above = |case: &Case| (case.sphere.center - ray.origin).dot(up);
        let highest = cases.iter().map(|case| above(case) + case.sphere.radius);
        let highest = highest.fold(0.3, f64::max);
        let lowest = cases.iter().map(|case| above(case) - case.sphere.radius);
        let lowest = lowest.fold(-0.3, f64::min);
        let squares = cases.iter().map(|case| case.sphere.radius.powi(2));
        let top = TOP * squares.fold(0.0, f64::max);
        let least = cases.iter().map(Case::least).fold(0.0, f64::min);

        let book = sheet.width == Width::Book;
        let line = sheet.line_height();
        // letters at the roots, and between the two parts
        let gap = 1.6 * line;
        let mut scale = body.size().x / (t[1] - t[0]);
        // the narrower the columns, the more lines
        for _ in 0..3 {
            let room = column(cases, scale) / sheet.letters;
            let lines = cases.iter().map(|case| lines_of(case, room, book).len());
            let below = lines.max().unwrap_or(0) as f64 * line + gap;
            let height = body.size().y - below - gap;
            scale = scale.min(height / (highest - lowest + top - least));
        }
        let ray_y = body.min.y + scale * highest;
        let axis_y = ray_y - scale * lowest + gap + scale * top;
        Self {
            body,
            ray,
            up,
            scale,
            t,
            ray_y,
            axis_y,
            top,
            bottom: axis_y - scale * least + gap,
            cases,
        }
    }

    fn x(&self, t: f64) -> f64 {
        self.body.middle().x + self.scale * (t - f64::midpoint(self.t[0], self.t[1]))
    }

    fn on_ray(&self, t: f64) -> DVec2 {
        DVec2::new(self.x(t), self.ray_y)
    }

    fn on_axis(&self, t: f64, f: f64) -> DVec2 {
        DVec2::new(self.x(t), self.axis_y - self.scale * f)
    }

    /// So far the ray goes before it is known what it hits.
    fn half(&self) -> DVec2 {
        self.on_ray(0.45)
    }

    fn axes(&self, sheet: &mut Sheet, stage: StageId) {
        let [low, high] = self.t;
        let origin = self.on_ray(0.0);
        sheet.at(stage, |sheet| {
            sheet.line(Look::LINE_OF_RAY, self.on_ray(low), self.on_ray(high));
            sheet.arrow(Look::RAY, origin, self.half());
            sheet.dot(Look::RAY, origin);
            sheet.arrow(Look::THIN, self.on_axis(low, 0.0), self.on_axis(high, 0.0));
            let end = self.on_axis(high, 0.0) - DVec2::new(0.0, 0.8 * sheet.letters);
            sheet.text(Anchor::End, end, formula("t"));
            let zero = self.on_axis(0.0, 0.0);
            let tick = DVec2::new(0.0, 0.4 * sheet.letters);
            sheet.line(Look::THIN, zero - tick, zero + tick);
            sheet.line(Look::HIDDEN, origin, zero - tick);
            sheet.label(self.body, zero, DVec2::Y, "0");
            sheet.label(self.body, origin, DVec2::new(0.3, 1.0), formula("R"));
        });
    }

    fn place(&self, case: &Case) -> DVec2 {
        let above = (case.sphere.center - self.ray.origin).dot(self.up);
        self.on_ray(case.middle()) - DVec2::new(0.0, self.scale * above)
    }

    fn outline(&self, sheet: &mut Sheet, case: &Case, look: Look) {
        let radius = self.scale * case.sphere.radius;
        sheet.circle(look, self.place(case), radius);
    }

    fn sphere(&self, sheet: &mut Sheet, case: &Case, stage: StageId) {
        sheet.at(stage, |sheet| {
            self.outline(sheet, case, Look::OBJECT);
            sheet.text(
                Anchor::Middle,
                self.name_at(sheet, case),
                case.name.as_str(),
            );
        });
    }

    /// The name stands in the sphere, off the ray.
    fn name_at(&self, sheet: &Sheet, case: &Case) -> DVec2 {
        let at = self.place(case);
        let off = 1.1 * sheet.letters;
        let is_on_ray = (at.y - self.ray_y).abs() < off;
        let up = if is_on_ray { off } else { 0.0 };
        at - DVec2::new(0.0, up)
    }

    fn parabola(&self, sheet: &mut Sheet, case: &Case) {
        /// The number of straight pieces that look smooth.
        const PIECES: u32 = 32;
        let (middle, least, a) = (case.middle(), case.least(), case.test.a);
        let half = ((self.top - least).max(0.0) / a).sqrt();
        let at = |piece: u32| {
            let from_vertex = half * (2.0 * f64::from(piece) / f64::from(PIECES) - 1.0);
            self.on_axis(middle + from_vertex, least + a * from_vertex * from_vertex)
        };
        sheet.path(Look::THIN.wide(1.75), (0..=PIECES).map(at).collect());
        for (_, root) in parabola::roots(&case.test) {
            let ends = [self.on_ray(root.t), self.on_axis(root.t, 0.0)];
            sheet.line(Look::HELP.wide(0.75), ends[0], ends[1]);
            for at in ends {
                if root.verdict == RootVerdict::Chosen {
                    sheet.small_dot(Look::RAY, at);
                } else {
                    sheet.cross(Look::REJECTED, at);
                }
            }
        }
    }

    /// The roots with their numbers, and what follows from them.
    fn words(&self, sheet: &mut Sheet, case: &Case, stage: StageId) {
        let line = sheet.line_height();
        let book = sheet.width == Width::Book;
        sheet.at(stage, |sheet| {
            let roots = parabola::roots(&case.test);
            let places = [DVec2::new(-1.0, 0.6), DVec2::new(1.0, 0.6)];
            let towards = |place: usize| match roots.len() {
                1 => DVec2::Y,
                _ => places[place.min(1)],
            };
            // the names of a slide are for roots that count: the others have their crosses
            let is_named = book
                || roots
                    .iter()
                    .any(|(_, root)| root.verdict == RootVerdict::Chosen);
            let named = if is_named { &roots[..] } else { &[] };
            for (place, (name, root)) in named.iter().enumerate() {
                let at = self.on_axis(root.t, 0.0);
                let text = if book {
                    Text::from(quantity(root.t))
                } else {
                    formula(name)
                };
                sheet.label(self.body, at, towards(place), text);
            }
            let room = column(self.cases, self.scale) / sheet.letters;
            for (number, text) in lines_of(case, room, book).into_iter().enumerate() {
                let y = self.bottom + (number as f64 + 0.5) * line;
                let at = DVec2::new(self.x(case.middle()), y);
                sheet.text(Anchor::Middle, at, text);
            }
        });
    }
}

/// How wide the words under a sphere may be: up to those of the next one.
fn column(cases: &[Case], scale: f64) -> f64 {
    /// Between two columns, of their distance.
    const GAP: f64 = 0.08;
    let mut middles: Vec<f64> = cases.iter().map(Case::middle).collect();
    middles.sort_by(f64::total_cmp);
    let between = middles.windows(2).map(|pair| pair[1] - pair[0]);
    let least = between.fold(f64::INFINITY, f64::min);
    let least = if least.is_finite() { least } else { 4.0 };
    (1.0 - GAP) * scale * least
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::figure::read_back::{DRAWN, ReadBack, ball};

    #[test]
    fn each_root_stands_straight_below_its_point_on_the_ray() {
        // the ray starts in (−10, 0, 0): half chords of √(1.5² − 0.9²) = 1.2 around t = 10 and t = −4
        let objects = json!([
            ball("A", [0.0, 0.9, 0.0], 1.5),
            ball("B", [-14.0, 0.9, 0.0], 1.5)
        ]);
        let (drawn, _) = ReadBack::of_ray_along_x(&objects, json!({"kind": "root-cases"}));
        // the hit, above and below
        let hits = drawn.dots("answer");
        let [above, below] = hits[..] else {
            panic!("{hits:?}");
        };
        assert!((above.x - below.x).abs() < DRAWN && above.y < below.y);
        // farther and both behind: at −5.2, −2.8 and 11.2, each twice
        let crosses = drawn.crosses("rejected");
        assert_eq!(crosses.len(), 6, "{crosses:?}");
        let origin = drawn.dots("ink")[0];
        let scale = (above.x - origin.x) / 8.8;
        for t in [-5.2, -2.8, 11.2] {
            let x = origin.x + scale * t;
            let found = crosses.iter().filter(|at| (at.x - x).abs() < 2.0 * DRAWN);
            assert_eq!(found.count(), 2, "{t} at {x}: {crosses:?}");
        }
        let texts = drawn.texts().join(" ");
        // b² − 4ac = 4·1.2²
        assert!(texts.contains("= 5.76"), "{texts}");
        assert!(texts.contains("8.8") && texts.contains("−5.2"), "{texts}");
    }
}
