//! The tests of objects, by distances, areas and angles.

use glam::DVec3;
use raystep::Event;
use raystep::geometry::{Axis, Plane, Polygon};
use raystep::scene::Shape;
use raystep::tracer::simple::{Own, Parts};

use super::Asked;

/// By the distance at which the line passes the center, in the space in which the surface is a unit sphere; of a cone by the
/// sign of the quadratic at its vertex.
pub(super) fn root_count(asked: &Asked) -> String {
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
pub(super) fn root_that_counts(asked: &Asked) -> String {
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

pub(super) fn polygon_of<'l>(asked: &Asked<'_, 'l>) -> &'l Polygon {
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
pub(super) fn doubled_area(polygon: &Polygon) -> DVec3 {
    let corners: Vec<DVec3> = polygon.vertices().collect();
    let from = corners[0];
    let pairs = corners.windows(2);
    pairs
        .map(|pair| (pair[0] - from).cross(pair[1] - from))
        .sum()
}

/// By the cross products of the corners and the mean corner.
pub(super) fn plane_t(asked: &Asked) -> String {
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
pub(super) fn dropped_axis(asked: &Asked) -> String {
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
pub(super) fn inside(asked: &Asked) -> String {
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
