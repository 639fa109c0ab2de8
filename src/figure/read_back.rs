//! For the tests of the kinds: a trace that is made by hand, and its drawing read back.

use glam::DVec2;
use roxmltree::{Document, Node};
use serde_json::Value;

use crate::figure::draw;
use crate::figure::sheet::Width;
use crate::figure::sheet::canvas::Rendition;
use crate::figure::spec::FigureSpec;
use crate::figure::traced::Traced;
use crate::scene::Scene;
use crate::trace::{Event, Record, Settings};

pub(in crate::figure) use of_scene::ball;

/// Coordinates in a drawing have two digits behind the point.
pub(in crate::figure) const DRAWN: f64 = 0.02;

/// What a drawing's elements are named by here.
const ID: &str = "read";

/// A trace of pixel (0, 0) with these events, each with the number of its ray.
pub(in crate::figure) fn traced(
    scene: Scene,
    events: impl IntoIterator<Item = (Option<u32>, Event)>,
) -> Traced {
    let record = |(step, (ray, event))| Record {
        pixel: Some([0, 0]),
        path: None,
        step,
        ray,
        parent: None,
        event,
    };
    Traced {
        scene,
        settings: Settings::default(),
        records: (0..).zip(events).map(record).collect(),
        of_pixels: crate::trace::OfPixels::default(),
    }
}

/// A drawing as its SVG has it.
pub(in crate::figure) struct ReadBack {
    svg: String,
}

impl ReadBack {
    /// Draws a figure of a hand-made trace; `spec` is what a lesson says about it, without its scene.
    #[track_caller]
    pub(in crate::figure) fn of(mut spec: Value, traced: Traced) -> Self {
        spec["scene"] = "by hand".into();
        let spec: FigureSpec = serde_json::from_value(spec).unwrap();
        let drawn = draw(&spec, &[traced], ID, Width::Book, Rendition::default());
        let svg = drawn.unwrap().svg;
        Self { svg }
    }

    fn read<T>(&self, of: impl Fn(&Node) -> Option<T>) -> Vec<T> {
        let document = Document::parse(&self.svg).unwrap();
        document
            .descendants()
            .filter_map(|node| of(&node))
            .collect()
    }

    /// The middles of the dots and circles whose area or line has a colour, such as `answer`.
    pub(in crate::figure) fn dots(&self, colour: &str) -> Vec<DVec2> {
        let circles = self.circles(colour);
        circles.into_iter().map(|(middle, _)| middle).collect()
    }

    /// The dots and circles that have a colour, with their radii.
    pub(in crate::figure) fn circles(&self, colour: &str) -> Vec<(DVec2, f64)> {
        self.read(|node| {
            let is_circle = node.has_tag_name("circle") && has_colour(node, colour);
            let middle = || DVec2::new(number(node, "cx"), number(node, "cy"));
            is_circle.then(|| (middle(), number(node, "r")))
        })
    }

    /// The points of the lines and polygons that have a colour.
    pub(in crate::figure) fn paths(&self, colour: &str) -> Vec<Vec<DVec2>> {
        self.read(|node| {
            let is_path = node.has_tag_name("path") && has_colour(node, colour);
            is_path.then(|| points(node.attribute("d").unwrap_or_default()))
        })
    }

    /// The middles of the crosses: of two lines of one length that cross there.
    pub(in crate::figure) fn crosses(&self, colour: &str) -> Vec<DVec2> {
        let lines = self.paths(colour);
        let middle = |line: &[DVec2]| (line[0] + line[1]) / 2.0;
        let is_cross = |a: &[DVec2], b: &[DVec2]| {
            a.len() == 2 && b.len() == 2 && middle(a).distance(middle(b)) < 0.02
        };
        let pairs = lines.windows(2).filter(|pair| is_cross(&pair[0], &pair[1]));
        pairs.map(|pair| middle(&pair[0])).collect()
    }

    /// All texts, the letters of each with its indices on the line.
    pub(in crate::figure) fn texts(&self) -> Vec<String> {
        self.read(|node| {
            let letters = || {
                node.descendants()
                    .filter_map(|of| of.text().filter(|_| of.is_text()))
            };
            node.has_tag_name("text").then(|| letters().collect())
        })
    }
}

fn has_colour(node: &Node, colour: &str) -> bool {
    let classes = node.attribute("class").unwrap_or_default();
    let own = ["line", "area"].map(|part| format!("{ID}_{colour}-{part}"));
    classes
        .split(' ')
        .any(|class| own.iter().any(|of| of == class))
}

#[track_caller]
fn number(node: &Node, key: &str) -> f64 {
    node.attribute(key).unwrap().parse().unwrap()
}

#[track_caller]
fn points(data: &str) -> Vec<DVec2> {
    let numbers = data
        .split(['M', 'L', 'Z', ' '])
        .filter(|part| !part.is_empty());
    let numbers: Vec<f64> = numbers.map(|number| number.parse().unwrap()).collect();
    let pair = |pair: &[f64]| DVec2::new(pair[0], pair[1]);
    numbers.chunks_exact(2).map(pair).collect()
}

#[cfg(test)]
mod of_scene {
    use super::*;
    use crate::figure::sheet::frame::Frame;
    use crate::lesson::trace_figure;
    use crate::scene::{NoFiles, load_bytes};

    impl ReadBack {
        /// Traces a scene of one pixel, whose ray starts in (−10, 0, 0) and goes along the x axis, and draws the figure.
        #[track_caller]
        pub(in crate::figure) fn of_ray_along_x(
            objects: &Value,
            mut spec: Value,
        ) -> (Self, Vec<Traced>) {
            let scene = serde_json::json!({
                "camera": {
                    "look_at": { "cop": [-10, 0, 0], "target": [0, 0, 0], "up": [0, 1, 0], "fov_degrees": 30 },
                    "pixels": [1, 1]
                },
                "materials": { "m": { "colour": [1, 1, 1] } },
                "slabs": [[1, 0], [0, 1]],
                "objects": objects
            });
            let loaded = load_bytes("scene.json", scene.to_string().as_bytes(), &NoFiles).unwrap();
            for (key, value) in [("scene", "by hand"), ("transport", "backward")] {
                spec[key] = value.into();
            }
            if spec.get("pixels").is_none() {
                spec["pixel"] = serde_json::json!([0, 0]);
            }
            let spec: FigureSpec = serde_json::from_value(spec).unwrap();
            let traced = trace_figure(loaded, "test/by-hand", &spec, |error| panic!("{error}"));
            let traced = traced.unwrap();
            let drawn = draw(&spec, &traced, ID, Width::Book, Rendition::default());
            let svg = drawn.unwrap().svg;
            (Self { svg }, traced)
        }

        /// The rectangles that have a colour.
        pub(in crate::figure) fn rectangles(&self, colour: &str) -> Vec<Frame> {
            self.read(|node| {
                let is_it = node.has_tag_name("rect") && has_colour(node, colour);
                is_it.then(|| {
                    let min = DVec2::new(number(node, "x"), number(node, "y"));
                    let size = DVec2::new(number(node, "width"), number(node, "height"));
                    Frame {
                        min,
                        max: min + size,
                    }
                })
            })
        }

        /// The places at which the upright straight lines of a colour stand, from the left, each once.
        pub(in crate::figure) fn upright(&self, colour: &str) -> Vec<f64> {
            let lines = self.paths(colour).into_iter();
            let lines = lines.filter(|line| line.len() == 2 && line[0].x == line[1].x);
            let mut places: Vec<f64> = lines.map(|line| line[0].x).collect();
            places.sort_by(f64::total_cmp);
            places.dedup();
            places
        }

        /// The letters of each text, and where it is anchored.
        pub(in crate::figure) fn placed_texts(&self) -> Vec<(String, DVec2)> {
            let places = self.read(|node| {
                let is_it = node.has_tag_name("text");
                is_it.then(|| DVec2::new(number(node, "x"), number(node, "y")))
            });
            self.texts().into_iter().zip(places).collect()
        }
    }

    /// A ball for such a scene.
    pub(in crate::figure) fn ball(name: &str, center: [f64; 3], radius: f64) -> Value {
        serde_json::json!({
            "name": name, "material": "m", "shape": { "sphere": { "center": center, "radius": radius } }
        })
    }
}
