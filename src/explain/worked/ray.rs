//! One ray: where it starts, what it is tested against, what becomes of it.

use glam::DVec3;

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::page::printable;
use crate::explain::worked::Solution;
use crate::explain::worked::misses::{FOLDED_FROM, LONGEST_UNFOLDED};
use crate::explain::worked::steps::{Course, Step, Test, steps};
use crate::scene::PrimitiveId;
use crate::trace::{Event, Kind, Nearest, Outcome, Purpose, RayEnd, RayStart};

impl Solution<'_> {
    /// The whole working of a ray, with the rays sent on from it indented below.
    pub(super) fn ray(&mut self, place: usize) {
        let node = self.tree.rays[place].clone();
        let steps = steps(&node.items, self.records);
        let shade = steps.iter().find_map(|step| match step {
            Step::Shade(shade) => Some(*shade),
            _ => None,
        });
        let mut course = Course {
            place,
            start: node.start,
            aligned: self.aligned_ray(&steps, node.start),
            nearest: None,
            nearest_object: None,
            shade,
            end: node.end,
            arrived: false,
            slabs_in_full: self.slabs_in_full(&steps),
            last: None,
        };
        self.page.line(
            Tone::Heading,
            self.ray_title(node.id, node.parent, node.start),
        );
        self.page.indent();
        if let Some(start) = node.start.filter(|_| self.shows(Kind::Ray)) {
            self.ray_start(&start, node.parent);
        }
        let tests = steps
            .iter()
            .filter(|step| matches!(step, Step::Test { .. }))
            .count();
        let fold = !self.options.all && FOLDED_FROM <= tests;
        let mut rest = steps.as_slice();
        while let Some((step, after)) = rest.split_first() {
            rest = after;
            match step {
                Step::Test {
                    object,
                    test,
                    nearest,
                } => {
                    self.test(*object, test, *nearest, &mut course);
                    let (misses, length) = misses_at_start(rest);
                    if fold && test.hit().is_none() && LONGEST_UNFOLDED <= misses {
                        // the first of the run was shown, the others are summed up
                        let (run, after) = rest.split_at(length);
                        self.folded(run, &course);
                        rest = after;
                    }
                }
                Step::Ray(child) => {
                    self.arrive(&mut course);
                    if self.options.ray.is_none() {
                        self.page.gap();
                        self.ray(*child);
                        self.page.gap();
                    } else {
                        self.child_in_short(*child);
                    }
                }
                Step::Light(light) => {
                    self.arrive(&mut course);
                    self.light(light, &course);
                }
                Step::Refraction(refraction) => {
                    self.arrive(&mut course);
                    self.refraction(refraction, &course);
                }
                Step::Shade(shade) => {
                    self.arrive(&mut course);
                    self.shade(shade);
                }
                Step::Search(event) => {
                    self.search(event, &course);
                    course.last = Some(*event);
                }
                Step::Carried(event) => self.carried(event),
                Step::Nearest(hit) => self.nearest(*hit, &mut course),
            }
        }
        if let Some(end) = node.end {
            self.ray_end(&end, &course);
        }
        self.page.outdent();
    }

    fn ray_title(&self, id: u32, parent: Option<u32>, start: Option<RayStart>) -> String {
        let Some(start) = start else {
            return format!("Ray {id}");
        };
        let what = match start.purpose {
            Purpose::Eye => "from the eye".into(),
            Purpose::Shadow => match start.light {
                Some(light) => format!("to the light {}", self.light_name(light)),
                None => "to a light".into(),
            },
            Purpose::Reflected => "reflected".into(),
            Purpose::Refracted => "refracted".into(),
            Purpose::Scattered => "scattered".into(),
            Purpose::Light => match start.light {
                Some(light) => format!("from the light {}", self.light_name(light)),
                None => "on from the surface".into(),
            },
            Purpose::Connection => "between the two paths".into(),
        };
        let of = parent.map_or(String::new(), |parent| {
            format!(", sent on from ray {parent}")
        });
        format!("Ray {id}: {what}{of}, depth {}", start.depth)
    }

    /// What a light is called.
    pub(super) fn light_name(&self, light: u32) -> String {
        let light = self.scene.lights.get(light as usize);
        light.map_or("?".into(), |light| printable(&light.name))
    }

    /// Equation (i) with the ray's numbers, and where they come from.
    fn ray_start(&mut self, start: &RayStart, parent: Option<u32>) {
        let d = Digits::USUAL;
        let (origin, direction) = (start.ray.origin, start.ray.direction);
        match start.purpose {
            Purpose::Eye => {
                if let Some(window) = start.window_t {
                    // a length near 1 is told with the digits in which it differs from 1
                    let length = Digits::for_difference(window, window - 1.0).number(window);
                    let to_window = d.vector(window * direction);
                    self.page
                        .plain(format!("P - COP = {to_window}, of length {length}"));
                    self.page.plain(format!(
                        "Δ = (P - COP)/{length} = {}: normalised, so that t is a distance and the \
                         window lies at t = {length}",
                        d.vector(direction)
                    ));
                }
            }
            Purpose::Shadow => {
                let lights = &self.scene.lights;
                let lamp = start.light.and_then(|light| lights.get(light as usize));
                let text = lamp.map_or(String::new(), |lamp| to_light(lamp.position, origin));
                self.page
                    .plain(format!("Δ = L{text} = {}", d.vector(direction)));
            }
            Purpose::Reflected => {
                let from = parent.and_then(|parent| self.surface_of(parent));
                match from {
                    Some((incoming, normal)) => {
                        let cosine = incoming.dot(normal);
                        self.page.plain(format!(
                            "Δ = Δ' - 2(Δ'·N)N = {} - 2·{}·{} = {}, with Δ' the direction of the ray \
                             that was sent on",
                            d.vector(incoming),
                            d.factor(cosine),
                            d.vector(normal),
                            d.vector(direction)
                        ));
                    }
                    None => self.page.plain(format!("Δ = {}", d.vector(direction))),
                }
            }
            Purpose::Refracted => self.page.plain(format!("Δ = T = {}", d.vector(direction))),
            Purpose::Scattered | Purpose::Light | Purpose::Connection => {
                self.page.plain(format!("Δ = {}", d.vector(direction)));
            }
        }
        self.page.plain(format!(
            "(x, y, z) = {} + t·{} … (i){}",
            d.vector(origin),
            d.vector(direction),
            range_text(start)
        ));
    }

    /// Direction and normal where a ray met its surface.
    fn surface_of(&self, ray: u32) -> Option<(DVec3, DVec3)> {
        let node = &self.tree.rays[self.tree.find(ray)?];
        let shade = steps(&node.items, self.records)
            .into_iter()
            .find_map(|step| match step {
                Step::Shade(shade) => Some(shade),
                _ => None,
            })?;
        Some((node.start?.ray.direction, shade.normal))
    }

    /// The test of one object, in full if it hits or all is wanted, else in short.
    fn test(
        &mut self,
        object: PrimitiveId,
        test: &Test,
        nearest: Option<Nearest>,
        course: &mut Course,
    ) {
        if self.shows_test(test) {
            let full = self.options.all || test.hit().is_some();
            match test {
                Test::Sphere(working) => self.sphere(object, working, course, full),
                Test::Ellipsoid(working) => self.ellipsoid(object, working, course, full),
                Test::Cone(working) => self.cone(object, working, course, full),
                Test::Box(working) => self.slabs(object, working, course),
                Test::Polygon {
                    plane,
                    edges,
                    inside,
                } => self.polygon(
                    object,
                    (plane.as_ref(), edges, inside.as_ref()),
                    course,
                    full,
                ),
            }
        }
        let shadow = course
            .start
            .is_some_and(|start| start.purpose == Purpose::Shadow);
        if let Some(hit) = nearest {
            self.nearest(hit, course);
        } else if let Some(first) = course.nearest_object
            && test.hit().is_some()
            && !shadow
            && self.shows(Kind::Nearest)
        {
            let first = self.name(first);
            let text = format!("→ as near as {first}, which comes first in the scene and stays");
            self.page.indented(|page| page.line(Tone::Refused, text));
        }
    }

    /// A hit became the nearest.
    fn nearest(&mut self, hit: Nearest, course: &mut Course) {
        if self.shows(Kind::Nearest) {
            let text = match hit.replaced {
                None => "→ the nearest hit so far".into(),
                Some(old) => {
                    format!("→ nearer than {}: the nearest hit so far", self.name(old))
                }
            };
            self.page.indented(|page| page.line(Tone::Found, text));
        }
        course.nearest = Some(hit.t);
        course.nearest_object = Some(hit.object);
    }

    fn shows_test(&self, test: &Test) -> bool {
        match test {
            Test::Sphere(_) => self.shows(Kind::SphereTest),
            Test::Ellipsoid(_) => self.shows(Kind::EllipsoidTest),
            Test::Cone(_) => self.shows(Kind::ConeTest),
            Test::Box(_) => self.shows(Kind::BoxTest),
            Test::Polygon { .. } => {
                self.shows(Kind::PlaneTest)
                    || self.shows(Kind::Edge)
                    || self.shows(Kind::PolygonTest)
            }
        }
    }

    /// A ray that is not told here: its purpose and its end.
    fn child_in_short(&mut self, place: usize) {
        let node = &self.tree.rays[place];
        let title = self.ray_title(node.id, node.parent, node.start);
        let end = node
            .end
            .map_or(String::new(), |end| format!(": {}", self.outcome(&end)));
        self.page
            .line(Tone::Aside, format!("{title}{end} (--ray {})", node.id));
    }

    fn outcome(&self, end: &RayEnd) -> String {
        let d = Digits::USUAL;
        let object = end.object.map_or("an object".into(), |id| self.name(id));
        let at = end
            .t
            .map_or(String::new(), |t| format!(" at t = {}", d.number(t)));
        match end.outcome {
            Outcome::Hit => format!("meets {object}{at}"),
            Outcome::Miss => "meets no object".into(),
            Outcome::Blocked => format!("blocked by {object}{at}: the point lies in its shadow"),
            Outcome::ReachesLight => "nothing in between: the light is visible".into(),
            Outcome::DepthLimit => format!(
                "not traced, since the depth limit is {}: no light comes this way",
                self.scene.max_depth
            ),
            Outcome::Absorbed => format!("meets {object}{at}, which absorbs it"),
            Outcome::CutOff => {
                format!("meets {object}{at}: one surface more than a path may meet")
            }
            Outcome::Connects => "nothing in between".into(),
        }
    }

    /// What the ray brings back.
    fn ray_end(&mut self, end: &RayEnd, course: &Course) {
        if !self.shows(Kind::RayEnd) {
            return;
        }
        let d = Digits::USUAL;
        let tone = match end.outcome {
            Outcome::Hit | Outcome::ReachesLight | Outcome::Connects => Tone::Found,
            Outcome::Miss
            | Outcome::Blocked
            | Outcome::DepthLimit
            | Outcome::Absorbed
            | Outcome::CutOff => Tone::Refused,
        };
        match (end.outcome, end.colour) {
            (Outcome::Hit, Some(colour)) => {
                let sum = self.sum(course).unwrap_or_default();
                self.page
                    .line(tone, format!("I = {sum}{}", d.vector(colour)));
            }
            (Outcome::Miss, Some(colour)) => self.page.line(
                tone,
                format!("→ no object is met: the background, {}", d.vector(colour)),
            ),
            _ => self.page.line(tone, format!("→ {}", self.outcome(end))),
        }
    }
}

/// L = (light − p)/|light − p|, with its numbers.
pub(super) fn to_light(light: DVec3, point: DVec3) -> String {
    let distance = (light - point).length();
    let d = Digits::for_difference(light.abs().max_element(), distance);
    format!(
        " = (light - p)/|light - p| = [{} - {}]/{}",
        d.vector(light),
        d.vector(point),
        d.number(distance)
    )
}

/// Which t count, in words.
fn range_text(start: &RayStart) -> String {
    let d = Digits::USUAL;
    let low = if start.range.min == 0.0 {
        "t > 0".into()
    } else {
        format!("t ≥ ε = {}", d.number(start.range.min))
    };
    if start.range.max.is_finite() {
        let end = match start.purpose {
            Purpose::Shadow => ", just short of the light",
            _ => "",
        };
        format!(", for {low} up to {}{end}", d.number(start.range.max))
    } else {
        format!(", for {low}")
    }
}

/// How many tests without a hit come next, and over how many steps: an aligned object comes before its test.
fn misses_at_start(steps: &[Step]) -> (usize, usize) {
    let (mut misses, mut length) = (0, 0);
    for (at, step) in steps.iter().enumerate() {
        match step {
            Step::Test { test, .. } if test.hit().is_none() => {
                misses += 1;
                length = at + 1;
            }
            Step::Search(Event::Aligned(_) | Event::Listed { .. } | Event::Mailbox { .. }) => {}
            _ => break,
        }
    }
    (misses, length)
}
