//! Hybrid ray tracing with connecting lines: a path of light and a path from the eye, each vertex of one joined to
//! each of the other by a line.
//!
//! E. Veach and L. Guibas (1994, 1995), E. Lafortune and Y. Willems (1993). With the light's power Φ' that
//! arrives at its vertex, the weight β of the path from the eye, and ρ/π of the surfaces at both ends,
//!
//! L = Φ'·ρ/π · G·V · ρ'/π·β · w,  G = cos θ · cos θ' / d²,  V = 1 if nothing stands between
//!
//! The same path of n edges can come about in several ways, one for each edge that can be the line: the weights w make
//! sure that it counts once ([`balance_heuristic`](crate::tracer::balance_heuristic)).

use std::f64::consts::PI;
use std::ops::ControlFlow;

use glam::{DVec2, DVec3};

use crate::geometry::{Ray, TRange};
use crate::scene::{Camera, WindowCrossing};
use crate::strategy::Strategy;
use crate::trace::{
    Connection, Event, Off, Outcome, PixelSample, Purpose, RayStart, Recorder, geometry_term,
};
use crate::tracer::backward::eye_ray_start;
use crate::tracer::balance_heuristic::Paths;
use crate::tracer::chance::Chance;
use crate::tracer::epsilon::EPSILON;
use crate::tracer::light_path::Lamps;
use crate::tracer::path_vertex::{Vertex, Vertices};
use crate::tracer::{LightPass, Tracer};

impl<S: Strategy> Tracer<'_, S> {
    /// The colour of a pixel: its paths from the eye, each connected to a path of light of its own, and what the
    /// lines from all paths of light to the eye have brought.
    pub(super) fn connected_pixel<R: Recorder>(
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
    pub(super) fn seen_by_the_eye<R: Recorder>(
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
        self.is_clear(start, Outcome::Connects, recorder)
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
