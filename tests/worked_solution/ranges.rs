//! Which steps of the log the lines of a page tell: each event of the page belongs to the steps of some line, and to no
//! others.
//!
//! Counted again from the records, over the scenes of all lessons, with every strategy and every transport.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use raystep::explain::{Line, Part, Section, Tone, strategies_to_compare};
use raystep::scene::{Emission, Light};
use raystep::strategy::Strategy;
use raystep::trace::{Purpose, Region};
use raystep::tracer::{LightPass, paths_behind, trace_pixel};
use raystep::{
    Chosen, Event, Off, Page, Record, Recording, Scene, Settings, StrategyName, Through, Tracer,
    Transport, WorkedOptions, load, worked_solution,
};

/// A step by its section and its number: the building, then the paths by their numbers, then the pixel.
type Place = (u8, u32, u32);

/// Where an event is, by what its record says it belongs to.
fn place(record: &Record) -> Place {
    match (record.path, record.pixel) {
        (Some(path), _) => (1, path, record.step),
        (None, Some(_)) => (2, 0, record.step),
        (None, None) => (0, 0, record.step),
    }
}

/// The first and the last step of a line.
fn steps(line: &Line) -> Option<[Place; 2]> {
    let steps = line.steps?;
    Some([steps.first, steps.last].map(|at| match at.section {
        Section::Building => (0, 0, at.step),
        Section::Path(path) => (1, path, at.step),
        Section::Pixel => (2, 0, at.step),
    }))
}

/// What is wrong with the steps of a page, if anything is. `of_page` are the events that the page is about.
fn mistake(page: &Page, of_page: &[&Record]) -> Option<String> {
    let mut ranges = BTreeSet::new();
    let titled = page.lines.iter().skip(1);
    let titles = 1 + titled.take_while(|line| line.tone == Tone::Aside).count();
    for (number, line) in page.lines.iter().enumerate() {
        let is_free = number < titles || line.tone == Tone::Heading;
        match steps(line) {
            Some(_) if is_free => return Some(format!("has steps of its own: {line:?}")),
            None if !is_free => return Some(format!("tells no step: {line:?}")),
            Some([first, last]) if last < first => return Some(format!("backwards: {line:?}")),
            range => ranges.extend(range),
        }
    }
    // how many ranges hold each event
    let mut of_rays: BTreeMap<[Place; 2], BTreeSet<u32>> = BTreeMap::new();
    for record in of_page {
        let at = place(record);
        let holds = |range: &&[Place; 2]| range[0] <= at && at <= range[1];
        let mut holding = ranges.iter().filter(holds);
        let Some(range) = holding.next() else {
            return Some(format!("no line tells {record:?}"));
        };
        if holding.next().is_some() {
            return Some(format!("two ranges hold {record:?}"));
        }
        of_rays.entry(*range).or_default().extend(record.ray);
    }
    // a line about a ray tells an event of it
    page.lines.iter().find_map(|line| {
        let (ray, range) = (line.ray?, steps(line)?);
        let rays = of_rays.get(&range)?;
        (!rays.contains(&ray)).then(|| format!("is about another ray: {line:?}"))
    })
}

/// All that led to a pixel, the building first.
pub(crate) fn traced(scene: &Scene, settings: &Settings, pixel: [u32; 2]) -> Vec<Record> {
    let strategy = Chosen::new(scene, settings.strategy, &settings.structure).unwrap();
    let region = Region::pixel(pixel);
    let pass = LightPass::new(scene, &strategy, settings, Some(region), |Off| {}, |_| {}).unwrap();
    let tracer = Tracer::new(scene, &strategy, settings.transport).with_light(pass.as_ref());
    let mut recording = Recording::new(Vec::new());
    strategy.note_building(&mut recording);
    for path in paths_behind(&tracer, region, settings.through).unwrap() {
        tracer.trace_path(path, &mut recording).unwrap();
    }
    trace_pixel(&tracer, pixel, settings.through, &mut recording).unwrap();
    recording.into_sink()
}

/// The scenes of the lessons' figures, each with two pixels that its figures draw.
pub(crate) fn scenes() -> Vec<(String, Scene, Vec<[u32; 2]>)> {
    let lessons = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons");
    let library = raystep::open_lessons(&lessons).unwrap();
    let mut pixels: BTreeMap<String, BTreeSet<[u32; 2]>> = BTreeMap::new();
    for name in library.figures() {
        let (lesson, spec) = library.find(&name).unwrap();
        let scene = format!("{}/{}", lesson.name, spec.scene);
        pixels
            .entry(scene)
            .or_default()
            .extend(spec.traced_pixels());
    }
    let of_scene = |(name, drawn): (String, BTreeSet<[u32; 2]>)| {
        let scene = load(&lessons.join(&name)).unwrap().build().unwrap();
        let [width, height] = scene.camera.pixels;
        // figures may have a picture of another size
        let inside = drawn.into_iter().filter(|[x, y]| *x < width && *y < height);
        let mut pixels: Vec<_> = inside.take(2).collect();
        if pixels.is_empty() {
            pixels.push([width / 2, height / 2]);
        }
        (name, scene, pixels)
    };
    pixels.into_iter().map(of_scene).collect()
}

/// All strategies under rays from the eye, and the exhaustive one under light where lamps have a power; so few paths that
/// the whole test takes seconds.
pub(crate) fn all_settings(scene: &Scene) -> Vec<Settings> {
    let mut all = Vec::new();
    for transport in [Transport::Backward, Transport::HybridLight] {
        let settings = Settings {
            transport,
            ..Settings::default()
        };
        all.extend(strategies_to_compare(scene, &settings));
    }
    let is_lamp = |light: &Light| matches!(light.emission, Emission::Power(_));
    if !scene.lights.is_empty() && scene.lights.iter().all(is_lamp) {
        let of_light = [
            Transport::Forward,
            Transport::HybridStored,
            Transport::HybridConnected,
        ];
        for transport in of_light {
            let mut settings = Settings {
                transport,
                ..Settings::default()
            };
            settings.light.paths = 2000;
            settings.light.samples = 1;
            settings.light.nearest = 12;
            settings.light.aperture = Some(0.3);
            all.push(settings);
        }
    }
    all
}

/// The first line that begins a part without its words: its name, or one of the symbols that are its name.
///
/// A line begins a part if neither the line before nor a line about the same steps is of that part.
fn headless(page: &Page) -> Option<String> {
    let mut begun = BTreeSet::new();
    let mut before = None;
    for line in &page.lines {
        let goes_on = std::mem::replace(&mut before, line.part) == line.part;
        let Some(part) = line.part else {
            continue;
        };
        if !begun.insert((part, steps(line))) || goes_on {
            continue;
        }
        let words = line.text.trim_start_matches("→ ");
        let is_head = |name: &str| {
            let ends = |rest: &str| !rest.starts_with(char::is_alphanumeric);
            words.strip_prefix(name).is_some_and(ends)
        };
        let title = part.title();
        let names = [part.name(), &title].into_iter();
        let mut heads = names.chain(part.name().split(", "));
        let folded = matches!(line.tone, Tone::Folded(_));
        if !folded && !heads.any(is_head) {
            return Some(format!("{part}: {line:?}"));
        }
    }
    None
}

#[test]
fn each_event_of_a_page_belongs_to_the_steps_of_one_range() {
    let (mut pages, mut folds) = (0, 0);
    let mut transports = BTreeSet::new();
    let mut parts = BTreeSet::new();
    for (name, scene, pixels) in scenes() {
        for settings in all_settings(&scene) {
            for &pixel in &pixels {
                let records = traced(&scene, &settings, pixel);
                let of_page: Vec<&Record> = records.iter().collect();
                for all in [false, true] {
                    let options = WorkedOptions {
                        all,
                        ..WorkedOptions::default()
                    };
                    let page = worked_solution(&scene, &settings, &records, &options);
                    if let Some(wrong) = mistake(&page, &of_page) {
                        let Settings {
                            strategy,
                            transport,
                            ..
                        } = settings;
                        panic!("{name} {pixel:?} {strategy:?} {transport:?} all {all}: {wrong}");
                    }
                    assert_eq!(headless(&page), None, "{name} {pixel:?}");
                    parts.extend(page.lines.iter().filter_map(|line| line.part));
                    pages += 1;
                    let is_fold = |line: &&Line| matches!(line.tone, Tone::Folded(_));
                    folds += page.lines.iter().filter(is_fold).count();
                }
                transports.insert(format!("{:?}", settings.transport));
            }
        }
    }
    assert_eq!(transports.len(), 5, "{transports:?}");
    assert!(2000 < pages && 50 < folds, "{pages} pages, {folds} folds");
    // a photon that arrives is rare in so few paths: a scene with a wide aperture has some
    let scene = super::light::built(super::light::SCENE);
    let settings = super::light::settings(Transport::Forward);
    let records = super::light::records(&scene, &settings, [1, 1]);
    for all in [false, true] {
        let options = WorkedOptions {
            all,
            ..WorkedOptions::default()
        };
        let page = worked_solution(&scene, &settings, &records, &options);
        assert_eq!(headless(&page), None);
        parts.extend(page.lines.iter().filter_map(|line| line.part));
    }
    let never: Vec<_> = Part::ALL
        .iter()
        .filter(|part| !parts.contains(part))
        .collect();
    assert!(never.is_empty(), "{never:?}");
}

#[test]
fn a_page_of_one_ray_tells_the_events_of_this_ray_and_of_those_it_spawned() {
    let scene = super::scene();
    let records = super::records(&scene);
    let rays = 1 + records
        .iter()
        .filter_map(|record| record.ray)
        .max()
        .unwrap();
    for wanted in 0..rays {
        let mut below = BTreeSet::from([wanted]);
        for record in &records {
            if matches!(record.event, Event::Ray(_))
                && record.parent.is_some_and(|parent| below.contains(&parent))
            {
                below.extend(record.ray);
            }
        }
        let is_of_ray = |record: &&Record| record.ray.is_some_and(|ray| below.contains(&ray));
        let of_ray: Vec<&Record> = records.iter().filter(is_of_ray).collect();
        let options = WorkedOptions {
            ray: Some(wanted),
            ..WorkedOptions::default()
        };
        let page = worked_solution(&scene, &Settings::default(), &records, &options);
        assert_eq!(mistake(&page, &of_ray), None);
    }
}

/// The steps of the first line that begins with some words.
#[track_caller]
fn told(page: &Page, words: &str) -> Option<[u32; 2]> {
    let line = page.lines.iter().find(|line| line.text.starts_with(words));
    let steps = line.unwrap_or_else(|| panic!("no {words}")).steps?;
    Some([steps.first.step, steps.last.step])
}

/// The pixel's events, counted by hand: 0 its point on the window, 1 the eye ray, 2 to 6 its tests (M is the nearest, 3;
/// the wall has a plane only), 7 and 8 the ray to the lamp and onwards.
#[test]
fn the_lines_of_the_paper_pixel_tell_the_steps_that_are_counted_by_hand() {
    let scene = super::scene();
    let records = super::records(&scene);
    let kinds: Vec<_> = records
        .iter()
        .take(7)
        .map(|r| r.event.kind().name())
        .collect();
    let by_hand = [
        "pixel",
        "ray",
        "sphere_test",
        "nearest",
        "sphere_test",
        "plane_test",
        "sphere_test",
    ];
    assert_eq!(kinds, by_hand);
    let options = WorkedOptions::default();
    let page = worked_solution(&scene, &Settings::default(), &records, &options);
    assert_eq!(told(&page, "P = corner"), Some([0, 0]));
    assert_eq!(told(&page, "direction: P − COP"), Some([1, 1]));
    assert_eq!(told(&page, "a = Δ·Δ"), Some([2, 2]));
    assert_eq!(told(&page, "→ nearest hit so far"), Some([3, 3]));
    assert_eq!(told(&page, "ball: sphere"), None);
    assert_eq!(
        told(&page, "t: none, the denominator of (v) is 0"),
        Some([5, 5])
    );
    // the point that the ray meets is in its shade, which comes after the shadow ray
    let shade = |record: &&Record| matches!(record.event, Event::Shade(_)) && record.ray == Some(0);
    let shade = records.iter().find(shade).unwrap().step;
    assert_eq!(told(&page, "p = o + t·Δ"), Some([shade, shade]));
    let last = records.last().unwrap().step;
    assert_eq!(told(&page, "from the eye ray"), Some([last, last]));
}

/// `listed` has no words: it belongs to the test that it introduces. The end of a ray whose photon says it all belongs to
/// the photon.
#[test]
fn an_event_without_words_is_told_with_the_step_it_belongs_to() {
    let scene = super::scene();
    let settings = Settings {
        strategy: StrategyName::Grid,
        ..Settings::default()
    };
    let records = traced(&scene, &settings, [0, 0]);
    let page = worked_solution(&scene, &settings, &records, &WorkedOptions::default());
    // the first sphere that is hit is the first that is worked out in full
    let introduces = |pair: &&[Record]| {
        let hits = matches!(pair[1].event, Event::SphereTest { .. });
        matches!(pair[0].event, Event::Listed { .. })
            && hits
            && pair[1].event.test_hits() == Some(true)
    };
    let pair = records.windows(2).find(introduces).unwrap();
    let both = [pair[0].step, pair[1].step];
    assert_eq!(told(&page, "a = Δ·Δ"), Some(both));

    let scene = super::light::built(super::light::GLASS);
    let settings = super::light::settings(Transport::HybridConnected);
    let records = traced(&scene, &settings, [3, 2]);
    let options = WorkedOptions {
        all: true,
        ..WorkedOptions::default()
    };
    let page = worked_solution(&scene, &settings, &records, &options);
    let own = records.iter().filter(|record| record.pixel.is_some());
    let own: Vec<&Record> = own.collect();
    let photon = |pair: &&[&Record]| {
        let is_end = matches!(pair[1].event, Event::RayEnd(_));
        matches!(pair[0].event, Event::Photon(_)) && is_end
    };
    let pair = own.windows(2).find(photon).unwrap();
    let tells = |line: &&Line| {
        let steps = line
            .steps
            .filter(|steps| steps.first.section == Section::Pixel);
        steps.is_some_and(|steps| steps.last.step == pair[1].step)
    };
    let line = page.lines.iter().find(tells).unwrap();
    assert!(line.text.starts_with("→ point: the path hits"), "{line:?}");
}

#[test]
fn a_line_that_lost_its_steps_or_took_anothers_is_noticed() {
    let scene = super::scene();
    let records = super::records(&scene);
    let of_page: Vec<&Record> = records.iter().collect();
    let options = WorkedOptions::default();
    let page = worked_solution(&scene, &Settings::default(), &records, &options);
    assert_eq!(mistake(&page, &of_page), None);
    let at = page
        .lines
        .iter()
        .position(|line| line.text.starts_with("direction: P − COP"))
        .unwrap();

    let mut lost = page.clone();
    lost.lines[at].steps = None;
    assert!(
        mistake(&lost, &of_page)
            .unwrap()
            .starts_with("tells no step")
    );

    let mut wide = page.clone();
    wide.lines[at].steps.as_mut().unwrap().last.step += 1;
    assert!(
        mistake(&wide, &of_page)
            .unwrap()
            .starts_with("two ranges hold")
    );

    let mut gone = page.clone();
    gone.lines.retain(|line| line.steps != page.lines[at].steps);
    assert!(
        mistake(&gone, &of_page)
            .unwrap()
            .starts_with("no line tells")
    );

    let mut heading = page;
    let heading_at = heading
        .lines
        .iter()
        .position(|line| line.tone == Tone::Heading && line.ray.is_some());
    heading.lines[heading_at.unwrap()].steps = heading.lines[at].steps;
    assert!(
        mistake(&heading, &of_page)
            .unwrap()
            .starts_with("has steps of its own")
    );
}

/// Rays that connect two paths, for a page of one of them alone.
#[test]
fn a_page_of_a_connecting_ray_tells_the_whole_connection() {
    let scene = super::light::built(super::light::SCENE);
    let settings = super::light::settings(Transport::HybridConnected);
    let records = traced(&scene, &settings, [1, 1]);
    let own: Vec<&Record> = records
        .iter()
        .filter(|record| record.pixel.is_some())
        .collect();
    let connects = |record: &&&Record| match record.event {
        Event::Ray(start) => start.purpose == Purpose::Connection,
        _ => false,
    };
    let ray = own.iter().find(connects).unwrap().ray.unwrap();
    let first = own
        .iter()
        .position(|record| record.ray == Some(ray))
        .unwrap();
    let is_end = |record: &&Record| matches!(record.event, Event::Connection(_));
    let length = own[first..].iter().position(is_end).unwrap();
    let options = WorkedOptions {
        ray: Some(ray),
        ..WorkedOptions::default()
    };
    let page = worked_solution(&scene, &settings, &records, &options);
    assert_eq!(mistake(&page, &own[first..=first + length]), None);
    assert_eq!(settings.through, Through::Centres);
}
