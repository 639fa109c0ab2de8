//! Who races: raystep's strategies, and the peers with textbook tests in their leaves.

use std::cell::Cell;
use std::time::Instant;

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::Bvh;
use glam::DVec3;
use nalgebra::{Point3, Vector3};
use parry3d_f64::bounding_volume::Aabb as ParryBox;
use parry3d_f64::math::Vector;
use parry3d_f64::partitioning::{Bvh as ParryBvh, BvhBuildStrategy};
use parry3d_f64::query::{Ray as ParryRay, RayCast};
use parry3d_f64::shape::TriMesh;
use raystep::geometry::{Ray, TRange};
use raystep::strategy::Strategy;
use raystep::structure::{Build, GridOptions, SlabChoice};
use raystep::{Chosen, Counts, Off, Scene, StrategyName, StructureOptions};

use crate::scenes::Objects;

/// What is done with many rays.
type OverRays<'a, T> = Box<dyn Fn(&[Ray]) -> T + 'a>;

/// One of those that race.
pub(crate) struct Contender<'a> {
    pub(crate) name: &'static str,
    /// How long the structure took to build, in seconds, in the median of some times.
    pub(crate) build: f64,
    /// With how many objects it is still worth waiting for.
    pub(crate) most: usize,
    /// Finds the nearest hit of each ray.
    pub(crate) nearest: OverRays<'a, Found>,
    /// Does so too, and counts the tests of objects.
    pub(crate) tests: OverRays<'a, u64>,
}

/// What a round found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Found {
    /// How many rays hit anything.
    pub(crate) hits: usize,
    /// The sum of their t, so that no t is left uncomputed.
    pub(crate) sum: f64,
}

/// The most objects for those who test every object or its volume: a mesh of ten thousand has a few more.
const LINEAR: usize = 20_000;
/// The most for the iterators of `bvh` that do not stop at the nearest hit: among a million objects they take
/// ten times as long as the others.
const UNORDERED: usize = 100_000;

impl Contender<'_> {
    /// Does the time of a ray grow with the number of objects?
    pub(crate) fn is_linear(&self) -> bool {
        self.most == LINEAR
    }
}

fn found(rays: &[Ray], nearest: impl Fn(&Ray) -> Option<f64>) -> Found {
    let mut found = Found::default();
    for t in rays.iter().filter_map(nearest) {
        found.hits += 1;
        found.sum += t;
    }
    found
}

/// How often something is built; once it has taken so many seconds, no more.
const BUILDS: usize = 5;
const LONG: f64 = 1.0;

/// What a closure gives, and how many seconds it takes: the median, for the first time finds cold caches and memory
/// that nobody has used.
fn timed<T>(mut build: impl FnMut() -> T) -> (T, f64) {
    let mut times = Vec::new();
    loop {
        let started = Instant::now();
        let built = build();
        times.push(started.elapsed().as_secs_f64());
        if times.len() == BUILDS || LONG < times.iter().sum() {
            times.sort_by(f64::total_cmp);
            return (built, times[times.len() / 2]);
        }
    }
}

/// All that race over a scene; raystep's hierarchy is the first.
pub(crate) fn contenders<'a>(objects: &'a Objects, scene: &'a Scene) -> Vec<Contender<'a>> {
    let few = scene.primitives.len() <= LINEAR;
    let mut all = of_raystep(scene);
    if few {
        all.extend(linear(scene));
    }
    all.extend(of_bvh(objects));
    all.push(of_parry(objects));
    all.retain(|contender| scene.primitives.len() <= contender.most);
    all
}

fn of_raystep(scene: &Scene) -> Vec<Contender<'_>> {
    let all = usize::MAX;
    let built = |build: Build| StructureOptions {
        build,
        ..StructureOptions::default()
    };
    let seven = StructureOptions {
        slabs: SlabChoice::Seven,
        ..built(Build::SurfaceArea)
    };
    let grid = |grid: GridOptions| StructureOptions {
        grid,
        ..StructureOptions::default()
    };
    let without = GridOptions {
        mailboxes: false,
        ..GridOptions::default()
    };
    // a sphere's test costs less than the steps through small cells
    let coarse = GridOptions {
        density: 1.0,
        ..GridOptions::default()
    };
    let areas = built(Build::SurfaceArea);
    use StrategyName::{Grid, Heap, Hierarchy};
    let ours = |name, strategy, options| ours(scene, name, all, strategy, options);
    vec![
        ours("hierarchy", Hierarchy, areas),
        ours("  seven slabs", Hierarchy, seven),
        ours("  bottom-up", Hierarchy, built(Build::BottomUp)),
        ours("  insertion", Hierarchy, built(Build::Insertion)),
        ours("  with a heap", Heap, areas),
        ours("grid", Grid, grid(GridOptions::default())),
        ours("  no mailboxes", Grid, grid(without)),
        ours("  a cell each", Grid, grid(coarse)),
    ]
}

/// Those whose time grows with the number of objects.
fn linear(scene: &Scene) -> Vec<Contender<'_>> {
    use StrategyName::{Bounds, Exhaustive, ZAligned};
    let usual = StructureOptions::default();
    let ours = |name, strategy| ours(scene, name, LINEAR, strategy, usual);
    vec![
        ours("exhaustive", Exhaustive),
        ours("boxes", Bounds),
        ours("z-aligned", ZAligned),
    ]
}

/// A strategy, whose fast driver runs without a recorder. What that needs is built with the structure.
fn ours<'a>(
    scene: &'a Scene,
    name: &'static str,
    most: usize,
    strategy: StrategyName,
    options: StructureOptions,
) -> Contender<'a> {
    let anywhere = Ray::new(DVec3::ZERO, DVec3::X);
    let (strategy, build) = timed(|| {
        let strategy = Chosen::new(scene, strategy, &options).expect("a structure");
        let _ = strategy.any(&anywhere, TRange::FORWARD, &mut Off);
        strategy
    });
    let strategy = std::rc::Rc::new(strategy);
    let counted = strategy.clone();
    Contender {
        name,
        build,
        most,
        nearest: Box::new(move |rays| {
            found(rays, |ray| {
                let hit = strategy.nearest(ray, TRange::FORWARD, &mut Off);
                hit.map(|hit| hit.t)
            })
        }),
        tests: Box::new(move |rays| {
            let mut counts = Counts::default();
            for ray in rays {
                let _ = counted.nearest(ray, TRange::FORWARD, &mut counts);
            }
            counts.objects_tested()
        }),
    }
}

/// A peer: `search(ray, tested)` finds the nearest hit and calls `tested` at each test of an object.
fn peer<'a>(
    name: &'static str,
    build: f64,
    most: usize,
    search: impl Search + 'a,
) -> Contender<'a> {
    let search = std::rc::Rc::new(search);
    let counted = search.clone();
    Contender {
        name,
        build,
        most,
        nearest: Box::new(move |rays| found(rays, |ray| search.nearest(ray, &|| {}))),
        tests: Box::new(move |rays| {
            let tests = Cell::new(0);
            for ray in rays {
                let _ = counted.nearest(ray, &|| tests.set(tests.get() + 1));
            }
            tests.get()
        }),
    }
}

/// A search that tells of each of its tests.
trait Search {
    fn nearest(&self, ray: &Ray, tested: &impl Fn()) -> Option<f64>;
}

/// An object of the crate `bvh`.
struct Shape {
    kind: Kind,
    node: usize,
}

#[derive(Clone, Copy)]
enum Kind {
    Sphere(DVec3, f64),
    Triangle([DVec3; 3]),
}

impl Kind {
    /// Textbook tests: all that a peer needs.
    #[inline]
    fn hit(&self, ray: &Ray, max: f64) -> Option<f64> {
        match self {
            Self::Sphere(center, radius) => sphere_hit(*center, *radius, ray, max),
            Self::Triangle(corners) => triangle_hit(corners, ray, max),
        }
    }
}

/// The smallest t above 0 of |o + t·Δ − c|² = r², for a unit ray.
#[inline]
fn sphere_hit(center: DVec3, radius: f64, ray: &Ray, max: f64) -> Option<f64> {
    let offset = ray.origin - center;
    let half_b = offset.dot(ray.direction);
    let c = offset.length_squared() - radius * radius;
    let quarter = half_b * half_b - c;
    if quarter < 0.0 {
        return None;
    }
    let root = quarter.sqrt();
    let near = -half_b - root;
    let t = if 0.0 < near { near } else { root - half_b };
    (0.0 < t && t <= max).then_some(t)
}

/// T. Möller and B. Trumbore 1997, both sides.
#[inline]
fn triangle_hit([a, b, c]: &[DVec3; 3], ray: &Ray, max: f64) -> Option<f64> {
    let (e1, e2) = (*b - *a, *c - *a);
    let p = ray.direction.cross(e2);
    let determinant = e1.dot(p);
    if determinant == 0.0 {
        return None;
    }
    let inverse = 1.0 / determinant;
    let s = ray.origin - *a;
    let u = s.dot(p) * inverse;
    if !(0.0..=1.0).contains(&u) {
        return None;
    }
    let q = s.cross(e1);
    let v = ray.direction.dot(q) * inverse;
    if v < 0.0 || 1.0 < u + v {
        return None;
    }
    let t = e2.dot(q) * inverse;
    (0.0 < t && t <= max).then_some(t)
}

impl Bounded<f64, 3> for Shape {
    fn aabb(&self) -> Aabb<f64, 3> {
        let (min, max) = match self.kind {
            Kind::Sphere(center, radius) => (center - radius, center + radius),
            Kind::Triangle([a, b, c]) => (a.min(b).min(c), a.max(b).max(c)),
        };
        let point = |p: DVec3| Point3::new(p.x, p.y, p.z);
        Aabb::with_bounds(point(min), point(max))
    }
}

impl BHShape<f64, 3> for Shape {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

/// A hierarchy of `bvh` and its objects.
struct OfBvh {
    tree: Bvh<f64, 3>,
    shapes: Vec<Shape>,
}

/// The iterators of `bvh`.
#[derive(Clone, Copy)]
enum Order {
    /// All leaves that the ray meets, in the order of the tree.
    Any,
    /// The nearest first: the search ends where the next box begins behind the nearest hit.
    Nearest,
    /// The nearer of two children first.
    NearerChild,
}

impl Search for (std::rc::Rc<OfBvh>, Order) {
    #[inline]
    fn nearest(&self, ray: &Ray, tested: &impl Fn()) -> Option<f64> {
        let (DVec3 { x, y, z }, delta) = (ray.origin, ray.direction);
        let query = bvh::ray::Ray::new(
            Point3::new(x, y, z),
            Vector3::new(delta.x, delta.y, delta.z),
        );
        let OfBvh { tree, shapes } = &*self.0;
        let mut best = f64::INFINITY;
        let test = |shape: &Shape, best: &mut f64| {
            tested();
            *best = shape.kind.hit(ray, *best).unwrap_or(*best);
        };
        match self.1 {
            Order::Any => {
                for shape in tree.traverse_iterator(&query, shapes) {
                    test(shape, &mut best);
                }
            }
            Order::Nearest => {
                for shape in tree.nearest_traverse_iterator(&query, shapes) {
                    let begins = query.intersection_slice_for_aabb(&shape.aabb());
                    if begins.is_some_and(|(near, _)| best < near) {
                        break;
                    }
                    test(shape, &mut best);
                }
            }
            Order::NearerChild => {
                for shape in tree.nearest_child_traverse_iterator(&query, shapes) {
                    test(shape, &mut best);
                }
            }
        }
        best.is_finite().then_some(best)
    }
}

fn of_bvh(objects: &Objects) -> Vec<Contender<'static>> {
    let kinds: Vec<Kind> = match objects {
        Objects::Spheres(spheres) => spheres.iter().map(|&(c, r)| Kind::Sphere(c, r)).collect(),
        Objects::Mesh(vertices, faces) => faces
            .iter()
            .map(|face| Kind::Triangle(face.map(|place| vertices[place as usize])))
            .collect(),
    };
    let shape = |kind| Shape { kind, node: 0 };
    let mut shapes: Vec<Shape> = kinds.into_iter().map(shape).collect();
    let (tree, build) = timed(|| Bvh::build(&mut shapes));
    let shared = std::rc::Rc::new(OfBvh { tree, shapes });
    [
        ("bvh", UNORDERED, Order::Any),
        ("  nearest first", usize::MAX, Order::Nearest),
        ("  nearer child", UNORDERED, Order::NearerChild),
    ]
    .map(|(name, most, order)| peer(name, build, most, (shared.clone(), order)))
    .into()
}

fn vector(v: DVec3) -> Vector {
    Vector::new(v.x, v.y, v.z)
}

fn parry_ray(ray: &Ray) -> ParryRay {
    ParryRay::new(vector(ray.origin), vector(ray.direction))
}

/// parry's hierarchy over spheres, which it has no shape for.
struct OfSpheres<'a> {
    tree: ParryBvh,
    spheres: &'a [(DVec3, f64)],
}

impl Search for OfSpheres<'_> {
    #[inline]
    fn nearest(&self, ray: &Ray, tested: &impl Fn()) -> Option<f64> {
        let test = |leaf: u32, max: f64| {
            tested();
            let (center, radius) = self.spheres[leaf as usize];
            sphere_hit(center, radius, ray, max)
        };
        let hit = self.tree.cast_ray(&parry_ray(ray), f64::INFINITY, test);
        hit.map(|(_, t)| t)
    }
}

/// parry's own search in a mesh, with its own test.
impl Search for TriMesh {
    #[inline]
    fn nearest(&self, ray: &Ray, tested: &impl Fn()) -> Option<f64> {
        let ray = parry_ray(ray);
        let test = |leaf: u32, max: f64| {
            tested();
            self.triangle(leaf).cast_local_ray(&ray, max, false)
        };
        let hit = self.bvh().cast_ray(&ray, f64::MAX, test);
        hit.map(|(_, t)| t)
    }
}

fn of_parry(objects: &Objects) -> Contender<'_> {
    let name = "parry3d";
    match objects {
        Objects::Spheres(spheres) => {
            let (tree, build) = timed(|| {
                let around = |&(c, r): &(DVec3, f64)| ParryBox::new(vector(c - r), vector(c + r));
                let boxes: Vec<_> = spheres.iter().map(around).collect();
                ParryBvh::from_leaves(BvhBuildStrategy::Binned, &boxes)
            });
            peer(name, build, usize::MAX, OfSpheres { tree, spheres })
        }
        Objects::Mesh(vertices, faces) => {
            let (mesh, build) = timed(|| {
                let vertices = vertices.iter().map(|&v| vector(v)).collect();
                TriMesh::new(vertices, faces.clone()).expect("a mesh")
            });
            peer(name, build, usize::MAX, mesh)
        }
    }
}
