//! One ray: where it starts, what it is tested against, how it ends.

use crate::explain::name::ray_title;
use crate::explain::number::Digits;
use crate::explain::page::{Fold, Tone, Unfold};
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::extent::Extent;
use crate::explain::worked::misses::{FOLDED_FROM, LONGEST_UNFOLDED};
use crate::explain::worked::pen::Pen;
use crate::explain::worked::quadratic::Tested;
use crate::explain::worked::steps::{Course, Noted, Step, Test, Told, slab_rays, steps};
use crate::explain::worked::{
    aligned, arrival, gathered, misses, photon, polygon, quadratic, ray_start, search, seen, shade,
    slabs, vertex,
};
use crate::scene::PrimitiveId;
use crate::trace::{Event, Kind, Nearest, Purpose, RayEnd, RayNode, RayStart, RayVerdict};

/// The whole working of a ray, with the rays that it spawned indented below.
pub(super) fn ray(context: &Context, place: usize, page: &mut Pen) {
    let whole = context.of_ray(place);
    if !page.writes(whole) {
        return;
    }
    let node = &context.tree.rays[place];
    let steps = steps(context, &node.items);
    let mut course = course(context, place, &steps);
    let ends_at = node.ends_at.map(|at| at.map(|at| context.at(at)));
    page.of_ray(node.id, |page| {
        if page.writes(Extent::at(whole.first)) {
            page.line(Tone::Heading, title_of(context, place));
        }
        page.indented(|page| {
            if let Some(start) = node.start.filter(|_| context.shows(Kind::Ray)) {
                page.telling(ends_at[0], |page| {
                    page.of_part(Part::Direction, |page| {
                        ray_start::ray_start(context, place, &start, node.parent, page);
                    });
                });
            }
            all_steps(context, &steps, &mut course, page);
            if let Some(end) = node.end {
                page.telling(ends_at[1], |page| ray_end(context, &end, &course, page));
            }
        });
    });
}

/// What is known of a ray before its steps are written.
fn course(context: &Context, place: usize, steps: &[Told]) -> Course {
    let node = &context.tree.rays[place];
    let shade = steps.iter().find_map(|told| match told.step {
        Step::Shade(shade) => Some((shade, told.extent)),
        _ => None,
    });
    let photon = steps.iter().find_map(|told| match told.step {
        Step::Photon(photon) => Some((photon, told.extent)),
        _ => None,
    });
    let of_photon = photon
        .zip(node.start)
        .map(|((photon, _), start)| vertex::normal_towards(context, &photon, -start.ray.direction));
    Course {
        place,
        start: node.start,
        aligned: aligned::aligned_ray(context, steps, node.start),
        nearest: None,
        nearest_object: None,
        shade: shade.map(|(shade, _)| shade),
        photon: photon.map(|(photon, _)| photon),
        normal: shade.map(|(shade, _)| shade.normal).or(of_photon),
        end: node.end,
        arrival: photon
            .map(|(_, extent)| extent)
            .or(shade.map(|(_, extent)| extent)),
        arrived: false,
        slabs_in_full: search::slabs_in_full(context, steps),
        slab_rays: slab_rays(steps),
        last: None,
        grid: None,
        slabs: Vec::new(),
    }
}

/// The steps of a ray, one by one; of many tests most misses are summed up.
fn all_steps(context: &Context, steps: &[Told], course: &mut Course, page: &mut Pen) {
    let is_test = |told: &&Told| matches!(told.step, Step::Test { .. });
    let fold = !context.options.all && FOLDED_FROM <= steps.iter().filter(is_test).count();
    let mut rest = steps;
    while let Some((told, after)) = rest.split_first() {
        rest = after;
        step(context, told, course, page);
        let is_miss = matches!(&told.step, Step::Test { test, .. } if test.hit().is_none());
        // what follows is counted where it may be summed up: in full, it would be counted again at each of many misses
        if !fold || !is_miss {
            continue;
        }
        let (misses, length) = misses_at_start(rest);
        if LONGEST_UNFOLDED <= misses {
            // the first of the run was shown, the others are summed up
            let (run, after) = rest.split_at(length);
            let extent = Extent::around(run.iter().map(|told| told.extent));
            page.telling(extent, |page| misses::folded(context, run, course, page));
            rest = after;
        }
    }
}

/// One step of a ray.
fn step(context: &Context, told: &Told, course: &mut Course, page: &mut Pen) {
    let meets = match told.step {
        Step::Test { .. } | Step::Search(_) | Step::Arrival(_) | Step::Nearest(_) => false,
        Step::Ray(_)
        | Step::Light(_)
        | Step::Refraction(_)
        | Step::Shade(_)
        | Step::Photon(_)
        | Step::Stored(_)
        | Step::Gathered { .. } => true,
    };
    if meets {
        page.telling(course.arrival, |page| {
            page.of_part(Part::Point, |page| arrival::arrive(context, course, page));
        });
    }
    search::before_step(context, &told.step, course);
    page.telling(told.extent, |page| write_step(context, told, course, page));
    after_step(&told.step, course);
}

/// What is known of the ray behind a step, whether the step was written or not.
fn after_step(step: &Step, course: &mut Course) {
    match step {
        Step::Test {
            nearest: Some(Noted { working: hit, .. }),
            ..
        }
        | Step::Nearest(hit) => {
            course.nearest = Some(hit.t);
            course.nearest_object = Some(hit.object);
        }
        Step::Search(event) => course.last = Some(*event),
        _ => {}
    }
}

/// The words of one step.
fn write_step(context: &Context, told: &Told, course: &Course, page: &mut Pen) {
    match &told.step {
        Step::Test {
            object,
            test,
            nearest,
        } => {
            // its nearest hit is a step of its own
            let tested = test.decided().unwrap_or(Extent::at(told.extent.first));
            page.telling(tested, |page| {
                object_test(context, *object, test, course, page);
            });
            is_nearest(context, test, (*nearest, tested), course, page);
        }
        Step::Ray(child) => {
            if context.options.ray.is_none() {
                page.gap();
                ray(context, *child, page);
                page.gap();
            } else {
                child_in_short(context, *child, page);
            }
        }
        Step::Light(light) => shade::light(context, light, course, page),
        Step::Refraction(refraction) => page.of_part(Part::Snell, |page| {
            shade::refraction(context, refraction, course, page);
        }),
        Step::Shade(shade) => shade::shade(context, shade, page),
        Step::Search(event) => search::search(context, event, course, page),
        Step::Photon(photon) => page.of_part(Part::Roulette, |page| {
            photon::photon(context, photon, course, page);
        }),
        Step::Stored(stored) => page.of_part(Part::Stored, |page| {
            photon::stored(context, stored, page);
        }),
        Step::Gathered { nearby, gathered } => {
            page.of_part(Part::Gathered, |page| {
                gathered::gather(context, nearby, gathered.as_ref(), page);
            });
        }
        Step::Arrival(arrival) => {
            page.of_part(Part::Arrival, |page| seen::seen(context, arrival, page));
        }
        Step::Nearest(hit) => becomes_nearest(context, hit, page),
    }
}

fn title_of(context: &Context, place: usize) -> String {
    let RayNode {
        id, parent, start, ..
    } = &context.tree.rays[place];
    ray_title(context.scene, *id, *parent, start.as_ref())
}

/// The test of one object, in full if it hits or all is wanted, else in short.
fn object_test(
    context: &Context,
    object: PrimitiveId,
    test: &Test,
    course: &Course,
    page: &mut Pen,
) {
    if shows_test(context, test) {
        let full = context.options.all || test.hit().is_some();
        let by_quadratic = |test| Tested {
            context,
            object,
            test,
            course,
            full,
        };
        match test {
            Test::Sphere(test) => quadratic::sphere(by_quadratic(test), page),
            Test::Ellipsoid(test) => quadratic::ellipsoid(by_quadratic(test), page),
            Test::Cone(test) => quadratic::cone(by_quadratic(test), page),
            Test::Box(working) => slabs::slabs(context, object, working, course, page),
            Test::Polygon {
                plane,
                edges,
                inside,
            } => polygon::polygon(
                context,
                object,
                (plane.as_ref(), edges, inside.as_ref()),
                course,
                full,
                page,
            ),
        }
    }
}

/// Whether the hit of a test is the nearest so far.
fn is_nearest(
    context: &Context,
    test: &Test,
    (nearest, tested): (Option<Noted<Nearest>>, Extent),
    course: &Course,
    page: &mut Pen,
) {
    let shadow = course
        .start
        .is_some_and(|start| start.purpose == Purpose::Shadow);
    if let Some(hit) = nearest {
        page.telling(hit.extent, |page| {
            becomes_nearest(context, &hit.working, page);
        });
    } else if let Some(first) = course.nearest_object
        && test.hit().is_some()
        && !shadow
        && context.shows(Kind::Nearest)
    {
        let first = context.name(first);
        let text = format!(" stays {first}: it has the same t and comes first in the scene");
        page.telling(tested, |page| {
            page.indented(|page| page.result(Tone::Refused, Part::Nearest, text));
        });
    }
}

/// A hit became the nearest.
fn becomes_nearest(context: &Context, hit: &Nearest, page: &mut Pen) {
    if context.shows(Kind::Nearest) {
        let text = match hit.replaced {
            None => " so far".into(),
            Some(old) => format!(" so far, nearer than {}", context.name(old)),
        };
        page.indented(|page| page.result(Tone::Found, Part::Nearest, text));
    }
}

fn shows_test(context: &Context, test: &Test) -> bool {
    match test {
        Test::Sphere(_) => context.shows(Kind::SphereTest),
        Test::Ellipsoid(_) => context.shows(Kind::EllipsoidTest),
        Test::Cone(_) => context.shows(Kind::ConeTest),
        Test::Box(_) => context.shows(Kind::BoxTest),
        Test::Polygon { .. } => {
            context.shows(Kind::PlaneTest)
                || context.shows(Kind::Edge)
                || context.shows(Kind::PolygonTest)
        }
    }
}

/// A ray that another page works out: its purpose and its end.
fn child_in_short(context: &Context, place: usize, page: &mut Pen) {
    let node = &context.tree.rays[place];
    let title = title_of(context, place);
    let end = node.end.map_or(String::new(), |end| {
        format!(": {}", verdict(context, &end, node.start).1)
    });
    let fold = Fold {
        hidden: 1,
        shown_by: Unfold::Ray(node.id),
    };
    page.of_ray(node.id, |page| {
        page.line(Tone::Folded(fold), format!("{title}{end}"));
    });
}

/// What the end of a ray says something about, and what it says.
fn verdict(context: &Context, end: &RayEnd, start: Option<RayStart>) -> (Part, String) {
    let d = Digits::USUAL;
    let object = end.object.map_or("an object".into(), |id| context.name(id));
    let at = end
        .t
        .map_or(String::new(), |t| format!(" at t = {}", d.number(t)));
    let of_path =
        start.is_some_and(|start| matches!(start.purpose, Purpose::Light | Purpose::Scattered));
    let part = match end.verdict {
        RayVerdict::Blocked | RayVerdict::ReachesLight | RayVerdict::Connects => Part::Visibility,
        _ if of_path => Part::Leg,
        _ => Part::RayColour,
    };
    let text = match end.verdict {
        RayVerdict::Hit => format!("the ray hits {object}{at}"),
        RayVerdict::Miss => "the ray hits no object".into(),
        RayVerdict::Blocked => {
            let is_line = start.is_some_and(|start| start.purpose == Purpose::Connection);
            let shadow = if is_line {
                ""
            } else {
                ", so the point is in its shadow"
            };
            format!("blocked by {object}{at}{shadow}")
        }
        RayVerdict::ReachesLight => "no object is in between, so the light is visible".into(),
        RayVerdict::DepthLimit => format!(
            "the depth limit is {}, so the ray is not traced and brings no light",
            context.scene.max_depth
        ),
        RayVerdict::Absorbed => format!("the ray hits {object}{at}, which absorbs it"),
        RayVerdict::CutOff => {
            format!("the ray hits {object}{at}, beyond the most surfaces of a path: it is cut off")
        }
        RayVerdict::Connects => "no object is in between".into(),
    };
    (part, text)
}

/// What the ray brings back.
fn ray_end(context: &Context, end: &RayEnd, course: &Course, page: &mut Pen) {
    if !context.shows(Kind::RayEnd) {
        return;
    }
    let d = Digits::USUAL;
    let tone = match end.verdict {
        RayVerdict::Hit | RayVerdict::ReachesLight | RayVerdict::Connects => Tone::Found,
        RayVerdict::Miss
        | RayVerdict::Blocked
        | RayVerdict::DepthLimit
        | RayVerdict::Absorbed
        | RayVerdict::CutOff => Tone::Refused,
    };
    match (end.verdict, end.colour) {
        // Russian roulette has said it already
        (RayVerdict::Hit | RayVerdict::Absorbed, None)
            if course.photon.is_some() && context.shows(Kind::Photon) => {}
        (RayVerdict::Hit, Some(colour)) => {
            let sum = shade::sum(context, course).unwrap_or_default();
            let text = format!(": I = {sum}{}", d.vector(colour));
            page.headed_line(tone, Part::RayColour, text);
        }
        (RayVerdict::Miss, Some(_)) if context.settings.transport.follows_light() => {
            let text = ": no object is hit, so there is no light: only the lights emit any";
            page.result(tone, Part::RayColour, text);
        }
        (RayVerdict::Miss, Some(colour)) => {
            let background = d.vector(colour);
            let text = format!(": no object is hit, so the background, {background}");
            page.result(tone, Part::RayColour, text);
        }
        _ => {
            let leaves = match end.verdict {
                RayVerdict::Miss => photon::leaves_with(context, &context.tree.rays[course.place]),
                _ => None,
            };
            let (part, text) = verdict(context, end, course.start);
            let leaves = leaves.unwrap_or_default();
            page.result(tone, part, format!(": {text}{leaves}"));
        }
    }
}

/// How many tests without a hit come next, and over how many steps: an aligned object comes before its test.
fn misses_at_start(steps: &[Told]) -> (usize, usize) {
    let (mut misses, mut length) = (0, 0);
    for (at, told) in steps.iter().enumerate() {
        match &told.step {
            Step::Test { test, .. } if test.hit().is_none() => {
                misses += 1;
                length = at + 1;
            }
            Step::Search(Event::Aligned(_) | Event::Listed { .. } | Event::Mailbox { .. }) => {}
            _ => break,
        }
    }
    (misses, length)
}
