//! Every figure of every lesson: well-formed, legible, and the same from its log.

use std::collections::HashSet;
use std::io::Cursor;
use std::path::Path;
use std::sync::OnceLock;
use std::time::Duration;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use raystep::explain::{Compared, grouped};
use raystep::figure::{UpTo, draw, text_width};
use raystep::lesson::{compare, compare_transports, lesson_schema, light_of_lamps};
use raystep::tracer::trace_pixel;
use raystep::{
    Chosen, Counts, Event, FigureName, FigureSpec, Library, Record, Recorder, Rendition, Through,
    Traced, Tracer, Transport, Width, render_picture,
};
use roxmltree::{Document, Node};

/// What a figure is named by in its ids here.
const ID: &str = "raystep-test";

pub(crate) fn library() -> Library {
    raystep::open_lessons(&Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons")).unwrap()
}

/// Each figure with its trace, made once for all tests.
pub(crate) fn traced() -> &'static [(FigureName, FigureSpec, Vec<Traced>)] {
    static TRACED: OnceLock<Vec<(FigureName, FigureSpec, Vec<Traced>)>> = OnceLock::new();
    TRACED.get_or_init(|| {
        let library = library();
        let figures = library.figures();
        let trace = |name: FigureName| {
            let (lesson, spec) = library.find(&name).unwrap();
            let traced = lesson.trace(&name.figure, spec);
            let traced = traced.unwrap_or_else(|error| panic!("{name}: {error}"));
            (name, spec.clone(), traced)
        };
        figures.into_iter().map(trace).collect()
    })
}

/// One of them by its name.
pub(crate) fn figure(name: &str) -> (&'static FigureSpec, &'static [Traced]) {
    let found = traced().iter().find(|(of, ..)| of.to_string() == name);
    let (_, spec, traced) = found.unwrap_or_else(|| panic!("there is no figure {name}"));
    (spec, traced)
}

/// The letters of a figure in a book.
pub(crate) fn texts_of_drawn(spec: &FigureSpec, traced: &[Traced]) -> Vec<String> {
    let drawn = draw(spec, traced, ID, Width::Book, Rendition::default());
    texts_of(&drawn.unwrap().svg)
}

/// Both widths, and what is written differently.
fn ways() -> Vec<(Width, Rendition)> {
    let usual = Rendition::default();
    vec![
        (Width::Book, usual),
        (Width::Slide, usual),
        (
            Width::Book,
            Rendition {
                standalone: true,
                ..usual
            },
        ),
        (
            Width::Slide,
            Rendition {
                grayscale: true,
                ..usual
            },
        ),
    ]
}

#[test]
fn every_figure_is_well_formed_and_legible() {
    let mut checked = 0;
    for (name, spec, traced) in traced() {
        for (width, rendition) in ways() {
            let drawn = draw(spec, traced, ID, width, rendition);
            let drawn = drawn.unwrap_or_else(|error| panic!("{name}: {error}"));
            check_svg(&format!("{name} {width:?}"), &drawn.svg);
            checked += 1;
        }
    }
    assert!(0 < checked);
}

#[test]
fn a_books_sheet_is_760_wide_and_as_high_as_what_is_drawn_at_every_step() {
    for (name, spec, traced) in traced() {
        let drawn = |width, up_to| {
            let rendition = Rendition {
                up_to,
                ..Rendition::default()
            };
            draw(spec, traced, ID, width, rendition).unwrap()
        };
        let size = |svg: &str| {
            let document = Document::parse(svg).unwrap();
            view_box(&document.root_element())
        };
        let whole = drawn(Width::Book, None);
        let shown = size(&whole.svg);
        assert_eq!((shown[0], shown[2]), (0.0, 760.0), "{name}");
        let first = whole.steps.first().copied().map(UpTo::Step);
        assert_eq!(size(&drawn(Width::Book, first).svg), shown, "{name}");
        let slide = drawn(Width::Slide, None);
        assert_eq!(size(&slide.svg), [0.0, 0.0, 1280.0, 720.0], "{name}");

        // the highest and the lowest point that is drawn, by what the file says, are a letter of 14 from the edges
        let document = Document::parse(&whole.svg).unwrap();
        let mut heights = Vec::new();
        for node in document.descendants().filter(Node::is_element) {
            let number = |key| node.attribute(key).and_then(|of| of.parse::<f64>().ok());
            match node.tag_name().name() {
                "text" => {
                    let [_, top, _, bottom] = letters_box(&document.root_element(), &node);
                    heights.extend([top, bottom]);
                }
                // the ground is as wide as the sheet
                "rect" if number("width") == Some(760.0) => {}
                "rect" | "image" => {
                    let y = number("y").unwrap_or_else(|| f64::midpoint(shown[1], shown[3]));
                    heights.extend([y, y + number("height").unwrap()]);
                }
                "circle" => {
                    let (y, r) = (number("cy").unwrap(), number("r").unwrap());
                    heights.extend([y - r, y + r]);
                }
                "path" => {
                    let data = node.attribute("d").unwrap().trim_end_matches('Z');
                    let points = data.split(['M', 'L']).filter(|of| !of.is_empty());
                    heights.extend(points.map(|point| {
                        let (_, y) = point.split_once(' ').unwrap();
                        y.parse::<f64>().unwrap()
                    }));
                }
                _ => {}
            }
        }
        let least = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let most = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let margins = [least - shown[1], shown[1] + shown[3] - most];
        for margin in margins {
            // halves of lines, ellipses and the room for accents are in the margin too
            assert!((0.0..=14.0 + 12.0).contains(&margin), "{name}: {margins:?}");
        }
    }
}

#[test]
fn no_figure_of_the_course_has_more_than_80_kb() {
    for (name, spec, traced) in traced() {
        let drawn = draw(spec, traced, ID, Width::Book, Rendition::default()).unwrap();
        let size = drawn.svg.len();
        assert!(size <= 80_000, "{name}: {size} bytes");
    }
}

#[test]
fn a_saved_log_gives_the_same_bytes() {
    for (name, spec, traced) in traced() {
        let grey = Rendition {
            grayscale: true,
            ..Rendition::default()
        };
        let drawn = |traced: &[Traced]| {
            [Rendition::default(), grey].map(|rendition| {
                let drawn = draw(spec, traced, ID, Width::Book, rendition);
                drawn.unwrap_or_else(|error| panic!("{name}: {error}"))
            })
        };
        let mut log = Vec::new();
        for traced in traced {
            traced.write(&mut log).unwrap();
        }
        let read = Traced::read("log", &log[..]).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(drawn(&read), drawn(traced), "{name}");
    }
}

#[test]
fn a_figure_up_to_its_last_step_is_the_whole_figure_and_each_step_adds_something() {
    for (name, spec, traced) in traced() {
        if spec.step.is_some() {
            continue;
        }
        let drawn = |up_to: Option<u32>| {
            let rendition = Rendition {
                up_to: up_to.map(UpTo::Step),
                ..Rendition::default()
            };
            draw(spec, traced, ID, Width::Book, rendition).unwrap()
        };
        let whole = drawn(None);
        assert_eq!(drawn(whole.steps.last().copied()).svg, whole.svg, "{name}");
        let mut length = 0;
        // a dozen of many
        let some = whole.steps.len().div_ceil(12).max(1);
        for step in whole.steps.iter().step_by(some) {
            let svg = drawn(Some(*step)).svg;
            assert!(length < svg.len(), "{name}, step {step}");
            length = svg.len();
        }
    }
}

/// The groups of a drawing: the stage and the step since which each is there, and its elements.
fn groups_of<'a>(document: &'a Document) -> Vec<(Option<u32>, Option<u32>, Node<'a, 'a>)> {
    let groups = document.root_element().children();
    let groups = groups.filter(|node| node.has_tag_name("g"));
    let number = |node: &Node, key: &str| Some(node.attribute(key)?.parse().unwrap());
    let group = |node: Node<'a, 'a>| {
        (
            number(&node, "data-stage"),
            number(&node, "data-step"),
            node,
        )
    };
    groups.map(group).collect()
}

#[test]
fn every_figure_argues_in_a_few_stages_that_tell_no_later_step() {
    let mut all = 0;
    for (name, spec, traced) in traced() {
        let draw_it = |up_to| {
            let rendition = Rendition {
                up_to,
                ..Rendition::default()
            };
            draw(spec, traced, ID, Width::Book, rendition).unwrap()
        };
        let whole = draw_it(None);
        let count = whole.stages.len();
        assert!((1..=12).contains(&count), "{name}: {count} stages");
        let mut before = None;
        for stage in &whole.stages {
            assert!(!stage.name.is_empty(), "{name}");
            let sentence = stage.sentence.as_str();
            assert!(
                sentence.ends_with('.') && !sentence.contains('\n'),
                "{name}: {sentence}"
            );
            // the steps that the stages need do not fall
            assert!(before <= stage.step, "{name}: {sentence}");
            before = stage.step;
        }
        // what belongs to a stage is made by no later step than the stage needs
        let document = Document::parse(&whole.svg).unwrap();
        for (stage, step, _) in groups_of(&document) {
            let Some(stage) = stage else { continue };
            let needs = whole.stages[stage as usize - 1].step;
            assert!(
                step <= needs,
                "{name}: step {step:?} in stage {stage}, which needs {needs:?}"
            );
        }
        // each stage tells more than the one before, and the last one is the whole
        let mut last = String::new();
        for stage in 1..=count as u32 {
            let drawn = draw_it(Some(UpTo::Stage(stage)));
            assert!(!drawn.description.is_empty(), "{name}");
            let shown = drawn.svg.split_once("<g").unwrap().1.to_owned();
            assert!(
                last.len() < shown.len() || count == 1,
                "{name}: nothing new at stage {stage}"
            );
            last = shown;
            all += 1;
        }
        let shown = whole.svg.split_once("<g").unwrap().1;
        if spec.step.is_none() {
            assert_eq!(last, shown, "{name}: the last stage is not the whole");
        }
    }
    // hundreds of stages, not thousands
    assert!((150..700).contains(&all), "{all}");
}

#[test]
fn the_colour_of_the_answer_comes_in_no_first_stage() {
    for (name, spec, traced) in traced() {
        let whole = draw(spec, traced, ID, Width::Book, Rendition::default()).unwrap();
        if whole.stages.len() < 3 {
            continue;
        }
        let document = Document::parse(&whole.svg).unwrap();
        let early = groups_of(&document)
            .into_iter()
            .filter(|(stage, ..)| stage.is_none_or(|stage| stage == 1));
        for (.., group) in early {
            let coloured = group.descendants().find(|node| {
                let class = node.attribute("class").unwrap_or_default();
                // a legend may say what the colour means
                class.contains("_answer-") && !class.contains("_answer-area")
            });
            assert!(coloured.is_none(), "{name}: {coloured:?}");
        }
    }
}

#[test]
fn no_figure_is_larger_than_80_kb() {
    for (name, spec, traced) in traced() {
        for (width, rendition) in ways() {
            let drawn = draw(spec, traced, ID, width, rendition).unwrap();
            let kilobytes = drawn.svg.len() as f64 / 1000.0;
            assert!(kilobytes <= 80.0, "{name} {width:?}: {kilobytes} kB");
        }
    }
}

#[test]
fn every_kind_of_figure_is_in_a_lesson() {
    let schema = lesson_schema();
    let kinds = schema["$defs"]["FigureKind"]["oneOf"].as_array().unwrap();
    let kinds: HashSet<&str> = kinds
        .iter()
        .map(|of| of["const"].as_str().unwrap())
        .collect();
    assert!(20 <= kinds.len(), "{kinds:?}");
    let library = library();
    let figures = library
        .lessons
        .iter()
        .flat_map(|lesson| lesson.content.figures.values());
    let drawn = figures.map(|spec| serde_json::to_value(spec.kind).unwrap());
    let drawn: HashSet<String> = drawn.map(|kind| kind.as_str().unwrap().into()).collect();
    let missing: Vec<_> = kinds
        .iter()
        .filter(|kind| !drawn.contains(**kind))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn every_lesson_is_as_its_schema_says() {
    let schema = jsonschema::validator_for(&lesson_schema()).unwrap();
    for lesson in library().lessons {
        let content = serde_json::to_value(&lesson.content).unwrap();
        assert!(schema.is_valid(&content), "{}", lesson.name);
    }
    let wrong =
        serde_json::json!({ "title": "t", "figures": { "f": { "kind": "ball", "scene": "s" } } });
    assert!(!schema.is_valid(&wrong));
}

#[test]
fn the_printed_figures_have_their_labels() {
    for (name, labels) in [
        // Fig. 15.57: the polygon, the ray's point p, p′ on a coordinate plane
        ("06-polygon/inside", &["R", "p", "p′", "x", "y", "z"][..]),
        // Fig. 15.58: four slabs of two planes each; two bounds and the bound of both
        (
            "10-bounds/slabs",
            &[
                "D_min of n₀",
                "D_max of n₀",
                "D_min of n₁",
                "D_max of n₁",
                "D_min of n₂",
                "D_max of n₂",
                "D_min of n₃",
                "D_max of n₃",
            ],
        ),
        (
            "10-bounds/merge",
            &["A", "B", "D_min: minimum", "D_max: maximum"],
        ),
        // Fig. 15.61: cells along x, y and z
        (
            "12-grid/partition",
            &["5 cells along x", "3 cells along y", "4 cells along z"],
        ),
        // Fig. 15.62: ray R and the objects that it is tested against, no other
        ("12-grid/walk", &["R", "A", "B", "C"]),
    ] {
        let (spec, traced) = figure(name);
        let svg = draw(spec, traced, ID, Width::Book, Rendition::default())
            .unwrap()
            .svg;
        let texts = texts_of(&svg);
        let has = |label: &str| texts.iter().any(|text| on_line(text) == on_line(label));
        for label in labels {
            assert!(has(label), "{name}: no {label} among {texts:?}");
        }
        if name == "12-grid/walk" {
            for other in ["D", "E", "F"] {
                assert!(!has(other), "{name}: {other} is not tested");
            }
        }
    }
}

/// The texts of a drawing, each with the letters of its indices among the others.
pub(crate) fn texts_of(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).unwrap();
    let texts = document
        .descendants()
        .filter(|node| node.has_tag_name("text"));
    texts.map(letters_of).collect()
}

/// A text with its indices and exponents on the line, as the letters of a drawing are read.
fn on_line(text: &str) -> String {
    const RAISED: &str = "₀₁₂₃₄₅₆₇₈₉⁰¹²³⁴⁵⁶⁷⁸⁹";
    let digit = |letter: char| {
        let place = RAISED.chars().position(|of| of == letter)?;
        char::from_digit(place as u32 % 10, 10)
    };
    let letters = text.chars().filter(|letter| *letter != '_');
    letters
        .map(|letter| digit(letter).unwrap_or(letter))
        .collect()
}

/// The letters of an element and all inside.
fn letters_of(node: Node) -> String {
    let inside = node.descendants().filter(Node::is_text);
    inside.filter_map(|node| node.text()).collect()
}

/// The letters of a figure, and the events that it was drawn from.
fn of_light(name: &str) -> (Vec<String>, &'static [Record]) {
    let (spec, traced) = figure(&format!("08-transport/{name}"));
    let drawn = draw(spec, traced, ID, Width::Book, Rendition::default()).unwrap();
    (texts_of(&drawn.svg), &traced[0].records)
}

#[track_caller]
fn check_text(texts: &[String], part: &str) {
    let has = texts
        .iter()
        .any(|text| on_line(text).contains(&on_line(part)));
    assert!(has, "no {part:?} among {texts:?}");
}

#[test]
fn forward_tracing_counts_the_paths_that_reach_the_eye_and_the_wasted_ones() {
    let (texts, records) = of_light("forward");
    let shown: HashSet<u32> = records.iter().filter_map(|record| record.path).collect();
    let arrived: HashSet<u32> = records
        .iter()
        .filter(|record| matches!(record.event, Event::Arrival(_)))
        .filter_map(|record| record.path)
        .collect();
    assert!(!arrived.is_empty() && arrived.len() < shown.len());
    // the figure's specification asks for the first 30; the others arrive at its pixels
    let sought = shown.iter().filter(|path| **path >= 30).count();
    assert_eq!(shown.len(), 30 + sought);
    // all that were sought out arrive, and none of the first
    assert_eq!(arrived.len(), sought);
    // 4 of 100 000, as `render --stats` says
    assert_eq!(sought, 4);
    check_text(&texts, "The first 30 of 100 000 paths of light");
    check_text(
        &texts,
        "4 of all 100 000 reach the eye, and are drawn too: 99.996 % are wasted",
    );
    for label in ["aperture", "window", "COP", "lamp"] {
        check_text(&texts, label);
    }
}

#[test]
fn the_density_of_photons_is_that_of_the_gathered_event() {
    let (texts, records) = of_light("gather");
    let gathered = records.iter().find_map(|record| match record.event {
        Event::Gathered(gathered) => Some(gathered),
        _ => None,
    });
    let gathered = gathered.unwrap();
    let radius = gathered.radius.unwrap();
    assert_eq!(gathered.count, 19);
    check_text(&texts, "number 20 sets r, and the 19 before it are summed");
    check_text(&texts, &format!("r = {radius:.4}"));
    // all photons are white: 19 of 100 W / 3000 each, over the disc
    let density = 19.0 * 100.0 / 3000.0 / (std::f64::consts::PI * radius * radius);
    assert!((gathered.irradiance.x / density - 1.0).abs() < 1e-9);
    check_text(&texts, &format!("= {density:.4} W/m²"));
}

#[test]
fn connecting_lines_join_named_vertices_and_one_has_its_geometry_term() {
    let (texts, records) = of_light("hybrid-connected");
    for label in ["x₀", "x₁", "x₂", "y₀", "y₁", "y₂", "G", "blocked"] {
        check_text(&texts, label);
    }
    let line = records.iter().find_map(|record| match record.event {
        Event::Connection(of) if (of.light_vertex, of.eye_vertex) == (1, 1) => Some(of),
        _ => None,
    });
    let line = line.unwrap();
    assert!(line.visible);
    let distance = line.from.distance(line.to);
    let geometry = line.cosines[0] * line.cosines[1] / (distance * distance);
    check_text(&texts, &format!("= {geometry:.5}"));
    check_text(&texts, "G(x₁, y₁) = cos θ · cos θ′ / d²");
}

#[test]
fn the_paths_of_a_caustic_have_all_come_through_the_ball() {
    let (texts, records) = of_light("caustic");
    let shown: HashSet<u32> = records.iter().filter_map(|record| record.path).collect();
    let refracted: HashSet<u32> = records
        .iter()
        .filter(|record| matches!(record.event, Event::Refraction(_)))
        .filter_map(|record| record.path)
        .collect();
    assert_eq!(refracted, shown);
    check_text(&texts, "E = 17 · 0.03333 W");
}

/// The texts of a figure of a lesson, in a book.
fn texts_of_figure(name: &str) -> Vec<String> {
    let (spec, traced) = figure(name);
    let drawn = draw(spec, traced, ID, Width::Book, Rendition::default()).unwrap();
    texts_of(&drawn.svg)
}

#[test]
fn the_slides_sum_is_exact_and_the_others_are_measured() {
    let (spec, traced) = figure("09-cost/sum");
    let texts = texts_of_figure("09-cost/sum");
    // 1024² · 100
    check_text(
        &texts,
        "1024 × 1024 pixels × 100 objects = 104 857 600 tests",
    );
    check_text(&texts, "104 857 600");
    let totals = traced.iter().map(|of| of.of_pixels.totals.unwrap());
    let totals: Vec<_> = totals.collect();
    // each eighth pixel both ways: 128 · 128 of them
    assert!(totals.iter().all(|of| (of.every, of.pixels) == (8, 16_384)));
    assert_eq!(64 * totals[0].objects, 104_857_600);
    // by another way: the same rays with one strategy after the other
    for (of, totals) in traced.iter().zip(&totals) {
        let strategy = of.settings.strategy;
        let chosen = Chosen::new(&of.scene, strategy, &of.settings.structure).unwrap();
        let tracer = Tracer::new(&of.scene, &chosen, Transport::Backward);
        let mut counts = Counts::default();
        for y in (0..1024).step_by(16) {
            for x in (0..1024).step_by(16) {
                trace_pixel(&tracer, [x, y], Through::Centres, &mut counts).unwrap();
            }
        }
        // a quarter of them says the same, but for chance
        let few = counts.objects_tested()
            + counts.search.bounds.tests
            + counts.search.entered
            + counts.search.cells;
        let all = totals.objects + totals.nodes + totals.cells;
        let ratio = 4.0 * few as f64 / all as f64;
        assert!((0.9..1.1).contains(&ratio), "{strategy:?}: {ratio}");
    }
    assert_eq!(spec.every, Some(8));
}

#[test]
fn the_rays_of_the_five_kinds_are_those_that_compare_counts() {
    let (_, traced) = figure("08-transport/five");
    let scene = light_of_lamps(traced[0].scene.clone());
    let clock = || Duration::ZERO;
    let compared =
        compare_transports(&scene, &traced[0].settings, 1_000_000, clock, |_| {}).unwrap();
    let texts = texts_of_figure("08-transport/five");
    for of in traced {
        let transport = of.settings.transport;
        let same = |cost: &&raystep::explain::TransportCost| cost.settings.transport == transport;
        let rays = &compared.compared.iter().find(same).unwrap().rays;
        let totals = of.of_pixels.totals.unwrap();
        assert_eq!(
            (totals.cast, totals.contributed),
            (rays.cast, rays.contributed()),
            "{transport:?}"
        );
        check_text(&texts, &format!("{} rays cast", grouped(rays.cast)));
    }
    // of each path of forward ray tracing none or few legs are seen
    check_text(&texts, "99.97");
}

#[test]
fn line_drawing_skips_the_cell_with_the_hit_and_the_walk_does_not() {
    // z = 3.5 − 0.55 x through cells of side 1: the middles of the columns lie in rows 3, 2, 2, 1, 1, 0;
    // the planes z = 3, 2 and 1 are crossed at x = 0.91, 2.73 and 4.55, so that three more cells have a part of the ray
    let texts = texts_of_figure("12-grid/line-drawing");
    check_text(&texts, "line drawing: 6 cells, one in each column");
    // it ends with the hit in the cell before the last
    check_text(&texts, "grid walk: 8 cells, all on the ray");
    let (spec, traced) = figure("12-grid/line-drawing");
    let drawn = draw(spec, traced, ID, Width::Book, Rendition::default()).unwrap();
    for sentence in [
        "It skips [0, 0, 2], [2, 0, 1], [4, 0, 0], which the ray passes through.",
        "Cell [4, 0, 0] holds the hit with A at t = ",
    ] {
        assert!(
            drawn.description.contains(sentence),
            "{}",
            drawn.description
        );
    }
}

#[test]
fn a_grid_between_too_coarse_and_too_fine_takes_the_fewest_steps() {
    let (_, traced) = figure("12-grid/resolutions");
    let sums: Vec<u64> = traced
        .iter()
        .map(|of| {
            let mut counts = Counts::default();
            for record in of
                .records
                .iter()
                .filter(|record| record.pixel == Some([12, 8]) && record.ray == Some(0))
            {
                counts.note(|| record.event);
            }
            counts.search.cells + counts.objects_tested()
        })
        .collect();
    let [coarse, right, fine] = sums[..] else {
        panic!("{sums:?}")
    };
    assert!(right < coarse && right < fine, "{sums:?}");
    let texts = texts_of_figure("12-grid/resolutions");
    for sum in sums {
        check_text(&texts, &format!("= {sum}"));
    }
}

#[test]
fn eight_objects_are_joined_seven_times_and_a_grid_of_6_by_5_has_30_cells() {
    let (spec, traced) = figure("11-hierarchy/building");
    let drawn = draw(spec, traced, ID, Width::Book, Rendition::default()).unwrap();
    assert!(drawn.description.contains("one volume is around all"));
    assert!(drawn.description.contains(": 30 cells."));
    let texts = texts_of(&drawn.svg);
    for number in ["1", "7"] {
        check_text(&texts, number);
    }
    assert!(!texts.iter().any(|text| text == "8"), "{texts:?}");
}

#[test]
fn the_totals_of_a_heat_map_are_what_the_whole_picture_takes() {
    let (spec, traced) = figure("09-cost/heat");
    let texts_of = |spec: &FigureSpec, traced: &[Traced]| {
        let drawn = draw(spec, traced, ID, Width::Book, Rendition::default()).unwrap();
        texts_of(&drawn.svg)
    };
    let texts = texts_of(spec, traced);
    for of in traced {
        let strategy =
            Chosen::new(&of.scene, of.settings.strategy, &of.settings.structure).unwrap();
        let tracer = Tracer::new(&of.scene, &strategy, of.settings.transport);
        let mut counts = Counts::default();
        render_picture(&tracer, of.settings.through, Some(&mut counts), &|_| {}).unwrap();
        let tests = counts.objects_tested();
        let nodes = counts.search.bounds.tests + counts.search.entered;
        let cells = counts.search.cells;
        let total = tests + nodes + cells;
        check_text(&texts, &format!("{} tests in all", grouped(total)));
        check_text(&texts, &format!("{} object tests", grouped(tests)));
        for (count, what) in [(nodes, "bound tests and nodes"), (cells, "cells")] {
            if 0 < count {
                check_text(&texts, &format!("{} {what}", grouped(count)));
            }
        }
    }
    // one scale: its numbers stand once
    for tick in ["1", "2", "5", "10", "20", "50", "100", "200"] {
        assert_eq!(texts.iter().filter(|text| *text == tick).count(), 1);
    }

    // what `compare` counts of 48 × 48 pixels: 200 tests for most pixels without a structure
    let library = library();
    let name: FigureName = "09-cost/heat".parse().unwrap();
    let (lesson, _) = library.find(&name).unwrap();
    let mut small = spec.clone();
    small.size = Some([48, 48]);
    let traced = lesson.trace("heat", &small).unwrap();
    let texts = texts_of(&small, &traced);
    for text in [
        "290 550 tests in all",
        "1 648 object tests",
        // 33 402 bounds and 16 895 nodes
        "50 297 bound tests and nodes",
        "51 945 tests in all",
        "6 069 object tests",
        "5 529 cells",
        "11 598 tests in all",
    ] {
        check_text(&texts, text);
    }
}

#[test]
fn the_bars_of_costs_are_the_numbers_of_a_comparison() {
    let (spec, traced) = figure("09-cost/strategies");
    let drawn = draw(spec, traced, ID, Width::Book, Rendition::default()).unwrap();
    let texts = texts_of(&drawn.svg);
    let first = &traced[0];
    let compared = compare(
        &first.scene,
        &first.settings,
        spec.pixel,
        1_000_000,
        || Duration::ZERO,
        |_| {},
    );
    let compared = compared.unwrap().compared;
    for of in traced {
        let same = |one: &&Compared| {
            let settings = &one.settings;
            settings.strategy == of.settings.strategy && settings.structure == of.settings.structure
        };
        let found = compared.iter().find(same).unwrap();
        let cost = found.cost.as_ref().unwrap();
        let [tests, searched] = [cost.counts.objects_tested(), cost.searched()];
        let numbers = match searched {
            0 => grouped(tests),
            _ => [tests + searched, tests, searched].map(grouped).join(" "),
        };
        let at = texts.iter().position(|text| *text == found.name()).unwrap();
        let drawn = texts[at + 1].replace(" =", "").replace(" +", "");
        assert_eq!(drawn, numbers, "{}", found.name());
    }
}

#[test]
fn a_figure_that_follows_light_says_what_it_lacks() {
    let library = library();
    let name: FigureName = "08-transport/forward".parse().unwrap();
    let (lesson, spec) = library.find(&name).unwrap();
    let wrong = |change: &dyn Fn(&mut FigureSpec)| {
        let mut spec = spec.clone();
        change(&mut spec);
        lesson.trace("forward", &spec).unwrap_err().to_string()
    };
    let error = wrong(&|spec| spec.scene = "scene.json".into());
    assert!(error.contains("figures.forward.scene"), "{error}");
    assert!(error.contains("has a colour but no power"), "{error}");
    let error = wrong(&|spec| spec.light.paths = 0);
    assert!(error.contains("figures.forward.light"), "{error}");
    let error = wrong(&|spec| spec.light.aperture = Some(-1.0));
    assert!(error.contains("figures.forward.light"), "{error}");
    let error = wrong(&|spec| spec.paths = Some(1_000_000));
    assert!(error.contains("show from 1 to 10000"), "{error}");

    // and one that gathers nothing, or connects nothing
    for (figure, transport) in [
        ("gather", Transport::Forward),
        ("hybrid-connected", Transport::HybridStored),
    ] {
        let mut spec = lesson.content.figures[figure].clone();
        spec.transport = transport;
        let traced = lesson.trace(figure, &spec).unwrap();
        let drawn = draw(&spec, &traced, ID, Width::Book, Rendition::default());
        assert_eq!(drawn.unwrap_err().key, "pixel", "{figure}");
    }
}

/// A reference is a picture inside the drawing: a PNG that can be read, wide enough to be enlarged.
#[track_caller]
fn check_picture(place: &str, element: &str, uri: &str) {
    assert_eq!(element, "image", "{place}");
    let base64 = uri.strip_prefix("data:image/png;base64,");
    let base64 = base64.unwrap_or_else(|| panic!("{place}: a reference to something outside"));
    let png = BASE64.decode(base64).unwrap();
    let mut reader = png::Decoder::new(Cursor::new(png)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    assert!(256 <= reader.info().width, "{place}");
}

/// What every drawing must be.
#[track_caller]
pub(crate) fn check_svg(name: &str, svg: &str) {
    let document = Document::parse(svg).unwrap_or_else(|error| panic!("{name}: {error}"));
    let root = document.root_element();
    assert_eq!(root.attribute("role"), Some("img"), "{name}");
    assert!(
        !svg.trim_end().contains("\n\n"),
        "{name}: an empty line ends a block of HTML"
    );

    let mut ids = HashSet::new();
    for node in root.descendants().filter(Node::is_element) {
        if let Some(id) = node.attribute("id") {
            assert!(ids.insert(id.to_owned()), "{name}: the id {id} comes twice");
            assert!(id.starts_with(ID), "{name}: {id}");
        }
        for attribute in node.attributes() {
            let value = attribute.value();
            let place = format!("{name}: {}=\"{value}\"", attribute.name());
            if attribute.name() == "href" {
                check_picture(&place, node.tag_name().name(), value);
                continue;
            }
            let refers = value.contains("url(");
            assert!(!refers, "{place}: a reference breaks where ids are renamed");
            let numbers = [
                "x",
                "y",
                "width",
                "height",
                "cx",
                "cy",
                "r",
                "rx",
                "ry",
                "stroke-width",
            ];
            if numbers.contains(&attribute.name()) {
                let number: f64 = value.parse().unwrap_or_else(|_| panic!("{place}"));
                assert!(number.is_finite(), "{place}");
            }
            if attribute.name() == "d" {
                for number in value
                    .split(['M', 'L', 'Z', ' '])
                    .filter(|word| !word.is_empty())
                {
                    let number: f64 = number.parse().unwrap_or_else(|_| panic!("{place}"));
                    assert!(number.is_finite() && number.abs() < 1e5, "{place}");
                }
            }
        }
    }
    for part in ["title", "desc"] {
        let node = root.children().find(|node| node.has_tag_name(part));
        let text = node.and_then(|node| node.text()).unwrap_or_default();
        assert!(!text.trim().is_empty(), "{name}: no {part}");
        let id = node
            .and_then(|node| node.attribute("id"))
            .unwrap_or_default();
        let labelled = root.attribute("aria-labelledby").unwrap_or_default();
        assert!(labelled.split(' ').any(|of| of == id), "{name}: {part}");
    }

    let size = view_box(&root);
    let boxes: Vec<(String, [f64; 4])> = root
        .descendants()
        .filter(|node| node.has_tag_name("text"))
        .map(|node| (letters_of(node), letters_box(&root, &node)))
        .collect();
    for (i, (text, [left, top, right, bottom])) in boxes.iter().enumerate() {
        assert!(
            size[0] <= *left
                && size[1] <= *top
                && *right <= size[0] + size[2]
                && *bottom <= size[1] + size[3],
            "{name}: {text:?} leaves the view box: {left} {top} {right} {bottom}"
        );
        for (other, b) in &boxes[..i] {
            let apart = *right <= b[0] || b[2] <= *left || *bottom <= b[1] || b[3] <= *top;
            assert!(apart, "{name}: {text:?} lies over {other:?}");
        }
    }
}

/// Left, top, width and height of what is shown.
fn view_box(root: &Node) -> Vec<f64> {
    let numbers = root.attribute("viewBox").unwrap().split(' ');
    numbers.map(|number| number.parse().unwrap()).collect()
}

/// Left, top, right and bottom of a line of letters: from the height of a capital to a little below the line.
fn letters_box(root: &Node, node: &Node) -> [f64; 4] {
    let number = |node: &Node, key: &str| node.attribute(key).and_then(|of| of.parse::<f64>().ok());
    let size = number(node, "font-size")
        .or_else(|| number(root, "font-size"))
        .unwrap();
    // the letters that are set smaller stand in elements of their own
    let letters = node.descendants().filter(Node::is_text);
    let widths = letters.map(|letters| {
        let own = letters.parent().and_then(|set| number(&set, "font-size"));
        text_width(letters.text().unwrap_or_default()) * own.unwrap_or(size)
    });
    let width: f64 = widths.sum();
    let (x, y) = (number(node, "x").unwrap(), number(node, "y").unwrap());
    let left = match node.attribute("text-anchor") {
        Some("middle") => x - 0.5 * width,
        Some("end") => x - width,
        _ => x,
    };
    [left, y - 0.73 * size, left + width, y + 0.2 * size]
}
