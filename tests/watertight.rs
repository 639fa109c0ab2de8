//! Closed meshes do not leak: a ray from inside meets a face, wherever it is aimed.
//!
//! Rays between two faces are where meshes leak, so most of what is shot here is aimed at vertices
//! and at points on edges, as nearly as f64 can say it, normalised and not.

use std::collections::BTreeMap;

use glam::DVec3;
use raystep::geometry::{Polygon, Ray, Sides, TRange};

use crate::seeded::Seeded;

/// A closed mesh: faces by the indices of their vertices, counter-clockwise from outside.
struct Mesh {
    name: &'static str,
    vertices: Vec<DVec3>,
    faces: Vec<Face>,
    edges: Vec<[usize; 2]>,
    is_convex: bool,
}

struct Face {
    polygon: Polygon,
    /// A sphere around the face: only rays that come near it are tested.
    middle: DVec3,
    reach: f64,
}

/// The spheres around faces are this much larger than their faces: rounding is far smaller.
const ROOM: f64 = 1.001;

impl Mesh {
    /// The solid, turned and moved so that no coordinate is a round number.
    fn new(name: &'static str, vertices: &[DVec3], faces: &[Vec<usize>], is_convex: bool) -> Self {
        let turn = glam::DQuat::from_axis_angle(DVec3::new(0.36, 0.48, 0.8), 0.7);
        let vertices: Vec<_> = vertices
            .iter()
            .map(|&v| turn * v + DVec3::new(3.1, -1.7, 0.3))
            .collect();
        Self::as_given(name, vertices, faces, is_convex)
    }

    fn as_given(
        name: &'static str,
        vertices: Vec<DVec3>,
        faces: &[Vec<usize>],
        is_convex: bool,
    ) -> Self {
        // closed: every edge is run through once in either direction
        let mut runs: BTreeMap<[usize; 2], i32> = BTreeMap::new();
        for face in faces {
            for (i, &from) in face.iter().enumerate() {
                let to = face[(i + 1) % face.len()];
                let run = runs.entry([from.min(to), from.max(to)]).or_default();
                *run += if from < to { 1 } else { 1000 };
            }
        }
        assert!(
            runs.values().all(|&run| run == 1001),
            "{name} is not closed"
        );
        let face = |indices: &Vec<usize>| {
            let corners: Vec<_> = indices.iter().map(|&i| vertices[i]).collect();
            let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
            let reach = ROOM
                * corners
                    .iter()
                    .map(|c| (c - middle).length())
                    .fold(0.0, f64::max);
            Face {
                polygon: Polygon::new(corners, None).unwrap(),
                middle,
                reach,
            }
        };
        Self {
            name,
            faces: faces.iter().map(face).collect(),
            edges: runs.into_keys().collect(),
            vertices,
            is_convex,
        }
    }

    /// How many faces a ray meets in front of its origin.
    fn hits(&self, ray: &Ray) -> usize {
        let length2 = ray.direction.length_squared();
        let comes_near = |face: &Face| {
            let passing = (face.middle - ray.origin)
                .cross(ray.direction)
                .length_squared();
            passing <= face.reach * face.reach * length2
        };
        let is_hit = |face: &&Face| {
            let plane_test = face.polygon.plane_test(ray, TRange::FORWARD, Sides::Both);
            plane_test
                .chosen()
                .is_some_and(|t| face.polygon.contains(ray, t).inside)
        };
        self.faces
            .iter()
            .filter(|face| comes_near(face))
            .filter(is_hit)
            .count()
    }
}

fn tetrahedron() -> Mesh {
    let vertices = [
        (0.0, 0.0, 0.0),
        (2.0, 0.1, 0.0),
        (0.3, 1.7, 0.2),
        (0.4, 0.5, 1.9),
    ]
    .map(DVec3::from);
    let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(Vec::from);
    Mesh::new("tetrahedron", &vertices, &faces, true)
}

/// The vertices of a unit cube: vertex 4x + 2y + z.
fn cube_corners() -> Vec<DVec3> {
    let bit = |i: usize, place: usize| (i >> place & 1) as f64;
    (0..8)
        .map(|i| DVec3::new(bit(i, 2), bit(i, 1), bit(i, 0)))
        .collect()
}

const CUBE: [[usize; 4]; 6] = [
    [0, 1, 3, 2],
    [4, 6, 7, 5],
    [0, 4, 5, 1],
    [2, 3, 7, 6],
    [0, 2, 6, 4],
    [1, 5, 7, 3],
];

fn turned_cube() -> Mesh {
    Mesh::new("turned cube", &cube_corners(), &CUBE.map(Vec::from), true)
}

/// Rays along the axes run along faces, and those at vertices are exact ties.
fn straight_cube() -> Mesh {
    Mesh::as_given("straight cube", cube_corners(), &CUBE.map(Vec::from), true)
}

/// An L of three unit squares, 1 high: its floor and its ceiling are concave hexagons.
fn l_shape(turned: bool) -> Mesh {
    let outline = [
        (0.0, 0.0),
        (2.0, 0.0),
        (2.0, 1.0),
        (1.0, 1.0),
        (1.0, 2.0),
        (0.0, 2.0),
    ];
    let at = |z: f64| outline.map(|(x, y)| DVec3::new(x, y, z));
    let vertices = [at(0.0), at(1.0)].concat();
    let mut faces: Vec<Vec<usize>> = vec![(0..6).rev().collect(), (6..12).collect()];
    faces.extend(
        (0..6)
            .map(|i| (i, (i + 1) % 6))
            .map(|(i, j)| vec![i, j, j + 6, i + 6]),
    );
    if turned {
        Mesh::new("turned L", &vertices, &faces, false)
    } else {
        Mesh::as_given("straight L", vertices, &faces, false)
    }
}

/// Twenty triangles, each cut in four as often as asked, with all vertices on the unit sphere.
fn icosphere(cuts: usize) -> Mesh {
    let golden = f64::midpoint(1.0, 5f64.sqrt());
    let mut vertices = Vec::new();
    for (one, two) in [
        (1.0, golden),
        (1.0, -golden),
        (-1.0, golden),
        (-1.0, -golden),
    ] {
        for corner in [(0.0, one, two), (one, two, 0.0), (two, 0.0, one)] {
            vertices.push(DVec3::from(corner).normalize());
        }
    }
    // a face is three vertices at the distance of an edge from each other
    let edge = 2.0 / (golden * golden + 1.0).sqrt();
    let is_edge = |i: usize, j: usize| ((vertices[i] - vertices[j]).length() - edge).abs() < 0.1;
    let mut faces = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                if is_edge(i, j) && is_edge(j, k) && is_edge(i, k) {
                    let outwards = vertices[i].cross(vertices[j]).dot(vertices[k]) > 0.0;
                    faces.push(if outwards {
                        vec![i, j, k]
                    } else {
                        vec![i, k, j]
                    });
                }
            }
        }
    }
    for _ in 0..cuts {
        let mut middles = BTreeMap::new();
        let mut middle = |i: usize, j: usize| {
            *middles.entry([i.min(j), i.max(j)]).or_insert_with(|| {
                vertices.push((vertices[i] + vertices[j]).normalize());
                vertices.len() - 1
            })
        };
        let mut cut = Vec::new();
        for face in &faces {
            let [i, j, k] = [face[0], face[1], face[2]];
            let (a, b, c) = (middle(i, j), middle(j, k), middle(k, i));
            cut.extend([vec![i, a, c], vec![a, j, b], vec![c, b, k], vec![a, b, c]]);
        }
        faces = cut;
    }
    Mesh::new("icosphere", &vertices, &faces, true)
}

/// Where a ray is aimed.
#[derive(Clone, Copy)]
enum Aim {
    Anywhere,
    Vertices,
    Edges,
}

/// Shoots `rays` rays from points inside, half of them normalised. `inside` makes the points, as
/// combinations of vertices.
#[track_caller]
fn check(
    seed: u64,
    mesh: &Mesh,
    rays: usize,
    aim: Aim,
    inside: impl Fn(&mut Seeded, &Mesh) -> DVec3,
) {
    let mut random = Seeded::new(seed);
    for i in 0..rays {
        let origin = inside(&mut random, mesh);
        let direction = match aim {
            Aim::Anywhere => random.direction(),
            Aim::Vertices => mesh.vertices[random.index(mesh.vertices.len())] - origin,
            Aim::Edges => {
                let [from, to] =
                    mesh.edges[random.index(mesh.edges.len())].map(|end| mesh.vertices[end]);
                from + random.unit() * (to - from) - origin
            }
        };
        let direction = if i % 2 == 0 {
            direction.normalize()
        } else {
            direction
        };
        let ray = Ray::new(origin, direction);
        let hits = mesh.hits(&ray);
        assert!(0 < hits, "{ray:?} leaves the {}", mesh.name);
        // out once more than in again; a convex solid is not entered again
        let is_right = if mesh.is_convex {
            hits == 1
        } else {
            hits % 2 == 1
        };
        assert!(is_right, "{ray:?} meets {hits} faces of the {}", mesh.name);
    }
}

/// A fifth of the rays anywhere and two fifths each at vertices and edges.
#[track_caller]
fn check_all(seed: u64, mesh: &Mesh, rays: usize, inside: impl Fn(&mut Seeded, &Mesh) -> DVec3) {
    check(seed, mesh, rays / 5, Aim::Anywhere, &inside);
    check(seed + 1, mesh, 2 * rays / 5, Aim::Vertices, &inside);
    check(seed + 2, mesh, 2 * rays / 5, Aim::Edges, &inside);
}

/// Any mean of all vertices: inside, if the solid is convex.
fn mean(random: &mut Seeded, mesh: &Mesh) -> DVec3 {
    let (mut sum, mut total) = (DVec3::ZERO, 0.0);
    for &vertex in &mesh.vertices {
        let weight = random.within(0.01, 1.0);
        sum += weight * vertex;
        total += weight;
    }
    sum / total
}

/// On the way from the middle towards any point of a mesh of many vertices, up to 9/10 of the way.
fn towards(random: &mut Seeded, mesh: &Mesh) -> DVec3 {
    let middle = DVec3::new(3.1, -1.7, 0.3);
    let vertex = mesh.vertices[random.index(mesh.vertices.len())];
    middle + 0.9 * random.unit() * (vertex - middle)
}

/// In one of the three cubes of the L: between its six corners at the L's inner edge and beyond.
fn in_the_l(random: &mut Seeded, mesh: &Mesh) -> DVec3 {
    let [corner, x, y] = [mesh.vertices[0], mesh.vertices[1], mesh.vertices[5]];
    let (u, v, w) = (
        0.5 * (x - corner),
        0.5 * (y - corner),
        mesh.vertices[6] - corner,
    );
    let place = DVec3::from_array([0; 3].map(|_| random.within(0.01, 0.99)));
    let (x, y) = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)][random.index(3)];
    corner + (place.x + x) * u + (place.y + y) * v + place.z * w
}

#[test]
fn the_middle_of_a_cube_sees_one_face_through_each_of_its_corners() {
    let cube = straight_cube();
    let middle = DVec3::splat(0.5);
    for corner in &cube.vertices {
        assert_eq!(cube.hits(&Ray::through(middle, *corner)), 1, "{corner}");
    }
    for &[from, to] in &cube.edges {
        let on_edge = 0.5 * (cube.vertices[from] + cube.vertices[to]);
        assert_eq!(cube.hits(&Ray::through(middle, on_edge)), 1, "{on_edge}");
    }
}

#[test]
fn no_ray_leaves_a_tetrahedron() {
    check_all(10, &tetrahedron(), 250_000, mean);
}

#[test]
fn no_ray_leaves_a_cube() {
    check_all(20, &turned_cube(), 200_000, mean);
    check_all(30, &straight_cube(), 150_000, mean);
    // whole eighths: every difference and every plane is exact, and ties are ties
    let eighth = |random: &mut Seeded, _: &Mesh| {
        DVec3::from_array([0; 3].map(|_| (1 + random.index(7)) as f64 / 8.0))
    };
    check_all(40, &straight_cube(), 50_000, eighth);
}

#[test]
fn no_ray_leaves_an_l_with_concave_faces() {
    check_all(50, &l_shape(true), 150_000, in_the_l);
    check_all(60, &l_shape(false), 100_000, in_the_l);
    // in the planes of the two faces at the inner edge, which rays then run along
    let in_plane = |random: &mut Seeded, _: &Mesh| {
        let (across, up) = (random.within(0.01, 0.99), random.within(0.01, 0.99));
        if random.sign() < 0.0 {
            DVec3::new(1.0, across, up)
        } else {
            DVec3::new(across, 1.0, up)
        }
    };
    check_all(70, &l_shape(false), 50_000, in_plane);
}

#[test]
fn no_ray_leaves_an_icosphere() {
    let mesh = icosphere(3);
    assert_eq!(mesh.faces.len(), 1280);
    check_all(80, &mesh, 100_000, towards);
}
