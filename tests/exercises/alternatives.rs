//! Functions that are written another way than the solutions: right ones, right ones in another form, and wrong ones without a name.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};
use raystep::Scene;
use raystep::geometry::{
    Alignment, AxisBox, Inside, Polygon, Ray, Refraction, Sides, SlabInterval, SlabRay, Sphere,
    TRange,
};
use raystep::lesson::exercise::supplied::{Below, Cells, Tree, hit};
use raystep::lesson::exercise::{Attempt, course};
use raystep::scene::{Camera, Emission, Light, Material, Normals, PhongTerm, PrimitiveId, Shape};
use raystep::strategy::Hit;
use raystep::trace::BoundVerdict;

/// Right ones.
pub(super) fn right() -> Vec<Box<dyn Attempt>> {
    vec![
        course::WINDOW_POINT.with(from_the_top_left),
        course::EYE_RAY.with(|camera, to_window| Ray::new(camera.cop, to_window.normalize())),
        course::NEAREST.with(by_least),
        course::POINT_AT_T.with(coordinate_by_coordinate),
        course::NORMALISED.with(by_root_of_squares),
        course::ROOTS.with(without_cancellation),
        course::ROOT_THAT_COUNTS.with(by_the_distance_from_the_centre),
        course::NORMALS.with(normalised_and_newell),
        course::LIGHT_TERM.with(by_halves),
        course::BLOCKED.with(by_a_loop_from_the_end),
        course::PLANE_T.with(from_a_vertex),
        course::PLANE_T.with(moller_trumbore),
        course::CROSSINGS.with(to_the_left),
        course::INSIDE.with(winding_number),
        course::REFLECT.with(|direction, normal| {
            let along = direction.dot(normal) * normal;
            (direction - along) - along
        }),
        course::REFRACT.with(by_angles),
        course::DIFFUSE_DIRECTION.with(around_a_unit_sphere),
        course::GEOMETRY_TERM.with(without_unit_vectors),
        course::IRRADIANCE.with(by_selection),
        course::ALIGN.with(any_pair),
        course::Z_SORT.with(by_the_ray),
        course::SLAB_INTERVAL.with(by_the_sign_of_t),
        course::INTERVAL.with(by_comparisons),
        course::BOUND_VERDICT.with(near_and_far),
        course::HIER_TRAVERSE.with(nearest_child_first),
        course::HIER_TRAVERSE.with(all_nodes_level_by_level),
        course::SPLIT_COST
            .with(|node, area, [(a, n), (b, m)]| node + a / area * n as f64 + b / area * m as f64),
        course::WALK.with(one_axis_at_a_time),
        course::CELL_OF.with(by_counting_planes),
    ]
}

fn from_the_top_left(camera: &Camera, x: f64, y: f64) -> DVec3 {
    let [width, height] = camera.pixels.map(f64::from);
    let pixel = [camera.right / width, -camera.up / height];
    camera.to_corner + camera.up + x * pixel[0] + y * pixel[1]
}

fn by_least(scene: &Scene, ray: &Ray, range: TRange) -> Option<Hit> {
    let objects = (0..).map(PrimitiveId).zip(&scene.primitives);
    let hits = objects.filter_map(|(object, of)| {
        Some(Hit {
            object,
            t: hit(of, ray, range)?,
        })
    });
    hits.min_by(|one, other| one.t.partial_cmp(&other.t).unwrap())
}

fn coordinate_by_coordinate(ray: &Ray, t: f64) -> DVec3 {
    let (o, d) = (ray.origin, ray.direction);
    DVec3::new(o.x + t * d.x, o.y + t * d.y, o.z + t * d.z)
}

fn by_root_of_squares(ray: &Ray) -> Option<(Ray, f64)> {
    let d = ray.direction;
    let length = (d.x * d.x + d.y * d.y + d.z * d.z).sqrt();
    (0.0 < length).then(|| (Ray::new(ray.origin, d * (1.0 / length)), length))
}

/// The quadratic formula with b′ = b/2, and the second root from t₁·t₂ = c/a.
fn without_cancellation(a: f64, b: f64, c: f64) -> Vec<f64> {
    let half = 0.5 * b;
    let discriminant = half * half - a * c;
    if discriminant < 0.0 {
        return vec![];
    }
    let q = -(half + discriminant.sqrt().copysign(half));
    let mut roots = vec![q / a, c / q];
    roots.sort_by(f64::total_cmp);
    roots.dedup();
    roots
}

fn by_the_distance_from_the_centre(
    sphere: &Sphere,
    ray: &Ray,
    range: TRange,
    _: Sides,
) -> Option<f64> {
    let length = ray.direction.length();
    let unit = ray.direction / length;
    let to_foot = (sphere.center - ray.origin).dot(unit);
    let foot = ray.origin + to_foot * unit;
    let half = sphere.radius.powi(2) - foot.distance_squared(sphere.center);
    if half < 0.0 {
        return None;
    }
    let roots = [to_foot - half.sqrt(), to_foot + half.sqrt()].map(|t| t / length);
    roots
        .into_iter()
        .find(|t| 0.0 < *t && range.min <= *t && *t <= range.max)
}

fn normalised_and_newell(shape: &Shape, point: DVec3) -> Normals {
    let normal = match shape {
        Shape::Sphere(sphere) => (point - sphere.center).normalize(),
        Shape::Polygon(polygon) => {
            let corners: Vec<DVec3> = polygon.vertices().collect();
            let next = corners.iter().cycle().skip(1);
            corners
                .iter()
                .zip(next)
                .map(|(a, b)| a.cross(*b))
                .sum::<DVec3>()
                .normalize()
        }
        _ => return shape.normals(point),
    };
    Normals {
        geometric: normal,
        shading: normal,
    }
}

/// V mirrored and compared with L, which is the same as L mirrored and compared with V.
fn by_halves(
    light: &Light,
    material: &Material,
    point: DVec3,
    normal: DVec3,
    to_viewer: DVec3,
) -> PhongTerm {
    let Emission::Colour(colour) = light.emission else {
        panic!("lights of exercises have a colour");
    };
    let to_light = (light.position - point).normalize();
    let n_dot_l = normal.dot(to_light);
    let mirrored = 2.0 * normal.dot(to_viewer) * normal - to_viewer;
    let lit = if 0.0 < n_dot_l { 1.0 } else { 0.0 };
    let r_dot_v = mirrored.dot(to_light);
    PhongTerm {
        to_light,
        distance: light.position.distance(point),
        n_dot_l,
        r_dot_v,
        diffuse: lit * n_dot_l * material.diffuse * colour * DVec3::from(material.colour),
        specular: lit * material.specular * r_dot_v.max(0.0).powf(material.shininess) * colour,
    }
}

fn by_a_loop_from_the_end(scene: &Scene, ray: &Ray, range: TRange) -> bool {
    let mut found = false;
    for primitive in scene.primitives.iter().rev() {
        found |= hit(primitive, ray, range).is_some();
    }
    found
}

fn from_a_vertex(polygon: &Polygon, ray: &Ray, range: TRange, _: Sides) -> Option<f64> {
    let normal = polygon.plane().normal;
    let vertex = polygon.vertices().next()?;
    let slope = normal.dot(ray.direction);
    let t = normal.dot(vertex - ray.origin) / slope;
    (slope != 0.0 && 0.0 < t && range.min <= t && t <= range.max).then_some(t)
}

/// T. Möller and B. Trumbore (1997), without the test of the edges.
fn moller_trumbore(polygon: &Polygon, ray: &Ray, range: TRange, _: Sides) -> Option<f64> {
    let v: Vec<DVec3> = polygon.vertices().collect();
    let (e1, e2) = (v[1] - v[0], v[2] - v[0]);
    let determinant = e1.dot(ray.direction.cross(e2));
    if determinant.abs() < 1e-12 {
        return None;
    }
    let t = e2.dot((ray.origin - v[0]).cross(e1)) / determinant;
    (0.0 < t && range.min <= t && t <= range.max).then_some(t)
}

/// The half-line runs the other way, and the lower end of an edge counts instead of the upper one.
fn to_the_left(outline: &[DVec2], p: DVec2) -> usize {
    let mut count = 0;
    for (place, from) in outline.iter().enumerate() {
        let to = outline[(place + 1) % outline.len()];
        if (from.y <= p.y) != (to.y <= p.y) {
            let x = from.x + (p.y - from.y) * (to.x - from.x) / (to.y - from.y);
            count += usize::from(x < p.x);
        }
    }
    count
}

fn winding_number(polygon: &Polygon, ray: &Ray, t: f64) -> bool {
    let p = polygon.dropped().drop_from(ray.at(t));
    let outline = polygon.outline();
    let mut turns = 0.0;
    for (place, from) in outline.iter().enumerate() {
        let to = outline[(place + 1) % outline.len()];
        turns += (*from - p).angle_to(to - p) / (2.0 * PI);
    }
    0.5 < turns.abs()
}

fn by_angles(direction: DVec3, normal: DVec3, index_from: f64, index_to: f64) -> Refraction {
    let cos_incident = -direction.dot(normal);
    let across = direction + cos_incident * normal;
    let sine = index_from / index_to * across.length();
    let transmitted = (sine <= 1.0).then(|| {
        let cosine = (1.0 - sine * sine).sqrt();
        sine * across.normalize_or_zero() - cosine * normal
    });
    Refraction {
        index_from,
        index_to,
        cos_incident,
        cos_refracted_squared: 1.0 - sine * sine,
        direction: transmitted,
    }
}

/// A point of the unit sphere that touches the surface from above.
fn around_a_unit_sphere(normal: DVec3, u: f64, v: f64) -> DVec3 {
    let z = 1.0 - 2.0 * u;
    let radius = (1.0 - z * z).sqrt();
    let angle = 2.0 * PI * v;
    (normal + DVec3::new(radius * angle.cos(), z, radius * angle.sin())).normalize()
}

fn without_unit_vectors(from: DVec3, normal_from: DVec3, to: DVec3, normal_to: DVec3) -> f64 {
    let (leaves, arrives) = (normal_from.dot(to - from), normal_to.dot(from - to));
    if leaves < 0.0 || arrives < 0.0 {
        return 0.0;
    }
    leaves * arrives / (to - from).length_squared().powi(2)
}

fn by_selection(photons: &[(f64, f64)], k: usize) -> f64 {
    let mut distances: Vec<f64> = photons.iter().map(|(distance, _)| *distance).collect();
    distances.sort_by(f64::total_cmp);
    let Some(radius) = distances.get(k.min(distances.len()).wrapping_sub(1)) else {
        return 0.0;
    };
    let inside = photons.iter().filter(|(distance, _)| distance < radius);
    inside.map(|(_, power)| power).sum::<f64>() / (PI * radius.powi(2))
}

fn any_pair(ray: &Ray) -> Alignment {
    let (x, y) = ray.direction.any_orthonormal_pair();
    let (x, y) = if 0.0 < x.cross(y).dot(ray.direction) {
        (x, y)
    } else {
        (y, x)
    };
    Alignment {
        origin: ray.origin,
        x,
        y,
        z: ray.direction,
    }
}

fn by_the_ray(frame: &Alignment, z: &[f64]) -> Option<(usize, DVec3)> {
    let mut nearest: Option<(usize, f64)> = None;
    for (object, &z) in z.iter().enumerate() {
        if 0.0 < z && nearest.is_none_or(|(_, nearest)| z < nearest) {
            nearest = Some((object, z));
        }
    }
    nearest.map(|(object, z)| (object, frame.origin + z * frame.z))
}

fn by_the_sign_of_t(line: &SlabRay, d_min: f64, d_max: f64) -> SlabInterval {
    let [from_min, from_max] = [line.s + d_min, line.s + d_max];
    if 1e200 < line.t_scale.abs() {
        return if 0.0 < from_min || from_max < 0.0 {
            SlabInterval::ParallelOutside
        } else {
            SlabInterval::ParallelInside
        };
    }
    let (near, far) = if 0.0 < line.t_scale {
        (from_min, from_max)
    } else {
        (from_max, from_min)
    };
    SlabInterval::Between {
        near: near * line.t_scale,
        far: far * line.t_scale,
    }
}

/// An empty interval may have any ends that have crossed.
fn by_comparisons(mut so_far: Inside, slab: SlabInterval) -> Inside {
    match slab {
        SlabInterval::Between { near, far } => {
            if so_far.near < near {
                so_far.near = near;
            }
            if far < so_far.far {
                so_far.far = far;
            }
        }
        SlabInterval::ParallelInside => {}
        SlabInterval::ParallelOutside => {
            so_far = Inside {
                near: 1.0,
                far: 0.0,
            }
        }
    }
    so_far
}

fn near_and_far(inside: Option<[f64; 2]>, range: TRange) -> BoundVerdict {
    match inside {
        Some([near, far]) if near <= range.max && range.min <= far => BoundVerdict::Hit,
        Some([near, _]) if range.max < near => BoundVerdict::Beyond,
        Some(_) => BoundVerdict::Behind,
        None => BoundVerdict::Missed,
    }
}

fn nearest_child_first(tree: &Tree<'_>, ray: &Ray) -> Option<(usize, f64)> {
    let mut nearest: Option<(usize, f64)> = None;
    let mut stack: Vec<(f64, usize)> = tree
        .near(0, ray, TRange::FORWARD)
        .map(|near| (near, 0))
        .into_iter()
        .collect();
    while let Some((near, node)) = stack.pop() {
        if nearest.is_some_and(|(_, t)| t < near) {
            continue;
        }
        match tree.below(node) {
            Below::Children(children) => {
                let met = children
                    .iter()
                    .filter_map(|&child| Some((tree.near(child, ray, TRange::FORWARD)?, child)));
                let mut met: Vec<_> = met.collect();
                met.sort_by(|one, other| other.0.total_cmp(&one.0));
                stack.extend(met);
            }
            Below::Objects(objects) => {
                for &object in objects {
                    let hit = tree.hit(object, ray, TRange::FORWARD).map(|t| (object, t));
                    nearest = match (nearest, hit) {
                        (Some(old), Some(new)) => Some(if new.1 < old.1 { new } else { old }),
                        (old, new) => old.or(new),
                    };
                }
            }
        }
    }
    nearest
}

fn all_nodes_level_by_level(tree: &Tree<'_>, ray: &Ray) -> Option<(usize, f64)> {
    let (mut level, mut hits) = (vec![0], Vec::new());
    while !level.is_empty() {
        let mut next = Vec::new();
        for node in level {
            if tree.near(node, ray, TRange::FORWARD).is_some() {
                match tree.below(node) {
                    Below::Children(children) => next.extend(children),
                    Below::Objects(objects) => hits.extend(objects.iter().filter_map(|&object| {
                        Some((object, tree.hit(object, ray, TRange::FORWARD)?))
                    })),
                }
            }
        }
        level = next;
    }
    hits.into_iter()
        .min_by(|one, other| one.1.total_cmp(&other.1))
}

/// At an edge it visits a cell that the ray only touches, and t is added up.
fn one_axis_at_a_time(cells: &Cells<'_>, ray: &Ray) -> Option<(usize, f64)> {
    let mut cell = cells.first(ray)?;
    let mut nearest: Option<(usize, f64)> = None;
    let mut next = [f64::INFINITY; 3];
    for axis in 0..3 {
        let up = usize::from(0.0 < ray.direction[axis]);
        if ray.direction[axis] != 0.0 {
            next[axis] = (cells.planes(axis)[cell[axis] as usize + up] - ray.origin[axis])
                / ray.direction[axis];
        }
    }
    loop {
        for (object, t) in cells.visit(cell, ray) {
            if nearest.is_none_or(|(_, nearest)| t < nearest) {
                nearest = Some((object, t));
            }
        }
        let mut axis = 0;
        for other in 1..3 {
            if next[other] < next[axis] {
                axis = other;
            }
        }
        if nearest.is_some_and(|(_, t)| t <= next[axis]) {
            return nearest;
        }
        let down = ray.direction[axis] < 0.0;
        let end = if down {
            0
        } else {
            cells.resolution()[axis] - 1
        };
        if cell[axis] == end {
            return nearest;
        }
        cell[axis] = if down { cell[axis] - 1 } else { cell[axis] + 1 };
        let side = cells.planes(axis)[1] - cells.planes(axis)[0];
        next[axis] += side / ray.direction[axis].abs();
    }
}

fn by_counting_planes(around: &AxisBox, resolution: [u32; 3], point: DVec3) -> [u32; 3] {
    let of = |axis: usize| {
        let side = (around.max[axis] - around.min[axis]) / f64::from(resolution[axis]);
        let planes = 1..resolution[axis];
        planes
            .filter(|i| around.min[axis] + f64::from(*i) * side <= point[axis])
            .count() as u32
    };
    [of(0), of(1), of(2)]
}

/// N·H in place of R·V.
fn blinn(
    light: &Light,
    material: &Material,
    point: DVec3,
    normal: DVec3,
    to_viewer: DVec3,
) -> PhongTerm {
    let term = light.phong(material, point, normal, to_viewer);
    let half = (term.to_light + to_viewer).normalize();
    let Emission::Colour(colour) = light.emission else {
        return term;
    };
    let highlight = normal.dot(half).max(0.0).powf(material.shininess);
    let lit = if 0.0 < term.n_dot_l { 1.0 } else { 0.0 };
    PhongTerm {
        specular: lit * material.specular * highlight * colour,
        ..term
    }
}

/// Right in another form than the one that is asked for.
pub(super) fn other_forms() -> Vec<Box<dyn Attempt>> {
    vec![
        course::EYE_RAY.with(|camera, to_window| Ray::new(camera.cop, to_window)),
        course::LIGHT_TERM.with(blinn),
        course::COEFFICIENTS.with(|sphere, ray| {
            let offset = ray.origin - sphere.center;
            let c = offset.length_squared() - sphere.radius.powi(2);
            [ray.direction.length_squared(), ray.direction.dot(offset), c]
        }),
        course::ROOTS.with(|a, b, c| {
            let mut roots = without_cancellation(a, b, c);
            roots.reverse();
            roots
        }),
        course::DIFFUSE_DIRECTION.with(|normal, u, v| {
            let (across, along) = normal.any_orthonormal_pair();
            let (sine, cosine) = (2.0 * PI * v).sin_cos();
            (1.0 - u * u).sqrt() * (cosine * across + sine * along) + u * normal
        }),
        course::IRRADIANCE.with(|photons, k| {
            let mut photons = photons.to_vec();
            photons.sort_by(|one, other| one.0.total_cmp(&other.0));
            photons.truncate(k);
            let Some((radius, _)) = photons.last() else {
                return 0.0;
            };
            photons.iter().map(|(_, power)| power).sum::<f64>() / (PI * radius.powi(2))
        }),
        course::COST.with(|[width, height], objects, _, _| width * height * objects),
        course::SLAB_OF.with(|vertices, n| {
            let along = vertices.iter().map(|v| n.dot(*v));
            let [low, high] = [along.clone().reduce(f64::min), along.reduce(f64::max)];
            [low.unwrap(), high.unwrap()]
        }),
        course::SLAB_RAY.with(|ray, n| SlabRay {
            s: n.dot(ray.origin),
            t_scale: -n.dot(ray.direction),
        }),
        course::SPLIT_COST.with(|node, _, [(a, n), (b, m)]| node + a * n as f64 + b * m as f64),
    ]
}

/// Wrong, but no mistake that has a name.
pub(super) fn unnamed() -> Vec<Box<dyn Attempt>> {
    vec![
        // of equal t the last object: not "last hit wins"
        course::NEAREST.with(|scene, ray, range| {
            let mut nearest: Option<Hit> = None;
            for (number, primitive) in (0..).zip(&scene.primitives) {
                if let Some(t) = hit(primitive, ray, range)
                    && nearest.is_none_or(|nearest| t <= nearest.t)
                {
                    nearest = Some(Hit {
                        object: PrimitiveId(number),
                        t,
                    });
                }
            }
            nearest
        }),
        course::ROOT_THAT_COUNTS.with(|sphere, ray, _, sides| {
            let range = TRange { min: 0.0, max: 4.0 };
            by_the_distance_from_the_centre(sphere, ray, range, sides)
        }),
        course::REFLECT.with(|direction, normal| direction - direction.dot(normal) * normal),
        course::PLANE_T.with(|polygon, ray, range, sides| {
            Some(1.001 * from_a_vertex(polygon, ray, range, sides)?)
        }),
        course::WINDOW_POINT.with(|camera, x, y| from_the_top_left(camera, x + 1.0, y)),
        course::SLAB_INTERVAL.with(|_, _, _| SlabInterval::ParallelInside),
        course::BLOCKED.with(|_, _, _| true),
    ]
}
