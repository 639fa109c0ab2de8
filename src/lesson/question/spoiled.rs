//! What the wrong function of a mistake returns in place of an event's fields.

use glam::DVec3;
use serde_json::{Value, json};

use crate::geometry::{PolygonTest, Ray, Refraction, TRange};
use crate::lesson::question::facts::EventFacts;
use crate::lesson::question::traced::{TracedPixel, facts_of_event};
use crate::mistake::{Mistake, Wrong};
use crate::scene::{PrimitiveId, Scene, Shape};
use crate::strategy::Hit;
use crate::trace::{
    BoundTest, CellVisit, Event, LightTerm, PixelColour, PixelSample, Purpose, RayEnd, RayStart,
    RayVerdict, Record, Shade,
};
use crate::tracer::Surface;
use crate::tracer::simple::{self, Parts};

/// An event with its ray.
struct At<'a> {
    traced: &'a TracedPixel,
    place: usize,
    record: &'a Record,
}

impl At<'_> {
    /// The start of the ray that an event is on.
    fn start_of(&self, ray: Option<u32>) -> Option<(Option<u32>, RayStart)> {
        let same = |record: &&Record| record.ray == ray && record.path == self.record.path;
        let mut of_ray = self.traced.records.iter().filter(same);
        of_ray.find_map(|record| match record.event {
            Event::Ray(start) => Some((record.parent, start)),
            _ => None,
        })
    }

    fn ray(&self) -> Option<RayStart> {
        self.start_of(self.record.ray).map(|(_, start)| start)
    }

    /// Which t count here: those of the ray, up to the nearest hit.
    fn on(&self) -> Option<(Ray, TRange)> {
        let start = self.ray()?;
        let before = self.traced.records[..self.place].iter().rev();
        let nearest = before
            .filter(|record| record.ray == self.record.ray && record.path == self.record.path)
            .find_map(|record| match record.event {
                Event::Nearest(hit) => Some(hit.t),
                _ => None,
            });
        let range = nearest.map_or(start.range, |t| start.range.up_to(t));
        Some((start.ray, range))
    }

    /// The end and the shade of a ray.
    fn of_ray(&self, ray: Option<u32>) -> (Option<RayEnd>, Option<Shade>) {
        let (mut ended, mut shaded) = (None, None);
        for record in self.traced.records.iter() {
            if record.ray != ray || record.path != self.record.path {
                continue;
            }
            match record.event {
                Event::RayEnd(end) => ended = Some(end),
                Event::Shade(shade) => shaded = Some(shade),
                _ => {}
            }
        }
        (ended, shaded)
    }
}

/// The fields of an event with what a mistake's wrong function returns in place of the right one; `None` if the function
/// has no part in the event.
pub(super) fn spoiled(mistake: &Mistake, traced: &TracedPixel, place: usize) -> Option<EventFacts> {
    let at = At {
        traced,
        place,
        record: &traced.records[place],
    };
    match &at.record.event {
        Event::SphereTest { object, .. } => at.sphere(&mistake.wrong, *object),
        Event::PlaneTest { object, .. } => at.root(&mistake.wrong, *object),
        Event::PolygonTest { object, test } => at.polygon(&mistake.wrong, *object, test),
        Event::Pixel(sample) => at.window(&mistake.wrong, sample),
        Event::Ray(start) => at.start(&mistake.wrong, start),
        Event::RayEnd(_) => at.end(&mistake.wrong),
        Event::Shade(shade) => at.shade(&mistake.wrong, shade),
        Event::LightTerm(term) => at.light(&mistake.wrong, term),
        Event::Refraction(right) => at.refraction(&mistake.wrong, right),
        Event::PixelColour(_) => at.colour(&mistake.wrong),
        Event::BoundTest(test) => at.bound(&mistake.wrong, test),
        Event::Cell(visit) => at.cell(&mistake.wrong, visit),
        _ => None,
    }
}

fn vector(of: DVec3) -> Value {
    json!(of.to_array())
}

impl At<'_> {
    fn scene(&self) -> &Scene {
        &self.traced.scene
    }

    /// The fields of another event in this one's place.
    fn whole(&self, event: Event) -> EventFacts {
        let names = self.traced.names();
        facts_of_event(event, self.record, &names)
    }

    /// The fields of this event, but for some.
    fn with(&self, fields: &[(&str, Option<Value>)]) -> Option<EventFacts> {
        let mut facts = self.traced.facts(self.record);
        let object = facts.fields.as_object_mut()?;
        for (key, value) in fields {
            match value {
                Some(value) => object.insert((*key).into(), value.clone()),
                None => object.remove(*key),
            };
        }
        Some(facts)
    }

    fn sphere(&self, wrong: &Wrong, object: PrimitiveId) -> Option<EventFacts> {
        let primitive = self.scene().primitive(object);
        match (wrong, &primitive.shape) {
            (Wrong::SphereTest(test), Shape::Sphere(sphere)) => {
                let (ray, range) = self.on()?;
                let test = test(sphere, &ray, range, primitive.sides);
                Some(self.whole(Event::SphereTest { object, test }))
            }
            (Wrong::Root(_), Shape::Sphere(_)) | (Wrong::Hit(_), _) => self.root(wrong, object),
            _ => None,
        }
    }

    /// t of the hit with an object.
    fn root(&self, wrong: &Wrong, object: PrimitiveId) -> Option<EventFacts> {
        let primitive = self.scene().primitive(object);
        let (ray, range) = self.on()?;
        let t = match (wrong, &primitive.shape) {
            (Wrong::PlaneT(t), Shape::Polygon(polygon)) => t(polygon, &ray, range, primitive.sides),
            (Wrong::Root(_) | Wrong::Hit(_), _) => wrong.hit(primitive, &ray, range),
            _ => return None,
        };
        self.with(&[("t", t.map(|t| json!(t)))])
    }

    fn polygon(
        &self,
        wrong: &Wrong,
        object: PrimitiveId,
        test: &PolygonTest,
    ) -> Option<EventFacts> {
        let primitive = self.scene().primitive(object);
        let Shape::Polygon(polygon) = &primitive.shape else {
            return None;
        };
        match wrong {
            Wrong::Inside(inside) => {
                let (ray, range) = self.on()?;
                let t = polygon.plane_test(&ray, range, primitive.sides).chosen()?;
                self.with(&[("inside", Some(json!(inside(polygon, &ray, t))))])
            }
            Wrong::DroppedAxis(axis) => {
                let dropped = axis(polygon.plane().normal);
                let test = PolygonTest { dropped, ..*test };
                Some(self.whole(Event::PolygonTest { object, test }))
            }
            _ => None,
        }
    }

    fn window(&self, wrong: &Wrong, sample: &PixelSample) -> Option<EventFacts> {
        let Wrong::WindowPoint(to_window) = wrong else {
            return None;
        };
        let camera = &self.scene().camera;
        let point = camera.cop + to_window(camera, sample.place.x, sample.place.y);
        self.with(&[("point", Some(vector(point)))])
    }

    fn start(&self, wrong: &Wrong, start: &RayStart) -> Option<EventFacts> {
        match (wrong, start.purpose) {
            (Wrong::Reflect(reflect), Purpose::Reflected) => {
                let (_, before) = self.start_of(self.record.parent)?;
                let normal = self.of_ray(self.record.parent).1?.normal;
                let direction = reflect(before.ray.direction, normal);
                self.with(&[("direction", Some(vector(direction)))])
            }
            (Wrong::Normalised(normalised), Purpose::Eye) => {
                let records = self.traced.records.iter();
                let mut samples = records.filter_map(|record| match record.event {
                    Event::Pixel(sample) => Some(sample),
                    _ => None,
                });
                let cop = self.scene().camera.cop;
                let before = Ray::new(cop, samples.next()?.point - cop);
                let (_, t) = normalised(&before)?;
                self.with(&[("t_window", Some(json!(t)))])
            }
            _ => None,
        }
    }

    /// What a ray hits, or whether a light is blocked.
    fn end(&self, wrong: &Wrong) -> Option<EventFacts> {
        let start = self.ray()?;
        let scene = self.scene();
        match (wrong, start.purpose) {
            (Wrong::Blocked(blocked), Purpose::Shadow) => {
                let is_blocked = blocked(scene, &start.ray, start.range);
                let verdict = if is_blocked {
                    RayVerdict::Blocked
                } else {
                    RayVerdict::ReachesLight
                };
                self.with(&[("outcome", Some(json!(verdict.word())))])
            }
            (_, Purpose::Shadow) => None,
            _ if wrong.is_part() => {
                let hit = wrong.nearest(scene, &start.ray, start.range);
                let name = |hit: Hit| json!(scene.object_of(hit.object).name.as_str());
                self.with(&[
                    ("t", hit.map(|hit| json!(hit.t))),
                    ("object", hit.map(name)),
                ])
            }
            _ => None,
        }
    }

    fn shade(&self, wrong: &Wrong, shade: &Shade) -> Option<EventFacts> {
        let Wrong::Normals(normals) = wrong else {
            return None;
        };
        let (start, end) = (self.ray()?, self.of_ray(self.record.ray).0?);
        let hit = Hit {
            object: end.object?,
            t: end.t?,
        };
        let scene = self.scene();
        let found = normals(&scene.primitive(shade.object).shape, shade.point);
        let surface = Surface::new(scene, &start.ray, start.depth, hit, found);
        self.with(&[("normal", Some(vector(surface.normal)))])
    }

    fn light(&self, wrong: &Wrong, right: &LightTerm) -> Option<EventFacts> {
        let Wrong::LightTerm(light_term) = wrong else {
            return None;
        };
        let shade = self.of_ray(self.record.ray).1?;
        let scene = self.scene();
        let term = light_term(
            scene.lights.get(right.light as usize)?,
            scene.material_of(shade.object),
            shade.point,
            shade.normal,
            -self.ray()?.ray.direction,
        );
        Some(self.whole(Event::LightTerm(LightTerm { term, ..*right })))
    }

    fn refraction(&self, wrong: &Wrong, right: &Refraction) -> Option<EventFacts> {
        let Wrong::Refract(refract) = wrong else {
            return None;
        };
        let normal = self.of_ray(self.record.ray).1?.normal;
        let direction = self.ray()?.ray.direction;
        let found = refract(direction, normal, right.index_from, right.index_to);
        Some(self.whole(Event::Refraction(found)))
    }

    fn colour(&self, wrong: &Wrong) -> Option<EventFacts> {
        if !wrong.is_part() {
            return None;
        }
        let raw = simple::pixel(self.scene(), wrong, self.traced.pixel);
        let clamped = raw.clamp(DVec3::ZERO, DVec3::ONE);
        Some(self.whole(Event::PixelColour(PixelColour { raw, clamped })))
    }

    fn bound(&self, wrong: &Wrong, test: &BoundTest) -> Option<EventFacts> {
        let Wrong::Bound(bound) = wrong else {
            return None;
        };
        let verdict = bound(test.inside, self.on()?.1);
        Some(self.whole(Event::BoundTest(BoundTest { verdict, ..*test })))
    }

    fn cell(&self, wrong: &Wrong, visit: &CellVisit) -> Option<EventFacts> {
        let Wrong::PlanesCrossed(crossed) = wrong else {
            return None;
        };
        let mut visit = *visit;
        visit.step.across = crossed(visit.step.next);
        Some(self.whole(Event::Cell(visit)))
    }
}
