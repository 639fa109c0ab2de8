//! Hybrid ray tracing with connecting lines: a path of light and a path from the eye, each vertex of one joined to
//! each of the other by a line.
//!
//! E. Veach and L. Guibas (1994, 1995), E. Lafortune and Y. Willems (1993). With the light's power Φ' that
//! arrives at its vertex, the weight β of the path from the eye, and ρ/π of the surfaces at both ends,
//!
//! L = Φ'·ρ/π · G·V · ρ'/π·β · w,  G = cos θ · cos θ' / d²,  V = 1 if nothing stands between
//!
//! The same path of n edges can come about in several ways, one for each edge that can be the line: the weights w make
//! sure that it counts once ([`balance_heuristic`](crate::tracer::light::balance_heuristic)).

use std::f64::consts::PI;
use std::ops::ControlFlow;

use glam::{DVec2, DVec3};

use crate::geometry::{Ray, TRange};
use crate::scene::{Camera, WindowCrossing};
use crate::strategy::Strategy;
use crate::trace::{
    Connection, Event, Off, PixelSample, Purpose, RayStart, RayVerdict, Recorder, geometry_term,
};
use crate::tracer::epsilon::EPSILON;
use crate::tracer::eye::backward::eye_ray_start;
use crate::tracer::light::balance_heuristic::Paths;
use crate::tracer::light::chance::Chance;
use crate::tracer::light::lamps::Lamps;
use crate::tracer::light::light_pass::LightPass;
use crate::tracer::light::path_vertex::{Vertex, Vertices};
use crate::tracer::tracer::Tracer;

impl<S: Strategy> Tracer<'_, S> {
    /// The colour of a pixel: its paths from the eye, each connected to a path of light of its own, and what the
    /// lines from all paths of light to the eye have brought.
    pub(in crate::tracer) fn connected_pixel<R: Recorder>(
        &self,
        light: &LightPass,
        pixel: [u32; 2],
        recorder: &mut R,
    ) -> ControlFlow<(), DVec3> {
        let camera = &self.scene.camera;
        let [width, height] = camera.pixels;
        let place = u64::from(pixel[1]) * u64::from(width) + u64::from(pixel[0]);
        let samples = light.options.samples;
        // each path of light carries its share of the power for the whole picture, and this pixel has only its own
        let counts_for = f64::from(width) * f64::from(height);
        let mut sum = DVec3::ZERO;
        for sample in 0..samples {
            let number = (place * u64::from(samples) + u64::from(sample)) as u32;
            let mut chance = Chance::of_eye(light.options.seed, number);
            let [across, down] = [chance.number(), chance.number()];
            let place = DVec2::new(f64::from(pixel[0]) + across, f64::from(pixel[1]) + down);
            recorder.note(|| {
                Event::Pixel(PixelSample {
                    pixel,
                    sample,
                    samples,
                    place,
                    point: camera.window_point(place.x, place.y),
                })
            });
            let (ray, window_t) = camera.eye_ray(place.x, place.y);
            let start = eye_ray_start(ray, window_t);
            let mut eye = Vertices(vec![Vertex::end(camera.cop, DVec3::ONE)]);
            let most = light.lamps.most;
            self.walk(start, DVec3::ONE, most, &mut chance, &mut eye, recorder)?;
            let lit = self.light_vertices(&light.lamps, number, &mut Off)?;
            let paths = Paths {
                camera,
                number,
                light: &lit.0,
                eye: &eye.0,
            };
            for eye_vertex in 1..eye.0.len() {
                for light_vertex in 0..lit.0.len() {
                    if light_vertex + eye_vertex <= most as usize {
                        let found = self.connect(&paths, light_vertex, eye_vertex, recorder)?;
                        let brings = found.map_or(DVec3::ZERO, |found| found.contribution);
                        sum += counts_for * brings;
                    }
                }
            }
        }
        ControlFlow::Continue(sum + light.seen(pixel))
    }

    /// The vertices of a path of light; none in a scene without lights.
    fn light_vertices<R: Recorder>(
        &self,
        lamps: &Lamps,
        path: u32,
        recorder: &mut R,
    ) -> ControlFlow<(), Vertices> {
        // the light itself is known when the path has been followed
        let mut vertices = Vertices(vec![Vertex::end(DVec3::ZERO, DVec3::ZERO)]);
        match self.follow_light(lamps, path, &mut vertices, recorder)? {
            Some(start) => vertices.0[0] = Vertex::end(start.position, start.power),
            None => vertices.0.clear(),
        }
        ControlFlow::Continue(vertices)
    }

    /// Follows a path of light, and draws a line from each of its vertices to the eye.
    pub(in crate::tracer) fn seen_by_the_eye<R: Recorder>(
        &self,
        lamps: &Lamps,
        path: u32,
        recorder: &mut R,
    ) -> ControlFlow<(), Vec<Connection>> {
        let vertices = self.light_vertices(lamps, path, recorder)?;
        let camera = &self.scene.camera;
        let paths = Paths {
            camera,
            number: path,
            light: &vertices.0,
            eye: &[Vertex::end(camera.cop, DVec3::ONE)],
        };
        let mut lines = Vec::new();
        for vertex in 1..vertices.0.len().min(lamps.most as usize + 1) {
            lines.extend(self.connect(&paths, vertex, 0, recorder)?);
        }
        ControlFlow::Continue(lines)
    }

    /// Connects two vertices; `None` where no line can bring anything.
    fn connect<R: Recorder>(
        &self,
        paths: &Paths<'_>,
        light_vertex: usize,
        eye_vertex: usize,
        recorder: &mut R,
    ) -> ControlFlow<(), Option<Connection>> {
        let [from, to] = [&paths.light[light_vertex], &paths.eye[eye_vertex]];
        // a line to the eye must pass the window
        let window = (eye_vertex == 0).then_some(paths.camera);
        let Some(line) = Line::between(from, to, window) else {
            return ControlFlow::Continue(None);
        };
        let Line {
            cosines, crossing, ..
        } = line;
        let visible = self.sees(to, from, &line, recorder)?;
        let geometry = geometry_term(from.point, to.point, cosines);
        let mut connection = Connection {
            path: paths.number,
            light_vertex: light_vertex as u16,
            eye_vertex: eye_vertex as u16,
            pixel: crossing.map(|crossing| crossing.pixel),
            from: from.point,
            to: to.point,
            cosines,
            visible,
            ..Connection::default()
        };
        if visible {
            connection.weight = paths.weight(light_vertex, eye_vertex, recorder);
            let sent = match light_vertex {
                0 => from.carries / (4.0 * PI),
                _ => from.carries * from.albedo / PI,
            };
            let received = match &crossing {
                Some(crossing) => DVec3::splat(per_area(crossing, paths.camera.pixel_area())),
                None => to.albedo / PI * to.carries,
            };
            connection.contribution = sent * geometry * received * connection.weight;
        }
        recorder.note(|| Event::Connection(connection));
        ControlFlow::Continue(Some(connection))
    }

    /// Does nothing stand between two vertices?
    fn sees<R: Recorder>(
        &self,
        from: &Vertex,
        to: &Vertex,
        line: &Line,
        recorder: &mut R,
    ) -> ControlFlow<(), bool> {
        let start = RayStart {
            ray: Ray::new(from.point, line.direction),
            range: TRange {
                min: from.epsilon,
                // what stands at the other end is not in between
                max: (line.distance - to.epsilon).min(line.distance * (1.0 - EPSILON)),
            },
            purpose: Purpose::Connection,
            depth: 1,
            window_t: None,
            light: None,
        };
        self.is_clear(start, RayVerdict::Connects, recorder)
    }
}

/// A line between a vertex of a path of light and one of a path from the eye.
struct Line {
    /// Unit direction from the eye's vertex to the light's.
    direction: DVec3,
    distance: f64,
    /// Of the light's vertex and of the eye's.
    cosines: [f64; 2],
    /// Where a line to the eye passes the window.
    crossing: Option<WindowCrossing>,
}

impl Line {
    /// The line between two vertices; `None` where it cannot bring anything.
    fn between(from: &Vertex, to: &Vertex, window: Option<&Camera>) -> Option<Self> {
        if !from.can_connect() || !to.can_connect() {
            return None;
        }
        let line = from.point - to.point;
        let direction = line.try_normalize()?;
        let cosines = [from.cosine(-direction), to.cosine(direction)];
        // of a line in a face itself, from one point of it to another, the cosine is what rounding leaves
        if cosines[0] <= EPSILON || cosines[1] <= EPSILON {
            return None;
        }
        let crossing = match window {
            Some(camera) => Some(camera.window_crossing(DVec3::ZERO, direction)?),
            None => None,
        };
        Some(Self {
            direction,
            distance: line.length(),
            cosines,
            crossing,
        })
    }
}

/// d² / (area · cos θ): how much of a point's light falls on so much of the window, by solid angle.
fn per_area(crossing: &WindowCrossing, area: f64) -> f64 {
    crossing.t * crossing.t / (area * crossing.cosine)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::scene::small_scene::{object, one_pixel, sphere};
    use crate::strategy::Exhaustive;
    use crate::trace::{Recording, Settings, Transport};

    /// The lamp at (0, 3, −1), the point (0, 0, −5) of a wall of albedo ½ that faces the eye, and the eye in the origin.
    fn vertices() -> [Vertex; 3] {
        let lamp = Vertex::end(DVec3::new(0.0, 3.0, -1.0), DVec3::splat(8.0));
        let wall = Vertex {
            normal: DVec3::Z,
            albedo: DVec3::splat(0.5),
            epsilon: 5e-9,
            ..Vertex::end(DVec3::new(0.0, 0.0, -5.0), DVec3::splat(2.0))
        };
        [lamp, wall, Vertex::end(DVec3::ZERO, DVec3::ONE)]
    }

    #[test]
    fn a_line_knows_its_length_its_direction_and_the_cosines_at_both_ends() {
        let [lamp, wall, eye] = vertices();
        let line = Line::between(&lamp, &wall, None).unwrap();
        assert_eq!(line.distance, 5.0);
        assert!((line.direction - DVec3::new(0.0, 0.6, 0.8)).length() <= 1e-15);
        assert_eq!(line.cosines[0], 1.0);
        assert!((line.cosines[1] - 0.8).abs() <= 1e-15);
        assert!(line.crossing.is_none());
        let camera = one_pixel(r#""objects":[]"#).camera;
        let line = Line::between(&wall, &eye, Some(&camera)).unwrap();
        assert_eq!((line.direction, line.cosines), (DVec3::NEG_Z, [1.0, 1.0]));
        assert_eq!(line.crossing.map(|crossing| crossing.pixel), Some([0, 0]));
    }

    #[test]
    fn no_line_goes_to_a_surface_that_faces_away_or_is_black_or_past_the_window() {
        let [lamp, wall, eye] = vertices();
        let away = Vertex {
            normal: DVec3::NEG_Z,
            ..wall
        };
        let along = Vertex {
            normal: DVec3::X,
            ..wall
        };
        let black = Vertex {
            albedo: DVec3::ZERO,
            ..wall
        };
        for none in [away, along, black] {
            assert!(Line::between(&lamp, &none, None).is_none());
            assert!(Line::between(&none, &eye, None).is_none());
        }
        assert!(Line::between(&wall, &wall, None).is_none());
        // the window is 1 ahead and reaches 1 to each side
        let camera = one_pixel(r#""objects":[]"#).camera;
        let beside = Vertex {
            point: DVec3::new(6.0, 0.0, -5.0),
            ..wall
        };
        assert!(Line::between(&beside, &eye, Some(&camera)).is_none());
        assert!(Line::between(&beside, &eye, None).is_some());
    }

    /// What the line between two vertices brings, and what is noted of it.
    fn connected(scene: &Scene, light_vertex: usize, eye_vertex: usize) -> Connection {
        let [lamp, wall, eye] = vertices();
        let strategy = Exhaustive::new(scene);
        let tracer = Tracer::new(scene, &strategy, Transport::HybridConnected);
        let paths = Paths {
            camera: &scene.camera,
            number: 7,
            light: &[lamp, wall],
            eye: &[eye, wall],
        };
        let mut recording = Recording::new(Vec::new());
        let connected = tracer.connect(&paths, light_vertex, eye_vertex, &mut recording);
        let ControlFlow::Continue(Some(found)) = connected else {
            panic!("{connected:?}");
        };
        let records = recording.into_sink();
        let last = records.last().map(|record| record.event);
        assert_eq!(last, Some(Event::Connection(found)));
        found
    }

    #[track_caller]
    fn check(found: DVec3, expected: f64) {
        let off = (found - expected).abs().max_element();
        assert!(off <= 1e-15, "{found}, expected {expected}");
    }

    #[test]
    fn a_line_to_the_eye_brings_the_light_of_the_wall_over_the_window_s_area() {
        let empty = one_pixel(r#""objects":[]"#);
        let found = connected(&empty, 1, 0);
        assert_eq!((found.path, found.pixel), (7, Some([0, 0])));
        assert_eq!((found.light_vertex, found.eye_vertex), (1, 0));
        assert!(found.visible);
        // Φ'·ρ/π = 2·½/π, G = 1/25, the pixel's 1/4; the other way has the share 5π to this one's 4
        let weight = 4.0 / (4.0 + 5.0 * PI);
        assert!((found.weight - weight).abs() <= 1e-15);
        check(found.contribution, 1.0 / PI / 25.0 / 4.0 * weight);
    }

    #[test]
    fn a_line_from_the_lamp_brings_its_intensity_to_the_wall() {
        let empty = one_pixel(r#""objects":[]"#);
        let found = connected(&empty, 0, 1);
        assert_eq!(found.pixel, None);
        // Φ'/4π = 8/4π, G = 0.8/25, ρ/π·β = ½/π·2
        let weight = 5.0 * PI / (4.0 + 5.0 * PI);
        check(found.contribution, 2.0 / PI * 0.032 / PI * weight);
    }

    #[test]
    fn what_stands_between_two_vertices_blocks_the_line_and_what_stands_at_its_end_does_not() {
        let with = |center: [f64; 3], radius: f64| {
            let ball = object("ball", "m", &sphere(center, radius));
            let scene = one_pixel(&format!(
                r#""materials":{{"m":{{"colour":[1,1,1]}}}},"objects":[{ball}]"#
            ));
            [connected(&scene, 1, 0), connected(&scene, 0, 1)].map(|found| found.visible)
        };
        assert_eq!(with([0.0, 0.0, -3.0], 0.5), [false, true]);
        assert_eq!(with([0.0, 1.5, -3.0], 0.5), [true, false]);
        // touching the wall from behind in its point, and the lamp from above in its own
        assert_eq!(with([0.0, 0.0, -6.0], 1.0), [true, true]);
        assert_eq!(with([0.0, 3.6, -0.2], 1.0), [true, true]);
    }

    #[test]
    fn a_path_of_light_in_an_empty_scene_has_the_lamp_as_its_only_vertex() {
        let scene = one_pixel(r#""lights":[{"position":[0,3,-1],"power":8}],"objects":[]"#);
        let strategy = Exhaustive::new(&scene);
        let tracer = Tracer::new(&scene, &strategy, Transport::HybridConnected);
        let mut settings = Settings {
            transport: Transport::HybridConnected,
            ..Settings::default()
        };
        settings.light.samples = 4;
        let lamps = Lamps::new(&scene, &settings);
        let ControlFlow::Continue(found) = tracer.light_vertices(&lamps, 0, &mut Off) else {
            panic!("nobody has enough");
        };
        // 8 watts over 4 paths
        let [lamp] = found.0[..] else {
            panic!("{found:?}");
        };
        assert_eq!(
            (lamp.point, lamp.carries),
            (DVec3::new(0.0, 3.0, -1.0), DVec3::splat(2.0))
        );
        let dark = one_pixel(r#""objects":[]"#);
        let tracer = Tracer::new(&dark, &strategy, Transport::HybridConnected);
        let found = tracer.light_vertices(&Lamps::new(&dark, &settings), 0, &mut Off);
        assert!(matches!(found, ControlFlow::Continue(vertices) if vertices.0.is_empty()));
    }

    #[test]
    fn light_on_a_part_of_the_window_grows_with_the_square_of_the_distance() {
        let camera = one_pixel(r#""objects":[]"#).camera;
        let direction = DVec3::new(0.6, 0.0, -0.8);
        let crossing = camera.window_crossing(DVec3::ZERO, direction).unwrap();
        // 1.25² over 4 times 0.8
        assert!((per_area(&crossing, 4.0) - 0.488_281_25).abs() <= 1e-15);
    }

    #[test]
    fn what_stands_within_the_epsilon_of_a_surface_does_not_block_a_line_to_it() {
        // a ball that ends 0.0005 before the wall, whose ε is 0.001
        let ball = object("ball", "m", &sphere([0.0, 0.0, -4.4995], 0.5));
        let scene = one_pixel(&format!(
            r#""materials":{{"m":{{"colour":[1,1,1]}}}},"objects":[{ball}]"#
        ));
        let strategy = Exhaustive::new(&scene);
        let tracer = Tracer::new(&scene, &strategy, Transport::HybridConnected);
        let [_, wall, _] = vertices();
        let before = Vertex::end(DVec3::new(0.0, 0.0, -4.2), DVec3::ONE);
        let visible = |epsilon: f64| {
            let wall = Vertex { epsilon, ..wall };
            let line = Line::between(&wall, &before, None).unwrap();
            match tracer.sees(&before, &wall, &line, &mut Off) {
                ControlFlow::Continue(visible) => visible,
                ControlFlow::Break(()) => panic!("nobody has enough"),
            }
        };
        assert!(visible(1e-3) && !visible(1e-4));
    }

    /// A white room around the eye, a lamp of 6 watts beside it, and a picture of 3 × 2 pixels with sides of 1.
    fn room() -> Scene {
        let walls = sphere([0.0, 0.0, 0.0], 4.0);
        crate::scene::small_scene::scene_from(&format!(
            r#"{{"camera":{{"window":{{"cop":[0,0,0],"corner":[-1.5,-1,-1],"right":[3,0,0],"up":[0,2,0]}},
            "pixels":[3,2]}},"lights":[{{"position":[0,1,0],"power":6}}],
            "materials":{{"m":{{"colour":[1,1,1],"diffuse":0.75}}}},"objects":[{}]}}"#,
            object("room", "m", &walls)
        ))
    }

    fn settings(bounces: Option<u32>) -> Settings {
        let mut settings = Settings {
            transport: Transport::HybridConnected,
            ..Settings::default()
        };
        settings.light.samples = 3;
        settings.light.bounces = bounces;
        settings
    }

    /// What is noted in the pixel (1, 1), and its colour; with what lines to the eye brought.
    fn pixel_of_room(bounces: Option<u32>) -> (Vec<Event>, DVec3, DVec3) {
        let scene = room();
        let strategy = Exhaustive::new(&scene);
        let settings = settings(bounces);
        let light = LightPass::new(&scene, &strategy, &settings, None, |_: Off| {}, |_| {});
        let light = light.unwrap().unwrap();
        let tracer = Tracer::new(&scene, &strategy, Transport::HybridConnected);
        let mut recording = Recording::new(Vec::new());
        let colour = match tracer.connected_pixel(&light, [1, 1], &mut recording) {
            ControlFlow::Continue(colour) => colour,
            ControlFlow::Break(()) => panic!("nobody has enough"),
        };
        let records = recording.into_sink();
        let events = records.into_iter().map(|record| record.event);
        (events.collect(), colour, light.seen([1, 1]))
    }

    #[test]
    fn a_pixel_has_its_own_paths_and_counts_what_they_bring_for_the_whole_picture() {
        let (events, colour, seen) = pixel_of_room(Some(3));
        let mut places = Vec::new();
        let mut paths = Vec::new();
        let mut sum = DVec3::ZERO;
        for event in &events {
            match event {
                Event::Pixel(sample) => places.push((sample.sample, sample.samples, sample.place)),
                Event::Connection(of) => {
                    paths.push(of.path);
                    sum += of.contribution;
                    assert!(of.light_vertex + of.eye_vertex <= 3 && 1 <= of.eye_vertex);
                }
                _ => {}
            }
        }
        // the fifth pixel of six, each with three samples
        paths.dedup();
        assert_eq!(paths, [12, 13, 14]);
        assert_eq!(
            places.iter().map(|place| place.0).collect::<Vec<_>>(),
            [0, 1, 2]
        );
        for (_, samples, place) in places {
            assert_eq!(samples, 3);
            assert!(
                (1.0..2.0).contains(&place.x) && (1.0..2.0).contains(&place.y),
                "{place}"
            );
        }
        assert!(sum.cmpgt(DVec3::ZERO).all() && seen.cmpgt(DVec3::ZERO).all());
        // six pixels
        let off = (colour - (6.0 * sum + seen)).abs().max_element();
        assert!(off <= 1e-14 * colour.max_element(), "{colour}");
    }

    #[test]
    fn a_path_of_one_surface_is_connected_to_the_lamp_alone() {
        let (events, _, _) = pixel_of_room(Some(1));
        let ends = events.iter().filter_map(|event| match event {
            Event::Connection(of) => Some((of.light_vertex, of.eye_vertex)),
            _ => None,
        });
        let ends: Vec<_> = ends.collect();
        assert_eq!(ends, [(0, 1); 3]);
    }

    #[test]
    fn each_surface_of_a_path_of_light_up_to_the_most_has_a_line_to_the_eye() {
        let scene = room();
        let strategy = Exhaustive::new(&scene);
        let tracer = Tracer::new(&scene, &strategy, Transport::HybridConnected);
        let mut lines_to = [0; 3];
        for bounces in [1, 2] {
            let lamps = Lamps::new(&scene, &settings(Some(bounces)));
            for path in 0..200 {
                let lines = match tracer.seen_by_the_eye(&lamps, path, &mut Off) {
                    ControlFlow::Continue(lines) => lines,
                    ControlFlow::Break(()) => panic!("nobody has enough"),
                };
                for line in lines {
                    assert!((1..=bounces).contains(&u32::from(line.light_vertex)));
                    assert_eq!(line.eye_vertex, 0);
                    lines_to[usize::from(line.light_vertex)] += 1;
                }
            }
        }
        // the window takes some of the directions, and its pixels 1 of 6 sides of a cube around the eye
        assert!(
            lines_to[0] == 0 && 10 < lines_to[1] && 5 < lines_to[2],
            "{lines_to:?}"
        );
    }
}
