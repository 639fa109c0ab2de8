//! Every strategy finds what the exhaustive one finds: the same object at the same t, bit for bit; and so does its fast
//! driver, which runs where nobody follows.
//!
//! Over a million rays through random scenes of all shapes. Half of the scenes stand on a lattice, as the
//! camera does, so that many rays run along axes, in faces and planes, through edges and corners, and start on
//! surfaces; and some objects stand twice, so that equal t occur. Each ray is the eye ray of a pixel: a failing
//! case is made as small as it goes and printed as a scene file with its pixel, ready for `raystep pixel`.
//!
//! The rays that are hardest to agree about, along planes, at the end of a range and at every scale, are in
//! `hard_rays`; those that once were answered differently are in `known_rays`. The z-aligned rays have their own
//! comparison, in `z_aligned`: they compute in another frame.

mod hard_rays;
mod known_rays;

use raystep::geometry::{Ray, TRange};
use raystep::scene::SceneFile;
use raystep::strategy::{
    BoundedObjects, DepthFirst, Exhaustive, HeapOrdered, Hit, Strategy, UniformGrid,
};
use raystep::structure::{Build, GridOptions, Lists, SlabChoice, SlabSet, VolumeKind};
use raystep::{Chosen, Off, Scene, StrategyName, StructureOptions};
use serde_json::{Value, json};

use crate::seeded::Seeded;

/// Pixels of each picture, to a side: odd, so that one is looked at along the middle.
const SIDE: u32 = 63;
/// With 63² rays each, more than a million in all.
const SCENES: u64 = 260;

/// Every strategy with every kind of structure, and what it is called.
const STRATEGIES: [&str; 15] = [
    "bounds: sphere",
    "bounds: ellipsoid",
    "bounds: box",
    "bounds: seven slabs",
    "hierarchy: bottom-up",
    "hierarchy: insertion",
    "hierarchy: surface-area",
    "hierarchy: seven slabs",
    "hierarchy: own slabs",
    "heap: bottom-up",
    "grid: mailboxes",
    "grid: no mailboxes",
    "grid: boxes",
    "grid: one cell",
    "grid: many cells",
];

/// What a strategy says of a ray: the nearest hit, and whether there is any up to just before it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Answer {
    object: Option<u32>,
    t: Option<u64>,
    any: bool,
    any_before: bool,
}

fn answer(strategy: &impl Strategy, ray: &Ray) -> Answer {
    let hit: Option<Hit> = strategy.nearest(ray, TRange::FORWARD, &mut Off);
    let before = hit.map_or(1.0, |hit| hit.t * (1.0 - 1e-3));
    Answer {
        object: hit.map(|hit| hit.object.0),
        t: hit.map(|hit| hit.t.to_bits()),
        any: strategy.any(ray, TRange::FORWARD, &mut Off).is_some(),
        any_before: strategy
            .any(ray, TRange::FORWARD.up_to(before), &mut Off)
            .is_some(),
    }
}

/// What is asked of each strategy in turn.
trait Question {
    type Answer;
    fn put(&self, strategy: &impl Strategy) -> Self::Answer;
}

/// The answers of one strategy to many rays.
struct Rays<'a>(&'a [Ray]);

impl Question for Rays<'_> {
    type Answer = Vec<Answer>;
    fn put(&self, strategy: &impl Strategy) -> Self::Answer {
        self.0.iter().map(|ray| answer(strategy, ray)).collect()
    }
}

fn answers(name: &str, scene: &Scene, rays: &[Ray]) -> Vec<Answer> {
    asked(name, scene, &Rays(rays))
}

/// The fast driver of a strategy is found under its name and this.
const FAST: &str = "fast ";

/// The names of all strategies, and of the fast drivers of all.
fn both_drivers() -> impl Iterator<Item = String> {
    let fast = STRATEGIES.into_iter().chain(["exhaustive"]);
    let fast = fast.map(|name| format!("{FAST}{name}"));
    STRATEGIES.into_iter().map(String::from).chain(fast)
}

/// What a strategy's fast driver says to a question: without a recorder, [`Chosen`] takes that.
fn asked_of_fast<Q: Question>(name: &str, scene: &Scene, question: &Q) -> Q::Answer {
    let mut options = StructureOptions::default();
    let (strategy, kind) = name.split_once(": ").unwrap_or((name, ""));
    let strategy = match strategy {
        "exhaustive" => StrategyName::Exhaustive,
        "bounds" => StrategyName::Bounds,
        "hierarchy" => StrategyName::Hierarchy,
        "heap" => StrategyName::Heap,
        "grid" => StrategyName::Grid,
        other => panic!("there is no strategy {other}"),
    };
    match kind {
        "" | "mailboxes" | "bottom-up" | "box" => {}
        "sphere" => options.volume = VolumeKind::Sphere,
        "ellipsoid" => options.volume = VolumeKind::Ellipsoid,
        "insertion" => options.build = Build::Insertion,
        "surface-area" => options.build = Build::SurfaceArea,
        "own slabs" => options.slabs = SlabChoice::Scene,
        "seven slabs" => {
            options.volume = VolumeKind::Slabs;
            options.slabs = SlabChoice::Seven;
            options.build = Build::SurfaceArea;
        }
        "no mailboxes" => options.grid.mailboxes = false,
        "boxes" => {
            options.grid.lists = Lists::Boxes;
            options.grid.density = 0.7;
        }
        "one cell" => options.grid.resolution = Some([1, 1, 1]),
        "many cells" => options.grid.density = 40.0,
        other => panic!("there is no kind {other}"),
    }
    question.put(&Chosen::new(scene, strategy, &options).unwrap())
}

/// What the strategy of a name says to a question.
fn asked<Q: Question>(name: &str, scene: &Scene, question: &Q) -> Q::Answer {
    if let Some(name) = name.strip_prefix(FAST) {
        return asked_of_fast(name, scene, question);
    }
    let (axes, seven) = (&SlabSet::AXES, &SlabSet::SEVEN);
    let grid = |options: GridOptions| question.put(&UniformGrid::new(scene, &options).unwrap());
    let usual = GridOptions::default();
    match name {
        "exhaustive" => question.put(&Exhaustive::new(scene)),
        "bounds: sphere" => question.put(&BoundedObjects::new(scene, VolumeKind::Sphere, axes)),
        "bounds: ellipsoid" => {
            question.put(&BoundedObjects::new(scene, VolumeKind::Ellipsoid, axes))
        }
        "bounds: box" => question.put(&BoundedObjects::new(scene, VolumeKind::Box, axes)),
        "bounds: seven slabs" => {
            question.put(&BoundedObjects::new(scene, VolumeKind::Slabs, seven))
        }
        "hierarchy: bottom-up" => question.put(&DepthFirst::new(scene, axes, Build::BottomUp)),
        "hierarchy: insertion" => question.put(&DepthFirst::new(scene, axes, Build::Insertion)),
        "hierarchy: surface-area" => {
            question.put(&DepthFirst::new(scene, axes, Build::SurfaceArea))
        }
        "hierarchy: seven slabs" => {
            question.put(&DepthFirst::new(scene, seven, Build::SurfaceArea))
        }
        "hierarchy: own slabs" => {
            let own = SlabSet::of(scene.slabs.as_ref().unwrap()).unwrap();
            question.put(&DepthFirst::new(scene, &own, Build::BottomUp))
        }
        "heap: bottom-up" => question.put(&HeapOrdered::new(scene, axes, Build::BottomUp)),
        "grid: mailboxes" => grid(usual),
        "grid: no mailboxes" => grid(GridOptions {
            mailboxes: false,
            ..usual
        }),
        "grid: boxes" => grid(GridOptions {
            lists: Lists::Boxes,
            density: 0.7,
            ..usual
        }),
        "grid: one cell" => grid(GridOptions {
            resolution: Some([1, 1, 1]),
            ..usual
        }),
        "grid: many cells" => grid(GridOptions {
            density: 40.0,
            ..usual
        }),
        other => panic!("there is no strategy {other}"),
    }
}

/// Numbers for a scene: on a lattice, or anywhere.
struct Numbers {
    random: Seeded,
    lattice: bool,
    /// What a step of the lattice measures.
    scale: f64,
}

impl Numbers {
    fn coordinate(&mut self, size: i32) -> f64 {
        let step = if self.lattice {
            f64::from(self.random.whole(-size, size))
        } else {
            self.random.within(-f64::from(size), f64::from(size))
        };
        step * self.scale
    }

    fn point(&mut self, size: i32) -> [f64; 3] {
        [0; 3].map(|_| self.coordinate(size))
    }

    fn length(&mut self) -> f64 {
        let step = if self.lattice {
            f64::from(self.random.whole(1, 2))
        } else {
            self.random.within(0.05, 2.0)
        };
        step * self.scale
    }

    /// Three or four corners in one plane.
    fn polygon(&mut self) -> Value {
        let corner = self.point(4);
        let [u, v] = [0; 2].map(|_| self.point(3));
        let at = |a: f64, b: f64| [0, 1, 2].map(|i| corner[i] + a * u[i] + b * v[i]);
        if self.random.index(2) == 0 {
            json!([at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0)])
        } else {
            // concave
            json!([at(0.0, 0.0), at(2.0, 0.0), at(0.5, 0.5), at(0.0, 2.0)])
        }
    }

    fn shape(&mut self) -> Value {
        match self.random.index(6) {
            0 => json!({ "sphere": { "center": self.point(4), "radius": self.length() } }),
            1 => {
                let radii = [0; 3].map(|_| self.length());
                json!({ "ellipsoid": { "center": self.point(4), "radii": radii } })
            }
            2 => {
                let min = self.point(4);
                let max = min.map(|low| low + self.length());
                json!({ "box": { "min": min, "max": max } })
            }
            3 => {
                let base = self.point(4);
                let mut apex = base;
                apex[self.random.index(3)] += self.length();
                if self.random.index(2) == 0 {
                    apex[self.random.index(3)] += self.length();
                }
                let apex_radius = [0.0, self.length()][self.random.index(2)];
                json!({ "cone": {
                    "base": base, "base_radius": self.length(),
                    "apex": apex, "apex_radius": apex_radius,
                } })
            }
            4 => json!({ "polygon": { "vertices": self.polygon() } }),
            _ => {
                let faces: Vec<_> = (0..3)
                    .map(|_| json!({ "vertices": self.polygon() }))
                    .collect();
                json!({ "mesh": { "faces": faces } })
            }
        }
    }

    /// A camera on the lattice, or anywhere; its window an axis away, or anywhere.
    fn camera(&mut self) -> Value {
        let cop = self.point(6);
        let ahead = self.random.index(3);
        let (mut to, mut right, mut up) = ([0.0; 3], [0.0; 3], [0.0; 3]);
        // towards the objects, most often
        let side = if 0.0 < cop[ahead] { -1.0 } else { 1.0 };
        let turned = if self.random.index(8) == 0 { -1.0 } else { 1.0 };
        to[ahead] = turned * side * 3.0 * self.scale;
        right[(ahead + 1) % 3] = self.random.sign() * 4.0 * self.scale;
        up[(ahead + 2) % 3] = self.random.sign() * 4.0 * self.scale;
        if !self.lattice {
            for edge in [&mut to, &mut right, &mut up] {
                for (side, off) in edge.iter_mut().zip(self.point(1)) {
                    *side += 0.3 * off;
                }
            }
        }
        let corner = [0, 1, 2].map(|i| cop[i] + to[i] - 0.5 * right[i] - 0.5 * up[i]);
        json!({
            "window": { "cop": cop, "corner": corner, "right": right, "up": up },
            "pixels": [SIDE, SIDE],
        })
    }

    fn scene(&mut self) -> Value {
        let count = 1 + self.random.index(14);
        let mut objects: Vec<Value> = Vec::new();
        for i in 0..count {
            let shape = match (objects.last(), self.random.index(8)) {
                // the same once more: equal t
                (Some(last), 0) => last["shape"].clone(),
                _ => self.shape(),
            };
            let name = format!("object {i}");
            objects.push(json!({ "name": name, "material": "grey", "shape": shape }));
        }
        json!({
            "camera": self.camera(),
            "materials": { "grey": { "colour": [0.5, 0.5, 0.5], "diffuse": 1.0 } },
            "objects": objects,
            "slabs": [[1, 2, 0], [0, 1, 1], [1, 0, -1], [1, 1, 1]],
        })
    }
}

/// A random scene of all shapes, as a file: on a lattice, or anywhere.
pub(crate) fn random_scene(seed: u64, lattice: bool) -> Value {
    let random = Seeded::new(seed);
    let mut numbers = Numbers {
        random,
        lattice,
        scale: 1.0,
    };
    numbers.scene()
}

/// The scene; `None` if an object has no area, which the lattice makes now and then.
fn built(scene: &Value) -> Option<Scene> {
    Scene::new(serde_json::from_value::<SceneFile>(scene.clone()).unwrap()).ok()
}

fn eye_rays(scene: &Scene) -> Vec<Ray> {
    let [width, height] = scene.camera.pixels;
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    pixels
        .map(|(x, y)| {
            let place = |side: u32| f64::from(side) + 0.5;
            scene.camera.eye_ray(place(x), place(y)).0
        })
        .collect()
}

/// The first pixel about which a strategy does not agree with the exhaustive one.
fn disagreement(name: &str, scene: &Scene, rays: &[Ray], expected: &[Answer]) -> Option<usize> {
    let found = answers(name, scene, rays);
    (0..rays.len()).find(|&at| found[at] != expected[at])
}

/// Takes objects away while the pixel still fails, and prints what is left.
fn shrunk(name: &str, scene: &Value, pixel: usize) -> String {
    let fails = |scene: &Value| {
        built(scene).is_some_and(|scene| {
            let ray = [eye_rays(&scene)[pixel]];
            let expected = answers("exhaustive", &scene, &ray);
            disagreement(name, &scene, &ray, &expected).is_some()
        })
    };
    let mut smallest = scene.clone();
    let mut at = 0;
    while at < smallest["objects"].as_array().unwrap().len() {
        let mut smaller = smallest.clone();
        smaller["objects"].as_array_mut().unwrap().remove(at);
        if fails(&smaller) {
            smallest = smaller;
        } else {
            at += 1;
        }
    }
    let (x, y) = (pixel as u32 % SIDE, pixel as u32 / SIDE);
    let small = built(&smallest).unwrap();
    let ray = [eye_rays(&small)[pixel]];
    format!(
        "{name} disagrees: {:?}\nexhaustive:      {:?}\nraystep pixel this-scene.json {x},{y}\n{smallest:#}",
        answers(name, &small, &ray),
        answers("exhaustive", &small, &ray)
    )
}

#[test]
fn a_million_rays_meet_the_same_object_at_the_same_t_whatever_the_strategy() {
    let check = |seed: u64| {
        let mut random = Seeded::new(seed);
        let scale = [1.0, 1.0, 1e-3, 1e4][random.index(4)];
        let mut numbers = Numbers {
            lattice: seed.is_multiple_of(2),
            random,
            scale,
        };
        let (file, scene) = loop {
            let file = numbers.scene();
            if let Some(scene) = built(&file) {
                break (file, scene);
            }
        };
        let rays = eye_rays(&scene);
        let expected = answers("exhaustive", &scene, &rays);
        for name in both_drivers() {
            if let Some(pixel) = disagreement(&name, &scene, &rays, &expected) {
                panic!("{}", shrunk(&name, &file, pixel));
            }
        }
        let hits = expected.iter().filter(|answer| answer.object.is_some());
        (rays.len(), hits.count())
    };
    let halves = std::thread::scope(|scope| {
        let half = |odd: u64| {
            move || {
                (0..SCENES / 2)
                    .map(move |i| check(2 * i + odd))
                    .collect::<Vec<_>>()
            }
        };
        let threads = [0, 1].map(|odd| scope.spawn(half(odd)));
        threads.map(|thread| thread.join().unwrap())
    });
    let all = halves.iter().flatten();
    let (rays, hits) = all.fold((0, 0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
    assert!(1_000_000 <= rays, "{rays}");
    assert!(rays / 10 <= hits, "hardly any ray meets anything: {hits}");
}
