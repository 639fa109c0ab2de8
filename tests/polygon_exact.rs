//! Containment in a polygon against exact arithmetic.
//!
//! Where the projected point p′ decided, `inside` must be what the even-odd rule says about that very
//! f64 p′ in the f64 outline. Whoever decided, it must be what the even-odd rule says about the ray's
//! line and the outline seen along it, unless the line passes an edge so closely that f64 cannot say
//! where it runs. Rays exactly through edges and vertices are the subject of `polygon_tilings`.

use glam::{DMat3, DVec2, DVec3};
use raystep::geometry::{
    Axis, DecidedBy, Plane, PlaneVerdict, Polygon, PolygonTest, Ray, Sides, TRange,
};

use crate::exact::{Exact, ExactPoint, ExactVec3, Place, even_odd, exact_point};
use crate::seeded::Seeded;

/// The ray is held by two points, its origin and one as far out as its numbers allow. The second is
/// rounded, three times ε/2 of its coordinates: so far may the line run beside the exact one, as a
/// share of |o| + t|Δ|, at the plane. Five times that, for |Δ| against its longest coordinate and for
/// the digits of the distance it is compared with.
const LINE: f64 = 8.0 * f64::EPSILON;
/// Rays per kind of polygon and plane.
const RAYS: usize = 300;

/// The vertices as seen along the ray, exactly: wᵢΔₖ − wₖΔᵢ for the two axes i other than k, with
/// w = vertex − origin. The ray itself is seen as the point 0. Also: 1/|Δₖ|, for lengths.
fn seen_along(ray: &Ray, vertices: &[DVec3]) -> (Vec<ExactPoint>, f64) {
    let size = ray.direction.abs().to_array();
    let k = (0..3).max_by(|&i, &j| size[i].total_cmp(&size[j])).unwrap();
    let [i, j] = [(k + 1) % 3, (k + 2) % 3];
    let (origin, direction) = (ExactVec3::from(ray.origin), ExactVec3::from(ray.direction));
    let project = |&vertex: &DVec3| {
        let w = &ExactVec3::from(vertex) - &origin;
        [i, j].map(|axis| &w.0[axis] * &direction.0[k] - &w.0[k] * &direction.0[axis])
    };
    (vertices.iter().map(project).collect(), 1.0 / size[k])
}

/// The distance of the point 0 from an outline, to a few digits.
fn distance_from_zero(outline: &[ExactPoint], scale: f64) -> f64 {
    let points: Vec<_> = outline
        .iter()
        .map(|[x, y]| scale * DVec2::new(x.to_f64(), y.to_f64()))
        .collect();
    let to_edge = |i: usize| {
        let (from, to) = (points[i], points[(i + 1) % points.len()]);
        let along = to - from;
        let share = (-from.dot(along) / along.length_squared()).clamp(0.0, 1.0);
        (from + share * along).length()
    };
    (0..points.len()).map(to_edge).fold(f64::INFINITY, f64::min)
}

/// How often each kind of decision was held against exact arithmetic.
#[derive(Debug, Default)]
struct Tally {
    by_point: usize,
    by_ray: usize,
}

/// Holds one containment test against exact arithmetic. `line`: the share of |o| + t|Δ| within which
/// the line may run beside the exact one.
#[track_caller]
fn check(polygon: &Polygon, ray: &Ray, line: f64, tally: &mut Tally) {
    let plane_test = polygon.plane_test(ray, TRange::FORWARD, Sides::Both);
    let PlaneVerdict::Meets(root) = plane_test.verdict else {
        return;
    };
    let test = polygon.contains(ray, root.t);
    let vertices: Vec<_> = polygon.vertices().collect();
    let context = || format!("{ray:?}\n{test:?}\n{vertices:?}");
    assert_eq!(test.inside, test.crossings % 2 == 1, "{}", context());
    check_edges(polygon, ray, test);

    let place = |is_inside| {
        if is_inside {
            Place::Inside
        } else {
            Place::Outside
        }
    };
    if test.decided_by == DecidedBy::Point {
        let outline: Vec<_> = polygon.outline().iter().map(|&p| exact_point(p)).collect();
        let exact = even_odd(&outline, &exact_point(test.projected));
        assert_eq!(
            place(test.inside),
            exact,
            "p' in the outline\n{}",
            context()
        );
        tally.by_point += 1;
    }

    let (outline, scale) = seen_along(ray, &vertices);
    let zero = [0.0, 0.0].map(Exact::from);
    let reach = ray.origin.length() + root.t.abs() * ray.direction.length();
    if line == 0.0 || line * reach < distance_from_zero(&outline, scale) {
        let exact = even_odd(&outline, &zero);
        if exact != Place::OnEdge {
            assert_eq!(
                place(test.inside),
                exact,
                "seen along the ray\n{}",
                context()
            );
            tally.by_ray += usize::from(test.decided_by == DecidedBy::Ray);
        }
    }
}

/// The working, edge by edge, must add up to the result.
#[track_caller]
fn check_edges(polygon: &Polygon, ray: &Ray, test: PolygonTest) {
    let edges: Vec<_> = polygon.edges(ray, test).collect();
    let outline = polygon.outline();
    let context = || format!("{ray:?}\n{test:?}\n{edges:?}");
    assert_eq!(edges.len(), outline.len(), "number of edges\n{}", context());
    let counted = edges.iter().filter(|edge| edge.counts).count();
    assert_eq!(counted, test.crossings as usize, "crossings\n{}", context());
    for (i, edge) in edges.iter().enumerate() {
        assert_eq!(edge.index as usize, i, "{}", context());
        assert_eq!(
            (edge.from, edge.to),
            (outline[i], outline[(i + 1) % outline.len()]),
            "{}",
            context()
        );
        assert_eq!(edge.decided_by, test.decided_by, "{}", context());
        assert!(edge.straddles || !edge.counts, "{}", context());
    }
}

/// Vertices at rising angles: concave where the radius jumps.
fn star(random: &mut Seeded, count: usize, shortest: f64) -> Vec<DVec2> {
    let step = std::f64::consts::TAU / count as f64;
    let start = random.within(0.0, std::f64::consts::TAU);
    let at = |i| {
        let angle = start + step * (i as f64 + 0.9 * random.unit());
        random.within(shortest, 1.0) * DVec2::from_angle(angle)
    };
    (0..count).map(at).collect()
}

/// A comb: teeth up from y = 0, gaps of any width between them, and many vertices at equal height.
fn comb(random: &mut Seeded, teeth: usize) -> Vec<DVec2> {
    let mut outline = vec![DVec2::new(1.0, -0.5), DVec2::new(-1.0, -0.5)];
    let step = 2.0 / teeth as f64;
    for tooth in 0..teeth {
        let left = -1.0 + step * tooth as f64;
        let right = left + step * random.within(0.1, 0.9);
        let (top, gap) = (0.5, right + 0.01 * step);
        outline.extend([(left, top), (right, top), (right, 0.0), (gap, 0.0)].map(DVec2::from));
    }
    outline
}

/// A thin quadrangle.
fn sliver(random: &mut Seeded) -> Vec<DVec2> {
    let along = DVec2::from_angle(random.within(0.0, std::f64::consts::TAU));
    let thin = random.power(-9.0, -2.0) * along.perp();
    vec![-along, 0.3 * along - thin, along, thin - 0.2 * along]
}

/// The planes: one for each dropped axis, and any other.
fn frame(random: &mut Seeded, which: usize) -> (DMat3, Option<Axis>) {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    match which {
        0 => (DMat3::from_cols(y, z, x), Some(Axis::X)),
        1 => (DMat3::from_cols(z, x, y), Some(Axis::Y)),
        2 => (DMat3::from_cols(x, y, z), Some(Axis::Z)),
        _ => {
            let normal = random.direction();
            let u = random.across(normal);
            (DMat3::from_cols(u, normal.cross(u), normal), None)
        }
    }
}

/// A point to aim at: anywhere, near a vertex or an edge, or level with a vertex.
fn target(random: &mut Seeded, outline: &[DVec2]) -> DVec2 {
    let i = random.index(outline.len());
    let (from, to) = (outline[i], outline[(i + 1) % outline.len()]);
    let anywhere = DVec2::new(random.within(-1.1, 1.1), random.within(-1.1, 1.1));
    let beside = random.power(-16.0, 0.0) * DVec2::from_angle(random.within(0.0, 7.0));
    match random.index(6) {
        0 => anywhere,
        1 => from + beside,
        2 => from + random.unit() * (to - from) + beside,
        3 => DVec2::new(anywhere.x, from.y),
        4 => DVec2::new(from.x, anywhere.y),
        // inside the narrowest part
        _ => from + random.unit() * (outline[(i + 2) % outline.len()] - from),
    }
}

/// Rays at a polygon of this outline, in four planes, with the outline's first vertex or its middle at
/// `at` sizes from the world's origin.
#[track_caller]
fn check_outlines(seed: u64, size: f64, at: f64, make: impl Fn(&mut Seeded) -> Vec<DVec2>) {
    let mut random = Seeded::new(seed);
    let mut tally = Tally::default();
    for i in 0..8 {
        let outline = make(&mut random);
        let (frame, axis) = frame(&mut random, i % 4);
        let center = random.point(at * size);
        let in_space = |p: DVec2| center + size * (frame * p.extend(0.0));
        let vertices: Vec<_> = outline.iter().map(|&p| in_space(p)).collect();
        let polygon = Polygon::new(vertices, None).unwrap();
        if let Some(axis) = axis {
            assert_eq!(polygon.dropped(), axis);
        }
        for _ in 0..RAYS {
            let goal = in_space(target(&mut random, &outline));
            // from straight ahead to nearly along the plane, from far and from near
            let away = random.direction() * DVec3::new(1.0, 1.0, random.power(-2.0, 0.0));
            let origin = goal + size * random.power(-1.0, 2.0) * (frame * away);
            let ray = Ray::through(origin, goal);
            let unit = ray.normalised().unwrap().0;
            check(
                &polygon,
                if random.sign() < 0.0 { &ray } else { &unit },
                LINE,
                &mut tally,
            );
        }
    }
    assert!(
        100 <= tally.by_point,
        "too few decided by the point: {tally:?}"
    );
}

#[test]
fn a_diamond_has_the_containment_of_the_hand() {
    // |x| + |y| ≤ 1 at z = 5: (0.5, 0.25) lies inside, (0.75, 0.5) outside
    let corners = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
    let diamond = Polygon::new(corners.map(|(x, y)| DVec3::new(x, y, 5.0)).to_vec(), None).unwrap();
    let mut tally = Tally::default();
    for (x, y, inside) in [(0.5, 0.25, true), (0.75, 0.5, false), (-0.5, 0.0, true)] {
        let ray = Ray::new(DVec3::new(x, y, 0.0), DVec3::Z);
        assert_eq!(diamond.contains(&ray, 5.0).inside, inside, "({x}, {y})");
        check(&diamond, &ray, 0.0, &mut tally);
    }
    assert_eq!(tally.by_point, 3);
}

#[test]
fn convex_outlines_contain_what_the_exact_ones_do() {
    // all radii alike: the vertices lie on a circle
    for (seed, count) in [(11, 3), (12, 4), (13, 7), (14, 100)] {
        check_outlines(seed, 1.0, 3.0, |random| star(random, count, 1.0));
    }
}

#[test]
fn concave_outlines_contain_what_the_exact_ones_do() {
    for (seed, count) in [(21, 4), (22, 5), (23, 12), (24, 60)] {
        check_outlines(seed, 1.0, 3.0, |random| star(random, count, 0.1));
    }
    check_outlines(25, 1.0, 3.0, |random| comb(random, 3));
    check_outlines(26, 1.0, 0.0, |random| comb(random, 20));
}

#[test]
fn slivers_contain_what_the_exact_ones_do() {
    check_outlines(31, 1.0, 0.0, sliver);
    check_outlines(32, 1.0, 3.0, sliver);
    check_outlines(33, 1e6, 1.0, sliver);
}

#[test]
fn huge_and_small_outlines_contain_what_the_exact_ones_do() {
    for (seed, size, at) in [
        (41, 1e9, 1.0),
        (42, 1e9, 0.0),
        (43, 1e-6, 1.0),
        (44, 1e-6, 1e4),
    ] {
        check_outlines(seed, size, at, |random| star(random, 9, 0.2));
    }
}

#[test]
fn huge_outlines_are_exact_beside_a_vertex_that_lies_close_to_the_ray() {
    // The outline's numbers are up to 10⁹ times those of the ray, and so is their rounding: p′ may be
    // clear of an edge by its own error and not by the edge's.
    let mut random = Seeded::new(45);
    let mut tally = Tally::default();
    for i in 0..40 {
        let outline = star(&mut random, 5, 0.2);
        let (frame, _) = frame(&mut random, i % 4);
        let size = random.power(3.0, 9.0);
        let vertices: Vec<_> = outline
            .iter()
            .map(|&p| size * (frame * (p - outline[0]).extend(0.0)))
            .collect();
        let polygon = Polygon::new(vertices, None).unwrap();
        for _ in 0..RAYS {
            let beside = random.power(-15.0, 0.0) * DVec2::from_angle(random.within(0.0, 7.0));
            let goal = frame * beside.extend(0.0);
            let ray = Ray::through(goal + random.power(-3.0, 1.0) * random.direction(), goal);
            check(&polygon, &ray, LINE, &mut tally);
        }
    }
    assert!(100 <= tally.by_point, "{tally:?}");
}

#[test]
fn the_ray_decides_exactly_where_its_numbers_are_exact() {
    // Coordinates are multiples of 2⁻⁴⁷ below 16, and |Δ| is larger than |o|: the second point of
    // the line, o + Δ, is not rounded, and the line is the exact one. Rays pass the edges at 2⁻⁴⁷
    // and more, where p′ cannot decide.
    let grid = 2f64.powi(-47);
    let snap = |p: DVec3| (p / grid).round() * grid;
    let mut random = Seeded::new(51);
    let mut tally = Tally::default();
    for i in 0..200 {
        let outline = star(&mut random, 3 + i % 5, 0.3);
        let (frame, _) = frame(&mut random, i % 4);
        // rounded to the grid, and so off their plane by about as much
        let vertices: Vec<_> = outline
            .iter()
            .map(|&p| snap(frame * p.extend(0.0)))
            .collect();
        let polygon = Polygon::new(vertices.clone(), None).unwrap();
        for _ in 0..RAYS / 3 {
            let corner = random.index(vertices.len());
            let (from, to) = (vertices[corner], vertices[(corner + 1) % vertices.len()]);
            let share = if random.sign() < 0.0 {
                0.0
            } else {
                random.unit()
            };
            let beside = grid * random.point(3.0);
            let goal = snap(from + share * (to - from) + beside);
            let origin = snap(frame * (random.direction() + 1.5 * DVec3::Z));
            let ray = Ray::new(origin, 4.0 * (goal - origin));
            if ray.origin.abs().max_element() <= ray.direction.abs().max_element() {
                check(&polygon, &ray, 0.0, &mut tally);
            }
        }
    }
    assert!(
        10_000 <= tally.by_ray,
        "too few decided by the ray: {tally:?}"
    );
}

#[test]
fn a_plane_of_a_polygon_is_that_of_its_frame() {
    let mut random = Seeded::new(61);
    for i in 0..100 {
        let (frame, _) = frame(&mut random, i % 4);
        let vertices = star(&mut random, 8, 0.2)
            .iter()
            .map(|p| frame * p.extend(2.0))
            .collect::<Vec<_>>();
        let Plane { normal, d } = Polygon::new(vertices, None).unwrap().plane();
        // the frame's own rounding and that of the area, which a star of thin arms makes small
        assert!(
            (normal - frame.z_axis).length() <= 1e-14,
            "{normal} {}",
            frame.z_axis
        );
        assert!((d + 2.0).abs() <= 1e-14, "{d}");
    }
}
