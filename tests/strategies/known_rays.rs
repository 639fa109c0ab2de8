//! Rays about which strategies have disagreed.

#![expect(
    clippy::unreadable_literal,
    reason = "the numbers of a known ray are as they were printed"
)]

use glam::DVec3;
use raystep::Scene;
use raystep::geometry::{AxisBox, Cone, Ellipsoid, Polygon, Ray, Sides, Sphere, TRange};
use raystep::scene::Shape;
use raystep::strategy::Hit;

use super::hard_rays::{Found, Queries, Query, scene};
use super::{asked, both_drivers};

fn polygon(vertices: &[[f64; 3]]) -> Shape {
    let vertices = vertices.iter().map(|&vertex| vertex.into()).collect();
    Shape::Polygon(Polygon::new(vertices, None).unwrap())
}

/// All strategies on one ray.
fn all_of(scene: &Scene, query: Query) -> Vec<(String, Found)> {
    let names = [String::from("exhaustive")]
        .into_iter()
        .chain(both_drivers());
    let found = |name: String| {
        let found = asked(&name, scene, &Queries(&[query]))[0];
        (name, found)
    };
    names.map(found).collect()
}

/// What all strategies say of a ray.
#[track_caller]
fn agreed(scene: &Scene, query: Query) -> Option<Hit> {
    let all = all_of(scene, query);
    let (_, expected) = all[0];
    for (name, found) in all {
        assert_eq!(found, expected, "{name}");
    }
    expected.nearest
}

#[test]
fn a_ray_in_the_plane_of_a_polygon_does_not_hit_it_beside_its_outline() {
    // it starts on the edge from (−1, 0.5) to (0.5, 2) in y and z, and leaves the polygon there; it was hit at
    // t = 0.001095, 0.001 outside, by the exhaustive search and the grid, and not by a hierarchy of own slabs
    let scene = scene(vec![(
        polygon(&[
            [3.0, 3.0, 2.5],
            [3.0, 1.5, 1.0000000000007696],
            [3.000000000000811, -0.999999999999015, 0.5000000000007696],
            [3.000000000000811, 0.500000000000985, 2.0],
        ]),
        Sides::Both,
    )]);
    let origin = DVec3::new(3.000000000000811, -0.249999999999015, 1.2500000000003848);
    let range = TRange {
        min: 3.000000000000811e-9,
        ..TRange::FORWARD
    };
    assert_eq!(agreed(&scene, (Ray::new(origin, DVec3::Z), range)), None);
}

#[test]
fn a_ray_that_starts_beside_a_polygon_in_its_plane_does_not_hit_it_there() {
    // the start is 0.0035 before the edge from the first to the third vertex, in the plane but for 3e−23: the
    // triangles were hit at t = 9.7e−17 or not, by chance
    let corners = [
        [
            1.2280808225911913e-6,
            0.09327864303695813,
            -0.09413569667787339,
        ],
        [
            -7.178589195119432e-7,
            1.7644859104271413,
            -0.09413724177256749,
        ],
        [8.286622318374569, 0.08974265752981755, -0.0937175934215224],
    ];
    let egg = Shape::Ellipsoid(Ellipsoid {
        center: DVec3::new(
            0.005055798428325159,
            -127.23236056431918,
            -0.07110156654344253,
        ),
        radii: DVec3::new(
            49.15292964827846,
            0.00044914434679746337,
            2.2882594347144267,
        ),
    });
    let ball = Shape::Sphere(Sphere {
        center: DVec3::new(
            156.03154523029053,
            -3.276716804666732e-05,
            0.00897057463714749,
        ),
        radius: 7.223181768670786,
    });
    let brick = Shape::Box(AxisBox {
        min: DVec3::new(
            -0.00011639440524003056,
            -0.004164029591696996,
            -1.0362924694855786e-06,
        ),
        max: DVec3::new(
            -0.00010438342477184441,
            11.878719248009213,
            0.0394890054902482,
        ),
    });
    let scene = scene(vec![
        (ball, Sides::Both),
        (egg, Sides::Front),
        (brick, Sides::Both),
        (polygon(&corners), Sides::Both),
        (polygon(&corners), Sides::Back),
    ]);
    let ray = Ray::new(
        DVec3::new(
            1.2321980940944477e-6,
            0.0897426575298026,
            -0.09413569340872027,
        ),
        DVec3::new(
            1.1643916227936423e-6,
            -0.9999999999988947,
            9.245380416018179e-7,
        ),
    );
    let hit = agreed(&scene, (ray, TRange::FORWARD)).unwrap();
    assert_eq!(hit.object.0, 1);
    // the ellipsoid is 0.0009 flat across y: t = 0.0897 + 127.2324 − 0.0004
    assert!((hit.t - 127.3217).abs() <= 1e-4, "{hit:?}");
}

#[test]
fn a_face_seen_edge_on_is_hit_inside_its_outline_or_not_at_all() {
    // the face was hit at t = 5.29, where it is not; seven slabs, which follow it more closely than a box, said so
    let face = [
        [5.747611835371914, 52193.49062238902, 7695.712519345921],
        [4.247611835371602, 52193.99062238902, 7701.212519345921],
        [-0.2523881646283983, 52195.49062238902, 7698.7125193459215],
    ];
    let base = DVec3::new(2.2476118353716017, 52193.99062238902, 7699.712519345921);
    let apex = DVec3::new(1.2476118353716017, 52195.99062238902, 7701.2125193459215);
    let cone = Cone::new(base, 1.0, apex, 1.0).unwrap();
    let scene = scene(vec![
        (Shape::Cone(cone), Sides::Both),
        (polygon(&face), Sides::Both),
    ]);
    let ray = Ray::new(
        DVec3::new(5.747611835371914, 52193.49062238902, 7705.525017057976),
        DVec3::new(-0.549534578817114, 0.18317819293902274, -0.815142623297231),
    );
    let hit = agreed(&scene, (ray, TRange::FORWARD)).unwrap();
    // in fractions the ray misses the face, which it would meet at t = 6.82; the cone is behind 5.29
    assert_eq!(hit.object.0, 0);
    assert!((hit.t - 5.6739).abs() <= 1e-4, "{hit:?}");
}

#[test]
fn a_cylinder_far_from_the_world_s_origin_is_in_every_cell_that_its_rays_cross() {
    // of the rays that meet it, one in forty found nothing in a fine grid: the cell of the hit did not list it
    let at = |y: f64, z: f64| DVec3::new(82665.61485505357, y, z);
    let [base, apex] = [
        at(110387.4790393872, 905.276324198096),
        at(110387.4790393872, 906.276324198096),
    ];
    let cylinder = Cone::new(base, 1.0, apex, 1.0).unwrap();
    let scene = scene(vec![(Shape::Cone(cylinder), Sides::Both)]);
    let ray = Ray::new(
        DVec3::new(82666.76225116101, 110378.38675850315, 907.2127008228366),
        DVec3::new(-0.1994067669762666, 0.9684393206801997, -0.1495400396032659),
    );
    let hit = agreed(&scene, (ray, TRange::FORWARD)).unwrap();
    // from (1.147396, −9.092281) beside the axis along (−0.199407, 0.968439): a = 0.977638, b = −18.068242,
    // c = 82.986090, so that t = (18.068242 − √(326.461360 − 324.521344))/1.955276
    assert!((hit.t - 8.528412).abs() <= 1e-5, "{hit:?}");
    // and with a range that ends there
    assert!(agreed(&scene, (ray, TRange::FORWARD.up_to(hit.t))).is_some());
}
