//! The weight of a connecting line among all ways in which the same path can come about.
//!
//! The balance heuristic (E. Veach and L. Guibas 1995): each way counts in proportion to its density. A path of n
//! edges can come about with each of them as the line; light has made the vertices before it, the eye those behind it.
//! The density is the product of φ of all vertices that sent on, and of G of all edges but the line, for a line is
//! drawn, not sampled. So all densities share all factors but those of their own line,
//!
//! w = share / Σ shares,  share = 1 / (G · φ · φ')
//!
//! with φ = 1/(4π) at the light, ρ/π at a diffuse surface, d²/(A·cos θ) at the eye with A the window's area. A mirror
//! or glass sends on in one direction: no line to it ever has that direction, so that its edges cannot be the line.
//! Through glass, n² of radiance is left out of the densities: the weights still add up to one.

use std::f64::consts::PI;

use glam::DVec3;

use crate::scene::Camera;
use crate::trace::{Alternative, Event, Recorder, geometry_term};
use crate::tracer::path_vertex::Vertex;

/// The two paths that are to be connected, each from its end on.
pub(super) struct Paths<'a> {
    pub(super) camera: &'a Camera,
    pub(super) number: u32,
    pub(super) light: &'a [Vertex],
    pub(super) eye: &'a [Vertex],
}

impl Paths<'_> {
    /// The weight of a connection by the balance heuristic.
    pub(super) fn weight<R: Recorder>(
        &self,
        light_vertex: usize,
        eye_vertex: usize,
        recorder: &mut R,
    ) -> f64 {
        // the whole path, from the light to the eye, with the line as one of its edges
        let of_light = self.light[..=light_vertex].iter();
        let of_eye = self.eye[..=eye_vertex].iter().rev();
        let vertices: Vec<&Vertex> = of_light.chain(of_eye).collect();
        let line = light_vertex + 1;
        let last = vertices.len() - 1;

        let mut shares = 0.0;
        let mut own = 0.0;
        for edge in 1..=last {
            let ends = [vertices[edge - 1], vertices[edge]];
            // at the ends of the line itself light goes on diffusely, whatever chance decided for the paths
            let is_line = edge == line;
            let bars = |end: usize| {
                let at = edge - 1 + end;
                let ends_line = at == line - 1 || at == line;
                !ends_line && ends[end].is_specular
            };
            if bars(0) || bars(1) {
                continue;
            }
            let direction = (ends[1].point - ends[0].point).normalize_or_zero();
            let cosines = [
                ends[0].cosine(direction).abs(),
                ends[1].cosine(-direction).abs(),
            ];
            let geometry = geometry_term(ends[0].point, ends[1].point, cosines);
            let at_light = if edge == 1 {
                1.0 / (4.0 * PI)
            } else {
                ends[0].density()
            };
            let at_eye = if edge == last {
                self.window_density(-direction)
            } else {
                ends[1].density()
            };
            let share = 1.0 / (geometry * at_light * at_eye);
            shares += share;
            if is_line {
                own = share;
            }
            recorder.note(|| {
                Event::Alternative(Alternative {
                    edge: edge as u32,
                    geometry,
                    densities: [at_light, at_eye],
                    share,
                    chosen: is_line,
                })
            });
        }
        own / shares
    }

    /// φ at the eye: paths from it pass the whole window alike.
    fn window_density(&self, direction: DVec3) -> f64 {
        let [width, height] = self.camera.pixels.map(f64::from);
        let area = self.camera.pixel_area() * width * height;
        let across = self.camera.window_normal();
        let cosine = direction.dot(across).abs();
        // the window's plane along this direction
        let t = self.camera.to_corner.dot(across).abs() / cosine;
        t * t / (area * cosine)
    }
}
