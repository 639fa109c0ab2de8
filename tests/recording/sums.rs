//! What must hold of the records of a pixel, worked out from the records alone.

mod searched;

use std::ops::ControlFlow;

use glam::DVec3;
use raystep::geometry::{PlaneVerdict, RootVerdict, Roots};
use raystep::scene::Shape;
use raystep::trace::{
    Kind, LightTerm, Nearest, Purpose, RayEnd, RayStart, RayVerdict, Shade, Sink, Visibility,
};
use raystep::{Counts, Event, Record, Scene, Settings};

use searched::Searched;

/// A sum of a few colours is rounded a few times; the colours are of the order of 1.
const ROUNDING: f64 = 1e-12;

/// How far a direction may be from unit length: a normal is rounded relative to the size of its object,
/// and each mirror doubles that.
const UNIT: f64 = 1e-12;

/// Rays and tests, counted from records.
#[derive(Default)]
pub(super) struct Sums {
    /// Of the rays that have started in this pixel: what for.
    purposes: Vec<Purpose>,
    /// By purpose: traced, hit, beyond the depth limit.
    rays: [[u64; 3]; 7],
    /// By kind: tests, hits.
    tests: [[u64; 2]; 6],
    /// What the ends of the rays say: tests, hits.
    told: [u64; 2],
    /// What it took to find out what to test.
    searched: Searched,
}

impl Sink for Sums {
    fn record(&mut self, record: &Record) -> ControlFlow<()> {
        if let Some((kind, hit)) = tested(&record.event) {
            let at = Counts::TESTS.iter().position(|&known| known == kind);
            let [tests, hits] = &mut self.tests[at.unwrap()];
            *tests += 1;
            *hits += u64::from(hit);
        }
        self.searched.event(&record.event, met(&record.event));
        match record.event {
            Event::Pixel(sample) if sample.sample == 0 => self.purposes.clear(),
            Event::Ray(start) => self.purposes.push(start.purpose),
            Event::RayEnd(end) => {
                let purpose = self.purposes[record.ray.unwrap() as usize];
                let [traced, hits, beyond] = &mut self.rays[purpose as usize];
                match end.verdict {
                    RayVerdict::DepthLimit => *beyond += 1,
                    verdict => {
                        *traced += 1;
                        *hits += u64::from(
                            ![RayVerdict::Miss, RayVerdict::ReachesLight].contains(&verdict),
                        );
                    }
                }
                self.told[0] += u64::from(end.tests);
                self.told[1] += u64::from(end.hits);
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

impl Sums {
    #[track_caller]
    pub(super) fn check(&self, scene: &str, counts: &Counts) {
        let rays = counts.rays.map(|c| [c.traced, c.hits, c.beyond_depth]);
        assert_eq!(rays, self.rays, "{scene}: rays");
        let tests = counts.tests.map(|c| [c.tests, c.hits]);
        assert_eq!(tests, self.tests, "{scene}: tests");
        for count in counts.tests {
            assert_eq!(count.tests, count.hits + count.misses, "{scene}");
        }
        // an object is tested by all kinds but the polygon's second test, and met by all but its first
        let sum = |i: usize, left_out: Kind| -> u64 {
            let counted = Counts::TESTS.iter().zip(tests);
            let counted = counted.filter(|(kind, _)| **kind != left_out);
            counted.map(|(_, count)| count[i]).sum()
        };
        let objects = [sum(0, Kind::PolygonTest), sum(1, Kind::PlaneTest)];
        assert_eq!(objects, self.told, "{scene}: the rays' ends");
        assert_eq!(counts.objects_tested(), objects[0], "{scene}: objects");
        self.searched.check(scene, counts);
        assert!(0 < objects[1], "{scene}: nothing was hit");
    }
}

/// The kind of a test, and whether it hit: read off its roots or crossings.
fn tested(event: &Event) -> Option<(Kind, bool)> {
    let any = |roots: Roots| roots.iter().any(|root| root.verdict == RootVerdict::Chosen);
    let hit = match event {
        Event::SphereTest { test, .. }
        | Event::EllipsoidTest { test, .. }
        | Event::ConeTest { test, .. } => any(test.roots),
        Event::BoxTest { test, .. } => any(test.roots),
        Event::PlaneTest { test, .. } => {
            matches!(test.verdict, PlaneVerdict::Meets(root) if root.verdict == RootVerdict::Chosen)
        }
        Event::PolygonTest { test, .. } => test.crossings % 2 == 1,
        _ => return None,
    };
    Some((event.kind(), hit))
}

/// Was an object met: its surface, or the inside of its outline?
fn met(event: &Event) -> bool {
    tested(event).is_some_and(|(kind, hit)| hit && kind != Kind::PlaneTest)
}

/// A ray with what happened on it so far.
struct Open {
    id: u32,
    start: RayStart,
    nearest: Option<Nearest>,
    edges: Vec<bool>,
    tests: [u32; 2],
    searched: Searched,
    lights: Vec<LightTerm>,
    /// The shadow ray that has just ended: its light and verdict.
    shadow: Option<(u32, RayVerdict)>,
    shade: Option<Shade>,
    /// The colours that rays sent on brought back: reflected, refracted.
    sent_on: [Option<DVec3>; 2],
}

/// Walks through the records of a pixel with the rays that are open.
struct Walk<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    open: Vec<Open>,
    started: u32,
    eye_colours: Vec<DVec3>,
}

#[track_caller]
pub(super) fn check_pixel(scene: &Scene, settings: &Settings, pixel: [u32; 2], records: &[Record]) {
    let mut walk = Walk {
        scene,
        settings,
        open: Vec::new(),
        started: 0,
        eye_colours: Vec::new(),
    };
    for (step, record) in (0..).zip(records) {
        assert_eq!((record.pixel, record.step), (Some(pixel), step));
        walk.record(record);
    }
    assert!(walk.open.is_empty(), "a ray has no end");
}

#[track_caller]
fn close(found: DVec3, expected: DVec3) {
    let size = expected.abs().max_element().max(1.0);
    let off = (found - expected).abs().max_element();
    assert!(off <= ROUNDING * size, "{found} {expected}");
}

impl Walk<'_> {
    fn record(&mut self, record: &Record) {
        // a ray's start is its own first event; between it and its end lie its own and its children's
        if !matches!(record.event, Event::Ray(_)) {
            assert_eq!(record.ray, self.open.last().map(|open| open.id));
            assert_eq!(record.parent, None);
        }
        if let Some((kind, hit)) = tested(&record.event) {
            let [tests, hits] = &mut self.top().tests;
            *tests += u32::from(kind != Kind::PolygonTest);
            *hits += u32::from(hit && kind != Kind::PlaneTest);
        }
        if let Some(top) = self.open.last_mut() {
            top.searched.event(&record.event, met(&record.event));
        }
        match record.event {
            Event::Ray(start) => self.starts(record, start),
            Event::RayEnd(end) => self.ends(&end),
            Event::Edge { edge, .. } => {
                assert_eq!(edge.index as usize, self.top().edges.len());
                self.top().edges.push(edge.counts);
            }
            Event::PolygonTest { object, test } => {
                let edges = std::mem::take(&mut self.top().edges);
                let counting = edges.iter().filter(|counts| **counts).count();
                assert_eq!(counting, test.crossings as usize);
                assert_eq!(test.inside, counting % 2 == 1);
                let Shape::Polygon(polygon) = &self.scene.primitive(object).shape else {
                    panic!("{object:?} is no polygon");
                };
                assert_eq!(edges.len(), polygon.vertices().len());
            }
            Event::Nearest(nearest) => {
                let before = self.top().nearest.replace(nearest);
                assert_eq!(nearest.replaced, before.map(|before| before.object));
                // of two at equal t the first in the scene wins, in whatever order they are tested
                let place = |of: Nearest| (of.t, of.object);
                assert!(before.is_none_or(|before| place(nearest) < place(before)));
            }
            Event::LightTerm(light) => {
                let shadow = self.top().shadow.take();
                let expected = match light.visibility {
                    Visibility::Visible => Some((light.light, RayVerdict::ReachesLight)),
                    Visibility::Shadowed => Some((light.light, RayVerdict::Blocked)),
                    Visibility::FacesAway | Visibility::NotTested => None,
                };
                assert_eq!(shadow, expected);
                let faces_away = light.visibility == Visibility::FacesAway;
                assert_eq!(faces_away, light.term.n_dot_l <= 0.0);
                assert_eq!(light.light as usize, self.top().lights.len());
                self.top().lights.push(light);
            }
            Event::Shade(shade) => self.shade(shade),
            Event::PixelColour(colour) => {
                let sum: DVec3 = self.eye_colours.iter().sum();
                close(colour.raw, sum / self.eye_colours.len() as f64);
                assert_eq!(colour.clamped, colour.raw.clamp(DVec3::ZERO, DVec3::ONE));
            }
            _ => {}
        }
    }

    fn top(&mut self) -> &mut Open {
        self.open.last_mut().expect("the event belongs to a ray")
    }

    fn starts(&mut self, record: &Record, start: RayStart) {
        assert_eq!(record.ray, Some(self.started));
        let above = self.open.last();
        assert_eq!(record.parent, above.map(|above| above.id));
        assert_eq!(above.is_none(), start.purpose == Purpose::Eye);
        let depth = above.map_or(1, |above| above.start.depth + 1);
        assert_eq!(start.depth, depth);
        // a surface at the largest depth still casts its shadow rays
        assert!(start.depth <= self.scene.max_depth + 1);
        let off = (start.ray.direction.length() - 1.0).abs();
        assert!(off <= UNIT, "{off:e}");
        assert_eq!(start.light.is_some(), start.purpose == Purpose::Shadow);
        self.open.push(Open {
            id: self.started,
            start,
            nearest: None,
            edges: Vec::new(),
            tests: [0, 0],
            searched: Searched::default(),
            lights: Vec::new(),
            shadow: None,
            shade: None,
            sent_on: [None, None],
        });
        self.started += 1;
    }

    fn shade(&mut self, shade: Shade) {
        let lights = self.scene.lights.len();
        let top = self.top();
        assert_eq!(top.lights.len(), lights);
        let visible = |light: &&LightTerm| {
            [Visibility::Visible, Visibility::NotTested].contains(&light.visibility)
        };
        let terms = top.lights.iter().filter(visible);
        let sum: DVec3 = terms
            .map(|light| light.term.diffuse + light.term.specular)
            .sum();
        close(shade.direct, sum);
        assert_eq!(
            top.nearest.map(|nearest| nearest.object),
            Some(shade.object)
        );
        top.shade = Some(shade);
    }

    fn ends(&mut self, end: &RayEnd) {
        let ray = self.open.pop().expect("the ray has started");
        assert_eq!([end.tests, end.hits], ray.tests);
        let RayStart {
            purpose,
            depth,
            range,
            ..
        } = ray.start;
        let beyond = self.scene.max_depth < depth;
        if end.verdict != RayVerdict::DepthLimit {
            let settings = self.settings;
            ray.searched.check_ray(self.scene, settings.strategy, end);
        }
        assert_eq!(
            end.verdict == RayVerdict::DepthLimit,
            beyond && purpose != Purpose::Shadow
        );
        if let Some(t) = end.t {
            assert!(0.0 < t && range.min <= t && t <= range.max);
        }
        if purpose == Purpose::Shadow {
            let blocked = end.object.is_some();
            assert_eq!(end.verdict == RayVerdict::Blocked, blocked);
            assert_eq!(end.verdict == RayVerdict::ReachesLight, !blocked);
            assert_eq!(end.t.is_some(), blocked);
            assert_eq!((end.colour, ray.nearest), (None, None));
            let light = ray.start.light.expect("a shadow ray has a light");
            self.top().shadow = Some((light, end.verdict));
            return;
        }

        assert_eq!(end.object, ray.nearest.map(|nearest| nearest.object));
        let t = ray.nearest.map(|nearest| nearest.t.to_bits());
        assert_eq!(end.t.map(f64::to_bits), t);
        assert_eq!(end.verdict == RayVerdict::Hit, end.object.is_some());
        let colour = end.colour.expect("the ray brings back a colour");
        close(colour, self.expected_colour(end.verdict, &ray));
        let sent_on = match purpose {
            Purpose::Reflected => &mut self.top().sent_on[0],
            Purpose::Refracted => &mut self.top().sent_on[1],
            _ => return self.eye_colours.push(colour),
        };
        assert_eq!(sent_on.replace(colour), None);
    }

    /// The colour from its parts.
    fn expected_colour(&self, verdict: RayVerdict, ray: &Open) -> DVec3 {
        let (RayVerdict::Hit, Some(shade)) = (verdict, ray.shade) else {
            assert!(ray.shade.is_none());
            return match verdict {
                RayVerdict::Miss => self.scene.background,
                RayVerdict::DepthLimit => DVec3::ZERO,
                _ => panic!("{verdict:?} without a shade"),
            };
        };
        let [reflected, refracted] = ray.sent_on;
        assert_eq!(reflected.is_some(), 0.0 < shade.reflection);
        assert_eq!(refracted.is_some(), 0.0 < shade.transmission);
        let material = self.scene.material_of(shade.object);
        close(
            shade.ambient,
            self.scene.ambient * DVec3::from(material.colour),
        );
        // total internal reflection moves the weight from one ray to the other
        let weights = material.reflection + material.transmission;
        assert!((shade.reflection + shade.transmission - weights).abs() <= ROUNDING);
        shade.ambient
            + shade.direct
            + shade.reflection * reflected.unwrap_or_default()
            + shade.transmission * refracted.unwrap_or_default()
    }
}
