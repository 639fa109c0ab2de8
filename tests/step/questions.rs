//! Questions of steps: the right answer is found by another route, from the scene and the ray, and never from the event's
//! verdict; every choice has a reason, and no two choices are alike.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec3;
use raystep::geometry::{Axis, Plane, Polygon, Ray, TRange};
use raystep::mistake::mistake;
use raystep::scene::{Primitive, PrimitiveId, Shape};
use raystep::step::{Asks, Question, StepLog};
use raystep::trace::{Bounded, GridEnter, QueueAction, RaySlab, RayStart};
use raystep::tracer::EPSILON;
use raystep::tracer::simple::{Own, Parts};
use raystep::{Event, Record};

use super::{each_lesson, each_random};
use crate::seeded::Seeded;

/// Numbers in a question have six digits.
const SHOWN: f64 = 2e-5;

/// The event that a step's question is about, with what came before it on its ray.
struct Asked<'a, 'l> {
    log: &'a StepLog<'l>,
    question: &'a Question,
    events: &'a [Record],
    /// The events of the ray before the step's own and those of it, in order.
    on_ray: Vec<&'a Event>,
    start: Option<RayStart>,
}

impl<'a, 'l> Asked<'a, 'l> {
    fn new(log: &'a StepLog<'l>, number: usize, question: &'a Question) -> Self {
        let step = log.step(number);
        let events = &log.records[step.events.clone()];
        let lead = &log.records[step.lead];
        let on_ray: Vec<&Event> = log.records[..step.events.end]
            .iter()
            .filter(|record| {
                record.ray == lead.ray && (record.pixel, record.path) == (lead.pixel, lead.path)
            })
            .map(|record| &record.event)
            .collect();
        // of several eye rays of a pixel each has a number of its own
        let start = on_ray.iter().find_map(|event| match event {
            Event::Ray(start) => Some(*start),
            _ => None,
        });
        Self {
            log,
            question,
            events,
            on_ray,
            start,
        }
    }

    fn right(&self) -> &str {
        &self.question.choices[self.question.right].text
    }

    /// The events of the ray before the first event of the step.
    fn before(&self) -> &[&'a Event] {
        let own = self.events.iter().filter(|record| {
            // a ray's step holds the rays inside it
            record.ray == self.events[0].ray
        });
        &self.on_ray[..self.on_ray.len() - own.count()]
    }

    fn primitive(&self, object: PrimitiveId) -> &'l Primitive {
        self.log.scene.primitive(object)
    }

    fn ray(&self) -> Ray {
        self.start.unwrap().ray
    }

    /// Those t that count, up to the nearest hit that was noted before.
    fn range(&self) -> TRange {
        let nearest = self.before().iter().filter_map(|event| match event {
            Event::Nearest(hit) => Some(hit.t),
            _ => None,
        });
        nearest.fold(self.start.unwrap().range, TRange::up_to)
    }
}

/// The number behind some words.
fn number_in(text: &str, before: &str) -> Option<f64> {
    let rest = &text[text.find(before)? + before.len()..];
    let word = rest.split([' ', ',', ';']).next()?;
    word.trim_end_matches('.').replace('−', "-").parse().ok()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= SHOWN * a.abs().max(b.abs()) + 1e-12
}

/// What is wrong with the right answer, if anything is.
fn wrong(asked: &Asked) -> Option<String> {
    let found = asked.right();
    let expected = match asked.question.asks {
        Asks::RootCount => root_count(asked),
        Asks::RootThatCounts => root_that_counts(asked),
        Asks::PlaneT => plane_t(asked),
        Asks::DroppedAxis => dropped_axis(asked),
        Asks::Inside => inside(asked),
        Asks::SlabThatEnds => slab_that_ends(asked),
        Asks::Bound => bound(asked),
        Asks::NextNode => next_node(asked),
        Asks::Pruned => pruned(asked),
        Asks::NextPlane => next_plane(asked),
        Asks::Mailbox => mailbox(asked),
        Asks::FinalHit => final_hit(asked),
        Asks::Blocked => return blocked(asked),
        Asks::ZeroTerms => zero_terms(asked),
        Asks::TotalReflection => total_reflection(asked),
    };
    if found == expected {
        return None;
    }
    // a t as printed, and as computed here
    match (number_in(found, "t = "), number_in(&expected, "t = ")) {
        (Some(a), Some(b)) if close(a, b) => None,
        _ => Some(format!("{found:?}, expected {expected:?}")),
    }
}

/// By the distance at which the line passes the center, in the space in which the surface is a unit sphere; of a cone by the
/// sign of the quadratic at its vertex.
fn root_count(asked: &Asked) -> String {
    let ray = asked.ray();
    let count = asked.events.iter().find_map(|record| match record.event {
        Event::SphereTest { object, .. } | Event::EllipsoidTest { object, .. } => {
            let (center, radii) = match &asked.primitive(object).shape {
                Shape::Sphere(sphere) => (sphere.center, DVec3::splat(sphere.radius)),
                Shape::Ellipsoid(ellipsoid) => (ellipsoid.center, ellipsoid.radii),
                other => panic!("{other:?}"),
            };
            let origin = (ray.origin - center) / radii;
            let direction = (ray.direction / radii).normalize();
            let foot = origin - origin.dot(direction) * direction;
            Some(foot.length())
        }
        Event::ConeTest { test, .. } => {
            // a·t² + b·t + c at t = −b/2a is above 0 without roots if a > 0
            let t = -test.b / (2.0 * test.a);
            let least = (test.a * t + test.b) * t + test.c;
            Some(if (0.0 < least) == (0.0 < test.a) {
                2.0
            } else {
                0.5
            })
        }
        _ => None,
    });
    match count.unwrap() {
        distance if (distance - 1.0).abs() <= 1e-12 => "one: the ray touches the surface".into(),
        distance if distance < 1.0 => "two".into(),
        _ => "none: the ray misses".into(),
    }
}

/// By the simple ray tracer, and of a sphere by walking along the ray to where its inside begins or ends.
fn root_that_counts(asked: &Asked) -> String {
    let object = asked.events.iter().find_map(|record| match record.event {
        Event::SphereTest { object, .. }
        | Event::EllipsoidTest { object, .. }
        | Event::ConeTest { object, .. }
        | Event::BoxTest { object, .. } => Some(object),
        _ => None,
    });
    let primitive = asked.primitive(object.unwrap());
    let (ray, range) = (asked.ray(), asked.range());
    let t = Own.hit(primitive, &ray, range);
    if let (Some(t), Shape::Sphere(sphere)) = (t, &primitive.shape) {
        let off = (ray.at(t) - sphere.center).length() - sphere.radius;
        let size = sphere.radius + sphere.center.length() + ray.origin.length() + t;
        assert!(off.abs() <= 1e-9 * size, "{off}");
        // halfway to it no surface was passed in the range: both are inside or both outside
        let side = |t: f64| (ray.at(t) - sphere.center).length() < sphere.radius;
        assert_eq!(
            side(range.min + 0.5 * (t - range.min)),
            side(range.min + 0.999 * (t - range.min))
        );
    }
    match t {
        Some(t) => format!("t = {t}"),
        None => {
            let is_one = asked.question.text.contains("The only root");
            if is_one {
                "it does not count: the ray misses".into()
            } else {
                "neither: the ray misses".into()
            }
        }
    }
}

fn polygon_of<'l>(asked: &Asked<'_, 'l>) -> &'l Polygon {
    let object = asked.events.iter().find_map(|record| match record.event {
        Event::PlaneTest { object, .. } | Event::PolygonTest { object, .. } => Some(object),
        _ => None,
    });
    match &asked.primitive(object.unwrap()).shape {
        Shape::Polygon(polygon) => polygon,
        other => panic!("{other:?}"),
    }
}

/// The sum of the cross products of neighbouring corners: twice the area along the normal.
fn doubled_area(polygon: &Polygon) -> DVec3 {
    let corners: Vec<DVec3> = polygon.vertices().collect();
    let from = corners[0];
    let pairs = corners.windows(2);
    pairs
        .map(|pair| (pair[0] - from).cross(pair[1] - from))
        .sum()
}

/// By the cross products of the corners and the mean corner.
fn plane_t(asked: &Asked) -> String {
    let polygon = polygon_of(asked);
    let ray = asked.ray();
    let normal = doubled_area(polygon).normalize();
    let corners: Vec<DVec3> = polygon.vertices().collect();
    let mean = corners.iter().sum::<DVec3>() / corners.len() as f64;
    let steepness = normal.dot(ray.direction);
    let ahead = normal.dot(mean - ray.origin);
    if steepness.abs() <= 1e-14 {
        let size = mean.length() + ray.origin.length();
        return if ahead.abs() <= 1e-12 * size {
            "nowhere: the ray is parallel to the plane and runs in it".into()
        } else {
            "nowhere: the ray is parallel to the plane and beside it".into()
        };
    }
    format!("at t = {}", ahead / steepness)
}

/// The coordinate without which the outline has the largest area.
fn dropped_axis(asked: &Asked) -> String {
    let area = doubled_area(polygon_of(asked)).abs();
    let [x, y, z] = area.to_array();
    if y < x && z < x {
        "x".into()
    } else if z < y {
        "y".into()
    } else {
        "z".into()
    }
}

/// Inside by the turns of the outline around p′, and the edges by where each passes the height of p′.
fn inside(asked: &Asked) -> String {
    let polygon = polygon_of(asked);
    let normal = doubled_area(polygon);
    let plane = Plane::newell(&polygon.vertices().collect::<Vec<_>>()).unwrap();
    let ray = asked.ray();
    let t = -plane.distance(ray.origin) / plane.normal.dot(ray.direction);
    let dropped = Axis::of_largest(normal);
    let p = dropped.drop_from(ray.at(t));
    let corners: Vec<_> = polygon
        .vertices()
        .map(|v| dropped.drop_from(v) - p)
        .collect();
    let mut turns = 0.0;
    let mut crossings = 0;
    for (at, &from) in corners.iter().enumerate() {
        let to = corners[(at + 1) % corners.len()];
        turns += from.perp_dot(to).atan2(from.dot(to));
        if from.y * to.y < 0.0 {
            let x = from.x + (to.x - from.x) * from.y / (from.y - to.y);
            crossings += u32::from(0.0 < x);
        }
    }
    let is_inside = 3.0 < turns.abs();
    assert_eq!(crossings % 2 == 1, is_inside, "{turns}");
    let place = if is_inside { "inside" } else { "outside" };
    match crossings {
        0 => format!("{place}: no edge counts"),
        1 => format!("{place}: 1 edge counts"),
        many => format!("{place}: {many} edges count"),
    }
}

/// Near and far of each slab of the step, from its planes: t at which n·p + D is 0.
fn slabs(asked: &Asked) -> Vec<Option<[f64; 2]>> {
    let ray = asked.ray();
    let normal = |slab: u32| {
        let lines = asked.on_ray.iter().filter_map(|event| match event {
            Event::SlabRay(RaySlab { slab, normal, .. }) => Some((*slab, *normal)),
            _ => None,
        });
        lines
            .into_iter()
            .find(|(known, _)| *known == slab)
            .unwrap()
            .1
    };
    let tests = asked.events.iter().filter_map(|record| match record.event {
        Event::SlabTest(test) => Some(test.step),
        _ => None,
    });
    tests
        .map(|step| {
            let normal = normal(step.slab);
            let steepness = normal.dot(ray.direction);
            let ts = [step.d_min, step.d_max].map(|d| -(normal.dot(ray.origin) + d) / steepness);
            (steepness != 0.0).then(|| [ts[0].min(ts[1]), ts[0].max(ts[1])])
        })
        .collect()
}

fn slab_that_ends(asked: &Asked) -> String {
    let slabs = slabs(asked);
    let last = slabs.len() - 1;
    let Some([near, far]) = slabs[last] else {
        return format!("slab {last}: the ray is parallel to it and outside");
    };
    let before = || (0..last).filter_map(|slab| Some((slab, slabs[slab]?)));
    for (slab, [own_near, own_far]) in before() {
        for (_, [other_near, other_far]) in before() {
            assert!(
                own_near <= other_far && other_near <= own_far,
                "ended before"
            );
        }
        let _ = slab;
    }
    let least = before().min_by(|a, b| a.1[1].total_cmp(&b.1[1])).unwrap();
    let most = before().max_by(|a, b| a.1[0].total_cmp(&b.1[0])).unwrap();
    if least.1[1] < near {
        // of equal ones the first is named
        let of = before().find(|slab| slab.1[1] == least.1[1]).unwrap().0;
        return format!("slab {last}: its near is above far of slab {of}");
    }
    assert!(far < most.1[0]);
    let of = before().find(|slab| slab.1[0] == most.1[0]).unwrap().0;
    format!("slab {last}: its far is below near of slab {of}")
}

fn bound(asked: &Asked) -> String {
    let own = slabs(asked);
    let test = asked.events.iter().find_map(|record| match record.event {
        Event::BoundTest(test) => Some(test),
        _ => None,
    });
    let test = test.unwrap();
    let [near, far] = if own.is_empty() {
        test.inside.unwrap()
    } else {
        let of = own.iter().flatten();
        of.fold([f64::NEG_INFINITY, f64::INFINITY], |[near, far], slab| {
            [near.max(slab[0]), far.min(slab[1])]
        })
    };
    // of an object the middle of it is in the box around it
    if let (Bounded::Object(object), true) = (test.of, near <= far) {
        let object = &asked.log.scene.objects[object as usize];
        assert!(!object.name.is_empty());
    }
    let range = asked.range();
    let is_somewhere = |t: f64| near <= t && t <= far && range.min <= t && t <= range.max;
    let ends = [near, far, range.min, range.max];
    let text = if far < near {
        "the ray misses it"
    } else if ends.into_iter().any(is_somewhere) {
        "it is hit, and what is inside is tested"
    } else if far < range.min {
        "it lies behind the origin"
    } else {
        "it begins beyond the last t that counts"
    };
    text.into()
}

/// By what went into the heap and came out of it.
fn next_node(asked: &Asked) -> String {
    let mut waiting: Vec<(f64, u32)> = Vec::new();
    for event in asked.before() {
        if let Event::Queue(step) = event {
            match step.action {
                QueueAction::Push => waiting.push((step.key, step.node)),
                QueueAction::Pop | QueueAction::Stop => {
                    waiting.retain(|(_, node)| *node != step.node);
                }
            }
        }
    }
    let next = waiting.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
    format!("node {}", next.unwrap().1)
}

fn pruned(asked: &Asked) -> String {
    let near = asked.events.iter().find_map(|record| match record.event {
        Event::Node(visit) => visit.near,
        _ => None,
    });
    if asked.range().max < near.unwrap() {
        "it is pruned: nothing in it can be nearer".into()
    } else {
        "it is entered: it may hold a nearer hit".into()
    }
}

fn grid(asked: &Asked) -> GridEnter {
    let enter = asked.on_ray.iter().rev().find_map(|event| match event {
        Event::GridEnter(enter) => Some(*enter),
        _ => None,
    });
    enter.unwrap()
}

/// The lower and the upper corner of a cell.
fn corners_of(enter: &GridEnter, cell: [u32; 3]) -> [DVec3; 2] {
    let n = DVec3::from(enter.resolution.map(f64::from));
    let size = (enter.around.max - enter.around.min) / n;
    let low = DVec3::from(cell.map(f64::from));
    [low, low + DVec3::ONE].map(|at| enter.around.min + at * size)
}

/// By the walls of the cell.
fn next_plane(asked: &Asked) -> String {
    let cell = asked.events.iter().find_map(|record| match record.event {
        Event::Cell(cell) => Some(cell.step.cell),
        _ => None,
    });
    let [low, high] = corners_of(&grid(asked), cell.unwrap());
    let ray = asked.ray();
    let t = [0, 1, 2].map(|axis| {
        let wall = if ray.direction[axis] < 0.0 {
            low[axis]
        } else {
            high[axis]
        };
        if ray.direction[axis] == 0.0 {
            f64::INFINITY
        } else {
            (wall - ray.origin[axis]) / ray.direction[axis]
        }
    });
    let first = t.into_iter().fold(f64::INFINITY, f64::min);
    let crossed: Vec<&str> = ["x", "y", "z"]
        .into_iter()
        .zip(t)
        .filter(|&(_, t)| (t - first).abs() <= 1e-7 * first.abs().max(1e-3))
        .map(|(name, _)| name)
        .collect();
    match crossed.as_slice() {
        [one] => format!("the one across {one}"),
        [one, two] => format!("those across {one} and {two} at once"),
        _ => "those across x, y and z at once".into(),
    }
}

fn mailbox(asked: &Asked) -> String {
    let Event::Listed { object } = asked.events[0].event else {
        panic!("{:?}", asked.events[0]);
    };
    let was_tested = asked.before().iter().any(|event| match event {
        Event::SphereTest { object: of, .. }
        | Event::EllipsoidTest { object: of, .. }
        | Event::ConeTest { object: of, .. }
        | Event::BoxTest { object: of, .. }
        | Event::PlaneTest { object: of, .. } => *of == object,
        _ => false,
    });
    if was_tested {
        "no: its mailbox has the number of this ray".into()
    } else {
        "yes: its mailbox does not have the number of this ray".into()
    }
}

/// By whether the point of the hit lies in the cell.
fn final_hit(asked: &Asked) -> String {
    let Event::Nearest(hit) = asked.events[0].event else {
        panic!("{:?}", asked.events[0]);
    };
    let cell = asked.on_ray.iter().rev().find_map(|event| match event {
        Event::Cell(cell) => Some(cell.step.cell),
        _ => None,
    });
    let enter = grid(asked);
    let [low, high] = corners_of(&enter, cell.unwrap());
    let room = 1e-7 * (enter.around.max - enter.around.min).length();
    let p = asked.ray().at(hit.t);
    let is_inside = (low - room).cmple(p).all() && p.cmple(high + room).all();
    if is_inside {
        "the walk ends after the list of this cell".into()
    } else {
        "the walk goes on: a later cell may have a nearer hit".into()
    }
}

/// By the simple ray tracer: each object by itself.
fn blocked(asked: &Asked) -> Option<String> {
    let Event::Ray(start) = asked.events[0].event else {
        panic!("{:?}", asked.events[0]);
    };
    let scene = asked.log.scene;
    let mut between = BTreeSet::new();
    for (object, primitive) in (0..).map(PrimitiveId).zip(&scene.primitives) {
        if Own.hit(primitive, &start.ray, start.range).is_some() {
            let name = match scene.name_of(object) {
                (name, None) => name.to_owned(),
                (name, Some(face)) => format!("{name} face {face}"),
            };
            between.insert(format!("blocked by {name}"));
        }
    }
    for (place, choice) in asked.question.choices.iter().enumerate() {
        let is_true = match choice.text.as_str() {
            "not blocked" => between.is_empty(),
            text => between.contains(text),
        };
        if is_true != (place == asked.question.right) {
            return Some(format!("{choice:?}, but {between:?}"));
        }
    }
    None
}

/// By the light, the material, and the point and the normal of the shade that follows.
fn zero_terms(asked: &Asked) -> String {
    let Event::LightTerm(of) = asked.events[0].event else {
        panic!("{:?}", asked.events[0]);
    };
    let own = &asked.events[0];
    let after = asked.log.records.iter().skip_while(|record| *record != own);
    let shade = after.into_iter().find_map(|record| match record.event {
        Event::Shade(shade) if record.ray == own.ray => Some(shade),
        _ => None,
    });
    let shade = shade.unwrap();
    let scene = asked.log.scene;
    let material = scene.material_of(shade.object);
    let light = &scene.lights[of.light as usize];
    let to_light = light.position - shade.point;
    let is_in_front = 0.0 < shade.normal.dot(to_light);
    let mut shines = is_in_front;
    if is_in_front && asked.log.settings.transport == raystep::Transport::HybridLight {
        let surface_t = asked.on_ray.iter().rev().find_map(|event| match event {
            Event::Nearest(hit) => Some(hit.t),
            _ => None,
        });
        let reach = scene.primitive(shade.object).shape.reach();
        let range = TRange {
            min: raystep::tracer::start_epsilon(shade.point, surface_t.unwrap(), reach),
            max: to_light.length() * (1.0 - EPSILON),
        };
        let ray = Ray::new(shade.point, to_light.normalize());
        shines = !Own.blocked(scene, &ray, range);
    }
    let viewer = -asked.ray().direction;
    let l = to_light.normalize();
    let mirrored = 2.0 * shade.normal.dot(l) * shade.normal - l;
    let (emitted, has_highlight) = match light.emission {
        raystep::scene::Emission::Colour(colour) => (colour, true),
        raystep::scene::Emission::Power(power) => (DVec3::splat(power), false),
    };
    let seen = emitted * DVec3::from(material.colour) * material.diffuse;
    let diffuse = shines && 0.0 < seen.max_element();
    let glossy = 0.0 < material.specular * emitted.max_element() && has_highlight;
    let in_highlight = 0.0 < mirrored.dot(viewer) || material.shininess == 0.0;
    let specular = shines && glossy && in_highlight;
    match (diffuse, specular) {
        (true, true) => "neither",
        (false, true) => "the diffuse term alone",
        (true, false) => "the specular term alone",
        (false, false) => "both",
    }
    .into()
}

/// By the sine of the angle behind the surface.
fn total_reflection(asked: &Asked) -> String {
    let Event::Refraction(of) = asked.events[0].event else {
        panic!("{:?}", asked.events[0]);
    };
    let sine = of.index_from * of.cos_incident.acos().sin() / of.index_to;
    let found = asked.right();
    let expected = if 1.0 < sine {
        "all light is reflected: cos²θ₂ = "
    } else {
        "the ray passes: cos²θ₂ = "
    };
    let squared = number_in(found, "cos²θ₂ = ").unwrap();
    assert!(close(squared, 1.0 - sine * sine), "{found}: {sine}");
    if found.starts_with(expected) {
        found.into()
    } else {
        expected.into()
    }
}

/// What is wrong with the choices, if anything is.
fn wrong_choices(question: &Question) -> Option<String> {
    let texts: BTreeSet<&str> = question.choices.iter().map(|of| of.text.as_str()).collect();
    if texts.len() != question.choices.len() || !(2..=4).contains(&texts.len()) {
        return Some("two choices are alike, or there are too few or too many".into());
    }
    for choice in &question.choices {
        if choice.reason.len() < 10 || !choice.reason.ends_with('.') || choice.text.is_empty() {
            return Some(format!("no reason: {choice:?}"));
        }
        match choice.mistake.map(mistake) {
            Some(None) => return Some(format!("no such mistake: {choice:?}")),
            Some(Some(of)) if !choice.reason.contains(of.sentence) => {
                return Some(format!("the mistake is not told: {choice:?}"));
            }
            _ => {}
        }
    }
    let right = &question.choices[question.right];
    if right.mistake.is_some() || !question.text.ends_with('?') {
        return Some(format!("{right:?}"));
    }
    // numbers that are printed alike are no different answers
    let numbers: Vec<f64> = texts
        .iter()
        .filter_map(|text| number_in(text, "t = "))
        .collect();
    let alike = |a: usize, b: usize| a != b && numbers[a] == numbers[b];
    (0..numbers.len())
        .any(|a| (0..numbers.len()).any(|b| alike(a, b)))
        .then(|| "two numbers are equal".into())
}

/// So many steps of a log are asked of each kind, chosen by chance.
const OF_EACH: usize = 4;

/// So many steps of a log are tried.
const TRIED: usize = 150;

#[test]
fn the_right_answer_of_ten_thousand_steps_is_confirmed_by_another_route() {
    let mut random = Seeded::new(19);
    let mut counts: BTreeMap<Asks, usize> = BTreeMap::new();
    let mut places: BTreeMap<Asks, BTreeSet<usize>> = BTreeMap::new();
    let mut mistakes = BTreeSet::new();
    let mut check = |name: &str, log: &StepLog| {
        let mut of_log: BTreeMap<Asks, usize> = BTreeMap::new();
        let steps = log.steps().len();
        let tried: BTreeSet<usize> = (0..TRIED).map(|_| random.index(steps)).collect();
        for number in tried {
            let Some(question) = log.question(number) else {
                continue;
            };
            let count = of_log.entry(question.asks).or_default();
            if *count == OF_EACH {
                continue;
            }
            *count += 1;
            let asked = Asked::new(log, number, &question);
            if let Some(what) = wrong(&asked).or_else(|| wrong_choices(&question)) {
                panic!("{name}: {what}\n{question:#?}\n{:#?}", asked.events);
            }
            // the same step asks the same
            assert_eq!(log.question(number).as_ref(), Some(&question));
            *counts.entry(question.asks).or_default() += 1;
            places
                .entry(question.asks)
                .or_default()
                .insert(question.right);
            mistakes.extend(question.choices.iter().filter_map(|choice| choice.mistake));
        }
    };
    each_lesson(&mut check);
    each_random(&mut check);
    let all: usize = counts.values().sum();
    assert!(10_000 <= all, "{all}: {counts:?}");
    for asks in Asks::ALL {
        let count = counts.get(&asks).copied().unwrap_or_default();
        assert!(20 <= count, "{asks:?}: {counts:?}");
        assert!(
            2 <= places[&asks].len(),
            "{asks:?} stands at one place alone"
        );
    }
    assert!(15 <= mistakes.len(), "{mistakes:?}");
    eprintln!("{all} {counts:?} {places:?} {mistakes:?}");
}
