//! Drawn coordinates against the events and the scene: for the kinds of figure whose own files have no such test.
//!
//! Of a flat view two points fix the map from the scene to the sheet: one scale for both directions, y upwards.

use glam::{DVec2, DVec3};
use raystep::figure::draw;
use raystep::{Event, FigureName, Record, Rendition, Scene, Traced, Width};
use roxmltree::{Document, Node};

use crate::figures::library;

const ID: &str = "raystep-test";

/// Coordinates in a drawing have two digits behind the point.
const DRAWN: f64 = 0.03;

/// A figure of a lesson: its trace, and the SVG.
fn drawn(name: &str) -> (Vec<Traced>, String) {
    let library = library();
    let figure: FigureName = name.parse().unwrap();
    let (lesson, spec) = library.find(&figure).unwrap();
    let traced = lesson.trace(&figure.figure, spec).unwrap();
    let drawn = draw(spec, &traced, ID, Width::Book, Rendition::default());
    (traced, drawn.unwrap().svg)
}

fn number(node: &Node, key: &str) -> f64 {
    node.attribute(key).unwrap().parse().unwrap()
}

/// The elements of a name whose line or area has a colour.
fn elements<'a>(document: &'a Document, tag: &str, colour: &str) -> Vec<Node<'a, 'a>> {
    let class = format!("{ID}_{colour}-");
    let is_it = |node: &Node| {
        let classes = node.attribute("class").unwrap_or_default();
        node.has_tag_name(tag) && classes.split(' ').any(|of| of.starts_with(&class))
    };
    document.descendants().filter(is_it).collect()
}

/// The points of the paths of a colour.
fn paths(document: &Document, colour: &str) -> Vec<Vec<DVec2>> {
    let points = |node: Node| {
        let data = node.attribute("d").unwrap();
        let numbers = data.split(['M', 'L', 'Z', ' ']);
        let numbers: Vec<f64> = numbers
            .filter(|part| !part.is_empty())
            .map(|number| number.parse().unwrap())
            .collect();
        let pairs = numbers.chunks_exact(2);
        pairs.map(|pair| DVec2::new(pair[0], pair[1])).collect()
    };
    elements(document, "path", colour)
        .into_iter()
        .map(points)
        .collect()
}

/// The middles of the circles of a colour.
fn circles(document: &Document, colour: &str) -> Vec<DVec2> {
    let middle = |node: Node| DVec2::new(number(&node, "cx"), number(&node, "cy"));
    elements(document, "circle", colour)
        .into_iter()
        .map(middle)
        .collect()
}

/// Where a text stands.
fn text_at(document: &Document, text: &str) -> DVec2 {
    let is_it = |node: &Node| {
        let letters = node.descendants().filter(Node::is_text);
        let letters: String = letters.filter_map(|of| of.text()).collect();
        node.has_tag_name("text") && letters == text
    };
    let found = document.descendants().find(is_it);
    let found = found.unwrap_or_else(|| panic!("no {text}"));
    DVec2::new(number(&found, "x"), number(&found, "y"))
}

#[track_caller]
fn has(points: &[DVec2], at: DVec2) {
    let is_near = |point: &DVec2| point.distance(at) <= DRAWN;
    assert!(
        points.iter().any(is_near),
        "nothing at {at} among {points:?}"
    );
}

/// From a plane of the scene to the sheet.
struct Map {
    scale: f64,
    from: DVec2,
    to: DVec2,
}

impl Map {
    /// By two points that do not lie side by side.
    fn by(scene: [DVec2; 2], sheet: [DVec2; 2]) -> Self {
        let scale = (sheet[1].x - sheet[0].x) / (scene[1].x - scene[0].x);
        let other = (sheet[0].y - sheet[1].y) / (scene[1].y - scene[0].y);
        assert!((scale / other - 1.0).abs() < 1e-3, "{scale} {other}");
        Self {
            scale,
            from: scene[0],
            to: sheet[0],
        }
    }

    fn place(&self, at: DVec2) -> DVec2 {
        let away = self.scale * (at - self.from);
        self.to + DVec2::new(away.x, -away.y)
    }
}

/// As the view from the side has it: −z to the right, y up.
fn side(at: DVec3) -> DVec2 {
    DVec2::new(-at.z, at.y)
}

/// The map of a side view, by the COP's dot and the lamp's ring.
fn by_cop_and_lamp(document: &Document, scene: &Scene) -> Map {
    let points = [scene.camera.cop, scene.lights[0].position].map(side);
    let dots = circles(document, "ink");
    // the COP is the dot furthest left, the lamp the ring furthest up
    let cop = dots
        .iter()
        .copied()
        .min_by(|a, b| a.x.total_cmp(&b.x))
        .unwrap();
    let lamp = dots
        .iter()
        .copied()
        .min_by(|a, b| a.y.total_cmp(&b.y))
        .unwrap();
    Map::by(points, [cop, lamp])
}

fn all<T>(records: &[Record], of: impl Fn(&Record) -> Option<T>) -> Vec<T> {
    records.iter().filter_map(of).collect()
}

#[test]
fn paths_of_light_bend_where_their_photons_hit() {
    let (traced, svg) = drawn("08-transport/forward");
    let document = Document::parse(&svg).unwrap();
    let map = by_cop_and_lamp(&document, &traced[0].scene);
    let legs: Vec<DVec2> = paths(&document, "light").concat();
    // the paths that arrive, by their numbers
    let records = &traced[0].records;
    let arrive = all(records, |record| {
        matches!(record.event, Event::Arrival(_)).then_some(record.path)
    });
    let first = all(records, |record| match &record.event {
        Event::Photon(photon) if arrive.contains(&record.path) => Some(photon.point),
        _ => None,
    });
    assert!(4 <= first.len());
    for point in first.into_iter().take(4) {
        has(&legs, map.place(side(point)));
    }
}

#[test]
fn the_line_with_the_geometry_term_joins_the_two_vertices() {
    let (traced, svg) = drawn("08-transport/hybrid-connected");
    let document = Document::parse(&svg).unwrap();
    let map = by_cop_and_lamp(&document, &traced[0].scene);
    let line = all(&traced[0].records, |record| match record.event {
        Event::Connection(of) if (of.light_vertex, of.eye_vertex) == (1, 1) => Some(of),
        _ => None,
    });
    let ends = paths(&document, "answer").concat();
    has(&ends, map.place(side(line[0].from)));
    has(&ends, map.place(side(line[0].to)));
}

#[test]
fn a_photon_stands_as_far_from_p_as_on_the_floor() {
    let (traced, svg) = drawn("08-transport/gather");
    let document = Document::parse(&svg).unwrap();
    let gathered = all(&traced[0].records, |record| match record.event {
        Event::Gathered(gathered) => Some(gathered),
        _ => None,
    });
    let nearby = all(&traced[0].records, |record| match record.event {
        Event::Nearby(photon) => Some(photon.point),
        _ => None,
    });
    let p = gathered[0].point;
    // p is the only dot in ink, beside the outline of the ball above; the dashed line goes from it to the photon that sets
    // the radius
    let mut in_ink = elements(&document, "circle", "ink");
    in_ink.sort_by(|a, b| number(a, "r").total_cmp(&number(b, "r")));
    let at = DVec2::new(number(&in_ink[0], "cx"), number(&in_ink[0], "cy"));
    let last = *nearby.last().unwrap();
    let to = circles(&document, "rejected")[0];
    let scale = at.distance(to) / p.distance(last);
    let photons = circles(&document, "light");
    for point in &nearby[..5] {
        // from above: x to the right, z down
        let away = scale * DVec2::new(point.x - p.x, point.z - p.z);
        has(&photons, at + away);
    }
}

#[test]
fn p_stands_in_the_projected_polygon_where_the_test_says() {
    let (traced, svg) = drawn("06-polygon/inside");
    let document = Document::parse(&svg).unwrap();
    let test = all(&traced[0].records, |record| match record.event {
        Event::PolygonTest { test, .. } => Some(test),
        _ => None,
    })[0];
    let edges = all(&traced[0].records, |record| match record.event {
        Event::Edge { edge, .. } if edge.counts => Some(edge),
        _ => None,
    });
    // the edge that counts is drawn thick: y is dropped, x goes to the right and z down
    let flat = |at: DVec2| DVec2::new(at.x, -at.y);
    let thick = paths(&document, "visited")[0].clone();
    let map = Map::by(
        [flat(edges[0].from), flat(edges[0].to)],
        [thick[0], thick[1]],
    );
    has(
        &circles(&document, "answer"),
        map.place(flat(test.projected)),
    );
}

/// The frame of a picture: its upper left corner and its size.
fn picture_of(document: &Document) -> [DVec2; 2] {
    let image = document
        .descendants()
        .find(|node| node.has_tag_name("image"))
        .unwrap();
    let of = |keys: [&str; 2]| DVec2::from(keys.map(|key| number(&image, key)));
    [of(["x", "y"]), of(["width", "height"])]
}

#[test]
fn a_marked_pixel_has_its_square_in_the_picture() {
    for (name, pixel) in [
        ("02-simple-tracer/picture", [30, 33]),
        ("08-transport/map", [16, 10]),
    ] {
        let (traced, svg) = drawn(name);
        let document = Document::parse(&svg).unwrap();
        let [corner, size] = picture_of(&document);
        let pixels = DVec2::from(traced[0].scene.camera.pixels.map(f64::from));
        let side = size / pixels;
        let [x, y] = pixel.map(f64::from);
        let middle = corner + side * DVec2::new(x + 0.5, y + 0.5);
        // the frames around pixels are squares of four corners
        let frames = document
            .descendants()
            .filter(|node| node.has_tag_name("path"));
        let middles = frames.filter_map(|node| {
            let data = node.attribute("d").filter(|data| data.ends_with('Z'))?;
            let numbers = data.trim_end_matches('Z').split(['M', 'L', ' ']);
            let numbers: Vec<f64> = numbers.filter_map(|number| number.parse().ok()).collect();
            let corners: Vec<DVec2> = numbers
                .chunks_exact(2)
                .map(|pair| DVec2::new(pair[0], pair[1]))
                .collect();
            (corners.len() == 4).then(|| corners.iter().sum::<DVec2>() / 4.0)
        });
        has(&middles.collect::<Vec<_>>(), middle);
    }
}

#[test]
fn ten_lies_on_the_scale_of_the_heat_where_its_logarithm_lies() {
    let (_, svg) = drawn("09-cost/heat");
    let document = Document::parse(&svg).unwrap();
    let [one, ten, most] = ["1", "10", "200"].map(|text| text_at(&document, text).x);
    let share = 10f64.log10() / 200f64.log10();
    assert!(
        ((ten - one) / (most - one) - share).abs() < 1e-4,
        "{one} {ten} {most}"
    );
}

#[test]
fn a_bar_of_costs_is_as_long_as_the_tests_of_the_pixel() {
    let (traced, svg) = drawn("09-cost/strategies");
    let document = Document::parse(&svg).unwrap();
    // every object once for the eye ray and once for the shadow ray: tests are the events with a verdict of an object
    let tests = all(&traced[0].records, |record| match &record.event {
        Event::RayEnd(end) => Some(end.tests),
        _ => None,
    });
    let tests: u32 = tests.iter().sum();
    let bars = elements(&document, "rect", "visited");
    let longest = bars
        .iter()
        .map(|bar| number(bar, "width"))
        .fold(0.0, f64::max);
    let [zero, end] = ["0", "200"].map(|text| text_at(&document, text).x);
    assert!(
        (longest / (end - zero) - f64::from(tests) / 200.0).abs() < 1e-3,
        "{longest} {tests}"
    );
}

/// The least and the largest coordinates of points.
fn around(points: &[DVec2]) -> [DVec2; 2] {
    let first = points[0];
    points
        .iter()
        .fold([first; 2], |[min, max], at| [min.min(*at), max.max(*at)])
}

#[test]
fn the_cells_that_line_drawing_skips_lie_two_columns_and_one_row_apart() {
    // [0, 0, 2], [2, 0, 1] and [4, 0, 0] of cells with sides of 1
    let (_, svg) = drawn("12-grid/line-drawing");
    let document = Document::parse(&svg).unwrap();
    let outlines = paths(&document, "rejected");
    let mut cells: Vec<[DVec2; 2]> = outlines.iter().map(|points| around(points)).collect();
    cells.sort_by(|a, b| a[0].x.total_cmp(&b[0].x));
    assert_eq!(cells.len(), 3, "{cells:?}");
    let side = cells[0][1] - cells[0][0];
    assert!((side.x / side.y - 1.0).abs() < 1e-2, "{side}");
    for pair in cells.windows(2) {
        let apart = pair[1][0] - pair[0][0];
        let expected = DVec2::new(2.0 * side.x, -side.y);
        assert!(apart.distance(expected) < 0.1, "{apart}, not {expected}");
    }
    // the hit is in the other panel, where A is, within a cell that none of these is
    let hits = circles(&document, "answer");
    let is_right = |at: &DVec2| cells[2][1].x + side.x < at.x;
    assert!(hits.iter().any(is_right), "{hits:?}");
}

#[test]
fn the_volumes_of_a_hierarchy_are_joined_until_one_holds_all_others() {
    let (_, svg) = drawn("11-hierarchy/building");
    let document = Document::parse(&svg).unwrap();
    let frame = |node: &Node| {
        let min = DVec2::new(number(node, "x"), number(node, "y"));
        let size = DVec2::new(number(node, "width"), number(node, "height"));
        [min, min + size]
    };
    let rectangles = elements(&document, "rect", "visited");
    let middle = 380.0;
    let volumes: Vec<[DVec2; 2]> = rectangles
        .iter()
        .filter(|node| !node.attribute("class").unwrap().contains("none"))
        .map(frame)
        .filter(|[min, max]| max.x < middle && 2.0 < (*max - *min).min_element())
        .collect();
    let largest = volumes.iter().max_by(|a, b| {
        let area = |of: &[DVec2; 2]| (of[1] - of[0]).element_product();
        area(a).total_cmp(&area(b))
    });
    let largest = largest.unwrap();
    // of eight objects seven volumes
    assert!(7 <= volumes.len(), "{volumes:?}");
    let held = volumes
        .iter()
        .filter(|[min, max]| largest[0].cmple(*min).all() && max.cmple(largest[1]).all());
    assert!(7 <= held.count(), "{volumes:?}");
}
