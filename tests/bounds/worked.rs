//! The worked solution tells each volume and each slab, with numbers that come out.

use glam::DVec3;
use raystep::strategy::BoundedObjects;
use raystep::structure::{SlabSet, VolumeKind};
use raystep::tracer::trace_pixel;
use raystep::{Recording, Scene, Settings, Through, Tracer, Transport, WorkedOptions};

use crate::worked_solution::worked_text;

use super::{KINDS, brick, cone, ellipsoid, mesh, outline, own_set, polygon, scene, solid, sphere};
use crate::calculator::check_line;
use crate::seeded::Seeded;

fn solution<const N: usize>(
    scene: &Scene,
    kind: VolumeKind,
    set: &SlabSet<N>,
    pixel: [u32; 2],
) -> String {
    let strategy = BoundedObjects::new(scene, kind, set);
    let tracer = Tracer::new(scene, &strategy, Transport::HybridLight);
    let mut recording = Recording::new(Vec::new());
    trace_pixel(&tracer, pixel, Through::Centres, &mut recording).unwrap();
    let options = WorkedOptions::default();
    let records = recording.into_sink();
    worked_text(scene, &Settings::default(), &records, &options)
}

/// The eye is at (0, 0, 9), and the pixel's ray runs to (½, ½, 5): Δ = (1, 1, −8)/√66.
const TOP_RIGHT: [u32; 2] = [1, 0];

#[track_caller]
fn check_lines(text: &str, lines: &[&str]) {
    let mut rest = text;
    for line in lines {
        let at = rest.find(line);
        assert!(at.is_some(), "{line:?} is not, or not in order, in\n{text}");
        rest = &rest[at.unwrap() + line.len()..];
    }
}

#[test]
fn a_met_a_missed_and_a_hidden_volume_are_told_with_what_follows() {
    let scene = scene(&[
        sphere(DVec3::new(1.0, 1.0, 1.0), 1.0),
        sphere(DVec3::new(-5.0, 0.0, 1.0), 1.0),
        sphere(DVec3::new(1.5, 1.5, -3.0), 1.0),
        sphere(DVec3::new(-1.0, -1.0, 17.0), 1.0),
    ]);
    // through the centre of the first, √66 = 8.12404 away
    let text = solution(&scene, VolumeKind::Sphere, &SlabSet::AXES, TOP_RIGHT);
    let lines = [
        "bounding volume of 0 (sphere): hit, inside for t in [7.12404, 9.12404], so the object is tested",
        "bounding volume of 1 (sphere): missed, so the object is not tested",
        "bounding volume of 2 (sphere): begins at t = 11.1861, behind the nearest hit, t = 7.12404, so the object \
         is not tested",
        "bounding volume of 3 (sphere): behind the origin, inside for t in [−9.12404, −7.12404], so the object \
         is not tested",
    ];
    check_lines(&text, &lines);
}

#[test]
fn each_slab_is_worked_out_up_to_the_one_at_which_near_and_far_cross() {
    let scene = scene(&[
        sphere(DVec3::new(1.0, 1.0, 1.0), 1.0),
        solid(DVec3::new(0.0, 2.0, 0.0), DVec3::new(4.0, 3.0, 4.0)),
    ]);
    let text = solution(&scene, VolumeKind::Slabs, &SlabSet::AXES, TOP_RIGHT);
    // x from 0 to 2: T = −√66, D from −2 to 0. Of the solid x lies between t = 0 and 4√66 = 32.4962, y from
    // 2√66 = 16.2481 on, and z = 0 is passed at 9√66/8 = 9.13955
    let lines = [
        "Bounding volume of 0, slab by slab",
        "S, T of slab 0, (A, B, C) = (1, 0, 0): S = 1·0 + 0·0 + 0·9 = 0, T = −1/[1·0.123091 + 0·0.123091 + \
         0·(−0.984732)] = −8.12404",
        "far = (S + D_min)·T = (0 − 2)·(−8.12404) = 16.2481",
        "interval: max near ",
        "S, T of slab 2, (A, B, C) = (0, 0, 1): S = 0·0 + 0·0 + 1·9 = 9, T = −1/[0·0.123091 + 0·0.123091 + \
         1·(−0.984732)] = 1.0155",
        "near = (S + D_min)·T = (9 − 2)·1.0155 = 7.10853, far",
        "bounding volume of 0 (slabs): hit, inside for t in [7.10853, 9.13954], so the object is tested",
        "Bounding volume of 1, slab by slab",
        "interval: max near 16.24808 > min far 9.139543: no t in common, missed; no more slabs are tested",
        "bounding volume of 1 (slabs): missed, so the object is not tested",
    ];
    check_lines(&text, &lines);
}

#[test]
fn every_line_about_volumes_can_be_computed_again() {
    let mut random = Seeded::new(11);
    let (mut equations, mut verdicts) = (0, 0);
    for _ in 0..25 {
        let mut near = || random.point(1.5);
        let (a, b, c, d) = (near(), near(), near(), near());
        let shapes = [
            sphere(a, 0.7),
            ellipsoid(b, DVec3::new(0.3, 0.9, 0.5)),
            solid(c - 0.5, c + 0.25),
            cone(d, 0.5, a, 0.1),
            polygon(&outline(&mut random, 5, 0.3)),
            mesh(&brick(&mut random)),
        ];
        let scene = scene(&shapes);
        let mut texts = KINDS
            .map(|kind| solution(&scene, kind, &SlabSet::SEVEN, TOP_RIGHT))
            .to_vec();
        texts.push(solution(&scene, VolumeKind::Slabs, &own_set(), [0, 1]));
        for text in texts {
            for line in text.lines() {
                let [numbers, _] = check_line(line);
                if line.contains("S, T of") || line.contains("near, far") {
                    equations += numbers;
                }
                verdicts += usize::from(line.trim_start().starts_with("bounding volume of"));
            }
        }
    }
    assert!(2000 < equations && 400 < verdicts, "{equations} {verdicts}");
}

#[test]
fn a_parallel_ray_is_told_by_where_its_s_lies() {
    // the middle of the window is at the corner of its four pixels: a window moved by half a pixel has the
    // axis itself as a ray, parallel to the slabs across x and y
    let scene = scene(&[
        sphere(DVec3::new(0.5, 0.5, 0.0), 1.0),
        sphere(DVec3::new(3.5, 0.5, 0.0), 1.0),
    ]);
    let strategy = BoundedObjects::new(&scene, VolumeKind::Slabs, &SlabSet::AXES);
    let mut recording = Recording::new(Vec::new());
    use raystep::geometry::{Ray, TRange};
    use raystep::strategy::Strategy;
    use raystep::trace::{Purpose, RayEnd, RayStart, RayVerdict};
    use raystep::{Event, Recorder};
    let ray = Ray::new(DVec3::new(0.5, 0.5, 9.0), -DVec3::Z);
    recording.note(|| {
        Event::Ray(RayStart {
            purpose: Purpose::Eye,
            ray,
            depth: 1,
            ..RayStart::default()
        })
    });
    strategy.nearest(&ray, TRange::FORWARD, &mut recording);
    recording.note(|| {
        Event::RayEnd(RayEnd {
            verdict: RayVerdict::Miss,
            ..RayEnd::default()
        })
    });
    let options = WorkedOptions::default();
    let records = recording.into_sink();
    let text = worked_text(&scene, &Settings::default(), &records, &options);
    // −D runs from −0.5 to 1.5, and for the second sphere from 2.5 to 4.5
    let lines = [
        "S = 1·0.5 + 0·0.5 + 0·9 = 0.5, 1·0 + 0·0 + 0·(−1) = 0: the ray is parallel",
        "−D_max = −0.5, −D_min = 1.5, and S is between them, so the ray is inside for every t",
        "bounding volume of 0 (slabs): hit, inside for t in [8, 10], so the object is tested",
        "−D_max = 2.5, −D_min = 4.5, and S is not between them, so the ray is outside for every t",
        "interval: empty, missed; no more slabs are tested",
        "bounding volume of 1 (slabs): missed, so the object is not tested",
    ];
    check_lines(&text, &lines);
    for line in text.lines() {
        check_line(line);
    }
}
