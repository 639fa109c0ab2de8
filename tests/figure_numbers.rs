//! Numbers that stand in figures, worked out by hand or from other events than those that the figure writes.

use glam::DVec3;
use raystep::figure::draw;
use raystep::geometry::QuadraticTest;
use raystep::{Event, FigureName, Record, Rendition, Traced, Width};

use crate::figures::{library, texts_of};

/// The letters of a lesson's figure, its alt text, and its trace.
pub(crate) fn drawn(name: &str) -> (Vec<Traced>, Vec<String>) {
    let library = library();
    let figure: FigureName = name.parse().unwrap();
    let (lesson, spec) = library.find(&figure).unwrap();
    let traced = lesson.trace(&figure.figure, spec).unwrap();
    let drawn = draw(
        spec,
        &traced,
        "raystep-test",
        Width::Book,
        Rendition::default(),
    );
    let texts = texts_of(&drawn.unwrap().svg);
    (traced, texts)
}

#[track_caller]
pub(crate) fn has(texts: &[String], part: &str) {
    let found = texts.iter().any(|text| text.contains(part));
    assert!(found, "no {part:?} among {texts:?}");
}

pub(crate) fn all<T>(records: &[Record], of: impl Fn(&Record) -> Option<T>) -> Vec<T> {
    records.iter().filter_map(of).collect()
}

/// A number as a figure has it: so many digits, without zeros at the end, with a minus.
pub(crate) fn digits(value: f64, decimals: usize) -> String {
    let text = format!("{:.decimals$}", value.abs());
    let text = text.trim_end_matches('0').trim_end_matches('.');
    let sign = if value < 0.0 { "−" } else { "" };
    format!("{sign}{text}")
}

#[test]
fn the_roots_of_five_spheres_on_a_ray_are_those_worked_out_by_hand() {
    let (_, texts) = drawn("04-sphere/cases");
    // half chords of √(1.5² − 0.9²) = 1.2 around −3.7, 0.4 and 12.4; the grazed one at 8.5
    for t in ["−4.9", "−2.5", "−0.8", "1.6", "8.5", "11.2", "13.6"] {
        assert!(texts.iter().any(|text| text == t), "{t}: {texts:?}");
    }
    // 4(r² − d²): 4·1.44, 0, 4(2.25 − 2.89)
    let count = |of: &str| texts.iter().filter(|text| *text == of).count();
    assert_eq!(count("b2 − 4ac = 5.76"), 3);
    assert_eq!(count("b2 − 4ac = 0"), 1);
    assert_eq!(count("b2 − 4ac = −2.56"), 1);
}

#[test]
fn the_two_forms_of_the_quadratic_have_the_numbers_worked_out_by_hand() {
    let (_, texts) = drawn("04-sphere/forms");
    // b = −8.2, c = 16: 67.24 − 64, 16.81 − 16, and 16.81 − 64
    for part in [
        "a = 1, b = −8.2, c = 16",
        "b2 − 4ac = 3.24",
        "b′2 − ac = 0.81",
        "b′2 − 4ac = −47.19",
    ] {
        has(&texts, part);
    }
    assert_eq!(
        texts
            .iter()
            .filter(|text| *text == "t1 = 3.2, t2 = 5")
            .count(),
        2
    );
}

#[test]
fn the_four_planes_have_the_numerators_and_denominators_worked_out_by_hand() {
    let (_, texts) = drawn("06-polygon/planes");
    // (A, B, C) = (−0.8, 0.6, 0) through (4, 0, 0) and (−3, 0, 0); (0, 1, 0) through y = −1 and y = 0
    for part in [
        "A: numerator 3.2, denominator −0.8",
        "t = 4 > 0: the hit",
        "B: numerator −2.4, denominator −0.8",
        "t = −3 < 0: behind the origin",
        "C: numerator 1, denominator 0",
        "D: numerator 0, denominator 0",
    ] {
        has(&texts, part);
    }
}

#[test]
fn the_centre_of_pixel_2_1_is_where_the_formula_puts_it_by_hand() {
    let (_, texts) = drawn("01-pinhole/pixel-grid");
    // (2 + ½)/4, 1 − (1 + ½)/3, (−2, −1.5, 0) + 0.625·(4, 0, 0) + 0.5·(0, 3, 0)
    has(&texts, "= 0.625");
    has(&texts, "= 0.5");
    has(&texts, "P = (0.5, 0, 0)");
}

#[test]
fn a_ball_at_the_rim_is_as_much_wider_than_high_in_the_picture_as_the_figure_says() {
    let (traced, texts) = drawn("01-pinhole/rim");
    let picture = traced[0].of_pixels.picture.as_ref().unwrap();
    let [width, height] = picture.pixels.map(|side| side as usize);
    let is_red = |x: usize, y: usize| {
        let at = 3 * (y * width + x);
        picture.rgb[at + 2] < picture.rgb[at]
    };
    // from the left end to each of the balls: the columns and rows that are red
    let mut ratios = Vec::new();
    let mut column = 0;
    while column < width {
        let is_ball = |x: usize| (0..height).any(|y| is_red(x, y));
        if !is_ball(column) {
            column += 1;
            continue;
        }
        let end = (column..width).find(|x| !is_ball(*x)).unwrap();
        let rows = (0..height).filter(|y| (column..end).any(|x| is_red(x, *y)));
        ratios.push((end - column) as f64 / rows.count() as f64);
        column = end;
    }
    assert_eq!(ratios.len(), 5, "{ratios:?}");
    for (found, said) in ratios.iter().zip([1.64, 1.13, 1.0, 1.13, 1.64]) {
        // a pixel more or less of some thirteen to thirty
        assert!((found / said - 1.0).abs() < 0.1, "{ratios:?}");
    }
    for (said, count) in [("1.64 : 1", 2), ("1.13 : 1", 2), ("1 : 1", 1)] {
        assert_eq!(texts.iter().filter(|text| *text == said).count(), count);
    }
    for angle in ["40°", "80°", "120°"] {
        has(&texts, angle);
    }
}

#[test]
fn the_sums_over_the_bars_of_terms_are_the_colours_of_the_pixels() {
    let (traced, texts) = drawn("05-shading/terms");
    let records = &traced[0].records;
    let colours = all(records, |record| match record.event {
        Event::PixelColour(colour) => Some(colour.raw.x),
        _ => None,
    });
    // six pixels, and the one that ends the log
    assert_eq!(colours.len(), 7);
    let ends = [400, 0];
    let drawn = all(records, |record| match record.event {
        Event::PixelColour(colour) if record.pixel != Some(ends) => Some(colour.raw.x),
        _ => None,
    });
    for colour in drawn {
        let sum = digits(colour, 3);
        assert!(texts.contains(&sum), "{sum}: {texts:?}");
    }
    // θ of each is the arc cosine of N·L of the points
    let angles = all(records, |record| match record.event {
        Event::LightTerm(term) => Some(term.term.n_dot_l.acos().to_degrees()),
        _ => None,
    });
    assert!(angles.iter().any(|angle| 90.0 < *angle));
    for angle in angles {
        has(&texts, &format!("{angle:.0}°"));
    }
}

#[test]
fn a_normal_is_turned_where_the_ray_comes_from_the_other_side() {
    let (traced, texts) = drawn("05-shading/sides");
    let scene = &traced[0].scene;
    let records = &traced[0].records;
    let rays = all(records, |record| match record.event {
        Event::Ray(start) => Some((record.pixel, record.ray, start.ray.direction)),
        _ => None,
    });
    let mut backs = 0;
    for record in records {
        let Event::Shade(shade) = record.event else {
            continue;
        };
        let of_ray =
            |(pixel, ray, _): &&(_, _, DVec3)| (*pixel, *ray) == (record.pixel, record.ray);
        let (.., direction) = rays.iter().find(of_ray).unwrap();
        // the outward normal by the scene: (p − c)/r of the ball at (0, 2.5, 2), whose radius is 1
        let own = match scene.name_of(shade.object).0 {
            "A" => shade.point - DVec3::new(0.0, 2.5, 2.0),
            // (1.6, 0, 0) × (0, 1, −0.6): up and towards the eye, and for C the other way round
            "B" => DVec3::new(0.0, 0.6, 1.0).normalize(),
            _ => -DVec3::new(0.0, 0.6, 1.0).normalize(),
        };
        let cosine = direction.dot(own);
        assert_eq!(shade.back, 0.0 < cosine);
        has(&texts, &digits(cosine, 4));
        backs += u32::from(shade.back);
    }
    assert_eq!(backs, 2);
}

#[test]
fn the_root_that_is_the_surface_itself_is_the_quotient_of_c_and_b() {
    let (traced, texts) = drawn("05-shading/epsilon");
    let mut found = Vec::new();
    for record in &traced[0].records {
        let Event::SphereTest { test, .. } = record.event else {
            continue;
        };
        let QuadraticTest { b, c, .. } = test;
        // next to 0 the square does not count: b·t + c = 0
        let t = -c / b;
        if t.abs() < 1e-12 {
            found.push(t);
        }
    }
    assert_eq!(found.len(), 4, "{found:?}");
    assert_eq!(found.iter().filter(|t| 0.0 < **t).count(), 2);
    for t in found {
        let written = format!("{:.1e}", t.abs());
        let (number, power) = written.split_once('e').unwrap();
        let sign = if t < 0.0 { "−" } else { "" };
        has(
            &texts,
            &format!("{sign}{number}·10{}", power.replace('-', "−")),
        );
    }
}

#[test]
fn the_weights_of_the_ray_tree_and_its_colours_add_up_to_the_pixel() {
    let (traced, texts) = drawn("07-reflection-refraction/ray-tree");
    let of_pixel = Some([20, 15]);
    let records: Vec<Record> = traced[0]
        .records
        .iter()
        .copied()
        .filter(|record| record.pixel == of_pixel)
        .collect();
    let colour_of = |ray: u32| {
        let ends = all(&records, |record| match record.event {
            Event::RayEnd(end) if record.ray == Some(ray) => end.colour,
            _ => None,
        });
        ends[0]
    };
    let shade = all(&records, |record| match record.event {
        Event::Shade(shade) if record.ray == Some(0) => Some(shade),
        _ => None,
    })[0];
    // the water reflects 0.3 and lets 0.6 through
    let sum = shade.ambient + shade.direct + 0.3 * colour_of(2) + 0.6 * colour_of(4);
    assert!((sum - colour_of(0)).length() < 1e-12);
    let [r, g, b] = sum.to_array().map(|of| digits(of, 4));
    has(&texts, &format!("= ({r}, {g}, {b})"));
    for part in ["× 0.3", "× 0.6", "5 shadow", "blocked", "hits A", "hits B"] {
        has(&texts, part);
    }
}

#[test]
fn dropping_another_axis_brings_p_closer_to_an_edge() {
    let (traced, texts) = drawn("06-polygon/badly-chosen");
    let records = &traced[0].records;
    let p = all(records, |record| match record.event {
        Event::PolygonTest { test, .. } => Some(test.point),
        _ => None,
    })[0];
    let corners = [
        [1.0, 2.53, 1.2],
        [3.4, 3.17, 0.8],
        [4.6, 3.38, 1.7],
        [3.4, 2.85, 4.0],
        [1.4, 2.41, 3.4],
    ];
    // twice the area of the triangle over an edge, by the edge's length, in the plane of two axes
    let distance = |[u, v]: [usize; 2]| {
        let at = |point: [f64; 3]| glam::DVec2::new(point[u], point[v]);
        let p = at(p.to_array());
        let edges = (0..5).map(|i| [at(corners[i]), at(corners[(i + 1) % 5])]);
        let distances = edges.map(|[a, b]| ((b - a).perp_dot(p - a) / (b - a).length()).abs());
        distances.fold(f64::INFINITY, f64::min)
    };
    for axes in [[0, 2], [0, 1]] {
        let near = distance(axes);
        let decimals = if near < 1.0 { 4 } else { 3 };
        has(
            &texts,
            &format!("is {} from an edge", digits(near, decimals)),
        );
    }
}

#[test]
fn a_picture_with_mirrors_says_what_they_show() {
    let (_, texts) = drawn("07-reflection-refraction/image-with-reflections");
    assert!(texts.contains(&"1: mirror shows A".into()), "{texts:?}");
    assert!(texts.contains(&"2: floor shows A".into()), "{texts:?}");
}
