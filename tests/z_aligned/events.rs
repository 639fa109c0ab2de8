//! What the z-aligned search records, and what is told of it.

use glam::DVec3;
use raystep::geometry::{AxisBox, Ray, Sphere, TRange};
use raystep::scene::{PrimitiveId, Shape};
use raystep::strategy::{Hit, Strategy, ZAligned};
use raystep::trace::{Aligned, AlignedPart, Kind};
use raystep::tracer::trace_pixel;
use raystep::{
    Event, NoFiles, Off, Recording, Settings, Through, Tracer, Transport, WorkedOptions, load_bytes,
};

use crate::worked_solution::worked_text;

use super::hard_rays::{ray, shape};
use super::{ROUNDING, both_sides};
use crate::seeded::Seeded;

#[test]
fn what_is_recorded_and_what_is_not_find_the_same_and_tests_are_hits_and_misses() {
    let mut seeded = Seeded::new(4);
    for _ in 0..200 {
        let scene = both_sides((0..12).map(|_| shape(&mut seeded)).collect());
        for _ in 0..20 {
            let ray = ray(&scene, &mut seeded);
            let mut recording = Recording::new(Vec::new());
            let seen = ZAligned::new(&scene).nearest(&ray, TRange::FORWARD, &mut recording);
            let unseen = ZAligned::new(&scene).nearest(&ray, TRange::FORWARD, &mut Off);
            assert_eq!(seen, unseen, "{ray:?}");

            let events: Vec<Event> = recording.into_sink().iter().map(|r| r.event).collect();
            let kind = |kind| events.iter().filter(move |event| event.kind() == kind);
            assert_eq!(kind(Kind::Align).count(), 1);
            let sorted: Vec<_> = events.iter().filter_map(sorted).collect();
            assert!(sorted.is_sorted(), "{sorted:?}");
            let tested = events.iter().filter(|event| event.test_hits().is_some());
            let planes = kind(Kind::PlaneTest).filter(|event| event.test_hits() == Some(true));
            let hits = tested
                .clone()
                .filter(|event| event.test_hits() == Some(true));
            // a polygon has two tests: of its plane, and then of its outline
            assert_eq!(tested.count(), 12 + planes.clone().count());
            assert_eq!(hits.count() - planes.count(), sorted.len());
            assert_eq!(
                sorted.first().map(|&(_, id)| id),
                seen.map(|hit| hit.object)
            );
        }
    }
}

/// z and the object of a place in the z sort.
fn sorted(event: &Event) -> Option<(f64, PrimitiveId)> {
    match event {
        Event::ZSort(sorted) => Some((sorted.z, sorted.object)),
        _ => None,
    }
}

#[test]
fn every_point_of_an_object_is_noted_before_and_after() {
    let ball = Sphere {
        center: DVec3::new(6.0, 1.0, 8.0),
        radius: 2.0,
    };
    let solid = AxisBox {
        min: DVec3::new(2.0, -1.0, 3.0),
        max: DVec3::new(4.0, 1.0, 5.0),
    };
    let scene = both_sides(vec![Shape::Sphere(ball), Shape::Box(solid)]);
    let ray = Ray::new(DVec3::ZERO, DVec3::new(0.6, 0.0, 0.8));
    let mut recording = Recording::new(Vec::new());
    ZAligned::new(&scene).nearest(&ray, TRange::FORWARD, &mut recording);
    let records = recording.into_sink();
    let parts: Vec<Aligned> = records
        .iter()
        .filter_map(|record| match record.event {
            Event::Aligned(part) => Some(part),
            _ => None,
        })
        .collect();
    // x′ = y, y′ = −0.8x + 0.6z, z′ = 0.6x + 0.8z
    let expected = [
        (0, AlignedPart::Center, [6.0, 1.0, 8.0], [1.0, 0.0, 10.0]),
        (1, AlignedPart::Center, [3.0, 0.0, 4.0], [0.0, 0.0, 5.0]),
        (1, AlignedPart::HalfAxis, [1.0, 0.0, 0.0], [0.0, -0.8, 0.6]),
        (1, AlignedPart::HalfAxis, [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]),
        (1, AlignedPart::HalfAxis, [0.0, 0.0, 1.0], [0.0, 0.6, 0.8]),
    ];
    assert_eq!(parts.len(), expected.len());
    for (part, (object, kind, from, to)) in parts.iter().zip(expected) {
        assert_eq!((part.object, part.part), (PrimitiveId(object), kind));
        assert_eq!(part.from, DVec3::from(from));
        let off = (part.to - DVec3::from(to)).length();
        assert!(off <= 10.0 * ROUNDING, "{part:?}");
    }
    // the box: x ≥ 2 from t = 10/3 on, z ≥ 3 from t = 3.75 on; the ball: 10 ± √(4 − 1)
    let places: Vec<_> = records.iter().filter_map(|r| sorted(&r.event)).collect();
    let [(near, first), (far, second)] = places[..] else {
        panic!("{places:?}");
    };
    assert_eq!((first, second), (PrimitiveId(1), PrimitiveId(0)));
    assert!((near - 3.75).abs() <= 10.0 * ROUNDING, "{near}");
    assert!(
        (far - (10.0 - 3f64.sqrt())).abs() <= 10.0 * ROUNDING,
        "{far}"
    );
}

#[test]
fn hits_at_equal_z_stay_in_the_order_of_the_scene() {
    let ball = |z| {
        Shape::Sphere(Sphere {
            center: DVec3::new(0.0, 0.0, z),
            radius: 1.0,
        })
    };
    let scene = both_sides(vec![ball(9.0), ball(5.0), ball(5.0)]);
    let ray = Ray::new(DVec3::ZERO, DVec3::Z);
    let mut recording = Recording::new(Vec::new());
    let hit = ZAligned::new(&scene).nearest(&ray, TRange::FORWARD, &mut recording);
    let expected = Hit {
        object: PrimitiveId(1),
        t: 4.0,
    };
    assert_eq!(hit, Some(expected));
    let records = recording.into_sink();
    let places: Vec<_> = records.iter().filter_map(|r| sorted(&r.event)).collect();
    let expected = [(4.0, 1), (4.0, 2), (8.0, 0)].map(|(z, id)| (z, PrimitiveId(id)));
    assert_eq!(places, expected);
}

#[test]
fn a_shadow_ray_ends_at_the_first_hit_and_sorts_nothing() {
    let ball = |z| {
        Shape::Sphere(Sphere {
            center: DVec3::new(0.0, 0.0, z),
            radius: 1.0,
        })
    };
    let scene = both_sides(vec![ball(9.0), ball(5.0)]);
    let ray = Ray::new(DVec3::ZERO, DVec3::Z);
    let mut recording = Recording::new(Vec::new());
    let hit = ZAligned::new(&scene).any(&ray, TRange::FORWARD, &mut recording);
    assert_eq!(hit.map(|hit| hit.object), Some(PrimitiveId(0)));
    let kinds: Vec<_> = recording
        .into_sink()
        .iter()
        .map(|r| r.event.kind())
        .collect();
    assert_eq!(kinds, [Kind::Align, Kind::Aligned, Kind::SphereTest]);
}

/// One pixel, whose eye ray runs along (0.6, 0, 0.8) from the origin.
const ALONG_3_4_5: &str = r#"{
  "camera": { "window": { "cop": [0, 0, 0], "corner": [2, -1, 4], "right": [2, 0, 0], "up": [0, 2, 0] },
              "pixels": [1, 1] },
  "background": [0, 0, 0], "ambient": [0, 0, 0],
  "materials": { "m": { "colour": [1, 1, 1] } },
  "objects": [
    { "name": "ball", "material": "m", "shape": { "sphere": { "center": [6, 1, 8], "radius": 2 } } },
    { "name": "box", "material": "m", "shape": { "box": { "min": [2, -1, 3], "max": [4, 1, 5] } } }
  ]
}"#;

#[test]
fn the_working_is_told_in_the_numbers_of_the_frame() {
    let loaded = load_bytes("345.json", ALONG_3_4_5.as_bytes(), &NoFiles).unwrap();
    let scene = loaded.build().unwrap();
    let strategy = ZAligned::new(&scene);
    let tracer = Tracer::new(&scene, &strategy, Transport::HybridLight);
    let mut recording = Recording::new(Vec::new());
    trace_pixel(&tracer, [0, 0], Through::Centres, &mut recording).unwrap();
    let records = recording.into_sink();
    let text = worked_text(
        &scene,
        &Settings::default(),
        &records,
        &WorkedOptions::default(),
    );
    for line in [
        "o = (0, 0, 0), z = Δ = (0.6, 0, 0.8)",
        "x = [e − (e·z)·z]/|z × e| = [(0, 1, 0) − 0·(0.6, 0, 0.8)]/1 = (0, 1, 0), with e the axis of the \
         smallest component of Δ",
        "y = z × x = [z × e]/|z × e| = (−0.8, 0, 0.6)",
        "aligned point: centre of ball (6, 1, 8) → (1, 0, 10)",
        "c = |o − centre|² − r² = (−1)² + 0² + (−10)² − 2² = 97",
        "t = (−b ± √12)/2a = (20 ± 3.4641016)/2 = 8.2679492 and 11.732051",
        "at x = y = 0 (ii) is (z − c_z)² = r² − c_x² − c_y² = 2² − 1² − 0² = 3",
        "aligned point: centre of box (3, 0, 4) → (0, 0, 5)",
        "aligned point: half axis 0 of box (1, 0, 0) → (0, −0.8, 0.6)",
        "near, far of the slab across z, turned to (A, B, C) = (0, 0.6, 0.8): near = −D/C = −(−3)/0.8 = 3.75, \
         far = −D/C = −(−5)/0.8 = 6.25",
        "Z sort: the hits, the nearest first",
        "1. box at z = 3.75: (0, 0, 3.75) is o + z·Δ = (0, 0, 0) + 3.75·(0.6, 0, 0.8) = (2.25, 0, 3) in the scene",
        "2. ball at z = 8.26795",
    ] {
        assert!(text.contains(line), "{line}\nis not in\n{text}");
    }
}
