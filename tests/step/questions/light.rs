//! Light: who stands between, which terms are left, and the sine behind a surface.

use std::collections::BTreeSet;

use glam::DVec3;
use raystep::geometry::{Ray, TRange};
use raystep::scene::{Emission, PrimitiveId};
use raystep::tracer::simple::{Own, Parts};
use raystep::tracer::{EPSILON, start_epsilon};
use raystep::{Event, Transport};

use super::{Asked, close, number_in};

/// By the simple ray tracer: each object by itself.
pub(super) fn blocked(asked: &Asked) -> Option<String> {
    let Event::Ray(start) = asked.events[0].event else {
        panic!("{:?}", asked.events[0]);
    };
    let scene = asked.log.scene;
    let mut between = BTreeSet::new();
    for (object, primitive) in (0..).map(PrimitiveId).zip(&scene.primitives) {
        if Own.hit(primitive, &start.ray, start.range).is_some() {
            let name = match scene.name_of(object) {
                (name, None) => name.to_owned(),
                (name, Some(face)) => format!("{name} face {face}"),
            };
            between.insert(format!("blocked by {name}"));
        }
    }
    for (place, choice) in asked.question.choices.iter().enumerate() {
        let is_true = match choice.text.as_str() {
            "not blocked" => between.is_empty(),
            text => between.contains(text),
        };
        if is_true != (place == asked.question.right) {
            return Some(format!("{choice:?}, but {between:?}"));
        }
    }
    None
}

/// By the light, the material, and the point and the normal of the shade that follows.
pub(super) fn zero_terms(asked: &Asked) -> String {
    let Event::LightTerm(of) = asked.events[0].event else {
        panic!("{:?}", asked.events[0]);
    };
    let own = &asked.events[0];
    let after = asked.log.records.iter().skip_while(|record| *record != own);
    let shade = after.into_iter().find_map(|record| match record.event {
        Event::Shade(shade) if record.ray == own.ray => Some(shade),
        _ => None,
    });
    let shade = shade.unwrap();
    let scene = asked.log.scene;
    let material = scene.material_of(shade.object);
    let light = &scene.lights[of.light as usize];
    let to_light = light.position - shade.point;
    let is_in_front = 0.0 < shade.normal.dot(to_light);
    let mut shines = is_in_front;
    if is_in_front && asked.log.settings.transport == Transport::HybridLight {
        let surface_t = asked.on_ray.iter().rev().find_map(|event| match event {
            Event::Nearest(hit) => Some(hit.t),
            _ => None,
        });
        let reach = scene.primitive(shade.object).shape.reach();
        let range = TRange {
            min: start_epsilon(shade.point, surface_t.unwrap(), reach),
            max: to_light.length() * (1.0 - EPSILON),
        };
        let ray = Ray::new(shade.point, to_light.normalize());
        shines = !Own.blocked(scene, &ray, range);
    }
    let viewer = -asked.ray().direction;
    let l = to_light.normalize();
    let mirrored = 2.0 * shade.normal.dot(l) * shade.normal - l;
    let (emitted, has_highlight) = match light.emission {
        Emission::Colour(colour) => (colour, true),
        Emission::Power(power) => (DVec3::splat(power), false),
    };
    let seen = emitted * DVec3::from(material.colour) * material.diffuse;
    let diffuse = shines && 0.0 < seen.max_element();
    let glossy = 0.0 < material.specular * emitted.max_element() && has_highlight;
    let in_highlight = 0.0 < mirrored.dot(viewer) || material.shininess == 0.0;
    let specular = shines && glossy && in_highlight;
    match (diffuse, specular) {
        (true, true) => "neither",
        (false, true) => "the diffuse term alone",
        (true, false) => "the specular term alone",
        (false, false) => "both",
    }
    .into()
}

/// By the sine of the angle behind the surface.
pub(super) fn total_reflection(asked: &Asked) -> String {
    let Event::Refraction(of) = asked.events[0].event else {
        panic!("{:?}", asked.events[0]);
    };
    let sine = of.index_from * of.cos_incident.acos().sin() / of.index_to;
    let found = asked.right();
    let expected = if 1.0 < sine {
        "all light is reflected: cos²θ₂ = "
    } else {
        "the ray passes: cos²θ₂ = "
    };
    let squared = number_in(found, "cos²θ₂ = ").unwrap();
    assert!(close(squared, 1.0 - sine * sine), "{found}: {sine}");
    if found.starts_with(expected) {
        found.into()
    } else {
        expected.into()
    }
}
