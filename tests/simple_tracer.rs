//! The simple ray tracer on one page against the ray tracer that records: the same picture, bit for bit.

use std::path::{Path, PathBuf};

use glam::DVec3;
use raystep::geometry::{Ray, TRange};
use raystep::scene::Camera;
use raystep::strategy::{DepthFirst, Exhaustive, Hit, Strategy};
use raystep::structure::{Build, SlabSet};
use raystep::tracer::render;
use raystep::tracer::simple::{self, Own, Parts};
use raystep::{Off, Scene, Through, Tracer, Transport, load};

/// Pixels to a side: so many that each scene's shadows, mirrors and glass are hit.
const SIDE: u32 = 40;

/// The files of the lessons' scenes.
pub(crate) fn scene_files() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let lessons = std::fs::read_dir(root.join("lessons")).unwrap();
    let files = lessons.flat_map(|lesson| std::fs::read_dir(lesson.unwrap().path()).unwrap());
    let files = files.map(|file| file.unwrap().path());
    let is_scene = |path: &PathBuf| {
        path.extension().is_some_and(|end| end == "json") && !path.ends_with("lesson.json")
    };
    let mut files: Vec<PathBuf> = files.filter(is_scene).collect();
    files.sort();
    files
}

/// The lessons' scenes of up to 100 objects, and a real one, each with its name.
fn scenes(depth: u32) -> Vec<(PathBuf, Scene)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = scene_files();
    files.push(root.join("tests/data/nff/balls-2.nff"));
    files.sort();
    let built = files.into_iter().map(|path| {
        let mut file = load(&path).unwrap();
        file.scene.camera.pixels = [SIDE; 2];
        file.scene.max_depth = depth;
        let scene = file.build().unwrap();
        (path, scene)
    });
    built.collect()
}

/// The colours that the ray tracer with all strategies and recorders gives.
fn reference(scene: &Scene, transport: Transport) -> Vec<DVec3> {
    let strategy = Exhaustive::new(scene);
    let tracer = Tracer::new(scene, &strategy, transport);
    render::<_, Off>(&tracer, Through::Centres, |_| {})
        .unwrap()
        .0
        .colours
}

#[track_caller]
fn same(path: &Path, found: &[DVec3], expected: &[DVec3]) {
    assert_eq!(found.len(), expected.len());
    for (at, (found, expected)) in found.iter().zip(expected).enumerate() {
        let bits = |colour: &DVec3| colour.to_array().map(f64::to_bits);
        let pixel = [at as u32 % SIDE, at as u32 / SIDE];
        let where_ = format!("{}, pixel {pixel:?}", path.display());
        assert_eq!(bits(found), bits(expected), "{where_}: {found} {expected}");
    }
}

/// No shadow: what the transport without rays to the lights assumes.
struct NothingBlocks;

impl Parts for NothingBlocks {
    fn blocked(&self, _: &Scene, _: &Ray, _: TRange) -> bool {
        false
    }
}

#[test]
fn its_picture_is_the_one_of_hybrid_light_at_depths_1_and_5() {
    for depth in [1, 5] {
        let scenes = scenes(depth);
        assert!(20 <= scenes.len());
        for (path, scene) in &scenes {
            let expected = reference(scene, Transport::HybridLight);
            same(path, &simple::picture(scene, &Own).colours, &expected);
        }
    }
}

#[test]
fn where_nothing_blocks_its_picture_is_the_one_of_backward() {
    for (path, scene) in &scenes(5) {
        let expected = reference(scene, Transport::Backward);
        same(
            path,
            &simple::picture(scene, &NothingBlocks).colours,
            &expected,
        );
    }
}

/// The nearest object by a hierarchy.
struct ByHierarchy<'a>(DepthFirst<'a, 3>);

impl Parts for ByHierarchy<'_> {
    fn nearest(&self, _: &Scene, ray: &Ray, range: TRange) -> Option<Hit> {
        self.0.nearest(ray, range, &mut Off)
    }
}

#[test]
fn a_hierarchy_may_look_for_the_nearest_object() {
    for (path, scene) in &scenes(3) {
        let hierarchy = DepthFirst::new(scene, &SlabSet::AXES, Build::BottomUp);
        let found = simple::picture(scene, &ByHierarchy(hierarchy)).colours;
        same(path, &found, &simple::picture(scene, &Own).colours);
    }
}

/// Rows counted from below, as beginners do: the picture is upside down.
struct RowsFromBelow;

impl Parts for RowsFromBelow {
    fn window_point(&self, camera: &Camera, x: f64, y: f64) -> DVec3 {
        camera.to_window(x, f64::from(camera.pixels[1]) - y)
    }
}

#[test]
fn rows_counted_from_below_turn_the_picture_upside_down() {
    let (path, scene) = &scenes(5)[0];
    let mut found = simple::picture(scene, &RowsFromBelow).colours;
    let upright = simple::picture(scene, &Own).colours;
    assert_ne!(found, upright);
    let rows: Vec<&[DVec3]> = found.chunks(SIDE as usize).rev().collect();
    found = rows.concat();
    same(path, &found, &upright);
}
