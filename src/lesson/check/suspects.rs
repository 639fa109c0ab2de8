//! Which mistake gives what a line has: each wrong function is asked on the same ray, object or light.

use crate::geometry::TRange;
use crate::lesson::check::on_ray::OnRay;
use crate::lesson::check::options::COLOUR;
use crate::lesson::check::reference::{Expected, ExpectedRay, Reference};
use crate::lesson::check::value::{Fields, Value};
use crate::lesson::check::way::Way;
use crate::mistake::{Mistake, Wrong, mistakes};
use crate::scene::{PrimitiveId, Shape};
use crate::structure::Across;
use crate::trace::{Event, LightTerm, Purpose};
use crate::tracer::simple::{self, Parts};
use crate::tracer::{EPSILON, Surface};

/// A line that differs, with all that led to it.
pub(super) struct Situation<'a, 's> {
    pub(super) reference: &'a Reference<'a, 's>,
    pub(super) pixel: [u32; 2],
    pub(super) expected: &'a Expected,
    pub(super) rays: &'a [ExpectedRay],
    /// The ray's place among them.
    pub(super) ray: Option<usize>,
    pub(super) on: Option<&'a OnRay>,
    /// All rays on which the log may have computed it.
    pub(super) contexts: &'a [OnRay],
    pub(super) yours: &'a Fields,
    /// The quantity that differs first.
    pub(super) key: &'a str,
    pub(super) tolerance: f64,
    /// Does the line differ, or does it agree with what is expected?
    pub(super) differs: bool,
    /// Does the ray go on beyond the light that it is cast to?
    pub(super) is_endless: bool,
    /// What is free in a program beside its mistake.
    pub(super) way: Way,
}

impl Situation<'_, '_> {
    /// Which t count on a ray.
    fn range(&self, on: &OnRay) -> TRange {
        let max = if self.is_endless {
            f64::INFINITY
        } else {
            on.range.max
        };
        TRange { max, ..on.range }
    }

    /// Does it belong to an eye ray, or to the pixel?
    fn is_of_eye(&self) -> bool {
        self.ray.is_none_or(|ray| self.rays[ray].parent.is_none())
    }

    /// Is the quantity a colour with all that its rays bring?
    fn is_of_colour(&self) -> bool {
        matches!(self.expected.event, Event::PixelColour(_)) || self.key == "colour"
    }
}

/// The mistakes that may still be it.
#[derive(Clone, Debug, Default)]
pub(in crate::lesson::check) struct Suspects(Vec<Suspect>);

/// A mistake with how many lines speak for it and against it.
#[derive(Clone, Copy, Debug)]
struct Suspect {
    mistake: &'static Mistake,
    /// Lines that differ, and have what the mistake gives.
    explained: u64,
    /// Lines that have something else.
    against: u64,
}

/// At an edge of an object or of a shadow a pixel of another program may see the other side. One line in so many may
/// speak against a mistake.
const EDGES: u64 = 32;

impl Suspects {
    /// All mistakes.
    pub(super) fn all() -> Self {
        let suspect = |mistake| Suspect {
            mistake,
            explained: 0,
            against: 0,
        };
        Self(mistakes().map(suspect).collect())
    }

    /// Those stay that say what a line says, or nothing against it, but for a few lines.
    pub(super) fn hear(&mut self, situation: &Situation<'_, '_>) {
        /// Before many lines are heard, so many may be against it.
        const FIRST: u64 = 1;
        self.0.retain_mut(|suspect| {
            match said(suspect.mistake, situation) {
                Said::TheSame => suspect.explained += u64::from(situation.differs),
                Said::Nothing => {}
                Said::Otherwise => suspect.against += 1,
            }
            suspect.against <= FIRST + suspect.explained / EDGES
        });
    }

    /// The one with the least against it that explains what differs; of several the first.
    pub(super) fn found(&self) -> Option<&'static Mistake> {
        let likely = |of: &&Suspect| 0 < of.explained && EDGES * of.against <= of.explained;
        let found = self.0.iter().filter(likely).min_by_key(|of| of.against);
        found.map(|of| of.mistake)
    }
}

/// How close what a wrong function gives must be to what a line has, in tolerances.
const CLOSE: f64 = 3.0;

/// What a wrong function says of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Said {
    TheSame,
    Nothing,
    Otherwise,
}

/// What it says on the ray that fits it best, or in the way that fits it best.
fn said(mistake: &Mistake, situation: &Situation<'_, '_>) -> Said {
    if situation.is_of_colour() {
        let said = Way::of(&mistake.wrong)
            .map(|way| said_on_ray(mistake, &Situation { way, ..*situation }));
        return best(&said.collect::<Vec<_>>());
    }
    // a function that is not told where the light is finds what lies beyond it
    let on_ray = |on| {
        [false, true].map(|is_endless| {
            let situation = Situation {
                on,
                is_endless,
                ..*situation
            };
            said_on_ray(mistake, &situation)
        })
    };
    let own = [situation.on].into_iter();
    let said: Vec<Said> = own
        .chain(situation.contexts.iter().map(Some))
        .flat_map(on_ray)
        .collect();
    best(&said)
}

fn best(said: &[Said]) -> Said {
    [Said::TheSame, Said::Nothing]
        .into_iter()
        .find(|of| said.contains(of))
        .unwrap_or(Said::Otherwise)
}

/// Is it a surface that hits the ray that starts on it? Which side of 0 such a t lies on is rounding, so it tells no two
/// mistakes apart.
pub(super) fn is_on_start(situation: &Situation<'_, '_>) -> bool {
    /// No ε of a program is larger.
    const NEAR: f64 = 1e-3;
    let t = ["t", "root", "near"]
        .iter()
        .find_map(|key| situation.yours.number(key));
    t.is_some_and(|t| t.abs() < NEAR)
}

fn said_on_ray(mistake: &Mistake, situation: &Situation<'_, '_>) -> Said {
    let Some(wrong) = predicted(&mistake.wrong, situation) else {
        // what a ray of a mirror brings is not computed again
        let is_spawned = situation.key == "colour" && !situation.is_of_eye();
        // a function that has no part in what differs is not it
        return if situation.differs && !is_spawned {
            Said::Otherwise
        } else {
            Said::Nothing
        };
    };
    let yours = situation.yours;
    let tolerance = CLOSE * situation.tolerance;
    let are_same = |key: &str, one: &Value, other: &Value| match key {
        "raw" | "clamped" | "colour" => one.is(other, tolerance.max(COLOUR)),
        // rounded or cut off
        "rgb" => one.is(other, tolerance) || one.is_within(other, 1.0),
        _ => one.is(other, tolerance),
    };
    let of_key = |key: &str| match (wrong.get(key), yours.get(key)) {
        (Some(wrong), Some(yours)) if are_same(key, yours, wrong) => {
            // where it changes nothing it explains nothing
            let right = situation.expected.fields.get(key);
            let changes = right.is_none_or(|right| !are_same(key, wrong, right));
            if changes || !situation.differs {
                Said::TheSame
            } else {
                Said::Nothing
            }
        }
        (Some(_), Some(_)) => Said::Otherwise,
        // no hit where the line has one
        (None, Some(_)) if ["t", "object"].contains(&key) => Said::Otherwise,
        (None, None) if ["t", "object"].contains(&key) => Said::TheSame,
        _ => Said::Nothing,
    };
    if wrong
        .0
        .iter()
        .any(|(key, _)| of_key(key) == Said::Otherwise)
    {
        return Said::Otherwise;
    }
    of_key(situation.key)
}

/// The fields of an event.
fn fields_of(situation: &Situation<'_, '_>, event: Event) -> Fields {
    let mut fields = Fields::of_event(event, &situation.reference.names);
    // which of several reasons a test has for its verdict is not the wrong function's
    fields.0.retain(|(key, _)| {
        ![
            "kind",
            "step",
            "pixel",
            "ray",
            "verdict",
            "why",
            "near_verdict",
            "far_verdict",
        ]
        .contains(&key.as_str())
    });
    fields
}

fn one(key: &str, value: Value) -> Fields {
    Fields(vec![(key.into(), value)])
}

fn vector(value: glam::DVec3) -> Value {
    Value::List(value.to_array().into())
}

/// What the line would have with the wrong function; `None` if the function has no part in it.
fn predicted(wrong: &Wrong, situation: &Situation<'_, '_>) -> Option<Fields> {
    let scene = situation.reference.scene;
    match &situation.expected.event {
        Event::Pixel(_) => eye_direction(wrong, situation).and_then(|direction| {
            let point = situation.yours.vector("point")?;
            let distance = (point - scene.camera.cop).length();
            Some(one(
                "point",
                vector(scene.camera.cop + distance * direction),
            ))
        }),
        Event::Ray(start) => {
            let direction = match start.purpose {
                Purpose::Eye => eye_direction(wrong, situation)?,
                _ => spawned(wrong, situation)?,
            };
            let length = situation.yours.vector("direction")?.length();
            Some(one("direction", vector(length * direction)))
        }
        Event::SphereTest { object, .. } => of_sphere(wrong, situation, *object),
        Event::PlaneTest { object, .. } => {
            if let Wrong::Hit(hit) = wrong {
                let on = situation.on?;
                // outside the polygon it says nothing of its plane
                return hit(scene.primitive(*object), &on.ray, situation.range(on))
                    .map(|t| root_at(Some(t)));
            }
            let (Wrong::PlaneT(plane_t), Shape::Polygon(polygon)) =
                (wrong, shape(situation, *object))
            else {
                return None;
            };
            let on = situation.on?;
            let t = plane_t(
                polygon,
                &on.ray,
                situation.range(on),
                scene.primitive(*object).sides,
            );
            let mut fields = root_at(t);
            // what the root follows from
            if let (Some(t), Some(denominator)) = (t, situation.yours.number("denominator")) {
                fields.0.push(("root".into(), Value::Number(t)));
                fields
                    .0
                    .push(("numerator".into(), Value::Number(-t * denominator)));
            }
            Some(fields)
        }
        Event::PolygonTest { object, .. } => of_polygon(wrong, situation, *object),
        Event::Nearest(_) | Event::RayEnd(_) if situation.key != "colour" => {
            of_nearest(wrong, situation)
        }
        Event::RayEnd(_) | Event::PixelColour(_) => of_colour(wrong, situation),
        Event::LightTerm(term) => of_light(wrong, situation, term),
        Event::Shade(shade) => {
            let Wrong::Normals(normals) = wrong else {
                return None;
            };
            let ray = &situation.rays[situation.ray?];
            let hit = ray.hit?;
            let found = normals(shape(situation, shade.object), shade.point);
            let surface = Surface::new(scene, &ray.start.ray, ray.start.depth, hit, found);
            Some(one("normal", vector(surface.normal)))
        }
        Event::Refraction(right) => {
            let Wrong::Refract(refract) = wrong else {
                return None;
            };
            let ray = &situation.rays[situation.ray?];
            let normal = ray.shade()?.normal;
            let found = refract(
                ray.start.ray.direction,
                normal,
                right.index_from,
                right.index_to,
            );
            Some(fields_of(situation, Event::Refraction(found)))
        }
        Event::Cell(_) => of_cell(wrong, situation),
        _ => None,
    }
}

fn shape<'a>(situation: &Situation<'a, '_>, object: PrimitiveId) -> &'a Shape {
    &situation.reference.scene.primitive(object).shape
}

/// What a function that gives t or nothing says: the hit, and the verdict.
fn root_at(t: Option<f64>) -> Fields {
    let verdict = if t.is_some() { "hit" } else { "rejected" };
    let t = t.map(|t| ("t".to_owned(), Value::Number(t)));
    let verdict = ("verdict".to_owned(), Value::Text(verdict.into()));
    Fields(t.into_iter().chain([verdict]).collect())
}

/// The unit direction of the pixel's eye ray.
fn eye_direction(wrong: &Wrong, situation: &Situation<'_, '_>) -> Option<glam::DVec3> {
    let Wrong::WindowPoint(window_point) = wrong else {
        return None;
    };
    let [x, y] = situation.pixel.map(f64::from);
    window_point(&situation.reference.scene.camera, x + 0.5, y + 0.5).try_normalize()
}

/// The unit direction of a reflected or refracted ray.
fn spawned(wrong: &Wrong, situation: &Situation<'_, '_>) -> Option<glam::DVec3> {
    let ray = &situation.rays[situation.ray?];
    let before = &situation.rays[ray.parent?];
    let (incoming, normal) = (before.start.ray.direction, before.shade()?.normal);
    match (wrong, ray.start.purpose) {
        (Wrong::Reflect(reflect), Purpose::Reflected) => reflect(incoming, normal).try_normalize(),
        (Wrong::Refract(refract), Purpose::Refracted) => {
            let right = before.events.iter().find_map(|of| match &of.event {
                Event::Refraction(right) => Some(right),
                _ => None,
            })?;
            refract(incoming, normal, right.index_from, right.index_to)
                .direction?
                .try_normalize()
        }
        (Wrong::Normals(normals), Purpose::Reflected) => {
            let scene = situation.reference.scene;
            let hit = before.hit?;
            let found = normals(&scene.primitive(hit.object).shape, before.shade()?.point);
            let surface = Surface::new(scene, &before.start.ray, before.start.depth, hit, found);
            crate::geometry::reflect(incoming, surface.normal).try_normalize()
        }
        (Wrong::LightTerm(light_term), Purpose::Shadow) => {
            let scene = situation.reference.scene;
            let light = scene.lights.get(ray.start.light? as usize)?;
            let shade = before.shade()?;
            let term = light_term(
                light,
                scene.material_of(shade.object),
                shade.point,
                normal,
                -incoming,
            );
            term.to_light.try_normalize()
        }
        _ => None,
    }
}

fn of_sphere(wrong: &Wrong, situation: &Situation<'_, '_>, object: PrimitiveId) -> Option<Fields> {
    let Shape::Sphere(sphere) = shape(situation, object) else {
        return None;
    };
    let on = situation.on?;
    let sides = situation.reference.scene.primitive(object).sides;
    match wrong {
        Wrong::SphereTest(test) => {
            let test = test(sphere, &on.ray, situation.range(on), sides);
            Some(fields_of(situation, Event::SphereTest { object, test }))
        }
        Wrong::Root(root) => Some(root_at(root(sphere, &on.ray, situation.range(on), sides))),
        Wrong::Hit(hit) => {
            let primitive = situation.reference.scene.primitive(object);
            Some(root_at(hit(primitive, &on.ray, situation.range(on))))
        }
        _ => None,
    }
}

fn of_polygon(wrong: &Wrong, situation: &Situation<'_, '_>, object: PrimitiveId) -> Option<Fields> {
    let Shape::Polygon(polygon) = shape(situation, object) else {
        return None;
    };
    match wrong {
        Wrong::Inside(inside) => {
            let on = situation.on?;
            let test = polygon.plane_test(
                &on.ray,
                situation.range(on),
                situation.reference.scene.primitive(object).sides,
            );
            Some(one(
                "inside",
                Value::Flag(inside(polygon, &on.ray, test.chosen()?)),
            ))
        }
        Wrong::DroppedAxis(axis) => {
            let letter = format!("{:?}", axis(polygon.plane().normal)).to_lowercase();
            Some(one("dropped", Value::Text(letter)))
        }
        _ => None,
    }
}

fn of_nearest(wrong: &Wrong, situation: &Situation<'_, '_>) -> Option<Fields> {
    if !wrong.is_part() {
        return None;
    }
    let on = situation.on?;
    let hit = wrong.nearest(situation.reference.scene, &on.ray, situation.range(on));
    let mut fields = Fields::default();
    if let Some(hit) = hit {
        fields.0.push(("t".into(), Value::Number(hit.t)));
        let name = situation.reference.name(hit.object).to_owned();
        fields.0.push(("object".into(), Value::Text(name)));
    }
    Some(fields)
}

fn of_colour(wrong: &Wrong, situation: &Situation<'_, '_>) -> Option<Fields> {
    if !wrong.is_part() {
        return None;
    }
    // the colour of a ray that others spawned is not told by the picture
    if !situation.is_of_eye() {
        return None;
    }
    let program = situation.way.with(wrong);
    let raw = simple::pixel(situation.reference.scene, &program, situation.pixel);
    let clamped = raw.clamp(glam::DVec3::ZERO, glam::DVec3::ONE);
    Some(Fields(match situation.expected.event {
        Event::RayEnd(_) => vec![("colour".into(), vector(raw))],
        _ => {
            let mut fields = vec![
                ("raw".to_owned(), vector(raw)),
                ("clamped".to_owned(), vector(clamped)),
            ];
            if situation.key == "rgb" {
                let rgb = (255.0 * clamped).round();
                fields.push(("rgb".into(), vector(rgb)));
            }
            fields
        }
    }))
}

fn of_light(wrong: &Wrong, situation: &Situation<'_, '_>, right: &LightTerm) -> Option<Fields> {
    let scene = situation.reference.scene;
    let ray = &situation.rays[situation.ray?];
    let shade = ray.shade()?;
    let light = scene.lights.get(right.light as usize)?;
    let terms = |term| {
        let mut fields = fields_of(situation, Event::LightTerm(LightTerm { term, ..*right }));
        // which of them count is another question
        fields.0.retain(|(key, _)| key != "visibility");
        Some(fields)
    };
    let material = scene.material_of(shade.object);
    let to_viewer = -ray.start.ray.direction;
    match wrong {
        Wrong::LightTerm(light_term) => terms(light_term(
            light,
            material,
            shade.point,
            shade.normal,
            to_viewer,
        )),
        Wrong::Normals(normals) => {
            let found = normals(shape(situation, shade.object), shade.point);
            let surface = Surface::new(scene, &ray.start.ray, ray.start.depth, ray.hit?, found);
            terms(light.phong(material, shade.point, surface.normal, to_viewer))
        }
        // behind the surface nobody asks
        Wrong::Blocked(_) | Wrong::LeavesFrom(_) if right.term.n_dot_l <= 0.0 => None,
        Wrong::Blocked(_) | Wrong::LeavesFrom(_) => {
            let hit = ray.hit?;
            let normals = shape(situation, hit.object).normals(shade.point);
            let surface = Surface::new(scene, &ray.start.ray, ray.start.depth, hit, normals);
            let (from, epsilon) = match wrong {
                Wrong::LeavesFrom(_) => wrong.leaves_from(&surface),
                _ => (shade.point, EPSILON),
            };
            let shadow = crate::geometry::Ray::new(from, right.term.to_light);
            let range = TRange {
                min: epsilon,
                max: right.term.distance * (1.0 - EPSILON),
            };
            let word = if wrong.blocked(scene, &shadow, range) {
                "shadowed"
            } else {
                "visible"
            };
            Some(one("visibility", Value::Text(word.into())))
        }
        _ => None,
    }
}

/// The cell that follows by a wrong step from the one before.
fn of_cell(wrong: &Wrong, situation: &Situation<'_, '_>) -> Option<Fields> {
    let ray = &situation.rays[situation.ray?];
    let mut before = None;
    for of in &ray.events {
        if of.step == situation.expected.step {
            break;
        }
        if let Event::Cell(visit) = &of.event {
            before = Some(visit.step);
        }
    }
    let before = before?;
    let direction = ray.start.ray.direction.to_array();
    match wrong {
        Wrong::PlanesCrossed(crossed) => {
            let across = crossed(before.next);
            let axes = axes_of(across);
            let moved: [f64; 3] = std::array::from_fn(|axis| {
                let step = if axes[axis] {
                    1f64.copysign(direction[axis])
                } else {
                    0.0
                };
                f64::from(before.cell[axis]) + step
            });
            Some(one("cell", Value::List(moved.into())))
        }
        _ => None,
    }
}

fn axes_of(across: Across) -> [bool; 3] {
    let name = format!("{across:?}");
    ['X', 'Y', 'Z'].map(|axis| name.contains(axis))
}
