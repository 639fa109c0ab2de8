//! The answers by another route: what a question takes from the trace is computed again in another way.

use raystep::geometry::{Ray, TRange};
use raystep::lesson::question::{Ask, Asked, Form, QuestionSpec};
use raystep::scene::{PrimitiveId, Shape};
use raystep::strategy::{Exhaustive, Strategy};
use raystep::trace::{Purpose, RayStart, RayVerdict};
use raystep::{Event, Off, Record, Scene};

use super::{all, lessons};

/// Numbers of two routes that differ by rounding alone.
const SAME: f64 = 1e-6;

fn start_of<'a>(records: &'a [Record], of: &Record) -> Option<&'a RayStart> {
    let same = |record: &&Record| record.ray == of.ray && record.path == of.path;
    records
        .iter()
        .filter(same)
        .find_map(|record| match &record.event {
            Event::Ray(start) => Some(start),
            _ => None,
        })
}

/// Where the line of a ray is on a sphere, by the point nearest to the center and the half chord.
fn on_sphere(ray: &Ray, scene: &Scene, object: PrimitiveId) -> Option<[f64; 2]> {
    let Shape::Sphere(sphere) = &scene.primitive(object).shape else {
        return None;
    };
    let middle = (sphere.center - ray.origin).dot(ray.direction) / ray.direction.length_squared();
    let distance = (ray.at(middle) - sphere.center).length();
    let half = (sphere.radius.powi(2) - distance.powi(2)).max(0.0).sqrt() / ray.direction.length();
    (distance <= sphere.radius).then_some([middle - half, middle + half])
}

#[test]
fn roots_of_spheres_are_where_half_chords_end() {
    let mut checked = 0;
    for asked in all() {
        let records = &asked.traced.records;
        for record in records.iter() {
            let Event::SphereTest { object, test } = &record.event else {
                continue;
            };
            let start = start_of(records, record).unwrap();
            let roots: Vec<f64> = test.roots.iter().map(|root| root.t).collect();
            match (
                on_sphere(&start.ray, &asked.traced.scene, *object),
                roots.as_slice(),
            ) {
                (Some(expected), [near, far]) => {
                    let size = far.abs().max(1.0);
                    for (found, expected) in [near, far].into_iter().zip(expected) {
                        // a half chord loses digits near a graze
                        assert!((found - expected).abs() <= 1e-4 * size, "{}", asked.name);
                    }
                    checked += 1;
                }
                (None, []) => checked += 1,
                // a graze is decided by rounding
                (_, [_]) | (Some(_), []) | (None, [_, _]) => {}
                (_, more) => panic!("{more:?}"),
            }
        }
    }
    assert!(300 < checked, "{checked}");
}

#[test]
fn every_hit_is_that_of_a_search_through_all_objects() {
    let mut checked = 0;
    for asked in all() {
        let (records, scene) = (&asked.traced.records, &asked.traced.scene);
        for record in records.iter() {
            let Event::RayEnd(end) = &record.event else {
                continue;
            };
            let Some(start) = start_of(records, record) else {
                continue;
            };
            let hit = Exhaustive::new(scene).nearest(&start.ray, start.range, &mut Off);
            match end.verdict {
                RayVerdict::Hit => {
                    let hit = hit.unwrap();
                    assert_eq!(Some(hit.object), end.object, "{}", asked.name);
                    assert!(
                        (hit.t - end.t.unwrap()).abs() <= SAME * hit.t,
                        "{}",
                        asked.name
                    );
                }
                RayVerdict::Miss | RayVerdict::ReachesLight => assert_eq!(hit, None),
                RayVerdict::Blocked => assert!(hit.is_some(), "{}", asked.name),
                _ => continue,
            }
            checked += 1;
        }
    }
    assert!(200 < checked, "{checked}");
}

/// The spec of a question.
fn spec(asked: &Asked) -> &'static QuestionSpec {
    let library = lessons();
    library.question(&asked.lesson, &asked.name).unwrap().1
}

#[test]
fn cells_in_order_are_those_of_points_along_the_ray() {
    /// So many points lie on each unit of the ray.
    const POINTS: f64 = 4096.0;
    let mut checked = 0;
    for asked in all() {
        let Form::Order(order) = &asked.form else {
            continue;
        };
        let records = &asked.traced.records;
        let entered = records.iter().find_map(|record| match &record.event {
            Event::GridEnter(grid) => Some((grid, start_of(records, record)?)),
            _ => None,
        });
        let (Some((grid, start)), Ask::Order(_)) = (entered, &spec(asked).ask) else {
            continue;
        };
        let (min, max) = (grid.around.min, grid.around.max);
        let mut cells: Vec<String> = Vec::new();
        let mut step = 0.0;
        while step < 40.0 * POINTS {
            let place = (start.ray.at(step / POINTS) - min) / (max - min);
            step += 1.0;
            if place.min_element() < 0.0 || 1.0 <= place.max_element() {
                continue;
            }
            let [i, j, k] =
                [0, 1, 2].map(|axis| (place[axis] * f64::from(grid.resolution[axis])).floor());
            let cell = format!("[{i}, {j}, {k}]");
            if cells.last() != Some(&cell) {
                cells.push(cell);
            }
        }
        let texts = order
            .order
            .iter()
            .map(|place| order.items[*place].text.clone());
        assert_eq!(texts.collect::<Vec<_>>(), cells, "{}", asked.name);
        checked += 1;
    }
    assert!(1 <= checked);
}

#[test]
fn whether_a_light_is_blocked_is_asked_of_every_object_alone() {
    let mut checked = 0;
    for asked in all() {
        let Form::Choice(choices) = &asked.form else {
            continue;
        };
        let event = &asked.traced.records[asked.place.event].event;
        let (Ask::Step(_), Event::Ray(start)) = (&spec(asked).ask, event) else {
            continue;
        };
        assert_eq!(start.purpose, Purpose::Shadow);
        let range = TRange {
            min: start.range.min,
            max: start.range.max,
        };
        let scene = &asked.traced.scene;
        let blocks = |id: PrimitiveId| {
            on_sphere(&start.ray, scene, id)
                .is_some_and(|roots| roots.iter().any(|t| 1e-6 < *t && *t < range.max))
        };
        let ids = (0..scene.primitives.len() as u32).map(PrimitiveId);
        let blockers: Vec<String> = ids
            .filter(|id| blocks(*id))
            .map(|id| format!("blocked by {}", scene.object_of(id).name))
            .collect();
        let right = &choices.iter().find(|choice| choice.right).unwrap().text;
        match blockers.as_slice() {
            [] => assert_eq!(right, "not blocked"),
            blockers => assert!(blockers.contains(right), "{right}: {blockers:?}"),
        }
        checked += 1;
    }
    assert!(3 <= checked, "{checked}");
}

#[test]
fn most_numbers_are_confirmed_by_a_formula_of_their_own() {
    // a formula that does not agree is refused when the question is asked
    let library = lessons();
    let questions = library.lessons.iter().flat_map(|of| &of.content.questions);
    let numbers: Vec<_> = questions
        .filter_map(|of| match &of.ask {
            Ask::Number(number) | Ask::Value(number) => Some(number.confirm.is_some()),
            _ => None,
        })
        .collect();
    let confirmed = numbers.iter().filter(|is| **is).count();
    assert!(
        numbers.len() <= 2 * confirmed,
        "{confirmed} of {}",
        numbers.len()
    );
}

/// How many times an outline runs around a point, by the angles under which its edges are seen from there.
fn winding(outline: &[glam::DVec2], point: glam::DVec2) -> f64 {
    let ends = outline.iter().zip(outline.iter().cycle().skip(1));
    let angles = ends.map(|(from, to)| (*from - point).angle_to(*to - point));
    angles.sum::<f64>() / std::f64::consts::TAU
}

#[test]
fn points_are_inside_a_polygon_if_its_outline_runs_around_them() {
    let mut checked = 0;
    for asked in all() {
        let scene = &asked.traced.scene;
        for record in asked.traced.records.iter() {
            let Event::PolygonTest { object, test } = &record.event else {
                continue;
            };
            let Shape::Polygon(polygon) = &scene.primitive(*object).shape else {
                continue;
            };
            let around = winding(polygon.outline(), test.projected).abs();
            assert_eq!(0.5 < around, test.inside, "{}: {around}", asked.name);
            checked += 1;
        }
    }
    assert!(60 < checked, "{checked}");
}

#[test]
fn refracted_rays_have_the_angle_of_snells_law() {
    let mut checked = 0;
    for asked in all() {
        for record in asked.traced.records.iter() {
            let Event::Refraction(found) = &record.event else {
                continue;
            };
            // n₁ sin θ₁ = n₂ sin θ₂
            let sine = found.index_from / found.index_to * found.cos_incident.acos().sin();
            assert_eq!(1.0 < sine, found.direction.is_none(), "{}", asked.name);
            if sine <= 1.0 {
                let cosine = sine.asin().cos();
                let expected = found.cos_refracted_squared.sqrt();
                assert!((cosine - expected).abs() < SAME, "{}", asked.name);
            }
            checked += 1;
        }
    }
    assert!(20 < checked, "{checked}");
}
