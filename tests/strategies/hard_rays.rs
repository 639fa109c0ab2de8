//! Rays about which strategies are most likely to disagree: in the plane of a polygon, from and towards its edges,
//! with a range that ends next to a hit, at scales from 1e−45 to 1e45 and far from the world's origin.
//!
//! Two cases are excepted, as [`raystep::strategy::Strategy`] says, and no others: a hit within 4 ulp of the end of the range,
//! and two hits within 1e−12 of each other.

use glam::DVec3;
use raystep::geometry::{AxisBox, Cone, Ellipsoid, Polygon, Ray, Sides, Sphere, TRange};
use raystep::scene::{Object, Primitive, PrimitiveId, Shape};
use raystep::strategy::{Exhaustive, Hit, Strategy};
use raystep::{NoFiles, Off, Scene, load_bytes};

use super::{Question, asked, both_drivers};
use crate::seeded::Seeded;

/// Scenes, each with some objects that are hard to agree about.
const SCENES: u64 = 900;
/// Rays through each of them.
const RAYS: usize = 60;
/// Two hits this near to each other, as a share of t, may change places.
const SAME: f64 = 1e-12;
/// A hit this near to the end of the range, in ulp, may count or not.
const ULP: u64 = 4;

/// A ray and where it counts.
pub(super) type Query = (Ray, TRange);

/// The nearest hit, and whether there is any.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Found {
    pub(super) nearest: Option<Hit>,
    any: bool,
}

pub(super) struct Queries<'a>(pub(super) &'a [Query]);

impl Question for Queries<'_> {
    type Answer = Vec<Found>;
    fn put(&self, strategy: &impl Strategy) -> Vec<Found> {
        let found = |&(ray, range): &Query| Found {
            nearest: strategy.nearest(&ray, range, &mut Off),
            any: strategy.any(&ray, range, &mut Off).is_some(),
        };
        self.0.iter().map(found).collect()
    }
}

/// Is one of the two exceptions the reason why these differ?
fn is_excepted(a: Found, b: Found, range: TRange) -> bool {
    let at_end = |hit: Option<Hit>| {
        hit.is_none_or(|hit| hit.t.to_bits().abs_diff(range.max.to_bits()) <= ULP)
    };
    let is_same = match (a.nearest, b.nearest) {
        (Some(a), Some(b)) => (a.t - b.t).abs() <= SAME * a.t.max(b.t),
        _ => false,
    };
    let ends = at_end(a.nearest) && at_end(b.nearest);
    let nearest = a.nearest == b.nearest || is_same || ends;
    nearest && (a.any == b.any || ends)
}

/// A scene of these shapes, in this order.
pub(super) fn scene(shapes: Vec<(Shape, Sides)>) -> Scene {
    let text = br#"{
      "camera": { "look_at": { "cop": [0, 0, 9], "target": [0, 0, 0], "up": [0, 1, 0], "fov_degrees": 40 },
                  "pixels": [1, 1] },
      "materials": { "m": { "colour": [1, 1, 1] } },
      "slabs": [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [0, 1, -1]],
      "objects": [ { "name": "A", "material": "m", "shape": { "sphere": { "center": [0, 0, 0], "radius": 1 } } } ]
    }"#;
    let mut scene = load_bytes("hard.json", text, &NoFiles)
        .unwrap()
        .build()
        .unwrap();
    let template = scene.objects[0].clone();
    let object = |first| Object {
        first: PrimitiveId(first),
        ..template.clone()
    };
    scene.objects = (0..shapes.len() as u32).map(object).collect();
    let primitive = |(object, (shape, sides))| Primitive {
        shape,
        object,
        sides,
    };
    scene.primitives = (0..).zip(shapes).map(primitive).collect();
    scene
}

/// Numbers of a scene: a scale, a corner far away from the world's origin, and a lattice or none.
struct Place {
    random: Seeded,
    scale: f64,
    corner: DVec3,
    lattice: bool,
}

impl Place {
    fn new(seed: u64) -> Self {
        let mut random = Seeded::new(1_000_000 + seed);
        let scale = 10f64.powi([0, 0, -3, 3, -20, 20, -45, 45][random.index(8)]);
        let far = [0.0, 0.0, 1e3, 1e5][random.index(4)];
        let corner = far * scale * random.point(1.0);
        Self {
            scale,
            corner,
            lattice: random.index(3) != 0,
            random,
        }
    }

    fn step(&mut self, size: i32) -> f64 {
        if self.lattice {
            0.5 * f64::from(self.random.whole(-2 * size, 2 * size))
        } else {
            self.random.within(-f64::from(size), f64::from(size))
        }
    }

    /// A vector of the scene's size.
    fn vector(&mut self, size: i32) -> DVec3 {
        self.scale * DVec3::from_array([0; 3].map(|_| self.step(size)))
    }

    fn point(&mut self) -> DVec3 {
        self.corner + self.vector(5)
    }

    fn length(&mut self) -> f64 {
        let half_steps = f64::from(self.random.whole(1, 4));
        self.scale
            * if self.lattice {
                0.5 * half_steps
            } else {
                self.random.within(0.1, 2.0)
            }
    }

    /// Three to five corners in a plane, the fourth and fifth of which make it concave now and then.
    fn polygon(&mut self) -> Option<Polygon> {
        let (at, u, v) = (self.point(), self.vector(3), self.vector(3));
        let outline: &[[f64; 2]] = [
            &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]] as &[_],
            &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            &[[0.0, 0.0], [2.0, 0.0], [0.5, 0.5], [0.0, 2.0]],
            &[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 0.5], [0.0, 1.0]],
        ][self.random.index(4)];
        let vertices = outline.iter().map(|&[a, b]| at + a * u + b * v);
        Polygon::new(vertices.collect(), None).ok()
    }

    fn shape(&mut self) -> Option<Shape> {
        match self.random.index(8) {
            0 => Some(Shape::Sphere(Sphere {
                center: self.point(),
                radius: self.length(),
            })),
            1 => Some(Shape::Ellipsoid(Ellipsoid {
                center: self.point(),
                radii: DVec3::from_array([0; 3].map(|_| self.length())),
            })),
            2 => {
                let min = self.point();
                let max = min + DVec3::from_array([0; 3].map(|_| self.length()));
                Some(Shape::Box(AxisBox { min, max }))
            }
            3 | 4 => {
                let (base, step) = (self.point(), self.vector(3));
                let radius = self.length();
                let apex_radius = [0.0, radius, self.length()][self.random.index(3)];
                Cone::new(base, radius, base + step, apex_radius).map(Shape::Cone)
            }
            _ => self.polygon().map(Shape::Polygon),
        }
    }

    fn scene(&mut self) -> Scene {
        let mut shapes: Vec<(Shape, Sides)> = Vec::new();
        let count = 1 + self.random.index(12);
        while shapes.len() < count {
            let sides = [Sides::Both, Sides::Both, Sides::Front, Sides::Back][self.random.index(4)];
            let twin = shapes.last().filter(|_| self.random.index(6) == 0).cloned();
            // the same once more: equal t
            let shape = twin.map(|(shape, _)| shape).or_else(|| self.shape());
            shapes.extend(shape.map(|shape| (shape, sides)));
        }
        scene(shapes)
    }

    /// Two points of a shape: corners or edges of a polygon, else points that its size is known by.
    fn points_of(&mut self, shape: &Shape) -> [DVec3; 2] {
        match shape {
            Shape::Polygon(polygon) => {
                let vertices: Vec<DVec3> = polygon.vertices().collect();
                let corner = |place: &mut Self| {
                    let at = place.random.index(vertices.len());
                    let next = vertices[(at + 1) % vertices.len()];
                    let share = [0.0, 0.5, 0.25, place.random.unit()][place.random.index(4)];
                    vertices[at] + share * (next - vertices[at])
                };
                [corner(self), corner(self)]
            }
            Shape::Sphere(Sphere { center, radius }) => [*center, *center + *radius * DVec3::X],
            Shape::Ellipsoid(of) => [of.center, of.center + of.radii * DVec3::Y],
            Shape::Box(of) => [of.min, of.max],
            Shape::Cone(cone) => [cone.base(), cone.apex()],
        }
    }

    /// In the plane of a polygon, along an edge, from a surface, or between any two such points.
    fn ray(&mut self, scene: &Scene) -> Option<Ray> {
        let any = |place: &mut Self| {
            let at = place.random.index(scene.primitives.len());
            place.points_of(&scene.primitives[at].shape)
        };
        let [a, b] = any(self);
        let [c, d] = any(self);
        let back = f64::from(self.random.whole(-2, 4));
        let ray = match self.random.index(6) {
            // in the plane, before, in or behind the polygon
            0 | 1 => Ray::new(a - back * (b - a), b - a),
            // the same, tilted by a few roundings or more
            2 => {
                let tilt = self.random.power(-17.0, -6.0) * self.random.direction();
                Ray::new(a - back * (b - a), (b - a).normalize_or_zero() + tilt)
            }
            // from one object's edge towards another's
            3 => Ray::through(a, c),
            4 => Ray::through(self.point(), d),
            // along an axis through a corner
            _ => {
                let axis = DVec3::AXES[self.random.index(3)] * self.random.sign();
                Ray::new(a - back * self.scale * axis, axis)
            }
        };
        ray.normalised().map(|(unit, _)| unit)
    }
}

/// The ray as far as it goes, and as far as some ulp more or less than its nearest hit, or exactly that.
fn queries(scene: &Scene, ray: Ray, place: &mut Place) -> Vec<Query> {
    let epsilon = TRange {
        min: 1e-9 * ray.origin.abs().max_element(),
        ..TRange::FORWARD
    };
    let mut queries = vec![(ray, TRange::FORWARD), (ray, epsilon)];
    for range in [TRange::FORWARD, epsilon] {
        let Some(hit) = Exhaustive::new(scene).nearest(&ray, range, &mut Off) else {
            continue;
        };
        // beyond the ulp that are excepted, and exactly at the hit
        for ulp in [0, 5, -5, 16, -16, 1_000, -1_000] {
            let max = f64::from_bits(hit.t.to_bits().saturating_add_signed(ulp).max(1));
            queries.push((ray, range.up_to(max)));
        }
        // on from the hit, as a ray that is sent on
        let point = ray.at(hit.t);
        let min = 1e-9 * point.abs().max_element().max(hit.t);
        let on = [place.random.direction(), ray.direction][place.random.index(2)];
        queries.push((Ray::new(point, on), TRange { min, ..range }));
    }
    queries
}

/// How often the exceptions were used, of how many queries and hits.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    queries: usize,
    hits: usize,
    excepted: usize,
}

fn compare(seed: u64, scene: &Scene, queries: &[Query], counts: &mut Counts) {
    let expected = asked("exhaustive", scene, &Queries(queries));
    counts.queries += queries.len();
    counts.hits += expected
        .iter()
        .filter(|found| found.nearest.is_some())
        .count();
    for name in both_drivers() {
        let found = asked(&name, scene, &Queries(queries));
        for ((&(ray, range), &found), &expected) in queries.iter().zip(&found).zip(&expected) {
            if found == expected {
                continue;
            }
            counts.excepted += 1;
            let shape = |found: Found| {
                let of = |hit: Hit| (hit.object, &scene.primitives[hit.object.0 as usize]);
                found.nearest.map(of)
            };
            assert!(
                is_excepted(found, expected, range),
                "scene {seed}: {name} disagrees about\n{ray:?}\n{range:?}\nfound {found:?}\n{:?}\n\
                 exhaustive: {expected:?}\n{:?}",
                shape(found),
                shape(expected)
            );
        }
    }
}

#[test]
fn hard_rays_meet_the_same_object_at_the_same_t_but_for_the_two_stated_exceptions() {
    let check = |seed: u64| {
        let mut place = Place::new(seed);
        let scene = place.scene();
        let mut asked = Vec::new();
        for _ in 0..RAYS {
            if let Some(ray) = place.ray(&scene) {
                asked.extend(queries(&scene, ray, &mut place));
            }
        }
        let mut counts = Counts::default();
        compare(seed, &scene, &asked, &mut counts);
        counts
    };
    let halves = std::thread::scope(|scope| {
        let half = |odd: u64| {
            move || {
                let seeds = (0..SCENES / 2).map(move |i| 2 * i + odd);
                seeds.map(check).collect::<Vec<Counts>>()
            }
        };
        let threads = [0, 1].map(|odd| scope.spawn(half(odd)));
        threads.map(|thread| thread.join().unwrap())
    });
    let mut all = Counts::default();
    for counts in halves.iter().flatten() {
        all.queries += counts.queries;
        all.hits += counts.hits;
        all.excepted += counts.excepted;
    }
    assert!(
        300_000 <= all.queries && all.queries / 4 <= all.hits,
        "{all:?}"
    );
    // no ray is known that needs one of the exceptions; one that turns up gets a test in `known_rays`
    assert_eq!(all.excepted, 0, "{all:?}");
}
