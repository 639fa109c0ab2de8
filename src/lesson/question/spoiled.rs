//! What the wrong function of a mistake returns in place of an event's fields.

use serde_json::{Value, json};

use crate::geometry::{Ray, TRange};
use crate::lesson::question::facts::EventFacts;
use crate::lesson::question::traced::{TracedPixel, facts_of_event};
use crate::mistake::{Mistake, Wrong};
use crate::scene::Shape;
use crate::strategy::Hit;
use crate::trace::{Event, LightTerm, Purpose, RayEnd, RayStart, Record, Shade};
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
    let record = &traced.records[place];
    let at = At {
        traced,
        place,
        record,
    };
    let names = traced.names();
    let whole = |event: Event| Some(facts_of_event(event, record, &names));
    let with = |fields: &[(&str, Option<Value>)]| {
        let mut facts = traced.facts(record);
        let object = facts.fields.as_object_mut()?;
        for (key, value) in fields {
            match value {
                Some(value) => object.insert((*key).into(), value.clone()),
                None => object.remove(*key),
            };
        }
        Some(facts)
    };
    let scene = &*traced.scene;
    let wrong = &mistake.wrong;
    let vector = |of: glam::DVec3| Some(json!(of.to_array()));
    match (wrong, &record.event) {
        (Wrong::SphereTest(test), Event::SphereTest { object, .. }) => {
            let primitive = scene.primitive(*object);
            let Shape::Sphere(sphere) = &primitive.shape else {
                return None;
            };
            let (ray, range) = at.on()?;
            let test = test(sphere, &ray, range, primitive.sides);
            whole(Event::SphereTest {
                object: *object,
                test,
            })
        }
        (Wrong::Root(_) | Wrong::Hit(_), Event::SphereTest { object, .. })
        | (Wrong::PlaneT(_) | Wrong::Hit(_), Event::PlaneTest { object, .. }) => {
            let primitive = scene.primitive(*object);
            let (ray, range) = at.on()?;
            let t = match (wrong, &primitive.shape) {
                (Wrong::PlaneT(t), Shape::Polygon(polygon)) => {
                    t(polygon, &ray, range, primitive.sides)
                }
                _ => wrong.hit(primitive, &ray, range),
            };
            with(&[("t", t.map(|t| json!(t)))])
        }
        (Wrong::Inside(inside), Event::PolygonTest { object, .. }) => {
            let Shape::Polygon(polygon) = &scene.primitive(*object).shape else {
                return None;
            };
            let (ray, range) = at.on()?;
            let t = polygon.plane_test(&ray, range, scene.primitive(*object).sides);
            with(&[("inside", Some(json!(inside(polygon, &ray, t.chosen()?))))])
        }
        (Wrong::DroppedAxis(axis), Event::PolygonTest { object, test }) => {
            let Shape::Polygon(polygon) = &scene.primitive(*object).shape else {
                return None;
            };
            let dropped = axis(polygon.plane().normal);
            whole(Event::PolygonTest {
                object: *object,
                test: crate::geometry::PolygonTest { dropped, ..*test },
            })
        }
        (Wrong::WindowPoint(point), Event::Pixel(sample)) => {
            let point = scene.camera.cop + point(&scene.camera, sample.place.x, sample.place.y);
            with(&[("point", vector(point))])
        }
        (Wrong::Normals(normals), Event::Shade(shade)) => {
            let ray = at.ray()?;
            let (end, _) = at.of_ray(record.ray);
            let end = end?;
            let hit = Hit {
                object: end.object?,
                t: end.t?,
            };
            let found = normals(&scene.primitive(shade.object).shape, shade.point);
            let surface = Surface::new(scene, &ray.ray, ray.depth, hit, found);
            with(&[("normal", vector(surface.normal))])
        }
        (Wrong::LightTerm(light_term), Event::LightTerm(right)) => {
            let (_, shade) = at.of_ray(record.ray);
            let shade = shade?;
            let light = scene.lights.get(right.light as usize)?;
            let term = light_term(
                light,
                scene.material_of(shade.object),
                shade.point,
                shade.normal,
                -at.ray()?.ray.direction,
            );
            whole(Event::LightTerm(LightTerm { term, ..*right }))
        }
        (Wrong::Blocked(blocked), Event::RayEnd(end)) => {
            let start = at.ray().filter(|start| start.purpose == Purpose::Shadow)?;
            let is_blocked = blocked(scene, &start.ray, start.range);
            let outcome = if is_blocked {
                "blocked"
            } else {
                "reaches_light"
            };
            let object = end.object.filter(|_| is_blocked).map(|_| json!(true));
            let mut fields = vec![("outcome", Some(json!(outcome)))];
            if object.is_none() {
                fields.extend([("object", None), ("t", None)]);
            }
            with(&fields)
        }
        (Wrong::Reflect(_) | Wrong::Refract(_), Event::Ray(start)) => {
            let parent = record.parent;
            let (_, before) = at.start_of(parent)?;
            let (_, shade) = at.of_ray(parent);
            let normal = shade?.normal;
            let direction = match (wrong, start.purpose) {
                (Wrong::Reflect(reflect), Purpose::Reflected) => {
                    reflect(before.ray.direction, normal)
                }
                _ => return None,
            };
            with(&[("direction", vector(direction))])
        }
        (Wrong::Refract(refract), Event::Refraction(right)) => {
            let (_, shade) = at.of_ray(record.ray);
            let direction = at.ray()?.ray.direction;
            let found = refract(direction, shade?.normal, right.index_from, right.index_to);
            whole(Event::Refraction(found))
        }
        (Wrong::Normalised(normalised), Event::Ray(start)) => {
            let camera = &scene.camera;
            let sample = traced
                .records
                .iter()
                .find_map(|record| match record.event {
                    Event::Pixel(sample) => Some(sample),
                    _ => None,
                })?;
            let before = Ray::new(camera.cop, sample.point - camera.cop);
            let (_, t) = normalised(&before)?;
            start.window_t?;
            with(&[("t_window", Some(json!(t)))])
        }
        (Wrong::Bound(bound), Event::BoundTest(test)) => {
            let (_, range) = at.on()?;
            let verdict = bound(test.inside, range);
            whole(Event::BoundTest(crate::trace::BoundTest {
                verdict,
                ..*test
            }))
        }
        (Wrong::PlanesCrossed(crossed), Event::Cell(visit)) => {
            let mut visit = *visit;
            visit.step.across = crossed(visit.step.next);
            whole(Event::Cell(visit))
        }
        (Wrong::NextPlane(next), Event::Cell(visit)) => {
            let direction = at.ray()?.ray.direction.to_array();
            let planes: [f64; 3] =
                std::array::from_fn(|axis| f64::from(next(visit.step.cell[axis], direction[axis])));
            with(&[("planes", Some(json!(planes)))])
        }
        (Wrong::Shade(_) | Wrong::Nearest(_) | Wrong::Normals(_), Event::PixelColour(_)) => {
            let raw = simple::pixel(scene, wrong, traced.pixel);
            whole(Event::PixelColour(crate::trace::PixelColour {
                raw,
                clamped: raw.clamp(glam::DVec3::ZERO, glam::DVec3::ONE),
            }))
        }
        (_, Event::RayEnd(_)) if wrong.is_part() => {
            let start = at.ray()?;
            if start.purpose == Purpose::Shadow {
                return None;
            }
            let hit = wrong.nearest(scene, &start.ray, start.range);
            let name = |hit: Hit| json!(scene.object_of(hit.object).name.as_str());
            with(&[
                ("t", hit.map(|hit| json!(hit.t))),
                ("object", hit.map(name)),
            ])
        }
        _ => None,
    }
}
