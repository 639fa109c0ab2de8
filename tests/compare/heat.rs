//! Heat maps: what two pixels cost, counted by hand, and the colours that show it.

use raystep::figure::heat_map;
use raystep::strategy::{DepthFirst, Exhaustive, Strategy};
use raystep::structure::{Build, SlabSet};
use raystep::tracer::{HeatLine, HeatOf, heat_values, render};
use raystep::{NoFiles, Scene, Through, Tracer, Transport, load_bytes};

use crate::cli::run::Folder;

/// The left one of two pixels looks at the middle of a ball, the right one past it; a lamp above lights the
/// side that is seen.
const ONE_BALL: &str = r#"{
  "camera": { "window": { "cop": [0, 0, 0], "corner": [-1, -0.5, -1], "right": [2, 0, 0], "up": [0, 1, 0] }, "pixels": [2, 1] },
  "background": [0, 0, 0], "ambient": [1, 1, 1],
  "lights": [ { "name": "lamp", "position": [0, 5, 0], "colour": [1, 1, 1] } ],
  "materials": { "red": { "colour": [1, 0, 0], "diffuse": 1 } },
  "objects": [ { "name": "A", "material": "red", "shape": { "sphere": { "center": [-2.5, 0, -5], "radius": 1 } } } ],
  "max_depth": 5
}"#;

/// The ends of viridis.
const LEAST: [u8; 3] = [68, 1, 84];
const MOST: [u8; 3] = [253, 231, 37];

fn values<S: Strategy>(scene: &Scene, strategy: &S, of: HeatOf, through: Through) -> Vec<f64> {
    let tracer = Tracer::new(scene, strategy, Transport::HybridLight);
    let (_, lines) = render::<_, HeatLine>(&tracer, through, |_| {}).unwrap();
    heat_values(&lines, of, through)
}

#[test]
fn the_pixels_of_one_ball_cost_what_is_counted_by_hand() {
    let scene = load_bytes("s.json", ONE_BALL.as_bytes(), &NoFiles).unwrap();
    let scene = scene.build().unwrap();
    let every = Exhaustive::new(&scene);
    let centres = Through::Centres;
    // left: the eye ray and the shadow ray it leads to, each tested against the ball; right: the eye ray
    assert_eq!(values(&scene, &every, HeatOf::Tests, centres), [2.0, 1.0]);
    assert_eq!(values(&scene, &every, HeatOf::Depth, centres), [2.0, 1.0]);
    assert_eq!(values(&scene, &every, HeatOf::Nodes, centres), [0.0, 0.0]);
    assert_eq!(values(&scene, &every, HeatOf::Cells, centres), [0.0, 0.0]);
    // the root is a leaf: each ray of the left pixel meets its bound and enters it, that of the right one
    // misses the bound, and no ball is tested
    let tree = DepthFirst::new(&scene, &SlabSet::AXES, Build::BottomUp);
    assert_eq!(values(&scene, &tree, HeatOf::Nodes, centres), [4.0, 1.0]);
    assert_eq!(values(&scene, &tree, HeatOf::Tests, centres), [2.0, 0.0]);
}

#[test]
fn through_the_corners_a_pixel_shows_the_mean_of_its_rays() {
    // the window is moved so that the two rays in its middle meet the ball, and the four at its ends do not
    let moved = ONE_BALL
        .replace("[-2.5, 0, -5]", "[0, 0, -5]")
        .replace("[-1, -0.5, -1]", "[-1, -0.05, -1]")
        .replace("\"up\": [0, 1, 0]", "\"up\": [0, 0.1, 0]");
    let scene = load_bytes("s.json", moved.as_bytes(), &NoFiles).unwrap();
    let scene = scene.build().unwrap();
    let every = Exhaustive::new(&scene);
    // of the four rays of each pixel two cost 2 and two cost 1
    let means = values(&scene, &every, HeatOf::Tests, Through::Corners);
    assert_eq!(means, [1.5, 1.5]);
}

/// The pixels of a PNG.
fn decoded(bytes: Vec<u8>) -> ([u32; 2], Vec<[u8; 3]>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
        .read_info()
        .unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    let pixels = pixels.chunks_exact(3).map(|rgb| [rgb[0], rgb[1], rgb[2]]);
    ([info.width, info.height], pixels.collect())
}

#[test]
fn the_dearest_pixel_is_yellow_and_the_cheapest_dark_blue() {
    let folder = Folder::empty().with("s.json", ONE_BALL);
    folder
        .run("render s.json -o heat.png --heatmap tests")
        .well();
    let ([width, height], pixels) = decoded(folder.read("heat.png"));
    // 2 × 1 pixels enlarged 160 times, and the legend below
    assert_eq!(width, 320);
    assert!(160 < height);
    for y in 0..160 {
        for x in 0..320 {
            let expected = if x < 160 { MOST } else { LEAST };
            assert_eq!(pixels[y * 320 + x], expected, "{x},{y}");
        }
    }
    // the legend's bar goes from the one to the other, and letters are black on white
    let legend = &pixels[160 * 320..];
    for colour in [LEAST, MOST, [0; 3], [255; 3], [33, 145, 140]] {
        assert!(legend.contains(&colour), "{colour:?}");
    }
}

#[test]
fn a_map_of_equal_numbers_is_dark_blue_all_over() {
    let map = heat_map([2, 2], &[7.0; 4], "object tests per pixel");
    let [width, _] = map.pixels;
    assert_eq!(width, 320);
    assert!(
        map.bytes[..320 * 320 * 3]
            .chunks_exact(3)
            .all(|rgb| rgb == LEAST)
    );
    // no other colour in the legend than that, ink and paper
    let legend = &map.bytes[320 * 320 * 3..];
    let known = [LEAST, [0; 3], [255; 3]];
    assert!(
        legend
            .chunks_exact(3)
            .all(|rgb| known.iter().any(|colour| rgb == colour))
    );
}

#[test]
fn a_heat_map_is_the_same_on_any_number_of_threads_and_counting_changes_nothing() {
    let folder = Folder::with_scene();
    let map = |words: &str| {
        let words = format!("render scene.json --pixels 33,21 --heatmap tests -o out.png {words}");
        assert_eq!(folder.run(&words).code, Some(0), "{words}");
        folder.read("out.png")
    };
    let first = map("");
    for words in ["--threads 1", "--threads 2", "--stats"] {
        assert!(map(words) == first, "{words}");
    }
    assert!(map("--strategy hierarchy") != first);
}
