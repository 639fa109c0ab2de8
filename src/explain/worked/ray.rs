//! One ray: where it starts, what it is tested against, what becomes of it.

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::printable;
use crate::explain::worked::Solution;
use crate::explain::worked::misses::{FOLDED_FROM, LONGEST_UNFOLDED};
use crate::explain::worked::steps::{Course, Step, Test, slab_rays, steps};
use crate::scene::PrimitiveId;
use crate::trace::{Event, Kind, Nearest, Outcome, Purpose, RayEnd, RayNode, RayStart};

impl Solution<'_> {
    /// The whole working of a ray, with the rays sent on from it indented below.
    pub(super) fn ray(&mut self, place: usize) {
        let node = self.tree.rays[place].clone();
        let steps = steps(&node.items, self.records);
        let shade = steps.iter().find_map(|step| match step {
            Step::Shade(shade) => Some(*shade),
            _ => None,
        });
        let photon = self.photon_of(&node);
        let of_photon = photon.zip(node.start);
        let of_photon =
            of_photon.map(|(photon, start)| self.normal_towards(&photon, -start.ray.direction));
        let mut course = Course {
            place,
            start: node.start,
            aligned: self.aligned_ray(&steps, node.start),
            nearest: None,
            nearest_object: None,
            shade,
            photon,
            normal: shade.map(|shade| shade.normal).or(of_photon),
            end: node.end,
            arrived: false,
            slabs_in_full: self.slabs_in_full(&steps),
            slab_rays: slab_rays(&steps),
            last: None,
            grid: None,
            slabs: Vec::new(),
        };
        self.page.line(Tone::Heading, self.ray_title(place));
        self.page.indent();
        if let Some(start) = node.start.filter(|_| self.shows(Kind::Ray)) {
            self.ray_start(place, &start, node.parent);
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
                Step::Search(event) => self.search_step(event, &mut course),
                Step::Photon(photon) => {
                    self.arrive(&mut course);
                    self.photon(photon, &course);
                }
                Step::Stored(stored) => {
                    self.arrive(&mut course);
                    self.stored(stored);
                }
                Step::Gathered { nearby, gathered } => {
                    self.arrive(&mut course);
                    self.gather(nearby, gathered.as_ref());
                }
                Step::Arrival(arrival) => self.seen(arrival),
                Step::Nearest(hit) => self.nearest(*hit, &mut course),
            }
        }
        if let Some(end) = node.end {
            self.ray_end(&end, &course);
        }
        self.page.outdent();
    }

    fn ray_title(&self, place: usize) -> String {
        let RayNode {
            id, parent, start, ..
        } = &self.tree.rays[place];
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
            Purpose::Connection => "from x' to x".into(),
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
        let title = self.ray_title(place);
        let end = node.end.map_or(String::new(), |end| {
            format!(": {}", self.outcome(&end, node.start))
        });
        self.page
            .line(Tone::Aside, format!("{title}{end} (--ray {})", node.id));
    }

    fn outcome(&self, end: &RayEnd, start: Option<RayStart>) -> String {
        let d = Digits::USUAL;
        let object = end.object.map_or("an object".into(), |id| self.name(id));
        let at = end
            .t
            .map_or(String::new(), |t| format!(" at t = {}", d.number(t)));
        match end.outcome {
            Outcome::Hit => format!("meets {object}{at}"),
            Outcome::Miss => "meets no object".into(),
            Outcome::Blocked => {
                let is_line = start.is_some_and(|start| start.purpose == Purpose::Connection);
                let shadow = if is_line {
                    ""
                } else {
                    ": the point lies in its shadow"
                };
                format!("blocked by {object}{at}{shadow}")
            }
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
            // chance has told it already
            (Outcome::Hit | Outcome::Absorbed, None)
                if course.photon.is_some() && self.shows(Kind::Photon) => {}
            (Outcome::Hit, Some(colour)) => {
                let sum = self.sum(course).unwrap_or_default();
                self.page
                    .line(tone, format!("I = {sum}{}", d.vector(colour)));
            }
            (Outcome::Miss, Some(_)) if self.settings.transport.follows_light() => {
                let text = "→ no object is met: no light comes from there, for only lamps send any";
                self.page.line(tone, text);
            }
            (Outcome::Miss, Some(colour)) => self.page.line(
                tone,
                format!("→ no object is met: the background, {}", d.vector(colour)),
            ),
            _ => {
                let leaves = match end.outcome {
                    Outcome::Miss => self.leaves_with(&self.tree.rays[course.place]),
                    _ => None,
                };
                let text = format!(
                    "→ {}{}",
                    self.outcome(end, course.start),
                    leaves.unwrap_or_default()
                );
                self.page.line(tone, text);
            }
        }
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
