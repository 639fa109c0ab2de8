//! A path from a light to the eye, put together from what was recorded of its two halves, and the chances of the ways in
//! which it can come about.
//!
//! A path of n edges comes about with edge e as the line if light has found the way to the near end and the eye the way
//! to the far end. The chance of that is p(e), the product of all steps from both sides:
//!
//! p(e) = Π φ(before the edge)·G over the edges before e · Π φ(behind the edge)·G over the edges behind e
//!
//! The balance heuristic asks for the weight p(e) / Σ p.

use std::f64::consts::PI;

use glam::DVec3;
use raystep::scene::Shape;
use raystep::trace::{Connection, PhotonVerdict};
use raystep::{Event, Record, Scene};

/// A vertex, from the light or the eye on.
#[derive(Clone, Copy)]
pub(super) struct Vertex {
    pub(super) point: DVec3,
    /// None for light and eye.
    pub(super) normal: Option<DVec3>,
    /// What arrives.
    pub(super) carries: DVec3,
    /// colour·diffuse.
    pub(super) albedo: DVec3,
    /// The path went on from here as from a mirror, or through.
    pub(super) passes: bool,
}

/// The light or the eye.
pub(super) fn end(point: DVec3, carries: DVec3) -> Vertex {
    Vertex {
        point,
        normal: None,
        carries,
        albedo: DVec3::ONE,
        passes: false,
    }
}

/// A unit normal at a point, by the shape alone.
fn normal(shape: &Shape, point: DVec3) -> DVec3 {
    match shape {
        Shape::Sphere(sphere) => (point - sphere.center) / sphere.radius,
        Shape::Box(solid) => {
            // the side that the point lies in
            let beside = (point - solid.min).abs().min((solid.max - point).abs());
            let mut normal = DVec3::ZERO;
            normal[beside.min_position()] = 1.0;
            normal
        }
        Shape::Polygon(polygon) => {
            let v: Vec<DVec3> = polygon.vertices().collect();
            (v[1] - v[0]).cross(v[2] - v[0]).normalize()
        }
        _ => panic!("no such shape in the scene"),
    }
}

/// Adds the surfaces that the photons of some records have met.
pub(super) fn add_surfaces(scene: &Scene, records: &[Record], vertices: &mut Vec<Vertex>) {
    for record in records {
        let Event::Photon(photon) = record.event else {
            continue;
        };
        let material = scene.material_of(photon.object);
        let before = vertices[vertices.len() - 1].point;
        let normal = normal(&scene.primitive(photon.object).shape, photon.point);
        let facing = normal.dot(before - photon.point).signum();
        vertices.push(Vertex {
            point: photon.point,
            normal: Some(facing * normal),
            carries: photon.power,
            albedo: DVec3::from(material.colour) * material.diffuse,
            passes: matches!(
                photon.verdict,
                PhotonVerdict::Mirrored | PhotonVerdict::Refracted
            ),
        });
    }
}

/// The path from its light to its eye, with the line between two of its vertices.
pub(super) struct Chain {
    pub(super) vertices: Vec<Vertex>,
    /// The number of the edge that is the line, from 1.
    pub(super) line: usize,
}

impl Chain {
    pub(super) fn new(light: &[Vertex], eye: &[Vertex], connection: &Connection) -> Self {
        let line = usize::from(connection.light_vertex) + 1;
        let mut vertices = light[..line].to_vec();
        vertices.extend(eye[..=usize::from(connection.eye_vertex)].iter().rev());
        // what a line ends at sends light on diffusely
        vertices[line - 1].passes = false;
        vertices[line].passes = false;
        Self { vertices, line }
    }

    /// cos θ · cos θ' / d² of an edge.
    pub(super) fn geometry(&self, edge: usize) -> f64 {
        let [a, b] = [self.vertices[edge - 1], self.vertices[edge]];
        let offset = b.point - a.point;
        let cosine = |vertex: Vertex| {
            let cosine = |normal: DVec3| normal.dot(offset).abs() / offset.length();
            vertex.normal.map_or(1.0, cosine)
        };
        cosine(a) * cosine(b) / offset.length_squared()
    }

    /// Can the edge be the line? Not at a mirror or in glass.
    fn can_be_line(&self, edge: usize) -> bool {
        !self.vertices[edge - 1].passes && !self.vertices[edge].passes
    }

    /// φ of a vertex.
    pub(super) fn density(&self, scene: &Scene, vertex: usize) -> f64 {
        let Vertex {
            point,
            albedo,
            passes,
            ..
        } = self.vertices[vertex];
        if vertex == 0 {
            return 1.0 / (4.0 * PI);
        }
        if vertex == self.vertices.len() - 1 {
            let along = (self.vertices[vertex - 1].point - point).normalize();
            let [width, height] = scene.camera.pixels.map(f64::from);
            return by_window_area(scene, along) / (width * height);
        }
        // one direction, with the same chance from both sides
        if passes {
            1.0
        } else {
            albedo.max_element() / PI
        }
    }

    /// ln p(e), but for what is the same for all e: how a mirror or glass spreads the light.
    fn chance(&self, scene: &Scene, line: usize) -> f64 {
        let step = |edge: usize| {
            let from = if edge < line { edge - 1 } else { edge };
            let geometry = if self.can_be_line(edge) {
                self.geometry(edge)
            } else {
                1.0
            };
            (self.density(scene, from) * geometry).ln()
        };
        let edges = 1..self.vertices.len();
        edges.filter(|&edge| edge != line).map(step).sum()
    }

    /// The edges that can be the line, and the weights that the balance heuristic gives them.
    pub(super) fn weights(&self, scene: &Scene) -> Vec<(usize, f64)> {
        let edges = (1..self.vertices.len()).filter(|&edge| self.can_be_line(edge));
        let chances: Vec<(usize, f64)> =
            edges.map(|edge| (edge, self.chance(scene, edge))).collect();
        let most = chances.iter().map(|(_, chance)| *chance);
        let most = most.fold(f64::NEG_INFINITY, f64::max);
        let sum: f64 = chances
            .iter()
            .map(|(_, chance)| (chance - most).exp())
            .sum();
        let weight = |(edge, chance): (usize, f64)| (edge, (chance - most).exp() / sum);
        chances.into_iter().map(weight).collect()
    }
}

/// d²/(A·cos θ) of a pixel: with t·direction in the window's plane, cos θ to its normal.
pub(super) fn by_window_area(scene: &Scene, direction: DVec3) -> f64 {
    let camera = &scene.camera;
    let across = camera.right.cross(camera.up);
    let t = across.dot(camera.to_corner) / across.dot(direction);
    let cosine = (across.dot(direction) / across.length()).abs();
    let [width, height] = camera.pixels.map(f64::from);
    let area = across.length() / (width * height);
    t * t / (area * cosine)
}
